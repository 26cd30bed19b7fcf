// The ladder: the error of each model against the noise floor.
import { barStyle, legend, sideAxis, threshold, valueAxis } from './chart';
import type { HoldOut, Step } from './document';
import type { Table } from './figure';
import { Figure, tooltip } from './figure';
import { number, plain, unitText } from './text';

/// Where the noise of a data set comes from, in the words of the JSON.
export const noiseSources: Record<string, string> = {
  declared: 'as declared in the file',
  regression: 'from the regression of the coast-down',
  repeats: 'from repeated rows',
  estimated: 'estimated from the residual of a regression without physics',
};

/// The floor of a ladder, in the unit of the errors.
export interface Floor {
  noise: number | null;
  source: string;
  unit: string; // for people
  key: string; // as names of columns have it
}

function noiseNote({ noise, source, unit, key }: Floor): string {
  return noise === null ? `The noise of these data is not known (too few repeated rows, and no std_${key} in every row), so the picture has no noise line.` : `Dashed: the noise of the data, ${number(noise, 3)} ${unit}, ${source}.`;
}

/// The place of the model with the least error.
export function nearest(models: { rmse: number }[]): number {
  return models.reduce((best, model, k) => (model.rmse < (models[best] as { rmse: number }).rmse ? k : best), 0);
}

/// Which of several models is nearest, and how far the first, or where it is the first the next, stands from the readings.
export function nearestWords(names: string[], models: { rmse: number }[], unit: string): string {
  const best = nearest(models);
  const errorOf = (k: number): string => number((models[k] as { rmse: number }).rmse);
  return best > 0 ? `${names[best]} has the smallest error: RMS error ${errorOf(0)} → ${errorOf(best)} ${unit}` : `${names[0]} has the smallest error: RMS error ${errorOf(0)} ${unit}, ${names[1]} ${errorOf(1)} ${unit}`;
}

/// RMS error of models one after the other.
export function ladder(names: string[], errors: number[], bias: number[], fit: (number | null)[], floor: Floor): Figure {
  const { noise, unit } = floor;
  return new Figure({
    id: 'ladder',
    title: 'Error of each model',
    note: noiseNote(floor),
    wide: true,
    height: 80 + names.length * 42,
    option: (l, width) => {
      const side = sideAxis(names, l, width);
      return {
        aria: { enabled: true, decal: { show: false } },
        grid: { left: side.left, right: 64, top: 26, bottom: 42 },
        tooltip: tooltip(l, (hit) => [
          names[hit.dataIndex] ?? '',
          ['RMS error', `${number(errors[hit.dataIndex])} ${unit}`],
          ['mean error', `${number(bias[hit.dataIndex], 3)} ${unit}`],
          ...(noise === null ? [] : ([['noise', `${number(noise, 3)} ${unit}`]] as [string, string][])),
        ]),
        xAxis: valueAxis(`RMS error [${unit}]`, l, 'x', { scale: false, min: 0 }),
        yAxis: side.option,
        series: [
          {
            type: 'bar',
            name: 'RMS error',
            barMaxWidth: 22,
            itemStyle: barStyle(l.kinds[0]),
            label: { show: true, position: 'right', color: l.ink, formatter: (hit: { dataIndex: number }) => number(errors[hit.dataIndex]) },
            data: errors,
            ...(noise === null ? {} : { markLine: threshold(noise, 'noise', l) }),
          },
        ],
      };
    },
    table: () => ({
      columns: ['model', `RMS error [${unit}]`, `mean error [${unit}]`, 'fit [%]', 'RMS error over noise'],
      rows: names.map((name, k) => [name, errors[k] ?? null, bias[k] ?? null, fit[k] ?? null, noise === null ? null : (errors[k] as number) / noise]),
    }),
  });
}

/// Before and after, on the rows of the fit and on rows it did not see.
export function beforeAfter(before: number, after: number, held: HoldOut[], floor: Floor, names: [string, string]): Figure {
  const { noise, unit } = floor;
  const rows = ['rows of the fit', ...held.map((h) => `left out: ${h.left_out.replace('_', ' ')}`)];
  const values = [
    [before, ...held.map((h) => h.rmse_before)],
    [after, ...held.map((h) => h.rmse_after)],
  ];
  const table = (): Table => ({ columns: [`RMS error [${unit}] on`, names[0], names[1]], rows: rows.map((row, k) => [row, values[0]?.[k] ?? null, values[1]?.[k] ?? null]) });
  return new Figure({
    id: 'ladder',
    title: 'Error before and after, compared with the noise',
    note: `${noiseNote(floor)} “Left out”: error on blocks of rows that the fit did not use.`,
    wide: true,
    height: 100 + rows.length * 54,
    onPaper: 0.62,
    option: (l, width) => {
      const top = legend(names, width, l);
      const side = sideAxis(rows, l, width);
      return {
        legend: top.option,
        grid: { left: side.left, right: 56, top: top.height + 24, bottom: 42 },
        tooltip: tooltip(l, (hit) => [rows[hit.dataIndex] ?? '', [hit.seriesName, `${number(hit.value as number)} ${unit}`]]),
        xAxis: valueAxis(`RMS error [${unit}]`, l, 'x', { scale: false, min: 0 }),
        yAxis: side.option,
        series: names.map((name, k) => ({
          type: 'bar',
          name,
          barMaxWidth: 18,
          itemStyle: barStyle(l.kinds[k === 0 ? 1 : 0], k === 0 ? 'wide' : 'none'),
          label: { show: true, position: 'right', color: l.ink, fontSize: 11, formatter: (hit: { value: number }) => number(hit.value) },
          data: values[k],
          ...(k === 0 && noise !== null ? { markLine: threshold(noise, 'noise', l) } : {}),
        })),
      };
    },
    table,
  });
}

/// What each model has that the one before it had not.
export function changes(step: Step): string {
  const texts = [
    ...step.added.map((id) => `+ ${id}`),
    ...step.removed.map((id) => `− ${id}`),
    ...step.numbers.map((n) => {
      const unit = unitText(n.unit);
      return `${n.name} ${n.before === null ? '=' : `${plain(n.before, 4)} →`} ${plain(n.after, 4)}${unit ? ` ${unit}` : ''}`;
    }),
  ];
  return texts.length ? texts.join(', ') : 'no effect and no fitted parameter';
}
