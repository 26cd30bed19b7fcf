// The list of the catalogue under the field of a designation: entries of that name, or of its size, chosen by mouse or keyboard.
import type { Actions } from './actions';
import { el, plain } from './report';
import type { Offer } from './state';

const pause = 120; // [ms] of typing, before the engine is asked
let [last, made] = [0, 0]; // the number of the last question, of the last list: ids of options are their own

const words = (b: Offer['bearings'][number]): string => `${plain(b.bore_mm, 4)} × ${plain(b.outer_diameter_mm, 4)} mm, ${b.ball_count} balls of ${plain(b.ball_diameter_mm, 4)} mm, ${plain(b.contact_angle_deg, 3)}°`;

/// The field with its label and its list; `name` stays the field of its form.
export function withCatalogue(label: string, name: HTMLInputElement, actions: Actions): HTMLElement {
  const list = el('ul', { role: 'listbox', tabindex: '-1', id: `catalogue-${++made}`, 'aria-label': 'Bearings of the catalogue' });
  const said = el('p', { class: 'note', role: 'status' });
  const box = el('div', { class: 'catalogue' }, said, list);
  box.hidden = true;
  const own: [string, string][] = [
    ['role', 'combobox'],
    ['aria-autocomplete', 'list'],
    ['aria-controls', list.id],
    ['aria-expanded', 'false'],
  ];
  for (const [key, value] of own) name.setAttribute(key, value);
  let options: HTMLElement[] = [];
  let at = -1;
  let typing = 0;

  const mark = (next: number) => {
    at = next;
    options.forEach((option, k) => option.setAttribute('aria-selected', String(k === at)));
    const option = options[at];
    if (option) name.setAttribute('aria-activedescendant', option.id);
    else name.removeAttribute('aria-activedescendant');
    option?.scrollIntoView({ block: 'nearest' });
  };
  const close = () => {
    clearTimeout(typing);
    ++last;
    mark(-1);
    box.hidden = true;
    name.setAttribute('aria-expanded', 'false');
  };
  const choose = (designation: string) => {
    name.value = designation;
    close();
  };
  const offer = async () => {
    const number = ++last;
    const asked = name.value.trim();
    const { bearings, sameSize } = asked.startsWith('-') ? { bearings: [], sameSize: false } : await actions.offers(asked);
    if (number !== last || document.activeElement !== name) return;
    if (!bearings.length) return close();
    const found = bearings.length === 1 ? '1 bearing' : `${bearings.length} bearings`;
    said.textContent = sameSize ? `${asked} is not in the catalogue; ${found} of the same size. Press Enter without a choice to estimate ${asked}.` : `${found} in the catalogue. Choose with the arrow keys.`;
    options = bearings.map((b, k) => {
      const option = el('li', { role: 'option', id: `${list.id}-${k}`, 'aria-selected': 'false' }, el('b', {}, b.name), ' ', el('span', { class: 'size' }, words(b)));
      // The field keeps the focus.
      option.addEventListener('mousedown', (event) => event.preventDefault());
      option.addEventListener('click', () => choose(b.name));
      return option;
    });
    list.replaceChildren(...options);
    box.hidden = false;
    name.setAttribute('aria-expanded', 'true');
    mark(-1);
  };

  name.addEventListener('input', () => {
    clearTimeout(typing);
    if (name.value.trim()) typing = window.setTimeout(() => void offer(), pause);
    else close();
  });
  name.addEventListener('blur', close);
  name.addEventListener('keydown', (event) => {
    const chosen = options[at]?.querySelector('b')?.textContent;
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step !== undefined) {
      event.preventDefault();
      if (box.hidden) void offer();
      else mark(at < 0 && step < 0 ? options.length - 1 : (at + step + options.length) % options.length);
    } else if (event.key === 'Escape' && !box.hidden) {
      event.stopPropagation(); // it would end the question that is asked
      close();
    } else if (chosen && (event.key === 'Enter' || event.key === 'Tab')) {
      if (event.key === 'Enter') event.preventDefault(); // the form is sent by the next one
      choose(chosen);
    } else if (event.key === 'Enter' || event.key === 'Tab') close();
  });
  return el('div', { class: 'designated' }, el('label', { for: name.id }, label), name, box);
}
