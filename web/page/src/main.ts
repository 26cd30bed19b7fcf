// Opens the workbench: one state, the parts that show it, the actions that change it.
import { followWindow } from '../../../report/page/src/figure';
import { Actions } from './actions';
import { engineOfPage } from './engine';
import { example, loaded } from './example';
import { frame } from './frame';
import { Store } from './state';
import type { Shown } from './view';

let parts: Shown[] = [];
const store = new Store((state) => {
  for (const part of parts) part.update(state);
  document.documentElement.dataset.idle = state.running === 0 && !state.job ? 'yes' : 'no';
});
const actions = new Actions(store, engineOfPage());
parts = frame(
  document.getElementById('workbench') as HTMLElement,
  actions,
  () => store.state,
  (part) => store.change(part),
);
followWindow();
const given = loaded();
void actions.open(given ?? example, given ? 'as opened' : 'built-in rig');
store.change({});
