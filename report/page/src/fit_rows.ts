// The rows of a data set against one of several models: measured against predicted, residuals, map.
import { band, categoryAxis, errorBars, legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { AxisRange, Predicted, ReportOfRows } from './document';
import { Rows } from './document';
import type { Cell, Hit, Table } from './figure';
import { choice, Figure, tooltip } from './figure';
import type { Group } from './groups';
import { groups, mean, rms, thinned } from './groups';
import type { Look } from './look';
import { diverging, inkOn, ordered, symbols } from './look';
import { axisTitle, el, fixed, number, plain, quantity, signed, unitOfKey } from './text';

const mostDrawn = 3000;
const mostRuns = 8;

/// Rows with what is shown of them, and what the reader has chosen.
export class FitView {
  readonly rows: Rows;
  readonly inputs: string[];
  readonly key: string; // unit of the readings as names have it: Nmm
  readonly unit: string; // N mm
  readonly what: string; // torque
  /// Columns that points may be coloured by.
  readonly colours: string[];
  model: number;
  colour: string;
  private readonly worst: Set<number>;
  private readonly figures: Figure[] = [];
  private readonly parts = new Map<string, Group[]>(); // by colour column

  constructor(
    readonly report: ReportOfRows,
    chosen: number,
  ) {
    this.rows = new Rows(report.rows);
    this.inputs = report.inputs;
    this.key = report.quantity.unit;
    this.unit = unitOfKey(this.key);
    this.what = report.quantity.in_words.split(' ').pop() ?? '';
    this.model = chosen;
    this.colours = this.inputs.filter((name) => this.rows.varies(name));
    if (report.runs.length > 1 && report.runs.length <= mostRuns) this.colours.push('run');
    this.colour = this.colours.find((name) => name === 'temperature_C') ?? this.colours.find((name) => name !== 'speed_rpm') ?? this.colours[0] ?? '';
    this.worst = new Set(this.largest(20));
  }

  predicted(model = this.model): Float64Array {
    return this.rows.get((this.report.models[model] as Predicted).column);
  }
  measured(): Float64Array {
    return this.rows.get(`measured_${this.key}`);
  }
  /// Standard deviation of every row; NaN where not known.
  std(): Float64Array {
    return this.rows.get(`std_${this.key}`);
  }
  residual(row: number): number {
    return (this.predicted()[row] as number) - (this.measured()[row] as number);
  }
  name(): string {
    return this.report.models[this.model]?.name ?? '';
  }

  private largest(count: number): number[] {
    const sizes = this.predicted().map((p, k) => Math.abs(p - (this.measured()[k] as number)));
    const least = sizes.filter(Number.isFinite).sort().at(-count) ?? 0;
    return Array.from(sizes.keys()).filter((k) => (sizes[k] as number) >= least);
  }

  add(figure: Figure): HTMLElement {
    this.figures.push(figure);
    return figure.element;
  }
  redraw(): void {
    for (const figure of this.figures) figure.draw();
  }

  /// Points in groups by the colour column, thinned for drawing.
  coloured(): Group[] {
    let parts = this.parts.get(this.colour);
    if (!parts) {
      parts = this.findParts();
      this.parts.set(this.colour, parts);
    }
    return parts;
  }
  private findParts(): Group[] {
    if (!this.colour) return [{ label: 'rows', rows: this.drawn(Array.from({ length: this.rows.count }, (_, k) => k)), from: 0, to: 0 }];
    if (this.colour === 'run') {
      const runs = this.rows.get('run');
      return this.report.runs.map((label, run) => ({ label: `run ${label}`, rows: this.drawn(Array.from(runs.keys()).filter((k) => runs[k] === run)), from: run, to: run })).filter((g) => g.rows.length > 0);
    }
    return groups(this.rows.get(this.colour), this.colour, 5).map((g) => ({ ...g, rows: this.drawn(g.rows) }));
  }
  private drawn(rows: number[]): number[] {
    return thinned(rows, Math.ceil((mostDrawn * rows.length) / Math.max(1, this.rows.count)), this.worst);
  }
  get thinned(): boolean {
    return this.rows.count > mostDrawn;
  }
  get marks(): number {
    return Math.min(this.rows.count, mostDrawn);
  }

  /// What hovering over a row tells.
  tell(row: number): (string | [string, string])[] {
    const lines: (string | [string, string])[] = [`line ${plain(this.rows.at('line', row))}`];
    if (this.rows.has('run')) lines.push(['run', this.report.runs[this.rows.at('run', row)] ?? '']);
    for (const name of ['time_s', ...this.inputs]) if (this.rows.has(name)) lines.push([quantity(name).label, `${plain(this.rows.at(name, row), 5)} ${quantity(name).unit}`]);
    lines.push(['measured', `${number(this.measured()[row])} ${this.unit}`], ['predicted', `${number(this.predicted()[row])} ${this.unit}`]);
    const std = this.std()[row] as number;
    const residual = this.residual(row);
    lines.push(['predicted − measured', `${signed(residual)} ${this.unit}${std > 0 ? ` (${signed(residual / std, 2)} σ)` : ''}`]);
    return lines;
  }

  /// All rows with what this model says of them.
  csv = (): Table => {
    const names = this.rows.names.filter((name) => !/^(predicted|effect|base|with)_/.test(name));
    const models = this.report.models.map((m) => m.column);
    const rows: Cell[][] = [];
    for (let k = 0; k < this.rows.count; ++k)
      rows.push([
        ...names.map((name) => (name === 'run' ? (this.report.runs[this.rows.at('run', k)] ?? '') : finite(this.rows.at(name, k)))),
        ...models.map((column) => finite(this.rows.at(column, k))),
        ...models.map((column) => finite(this.rows.at(column, k) - (this.measured()[k] as number))),
      ]);
    return { columns: [...names, ...this.report.models.map((m) => `predicted_${this.key}: ${m.name}`), ...this.report.models.map((m) => `residual_${this.key}: ${m.name}`)], rows };
  };
}

function finite(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}

/// A choice of the model and of the colour for all pictures of rows at once.
export function choices(view: FitView): HTMLElement {
  const bar = el('div', { class: 'choices', id: 'of-rows' });
  if (view.report.models.length > 1)
    bar.append(
      choice(
        'Model',
        view.report.models.map((m) => m.name),
        view.model,
        (index) => {
          view.model = index;
          view.redraw();
        },
      ),
    );
  if (view.colours.length > 1)
    bar.append(
      choice(
        'Colour by',
        view.colours.map((name) => quantity(name).label),
        view.colours.indexOf(view.colour),
        (index) => {
          view.colour = view.colours[index] as string;
          view.redraw();
        },
      ),
    );
  return bar;
}

function colourOf(view: FitView, k: number, count: number, l: Look): string {
  return view.colour === 'run' ? (l.kinds[k % l.kinds.length] as string) : (ordered(count, l)[k] as string);
}

function scatter(view: FitView, x: (row: number) => number, y: (row: number) => number, l: Look): { names: string[]; icons: string[]; series: Option[] } {
  const parts = view.coloured();
  return {
    names: parts.map((g) => g.label),
    icons: parts.map((_, k) => symbols[k % symbols.length] as string),
    series: parts.map((g, k) => ({
      type: 'scatter',
      name: g.label,
      z: 3,
      symbol: symbols[k % symbols.length],
      symbolSize: view.rows.count > 800 ? 4 : 7,
      itemStyle: { color: colourOf(view, k, parts.length, l), opacity: view.rows.count > 800 ? 0.6 : 0.85 },
      emphasis: { itemStyle: { borderColor: l.ink, borderWidth: 2, opacity: 1 } },
      data: g.rows.map((row) => [x(row), y(row), row]),
    })),
  };
}

function rowTooltip(view: FitView, l: Look): Option {
  return tooltip(l, (hit: Hit) => (Array.isArray(hit.value) && hit.value.length > 2 ? view.tell(hit.value[2] as number) : null));
}

/// Says on the page what is drawn of how many rows.
export function drawnNote(view: FitView): string {
  const { rows } = view;
  const kept = rows.count < rows.total ? `This page holds ${rows.count} of ${rows.total} rows: evenly spread over the file, and the rows with the largest errors. ` : '';
  const drawn = view.thinned ? `Pictures of single rows draw about ${mostDrawn} of ${rows.count}: evenly spread, and the rows with the largest errors. Lines, bands and means use all rows.` : '';
  return kept + drawn;
}

export function parity(view: FitView): HTMLElement {
  const measured = view.measured();
  return view.add(
    new Figure({
      id: 'parity',
      title: 'Measured against predicted',
      note: 'On the line, both agree. Dashed: ±2 standard deviations of the noise, if it is known.',
      height: (width) => (width < 480 ? 360 : 340),
      marks: view.marks,
      option: (l, width) => {
        const predicted = view.predicted();
        const [low, high] = niceRange([...measured, ...predicted].filter(Number.isFinite));
        const points = scatter(
          view,
          (k) => predicted[k] as number,
          (k) => measured[k] as number,
          l,
        );
        const names = [...points.names];
        const icons: string[] = [...points.icons];
        const series = [...points.series];
        const noise = noiseBand(view, (k) => predicted[k] as number);
        if (noise.length) {
          names.push('±2σ noise');
          icons.push('rect');
          series.push(
            band(
              '±2σ noise',
              noise.map(([x, s]) => [x, x - 2 * s, x + 2 * s]),
              l.band,
              l.muted,
            ),
          );
        }
        series.push({
          type: 'line',
          name: 'agreement',
          silent: true,
          symbol: 'none',
          z: 2,
          lineStyle: { color: l.ink, width: 1.2 },
          data: [
            [low, low],
            [high, high],
          ],
        });
        const top = legend(names, width, l, icons);
        return {
          legend: top.option,
          grid: { left: 56, right: 18, top: top.height + 26, bottom: 46 },
          tooltip: rowTooltip(view, l),
          xAxis: valueAxis(`predicted [${view.unit}]`, l, 'x', { min: low, max: high }),
          yAxis: valueAxis(`measured [${view.unit}]`, l, 'y', { min: low, max: high }),
          series,
        };
      },
      table: () => worstTable(view),
      csv: view.csv,
    }),
  );
}

/// Round limits around the values, the same for both axes; zero where it is near.
function niceRange(values: number[]): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const v of values) {
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  if (low > 0 && low < 0.3 * high) low = 0;
  const range = high - low || Math.abs(high) || 1;
  const power = 10 ** Math.floor(Math.log10(range / 5));
  const step = power * ([1, 2, 5, 10].find((m) => m * power >= range / 6) ?? 10);
  return [Math.floor(low / step) * step, Math.ceil(high / step) * step];
}

