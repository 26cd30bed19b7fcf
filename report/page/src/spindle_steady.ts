// The page of a spindle where all has come to rest, at one speed or several.
import { barStyle, sideAxis, valueAxis } from './chart';
import type { SpindleSteadyReport } from './document';
import { Rows } from './document';
import type { Cell } from './figure';
import { Figure, tooltip } from './figure';
import { lineFigure } from './line_figure';
import type { Line } from './line_figure';
import { assumptions, grid, header, judgedBadge, notes, section, warnings } from './page';
import { sectionFigure } from './section_view';
import { heatParts } from './spindle_run';
import { dash, number, plain, shortPaths, valueList } from './text';

const words = (name: string) => name.replace(/_/g, ' ');

interface Source {
  name: string;
  watts: number;
  into: boolean;
}

/// Where heat comes from, bearing by bearing, and where it goes.
function sources(report: SpindleSteadyReport, rows: Rows, row: number): Source[] {
  const of = (column: string) => rows.at(column, row);
  const friction = report.bearings.length ? report.bearings.map((b) => ({ name: `friction of ${words(b)}`, watts: of(`${b}_friction_W`), into: true })) : [{ name: 'friction', watts: of('friction_power_W'), into: true }];
  const others = heatParts.filter((p) => p.column !== 'friction_power_W' && p.column !== 'heat_stored_W').map((p) => ({ name: p.sign > 0 ? p.name : `to the ${p.name}`, watts: of(p.column), into: p.sign > 0 }));
  return [...friction, ...others].filter((s) => s.watts !== 0 && Number.isFinite(s.watts));
}

function heatBars(list: Source[], height: number): Figure {
  const sum = (into: boolean) => list.filter((s) => s.into === into).reduce((total, s) => total + s.watts, 0);
  return new Figure({
    id: 'heat',
    title: 'Heat balance',
    note: `Heat into the spindle: ${number(sum(true))} W. Heat out of the spindle: ${number(sum(false))} W.`,
    height,
    option: (l, width) => {
      const side = sideAxis(
        list.map((s) => s.name),
        l,
        width,
      );
      return {
        grid: { left: side.left, right: 60, top: 12, bottom: 44 },
        tooltip: tooltip(l, (hit) => [list[hit.dataIndex]?.name ?? '', ['heat flow', `${number(list[hit.dataIndex]?.watts)} W`], ['share', `${plain((100 * (list[hit.dataIndex]?.watts ?? NaN)) / sum(true), 3)} %`]]),
        xAxis: valueAxis('heat flow [W]', l, 'x', { scale: false }),
        yAxis: side.option,
        series: [
          {
            type: 'bar',
            barMaxWidth: 20,
            data: list.map((s) => ({ value: s.watts, itemStyle: barStyle(l.kinds[s.into ? 1 : 0]) })),
            label: { show: true, position: 'right', color: l.ink, fontSize: 11, formatter: (hit: { dataIndex: number }) => number(list[hit.dataIndex]?.watts) },
          },
        ],
      };
    },
    table: () => ({ columns: ['', 'heat flow [W]', 'direction'], rows: list.map((s): Cell[] => [s.name, s.watts, s.into ? 'in' : 'out']) }),
  });
}

/// A temperature, of a ring or of a sensor.
interface Reading {
  name: string;
  ring: string;
  t: number;
}

function readings(report: SpindleSteadyReport, rows: Rows): Reading[] {
  const rings = report.bearings.flatMap((b) => ['inner', 'outer'].map((ring) => ({ name: `${words(b)}, ${ring} ring`, ring, t: rows.at(`${b}_${ring}_ring_temperature_C`, 0) })));
  return [...rings, ...report.sensors.map((s) => ({ name: words(s), ring: 'sensor', t: rows.at(`${s}_temperature_C`, 0) }))];
}

/// Rings of each bearing, one under the other, and the sensors.
function ringBars(report: SpindleSteadyReport, all: Reading[], height: number): Figure {
  return new Figure({
    id: 'temperatures',
    title: report.network ? 'Temperatures of the nodes' : report.sensors.length ? 'Temperatures of rings and sensors' : 'Temperatures of the rings',
    height,
    option: (l, width) => {
      const side = sideAxis(
        all.map((r) => r.name),
        l,
        width,
      );
      const kinds = ['inner', 'outer', 'sensor'];
      return {
        grid: { left: side.left, right: 60, top: 12, bottom: 44 },
        tooltip: tooltip(l, (hit) => [all[hit.dataIndex]?.name ?? '', ['temperature', `${number(all[hit.dataIndex]?.t)} °C`]]),
        xAxis: valueAxis('temperature [°C]', l, 'x'),
        yAxis: side.option,
        series: [
          {
            type: 'scatter',
            symbolSize: 11,
            data: all.map((r, k) => ({ value: [r.t, k], symbol: ['circle', 'rect', 'diamond'][kinds.indexOf(r.ring)], itemStyle: { color: l.kinds[kinds.indexOf(r.ring)] } })),
            label: { show: true, position: 'right', color: l.ink, fontSize: 11, formatter: (hit: { dataIndex: number }) => number(all[hit.dataIndex]?.t) },
          },
        ],
      };
    },
    table: () => ({ columns: ['', 'temperature [°C]'], rows: all.map((r): Cell[] => [r.name, r.t]) }),
  });
}

