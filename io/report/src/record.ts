// The page of a record over time, of compare, diagnose, add and correct with a correction.
import { legend, sideAxis, threshold, valueAxis } from './chart';
import type { Comparison, Corrected, Diagnosis, RecordReport, Size } from './document';
import { Figure, tooltip } from './figure';
import { contributions, overTime, residualOverTime } from './over_time';
import { grid, header, notes, section } from './page';
import { RecordView } from './record_view';
import { steps } from './steps';
import { dash, el, number, plain, plainCeiling, shortPaths, signed, unitText, valueList } from './text';
import { verdicts } from './verdicts';

/// An error of the ladder [µm]; what is not known is null.
interface Rung {
  name: string;
  rms: number | null;
  held: number | null;
  note?: string;
}

interface Limits {
  tolerance: number | null;
  noise: number | null;
}

type Fields = Record<string, unknown>;

function field(of: object, name: string): number | null {
  const value = (of as Fields)[name];
  return typeof value === 'number' ? value : null;
}

function um(value: number | null | undefined): string {
  return value === null || value === undefined ? dash : `${number(value, 3)} µm`;
}

/// Errors of models or effects, against what is tolerated and what the sensor scatters.
function ladder(rungs: Rung[], { tolerance, noise }: Limits): Figure {
  const held = rungs.some((r) => r.held !== null);
  const names = ['on all readings', ...(held ? ['on parts that no fit saw'] : [])];
  const values = [rungs.map((r) => r.rms), ...(held ? [rungs.map((r) => r.held)] : [])];
  const most = Math.max(...values.flat().map((v) => v ?? 0));
  const lines = [...(tolerance === null ? [] : [`the tolerance, ${um(tolerance)}`]), ...(noise === null ? [] : [`the noise of the sensor, ${um(noise)}`])];
  return new Figure({
    id: 'ladder',
    title: rungs.length > 1 ? 'RMS error, one after the other' : 'RMS error',
    note: lines.length ? `Dashed: ${lines.join('; ')}.` : 'No tolerance was given, and the noise is not known.',
    wide: true,
    height: 92 + rungs.length * (held ? 44 : 34),
    onPaper: 0.62,
    option: (l, width) => {
      const top = legend(held ? names : [], width, l);
      const side = sideAxis(rungs.map((r) => r.name), l, width);
      // Two words beside each other would not be read.
      const apart = ((width - side.left - 56) * Math.abs((tolerance ?? 0) - (noise ?? 0))) / Math.max(most, tolerance ?? 0, noise ?? 0);
      const marks = [...(tolerance === null ? [] : [{ xAxis: tolerance, label: { formatter: 'tolerance' } }]), ...(noise === null ? [] : [{ xAxis: noise, label: { formatter: tolerance !== null && apart < 70 ? '' : 'noise' } }])];
      return {
        ...(held ? { legend: top.option } : {}),
        grid: { left: side.left, right: 56, top: top.height + 24, bottom: 42 },
        tooltip: tooltip(l, (hit) => {
          const r = rungs[hit.dataIndex];
          return r ? [r.name, ['on all readings', um(r.rms)], ...(held ? ([['on parts that no fit saw', um(r.held)]] as [string, string][]) : []), ...(r.note ? [r.note] : [])] : null;
        }),
        xAxis: valueAxis('RMS error [µm]', l, 'x', { scale: false, min: 0, ...(most < Math.max(tolerance ?? 0, noise ?? 0) ? { max: plainCeiling(Math.max(tolerance ?? 0, noise ?? 0)) } : {}) }),
        yAxis: side.option,
        series: names.map((name, k) => ({
          type: 'bar',
          name,
          barMaxWidth: held ? 14 : 20,
          itemStyle: { color: l.kinds[k], borderRadius: [0, 3, 3, 0], decal: k === 1 ? { symbol: 'rect', dashArrayX: [1, 0], dashArrayY: [2, 5], rotation: -0.7, color: 'rgba(255,255,255,0.35)' } : undefined },
          label: { show: true, position: 'right', color: l.ink, fontSize: 11, formatter: (hit: { value: number | null }) => (hit.value === null ? '' : number(hit.value, 3)) },
          data: values[k],
          ...(k === 0 && marks.length ? { markLine: { ...threshold(0, '', l), data: marks } } : {}),
        })),
      };
    },
    table: () => ({
      columns: ['', 'RMS [µm]', ...(held ? ['RMS on parts that no fit saw [µm]'] : []), 'over the tolerance', 'numbers'],
      rows: rungs.map((r) => [r.name, r.rms, ...(held ? [r.held] : []), tolerance === null ? null : ((r.held ?? r.rms) as number) / tolerance, r.note ?? '']),
    }),
  });
}

function sizes(parameters: Record<string, Size>): string {
  return Object.entries(parameters)
    .map(([name, p]) => `${name} = ${number(p.value, 3)}${p.std === null ? '' : ` ± ${number(p.std, 2)}`}${unitText(p.unit) ? ` ${unitText(p.unit)}` : ''}${p.at_bound ? ' (at its bound)' : ''}`)
    .join(', ');
}

