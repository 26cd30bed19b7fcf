// A record over time: measured and predicted above the inputs, what is added by what, what is left.
import { areas, band, legend, valueAxis } from './chart';
import type { Option } from './chart';
import { Figure } from './figure';
import type { Look } from './look';
import { dashes, look } from './look';
import type { RecordView } from './record_view';
import { stretches } from './thin';
import { capital, number, quantity } from './text';
import { frame, left, lines, paper, places, right, rowTooltip, stacked, table, timeAxis } from './time_panels';

const mostColoured = 6; // inputs of one kind
const mostRuns = 12; // that are named

/// Runs with their names, shaded in turn.
function runMarks(view: RecordView, l: Look): Option {
  const { runs } = view.report;
  if (runs.length < 2 || runs.length > mostRuns) return {};
  const of = view.rows.get('run');
  const data = runs.flatMap((name, run) => {
    const [first, last] = [of.indexOf(run), of.lastIndexOf(run)];
    if (first < 0) return [];
    const [from, to] = [Math.max(view.hours[first] as number, view.span[0]), Math.min(view.hours[last] as number, view.span[1])];
    return from <= to ? [[{ name, xAxis: from, itemStyle: { color: run % 2 ? 'transparent' : l.band, opacity: 0.5 } }, { xAxis: to }]] : [];
  });
  return { markArea: { silent: true, animation: false, label: { color: l.muted, fontSize: 11, position: 'insideTopLeft' }, data } };
}

/// Readings as points: nothing is drawn where nothing was read.
function dots(view: RecordView, values: Float64Array, width: number, l: Look, less: (row: number) => number = () => 0): Option {
  return {
    type: 'scatter',
    name: 'measured',
    silent: true,
    symbolSize: view.rows.count > 800 ? 2.5 : 4,
    z: 4,
    itemStyle: { color: l.ink, opacity: 0.75 },
    data: view
      .course(values, width)
      .flat()
      .map((k) => [view.hours[k], (values[k] as number) - less(k)]),
  };
}

interface Line {
  label: string;
  column: string;
  colour: string;
  dash: (typeof dashes)[number];
}

/// Inputs of one unit, below each other on the axis of time.
interface Panel {
  title: string;
  lines: Line[];
  stepped: boolean;
  onOff: boolean;
  height: number;
}

const kinds: [string, string, number][] = [
  ['°C', 'temperatures [°C]', 170],
  ['W', 'power [W]', 90],
  ['rpm', 'speed [rpm]', 80],
  ['m/min', 'feed [m/min]', 80],
  ['', 'on or off', 46],
];

function panels(view: RecordView, l: Look): Panel[] {
  const drivers = view.drivers();
  return kinds.flatMap(([unit, title, height]): Panel[] => {
    const names = view.report.inputs.filter((name) => quantity(name).unit === unit && (view.rows.varies(name) || drivers.includes(name)));
    if (names.length === 0) return [];
    const place = (name: string) => (drivers.includes(name) ? drivers.indexOf(name) : drivers.length);
    const ordered = names.slice().sort((a, b) => place(a) - place(b));
    const coloured = ordered.slice(0, Math.max(1, Math.min(mostColoured, drivers.length ? ordered.filter((n) => drivers.includes(n)).length : mostColoured)));
    const others = ordered.length - coloured.length;
    const line = (column: string): Line => {
      const k = coloured.indexOf(column);
      return k < 0
        ? { label: `${others} other${others > 1 ? 's' : ''}${drivers.length ? ', in one colour' : ''}`, column, colour: l.muted, dash: 'solid' }
        : { label: quantity(column).label, column, colour: l.kinds[k % l.kinds.length] as string, dash: dashes[k % dashes.length] as (typeof dashes)[number] };
    };
    // What is drawn in grey lies below.
    const only = ordered.length === 1 ? quantity(ordered[0] as string).label + (unit ? ` [${unit}]` : '') : title;
    return [{ title: only, lines: [...ordered.slice(coloured.length), ...coloured].map(line), stepped: unit !== '°C', onOff: unit === '', height }];
  });
}

