// Reads and changes single keys in the text of a model, so that its comments and its order stay as they are.
// The engine reads the whole text and judges it; this finds lines.

export interface Entry {
  table: string; // "lubricant"; "effect" of [[effect]]
  index: number; // which of several tables of that name
  key: string;
  value: string; // as it stands in the text
  comment: string; // behind it, without #
  line: number; // from 0
}

const header = /^\s*(\[\[?)\s*([^\]]*?)\s*\]\]?\s*(?:#(.*))?$/;
const assignment = /^(\s*)([A-Za-z0-9_-]+)(\s*=\s*)(.*)$/;

/// Splits "22.0   # of a grease" into value and comment; # within quotes belongs to the value.
function split(text: string): { value: string; comment: string } {
  let quote = '';
  for (let k = 0; k < text.length; ++k) {
    const c = text[k] as string;
    if (quote) {
      if (c === '\\' && quote === '"') ++k;
      else if (c === quote) quote = '';
    } else if (c === '"' || c === "'") quote = c;
    else if (c === '#') return { value: text.slice(0, k).trim(), comment: text.slice(k + 1).trim() };
  }
  return { value: text.trim(), comment: '' };
}

/// All keys of single lines, table by table. A remark behind a header stands for every key of its table.
export function entries(text: string): Entry[] {
  const found: Entry[] = [];
  const count = new Map<string, number>();
  let table = '';
  let index = 0;
  let open = 0; // brackets of a value over several lines
  text.split('\n').forEach((line, at) => {
    const balance = (s: string) => (s.match(/[[{]/g)?.length ?? 0) - (s.match(/[\]}]/g)?.length ?? 0);
    if (open > 0) {
      open += balance(split(line).value);
      return;
    }
    const head = header.exec(line);
    if (head) {
      table = head[2] as string;
      index = count.get(table) ?? 0;
      count.set(table, index + 1);
      return;
    }
    const set = assignment.exec(line);
    if (!set || line.trimStart().startsWith('#')) return;
    const { value, comment } = split(set[4] as string);
    found.push({ table, index, key: set[2] as string, value, comment, line: at });
    open = Math.max(0, balance(value));
  });
  return found;
}

/// The text of a value: what quotes hold, else as it stands.
export function plainValue(value: string): string {
  if (/^".*"$/.test(value)) {
    try {
      return JSON.parse(value) as string;
    } catch {
      return value.slice(1, -1);
    }
  }
  return /^'.*'$/.test(value) ? value.slice(1, -1) : value;
}

export const quoted = (text: string): string => JSON.stringify(text).replace(/\u007f/g, '\\u007F');

/// A correction of displacements over time, or several.
export const isCorrection = (text: string): boolean => /^\s*\[\[?correction\]/m.test(text);

/// A spindle with its shaft and housing.
export const isSpindle = (text: string): boolean => /^\s*\[shaft\]/m.test(text) && /^\s*\[housing\]/m.test(text);

/// Displacements of a model that has several corrections.
export function channelsOf(text: string): string[] {
  const found = entries(text)
    .filter((e) => e.table === 'correction' && e.key === 'displacement')
    .map((e) => plainValue(e.value));
  return found.length > 1 ? found : [];
}

export function valueOf(text: string, table: string, key: string): string | undefined {
  const entry = entries(text).find((e) => e.table === table && e.key === key && e.index === 0);
  return entry && plainValue(entry.value);
}

/// Sets a key; `value` as it shall stand in the text, undefined takes the key out. `comment` stands behind it.
export function withValue(text: string, table: string, key: string, value: string | undefined, comment = ''): string {
  const lines = text.split('\n');
  const all = entries(text);
  const entry = all.find((e) => e.table === table && e.key === key && e.index === 0);
  const tail = comment ? `  # ${comment}` : '';
  if (entry) {
    if (value === undefined) lines.splice(entry.line, 1);
    else {
      const keep = comment || /\b(assumed|estimated)\b/.test(entry.comment) ? tail : entry.comment ? `  # ${entry.comment}` : '';
      lines[entry.line] = `${key} = ${value}${keep}`;
    }
    return lines.join('\n');
  }
  if (value === undefined) return text;
  // A line that waits as a comment: "# supply = ..."
  const start = lines.findIndex((line) => header.exec(line)?.[1] === '[' && header.exec(line)?.[2] === table);
  if (start < 0) return `${text.replace(/\n*$/, '\n')}\n[${table}]\n${key} = ${value}${tail}\n`;
  let end = start + 1;
  let last = start;
  for (; end < lines.length && !header.test(lines[end] as string); ++end) {
    const line = lines[end] as string;
    if (new RegExp(`^#\\s*${key}\\s*=`).test(line)) {
      lines[end] = `${key} = ${value}${tail}`;
      return lines.join('\n');
    }
    if (line.trim() && !line.startsWith('#')) last = end;
  }
  lines.splice(last + 1, 0, `${key} = ${value}${tail}`);
  return lines.join('\n');
}

/// Whether the text says that a value is assumed: behind it or behind the header of its table.
export function assumedIn(text: string): Set<string> {
  const found = new Set<string>();
  const lines = text.split('\n');
  const marked = /\b(assumed|estimated)\b/;
  for (const e of entries(text)) {
    let head = e.line;
    while (head >= 0 && !header.test(lines[head] as string)) --head;
    if (marked.test(e.comment) || marked.test(header.exec(lines[head] ?? '')?.[3] ?? '')) found.add(`${e.table}.${e.key}`);
  }
  return found;
}
