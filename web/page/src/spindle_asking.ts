// Questions about a spindle without measurements: its steady state at once, its programme and modes when they are looked at.
import { documentOf, reportOf, type Asking } from './asking';
import type { Answer } from './engine';
import * as ask from './questions';
import type { Machine, Panel, Written } from './state';
import type { ModesReport, SpindleRunReport, SpindleSteadyReport } from '../../../report/page/src/document';

/// Columns of a programme; a record has others.
const settings = /^(time_s|speed_rpm|coolant_on|(ambient|machine|coolant_inlet)_temperature_C|axial_load_N|radial_load_N|moment_Nm|belt_force_N|motor_heat_W|motor_power_W)$/;

export const isProgramme = (header: string[]): boolean => header.includes('time_s') && header.includes('speed_rpm') && header.every((name) => settings.test(name));

function written<T>(answer: Answer): Written<T> {
  documentOf(answer);
  const page = answer.files['report.html'] as string;
  return { report: reportOf<T>(page), page };
}

/// Asks what the step that is shown needs and `has` lacks.
export async function askSpindle(asking: Asking, { of, ...has }: Machine, model: string, panel: Panel, known: (part: Partial<Machine>) => void): Promise<void> {
  if (!has.steady) known({ steady: written<SpindleSteadyReport>(await asking.ask('Finding the steady state', ask.steady(of, model))) });
  if (panel === 'programme' && of.programme && !has.run) {
    const answer = await asking.ask('Running the programme', ask.simulate(of, model, of.programme));
    known({ run: { ...written<SpindleRunReport>(answer), rows: answer.files['run.csv'] ?? '' } });
  }
  if (panel === 'modes' && !has.modes) known({ modes: written<ModesReport>(await asking.ask('Finding the modes', ask.modes(of, model))) });
}
