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

/// Rows with a finite value, in its order.
function sorted(values: Float64Array): number[] {
  const rows: number[] = [];
  for (let i = 0; i < values.length; ++i) if (Number.isFinite(values[i])) rows.push(i);
  return rows.sort((a, b) => (values[a] as number) - (values[b] as number) || a - b);
}

function make(rows: number[], values: Float64Array, name: string): Group {
  const from = values[rows[0] as number] as number;
  const to = values[rows[rows.length - 1] as number] as number;
  const { unit } = quantity(name);
  const low = plain(from, 3);
  const high = plain(to, 3);
  const range = low === high ? low : `${low}…${high}`;
  return { label: unit === '°' ? `${range}°` : `${range} ${unit}`.trim(), rows, from, to };
}

/// At most `most` groups, by rising value.
export function groups(values: Float64Array, name: string, most: number): Group[] {
  const rows = sorted(values);
  if (rows.length === 0) return [];
  const at = (k: number) => values[rows[k] as number] as number;
  const range = at(rows.length - 1) - at(0);
  if (!(range > 0)) return [make(rows, values, name)];
  const levels: number[][] = [];
  rows.forEach((row, k) => {
    if (k === 0 || at(k) - at(k - 1) > 0.04 * range) levels.push([]);
    (levels[levels.length - 1] as number[]).push(row);
  });
  const narrow = levels.every((level) => {
    const first = values[level[0] as number] as number;
    const last = values[level[level.length - 1] as number] as number;
    return last - first <= 0.12 * range;
  });
  if (narrow && levels.length >= 2 && levels.length <= Math.max(most, mostLevels))
    return levels.map((level) => make(level, values, name));
  // Equal values stay together.
  const parts: number[][] = [[]];
  rows.forEach((row, k) => {
    if (k >= (parts.length * rows.length) / most && at(k) > at(k - 1)) parts.push([]);
    (parts[parts.length - 1] as number[]).push(row);
  });
  return parts.filter((part) => part.length > 0).map((part) => make(part, values, name));
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
