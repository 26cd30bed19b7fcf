// Builds the page from the document inside it: one function for each command that writes reports.
import { deflection } from './deflection';
import { detectable, effectNodes, plan, ranking } from './diagnosis';
import { readDocument, Rows } from './document';
import type { AddReport, ColumnData, CompareReport, Comparison, DiagnoseReport, Diagnosis, DisplacementReport, Report, TableReport } from './document';
import { drawAll } from './figure';
import { notTestableList, parameterList } from './fit_lists';
import { choices, drawnNote, FitView, misfitMap, parity, residuals } from './fit_rows';
import { drawnSpeeds } from './line_figure';
import { modes } from './modes';
import { overSpeed } from './over_speed';
import { beforeAfter, changes, ladder, nearest, nearestWords, noiseSources } from './ladder';
import type { Floor } from './ladder';
import { grid, header, judgedBadge, notes, section, warnings } from './page';
import { record } from './record';
import { lawFigures, shaftFigures } from './shaft';
import { spindleRun } from './spindle_run';
import { spindleSteady } from './spindle_steady';
import { stepResponses } from './step_responses';
import { tableFigures } from './stribeck';
import { capital, dash, el, number, plain, probability, shortPaths, signed, unitText, valueList, withUnit } from './text';
import { verdicts } from './verdicts';

const page = document.getElementById('page') as HTMLElement;

/// The pictures of rows, with the choices that they share.
function fitSection(view: FitView): HTMLElement {
  const thinning = drawnNote(view);
  return section('Agreement and residuals', others(view), choices(view), thinning ? el('p', { class: 'note', id: 'thinned' }, thinning) : undefined, grid(parity(view), ...residuals(view), misfitMap(view)));
}

/// Says what else was measured: the pictures are of one channel.
function others(view: FitView): HTMLElement | undefined {
  const { other_channels: words = [] } = view.report;
  return words.length ? el('p', { class: 'note', id: 'others' }, `This page does not draw other measured quantities: ${words.join(', ')}. The JSON results have all channels.`) : undefined;
}

/// What does not matter to whoever uses the model, and the error on rows left out that it is held against.
function toleranceFacts(d: Diagnosis, { unit, key }: FitView): [string, string][] {
  const [tolerance, held] = [`tolerance_${key}`, `rmse_held_out_${key}`].map((name) => (d as unknown as Record<string, unknown>)[name]);
  if (typeof tolerance !== 'number') return [];
  return [
    ['tolerance', `${number(tolerance, 3)} ${unit}`],
    ['on held-out rows', typeof held === 'number' ? `${number(held, 3)} ${unit}` : dash],
  ];
}

/// A diagnosis estimates the noise, unless the torques of a coast-down brought theirs.
function sourceIn(baseline: Comparison): string {
  return baseline.noise.source === 'regression' ? 'regression' : 'estimated';
}

function floorOf({ unit, key }: FitView, noise: number | null, source: string): Floor {
  return { noise, source: noiseSources[source] ?? source, unit, key };
}

function lackOfFit(c: Comparison): [string, string][] {
  return c.lack_of_fit.p_value === null ? [] : [['p-value of the misfit', probability(c.lack_of_fit.p_value)]];
}

function compare(report: CompareReport): (Node | undefined)[] {
  const comparisons = 'models' in report.results ? report.results.models : [report.results];
  const best = nearest(comparisons);
  const shown = comparisons[best] as Comparison;
  const first = comparisons[0] as Comparison;
  const files = shortPaths([...comparisons.map((c) => c.model), shown.data]);
  report.models.forEach((m, k) => (m.name = files[k] as string));
  const several = comparisons.length > 1;
  const view = new FitView(report, best);
  const { unit } = view;
  const comparedOverSpeed = overSpeed(view);
  const estimated = first.noise.rms === null && shown.noise.estimated_rms !== undefined;
  const noise = first.noise.rms ?? shown.noise.estimated_rms ?? null;
  const source = estimated ? 'estimated' : first.noise.source;
  const floor = noise === null ? '' : `; noise ${number(noise, 3)} ${unit}${estimated ? ', estimated' : ''}`;
  const steps = report.steps.map((step, k) => [files[k + 1] as string, number(comparisons[k + 1]?.rmse), signed((comparisons[k + 1]?.rmse as number) - (comparisons[k]?.rmse as number)), changes(step)]);
  return [
    header({ command: 'compare', files, sentence: several ? `${nearestWords(files, comparisons, unit)}${floor}.` : shown.statement, ...(several ? { more: `${files[best]}: ${shown.statement}` } : {}) }, [
      ['RMS error', `${number(shown.rmse)} ${unit}`],
      ['mean error', `${number(shown.bias, 3)} ${unit}`],
      [noise === null ? 'noise' : `noise, ${source}`, noise === null ? 'not known' : `${number(noise, 3)} ${unit}`],
      ['rows', String(shown.rows)],
      ...lackOfFit(shown),
    ]),
    comparedOverSpeed ? section(`${capital(view.report.quantity.in_words)} over speed`, grid(comparedOverSpeed)) : undefined,
    section(
      several ? 'Errors of the models' : 'The error',
      grid(
        ladder(
          files.slice(0, -1),
          comparisons.map((c) => c.rmse),
          comparisons.map((c) => c.bias),
          comparisons.map((c) => c.fit_percent),
          floorOf(view, noise, source),
        ),
      ),
      several ? el('div', { id: 'steps' }, valueList('Changes from model to model: effects and fitted parameters', ['model', `RMS error [${unit}]`, `change [${unit}]`, 'what changed'], steps)) : undefined,
    ),
    fitSection(view),
    notes(report.results.said),
  ];
}

