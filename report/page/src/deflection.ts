// The page of a shaft under a force: its line, and the balls of every bearing.
import { aroundOption } from './around';
import { legend, valueAxis } from './chart';
import type { DeflectionReport, LoadedBearing } from './document';
import type { Cell } from './figure';
import { choice, Figure, tooltip } from './figure';
import { dashes } from './look';
import { grid, header, judgedBadge, notes, section, warnings } from './page';
import { shaftSeries } from './shaft_pieces';
import { axisTitle, dash, number, plain, shortPaths, valueList } from './text';

const words = (name: string) => name.replace(/_/g, ' ');

function bendingLine(report: DeflectionReport): Figure {
  const { total_um: total = [], tangent_um: tangent = [], stiff_um: stiff = [] } = report.line;
  const { nodes_mm: nodes, results: r } = report;
  const lines = [
    { name: 'shaft on its bearings', values: total },
    { name: 'bearing stiffness as without the force', values: tangent },
    { name: 'rigid bearings', values: stiff },
  ].filter((line) => line.values.length === nodes.length);
  return new Figure({
    id: 'line',
    title: 'Deflection of the shaft',
    note: 'The difference between the first line and the line with rigid bearings is the share of the bearings. The rest is the bending of the shaft. The drawing of the shaft has its own scale for the diameters. The arrow is the radial force.',
    wide: true,
    height: 380,
    option: (l, width) => {
      const top = legend(
        lines.map((line) => line.name),
        width,
        l,
      );
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const [x, v] = hit.value as [number, number];
          return [hit.seriesName, ['behind the nose face', `${plain(x, 4)} mm`], ['displacement', `${number(v)} µm`]];
        }),
        xAxis: valueAxis('behind the nose face [mm]', l, 'x', { scale: false, min: 0, max: nodes[nodes.length - 1], splitLine: { show: false }, axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, showMaxLabel: false } }),
        yAxis: valueAxis('radial displacement [µm]', l, 'y', { scale: false }),
        series: [
          shaftSeries(report.shaft, l),
          ...lines.map((line, k) => ({
            type: 'line',
            name: line.name,
            symbol: 'circle',
            symbolSize: 8,
            showAllSymbol: true,
            z: 4 + k,
            color: l.kinds[k],
            lineStyle: { width: k === 0 ? 2.4 : 1.8, type: dashes[k] },
            // Points that answer the pointer and are not seen.
            data: nodes.map((x, n) => ({ value: [x, line.values[n]], itemStyle: { opacity: 0 } })),
          })),
          ...(r.force_N === 0
            ? []
            : [
                {
                  type: 'scatter',
                  name: 'force',
                  silent: true,
                  z: 7,
                  symbol: 'path://M5 0L10 8H7V22H3V8H0Z',
                  symbolSize: [12, 26],
                  symbolRotate: r.force_N > 0 ? 0 : 180,
                  symbolOffset: [0, r.force_N > 0 ? 16 : -16],
                  itemStyle: { color: l.ink },
                  data: [[r.at_mm, r.displacement_um]],
                },
              ]),
        ],
      };
    },
    table: () => ({ columns: ['behind the nose face [mm]', ...lines.map((line) => `${line.name} [µm]`)], rows: nodes.map((x, n): Cell[] => [x, ...lines.map((line) => line.values[n] ?? null)]) }),
  });
}

type BallColumn = Exclude<keyof LoadedBearing['balls'][number], 'azimuth_deg'>;
const ballColumns: BallColumn[] = ['inner_load_N', 'outer_load_N', 'inner_contact_angle_deg', 'outer_contact_angle_deg'];

/// One value of every ball, a line for each bearing.
function balls(bearings: LoadedBearing[]): Figure {
  let column = 0;
  const name = () => ballColumns[column] as BallColumn;
  const figure: Figure = new Figure({
    id: 'balls',
    title: 'Around the bearings',
    note: '0° is the direction of the force. A ball without contact with the inner race has no inner angle.',
    height: 420,
    onPaper: 1,
    controls: [choice('Show', ballColumns.map(axisTitle), 0, (k) => ((column = k), figure.draw()))],
    option: (l, width) =>
      aroundOption(
        bearings.map((b) => ({ name: words(b.place), azimuth: b.balls.map((ball) => ball.azimuth_deg), values: b.balls.map((ball) => ball[name()]) })),
        name(),
        l.kinds,
        l,
        width,
      ),
    table: () => ({ columns: ['bearing', 'azimuth [°]', ...ballColumns.map(axisTitle)], rows: bearings.flatMap((b) => b.balls.map((ball): Cell[] => [words(b.place), ball.azimuth_deg, ...ballColumns.map((c) => ball[c])])) }),
  });
  return figure;
}

