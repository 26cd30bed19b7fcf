// What a diagnosis adds: ranking, the chosen effect, what could have been found, where to measure next.
import { barStyle, legend, sideAxis, symbolLegend, threshold, valueAxis } from './chart';
import type { BaseShifts, DiagnoseReport, Explanation, RankedEffect, Size, Suggested } from './document';
import type { Cell } from './figure';
import { choice, Figure, tooltip } from './figure';
import type { FitView } from './fit_rows';
import { groups, mean, thinned } from './groups';
import { dashes, ordered, symbols } from './look';
import { axisTitle, el, number, plain, quantity, signed, unitText, valueList } from './text';

const mostBars = 12;
const planSymbols = symbols.filter((s) => s !== 'diamond'); // which are the points to come

/// A difference of -2 ln L: tenths are enough.
function gainText(gain: number): string {
  return Math.abs(gain) < 0.05 ? '0' : plain(Number(gain.toFixed(1)), 5);
}

function sizeText(parameters: Record<string, Size>): string {
  return Object.entries(parameters)
    .map(([name, p]) => {
      const std = p.std === null ? '' : ` ± ${number(p.std, 2)}`;
      const unit = unitText(p.unit);
      return `${name} = ${number(p.value, 3)}${std}${unit ? ` ${unit}` : ''}${p.at_bound ? ' (at its bound)' : ''}${p.plausible === false ? ' (implausible)' : ''}`;
    })
    .join(', ');
}

export function ranking(report: DiagnoseReport, { unit }: FitView): Figure {
  const { effects, needed_gain: needed, candidates_tried: tried } = report.results;
  const shown = effects.filter((e, k) => e.in_verdict || k < mostBars);
  const best = Math.max(...effects.map((e) => e.gain));
  const kinds: [string, (e: RankedEffect) => boolean][] = [
    ['in the verdict', (e) => e.in_verdict],
    ['above the threshold', (e) => !e.in_verdict && e.gain > needed],
    ['below the threshold', (e) => !e.in_verdict && !(e.gain > needed)],
  ];
  return new Figure({
    id: 'ranking',
    title: 'Effects that explain the misfit',
    note: `Gain: decrease of −2 ln L when the effect is added and all parameters are refitted. The verdict needs a gain of ${number(needed, 3)}. ${tried} explanations were tried.${shown.length < effects.length ? ` The picture shows the best ${shown.length} of ${effects.length}; the table has all.` : ''}`,
    wide: true,
    height: 84 + shown.length * 30,
    onPaper: 0.6,
    option: (l, width) => {
      const present = kinds.filter(([, is]) => shown.some(is));
      const top = legend(
        present.map(([name]) => name),
        width,
        l,
      );
      const side = sideAxis(
        shown.map((e) => e.id),
        l,
        width,
      );
      const colours: Record<string, string> = { 'in the verdict': l.kinds[1] as string, 'above the threshold': l.kinds[0] as string, 'below the threshold': l.muted };
      const behind = (e: RankedEffect) => (best - e.gain > 0.05 ? `${gainText(e.gain)}  (${gainText(best - e.gain)} behind)` : gainText(e.gain));
      return {
        legend: top.option,
        grid: { left: side.left, right: width < 480 ? 60 : 150, top: top.height + 22, bottom: 40 },
        tooltip: tooltip(l, (hit) => {
          const e = shown[hit.dataIndex];
          if (!e) return null;
          return [
            e.id,
            ['gain', gainText(e.gain)],
            ['behind the best', gainText(best - e.gain)],
            ['RMS error', `${number(e.rmse)} ${unit}`],
            ...(e.rmse_cross_validated === null ? [] : ([['on held-out rows', `${number(e.rmse_cross_validated)} ${unit}`]] as [string, string][])),
            ['size', sizeText(e.parameters)],
            ...(e.indistinguishable_from.length ? ([['not distinguishable from', e.indistinguishable_from.join(', ')]] as [string, string][]) : []),
          ];
        }),
        xAxis: valueAxis('gain', l, 'x', { scale: false }),
        yAxis: side.option,
        series: present.map(([name, is], k) => ({
          type: 'bar',
          name,
          stack: 'gain',
          barMaxWidth: 18,
          itemStyle: barStyle(colours[name], name === 'in the verdict' ? 'none' : name === 'above the threshold' ? 'wide' : 'narrow'),
          label: {
            show: true,
            position: 'right',
            color: l.ink,
            fontSize: 11,
            formatter: (hit: { dataIndex: number }) => {
              const e = shown[hit.dataIndex];
              return e && is(e) ? (width < 480 ? gainText(e.gain) : behind(e)) : '';
            },
          },
          data: shown.map((e) => (is(e) ? e.gain : null)),
          ...(k === 0 ? { markLine: threshold(needed, `needed ${number(needed, 3)}`, l) } : {}),
        })),
      };
    },
    table: () => ({
      columns: ['effect', 'in the verdict', 'gain', `RMS [${unit}]`, `RMS on held-out rows [${unit}]`, 'size', 'not distinguishable from'],
      rows: effects.map((e) => [e.id, e.in_verdict ? 'yes' : 'no', e.gain, e.rmse, e.rmse_cross_validated, sizeText(e.parameters), e.indistinguishable_from.join(', ')]),
    }),
  });
}

