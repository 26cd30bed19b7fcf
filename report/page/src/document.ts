// The data inside the page, as report/report.cpp writes them.

/// A note of a result.
export interface Said {
  kind: 'note' | 'doubt' | 'warning';
  code: string;
  text: string;
}

export interface Column {
  name: string;
  constant?: number | null;
  values?: (number | null)[];
}

export interface ColumnData {
  total: number;
  rows: number;
  columns: Column[];
}

export interface AxisRange {
  from?: number;
  to?: number;
  run?: string;
}

export interface MisfitCell {
  across: number;
  up: number;
  rows: number;
  bias: number;
  sigmas: number | null;
  significant: boolean;
}

export interface MisfitMap {
  across_column: string;
  up_column: string;
  across: AxisRange[];
  up: AxisRange[];
  needed_sigmas: number;
  cells: MisfitCell[];
}

/// What one model says of the rows.
export interface Predicted {
  name: string;
  column: string;
  rmse: number;
  map: MisfitMap;
}

export interface ErrorRange {
  variable: string;
  from: number | string;
  to: number | string;
  unit: string;
  rows: number;
  rmse: number;
  bias: number;
}

export interface Comparison {
  model: string;
  data: string;
  quantity: string;
  unit: string; // of errors
  channels?: Comparison[]; // of what has several
  rows: number;
  rows_not_predicted: number[];
  rmse: number;
  mae: number;
  max_abs: number;
  bias: number;
  fit_percent: number | null;
  noise: { rms: number | null; source: string; estimated_rms?: number };
  lack_of_fit: { statistic: number | null; p_value: number | null };
  statement: string;
  where: ErrorRange[];
  worst_rows: { line: number; predicted: number; measured: number; residual: number; sigmas: number | null }[];
}

export interface Size {
  value: number | null;
  std: number | null;
  unit: string;
  plausible?: boolean;
  at_bound?: boolean;
}

export interface HoldOut {
  left_out: string;
  rmse_before: number;
  rmse_after: number;
}

/// Base parameters without an effect and with it.
export type BaseShifts = Record<string, { before: number; after: number; std: number | null; unit: string }>;

export interface RankedEffect {
  id: string;
  in_verdict: boolean;
  gain: number;
  rmse: number;
  rmse_cross_validated: number | null;
  parameters: Record<string, Size>;
  base_parameters: BaseShifts;
  indistinguishable_from: string[];
  channels?: { quantity: string; rmse: number; rmse_cross_validated: number | null }[]; // where there are several
}

export interface Detectable {
  id: string;
  parameter: string;
  unit: string;
  size: number;
  share_of_reading: number;
  most_alike: string;
  told_apart_from: number | null;
}

/// A point to measure: inputs by the names of their columns, and why.
export interface Suggested {
  [input: string]: number | string | null;
  repeats: number;
  separates: string;
  difference_in_sigma: number | null;
}

export interface Diagnosis {
  model: string;
  data: string;
  verdict: string;
  headline: string;
  sentence: string;
  p_value: number | null;
  remaining_p_value: number | null;
  needed_gain: number;
  candidates_tried: number;
  rows: number;
  rmse_before: number;
  rmse_after: number;
  noise: { rms: number; relative: number; absolute: number; correlation: number; run_share: number };
  baseline: Comparison;
  channels?: { quantity: string; unit: string; rmse_before: number; rmse_after: number; noise: { rms: number } }[]; // where there are several
  effects: RankedEffect[];
  explanations: string[][];
  base_parameters: BaseShifts;
  hold_out: HoldOut[];
  would_have_been_found: Detectable[];
  not_testable: { id: string; missing: string }[];
  suggested_measurements: Suggested[];
  said: Said[]; // messages, then notes on the record
  /// With a tolerance: whether the refitted model is good enough on rows left out.
  within_tolerance?: boolean;
  significant_but_immaterial?: string[];
  /// With the formula under the name of the reading, torque_Nmm.
  shape?: { coefficients: Record<string, Size>; statement: string; explained_share: number | null };
}

