// What the pages of all commands are built of: the head with its facts, sections, grids of pictures, notes.
import type { Assumptions, Said } from './document';
import type { Figure } from './figure';
import { el, number, printed, valueList } from './text';

export function header(words: { command: string; files: string[]; badge?: [string, string] | undefined; sentence: string; more?: string }, facts: [string, string][]): HTMLElement {
  document.title = `${words.command}: ${words.files.join(', ')}`;
  const head = el('header', {}, el('p', { class: 'eyebrow' }, `raceway\u00a0${words.command}`));
  for (const file of words.files) (head.firstChild as HTMLElement).append(el('code', {}, file));
  if (words.badge) head.append(el('span', { class: `badge ${words.badge[1]}`, id: 'verdict' }, words.badge[0]));
  head.append(el('h1', { id: 'sentence' }, printed(words.sentence)));
  if (words.more) head.append(el('p', { class: 'more' }, printed(words.more)));
  const list = el('dl', { class: 'facts' });
  for (const [name, value] of facts) list.append(el('div', {}, el('dt', {}, name), el('dd', {}, value)));
  head.append(list);
  return head;
}

/// The badge of an answer that passes limits is not green.
export function judgedBadge(badge: [string, string] | undefined, judged: string[]): [string, string] | undefined {
  if (judged.length === 0 || badge?.[1] === 'open') return badge;
  return [`${badge ? `${badge[0]}, ` : ''}limits exceeded`, 'open'];
}

export function warnings(lines: string[]): HTMLElement | undefined {
  return lines.length ? section('Warnings', el('ul', { class: 'notes', id: 'warnings' }, ...lines.map((line) => el('li', {}, line)))) : undefined;
}

export function section(title: string, ...content: (Node | undefined)[]): HTMLElement {
  const nodes = content.filter((node): node is Node => node !== undefined);
  return el('section', {}, el('h2', {}, title), ...nodes);
}

export function grid(...figures: (HTMLElement | Figure | undefined)[]): HTMLElement {
  const box = el('div', { class: 'grid' });
  const elements = figures.flatMap((f) => (f ? [f instanceof HTMLElement ? f : f.element] : []));
  // Two side by side; one that is left over takes the whole width.
  let open: HTMLElement | undefined;
  for (const element of elements) {
    if (element.classList.contains('wide')) {
      open?.classList.add('wide');
      open = undefined;
    } else open = open ? undefined : element;
  }
  open?.classList.add('wide');
  box.append(...elements);
  return box;
}

/// What the spreads of the assumed numbers do to the nose, a line each.
export function assumptions(of: Assumptions | undefined): HTMLElement | undefined {
  if (!of) return undefined;
  const moved = (to: number | null) => {
    if (to === null) return 'no state';
    const by = to - of.axial_displacement_um;
    return `${by > 0 ? '+' : ''}${number(by, 3)}`;
  };
  const list = valueList(
    'The five largest influences',
    ['assumed', 'value', '±', 'nose if smaller [µm]', 'nose if larger [µm]'],
    of.most.map((a) => [a.name, number(a.value), number(a.spread, 3), moved(a.displacement_at_less_um), moved(a.displacement_at_more_um)]),
  );
  list.id = 'assumptions';
  return section(
    'Influence of the assumptions',
    el(
      'p',
      {},
      `These five of ${of.assumed} assumed numbers have the largest influence on the nose displacement in the steady state at ${number(of.speed_rpm)} rpm. The table gives the change of the displacement if a number is smaller or larger by its usual spread.`,
    ),
    list,
  );
}

export function notes(said: (Said | string)[]): HTMLElement | undefined {
  if (said.length === 0) return undefined;
  const line = (one: Said | string) => (typeof one === 'string' ? el('li', {}, one) : el('li', { 'data-kind': one.kind, 'data-code': one.code }, one.text));
  return section('Notes', el('ul', { class: 'notes' }, ...said.map(line)));
}
