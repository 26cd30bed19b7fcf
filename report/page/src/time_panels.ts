// What pictures over time share: their axis, lines and stacked areas, panels below each other, tables.
import { legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { Table } from './figure';
import { Figure, tooltip } from './figure';
import type { Look } from './look';
import { dashes, look } from './look';
import { number } from './text';
import { stretches, thinnedCourse } from './thin';
import type { TimeView } from './time_view';

export const left = 56;
export const right = 18;
export const paper = 0.68; // of the height of a panel

/// What is added to a sum, by rows.
export interface Share {
  name: string;
  values: Float64Array;
}

/// Rows of the span; with their lines where a file was read.
export function table(view: TimeView, columns: [string, ArrayLike<number>][]): Table {
  const known = (v: number | undefined) => (v === undefined || !Number.isFinite(v) ? null : v);
  const line = view.rows.has('line');
  return {
    columns: [...(line ? ['line'] : []), 'time [s]', ...columns.map(([name]) => name)],
    rows: Array.from({ length: view.rows.count }, (_, k) => k)
      .filter((k) => (view.hours[k] as number) >= view.span[0] && (view.hours[k] as number) <= view.span[1])
      .map((k) => [...(line ? [view.rows.at('line', k)] : []), known(view.rows.at('time_s', k)), ...columns.map(([, values]) => known(values[k]))]),
  };
}

/// The tooltip of the row under the pointer, wherever in the picture that is.
export function rowTooltip(view: TimeView, l: Look, lines: (row: number) => (string | [string, string])[]): Option {
  const base = tooltip(l, (hit) => {
    const first = (Array.isArray(hit) ? hit[0] : hit) as { axisValue?: number | string } | undefined;
    return first?.axisValue === undefined ? null : lines(view.nearest(Number(first.axisValue)));
  });
  return { ...base, trigger: 'axis', axisPointer: { type: 'line', animation: false, lineStyle: { color: l.muted } } };
}

export function timeAxis(view: TimeView, l: Look, more: Option = {}): Option {
  return valueAxis(`${view.axisName} [${view.axisUnit}]`, l, 'x', {
    scale: true,
    min: view.span[0],
    max: view.span[1],
    splitLine: { show: false },
    ...more,
    axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, showMinLabel: view.span[0] === 0, showMaxLabel: false, ...(more.axisLabel as object) },
  });
}

/// The rows at which a held value changes, and the ends: a step between near points would be drawn askew.
function turns(rows: number[], values: Float64Array): number[] {
  return rows.filter((row, k) => k === 0 || k === rows.length - 1 || values[row] !== values[rows[k - 1] as number]);
}

/// A line with its single points, which no line would show.
export function lines(view: TimeView, name: string, values: Float64Array, width: number, colour: string, more: Option = {}, readings = false): Option[] {
  const list = view.course(values, width, readings).map((rows) => (more.step ? turns(rows, values) : rows));
  const single = list.filter((rows) => rows.length === 1).map((rows) => rows[0] as number);
  const { xAxisIndex = 0, yAxisIndex = 0 } = more;
  return [
    { type: 'line', name, symbol: 'none', silent: true, itemStyle: { color: colour }, lineStyle: { color: colour, width: 1.8 }, data: view.line(values, list), ...more },
    ...(single.length ? [{ type: 'scatter', name, silent: true, symbolSize: 4, itemStyle: { color: colour }, xAxisIndex, yAxisIndex, z: 5, data: single.map((k) => [view.hours[k], values[k]]) }] : []),
  ];
}

/// Where the panels of a picture stand, one below the other.
export interface Place {
  legend: Option;
  top: number;
  height: number;
}

export function places(all: { names: string[]; icons?: (string | undefined)[]; height: number }[], width: number, l: Look): { list: Place[]; height: number } {
  let at = 0;
  const list = all.map(({ names, icons, height }) => {
    const own = legend(names, width, l, icons);
    const place = { legend: { ...own.option, top: at }, top: at + own.height + 24, height };
    at = place.top + height + 14;
    return place;
  });
  return { list, height: at + 28 };
}

