// The page of the modes of a shaft on its bearings: Campbell diagram, shapes, stiffness.
import { legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { CampbellRow, Crossing, Mode, ModesReport } from './document';
import { columnsOf, Rows } from './document';
import type { Cell } from './figure';
import { choice, Figure, tooltip } from './figure';
import { lineFigure } from './line_figure';
import type { Look } from './look';
import { dashes, look, symbols } from './look';
import { grid, header, judgedBadge, notes, section, warnings } from './page';
import { shaftSeries } from './shaft_pieces';
import { number, plain, shortPaths, valueList } from './text';

const words = (name: string) => name.replace(/_/g, ' ');
const whirls = ['backward', 'forward'] as const;
type Sense = (typeof whirls)[number];

/// One line of the diagram: the k-th mode in a sense, from speed to speed.
interface Track {
  pair: number;
  sense: Sense;
  points: { speed: number; mode: Mode | undefined }[];
}

/// Modes by the sense of their whirl; of those that stand every other one counts as each.
function inSense(row: CampbellRow, sense: Sense): Mode[] {
  let standing = 0;
  return row.modes.filter((m) => (m.whirl === 'standing' ? standing++ % 2 === whirls.indexOf(sense) : m.whirl === sense));
}

function tracks(rows: CampbellRow[]): Track[] {
  const most = Math.max(0, ...rows.flatMap((r) => whirls.map((w) => inSense(r, w).length)));
  return Array.from({ length: most }, (_, pair) => pair).flatMap((pair) => whirls.map((sense): Track => ({ pair, sense, points: rows.map((r) => ({ speed: r.speed_rpm, mode: inSense(r, sense)[pair] })) })));
}

/// Once and twice per turn: unbalance, and what shakes twice in a turn.
const orders = [1, 2];

const ordinal = (mode: number) => ['1st', '2nd', '3rd'][mode - 1] ?? `${mode}th`;
const nameOf = (t: Track) => `${ordinal(t.pair + 1)} ${t.sense}`;

/// Frequencies of each bearing that go with the speed, by the end of their columns.
const rolling: [string, string][] = [
  ['cage_Hz', 'cage'],
  ['outer_race_Hz', 'outer race'],
  ['inner_race_Hz', 'inner race'],
];

function campbell(report: ModesReport, list: Track[], crossed: Crossing[]): Figure {
  const { rows } = report.results;
  const places = Object.keys(rows[0] ?? {}).flatMap((name) => (name.endsWith('_cage_Hz') ? [name.slice(0, -'_cage_Hz'.length)] : []));
  const passing = places.flatMap((place, bearing) => rolling.map(([column, what], k) => ({ name: `${words(place)} ${what}`, column: `${place}_${column}`, bearing, k })));
  const fastest = Math.max(...rows.map((r) => r.speed_rpm));
  const highest = Math.max(...list.flatMap((t) => t.points.map((p) => p.mode?.frequency_Hz ?? 0)));
  const top = 1.06 * highest;
  const symbolOf = (t: Track) => symbols[t.sense === 'forward' ? 1 : 5];
  const line = (t: Track, l: Look): Option => ({
    type: 'line',
    name: nameOf(t),
    symbol: symbolOf(t),
    symbolSize: 8,
    showAllSymbol: true,
    color: l.kinds[t.pair % l.kinds.length],
    lineStyle: { width: 1.8, type: t.sense === 'forward' ? 'solid' : 'dashed' },
    connectNulls: false,
    z: 4,
    data: t.points.map((p, k) => ({ value: [p.speed, p.mode?.frequency_Hz ?? null], symbol: p.mode?.whirl === 'standing' ? 'circle' : symbolOf(t), ...(k % Math.ceil(t.points.length / 24) ? { itemStyle: { opacity: 0 } } : {}) })),
  });
  const excitation = (order: number, l: Look): Option => {
    const end = Math.min(fastest, (60 * top) / order);
    return {
      type: 'line',
      name: `${order}×`,
      symbol: 'none',
      silent: true,
      z: 3,
      itemStyle: { color: l.muted },
      lineStyle: { color: l.muted, width: 1.4, type: dashes[order === 1 ? 3 : 2] },
      data: [
        [0, 0],
        { value: [0.55 * end, (order * 0.55 * end) / 60], label: { show: (order * end) / 60 > 0.1 * top, position: 'bottom', distance: 6, formatter: `${order}×`, color: l.ink, fontSize: 12 }, symbol: 'circle', symbolSize: 0.1 },
        [end, (order * end) / 60],
      ],
      showSymbol: true,
      showAllSymbol: true,
    };
  };
  const ofBearing = ({ name, column, bearing, k }: (typeof passing)[number], l: Look): Option => {
    const points = rows.map((r): [number, number | null] => {
      const f = r[column];
      return [r.speed_rpm, typeof f === 'number' && f <= top ? f : null];
    });
    return { type: 'line', name, symbol: 'none', z: 2, color: l.kinds[(2 + bearing) % l.kinds.length], lineStyle: { width: 1, opacity: 0.75, type: dashes[k + 1] }, data: points };
  };
  return new Figure({
    id: 'campbell',
    title: 'Campbell diagram',
    note: 'Triangle up, solid: forward whirl. Triangle down, dashed: backward whirl. Circle: no whirl. Grey: one and two times the speed. Thin lines: cage, outer-race and inner-race frequencies of each bearing. A ring marks the crossing with a mode.',
    wide: true,
    height: (width) => (width < 480 ? 420 : 460),
    onPaper: 0.8,
    option: (l, width) => {
      const names = [...list.map(nameOf), ...orders.map((o) => `${o}×`), ...passing.map((p) => p.name)];
      const head = legend(names, width, l, list.map(symbolOf));
      return {
        legend: head.option,
        grid: { left: 60, right: 20, top: head.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const [speed, frequency] = hit.value as [number, number];
          return [hit.seriesName, ['speed', `${plain(speed, 5)} rpm`], ['frequency', `${number(frequency, 5)} Hz`]];
        }),
        xAxis: valueAxis('speed [rpm]', l, 'x', { scale: false, min: 0, max: fastest || 1 }),
        yAxis: valueAxis('frequency [Hz]', l, 'y', { scale: false, min: 0, max: Math.ceil(top / 100) * 100 }),
        series: [
          ...list.map((t) => line(t, l)),
          ...(fastest > 0 ? orders.map((o) => excitation(o, l)) : []),
          ...(fastest > 0 ? passing.map((p) => ofBearing(p, l)) : []),
          { type: 'scatter', name: 'met', z: 6, symbol: 'circle', symbolSize: 14, itemStyle: { color: 'transparent', borderColor: l.ink, borderWidth: 1.8 }, data: crossed.map((c) => [c.speed_rpm, c.frequency_Hz]) },
        ],
      };
    },
    table: () => ({ columns: ['speed [rpm]', 'mode', 'frequency [Hz]', 'whirl'], rows: rows.flatMap((r) => r.modes.map((m): Cell[] => [r.speed_rpm, m.mode, m.frequency_Hz, m.whirl])) }),
  });
}

