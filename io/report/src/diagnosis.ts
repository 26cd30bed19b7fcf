// What a diagnosis adds: ranking, the chosen effect, what could have been found, where to measure next.
import { legend, sideAxis, threshold, valueAxis } from './chart';
import type { DiagnoseReport, RankedEffect, Size } from './document';
import type { Cell } from './figure';
import { choice, Figure, tooltip } from './figure';
import type { FitView } from './fit_rows';
import { groups, mean, thinned } from './groups';
import { dashes, ordered, symbols } from './look';
import { axisTitle, number, plain, quantity, signed, unitText } from './text';

const mostBars = 12;

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

export function ranking(report: DiagnoseReport): Figure {
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
    title: 'Which effects explain it',
    note: `Gain: fall of −2 ln L when the effect is added and everything is refitted; ${number(needed, 3)} needed, ${tried} explanations tried.${shown.length < effects.length ? ` The best ${shown.length} of ${effects.length}; the table has all.` : ''}`,
    wide: true,
    height: 84 + shown.length * 30,
    option: (l, width) => {
      const present = kinds.filter(([, is]) => shown.some(is));
      const top = legend(present.map(([name]) => name), width, l);
      const side = sideAxis(shown.map((e) => e.id), l, width);
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
            ['RMS error', `${number(e.rmse)} N mm`],
            ...(e.rmse_cross_validated === null ? [] : ([['on rows left out', `${number(e.rmse_cross_validated)} N mm`]] as [string, string][])),
            ['size', sizeText(e.parameters)],
            ...(e.indistinguishable_from.length ? ([['not told from', e.indistinguishable_from.join(', ')]] as [string, string][]) : []),
          ];
        }),
        xAxis: valueAxis('gain', l, 'x', { scale: false }),
        yAxis: side.option,
        series: present.map(([name, is], k) => ({
          type: 'bar',
          name,
          stack: 'gain',
          barMaxWidth: 18,
          itemStyle: {
            color: colours[name],
            borderRadius: [0, 3, 3, 0],
            decal: name === 'in the verdict' ? undefined : { symbol: 'rect', dashArrayX: [1, 0], dashArrayY: name === 'above the threshold' ? [2, 5] : [1, 3], rotation: -0.7, color: 'rgba(255,255,255,0.35)' },
          },
          label: { show: true, position: 'right', color: l.ink, fontSize: 11, formatter: (hit: { dataIndex: number }) => { const e = shown[hit.dataIndex]; return e && is(e) ? (width < 480 ? gainText(e.gain) : behind(e)) : ''; } },
          data: shown.map((e) => (is(e) ? e.gain : null)),
          ...(k === 0 ? { markLine: threshold(needed, `needed ${number(needed, 3)}`, l) } : {}),
        })),
      };
    },
    table: () => ({
      columns: ['effect', 'in the verdict', 'gain', 'RMS [N mm]', 'RMS on rows left out [N mm]', 'size', 'not told from'],
      rows: effects.map((e) => [e.id, e.in_verdict ? 'yes' : 'no', e.gain, e.rmse, e.rmse_cross_validated, sizeText(e.parameters), e.indistinguishable_from.join(', ')]),
    }),
  });
}

