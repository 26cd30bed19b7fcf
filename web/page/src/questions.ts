// Questions to the command, as arguments and files, and the same as lines that people run themselves.
import type { Question } from './engine';
import type { Case, TextFile } from './state';
import { isCorrection, isSpindle } from './toml';

/// A name that is safe as an argument and as a file: what messages of the command call the file.
export function safeName(name: string): string {
  const base = name.split(/[\\/]/).pop() ?? '';
  return base.replace(/[^\p{L}\p{N}._-]/gu, '_').replace(/^[-.]+/, '') || 'data.csv';
}

/// The data under names of their own, apart from ours.
export function dataFiles(data: TextFile[]): TextFile[] {
  const taken = new Set(['model.toml', 'start.toml', 'refitted.toml', 'improved.toml', 'found.toml', 'columns.toml', 'report.html', 'rows.csv']);
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

/// Which readings of a record are fitted to, and which judge.
function span(of: Case, judge = false): string[] {
  if (!of.until || !of.model || !isCorrection(of.model.text)) return [];
  return judge ? ['--from', of.until, '--zero', 'none'] : ['--until', of.until];
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
export function check(of: Case, model: string, rows: boolean): Question {
  const { data, columns, files } = rig({ ...of, data: of.data.slice(0, 1), rows: false });
  return { arguments: ['check', 'model.toml', ...data, ...columns, '--json', ...(rows ? ['-o', 'rows.csv'] : [])], files: { 'model.toml': model, ...files } };
}

/// Of a bearing, or of a spindle on three of it.
export function newModel(designation: string, spindle = false, oil = ''): Question {
  return { arguments: ['new', ...(designation ? [designation] : []), ...(spindle ? ['--spindle'] : ['--law', 'palmgren']), ...(oil ? ['--oil', oil] : []), '-o', 'model.toml'], files: {} };
}

/// Entries of the catalogue with this in their name; of a designation that is in none, those of its size.
export function bearings(filter: string): Question {
  return { arguments: ['bearings', ...(filter ? [filter] : []), '--json'], files: {} };
}

export function diagnose(of: Case, model: string): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['diagnose', 'model.toml', ...data, ...columns, ...span(of), '--json', '--report', 'report.html'], files: { 'model.toml': model, ...files } };
}

export function calibrate(of: Case, model: string): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['calibrate', 'model.toml', ...data, ...columns, ...span(of), '--json', '-o', 'refitted.toml'], files: { 'model.toml': model, ...files } };
}

export function add(of: Case, model: string, ids: string[]): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['add', 'model.toml', ...ids, '--data', ...data, ...columns, ...span(of), ...(of.forced ? ['--force'] : []), '--json', '-o', 'improved.toml', '--report', 'report.html'], files: { 'model.toml': model, ...files } };
}

/// Takes another base law, whether it helps or not: a look, before any is chosen.
export function tryLaw(of: Case, model: string, law: string): Question {
  return add({ ...of, forced: true }, model, [`law:${law}`]);
}

/// Models as [name, text], in their order.
export function compare(of: Case, models: [string, string][]): Question {
  const { data, columns, files } = rig(of);
  return { arguments: ['compare', ...models.map(([name]) => name), ...data, ...columns, ...span(of, true), '--json', '--report', 'report.html'], files: { ...Object.fromEntries(models), ...files } };
}

/// A correction to begin with, of what a record holds.
export function newRecord(of: Case): Question {
  const [file] = dataFiles(of.data) as [TextFile];
  return { arguments: ['new', '--record', file.name, ...(of.map ? ['--columns', 'columns.toml'] : []), '-o', 'model.toml'], files: { [file.name]: file.text, ...(of.map ? { 'columns.toml': of.map } : {}) } };
}

/// The lags of a correction from its record; with many sensors each through a bank of lags.
export function identify(of: Case, model: string, bank: boolean): Question {
  const { data, columns, files } = rig({ ...of, data: of.data.slice(0, 1), rows: false, channel: '' });
  return { arguments: ['identify', 'model.toml', ...data, ...columns, ...span(of), ...(bank ? ['--lags', 'auto'] : []), '--json', '-o', 'found.toml'], files: { 'model.toml': model, ...files } };
}

/// The correction over its record: how far it may be trusted.
export function correct(of: Case, model: string): Question {
  const { data, columns, files } = rig({ ...of, data: of.data.slice(0, 1), rows: false, channel: '' });
  return { arguments: ['correct', 'model.toml', ...data, ...columns, '--json'], files: { 'model.toml': model, ...files } };
}

