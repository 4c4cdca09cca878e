// Elements of the page. Text is only ever set as text: names are never interpreted as markup.

type Child = Node | string | number | null | undefined | false;
type Attributes = Record<string, string | number | boolean | null | undefined | ((event: any) => void)>;

/** Creates an element. `on…` attributes are listeners; `false`, `null` and `undefined` are left out. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, "");
    else node.setAttribute(name, String(value));
  }
  add(node, ...children);
  return node;
}

export function add(node: Element, ...children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    node.append(typeof child === "number" ? String(child) : child);
  }
}

/** Replaces the children of a node. */
export function fill(node: Element, ...children: Child[]): void {
  node.replaceChildren();
  add(node, ...children);
}

/** Text in which words between backticks are code. */
export function prose(text: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  text.split("`").forEach((part, i, all) => {
    const isCode = i % 2 === 1 && i < all.length - 1;
    fragment.append(isCode ? h("code", {}, part) : i % 2 === 1 ? `\`${part}` : part);
  });
  return fragment;
}

/** Sets the text only if it changes, so that a live region is not read twice. */
export function say(node: Element, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

let count = 0;

/** Returns an id that is unique in the page. */
export function unique(stem: string): string {
  count += 1;
  return `${stem}-${count}`;
}

export function button(label: string, onclick: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return h("button", { type: "button", onclick, ...attributes }, label);
}

/** Keeps the focus on the element of the same `data-key` while `draw` replaces the contents. */
export function redraw(root: Element, draw: () => void): void {
  const active = document.activeElement;
  const key = active && root.contains(active) ? active.getAttribute("data-key") : null;
  const scroll = root.scrollTop;
  draw();
  root.scrollTop = scroll;
  if (key === null) return;
  for (const node of root.querySelectorAll<HTMLElement>("[data-key]"))
    if (node.getAttribute("data-key") === key) return node.focus({ preventScroll: true });
}

export const reducedMotion = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;