function worstTable(view: FitView): Table {
  const rows = Array.from({ length: view.rows.count }, (_, k) => k)
    .filter((k) => Number.isFinite(view.residual(k)))
    .sort((a, b) => Math.abs(view.residual(b)) - Math.abs(view.residual(a)) || a - b);
  const names = view.inputs.filter((name) => view.rows.varies(name));
  const noise = view.std().some((s) => s > 0);
  return {
    columns: ['line', ...names.map(axisTitle), `measured [${view.unit}]`, `predicted [${view.unit}]`, `predicted − measured [${view.unit}]`, ...(noise ? ['in σ'] : [])],
    rows: rows.map((k) => [
      view.rows.at('line', k),
      ...names.map((name) => finite(view.rows.at(name, k))),
      finite(view.measured()[k] as number),
      finite(view.predicted()[k] as number),
      finite(view.residual(k)),
      ...(noise ? [finite(view.residual(k) / (view.std()[k] as number))] : []),
    ]),
  };
}

/// [x, rms of σ] along x, over parts of equally many rows; empty where the noise is not known.
function noiseBand(view: FitView, x: (row: number) => number): [number, number][] {
  const std = view.std();
  const at = Float64Array.from({ length: view.rows.count }, (_, k) => ((std[k] as number) > 0 ? x(k) : NaN));
  const most = view.rows.varies(`std_${view.key}`) ? Math.max(1, Math.min(16, Math.floor(view.rows.count / 8))) : 1;
  const list = groups(at, '', most);
  if (list.length === 0) return [];
  const points = list.map((g): [number, number] => [mean(g.rows.map((k) => at[k] as number)), rms(g.rows.map((k) => std[k] as number))]);
  const first = list[0] as Group;
  const last = list[list.length - 1] as Group;
  return [[first.from, (points[0] as [number, number])[1]], ...points, [last.to, (points[points.length - 1] as [number, number])[1]]];
}

