// The page of step responses: each with its fit, the laws of gain and time constant, and what they cost over a programme.
import { legend, symbolLegend, valueAxis } from './chart';
import type { Option } from './chart';
import { columnsOf, Rows } from './document';
import type { StepCourse, StepRow, StepsReport } from './document';
import type { Cell } from './figure';
import { choice, Figure, tooltip } from './figure';
import { thinned } from './groups';
import { lineFigure } from './line_figure';
import { dashes, ordered, symbols } from './look';
import { grid, header, notes, section } from './page';
import { dash, el, number, plain, shortPaths, signed, valueList } from './text';
import { panelFigure } from './time_panels';
import { TimeView } from './time_view';

const mostDrawn = 8; // steps in one picture

/// How far a lag has come.
const lag = (gain: number | null, minutes: number | null, seconds: number) => (gain === null || minutes === null ? NaN : gain * (1 - Math.exp(-seconds / (60 * minutes))));
const one = (r: StepRow, t: number) => lag(r.K_um, r.T_min, t);
const two = (r: StepRow, t: number) => lag(r.K1_um, r.T1_min, t) + lag(r.K2_um, r.T2_min, t);
const hasTwo = (r: StepRow) => r.K2_um !== null;

const directions = ['axial', 'radial'] as const;
type Direction = (typeof directions)[number];

const loadOf = (r: StepRow, direction: Direction) => r[`${direction}_load_N`] ?? null;
const speedOf = (r: StepRow) => (r.speed_rpm === null ? `${plain(r.power_end_W, 4)} W` : `${plain(r.speed_rpm)} rpm`);
const nameOf = (r: StepRow) => r.load_case || [...directions.flatMap((d) => (loadOf(r, d) === null ? [] : [`${plain(loadOf(r, d) as number)} N ${d}`])), speedOf(r)].join(', ');

interface Step {
  row: StepRow;
  time: number[];
  displacement: number[];
}

/// The unit of an axis of time.
function scaleOf(seconds: number): { unit: string; of: number } {
  return seconds < 600 ? { unit: 's', of: 1 } : seconds < 8 * 3600 ? { unit: 'min', of: 60 } : { unit: 'h', of: 3600 };
}

const ofSpeeds = { id: 'courses', title: 'Step responses', from: 'From rest' };
const ofLoads = { id: 'load-courses', title: 'Responses to a load', from: 'From the steady state' };

function courses(steps: Step[], { id, title, from } = ofSpeeds): Figure {
  const drawn = thinned(
    steps.map((_, k) => k),
    mostDrawn,
  ).map((k) => steps[k] as Step);
  const until = Math.max(...drawn.flatMap((s) => s.time));
  const { unit, of } = scaleOf(until);
  const both = drawn.some((s) => hasTwo(s.row));
  return new Figure({
    id,
    title,
    note: `${from}, without the kinematic part, which acts immediately. Points: spindle. Dashed: one time constant.${both ? ' Solid: two.' : ''}${drawn.length < steps.length ? ` The picture shows ${drawn.length} of ${steps.length} steps, evenly chosen.` : ''}`,
    wide: true,
    marks: 1e4,
    height: 420,
    onPaper: 0.8,
    option: (l, width) => {
      const names = drawn.map((s) => nameOf(s.row));
      const colours = ordered(drawn.length, l);
      const top = symbolLegend(names, width, l);
      const fit = (s: Step, k: number, value: (r: StepRow, t: number) => number, type: string): Option => ({
        type: 'line',
        name: names[k],
        symbol: 'none',
        silent: true,
        color: colours[k],
        lineStyle: { width: 1.6, type },
        data: Array.from({ length: 161 }, (_, n) => (n / 160) ** 2 * until).map((t) => [t / of, value(s.row, t)]),
      });
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const [t, v] = hit.value as [number, number];
          return [hit.seriesName, ['time', `${number(t, 4)} ${unit}`], ['displacement', `${number(v)} µm`]];
        }),
        xAxis: valueAxis(`time since the step [${unit}]`, l, 'x', { scale: false, min: 0, max: until / of, axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, showMaxLabel: false } }),
        yAxis: valueAxis('displacement [µm]', l, 'y', { scale: false }),
        series: drawn.flatMap((s, k) => [
          {
            type: 'scatter',
            name: names[k],
            symbol: symbols[k % symbols.length],
            symbolSize: 6,
            color: colours[k],
            itemStyle: { opacity: 0.7 },
            data: thinned(
              s.time.map((_, n) => n),
              80,
            ).map((n) => [(s.time[n] as number) / of, s.displacement[n]]),
          },
          fit(s, k, one, 'dashed'),
          ...(hasTwo(s.row) ? [fit(s, k, two, 'solid')] : []),
        ]),
      };
    },
    table: () => ({
      columns: ['step', 'time [s]', 'displacement [µm]', 'one time constant [µm]', 'two [µm]'],
      rows: steps.flatMap((s) => s.time.map((t, n): Cell[] => [nameOf(s.row), t, s.displacement[n] ?? null, one(s.row, t), hasTwo(s.row) ? two(s.row, t) : null])),
    }),
  });
}