function diagnose(report: DiagnoseReport): (Node | undefined)[] {
  const d = report.results;
  const view = new FitView(report, 0);
  const { unit } = view;
  const effects = d.explanations.length && report.models.length > 1 ? (d.explanations[0] as string[]) : [];
  const floor = floorOf(view, d.noise.rms, sourceIn(d.baseline));
  const formula = Object.entries(d.shape ?? {}).find(([name]) => name.endsWith(`_${view.key}`));
  const nodes = effectNodes(report, view);
  return [
    header({ command: 'diagnose', files: shortPaths([d.model, d.data]), badge: verdicts[d.verdict] ?? [d.verdict, 'open'], sentence: d.headline, more: d.sentence }, [
      ['RMS error', d.rmse_after < d.rmse_before ? `${number(d.rmse_before, 3)} → ${number(d.rmse_after, 3)} ${unit}` : `${number(d.rmse_before, 3)} ${unit}`],
      [`noise, ${sourceIn(d.baseline)}`, `${number(d.noise.rms, 3)} ${unit}`],
      ['rows', String(d.rows)],
      ['p-value of the misfit', probability(d.p_value)],
      ...toleranceFacts(d, view),
      ...(effects.length ? ([['p-value of the remaining misfit', probability(d.remaining_p_value)]] as [string, string][]) : []),
    ]),
    section(
      'The verdict',
      grid(
        effects.length || d.hold_out.length
          ? beforeAfter(d.rmse_before, d.rmse_after, d.hold_out, floor, ['refitted, no effect added', effects.length ? `with ${effects.join(' and ')}` : 'with the most similar effect'])
          : ladder(['refitted, no effect added'], [d.rmse_before], [d.baseline.bias], [d.baseline.fit_percent], floor),
        d.effects.length ? ranking(report, view) : undefined,
      ),
    ),
    d.shape
      ? section(
          'Shape of the misfit',
          el('p', {}, d.shape.statement),
          formula ? el('pre', {}, `${formula[0]} = "${formula[1]}"`) : undefined,
          valueList(
            'Coefficients',
            ['name', 'value', 'std error', 'unit'],
            Object.entries(d.shape.coefficients).map(([name, c]) => [name, number(c.value), number(c.std, 2), unitText(c.unit)]),
          ),
        )
      : undefined,
    nodes.length ? section('Contribution of an effect', ...nodes) : undefined,
    fitSection(view),
    section('What these data can show', grid(plan(report, view), detectable(report, view)), notTestableList(d)),
    notes(d.said),
  ];
}

function add(report: AddReport): (Node | undefined)[] {
  const r = report.results;
  const names = Object.keys(r.calibration.parameters);
  const effects = [...new Set(names.map((name) => name.split('.')[0] as string).filter((id) => names.some((name) => name.startsWith(`${id}.`))))];
  const files = shortPaths([r.model, r.data]);
  const view = new FitView(report, 1);
  const held = r.rmse_held_out_after === null ? '' : `; on held-out rows ${number(r.rmse_held_out_before, 3)} → ${number(r.rmse_held_out_after, 3)}`;
  const change = `error ${number(r.before.rmse, 3)} → ${number(r.after.rmse, 3)} ${view.unit}${held}`;
  return [
    header({ command: 'add', files, badge: r.refused ? ['refused', 'open'] : ['added', 'good'], sentence: r.refused ? `${effects.join(' and ')} refused: ${r.reason}.` : `${effects.join(' and ')}: ${change}.`, more: r.after.statement }, [
      ['RMS error', `${number(r.before.rmse, 3)} → ${number(r.after.rmse, 3)} ${view.unit}`],
      [`noise, ${sourceIn(r.before)}`, report.noise_rms === null ? 'not known' : `${number(report.noise_rms, 3)} ${view.unit}`],
      ['rows', String(r.after.rows)],
    ]),
    section('Improvement', grid(beforeAfter(r.before.rmse, r.after.rmse, r.hold_out, floorOf(view, report.noise_rms, sourceIn(r.before)), ['before, refitted', 'after'])), parameterList('Parameters', r.calibration.parameters)),
    fitSection(view),
    notes(r.said),
  ];
}