export interface Added {
  model: string;
  data: string;
  refused: boolean;
  reason: string;
  before: Comparison;
  after: Comparison;
  rmse_held_out_before: number | null;
  rmse_held_out_after: number | null;
  hold_out: HoldOut[];
  calibration: { parameters: Record<string, Size & { start: number }> };
  said: Said[]; // messages, then notes on the record
}

export interface TableResults {
  model: string;
  bearing: string;
  parts: string[];
  contact_angle_deg: number;
}

/// The balls of a bearing at one operating point, in the order of their azimuth.
export interface BearingState {
  speed_rpm: number;
  axial_load_N: number;
  radial_load_N: number;
  temperature_C: number;
  azimuth_deg: number[];
  inner_contact_angle_deg: (number | null)[];
  outer_contact_angle_deg: (number | null)[];
  inner_load_N: (number | null)[];
  outer_load_N: (number | null)[];
  inner_pressure_MPa: (number | null)[];
  outer_pressure_MPa: (number | null)[];
}

/// What a model takes for granted.
export interface ModelFacts {
  model: string;
  bearing: string;
  law: string;
  factors: { name: string; value: number; unit: string }[];
  effects: string[];
  viscosity_40C_mm2_s: number;
  viscosity_100C_mm2_s: number;
  defaults: string[];
}

interface Common {
  judged?: string[]; // limits that the answer passes, a line each
  raceway_report: number;
  program: string;
  assumed: ModelFacts[];
  rows: ColumnData;
}

/// What was measured; columns of readings end with the unit.
export interface MeasuredQuantity {
  in_words: string; // "friction torque"
  unit: string; // as names have it: "Nmm"
}

interface WithRows extends Common {
  quantity: MeasuredQuantity;
  inputs: string[]; // columns of what was set
  models: Predicted[];
  runs: string[];
  other_channels?: string[]; // measured as well, and not drawn
}

/// What changed from one model to the next.
export interface Step {
  added: string[];
  removed: string[];
  numbers: { name: string; unit: string; before: number | null; after: number }[];
}

/// Effects with the base parameters refitted: columns of the readings, of the part without these
/// effects, and of what each effect adds.
export interface Explanation {
  effects: { id: string; column: string }[];
  base: string;
  total: string;
}

export interface CompareReport extends WithRows {
  kind: 'compare';
  results: (Comparison | { models: Comparison[] }) & { said: Said[] }; // notes on the record
  steps: Step[]; // between the models
}

export interface DiagnoseReport extends WithRows {
  kind: 'diagnose';
  results: Diagnosis;
  explanations: Explanation[]; // that of the verdict first
  preload_N?: number; // of the model of a shaft
}

export interface AddReport extends WithRows {
  kind: 'add';
  results: Added;
  noise_rms: number | null;
}

export interface TableReport extends Common {
  kind: 'table';
  results: TableResults;
  states: BearingState[];
  data?: string;
  measured?: { rows: ColumnData; quantity: MeasuredQuantity };
  preload_N?: number; // of the model of a shaft
}

export interface KinematicLaw {
  law: string;
  parameters: Record<'A' | 'B' | 'C', Size>;
  mae_um: number;
  max_abs_um: number;
  max_abs_at_rpm: number;
  rows: number;
  valid_from_rpm: number;
  valid_to_rpm: number;
  said: Said[];
}

export interface DisplacementReport extends Common {
  kind: 'displacement';
  model: string;
  results: { bearing: string; arrangement: { preload_N: number; front_lift_off_load_N: number | null; rear_lift_off_load_N: number | null } };
  places: string[]; // front_1, front_2, rear_1: columns of bearings begin so
  warnings: string[];
  law_statement: string;
  law?: KinematicLaw;
  law_curve?: [number, number][];
}

