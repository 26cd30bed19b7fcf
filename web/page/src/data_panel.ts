// The data: which column is which quantity, in which unit, as a picture each; what the engine doubts.
import { inWords, type Actions } from './actions';
import { preview, readMap, type Mapped } from './columns';
import { exampleButtons, filePicker } from './frame';
import { axisTitle, el, number, plain, printed, quantity } from './report';
import type { Reading, State } from './state';
import { button, callout, type Panelled } from './view';
import { isCorrection } from './toml';

const svg = 'http://www.w3.org/2000/svg';
const [plotWidth, plotHeight] = [220, 40];

/// A column over its rows, without axes: its range stands beside it.
function spark(values: Float64Array | undefined, label: string): Element {
  const known = values?.filter(Number.isFinite) ?? new Float64Array();
  const picture = document.createElementNS(svg, 'svg');
  picture.setAttribute('viewBox', `0 0 ${plotWidth} ${plotHeight}`);
  picture.setAttribute('class', 'spark');
  picture.setAttribute('role', 'img');
  picture.setAttribute('aria-label', `${label} over the rows`);
  if (!values || !known.length) return picture;
  let [low, high] = [Infinity, -Infinity];
  for (const v of known) {
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  for (let k = 0; k < values.length; ++k) {
    const v = values[k] as number;
    if (!Number.isFinite(v)) continue;
    const dot = document.createElementNS(svg, 'circle');
    dot.setAttribute('cx', String(3 + ((plotWidth - 6) * k) / Math.max(1, values.length - 1)));
    dot.setAttribute('cy', String(high === low ? plotHeight / 2 : plotHeight - 3 - ((plotHeight - 6) * (v - low)) / (high - low)));
    dot.setAttribute('r', known.length < 60 ? '2.4' : '1.4');
    picture.append(dot);
  }
  return picture;
}

function mappingRow(m: Mapped, header: string[], s: State, actions: Actions): HTMLElement {
  const { label, unit } = quantity(m.ours);
  const select = el('select', { id: `column-${m.ours}`, 'aria-label': `Column of ${label}` });
  const names = [...new Set([m.column, ...header].filter((name) => name !== ''))];
  select.append(el('option', { value: '' }, 'not in the file'), ...names.map((name) => el('option', { value: name }, name)));
  select.value = m.column;
  select.addEventListener('change', () => void actions.mapColumn(m.ours, { column: select.value, number: '' }));
  // Of a column its unit; where there is none, a number for all rows.
  const field = m.column
    ? el('input', { type: 'text', id: `unit-${m.ours}`, class: 'unit', size: '8', 'aria-label': `Unit of ${label} in the file`, placeholder: 'from its name' })
    : el('input', { type: 'text', id: `number-${m.ours}`, class: 'unit', size: '8', inputmode: 'decimal', 'aria-label': `${label} of all rows, ${unit}`, placeholder: unit ? `… ${unit}` : '' });
  field.value = m.column ? m.unit : m.number;
  field.addEventListener('change', () => {
    const value = field.value.trim();
    void actions.mapColumn(m.ours, m.column ? { unit: value } : { number: value.replace(',', '.') });
  });
  const read = s.reading?.columns.find((c) => c.name === m.ours);
  const range = read ? (read.from === read.to ? `${plain(read.from, 5)} ${unit}` : `${plain(read.from, 5)} … ${plain(read.to, 5)} ${unit}`) : '';
  return el('tr', {}, el('th', { scope: 'row' }, axisTitle(m.ours)), el('td', {}, select), el('td', {}, field), el('td', { class: 'number' }, range), el('td', {}, spark(s.reading?.numbers.get(m.ours), label)));
}

function option(id: string, text: string, on: boolean, change: (on: boolean) => void): HTMLElement {
  const box = el('input', { type: 'checkbox', id });
  box.checked = on;
  box.addEventListener('change', () => change(box.checked));
  return el('label', { class: 'option' }, box, text);
}

function rawRows(s: State, names: string[]): HTMLElement | undefined {
  const [file] = s.data;
  if (!file) return undefined;
  const { header, rows, total } = preview(file.text, names, 10);
  if (!rows.length) return undefined;
  const head = el('tr', {}, ...header.map((name) => el('th', { scope: 'col' }, name)));
  return el(
    'section',
    { class: 'list' },
    el('h3', {}, `First rows of ${file.name}`),
    el('div', { class: 'scroll', tabindex: '0' }, el('table', { class: 'raw' }, el('thead', {}, head), el('tbody', {}, ...rows.map((line) => el('tr', {}, ...line.map((cell) => el('td', {}, cell))))))),
    el('p', { class: 'note' }, `${rows.length} of ${total} lines, as in the file.`),
  );
}

function pasteBox(actions: Actions): HTMLElement {
  const area = el('textarea', { id: 'paste', rows: '5', 'aria-label': 'Table from a spreadsheet', placeholder: 'speed_rpm\taxial_load_N\ttemperature_C\tfriction_torque_Nmm' });
  const take = button('Read the table', () => void actions.drop(Promise.resolve([{ name: 'pasted.csv', bytes: new TextEncoder().encode(area.value).buffer }])), { id: 'read-paste' });
  return el('details', {}, el('summary', {}, 'Paste a table from a spreadsheet'), area, el('p', { class: 'actions' }, take));
}

/// A record is cut into what is fitted to and what judges.
function untilField(s: State, actions: Actions): HTMLElement {
  const input = el('input', { type: 'text', id: 'until', size: '8', placeholder: 'whole record', 'aria-describedby': 'until-note' });
  input.value = s.until;
  input.addEventListener('change', () => void actions.cut(input.value.replace(/\s+/g, '')));
  return el(
    'section',
    { class: 'list' },
    el('label', { class: 'choice' }, el('span', {}, 'Fit to readings until'), input),
    el('p', { class: 'note', id: 'until-note' }, 'A time such as 26h, 90min or 3600s. Later readings test the model, and no fit uses them. If this field is empty, the fit uses all readings, and held-out parts test the model.'),
  );
}

/// The noise of rows; that of means over dwells, which the verdict compares with, is another.
function noiseWords({ rms, source, estimated_rms }: Reading['noise'], unit: string): string {
  return `; noise ${number(rms, 3)} ${unit} from ${inWords(source)}${estimated_rms === undefined ? '' : `; a fit finds ${number(estimated_rms, 3)} ${unit}`}`;
}

export function dataPanel(actions: Actions): Panelled {
  return {
    needs: (s) => [s.data, s.map, s.proposal, s.reading, s.confirmed, s.problem, s.model, s.until, s.example, s.dropNan, s.rows],
    make: (s) => {
      const { mapped, absent, unused } = readMap(s.map || s.proposal);
      const missing = readMap(s.proposal).absent.filter((ours) => !mapped.some((m) => m.ours === ours));
      const list: Mapped[] = [...mapped, ...[...new Set([...absent, ...missing])].map((ours) => ({ ours, column: '', unit: '', number: '' }))];
      // Columns that have our names need no line in the map.
      for (const { name } of s.reading?.columns ?? []) if (!list.some((m) => m.ours === name)) list.push({ ours: name, column: name, unit: '', number: '' });
      const names = list.map((m) => m.column).filter(Boolean);
      const header = s.data[0] ? preview(s.data[0].text, [...names, ...unused], 1).header : [];
      const said = s.reading?.said ?? [];
      const doubts = said.filter((n) => n.kind !== 'note').map((n) => callout('doubt', el('b', {}, n.kind === 'doubt' ? 'Doubt: ' : 'Warning: '), printed(n.text)));
      const remarks = said.filter((n) => n.kind === 'note');
      const noise = s.reading?.noise;
      const next = s.confirmed && !s.problem && s.reading ? button(s.model ? 'Next: the verdict' : 'Next: the bearing', () => actions.show(s.model ? 'missing' : 'model'), { class: 'primary', id: 'next' }) : undefined;
      return [
        s.problem?.at === 'data' ? callout('error', s.problem.text) : undefined,
        el(
          'div',
          { class: 'drop', id: 'drop' },
          el('p', {}, el('b', {}, 'Drop a CSV file anywhere on this page'), ', or '),
          filePicker(actions, 'choose files', 'file-2'),
          el('p', { class: 'note' }, 'Speed, loads, temperature and friction torque, with one row for each reading. Several files are one record. Your data stay on this computer.'),
          pasteBox(actions),
          s.example ? '' : el('p', { class: 'choice' }, el('span', { class: 'note' }, 'Or look at an example'), exampleButtons(s.example, actions, 'see')),
        ),
        s.model && isCorrection(s.model.text) ? untilField(s, actions) : undefined,
        s.confirmed
          ? undefined
          : callout(
              'doubt',
              el('span', {}, el('b', {}, 'Proposed from words and units: '), 'check the columns below. The page computes nothing before you agree.'),
              button('These columns are right', () => void actions.confirmColumns(), { class: 'primary', id: 'confirm-columns' }),
            ),
        list.length
          ? el(
              'section',
              { class: 'list' },
              el('div', { class: 'head' }, el('h3', {}, 'Columns'), el('span', { class: 'note' }, s.reading ? `${s.reading.rows} rows${noise?.rms ? noiseWords(noise, quantity(`x_${s.reading.unit}`).unit) : ''}` : '')),
              el(
                'div',
                { class: 'scroll wide', tabindex: '0' },
                el(
                  'table',
                  { class: 'mapping' },
                  el('thead', {}, el('tr', {}, ...['quantity', 'column of the file', 'its unit, or a number', 'as read', 'over the rows'].map((h) => el('th', { scope: 'col', class: h === 'as read' ? 'number' : '' }, h)))),
                  el('tbody', {}, ...list.map((m) => mappingRow(m, header, s, actions))),
                ),
              ),
              el(
                'p',
                { class: 'options' },
                option('drop-nan', 'Leave out rows with an empty cell, nan or #N/A in a column that the model uses', s.dropNan, (on) => void actions.readAs({ dropNan: on })),
                option('rows', 'Use every row of a logger instead of means at equal settings', s.rows, (on) => void actions.readAs({ rows: on })),
              ),
              ...(unused.length ? [el('p', { class: 'note' }, `Not used: ${unused.join(', ')}.`)] : []),
            )
          : undefined,
        ...doubts,
        next ? el('p', { class: 'actions' }, next) : undefined,
        remarks.length ? el('section', { class: 'list' }, el('h3', {}, 'How the file was read'), el('ul', { class: 'said' }, ...remarks.map((n) => el('li', {}, printed(n.text))))) : undefined,
        rawRows(s, [...names, ...unused]),
      ];
    },
  };
}
