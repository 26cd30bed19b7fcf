// A Stribeck table: torque, its parts and contact angles against speed, loads around the bearing.
import { aroundOption } from './around';
import { legend, valueAxis } from './chart';
import type { Option } from './chart';
import type { BearingState, TableReport } from './document';
import { Rows } from './document';
import { choice, Figure, tooltip } from './figure';
import { thinned } from './groups';
import { dashes, ordered, symbols } from './look';
import { axisTitle, number, plain, quantity, withUnit } from './text';

const mostCurves = 8; // that stay readable
const mostSpeeds = 5; // around the bearing
const mostPoints = 3000; // measured ones that are drawn
const otherLoads = 'other loads';

/// So many places of a list, its ends among them.
function spread(count: number, most: number): number[] {
  return count <= most ? Array.from({ length: count }, (_, k) => k) : Array.from({ length: most }, (_, k) => Math.round((k * (count - 1)) / (most - 1)));
}

function distinct(values: Iterable<number>): number[] {
  return [...new Set(values)].filter(Number.isFinite).sort((a, b) => a - b);
}

interface Slice {
  axial: number;
  rows: number[];
}

/// How far from a curve a reading may be and still be of it.
const [nearLoad, nearTemperature] = [0.1, 5];

/// A measured point among the curves: the curve whose load it has, if any, and how much warmer it is.
interface Placed {
  row: number;
  curve: number; // -1: of other loads
  warmer: number; // [K], 0 where not known
}

/// What is drawn against speed, and readings of it.
interface CurvesOf {
  id: string;
  title: string;
  column: string;
  points: Rows | undefined;
  reading: string; // column of the points
  note: string;
  choices: HTMLElement[];
}