interface Chosen {
  id: string;
  column: string;
  with: Explanation;
  shifts: BaseShifts;
  of: RankedEffect | undefined;
}

/// What one effect of the ranking does: its share of the reading over the plan, and what the base
/// parameters had been hiding of it. The reader chooses which.
export function effectNodes(report: DiagnoseReport, view: FitView): Node[] {
  const { effects: ranked, base_parameters: ofVerdict, explanations: sets } = report.results;
  const best = sets[0] ?? [];
  const list = report.explanations.flatMap((e): Chosen[] =>
    e.effects.map(({ id, column }) => {
      const of = ranked.find((r) => r.id === id);
      return { id, column, with: e, of, shifts: best.includes(id) ? ofVerdict : (of?.base_parameters ?? {}) };
    }),
  );
  if (list.length === 0) return [];
  let chosen = list[0] as Chosen;
  const { rows, unit, what } = view;
  const all = Array.from({ length: rows.count }, (_, k) => k);
  const effect = (k: number) => rows.at(chosen.column, k);
  const total = (k: number) => rows.at(chosen.with.total, k);
  const share = (k: number) => (100 * effect(k)) / total(k);
  const inputs = view.inputs.filter((name) => rows.varies(name));
  const column = inputs.find((name) => name !== 'speed_rpm');
  const others = () => chosen.with.effects.map((e) => e.id).join(' and ');
  const shareOf = new Figure({
    id: 'share',
    title: `Share of the effect in the ${what}`,
    note: () => `Share of ${chosen.id} in the prediction of the model with ${others()}, at every measured point.`,
    marks: view.marks,
    option: (l, width) => {
      const parts = column ? groups(rows.get(column), column, 5) : [{ label: 'rows', rows: all, from: 0, to: 0 }];
      const colours = ordered(parts.length, l);
      const top = symbolLegend(
        parts.map((g) => g.label),
        width,
        l,
      );
      return {
        legend: top.option,
        grid: { left: 56, right: 18, top: top.height + 26, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const k = (hit.value as number[])[2] as number;
          return [...view.tell(k).slice(0, -3), [chosen.id, `${signed(effect(k))} ${unit}`], [`share of the ${what}`, `${number(share(k), 3)} %`]];
        }),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
        yAxis: valueAxis(`share of the ${what} [%]`, l, 'y', { scale: false }),
        series: parts.map((g, k) => ({
          type: 'scatter',
          name: g.label,
          symbol: symbols[k % symbols.length],
          symbolSize: 7,
          itemStyle: { color: colours[k], opacity: 0.85 },
          data: thinned(g.rows, 600).map((row) => [rows.at('speed_rpm', row), share(row), row]),
        })),
      };
    },
    table: () => ({ columns: [...inputs.map(axisTitle), `${chosen.id} [${unit}]`, `${what} [${unit}]`, 'share [%]'], rows: all.map((k) => [...inputs.map((name) => rows.at(name, k)), effect(k), total(k), share(k)]) }),
  });
  const everything = (k: number) => total(k) - rows.at(chosen.with.base, k);
  const hidden = (k: number) => (view.predicted(0)[k] as number) - rows.at(chosen.with.base, k);
  const names = Object.keys(list.find((c) => Object.keys(c.shifts).length)?.shifts ?? {});
  const lines: [string, (k: number) => number][] = [
    ['whole contribution', everything],
    [`hidden by ${names.join(', ')}`, hidden],
    ['remaining misfit', (k) => everything(k) - hidden(k)],
  ];
  const parts = () => groups(rows.get('speed_rpm'), 'speed_rpm', 10);
  const shifts = () => Object.entries(chosen.shifts);
  const hiding = new Figure({
    id: 'hidden',
    title: 'Part of the effect that the base parameters hide',
    note: () =>
      `Refitted without and with ${others()}: ${shifts()
        .map(([name, p]) => `${name} ${number(p.before)} → ${number(p.after)}`)
        .join('; ')}. The wrong values hide a part of the effect, so this part does not appear as misfit. Means over the rows of each speed.`,
    option: (l, width) => {
      const top = legend(
        lines.map(([name]) => name),
        width,
        l,
        symbols.slice(0, lines.length),
      );
      return {
        legend: top.option,
        grid: { left: 56, right: 18, top: top.height + 26, bottom: 46 },
        tooltip: tooltip(l, (hit) => [hit.seriesName, ['speed', `${plain((hit.value as number[])[0], 5)} rpm`], [`mean ${what}`, `${signed((hit.value as number[])[1] as number)} ${unit}`]]),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
        yAxis: valueAxis(`${what} [${unit}]`, l, 'y', { scale: false }),
        series: lines.map(([name, value], k) => ({
          type: 'line',
          name,
          symbol: symbols[k],
          symbolSize: 7,
          color: [l.kinds[1], l.kinds[0], l.muted][k],
          lineStyle: { type: dashes[k], width: 2 },
          data: parts().map((g) => [mean(g.rows.map((row) => rows.at('speed_rpm', row))), mean(g.rows.map(value))]),
        })),
      };
    },
    table: () => ({ columns: [axisTitle('speed_rpm'), 'rows', ...lines.map(([name]) => `${name} [${unit}]`)], rows: parts().map((g): Cell[] => [g.label, g.rows.length, ...lines.map(([, value]) => mean(g.rows.map(value)))]) }),
  });
  const base = el('div', { id: 'base-parameters' });
  const tellBase = () =>
    base.replaceChildren(
      valueList(
        `Base parameters, without and with ${others()}`,
        ['parameter', 'without', 'with', 'std error', 'unit'],
        shifts().map(([name, p]) => [name, number(p.before), number(p.after), number(p.std, 2), unitText(p.unit)]),
      ),
    );
  tellBase();
  const label = ({ id, of }: Chosen) => `${id} (${of?.in_verdict ? 'verdict, ' : ''}gain ${gainText(of?.gain ?? NaN)})`;
  const bar = el('div', { class: 'choices', id: 'effect' });
  if (list.length > 1)
    bar.append(
      choice('Effect', list.map(label), 0, (k) => {
        chosen = list[k] as Chosen;
        shareOf.draw();
        if (names.length === 0) return;
        hiding.draw();
        tellBase();
      }),
    );
  // Nothing was free to fit: nothing hid anything.
  if (names.length === 0) return [bar, shareOf.element];
  return [bar, el('div', { class: 'grid' }, shareOf.element, hiding.element), base];
}

