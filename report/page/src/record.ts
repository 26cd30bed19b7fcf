// The page of a record over time, of compare, diagnose, add and correct with a correction.
import type { Comparison, Corrected, CorrectedAxis, Diagnosis, RecordReport } from './document';
import { notTestableList, parameterList, shiftList } from './fit_lists';
import { grid, header, notes, section } from './page';
import { field, inUnit, ladder, lengthOf, overTimeSection, sizes, unitKey } from './record_parts';
import type { Rung } from './record_parts';
import { RecordView } from './record_view';
import { spindleRecord } from './spindle_record';
import { steps } from './steps';
import { el, number, plain, shortPaths, signed, unitOfKey, valueList } from './text';
import { verdicts } from './verdicts';

/// The refitted model, the explanations of the verdict, then every other effect.
function rungsOf(d: Diagnosis, heldOut: string): Rung[] {
  const of = (ids: string[], name: string): Rung => {
    const effects = d.effects.filter((e) => ids.includes(e.id));
    const first = effects[0];
    return { name, rms: first?.rmse ?? null, held: first ? field(first, heldOut) : null, note: effects.map((e) => sizes(e.parameters)).join(', ') };
  };
  const sets = d.explanations.filter((ids) => d.effects.some((e) => ids.includes(e.id)));
  const told = sets.flat();
  return [{ name: 'refitted, no effect added', rms: d.rmse_before, held: field(d, heldOut) }, ...sets.map((ids) => of(ids, `${ids.join(' and ')} (verdict)`)), ...d.effects.filter((e) => !told.includes(e.id)).map((e) => of([e.id], e.id))];
}

function where(c: Comparison, unit: string): HTMLElement | undefined {
  if (!c.where.length) return undefined;
  const range = (from: number | string, to: number | string) => (from === to ? `${from}` : `${typeof from === 'number' ? plain(from, 4) : from} to ${typeof to === 'number' ? plain(to, 4) : to}`);
  return valueList(
    'Errors by range, largest first',
    ['by', 'from, to', 'rows', `RMS [${unit}]`, `mean [${unit}]`],
    c.where.map((w) => [w.variable.replace(/_/g, ' '), `${range(w.from, w.to)} ${w.unit}`.trim(), String(w.rows), number(w.rmse, 3), signed(w.bias, 3)]),
  );
}

function compare(report: RecordReport & { command: 'compare' }): (Node | undefined)[] {
  const comparisons = 'models' in report.results ? report.results.models : [report.results];
  const last = comparisons[comparisons.length - 1] as Comparison;
  const files = shortPaths([...comparisons.map((c) => c.model), last.data]);
  report.models.forEach((m, k) => (m.name = files[k] as string));
  const view = new RecordView(report, comparisons.length - 1);
  const um = (value: number | null | undefined) => inUnit(value, view.unit);
  const several = comparisons.length > 1;
  const limits = { tolerance: view.chosen.tolerance, noise: last.noise.rms };
  return [
    header(
      {
        command: 'compare',
        files,
        sentence: several ? `RMS error ${number((comparisons[0] as Comparison).rmse, 3)} → ${um(last.rmse)} over ${comparisons.length} models.` : last.statement,
        ...(several ? { more: `${files[comparisons.length - 1]}: ${last.statement}` } : {}),
      },
      [['RMS error', um(last.rmse)], ['largest', um(last.max_abs)], ['tolerance', um(limits.tolerance)], ['noise of the sensor', um(limits.noise)], ['readings', String(last.rows)], lengthOf(view)],
    ),
    overTimeSection(view),
    section(
      'Errors of the models',
      grid(
        ladder(
          comparisons.map((c, k) => ({ name: files[k] as string, rms: c.rmse, held: null })),
          limits,
          view.unit,
        ),
      ),
      where(last, view.unit),
    ),
    section('Step responses', grid(steps(view))),
    notes(report.results.said),
  ];
}

function diagnose(report: RecordReport & { command: 'diagnose' }): (Node | undefined)[] {
  const d = report.results;
  const view = new RecordView(report, report.models.length - 1);
  const limits = { tolerance: view.chosen.tolerance, noise: d.noise.rms };
  const um = (value: number | null | undefined) => inUnit(value, view.unit);
  const heldOut = `rmse_held_out_${view.chosen.unit}`;
  const held = [field(d, heldOut), d.explanations.length ? field(d.effects[0] ?? {}, heldOut) : null];
  return [
    header({ command: 'diagnose', files: shortPaths([d.model, d.data]), badge: verdicts[d.verdict] ?? [d.verdict, 'open'], sentence: d.headline, more: d.sentence }, [
      ['on held-out parts', held[1] === null ? um(held[0]) : `${number(held[0], 3)} → ${um(held[1])}`],
      ['tolerance', um(limits.tolerance)],
      ['noise of the sensor', um(limits.noise)],
      ['readings', String(d.rows)],
      lengthOf(view),
    ]),
    section('The verdict', grid(ladder(rungsOf(d, heldOut), limits, view.unit))),
    overTimeSection(view),
    section('Step responses', grid(steps(view))),
    section('What this record can show', shiftList(d), notTestableList(d)),
    notes(d.said),
  ];
}