/// What the fits leave of one step.
function left(steps: Step[]): Figure {
  let at = steps.length - 1;
  const now = () => steps[at] as Step;
  const figure: Figure = new Figure({
    id: 'left',
    title: 'Residuals of the fits',
    note: () => `Fit − spindle: ${number(now().row.fit_rms_um, 2)} µm RMS with one time constant${hasTwo(now().row) ? `, ${number(now().row.fit_rms_two_um, 2)} µm with two` : ''}.`,
    wide: true,
    height: 260,
    controls:
      steps.length > 1
        ? [
            choice(
              'Step',
              steps.map((s) => nameOf(s.row)),
              at,
              (k) => ((at = k), figure.draw()),
            ),
          ]
        : [],
    option: (l, width) => {
      const s = now();
      const { unit, of } = scaleOf(Math.max(...s.time));
      const kinds = [['one time constant', one], ...(hasTwo(s.row) ? [['two', two]] : [])] as [string, (r: StepRow, t: number) => number][];
      const top = legend(
        kinds.map(([name]) => name),
        width,
        l,
      );
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => [hit.seriesName, ['time', `${number((hit.value as number[])[0], 4)} ${unit}`], ['fit − spindle', `${signed((hit.value as [number, number])[1])} µm`]]),
        xAxis: valueAxis(`time since the step [${unit}]`, l, 'x', { scale: false, min: 0 }),
        yAxis: valueAxis('fit − spindle [µm]', l, 'y', { scale: false }),
        series: kinds.map(([name, value], k) => ({
          type: 'line',
          name,
          symbolSize: 4,
          showSymbol: false,
          color: l.kinds[k],
          lineStyle: { width: 1.8, type: dashes[1 - k] },
          data: s.time.map((t, n) => [t / of, value(s.row, t) - (s.displacement[n] as number)]),
        })),
      };
    },
    table: () => ({
      columns: ['time [s]', 'one time constant [µm]', 'two [µm]'],
      rows: now().time.map((t, n): Cell[] => [t, one(now().row, t) - (now().displacement[n] as number), hasTwo(now().row) ? two(now().row, t) - (now().displacement[n] as number) : null]),
    }),
  });
  return figure;
}

/// Gain or time constant at the power at the end of each step, with the laws through them.
function law(report: StepsReport, steps: Step[], of: 'K' | 'T'): Figure {
  const { laws, results: r } = report;
  const unit = of === 'K' ? 'µm' : 'min';
  const key = of === 'K' ? 'um' : 'min';
  const value = (s: Step) => (of === 'K' ? s.row.K_um : s.row.T_min);
  const line = of === 'K' ? [r.K_of_P.slope_um_W, r.K_of_P.offset_um] : [r.T_of_P.slope_min_W, r.T_of_P.offset_min];
  const power = of === 'K' ? [r.K_power_law.factor_um, r.K_power_law.exponent] : [r.T_power_law.factor_min, r.T_power_law.exponent];
  const kinds: [string, 'line' | 'power' | 'curve'][] = [
    ['curve', 'curve'],
    ['power law', 'power'],
    ['straight line', 'line'],
  ];
  const course = (which: string) => (laws as unknown as Record<string, (number | null)[]> | null)?.[`${of}_${which}_${key}`] ?? [];
  const known = kinds.filter(([, which]) => course(which).some((v) => v !== null));
  const range = r.valid_from_W === null && r.valid_to_W === null ? '' : `; valid from ${number(r.valid_from_W ?? 0, 3)} to ${r.valid_to_W === null ? 'any' : number(r.valid_to_W, 3)} W`;
  const words = [
    ...(power[0] === null || power[1] === null ? [] : [`${of} = ${number(power[0])} ${unit} (P/W)^${number(power[1], 3)}`]),
    ...(line[0] === null || line[1] === null ? [] : [`${of} = ${number(line[0])} ${unit}/W P ${(line[1] as number) < 0 ? '−' : '+'} ${number(Math.abs(line[1] as number))} ${unit}${range}`]),
  ];
  return new Figure({
    id: of === 'K' ? 'gain' : 'time-constant',
    title: of === 'K' ? 'Gain K against power' : 'Time constant T against power',
    note: words.join('; ') + (words.length ? '.' : ''),
    height: 360,
    option: (l, width) => {
      const names = ['steps', ...known.map(([name]) => name)];
      const top = legend(names, width, l, ['circle']);
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const [p, v] = hit.value as [number, number];
          const step = hit.seriesName === 'steps' ? steps[hit.dataIndex] : undefined;
          return [step ? nameOf(step.row) : hit.seriesName, ['power at the end', `${number(p)} W`], [of, `${number(v)} ${unit}`]];
        }),
        xAxis: valueAxis('power at the end P [W]', l, 'x', { scale: false, min: 0 }),
        yAxis: valueAxis(`${of} [${unit}]`, l, 'y', { scale: false }),
        series: [
          { type: 'scatter', name: 'steps', symbol: 'circle', symbolSize: 9, z: 6, itemStyle: { color: l.ink }, data: steps.map((s) => [s.row.power_end_W, value(s)]) },
          ...known.map(([name, which], k) => ({
            type: 'line',
            name,
            silent: true,
            symbol: 'none',
            connectNulls: false,
            z: 3,
            color: l.kinds[k],
            lineStyle: { width: 1.8, type: dashes[k] },
            data: (laws?.power_W ?? []).map((p, n) => [p, course(which)[n]]),
          })),
        ],
      };
    },
    table: () => ({ columns: ['step', 'power at the end [W]', `${of} [${unit}]`], rows: steps.map((s): Cell[] => [nameOf(s.row), s.row.power_end_W, value(s)]) }),
  });
}