const panelHeight = 170;
const between = 24;

type Shape = ModesReport['shapes'][number]['modes'][number];

/// Along one axis; of a mode that stands along that of its larger amplitude, whose largest is 1. The
/// largest is positive, so that modes alike look alike.
function values(m: Shape, which: 'y' | 'z'): number[] {
  const most = (list: number[]) => list.reduce((best, v) => (Math.abs(v) > Math.abs(best) ? v : best), 0);
  const plane = Math.abs(most(m.y)) >= Math.abs(most(m.z)) ? m.y : m.z;
  if (m.whirl === 'standing') return plane.map((v) => v / most(plane));
  return m[which].map((v) => v * Math.sign(most(plane)));
}

/// Shapes of all modes at a speed, one panel each, the shaft behind.
function shapes(report: ModesReport): Figure {
  let at = 0;
  const now = () => report.shapes[at]?.modes ?? [];
  const nodes = report.nodes_mm;
  const layout = (width: number) => {
    const columns = width >= 900 ? 3 : width >= 560 ? 2 : 1;
    const tall = panelHeight * (look().print ? 0.66 : 1);
    const wide = (width - (columns - 1) * between) / columns;
    const most = Math.max(...report.shapes.map((s) => s.modes.length));
    return { tall, wide, height: Math.ceil(most / columns) * (tall + 66), place: (k: number) => ({ left: (k % columns) * (wide + between) + 34, width: wide - 40, top: Math.floor(k / columns) * (tall + 66) + 26, height: tall }) };
  };
  const label = (speed: number) => `${plain(speed, 5)} rpm`;
  const figure: Figure = new Figure({
    id: 'shapes',
    title: 'Mode shapes',
    note: () => `At ${label(report.shapes[at]?.speed_rpm ?? 0)}: amplitude of the shaft axis, scaled to a largest value of 1. The drawing of the shaft with its bearings has its own scale for the diameters.`,
    wide: true,
    onPaper: 1,
    controls:
      report.shapes.length > 1
        ? [
            choice(
              'Speed',
              report.shapes.map((s) => label(s.speed_rpm)),
              0,
              (k) => ((at = k), figure.draw()),
            ),
          ]
        : [],
    height: (width) => layout(width).height,
    option: (l, width) => {
      const { place, wide } = layout(width);
      const list = now();
      // Of an ellipse the other axis too; what stands is drawn in its plane.
      const round = (m: Shape) => m.whirl === 'standing' || m.y.every((v, k) => Math.abs(Math.abs(v) - Math.abs(m.z[k] as number)) < 1e-3);
      const bend = (m: Shape, which: 'y' | 'z', k: number): Option => ({
        type: 'line',
        name: `mode ${k + 1}`,
        xAxisIndex: k,
        yAxisIndex: k,
        symbol: 'none',
        z: 4,
        color: l.kinds[Math.floor(k / 2) % l.kinds.length],
        lineStyle: { width: 2.2, type: which === 'y' ? 'solid' : 'dashed' },
        data: nodes.map((x, n) => [x, values(m, which)[n]]),
      });
      return {
        grid: list.map((_, k) => place(k)),
        tooltip: tooltip(l, (hit) => {
          const [x, v] = hit.value as [number, number];
          return [hit.seriesName, ['behind the nose face', `${plain(x, 4)} mm`], ['amplitude', number(v, 3)]];
        }),
        xAxis: list.map((_, k) =>
          valueAxis('behind the nose face [mm]', l, 'x', {
            gridIndex: k,
            scale: false,
            min: 0,
            max: nodes[nodes.length - 1],
            splitNumber: 4,
            splitLine: { show: false },
            axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, showMaxLabel: false },
          }),
        ),
        yAxis: list.map((m, k) =>
          valueAxis(`mode ${k + 1}, ${m.whirl}: ${number(m.frequency_Hz, 4)} Hz`, l, 'y', {
            gridIndex: k,
            scale: false,
            min: -1,
            max: 1,
            interval: 1,
            nameTextStyle: { color: l.ink, fontSize: 12, align: 'left', padding: [0, 0, 0, -24] },
            nameTruncate: { maxWidth: wide - 10 },
            axisLabel: { color: l.muted, fontSize: 11, formatter: (v: number) => plain(v) },
          }),
        ),
        series: list.flatMap((m, k) => [shaftSeries(report.shaft, l, { xAxisIndex: k, yAxisIndex: k }, l.print ? 24 : 34), bend(m, 'y', k), ...(round(m) ? [] : [bend(m, 'z', k)])]),
      };
    },
    table: () => ({ columns: ['behind the nose face [mm]', ...now().flatMap((m, k) => [`mode ${k + 1}, ${m.whirl}, y`, 'z'])], rows: nodes.map((x, n): Cell[] => [x, ...now().flatMap((m) => [m.y[n] ?? null, m.z[n] ?? null])]) }),
  });
  return figure;
}

