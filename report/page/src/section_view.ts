// Half of a spindle, cut along its axis and drawn to scale from its cells, with their temperatures.
import { valueAxis } from './chart';
import type { Option } from './chart';
import type { Section } from './document';
import { choice, Figure, tooltip } from './figure';
import type { Look } from './look';
import { level, viridis } from './look';
import { number, plain } from './text';

const tallest = 560; // of the drawing [px]
const sides = { left: 46, right: 16, top: 30, bottom: 90 };
const leastSpan = 1; // of the colours [K]
const longLabel = 54; // that a bearing's name takes [px]

interface Api {
  coord: (point: number[]) => [number, number];
}

type Shape = Option & { type: string };

/// Axis from the nose to the rear, radius upwards; a millimetre is as long on either.
function frame(section: Section, width: number): { x: [number, number]; top: number; height: number; scale: number } {
  const { start_mm, end_mm, outer_radius_mm } = section.cells;
  const most = (list: number[]) => list.reduce((m, v) => Math.max(m, v), -Infinity);
  const [from, to, top] = [start_mm.reduce((m, v) => Math.min(m, v), Infinity), most(end_mm), 1.1 * most(outer_radius_mm)];
  const inner = width - sides.left - sides.right;
  const margin = 0.02 * (to - from);
  const scale = Math.min(inner / (to - from + 2 * margin), tallest / top); // [px/mm]
  const spare = (inner / scale - (to - from)) / 2;
  return { x: [from - spare, to + spare], top, height: top * scale, scale };
}

/// Faces between parts, and those where no cell is.
function outline({ cells }: Section): number[][] {
  const faces = new Map<string, { points: number[]; part: string; open: boolean }>();
  cells.part.forEach((part, k) => {
    const [a, b, p, q] = [cells.start_mm[k], cells.end_mm[k], cells.inner_radius_mm[k], cells.outer_radius_mm[k]] as [number, number, number, number];
    for (const points of [
      [a, p, a, q],
      [b, p, b, q],
      [a, p, b, p],
      [a, q, b, q],
    ]) {
      const key = points.join();
      const other = faces.get(key);
      if (other) other.open = other.part !== part;
      else faces.set(key, { points, part, open: true });
    }
  });
  return [...faces.values()].filter((f) => f.open && (f.points[1] !== 0 || f.points[3] !== 0)).map((f) => f.points);
}

/// Shapes of one series: all drawn at its only item.
function shapes(name: string, z: number, draw: (api: Api) => Shape[]): Option {
  return { type: 'custom', name, silent: true, z, data: [[0, 0]], renderItem: (_: unknown, api: Api) => ({ type: 'group', children: draw(api) }) };
}

const segment = ([x1, y1]: [number, number], [x2, y2]: [number, number], style: Option): Shape => ({ type: 'line', shape: { x1, y1, x2, y2 }, style });

function box(api: Api, from: [number, number], to: [number, number], style: Option): Shape {
  const [[x1, y1], [x2, y2]] = [api.coord(from), api.coord(to)];
  return { type: 'rect', shape: { x: Math.min(x1, x2), y: Math.min(y1, y2), width: Math.abs(x2 - x1), height: Math.abs(y2 - y1) }, style };
}

/// Rings, and a ball with the line along which it presses or a roller.
function bearing(b: Section['bearings'][number], api: Api, scale: number, l: Look): Shape[] {
  const thin = { fill: 'none', stroke: l.ink, lineWidth: 1.3 };
  const [from, to] = [b.position_mm - b.width_mm / 2, b.position_mm + b.width_mm / 2];
  const centre: [number, number] = [b.position_mm, b.pitch_diameter_mm / 2];
  const [cx, cy] = api.coord(centre);
  const rings = [box(api, [from, b.bore_mm / 2], [to, b.inner_ring_shoulder_mm / 2], thin), box(api, [from, b.outer_ring_shoulder_mm / 2], [to, b.outer_diameter_mm / 2], thin)];
  const rolling = { fill: l.surface, stroke: l.ink, lineWidth: 1.3 };
  if (b.roller_diameter_mm !== undefined && b.roller_length_mm !== undefined) {
    const [half, radius] = [b.roller_length_mm / 2, b.roller_diameter_mm / 2];
    return [...rings, box(api, [centre[0] - half, centre[1] - radius], [centre[0] + half, centre[1] + radius], rolling)];
  }
  const ball = b.ball_diameter_mm ?? 0;
  const angle = ((b.contact_angle_deg ?? 0) * Math.PI) / 180;
  const reach = 0.85 * ball;
  const along = (sign: number): [number, number] => api.coord([centre[0] + sign * (b.pressed_rearwards ? 1 : -1) * reach * Math.sin(angle), centre[1] + sign * reach * Math.cos(angle)]);
  return [...rings, { type: 'circle', shape: { cx, cy, r: (ball / 2) * scale }, style: rolling }, segment(along(-1), along(1), { stroke: l.ink, lineWidth: 1, lineDash: [4, 3] })];
}