function figuresOfOne(report: SpindleSteadyReport, rows: Rows): HTMLElement {
  const [heat, all] = [sources(report, rows, 0), readings(report, rows)];
  const height = 60 + 30 * Math.max(heat.length, all.length);
  return grid(heatBars(heat, height), all.length ? ringBars(report, all, height) : undefined);
}

const ofBearing: [string, string, number][] = [
  ['inner ring [°C]', 'inner_ring_temperature_C', 4],
  ['outer ring [°C]', 'outer_ring_temperature_C', 4],
  ['axial force [N]', 'force_N', 4],
  ['friction [W]', 'friction_W', 4],
  ['contact angle inner [°]', 'inner_contact_angle_deg', 4],
  ['outer [°]', 'outer_contact_angle_deg', 4],
  ['ball load inner [N]', 'inner_load_N', 4],
  ['outer [N]', 'outer_load_N', 4],
  ['pressure inner [MPa]', 'inner_contact_pressure_MPa', 4],
  ['outer [MPa]', 'outer_contact_pressure_MPa', 4],
  ['axial stiffness [N/µm]', 'axial_stiffness_N_um', 4],
];

function bearingTable(report: SpindleSteadyReport, rows: Rows): HTMLElement {
  const table = valueList(
    'Each bearing',
    ['bearing', ...ofBearing.map(([title]) => title)],
    report.bearings.map((b) => [words(b), ...ofBearing.map(([, column, digits]) => number(rows.at(`${b}_${column}`, 0), digits))]),
  );
  table.id = 'bearings';
  return table;
}

/// Lines over speed, of the whole and of each bearing.
function overSpeed(report: SpindleSteadyReport, rows: Rows): Figure[] {
  const each = (column: string, dash = 0, told = ''): Line[] => report.bearings.map((b, kind) => ({ name: words(b), column: `${b}_${column}`, kind, dash, ...(told ? { told } : {}) }));
  const races = (id: string, title: string, axis: string, inner: string, outer: string, what: string, fromZero: boolean) =>
    lineFigure(rows, { id, title, axis, fromZero, note: `Solid: inner ${what}, dashed: outer ${what}.`, lines: [...each(inner, 0, `inner ${what}`), ...each(outer, 1, `outer ${what}`)] });
  const parts = heatParts.filter((p) => p.column !== 'heat_stored_W' && rows.get(p.column).some((v) => Number.isFinite(v) && v !== 0));
  const heat = lineFigure(rows, {
    id: 'heat',
    title: 'Heat balance',
    note: 'Friction, motor, drive and seals heat the spindle. The other parts remove heat.',
    axis: 'heat_flow_W',
    fromZero: true,
    lines: parts.map((p, kind) => ({ name: p.name, column: p.column, kind, dash: p.sign > 0 ? 0 : 1 })),
  });
  const sensors = report.sensors.length
    ? [
        lineFigure(rows, {
          id: 'sensors',
          title: report.network ? 'Temperatures of the nodes' : 'Temperatures of the sensors',
          axis: 'temperature_C',
          lines: report.sensors.map((s, kind) => ({ name: words(s), column: `${s}_temperature_C`, kind })),
        }),
      ]
    : [];
  if (report.network) return [heat, ...sensors];
  return [
    lineFigure(rows, {
      id: 'nose',
      title: 'Displacement of the nose',
      note: 'Nose face relative to the flange, positive towards the tool.',
      axis: 'displacement_um',
      lines: [
        { name: 'total', column: 'axial_displacement_um', kind: 0 },
        { name: 'thermal', column: 'thermal_displacement_um', kind: 1, dash: 1 },
        { name: 'kinematic', column: 'kinematic_displacement_um', kind: 2, dash: 2 },
      ],
    }),
    lineFigure(rows, {
      id: 'forces',
      title: 'Axial forces of the sets',
      axis: 'force_N',
      fromZero: true,
      lines: [
        { name: 'front set', column: 'front_force_N', kind: 0 },
        { name: 'rear set', column: 'rear_force_N', kind: 1, dash: 1 },
      ],
    }),
    heat,
    lineFigure(rows, {
      id: 'stiffness',
      title: 'Axial stiffness of shaft and bearings',
      axis: 'axial_stiffness_N_um',
      fromZero: true,
      lines: [{ name: 'shaft', column: 'axial_stiffness_N_um', kind: 6 }, ...each('axial_stiffness_N_um', 1)],
    }),
    races('rings', 'Temperatures of the rings', 'temperature_C', 'inner_ring_temperature_C', 'outer_ring_temperature_C', 'ring', false),
    ...sensors,
    lineFigure(rows, { id: 'bearing-forces', title: 'Axial force of each bearing', axis: 'force_N', fromZero: true, lines: each('force_N') }),
    lineFigure(rows, { id: 'friction', title: 'Friction of each bearing', axis: 'friction_W', fromZero: true, lines: each('friction_W') }),
    races('contact-angles', 'Contact angles', 'contact_angle_deg', 'inner_contact_angle_deg', 'outer_contact_angle_deg', 'race', false),
    races('ball-loads', 'Ball loads', 'ball_load_N', 'inner_load_N', 'outer_load_N', 'race', true),
    races('pressures', 'Contact pressures', 'peak_pressure_MPa', 'inner_contact_pressure_MPa', 'outer_contact_pressure_MPa', 'race', true),
  ];
}