function overSpeed(report: ModesReport, rows: Rows): Figure[] {
  const sides = ['front', 'rear'].filter((side) => rows.has(`${side}_radial_N_um`));
  const sets = (what: string) => sides.map((side, kind) => ({ name: `${side} set`, column: `${side}_${what}`, kind }));
  const each = (what: string, first: number) => (report.bearings.length > 1 ? report.bearings.map((b, k) => ({ name: words(b), column: `${b}_${what}`, kind: first + k, dash: 1 })) : []);
  const figures = [
    lineFigure(rows, { id: 'radial', title: 'Radial stiffness', note: 'Solid: sets. Dashed: single bearings.', axis: 'radial_stiffness_N_um', fromZero: true, lines: [...sets('radial_N_um'), ...each('radial_N_um', 2)] }),
    lineFigure(rows, { id: 'axial', title: 'Axial stiffness', note: 'Solid: sets. Dashed: single bearings.', axis: 'axial_stiffness_N_um', fromZero: true, lines: [...sets('axial_N_um'), ...each('axial_N_um', 2)] }),
    lineFigure(rows, {
      id: 'forces',
      title: 'Axial forces',
      note: 'Solid: sets. Dashed: single bearings.',
      axis: 'force_N',
      fromZero: true,
      lines: [...['front', 'rear'].filter((s) => rows.has(`${s}_force_N`)).map((side, kind) => ({ name: `${side} set`, column: `${side}_force_N`, kind })), ...each('force_N', 2)],
    }),
  ];
  if (report.bearings.every((b) => rows.has(`${b}_inner_ring_temperature_C`)))
    figures.push(
      lineFigure(rows, {
        id: 'rings',
        title: 'Temperatures of the rings',
        note: 'Solid: inner ring, dashed: outer ring.',
        axis: 'temperature_C',
        lines: report.bearings.flatMap((b, kind) => [
          { name: words(b), column: `${b}_inner_ring_temperature_C`, kind, told: 'inner ring' },
          { name: words(b), column: `${b}_outer_ring_temperature_C`, kind, dash: 1, told: 'outer ring' },
        ]),
      }),
    );
  return figures;
}

