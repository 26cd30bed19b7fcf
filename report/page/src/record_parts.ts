// What the pages of records over time share: the ladder, the section over time, how long the record is.
import { barStyle, legend, sideAxis, threshold, valueAxis } from './chart';
import type { Size } from './document';
import { Figure, tooltip } from './figure';
import { contributions, overTime, residualOverTime } from './over_time';
import { grid, section } from './page';
import type { RecordView } from './record_view';
import { dash, el, number, plainCeiling, unitText } from './text';

/// An error of the ladder; what is not known is null.
export interface Rung {
  name: string;
  rms: number | null;
  held: number | null;
  note?: string;
}

export interface Limits {
  tolerance: number | null;
  noise: number | null;
}

type Fields = Record<string, unknown>;

export function field(of: object, name: string): number | null {
  const value = (of as Fields)[name];
  return typeof value === 'number' ? value : null;
}

export function inUnit(value: number | null | undefined, unit: string): string {
  return value === null || value === undefined ? dash : `${number(value, 3)} ${unit}`;
}
/// "um" of displacement_z_um.
export function unitKey(displacement: string): string {
  return displacement.slice(displacement.lastIndexOf('_') + 1);
}

/// Errors of models or effects, against what is tolerated and what the sensor scatters.
export function ladder(rungs: Rung[], { tolerance, noise }: Limits, unit: string, note?: string, id = 'ladder'): Figure {
  const um = (value: number | null | undefined) => inUnit(value, unit);
  const held = rungs.some((r) => r.held !== null);
  const names = ['on all readings', ...(held ? ['on held-out parts'] : [])];
  const values = [rungs.map((r) => r.rms), ...(held ? [rungs.map((r) => r.held)] : [])];
  const most = Math.max(...values.flat().map((v) => v ?? 0));
  const lines = [...(tolerance === null ? [] : [`the tolerance, ${um(tolerance)}`]), ...(noise === null ? [] : [`the noise of the sensor, ${um(noise)}`])];
  return new Figure({
    id,
    title: rungs.length > 1 ? 'RMS errors' : 'RMS error',
    note: note ?? (lines.length ? `Dashed: ${lines.join('; ')}.` : 'No tolerance was given, and the noise is not known.'),
    wide: true,
    height: 92 + Math.min(rungs.length * (held ? 44 : 34), 1300), // with its table on a sheet of paper
    onPaper: 0.62,
    option: (l, width) => {
      const top = legend(held ? names : [], width, l);
      const side = sideAxis(
        rungs.map((r) => r.name),
        l,
        width,
      );
      // Two words beside each other would not be read.
      const apart = ((width - side.left - 56) * Math.abs((tolerance ?? 0) - (noise ?? 0))) / Math.max(most, tolerance ?? 0, noise ?? 0);
      const marks = [...(tolerance === null ? [] : [{ xAxis: tolerance, label: { formatter: 'tolerance' } }]), ...(noise === null ? [] : [{ xAxis: noise, label: { formatter: tolerance !== null && apart < 70 ? '' : 'noise' } }])];
      return {
        ...(held ? { legend: top.option } : {}),
        grid: { left: side.left, right: 56, top: top.height + 24, bottom: 42 },
        tooltip: tooltip(l, (hit) => {
          const r = rungs[hit.dataIndex];
          return r ? [r.name, ['on all readings', um(r.rms)], ...(held ? ([['on held-out parts', um(r.held)]] as [string, string][]) : []), ...(r.note ? [r.note] : [])] : null;
        }),
        xAxis: valueAxis(`RMS error [${unit}]`, l, 'x', { scale: false, min: 0, ...(most < Math.max(tolerance ?? 0, noise ?? 0) ? { max: plainCeiling(Math.max(tolerance ?? 0, noise ?? 0)) } : {}) }),
        yAxis: side.option,
        series: names.map((name, k) => ({
          type: 'bar',
          name,
          barMaxWidth: held ? 14 : 20,
          itemStyle: barStyle(l.kinds[k], k === 1 ? 'wide' : 'none'),
          label: { show: true, position: 'right', color: l.ink, fontSize: 11, textBorderColor: l.surface, textBorderWidth: 3, formatter: (hit: { value: number | null }) => (hit.value === null ? '' : number(hit.value, 3)) },
          data: values[k],
          ...(k === 0 && marks.length ? { markLine: { ...threshold(0, '', l), data: marks } } : {}),
        })),
      };
    },
    table: () => ({
      columns: ['', `RMS [${unit}]`, ...(held ? [`RMS on held-out parts [${unit}]`] : []), 'RMS / tolerance', 'parameters'],
      rows: rungs.map((r) => [r.name, r.rms, ...(held ? [r.held] : []), tolerance === null ? null : ((r.held ?? r.rms) as number) / tolerance, r.note ?? '']),
    }),
  });
}

export function sizes(parameters: Record<string, Size>): string {
  return Object.entries(parameters)
    .map(([name, p]) => `${name} = ${number(p.value, 3)}${p.std === null ? '' : ` ± ${number(p.std, 2)}`}${unitText(p.unit) ? ` ${unitText(p.unit)}` : ''}${p.at_bound ? ' (at its bound)' : ''}`)
    .join(', ');
}

/// What the page has of more rows than it holds, and how it draws them.
function thinned(view: RecordView): HTMLElement | undefined {
  const { rows, total } = view.report.rows;
  if (total <= 2000) return undefined;
  return el(
    'p',
    { class: 'note', id: 'thinned' },
    `${rows < total ? `This page contains ${rows} of ${total} rows: evenly spread rows, and the rows with the lowest and highest value of every column in each interval. ` : ''}In each time step of about one pixel, lines show the first, the lowest, the highest and the last row, so the picture shows every extreme. Tables and CSV have every row of the page.`,
  );
}

export function overTimeSection(view: RecordView): HTMLElement {
  const parts = view.report.models.some((m) => m.parts);
  return section('Over time', view.choices(view.report.command === 'correct' ? 'Displacement' : 'Model'), thinned(view), grid(overTime(view), parts ? contributions(view) : undefined, residualOverTime(view)));
}

export function lengthOf(view: RecordView): [string, string] {
  const hours = (view.hours[view.rows.count - 1] ?? 0) - (view.hours[0] ?? 0);
  return ['length', `${number(hours, 3)} h${view.report.runs.length > 1 ? `, ${view.report.runs.length} runs` : ''}`];
}