/// Axes of panels below each other, all on one time.
export function frame(view: TimeView, l: Look, list: Place[]): Option {
  const lowest = list.length - 1;
  return {
    legend: list.map((p) => p.legend),
    grid: list.map((p) => ({ left, right, top: p.top, height: p.height })),
    axisPointer: { link: [{ xAxisIndex: 'all' }] },
    xAxis: list.map((_, k) => timeAxis(view, l, { gridIndex: k, ...(k < lowest ? { name: '', axisLabel: { show: false } } : {}) })),
  };
}

/// Lines of one unit, below others on the same time.
export interface Panel {
  title: string; // of its axis
  unit: string;
  lines: { label: string; column: string; kind: number; dash?: number }[];
  height: number;
  stepped?: boolean;
  onOff?: boolean;
  more?: (l: Look) => Option[]; // further series
}

/// A picture of panels; the tooltip has all of them.
export function panelFigure(view: TimeView, spec: { id: string; title: string; note?: string }, panels: Panel[]): Figure {
  const layout = (l: Look, width: number) =>
    places(
      panels.map((p) => ({ names: p.lines.length > 1 ? p.lines.map((line) => line.label) : [], height: p.height * (l.print ? paper : 1) })),
      width,
      l,
    );
  const columns = panels.flatMap((p) => p.lines.map((line): [string, Float64Array] => [`${p.title.replace(/ \[.*/, '')}${p.lines.length > 1 ? `, ${line.label}` : ''}${p.unit ? ` [${p.unit}]` : ''}`, view.rows.get(line.column)]));
  return new Figure({
    ...spec,
    wide: true,
    marks: 1e4,
    onPaper: 1,
    height: (width) => layout(look(), width).height,
    option: (l, width) => {
      const { list } = layout(l, width);
      const inner = width - left - right;
      return {
        ...frame(view, l, list),
        tooltip: rowTooltip(view, l, (row) => [
          `${number(view.hours[row], 4)} ${view.axisUnit}`,
          ...panels.flatMap((p) => p.lines.map((line): [string, string] => [p.lines.length > 1 ? line.label : p.title.replace(/ \[.*/, ''), `${number(view.rows.at(line.column, row))} ${p.unit}`])),
        ]),
        yAxis: panels.map((p, k) => valueAxis(p.title, l, 'y', { gridIndex: k, splitNumber: p.height < 60 ? 1 : p.height < 110 ? 3 : 5, ...(p.onOff ? { min: 0, max: 1, interval: 1 } : {}) })),
        series: panels.flatMap((p, k) => [
          ...p.lines.flatMap((line) => {
            const colour = l.kinds[line.kind % l.kinds.length] as string;
            return lines(view, line.label, view.rows.get(line.column), inner, colour, {
              xAxisIndex: k,
              yAxisIndex: k,
              ...(p.stepped ? { step: 'end' } : {}),
              lineStyle: { color: colour, width: 1.6, type: dashes[(line.dash ?? 0) % dashes.length] },
            });
          }),
          ...(p.more?.(l) ?? []).map((one) => ({ ...one, xAxisIndex: k, yAxisIndex: k })),
        ]),
      };
    },
    table: () => table(view, columns),
  });
}

/// Shares above zero stand on each other, those below hang from each other.
export function stacked(view: TimeView, shares: Share[], total: Float64Array, width: number): { name: string; up: [number, number, number][][]; down: [number, number, number][][] }[] {
  const list = thinnedCourse(stretches(view.hours, total, view.piece, view.span), view.hours, [total, ...shares.map((s) => s.values)], view.span, Math.max(100, Math.round(width / 3)));
  const result = shares.map(({ name }) => ({ name, up: list.map((): [number, number, number][] => []), down: list.map((): [number, number, number][] => []) }));
  list.forEach((rows, p) => {
    for (const k of rows) {
      let above = 0;
      let under = 0;
      const x = view.hours[k] as number;
      shares.forEach(({ values }, s) => {
        const v = values[k] as number;
        const of = result[s] as (typeof result)[number];
        (of.up[p] as [number, number, number][]).push([x, above, (above += Math.max(v, 0))]);
        (of.down[p] as [number, number, number][]).push([x, (under += Math.min(v, 0)), under - Math.min(v, 0)]);
      });
    }
  });
  return result;
}