export function exported(model: string, format: string, untrusted: boolean): Question {
  return { arguments: ['export', 'model.toml', '--format', format, ...(untrusted ? ['--accept-untrusted'] : [])], files: { 'model.toml': model } };
}

const given = (flag: string, value: string): string[] => (value ? [flag, value] : []);

/// Flags of a steady state.
const state = (of: Case): string[] => ['--speed', of.speed, '--steady', ...(of.coolantOff ? ['--coolant', 'off'] : []), ...given('--axial-load', of.axialLoad), ...given('--radial-load', of.radialLoad)];

export function steady(of: Case, model: string): Question {
  return { arguments: ['spindle', 'model.toml', ...state(of), '--json', '--report', 'report.html'], files: { 'model.toml': model } };
}

export function simulate(of: Case, model: string, { text }: TextFile): Question {
  return {
    arguments: ['spindle', 'model.toml', '--speed-profile', 'programme.csv', ...(of.coolantOff ? ['--coolant', 'off'] : []), '--json', '-o', 'run.csv', '--report', 'report.html'],
    files: { 'model.toml': model, 'programme.csv': text },
  };
}

export function modes(of: Case, model: string): Question {
  return { arguments: ['modes', 'model.toml', '--speed', of.modeSpeeds, '--json', '--report', 'report.html'], files: { 'model.toml': model } };
}

export const keys: Question = { arguments: ['keys', '--json'], files: {} };
export const effects: Question = { arguments: ['effects', '--json'], files: {} };

