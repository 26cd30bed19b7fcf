// Words and numbers for people. All text that comes from files goes through here into text nodes.

/// An element with text and children; strings become text nodes, never markup.
export function el<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Record<string, string> = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

export const dash = '–';

export function capital(text: string): string {
  return `${text.slice(0, 1).toUpperCase()}${text.slice(1)}`;
}

/// Words of the command as people print them.
export function printed(text: string): string {
  return text
    .replace(/ -> /g, ' → ')
    .replace(/\+- /g, '± ')
    .replace(/\bum\b/g, 'µm')
    .replace(/(\d) (?=\d{3}\b|N mm|rpm|µm|N\b|K\b|C\b)/g, '$1\u00a0')
    .replace(/(\d*)[ \u00a0]C\b(?= |\.|,|;|$|\))/g, (all: string, digits: string) => (digits.length > 3 ? all : `${digits}\u00a0°C`)); // 6014 C is a bearing
}

/// So many significant digits, without exponent where people would write none.
export function number(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return dash;
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  const magnitude = Math.floor(Math.log10(Math.abs(value)));
  const text = magnitude < -4 || magnitude > 7 ? value.toExponential(digits - 1) : value.toFixed(Math.min(20, Math.max(0, digits - 1 - magnitude)));
  return text.replace('-', '−');
}

/// Digits as they are read, without trailing zeros: 16000, 25.4.
export function plain(value: number | null | undefined, digits = 6): string {
  if (value === null || value === undefined || Number.isNaN(value)) return dash;
  return String(Number(value.toPrecision(digits))).replace('-', '−');
}

/// The next round number above.
export function plainCeiling(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * ([1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((m) => m * power > 1.05 * value) ?? 12);
}

/// With a sign, and so many decimals.
export function fixed(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? '0' : (value > 0 ? '+' : '') + text.replace('-', '−');
}

export function signed(value: number, digits = 3): string {
  return (value > 0 ? '+' : '') + number(value, digits);
}

export function probability(p: number | null): string {
  if (p === null) return dash;
  if (p < 1e-300) return 'p < 1e-300';
  return p < 1e-3 ? `p = ${p.toExponential(0)}` : `p = ${Number(p.toPrecision(2))}`;
}

const units: [string, string][] = [
  ['_Nmm', 'N mm'],
  ['_Nm', 'N m'],
  ['_N_um', 'N/µm'],
  ['_rpm', 'rpm'],
  ['_MPa', 'MPa'],
  ['_m_min', 'm/min'],
  ['_deg', '°'],
  ['_mm', 'mm'],
  ['_um', 'µm'],
  ['_urad', 'µrad'],
  ['_Hz', 'Hz'],
  ['_min', 'min'],
  ['_K', 'K'],
  ['_N', 'N'],
  ['_C', '°C'],
  ['_W', 'W'],
  ['_s', 's'],
];

/// "Nmm" -> "N mm"
export function unitOfKey(key: string): string {
  return units.find(([suffix]) => suffix === `_${key}`)?.[1] ?? key;
}

/// "axial_load_N" -> { label: "axial load", unit: "N" }
export function quantity(name: string): { label: string; unit: string } {
  for (const [suffix, unit] of units) if (name.endsWith(suffix)) return { label: name.slice(0, -suffix.length).replace(/_/g, ' '), unit };
  return { label: name.replace(/_/g, ' '), unit: '' };
}

/// "axial load [N]"
export function axisTitle(name: string): string {
  const { label, unit } = quantity(name);
  return unit ? `${label} [${unit}]` : label;
}

export function withUnit(value: number, name: string): string {
  const { unit } = quantity(name);
  return unit === '°' ? `${plain(value, 4)}°` : `${plain(value, 4)}${unit ? ` ${unit}` : ''}`;
}

/// A unit as files write it, "1" for none.
export function unitText(unit: string): string {
  return unit === '1' ? '' : unit;
}

/// Paths by their file names, with as many of their folders as tell them apart.
export function shortPaths(paths: string[]): string[] {
  const parts = paths.map((p) => p.split('/'));
  const end = (p: string[], count: number) => p.slice(-count).join('/');
  return parts.map((p, k) => {
    let count = 1;
    while (count < p.length && parts.some((q, j) => paths[j] !== paths[k] && end(q, count) === end(p, count))) ++count;
    return end(p, count);
  });
}

/// A small table of text under a title.
export function valueList(title: string, columns: string[], rows: string[][]): HTMLElement {
  const body = el('tbody', {}, ...rows.map((row) => el('tr', {}, ...row.map((cell) => el('td', {}, cell)))));
  return el(
    'div',
    { class: rows.length > 8 ? 'list' : 'list short' },
    ...(title ? [el('h3', {}, title)] : []),
    el('div', { class: 'scroll', tabindex: '0' }, el('table', {}, el('thead', {}, el('tr', {}, ...columns.map((c) => el('th', { scope: 'col' }, c)))), body)),
  );
}
