// The model: a designation and an oil make it; each key has its field, and the text stays in step.
import { alone, baseLaws, type Actions } from './actions';
import { withCatalogue } from './catalogue';
import { capital, el, plain, printed } from './report';
import { doubled, pieces, withoutPiece, withPiece } from './shaft_pieces';
import { crossSection } from './spindle_panels';
import type { Key, State } from './state';
import { assumedIn, channelsOf, entries, isCorrection, isSpindle, plainValue, quoted, valueOf, withValue, type Entry } from './toml';
import { button, callout, Part, type Panelled } from './view';

/// ISO VG grades that the command takes.
const grades = [5, 7, 10, 15, 22, 32, 46, 68, 100, 150, 220];

const words: Record<string, string> = {
  bearing: 'Bearing',
  lubricant: 'Lubricant',
  friction: 'Friction',
  rig: 'Rig',
  solver: 'Solver',
  calibration: 'Calibration',
  loop: 'Loop',
  life: 'Life',
  arrangement: 'Arrangement and preload',
  shaft: 'Shaft',
  housing: 'Housing',
  seat: 'Seats and fits',
  coolant: 'Coolant',
  ambient: 'Surroundings',
  sensor: 'Sensor',
  heat: 'Heat sources',
  spindle: 'Spindle',
};
const hidden = /^(effect|columns|calibration\.covariance|correction|shaft\.segment)/;

/// Tables of a spindle whose defaults hold where the text has none of them.
const ofEverySpindle = ['seat', 'ambient'];

const unitWords = (unit: string | null): string => (unit ?? '').replace('mm2/s', 'mm²/s').replace('m2 K', 'm² K').replace('um', 'µm').replace(/^deg$/, '°').replace(/^C$/, '°C');

/// Whether a key belongs to such a model: to its law, to balls or to rollers.
function applies(only: string | null, text: string): boolean {
  const law = valueOf(text, 'friction', 'law') ?? 'palmgren';
  const rollers = valueOf(text, 'bearing', 'type') === 'cylindrical-roller';
  return (only ?? '').split(', ').every((part) => (part === 'cylindrical rollers' ? rollers : part === 'spindle' ? isSpindle(text) : part.startsWith('law ') ? part === `law ${law}` : part === ''));
}

function rangeWords(key: Key): string {
  const unit = unitWords(key.unit);
  if (key.choices.length) return '';
  const parts = [key.from, key.to].map((v) => (v === null ? '' : plain(v, 4)));
  return parts[0] || parts[1] ? `${parts[0]} … ${parts[1]}${unit ? ` ${unit}` : ''}` : unit;
}

/// "ball_diameter_mm" as "Ball diameter": the unit stands behind the field. Symbols stay as they are.
function nameOf(key: Key): string {
  // "W/(m2 K)" is W_m2K in names.
  const unit = (key.unit ?? (key.kind === 'list' ? 'mm' : '')).replace(/[()\s-]/g, '').replace('/', '_');
  const bare = unit && key.key.endsWith(`_${unit}`) ? key.key.slice(0, -unit.length - 1) : key.unit ? key.key.replace(/_(mm2_s|[A-Za-z0-9]+|1_GPa|N_um|kg_m3|W_mK)$/, '') : key.key;
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
    el('span', { class: 'entry' }, input, el('span', { class: 'of-unit' }, unitWords(key.unit ?? (/_mm$/.test(key.key) ? 'mm' : null)))),
    el(
      'p',
      { class: 'note', id: `${id}-note` },
      ...(assumed ? [el('span', { class: 'mark' }, /^estimated/.test(entry?.comment ?? '') ? 'estimated' : 'assumed'), ' '] : []),
      `${entry?.comment && assumed ? `${entry.comment.replace(/^(assumed|estimated): */, '').replace(/^assumed$/, '')}. `.replace(/^\. /, '') : ''}${rangeWords(key)}${rangeWords(key) ? ': ' : ''}${key.meaning}`,
    ),
  );
}