function mainNames(view: RecordView): { names: string[]; icons: (string | undefined)[] } {
  const models = view.together().map((m) => view.label(m));
  const read = view.hasReadings();
  return { names: [...(read ? ['measured'] : []), ...models], icons: [...(read ? ['circle'] : []), ...models.map(() => undefined)] };
}

export function overTime(view: RecordView): HTMLElement {
  const layout = (l: Look, width: number) => {
    const below = panels(view, l);
    // As they are ranked, the others last.
    const names = (p: Panel) => (p.lines.length === 1 ? [] : [...new Set([...p.lines.filter((line) => line.colour !== l.muted), ...p.lines].map((line) => line.label))]);
    return {
      below,
      ...places(
        [{ ...mainNames(view), height: width < 480 ? 220 : 260 }, ...below.map((p) => ({ names: names(p), height: p.height }))].map((p) => ({ ...p, height: l.print ? paper * p.height : p.height })),
        width,
        l,
      ),
    };
  };
  return view.add(
    new Figure({
      id: 'over-time',
      title: () => `${capital(view.chosen.in_words)}, measured and predicted, with the inputs`,
      note: () =>
        `Points: measured. Lines: predicted, with a gap if rows are missing. Below: the inputs over the same time${view.chosen.parts ? `. Coloured: the inputs that drive ${view.together().length > 1 ? `“${view.chosen.name}”` : 'the model'}${view.drivers().length > mostColoured ? ' most' : ''}` : ''}.`,
      wide: true,
      marks: 1e4,
      onPaper: 1,
      height: (width) => layout(look(), width).height,
      option: (l, width) => {
        const { below, list } = layout(l, width);
        const together = view.together();
        const inner = width - left - right;
        const main: Option[] = [
          ...(view.hasReadings() ? [dots(view, view.measured(), inner / 2, l)] : []),
          ...together.flatMap((m, k) => lines(view, view.label(m), view.predicted(m), inner, l.kinds[k % l.kinds.length] as string, { z: 5, lineStyle: { color: l.kinds[k % l.kinds.length], width: 1.8, type: dashes[k % dashes.length] } })),
        ];
        Object.assign(main[0] as Option, runMarks(view, l));
        const inputs = below.flatMap((p, k) =>
          p.lines.flatMap((line) =>
            lines(view, line.label, view.rows.get(line.column), inner, line.colour, {
              xAxisIndex: k + 1,
              yAxisIndex: k + 1,
              ...(p.stepped ? { step: 'end' } : {}),
              lineStyle: { color: line.colour, width: line.colour === l.muted ? 0.8 : 1.4, opacity: line.colour === l.muted ? 0.7 : 1, type: line.dash },
              z: line.colour === l.muted ? 2 : 3,
            }),
          ),
        );
        return {
          ...frame(view, l, list),
          tooltip: rowTooltip(view, l, (row) => [...view.tell(row), ...view.tellInputs(row)]),
          yAxis: [
            valueAxis(`${quantity(view.chosen.displacement).label.replace(/^.*(temperature|displacement)/, '$1')} [${view.unit}]`, l, 'y', { gridIndex: 0 }),
            ...below.map((p, k) => valueAxis(p.title, l, 'y', { gridIndex: k + 1, splitNumber: p.height < 60 ? 1 : 3, ...(p.onOff ? { min: 0, max: 1, interval: 1 } : {}) })),
          ],
          series: [...main, ...inputs],
        };
      },
      table: () =>
        table(view, [
          ...(view.chosen.measured ? ([[`measured [${view.unit}]`, view.measured()]] as [string, Float64Array][]) : []),
          ...view.together().map((m): [string, Float64Array] => [`${m.name} [${view.unit}]`, view.predicted(m)]),
          ...view.report.inputs.map((name): [string, Float64Array] => [name, view.rows.get(name)]),
        ]),
    }),
  );
}