/// Turns of the coolant's channel, cut through.
function turns(c: NonNullable<Section['channels']>[number], api: Api): Shape[] {
  const count = Math.max(1, Math.floor((c.end_mm - c.start_mm) / c.pitch_mm));
  const first = (c.start_mm + c.end_mm - count * c.pitch_mm) / 2 + c.pitch_mm / 2;
  return Array.from({ length: count }, (_, k) => {
    const middle = first + k * c.pitch_mm;
    return box(api, [middle - c.width_mm / 2, (c.diameter_mm - c.depth_mm) / 2], [middle + c.width_mm / 2, (c.diameter_mm + c.depth_mm) / 2], { fill: 'none', stroke: '#ffffff', lineWidth: 1.4 });
  });
}

/// Where a flange is bolted on: its length on top of the housing.
function flange({ cells, flange: f }: Section, api: Api, l: Look): Shape[] {
  let top = 0;
  cells.part.forEach((part, k) => {
    if (part === 'housing' && (cells.start_mm[k] as number) <= f.position_mm && (cells.end_mm[k] as number) >= f.position_mm) top = Math.max(top, cells.outer_radius_mm[k] as number);
  });
  if (top === 0) return [];
  const [[x1, y], [x2]] = [api.coord([f.position_mm - f.length_mm / 2, top]), api.coord([f.position_mm + f.length_mm / 2, top])];
  return [segment([x1, y - 2], [x2, y - 2], { stroke: l.ink, lineWidth: 4 })];
}

function cells(section: Section, temperatures: number[], [low, high]: [number, number]): Option {
  const { start_mm, end_mm, inner_radius_mm, outer_radius_mm } = section.cells;
  return {
    type: 'custom',
    name: 'temperature',
    z: 2,
    encode: { x: [0, 1], y: [2, 3] },
    data: temperatures.map((t, k) => [start_mm[k], end_mm[k], inner_radius_mm[k], outer_radius_mm[k], t]),
    renderItem: (item: { dataIndex: number }, api: Api) => {
      const k = item.dataIndex;
      const rect = box(api, [start_mm[k] as number, inner_radius_mm[k] as number], [end_mm[k] as number, outer_radius_mm[k] as number], { fill: level(((temperatures[k] as number) - low) / (high - low)) });
      const shape = rect.shape as { x: number; y: number; width: number; height: number };
      // Cells overlap by a little, or the page would shine through between them.
      return { ...rect, shape: { ...shape, width: shape.width + 0.6, height: shape.height + 0.6 } };
    },
  };
}

/// Numbers beside the dots, those of neighbours on the other side.
function sensors(section: Section, scale: number, l: Look): Option {
  const places = section.sensors;
  const near = (k: number) => places.slice(0, k).some((p) => Math.hypot(p.position_mm - (places[k]?.position_mm ?? 0), p.radius_mm - (places[k]?.radius_mm ?? 0)) * scale < 16);
  return {
    type: 'scatter',
    name: 'sensors',
    z: 8,
    symbolSize: 6,
    itemStyle: { color: l.surface, borderColor: l.ink, borderWidth: 1.4 },
    data: places.map((p, k) => ({
      value: [p.position_mm, p.radius_mm],
      label: { show: true, formatter: String(k + 1), position: near(k) ? 'left' : 'right', distance: 4, fontSize: 11, fontWeight: 600, color: '#10161d', textBorderColor: '#ffffff', textBorderWidth: 2.5 },
    })),
  };
}

