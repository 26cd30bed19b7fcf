// The cases that are built in, and what `raceway workbench` puts into the page.
import rigRows from '../../../tests/hidden_effect/rigs/dev-03/train.csv';
import rigModel from '../../../tests/hidden_effect/rigs/dev-03/model.toml';
import bare from '../../../data/measurements/spindle_thermal/bare3.toml';
import design from '../../../data/spindles/externally_driven.toml';
import day from '../../../data/spindles/day.csv';
import { preview } from './columns';
import { unpacked } from './packed';
import { isProgramme } from './spindle_asking';
import { nothing, type Case, type Diagnosed, type ExampleName } from './state';
import { isSpindle } from './toml';

interface Example {
  title: string; // of the button
  eyebrow: string; // above the verdict
  label: string; // its line in the history
  open: () => Promise<Case>;
}

/// The 34 h are in the page as compressed text (bundle.mjs), since they are a megabyte.
async function record(): Promise<string> {
  const packed = document.getElementById('spindle-record')?.textContent;
  if (!packed) throw new Error('This page contains no spindle record.');
  return new TextDecoder().decode(await unpacked(packed));
}

export const examples: Record<ExampleName, Example> = {
  rig: {
    title: 'Torque rig',
    eyebrow: 'Built-in example: a 7014 spindle bearing on a torque rig, 120 readings',
    label: 'built-in rig',
    open: async () => ({ ...nothing, example: 'rig', data: [{ name: 'rig.csv', text: rigRows }], model: { name: 'rig.toml', text: rigModel } }),
  },
  record: {
    title: 'Warm spindle, 34 h',
    eyebrow: 'Built-in example, measured: a spindle over 34 h, a displacement and 16 temperatures',
    label: 'built-in record',
    open: async () => ({ ...nothing, example: 'record', data: [{ name: 'record.csv', text: await record() }], model: { name: 'bare3.toml', text: bare }, until: '26h' }),
  },
  spindle: {
    title: 'Spindle design',
    eyebrow: 'Built-in example: a milling spindle on three bearings with cooled housing, no measurement',
    label: 'built-in spindle',
    open: async () => ({ ...nothing, example: 'spindle', model: { name: 'spindle.toml', text: design }, programme: { name: 'day.csv', text: day } }),
  },
};

/// A case that was put into the page: {"model": {...}, "data": [...], "map": "..."}.
export function loaded(): Case | undefined {
  const text = document.getElementById('loaded')?.textContent;
  if (!text) return undefined;
  const given = { ...nothing, ...(JSON.parse(text) as Partial<Case>) };
  const [file] = given.data;
  const programme = given.model && isSpindle(given.model.text) && file && given.data.length === 1 && isProgramme(preview(file.text, ['time_s'], 1).header);
  return programme ? { ...given, data: [], programme: file } : given;
}

/// The diagnosis of the rig as the engine gave it when the page was made. It stands until the engine has answered here.
export async function recordedDiagnosis(): Promise<Diagnosed | undefined> {
  const packed = document.getElementById('recorded')?.textContent;
  return packed ? (JSON.parse(new TextDecoder().decode(await unpacked(packed))) as Diagnosed) : undefined;
}
