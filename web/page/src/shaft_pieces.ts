// The pieces of a shaft in the text of a model: [[shaft.segment]] tables, or a list `segment = [{...}, ...]` of [shaft].

interface Place {
  value: string;
  from: number; // in the text
  to: number;
}

export interface Piece {
  from: number;
  to: number;
  inline: boolean;
  keys: Map<string, Place>;
}

const pair = /\b(\w+)(\s*=\s*)("[^"]*"|[^,\s}#]+)/g;

function keysIn(text: string, from: number, to: number): Map<string, Place> {
  const keys = new Map<string, Place>();
  for (const found of text
    .slice(from, to)
    .replace(/#.*/g, (comment) => ' '.repeat(comment.length))
    .matchAll(pair)) {
    const [, key, equals, value] = found as unknown as [string, string, string, string];
    const at = from + found.index + key.length + equals.length;
    keys.set(key, { value, from: at, to: at + value.length });
  }
  return keys;
}

/// From the nose to the rear.
export function pieces(text: string): Piece[] {
  const tables = [...text.matchAll(/^\s*\[\[shaft\.segment\]\].*$/gm)].map((head) => {
    const start = head.index + head[0].indexOf('[[');
    const next = /^\s*\[/gm;
    next.lastIndex = head.index + head[0].length;
    const to = next.exec(text)?.index ?? text.length;
    return { from: start, to, inline: false, keys: keysIn(text, head.index + head[0].length, to) };
  });
  if (tables.length) return tables;
  const shaft = /^\s*\[shaft\]/m.exec(text);
  const list = shaft && /^\s*segment\s*=\s*\[/m.exec(text.slice(shaft.index));
  if (!shaft || !list) return [];
  const found: Piece[] = [];
  const brace = /\{[^}]*\}|\]/g;
  brace.lastIndex = shaft.index + list.index + list[0].length;
  for (let m = brace.exec(text); m && m[0] !== ']'; m = brace.exec(text)) found.push({ from: m.index, to: m.index + m[0].length, inline: true, keys: keysIn(text, m.index, m.index + m[0].length) });
  return found;
}

/// Sets a number of a piece; an empty one takes the key out.
export function withPiece(text: string, at: number, key: string, value: string): string {
  const piece = pieces(text)[at];
  if (!piece) return text;
  const place = piece.keys.get(key);
  if (place && value) return text.slice(0, place.from) + value + text.slice(place.to);
  if (place) {
    const before = text.slice(0, place.from);
    const cut = before.replace(new RegExp(`${piece.inline ? ',?' : '\\n?'}\\s*${key}\\s*=\\s*$`), '');
    return cut + text.slice(place.to);
  }
  if (!value) return text;
  const end = piece.inline ? piece.to - 1 : Math.max(...[...piece.keys.values()].map((p) => p.to));
  return `${text.slice(0, end)}${piece.inline ? ', ' : '\n'}${key} = ${value}${text.slice(end)}`;
}

/// A copy of a piece behind it.
export function doubled(text: string, at: number): string {
  const piece = pieces(text)[at];
  if (!piece) return text;
  const own = text.slice(piece.from, piece.to);
  return `${text.slice(0, piece.to)}${piece.inline ? ', ' : ''}${own}${text.slice(piece.to)}`;
}

export function withoutPiece(text: string, at: number): string {
  const all = pieces(text);
  const piece = all[at];
  if (!piece || all.length < 2) return text;
  if (!piece.inline) return text.slice(0, piece.from) + text.slice(piece.to);
  const behind = text.slice(piece.to);
  const last = at === all.length - 1;
  // One comma goes with it: that behind, of the last one that before.
  return last ? text.slice(0, (all[at - 1] as Piece).to) + behind : text.slice(0, piece.from) + behind.replace(/^\s*,[ \t]*/, '');
}