function table(report: TableReport): (Node | undefined)[] {
  const { model, bearing } = report.results;
  const thinned = report.rows.rows < report.rows.total ? `This page contains ${report.rows.rows} of ${report.rows.total} points, evenly spread.` : '';
  return [
    header({ command: 'table', files: shortPaths(report.data ? [model, report.data] : [model]), badge: judgedBadge(undefined, report.judged ?? []), sentence: `Friction torque of ${bearing}`, ...(thinned ? { more: thinned } : {}) }, [
      ['points', String(report.rows.total)],
      ['contact angle', `${plain(report.results.contact_angle_deg, 4)}°`],
    ]),
    warnings(report.judged ?? []),
    section('Results over speed', grid(...tableFigures(report))),
  ];
}

function displacement(report: DisplacementReport): (Node | undefined)[] {
  const rows = new Rows(report.rows);
  const { bearing, arrangement } = report.results;
  const { law } = report;
  let last = rows.count - 1;
  while (last >= 0 && !Number.isFinite(rows.at('axial_displacement_um', last))) --last;
  const lost = (load: number | null) => (load === null ? dash : `${plain(load, 4)} N`);
  return [
    header(
      {
        command: 'displacement',
        files: shortPaths([report.model]),
        badge: judgedBadge(undefined, report.judged ?? []),
        sentence: last < 0 ? `No position of the shaft on ${bearing}.` : `Shaft on ${bearing}: ${signed(rows.at('axial_displacement_um', last), 4)} µm at ${plain(rows.at('speed_rpm', last))} rpm, positive towards the tool.`,
        ...(report.warnings.length ? {} : { more: 'No bearing loses its inner contacts or falls below its minimum load at these speeds.' }),
      },
      [
        ['preload at standstill', `${plain(arrangement.preload_N, 4)} N`],
        ['external load', withUnit(rows.at('external_load_N', 0), 'external_load_N')],
        ['front set loses contact at', lost(arrangement.front_lift_off_load_N)],
        ['rear set loses contact at', lost(arrangement.rear_lift_off_load_N)],
        ['lubricant', withUnit(rows.at('temperature_C', 0), 'temperature_C')],
        ['speeds', String(report.rows.total)],
      ],
    ),
    warnings(report.warnings),
    section(
      'Displacement and the kinematic law',
      thinning(report.rows, 'speeds', drawnSpeeds),
      grid(...lawFigures(report, rows)),
      el('p', { class: 'note', id: 'law-statement' }, report.law_statement),
      law ? parameterList('The law: u = A n^(1 − B exp(−C n)), u in µm, n in rpm', law.parameters, 5) : undefined,
    ),
    section('The bearings against speed', grid(...shaftFigures(report, rows))),
    notes(law?.said ?? []),
  ];
}

/// What a page of many rows leaves out.
function thinning(data: ColumnData, what: string, drawn: number): HTMLElement | undefined {
  const text = [
    data.rows < data.total ? `This page contains ${data.rows} of ${data.total} ${what}, evenly spread. The fit and the warnings use all of them.` : '',
    data.rows > drawn ? `Pictures draw about ${drawn} of ${data.rows} ${what}; the CSV has all of them.` : '',
  ]
    .join(' ')
    .trim();
  return text ? el('p', { class: 'note', id: 'thinned' }, text) : undefined;
}

function build(report: Report): (Node | undefined)[] {
  switch (report.kind) {
    case 'compare':
      return compare(report);
    case 'diagnose':
      return diagnose(report);
    case 'add':
      return add(report);
    case 'table':
      return table(report);
    case 'displacement':
      return displacement(report);
    case 'record':
      return record(report);
    case 'modes':
      return modes(report);
    case 'deflection':
      return deflection(report);
    case 'steps':
      return stepResponses(report);
    case 'spindle_run':
      return spindleRun(report);
    case 'spindle_steady':
      return spindleSteady(report);
  }
}

/// Assumptions of each model: its law with the factors, its oil, and its defaults.
function assumed(report: Report): HTMLElement | undefined {
  if (report.assumed.length === 0) return undefined;
  const files = shortPaths(report.assumed.map((m) => m.model));
  const lines = report.assumed.map((m, k) => [
    files[k] as string,
    m.bearing,
    `${m.law}: ${m.factors.map((f) => `${f.name} = ${plain(f.value, 4)}${f.unit === '1' ? '' : ` ${unitText(f.unit)}`}`).join(', ')}`,
    m.effects.length ? m.effects.join(', ') : 'none',
    `${plain(m.viscosity_40C_mm2_s, 4)} mm²/s at 40 °C, ${plain(m.viscosity_100C_mm2_s, 4)} at 100 °C`,
    m.defaults.length ? m.defaults.join('; ') : 'none',
  ]);
  return el('div', { id: 'assumed' }, section('Assumptions of the model', valueList('Law, oil and defaults', ['model', 'bearing', 'law and parameters', 'effects', 'oil', 'defaults used'], lines)));
}

function show(report: Report): void {
  const parts = [...build(report), assumed(report)].filter((node): node is Node => node !== undefined);
  page.append(...parts, el('footer', {}, `${report.program}. ${'models' in report ? 'Residuals are predicted − measured. ' : ''}This page needs no network.`));
  drawAll();
}

show(readDocument());
