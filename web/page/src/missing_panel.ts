// What is missing: candidates that a click adds, the curves that move, what would tell candidates apart.
import { inWords, type Actions } from './actions';
import { axisTitle, capital, detectable, drawNew, el, field, FitView, grid, number, overSpeed, overTimeSection, plain, plan, printed, RecordView, unitOfKey, unitText, valueList } from './report';
import type { Result, State } from './state';
import { plainValue, valueOf } from './toml';
import { button, callout, type Panelled } from './view';
import type { AddReport, DiagnoseReport, Diagnosis, RankedEffect, Size, Suggested } from '../../../report/page/src/document';

const shownAtOnce = 10;

function sizes(parameters: Record<string, Size>): string {
  return Object.entries(parameters)
    .map(([name, p]) => {
      const unit = printed(unitText(p.unit));
      const doubt = p.at_bound ? ', at its bound' : p.plausible === false ? ', implausible' : '';
      return `${name.replace(/_/g, ' ').replace(/ Nmm$/, '')} ${number(p.value, 3)}${p.std === null ? '' : ` ± ${number(p.std, 2)}`}${unit ? ` ${unit}` : ''}${doubt}`;
    })
    .join('; ');
}

interface Candidate {
  id: string;
  on: boolean;
  rmse: number | undefined;
  held: number | null | undefined;
  gain: number | undefined;
  size: string;
  inVerdict: boolean;
  law: boolean;
}

function fromRanking(e: RankedEffect): Candidate {
  return { id: e.id, on: false, rmse: e.rmse, held: e.rmse_cross_validated ?? field(e, 'rmse_held_out_um') ?? field(e, 'rmse_held_out_urad'), gain: e.gain, size: sizes(e.parameters), inVerdict: e.in_verdict, law: e.id.startsWith('law:') };
}

/// Those that are on, then what the diagnosis of the model with them ranks, base laws in their place by error.
function candidates(s: State, result: Result): Candidate[] {
  const a = result.added?.results;
  const on = s.on.map((id): Candidate => {
    const own = Object.fromEntries(
      Object.entries(a?.calibration.parameters ?? {})
        .filter(([name]) => name.startsWith(`${id}.`))
        .map(([name, p]) => [name.slice(id.length + 1), p]),
    );
    return { id, on: true, rmse: a?.after.rmse, held: a?.rmse_held_out_after, gain: undefined, size: sizes(own), inVerdict: true, law: false };
  });
  // Where nothing more is missing none is ranked: then those of before, each alone.
  const rest = result.rest?.results.effects ?? [];
  const ranked = (rest.length ? rest : result.base.results.effects).filter((e) => !s.on.includes(e.id) && !e.id.startsWith('law:')).map(fromRanking);
  const list = [...on, ...ranked.map((c) => (rest.length || !s.on.length ? c : { ...c, inVerdict: false }))];
  const own = plainValue(valueOf(s.model?.text ?? '', 'friction', 'law') ?? 'palmgren');
  const current = s.law || own;
  for (const { law, rmse, held } of s.laws) {
    const c: Candidate = { id: `law:${law}`, on: current === law, rmse, held, gain: undefined, size: `instead of ${own}, without effects`, inVerdict: false, law: true };
    const at = list.findIndex((l) => !l.on && (l.rmse ?? 0) > rmse);
    list.splice(at < 0 || c.on ? (c.on ? 0 : list.length) : at, 0, c);
  }
  return list;
}

function row(c: Candidate, s: State, result: Result, actions: Actions): HTMLElement {
  const unit = unitOfKey(result.base.results.baseline.unit);
  const before = result.base.results.rmse_before;
  const noise = result.base.results.noise.rms;
  const most = 1.05 * Math.max(before, noise);
  const bar = el('span', { class: 'bar-now' });
  const line = el('span', { class: 'bar-noise' });
  bar.style.width = `${Math.min(100, (100 * (c.rmse ?? most)) / most)}%`;
  line.style.left = `${(100 * noise) / most}%`;
  const card = s.effects.get(c.id);
  const own = plainValue(valueOf(s.model?.text ?? '', 'friction', 'law') ?? 'palmgren');
  const press = () => void (c.law ? actions.takeLaw(c.on ? own : c.id.slice(4)) : actions.toggle(c.id));
  const b = el(
    'button',
    { type: 'button', role: 'switch', 'aria-checked': String(c.on), id: `candidate-${c.id}`, class: `candidate${c.inVerdict ? ' in-verdict' : ''}`, ...(card ? { title: `${capital(card.title)}. ${card.mechanism}` } : {}) },
    el('span', { class: 'switch', 'aria-hidden': 'true' }),
    el('span', { class: 'name' }, el('b', {}, capital(inWords(c.id))), el('span', { class: 'size' }, card?.title ?? c.size)),
    el('span', { class: 'bar-track', 'aria-hidden': 'true' }, bar, line),
    el('span', { class: 'number' }, `${number(c.rmse, 3)}`, el('span', { class: 'visually-hidden' }, ` ${unit} RMS error`)),
    el('span', { class: 'number held' }, c.held === null || c.held === undefined ? '–' : number(c.held, 3), el('span', { class: 'visually-hidden' }, ` ${unit} on held-out rows`)),
  );
  b.addEventListener('click', press);
  const li = el('li', {}, b);
  if (c.size && (c.on || c.inVerdict) && card) li.append(el('p', { class: 'fitted' }, c.size));
  return li;
}

