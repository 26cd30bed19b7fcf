// Rows of numbers over time, as pictures draw them.
import type { ColumnData } from './document';
import { Rows } from './document';
import { longGap, stretches, thinnedCourse } from './thin';
import type { Stretches } from './thin';

/// Has the columns `hours`, `time_s` and, where there are gaps, `piece`.
export class TimeView {
  readonly rows: Rows;
  readonly hours: Float64Array; // or in the unit of the axis, where that is another
  axisUnit = 'h';
  private perSecond = 1 / 3600;
  readonly piece: Float64Array;
  span: [number, number];

  constructor(data: ColumnData) {
    this.rows = new Rows(data);
    this.hours = this.rows.get('hours');
    this.piece = this.rows.has('piece') ? this.rows.get('piece') : new Float64Array(this.rows.count);
    this.span = [this.hours[0] ?? 0, this.hours[this.rows.count - 1] ?? 1];
  }

  /// Takes minutes or seconds for what lasts no longer.
  takeOwnUnit(): void {
    const length = this.span[1] - this.span[0];
    const [unit, perHour] = length > 0.5 ? ['h', 1] : length > 1 / 60 ? ['min', 60] : ['s', 3600];
    this.axisUnit = unit as string;
    this.perSecond = (perHour as number) / 3600;
    this.hours.forEach((v, k) => (this.hours[k] = v * (perHour as number)));
    this.span = [this.span[0] * (perHour as number), this.span[1] * (perHour as number)];
  }
  /// A time in the unit of the axis.
  at(seconds: number): number {
    return seconds * this.perSecond;
  }

  get axisName(): string {
    return 'time';
  }

  /// A column in stretches without a gap, thinned for a picture of this width. `readings`: read now
  /// and then, with gaps of their own.
  course(values: Float64Array, width: number, readings = false): Stretches {
    const list = stretches(this.hours, values, this.piece, this.span, readings ? longGap(this.hours, values) : Infinity);
    return thinnedCourse(list, this.hours, [values], this.span, Math.max(100, Math.round(width)));
  }

  /// Points of a line; an empty one between stretches.
  line(values: Float64Array, list: Stretches): [number, number | null][] {
    return list.flatMap((rows): [number, number | null][] => {
      const last = rows[rows.length - 1] as number;
      return [...rows.map((k): [number, number] => [this.hours[k] as number, values[k] as number]), [this.hours[last] as number, null]];
    });
  }

  /// The row nearest to a time.
  nearest(hours: number): number {
    let low = 0;
    let high = this.rows.count - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if ((this.hours[middle] as number) <= hours) low = middle;
      else high = middle;
    }
    return hours - (this.hours[low] as number) <= (this.hours[high] as number) - hours ? low : high;
  }
}