interface Part {
  label: string;
  x: number;
  rows: number;
  bias: number;
  rmse: number;
  error: number; // standard error of the mean
}

/// Means of the residual over parts of the x axis.
function parts(view: FitView, name: string): Part[] {
  const x = name === 'order' ? Float64Array.from({ length: view.rows.count }, (_, k) => k + 1) : view.rows.get(name);
  return groups(x, name, 8).map((g) => {
    const rows = g.rows.filter((k) => Number.isFinite(view.residual(k)));
    const residuals = rows.map((k) => view.residual(k));
    const bias = mean(residuals);
    const spread = Math.sqrt(residuals.reduce((sum, r) => sum + (r - bias) ** 2, 0) / Math.max(1, rows.length - 1));
    return { label: g.label, x: mean(rows.map((k) => x[k] as number)), rows: rows.length, bias, rmse: rms(residuals), error: spread / Math.sqrt(rows.length) };
  });
}

export function residuals(view: FitView): HTMLElement[] {
  const names = view.inputs.filter((name) => view.rows.varies(name));
  return [...names, 'order'].map((name) => {
    const label = name === 'order' ? 'order of the rows' : quantity(name).label;
    const x = (k: number) => (name === 'order' ? k + 1 : view.rows.at(name, k));
    return view.add(
      new Figure({
        id: `residual-${label.replace(/ /g, '-')}`,
        title: `Residual over ${label}`,
        marks: view.marks,
        option: (l, width) => {
          const points = scatter(view, x, (k) => view.residual(k), l);
          const entries = [...points.names];
          const icons: string[] = [...points.icons];
          const series = [...points.series];
          const noise = noiseBand(view, x);
          if (noise.length) {
            entries.push('±2σ noise');
            icons.push('rect');
            series.push(
              band(
                '±2σ noise',
                noise.map(([at, s]) => [at, -2 * s, 2 * s]),
                l.band,
                l.muted,
              ),
            );
          }
          const steps = parts(view, name);
          const means = 'mean, ±2 standard errors';
          entries.push(means);
          icons.push('diamond');
          series.push(
            { type: 'line', name: means, silent: true, symbol: 'diamond', symbolSize: 9, z: 7, itemStyle: { color: l.ink }, lineStyle: { color: l.ink, width: 1.6 }, data: steps.map((s) => [s.x, s.bias]) },
            errorBars(
              means,
              steps.filter((s) => s.rows > 1).map((s) => [s.x, s.bias - 2 * s.error, s.bias + 2 * s.error]),
              l.ink,
            ),
          );
          const top = legend(entries, width, l, icons);
          const unit = name === 'order' ? 'row, in the order of the file' : axisTitle(name);
          return {
            legend: top.option,
            grid: { left: 56, right: 18, top: top.height + 26, bottom: 46 },
            tooltip: rowTooltip(view, l),
            xAxis: valueAxis(unit, l, 'x', { ...(name === 'order' ? { min: 0, max: view.rows.count } : {}) }),
            yAxis: valueAxis(`predicted − measured [${view.unit}]`, l, 'y'),
            series,
          };
        },
        height: (width) => (width < 480 ? 360 : 340),
        table: () => ({
          columns: [name === 'order' ? 'rows' : axisTitle(name), 'number of rows', `RMS [${view.unit}]`, `mean of predicted − measured [${view.unit}]`, `standard error [${view.unit}]`],
          rows: parts(view, name).map((s) => [s.label, s.rows, s.rmse, s.bias, finite(s.error)]),
        }),
        csv: view.csv,
      }),
    );
  });
}

