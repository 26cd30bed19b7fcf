// A table as its figures see it: its levels, and the ones that the reader chose.
import type { TableReport } from './document';
import { Rows } from './document';
import { choice, type Figure } from './figure';
import { thinned } from './groups';
import { axisTitle, withUnit } from './text';

export const mostCurves = 8; // that stay readable

export function distinct(values: Iterable<number>): number[] {
  return [...new Set(values)].filter(Number.isFinite).sort((a, b) => a - b);
}

/// Rows of one axial load at the chosen radial load and temperature.
export interface Slice {
  axial: number;
  rows: number[];
}

export class TableView {
  readonly rows: Rows;
  readonly axials: number[];
  readonly radials: number[];
  readonly temperatures: number[];
  readonly preload_N: number | undefined;
  readonly chosen: { radial: number; temperature: number; axial: number; logarithmic: boolean };

  /// Figures that a choice redraws.
  readonly figures: Figure[] = [];

  constructor(report: TableReport) {
    this.rows = new Rows(report.rows);
    this.axials = distinct(this.rows.get('axial_load_N'));
    this.radials = distinct(this.rows.get('radial_load_N'));
    this.temperatures = distinct(this.rows.get('temperature_C'));
    this.preload_N = report.preload_N;
    this.chosen = { radial: 0, temperature: 0, axial: this.axials.length - 1, logarithmic: false };
  }

  redraw(): void {
    for (const figure of this.figures) figure.draw();
  }

  get radial(): number {
    return this.radials[this.chosen.radial] as number;
  }
  get temperature(): number | undefined {
    return this.temperatures[this.chosen.temperature];
  }

  slices(): Slice[] {
    const byLoad = new Map<number, number[]>(this.axials.map((a) => [a, []]));
    const radial = this.rows.get('radial_load_N');
    const temperature = this.rows.get('temperature_C');
    const axial = this.rows.get('axial_load_N');
    for (let k = 0; k < this.rows.count; ++k) if (radial[k] === this.radial && temperature[k] === this.temperature) byLoad.get(axial[k] as number)?.push(k);
    return [...byLoad].map(([a, list]) => ({ axial: a, rows: list }));
  }
  /// The slices that are drawn.
  shown(): Slice[] {
    const list = this.slices();
    return thinned(
      list.map((_, k) => k),
      mostCurves,
    ).map((k) => list[k] as Slice);
  }
  place(): string {
    return `radial load ${withUnit(this.radial, 'radial_load_N')}, ${withUnit(this.temperature as number, 'temperature_C')}`;
  }

  /// The table of a figure: the state and these columns.
  columns(names: string[]): () => { columns: string[]; rows: (number | null)[][] } {
    const all = ['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C', ...names];
    return () => ({ columns: all.map(axisTitle), rows: Array.from({ length: this.rows.count }, (_, k) => all.map((name) => (Number.isFinite(this.rows.at(name, k)) ? this.rows.at(name, k) : null))) });
  }

  /// Choices of radial load and temperature, where there are several.
  controls(): HTMLElement[] {
    const of = (label: string, name: string, values: number[], choose: (k: number) => void) =>
      values.length > 1
        ? [
            choice(
              label,
              values.map((v) => withUnit(v, name)),
              0,
              (k) => (choose(k), this.redraw()),
            ),
          ]
        : [];
    return [...of('Radial load', 'radial_load_N', this.radials, (k) => (this.chosen.radial = k)), ...of('Temperature', 'temperature_C', this.temperatures, (k) => (this.chosen.temperature = k))];
  }
}