export function tableFigures(report: TableReport): Figure[] {
  const rows = new Rows(report.rows);
  const axials = distinct(rows.get('axial_load_N'));
  const radials = distinct(rows.get('radial_load_N'));
  const temperatures = distinct(rows.get('temperature_C'));
  const measured = report.measured ? new Rows(report.measured.rows) : undefined;
  const torques = measured?.has('measured_Nmm') ? measured : undefined;
  const positions = measured?.has('measured_um') && rows.has('axial_displacement_um') ? measured : undefined;
  const chosen = { radial: 0, temperature: 0, axial: axials.length - 1, logarithmic: false };
  const figures: Figure[] = [];
  const note = [
    axials.length > mostCurves ? `${mostCurves} of ${axials.length} axial loads are drawn, the table has all.` : '',
    measured && !torques && !positions ? `The table has no ${report.measured?.quantity.in_words}: what was measured is not drawn.` : '',
  ]
    .join(' ')
    .trim();
  const redraw = () => {
    for (const figure of figures) figure.draw();
  };
  const controls = () => {
    const list: HTMLElement[] = [];
    if (radials.length > 1)
      list.push(
        choice(
          'Radial load',
          radials.map((v) => withUnit(v, 'radial_load_N')),
          0,
          (k) => ((chosen.radial = k), redraw()),
        ),
      );
    if (temperatures.length > 1)
      list.push(
        choice(
          'Temperature',
          temperatures.map((v) => withUnit(v, 'temperature_C')),
          0,
          (k) => ((chosen.temperature = k), redraw()),
        ),
      );
    return list;
  };
  const slices = (): Slice[] => {
    const byLoad = new Map<number, number[]>(axials.map((a) => [a, []]));
    const radial = rows.get('radial_load_N');
    const temperature = rows.get('temperature_C');
    const axial = rows.get('axial_load_N');
    for (let k = 0; k < rows.count; ++k) if (radial[k] === radials[chosen.radial] && temperature[k] === temperatures[chosen.temperature]) byLoad.get(axial[k] as number)?.push(k);
    return [...byLoad].map(([a, list]) => ({ axial: a, rows: list }));
  };
  const shown = () => {
    const list = slices();
    return thinned(
      list.map((_, k) => k),
      mostCurves,
    ).map((k) => list[k] as Slice);
  };
  const place = () => `radial load ${withUnit(radials[chosen.radial] as number, 'radial_load_N')}, ${withUnit(temperatures[chosen.temperature] as number, 'temperature_C')}`;
  const columns = (names: string[]) => () => ({
    columns: ['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C', ...names].map(axisTitle),
    rows: Array.from({ length: rows.count }, (_, k) => ['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C', ...names].map((name) => (Number.isFinite(rows.at(name, k)) ? rows.at(name, k) : null))),
  });

  /// Every measured point with the curve that it belongs to; what was not recorded is as there.
  const placed = (points: Rows, curves: Slice[]): Placed[] => {
    const off = (name: string, value: number | undefined, k: number, width: number) => value !== undefined && points.has(name) && !(Math.abs(points.at(name, k) - value) <= width);
    const radial = radials[chosen.radial] as number;
    return Array.from({ length: points.count }, (_, row) => {
      const others = off('radial_load_N', radial, row, nearLoad * radial + 1) || off('preload_N', report.preload_N, row, nearLoad * (report.preload_N ?? 0));
      const curve = others ? -1 : curves.findIndex((c) => !off('axial_load_N', c.axial, row, nearLoad * Math.abs(c.axial) + 1));
      const temperature = temperatures[chosen.temperature];
      const warmer = points.has('temperature_C') && temperature !== undefined ? points.at('temperature_C', row) - temperature : 0;
      return { row, curve, warmer: Number.isFinite(warmer) ? warmer : 0 };
    });
  };
  const pointsNote = (points: Rows | undefined): string => {
    if (!points) return '';
    const list = placed(points, shown());
    const [at, colder, hotter, other] = [
      list.filter((p) => p.curve >= 0 && Math.abs(p.warmer) <= nearTemperature).length,
      list.filter((p) => p.curve >= 0 && p.warmer < -nearTemperature).length,
      list.filter((p) => p.curve >= 0 && p.warmer > nearTemperature).length,
      list.filter((p) => p.curve < 0).length,
    ];
    const drawn = points.count > mostPoints ? `${mostPoints} of ${points.count} measured points, evenly spread; of all` : `All ${points.count} measured points:`;
    const total = points.count < points.total ? ` The page holds ${points.count} of ${points.total}.` : '';
    return `${drawn} ${at} within 10 % of the loads of a curve and 5 K of its temperature, in its colour; ${colder} colder (blue) and ${hotter} warmer (orange) than that, the fuller the further; ${other} at other loads (grey).${total}`;
  };
  /// Curves of a column for each axial load, and what was measured of it.
  const against = ({ id, title, column, points, reading, note: below, choices }: CurvesOf): Figure =>
    new Figure({
      id,
      title,
      note: () => `${below} ${pointsNote(points)}`.trim(),
      wide: true,
      height: 420,
      marks: rows.count / 4,
      controls: choices,
      option: (l, width) => {
        const curves = shown();
        const names = curves.map((c) => `${plain(c.axial)} N`);
        const colours = ordered(curves.length, l);
        const readings: { name: string; data: Option[] }[] = [];
        const { label, unit } = quantity(column);
        const series: Option[] = curves.map((c, k) => ({
          type: 'line',
          name: names[k],
          symbol: 'circle',
          symbolSize: 4,
          lineStyle: { color: colours[k], width: 2.2, type: dashes[k % dashes.length] },
          itemStyle: { color: colours[k] },
          data: c.rows.filter((row) => !chosen.logarithmic || rows.at('speed_rpm', row) > 0).map((row) => [rows.at('speed_rpm', row), rows.at(column, row), row]),
        }));
        const far = Math.max(nearTemperature + 1, ...(points ? placed(points, curves).map((p) => Math.abs(p.warmer)) : []));
        const fill = ({ curve, warmer }: Placed): [string, number] => {
          if (curve < 0) return [l.muted, 0.35];
          if (Math.abs(warmer) <= nearTemperature) return [colours[curve] as string, 1];
          return [warmer < 0 ? l.negative : l.positive, 0.25 + (0.65 * Math.abs(warmer)) / far];
        };
        if (points) {
          const list = placed(points, curves);
          for (const row of thinned(
            list.map((p) => p.row),
            mostPoints,
          )) {
            const p = list[row] as Placed;
            const [colour, opacity] = fill(p);
            const name = p.curve < 0 ? otherLoads : (names[p.curve] as string);
            (readings[p.curve + 1] ??= { name, data: [] }).data.push({ value: [points.at('speed_rpm', p.row), points.at(reading, p.row), p.row, 'measured'], itemStyle: { color: colour, opacity } });
          }
        }
        readings.forEach((r, k) =>
          series.push({
            type: 'scatter',
            name: r.name,
            symbol: k === 0 ? 'circle' : symbols[(k - 1) % symbols.length],
            symbolSize: (points?.count ?? 0) > 800 ? 5 : 8,
            z: k === 0 ? 1 : 6,
            itemStyle: { color: k === 0 ? l.muted : (colours[k - 1] as string), borderColor: l.ink, borderWidth: k === 0 || (points?.count ?? 0) > 800 ? 0 : 1 },
            data: r.data,
          }),
        );
        const entries = [...names, ...(readings[0] ? [otherLoads] : [])];
        const top = legend(
          entries,
          width,
          l,
          entries.map((_, k) => (k < names.length ? symbols[k % symbols.length] : 'circle')),
        );
        return {
          legend: top.option,
          grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
          tooltip: tooltip(l, (hit) => {
            const value = hit.value as (number | string)[];
            const source = value[3] === 'measured' && points ? points : rows;
            const k = value[2] as number;
            return [
              source === rows ? 'computed' : `measured, line ${plain(source.at('line', k))}`,
              ...['speed_rpm', 'axial_load_N', 'radial_load_N', 'temperature_C', 'preload_N'].filter((name) => source.has(name)).map((name): [string, string] => [quantity(name).label, withUnit(source.at(name, k), name)]),
              [label, `${number(value[1] as number)} ${unit}`],
            ];
          }),
          xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x', chosen.logarithmic ? { type: 'log' } : {}),
          yAxis: valueAxis(`${axisTitle(column)}, ${place()}`, l, 'y', { scale: false }),
          series,
        };
      },
      table: columns([column]),
      csv: columns(rows.names.slice(4)),
    });
  figures.push(
    against({
      id: 'stribeck',
      title: 'Stribeck curves',
      column: 'friction_torque_Nmm',
      points: torques,
      reading: 'measured_Nmm',
      note,
      choices: [...controls(), choice('Speed axis', ['linear', 'logarithmic'], 0, (k) => ((chosen.logarithmic = k === 1), redraw()))],
    }),
  );
  if (positions)
    figures.push(
      against({
        id: 'position',
        title: 'Displacement of the shaft',
        column: 'axial_displacement_um',
        points: positions,
        reading: 'measured_um',
        note: `Positive towards the tool.${positions.has('preload_N') ? ' Other preloads than that of the model count as other loads.' : ''}`,
        choices: [],
      }),
    );

  const parts = report.results.parts.filter((name) => rows.has(name));
  figures.push(
    new Figure({
      id: 'parts',
      title: 'What the torque is made of',
      controls: [
        choice(
          'Axial load',
          axials.map((v) => withUnit(v, 'axial_load_N')),
          chosen.axial,
          (k) => ((chosen.axial = k), redraw()),
        ),
      ],
      option: (l, width) => {
        const slice = slices()[chosen.axial] as Slice;
        const names = parts.map((name) => quantity(name).label);
        const top = legend(
          names,
          width,
          l,
          parts.map((_, k) => symbols[k % symbols.length]),
        );
        return {
          legend: top.option,
          grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
          tooltip: tooltip(l, (hit) => [hit.seriesName, ['speed', `${plain((hit.value as number[])[0])} rpm`], ['torque', `${number((hit.value as number[])[1])} N mm`]]),
          xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
          yAxis: valueAxis(`torque [N mm], ${place()}`, l, 'y', { scale: false }),
          series: parts.map((name, k) => ({
            type: 'line',
            name: names[k],
            stack: 'torque',
            symbol: symbols[k % symbols.length],
            symbolSize: 6,
            color: l.kinds[k % l.kinds.length],
            lineStyle: { width: 1.5, type: dashes[k % dashes.length] },
            areaStyle: { opacity: 0.35 },
            data: slice.rows.map((row) => [rows.at('speed_rpm', row), rows.at(name, row)]),
          })),
        };
      },
      table: columns(parts),
    }),
  );

  const angles = ['inner_contact_angle_max_deg', 'inner_contact_angle_min_deg', 'outer_contact_angle_max_deg', 'outer_contact_angle_min_deg'];
  if (angles.every((name) => rows.has(name)))
    figures.push(
      new Figure({
        id: 'angles',
        title: 'Contact angles against speed',
        note: `Solid: inner race, dashed: outer race; ${report.results.contact_angle_deg ? `${plain(report.results.contact_angle_deg, 4)}° without load` : ''}. Where balls differ, the smallest and the largest.`,
        option: (l, width) => {
          const curves = shown();
          const names = curves.map((c) => `${plain(c.axial)} N`);
          const colours = ordered(curves.length, l);
          const top = legend(
            names,
            width,
            l,
            curves.map((_, k) => symbols[k % symbols.length]),
          );
          return {
            legend: top.option,
            grid: { left: 56, right: 20, top: top.height + 28, bottom: 46 },
            tooltip: tooltip(l, (hit) => {
              const [speed, angle, , race] = hit.value as [number, number, number, string];
              return [`${race} race, ${hit.seriesName}`, ['speed', `${plain(speed)} rpm`], ['contact angle', `${number(angle)}°`]];
            }),
            xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
            yAxis: valueAxis(`contact angle [°], ${place()}`, l, 'y'),
            series: curves.flatMap((c, k) =>
              angles.map((name) => ({
                type: 'line',
                name: names[k],
                symbol: symbols[k % symbols.length],
                symbolSize: 6,
                color: colours[k],
                lineStyle: { width: 1.6, type: name.startsWith('inner') ? 'solid' : 'dashed' },
                data: c.rows.map((row) => [rows.at('speed_rpm', row), rows.at(name, row), row, name.startsWith('inner') ? 'inner' : 'outer']),
              })),
            ),
          };
        },
        table: columns(angles),
      }),
    );
  if (report.states.length) figures.push(balls(report.states), around(report.states));
  return figures;
}

