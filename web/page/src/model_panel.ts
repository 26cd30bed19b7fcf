// The model: a designation and an oil make it; each key has its field, and the text stays in step.
import { baseLaws, type Actions } from './actions';
import { grades } from './oil';
import { capital, el, plain } from './report';
import type { Key, State } from './state';
import { assumedIn, channelsOf, entries, isCorrection, plainValue, quoted, valueOf, withValue, type Entry } from './toml';
import { button, callout, type Panelled } from './view';

const words: Record<string, string> = { bearing: 'Bearing', lubricant: 'Lubricant', friction: 'Friction', rig: 'Rig', solver: 'Solver', calibration: 'Calibration', loop: 'Loop', life: 'Life' };
const hidden = /^(effect|columns|calibration\.covariance|correction)/;

const unitWords = (unit: string | null): string => (unit ?? '').replace('mm2/s', 'mm²/s').replace('um', 'µm').replace(/^deg$/, '°').replace(/^C$/, '°C');

/// Whether a key belongs to such a model: to its law, to balls or to rollers.
function applies(only: string | null, text: string): boolean {
  const law = valueOf(text, 'friction', 'law') ?? 'palmgren';
  const rollers = valueOf(text, 'bearing', 'type') === 'cylindrical-roller';
  return (only ?? '').split(', ').every((part) => (part === 'of cylindrical rollers' ? rollers : part.startsWith('law ') ? part === `law ${law}` : part === ''));
}

function rangeWords(key: Key): string {
  const unit = unitWords(key.unit);
  if (key.choices.length) return '';
  const parts = [key.from, key.to].map((v) => (v === null ? '' : plain(v, 4)));
  return parts[0] || parts[1] ? `${parts[0]} … ${parts[1]}${unit ? ` ${unit}` : ''}` : unit;
}

/// "ball_diameter_mm" as "Ball diameter": the unit stands behind the field. Symbols stay as they are.
function nameOf(key: Key): string {
  const bare = key.unit ? key.key.replace(/_(mm2_s|[A-Za-z0-9]+|1_GPa|N_um|kg_m3|W_mK)$/, '') : key.key;
  if (/^[A-Za-z]\d?$|^(mu|K)_/.test(key.key)) return key.key;
  return capital(bare.replace(/_/g, ' ').replace(/ (\d+)C$/, ' at $1 °C'));
}

function field(key: Key, entry: Entry | undefined, assumed: boolean, s: State, actions: Actions): HTMLElement {
  const id = `key-${key.table}-${key.key}`;
  const text = s.model?.text ?? '';
  const shown = entry ? plainValue(entry.value) : '';
  const set = (value: string) => {
    if (value === shown) return;
    const plainText = key.kind === 'text' && !/^\d/.test(value) ? quoted(value) : key.kind === 'text' ? quoted(value) : value.trim().replace(/^(-?\d+),(\d+)$/, '$1.$2');
    void actions.editModel(withValue(text, key.table, key.key, value === '' ? undefined : plainText), `${key.key} ${value === '' ? 'left out' : `= ${value}`}`);
  };
  let input: HTMLInputElement | HTMLSelectElement;
  if (key.choices.length) {
    input = el('select', { id, 'aria-describedby': `${id}-note` });
    if (!entry) input.append(el('option', { value: '' }, key.default ? `default: ${key.default}` : 'not given'));
    for (const choice of [...new Set([...(entry ? [shown] : []), ...key.choices])]) input.append(el('option', { value: choice }, choice));
    input.value = shown;
  } else {
    input = el('input', { id, type: 'text', ...(key.kind === 'number' ? { inputmode: 'decimal', class: 'number' } : {}), 'aria-describedby': `${id}-note`, placeholder: key.default ?? '', autocomplete: 'off' });
    input.value = shown;
  }
  const change = () => set(input.value);
  input.addEventListener('change', change);
  return el(
    'div',
    { class: `field${assumed ? ' assumed' : ''}` },
    el('label', { for: id }, nameOf(key)),
    el('span', { class: 'entry' }, input, el('span', { class: 'of-unit' }, unitWords(key.unit))),
    el(
      'p',
      { class: 'note', id: `${id}-note` },
      ...(assumed ? [el('span', { class: 'mark' }, /^estimated/.test(entry?.comment ?? '') ? 'estimated' : 'assumed'), ' '] : []),
      `${entry?.comment && assumed ? `${entry.comment.replace(/^(assumed|estimated): */, '').replace(/^assumed$/, '')}. `.replace(/^\. /, '') : ''}${rangeWords(key)}${rangeWords(key) ? ': ' : ''}${key.meaning}`,
    ),
  );
}

/// Three answers make a model.
function designation(s: State, actions: Actions): HTMLElement {
  const name = el('input', { type: 'text', id: 'designation', autocomplete: 'off', spellcheck: 'false', placeholder: '7014 AC' });
  const oil = el('input', { type: 'text', id: 'oil', list: 'grades', autocomplete: 'off', placeholder: 'VG 32' });
  const load = el('input', { type: 'text', id: 'preload', inputmode: 'decimal', size: '8', placeholder: 'as measured' });
  name.value = s.designation;
  oil.value = s.oil;
  const make = () => void (name.value.trim() && actions.designate(name.value.trim(), oil.value, load.value));
  const form = el(
    'form',
    { class: 'designation' },
    el('label', {}, el('span', {}, 'Designation of the bearing'), name),
    el('label', {}, el('span', {}, 'Oil, ISO VG grade'), oil),
    el('label', {}, el('span', {}, 'Preload [N], where the data have no axial load'), load),
    el('datalist', { id: 'grades' }, ...grades.map((g) => el('option', { value: g }))),
    el('button', { type: 'submit', class: 'primary', id: 'make-model' }, s.model ? 'Make a new model' : 'Make the model'),
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    make();
  });
  return form;
}

