// The map of columns: which column of the file is which quantity, as `check --suggest-columns` writes it.
import type { Reading } from './state';
import { entries, plainValue, quoted } from './toml';

export interface Mapped {
  ours: string; // "speed_rpm"
  column: string; // of the file; '' where a number stands for it, or nothing does
  unit: string; // '' where the name says it
  number: string; // instead of a column
}

/// Lines of [columns]; commented ones are quantities that were not found.
export function readMap(text: string): { mapped: Mapped[]; absent: string[]; unused: string[] } {
  const mapped = entries(text)
    .filter((e) => e.table === 'columns')
    .map((e): Mapped => {
      const part = (name: string) => {
        const found = new RegExp(`\\b${name}\\s*=\\s*("(?:[^"\\\\]|\\\\.)*"|'[^']*')`).exec(e.value);
        return found ? plainValue(found[1] as string) : '';
      };
      if (e.value.startsWith('{')) return { ours: e.key, column: part('column'), unit: part('unit'), number: '' };
      return /^["']/.test(e.value) ? { ours: e.key, column: plainValue(e.value), unit: '', number: '' } : { ours: e.key, column: '', unit: '', number: e.value };
    });
  const lines = text.split('\n');
  const absent = lines.flatMap((line) => /^#\s*([a-z_A-Z0-9]+)\s*=/.exec(line)?.[1] ?? []);
  const unused = lines.filter((line) => line.startsWith('# not used:')).flatMap((line) => [...line.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map((m) => plainValue(m[0])));
  return { mapped, absent, unused };
}

export function writeMap(mapped: Mapped[]): string {
  const lines = mapped.filter((m) => m.column || m.number).map((m) => `${m.ours} = ${m.number ? m.number : m.unit ? `{ column = ${quoted(m.column)}, unit = ${quoted(m.unit)} }` : quoted(m.column)}`);
  return ['[columns]', ...lines, ''].join('\n');
}

const separators = [',', ';', '\t'];

/// Cells of a line, quotes taken off.
export function cells(line: string, separator: string): string[] {
  const found: string[] = [];
  let cell = '';
  let quoted = false;
  for (let k = 0; k < line.length; ++k) {
    const c = line[k] as string;
    if (quoted) {
      if (c === '"' && line[k + 1] === '"') cell += line[++k];
      else if (c === '"') quoted = false;
      else cell += c;
    } else if (c === '"') quoted = true;
    else if (c === separator) {
      found.push(cell.trim());
      cell = '';
    } else cell += c;
  }
  return [...found, cell.trim()];
}

/// The first rows of a file under their header, to be looked at. The engine reads it by itself.
export function preview(text: string, names: string[], rows: number): { header: string[]; rows: string[][]; lines: number; total: number } {
  const head = text
    .slice(0, 200_000)
    .split(/\r\n|\r|\n/)
    .slice(0, 200);
  const separator = separators.map((s) => ({ s, count: Math.max(...head.slice(0, 40).map((line) => cells(line, s).length)) })).sort((a, b) => b.count - a.count)[0]?.s ?? ',';
  const split = head.map((line) => cells(line, separator));
  const holds = (line: string[]) => names.filter((name) => line.includes(name)).length;
  const best = Math.max(...split.map(holds), 0);
  let at = best > 0 ? split.findIndex((line) => holds(line) === best) : split.findIndex((line) => line.length > 1 && !line[0]?.startsWith('#'));
  if (at < 0) at = 0;
  let total = text.endsWith('\n') || text === '' ? 0 : 1;
  for (let end = text.indexOf('\n'); end >= 0; end = text.indexOf('\n', end + 1)) ++total;
  return {
    header: split[at] ?? [],
    rows: split
      .slice(at + 1)
      .filter((line) => line.some((c) => c !== ''))
      .slice(0, rows),
    lines: at + 1,
    total,
  };
}

const largest = 4e6; // characters of a file that is read whole where a look at it is enough

/// The head of a large file and of its other lines as many as are looked at, evenly spread; a file of usual size as it is.
export function thinned(text: string, most = 20_000): string {
  if (text.length < largest) return text;
  const ends: number[] = [];
  for (let end = text.indexOf('\n'); end >= 0; end = text.indexOf('\n', end + 1)) ends.push(end + 1);
  const whole = 200; // lines, of the head and the first rows
  const step = Math.ceil(ends.length / most);
  const lines = [text.slice(0, ends[whole])];
  for (let k = whole; k + 1 < ends.length; k += step) lines.push(text.slice(ends[k], ends[k + 1]));
  return lines.join('');
}

/// Numbers of a CSV that `check -o` wrote, by column; of many rows as many as are drawn, evenly spread.
export function numbersOf(text: string, most = 500): Map<string, Float64Array> {
  const lines = text.split('\n').filter((line) => line && !line.startsWith('#'));
  const names = cells(lines[0] ?? '', ',');
  const rows = Math.max(0, lines.length - 1);
  const count = Math.min(rows, most);
  const columns = names.map(() => new Float64Array(count));
  for (let k = 0; k < count; ++k) {
    const line = cells(lines[1 + Math.floor((k * rows) / count)] as string, ',');
    columns.forEach((column, c) => (column[k] = line[c] === '' || line[c] === undefined ? NaN : Number(line[c])));
  }
  return new Map(names.map((name, c) => [name, columns[c] as Float64Array]));
}

/// Several files as one record: all rows, in their order. The noise of each is its own and stands with none.
export function joined(readings: Reading[]): Reading {
  const [first, ...others] = readings as [Reading, ...Reading[]];
  if (!others.length) return first;
  const parts = (name: string) => readings.flatMap((r) => r.columns.filter((c) => c.name === name));
  const known = (values: (number | null)[]) => values.filter((v): v is number => v !== null);
  const names = [...new Set(readings.flatMap((r) => r.columns.map((c) => c.name)))];
  const columns = names.map((name) => {
    const [from, to] = [known(parts(name).map((c) => c.from)), known(parts(name).map((c) => c.to))];
    return { name, from: from.length ? Math.min(...from) : null, to: to.length ? Math.max(...to) : null, levels: Math.max(...parts(name).map((c) => c.levels)) };
  });
  const numbers = new Map([...new Set(readings.flatMap((r) => [...r.numbers.keys()]))].map((name) => [name, Float64Array.from(readings.flatMap((r) => [...(r.numbers.get(name) ?? [])]))]));
  const said = readings.flatMap((r) => r.said).filter((s, k, all) => all.findIndex((other) => other.text === s.text) === k);
  return { ...first, said, rows: readings.reduce((sum, r) => sum + r.rows, 0), columns, noise: { rms: null, source: '' }, numbers };
}

/// The text of a file: UTF-8 or UTF-16 where it is that, else Windows-1252, as spreadsheets of the West save.
export function decoded(bytes: ArrayBuffer): string {
  const [a, b] = new Uint8Array(bytes.slice(0, 2));
  if (a === 0xff && b === 0xfe) return new TextDecoder('utf-16le').decode(bytes);
  if (a === 0xfe && b === 0xff) return new TextDecoder('utf-16be').decode(bytes);
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}
