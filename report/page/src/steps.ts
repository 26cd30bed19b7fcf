// What a step of each input does over time.
import { legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { StepResponse } from './document';
import type { Cell } from './figure';
import { Figure, tooltip } from './figure';
import { dashes, look } from './look';
import type { Look } from './look';
import type { RecordView } from './record_view';
import { number, plain, signed } from './text';

const mostPanels = 6;
const points = 120; // of a curve
const panelHeight = 170;
const between = 30;

/// A time as people say it.
export function duration(seconds: number): string {
  if (seconds < 120) return `${number(seconds, 3)} s`;
  return seconds < 7200 ? `${number(seconds / 60, 3)} min` : `${number(seconds / 3600, 3)} h`;
}

interface Curve {
  name: string;
  at: [number, number][]; // [s], in the unit of the displacement
  bend?: [number, number]; // after one time constant
}

function partCurve(r: StepResponse, part: StepResponse['parts'][number], until: number, unit: string): Curve {
  const { gain, time_constant_s: tau } = part;
  const y = (t: number) => gain * (1 - (1 - r.sensor_time_constant_s / tau) * Math.exp(-t / tau));
  return { name: `${r.parts.length > 1 ? `${part.name}: ` : ''}${signed(gain)} ${unit}, ${duration(tau)}`, at: Array.from({ length: points + 1 }, (_, k) => [(until * k) / points, y((until * k) / points)]), bend: [tau, y(tau)] };
}

/// Its parts, then their sum where there is more than one.
function curves(r: StepResponse, unit: string): Curve[] {
  if (r.sampled.length) return [{ name: `printed coefficients: ${signed(final(r))} ${unit}`, at: r.sampled.map((v, k) => [k * (r.sampling_s ?? 1), v]) }];
  const until = 4 * Math.max(...r.parts.map((p) => p.time_constant_s), 1);
  const list = r.parts.map((p) => partCurve(r, p, until, unit));
  if (r.at_once === 0 && list.length === 1) return list;
  const sum = Array.from({ length: points + 1 }, (_, k): [number, number] => [(until * k) / points, r.at_once + list.reduce((s, c) => s + (c.at[k] as [number, number])[1], 0)]);
  return [...list, { name: `${list.length ? 'together: ' : 'at once: '}${signed(final(r))} ${unit}${r.at_once && list.length ? `, ${signed(r.at_once)} at once` : ''}`, at: sum }];
}

/// Where it leads to.
function final(r: StepResponse): number {
  return r.sampled.length ? (r.sampled[r.sampled.length - 1] as number) : r.at_once + r.parts.reduce((s, p) => s + p.gain, 0);
}

function stepText(r: StepResponse): string {
  return r.unit ? `${plain(r.step, 3)} ${r.unit} of ${r.input}` : r.input;
}

interface Placed {
  response: StepResponse;
  curves: Curve[];
  left: number;
  top: number;
  width: number;
  head: Option;
}

/// Two beside each other where there is room.
function layout(list: StepResponse[], width: number, l: Look, unit: string): { panels: Placed[]; tall: number; height: number } {
  const columns = width >= 600 && list.length > 1 ? 2 : 1;
  const tall = l.print ? 0.62 * panelHeight : panelHeight;
  const wide = (width - (columns - 1) * between) / columns;
  const panels: Placed[] = [];
  let top = 0;
  for (let k = 0; k < list.length; k += columns) {
    const row = list.slice(k, k + columns).map((response) => {
      const own = curves(response, unit);
      return {
        response,
        curves: own,
        head: legend(
          own.map((c) => c.name),
          wide,
          l,
        ),
      };
    });
    const tallest = Math.max(...row.map((p) => p.head.height));
    row.forEach((p, c) => panels.push({ ...p, left: c * (wide + between), top: top + tallest + 28, width: wide, head: { ...p.head.option, left: c * (wide + between), top, width: wide } }));
    top += tallest + 28 + tall + (l.print ? 46 : 62);
  }
  return { panels, tall, height: Math.max(top, 40) };
}

export function steps(view: RecordView): HTMLElement | undefined {
  const all = () => view.chosen.responses ?? [];
  const shown = () =>
    all()
      .slice()
      .sort((a, b) => Math.abs(final(b)) - Math.abs(final(a)))
      .slice(0, mostPanels);
  if (view.report.models.every((m) => !m.responses?.length)) return undefined;
  return view.add(
    new Figure({
      id: 'steps',
      title: 'Response to a step of an input',
      note: () => {
        const changed = [...new Set(all().flatMap((r) => r.changed_by))];
        return view.about(
          `from rest. Each lag shows its final value and its time constant. The mark (63 %) is at the time constant. Several lags are dashed, and the solid line is their sum.${all().length > mostPanels ? ` The picture shows the ${mostPanels} largest of ${all().length}; the table has all.` : ''}${changed.length ? ` This response applies during warm-up at low speed with the coolant on. In other states, ${changed.join(', ')} ${changed.length > 1 ? 'change' : 'changes'} the response.` : ''}`,
        );
      },
      wide: true,
      onPaper: 1,
      height: (width) => layout(shown(), width, look(), view.unit).height,
      option: (l, width) => {
        const { panels, tall } = layout(shown(), width, l, view.unit);
        const scale = (p: Placed) => {
          const until = Math.max(...p.curves.flatMap((c) => c.at.map(([t]) => t)));
          return until < 600 ? { unit: 's', of: 1 } : until < 4 * 7200 ? { unit: 'min', of: 60 } : { unit: 'h', of: 3600 };
        };
        const series = panels.flatMap((p, k): Option[] => {
          const { of } = scale(p);
          return p.curves.flatMap((c, n): Option[] => {
            const last = n === p.curves.length - 1;
            const colour = last ? l.ink : (l.kinds[n % l.kinds.length] as string);
            const own = { name: c.name, xAxisIndex: k, yAxisIndex: k, itemStyle: { color: colour } };
            return [
              { ...own, type: 'line', symbol: 'none', lineStyle: { color: colour, width: last ? 2 : 1.6, type: last ? 'solid' : dashes[1 + (n % (dashes.length - 1))] }, data: c.at.map(([t, y]) => [t / of, y]) },
              ...(c.bend ? [{ ...own, type: 'scatter', symbolSize: 7, data: [[c.bend[0] / of, c.bend[1]]] }] : []),
            ];
          });
        });
        return {
          legend: panels.map((p) => p.head),
          grid: panels.map((p) => ({ left: p.left + 50, width: p.width - 62, top: p.top, height: tall })),
          tooltip: tooltip(l, (hit) => [hit.seriesName]),
          xAxis: panels.map((p, k) =>
            valueAxis(`time [${scale(p).unit}]`, l, 'x', {
              gridIndex: k,
              scale: false,
              axisLabel: { color: l.muted, fontSize: 11, hideOverlap: true, showMaxLabel: false },
              min: 0,
              max: Math.max(...p.curves.flatMap((c) => c.at.map(([t]) => t))) / scale(p).of,
            }),
          ),
          yAxis: panels.map((p, k) => valueAxis(`${p.response.name}: ${stepText(p.response)} [${view.unit}]`, l, 'y', { gridIndex: k, scale: false, splitNumber: 4, nameTruncate: { maxWidth: p.width - 10 } })),
          series,
        };
      },
      table: () => ({
        columns: ['channel', 'step', 'part', `gain [${view.unit} per step]`, 'time constant [s]'],
        rows: all().flatMap((r): Cell[][] => [
          ...r.parts.map((p): Cell[] => [r.name, stepText(r), p.name, p.gain, p.time_constant_s]),
          ...(r.at_once ? [[r.name, stepText(r), 'at once', r.at_once, 0] as Cell[]] : []),
          ...(r.sampled.length ? [[r.name, stepText(r), 'printed coefficients', final(r), null] as Cell[]] : []),
        ]),
      }),
      csv: () => ({ columns: ['channel', 'step', 'curve', 'time [s]', `displacement [${view.unit}]`], rows: all().flatMap((r) => curves(r, view.unit).flatMap((c) => c.at.map(([t, y]): Cell[] => [r.name, stepText(r), c.name, t, y]))) }),
    }),
  );
}
