// Every step with its error before and after; a click goes back.
import type { Actions } from './actions';
import { dash, el, number, unitOfKey } from './report';
import { button, type Panelled } from './view';

export function historyPanel(actions: Actions): Panelled {
  return {
    needs: (s) => [s.history, s.at, s.until],
    make: (s) => {
      if (!s.history.length) return [el('p', { class: 'quiet' }, 'Each step appears here with its error.')];
      const spindle = s.history.every((line) => line.spindle);
      const rows = s.history.map((line, k) => {
        const before = s.history[k - 1];
        const unit = unitOfKey(line.unit);
        const same = before && before.of.data === line.of.data && before.spindle === line.spindle;
        return el(
          'tr',
          k === s.at ? { 'aria-current': 'true' } : {},
          el('td', { class: 'number' }, String(k + 1)),
          el('td', {}, line.label),
          el('td', { class: 'number' }, same ? number(before.rmse, 3) : dash),
          el('td', { class: 'number' }, `${number(line.rmse, 3)} ${unit}`),
          el('td', { class: 'number' }, line.held === undefined ? dash : `${number(line.held, 3)} ${line.spindle ? 'N' : unit}`),
          el('td', {}, k === s.at ? 'shown' : button('Go back', () => void actions.back(k), { class: 'small', id: `back-${k}`, 'aria-label': `Go back to step ${k + 1}, ${line.label}` })),
        );
      });
      return [
        el(
          'section',
          { class: 'list' },
          el(
            'div',
            { class: 'head' },
            el('h3', {}, 'History'),
            button('Undo', () => void actions.back(s.at - 1), { id: 'undo', class: 'small', title: 'One step back (Ctrl+Z)', ...(s.at > 0 ? {} : { disabled: '' }) }),
          ),
          el(
            'div',
            { class: 'scroll', tabindex: '0' },
            el(
              'table',
              {},
              el(
                'thead',
                {},
                el(
                  'tr',
                  {},
                  ...['no.', 'step', ...(spindle ? ['nose before', 'nose after', 'front set'] : ['error before', 'error after', s.until ? `after ${s.until}` : 'on held-out rows']), ''].map((h, k) =>
                    h ? el('th', { scope: 'col', class: k === 0 || (k > 1 && k < 5) ? 'number' : '' }, h) : el('td', {}),
                  ),
                ),
              ),
              el('tbody', {}, ...rows),
            ),
          ),
          el('p', { class: 'note' }, `${spindle ? 'Displacement of the nose and axial force of the front set in the steady state.' : 'RMS error of the refitted model.'} If you go back, the next step replaces the later steps.`),
        ),
      ];
    },
  };
}
