// What if: leave out, hold, free, another limit; the answer stands beside the first result.

import { api, Refused } from "./api";
import { button, fill, h, redraw } from "./dom";
import { length, quantity, significant } from "./numbers";
import { check, difference, message } from "./parts";
import { badge } from "./panels";
import { on, scene, store, targets, tell } from "./store";
import type { Message, WhatIfAsked } from "./types";
import { t } from "./words";

/** Time (ms) after the last change until the question is sent. */
const PAUSE = 120;

let timer = 0;
let asking = 0;
let problems: Message[] = [];
let written: string | null = null;
let isBusy = false;

const isEmpty = (asked: WhatIfAsked): boolean =>
  Object.values(asked).every(value => value === undefined || (Array.isArray(value) && value.length === 0));

const refused = (error: unknown): Message[] =>
  error instanceof Refused ? error.messages : [{ id: "request", severity: "error", text: `${t("failed")} ${String(error)}` }];

function ask(): void {
  clearTimeout(timer);
  const mine = ++asking;
  if (isEmpty(store.asked)) {
    store.what = null;
    problems = [];
    isBusy = false;
    tell("what");
    return;
  }
  isBusy = true;
  tell("what");
  timer = window.setTimeout(async () => {
    try {
      const answer = await api.whatIf(store.asked);
      if (mine !== asking) return;
      store.what = answer;
      problems = [];
    } catch (error) {
      if (mine !== asking) return;
      problems = refused(error);
    }
    isBusy = false;
    tell("what");
  }, PAUSE);
}

type ListKey = "leave_out_poses" | "leave_out_targets" | "hold" | "free";

function toggle(key: ListKey, name: string, on?: boolean): void {
  const list = store.asked[key] ?? [];
  const has = list.includes(name);
  if (on === has) return;
  change({ [key]: has ? list.filter(n => n !== name) : [...list, name] });
}

/** Changes the question; what was written before belongs to another one. */
function change(by: WhatIfAsked): void {
  written = null;
  store.asked = { ...store.asked, ...by };
  ask();
}

/** Ids of poses in a text such as `3, 7-12`; a range follows the order of measurement. */
function idsIn(text: string): string[] {
  const all = scene()?.poses.map(pose => pose.id) ?? [];
  return text.split(/[,;\s]+/).flatMap(part => {
    if (all.includes(part)) return [part];
    const ends = all.flatMap((id, i) => (part.startsWith(`${id}-`) && all.includes(part.slice(id.length + 1)) ? [i] : []));
    if (ends.length === 0) return [];
    const to = all.indexOf(part.slice(all[ends[0]].length + 1));
    return all.slice(Math.min(ends[0], to), Math.max(ends[0], to) + 1);
  });
}

export const leaveOut = (pose: string): void => toggle("leave_out_poses", pose);

/** Forgets the question, as after a run; what was written stays in sight. */
export function forget(): void {
  store.asked = {};
  ask();
}

export function whatIf(): HTMLElement {
  const root = h("div", { class: "panel whatif" });
  const asked = h("div", { class: "asked" });
  const answer = h("div", { class: "answer", "aria-live": "polite" });
  const keep = keepForm();
  fill(root, h("p", { class: "note" }, t("whatIfNote")), asked, answer, keep.root);
  const draw = () => {
    redraw(asked, () => fill(asked, ...askedParts()));
    fill(answer, ...answerParts());
    keep.draw();
  };
  on(["what", "scene", "selection"], draw);
  draw();
  return root;
}

function askedParts(): HTMLElement[] {
  const pose = scene()?.poses[store.pose];
  const out = store.asked.leave_out_poses ?? [];
  const chips = out.map(id =>
    h("li", {}, button(`${t("pose")} ${id} ✕`, () => leaveOut(id), { class: "chip-button", "data-key": `x${id}` })),
  );
  const poses = h(
    "fieldset",
    {},
    h("legend", {}, t("leftOutPoses")),
    h("ul", { class: "chips" }, ...chips),
    pose &&
      !out.includes(pose.id) &&
      button(`${t("leaveOutPose")}: ${pose.id}`, () => leaveOut(pose.id), { class: "small", "data-key": "leave" }),
    groupPart(out),
  );
  const list = targets();
  const marks = h(
    "fieldset",
    {},
    h("legend", {}, t("leaveOutTarget")),
    ...list
      .slice(0, 60)
      .map(name =>
        check(name, store.asked.leave_out_targets?.includes(name) ?? false, on => toggle("leave_out_targets", name, on), `g${name}`),
      ),
  );
  const parts = [poses, ...(list.length > 1 ? [marks] : []), parametersPart(), limitPart()];
  if (store.state?.split) parts.push(splitPart());
  return parts;
}

/** Several poses at once. */
function groupPart(out: string[]): HTMLElement {
  const input = h("input", { id: "group", "data-key": "group", placeholder: "3, 7-12", autocomplete: "off" });
  const send = (event: Event) => {
    event.preventDefault();
    const ids = idsIn(input.value.trim());
    if (ids.length) change({ leave_out_poses: [...new Set([...out, ...ids])] });
  };
  return h(
    "form",
    { class: "row", onsubmit: send },
    h("label", { for: "group" }, t("group")),
    input,
    h("button", { type: "submit", class: "small", "data-key": "group-send" }, t("leaveOut")),
  );
}

