// Parts that several panels show: messages, a difference of text, progress.

import { fill, h, prose } from "./dom";
import { selectPose } from "./store";
import type { Message, Severity } from "./types";
import { named, t } from "./words";

const SIGNS: Record<Severity, string> = { error: "✗", warning: "!", info: "i" };

/** One message with its place and its hint. */
export function message(m: Message): HTMLElement {
  const { file, line, key, pose } = m.where ?? {};
  const place = [file && (line ? `${file}:${line}` : file), key].filter(Boolean).join(", ");
  return h(
    "li",
    { class: `message ${m.severity}` },
    h("span", { class: "sign", "aria-hidden": "true" }, SIGNS[m.severity] ?? "i"),
    h(
      "div",
      {},
      h("p", {}, h("b", {}, `${named(m.severity)}: `), prose(m.text)),
      m.hint && h("p", { class: "hint" }, prose(m.hint)),
      h(
        "p",
        { class: "place" },
        place && h("span", {}, place, " "),
        pose !== undefined &&
          h("button", { type: "button", class: "link", onclick: () => selectPose(pose) }, `${t("pose")} ${pose}`),
        " ",
        h("code", {}, m.id),
      ),
    ),
  );
}

const RANK: Record<Severity, number> = { error: 0, warning: 1, info: 2 };

export function messages(list: Message[]): HTMLElement {
  const sorted = [...list].sort((a, b) => RANK[a.severity] - RANK[b.severity]);
  return sorted.length
    ? h("ul", { class: "messages" }, ...sorted.map(message))
    : h("p", { class: "note" }, t("noMessages"));
}

/** A unified difference, or a whole text. */
export function difference(text: string, label: string): HTMLElement {
  const lines = text.replace(/\n$/, "").split("\n");
  const isDifference = /^(@@|---|\+\+\+)/m.test(text);
  const kind = (line: string): string => {
    if (!isDifference || /^(---|\+\+\+|@@)/.test(line)) return isDifference ? "meta" : "";
    return line.startsWith("+") ? "added" : line.startsWith("-") ? "removed" : "";
  };
  return h(
    "pre",
    { class: "difference", tabindex: 0, "aria-label": label },
    ...lines.map(line => h("code", { class: kind(line) }, `${line}\n`)),
  );
}

/** A region that scrolls sideways, and says so if it does. */
export function scroller(region: HTMLElement, ...children: HTMLElement[]): HTMLElement {
  const note = h("p", { class: "sideways", hidden: true }, t("sideways"));
  fill(region, ...children);
  const look = () => (note.hidden = region.clientWidth === 0 || region.scrollWidth <= region.clientWidth + 1);
  const observer = new ResizeObserver(look);
  [region, ...children].forEach(node => observer.observe(node));
  return h("div", { class: "scroller" }, note, region);
}

/** Region of a table. */
export const region = (label: string, kind = ""): HTMLElement =>
  h("div", { class: `scroll ${kind}`, tabindex: 0, role: "region", "aria-label": label });

/** A switch that is on or off. */
export function check(label: string, on: boolean, onchange: (on: boolean) => void, key?: string): HTMLElement {
  const box = h("input", { type: "checkbox", "data-key": key, onchange: () => onchange(box.checked) });
  box.checked = on;
  return h("label", { class: "check" }, box, label);
}

export function progress(text: string, share: number | undefined): HTMLElement {
  const bar = h("progress", { max: 1, "aria-label": t("progress") });
  if (share !== undefined) bar.value = share;
  return h("div", { class: "progress" }, bar, h("span", {}, text));
}
