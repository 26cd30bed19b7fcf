// Colours: Okabe and Ito's for kinds, viridis for ordered levels, blue to vermilion for signs. All are
// told apart by colour-blind readers; in black and white by symbol, line or number.

export interface Look {
  dark: boolean;
  print: boolean;
  ink: string;
  muted: string;
  rule: string;
  surface: string;
  band: string;
  kinds: string[];
  negative: string;
  positive: string;
}

const light: Look = {
  dark: false,
  print: false,
  ink: '#1b2430',
  muted: '#5a6675',
  rule: '#e3e7ec',
  surface: '#ffffff',
  band: 'rgba(90,102,117,0.18)',
  kinds: ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9', '#000000'],
  negative: '#0072B2',
  positive: '#D55E00',
};

const dark: Look = {
  dark: true,
  print: false,
  ink: '#e8edf2',
  muted: '#9aa7b5',
  rule: '#2b3540',
  surface: '#171d24',
  band: 'rgba(170,184,199,0.20)',
  kinds: ['#56B4E9', '#E69F00', '#009E73', '#CC79A7', '#F0E442', '#D55E00', '#e8edf2'],
  negative: '#56B4E9',
  positive: '#E69F00',
};

export const printQuery = window.matchMedia('print');
export const darkQuery = window.matchMedia('(prefers-color-scheme: dark)');
let printing = false;
export function setPrinting(on: boolean): void {
  printing = on;
}

export function look(): Look {
  if (printing || printQuery.matches) return { ...light, print: true, rule: '#d5dae0' };
  return darkQuery.matches ? dark : light;
}

export const symbols = [
  'circle',
  'triangle',
  'rect',
  'diamond',
  'path://M3 0h4v3h3v4h-3v3h-4v-3h-3v-4h3z', // plus
  'path://M0 0h10l-5 9z', // triangle, point down
  'path://M0 3h10v4h-10z', // bar
  'path://M3 0h4v10h-4z', // pillar
];
export const dashes = ['solid', 'dashed', 'dotted', [8, 3, 2, 3]];

export const viridis = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725'];

function channels(colour: string): number[] {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
}

function mix(a: string, b: string, share: number): string {
  const [p, q] = [channels(a), channels(b)];
  return (
    '#' +
    p
      .map((v, k) =>
        Math.round(v + ((q[k] as number) - v) * share)
          .toString(16)
          .padStart(2, '0'),
      )
      .join('')
  );
}

/// Colours of ordered levels that stand out from the page.
export function ordered(count: number, l: Look): string[] {
  // On paper nothing is as light as to get lost.
  const [from, to] = l.dark ? [0.34, 1.0] : [0.0, l.print ? 0.62 : 0.8];
  return Array.from({ length: count }, (_, k) => {
    const at = (from + (to - from) * (count === 1 ? 0.4 : k / (count - 1))) * (viridis.length - 1);
    return level(at / (viridis.length - 1));
  });
}

/// Colour at a share of the whole scale of levels, where a scale beside it says what it means.
export function level(share: number): string {
  const at = Math.min(1, Math.max(0, share)) * (viridis.length - 1);
  const index = Math.min(viridis.length - 2, Math.floor(at));
  return mix(viridis[index] as string, viridis[index + 1] as string, at - index);
}

/// Colour of a value in [-1, 1].
export function diverging(value: number, l: Look): string {
  const end = value < 0 ? l.negative : l.positive;
  return mix(l.surface, end, Math.min(1, Math.abs(value)) * 0.85);
}

/// Black or white, whichever reads better on a colour.
export function inkOn(colour: string): string {
  const [r, g, b] = channels(colour).map((v) => (v / 255) ** 2.2) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.19 ? '#10161d' : '#ffffff';
}