/// The ball that carries most and the one that carries least, against speed.
function balls(states: BearingState[]): Figure {
  const shown: BallColumn[] = ['inner_load_N', 'outer_load_N', 'inner_pressure_MPa', 'outer_pressure_MPa'];
  const axials = distinct(states.map((s) => s.axial_load_N));
  const radials = distinct(states.map((s) => s.radial_load_N));
  let radial = radials.length - 1;
  let name = shown[0] as BallColumn;
  const ends = (s: BearingState, column: BallColumn): [number | null, number | null] => {
    const values = s[column].filter((v): v is number => v !== null);
    return values.length ? [Math.max(...values), Math.min(...values)] : [null, null];
  };
  const figure: Figure = new Figure({
    id: 'balls',
    title: 'Ball loads and pressures against speed',
    note: 'Solid: the ball that has most, dashed: the one that has least; one line where all balls are alike.',
    height: 420,
    onPaper: 1,
    controls: [
      choice(
        'Show',
        shown.map((c) => axisTitle(c)),
        0,
        (k) => ((name = shown[k] as BallColumn), figure.draw()),
      ),
      ...(radials.length > 1
        ? [
            choice(
              'Radial load',
              radials.map((v) => withUnit(v, 'radial_load_N')),
              radial,
              (k) => ((radial = k), figure.draw()),
            ),
          ]
        : []),
    ],
    option: (l, width) => {
      const names = axials.map((a) => `${plain(a)} N`);
      const colours = ordered(axials.length, l);
      const top = legend(
        names,
        width,
        l,
        axials.map((_, k) => symbols[k % symbols.length]),
      );
      const of = (axial: number) => states.filter((s) => s.axial_load_N === axial && s.radial_load_N === radials[radial]);
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const [speed, value, end] = hit.value as [number, number, string];
          return [`${hit.seriesName} axial`, ['speed', `${plain(speed)} rpm`], [`${quantity(name).label}, ${end}`, withUnit(value, name)]];
        }),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
        yAxis: valueAxis(axisTitle(name), l, 'y', { scale: false }),
        series: axials.flatMap((axial, k) =>
          ['largest', 'smallest'].map((end, at) => ({
            type: 'line',
            name: names[k],
            symbol: symbols[k % symbols.length],
            symbolSize: 6,
            color: colours[k],
            lineStyle: { width: 1.8, type: at === 0 ? 'solid' : 'dashed' },
            data: of(axial).map((s) => [s.speed_rpm, ends(s, name)[at], end]),
          })),
        ),
      };
    },
    table: () => ({
      columns: ['speed [rpm]', 'axial load [N]', 'radial load [N]', ...shown.flatMap((c) => [`${axisTitle(c)}, largest`, `${axisTitle(c)}, smallest`])],
      rows: states.map((s) => [s.speed_rpm, s.axial_load_N, s.radial_load_N, ...shown.flatMap((c) => ends(s, c))]),
    }),
  });
  return figure;
}

