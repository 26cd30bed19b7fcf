// Curves of one column against speed, a curve for each axial load, and measured points among them.
import { legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { Rows } from './document';
import { Figure, tooltip } from './figure';
import { thinned } from './groups';
import type { Look } from './look';
import { dashes, ordered, symbols } from './look';
import type { Slice, TableView } from './table_view';
import { axisTitle, number, plain, quantity, withUnit } from './text';

const mostPoints = 3000; // measured ones that are drawn
const otherLoads = 'other loads';

/// Largest distance of a reading from its curve: share of a load, difference of temperature [K].
const [nearLoad, nearTemperature] = [0.1, 5];

/// A measured point among the curves: the curve whose load it has, if any, and how much warmer it is.
interface Placed {
  row: number;
  curve: number; // -1: of other loads
  warmer: number; // [K], 0 where not known
}

/// A column that is drawn against speed, and its readings.
interface CurvesOf {
  id: string;
  title: string;
  column: string;
  points: Rows | undefined;
  reading: string; // column of the points
  note: string;
  choices: HTMLElement[];
}

/// Assigns each measured point to a curve. A value that was not recorded counts as equal to the value of the curve.
function placed(view: TableView, points: Rows, curves: Slice[]): Placed[] {
  const off = (name: string, value: number | undefined, k: number, width: number) => value !== undefined && points.has(name) && !(Math.abs(points.at(name, k) - value) <= width);
  const radial = view.radial;
  return Array.from({ length: points.count }, (_, row) => {
    const others = off('radial_load_N', radial, row, nearLoad * radial + 1) || off('preload_N', view.preload_N, row, nearLoad * (view.preload_N ?? 0));
    const curve = others ? -1 : curves.findIndex((c) => !off('axial_load_N', c.axial, row, nearLoad * Math.abs(c.axial) + 1));
    const temperature = view.temperature;
    const warmer = points.has('temperature_C') && temperature !== undefined ? points.at('temperature_C', row) - temperature : 0;
    return { row, curve, warmer: Number.isFinite(warmer) ? warmer : 0 };
  });
}

function pointsNote(view: TableView, points: Rows | undefined): string {
  if (!points) return '';
  const list = placed(view, points, view.shown());
  const [at, colder, hotter, other] = [
    list.filter((p) => p.curve >= 0 && Math.abs(p.warmer) <= nearTemperature).length,
    list.filter((p) => p.curve >= 0 && p.warmer < -nearTemperature).length,
    list.filter((p) => p.curve >= 0 && p.warmer > nearTemperature).length,
    list.filter((p) => p.curve < 0).length,
  ];
  const drawn = points.count > mostPoints ? `The picture shows ${mostPoints} of ${points.count} measured points, evenly spread. Of all points,` : `Of ${points.count} measured points,`;
  const total = points.count < points.total ? ` The page contains ${points.count} of ${points.total}.` : '';
  return `${drawn} ${at} lie within 10 % of the loads and 5 K of the temperature of a curve and have its colour; ${colder} are colder (blue) and ${hotter} warmer (orange), with a stronger colour for a larger difference; ${other} are at other loads (grey).${total}`;
}

/// The computed curves.
function curveSeries({ rows, chosen }: TableView, column: string, curves: Slice[], names: string[], colours: string[]): Option[] {
  return curves.map((c, k) => ({
    type: 'line',
    name: names[k],
    symbol: 'circle',
    symbolSize: 4,
    lineStyle: { color: colours[k], width: 2.2, type: dashes[k % dashes.length] },
    itemStyle: { color: colours[k] },
    data: c.rows.filter((row) => !chosen.logarithmic || rows.at('speed_rpm', row) > 0).map((row) => [rows.at('speed_rpm', row), rows.at(column, row), row]),
  }));
}

/// Measured points: in the colour of their curve, blue and orange where they are colder or warmer, grey at other loads.
function pointSeries(view: TableView, points: Rows, reading: string, curves: Slice[], names: string[], colours: string[], l: Look): Option[] {
  const list = placed(view, points, curves);
  const far = Math.max(nearTemperature + 1, ...list.map((p) => Math.abs(p.warmer)));
  const fill = ({ curve, warmer }: Placed): [string, number] => {
    if (curve < 0) return [l.muted, 0.35];
    if (Math.abs(warmer) <= nearTemperature) return [colours[curve] as string, 1];
    return [warmer < 0 ? l.negative : l.positive, 0.25 + (0.65 * Math.abs(warmer)) / far];
  };
  const readings: { name: string; data: Option[] }[] = [];
  for (const row of thinned(
    list.map((p) => p.row),
    mostPoints,
  )) {
    const p = list[row] as Placed;
    const [colour, opacity] = fill(p);
    const name = p.curve < 0 ? otherLoads : (names[p.curve] as string);
    (readings[p.curve + 1] ??= { name, data: [] }).data.push({ value: [points.at('speed_rpm', p.row), points.at(reading, p.row), p.row, 'measured'], itemStyle: { color: colour, opacity } });
  }
  const many = points.count > 800;
  const series: Option[] = [];
  // forEach skips curves without points.
  readings.forEach((r, k) =>
    series.push({
      type: 'scatter',
      name: r.name,
      symbol: k === 0 ? 'circle' : symbols[(k - 1) % symbols.length],
      symbolSize: many ? 5 : 8,
      z: k === 0 ? 1 : 6,
      itemStyle: { color: k === 0 ? l.muted : (colours[k - 1] as string), borderColor: l.ink, borderWidth: k === 0 || many ? 0 : 1 },
      data: r.data,
    }),
  );
  return series;
}

export function curvesFigure(view: TableView, { id, title, column, points, reading, note, choices }: CurvesOf): Figure {
  const { rows, chosen } = view;
  return new Figure({
    id,
    title,
    note: () => `${note} ${pointsNote(view, points)}`.trim(),
    wide: true,
    height: 420,
    marks: rows.count / 4,
    controls: choices,
    option: (l, width) => {
      const curves = view.shown();
      const names = curves.map((c) => `${plain(c.axial)} N`);
      const colours = ordered(curves.length, l);
      const { label, unit } = quantity(column);
      const measured = points ? pointSeries(view, points, reading, curves, names, colours, l) : [];
      const entries = [...names, ...(measured.some((s) => s.name === otherLoads) ? [otherLoads] : [])];
      const top = legend(
        entries,
        width,
        l,
        entries.map((_, k) => (k < names.length ? symbols[k % symbols.length] : 'circle')),
      );
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const value = hit.value as (number | string)[];
          const source = value[3] === 'measured' && points ? points : rows;
          const k = value[2] as number;
          return [
            source === rows ? 'computed' : `measured, line ${plain(source.at('line', k))}`,
            ...['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C', 'preload_N'].filter((name) => source.has(name)).map((name): [string, string] => [quantity(name).label, withUnit(source.at(name, k), name)]),
            [label, `${number(value[1] as number)} ${unit}`],
          ];
        }),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x', chosen.logarithmic ? { type: 'log' } : {}),
        yAxis: valueAxis(`${axisTitle(column)}, ${view.place()}`, l, 'y', { scale: false }),
        series: [...curveSeries(view, column, curves, names, colours), ...measured],
      };
    },
    table: view.columns([column]),
    csv: view.columns(rows.names.slice(4)),
  });
}