const forShell = (word: string): string => (/^[\w.,:/=-]+$/.test(word) ? word : `'${word.replace(/'/g, `'\\''`)}'`);
const forPython = (text: string): string => JSON.stringify(text);

/// File names as people have them on their disk; "./" where one begins with a dash.
const named = ({ name }: TextFile): string => (name.startsWith('-') ? `./${name}` : name);

/// Makes lines of a shell, and remembers the files that they write.
class Lines {
  readonly written = new Set<string>();

  private static shell = (words: string[]): string => ['raceway', ...words].map(forShell).join(' ');

  run(...words: string[]): string {
    words.forEach((word, k) => /^(-o|--report)$/.test(word) && this.written.add(words[k + 1] as string));
    return Lines.shell(words);
  }

  /// Writes a file that may have been saved from the page: then that one is taken.
  unlessSaved(name: string, ...words: string[]): string {
    return `[ -e ${name} ] || ${Lines.shell([...words, '-o', name])}`;
  }
}

/// The commands that do the same. They begin with the files that were saved; what they write anew is kept under another name.
export function shellCommands(of: Case): string {
  const make = new Lines();
  const spindle = of.model !== undefined && isSpindle(of.model.text);
  const lines = spindle && !of.data.length ? ofSpindle(of, make) : ofData(of, make);
  if (of.designation) lines.unshift('# Without a saved model.toml, this command writes the model from the designation.', make.unlessSaved('model.toml', ...newModel(of.designation, spindle, of.oil).arguments.slice(0, -2)));
  if (make.written.size) lines.unshift('# Existing files with these names are renamed first.', `for file in ${[...make.written].map(forShell).join(' ')}; do [ ! -e $file ] || mv $file before-$file; done`);
  return `${lines.join('\n')}\n`;
}

/// Rows of a programme get another name where the programme has that one: a command may not overwrite what it reads.
const rowsFile = (of: Case): string => (of.programme?.name === 'run.csv' ? 'rows.csv' : 'run.csv');

function ofSpindle(of: Case, make: Lines): string[] {
  const line = make.run.bind(make);
  const coolant = of.coolantOff ? ['--coolant', 'off'] : [];
  return [
    line('spindle', 'model.toml', ...state(of), '--report', 'steady.html'),
    ...(of.programme ? [line('spindle', 'model.toml', '--speed-profile', named(of.programme), ...coolant, '-o', rowsFile(of), '--report', 'programme.html')] : []),
    line('modes', 'model.toml', '--speed', of.modeSpeeds, '--report', 'modes.html'),
  ];
}

function ofData(of: Case, make: Lines): string[] {
  const line = make.run.bind(make);
  const data = of.data.map(named);
  const columns = reading(of);
  const fit = [...columns, ...span(of)];
  const force = of.forced ? ['--force'] : [];
  const lines: string[] = [];
  const first = of.start ? 'start.toml' : 'model.toml';
  if (of.fromRecord) lines.push(make.unlessSaved(first, 'new', '--record', ...data.slice(0, 1), ...(of.map ? ['--columns', 'columns.toml'] : [])));
  if (of.start) lines.push(line('identify', first, ...data.slice(0, 1), ...fit, ...(of.bank ? ['--lags', 'auto'] : []), '-o', 'model.toml'));
  if (of.map) lines.unshift(make.unlessSaved('columns.toml', 'check', first, ...data.slice(0, 1), '--suggest-columns'));
  let model = 'model.toml';
  if (of.law) {
    lines.push(line('add', model, `law:${of.law}`, '--data', ...data, ...fit, ...force, '-o', `${of.law}.toml`));
    model = `${of.law}.toml`;
  }
  lines.push(line('diagnose', model, ...data, ...fit));
  const improved = of.on.length > 0 || !of.start;
  if (of.on.length) lines.push(line('add', model, ...of.on, '--data', ...data, ...fit, ...force, '-o', 'improved.toml', '--report', 'report.html'), line('diagnose', 'improved.toml', ...data, ...fit));
  else if (improved) lines.push(line('calibrate', model, ...data, ...fit, '-o', 'improved.toml'));
  lines.push(line('compare', ...(of.start ? [first] : []), model, ...(improved ? ['improved.toml'] : []), ...data, ...columns, ...span(of, true), '--report', 'compare.html'));
  return lines;
}

export function pythonCommands(of: Case): string {
  return `${(of.model && isSpindle(of.model.text) && !of.data.length ? pythonOfSpindle(of) : pythonOfData(of)).join('\n')}\n`;
}

const numbers = (speeds: string): string => {
  const [from, to, step] = speeds.split(':');
  return to === undefined ? (from as string) : `range(${from}, ${to} + 1, ${step ?? to})`;
};

function pythonOfSpindle(of: Case): string[] {
  const coolant = of.coolantOff ? ', coolant=False' : '';
  const loads = [...(of.axialLoad ? [`, axial_load_N=${of.axialLoad}`] : []), ...(of.radialLoad ? [`, radial_load_N=${of.radialLoad}`] : [])].join('');
  return [
    'import raceway',
    '',
    'spindle = raceway.Model.read("model.toml")',
    `print(spindle.steady(${numbers(of.speed)}${coolant}${loads}).to_frame().T)`,
    ...(of.programme ? [`run = spindle.simulate(raceway.Record.read(${forPython(named(of.programme))})${coolant})`, `run.save("${rowsFile(of)}", overwrite=True)`] : []),
    `print(spindle.modes(${numbers(of.modeSpeeds)}).to_frame()[["speed_rpm", "frequency_Hz", "whirl"]])`,
  ];
}

/// "26h" in seconds.
function seconds(time: string): string {
  const [, value = '', unit = ''] = /^([\d.]+)\s*(s|min|h|d)?$/.exec(time) ?? [];
  return String(Number(value) * ({ min: 60, h: 3600, d: 86400 }[unit] ?? 1));
}

function pythonOfData(of: Case): string[] {
  const columns = `${of.map ? ', columns=open("columns.toml").read()' : ''}${of.dropNan ? ', drop_nan=True' : ''}`;
  const until = span(of).length ? `, until_s=${seconds(of.until)}` : '';
  const own = `${of.rows ? ', rows=True' : ''}${of.channel ? `, channel=${forPython(of.channel)}` : ''}`;
  const rows = `${own}${until}`;
  const judged = `${own}${until ? `, from_s=${seconds(of.until)}, zero="none"` : ''}`;
  const records = of.data.map((d) => `raceway.Record.read(${forPython(named(d))}${columns})`);
  const lines = ['import raceway', '', `record = ${records.length > 1 ? `[${records.join(', ')}]` : (records[0] ?? '')}`];
  if (of.start) lines.push('start = raceway.read("start.toml")', `model = start.identify(record${of.bank ? ', lags_s="auto"' : ''}${until}).correction`);
  else lines.push('model = raceway.read("model.toml")');
  if (of.law) lines.push(`model = model.add(${forPython(`law:${of.law}`)}, record${rows}).model`);
  lines.push(`print(model.diagnose(record${rows}).headline)`);
  if (of.on.length) lines.push(`better = model.add([${of.on.map(forPython).join(', ')}], record${rows}).model`, `print(better.diagnose(record${rows}).headline)`);
  else lines.push(of.start ? 'better = model' : `better = model.calibrate(record${rows}).model`);
  lines.push(`print(better.compare(record${judged}))`, 'better.save("improved.toml", overwrite=True)');
  return lines;
}