/// How a simulation of a spindle ended.
export interface SpindleEnd {
  status: string;
  message: string;
  steps: number;
  rejected: number;
  energy_error: number | null;
}

/// Half of a spindle, cut along its axis, with the temperatures of its cells at some moments.
export interface Section {
  cells: { part: string[]; start_mm: number[]; end_mm: number[]; inner_radius_mm: number[]; outer_radius_mm: number[] };
  bearings: {
    label: string;
    position_mm: number;
    width_mm: number;
    bore_mm: number;
    outer_diameter_mm: number;
    inner_ring_shoulder_mm: number;
    outer_ring_shoulder_mm: number;
    pitch_diameter_mm: number;
    ball_diameter_mm?: number; // of a ball bearing, with the two below
    contact_angle_deg?: number;
    pressed_rearwards?: boolean;
    roller_diameter_mm?: number; // of a cylindrical roller bearing, with its length
    roller_length_mm?: number;
  }[];
  sensors: { name: string; position_mm: number; radius_mm: number }[];
  flange: { position_mm: number; length_mm: number };
  channels?: { start_mm: number; end_mm: number; diameter_mm: number; width_mm: number; depth_mm: number; pitch_mm: number }[];
  moments: { time_s: number | null; speed_rpm: number | null; temperature_C: number[] }[];
}

interface SpindlePage extends Common {
  model: string;
  mesh: string; // what the command says of its cells
  network: boolean;
  has_coolant: boolean;
  bearings: string[]; // front_1, rear_1: columns of bearings begin so
  sensors: string[]; // and those of sensors
  section?: Section; // not of a network
}

/// The assumed numbers that move the nose most, by their usual spread; null where that leaves no state.
export interface Assumptions {
  speed_rpm: number;
  axial_displacement_um: number;
  assumed: number;
  most: { name: string; value: number; spread: number; displacement_at_less_um: number | null; displacement_at_more_um: number | null }[];
}

export interface SpindleRunReport extends SpindlePage {
  kind: 'spindle_run';
  programme: string;
  results: { spindle: string; report: SpindleEnd; highest_front_force: { force_N: number; time_s: number | null }; assumptions?: Assumptions };
  rows_asked: number;
  rows_reached: number;
  ended_at_s: number | null;
  inputs: string[];
}

export interface SpindleSteadyReport extends SpindlePage {
  kind: 'spindle_steady';
  results: { spindle: string; assumptions?: Assumptions };
  preload_N?: number;
  coolant_on: boolean;
  reports: { status: string; in_words: string }[]; // row by row
}

/// Pieces of a shaft with bearings and disks, to be drawn along its axis.
export interface ShaftPieces {
  pieces: { start_mm: number; end_mm: number; diameter_mm: number; bore_mm: number }[];
  bearings: { label: string; position_mm: number; pitch_diameter_mm: number; ball_diameter_mm: number }[];
  disks: { position_mm: number; mass_kg: number }[];
}

export interface Mode {
  frequency_Hz: number;
  whirl: string;
  damping_ratio?: number | null;
}

/// Where something that goes with the speed meets a mode.
export interface Crossing {
  excitation: string; // 1x, 2x, "front_1 outer race"
  mode: number; // of its sense, from 1
  whirl: string;
  speed_rpm: number;
  frequency_Hz: number;
}

/// A row of the Campbell diagram; forces and stiffness by name.
export type CampbellRow = { speed_rpm: number; modes: (Mode & { mode: number })[]; report: { status: string; message?: string } } & Record<string, unknown>;

interface BeamPage {
  judged?: string[]; // limits that the answer passes, a line each
  raceway_report: number;
  program: string;
  assumed: ModelFacts[];
  model: string;
  bearing: string;
  warm: boolean;
  shaft: ShaftPieces;
  nodes_mm: number[];
}

export interface ModesReport extends BeamPage {
  kind: 'modes';
  weight_kg: number;
  results: { preload_N: number; rows: CampbellRow[]; crossings: Crossing[] };
  bearings: string[];
  shapes: { speed_rpm: number; modes: (Mode & { y: number[]; z: number[] })[] }[];
}

