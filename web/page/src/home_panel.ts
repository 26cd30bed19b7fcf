// What a user takes home: model, map of columns, report, and the commands that do the same.
import { el, printed, saveBlob } from './report';
import { pythonCommands, shellCommands } from './questions';
import { readMap, writeMap } from './columns';
import { caseOf, type State, type Trust } from './state';
import { alone, type Actions } from './actions';
import { isCorrection } from './toml';
import { trustLine } from './verdict';
import { button, callout, type Panelled } from './view';

function save(name: string, text: string, type: string): void {
  saveBlob(name, new Blob([text], { type }));
}

function item(title: string, words: string, name: string, text: string | undefined, type: string, id: string): HTMLElement {
  return el(
    'li',
    {},
    el('div', {}, el('b', {}, title), el('p', { class: 'note' }, words)),
    button(`Save ${name}`, () => text !== undefined && save(name, text, type), { id, ...(text === undefined ? { disabled: '' } : {}) }),
  );
}

function listing(title: string, text: string, name: string, id: string): HTMLElement {
  const said = el('span', { class: 'note', role: 'status' });
  const copy = button(
    'Copy',
    () =>
      void navigator.clipboard.writeText(text).then(
        () => (said.textContent = 'copied'),
        () => (said.textContent = 'The browser does not allow copying. Save the file instead.'),
      ),
    { class: 'small' },
  );
  return el(
    'section',
    { class: 'list' },
    el(
      'div',
      { class: 'head' },
      el('h3', {}, title),
      el(
        'span',
        {},
        said,
        ' ',
        copy,
        ' ',
        button('Save', () => save(name, text, 'text/plain'), { class: 'small', id: `save-${id}` }),
      ),
    ),
    el('pre', { id, tabindex: '0' }, text),
  );
}

/// A correction as something that runs in a control.
function exports(model: string, trust: Trust | undefined, actions: Actions): HTMLElement {
  const formats: [string, string, string][] = [
    ['python', 'correction.py', 'Python, one file'],
    ['c', 'correction.h', 'C99, one header'],
    ['csv', 'correction.csv', 'Table of numbers'],
    ['linuxcnc', 'thermal.py', 'LinuxCNC, HAL component'],
  ];
  const said = el('div', { role: 'status' });
  const write = (format: string, name: string, untrusted = false) =>
    void actions.exported(model, format, untrusted).then(
      (text) => {
        said.replaceChildren();
        save(name, text, 'text/plain');
      },
      (error: Error) => {
        // The command asks for --accept-untrusted where a correction is not to be used.
        const may = /--accept-untrusted/.test(error.message);
        const words = error.message.replace(/\. --accept-untrusted.*$/s, '.');
        said.replaceChildren(callout(may ? 'doubt' : 'error', el('span', {}, printed(words)), may ? button('Export it anyway', () => write(format, name, true), { id: 'accept-untrusted', class: 'small' }) : undefined));
      },
    );
  return el(
    'section',
    { class: 'list', id: 'export' },
    el('h3', {}, 'Export the correction'),
    ...(trust ? [trustLine(trust)] : []),
    el('p', { class: 'actions' }, ...formats.map(([format, name, words]) => button(words, () => write(format, name), { id: `export-${format}` }))),
    said,
  );
}

function homeOfSpindle(s: State): HTMLElement[] {
  const of = caseOf(s);
  const { steady, run, modes } = s.machine ?? {};
  return [
    el(
      'section',
      { class: 'list' },
      el('h3', {}, 'Files'),
      el(
        'ul',
        { class: 'files' },
        item('Model', 'The model of the step Model.', 'model.toml', s.model?.text, 'application/toml', 'save-model'),
        ...(s.programme ? [item('Programme', 'The speeds over time, CSV.', s.programme.name, s.programme.text, 'text/csv', 'save-programme')] : []),
        item('Report of the steady state', 'One page with all pictures, for any browser, offline.', 'steady.html', steady?.page, 'text/html', 'save-steady'),
        item('Report of the programme', run ? 'The same pictures over time.' : 'Open the step Programme first.', 'programme.html', run?.page, 'text/html', 'save-run'),
        item('Rows of the programme', 'Displacement, forces, heat and temperatures over time, CSV.', 'run.csv', run?.rows, 'text/csv', 'save-rows'),
        item('Report of the modes', modes ? 'Campbell diagram and shapes.' : 'Open the step Modes first.', 'modes.html', modes?.page, 'text/html', 'save-modes'),
      ),
    ),
    listing('The same steps as commands', shellCommands(of), 'commands.sh', 'shell'),
    listing('The same steps in Python', pythonCommands(of), 'commands.py', 'python'),
  ];
}

export function homePanel(actions: Actions): Panelled {
  return {
    needs: (s) => [s.result, s.machine, s.model, s.map, s.law, s.on, s.forced, s.dropNan, s.rows, s.until],
    make: (s) => {
      if (alone(s)) return homeOfSpindle(s);
      const of = caseOf(s);
      const map = s.map || (s.proposal ? writeMap(readMap(s.proposal).mapped) : '');
      const what = s.on.length ? 'with its effects, refitted' : s.start ? 'with the lags found' : 'refitted';
      return [
        el(
          'section',
          { class: 'list' },
          el('h3', {}, 'Files'),
          el(
            'ul',
            { class: 'files' },
            item('Improved model', `The model ${what}: parameters with their uncertainty, TOML.`, 'improved.toml', s.result?.model, 'application/toml', 'save-improved'),
            item('Model as entered', 'The model of the step Model.', 'model.toml', s.model?.text, 'application/toml', 'save-model'),
            ...(s.start ? [item('Model before the lags were found', 'The commands below start from this model.', 'start.toml', s.start.text, 'application/toml', 'save-start')] : []),
            item('Map of columns', 'Quantity and unit of each column of your file.', 'columns.toml', map || undefined, 'application/toml', 'save-columns'),
            ...(s.example && s.data[0] ? [item('Data', 'The rows of the built-in example, CSV.', s.data[0].name, s.data[0].text, 'text/csv', 'save-data')] : []),
            item('Report', 'One page with all pictures, for any browser, offline.', 'report.html', s.result?.report, 'text/html', 'save-report'),
          ),
        ),
        s.result?.model && isCorrection(s.result.model) ? exports(s.result.model, s.result.trust, actions) : undefined,
        listing('The same steps as commands', shellCommands(of), 'commands.sh', 'shell'),
        listing('The same steps in Python', pythonCommands(of), 'commands.py', 'python'),
      ];
    },
  };
}
