// The page of a record of a spindle: all channels together, of compare, diagnose and add.
import { barStyle, legend, sideAxis, threshold, valueAxis } from './chart';
import type { Comparison, Diagnosis, RecordReport } from './document';
import type { Cell } from './figure';
import { Figure, tooltip } from './figure';
import { notTestableList, parameterList, shiftList } from './fit_lists';
import { changes } from './ladder';
import { grid, header, notes, section } from './page';
import { inUnit, ladder, lengthOf, overTimeSection, sizes } from './record_parts';
import type { Rung } from './record_parts';
import { RecordView } from './record_view';
import { el, number, plain, shortPaths, signed, valueList } from './text';
import { verdicts } from './verdicts';

const times = 'times the tolerance';
const togetherNote = 'All channels together: root mean square of the errors, each divided by its tolerance. Dashed: tolerance.';

/// A number whose name ends with a unit: tolerance_um, tolerance_K.
function withAnyUnit(of: object, name: string): number | null {
  const found = Object.entries(of).find(([key, value]) => key.startsWith(`${name}_`) && typeof value === 'number');
  return found ? (found[1] as number) : null;
}

/// One channel with an error of each kind: of models one after the other, or before and after.
interface Row {
  channel: string;
  unit: string;
  tolerance: number | null;
  noise: number | null;
  errors: (number | null)[];
}

const words = (quantity: string) => quantity.replace(/_/g, ' ');
const unitOf = (unit: string) => (unit === 'C' ? 'K' : unit === 'um' ? 'µm' : unit);

/// Of all channels together: the root of the mean square of errors over their tolerances.
function together(errors: (number | null)[], tolerances: (number | null)[]): number | null {
  const shares = errors.flatMap((e, k) => (e === null || !tolerances[k] ? [] : [(e / (tolerances[k] as number)) ** 2]));
  return shares.length ? Math.sqrt(shares.reduce((sum, s) => sum + s, 0) / shares.length) : null;
}

/// Errors of each channel in multiples of what is tolerated there, so that micrometres and kelvins stand beside each other.
function channelBars(rows: Row[], names: string[]): Figure {
  return new Figure({
    id: 'channels',
    title: 'RMS error of each channel',
    note: 'In multiples of the tolerance of the channel, which combines the noise of its sensor and the expected error of the model. The labels at the bars have the unit of the channel.',
    wide: true,
    height: 96 + rows.length * (14 + 16 * names.length),
    onPaper: 0.7,
    option: (l, width) => {
      const top = legend(
        names.length > 1 ? names : [],
        width,
        l,
        names.map(() => 'rect'),
      );
      const side = sideAxis(
        rows.map((r) => r.channel),
        l,
        width,
      );
      const share = (r: Row, k: number) => (r.errors[k] === null || r.errors[k] === undefined || !r.tolerance ? null : (r.errors[k] as number) / r.tolerance);
      return {
        ...(names.length > 1 ? { legend: top.option } : {}),
        grid: { left: side.left, right: 64, top: top.height + 24, bottom: 42 },
        tooltip: tooltip(l, (hit) => {
          const r = rows[hit.dataIndex];
          return r ? [r.channel, ...names.map((name, k): [string, string] => [name, inUnit(r.errors[k], r.unit)]), ['tolerance', inUnit(r.tolerance, r.unit)], ['noise of the sensor', inUnit(r.noise, r.unit)]] : null;
        }),
        xAxis: valueAxis('RMS error over the tolerance', l, 'x', { scale: false, min: 0 }),
        yAxis: side.option,
        series: names.map((name, k) => ({
          type: 'bar',
          name,
          barMaxWidth: 15,
          itemStyle: barStyle(l.kinds[k % l.kinds.length], k === 2 && names.length === 3 ? 'wide' : 'none'),
          label: {
            show: true,
            position: 'right',
            color: l.ink,
            fontSize: 11,
            textBorderColor: l.surface,
            textBorderWidth: 3,
            formatter: (hit: { dataIndex: number }) => inUnit(rows[hit.dataIndex]?.errors[k], rows[hit.dataIndex]?.unit ?? ''),
          },
          data: rows.map((r) => share(r, k)),
          ...(k === 0 ? { markLine: threshold(1, 'tolerance', l) } : {}),
        })),
      };
    },
    table: () => ({ columns: ['channel', 'unit', ...names.map((name) => `RMS, ${name}`), 'tolerance', 'noise'], rows: rows.map((r): Cell[] => [r.channel, r.unit, ...names.map((_, k) => r.errors[k] ?? null), r.tolerance, r.noise]) }),
  });
}

