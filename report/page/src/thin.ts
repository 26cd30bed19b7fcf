// Rows over time, thinned for drawing so that no extreme is lost.

/// Rows by the stretches within which lines are drawn.
export type Stretches = number[][];

/// Rows with a value whose x lies within [from, to]. A stretch ends where `piece` changes, and where
/// the next value is further away than `gap`.
export function stretches(x: ArrayLike<number>, y: ArrayLike<number>, piece: ArrayLike<number>, [from, to]: [number, number], gap = Infinity): Stretches {
  const list: Stretches = [];
  let last = -1;
  for (let k = 0; k < x.length; ++k) {
    const at = x[k] as number;
    if (!(at >= from && at <= to) || !Number.isFinite(y[k])) continue;
    if (last < 0 || piece[k] !== piece[last] || at - (x[last] as number) > gap) list.push([]);
    (list[list.length - 1] as number[]).push(k);
    last = k;
  }
  return list;
}

/// Of every stretch the rows that a line of `steps` points across all of [from, to] needs: in each
/// step the first and the last, and those where one of the columns is lowest and highest.
export function thinnedCourse(list: Stretches, x: ArrayLike<number>, columns: ArrayLike<number>[], [from, to]: [number, number], steps: number): Stretches {
  const total = list.reduce((sum, rows) => sum + rows.length, 0);
  if (total <= 2 * steps) return list;
  const width = (to - from) / steps || 1;
  const stepOf = (row: number) => Math.floor(((x[row] as number) - from) / width);
  return list.map((rows) => {
    const kept: number[] = [];
    for (let begin = 0; begin < rows.length;) {
      const step = stepOf(rows[begin] as number);
      let end = begin + 1;
      while (end < rows.length && stepOf(rows[end] as number) === step) ++end;
      const wanted = new Set([rows[begin] as number, rows[end - 1] as number]);
      for (const column of columns) {
        let low = rows[begin] as number;
        let high = low;
        for (let k = begin; k < end; ++k) {
          const row = rows[k] as number;
          if ((column[row] as number) < (column[low] as number)) low = row;
          if ((column[row] as number) > (column[high] as number)) high = row;
        }
        wanted.add(low).add(high);
      }
      kept.push(...[...wanted].sort((a, b) => a - b));
      begin = end;
    }
    return kept;
  });
}

/// Far more than the usual distance between values.
export function longGap(x: ArrayLike<number>, y: ArrayLike<number>): number {
  const steps: number[] = [];
  let last = NaN;
  for (let k = 0; k < x.length; ++k) {
    if (!Number.isFinite(y[k])) continue;
    if (!Number.isNaN(last)) steps.push((x[k] as number) - last);
    last = x[k] as number;
  }
  steps.sort((a, b) => a - b);
  return steps.length ? 10 * (steps[steps.length >> 1] as number) : Infinity;
}
