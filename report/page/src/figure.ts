// One picture with what belongs to it: title, note, choices, chart, table, CSV.
import { BarChart, CustomChart, HeatmapChart, LineChart, ScatterChart } from 'echarts/charts';
import { AriaComponent, GridComponent, LegendComponent, MarkAreaComponent, MarkLineComponent, PolarComponent, TooltipComponent, VisualMapComponent } from 'echarts/components';
import * as echarts from 'echarts/core';
import type { ECharts } from 'echarts/core';
import { CanvasRenderer, SVGRenderer } from 'echarts/renderers';
import { fonts } from './chart';
import type { Option } from './chart';
import { darkQuery, look, printQuery, setPrinting } from './look';
import type { Look } from './look';
import { dash, el, number } from './text';

echarts.use([
  AriaComponent,
  BarChart,
  CanvasRenderer,
  CustomChart,
  GridComponent,
  HeatmapChart,
  LegendComponent,
  LineChart,
  MarkAreaComponent,
  MarkLineComponent,
  PolarComponent,
  ScatterChart,
  SVGRenderer,
  TooltipComponent,
  VisualMapComponent,
]);

export type Cell = string | number | null;

/// Columns with units; a cell is text or a number in full.
export interface Table {
  columns: string[];
  rows: Cell[][];
}

export interface FigureSpec {
  id: string;
  title: string | (() => string);
  note?: string | (() => string);
  wide?: boolean;
  height?: number | ((width: number) => number);
  /// Of the height, on paper.
  onPaper?: number;
  /// How many marks there will be: many are drawn on a canvas, few as vectors.
  marks?: number;
  controls?: HTMLElement[];
  option: (look: Look, width: number) => Option;
  /// Shown under the picture.
  table: () => Table;
  /// Behind the button; the table where absent.
  csv?: () => Table;
}

const mostTableRows = 200;
const manyMarks = 1200;
// On paper the page is two columns of this width.
const printColumn = 312;
const printWide = 676;

export class Figure {
  readonly element: HTMLElement;
  private readonly canvas = el('div', { class: 'chart' });
  private readonly title = el('h3', {});
  private readonly note = el('p', { class: 'note' });
  private readonly numbers: HTMLDetailsElement;
  private chart: ECharts | undefined;

  constructor(private readonly spec: FigureSpec) {
    this.numbers = el('details', {}, el('summary', {}, 'Table'));
    this.numbers.addEventListener('toggle', () => this.fillTable());
    const button = el('button', { type: 'button', class: 'csv', title: 'Save the numbers of this picture as CSV' }, 'CSV');
    button.addEventListener('click', () => save(`${spec.id}.csv`, csvText((spec.csv ?? spec.table)())));
    const picture = (kind: 'PNG' | 'SVG') => {
      const b = el('button', { type: 'button', class: 'picture', title: `Save this picture as ${kind}` }, kind);
      b.addEventListener('click', () => void this.savePicture(kind));
      return b;
    };
    const saving = el('div', { class: 'saving' }, picture('PNG'), picture('SVG'), button);
    const head = el('div', { class: 'head' }, this.title);
    if (spec.controls?.length) head.append(el('div', { class: 'controls' }, ...spec.controls));
    this.element = el('figure', { class: spec.wide ? 'wide' : '', id: spec.id }, head);
    if (spec.note) this.element.append(this.note);
    this.element.append(this.canvas, el('div', { class: 'foot' }, this.numbers, saving));
    this.canvas.setAttribute('role', 'img');
    this.tell();
    all.push(this);
  }

  private tell(): void {
    const { note = '', title } = this.spec;
    this.title.textContent = typeof title === 'string' ? title : title();
    this.note.textContent = typeof note === 'string' ? note : note();
    this.canvas.setAttribute('aria-label', `${this.title.textContent}. ${this.note.textContent}`.trim());
  }

  /// Draws with the look of the moment; anew where a choice has changed.
  draw(): void {
    const l = look();
    const width = l.print ? (this.element.classList.contains('wide') ? printWide : printColumn) : this.canvas.clientWidth;
    if (width === 0) return;
    this.tell();
    const { height = 320, onPaper = 0.73 } = this.spec;
    const onScreen = typeof height === 'number' ? height : height(width);
    const tall = l.print ? Math.round(onScreen * onPaper) : onScreen;
    this.canvas.style.height = `${tall}px`;
    if (!this.chart) this.chart = echarts.init(this.canvas, null, { renderer: (this.spec.marks ?? 0) > manyMarks ? 'canvas' : 'svg', width, height: tall });
    else this.chart.resize({ width, height: tall });
    this.chart.setOption({ ...common(l), ...this.spec.option(l, width) }, { notMerge: true });
    if (this.numbers.open) this.fillTable();
  }

  drawFirst(): void {
    if (!this.chart) this.draw();
  }

  dispose(): void {
    this.chart?.dispose();
    this.chart = undefined;
  }

  /// The picture as it is seen, drawn once more for the file.
  private async savePicture(kind: 'PNG' | 'SVG'): Promise<void> {
    const l = look();
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const vectors = kind === 'SVG';
    const chart = vectors ? echarts.init(null, null, { renderer: 'svg', ssr: true, width, height }) : echarts.init(el('div', {}), null, { renderer: 'canvas', devicePixelRatio: 2, width, height });
    chart.setOption({ ...common(l), ...this.spec.option(l, width), backgroundColor: l.surface });
    const name = `${this.spec.id}.${kind.toLowerCase()}`;
    if (vectors) saveBlob(name, new Blob([chart.renderToSVGString()], { type: 'image/svg+xml' }));
    else {
      const picture = chart.renderToCanvas({ pixelRatio: 2, backgroundColor: l.surface });
      const blob = await new Promise<Blob | null>((done) => picture.toBlob(done, 'image/png'));
      if (blob) saveBlob(name, blob);
    }
    chart.dispose();
  }

