// Measured against predicted: the model as entered, refitted, and with its effects; parameters to drag.
import type { Actions } from './actions';
import { choices, el, FitView, grid, ladder, misfitMap, noiseSources, notes, number, overSpeed, parity, plain, printed, record, residuals, section, unitOfKey, unitText } from './report';
import type { State } from './state';
import { callout, Part, type Child, type Panelled } from './view';
import { valueOf } from './toml';
import type { Comparison } from '../../../report/page/src/document';

/// Sliders for the numbers that are fitted; the error follows.
function sliders(s: State, actions: Actions): HTMLElement | undefined {
  const shifts = s.result?.base.results.base_parameters ?? {};
  const text = s.model?.text ?? '';
  const list = Object.entries(shifts).filter(([name]) => valueOf(text, 'friction', name) !== undefined);
  if (!list.length) return undefined;
  const rows = list.map(([name, shift]) => {
    const entered = Number(valueOf(text, 'friction', name));
    const from = Math.min(entered, shift.before) / 3;
    const to = Math.max(entered, shift.before) * 3;
    const input = el('input', { type: 'range', id: `slide-${name}`, min: String(from), max: String(to), step: String((to - from) / 400), 'aria-label': `${name} of the model as entered` });
    input.value = String(entered);
    const rounded = () => String(Number(Number(input.value).toPrecision(4)));
    const value = el('output', { for: `slide-${name}` }, plain(entered, 4));
    input.addEventListener('input', () => {
      value.textContent = plain(Number(input.value), 4);
      void actions.drag('friction', name, rounded());
    });
    input.addEventListener('change', () => void actions.dragEnd('friction', name, rounded()));
    return el('label', { class: 'slide' }, el('span', {}, name), input, value, el('span', { class: 'note' }, `${unitText(shift.unit)} refitted ${number(shift.before, 4)}`));
  });
  return el('section', { class: 'list sliders' }, el('h3', {}, 'Model as entered: drag a number'), ...rows);
}

export function comparePanel(actions: Actions): Panelled {
  const figures = () => new Part(el('div', {}), (s) => [s.result?.compared], pictures);
  const numbers = () =>
    new Part(
      el('div', {}),
      (s) => [s.at, s.result === undefined, s.result?.refitted],
      (s) => [sliders(s, actions)],
    );
  return { needs: () => [], make: () => [numbers(), figures()] };
}

function pictures(s: State): Child[] {
  const report = s.result?.compared;
  const names = s.result?.names ?? [];
  if (!report) return [el('p', { class: 'quiet' }, 'Measured and predicted torque appear here when the data and the bearing are known.')];
  if (report.kind === 'record') {
    const title = document.title;
    const [, ...pictures] = record(report);
    document.title = title;
    return [el('p', { class: 'note' }, `Models in order: ${names.join(', ')}.${s.until ? ` Only readings after ${s.until} count here. No fit used them.` : ''}`), ...pictures];
  }
  const all = 'models' in report.results ? report.results.models : [report.results];
  report.models.forEach((m, k) => (m.name = names[k] ?? m.name));
  const view = new FitView(report, all.length - 1);
  const last = all[all.length - 1] as Comparison;
  const first = all[0] as Comparison;
  const noise = first.noise.rms ?? last.noise.estimated_rms ?? null;
  const source = first.noise.rms === null ? 'estimated' : first.noise.source;
  return [
    callout('note', printed(last.statement)),
    grid(
      overSpeed(view),
      ladder(
        names,
        all.map((c) => c.rmse),
        all.map((c) => c.bias),
        all.map((c) => c.fit_percent),
        { noise, source: noiseSources[source] ?? source, unit: unitOfKey(first.unit), key: first.unit },
      ),
    ),
    section('Agreement and residuals', choices(view), grid(parity(view), ...residuals(view), misfitMap(view))),
    notes(report.results.said),
  ];
}
