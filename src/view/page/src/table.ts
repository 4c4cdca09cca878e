// Table of errors: sorted by any column, and only the rows in view exist.

import { h, fill, redraw } from "./dom";
import { micrometres } from "./numbers";
import { region, scroller } from "./parts";
import { after, isShown, on, scene, select, store } from "./store";
import type { Point, Scene } from "./types";
import { named, t } from "./words";

/** Height (px) of a row. */
const ROW = 30;
/** Rows beyond the visible part. */
const MARGIN = 8;

interface Column {
  key: string;
  head: string;
  number: boolean;
  sort(point: Point, shown: Scene): number | string;
  text(point: Point, shown: Scene): string;
}

const columns = (): Column[] => [
  {
    key: "pose",
    head: t("pose"),
    number: false,
    sort: p => p.pose,
    text: (p, s) => s.poses[p.pose].id,
  },
  { key: "target", head: t("target"), number: false, sort: p => p.target, text: p => p.target },
  {
    key: "set",
    head: t("set"),
    number: false,
    sort: (p, s) => s.poses[p.pose].set,
    text: (p, s) =>
      [named(s.poses[p.pose].set), !p.used && t("unused"), p.outlier && t("outlier")].filter(Boolean).join(", "),
  },
  {
    key: "before",
    head: `${t("before")} (µm)`,
    number: true,
    sort: p => p.magnitude_before_um ?? -1,
    text: p => micrometres(p.magnitude_before_um),
  },
  {
    key: "after",
    head: `${t("after")} (µm)`,
    number: true,
    sort: p => after(p).magnitude_after_um ?? -1,
    text: p => micrometres(after(p).magnitude_after_um),
  },
  {
    key: "u",
    head: "± U (µm)",
    number: true,
    sort: p => p.uncertainty_um ?? -1,
    text: p => micrometres(p.uncertainty_um),
  },
];

export class ErrorTable {
  readonly root: HTMLElement;
  private readonly head = h("thead");
  private readonly body = h("tbody");
  private readonly caption = h("caption");
  private readonly table = h("table", { class: "errors" }, this.caption, this.head, this.body);
  private readonly scroll = region(t("errorsTab"), "rows");
  private order: number[] = [];
  private sort = { key: "pose", down: false };

  constructor() {
    this.root = h("div", { class: "errors-tab" }, scroller(this.scroll, this.table));
    this.scroll.addEventListener("scroll", () => this.draw(), { passive: true });
    this.scroll.addEventListener("keydown", event => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.scroll);
    on(["scene", "view", "what"], () => this.arrange());
    on(["selection"], () => {
      this.reveal();
      this.draw();
    });
    this.arrange();
  }

  private arrange(): void {
    const shown = scene();
    const column = columns().find(c => c.key === this.sort.key) ?? columns()[0];
    this.order = (shown?.points ?? []).map((_, i) => i).filter(i => shown && isShown(shown.points[i]));
    if (shown) {
      const sign = this.sort.down ? -1 : 1;
      const keys = new Map(this.order.map(i => [i, column.sort(shown.points[i], shown)]));
      this.order.sort((a, b) => {
        const [x, y] = [keys.get(a) ?? 0, keys.get(b) ?? 0];
        const by = typeof x === "string" ? x.localeCompare(String(y), undefined, { numeric: true }) : x - Number(y);
        return sign * by || a - b;
      });
    }
    this.caption.textContent = t("shownPoints", { shown: this.order.length, count: shown?.points.length ?? 0 });
    this.table.setAttribute("aria-rowcount", String(this.order.length + 1));
    redraw(this.head, () =>
      fill(
        this.head,
        h(
          "tr",
          { "aria-rowindex": 1 },
          ...columns().map(c => {
            const state = this.sort.key !== c.key ? "none" : this.sort.down ? "descending" : "ascending";
            const sort = () => {
              this.sort = { key: c.key, down: this.sort.key === c.key ? !this.sort.down : c.number };
              this.scroll.scrollTop = 0;
              this.arrange();
            };
            return h(
              "th",
              { scope: "col", class: c.number ? "num" : "", "aria-sort": state },
              h("button", { type: "button", "data-key": c.key, onclick: sort }, c.head),
            );
          }),
        ),
      ),
    );
    this.draw();
  }

  private draw(): void {
    const shown = scene();
    const { scrollTop, clientHeight } = this.scroll;
    const first = Math.max(0, Math.floor(scrollTop / ROW) - MARGIN);
    const last = Math.min(this.order.length, Math.ceil((scrollTop + (clientHeight || 600)) / ROW) + MARGIN);
    const spacer = (rows: number) => {
      if (rows <= 0) return null;
      const cell = h("td", { colspan: 6, class: "spacer" });
      cell.style.height = `${rows * ROW}px`;
      return h("tr", { "aria-hidden": "true" }, cell);
    };
    if (!shown) return fill(this.body);
    redraw(this.body, () =>
      fill(
        this.body,
        spacer(first),
        ...this.order.slice(first, last).map((i, k) => this.row(shown, i, first + k)),
        spacer(this.order.length - last),
      ),
    );
  }

  private row(shown: Scene, index: number, at: number): HTMLElement {
    const point = shown.points[index];
    const isChosen = point.pose === store.pose;
    const classes = [isChosen && "chosen", index === store.point && "point", !point.used && "unused", point.outlier && "outlier"];
    const row = h(
      "tr",
      { "aria-rowindex": at + 2, "aria-current": isChosen ? "true" : null, class: classes.filter(Boolean).join(" ") },
      ...columns().map((column, i) => {
        const text = column.text(point, shown);
        if (i > 0) return h("td", { class: column.number ? "num" : "" }, text);
        const pick = () => select(point.pose, index);
        const pressed = isChosen ? "true" : "false";
        return h(
          "th",
          { scope: "row" },
          h("button", { type: "button", class: "pick", "data-key": `p${index}`, "aria-pressed": pressed, onclick: pick }, text),
        );
      }),
    );
    row.addEventListener("click", () => select(point.pose, index));
    return row;
  }

  private key(event: KeyboardEvent): void {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!by) return;
    const at = this.order.indexOf(store.point);
    const start = at >= 0 ? at : this.order.findIndex(i => scene()?.points[i].pose === store.pose) - by;
    const next = this.order[Math.max(0, Math.min(this.order.length - 1, start + by))];
    const shown = scene();
    if (next === undefined || !shown) return;
    event.preventDefault();
    const isOnRow = document.activeElement?.classList.contains("pick");
    select(shown.points[next].pose, next);
    if (isOnRow) this.body.querySelector<HTMLElement>(`[data-key="p${next}"]`)?.focus({ preventScroll: true });
  }

  /** Scrolls to the selected row if it is out of sight. */
  private reveal(): void {
    const shown = scene();
    const at = this.order.findIndex(i => (store.point >= 0 ? i === store.point : shown?.points[i].pose === store.pose));
    if (at < 0) return;
    const [top, height] = [this.scroll.scrollTop, this.scroll.clientHeight];
    const head = this.head.offsetHeight + this.caption.offsetHeight;
    const y = at * ROW;
    if (y < top) this.scroll.scrollTop = y;
    else if (y + ROW > top + height - head) this.scroll.scrollTop = y + ROW - height + head;
  }
}