export function contributions(view: RecordView): HTMLElement {
  const sum = (k: number) => (view.chosen.parts ?? []).reduce((s, p) => s + view.rows.at(p.column, k), 0);
  return view.add(
    new Figure({
      id: 'contributions',
      title: 'Contributions to the displacement',
      note: () =>
        view.about(
          `contribution of each channel and effect${(view.chosen.parts ?? []).length > view.shares().length ? '; the smaller ones are summed' : ''}. Line: their sum. Points: measured. The fitted zero of the reading is subtracted from both.`,
        ),
      wide: true,
      marks: 1e4,
      height: (width) => (width < 480 ? 320 : 360),
      option: (l, width) => {
        const inner = width - left - right;
        // What is left of many channels is no kind of its own.
        const colours = (k: number) => (k < mostColoured ? (l.kinds[k % l.kinds.length] as string) : l.muted);
        const parts = stacked(view, view.shares(), view.predicted(), inner);
        const total = view.predicted().map((_, k) => sum(k));
        const read = view.hasReadings();
        const names = [...parts.map((p) => p.name), 'sum', ...(read ? ['measured'] : [])];
        const top = legend(names, width, l, [...parts.map(() => 'rect'), undefined, 'circle']);
        return {
          legend: top.option,
          grid: { left, right, top: top.height + 26, bottom: 46 },
          tooltip: rowTooltip(view, l, (row) => [...view.tell(row).slice(0, 2), ...view.shares().map((s): [string, string] => [s.name, `${(s.values[row] as number).toPrecision(4).replace('-', '−')} ${view.unit}`])]),
          xAxis: timeAxis(view, l),
          yAxis: valueAxis(`displacement [${view.unit}]`, l, 'y', { scale: false }),
          series: [
            ...parts.flatMap((p, k) => [areas(p.name, p.up, colours(k)), areas(p.name, p.down, colours(k))]),
            ...lines(view, 'sum', total, inner, l.ink, { z: 6, lineStyle: { color: l.ink, width: 1.6 } }),
            ...(read ? [dots(view, view.measured(), inner / 2, l, (k) => (view.predicted()[k] as number) - sum(k))] : []),
          ],
        };
      },
      table: () =>
        table(
          view,
          (view.chosen.parts ?? []).map((p): [string, Float64Array] => [`${p.name} [${view.unit}]`, view.rows.get(p.column)]),
        ),
    }),
  );
}

/// Rows of each part that is held out, with what is left there.
function partRows(view: RecordView): { part: number; from: number; to: number; rms: number; mean: number; most: number; held: number }[] {
  const residual = view.residual();
  const { held_out: held, held_out_parts: parts = [] } = view.chosen;
  return parts.map(({ part, from_h: from, to_h: to }) => {
    const errors = Array.from(residual.filter((r, k) => Number.isFinite(r) && (view.hours[k] as number) >= from && (view.hours[k] as number) <= to));
    const unseen = held ? held.residual.filter((_, k) => held.part[k] === part) : [];
    const rms = (list: number[]) => Math.sqrt(list.reduce((s, e) => s + e * e, 0) / list.length);
    return { part, from, to, rms: rms(errors), mean: errors.reduce((s, e) => s + e, 0) / errors.length, most: errors.reduce((m, e) => Math.max(m, Math.abs(e)), 0), held: rms(unseen) };
  });
}