/// The stiffness of each bearing without the force and under it.
function stiffness(bearings: LoadedBearing[], before: number[]): Figure {
  const kinds = [
    { name: 'radial, without the force', value: (_: LoadedBearing, k: number) => before[k] ?? null },
    { name: 'radial, under the force', value: (b: LoadedBearing) => b.radial_stiffness_N_um },
    { name: 'axial, under the force', value: (b: LoadedBearing) => b.axial_stiffness_N_um },
  ];
  return new Figure({
    id: 'stiffness',
    title: 'Stiffness of the bearings',
    height: 420,
    onPaper: 0.8,
    option: (l, width) => {
      const top = legend(
        kinds.map((k) => k.name),
        width,
        l,
        kinds.map(() => 'rect'),
      );
      return {
        legend: top.option,
        aria: { enabled: true, decal: { show: false } },
        grid: { left: 60, right: 16, top: top.height + 28, bottom: 30 },
        tooltip: tooltip(l, (hit) => [`${words(bearings[hit.dataIndex]?.place ?? '')}: ${hit.seriesName}`, ['stiffness', `${number(hit.value as number)} N/µm`]]),
        xAxis: { type: 'category', data: bearings.map((b) => words(b.place)), axisLabel: { color: l.ink, fontSize: 12, interval: 0, hideOverlap: true }, axisTick: { show: false }, axisLine: { lineStyle: { color: l.muted } } },
        yAxis: valueAxis('stiffness [N/µm]', l, 'y', { scale: false, min: 0 }),
        series: kinds.map((kind, k) => ({ type: 'bar', name: kind.name, barMaxWidth: 26, itemStyle: { color: l.kinds[k], borderRadius: [3, 3, 0, 0] }, data: bearings.map((b, n) => kind.value(b, n)) })),
      };
    },
    table: () => ({ columns: ['bearing', ...kinds.map((k) => `${k.name} [N/µm]`)], rows: bearings.map((b, n): Cell[] => [words(b.place), ...kinds.map((kind) => kind.value(b, n))]) }),
  });
}

export function deflection(report: DeflectionReport): (Node | undefined)[] {
  const { results: r, line } = report;
  const found = r.report.status === 'converged' && r.displacement_um !== null;
  const judged = report.judged ?? [];
  const um = (v: number | null) => (v === null ? dash : `${number(v)} µm`);
  const radial = r.direction === 'radial';
  const under = `Shaft on ${report.bearing} under ${report.load} at ${plain(r.at_mm)} mm, ${plain(r.speed_rpm)} rpm, ${report.warm ? 'warm' : 'cold'}`;
  const before = line.radial_stiffness_before_N_um ?? [];
  const first = r.tangent_displacement_um === null || r.stiffness_N_um === null ? NaN : r.force_N / r.tangent_displacement_um;
  const table = valueList(
    'Each bearing under the force',
    ['bearing', 'axial [N]', 'radial [N]', 'moment [N m]', 'least ball load [N]', 'largest [N]', 'least angle [°]', 'largest [°]', 'balls lost', 'K axial [N/µm]', 'K radial [N/µm]', 'K radial without force [N/µm]'],
    r.bearings.map((b, k) => {
      // Zero where rounding left it.
      const load = Math.abs(r.force_N) + Math.abs(r.axial_force_N ?? 0) + Math.abs(r.moment_Nm ?? 0);
      const across = (v: number) => number(Math.abs(v) < 1e-9 * load ? 0 : v);
      return [
        words(b.place),
        number(b.axial_load_N),
        across(b.radial_load_N),
        across(b.moment_Nm),
        number(b.least_inner_load_N),
        number(b.largest_inner_load_N),
        number(b.least_inner_contact_angle_deg),
        number(b.largest_inner_contact_angle_deg),
        String(b.lost_balls),
        number(b.axial_stiffness_N_um),
        number(b.radial_stiffness_N_um),
        number(before[k]),
      ];
    }),
  );
  table.id = 'bearings';
  return [
    header(
      {
        command: 'deflection',
        files: shortPaths([report.model]),
        badge: judgedBadge(found ? undefined : [words(r.report.status), 'open'], judged),
        sentence: found
          ? `${under}: displacement at the load ${um(r.displacement_um)}${r.stiffness_N_um === null ? '' : `, ${number(r.stiffness_N_um)} N/µm`}.`
          : `${under}: no equilibrium${r.report.message ? `: ${r.report.message}` : ''}.`,
      },
      found
        ? [
            ['preload as mounted', `${plain(r.preload_N, 4)} N`],
            ['front set without the force', `${number(r.unloaded_front_force_N)} N`],
            ['rear set', `${number(r.unloaded_rear_force_N)} N`],
            ...(Number.isFinite(first) ? ([['stiffness at zero load', `${number(first)} N/µm`]] as [string, string][]) : []),
            ...(radial
              ? ([
                  ['nose', um(r.nose_displacement_um)],
                  ['slope of the nose', `${number(r.nose_slope_urad)} µrad`],
                ] as [string, string][])
              : []),
          ]
        : [],
    ),
    warnings(judged),
    found && radial ? section('The shaft', grid(bendingLine(report))) : undefined,
    found ? section('The bearings', grid(balls(r.bearings), stiffness(r.bearings, before)), table) : undefined,
    notes(['The model has a rigid housing. Its deformation is not part of these displacements.']),
  ];
}
