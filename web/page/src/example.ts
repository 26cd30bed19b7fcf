// The rig that is built in: a spindle bearing whose torque holds a drag that its model does not know.
import data from '../../../tests/hidden_effect/rigs/dev-03/train.csv';
import model from '../../../tests/hidden_effect/rigs/dev-03/model.toml';
import type { Case, TextFile } from './state';

export const example: Partial<Case> = {
  example: true,
  data: [{ name: 'rig.csv', text: data }],
  map: '',
  model: { name: 'rig.toml', text: model },
  designation: '',
  oil: '',
  dropNan: false,
  rows: false,
  channel: '',
  law: '',
  on: [],
  forced: false,
};

/// A case that was put into the page: {"model": {...}, "data": [...], "map": "..."}.
export function loaded(): Partial<Case> | undefined {
  const text = document.getElementById('loaded')?.textContent;
  if (!text) return undefined;
  const given = JSON.parse(text) as { model?: TextFile; data?: TextFile[]; map?: string };
  return { ...example, example: false, data: given.data ?? [], map: given.map ?? '', model: given.model };
}