/// A bearing under load, with its balls in the order of their azimuth.
export interface LoadedBearing {
  place: string;
  axial_load_N: number;
  radial_load_N: number;
  moment_Nm: number;
  largest_inner_load_N: number;
  least_inner_load_N: number;
  largest_inner_contact_angle_deg: number | null;
  least_inner_contact_angle_deg: number | null;
  lost_balls: number;
  axial_stiffness_N_um: number;
  radial_stiffness_N_um: number;
  balls: { azimuth_deg: number; inner_load_N: number; outer_load_N: number; inner_contact_angle_deg: number | null; outer_contact_angle_deg: number | null }[];
}

export interface DeflectionReport extends BeamPage {
  kind: 'deflection';
  load: string; // in words
  results: {
    speed_rpm: number;
    force_N: number;
    axial_force_N?: number;
    moment_Nm?: number;
    direction: string;
    at_mm: number;
    preload_N: number;
    unloaded_front_force_N: number | null;
    unloaded_rear_force_N: number | null;
    displacement_um: number | null;
    nose_displacement_um: number | null;
    nose_slope_urad: number | null;
    stiffness_N_um: number | null;
    tangent_displacement_um: number | null;
    bearings: LoadedBearing[];
    report: { status: string; message?: string };
  };
  line: { total_um?: number[]; tangent_um?: number[]; stiff_um?: number[]; radial_stiffness_before_N_um?: number[] };
}

/// A step response as a row of steps.csv.
export interface StepRow {
  load_case?: string;
  speed_rpm: number | null;
  power_start_W: number | null;
  power_end_W: number | null;
  kinematic_um: number | null;
  K_um: number | null;
  T_min: number | null;
  fit_rms_um: number | null;
  K1_um: number | null;
  T1_min: number | null;
  K2_um: number | null;
  T2_min: number | null;
  fit_rms_two_um: number | null;
  front_force_N: number | null;
  highest_front_force_N: number | null;
  two_needed: boolean;
  settled: boolean;
  status: string;
  message?: string;
  axial_load_N?: number | null; // of a step of a load
  radial_load_N?: number | null;
}

export interface StepCourse {
  time_s: number[];
  displacement_um: number[];
}

type Values = (number | null)[];

export interface StepsReport {
  raceway_report: number;
  program: string;
  kind: 'steps';
  assumed: ModelFacts[];
  source: string;
  results: {
    rows: StepRow[];
    load_rows?: StepRow[];
    K_of_P: { slope_um_W: number | null; offset_um: number | null; slope_um_W_std: number | null; offset_um_std: number | null };
    T_of_P: { slope_min_W: number | null; offset_min: number | null; slope_min_W_std: number | null; offset_min_std: number | null };
    K_power_law: { factor_um: number | null; exponent: number | null; exponent_std: number | null; rms_percent: number | null };
    T_power_law: { factor_min: number | null; exponent: number | null; exponent_std: number | null; rms_percent: number | null };
    valid_from_W: number | null;
    valid_to_W: number | null;
    cool_down?: { K_um: number; T_min: number; fit_rms_um: number; T_at_rest_min: number | null };
    superposition?: { rows: number; rms_um: number; largest_um: number; time_of_largest_s: number; lowest_um: number; highest_um: number; status: string };
    said: Said[];
  };
  courses: StepCourse[];
  load_courses?: StepCourse[]; // of load_rows
  laws: { power_W: number[]; K_line_um: Values; K_power_um: Values; K_curve_um: Values; T_line_min: Values; T_power_min: Values; T_curve_min: Values } | null;
  programme?: string;
  rows?: ColumnData; // of the programme
}

