// Questions to the command, as arguments and files, and the same as lines that people run themselves.
import type { Question } from './engine';
import type { Case, TextFile } from './state';
import { isCorrection } from './toml';

/// A name that is safe as an argument and as a file: what messages of the command call the file.
export function safeName(name: string): string {
  const base = name.split(/[\\/]/).pop() ?? '';
  return base.replace(/[^\p{L}\p{N}._-]/gu, '_').replace(/^[-.]+/, '') || 'data.csv';
}

/// The data under names of their own, apart from ours.
export function dataFiles(data: TextFile[]): TextFile[] {
  const taken = new Set(['model.toml', 'refitted.toml', 'improved.toml', 'columns.toml', 'report.html', 'rows.csv']);
  return data.map(({ name, text }) => {
    let safe = safeName(name);
    for (let k = 2; taken.has(safe); ++k) safe = `${k}-${safeName(name)}`;
    taken.add(safe);
    return { name: safe, text };
  });
}

interface Rig {
  data: string[];
  columns: string[]; // flags that say how the data are read
  files: Record<string, string>;
}

/// Flags that say how the data are read.
function reading(of: Case): string[] {
  return [...(of.map ? ['--columns', 'columns.toml'] : []), ...(of.dropNan ? ['--drop-nan'] : []), ...(of.rows ? ['--rows'] : []), ...(of.channel ? ['--channel', of.channel] : [])];
}

function rig(of: Case): Rig {
  const data = dataFiles(of.data);
  return { data: data.map((d) => d.name), columns: reading(of), files: { ...Object.fromEntries(data.map((d) => [d.name, d.text])), ...(of.map ? { 'columns.toml': of.map } : {}) } };
}

export function suggest(model: string, data: TextFile): Question {
  const [file] = dataFiles([data]) as [TextFile];
  return { arguments: ['check', 'model.toml', file.name, '--suggest-columns'], files: { 'model.toml': model, [file.name]: file.text } };
}

/// Of the first file: `check` takes one.
export function check(of: Case, model: string): Question {
  const { data, columns, files } = rig({ ...of, data: of.data.slice(0, 1), rows: false });
  return { arguments: ['check', 'model.toml', ...data, ...columns, '--json', '-o', 'rows.csv'], files: { 'model.toml': model, ...files } };
}

export function newModel(designation: string, law: string): Question {
  return { arguments: ['new', designation, ...(law ? ['--law', law] : []), '-o', 'model.toml'], files: {} };
}

export function diagnose(of: Case, model: string): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['diagnose', 'model.toml', ...data, ...columns, '--json', '--report', 'report.html'], files: { 'model.toml': model, ...files } };
}

export function calibrate(of: Case, model: string): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['calibrate', 'model.toml', ...data, ...columns, '--json', '-o', 'refitted.toml'], files: { 'model.toml': model, ...files } };
}

export function add(of: Case, model: string, ids: string[]): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['add', 'model.toml', ...ids, '--data', ...data, ...columns, ...(of.forced ? ['--force'] : []), '--json', '-o', 'improved.toml', '--report', 'report.html'], files: { 'model.toml': model, ...files } };
}

/// Takes another base law, whether it helps or not: a look, before any is chosen.
export function tryLaw(of: Case, model: string, law: string): Question {
  return add({ ...of, forced: true }, model, [`law:${law}`]);
}

/// Models as [name, text], in their order.
export function compare(of: Case, models: [string, string][]): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['compare', ...models.map(([name]) => name), ...data, ...columns, '--json', '--report', 'report.html'], files: { ...Object.fromEntries(models), ...files } };
}

/// A correction to begin with, of what a record holds.
export function newRecord(of: Case): Question {
  const [file] = dataFiles(of.data) as [TextFile];
  return { arguments: ['new', '--record', file.name, ...(of.map ? ['--columns', 'columns.toml'] : []), '-o', 'model.toml'], files: { [file.name]: file.text, ...(of.map ? { 'columns.toml': of.map } : {}) } };
}