const channelsOf = (c: Comparison): Comparison[] => c.channels ?? [c];

function where(channels: Comparison[]): HTMLElement | undefined {
  const range = (from: number | string, to: number | string) => (from === to ? `${from}` : `${typeof from === 'number' ? plain(from, 4) : from} to ${typeof to === 'number' ? plain(to, 4) : to}`);
  const rows = channels.flatMap((c) =>
    c.where.slice(0, 3).map((w) => [words(c.quantity), words(w.variable), `${range(w.from, w.to)} ${w.unit}`.trim(), String(w.rows), inUnit(w.rmse, unitOf(c.unit)), `${signed(w.bias, 3)} ${unitOf(c.unit)}`]),
  );
  return rows.length ? valueList('Largest errors of each channel', ['channel', 'by', 'from, to', 'rows', 'RMS', 'mean'], rows) : undefined;
}

function compare(report: RecordReport & { command: 'compare' }): (Node | undefined)[] {
  const comparisons = 'models' in report.results ? report.results.models : [report.results];
  const last = comparisons[comparisons.length - 1] as Comparison;
  const files = shortPaths([...comparisons.map((c) => c.model), last.data]);
  // Of each model its channels, one after the other.
  const count = channelsOf(last).length;
  report.models.forEach((m, k) => (m.name = files[Math.floor(k / count)] ?? m.name));
  const view = new RecordView(report, (comparisons.length - 1) * count);
  const rows = channelsOf(last).map((c, k): Row => ({ channel: words(c.quantity), unit: unitOf(c.unit), tolerance: withAnyUnit(c, 'tolerance'), noise: c.noise.rms, errors: comparisons.map((m) => channelsOf(m)[k]?.rmse ?? null) }));
  const tolerances = rows.map((r) => r.tolerance);
  const all = comparisons.map((_, k) =>
    together(
      rows.map((r) => r.errors[k] ?? null),
      tolerances,
    ),
  );
  const within = rows.filter((r) => r.tolerance !== null && (r.errors[comparisons.length - 1] ?? Infinity) <= r.tolerance).length;
  const names = files.slice(0, -1);
  const several = comparisons.length > 1;
  return [
    header(
      {
        command: 'compare',
        files,
        sentence: `${within} of ${count} channels within their tolerance${several ? ` with ${names[names.length - 1]}` : ''}; all together ${all.map((v) => number(v, 3)).join(' → ')} ${times}.`,
        more: last.statement,
      },
      [...channelsOf(last).map((c): [string, string] => [words(c.quantity), inUnit(c.rmse, unitOf(c.unit))]), ['readings', String(last.rows)], lengthOf(view)],
    ),
    section(
      several ? 'Errors of the models' : 'The error',
      grid(
        several
          ? ladder(
              names.map((name, k): Rung => ({ name, rms: all[k] ?? null, held: null })),
              { tolerance: 1, noise: null },
              times,
              togetherNote,
            )
          : undefined,
        channelBars(rows, names),
      ),
      several
        ? el(
            'div',
            { id: 'steps' },
            valueList(
              'Changes from model to model: effects and fitted parameters',
              ['model', 'all channels', 'what changed'],
              report.steps.map((step, k) => [names[k + 1] ?? '', `${number(all[k + 1], 3)} ${times}`, changes(step)]),
            ),
          )
        : undefined,
    ),
    overTimeSection(view),
    section('Largest errors', where(channelsOf(last))),
    notes(report.results.said),
  ];
}

/// What a diagnosis says of a channel, without and with its verdict.
function rowsOf(d: Diagnosis, explained: boolean): Row[] {
  return (d.channels ?? []).map((c): Row => ({
    channel: words(c.quantity),
    unit: unitOf(c.unit),
    tolerance: withAnyUnit(c, 'tolerance'),
    noise: c.noise.rms,
    errors: [c.rmse_before, ...(explained ? [c.rmse_after] : []), withAnyUnit(c, 'rmse_held_out')],
  }));
}

