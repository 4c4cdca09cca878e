// Panels beside the robot: result, parameters, messages, selected pose.

import { api } from "./api";
import { fill, h, prose, redraw } from "./dom";
import { bytes, fixed, length, micrometres, quantity, significant, stated, time } from "./numbers";
import { messages, region, scroller } from "./parts";
import { after, on, pointsOf, scene, select, store, worst } from "./store";
import type { Parameter, Scene, Status } from "./types";
import { named, t } from "./words";

const SIGNS: Record<Status, string> = { pass: "✓", fail: "✗", conditional: "!", undecided: "?", none: "–" };

export function badge(status: Status): HTMLElement {
  return h("span", { class: `badge ${status}` }, h("span", { "aria-hidden": "true" }, SIGNS[status]), " ", named(status));
}

/** Largest error with U and limit, in words. */
export function largest(): string | null {
  const maximum = store.state?.maximum;
  const limit = (um: number | undefined) => (um === undefined ? "" : `, ${t("limit")} ${stated(um)}`);
  if (store.what) {
    const { now, uncertainty } = store.what.maximum_um;
    return length(now, uncertainty) + (uncertainty ? " (k\u00a0=\u00a02)" : "") + limit(store.asked.limit_um ?? maximum?.limit_um);
  }
  if (maximum)
    return (
      length(maximum.value_um, maximum.uncertainty_um) +
      (maximum.uncertainty_um ? " (k\u00a0=\u00a02)" : "") +
      limit(maximum.limit_um)
    );
  const found = worst();
  const shown = scene();
  if (!found || !shown) return null;
  const u = shown.points[found.point].uncertainty_um;
  return length(found.um, u) + (u ? " (k\u00a0=\u00a02)" : "");
}

export function result(): HTMLElement {
  const root = h("div", { class: "panel" });
  const draw = () => {
    const { state } = store;
    const verdict = store.what?.verdict ?? state?.verdict;
    const links = store.offline ? [] : (state?.downloads ?? []);
    fill(
      root,
      verdict && h("h3", {}, t("verdict")),
      verdict && h("p", {}, badge(verdict.status)),
      ...(verdict?.lines ?? []).map(line => h("p", { class: "line" }, prose(line))),
      !verdict && h("p", { class: "note" }, t("noResult")),
      verdict && verdict.next.length > 0 && h("h3", {}, t("nextSteps")),
      verdict && verdict.next.length > 0 && h("ol", { class: "steps" }, ...verdict.next.map(step => h("li", {}, prose(step)))),
      (links.length > 0 || !store.offline) && h("h3", {}, t("downloads")),
      h(
        "ul",
        { class: "downloads" },
        ...links.map(d =>
          h(
            "li",
            {},
            h("a", { href: api.download(d.name), download: d.name }, d.label || d.name),
            h("span", { class: "note" }, ` ${d.name}, ${bytes(d.bytes)}`),
          ),
        ),
        !store.offline &&
          state?.scene &&
          h("li", {}, h("a", { href: api.exportPage(), download: "view.html" }, t("exportPage"))),
      ),
    );
  };
  on(["state", "what", "online"], draw);
  draw();
  return root;
}

/** Value ± u and nominal in the decimals of u. */
function parameterRow(p: Parameter): HTMLElement {
  const u = p.held ? undefined : p.uncertainty;
  const places = u && u > 0 ? Math.min(9, Math.max(0, 1 - Math.floor(Math.log10(u)))) : undefined;
  const show = (value: number) => (places === undefined ? significant(value, 6) : fixed(value, places));
  const change = p.identified - p.nominal;
  const isMoved = u !== undefined && Math.abs(change) > 2 * u;
  return h(
    "tr",
    { class: p.held ? "unused" : "" },
    h("th", { scope: "row", title: p.meaning }, p.name, h("small", {}, ` ${p.unit}${p.held ? `, ${t("held")}` : ""}`)),
    h("td", { class: "num" }, show(p.nominal)),
    h("td", { class: "num" }, show(p.identified), u && places !== undefined ? ` ±\u00a0${fixed(u, places)}` : ""),
    h("td", { class: "num" }, p.held ? "–" : `${change > 0 ? "+" : ""}${show(change)}`, isMoved && h("b", {}, " *")),
  );
}