export function detectable(report: DiagnoseReport, { what }: FitView): Figure | undefined {
  const list = report.results.would_have_been_found.slice().sort((a, b) => a.share_of_reading - b.share_of_reading);
  if (list.length === 0) return undefined;
  const percent = list.map((d) => 100 * d.share_of_reading);
  const floor = 10 ** Math.floor(Math.log10(Math.min(...percent) * 0.999));
  return new Figure({
    id: 'detectable',
    title: 'Smallest effects that these data would show',
    note: `Smallest share of the ${what} (RMS over the rows) at which a diagnosis would find an effect in 99 of 100 cases.`,
    wide: true,
    height: 76 + list.length * 22,
    onPaper: 0.8,
    option: (l, width) => {
      const side = sideAxis(
        list.map((d) => d.id),
        l,
        width,
      );
      return {
        grid: { left: side.left, right: 70, top: 12, bottom: 44 },
        tooltip: tooltip(l, (hit) => {
          const d = list[hit.dataIndex];
          if (!d) return null;
          const unit = unitText(d.unit);
          return [
            d.id,
            ['smallest size found', `${d.parameter} = ${number(d.size, 2)}${unit ? ` ${unit}` : ''}`],
            [`share of the ${what}`, `${number(100 * d.share_of_reading, 2)} %`],
            ...(d.most_alike
              ? ([
                  ['most similar effect', d.most_alike],
                  ['smallest size distinguished from it', `${number(d.told_apart_from, 2)}${unit ? ` ${unit}` : ''}`],
                ] as [string, string][])
              : []),
          ];
        }),
        xAxis: valueAxis(`share of the ${what} [%], logarithmic`, l, 'x', { type: 'log', scale: false, min: floor, startValue: floor }),
        yAxis: side.option,
        series: [
          {
            type: 'bar',
            name: 'smallest size found',
            barMaxWidth: 12,
            itemStyle: barStyle(l.kinds[2]),
            label: { show: true, position: 'right', color: l.ink, fontSize: 11, formatter: (hit: { dataIndex: number }) => `${number(percent[hit.dataIndex], 2)} %` },
            data: percent,
          },
        ],
      };
    },
    table: () => ({
      columns: ['effect', 'parameter', 'smallest size found', 'unit', `share of the ${what} [%]`, 'most similar effect', 'smallest size distinguished from it'],
      rows: list.map((d) => [d.id, d.parameter, d.size, unitText(d.unit), 100 * d.share_of_reading, d.most_alike, d.told_apart_from]),
    }),
  });
}

