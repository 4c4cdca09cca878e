// Colour scales that people with any colour vision can read.

export type Rgb = [number, number, number];

// 17 samples of matplotlib's scales (CC0)
const CIVIDIS =
  "00224e 002e6b 163b70 2f466c 42526b 525d6d 61696f 707573 7f8078 8f8c78 a09a75 b1a570 c3b369 d5c160 e7cf55 f8de45 fee838";
const VIRIDIS =
  "440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c 1fa088 28ae80 3fbc73 5ec962 84d44b addc30 d8e219 fde725";

const parse = (hex: string): Rgb => [0, 2, 4].map(i => parseInt(hex.slice(i, i + 2), 16) / 255) as Rgb;
const scales = { cividis: CIVIDIS.split(" ").map(parse), viridis: VIRIDIS.split(" ").map(parse) };

export type Scale = keyof typeof scales;

/** Part of a scale that differs from the background. */
const range = (dark: boolean): [number, number] => (dark ? [0.28, 1] : [0, 0.86]);

/** Colour of a share from 0 to 1. */
export function colour(scale: Scale, share: number, dark: boolean): Rgb {
  const [from, to] = range(dark);
  const at = (from + Math.max(0, Math.min(1, share)) * (to - from)) * 16;
  const low = Math.min(15, Math.floor(at));
  const [a, b] = [scales[scale][low], scales[scale][low + 1]];
  return [0, 1, 2].map(i => a[i] + (b[i] - a[i]) * (at - low)) as Rgb;
}

/** Categories after Okabe and Ito. */
const CATEGORIES = ["0072b2", "d55e00", "009e73", "cc79a7", "56b4e9", "e69f00", "7a6a00", "555555"].map(parse);
const CATEGORIES_DARK = ["56b4e9", "e69f00", "2cc79a", "cc79a7", "8ecdf0", "ff8a3d", "f0e442", "bbbbbb"].map(parse);

export const category = (index: number, dark: boolean): Rgb => {
  const list = dark ? CATEGORIES_DARK : CATEGORIES;
  return list[index % list.length];
};

export const css = (c: Rgb): string => `rgb(${c.map(v => Math.round(v * 255)).join(" ")})`;
export const rgb = (hex: string): Rgb => parse(hex.replace("#", ""));

const query = matchMedia("(prefers-color-scheme: dark)");
export const isDark = (): boolean => query.matches;
export const onDark = (listen: () => void): void => query.addEventListener("change", listen);