/// Both time constants against power, where one does not do.
function twoLags(steps: Step[]): Figure[] {
  if (steps.length < 2 || !steps.every((s) => hasTwo(s.row)) || !steps.some((s) => s.row.two_needed)) return [];
  const rows = new Rows(columnsOf(steps.map((s) => ({ ...s.row }))));
  const both = (what: string) => [
    { name: 'the faster one', column: `${what}1_${what === 'K' ? 'um' : 'min'}`, kind: 0 },
    { name: 'the slower one', column: `${what}2_${what === 'K' ? 'um' : 'min'}`, kind: 1, dash: 1 },
  ];
  return [
    lineFigure(rows, { id: 'two-gains', title: 'Gains of two time constants', x: 'power_end_W', axis: 'gain_um', fromZero: true, lines: both('K') }),
    lineFigure(rows, { id: 'two-times', title: 'The two time constants', x: 'power_end_W', axis: 'time_constant_min', fromZero: true, lines: both('T') }),
  ];
}

/// Gain and displacement at once over a load, a line for each speed.
function overLoad(steps: Step[], direction: Direction): Figure[] {
  const rows = steps.map((s) => s.row).filter((r) => loadOf(r, direction) !== null);
  if (rows.length === 0) return [];
  const speeds = [...new Set(rows.map((r) => r.speed_rpm as number))].sort((a, b) => a - b);
  const column = (what: string, speed: number) => `${what}_at_${speed}_rpm_um`;
  const x = `${direction}_load_N`;
  const byLoad = new Map<number, Record<string, unknown>>();
  for (const r of rows) {
    const load = loadOf(r, direction) as number;
    const row = byLoad.get(load) ?? { [x]: load };
    byLoad.set(load, { ...row, [column('K', r.speed_rpm as number)]: r.K_um, [column('at_once', r.speed_rpm as number)]: r.kinematic_um });
  }
  const table = new Rows(columnsOf([...byLoad.values()].sort((a, b) => (a[x] as number) - (b[x] as number))));
  const figure = (id: string, title: string, axis: string, what: string) =>
    lineFigure(table, { id: `${direction}-${id}`, title, x, axis, fromZero: true, lines: speeds.map((speed, k) => ({ name: `${plain(speed)} rpm`, column: column(what, speed), kind: k })) });
  return [figure('gain', `Gain K against the ${direction} load`, 'gain_um', 'K'), figure('at-once', `Immediate displacement against the ${direction} load`, 'displacement_um', 'at_once')];
}

function superposition(report: StepsReport): HTMLElement | undefined {
  const s = report.results.superposition;
  if (!s || !report.rows) return undefined;
  const view = new TimeView(report.rows);
  view.takeOwnUnit();
  return section(
    'The correction compared with the full simulation',
    grid(
      panelFigure(
        view,
        {
          id: 'superposition',
          title: 'Over a programme of speeds',
          note: `Error of the simplification: ${number(s.rms_um, 3)} µm RMS, at most ${number(s.largest_um, 3)} µm (after ${number(s.time_of_largest_s / 3600, 3)} h); the displacement varies by ${number(s.highest_um - s.lowest_um, 3)} µm.`,
        },
        [
          {
            title: 'displacement [µm]',
            unit: 'µm',
            height: 240,
            lines: [
              { label: 'full simulation', column: 'simulated_um', kind: 6 },
              { label: 'correction', column: 'corrected_um', kind: 1, dash: 1 },
            ],
          },
          { title: 'correction − simulation [µm]', unit: 'µm', height: 130, lines: [{ label: 'correction − simulation', column: 'error_um', kind: 0 }] },
          { title: 'speed [rpm]', unit: 'rpm', height: 80, stepped: true, lines: [{ label: 'speed', column: 'speed_rpm', kind: 6 }] },
        ],
      ),
    ),
  );
}