/// Measured points on the plan, and those to measure next.
export function plan(report: DiagnoseReport, view: FitView): Figure {
  const { rows } = view;
  const next = report.results.suggested_measurements;
  const first = next[0] ?? {};
  const inputs = view.inputs.filter((name) => next.length === 0 || name in first);
  const asked = next.length ? Object.keys(first).filter((name) => quantity(name).unit !== '') : inputs;
  // A preload that the rows do not tell, and one to measure as it is, are those of the model.
  const preload = report.preload_N ?? NaN;
  const at = (m: Suggested, name: string) => (name === 'preload_N' ? (m[name] ?? preload) : m[name]) as number;
  const height = (name: string, row: number) => (name === 'preload_N' && !rows.has(name) ? preload : rows.at(name, row));
  const preloads = next.some((m) => typeof m.preload_N === 'number');
  // Beside speed, the input that the new points move, else the one that was moved.
  const moved = (name: string) => name !== 'speed_rpm' && (rows.varies(name) || next.some((m) => at(m, name) !== at(first as Suggested, name)));
  const up = preloads ? 'preload_N' : (inputs.find(moved) ?? inputs.find((name) => name !== 'speed_rpm') ?? 'speed_rpm');
  const colour = inputs.find((name) => name !== up && rows.varies(name) && moved(name));
  return new Figure({
    id: 'plan',
    title: next.length ? 'Where to measure next' : 'Measured points',
    note: next.length ? `Diamonds: points that best distinguish effects that look alike in these data (${next[0]?.separates ?? ''}).` : 'The diagnosis proposes no further points.',
    marks: view.marks,
    wide: next.length > 0,
    option: (l, width) => {
      const parts = colour ? groups(rows.get(colour), colour, 5) : [{ label: 'measured', rows: Array.from({ length: rows.count }, (_, k) => k), from: 0, to: 0 }];
      const colours = parts.length > 1 ? ordered(parts.length, l) : [l.muted];
      const names = [...parts.map((g) => g.label), ...(next.length ? ['measure next'] : [])];
      const icons = parts.map((_, k) => planSymbols[k % planSymbols.length]);
      const top = legend(names, width, l, [...icons, 'diamond']);
      return {
        legend: top.option,
        grid: { left: 56, right: 30, top: top.height + 26, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          if (hit.seriesName === 'measure next' && hit.seriesIndex === parts.length) {
            const m = next[hit.dataIndex];
            if (!m) return null;
            return [
              'measure next',
              ...asked.map((name): [string, string] => [quantity(name).label, `${plain(at(m, name), 4)} ${quantity(name).unit}`]),
              ['repeats', String(m.repeats)],
              ['separates', m.separates],
              ['difference', m.difference_in_sigma === null ? '' : `${number(m.difference_in_sigma, 3)} σ`],
            ];
          }
          return view.tell((hit.value as number[])[2] as number);
        }),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
        yAxis: valueAxis(axisTitle(up), l, 'y'),
        series: [
          ...parts.map((g, k) => ({
            type: 'scatter',
            name: g.label,
            symbol: icons[k],
            symbolSize: 7,
            itemStyle: { color: colours[k], opacity: 0.6 },
            data: thinned(g.rows, 600).map((row) => [rows.at('speed_rpm', row), height(up, row), row]),
          })),
          ...(next.length
            ? [
                {
                  type: 'scatter',
                  name: 'measure next',
                  symbol: 'diamond',
                  symbolSize: 18,
                  z: 8,
                  itemStyle: { color: l.kinds[1], borderColor: l.ink, borderWidth: 1.2 },
                  label: { show: true, position: 'top', color: l.ink, fontSize: 11, formatter: (hit: { dataIndex: number }) => `${next[hit.dataIndex]?.repeats ?? ''}×` },
                  data: next.map((m) => [at(m, 'speed_rpm'), at(m, up)]),
                },
              ]
            : []),
        ],
      };
    },
    table: () =>
      next.length
        ? { columns: [...asked.map(axisTitle), 'repeats', 'separates', 'difference [σ]'], rows: next.map((m) => [...asked.map((name) => at(m, name)), m.repeats, m.separates, m.difference_in_sigma]) }
        : { columns: ['line', ...inputs.map(axisTitle)], rows: Array.from({ length: rows.count }, (_, k) => [rows.at('line', k), ...inputs.map((name) => rows.at(name, k))]) },
  });
}