function rangeText(range: AxisRange): string {
  if (range.run !== undefined) return range.run === '' ? 'no run' : `run ${range.run}`;
  const [from, to] = [plain(range.from, 4), plain(range.to, 4)];
  return from === to ? from : `${plain(range.from, 3)}…${plain(range.to, 3)}`;
}

/// Values of cells with as many decimals as tell them apart, fewer where cells are narrow; nothing
/// where none would fit.
function cellLabels(values: number[], most: number, width: number): { texts: string[]; size: number } | undefined {
  const decimals = 1 - Math.floor(Math.log10(most));
  for (const [digits, size] of [
    [decimals, 12],
    [decimals, 10],
    [decimals - 1, 10],
  ] as [number, number][]) {
    const texts = values.map((v) => fixed(v, Math.max(0, digits)));
    if (Math.max(...texts.map((t) => t.length)) * size * 0.56 < width - 2) return { texts, size };
  }
  return undefined;
}

/// "axial load [N]" of a column; runs have names.
function planTitle(column: string): string {
  return column === 'run_id' ? 'run' : axisTitle(column);
}

/// Undefined where nothing was swept.
export function misfitMap(view: FitView): HTMLElement | undefined {
  const map = () => (view.report.models[view.model] as Predicted).map;
  if (map().cells.length === 0) return undefined;
  const known = map().cells.some((c) => c.sigmas !== null);
  const acrossTitle = () => planTitle(map().across_column);
  const upTitle = () => planTitle(map().up_column);
  /// A range with its unit, or a run.
  const place = (range: AxisRange, column: string) => `${rangeText(range)} ${quantity(column).unit}`.trim();
  return view.add(
    new Figure({
      id: 'map',
      title: 'Map of the misfit',
      note: known
        ? 'Mean of predicted − measured in each part of the test plan. Framed and bold: significantly different from the noise (5 % level for the whole map, if the rows are independent).'
        : 'Mean of predicted − measured in each part of the test plan. The noise of these data is not known, so the map marks no cell as significant.',
      wide: true,
      height: () => 130 + Math.max(3, map().up.length) * 38,
      onPaper: 0.85,
      option: (l, width) => {
        const { across, up: rows } = map();
        // Frames are drawn over their neighbours.
        const cells = map()
          .cells.slice()
          .sort((a, b) => Number(a.significant) - Number(b.significant));
        const most = Math.max(...cells.map((c) => Math.abs(c.bias)), 1e-12);
        const left = Math.min(110, 20 + Math.max(...rows.map((r) => rangeText(r).length)) * 6.6);
        const cellWidth = (width - left - 18) / across.length;
        const label = cellLabels(
          cells.map((c) => c.bias),
          most,
          cellWidth,
        );
        const slanted = Math.max(...across.map((r) => rangeText(r).length)) * 6.6 > cellWidth;
        return {
          grid: { left, right: 18, top: 30, bottom: slanted ? 112 : 92 },
          tooltip: tooltip(l, (hit) => {
            const c = cells[hit.dataIndex];
            if (!c) return null;
            return [
              `${place(across[c.across] as AxisRange, map().across_column)}, ${upTitle().replace(/ \[.*/, '')} ${place(rows[c.up] as AxisRange, map().up_column)}`,
              ['mean of predicted − measured', `${signed(c.bias)} ${view.unit}`],
              ['rows', String(c.rows)],
              ...(c.sigmas === null
                ? []
                : ([
                    ['in standard errors', signed(c.sigmas, 3)],
                    ['needed', number(map().needed_sigmas, 3)],
                  ] as [string, string][])),
            ];
          }),
          xAxis: categoryAxis(across.map(rangeText), l, {
            name: acrossTitle(),
            nameLocation: 'middle',
            nameGap: slanted ? 50 : 28,
            nameTextStyle: { color: l.muted },
            axisLabel: { color: l.muted, fontSize: 11, interval: 0, rotate: slanted ? 40 : 0 },
          }),
          yAxis: categoryAxis(rows.map(rangeText), l, { name: upTitle(), nameTextStyle: { color: l.muted, align: 'left', padding: [0, 0, 0, -left + 8] }, nameGap: 10, axisLabel: { color: l.muted, fontSize: 11, interval: 0 } }),
          visualMap: {
            type: 'continuous',
            min: -most,
            max: most,
            dimension: 2,
            seriesIndex: 0,
            orient: 'horizontal',
            left: 'center',
            bottom: 0,
            itemWidth: 12,
            itemHeight: Math.min(220, width * 0.4),
            text: [`+${number(most, 3)} ${view.unit}`, `${number(-most, 3)} ${view.unit}`],
            textStyle: { color: l.muted, fontSize: 11 },
            inRange: { color: [-1, -0.5, 0, 0.5, 1].map((v) => diverging(v, l)) },
            calculable: false,
          },
          series: [
            {
              type: 'heatmap',
              name: 'misfit',
              data: cells.map((c) => ({
                value: [c.across, c.up, c.bias],
                itemStyle: c.significant ? { borderColor: l.ink, borderWidth: 2 } : { borderColor: l.surface, borderWidth: 2 },
                label: { fontWeight: c.significant ? 'bold' : 'normal', color: inkOn(diverging(c.bias / most, l)) },
              })),
              label: { show: label !== undefined, fontSize: label?.size ?? 10, formatter: (hit: { dataIndex: number }) => label?.texts[hit.dataIndex] ?? '' },
              emphasis: { itemStyle: { borderColor: l.ink, borderWidth: 3 } },
            },
          ],
        };
      },
      table: () => ({
        columns: [acrossTitle(), upTitle(), 'rows', `mean of predicted − measured [${view.unit}]`, 'in standard errors', 'significant'],
        rows: map().cells.map((c) => [rangeText(map().across[c.across] as AxisRange), rangeText(map().up[c.up] as AxisRange), c.rows, c.bias, c.sigmas, c.significant ? 'yes' : c.sigmas === null ? 'not known' : 'no']),
      }),
    }),
  );
}