/// The steps that have a fit.
function fitted(rows: StepRow[], drawn: StepCourse[]): Step[] {
  const all = rows.map((row, k): Step => ({ row, time: drawn[k]?.time_s ?? [], displacement: drawn[k]?.displacement_um ?? [] }));
  return all.filter((s) => s.row.status === 'converged' && s.row.K_um !== null);
}

export function stepResponses(report: StepsReport): (Node | undefined)[] {
  const { results: r } = report;
  const rows = [...r.rows, ...(r.load_rows ?? [])];
  const steps = fitted(r.rows, report.courses);
  const loads = fitted(r.load_rows ?? [], report.load_courses ?? []);
  const failed = rows.filter((row) => row.status !== 'converged').map((row) => `${nameOf(row)}: ${row.message ?? row.status.replace(/_/g, ' ')}`);
  const warnings = failed.length ? section('Warnings', el('ul', { class: 'notes', id: 'warnings' }, ...failed.map((w) => el('li', {}, w)))) : undefined;
  const head = { command: 'step-response', files: shortPaths([report.source, ...(report.programme ? [report.programme] : [])]) };
  if (steps.length === 0) return [header({ ...head, sentence: 'No step response has a fit.' }, []), warnings, notes(r.said)];
  const [first, last] = [steps[0] as Step, steps[steps.length - 1] as Step];
  const ends = (of: (row: StepRow) => number | null) => (steps.length > 1 ? `${number(of(first.row), 3)} to ${number(of(last.row), 3)}` : number(of(first.row), 3));
  const needed = steps.filter((s) => s.row.two_needed).length;
  return [
    header(
      {
        ...head,
        ...(failed.length ? { badge: [`${failed.length} of ${rows.length} steps without a fit`, 'open'] as [string, string] } : {}),
        sentence: `${steps.length === 1 ? 'One step' : `${steps.length} steps`} from rest: K ${ends((row) => row.K_um)} µm and T ${ends((row) => row.T_min)} min at ${ends((row) => row.power_end_W)} W.`,
        ...(r.superposition ? { more: `Over ${head.files[1] ?? 'the programme'} the correction differs from the simulation by ${number(r.superposition.rms_um, 3)} µm RMS.` } : {}),
      },
      [
        ['need two time constants', `${needed} of ${steps.length}`],
        ['largest residual with one', `${number(Math.max(...steps.map((s) => s.row.fit_rms_um ?? 0)), 2)} µm`],
        ...(steps.some((s) => hasTwo(s.row)) ? ([['largest residual with two', `${number(Math.max(...steps.map((s) => s.row.fit_rms_two_um ?? 0)), 2)} µm`]] as [string, string][]) : []),
        ...(r.cool_down ? ([['time constant at rest', `${number(r.cool_down.T_at_rest_min, 3)} min`]] as [string, string][]) : []),
      ],
    ),
    warnings,
    section('The steps', grid(steps.some((s) => s.time.length) ? courses(steps) : undefined, steps.some((s) => s.time.length) ? left(steps) : undefined)),
    section('The laws', grid(law(report, steps, 'K'), law(report, steps, 'T'), ...twoLags(steps))),
    loads.length ? section('The loads', grid(courses(loads, ofLoads), ...directions.flatMap((d) => overLoad(loads, d)))) : undefined,
    superposition(report),
    section(
      'The numbers',
      valueList(
        'Each step',
        ['step', 'P at the start [W]', 'at the end [W]', 'kinematic [µm]', 'K [µm]', 'T [min]', 'residual [µm]', 'K1 [µm]', 'T1 [min]', 'K2 [µm]', 'T2 [min]', 'residual [µm]', 'front force [N]', 'largest [N]'],
        rows.map((row) => [
          nameOf(row),
          ...[row.power_start_W, row.power_end_W, row.kinematic_um, row.K_um, row.T_min, row.fit_rms_um, row.K1_um, row.T1_min, row.K2_um, row.T2_min, row.fit_rms_two_um, row.front_force_N, row.highest_front_force_N].map((v, k) =>
            v === null ? dash : number(v, k === 5 || k === 10 ? 2 : 4),
          ),
        ]),
      ),
    ),
    notes(r.said),
  ];
}
