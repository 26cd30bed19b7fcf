// A spindle without measurements: its steady state, a programme of speeds, its modes. The pictures are those of the reports.
import type { Actions } from './actions';
import { filePicker } from './frame';
import { el, modes, printed, sectionFigure, spindleRun, spindleSteady } from './report';
import type { Machine, State } from './state';
import { button, callout, Part, type Child, type Panelled } from './view';

type Nodes = (Node | undefined)[];

/// The head of a report and what stands below it; the title of this page stays.
function parted(made: () => Nodes): { head: Node | undefined; below: Node[] } {
  const { title } = document;
  const [head, ...below] = made();
  document.title = title;
  return { head, below: below.filter((n): n is Node => n !== undefined) };
}

function pageOf(machine: Machine | undefined, panel: State['panel']): ReturnType<typeof parted> | undefined {
  const { steady, run, modes: found } = machine ?? {};
  if (panel === 'programme') return run && parted(() => spindleRun(run.report));
  if (panel === 'modes') return found && parted(() => modes(found.report));
  return steady && parted(() => spindleSteady(steady.report));
}

/// What stands above the steps: the answer of the step that is shown, else of the steady state.
export function spindleHead(s: State): Child[] {
  const head = (pageOf(s.machine, s.panel) ?? pageOf(s.machine, 'steady'))?.head;
  if (head instanceof Element) {
    for (const words of head.querySelectorAll('#sentence, .more')) words.textContent = printed(words.textContent ?? '');
    if (s.stale) head.querySelector('#sentence')?.before(el('span', { class: 'badge open', id: 'stale' }, s.job ? 'updating' : 'previous case'));
  }
  return [head ?? el('h1', { id: 'sentence' }, s.problem ? 'No answer yet.' : 'Calculating …')];
}

/// A field of a question.
function asked(id: string, words: string, unit: string, value: string, change: (value: string) => void, more: Record<string, string> = {}): HTMLElement {
  const input = el('input', { id, type: 'text', autocomplete: 'off', size: '12', ...more });
  input.value = value;
  input.addEventListener('change', () => change(input.value.trim().replace(/^(-?\d+),(\d+)$/, '$1.$2')));
  return el('label', { class: 'asked' }, el('span', {}, words), el('span', { class: 'entry' }, input, el('span', { class: 'of-unit' }, unit)));
}

function coolant(s: State, actions: Actions): HTMLElement | undefined {
  if (!/^\s*\[coolant\]/m.test(s.model?.text ?? '')) return undefined;
  const box = el('input', { type: 'checkbox', id: 'coolant' });
  box.checked = !s.coolantOff;
  box.addEventListener('change', () => void actions.choose({ coolantOff: !box.checked }, box.checked ? 'coolant on' : 'coolant off'));
  return el('label', { class: 'option' }, box, 'Coolant on');
}

const present = (...children: (Node | undefined)[]): Node[] => children.filter((c): c is Node => c !== undefined);

function problemAt(s: State, panel: State['panel']): HTMLElement | undefined {
  return s.problem?.at === panel ? callout('error', printed(s.problem.text)) : undefined;
}

const waiting = (s: State, words: string): HTMLElement => el('p', { class: 'quiet' }, s.problem ? 'Nothing to show yet.' : words);

export function steadyPanel(actions: Actions): Panelled {
  return {
    needs: (s) => [s.machine?.steady, s.problem, s.speed, s.coolantOff, s.axialLoad, s.radialLoad],
    make: (s) => [
      problemAt(s, 'steady'),
      el(
        'section',
        { class: 'list questions' },
        ...present(
          asked('speed', 'Speed, or from:to:step', 'rpm', s.speed, (speed) => void actions.choose({ speed }, `speed ${speed} rpm`)),
          asked('axial-load', 'Axial load at the nose', 'N', s.axialLoad, (axialLoad) => void actions.choose({ axialLoad }, `axial load ${axialLoad || 'of the model'} N`), { placeholder: 'of the model' }),
          asked('radial-load', 'Radial load at the nose', 'N', s.radialLoad, (radialLoad) => void actions.choose({ radialLoad }, `radial load ${radialLoad || '0'} N`), { placeholder: '0' }),
          coolant(s, actions),
        ),
      ),
      ...(pageOf(s.machine, 'steady')?.below ?? [waiting(s, 'The steady state appears here in a moment.')]),
    ],
  };
}

const proposed = 'time_s,speed_rpm\n0,0\n3600,6000\n7200,6000\n10800,0\n';

export function programmePanel(actions: Actions): Panelled {
  return {
    needs: (s) => [s.machine?.run, s.problem, s.programme, s.coolantOff],
    make: (s) => {
      const area = el('textarea', { id: 'programme', rows: '10', spellcheck: 'false', 'aria-label': 'Programme of speeds, CSV', 'data-scroll': 'programme' });
      area.value = s.programme?.text ?? proposed;
      const run = button('Run this programme', () => void actions.choose({ programme: { name: s.programme?.name ?? 'programme.csv', text: area.value } }, 'programme'), { id: 'run-programme', class: s.programme ? '' : 'primary' });
      return [
        problemAt(s, 'programme'),
        el(
          'section',
          { class: 'list' },
          el('p', {}, s.programme ? el('b', {}, s.programme.name) : 'No programme yet: run this one, change it, or ', ' ', filePicker(actions, s.programme ? 'Choose another' : 'choose a file', 'programme-file')),
          el('p', { class: 'note' }, 'CSV with time_s and speed_rpm; a row may also have loads, coolant_on, motor heat and temperatures of room, machine and coolant.'),
          el('details', s.programme && s.problem?.at !== 'programme' ? {} : { open: '' }, el('summary', {}, 'Text of the programme'), area, el('p', { class: 'actions' }, run)),
          ...present(coolant(s, actions)),
        ),
        ...(pageOf(s.machine, 'programme')?.below ?? (s.programme ? [waiting(s, 'The run appears here when it is complete.')] : [])),
      ];
    },
  };
}

export function modesPanel(actions: Actions): Panelled {
  return {
    needs: (s) => [s.machine?.modes, s.problem, s.modeSpeeds],
    make: (s) => [
      problemAt(s, 'modes'),
      el(
        'section',
        { class: 'list questions' },
        asked('mode-speeds', 'Speeds, from:to:step', 'rpm', s.modeSpeeds, (modeSpeeds) => void actions.choose({ modeSpeeds }, `modes at ${modeSpeeds} rpm`)),
      ),
      ...(pageOf(s.machine, 'modes')?.below ?? [waiting(s, 'The modes appear here in a moment.')]),
    ],
  };
}

/// The cross-section beside the fields of the model: it follows each change.
export function crossSection(): Part {
  return new Part(
    el('div', { id: 'cross-section' }),
    (s) => [s.machine?.steady, s.stale],
    (s) => {
      const section = s.machine?.steady?.report.section;
      if (!section) return [];
      const speeds = section.moments.map((m) => `${m.speed_rpm} rpm`);
      return [
        s.stale ? el('p', { class: 'note', role: 'status' }, s.job ? 'The picture follows in a moment.' : 'The picture shows the last model with a solution.') : undefined,
        sectionFigure(section, 'speed', speeds, speeds.length - 1).element,
      ];
    },
  );
}