/// `labels`: what the moments are called in the choice; `chosen` the first one drawn.
export function sectionFigure(section: Section, what: string, labels: string[], chosen: number): Figure {
  const { moments, cells: mesh } = section;
  const all = moments.flatMap((m) => m.temperature_C);
  const least = all.reduce((m, v) => Math.min(m, v), Infinity);
  const most = Math.max(
    all.reduce((m, v) => Math.max(m, v), -Infinity),
    least + leastSpan,
  );
  const now = () => moments[chosen]?.temperature_C ?? [];
  const hottest = () => now().reduce((best, t, k) => (t > (now()[best] as number) ? k : best), 0);
  const figure: Figure = new Figure({
    id: 'section',
    title: 'Cross-section with temperatures',
    note: () =>
      [
        `${labels[chosen]}: from ${number(
          now().reduce((m, v) => Math.min(m, v), Infinity),
          4,
        )} to ${number(now()[hottest()], 4)} °C, hottest in the ${mesh.part[hottest()]} ${plain(((mesh.start_mm[hottest()] as number) + (mesh.end_mm[hottest()] as number)) / 2, 3)} mm behind the nose face.`,
        `Half of the spindle, cut along its axis, to scale: shaft below, housing above. Thick line on top: flange.${section.channels ? ' White: coolant channel.' : ''} Dashed through the balls: contact lines.`,
        moments.length > 1 ? `Colours are the same for every ${what}.` : '',
        section.sensors.length ? `Sensors: ${section.sensors.map((s, k) => `${k + 1} ${s.name.replace(/_/g, ' ')}`).join(', ')}.` : '',
      ].join(' '),
    wide: true,
    onPaper: 1,
    marks: 1.5 * mesh.part.length,
    ...(moments.length > 1
      ? {
          controls: [
            choice(what === 'speed' ? 'Speed' : 'Moment', labels, chosen, (k) => {
              chosen = k;
              figure.draw();
            }),
          ],
        }
      : {}),
    height: (width) => frame(section, width).height + sides.top + sides.bottom,
    option: (l, width) => {
      const { x, top, height, scale } = frame(section, width);
      const faces = outline(section);
      const [from, to] = [mesh.start_mm.reduce((m, v) => Math.min(m, v), Infinity), mesh.end_mm.reduce((m, v) => Math.max(m, v), -Infinity)];
      const places = section.bearings.map((b) => b.position_mm).sort((a, b) => a - b);
      const apart = Math.min(...places.slice(1).map((at, k) => at - (places[k] ?? 0)), Infinity) * scale;
      const name = (label: string) => (apart > longLabel ? label.replace('_', ' ') : `${label.slice(0, 1).toUpperCase()}${label.replace(/.*_/, '')}`);
      const nothing = { show: false };
      return {
        grid: { left: sides.left, right: sides.right, top: sides.top, height },
        tooltip: tooltip(l, (hit) => {
          const k = hit.dataIndex;
          if (hit.seriesName === 'sensors') {
            const s = section.sensors[k];
            return s ? [s.name.replace(/_/g, ' '), ['behind the nose face', `${plain(s.position_mm, 4)} mm`], ['radius', `${plain(s.radius_mm, 4)} mm`]] : null;
          }
          const middle = (a: number[], b: number[]) => `${plain(((a[k] as number) + (b[k] as number)) / 2, 4)} mm`;
          return [mesh.part[k] ?? '', ['temperature', `${number(now()[k])} °C`], ['behind the nose face', middle(mesh.start_mm, mesh.end_mm)], ['radius', middle(mesh.inner_radius_mm, mesh.outer_radius_mm)]];
        }),
        xAxis: valueAxis('behind the nose face [mm]', l, 'x', { min: x[0], max: x[1], splitLine: nothing, axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, showMinLabel: false, showMaxLabel: false } }),
        yAxis: valueAxis('radius [mm]', l, 'y', { min: 0, max: top, splitLine: nothing, axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, showMaxLabel: false } }),
        visualMap: {
          type: 'continuous',
          min: least,
          max: most,
          dimension: 4,
          seriesIndex: 0,
          hoverLink: false,
          orient: 'horizontal',
          left: 'center',
          bottom: 0,
          itemWidth: 12,
          itemHeight: Math.min(320, width * 0.5),
          text: [`${number(most, 3)} °C`, `${number(least, 3)} °C`],
          textStyle: { color: l.ink, fontSize: 12 },
          inRange: { color: viridis },
        },
        series: [
          cells(section, now(), [least, most]),
          shapes('outline', 4, (api) => faces.map(([a, p, b, q]) => segment(api.coord([a as number, p as number]), api.coord([b as number, q as number]), { stroke: l.ink, lineWidth: 1 }))),
          ...(section.channels ? [shapes('coolant', 5, (api) => section.channels?.flatMap((c) => turns(c, api)) ?? [])] : []),
          shapes('bearings', 6, (api) => section.bearings.flatMap((b) => bearing(b, api, scale, l))),
          shapes('axis', 6, (api) => [segment(api.coord([from - 0.01 * (to - from), 0]), api.coord([to + 0.01 * (to - from), 0]), { stroke: l.muted, lineWidth: 1, lineDash: [12, 3, 2, 3] }), ...flange(section, api, l)]),
          {
            type: 'scatter',
            name: 'names',
            silent: true,
            z: 7,
            symbolSize: 0.1,
            data: section.bearings.map((b) => ({ value: [b.position_mm, top], label: { show: true, position: 'top', distance: 2, formatter: name(b.label), color: l.ink, fontSize: 11 } })),
          },
          ...(section.sensors.length ? [sensors(section, scale, l)] : []),
        ],
      };
    },
    table: () => ({
      columns: ['part', 'behind the nose face [mm]', 'radius [mm]', 'temperature [°C]'],
      rows: now().map((t, k) => [mesh.part[k] ?? '', ((mesh.start_mm[k] as number) + (mesh.end_mm[k] as number)) / 2, ((mesh.inner_radius_mm[k] as number) + (mesh.outer_radius_mm[k] as number)) / 2, t]),
    }),
  });
  return figure;
}