/// The lags of a correction from its record; with many sensors each through a bank of lags.
export function identify(of: Case, model: string, bank: boolean): Question {
  const { data, columns, files } = rig({ ...of, data: of.data.slice(0, 1), rows: false, channel: '' });
  return { arguments: ['identify', 'model.toml', ...data, ...columns, ...(bank ? ['--lags', 'auto'] : []), '--json', '-o', 'found.toml'], files: { 'model.toml': model, ...files } };
}

export function exported(model: string, format: string): Question {
  return { arguments: ['export', 'model.toml', '--format', format], files: { 'model.toml': model } };
}

export const keys: Question = { arguments: ['keys', '--json'], files: {} };
export const effects: Question = { arguments: ['effects', '--json'], files: {} };

const forShell = (word: string): string => (/^[\w.,:/=-]+$/.test(word) ? word : `'${word.replace(/'/g, `'\\''`)}'`);
const forPython = (text: string): string => JSON.stringify(text);

/// File names as people have them on their disk; "./" where one begins with a dash.
const named = ({ name }: TextFile): string => (name.startsWith('-') ? `./${name}` : name);

/// The commands that do the same.
export function shellCommands(of: Case): string {
  const data = of.data.map(named);
  const columns = reading(of);
  const force = of.forced ? ['--force'] : [];
  const line = (...words: string[]) => ['raceway', ...words].map(forShell).join(' ');
  const lines: string[] = [];
  if (!of.designation && of.model && isCorrection(of.model.text)) lines.push(line('new', '--record', ...data.slice(0, 1), '-o', 'model.toml'));
  if (of.designation) lines.push(line('new', of.designation, '--law', 'palmgren', '-o', 'model.toml'));
  if (of.designation) lines.push(`# Then put your values into model.toml${of.oil ? ` (oil ${of.oil.replace(/\s+/g, ' ')})` : ''}, or save the one of this page.`);
  if (of.map) lines.push(line('check', 'model.toml', ...data.slice(0, 1), '--suggest-columns', '-o', 'columns.toml'));
  let model = 'model.toml';
  if (of.law) {
    lines.push(line('add', model, `law:${of.law}`, '--data', ...data, ...columns, ...force, '-o', `${of.law}.toml`));
    model = `${of.law}.toml`;
  }
  lines.push(line('diagnose', model, ...data, ...columns));
  if (of.on.length) lines.push(line('add', model, ...of.on, '--data', ...data, ...columns, ...force, '-o', 'improved.toml', '--report', 'report.html'), line('diagnose', 'improved.toml', ...data, ...columns));
  else lines.push(line('calibrate', model, ...data, ...columns, '-o', 'improved.toml'));
  lines.push(line('compare', model, 'improved.toml', ...data, ...columns, '--report', 'compare.html'));
  return `${lines.join('\n')}\n`;
}

export function pythonCommands(of: Case): string {
  const columns = `${of.map ? ', columns=open("columns.toml").read()' : ''}${of.dropNan ? ', drop_nan=True' : ''}`;
  const rows = of.rows ? ', rows=True' : '';
  const records = of.data.map((d) => `raceway.Record.read(${forPython(named(d))}${columns})`);
  const lines = ['import raceway', '', 'model = raceway.Model.read("model.toml")', `record = ${records.length > 1 ? `[${records.join(', ')}]` : (records[0] ?? '')}`];
  if (of.law) lines.push(`model = model.add(${forPython(`law:${of.law}`)}, record${rows}).model`);
  lines.push(`print(model.diagnose(record${rows}).headline)`);
  if (of.on.length) lines.push(`better = model.add([${of.on.map(forPython).join(', ')}], record${rows}).model`, `print(better.diagnose(record${rows}).headline)`);
  else lines.push(`better = model.calibrate(record${rows}).model`);
  lines.push(`print(better.compare(record${rows}))`, 'better.save("improved.toml")');
  return `${lines.join('\n')}\n`;
}