export function residualOverTime(view: RecordView): HTMLElement | undefined {
  if (!view.report.models.some((m) => view.hasReadings(m))) return undefined;
  const held = view.report.models.some((m) => m.held_out);
  const seen = held ? 'fitted to all readings' : 'predicted − measured';
  const unseen = 'from a fit to the other parts';
  return view.add(
    new Figure({
      id: 'residual',
      title: () => `Residual${view.chosen.parts ? '' : ` of the ${view.chosen.in_words}`}`,
      note: () =>
        view.about(
          `predicted − measured. Shading: the eight parts of the record${held ? '. A second line shows each part as predicted by a fit that did not use this part' : ', which the fits leave out one by one; the table has the error on each part'}.${view.chosen.tolerance === null ? '' : ` Band: tolerance of ±${number(view.chosen.tolerance, 3)} ${view.errorUnit}, which applies to the RMS error.`}`,
        ),
      wide: true,
      marks: 1e4,
      height: (width) => (width < 480 ? 320 : 340),
      option: (l, width) => {
        const inner = width - left - right;
        const tolerance = view.chosen.tolerance;
        const names = [seen, ...(view.chosen.held_out ? [unseen] : []), ...(tolerance === null ? [] : ['tolerance'])];
        const top = legend(names, width, l, [undefined, ...(view.chosen.held_out ? [undefined] : []), 'rect']);
        const parts = (view.chosen.held_out_parts ?? []).filter((p) => p.to_h > view.span[0] && p.from_h < view.span[1]);
        const series = lines(view, seen, view.residual(), inner, l.kinds[0] as string, { z: 4, lineStyle: { color: l.kinds[0], width: 1.2 } }, true);
        Object.assign(series[0] as Option, {
          markArea: {
            silent: true,
            animation: false,
            label: { color: l.muted, fontSize: 11, position: 'insideTop', distance: 3 },
            data: parts.map((p, k) => [{ name: `${p.part}`, xAxis: Math.max(p.from_h, view.span[0]), itemStyle: { color: k % 2 ? 'transparent' : l.band, opacity: 0.6 } }, { xAxis: Math.min(p.to_h, view.span[1]) }]),
          },
        });
        if (view.chosen.held_out) {
          const { hours, piece, residual: errors } = view.chosen.held_out;
          const own = stretches(hours, errors, piece, view.span);
          series.push({
            type: 'line',
            name: unseen,
            symbol: 'none',
            silent: true,
            z: 5,
            itemStyle: { color: l.kinds[1] },
            lineStyle: { color: l.kinds[1], width: 1.6, type: 'dashed' },
            data: own.flatMap((of): [number, number | null][] => [...of.map((k): [number, number] => [hours[k] as number, errors[k] as number]), [hours[of[of.length - 1] as number] as number, null]]),
          });
        }
        if (tolerance !== null)
          series.push(
            band(
              'tolerance',
              view.span.map((x): [number, number, number] => [x, -tolerance, tolerance]),
              l.dark ? 'rgba(0,158,115,0.25)' : 'rgba(0,158,115,0.14)',
              l.kinds[2] as string,
            ),
          );
        return {
          legend: top.option,
          grid: { left, right, top: top.height + 26, bottom: 46 },
          tooltip: rowTooltip(view, l, (row) => view.tell(row)),
          xAxis: timeAxis(view, l),
          yAxis: valueAxis(`predicted − measured [${view.errorUnit}]`, l, 'y'),
          series,
        };
      },
      table: () => ({
        columns: ['part', 'from [h]', 'to [h]', ...['RMS', 'mean', 'largest', ...(held ? ['RMS, fit to the others'] : [])].map((name) => `${name} [${view.errorUnit}]`)],
        rows: partRows(view).map((p) => [p.part, p.from, p.to, p.rms, p.mean, p.most, ...(held ? [Number.isFinite(p.held) ? p.held : null] : [])]),
      }),
      csv: () =>
        table(
          view,
          view.report.models.filter((m) => m.measured && m.unit === view.chosen.unit).map((m): [string, Float64Array] => [`${m.name}${m.parts ? '' : `, ${m.in_words}`} [${view.errorUnit}]`, view.residual(m)]),
        ),
    }),
  );
}