/// What a step of an input does: lags, each gain (1 − exp(−t/T)).
export interface StepResponse {
  name: string;
  input: string; // for people
  step: number;
  unit: string;
  parts: { name: string; gain: number; time_constant_s: number }[]; // in the unit of the model
  at_once: number;
  sensor_time_constant_s: number;
  sampled: number[]; // of printed coefficients instead of parts
  sampling_s: number | null;
  changed_by: string[];
}

/// A correction, or one channel of a spindle, over a record: names of columns, and what else is drawn of it.
export interface ModelOverTime {
  name: string;
  displacement: string;
  in_words: string;
  unit: string; // of the columns, as their names have it
  predicted: string;
  measured?: string;
  tolerance: number | null;
  initial_state?: string;
  defaults: string[];
  parts?: { name: string; column: string; inputs: string[] }[]; // of a correction
  responses?: StepResponse[];
  held_out_parts?: { part: number; from_h: number; to_h: number }[];
  /// Errors of a fit to the other parts, at means of readings.
  held_out?: { hours: number[]; piece: number[]; part: number[]; residual: number[] };
}

/// What `correct` says of one displacement.
export interface CorrectedAxis {
  displacement: string;
  rows_beyond_range: number;
  /// Names of errors end in the unit of the displacement: rmse_um, of an angle rmse_urad.
  metrics: { readings: number; fit_percent: number | null; reduction_of_max_percent: number | null };
}

export interface Corrected extends CorrectedAxis {
  model: string;
  data: string;
  rows: number;
  axes?: CorrectedAxis[];
  said: Said[];
}

interface RecordPage extends Common {
  kind: 'record';
  models: ModelOverTime[];
  inputs: string[];
  runs: string[];
  runs_in_sequence: boolean; // their clocks begin anew: drawn one after the other
  steps: Step[]; // between models of spindles
}

export type RecordReport = RecordPage & ({ command: 'compare'; results: CompareReport['results'] } | { command: 'diagnose'; results: Diagnosis } | { command: 'add'; results: Added } | { command: 'correct'; results: Corrected });

export type Report = CompareReport | DiagnoseReport | AddReport | TableReport | DisplacementReport | RecordReport | SpindleRunReport | SpindleSteadyReport | ModesReport | DeflectionReport | StepsReport;
export type ReportOfRows = CompareReport | DiagnoseReport | AddReport;

export function readDocument(): Report {
  const text = document.getElementById('document')?.textContent ?? '';
  return JSON.parse(text) as Report;
}

/// Numbers of rows that have names of their own, as columns.
export function columnsOf(rows: Record<string, unknown>[]): ColumnData {
  const names = [...new Set(rows.flatMap((r) => Object.keys(r).filter((name) => typeof r[name] === 'number')))];
  return { total: rows.length, rows: rows.length, columns: names.map((name) => ({ name, values: rows.map((r) => (typeof r[name] === 'number' ? (r[name] as number) : null)) })) };
}

/// Columns of numbers by name; NaN where a number is not known.
export class Rows {
  readonly total: number;
  readonly count: number;
  readonly names: string[];
  private readonly columns = new Map<string, Float64Array>();
  private readonly constants = new Set<string>();

  constructor(data: ColumnData) {
    this.total = data.total;
    this.count = data.rows;
    this.names = data.columns.map((c) => c.name);
    for (const column of data.columns) {
      const values = new Float64Array(data.rows);
      if (column.values) for (let i = 0; i < data.rows; ++i) values[i] = column.values[i] ?? NaN;
      else values.fill(column.constant ?? NaN);
      if (!column.values) this.constants.add(column.name);
      this.columns.set(column.name, values);
    }
  }

  has(name: string): boolean {
    return this.columns.has(name);
  }
  /// True if the column has more than one value.
  varies(name: string): boolean {
    return this.has(name) && !this.constants.has(name);
  }
  get(name: string): Float64Array {
    const values = this.columns.get(name);
    if (!values) throw new Error(`no column ${name}`);
    return values;
  }
  at(name: string, row: number): number {
    return this.get(name)[row] ?? NaN;
  }
}
