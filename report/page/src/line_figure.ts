// Lines against speed, or against another column: the one figure of what was computed for a list of points.
import { legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { Rows } from './document';
import { Figure, tooltip } from './figure';
import { thinned } from './groups';
import type { Look } from './look';
import { dashes, symbols } from './look';
import { axisTitle, number, plain, quantity } from './text';

export const drawnSpeeds = 500; // that each line is drawn from
const mostSymbols = 12; // of a line

/// A line against speed, or against another column: a column of the rows under a name of the legend.
export interface Line {
  name: string;
  column: string;
  kind: number; // colour and symbol
  dash?: number;
  told?: string; // beside the name in the tooltip
}

export interface LineFigure {
  x?: string; // column of the horizontal axis; the speed
  id: string;
  title: string;
  axis: string;
  lines: Line[];
  note?: string;
  wide?: boolean;
  height?: number;
  fromZero?: boolean;
  table?: string[];
  csv?: string[];
  more?: (l: Look) => Option[]; // further series, under names of `lines` or of their own
  moreNames?: string[];
}

export function lineFigure(rows: Rows, f: LineFigure): Figure {
  const { x = 'speed_rpm' } = f;
  const along = quantity(x);
  const points = Array.from({ length: rows.count }, (_, k) => k);
  const drawn = thinned(points, drawnSpeeds);
  const step = Math.ceil(drawn.length / mostSymbols);
  const columns = (names: string[]) => () => ({ columns: [x, ...names].map(axisTitle), rows: points.map((k) => [x, ...names].map((name) => (Number.isFinite(rows.at(name, k)) ? rows.at(name, k) : null))) });
  const names = [...new Set(f.lines.map((line) => line.name))];
  return new Figure({
    id: f.id,
    title: f.title,
    ...(f.note ? { note: f.note } : {}),
    ...(f.wide ? { wide: true } : {}),
    ...(f.height ? { height: f.height } : {}),
    option: (l, width) => {
      const kindOf = (name: string) => f.lines.find((line) => line.name === name)?.kind ?? 0;
      const top = legend(
        [...names, ...(f.moreNames ?? [])],
        width,
        l,
        names.map((name) => symbols[kindOf(name) % symbols.length]),
      );
      return {
        legend: top.option,
        grid: { left: 64, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const [at, value] = hit.value as [number, number];
          const line = f.lines[hit.seriesIndex];
          return [line?.told ? `${hit.seriesName}, ${line.told}` : hit.seriesName, [along.label, `${plain(at)} ${along.unit}`.trim()], [quantity(f.axis).label, `${number(value, 5)} ${quantity(f.axis).unit}`.replace(' °', '°')]];
        }),
        xAxis: valueAxis(axisTitle(x), l, 'x'),
        yAxis: valueAxis(axisTitle(f.axis), l, 'y', { scale: !f.fromZero }),
        series: [
          ...f.lines.map((line) => ({
            type: 'line',
            name: line.name,
            symbol: symbols[line.kind % symbols.length],
            symbolSize: 7,
            showAllSymbol: true,
            color: l.kinds[line.kind % l.kinds.length],
            lineStyle: { width: 2, type: dashes[(line.dash ?? 0) % dashes.length] },
            connectNulls: false,
            // A few symbols, between which dashes can be seen; the others answer the pointer.
            data: drawn.map((k, n) => ({ value: [rows.at(x, k), Number.isFinite(rows.at(line.column, k)) ? rows.at(line.column, k) : null], ...(n % step ? { itemStyle: { opacity: 0 } } : {}) })),
          })),
          ...(f.more?.(l) ?? []),
        ],
      };
    },
    table: columns(f.table ?? f.lines.map((line) => line.column)),
    ...(f.csv ? { csv: columns(f.csv) } : {}),
  });
}