/// Three answers make a model.
export function designation(s: State, actions: Actions): HTMLElement {
  const spindle = alone(s);
  const name = el('input', { type: 'text', id: 'designation', autocomplete: 'off', spellcheck: 'false', placeholder: '7014 AC' });
  const oil = el('input', { type: 'text', id: 'oil', list: 'grades', autocomplete: 'off', placeholder: 'VG 32' });
  const load = el('input', { type: 'text', id: 'preload', inputmode: 'decimal', size: '8', placeholder: spindle ? 'from its rating' : 'as measured' });
  name.value = s.designation;
  oil.value = s.oil;
  const make = () => void (name.value.trim() && actions.designate(name.value.trim(), oil.value, load.value, spindle));
  const form = el(
    'form',
    { class: 'designation' },
    withCatalogue('Designation of the bearing', name, actions),
    el('label', {}, el('span', {}, 'Oil, ISO VG grade'), oil),
    el('label', {}, el('span', {}, spindle ? 'Preload as mounted [N]' : 'Preload [N], if the data have no axial load'), load),
    el('datalist', { id: 'grades' }, ...grades.map((grade) => el('option', { value: `VG ${grade}` }))),
    el('button', { type: 'submit', class: 'primary', id: 'make-model' }, spindle ? 'Make a spindle with three of these bearings' : s.model ? 'Make a new model' : 'Make the model'),
  );
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    make();
  });
  return form;
}

/// The shaft from the nose to the rear, piece by piece.
function shaftTable(text: string, actions: Actions): HTMLElement | undefined {
  const all = pieces(text);
  if (!all.length) return undefined;
  const columns: [string, string][] = [
    ['length_mm', 'length [mm]'],
    ['diameter_mm', 'diameter [mm]'],
    ['bore_mm', 'bore [mm]'],
  ];
  const rows = all.map(({ keys }, k) => {
    const cells = columns.map(([key, words]) => {
      const input = el('input', {
        type: 'text',
        inputmode: 'decimal',
        class: 'number',
        size: '7',
        id: `piece-${k}-${key}`,
        'aria-label': `Piece ${k + 1}, ${words}`,
        placeholder: key === 'bore_mm' ? (valueOf(text, 'shaft', 'bore_mm') ?? '') : '',
      });
      input.value = keys.get(key)?.value ?? '';
      input.addEventListener('change', () => void actions.editModel(withPiece(text, k, key, input.value.trim().replace(',', '.')), `piece ${k + 1}: ${key} = ${input.value.trim()}`));
      return el('td', {}, input);
    });
    const twice = button('Add', () => void actions.editModel(doubled(text, k), `piece ${k + 1} twice`), { class: 'small', id: `piece-${k}-add`, 'aria-label': `Add a piece like piece ${k + 1} behind it` });
    const out = button('Remove', () => void actions.editModel(withoutPiece(text, k), `piece ${k + 1} removed`), {
      class: 'small',
      id: `piece-${k}-remove`,
      'aria-label': `Remove piece ${k + 1}`,
      ...(all.length < 2 ? { disabled: '' } : {}),
    });
    return el('tr', {}, el('td', { class: 'number' }, String(k + 1)), ...cells, el('td', {}, twice, ' ', out));
  });
  const head = [...['piece', ...columns.map(([, words]) => words)].map((words) => el('th', { scope: 'col', class: 'number' }, words)), el('td', {})];
  return el('div', { class: 'scroll wide', tabindex: '0' }, el('table', { class: 'pieces' }, el('thead', {}, el('tr', {}, ...head)), el('tbody', {}, ...rows)));
}

/// Values that the model does not give: `check` lists them with those that the model marks as assumed, whose fields show it.
function defaults(): Part {
  return new Part(
    el('div', { id: 'defaults' }),
    (s) => [s.reading?.defaults, s.model],
    (s) => {
      const marked = assumedIn(s.model?.text ?? '');
      const list = (s.reading?.defaults ?? []).filter((line) => !marked.has((line.split(' = ')[0] as string).replace(/\[\d+\]/g, '')));
      if (!list.length) return [];
      return [el('details', { class: 'list' }, el('summary', {}, `${list.length} more values are not in the model: their defaults apply`), el('ul', { class: 'said' }, ...list.map((line) => el('li', {}, printed(line)))))];
    },
  );
}

