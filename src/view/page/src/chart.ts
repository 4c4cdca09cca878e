// Errors of all points against the order of measurement, the time, or a joint.

import uPlot from "uplot";
import { isDark } from "./colours";
import { h, fill } from "./dom";
import { length, significant, stated } from "./numbers";
import { after, isShown, on, scene, select, store, worst } from "./store";
import type { Scene } from "./types";
import { t } from "./words";

/** Points from which they are drawn as one picture. */
const DENSE = 1000;
/** Points up to which uncertainties are drawn as bars. */
const BARS = 600;

export class Chart {
  readonly root: HTMLElement;
  private readonly area = h("div", { class: "plot", role: "img" });
  private readonly against = h("select", { id: "against", onchange: () => this.rebuild() });
  private readonly scale = h(
    "select",
    { id: "scale", "aria-label": t("errorUm"), onchange: () => this.rebuild() },
    h("option", { value: "log" }, t("logarithmic")),
    h("option", { value: "linear" }, t("linear")),
  );
  private plot: uPlot | null = null;
  /** Index of the point of each mark. */
  private marks: number[] = [];
  private drawn: Scene | undefined;

  constructor() {
    const title = h("h2", { id: "chart-title" }, t("errorUm"));
    const controls = h(
      "div",
      { class: "controls" },
      title,
      h("label", { for: "against" }, t("xAxis")),
      this.against,
      this.scale,
      h("span", { class: "key" }, h("i", { class: "mark before" }), t("before")),
      h("span", { class: "key" }, h("i", { class: "mark after" }), `${t("after")} ± U`),
    );
    this.root = h("section", { class: "chart", "aria-labelledby": "chart-title" }, controls, this.area);
    new ResizeObserver(() => this.resize()).observe(this.area);
    on(["scene"], () => this.scene());
    on(["view", "what", "dark"], () => this.rebuild());
    on(["selection"], () => this.plot?.redraw(false, false));
    this.scene();
  }

  private scene(): void {
    const shown = scene();
    this.root.hidden = !shown || !shown.points.some(p => p.magnitude_after_um ?? p.magnitude_before_um);
    const chosen = this.against.value;
    const options: [string, string][] = [["order", t("order")]];
    if (shown?.poses.every(pose => pose.time_s !== undefined)) options.push(["time", t("timeAxis")]);
    shown?.joints.forEach((joint, i) => options.push([`joint:${i}`, joint.name]));
    fill(this.against, ...options.map(([value, text]) => h("option", { value }, text)));
    if (options.some(([value]) => value === chosen)) this.against.value = chosen;
    this.rebuild();
  }

  private value(shown: Scene, by: string, point: number): number {
    const pose = shown.poses[shown.points[point].pose];
    if (by === "time") return pose.time_s ?? 0;
    const joint = /^joint:(\d+)$/.exec(by);
    return joint ? pose.joints[Number(joint[1])] : shown.points[point].pose;
  }

  private label(shown: Scene, by: string): string {
    const joint = /^joint:(\d+)$/.exec(by);
    const described = joint && shown.joints[Number(joint[1])];
    if (described) return `${described.name} (${described.unit})`;
    return by === "time" ? `${t("time")} (s)` : t("pose");
  }

  private rebuild(): void {
    const shown = scene();
    this.plot?.destroy();
    this.plot = null;
    this.drawn = shown;
    if (!shown || this.root.hidden) return;
    const by = this.against.value || "order";
    const marks = shown.points.map((_, i) => i).filter(i => isShown(shown.points[i]));
    const x = new Map(marks.map(i => [i, this.value(shown, by, i)]));
    marks.sort((a, b) => (x.get(a) ?? 0) - (x.get(b) ?? 0) || a - b);
    this.marks = marks;
    const isLog = this.scale.value !== "linear";
    const positive = (um: number | undefined): number | null =>
      um === undefined ? null : isLog ? Math.max(um, 1e-3) : um;
    const data: uPlot.AlignedData = [
      marks.map(i => x.get(i) ?? 0),
      marks.map(i => positive(shown.points[i].magnitude_before_um)),
      marks.map(i => positive(after(shown.points[i]).magnitude_after_um)),
    ];
    this.plot = new uPlot(this.options(shown, by, isLog), data, this.area);
    const largest = worst();
    this.area.setAttribute(
      "aria-label",
      t("chartText", { count: marks.length, axis: this.label(shown, by), worst: largest ? length(largest.um) : "–" }),
    );
  }

