// One value of every ball around a bearing, as lines in polar coordinates.
import { symbolLegend } from './chart';
import type { Option } from './chart';
import { tooltip } from './figure';
import type { Look } from './look';
import { dashes, symbols } from './look';
import { plain, quantity, withUnit } from './text';

export interface Ring {
  name: string;
  azimuth: number[]; // [°]
  values: (number | null)[];
}

/// `column`: what the values are, with its unit.
export function aroundOption(rings: Ring[], column: string, colours: string[], l: Look, width: number): Option {
  const top = symbolLegend(
    rings.map((r) => r.name),
    width,
    l,
  );
  return {
    legend: top.option,
    tooltip: tooltip(l, (hit) => {
      const [value, azimuth] = hit.value as [number, number];
      return [hit.seriesName, ['azimuth', `${plain(azimuth, 4)}°`], [quantity(column).label, withUnit(value, column)]];
    }),
    polar: { center: ['50%', top.height / 2 + 215], radius: Math.min(150, width / 2 - 44) },
    angleAxis: {
      type: 'value',
      min: 0,
      max: 360,
      interval: 30,
      startAngle: 0,
      clockwise: false,
      axisLabel: { color: l.muted, fontSize: 11, formatter: (v: number) => (v === 360 ? '' : `${v}°`) },
      axisLine: { lineStyle: { color: l.muted } },
      splitLine: { lineStyle: { color: l.rule } },
    },
    radiusAxis: {
      type: 'value',
      min: column.includes('angle') ? undefined : 0,
      splitNumber: 3,
      axisLabel: { color: l.ink, fontSize: 10, hideOverlap: true, backgroundColor: l.surface, formatter: (v: number) => plain(v, 5) },
      axisLine: { lineStyle: { color: l.muted } },
      splitLine: { lineStyle: { color: l.rule } },
    },
    series: rings.map(({ name, azimuth, values }, k) => {
      const points = azimuth.map((at, ball) => [values[ball], at]);
      const first = points[0] as [number, number];
      return {
        type: 'line',
        name,
        coordinateSystem: 'polar',
        symbol: symbols[k % symbols.length],
        symbolSize: 6,
        color: colours[k % colours.length],
        lineStyle: { width: 1.8, type: dashes[k % dashes.length] },
        data: [...points, [first[0], first[1] + 360]],
      };
    }),
  };
}
