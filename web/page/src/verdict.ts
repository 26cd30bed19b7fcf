// The verdict above all steps: the sentence, the error against the noise, and the button that mends it.
import { alone, heldOut, inWords, judgedErrors, type Actions } from './actions';
import { examples } from './example';
import { el, field, number, printed, probability, unitOfKey, verdicts } from './report';
import { designation } from './model_panel';
import { spindleHead } from './spindle_panels';
import type { Result, State, Trust } from './state';
import { isCorrection } from './toml';
import { button, callout, Part, type Shown } from './view';

interface Errors {
  before: number;
  now: number;
}

/// RMS errors without effects and as it is, in the fit and on rows left out; of a record that is fitted to in part on what follows.
export function errors({ base, added, before: start, ...result }: Result, until: string): { fit: Errors; held: Errors | undefined; noise: number; unit: string } {
  const d = base.results;
  const a = added?.results;
  const fit = { before: start ?? d.rmse_before, now: a?.after.rmse ?? d.rmse_before };
  const [noise, unit] = [d.noise.rms, unitOfKey(d.baseline.unit)];
  if (until) return { fit, held: judgedErrors({ base, ...result }), noise, unit };
  const before = a?.rmse_held_out_before ?? heldOut(d.hold_out) ?? field(d, 'rmse_held_out_um') ?? field(d, 'rmse_held_out_urad') ?? undefined;
  const now = a?.rmse_held_out_after ?? before;
  return { fit, held: before === undefined || now === undefined ? undefined : { before, now }, noise, unit };
}

/// Bars that move where they stand, so that they are seen to fall.
class ErrorBars implements Shown {
  private readonly rows = ['in the fit', 'on held-out rows'].map((label) => {
    const bar = el('div', { class: 'bar-now' });
    const ghost = el('div', { class: 'bar-before' });
    const noise = el('div', { class: 'bar-noise' });
    const value = el('span', { class: 'bar-value number' });
    const words = el('span', { class: 'bar-label' }, label);
    return { bar, ghost, noise, value, words, element: el('div', { class: 'bar-row' }, words, el('div', { class: 'bar-track', 'aria-hidden': 'true' }, ghost, bar, noise), value) };
  });
  private readonly legend = el('p', { class: 'bar-legend' });
  private seen: unknown[] = [];

  constructor(private readonly element: HTMLElement) {
    element.append(el('h2', { class: 'bars-title' }, 'RMS error compared with the noise'), ...this.rows.map((r) => r.element), this.legend);
  }

  update({ result, on, problem, until }: State): void {
    this.element.hidden = !result;
    if (!result || (result === this.seen[0] && on === this.seen[1])) return;
    this.seen = [result, on];
    const { fit, held, noise, unit } = errors(result, until);
    // What was clicked a moment ago: the diagnosis knows the error with one effect, and without any.
    const added = on.length === 1 ? result.base.results.effects.find((e) => e.id === on[0]) : undefined;
    const clicked = problem || result.before !== undefined || on === result.on ? undefined : on.length === 0 ? fit.before : added?.rmse;
    if (clicked !== undefined) fit.now = clicked;
    if (clicked !== undefined && held && !until) held.now = added?.rmse_cross_validated ?? held.before;
    const most = 1.08 * Math.max(fit.before, held?.before ?? 0, fit.now, held?.now ?? 0, noise);
    const share = (value: number) => `${(100 * value) / most}%`;
    [fit, held].forEach((e, k) => {
      const row = this.rows[k];
      if (!row) return;
      if (k === 1) row.words.textContent = until ? `after ${until.replace(/(\d)([a-z])/, '$1\u00a0$2')}, not fitted` : 'on held-out rows';
      row.element.hidden = !e;
      if (!e) return;
      row.bar.style.width = share(e.now);
      row.ghost.style.width = share(e.before);
      row.noise.style.left = share(noise);
      row.value.textContent = e.now === e.before ? `${number(e.now, 3)} ${unit}` : `${number(e.before, 3)} → ${number(e.now, 3)} ${unit}`;
    });
    this.legend.textContent = `Vertical line: noise of the data, ${number(noise, 3)} ${unit}.`;
  }
}

const trustWords: Record<Trust['verdict'], [string, string]> = { good: ['good', 'good'], 'within-range': ['only inside its range', 'open'], 'do-not-use': ['do not use', 'bad'], unknown: ['not known', 'open'] };

/// How far a correction may be trusted, as the command says it.
export function trustLine(trust: Trust): HTMLElement {
  const [words, kind] = trustWords[trust.verdict];
  return el('p', { class: 'trust', id: 'trust' }, el('span', {}, 'Trust in this correction '), el('span', { class: `badge ${kind}` }, words), ...(trust.because ? [el('span', { class: 'note' }, printed(trust.because))] : []));
}

/// Data without a model: the step Model has the same fields.
const asksBearing = (s: State): boolean => s.reading !== undefined && s.confirmed && !s.model && s.problem?.at !== 'data' && s.panel !== 'model';

