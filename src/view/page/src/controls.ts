// Slider and playback over poses; colours, filters and arrows of the view.

import { fill, h, say, reducedMotion } from "./dom";
import { times } from "./paint";
import { check } from "./parts";
import { change, on, scene, select, sets, store, targets, tell } from "./store";
import { named, t } from "./words";

const SPEEDS = [1, 2, 5, 20];

/** Slider over the poses, with playback. */
export function player(): HTMLElement {
  const slider = h("input", { type: "range", id: "pose", min: 0, step: 1, "aria-label": t("pose") });
  const shown = h("output", { for: "pose" });
  const speed = h("select", { "aria-label": t("speed") });
  const sign = h("span", { "aria-hidden": "true" });
  const word = h("span", { class: "hidden" });
  const play = h("button", { type: "button", class: "play", "aria-pressed": "false" }, sign, word);
  const root = h("div", { class: "player" }, play, slider, shown, speed);
  let playing = false;
  let begun = { at: 0, pose: 0 };

  const show = () => {
    const current = scene();
    const pose = current?.poses[store.pose];
    if (!current || !pose) return;
    slider.max = String(current.poses.length - 1);
    slider.value = String(store.pose);
    const text = t("poseOf", { id: pose.id, index: store.pose + 1, count: current.poses.length });
    slider.setAttribute("aria-valuetext", `${text}, ${named(pose.set)}`);
    say(shown, text);
  };
  const mark = () => {
    say(sign, playing ? "❚❚" : "▶");
    say(word, playing ? t("pause") : t("play"));
    play.setAttribute("aria-pressed", String(playing));
  };
  const stop = () => {
    playing = false;
    mark();
  };
  const step = (now: number) => {
    const current = scene();
    if (!playing || !current) return;
    const last = current.poses.length - 1;
    const seconds = (now - begun.at) / 1000;
    const start = current.poses[begun.pose].time_s ?? 0;
    let pose = begun.pose;
    if (speed.value === "time") while (pose < last && (current.poses[pose + 1].time_s ?? 0) - start <= seconds) pose += 1;
    else pose += Math.floor(seconds * Number(speed.value));
    if (pose !== store.pose) select(Math.min(last, pose));
    if (pose >= last) return stop();
    requestAnimationFrame(step);
  };
  const begin = () => {
    const last = (scene()?.poses.length ?? 1) - 1;
    if (store.pose >= last) select(0);
    begun = { at: performance.now(), pose: store.pose };
    requestAnimationFrame(step);
  };
  play.addEventListener("click", () => {
    playing = !playing;
    mark();
    if (playing) begin();
  });
  speed.addEventListener("change", () => playing && begin());
  slider.addEventListener("input", () => {
    stop();
    select(Number(slider.value));
  });
  const scenes = () => {
    const current = scene();
    root.hidden = !current || current.poses.length < 2;
    const isTimed = current?.poses.every((pose, i, all) => (pose.time_s ?? NaN) >= (all[i - 1]?.time_s ?? -Infinity));
    const chosen = speed.value || (reducedMotion() ? "1" : "2");
    fill(
      speed,
      ...SPEEDS.map(n => h("option", { value: n }, t("perSecond", { count: n }))),
      isTimed && h("option", { value: "time" }, t("realTime")),
    );
    speed.value = chosen;
    show();
  };
  on(["scene"], scenes);
  on(["selection"], show);
  scenes();
  mark();
  return root;
}

