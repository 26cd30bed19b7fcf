// What the pictures share: axes, legends, bands, bars with a line.
import type { EChartsCoreOption } from 'echarts/core';
import type { Look } from './look';
import { symbols } from './look';
import { plain } from './text';

export type Option = EChartsCoreOption;

const letter = 6.6; // about the width of a character at 12 px
const gap = 12; // between the entries of a legend
export const fonts = 'system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';

const pen = document.createElement('canvas').getContext('2d');

/// Width of a text at 12 px.
function textWidth(text: string): number {
  if (!pen) return text.length * letter;
  pen.font = `12px ${fonts}`;
  return pen.measureText(text).width;
}

/// A legend on top, and the height it takes at this width.
export function legend(names: string[], width: number, l: Look, icons: (string | undefined)[] = []): { option: Option; height: number } {
  const size = l.print ? 10.5 : 12;
  let lines = 1;
  let used = 0;
  for (const name of names) {
    const item = 14 + 5 + (textWidth(name) * size) / 12 + gap;
    if (used > 0 && used + item > width - 10) {
      ++lines;
      used = 0;
    }
    used += item;
  }
  return {
    option: {
      data: names.map((name, k) => (icons[k] ? { name, icon: icons[k] } : { name })),
      left: 0,
      top: 0,
      itemWidth: 14,
      itemHeight: 9,
      itemGap: gap,
      textStyle: { color: l.ink, fontSize: size },
      inactiveColor: l.dark ? '#4a5664' : '#b9c1ca',
      selectedMode: 'multiple',
    },
    height: names.length ? lines * 20 + 4 : 0,
  };
}

/// A bar to the right; hatching tells it from another without its colour.
export function barStyle(color: string | undefined, hatch: 'none' | 'wide' | 'narrow' = 'none'): Option {
  return { color, borderRadius: [0, 3, 3, 0], decal: hatch === 'none' ? undefined : { symbol: 'rect', dashArrayX: [1, 0], dashArrayY: hatch === 'wide' ? [2, 5] : [1, 3], rotation: -0.7, color: 'rgba(255,255,255,0.35)' } };
}

/// A legend of curves, each with its own symbol.
export function symbolLegend(names: string[], width: number, l: Look): { option: Option; height: number } {
  return legend(
    names,
    width,
    l,
    names.map((_, k) => symbols[k % symbols.length]),
  );
}

export function valueAxis(name: string, l: Look, place: 'x' | 'y', more: Option = {}): Option {
  return {
    type: 'value',
    name,
    nameLocation: place === 'x' ? 'middle' : 'end',
    nameGap: place === 'x' ? 26 : 10,
    nameTextStyle: { color: l.muted, fontSize: 12, ...(place === 'y' ? { align: 'left', padding: [0, 0, 0, -44] } : {}) },
    scale: true,
    axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, formatter: (v: number) => plain(v, 6) },
    axisLine: { show: place === 'x', onZero: false, lineStyle: { color: l.muted } },
    axisTick: { show: place === 'x', lineStyle: { color: l.muted } },
    splitLine: { lineStyle: { color: l.rule } },
    splitNumber: 5,
    ...more,
  };
}

export function categoryAxis(names: string[], l: Look, more: Option = {}): Option {
  return { type: 'category', data: names, axisLabel: { color: l.ink, fontSize: 12 }, axisLine: { lineStyle: { color: l.muted } }, axisTick: { show: false }, splitLine: { show: false }, ...more };
}

/// Names down the side of horizontal bars, cut where the page is narrow; the tooltip has them in full.
export function sideAxis(names: string[], l: Look, width: number): { option: Option; left: number } {
  const longest = Math.max(...names.map(textWidth), 30);
  const room = Math.max(90, Math.min(longest + 8, width * 0.42));
  return { option: categoryAxis(names, l, { inverse: true, axisLabel: { color: l.ink, fontSize: 12, width: room, overflow: 'truncate', interval: 0 } }), left: room + 12 };
}

interface CustomApi {
  coord: (point: number[]) => number[];
  value: (dimension: number) => number;
}

/// An area between two lines over x; `points` are [x, low, high] by rising x.
export function band(name: string, points: [number, number, number][], colour: string, edge: string): Option {
  return {
    type: 'custom',
    name,
    silent: true,
    z: 1,
    clip: true,
    itemStyle: { color: colour },
    encode: { x: 0, y: [1, 2] },
    data: points,
    renderItem: (context: { dataIndexInside: number }, api: CustomApi) => {
      if (context.dataIndexInside > 0) return undefined;
      const high = points.map(([x, , top]) => api.coord([x, top]));
      const low = points.map(([x, bottom]) => api.coord([x, bottom])).reverse();
      return {
        type: 'group',
        children: [
          { type: 'polygon', shape: { points: [...high, ...low] }, style: { fill: colour } },
          { type: 'polyline', shape: { points: high }, style: { fill: 'none', stroke: edge, lineWidth: 1, lineDash: [4, 3] } },
          { type: 'polyline', shape: { points: low }, style: { fill: 'none', stroke: edge, lineWidth: 1, lineDash: [4, 3] } },
        ],
      };
    },
  };
}

/// Filled between two lines over x, stretch by stretch; points are [x, low, high] by rising x.
export function areas(name: string, stretches: [number, number, number][][], colour: string): Option {
  const all = stretches.flat();
  return {
    type: 'custom',
    name,
    silent: true,
    z: 2,
    clip: true,
    itemStyle: { color: colour },
    encode: { x: 0, y: [1, 2] },
    // Nothing to fill is nothing to draw.
    data: all.some(([, low, high]) => high > low) ? all : [],
    renderItem: (context: { dataIndexInside: number }, api: CustomApi) => {
      if (context.dataIndexInside > 0) return undefined;
      return {
        type: 'group',
        children: stretches.map((points) => ({
          type: 'polygon',
          shape: { points: [...points.map(([x, , high]) => api.coord([x, high])), ...points.map(([x, low]) => api.coord([x, low])).reverse()] },
          style: { fill: colour, opacity: 0.75 },
        })),
      };
    },
  };
}

/// Vertical error bars; `points` are [x, low, high].
export function errorBars(name: string, points: [number, number, number][], colour: string): Option {
  return {
    type: 'custom',
    name,
    silent: true,
    z: 6,
    clip: true,
    itemStyle: { color: colour },
    encode: { x: 0, y: [1, 2] },
    data: points,
    renderItem: (_: unknown, api: CustomApi) => {
      const x = api.value(0);
      const top = api.coord([x, api.value(2)]) as [number, number];
      const bottom = api.coord([x, api.value(1)]) as [number, number];
      const style = { stroke: colour, lineWidth: 1.6, fill: 'none' };
      const line = (x1: number, y1: number, x2: number, y2: number) => ({ type: 'line', shape: { x1, y1, x2, y2 }, style });
      return { type: 'group', children: [line(top[0], top[1], bottom[0], bottom[1]), line(top[0] - 4, top[1], top[0] + 4, top[1]), line(bottom[0] - 4, bottom[1], bottom[0] + 4, bottom[1])] };
    },
  };
}

/// A line across horizontal bars with its words.
export function threshold(value: number, text: string, l: Look): Option {
  return { silent: true, symbol: 'none', animation: false, label: { formatter: text, color: l.ink, fontSize: 11, position: 'start', distance: 6 }, lineStyle: { color: l.ink, type: 'dashed', width: 1.5 }, data: [{ xAxis: value }] };
}