/// The path of the nose under an unbalance, where one was asked about.
function unbalanced(rows: Rows): HTMLElement | undefined {
  if (!rows.has('nose_amplitude_um')) return undefined;
  return section(
    'Under an unbalance',
    grid(
      lineFigure(rows, {
        id: 'unbalance',
        title: 'Path of the nose',
        note: 'Largest distance of the nose from its position without unbalance, for the given unbalance and damping.',
        axis: 'amplitude_um',
        fromZero: true,
        lines: [{ name: 'nose', column: 'nose_amplitude_um', kind: 0 }],
      }),
      lineFigure(rows, { id: 'unbalance-lag', title: 'Lag behind the unbalance', note: 'At a resonance, the lag is a quarter of a turn.', axis: 'lag_deg', lines: [{ name: 'nose', column: 'nose_lag_deg', kind: 0 }] }),
    ),
  );
}

export function modes(report: ModesReport): (Node | undefined)[] {
  const found = report.results.rows.filter((r) => r.modes.length > 0);
  const failed = report.results.rows.filter((r) => r.report.status !== 'converged').map((r) => `${plain(r.speed_rpm)} rpm: ${words(r.report.status)}${r.report.message ? `, ${r.report.message}` : ''}`);
  const state = report.warm ? 'warm in its steady state' : 'cold';
  const head = { command: 'modes', files: shortPaths([report.model]) };
  const judged = report.judged ?? [];
  const said = warnings([...failed, ...judged]);
  const first = (r: CampbellRow | undefined) => r?.modes[0]?.frequency_Hz ?? NaN;
  if (found.length === 0) return [header({ ...head, sentence: `Shaft on ${report.bearing}: no modes at these speeds.` }, []), said];
  const list = tracks(report.results.rows);
  const crossed = report.results.crossings;
  const byTurn = crossed.filter((c) => /^[12]x$/.test(c.excitation));
  const lowest = found.reduce((best, r) => (first(r) < first(best) ? r : best));
  const last = found[found.length - 1];
  const at = (r: CampbellRow | undefined) => `${number(first(r), 4)} Hz at ${plain(r?.speed_rpm)} rpm`;
  const speeds = report.results.rows.map((r) => r.speed_rpm);
  const [slowest, fastest] = [Math.min(...speeds), Math.max(...speeds)];
  const met =
    byTurn.length === 0
      ? `One and two times the speed cross no mode between ${plain(slowest)} and ${plain(fastest)} rpm.`
      : `${byTurn.length === 1 ? 'One crossing' : `${byTurn.length} crossings`} of a mode with one or two times the speed, the first at ${number(Math.min(...byTurn.map((c) => c.speed_rpm)), 4)} rpm.`;
  const rows = new Rows(columnsOf(report.results.rows));
  return [
    header(
      {
        ...head,
        badge: judgedBadge(failed.length ? [`${failed.length} of ${report.results.rows.length} speeds without modes`, 'open'] : undefined, judged),
        sentence: `Shaft on ${report.bearing}, ${state}: first mode ${at(found[0])}${found.length > 1 ? `, ${at(last)}` : ''}.`,
        ...(slowest < fastest ? { more: met } : {}),
      },
      [
        ['mass with disks', `${plain(report.weight_kg, 4)} kg`],
        ['preload at standstill', `${plain(report.results.preload_N, 4)} N`],
        ['lowest', at(lowest)],
        ['speeds', String(report.results.rows.length)],
      ],
    ),
    said,
    section(
      'Frequencies against speed',
      grid(campbell(report, list, crossed)),
      crossed.length
        ? valueList(
            'Crossings with modes',
            ['excitation', 'mode', 'speed [rpm]', 'frequency [Hz]'],
            crossed.map((c) => [words(c.excitation).replace(/^([12])x$/, '$1×'), `${ordinal(c.mode)} ${c.whirl}`, number(c.speed_rpm, 4), number(c.frequency_Hz, 4)]),
          )
        : undefined,
    ),
    unbalanced(rows),
    section('Shapes', grid(shapes(report))),
    found.length > 1 ? section('The bearings against speed', grid(...overSpeed(report, rows))) : undefined,
    notes([
      report.results.rows[0]?.modes[0]?.damping_ratio ? 'Each mode has the given damping ratio. The model does not include the flexibility of the housing.' : 'The model does not include damping or the flexibility of the housing.',
      'Unbalance excites modes with forward whirl. It excites modes with backward whirl only if the bearing stiffness depends on the direction.',
    ]),
  ];
}