/// The refitted model, the explanations of the verdict, then every other effect.
function rungsOf(d: Diagnosis): Rung[] {
  const of = (ids: string[], name: string): Rung => {
    const effects = d.effects.filter((e) => ids.includes(e.id));
    const first = effects[0];
    return { name, rms: first?.rmse ?? null, held: first ? field(first, 'rmse_held_out_um') : null, note: effects.map((e) => sizes(e.parameters)).join(', ') };
  };
  const sets = d.explanations.filter((ids) => d.effects.some((e) => ids.includes(e.id)));
  const told = sets.flat();
  return [
    { name: 'refitted, nothing added', rms: d.rmse_before, held: field(d, 'rmse_held_out_um') },
    ...sets.map((ids) => of(ids, `${ids.join(' and ')} (verdict)`)),
    ...d.effects.filter((e) => !told.includes(e.id)).map((e) => of([e.id], e.id)),
  ];
}

function where(c: Comparison): HTMLElement | undefined {
  if (!c.where.length) return undefined;
  const range = (from: number | string, to: number | string) => (from === to ? `${from}` : `${typeof from === 'number' ? plain(from, 4) : from} to ${typeof to === 'number' ? plain(to, 4) : to}`);
  return valueList(
    'Where it errs, the worst first',
    ['by', 'from, to', 'rows', 'RMS [µm]', 'mean [µm]'],
    c.where.map((w) => [w.variable.replace(/_/g, ' '), `${range(w.from, w.to)} ${w.unit}`.trim(), String(w.rows), number(w.rmse, 3), signed(w.bias, 3)]),
  );
}

/// What the page has of more rows than it holds, and how it draws them.
function thinned(view: RecordView): HTMLElement | undefined {
  const { rows, total } = view.report.rows;
  if (total <= 2000) return undefined;
  return el(
    'p',
    { class: 'note', id: 'thinned' },
    `${rows < total ? `This page holds ${rows} of ${total} rows: evenly spread, and the lowest and highest of every column in each stretch. ` : ''}Lines draw in each step of time, about a pixel wide, the first, the lowest, the highest and the last row, so that no extreme is lost; tables and CSV have every row of the page.`,
  );
}

function overTimeSection(view: RecordView): HTMLElement {
  return section('Over time', view.choices(view.report.command === 'correct' ? 'Displacement' : 'Model'), thinned(view), grid(overTime(view), contributions(view), residualOverTime(view)));
}

function lengthOf(view: RecordView): [string, string] {
  const hours = (view.hours[view.rows.count - 1] ?? 0) - (view.hours[0] ?? 0);
  return ['length', `${number(hours, 3)} h${view.report.runs.length > 1 ? `, ${view.report.runs.length} runs` : ''}`];
}

function compare(report: RecordReport & { command: 'compare' }): (Node | undefined)[] {
  const comparisons = 'models' in report.results ? report.results.models : [report.results];
  const last = comparisons[comparisons.length - 1] as Comparison;
  const files = shortPaths([...comparisons.map((c) => c.model), last.data]);
  report.models.forEach((m, k) => (m.name = files[k] as string));
  const view = new RecordView(report, comparisons.length - 1);
  const several = comparisons.length > 1;
  const limits = { tolerance: view.chosen.tolerance_um, noise: last.noise.rms };
  return [
    header(
      {
        command: 'compare',
        files,
        sentence: several ? `RMS error ${number((comparisons[0] as Comparison).rmse, 3)} → ${number(last.rmse, 3)} µm over ${comparisons.length} models.` : last.statement,
        ...(several ? { more: `${files[comparisons.length - 1]}: ${last.statement}` } : {}),
      },
      [['RMS error', um(last.rmse)], ['largest', um(last.max_abs)], ['tolerance', um(limits.tolerance)], ['noise of the sensor', um(limits.noise)], ['readings', String(last.rows)], lengthOf(view)],
    ),
    overTimeSection(view),
    section('The ladder', grid(ladder(comparisons.map((c, k) => ({ name: files[k] as string, rms: c.rmse, held: null })), limits)), where(last)),
    section('Step responses', grid(steps(view))),
    notes(report.results.notes),
  ];
}