type BallColumn = 'inner_load_N' | 'outer_load_N' | 'inner_pressure_MPa' | 'outer_pressure_MPa' | 'inner_contact_angle_deg' | 'outer_contact_angle_deg';

/// One value of every ball around the bearing, a line for each speed.
function around(states: BearingState[]): Figure {
  const ballColumns: BallColumn[] = ['inner_load_N', 'outer_load_N', 'inner_pressure_MPa', 'outer_pressure_MPa', 'inner_contact_angle_deg', 'outer_contact_angle_deg'];
  const key = (s: BearingState) => `${plain(s.axial_load_N)} N axial, ${plain(s.radial_load_N)} N radial`;
  const loads = [...new Set(states.map(key))];
  let load = loads.length - 1;
  let column = 0;
  const name = () => ballColumns[column] as BallColumn;
  const drawn = () => {
    const list = states.filter((s) => key(s) === loads[load]);
    return spread(list.length, mostSpeeds).map((k) => list[k] as BearingState);
  };
  const figure: Figure = new Figure({
    id: 'around',
    title: 'Around the bearing',
    note: `At ${withUnit((states[0] as BearingState).temperature_C, 'temperature_C')}. 0° is the direction of the radial load; a ball that has lost the inner race has no inner angle.`,
    height: 420,
    onPaper: 1,
    controls: [
      choice(
        'Show',
        ballColumns.map((c) => axisTitle(c)),
        0,
        (k) => ((column = k), figure.draw()),
      ),
      choice('Load', loads, load, (k) => ((load = k), figure.draw())),
    ],
    option: (l, width) => {
      const list = drawn();
      const names = list.map((s) => `${plain(s.speed_rpm)} rpm`);
      const colours = ordered(list.length, l);
      return aroundOption(
        list.map((r, k) => ({ name: names[k] as string, azimuth: r.azimuth_deg, values: r[name()] })),
        name(),
        colours,
        l,
        width,
      );
    },
    table: () => ({
      columns: ['speed [rpm]', 'axial load [N]', 'radial load [N]', 'azimuth [°]', ...ballColumns.map((c) => axisTitle(c))],
      rows: states.flatMap((s) => s.azimuth_deg.map((azimuth, ball) => [s.speed_rpm, s.axial_load_N, s.radial_load_N, azimuth, ...ballColumns.map((c) => s[c][ball] ?? null)])),
    }),
  });
  return figure;
}
