// The pieces of a shaft with its bearings, drawn behind lines along its axis.
import type { Option } from './chart';
import type { ShaftPieces } from './document';
import type { Look } from './look';

interface Api {
  coord: (point: number[]) => [number, number];
}

/// Half of the height that is drawn for the thickest piece [px].
const half = 34;

/// Lies on the line y = 0 of a grid, thickness in pixels; `place` says which grid.
export function shaftSeries({ pieces, bearings, disks }: ShaftPieces, l: Look, place: { xAxisIndex?: number; yAxisIndex?: number } = {}, tall = half): Option {
  const thickest = Math.max(...pieces.map((p) => p.diameter_mm), ...bearings.map((b) => b.pitch_diameter_mm + b.ball_diameter_mm));
  const scale = tall / (thickest / 2);
  return {
    type: 'custom',
    name: 'shaft',
    silent: true,
    z: 1,
    ...place,
    clip: true,
    data: [[0, 0]],
    renderItem: (_: unknown, api: Api) => {
      const at = (mm: number) => api.coord([mm, 0])[0];
      const [, y0] = api.coord([0, 0]);
      const body = { fill: l.band, stroke: l.muted, lineWidth: 0.8, opacity: 0.75 };
      const perMm = Math.abs(at(1) - at(0));
      return {
        type: 'group',
        children: [
          ...pieces.map((p) => ({ type: 'rect', shape: { x: at(p.start_mm), width: at(p.end_mm) - at(p.start_mm), y: y0 - (p.diameter_mm / 2) * scale, height: p.diameter_mm * scale }, style: body })),
          ...bearings.flatMap((b) =>
            [1, -1].map((side) => ({
              type: 'circle',
              shape: { cx: at(b.position_mm), cy: y0 + side * (b.pitch_diameter_mm / 2) * scale, r: Math.max(2.5, Math.min((b.ball_diameter_mm / 2) * scale, (b.ball_diameter_mm / 2) * perMm * 2)) },
              style: { fill: l.surface, stroke: l.ink, lineWidth: 1.1 },
            })),
          ),
          ...disks.map((d) => ({ type: 'line', shape: { x1: at(d.position_mm), x2: at(d.position_mm), y1: y0 - 1.15 * tall, y2: y0 + 1.15 * tall }, style: { stroke: l.ink, lineWidth: 4 } })),
        ],
      };
    },
  };
}