function diagnose(report: RecordReport & { command: 'diagnose' }): (Node | undefined)[] {
  const d = report.results;
  const view = new RecordView(report, report.models.length - 1);
  const limits = { tolerance: view.chosen.tolerance_um, noise: d.noise.rms };
  const held = [field(d, 'rmse_held_out_um'), d.explanations.length ? field(d.effects[0] ?? {}, 'rmse_held_out_um') : null];
  return [
    header({ command: 'diagnose', files: shortPaths([d.model, d.data]), badge: verdicts[d.verdict] ?? [d.verdict, 'open'], sentence: d.headline, more: d.sentence }, [
      ['on parts that no fit saw', held[1] === null ? um(held[0]) : `${number(held[0], 3)} → ${um(held[1])}`],
      ['tolerance', um(limits.tolerance)],
      ['noise of the sensor', um(limits.noise)],
      ['readings', String(d.rows)],
      lengthOf(view),
    ]),
    section('The verdict', grid(ladder(rungsOf(d), limits))),
    overTimeSection(view),
    section('Step responses', grid(steps(view))),
    section(
      'What this record can show',
      valueList('Numbers of the model, without and with what is missing', ['number', 'without', 'with', 'std error', 'unit'], Object.entries(d.base_parameters).map(([name, p]) => [name, number(p.before), number(p.after), number(p.std, 2), unitText(p.unit)])),
      d.not_testable.length ? valueList('Could not have been found', ['effect', 'why'], d.not_testable.map((n) => [n.id, n.missing])) : undefined,
    ),
    notes([...d.messages, ...d.notes]),
  ];
}

function add(report: RecordReport & { command: 'add' }): (Node | undefined)[] {
  const r = report.results;
  const view = new RecordView(report, report.models.length - 1);
  const parameters = Object.entries(r.calibration.parameters);
  const limits = { tolerance: view.chosen.tolerance_um, noise: r.before.noise.rms };
  return [
    header(
      {
        command: 'add',
        files: shortPaths([r.model, r.data]),
        badge: r.refused ? ['refused', 'open'] : ['added', 'good'],
        sentence: r.refused ? `Refused: ${r.reason}.` : `On parts that no fit saw ${number(r.rmse_held_out_before, 3)} → ${um(r.rmse_held_out_after)}.`,
        more: r.after.statement,
      },
      [['RMS error', `${number(r.before.rmse, 3)} → ${um(r.after.rmse)}`], ['tolerance', um(limits.tolerance)], ['readings', String(r.after.rows)], lengthOf(view)],
    ),
    section(
      'What it bought',
      grid(ladder([{ name: 'before, refitted', rms: r.before.rmse, held: r.rmse_held_out_before }, { name: 'after', rms: r.after.rmse, held: r.rmse_held_out_after }], limits)),
      valueList('Parameters', ['parameter', 'value', 'std error', 'unit'], parameters.map(([name, p]) => [name, number(p.value), number(p.std, 2), unitText(p.unit)])),
    ),
    overTimeSection(view),
    section('Step responses', grid(steps(view))),
    notes([...r.messages, ...r.notes]),
  ];
}

function correct(report: RecordReport & { command: 'correct' }): (Node | undefined)[] {
  const r: Corrected = report.results;
  const axes = r.axes ?? [r];
  const view = new RecordView(report, 0);
  const read = axes.filter((a) => a.metrics.rmse_um !== null && a.metrics.readings > 0);
  const range = ([low, high]: [number | null, number | null]) => (low === null || high === null ? 'not all rows predicted' : `${number(low, 3)} to ${number(high, 3)} µm predicted`);
  return [
    header(
      {
        command: 'correct',
        files: shortPaths([r.model, r.data]),
        sentence: axes.map((a, k) => `${report.models[k]?.name ?? a.displacement}: ${range(a.predicted_range_um)}${a.metrics.readings > 0 ? `, ${um(a.metrics.rmse_um)} RMS left` : ''}.`).join(' '),
        ...(read.length ? { more: 'Left: predicted − measured when one constant is taken off, since the zero of a reading is arbitrary.' } : { more: 'Nothing was read: what is left is not known.' }),
      },
      [
        ['rows', String(r.rows)],
        ...(axes.length === 1 ? ([['readings', String(r.metrics.readings)], ['largest left', um(r.metrics.max_abs_um)], ['rows beyond the range', String(r.rows_beyond_range)]] as [string, string][]) : []),
        lengthOf(view),
      ],
    ),
    overTimeSection(view),
    read.length ? section('The error', grid(ladder(axes.map((a, k) => ({ name: report.models[k]?.name ?? a.displacement, rms: a.metrics.rmse_um, held: null })), { tolerance: view.chosen.tolerance_um, noise: null }))) : undefined,
    section('Step responses', grid(steps(view))),
    notes(r.messages),
  ];
}

/// What the models take for granted.
function taken(report: RecordReport): HTMLElement | undefined {
  const lines = report.models.map((m) => [m.name, m.displacement, m.initial_state === 'rest' ? 'from rest' : 'warm: found from the readings', m.defaults.length ? m.defaults.map((d) => d.replace(' (default)', '')).join('; ') : 'none']);
  return el('div', { id: 'assumed' }, section('What the model takes for granted', valueList('Beginning and defaults', ['model', 'displacement', 'a run begins', 'defaults used'], lines)));
}

export function record(report: RecordReport): (Node | undefined)[] {
  const content = () => {
    switch (report.command) {
      case 'compare':
        return compare(report);
      case 'diagnose':
        return diagnose(report);
      case 'add':
        return add(report);
      case 'correct':
        return correct(report);
    }
  };
  return [...content(), taken(report)];
}