/// The refitted model, the explanations of the verdict, then every other effect, all channels together.
function rungsOf(d: Diagnosis, tolerances: (number | null)[]): Rung[] {
  const of = (ids: string[], name: string): Rung => {
    const effects = d.effects.filter((e) => ids.includes(e.id));
    const channels = effects[0]?.channels ?? [];
    return {
      name,
      rms: together(
        channels.map((c) => c.rmse),
        tolerances,
      ),
      held: together(
        channels.map((c) => c.rmse_cross_validated),
        tolerances,
      ),
      note: effects.map((e) => sizes(e.parameters)).join(', '),
    };
  };
  const sets = d.explanations.filter((ids) => d.effects.some((e) => ids.includes(e.id)));
  const told = sets.flat();
  const before = d.channels ?? [];
  return [
    {
      name: 'refitted, no effect added',
      rms: together(
        before.map((c) => c.rmse_before),
        tolerances,
      ),
      held: together(
        before.map((c) => withAnyUnit(c, 'rmse_held_out')),
        tolerances,
      ),
    },
    ...sets.map((ids) => of(ids, `${ids.join(' and ')} (verdict)`)),
    ...d.effects.filter((e) => !told.includes(e.id)).map((e) => of([e.id], e.id)),
  ];
}

function diagnose(report: RecordReport & { command: 'diagnose' }): (Node | undefined)[] {
  const d = report.results;
  const count = (d.channels ?? []).length || 1;
  const view = new RecordView(report, report.models.length - count);
  const explained = d.explanations.length > 0;
  const rows = rowsOf(d, explained);
  const rungs = rungsOf(
    d,
    rows.map((r) => r.tolerance),
  );
  const held = rungs
    .slice(0, explained ? 2 : 1)
    .map((r) => number(r.held, 3))
    .join(' → ');
  return [
    header({ command: 'diagnose', files: shortPaths([d.model, d.data]), badge: verdicts[d.verdict] ?? [d.verdict, 'open'], sentence: d.headline, more: d.sentence }, [
      ['on held-out parts', `${held} ${times}`],
      ['channels', String(count)],
      ['readings', String(d.rows)],
      lengthOf(view),
    ]),
    section(
      'The verdict',
      grid(
        channelBars(rows, ['refitted, no effect added', ...(explained ? [`with ${(d.explanations[0] ?? []).join(' and ')}`] : []), 'no effect added, held-out parts']),
        rungs.length > 1 ? ladder(rungs, { tolerance: 1, noise: null }, times, togetherNote) : undefined,
      ),
    ),
    overTimeSection(view),
    section('What this record can show', shiftList(d), notTestableList(d)),
    notes(d.said),
  ];
}

function add(report: RecordReport & { command: 'add' }): (Node | undefined)[] {
  const r = report.results;
  const [before, after] = [channelsOf(r.before), channelsOf(r.after)];
  const view = new RecordView(report, report.models.length - (before.length || 1));
  const rows = before.map((c, k): Row => ({ channel: words(c.quantity), unit: unitOf(c.unit), tolerance: withAnyUnit(c, 'tolerance'), noise: c.noise.rms, errors: [c.rmse, after[k]?.rmse ?? null] }));
  const tolerances = rows.map((row) => row.tolerance);
  const both = [0, 1].map((k) =>
    number(
      together(
        rows.map((row) => row.errors[k] ?? null),
        tolerances,
      ),
      3,
    ),
  );
  return [
    header(
      {
        command: 'add',
        files: shortPaths([r.model, r.data]),
        badge: r.refused ? ['refused', 'open'] : ['added', 'good'],
        sentence: r.refused ? `Refused: ${r.reason}.` : `All channels together ${both.join(' → ')} ${times}.`,
        more: r.after.statement,
      },
      [...after.map((c, k): [string, string] => [words(c.quantity), `${number(before[k]?.rmse, 3)} → ${inUnit(c.rmse, unitOf(c.unit))}`]), lengthOf(view)],
    ),
    section('Improvement', grid(channelBars(rows, ['before, refitted', 'after'])), parameterList('Parameters', r.calibration.parameters)),
    overTimeSection(view),
    notes(r.said),
  ];
}

export function spindleRecord(report: RecordReport): (Node | undefined)[] {
  switch (report.command) {
    case 'compare':
      return compare(report);
    case 'diagnose':
      return diagnose(report);
    case 'add':
      return add(report);
    case 'correct':
      return [];
  }
}
