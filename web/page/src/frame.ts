// What surrounds the steps: title, what the engine is doing, the verdict, the list of steps.
import { el, number, unitOfKey } from './report';
import { alone, type Actions } from './actions';
import { comparePanel } from './compare_panel';
import { dataPanel } from './data_panel';
import { examples } from './example';
import { historyPanel } from './history_panel';
import { homePanel } from './home_panel';
import { missingPanel } from './missing_panel';
import { modelPanel } from './model_panel';
import { modesPanel, programmePanel, steadyPanel } from './spindle_panels';
import type { ExampleName, Panel, State } from './state';
import { verdict } from './verdict';
import { isCorrection, plainValue, valueOf } from './toml';
import { button, Part, type Panelled, type Shown } from './view';

const names: Record<Panel, string> = { data: 'Data', model: 'Model', compare: 'Compare', missing: 'What is missing', steady: 'Steady state', programme: 'Programme', modes: 'Modes', history: 'History', home: 'Save and reuse' };

/// The steps of measurements, and those of a spindle without any.
const stepsOf = (s: State): Panel[] => (alone(s) ? ['model', 'steady', 'programme', 'modes', 'history', 'home'] : ['data', 'model', 'compare', 'missing', 'history', 'home']);

/// What stands under the name of a step.
function summary(panel: Panel, s: State): string {
  switch (panel) {
    case 'data':
      return s.data.length ? `${s.data.map((d) => d.name).join(', ')}${s.reading ? `, ${s.reading.rows} rows` : ''}` : 'no file yet';
    case 'model': {
      if (!s.model) return 'no bearing yet';
      if (alone(s)) return plainValue(valueOf(s.model.text, 'spindle', 'name') ?? valueOf(s.model.text, 'bearing', 'name') ?? valueOf(s.model.text, 'bearing', 'catalogue') ?? s.model.name);
      if (isCorrection(s.model.text)) return s.channel || 'a correction over time';
      const name = valueOf(s.model.text, 'bearing', 'name') ?? valueOf(s.model.text, 'bearing', 'catalogue') ?? s.model.name;
      return `${plainValue(name)}, ${s.law || (valueOf(s.model.text, 'friction', 'law') ?? 'palmgren')}`;
    }
    case 'compare': {
      const models = s.result?.compared?.results;
      const last = models && ('models' in models ? models.models[models.models.length - 1] : models);
      return last ? `error ${number(last.rmse, 3)} ${unitOfKey(last.unit)}` : 'measured and predicted';
    }
    case 'missing':
      return s.on.length ? `${s.on.length} effect${s.on.length > 1 ? 's' : ''} on` : 'click to add effects';
    case 'steady':
      return `${s.speed} rpm${s.coolantOff ? ', coolant off' : ''}`;
    case 'programme':
      return s.programme?.name ?? 'speeds over time';
    case 'modes':
      return 'Campbell diagram';
    case 'history':
      return `${s.history.length} step${s.history.length === 1 ? '' : 's'}`;
    case 'home':
      return 'model, report, commands';
  }
}

/// Files that are dropped anywhere, or chosen.
function takeFiles(list: FileList | null | undefined, actions: Actions): void {
  const files = [...(list ?? [])];
  if (files.length) void actions.drop(Promise.all(files.map(async (f) => ({ name: f.name, bytes: await f.arrayBuffer() }))));
}

export function filePicker(actions: Actions, text: string, id: string): HTMLElement {
  const input = el('input', { type: 'file', id, class: 'visually-hidden', multiple: '', accept: '.csv,.txt,.tsv,.dat,.toml,text/csv,text/plain' });
  input.addEventListener('change', () => takeFiles(input.files, actions));
  return el('span', { class: 'picker' }, input, el('label', { for: id, class: 'button' }, text));
}

/// The cases that are built in; that which is shown is marked.
export function exampleButtons(shown: string, actions: Actions, prefix = 'example'): HTMLElement {
  return el(
    'div',
    { class: 'segments', role: 'group', 'aria-label': 'Built-in examples' },
    ...(Object.keys(examples) as ExampleName[]).map((name) => button(examples[name].title, () => void actions.openExample(name), { id: `${prefix}-${name}`, 'aria-pressed': String(shown === name) })),
  );
}

