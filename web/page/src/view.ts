// Parts of the page that are made anew where what they need of the state has changed, and at no other time.
import { drawNew } from '../../../report/page/src/figure';
import { el } from '../../../report/page/src/text';
import type { State } from './state';

export type Child = Node | string | Part | undefined | false;

export const nodes = (...children: Child[]): (Node | string)[] => children.flatMap((c) => (c instanceof Part ? [c.element] : c === undefined || c === false ? [] : [c]));

/// A step of the workbench: what it needs of the state, what it is made of.
export interface Panelled {
  needs: (state: State) => unknown[];
  make: (state: State) => Child[];
}

/// Whatever follows the state.
export interface Shown {
  update(state: State): void;
}

export class Part implements Shown {
  readonly element: HTMLElement;
  private seen: unknown[] | undefined;
  private inner: Part[] = [];

  constructor(
    element: HTMLElement,
    private readonly needs: (state: State) => unknown[],
    private readonly make: (state: State) => Child[],
  ) {
    this.element = element;
  }

  /// A part that cannot be drawn says so where it stands; the others live on.
  private made(state: State): Child[] {
    try {
      return this.make(state);
    } catch (error) {
      return [callout('error', `This part of the page could not be drawn: ${error instanceof Error ? error.message : String(error)}`)];
    }
  }

  update(state: State): void {
    const needs = this.needs(state);
    if (this.seen && needs.every((n, k) => n === this.seen?.[k])) {
      for (const part of this.inner) part.update(state);
      return;
    }
    this.seen = needs;
    const focus = document.activeElement;
    const id = focus && this.element.contains(focus) ? focus.id : '';
    const selection = focus instanceof HTMLTextAreaElement ? [focus.selectionStart, focus.selectionEnd, focus.scrollTop] : undefined;
    const scrolls = [...this.element.querySelectorAll('[data-scroll]')].map((e) => [e.getAttribute('data-scroll'), e.scrollTop] as const);
    const made = this.made(state);
    this.inner = made.filter((c): c is Part => c instanceof Part);
    this.element.replaceChildren(...nodes(...made));
    for (const part of this.inner) part.update(state);
    for (const [name, top] of scrolls) {
      const same = [...this.element.querySelectorAll('[data-scroll]')].find((e) => e.getAttribute('data-scroll') === name);
      if (same) same.scrollTop = top;
    }
    if (id) {
      const again = document.getElementById(id);
      again?.focus({ preventScroll: true });
      if (again instanceof HTMLTextAreaElement && selection) {
        again.setSelectionRange(selection[0] as number, selection[1] as number);
        again.scrollTop = selection[2] as number;
      }
    }
    drawNew();
  }
}

export function button(text: string | Node, press: () => void, attributes: Record<string, string> = {}): HTMLButtonElement {
  const b = el('button', { type: 'button', ...attributes }, text);
  b.addEventListener('click', press);
  return b;
}

/// A message that stands where it applies.
export function callout(kind: 'error' | 'doubt' | 'note', ...content: Child[]): HTMLElement {
  return el('div', { class: `callout ${kind}`, ...(kind === 'error' ? { role: 'alert' } : {}) }, ...nodes(...content));
}
