// Numbers with units, in the decimals that their uncertainty allows.

import { language } from "./words";

const NBSP = "\u00a0";
const formats = new Map<string, Intl.NumberFormat>();

/** Formats a number with a fixed count of decimals. */
export function fixed(value: number, decimals: number): string {
  const places = Math.max(0, Math.min(12, decimals));
  const key = `${language()} ${places}`;
  let format = formats.get(key);
  if (!format) {
    format = new Intl.NumberFormat(language(), {
      minimumFractionDigits: places,
      maximumFractionDigits: places,
      useGrouping: false,
    });
    formats.set(key, format);
  }
  // no minus sign before zero
  const rounded = Number(value.toFixed(places));
  return format.format(rounded === 0 ? 0 : rounded).replace("-", "\u2212");
}

/** Decimals that show this many significant digits. */
function decimals(value: number, digits: number): number {
  const size = Math.abs(value);
  return size > 0 && Number.isFinite(size) ? Math.max(0, digits - 1 - Math.floor(Math.log10(size))) : 0;
}

/** Formats a number with significant digits. */
export function significant(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return "–";
  return fixed(value, decimals(value, digits));
}

/** Value ± U with two digits of U, each with the unit. */
export function withU(value: number, u: number | undefined, unit: string): string {
  const shown = unit === "1" ? "" : NBSP + unit;
  if (u === undefined || !(u > 0)) return `${significant(value, 6)}${shown}`;
  const places = decimals(u, 2);
  return `${fixed(value, places)}${shown} ±${NBSP}${fixed(u, places)}${shown}`;
}

/** A value with its unit. */
export function quantity(value: number, unit: string, digits = 3): string {
  return `${significant(value, digits)}${unit === "1" ? "" : NBSP + unit}`;
}

/** A length: µm below 0.1 mm, mm above; with U if there is one. */
export function length(um: number, u?: number): string {
  const [factor, unit] = Math.abs(um) < 100 ? [1, "µm"] : [1e-3, "mm"];
  if (u !== undefined && u > 0) return withU(um * factor, u * factor, unit);
  return quantity(um * factor, unit);
}

/** A stated length, such as a limit: no digits beyond those that were stated. */
export function stated(um: number): string {
  const [value, unit] = Math.abs(um) < 100 ? [um, "µm"] : [um / 1000, "mm"];
  const text = String(Number(value.toPrecision(6)));
  return `${fixed(value, text.split(".")[1]?.length ?? 0)}${NBSP}${unit}`;
}

/** Number of µm for a column whose head carries the unit. */
export function micrometres(um: number | undefined): string {
  if (um === undefined || !Number.isFinite(um)) return "–";
  return fixed(um, Math.abs(um) < 100 ? 1 : 0);
}

/** Size of a file. */
export function bytes(count: number): string {
  if (count < 1000) return `${count}${NBSP}B`;
  if (count < 1e6) return quantity(count / 1000, "kB");
  return quantity(count / 1e6, "MB");
}

/** Time in seconds, or minutes and seconds above two minutes. */
export function time(seconds: number): string {
  if (seconds < 120) return `${fixed(seconds, 1)}${NBSP}s`;
  return `${Math.floor(seconds / 60)}${NBSP}min ${fixed(seconds % 60, 0)}${NBSP}s`;
}