export function frame(root: HTMLElement, actions: Actions, state: () => State, change: (part: Partial<State>) => void): Shown[] {
  const status = el('div', { class: 'status', role: 'status', 'aria-live': 'polite' });
  const nav = el('nav', { class: 'steps', 'aria-label': 'Steps' });
  const head = el('section', { class: 'verdict', 'aria-label': 'Verdict' });
  const choice = el('div', { class: 'examples' });
  const panel = el('section', { class: 'panel', id: 'panel', 'aria-live': 'off' });
  root.append(
    el('header', { class: 'bar' }, el('p', { class: 'brand' }, el('strong', {}, 'raceway'), ' workbench'), status, filePicker(actions, 'Drop your file here, or choose it', 'file')),
    el('div', { class: 'layout' }, nav, el('main', {}, choice, head, panel)),
  );
  document.addEventListener('dragover', (event) => {
    event.preventDefault();
    root.classList.add('dragging');
  });
  document.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) root.classList.remove('dragging');
  });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    root.classList.remove('dragging');
    takeFiles(event.dataTransfer?.files, actions);
  });
  document.addEventListener('paste', (event) => {
    if (event.target instanceof HTMLInputElement || event.target instanceof HTMLTextAreaElement) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (text.includes('\n')) void actions.drop(Promise.resolve([{ name: 'pasted.csv', bytes: new TextEncoder().encode(text).buffer }]));
  });
  document.addEventListener('keydown', (event) => {
    const typing = event.target instanceof HTMLElement && /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName);
    if (event.key === 'z' && (event.ctrlKey || event.metaKey) && !typing) {
      event.preventDefault();
      void actions.back(state().at - 1);
    }
    if (event.key === 'Escape' && state().job) actions.stop();
  });

  const panels: Record<Panel, Panelled> = {
    data: dataPanel(actions),
    model: modelPanel(actions, change),
    compare: comparePanel(actions),
    missing: missingPanel(actions),
    history: historyPanel(actions),
    steady: steadyPanel(actions),
    programme: programmePanel(actions),
    modes: modesPanel(actions),
    home: homePanel(actions),
  };
  // The seconds of a question run on their own.
  const clock = el('span', { class: 'clock' });
  setInterval(() => {
    const { job } = state();
    if (job) clock.textContent = `${job.share === undefined ? '' : `${Math.round(100 * job.share)} %, `}${((performance.now() - job.since) / 1000).toFixed(1)} s`;
  }, 100);

  // On a narrow page the list of steps is scrolled sideways.
  const showStep = () => {
    const current = nav.querySelector('[aria-current]')?.getBoundingClientRect();
    const box = nav.getBoundingClientRect();
    if (current && (current.left < box.left || current.right > box.right)) nav.scrollLeft += current.left + current.width / 2 - box.left - box.width / 2;
  };

  return [
    new Part(
      status,
      (s) => [s.job?.label, s.took],
      (s) => {
        if (!s.job) return [s.took ? el('span', { class: 'took' }, `${s.took.label}: ${s.took.ms < 995 ? `${Math.round(s.took.ms)} ms` : `${(s.took.ms / 1000).toFixed(1)} s`}`) : undefined];
        clock.textContent = '';
        return [el('span', { class: 'spinner', 'aria-hidden': 'true' }), el('span', {}, `${s.job.label} `), clock, button('Stop', () => actions.stop(), { id: 'stop', class: 'small', title: 'Stops this calculation (Escape)' })];
      },
    ),
    new Part(
      nav,
      (s) => [s.panel, s.data, s.model, s.law, s.on, s.result, s.history, s.reading, s.problem, s.speed, s.coolantOff, s.programme],
      (s) => {
        requestAnimationFrame(showStep);
        return [
          el(
            'ol',
            {},
            ...stepsOf(s).map((name, k) => {
              const wrong = s.problem?.at === name;
              const b = button(
                el(
                  'span',
                  { class: 'step' },
                  el('span', { class: 'numeral', 'aria-hidden': 'true' }, String(k + 1)),
                  el('span', { class: 'words' }, el('b', {}, names[name]), el('span', { class: 'summary' }, wrong ? 'needs attention' : summary(name, s))),
                ),
                () => actions.show(name),
                { id: `step-${name}`, ...(s.panel === name ? { 'aria-current': 'step' } : {}), class: wrong ? 'wrong' : '' },
              );
              return el('li', {}, b);
            }),
          ),
        ];
      },
    ),
    new Part(
      choice,
      (s) => [s.example],
      (s) => (s.example ? [el('span', { class: 'note' }, 'Built-in examples'), exampleButtons(s.example, actions)] : []),
    ),
    ...verdict(head, actions),
    new Part(
      panel,
      (s) => [s.panel, ...panels[s.panel].needs(s)],
      (s) => {
        panel.dataset.panel = s.panel;
        return [el('h2', { class: 'visually-hidden' }, names[s.panel]), ...panels[s.panel].make(s)];
      },
    ),
  ];
}