function add(report: RecordReport & { command: 'add' }): (Node | undefined)[] {
  const r = report.results;
  const view = new RecordView(report, report.models.length - 1);
  const limits = { tolerance: view.chosen.tolerance, noise: r.before.noise.rms };
  const um = (value: number | null | undefined) => inUnit(value, view.unit);
  return [
    header(
      {
        command: 'add',
        files: shortPaths([r.model, r.data]),
        badge: r.refused ? ['refused', 'open'] : ['added', 'good'],
        sentence: r.refused ? `Refused: ${r.reason}.` : `On held-out parts ${number(r.rmse_held_out_before, 3)} → ${um(r.rmse_held_out_after)}.`,
        more: r.after.statement,
      },
      [['RMS error', `${number(r.before.rmse, 3)} → ${um(r.after.rmse)}`], ['tolerance', um(limits.tolerance)], ['readings', String(r.after.rows)], lengthOf(view)],
    ),
    section(
      'Improvement',
      grid(
        ladder(
          [
            { name: 'before, refitted', rms: r.before.rmse, held: r.rmse_held_out_before },
            { name: 'after', rms: r.after.rmse, held: r.rmse_held_out_after },
          ],
          limits,
          view.unit,
        ),
      ),
      parameterList('Parameters', r.calibration.parameters),
    ),
    overTimeSection(view),
    section('Step responses', grid(steps(view))),
    notes(r.said),
  ];
}

function correct(report: RecordReport & { command: 'correct' }): (Node | undefined)[] {
  const r: Corrected = report.results;
  const axes = r.axes ?? [r];
  const view = new RecordView(report, 0);
  const unitOf = (a: CorrectedAxis) => unitOfKey(unitKey(a.displacement));
  const error = (a: CorrectedAxis, name: string) => field(a.metrics, `${name}_${unitKey(a.displacement)}`);
  const read = axes.filter((a) => error(a, 'rmse') !== null && a.metrics.readings > 0);
  const range = (a: CorrectedAxis) => {
    const [low, high] = (a as unknown as Record<string, [number | null, number | null]>)[`predicted_range_${unitKey(a.displacement)}`] ?? [null, null];
    return low === null || high === null ? 'not all rows predicted' : `${number(low, 3)} to ${number(high, 3)} ${unitOf(a)} predicted`;
  };
  return [
    header(
      {
        command: 'correct',
        files: shortPaths([r.model, r.data]),
        sentence: axes.map((a, k) => `${report.models[k]?.name ?? a.displacement}: ${range(a)}${a.metrics.readings > 0 ? `, ${inUnit(error(a, 'rmse'), unitOf(a))} RMS residual` : ''}.`).join(' '),
        ...(read.length ? { more: 'Residual: predicted − measured, minus one constant, because the zero of a reading is arbitrary.' } : { more: 'The record has no readings, so the residual is not known.' }),
      },
      [
        ['rows', String(r.rows)],
        ...(axes.length === 1
          ? ([
              ['readings', String(r.metrics.readings)],
              ['largest residual', inUnit(error(r, 'max_abs'), unitOf(r))],
              ['rows beyond the range', String(r.rows_beyond_range)],
            ] as [string, string][])
          : []),
        lengthOf(view),
      ],
    ),
    overTimeSection(view),
    read.length
      ? section(
          'The error',
          grid(
            ...[...new Set(axes.map(unitOf))].map((unit, n) =>
              ladder(
                axes.flatMap((a, k) => (unitOf(a) === unit ? [{ name: report.models[k]?.name ?? a.displacement, rms: error(a, 'rmse'), held: null }] : [])),
                { tolerance: unit === view.unit ? view.chosen.tolerance : null, noise: null },
                unit,
                undefined,
                n === 0 ? 'ladder' : `ladder_${n}`,
              ),
            ),
          ),
        )
      : undefined,
    section('Step responses', grid(steps(view))),
    notes(r.said),
  ];
}

/// What the models take for granted.
function taken(report: RecordReport): HTMLElement | undefined {
  const lines = report.models.map((m) => [m.name, m.displacement, m.initial_state === 'rest' ? 'from rest' : 'warm, fitted to the readings', m.defaults.length ? m.defaults.join('; ') : 'none']);
  return el('div', { id: 'assumed' }, section('Assumptions of the model', valueList('Initial state and defaults', ['model', 'displacement', 'a run begins', 'defaults used'], lines)));
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
  return report.models.some((m) => m.parts) || report.models.length === 0 ? [...content(), taken(report)] : spindleRecord(report);
}
