// A Stribeck table: torque, its parts and contact angles against speed, loads around the bearing.
import { around, balls } from './ball_figures';
import { symbolLegend, valueAxis } from './chart';
import { curvesFigure } from './curves';
import type { TableReport } from './document';
import { Rows } from './document';
import { choice, Figure, tooltip } from './figure';
import { dashes, ordered, symbols } from './look';
import { mostCurves, TableView } from './table_view';
import type { Slice } from './table_view';
import { axisTitle, number, plain, quantity, withUnit } from './text';

const angles = ['inner_contact_angle_max_deg', 'inner_contact_angle_min_deg', 'outer_contact_angle_max_deg', 'outer_contact_angle_min_deg'];

export function tableFigures(report: TableReport): Figure[] {
  const view = new TableView(report);
  const { rows, axials, chosen, figures } = view;
  const measured = report.measured ? new Rows(report.measured.rows) : undefined;
  const torques = measured?.has('measured_Nmm') ? measured : undefined;
  const positions = measured?.has('measured_um') && rows.has('axial_displacement_um') ? measured : undefined;
  const note = [
    axials.length > mostCurves ? `The picture shows ${mostCurves} of ${axials.length} axial loads; the table has all.` : '',
    measured && !torques && !positions ? `The table has no ${report.measured?.quantity.in_words}, so the picture shows no measured points.` : '',
  ]
    .join(' ')
    .trim();
  figures.push(
    curvesFigure(view, {
      id: 'stribeck',
      title: 'Stribeck curves',
      column: 'friction_torque_Nmm',
      points: torques,
      reading: 'measured_Nmm',
      note,
      choices: [...view.controls(), choice('Speed axis', ['linear', 'logarithmic'], 0, (k) => ((chosen.logarithmic = k === 1), view.redraw()))],
    }),
  );
  if (positions)
    figures.push(
      curvesFigure(view, {
        id: 'position',
        title: 'Displacement of the shaft',
        column: 'axial_displacement_um',
        points: positions,
        reading: 'measured_um',
        note: `Positive towards the tool.${positions.has('preload_N') ? ' A point whose preload differs from the model counts as a point at another load.' : ''}`,
        choices: [],
      }),
    );
  figures.push(
    partsFigure(
      view,
      report.results.parts.filter((name) => rows.has(name)),
    ),
  );
  if (angles.every((name) => rows.has(name))) figures.push(anglesFigure(view, report.results.contact_angle_deg));
  if (report.states.length) figures.push(balls(report.states), around(report.states));
  return figures;
}

/// The parts of the torque at one axial load.
function partsFigure(view: TableView, parts: string[]): Figure {
  return new Figure({
    id: 'parts',
    title: 'Parts of the torque',
    controls: [
      choice(
        'Axial load',
        view.axials.map((v) => withUnit(v, 'axial_load_N')),
        view.chosen.axial,
        (k) => ((view.chosen.axial = k), view.redraw()),
      ),
    ],
    option: (l, width) => {
      const slice = view.slices()[view.chosen.axial] as Slice;
      const names = parts.map((name) => quantity(name).label);
      const top = symbolLegend(names, width, l);
      return {
        legend: top.option,
        grid: { left: 60, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => [hit.seriesName, ['speed', `${plain((hit.value as number[])[0])} rpm`], ['torque', `${number((hit.value as number[])[1])} N mm`]]),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
        yAxis: valueAxis(`torque [N mm], ${view.place()}`, l, 'y', { scale: false }),
        series: parts.map((name, k) => ({
          type: 'line',
          name: names[k],
          stack: 'torque',
          symbol: symbols[k % symbols.length],
          symbolSize: 6,
          color: l.kinds[k % l.kinds.length],
          lineStyle: { width: 1.5, type: dashes[k % dashes.length] },
          areaStyle: { opacity: 0.35 },
          data: slice.rows.map((row) => [view.rows.at('speed_rpm', row), view.rows.at(name, row)]),
        })),
      };
    },
    table: view.columns(parts),
  });
}

/// `free`: the contact angle without load.
function anglesFigure(view: TableView, free: number | undefined): Figure {
  return new Figure({
    id: 'angles',
    title: 'Contact angles against speed',
    note: `Solid: inner race, dashed: outer race; ${free ? `${plain(free, 4)}° without load` : ''}. If the balls differ, the lines show the smallest and the largest angle.`,
    option: (l, width) => {
      const curves = view.shown();
      const names = curves.map((c) => `${plain(c.axial)} N`);
      const colours = ordered(curves.length, l);
      const top = symbolLegend(names, width, l);
      return {
        legend: top.option,
        grid: { left: 56, right: 20, top: top.height + 28, bottom: 46 },
        tooltip: tooltip(l, (hit) => {
          const [speed, angle, , race] = hit.value as [number, number, number, string];
          return [`${race} race, ${hit.seriesName}`, ['speed', `${plain(speed)} rpm`], ['contact angle', `${number(angle)}°`]];
        }),
        xAxis: valueAxis(axisTitle('speed_rpm'), l, 'x'),
        yAxis: valueAxis(`contact angle [°], ${view.place()}`, l, 'y'),
        series: curves.flatMap((c, k) =>
          angles.map((name) => ({
            type: 'line',
            name: names[k],
            symbol: symbols[k % symbols.length],
            symbolSize: 6,
            color: colours[k],
            lineStyle: { width: 1.6, type: name.startsWith('inner') ? 'solid' : 'dashed' },
            data: c.rows.map((row) => [view.rows.at('speed_rpm', row), view.rows.at(name, row), row, name.startsWith('inner') ? 'inner' : 'outer']),
          })),
        ),
      };
    },
    table: view.columns(angles),
  });
}
