// While one measures: a line that is readable from three metres, and the figures behind it.

import { fill, h, say } from "./dom";
import { length, quantity, significant } from "./numbers";
import { message, region, scroller } from "./parts";
import { on, scene, selectPose, store } from "./store";
import type { Watch } from "./types";
import { t } from "./words";

const SIGNS = { good: "✓", wait: "…", bad: "✗" };

/** The large line above the page. */
export function band(): HTMLElement {
  const sign = h("span", { class: "sign", "aria-hidden": "true" });
  const line = h("p", { class: "spoken", "aria-live": "assertive", "aria-atomic": "true" });
  const next = h("p", { class: "then" });
  const size = h("button", { type: "button", class: "small", "aria-pressed": "false" }, t("bigLine"));
  const root = h("section", { class: "band", "aria-label": t("watchTab") }, sign, h("div", {}, line, next), size);
  size.addEventListener("click", () => {
    const on = root.classList.toggle("whole");
    size.setAttribute("aria-pressed", String(on));
  });
  root.addEventListener("keydown", event => {
    if (event.key !== "Escape") return;
    root.classList.remove("whole");
    size.setAttribute("aria-pressed", "false");
  });
  const draw = () => {
    const { watch, state } = store;
    root.hidden = !watch && !state?.watching;
    root.dataset.tone = watch?.tone ?? "wait";
    say(sign, SIGNS[watch?.tone ?? "wait"]);
    // a sentence is smaller than a word, and still has letters of 15 mm
    root.classList.toggle("long", (watch?.line ?? t("waiting")).length > 26);
    say(line, watch?.line ?? t("waiting"));
    say(next, watch?.next ? `${t("nextPose")}: ${t("pose")} ${watch.next.pose}` : "");
  };
  on(["watch", "state"], draw);
  draw();
  return root;
}

export function watchPanel(): HTMLElement {
  const root = h("div", { class: "panel watch" });
  const draw = () => {
    const { watch } = store;
    if (!watch) return fill(root, h("p", { class: "note" }, t("waiting")));
    fill(root, ...received(watch), ...latest(watch), ...next(watch), ...uncertainties(watch));
  };
  on(["watch"], draw);
  draw();
  return root;
}

function received(watch: Watch): (Node | null)[] {
  const bar = h("progress", { max: watch.planned ?? Math.max(1, watch.received), "aria-label": t("received") });
  bar.value = watch.received;
  const count = watch.planned ? `${watch.received} / ${watch.planned}` : String(watch.received);
  return [
    h("h3", {}, `${t("received")}: ${count}`),
    watch.planned ? bar : null,
    watch.stop ? h("h3", {}, t("stopRule")) : null,
    watch.stop
      ? h("p", { class: `stop ${watch.stop.met ? "good" : ""}` }, watch.stop.met ? "✓ " : "", watch.stop.text)
      : null,
  ];
}

function latest(watch: Watch): (Node | null)[] {
  const { latest } = watch;
  if (!latest) return [];
  const words = latest.agrees ? `✓ ${t("agrees")}` : `✗ ${t("disagrees")}`;
  return [
    h("h3", {}, t("latestPose")),
    h(
      "p",
      {},
      h("button", { type: "button", class: "link", onclick: () => selectPose(latest.pose) }, `${t("pose")} ${latest.pose}`),
      latest.target ? `, ${latest.target}` : "",
      latest.error_um === undefined ? "" : `: ${length(latest.error_um)}`,
      " ",
      h("b", { class: latest.agrees ? "good" : "bad" }, words),
    ),
    latest.expected_um === undefined ? null : h("p", { class: "note" }, t("expected", { value: length(latest.expected_um) })),
    latest.message ? h("ul", { class: "messages" }, message(latest.message)) : null,
  ];
}

function next(watch: Watch): (Node | null)[] {
  const { next } = watch;
  if (!next) return [];
  const joints = scene()?.joints ?? [];
  return [
    h("h3", {}, `${t("nextPose")}: ${t("pose")} ${next.pose}`),
    h("p", { class: "note" }, next.reason),
    h(
      "dl",
      { class: "joints" },
      ...next.joints.map((value, i) =>
        h(
          "div",
          {},
          h("dt", {}, joints[i]?.name ?? String(i + 1)),
          h("dd", {}, joints[i] ? quantity(value, joints[i].unit, 5) : significant(value, 5)),
        ),
      ),
    ),
  ];
}

function uncertainties(watch: Watch): (Node | null)[] {
  if (!watch.parameters?.length) return [];
  return [
    h("h3", {}, t("uColumn")),
    scroller(
      region(t("uColumn")),
      h(
        "table",
        {},
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ...[t("parameter"), t("uNow"), t("uAtEnd")].map((head, i) =>
              h("th", { scope: "col", class: i ? "num" : "" }, head),
            ),
          ),
        ),
        h(
          "tbody",
          {},
          ...watch.parameters.map(p =>
            h(
              "tr",
              {},
              h("th", { scope: "row" }, p.name),
              h("td", { class: "num" }, quantity(p.u_now, p.unit, 2)),
              h("td", { class: "num" }, p.u_end === undefined ? "–" : quantity(p.u_end, p.unit, 2)),
            ),
          ),
        ),
      ),
    ),
  ];
}