function measureNext(d: Diagnosis): HTMLElement | undefined {
  const next = d.suggested_measurements;
  const needed = (d as unknown as { records_needed?: string[] }).records_needed ?? [];
  if (!next.length && !needed.length) return undefined;
  const inputs = Object.keys(next[0] ?? {}).filter((name) => typeof next[0]?.[name] === 'number' && axisTitle(name) !== name.replace(/_/g, ' '));
  return el(
    'div',
    { id: 'measure-next' },
    ...(next.length
      ? [
          valueList(
            'Measure next',
            [...inputs.map(axisTitle), 'repeats', 'distinguishes'],
            next.map((m: Suggested) => [...inputs.map((name) => plain(m[name] as number, 4)), String(m.repeats), m.separates.split(' / ').map(inWords).join(' or ')]),
          ),
        ]
      : []),
    ...needed.map((text) => callout('note', `Also record ${text}.`)),
  );
}

/// The curves that move: the model before and, where effects are on, with them.
function curves(result: Result, s: State): HTMLElement | undefined {
  const source = result.added ?? result.base;
  const name = s.on.length ? `with ${s.on.map(inWords).join(' and ')}` : `with ${(result.base.results.explanations[0] ?? []).map(inWords).join(' and ') || 'the candidate'}`;
  source.models.forEach((m, k) => (m.name = k === 0 ? 'no effect added' : name));
  if (source.kind === 'record') return source.models.some((m) => m.parts) ? overTimeSection(new RecordView(source, source.models.length - 1)) : undefined;
  const models = result.added ? source.models.slice(0, 2) : source.models.slice(0, 1);
  return overSpeed(new FitView({ ...source, models } as AddReport | DiagnoseReport, models.length - 1));
}

export function missingPanel(actions: Actions): Panelled {
  let all = false;
  return {
    needs: (s) => [s.result, s.laws, s.effects, s.problem, !s.result && s.model !== undefined && s.data.length > 0],
    make: (s) => {
      const problem =
        s.problem?.at === 'missing'
          ? callout(
              'error',
              el('span', {}, s.problem.text),
              button('Calculate again', () => void actions.evaluate(), { class: 'small' }),
            )
          : undefined;
      const { result } = s;
      if (!result)
        return [
          problem,
          el(
            'p',
            { class: 'quiet' },
            s.problem ? 'The verdict appears here when the error is corrected.' : s.model && s.data.length ? 'The candidates appear here in a moment.' : 'The candidates appear here when the data and the bearing are known.',
          ),
        ];
      const d = (result.rest ?? result.base).results;
      const list = candidates(s, result);
      const rows = el('ol', { class: 'candidates' });
      const fill = () => rows.replaceChildren(...(all ? list : list.filter((c, k) => k < shownAtOnce || c.law || c.on)).map((c) => row(c, s, result, actions)));
      fill();
      const more =
        list.length > shownAtOnce
          ? button(
              all ? 'Only the best' : `All ${list.length} candidates`,
              () => {
                all = !all;
                fill();
                if (more) more.textContent = all ? 'Only the best' : `All ${list.length} candidates`;
              },
              { class: 'small', id: 'all-candidates' },
            )
          : undefined;
      const unit = unitOfKey(d.baseline.unit);
      const diagnosed = result.rest ?? result.base;
      // Of a record over time these pictures stand in the step Compare.
      const view = diagnosed.kind === 'record' ? undefined : new FitView(diagnosed, 0);
      const planned = view && diagnosed.kind !== 'record' ? plan(diagnosed, view) : undefined;
      const next = d.suggested_measurements.length > 0;
      // Drawn when it is opened: a picture in a closed box has no width.
      const shows =
        view && diagnosed.kind !== 'record'
          ? el('details', { class: 'list' }, el('summary', {}, 'Smallest effects that these data would show, and measured points'), grid(next ? undefined : planned, detectable(diagnosed, view)))
          : undefined;
      shows?.addEventListener('toggle', drawNew);
      return [
        problem,
        s.law ? callout('note', `The law ${s.law} replaces the law of the model. Its parameters are fitted to the data and written into the improved model.`) : undefined,
        el(
          'div',
          { class: 'two' },
          el(
            'section',
            { class: 'list candidates-box' },
            el(
              'div',
              { class: 'head' },
              el('h3', {}, 'Candidates'),
              el(
                'span',
                { class: 'note' },
                `RMS error ${s.on.length && !result.rest?.results.effects.length ? 'with each candidate instead' : s.on.length ? 'with each candidate in addition' : 'with each candidate'}, all refitted [${unit}]`,
              ),
            ),
            el('p', { class: 'columns', 'aria-hidden': 'true' }, el('span', {}, 'click to add or remove'), el('span', { class: 'number' }, 'fit'), el('span', { class: 'number held' }, 'held out')),
            rows,
            ...(more ? [more] : []),
          ),
          el('div', { class: 'beside' }, ...[curves(result, s)].filter((f): f is HTMLElement => f !== undefined), ...[measureNext(d)].filter((f): f is HTMLElement => f !== undefined), ...(next && planned ? [planned.element] : [])),
        ),
        shows,
        d.not_testable.length
          ? el(
              'details',
              { class: 'list' },
              el('summary', {}, `These data cannot show ${d.not_testable.length} effects`),
              valueList(
                '',
                ['effect', 'why'],
                d.not_testable.map((n) => [inWords(n.id), printed(n.missing)]),
              ),
            )
          : undefined,
        d.said.length ? el('section', { class: 'list' }, el('h3', {}, 'Notes on these data'), el('ul', { class: 'said' }, ...d.said.map((n) => el('li', { 'data-kind': n.kind }, printed(n.text))))) : undefined,
      ];
    },
  };
}