export function modelPanel(actions: Actions, change: (part: Partial<State>) => void): Panelled {
  let typing = 0;
  return {
    needs: (s) => [s.model, s.data.length === 0, s.keys, s.problem, s.toml, s.law, s.modelNotes, s.channel],
    make: (s) => {
      const problem = s.problem?.at === 'model' ? callout('error', s.problem.text) : undefined;
      const spindle = alone(s);
      const form = el(
        'section',
        { class: 'list' },
        el('h3', {}, spindle ? 'Start from a template: a spindle on three bearings' : s.model ? 'Another bearing' : 'Which bearing was measured?'),
        designation(s, actions),
        el(
          'p',
          { class: 'note' },
          spindle
            ? 'For example S 6010 E or 7014 C. The page marks the numbers that the template assumes. You can also drop a model file (TOML).'
            : 'For example 7014 C, 7014 AC, HCB7014 or S 6014 C. The other values come from the catalogue or are estimated. You can also drop a model file (TOML).',
        ),
      );
      if (!s.model) {
        const at = document.activeElement;
        if (!at || !/^(INPUT|TEXTAREA|SELECT)$/.test(at.tagName)) setTimeout(() => document.getElementById('designation')?.focus(), 0);
        return [problem, form];
      }
      const text = s.model.text;
      const all = entries(text).filter((e) => !hidden.test(e.table) && e.index === 0 && e.table !== '');
      const assumed = assumedIn(text);
      const tables = [...new Set([...all.map((e) => e.table), ...(spindle ? ofEverySpindle : [])])];
      const own = valueOf(text, 'friction', 'law') ?? 'palmgren';
      const current = s.law || own;
      const law = el(
        'div',
        { class: 'segments', role: 'group', 'aria-label': 'Base law' },
        ...baseLaws.map((l) => button(l, () => void (spindle ? actions.editModel(withValue(text, 'friction', 'law', quoted(l)), `base law ${l}`) : actions.takeLaw(l)), { id: `law-${l}`, 'aria-pressed': String(l === current) })),
      );
      const keyOf = (table: string, key: string) => s.keys.find((k) => k.table === table && k.key === key && applies(k.only, text));
      const groups = tables.map((table) => {
        const here = all.filter((e) => e.table === table && !(table === 'friction' && e.key === 'law'));
        const fields = here.flatMap((e) => {
          const key = keyOf(table, e.key);
          return key && !/^\[\s*($|\{)/.test(e.value) ? [field(key, e, assumed.has(`${table}.${e.key}`), s, actions)] : [];
        });
        const others = s.keys.filter(
          (k, at) =>
            k.table === table &&
            applies(k.only, text) &&
            k.key !== 'law' &&
            !here.some((e) => e.key === k.key) &&
            s.keys.findIndex((other) => other.table === table && other.key === k.key && applies(other.only, text)) === at &&
            k.kind !== 'table' &&
            !(k.table === 'shaft' && k.key === 'segment'),
        );
        return el(
          'section',
          { class: 'list' },
          el('h3', {}, words[table] ?? capital(table)),
          ...(table === 'friction' ? [el('p', { class: 'law' }, el('span', { class: 'note' }, 'Base law '), law)] : []),
          el('div', { class: 'fields' }, ...fields),
          ...[table === 'shaft' ? shaftTable(text, actions) : undefined].filter((t) => t !== undefined),
          ...(others.length
            ? [
                el(
                  'details',
                  {},
                  el('summary', {}, `${others.length} more key${others.length === 1 ? '' : 's'}${here.length ? '' : ', all at their defaults'}`),
                  el('div', { class: 'fields' }, ...others.map((k) => field(k, undefined, false, s, actions))),
                ),
              ]
            : []),
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
      const choice = el('select', { id: 'channel', 'aria-label': 'Displacement' }, ...channels.map((c) => el('option', { value: c }, c)));
      choice.value = s.channel;
      choice.addEventListener('change', () => void actions.takeChannel(choice.value));
      const lags = correction
        ? el(
            'section',
            { class: 'list', id: 'lags' },
            el('h3', {}, 'Lags from the record'),
            ...(channels.length ? [el('p', { class: 'choice' }, el('span', {}, 'Displacement'), choice)] : []),
            el('p', { class: 'note' }, 'Gains and time constants of each channel, chosen by the error on held-out parts of the record.'),
            el(
              'p',
              { class: 'actions' },
              button('Find the lags of these channels', () => void actions.identify(false), { id: 'identify', class: 'primary' }),
              button('Find the lags of all sensors', () => void actions.identify(true), { id: 'identify-bank' }),
            ),
          )
        : undefined;
      const count = assumed.size;
      return [
        problem,
        spindle ? crossSection() : undefined,
        correction ? undefined : form,
        ...s.modelNotes.map((note) => callout('doubt', note)),
        count ? callout('doubt', el('b', {}, `${count} values are assumed or estimated`), ': they are marked below. Enter better values if you know them.') : undefined,
        lags,
        defaults(),
        toml,
        ...groups,
      ];
    },
  };
}