/** Colours, filters, arrows. */
export function options(): HTMLElement {
  const root = h("div", { class: "options-row" });
  let showMagnification = () => {};
  const draw = () => {
    const current = scene();
    const view = store.view;
    if (!current) return fill(root);
    const option = (value: string, label: string) => h("option", { value }, label);
    const picker = (id: string, label: string, value: string, list: HTMLElement[], took: (value: string) => void) => {
      const isNamed = id === "colour";
      const box = h("select", { id, "aria-label": isNamed ? null : label, onchange: () => took(box.value) }, ...list);
      box.value = value;
      return h("span", { class: "field" }, isNamed && h("label", { for: id }, label), box);
    };
    const isTimed = current.poses.some(pose => pose.time_s !== undefined);
    const hasBefore = current.points.some(point => point.before);
    const hasHulls = current.points.some(point => point.covariance_um2);
    const marks = targets();
    const colours = [
      option("after", t("errorAfter")),
      ...(hasBefore ? [option("before", t("errorBefore"))] : []),
      option("target", t("target")),
      option("set", t("set")),
      option("time", isTimed ? t("time") : t("order")),
      ...current.joints.map((joint, i) => option(`joint:${i}`, joint.name)),
    ];
    const allSets = [option("", t("allSets")), ...sets().map(set => option(set, named(set)))];
    const allTargets = [option("", t("allTargets")), ...marks.map(name => option(name, name))];
    fill(
      root,
      picker("colour", t("colourBy"), view.colour, colours, colour => change({ colour })),
      sets().length > 1 && picker("set", t("set"), view.set, allSets, set => change({ set })),
      marks.length > 1 && picker("target", t("target"), view.target, allTargets, target => change({ target })),
      h(
        "span",
        { class: "field checks", role: "group", "aria-label": t("arrows") },
        hasBefore && check(t("before"), view.before, before => change({ before })),
        check(t("after"), view.after, isOn => change({ after: isOn })),
        hasHulls && check(t("ellipsoids"), view.ellipsoids, ellipsoids => change({ ellipsoids })),
        check(t("chainsAll"), view.chains, chains => change({ chains })),
        current.parts?.length && check(t("meshes"), view.meshes, meshes => change({ meshes })),
      ),
      magnification(show => (showMagnification = show)),
    );
  };
  on(["scene"], draw);
  on(["view"], () => showMagnification());
  draw();
  return root;
}

/** Slider of the magnification; `shows` receives a function that shows a new value. */
function magnification(shows: (show: () => void) => void): HTMLElement {
  const slider = h("input", { type: "range", id: "magnification", min: 0, max: 5, step: 0.01 });
  const shown = h("output", { for: "magnification" });
  const label = (factor: number) => {
    say(shown, times(factor));
    slider.setAttribute("aria-valuetext", times(factor));
  };
  const show = () => {
    slider.value = String(Math.log10(store.view.magnification));
    label(store.view.magnification);
  };
  show();
  slider.addEventListener("input", () => {
    // two digits, as the label states
    const factor = Number((10 ** Number(slider.value)).toPrecision(2));
    label(factor);
    change({ magnification: factor });
  });
  shows(show);
  return h("span", { class: "field" }, h("label", { for: "magnification" }, t("arrows")), slider, shown);
}

/** Tabs in the pattern of WAI-ARIA: arrow keys move, only the chosen tab is in the order of the focus. */
export class Tabs {
  readonly root = h("section", { class: "tabs" });
  private readonly list = h("div", { role: "tablist", class: "tablist" });
  private readonly tabs: { key: string; tab: HTMLButtonElement; panel: HTMLElement; label: () => string }[] = [];

  constructor() {
    this.root.append(this.list);
    this.list.addEventListener("keydown", event => {
      const visible = this.tabs.filter(entry => !entry.tab.hidden);
      const at = visible.findIndex(entry => entry.tab === document.activeElement);
      const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: visible.length - 1 }[event.key];
      if (to === undefined || at < 0) return;
      event.preventDefault();
      const entry = visible[(to + visible.length) % visible.length];
      this.show(entry.key);
      entry.tab.focus();
    });
  }

  add(key: string, label: () => string, contents: HTMLElement): void {
    const tab = h("button", {
      type: "button",
      role: "tab",
      id: `tab-${key}`,
      "aria-controls": `panel-${key}`,
      onclick: () => this.show(key),
    });
    const panel = h("div", { role: "tabpanel", id: `panel-${key}`, "aria-labelledby": tab.id, tabindex: 0 }, contents);
    this.list.append(tab);
    this.root.append(panel);
    this.tabs.push({ key, tab, panel, label });
    this.relabel();
  }

  relabel(): void {
    for (const { tab, label } of this.tabs) say(tab, label());
  }

  hide(key: string, isHidden: boolean): void {
    const entry = this.tabs.find(tab => tab.key === key);
    if (entry) entry.tab.hidden = isHidden;
  }

  show(key: string): void {
    for (const entry of this.tabs) {
      const isChosen = entry.key === key;
      entry.tab.setAttribute("aria-selected", String(isChosen));
      entry.tab.tabIndex = isChosen ? 0 : -1;
      entry.panel.hidden = !isChosen;
    }
    tell("busy");
  }
}
