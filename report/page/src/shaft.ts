// A shaft against speed: its displacement and the law of it, forces of the sets, every bearing.
import type { DisplacementReport } from './document';
import type { Rows } from './document';
import type { Figure } from './figure';
import { lineFigure } from './line_figure';
import type { Look } from './look';
import { number, plain } from './text';

/// The displacement, its law and what the law leaves.
export function lawFigures(report: DisplacementReport, rows: Rows): Figure[] {
  const { law, law_curve: curve } = report;
  const withLaw = law && curve;
  const figures = [
    lineFigure(rows, {
      id: 'displacement',
      title: 'Shaft displacement',
      note: 'Measured from the position of the shaft at standstill under the same load.',
      wide: true,
      height: 400,
      axis: 'axial_displacement_um',
      lines: [{ name: 'computed', column: 'axial_displacement_um', kind: 0 }],
      ...(withLaw
        ? {
            moreNames: ['fitted law'],
            more: (l: Look) => [
              {
                type: 'line',
                name: 'fitted law',
                silent: true, // or it would lie over the points that answer the pointer
                symbol: 'none',
                z: 4,
                color: l.kinds[1],
                lineStyle: { width: 2, type: 'dashed' },
                data: curve,
              },
            ],
          }
        : {}),
      table: ['axial_displacement_um', ...(withLaw ? ['law_displacement_um', 'law_residual_um'] : [])],
      csv: rows.names.filter((name) => name !== 'speed_rpm'),
    }),
  ];
  if (withLaw)
    figures.push(
      lineFigure(rows, {
        id: 'law-residual',
        title: 'Residual of the law',
        note: `Law minus computed: mean absolute error ${number(law.mae_um, 3)} µm over ${law.rows} speeds, largest ${number(law.max_abs_um, 3)} µm at ${plain(law.max_abs_at_rpm)} rpm.`,
        wide: true,
        height: 240,
        axis: 'law_residual_um',
        lines: [{ name: 'law − computed', column: 'law_residual_um', kind: 1 }],
        fromZero: true,
      }),
    );
  return figures;
}

interface Group {
  name: string;
  place: string; // the first of those that are alike
}

/// Bearings that have the same numbers are one line: in a tandem of equal bearings they all do.
function alike(report: DisplacementReport, rows: Rows, names: string[]): Group[] {
  const groups: { places: string[] }[] = [];
  const equal = (a: string, b: string) =>
    names.every((name) => {
      const [p, q] = [rows.get(`${a}_${name}`), rows.get(`${b}_${name}`)];
      return p.every((v, k) => {
        const w = q[k] as number;
        return (Number.isNaN(v) && Number.isNaN(w)) || Math.abs(v - w) <= 1e-5 * Math.max(Math.abs(v), Math.abs(w));
      });
    });
  for (const place of report.places) {
    const same = groups.find((g) => equal(g.places[0] as string, place));
    if (same) same.places.push(place);
    else groups.push({ places: [place] });
  }
  return groups.map((g) => ({ name: g.places.map((p) => p.replace('_', ' ')).join(', '), place: g.places[0] as string }));
}

export function shaftFigures(report: DisplacementReport, rows: Rows): Figure[] {
  const all = (names: string[]) => report.places.flatMap((place) => names.map((name) => `${place}_${name}`));
  /// Inner (solid) and outer (dashed) race of every bearing.
  const races = (id: string, title: string, axis: string, inner: string, outer: string, note = '', fromZero = true) =>
    lineFigure(rows, {
      id,
      title,
      note: `Solid: inner ${note || 'race'}, dashed: outer ${note || 'race'}.`,
      axis,
      fromZero,
      lines: alike(report, rows, [inner, outer]).flatMap((group, k) => [
        { name: group.name, column: `${group.place}_${inner}`, kind: k, told: `inner ${note || 'race'}` },
        { name: group.name, column: `${group.place}_${outer}`, kind: k, dash: 1, told: `outer ${note || 'race'}` },
      ]),
      table: all([inner, outer]),
    });
  return [
    lineFigure(rows, {
      id: 'forces',
      title: 'Forces of the sets',
      note: 'Axial force of each set on the shaft.',
      axis: 'force_N',
      fromZero: true,
      lines: [
        { name: 'front', column: 'front_force_N', kind: 0 },
        { name: 'rear', column: 'rear_force_N', kind: 1, dash: 1 },
      ],
      table: ['front_force_N', 'rear_force_N', ...all(['axial_load_N'])],
    }),
    lineFigure(rows, { id: 'stiffness', title: 'Axial stiffness of the shaft', axis: 'axial_stiffness_N_um', fromZero: true, lines: [{ name: 'axial stiffness', column: 'axial_stiffness_N_um', kind: 0 }] }),
    races('contact-angles', 'Contact angles', 'contact_angle_deg', 'inner_contact_angle_deg', 'outer_contact_angle_deg', '', false),
    races('ball-loads', 'Ball loads', 'ball_load_N', 'inner_load_N', 'outer_load_N'),
    races('pressures', 'Contact pressures', 'peak_pressure_MPa', 'inner_contact_pressure_MPa', 'outer_contact_pressure_MPa'),
    lineFigure(rows, {
      id: 'torque',
      title: 'Friction torque',
      axis: 'friction_torque_Nmm',
      fromZero: true,
      lines: [
        { name: 'all bearings', column: 'friction_torque_Nmm', kind: 6 },
        ...alike(report, rows, ['friction_torque_Nmm']).map((group, k) => ({ name: group.name, column: `${group.place}_friction_torque_Nmm`, kind: k, dash: 1, told: 'each' })),
      ],
      table: ['friction_torque_Nmm', ...all(['friction_torque_Nmm'])],
    }),
    lineFigure(rows, {
      id: 'power',
      title: 'Power loss',
      axis: 'power_loss_W',
      fromZero: true,
      lines: [{ name: 'all bearings', column: 'power_loss_W', kind: 6 }, ...alike(report, rows, ['power_loss_W']).map((group, k) => ({ name: group.name, column: `${group.place}_power_loss_W`, kind: k, dash: 1, told: 'each' }))],
      table: ['power_loss_W', ...all(['power_loss_W'])],
    }),
    races('heat', 'Heat into the rings', 'heat_W', 'inner_ring_heat_W', 'outer_ring_heat_W', 'ring'),
  ];
}
