// Rows put into few groups by the value of one column: levels where it was set to few values, else
// parts of about equally many rows.
import { plain, quantity } from './text';

export interface Group {
  label: string;
  rows: number[];
  from: number;
  to: number;
}

const mostLevels = 8;

interface Range {
  from: number;
  to: number;
}

function label({ from, to }: Range, name: string): string {
  const { unit } = quantity(name);
  const low = plain(from, 3);
  const high = plain(to, 3);
  const text = low === high ? low : `${low}…${high}`;
  return unit === '°' ? `${text}°` : `${text} ${unit}`.trim();
}

/// Levels of sorted values, if they are few and narrow.
function levels(values: Float64Array, most: number): Range[] | undefined {
  const range = (values[values.length - 1] as number) - (values[0] as number);
  const list: Range[] = [];
  for (const value of values) {
    const last = list[list.length - 1];
    if (last && value - last.to <= 0.04 * range) last.to = value;
    else if (list.length === most) return undefined;
    else list.push({ from: value, to: value });
  }
  return list.every((level) => level.to - level.from <= 0.12 * range) ? list : undefined;
}

/// Parts of about equally many of sorted values; equal values stay together.
function quantiles(values: Float64Array, parts: number): Range[] {
  const list: Range[] = [];
  values.forEach((value, k) => {
    const last = list[list.length - 1];
    if (!last || (k >= (list.length * values.length) / parts && value > last.to)) list.push({ from: value, to: value });
    else last.to = value;
  });
  return list;
}

/// At most `most` groups, or as many levels, by rising value; rows in their order. Rows without a
/// finite value are in none.
export function groups(values: Float64Array, name: string, most: number): Group[] {
  const ordered = values.filter(Number.isFinite).sort();
  if (ordered.length === 0) return [];
  const ranges = levels(ordered, Math.max(most, mostLevels)) ?? quantiles(ordered, most);
  const list = ranges.map((range): Group => ({ ...range, label: label(range, name), rows: [] }));
  values.forEach((value, row) => {
    if (!Number.isFinite(value)) return;
    let low = 0;
    let high = list.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((list[middle] as Group).from <= value) low = middle;
      else high = middle - 1;
    }
    (list[low] as Group).rows.push(row);
  });
  return list;
}

/// Every so many-th of the rows, for drawing; those in `always` too.
export function thinned(rows: number[], most: number, always: Set<number> = new Set()): number[] {
  if (rows.length <= most) return rows;
  const step = rows.length / most;
  const picked = new Set<number>();
  for (let k = 0; k < most; ++k) picked.add(rows[Math.floor(k * step)] as number);
  return rows.filter((row) => picked.has(row) || always.has(row));
}

export function mean(values: number[]): number {
  return values.reduce((sum, v) => sum + v, 0) / values.length;
}

export function rms(values: number[]): number {
  return Math.sqrt(values.reduce((sum, v) => sum + v * v, 0) / values.length);
}