function parametersPart(): HTMLElement {
  const list = store.state?.parameters ?? [];
  const details = h(
    "details",
    { class: "hold" },
    h("summary", { "data-key": "hold" }, `${t("hold")} / ${t("free")}`),
    h(
      "div",
      { class: "hold-list" },
      ...list.map(p =>
        p.held
          ? check(`${t("free")}: ${p.name}`, store.asked.free?.includes(p.name) ?? false, on => toggle("free", p.name, on), `f${p.name}`)
          : check(`${t("hold")}: ${p.name}`, store.asked.hold?.includes(p.name) ?? false, on => toggle("hold", p.name, on), `h${p.name}`),
      ),
    ),
  );
  details.open = isHoldOpen;
  details.addEventListener("toggle", () => (isHoldOpen = details.open));
  return details;
}

let isHoldOpen = false;

function limitPart(): HTMLElement {
  const read = () => {
    const value = Number(input.value.replace(",", "."));
    change({ limit_um: input.value !== "" && value > 0 ? value : undefined });
  };
  const present = store.state?.maximum?.limit_um;
  const input = h("input", {
    type: "number",
    min: 0,
    step: "any",
    id: "limit-um",
    "data-key": "limit",
    placeholder: present === undefined ? "" : String(present),
    onchange: read,
  });
  input.value = store.asked.limit_um === undefined ? "" : String(store.asked.limit_um);
  return h("p", { class: "field" }, h("label", { for: "limit-um" }, t("limitUm")), input);
}

function splitPart(): HTMLElement {
  const field = (key: "calibration" | "validation", label: string): HTMLElement => {
    const input = h("input", {
      id: `split-${key}`,
      "data-key": key,
      placeholder: store.state?.split?.[key] ?? "",
      onchange: () => {
        change({ [key]: input.value.trim() || undefined });
      },
    });
    input.value = store.asked[key] ?? "";
    return h("p", { class: "field" }, h("label", { for: `split-${key}` }, label), input);
  };
  return h("div", {}, field("calibration", t("splitCalibration")), field("validation", t("splitValidation")));
}

function answerParts(): (HTMLElement | null)[] {
  const { what, state } = store;
  const parts: (HTMLElement | null)[] = [];
  if (isBusy) parts.push(h("p", { class: "note" }, t("running")));
  if (problems.length) parts.push(h("ul", { class: "messages" }, ...problems.map(message)));
  if (!what) return parts;
  const unit = (name: string) => what.parameters.find(p => p.name === name)?.unit ?? "";
  const { first, now, uncertainty } = what.maximum_um;
  const row = (head: string, a: Node | string, b: Node | string) =>
    h("tr", {}, h("th", { scope: "row" }, head), h("td", {}, a), h("td", {}, b));
  parts.push(
    h(
      "table",
      { class: "beside" },
      h("caption", {}, t("milliseconds", { time: quantity(what.seconds * 1000, "ms", 2) })),
      h(
        "thead",
        {},
        h("tr", {}, h("td"), h("th", { scope: "col" }, t("first")), h("th", { scope: "col" }, t("nowResult"))),
      ),
      h(
        "tbody",
        {},
        row(t("largest"), length(first, state?.maximum?.uncertainty_um), length(now, uncertainty)),
        state?.verdict && what.verdict && row(t("verdict"), badge(state.verdict.status), badge(what.verdict.status)),
      ),
    ),
    h("h3", {}, t("changed")),
    what.changed.length === 0
      ? h("p", { class: "note" }, t("nothingChanged"))
      : h(
          "table",
          {},
          h(
            "thead",
            {},
            h(
              "tr",
              {},
              h("th", { scope: "col" }, t("parameter")),
              h("th", { scope: "col", class: "num" }, t("changeHead")),
              h("th", { scope: "col", class: "num" }, t("changeOverU")),
            ),
          ),
          h(
            "tbody",
            {},
            ...what.changed.map(c =>
              h(
                "tr",
                {},
                h("th", { scope: "row" }, c.name),
                h("td", { class: "num" }, quantity(c.by, unit(c.name), 3)),
                h("td", { class: "num" }, significant(c.in_u, 2)),
              ),
            ),
          ),
        ),
  );
  return parts;
}

/** "Write it to the campaign" with the reason asked for. */
function keepForm(): { root: HTMLElement; draw: () => void } {
  const reason = h("input", { id: "reason", autocomplete: "off", required: true });
  const problem = h("p", { class: "problem", role: "alert" });
  const shown = h("div");
  const send = async (event: Event) => {
    event.preventDefault();
    if (!reason.value.trim()) {
      problem.textContent = t("reasonNeeded");
      reason.focus();
      return;
    }
    problem.textContent = "";
    try {
      written = (await api.keep(store.asked, reason.value.trim())).difference;
      draw();
      shown.scrollIntoView({ block: "nearest" });
    } catch (error) {
      problem.textContent = refused(error).map(m => [m.text, m.hint].filter(Boolean).join(" ")).join(" ");
    }
  };
  const root = h(
    "form",
    { class: "keep", novalidate: true, onsubmit: send },
    h("label", { for: "reason" }, t("keepReason")),
    reason,
    problem,
    h(
      "p",
      { class: "actions" },
      h("button", { type: "submit", class: "main" }, t("keep")),
      button(t("reset"), () => {
        written = null;
        forget();
      }),
    ),
    shown,
  );
  const draw = () => {
    root.hidden = isEmpty(store.asked) && written === null;
    fill(
      shown,
      written !== null && h("p", { role: "status" }, t("kept")),
      written !== null && difference(written, t("difference")),
    );
  };
  return { root, draw };
}