export function modelPanel(actions: Actions, change: (part: Partial<State>) => void): Panelled {
  let typing = 0;
  return {
    needs: (s) => [s.model, s.keys, s.problem, s.toml, s.law, s.modelNotes, s.channel],
    make: (s) => {
      const problem = s.problem?.at === 'model' ? callout('error', s.problem.text) : undefined;
      const form = el(
        'section',
        { class: 'list' },
        el('h3', {}, s.model ? 'Another bearing' : 'Which bearing was measured?'),
        designation(s, actions),
        el('p', { class: 'note' }, 'As 7014 C, 7014 AC, HCB7014 or S 6014 C; the catalogue or its rules fill in the rest. Or drop a model file (TOML).'),
      );
      if (!s.model) {
        const at = document.activeElement;
        if (!at || !/^(INPUT|TEXTAREA|SELECT)$/.test(at.tagName)) setTimeout(() => document.getElementById('designation')?.focus(), 0);
        return [problem, form];
      }
      const text = s.model.text;
      const all = entries(text).filter((e) => !hidden.test(e.table) && e.index === 0 && e.table !== '');
      const assumed = assumedIn(text);
      const tables = [...new Set(all.map((e) => e.table))];
      const own = valueOf(text, 'friction', 'law') ?? 'palmgren';
      const current = s.law || own;
      const law = el('div', { class: 'segments', role: 'group', 'aria-label': 'Base law' }, ...baseLaws.map((l) => button(l, () => void actions.takeLaw(l), { id: `law-${l}`, 'aria-pressed': String(l === current) })));
      const keyOf = (table: string, key: string) => s.keys.find((k) => k.table === table && k.key === key && applies(k.only, text));
      const groups = tables.map((table) => {
        const here = all.filter((e) => e.table === table && !(table === 'friction' && e.key === 'law'));
        const fields = here.flatMap((e) => {
          const key = keyOf(table, e.key);
          return key ? [field(key, e, assumed.has(`${table}.${e.key}`), s, actions)] : [];
        });
        const others = s.keys.filter(
          (k, at) =>
            k.table === table &&
            applies(k.only, text) &&
            k.key !== 'law' &&
            !here.some((e) => e.key === k.key) &&
            s.keys.findIndex((other) => other.table === table && other.key === k.key && applies(other.only, text)) === at &&
            k.kind !== 'table',
        );
        return el(
          'section',
          { class: 'list' },
          el('h3', {}, words[table] ?? capital(table)),
          ...(table === 'friction' ? [el('p', { class: 'law' }, el('span', { class: 'note' }, 'Base law '), law)] : []),
          el('div', { class: 'fields' }, ...fields),
          ...(others.length ? [el('details', {}, el('summary', {}, `${others.length} more keys`), el('div', { class: 'fields' }, ...others.map((k) => field(k, undefined, false, s, actions))))] : []),
        );
      });
      const area = el('textarea', { id: 'toml', rows: '28', spellcheck: 'false', 'aria-label': 'Text of the model, TOML', 'data-scroll': 'toml' });
      area.value = text;
      area.addEventListener('input', () => {
        clearTimeout(typing);
        typing = window.setTimeout(() => void actions.editModel(area.value, 'text of the model'), 500);
      });
      const toml = el('details', { class: 'list', ...(s.toml ? { open: '' } : {}) }, el('summary', {}, `Text of ${s.model.name} (TOML)`), area);
      toml.addEventListener('toggle', () => toml.open !== s.toml && change({ toml: toml.open }));
      const correction = isCorrection(text);
      const channels = channelsOf(text);
      const choice = el('select', { id: 'channel', 'aria-label': 'Displacement in question' }, ...channels.map((c) => el('option', { value: c }, c)));
      choice.value = s.channel;
      choice.addEventListener('change', () => void actions.takeChannel(choice.value));
      const lags = correction
        ? el(
            'section',
            { class: 'list', id: 'lags' },
            el('h3', {}, 'Lags from the record'),
            ...(channels.length ? [el('p', { class: 'choice' }, el('span', {}, 'Displacement'), choice)] : []),
            el('p', { class: 'note' }, 'Gains and time constants of each channel, chosen by the error on parts of the record that no fit saw.'),
            el(
              'p',
              { class: 'actions' },
              button('Find the lags of these channels', () => void actions.identify(false), { id: 'identify', class: 'primary' }),
              button('Take all sensors, each through a bank of lags', () => void actions.identify(true), { id: 'identify-bank' }),
            ),
          )
        : undefined;
      const count = assumed.size;
      return [
        problem,
        correction ? undefined : form,
        ...s.modelNotes.map((note) => callout('doubt', note)),
        count ? callout('doubt', el('b', {}, `${count} values are assumed or estimated`), ': they are marked below. Put in what you know better.') : undefined,
        lags,
        toml,
        ...groups,
      ];
    },
  };
}
