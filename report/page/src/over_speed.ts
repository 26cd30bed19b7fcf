// What was measured and what every model predicts, over speed.
import { legend, valueAxis } from './chart';
import type { Option } from './chart';
import { Figure, tooltip } from './figure';
import type { FitView } from './fit_rows';
import { groups, mean, thinned } from './groups';
import { dashes, ordered, symbols } from './look';
import { axisTitle } from './text';

const mostLevels = 6; // that stay readable
const mostPoints = 3000;
const mostSteps = 40; // of speed in a line
const strokes = ['solid', 'dashed', 'dotted', 'dash-dotted']; // names of the dashes

interface Level {
  label: string;
  rows: number[];
}

/// Rows of one level of what was set beside the speed: a load, or whatever else has few values.
function levels(view: FitView): Level[] {
  const all = Array.from({ length: view.rows.count }, (_, k) => k);
  const set = view.inputs.find((name) => name !== 'speed_rpm' && name !== 'temperature_C' && view.rows.varies(name));
  if (!set) return [{ label: '', rows: all }];
  return groups(view.rows.get(set), set, mostLevels);
}

/// The mean prediction of a model in steps of speed.
function line(view: FitView, rows: number[], model: number): [number, number][] {
  const speeds = new Float64Array(view.rows.count).fill(NaN);
  const predicted = view.predicted(model);
  for (const k of rows) if (Number.isFinite(predicted[k])) speeds[k] = view.rows.at('speed_rpm', k);
  return groups(speeds, 'speed_rpm', mostSteps).map((g) => [mean(g.rows.map((k) => speeds[k] as number)), mean(g.rows.map((k) => predicted[k] as number))]);
}

export function overSpeed(view: FitView): HTMLElement | undefined {
  if (!view.rows.has('speed_rpm') || !view.rows.varies('speed_rpm')) return undefined;
  const parts = levels(view);
  const models = view.report.models;
  const measured = view.measured();
  const shown = parts.map((g) => thinned(g.rows, Math.ceil((mostPoints * g.rows.length) / view.rows.count)));
  const drawn = shown.reduce((sum, rows) => sum + rows.length, 0);
  return new Figure({
    id: 'over-speed',
    title: 'Measured and predicted',
    note: () =>
      `Points: measured. Lines: ${models.length > 1 ? `predictions of the models (${models.map((m, k) => `${m.name} ${strokes[k % strokes.length]}`).join(', ')})` : 'prediction of the model'} for these rows, as means over steps of speed.${drawn < view.rows.count ? ` ${drawn} of ${view.rows.count} rows are drawn.` : ''}`,
    wide: true,
    height: 400,
    marks: drawn,
    option: (l, width) => {
      const colours = ordered(parts.length, l);
      const colourOf = (k: number) => (parts.length > 1 ? (colours[k] as string) : (l.kinds[0] as string));
      const names: string[] = [];
      const icons: (string | undefined)[] = [];
      const series: Option[] = [];
      parts.forEach((part, k) => {
        const name = part.label || 'measured';
        names.push(name);
        icons.push(symbols[k % symbols.length]);
        series.push({
          type: 'scatter',
          name,
          z: 3,
          symbol: symbols[k % symbols.length],
          symbolSize: view.rows.count > 800 ? 4 : 7,
          itemStyle: { color: colourOf(k), opacity: 0.75 },
          data: (shown[k] as number[]).map((row) => [view.rows.at('speed_rpm', row), measured[row], row]),
        });
      });
      models.forEach((model, m) => {
        const ink = parts.length > 1 ? l.ink : (l.kinds[(m + 1) % l.kinds.length] as string);
        names.push(model.name);
        icons.push(undefined);
        parts.forEach((part, k) =>
          series.push({
            type: 'line',
            name: model.name,
            symbol: 'none',
            silent: true, // the points tell their numbers
            z: 5,
            itemStyle: { color: ink },
            lineStyle: { color: parts.length > 1 ? colourOf(k) : ink, width: 2, type: dashes[m % dashes.length] },
            data: line(view, part.rows, m),
          }),
        );
      });
      const top = legend(names, width, l, icons);
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const value = hit.value as number[];
          return view.tell(value[2] as number);
        }),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
        yAxis: valueAxis(`${view.what} [${view.unit}]`, l, 'y', { scale: view.key !== 'Nmm' }),
        series,
      };
    },
    table: () => ({
      columns: [axisTitle('speed_rpm'), 'level', ...models.map((m) => `${m.name} [${view.unit}]`)],
      rows: parts.flatMap((part) => {
        const lines = models.map((_, m) => line(view, part.rows, m));
        return (lines[0] ?? []).map(([speed], at) => [speed, part.label, ...lines.map((of) => of[at]?.[1] ?? null)]);
      }),
    }),
    csv: view.csv,
  }).element;
}