export function verdict(head: HTMLElement, actions: Actions): Shown[] {
  const words = el('div', { class: 'words' });
  const bars = el('div', { class: 'bars', id: 'error-bars' });
  const bearing = el('div', { class: 'asked-bearing' });
  head.append(words, bearing, bars);
  const part = new Part(
    words,
    (s) => [s.result, s.on, s.problem, s.stale, s.job === undefined, s.model, s.data, s.example, s.confirmed, s.panel === 'data' || s.panel === 'model', s.at > 0, s.machine, alone(s) && s.panel],
    (s) => {
      const problem =
        s.problem && s.panel !== s.problem.at
          ? callout(
              'error',
              el('span', {}, s.problem.text),
              button('Show', () => actions.show(s.problem?.at ?? 'data'), { class: 'small' }),
            )
          : undefined;
      if (alone(s)) return [problem, ...spindleHead(s)];
      const { result } = s;
      if (!result) {
        const next = !s.data.length
          ? 'Drop a file with measured friction torque: CSV, or a table pasted from a spreadsheet.'
          : !s.confirmed
            ? 'Check the columns.'
            : s.problem
              ? s.problem.at === 'data'
                ? 'The data cannot be read in this form.'
                : 'No verdict yet.'
              : !s.model
                ? 'Which bearing was measured? Type its designation.'
                : 'Calculating …';
        return [problem, el('h1', { id: 'sentence' }, next)];
      }
      const shown = s.on.length ? result.rest : result.base;
      const d = (shown ?? result.base).results;
      const on = s.on.map(inWords).join(' and ');
      const [badge, kind] = s.on.length && !shown ? ['refitted', 'open'] : (verdicts[d.verdict] ?? [d.verdict, 'open']);
      const { fit, unit } = errors(result, s.until);
      const sentence = !s.on.length ? d.headline : shown ? `With ${on}: ${d.headline.slice(0, 1).toLowerCase()}${d.headline.slice(1)}` : `With ${on}: error ${number(fit.before, 3)} → ${number(fit.now, 3)} ${unit}`;
      const sets = d.explanations.filter((set) => set.some((id) => !s.on.includes(id))).slice(0, 3);
      const laws = (id: string) => id.startsWith('law:');
      const adds = sets.map((set, k) =>
        button(`Add ${set.map(inWords).join(' and ')}`, () => void actions.turnOn(set), { class: k === 0 || d.verdict === 'ambiguous' ? 'primary' : '', id: `add-${k}`, ...(set.some(laws) ? { title: 'Uses this base law' } : {}) }),
      );
      const removes = s.on.map((id) => button(`Remove ${inWords(id)}`, () => void actions.toggle(id), { id: `remove-${id}` }));
      const lags =
        isCorrection(s.model?.text ?? '') && !s.start && d.verdict !== 'nothing-missing' && !s.on.length
          ? [button('Find the lags of all sensors', () => void actions.identify(true), { class: 'primary', id: 'find-lags', title: 'Bank of lags for every sensor: identify --lags auto' })]
          : [];
      const refused = result.refused
        ? callout(
            'doubt',
            el('span', {}, `The program refuses this effect: ${printed(result.refused)}.`),
            button('Add it anyway', () => void actions.force(), { class: 'small', id: 'force' }),
          )
        : undefined;
      return [
        problem,
        el('p', { class: 'eyebrow' }, s.example ? examples[s.example].eyebrow : s.data.map((f) => f.name).join(', ')),
        el('span', { class: `badge ${kind}`, id: 'verdict' }, badge),
        result.recorded
          ? el('span', { class: 'badge open', id: 'stale' }, 'recorded when this page was made; the calculation is running')
          : s.stale
            ? el('span', { class: 'badge open', id: 'stale' }, s.job ? 'updating' : 'previous case')
            : undefined,
        el('h1', { id: 'sentence' }, printed(sentence)),
        result.trust && !s.stale ? trustLine(result.trust) : undefined,
        refused,
        el(
          'p',
          { class: 'actions' },
          ...lags,
          ...(result.refused ? removes : [...(s.on.length && d.verdict === 'nothing-missing' ? [] : adds), ...removes]),
          ...(s.at > 0 ? [button('Undo', () => void actions.back(s.at - 1), { id: 'undo-here', title: 'One step back (Ctrl+Z)' })] : []),
        ),
        el(
          'details',
          { class: 'why' },
          el('summary', {}, 'Why, in numbers'),
          el('p', {}, printed(d.sentence)),
          el('p', {}, `p-value of the misfit: ${probability(d.p_value)}. Rows: ${d.rows}. Explanations tried: ${d.candidates_tried}. Gain needed: ${number(d.needed_gain, 3)}.`),
        ),
      ];
    },
  );
  const asked = new Part(
    bearing,
    (s) => [asksBearing(s)],
    (s) => (asksBearing(s) ? [designation(s, actions)] : []),
  );
  return [part, asked, new ErrorBars(bars)];
}