/// Share of the effect in the torque over the plan, and what the base parameters had been hiding.
export function effectFigures(report: DiagnoseReport, view: FitView): Figure[] {
  const effects = report.effects_of_verdict ?? [];
  if (effects.length === 0) return [];
  let chosen = 0;
  const rows = view.rows;
  const all = Array.from({ length: rows.count }, (_, k) => k);
  const torque = (k: number) => rows.at((effects[chosen] as { column: string }).column, k);
  const total = (k: number) => view.predicted(1)[k] as number;
  const share = (k: number) => (100 * torque(k)) / total(k);
  const column = ['axial_load_N', 'temperature_C', 'radial_load_N'].find((name) => rows.varies(name)) ?? 'speed_rpm';
  const figures: Figure[] = [];
  const pick = effects.length > 1 ? [choice('Effect', effects.map((e) => e.id), 0, (index) => {
    chosen = index;
    for (const figure of figures) figure.draw();
  })] : [];
  figures.push(
    new Figure({
      id: 'share',
      title: `Share of ${effects.length > 1 ? 'the effect' : (effects[0] as { id: string }).id} in the torque`,
      note: 'Of what the model with the effect predicts, at every measured point.',
      marks: view.marks,
      controls: pick,
      option: (l, width) => {
        const parts = groups(rows.get(column), column, 5);
        const colours = ordered(parts.length, l);
        const top = legend(parts.map((g) => g.label), width, l, parts.map((_, k) => symbols[k % symbols.length]));
        return {
          legend: top.option,
          grid: { left: 56, right: 18, top: top.height + 26, bottom: 46 },
          tooltip: tooltip(l, (hit) => {
            const k = (hit.value as number[])[2] as number;
            return [...view.tell(k).slice(0, -3), [(effects[chosen] as { id: string }).id, `${signed(torque(k))} N mm`], ['share of the torque', `${number(share(k), 3)} %`]];
          }),
          xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
          yAxis: valueAxis('share of the torque [%]', l, 'y', { scale: false }),
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
      table: () => ({
        columns: [axisTitle('speed_rpm'), axisTitle(column), axisTitle('temperature_C'), `${(effects[chosen] as { id: string }).id} [N mm]`, 'torque [N mm]', 'share [%]'],
        rows: all.map((k) => [rows.at('speed_rpm', k), rows.at(column, k), rows.at('temperature_C', k), torque(k), total(k), share(k)]),
      }),
    }),
  );
  const parameters = Object.entries(report.results.base_parameters);
  const shifts = parameters.map(([name, p]) => `${name} ${number(p.before)} → ${number(p.after)}`).join(', ');
  const everything = (k: number) => total(k) - rows.at('base_with_effects_Nmm', k);
  const hidden = (k: number) => (view.predicted(0)[k] as number) - rows.at('base_with_effects_Nmm', k);
  const lines: [string, (k: number) => number][] = [
    ['what is missing', everything],
    [`hidden by ${parameters.map(([name]) => name).join(', ')}`, hidden],
    ['left over as misfit', (k) => everything(k) - hidden(k)],
  ];
  const parts = () => groups(rows.get('speed_rpm'), 'speed_rpm', 10);
  figures.push(
    new Figure({
      id: 'hidden',
      title: 'What the base parameters had been hiding',
      note: `Refitted without the effect: ${shifts}. What the wrong values took over did not show as misfit. Means over the rows of a speed.`,
      option: (l, width) => {
        const top = legend(lines.map(([name]) => name), width, l);
        return {
          legend: top.option,
          grid: { left: 56, right: 18, top: top.height + 26, bottom: 46 },
          tooltip: tooltip(l, (hit) => [hit.seriesName, ['speed', `${plain((hit.value as number[])[0], 5)} rpm`], ['mean torque', `${signed((hit.value as number[])[1] as number)} N mm`]]),
          xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
          yAxis: valueAxis('torque [N mm]', l, 'y', { scale: false }),
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
      table: () => ({
        columns: [axisTitle('speed_rpm'), 'rows', ...lines.map(([name]) => `${name} [N mm]`)],
        rows: parts().map((g): Cell[] => [g.label, g.rows.length, ...lines.map(([, value]) => mean(g.rows.map(value)))]),
      }),
    }),
  );
  return figures;
}

export function detectable(report: DiagnoseReport): Figure | undefined {
  const list = report.results.would_have_been_found.slice().sort((a, b) => a.share_of_reading - b.share_of_reading);
  if (list.length === 0) return undefined;
  const percent = list.map((d) => 100 * d.share_of_reading);
  const floor = 10 ** Math.floor(Math.log10(Math.min(...percent) * 0.999));
  return new Figure({
    id: 'detectable',
    title: 'What would have been found, and from which size',
    note: 'Smallest share of the torque (RMS over the rows) at which an effect would have been found in 99 of 100 cases.',
    wide: true,
    height: 76 + list.length * 22,
    option: (l, width) => {
      const side = sideAxis(list.map((d) => d.id), l, width);
      return {
        grid: { left: side.left, right: 70, top: 12, bottom: 44 },
        tooltip: tooltip(l, (hit) => {
          const d = list[hit.dataIndex];
          if (!d) return null;
          const unit = unitText(d.unit);
          return [
            d.id,
            ['found from', `${d.parameter} = ${number(d.size, 2)}${unit ? ` ${unit}` : ''}`],
            ['share of the torque', `${number(100 * d.share_of_reading, 2)} %`],
            ...(d.most_alike ? ([['most alike', d.most_alike], ['told from it from', `${number(d.told_apart_from, 2)}${unit ? ` ${unit}` : ''}`]] as [string, string][]) : []),
          ];
        }),
        xAxis: valueAxis('share of the torque [%], logarithmic', l, 'x', { type: 'log', scale: false, min: floor, startValue: floor }),
        yAxis: side.option,
        series: [
          {
            type: 'bar',
            name: 'found from',
            barMaxWidth: 12,
            itemStyle: { color: l.kinds[2], borderRadius: [0, 3, 3, 0] },
            label: { show: true, position: 'right', color: l.ink, fontSize: 11, formatter: (hit: { dataIndex: number }) => `${number(percent[hit.dataIndex], 2)} %` },
            data: percent,
          },
        ],
      };
    },
    table: () => ({
      columns: ['effect', 'parameter', 'found from', 'unit', 'share of the torque [%]', 'most alike', 'told from it from'],
      rows: list.map((d) => [d.id, d.parameter, d.size, unitText(d.unit), 100 * d.share_of_reading, d.most_alike, d.told_apart_from]),
    }),
  });
}

/// Measured points on the plan, and those to measure next.
export function plan(report: DiagnoseReport, view: FitView): Figure {
  const { rows } = view;
  const next = report.results.suggested_measurements;
  const up = ['axial_load_N', 'temperature_C', 'radial_load_N'].find((name) => rows.varies(name)) ?? 'axial_load_N';
  const colour = up === 'temperature_C' ? 'speed_rpm' : 'temperature_C';
  return new Figure({
    id: 'plan',
    title: next.length ? 'Where to measure next' : 'Where was measured',
    note: next.length
      ? `Diamonds: points that best tell apart what these data cannot (${next[0]?.separates ?? ''}).`
      : 'No further points are proposed; this is the plan as measured.',
    marks: view.marks,
    wide: next.length > 0,
    option: (l, width) => {
      const parts = rows.varies(colour) ? groups(rows.get(colour), colour, 5) : [{ label: 'measured', rows: Array.from({ length: rows.count }, (_, k) => k), from: 0, to: 0 }];
      const colours = parts.length > 1 ? ordered(parts.length, l) : [l.muted];
      const names = [...parts.map((g) => g.label), ...(next.length ? ['measure next'] : [])];
      const top = legend(names, width, l, [...parts.map(() => 'circle'), 'diamond']);
      return {
        legend: top.option,
        grid: { left: 56, right: 30, top: top.height + 26, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          if (hit.seriesName === 'measure next' && hit.seriesIndex === parts.length) {
            const m = next[hit.dataIndex];
            if (!m) return null;
            return [
              'measure next',
              ...(['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C'] as const).map((name): [string, string] => [quantity(name).label, `${plain(m[name], 4)} ${quantity(name).unit}`]),
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
            symbolSize: 6,
            itemStyle: { color: colours[k], opacity: 0.6 },
            data: thinned(g.rows, 600).map((row) => [rows.at('speed_rpm', row), rows.at(up, row), row]),
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
                  data: next.map((m) => [m.speed_rpm, m[up as 'axial_load_N']]),
                },
              ]
            : []),
        ],
      };
    },
    table: () =>
      next.length
        ? {
            columns: [...['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C'].map(axisTitle), 'repeats', 'separates', 'difference [σ]'],
            rows: next.map((m) => [m.speed_rpm, m.axial_load_N, m.radial_load_N, m.temperature_C, m.repeats, m.separates, m.difference_in_sigma]),
          }
        : {
            columns: ['line', ...['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C'].map(axisTitle)],
            rows: Array.from({ length: rows.count }, (_, k) => [rows.at('line', k), rows.at('speed_rpm', k), rows.at('axial_load_N', k), rows.at('radial_load_N', k), rows.at('temperature_C', k)]),
          },
  });
}