  private fillTable(): void {
    this.numbers.querySelector('.scroll')?.remove();
    if (!this.numbers.open) return;
    const table = this.spec.table();
    const shown = table.rows.slice(0, mostTableRows);
    const body = el('tbody', {});
    for (const row of shown)
      body.append(el('tr', {}, ...row.map((cell) => (typeof cell === 'string' ? el('td', {}, cell) : el('td', { class: 'number', 'data-value': cell === null ? '' : String(cell) }, cell === null ? dash : number(cell, 5))))));
    const first = table.rows[0] ?? [];
    const head = el('tr', {}, ...table.columns.map((name, k) => el('th', { class: typeof first[k] === 'string' ? '' : 'number', scope: 'col' }, name)));
    const scroll = el('div', { class: 'scroll', tabindex: '0' }, el('table', {}, el('thead', {}, head), body));
    if (shown.length < table.rows.length) scroll.append(el('p', { class: 'note' }, `${shown.length} of ${table.rows.length} rows; the CSV has all of them.`));
    this.numbers.append(scroll);
  }
}

const all: Figure[] = [];

function common(l: Look): Option {
  return { animation: false, backgroundColor: 'transparent', color: l.kinds, textStyle: { color: l.ink, fontFamily: fonts, fontSize: 12 } };
}

/// A tooltip whose content is built of text nodes: `lines` gives label and value, or one text.
export function tooltip(l: Look, lines: (hit: Hit) => (string | [string, string])[] | null): Option {
  return {
    trigger: 'item',
    confine: true,
    renderMode: 'html',
    backgroundColor: l.surface,
    borderColor: l.rule,
    borderWidth: 1,
    padding: 10,
    transitionDuration: 0,
    textStyle: { color: l.ink, fontSize: 12 },
    formatter: (hit: Hit) => {
      const content = lines(hit);
      if (!content) return '';
      const list = el('div', { class: 'tip' });
      for (const line of content)
        if (typeof line === 'string') list.append(el('strong', {}, line));
        else list.append(el('span', {}, line[0]), el('b', {}, line[1]));
      return list;
    },
  };
}

export interface Hit {
  componentType: string;
  seriesIndex: number;
  seriesName: string;
  dataIndex: number;
  name: string;
  value: unknown;
  data: unknown;
}

// RFC 4180; no spreadsheet takes a text for a formula.
function quoted(cell: Cell): string {
  if (cell === null) return '';
  const text = typeof cell === 'string' && /^[=+\-@\t\r]/.test(cell) ? `'${cell}` : String(cell);
  return /[",\n\r]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

export function csvText(table: Table): string {
  return [table.columns, ...table.rows].map((row) => row.map(quoted).join(',')).join('\r\n') + '\r\n';
}

function save(name: string, text: string): void {
  saveBlob(name, new Blob([text], { type: 'text/csv' }));
}

export function saveBlob(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = el('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/// Draws all pictures, seen or not, and marks the page; of a large one piece by piece, so that it
/// stays alive meanwhile.
export function drawAll(): void {
  let next = 0;
  // Pages of usual size are whole when they are loaded, as whoever takes a picture of one expects.
  let budget = 3000;
  const step = () => {
    const until = performance.now() + budget;
    budget = 40;
    while (next < all.length && performance.now() < until) (all[next++] as Figure).draw();
    if (next < all.length) setTimeout(step, 0);
    else document.documentElement.dataset.drawn = 'yes';
  };
  step();
  followWindow();
}

/// Draws anew what the window changes: its width, its colours, paper.
export function followWindow(): void {
  let width = window.innerWidth;
  window.addEventListener('resize', () => {
    if (window.innerWidth === width || look().print) return;
    width = window.innerWidth;
    redrawAll();
  });
  darkQuery.addEventListener('change', redrawAll);
  printQuery.addEventListener('change', redrawAll);
  window.addEventListener('beforeprint', () => {
    setPrinting(true);
    redrawAll();
  });
  window.addEventListener('afterprint', () => {
    setPrinting(false);
    redrawAll();
  });
}

function redrawAll(): void {
  for (const figure of all) figure.draw();
}

/// Lets go of the pictures that are no longer on the page, and draws those that are new: many or large ones piece by piece.
export function drawNew(): void {
  for (let k = all.length - 1; k >= 0; --k) {
    const figure = all[k] as Figure;
    if (figure.element.isConnected) continue;
    figure.dispose();
    all.splice(k, 1);
  }
  const list = [...all];
  const step = (budget: number) => {
    const until = performance.now() + budget;
    while (list.length && performance.now() < until) {
      const figure = list.shift() as Figure;
      if (figure.element.isConnected) figure.drawFirst();
    }
    if (list.length) setTimeout(() => step(30), 0);
  };
  step(150);
}

/// A choice above a picture.
export function choice(label: string, options: string[], chosen: number, change: (index: number) => void): HTMLElement {
  const select = el('select', {});
  options.forEach((text, k) => select.append(el('option', { value: String(k) }, text)));
  select.selectedIndex = chosen;
  select.addEventListener('change', () => change(select.selectedIndex));
  return el('label', { class: 'choice' }, el('span', {}, label), select);
}