export function spindleSteady(report: SpindleSteadyReport): (Node | undefined)[] {
  const rows = new Rows(report.rows);
  const one = report.reports.length === 1;
  const judged = report.judged ?? [];
  const failed = report.reports.flatMap((r, k) => (r.status === 'converged' || k >= rows.count ? [] : [`${plain(rows.at('speed_rpm', k))} rpm: ${r.in_words || words(r.status)}`]));
  const found = failed.length < report.reports.length;
  let last = report.reports.length - 1;
  while (last > 0 && report.reports[last]?.status !== 'converged') --last;
  const at = (name: string) => (rows.has(name) ? rows.at(name, last) : NaN);
  const rings = report.bearings.flatMap((b) => [at(`${b}_inner_ring_temperature_C`), at(`${b}_outer_ring_temperature_C`)]).filter(Number.isFinite);
  const speed = `${plain(at('speed_rpm'))} rpm`;
  const coolant = report.has_coolant ? `, coolant ${report.coolant_on ? 'on' : 'off'}` : '';
  const words_of = report.network ? `${number(at('friction_power_W') + at('drive_heat_W'))} W of heat` : `nose ${number(at('axial_displacement_um'))} µm relative to the flange, ${number(at('front_force_N'))} N in the front set`;
  const facts: [string, string][] = [
    ...(report.network
      ? []
      : ([
          ['part that the sets cause', `${number(at('kinematic_displacement_um'))} µm`],
          ['front set', `${number(at('front_force_N'))} N`],
          ['rear set', `${number(at('rear_force_N'))} N`],
          ['as mounted', `${plain(report.preload_N, 4)} N`],
          ['axial stiffness', `${number(at('axial_stiffness_N_um'))} N/µm`],
          ['hottest ring', rings.length ? `${number(Math.max(...rings))} °C` : dash],
        ] as [string, string][])),
    ['friction', `${number(at('friction_power_W'))} W`],
    ...(one ? [] : ([['speeds', String(report.rows.total)]] as [string, string][])),
  ];
  const labels = report.section?.moments.map((m) => `${plain(m.speed_rpm, 5)} rpm`) ?? [];
  return [
    header(
      {
        command: 'spindle',
        files: shortPaths([report.model]),
        badge: judgedBadge(failed.length ? [found ? `${failed.length} of ${report.reports.length} without a steady state` : words(report.reports[0]?.status ?? ''), 'open'] : ['steady', 'good'], judged),
        sentence: found ? `${report.results.spindle} at ${speed}${coolant}: ${words_of}.` : `${report.results.spindle}: no steady state${coolant}.`,
        more: `${report.mesh}.`,
      },
      found ? facts : [],
    ),
    warnings([...failed, ...judged]),
    report.section ? section('The cross-section', grid(sectionFigure(report.section, 'speed', labels, labels.length - 1))) : undefined,
    !found ? undefined : one ? section('Heat and temperatures', figuresOfOne(report, rows)) : section('Results over speed', grid(...overSpeed(report, rows))),
    found && one && report.bearings.length ? section('The bearings', bearingTable(report, rows)) : undefined,
    assumptions(report.results.assumptions),
    notes(report.rows.rows < report.rows.total ? [`This page contains ${report.rows.rows} of ${report.rows.total} speeds, evenly spread.`] : []),
  ];
}
