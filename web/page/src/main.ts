// Opens the workbench: one state, the parts that show it, the actions that change it.
import { followWindow } from '../../../report/page/src/figure';
import { Actions } from './actions';
import { engineOfPage } from './engine';
import { examples, loaded, recordedDiagnosis } from './example';
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
if (given) void actions.open(Promise.resolve(given), 'as opened');
else void actions.open(examples.rig.open(), examples.rig.label, recordedDiagnosis());
store.change({});