  private options(shown: Scene, by: string, isLog: boolean): uPlot.Options {
    const dark = isDark();
    const [ink, soft, grid] = dark ? ["#d5dae0", "#8e98a3", "#2c333b"] : ["#1b1f24", "#8a939d", "#e4e8ec"];
    const accent = dark ? "#6fb0ff" : "#1f5fb0";
    const font = "12px system-ui, sans-serif";
    const none = () => null;
    const axis = { stroke: ink, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1 }, font };
    const isDense = this.marks.length > DENSE;
    return {
      width: Math.max(120, this.area.clientWidth),
      height: Math.max(90, this.area.clientHeight),
      legend: { show: false },
      cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
      scales: {
        x: { time: false, range: (_, low, high) => pad(low, high) },
        y: isLog ? { distr: 3, log: 10, range: (_, low, high) => [(low || 1) / 1.6, (high || 10) * 1.5] } : { range: (_, _low, high) => [0, (high || 1) * 1.06] },
      },
      axes: [
        {
          ...axis,
          size: 34,
          label: this.label(shown, by),
          labelFont: font,
          labelSize: 14,
          space: 46,
          ...(by === "order"
            ? { values: (_, ticks) => ticks.map(v => (Number.isInteger(v) ? (shown.poses[v]?.id ?? "") : "")) }
            : { values: (_, ticks) => ticks.map(v => significant(v, 3).replace(/([.,]\d*?)0+$/, "$1").replace(/[.,]$/, "")) }),
        },
        {
          ...axis,
          size: 54,
          values: (_, ticks) => ticks.map(v => (v === null ? "" : significant(v, 1))),
          ...(isLog ? { filter: (plot: uPlot, ticks: number[]) => readable(plot, ticks) } : {}),
        },
      ],
      series: [
        {},
        {
          stroke: soft,
          paths: none,
          points: { show: false },
        },
        { stroke: accent, paths: none, points: { show: false } },
      ],
      hooks: {
        drawAxes: [plot => this.drawSelection(plot)],
        draw: [
          plot => (isDense ? this.drawDense(plot, [soft, accent]) : this.drawCircles(plot, [soft, accent])),
          plot => this.drawMarks(plot, accent),
        ],
        ready: [plot => this.answer(plot)],
      },
    };
  }

  /** Band of the selected pose. */
  private drawSelection(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const at = this.marks.flatMap((i, mark) => (this.drawn?.points[i].pose === store.pose ? [plot.data[0][mark]] : []));
    if (at.length === 0) return;
    ctx.save();
    ctx.fillStyle = isDark() ? "#ff6ee055" : "#c4009c33";
    const x = plot.valToPos(at[0], "x", true);
    ctx.fillRect(x - 4, bbox.top, 8, bbox.height);
    ctx.restore();
  }

  /** Points as circles, drawn into one picture: without a graphics processor, a circle on the page takes half a millisecond. */
  private drawCircles(plot: uPlot, colours: string[]): void {
    const { ctx, data } = plot;
    const { width, height } = ctx.canvas;
    const picture = h("canvas", { width, height });
    const own = picture.getContext("2d", { willReadFrequently: true });
    if (!own || width < 1 || height < 1) return;
    own.lineWidth = devicePixelRatio;
    colours.forEach((colour, i) => {
      const isBefore = i === 0;
      own.strokeStyle = colour;
      own.fillStyle = !isBefore ? colour : isDark() ? "#15181c" : "#fff";
      data[i + 1].forEach((um, mark) => {
        if (um == null) return;
        own.beginPath();
        own.arc(plot.valToPos(data[0][mark], "x", true), plot.valToPos(um, "y", true), 2.5 * devicePixelRatio, 0, 2 * Math.PI);
        own.fill();
        if (isBefore) own.stroke();
      });
    });
    ctx.drawImage(picture, 0, 0);
  }

  /** Thousands of points, as one picture. */
  private drawDense(plot: uPlot, colours: string[]): void {
    const { ctx, bbox, data } = plot;
    const [width, height] = [Math.ceil(bbox.width), Math.ceil(bbox.height)];
    const picture = h("canvas", { width, height });
    const own = picture.getContext("2d", { willReadFrequently: true });
    if (!own || width < 1 || height < 1) return;
    const image = own.createImageData(width, height);
    const pixels = new Uint32Array(image.data.buffer);
    colours.forEach((colour, i) => {
      const [r, g, b] = [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16));
      const opaque = ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
      data[i + 1].forEach((um, mark) => {
        if (um == null) return;
        const x = Math.round(plot.valToPos(data[0][mark], "x", true) - bbox.left);
        const y = Math.round(plot.valToPos(um, "y", true) - bbox.top);
        for (let down = -1; down <= 1; down++)
          for (let right = -1; right <= 1; right++)
            if (x + right >= 0 && x + right < width && y + down >= 0 && y + down < height)
              pixels[(y + down) * width + x + right] = opaque;
      });
    });
    own.putImageData(image, 0, 0);
    ctx.drawImage(picture, bbox.left, bbox.top);
  }

  /** Uncertainties and limit. */
  private drawMarks(plot: uPlot, accent: string): void {
    const shown = this.drawn;
    if (!shown) return;
    const { ctx, bbox } = plot;
    const y = (um: number): number =>
      Math.max(bbox.top, Math.min(bbox.top + bbox.height, plot.valToPos(Math.max(um, 1e-3), "y", true)));
    ctx.save();
    ctx.strokeStyle = accent;
    ctx.globalAlpha = 0.4;
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    if (this.marks.length <= BARS)
      this.marks.forEach((i, mark) => {
        const [um, u] = [plot.data[2][mark], shown.points[i].uncertainty_um];
        if (um == null || !u) return;
        const x = plot.valToPos(plot.data[0][mark], "x", true);
        ctx.moveTo(x, y(Math.max(0, um - u)));
        ctx.lineTo(x, y(um + u));
      });
    ctx.stroke();
    const limit = store.asked.limit_um ?? store.state?.maximum?.limit_um;
    const at = limit === undefined ? NaN : plot.valToPos(limit, "y", true);
    if (limit !== undefined && at >= bbox.top && at <= bbox.top + bbox.height) {
      ctx.globalAlpha = 1;
      ctx.strokeStyle = ctx.fillStyle = isDark() ? "#ff8a85" : "#a3201d";
      ctx.setLineDash([6, 4]);
      ctx.beginPath();
      ctx.moveTo(bbox.left, at);
      ctx.lineTo(bbox.left + bbox.width, at);
      ctx.stroke();
      ctx.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
      ctx.textAlign = "left";
      ctx.textBaseline = "bottom";
      ctx.fillText(`${t("limit")} ${stated(limit)}`, bbox.left + 6 * devicePixelRatio, at - 2);
    }
    ctx.restore();
  }

  /** Selects the mark nearest to the pointer. */
  private answer(plot: uPlot): void {
    plot.over.addEventListener("click", event => {
      const found = this.nearest(plot, event);
      const shown = this.drawn;
      if (found >= 0 && shown) select(shown.points[found].pose, found);
    });
    plot.over.addEventListener("mousemove", event => {
      const found = this.nearest(plot, event);
      const shown = this.drawn;
      if (found < 0 || !shown) return plot.over.removeAttribute("title");
      const point = shown.points[found];
      const um = after(point).magnitude_after_um;
      const text = `${t("pose")} ${shown.poses[point.pose].id}, ${point.target}: ${um === undefined ? "–" : length(um, point.uncertainty_um)}`;
      if (plot.over.title !== text) plot.over.title = text;
    });
  }

  private nearest(plot: uPlot, event: MouseEvent): number {
    const box = plot.over.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    let [best, found] = [18, -1];
    this.marks.forEach((i, mark) => {
      const px = plot.valToPos(plot.data[0][mark], "x");
      if (Math.abs(px - x) > best) return;
      for (const series of [1, 2]) {
        const value = plot.data[series][mark];
        if (value == null) continue;
        const away = Math.hypot(px - x, plot.valToPos(value, "y") - y);
        if (away < best) [best, found] = [away, i];
      }
    });
    return found;
  }

  private resize(): void {
    const [width, height] = [this.area.clientWidth, this.area.clientHeight];
    if (width < 10 || height < 10) return;
    if (!this.plot) return this.rebuild();
    this.plot.setSize({ width, height });
  }
}

/** Powers of ten, and 2 and 5 times them if few powers are in sight. */
function readable(plot: uPlot, ticks: number[]): (number | null)[] {
  const { min, max } = plot.scales.y;
  const leads = Math.log10((max ?? 10) / (min ?? 1)) < 1.7 ? [1, 2, 5] : [1];
  return ticks.map(v => (leads.some(lead => Math.abs(v / 10 ** Math.floor(Math.log10(v) + 1e-9) - lead) < 1e-6) ? v : null));
}

function pad(low: number, high: number): [number, number] {
  const by = Math.max((high - low) * 0.03, high === low ? 1 : 0);
  return [low - by, high + by];
}