export function parameters(): HTMLElement {
  const filter = h("input", { type: "search", id: "parameter-filter", oninput: () => draw() });
  const body = h("tbody");
  const root = h(
    "div",
    { class: "panel" },
    h("p", { class: "filter" }, h("label", { for: "parameter-filter" }, t("searchParameter")), filter),
    scroller(
      region(t("parametersTab")),
      h(
        "table",
        {},
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            ...[t("parameter"), t("nominal"), t("value"), t("changeHead")].map((head, i) =>
              h("th", { scope: "col", class: i > 0 ? "num" : "" }, head),
            ),
          ),
        ),
        body,
      ),
    ),
    h("p", { class: "note" }, t("moved")),
  );
  const draw = () => {
    const wanted = filter.value.trim().toLowerCase();
    const list = store.what?.parameters ?? store.state?.parameters ?? [];
    fill(body, ...list.filter(p => p.name.toLowerCase().includes(wanted)).map(parameterRow));
  };
  on(["state", "what"], draw);
  draw();
  return root;
}

export function messagesPanel(): HTMLElement {
  const root = h("div", { class: "panel" });
  const draw = () => fill(root, messages([...(store.state?.messages ?? []), ...(store.what?.messages ?? [])]));
  on(["state", "what"], draw);
  draw();
  return root;
}

/** Joint values and errors of the selected pose. */
export function selected(leaveOut: ((pose: string) => void) | null): HTMLElement {
  const root = h("section", { class: "selected", "aria-label": t("selected") });
  const draw = () => {
    const shown = scene();
    const pose = shown?.poses[store.pose];
    root.hidden = !pose;
    if (!shown || !pose) return;
    const isOut = store.asked.leave_out_poses?.includes(pose.id) ?? false;
    redraw(root, () =>
      fill(
        root,
        h(
          "h2",
          {},
          `${t("pose")} ${pose.id}`,
          h("small", {}, ` ${named(pose.set)}${pose.time_s === undefined ? "" : `, ${time(pose.time_s)}`}`),
          leaveOut &&
            h(
              "button",
              { type: "button", class: "small", "data-key": "out", "aria-pressed": String(isOut), onclick: () => leaveOut(pose.id) },
              t("leaveOutPose"),
            ),
        ),
        pointsTable(),
        shown.joints.length > 0 &&
          h("dl", { class: "joints" }, ...shown.joints.map((joint, i) => jointCell(joint, pose.joints[i]))),
      ),
    );
  };
  on(["scene", "selection", "what"], draw);
  draw();
  return root;
}

/** Errors of the targets at the selected pose. */
function pointsTable(): HTMLElement {
  const shown = scene();
  const heads = [t("target"), t("before"), `${t("after")} ± U`, "x", "y", "z"];
  return scroller(
    region(`${t("pose")} ${shown?.poses[store.pose]?.id ?? ""}: ${t("errorsTab")}`),
    h(
      "table",
      { class: "targets" },
      h("caption", {}, t("errorCaption")),
      h("thead", {}, h("tr", {}, ...heads.map((head, i) => h("th", { scope: "col", class: i ? "num" : "" }, head)))),
      h("tbody", {}, ...pointsOf(store.pose).slice(0, 24).map(i => (shown ? pointRow(shown, i) : null))),
    ),
  );
}

function pointRow(shown: Scene, i: number): HTMLElement {
  const point = shown.points[i];
  const error = after(point);
  const now = error.magnitude_after_um;
  const u = point.uncertainty_um;
  const places = u && u < 10 ? 1 : 0;
  const cells = [
    micrometres(point.magnitude_before_um),
    now === undefined ? "–" : u ? `${fixed(now, places)} ±\u00a0${fixed(u, places)}` : micrometres(now),
    ...[0, 1, 2].map(axis => (error.after ? fixed(error.after[axis], places) : "–")),
  ];
  const flags = [point.outlier && t("outlier"), !point.used && t("unused")].filter(Boolean).join(", ");
  return h(
    "tr",
    { class: i === store.point ? "chosen point" : "" },
    h(
      "th",
      { scope: "row" },
      h("button", { type: "button", class: "link", "data-key": `t${i}`, onclick: () => select(point.pose, i) }, point.target),
      flags && h("span", { class: "flag" }, ` ${flags}`),
    ),
    ...cells.map(cell => h("td", { class: "num" }, cell)),
  );
}

function jointCell(joint: { name: string; unit: string; lower?: number; upper?: number }, value: number | undefined): HTMLElement {
  const { lower, upper } = joint;
  const isBounded = lower !== undefined && upper !== undefined && upper > lower && value !== undefined;
  const range = h("span", { class: "range", "aria-hidden": "true" }, h("i"));
  if (isBounded) {
    const share = Math.max(0, Math.min(1, (value - lower) / (upper - lower)));
    (range.firstElementChild as HTMLElement).style.left = `${share * 100}%`;
  }
  return h("div", {}, h("dt", {}, joint.name), h("dd", {}, value === undefined ? "–" : quantity(value, joint.unit, 5), isBounded && range));
}

