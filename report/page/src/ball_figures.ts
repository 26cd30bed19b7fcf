// Loads, pressures and contact angles of single balls, at the states of a table.
import { aroundOption } from './around';
import { symbolLegend, valueAxis } from './chart';
import type { BearingState } from './document';
import { choice, Figure, tooltip } from './figure';
import { ordered, symbols } from './look';
import { distinct } from './table_view';
import { axisTitle, plain, quantity, withUnit } from './text';

const mostSpeeds = 5; // around the bearing

/// At most `most` places of a list of `count`, its ends among them.
function spread(count: number, most: number): number[] {
  return count <= most ? Array.from({ length: count }, (_, k) => k) : Array.from({ length: most }, (_, k) => Math.round((k * (count - 1)) / (most - 1)));
}

type BallColumn = 'inner_load_N' | 'outer_load_N' | 'inner_pressure_MPa' | 'outer_pressure_MPa' | 'inner_contact_angle_deg' | 'outer_contact_angle_deg';

/// The ball that carries most and the one that carries least, against speed.
export function balls(states: BearingState[]): Figure {
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
    note: 'Solid: largest value of all balls. Dashed: smallest value. If all balls have the same value, there is one line.',
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
      const top = symbolLegend(names, width, l);
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

/// One value of every ball around the bearing, a line for each speed.
export function around(states: BearingState[]): Figure {
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
    note: `At ${withUnit((states[0] as BearingState).temperature_C, 'temperature_C')}. 0° is the direction of the radial load. A ball without contact with the inner race has no inner angle.`,
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
