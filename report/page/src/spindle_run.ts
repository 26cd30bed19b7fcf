// The page of a spindle through a speed programme.
import { areas, legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { SpindleRunReport } from './document';
import { Figure } from './figure';
import type { Look } from './look';
import { assumptions, grid, header, judgedBadge, notes, section, warnings } from './page';
import { sectionFigure } from './section_view';
import { dash, number, plain, plainCeiling, quantity, shortPaths } from './text';
import { left, panelFigure, right, rowTooltip, stacked, table, timeAxis } from './time_panels';
import type { Panel, Share } from './time_panels';
import { TimeView } from './time_view';

const words = (name: string) => name.replace(/_/g, ' ');
export const hoursOf = (seconds: number) => (seconds < 600 ? `${number(seconds, 3)} s` : `${number(seconds / 3600, 3)} h`);

/// Speed, and of the other inputs those that vary.
function inputPanels(report: SpindleRunReport, view: TimeView): Panel[] {
  const kinds: [string, string, number][] = [
    ['rpm', 'speed [rpm]', 80],
    ['N', 'loads [N]', 80],
    ['W', 'motor heat [W]', 80],
    ['', 'on or off', 46],
  ];
  return kinds.flatMap(([unit, title, height]): Panel[] => {
    const names = report.inputs.filter((n) => quantity(n).unit === unit && (n === 'speed_rpm' || (view.rows.varies(n) && (n !== 'coolant_on' || report.has_coolant))));
    if (names.length === 0) return [];
    const only = names.length === 1 ? `${quantity(names[0] as string).label}${unit ? ` [${unit}]` : ''}` : title;
    return [{ title: only, unit, height, stepped: true, onOff: unit === '', lines: names.map((column, kind) => ({ label: quantity(column).label, column, kind: unit === 'rpm' ? 6 : kind })) }];
  });
}

function nose(report: SpindleRunReport, view: TimeView): Figure {
  return panelFigure(
    view,
    { id: 'nose', title: 'Displacement of the nose', note: 'Nose face relative to the flange, positive towards the tool, zero as mounted at standstill. Kinematic: displacement that the cold sets cause at this speed.' },
    [
      {
        title: 'displacement [µm]',
        unit: 'µm',
        height: 250,
        lines: [
          { label: 'total', column: 'axial_displacement_um', kind: 0 },
          { label: 'thermal', column: 'thermal_displacement_um', kind: 1, dash: 1 },
          { label: 'kinematic', column: 'kinematic_displacement_um', kind: 2, dash: 2 },
        ],
      },
      ...inputPanels(report, view),
    ],
  );
}

/// The highest force of the front set, over all time steps.
function highest(report: SpindleRunReport, view: TimeView): ((l: Look) => Option[]) | undefined {
  const { force_N: force, time_s: time } = report.results.highest_front_force;
  if (time === null || !(force > 0)) return undefined;
  const at = view.at(time);
  const late = at > (view.span[0] + view.span[1]) / 2;
  return (l) => [
    {
      type: 'scatter',
      name: 'front set',
      silent: true,
      z: 8,
      symbol: 'triangle',
      symbolSize: 9,
      itemStyle: { color: l.ink },
      data: [[at, force]],
      label: { show: true, position: late ? 'left' : 'right', distance: 6, formatter: `${number(force)} N at ${hoursOf(time)}`, color: l.ink, fontSize: 12, textBorderColor: l.surface, textBorderWidth: 3 },
    },
  ];
}

function forces(report: SpindleRunReport, view: TimeView): Figure {
  const more = highest(report, view);
  return panelFigure(view, { id: 'forces', title: 'Axial forces of sets and bearings', note: `Triangle: the highest force of the front set over all time steps. The rings warm faster than the shaft, so the forces can overshoot.` }, [
    {
      title: 'force of a set [N]',
      unit: 'N',
      height: 200,
      lines: [
        { label: 'front set', column: 'front_force_N', kind: 0 },
        { label: 'rear set', column: 'rear_force_N', kind: 1, dash: 1 },
      ],
      ...(more ? { more } : {}),
    },
    { title: 'force of a bearing [N]', unit: 'N', height: 160, lines: report.bearings.map((b, kind) => ({ label: words(b), column: `${b}_force_N`, kind, dash: kind })) },
    ...inputPanels(report, view).slice(0, 1),
  ]);
}

function temperatures(report: SpindleRunReport, view: TimeView): Figure {
  const fluids = report.inputs.filter((n) => quantity(n).unit === '°C');
  const panels: Panel[] = [];
  if (report.bearings.length)
    panels.push({
      title: 'rings [°C]',
      unit: '°C',
      height: 220,
      lines: report.bearings.flatMap((b, kind) => [
        { label: `${words(b)} inner`, column: `${b}_inner_ring_temperature_C`, kind },
        { label: `${words(b)} outer`, column: `${b}_outer_ring_temperature_C`, kind, dash: 1 },
      ]),
    });
  if (report.sensors.length)
    panels.push({ title: report.network ? 'nodes [°C]' : 'sensors [°C]', unit: '°C', height: 170, lines: report.sensors.map((s, kind) => ({ label: words(s), column: `${s}_temperature_C`, kind, dash: Math.floor(kind / 7) })) });
  if (fluids.length) panels.push({ title: 'surroundings [°C]', unit: '°C', height: 110, lines: fluids.map((column, kind) => ({ label: quantity(column).label.replace(' temperature', ''), column, kind, dash: kind })) });
  return panelFigure(view, { id: 'temperatures', title: 'Temperatures', note: report.bearings.length ? 'Means of the rings: inner solid, outer dashed.' : '' }, [...panels, ...inputPanels(report, view).slice(0, 1)]);
}

export const heatParts: { name: string; column: string; sign: number }[] = [
  { name: 'friction', column: 'friction_power_W', sign: 1 },
  { name: 'motor, drive, seals', column: 'drive_heat_W', sign: 1 },
  { name: 'coolant', column: 'heat_to_coolant_W', sign: -1 },
  { name: 'air', column: 'heat_to_air_W', sign: -1 },
  { name: 'machine', column: 'heat_to_machine_W', sign: -1 },
  { name: 'stored', column: 'heat_stored_W', sign: -1 },
];
const heatKinds = [1, 4, 5, 2, 3, 6];

/// How far an axis goes on which short peaks, as of coolant that is switched on, do not press all
/// else flat; undefined where there are none.
function withoutPeaks(view: TimeView, shares: Share[]): { limit: number; most: number } | undefined {
  const steps = Array.from(view.hours, (time, k) => {
    const sum = (sign: number) => shares.reduce((total, s) => total + Math.max(sign * (s.values[k] as number), 0), 0);
    return { size: Math.max(sum(1), sum(-1)), length: k > 0 ? time - (view.hours[k - 1] as number) : 0 };
  }).sort((a, b) => a.size - b.size);
  const most = steps[steps.length - 1]?.size ?? 0;
  let left = 0.97 * steps.reduce((total, s) => total + s.length, 0);
  const usual = steps.find((s) => (left -= s.length) <= 0)?.size ?? most;
  return most > 4 * usual && usual > 0 ? { limit: 2 * usual, most } : undefined;
}

function heat(view: TimeView): Figure {
  const parts = heatParts.filter(({ column }) => view.rows.get(column).some((v) => v !== 0));
  const kinds = parts.map((p) => heatKinds[heatParts.indexOf(p)] as number);
  const shares = parts.map(({ name, column, sign }): Share => ({ name, values: view.rows.get(column).map((v) => sign * v) }));
  const peaks = withoutPeaks(view, shares);
  return new Figure({
    id: 'heat',
    title: 'Heat balance',
    note:
      'Above zero: heat into the spindle, and stored heat that flows back. Below zero: heat out of the spindle, and heat that is stored. Both sides are equal at any time.' +
      (peaks ? ` Cut off: short peaks up to ${number(peaks.most, 3)} W.` : ''),
    wide: true,
    marks: 1e4,
    onPaper: 0.8,
    height: (width) => (width < 480 ? 320 : 340),
    option: (l, width) => {
      const inner = width - left - right;
      const colours = (k: number) => (kinds[k] === 6 ? l.muted : (l.kinds[kinds[k] as number] as string));
      const top = legend(
        shares.map((s) => s.name),
        width,
        l,
        shares.map(() => 'rect'),
      );
      return {
        legend: top.option,
        grid: { left, right, top: top.height + 26, bottom: 46 },
        tooltip: rowTooltip(view, l, (row) => [`${number(view.hours[row], 4)} ${view.axisUnit}`, ...parts.map(({ name, column }): [string, string] => [name, `${number(view.rows.at(column, row))} W`])]),
        xAxis: timeAxis(view, l),
        yAxis: valueAxis('heat flow [W]', l, 'y', { scale: false, ...(peaks ? { min: -plainCeiling(peaks.limit), max: plainCeiling(peaks.limit) } : {}) }),
        series: stacked(view, shares, view.rows.get('friction_power_W'), inner).flatMap((p, k) => [areas(p.name, p.up, colours(k)), areas(p.name, p.down, colours(k))]),
      };
    },
    table: () =>
      table(
        view,
        heatParts.map(({ name, column }): [string, Float64Array] => [`${name} [W]`, view.rows.get(column)]),
      ),
  });
}

function crossSection(report: SpindleRunReport): Figure | undefined {
  if (!report.section) return undefined;
  const { moments } = report.section;
  const { time_s: high } = report.results.highest_front_force;
  // The state is that at the end of the step in which it was.
  const worst = high === null ? -1 : moments.findIndex((m) => (m.time_s ?? 0) >= high * (1 - 1e-12));
  const labels = moments.map((m, k) => `${hoursOf(m.time_s ?? 0)}, ${plain(m.speed_rpm, 5)} rpm${k === worst ? ', highest front force' : ''}${k === moments.length - 1 ? ', the end' : ''}`);
  return sectionFigure(report.section, 'moment', labels, worst < 0 ? moments.length - 1 : worst);
}

export function spindleRun(report: SpindleRunReport): (Node | undefined)[] {
  const view = new TimeView(report.rows);
  view.takeOwnUnit();
  const { rows } = view;
  const end = report.results.report;
  const last = rows.count - 1;
  const at = (name: string) => (rows.has(name) && last >= 0 ? rows.at(name, last) : NaN);
  const converged = end.status === 'converged';
  const judged = report.judged ?? [];
  const extreme = (name: string, sign: number) => {
    // Rounding makes no extreme.
    const values = rows.get(name).map((v) => sign * Math.round(1e4 * v));
    return values.reduce((best, v, k) => (v > (values[best] as number) ? k : best), 0);
  };
  const high = report.results.highest_front_force;
  const rounded = (v: number) => number(Math.abs(v) < 1e-3 ? 0 : v, 4);
  const place = (row: number) => `${rounded(rows.at('axial_displacement_um', row))} µm at ${hoursOf(rows.at('time_s', row))}`;
  const reached = `${report.rows_reached} of ${report.rows_asked} rows`;
  const facts: [string, string][] = [
    ...(report.network
      ? []
      : ([
          ['nose at the end', `${rounded(at('axial_displacement_um'))} µm`],
          ['highest front force', `${number(high.force_N)} N`],
        ] as [string, string][])),
    ['friction at the end', `${number(at('friction_power_W'))} W`],
    ['error of the energy balance', end.energy_error === null ? dash : `${end.energy_error.toExponential(0)} of the exchanged heat`],
    ['time steps', `${end.steps + end.rejected}, ${end.rejected} rejected`],
    ['rows', reached],
  ];
  const head = { command: 'spindle', files: shortPaths([report.model, report.programme]), badge: judgedBadge([converged ? 'completed' : words(end.status), converged ? 'good' : 'open'], judged) };
  if (last < 0) return [header({ ...head, sentence: `${report.results.spindle}: no row was reached.`, more: end.message }, facts)];
  return [
    header(
      {
        ...head,
        sentence: converged
          ? report.network
            ? `${report.results.spindle} through ${hoursOf(report.ended_at_s ?? 0)}.`
            : `${report.results.spindle}: nose from ${place(extreme('axial_displacement_um', -1))} to ${place(extreme('axial_displacement_um', 1))}; front set up to ${number(high.force_N)} N at ${hoursOf(high.time_s ?? 0)}.`
          : `${report.results.spindle}: ended after ${hoursOf(report.ended_at_s ?? 0)}: ${end.message || words(end.status)}. ${reached} were computed.`,
        more: `${report.mesh}.`,
      },
      facts,
    ),
    warnings(judged),
    report.section ? section('The cross-section', grid(crossSection(report))) : undefined,
    section('Over time', grid(...(report.network ? [] : [nose(report, view), forces(report, view)]), temperatures(report, view), heat(view))),
    assumptions(report.results.assumptions),
    notes([
      'The inputs of a row apply from the previous row to this row.',
      ...(report.rows.total > report.rows_reached ? [`Lines connect the rows of the programme and the ends of all time steps, ${report.rows.total} points.`] : []),
      ...(report.rows.rows < report.rows.total ? [`This page contains ${report.rows.rows} of ${report.rows.total} points: evenly spread points, and the points with the lowest and highest value of every column in each interval.`] : []),
    ]),
  ];
}
