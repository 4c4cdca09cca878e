// Colours of points, and the words for them.

import { category, colour, css, isDark, type Rgb, type Scale } from "./colours";
import { h } from "./dom";
import { length, quantity, significant, time } from "./numbers";
import { after, isShown, store } from "./store";
import type { Scene } from "./types";
import { named, t } from "./words";

export interface Painter {
  colour(point: number): Rgb | null;
  legend(): HTMLElement;
  /** Largest shown error (µm). */
  largest(which: "before" | "after"): number;
}

interface Quantity {
  label: string;
  value(point: number): number | undefined;
  text(value: number): string;
  scale: Scale;
  fromZero: boolean;
}

function quantityBy(shown: Scene, by: string): Quantity | null {
  const point = (i: number) => shown.points[i];
  const error = { text: (v: number) => length(v), scale: "cividis" as const, fromZero: true };
  if (by === "after") return { ...error, label: t("errorAfter"), value: i => after(point(i)).magnitude_after_um };
  if (by === "before") return { ...error, label: t("errorBefore"), value: i => point(i).magnitude_before_um };
  if (by === "time")
    return {
      label: t("time"),
      value: i => shown.poses[point(i).pose].time_s ?? point(i).pose,
      text: v => (shown.poses.some(pose => pose.time_s !== undefined) ? time(v) : `${t("pose")} ${shown.poses[v]?.id ?? v}`),
      scale: "viridis",
      fromZero: false,
    };
  const joint = /^joint:(\d+)$/.exec(by);
  const described = joint && shown.joints[Number(joint[1])];
  if (!joint || !described) return null;
  return {
    label: described.name,
    value: i => shown.poses[point(i).pose].joints[Number(joint[1])],
    text: v => quantity(v, described.unit, 3),
    scale: "viridis",
    fromZero: false,
  };
}

function categories(shown: Scene, by: string): { list: string[]; key: (point: number) => string } {
  const key =
    by === "set" ? (i: number) => shown.poses[shown.points[i].pose].set : (i: number) => shown.points[i].target;
  return { list: [...new Set(shown.points.map((_, i) => key(i)))], key };
}

let cached: { key: string; shown: Scene; what: unknown; painter: Painter } | null = null;

/** Colours of the present view. */
export function painter(shown: Scene): Painter {
  const { colour: by, set, target } = store.view;
  const key = JSON.stringify([by, set, target, isDark()]);
  if (cached && cached.key === key && cached.shown === shown && cached.what === store.what) return cached.painter;
  const made = make(shown, by);
  cached = { key, shown, what: store.what, painter: made };
  return made;
}

function make(shown: Scene, by: string): Painter {
  const largest = (which: "before" | "after"): number =>
    shown.points.reduce((most, point) => {
      const um = which === "after" ? after(point).magnitude_after_um : point.magnitude_before_um;
      return isShown(point) && um !== undefined ? Math.max(most, um) : most;
    }, 0);
  const dark = isDark();
  const measured = quantityBy(shown, by);
  if (!measured) {
    const { list, key } = categories(shown, by);
    return {
      colour: i => category(list.indexOf(key(i)), dark),
      legend: () =>
        h(
          "ul",
          { class: "chips" },
          ...list.slice(0, 12).map((name, i) => {
            const chip = h("span", { class: "chip", "aria-hidden": "true" });
            chip.style.background = css(category(i, dark));
            return h("li", {}, chip, named(name));
          }),
        ),
      largest,
    };
  }
  let [low, high] = [Infinity, -Infinity];
  shown.points.forEach((point, i) => {
    const value = measured.value(i);
    // an excluded reading does not stretch the scale
    if (value === undefined || !isShown(point) || !point.used) return;
    low = Math.min(low, value);
    high = Math.max(high, value);
  });
  if (!(low <= high)) [low, high] = [0, 1];
  if (measured.fromZero) low = 0;
  return {
    colour: i => {
      const value = measured.value(i);
      return value === undefined ? null : colour(measured.scale, high > low ? (value - low) / (high - low) : 0.5, dark);
    },
    legend: () => {
      const bar = h("span", { class: "bar", "aria-hidden": "true" });
      const stops = Array.from({ length: 9 }, (_, i) => css(colour(measured.scale, i / 8, dark)));
      bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
      return h(
        "p",
        { class: "scale" },
        h("b", {}, measured.label),
        h("span", {}, measured.text(low)),
        bar,
        h("span", {}, measured.text(high)),
      );
    },
    largest,
  };
}

/** A point in words. */
export function describe(shown: Scene, index: number): HTMLElement {
  const point = shown.points[index];
  const pose = shown.poses[point.pose];
  const now = after(point).magnitude_after_um;
  const lines: string[] = [];
  if (point.magnitude_before_um !== undefined) lines.push(`${t("errorBefore")}: ${length(point.magnitude_before_um)}`);
  if (now !== undefined) lines.push(`${t("errorAfter")}: ${length(now, point.uncertainty_um)}`);
  if (!point.used) lines.push(t("unused"));
  if (point.outlier) lines.push(t("outlier"));
  return h(
    "div",
    {},
    h("b", {}, `${t("pose")} ${pose.id}, ${point.target}`),
    h("div", {}, named(pose.set)),
    ...lines.map(line => h("div", {}, line)),
  );
}

export const times = (factor: number): string => `× ${significant(factor, 2)}`;
