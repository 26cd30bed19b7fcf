// The one state of the page. Views read it, actions replace it, nothing else holds anything that matters.
import type { Job } from './asking';
import type { AddReport, CompareReport, DiagnoseReport, ModesReport, RecordReport, Said, SpindleRunReport, SpindleSteadyReport } from '../../../report/page/src/document';

/// Pages of the command: of readings one by one, or of a record over time.
export type Diagnosed = DiagnoseReport | (RecordReport & { command: 'diagnose' });
export type AddedTo = AddReport | (RecordReport & { command: 'add' });
export type Compared = CompareReport | (RecordReport & { command: 'compare' });

export interface TextFile {
  name: string;
  text: string;
}

export type ExampleName = 'rig' | 'record' | 'spindle';

/// What a step of the history brings back: all that a user has chosen.
export interface Case {
  example: ExampleName | ''; // the case that is built in, as long as it is shown
  data: TextFile[];
  map: string; // the table [columns]; empty where the columns have our names
  model: TextFile | undefined;
  start: TextFile | undefined; // the correction before its lags were found in the record
  bank: boolean; // they were found of all sensors, each through a bank of lags
  fromRecord: boolean; // the correction was made of the record's columns
  designation: string; // that the model was made of, for the commands; empty of a file
  oil: string; // the same
  dropNan: boolean; // rows with an empty cell are left out
  rows: boolean; // rows of a logger stay apart
  until: string; // readings of a record up to then are fitted to, those that follow judge: "26h"; empty: all are fitted to
  channel: string; // of a model with several displacements the one in question
  law: string; // a base law instead of that of the model; empty: as it is
  on: string[]; // effects
  forced: boolean; // added though the command refuses
  speed: string; // of a spindle's steady state [rpm], a number or from:to:step
  coolantOff: boolean;
  axialLoad: string; // at the nose [N]; empty: that of the model
  radialLoad: string;
  programme: TextFile | undefined; // of speeds
  modeSpeeds: string; // of its modes [rpm], from:to:step
}

/// How far a correction may be trusted, in the words of the command.
export interface Trust {
  verdict: 'good' | 'within-range' | 'do-not-use' | 'unknown';
  because: string;
}

/// What the engine says of a case, step by step as answers come in.
export interface Result {
  on: string[]; // the effects that it is of
  entered: string; // text of the model with the chosen base law
  base: Diagnosed;
  added?: AddedTo;
  refused?: string; // why an effect or a law was not taken
  rest?: Diagnosed; // of the model with the effects
  compared?: Compared;
  names?: string[]; // of its models, in their order
  before?: number; // RMS error of the correction before its lags were found, refitted
  trust?: Trust; // of the correction in `model`
  recorded?: boolean; // of the page itself, not yet of the engine
  refitted?: string; // text, nothing added
  model?: string; // text, refitted, with the effects
  report?: string; // the page of the command
}

/// An answer with the page that the command wrote of it.
export interface Written<T> {
  report: T;
  page: string;
}

/// What the engine says of a spindle without measurements.
export interface Machine {
  of: Case;
  steady?: Written<SpindleSteadyReport>;
  run?: Written<SpindleRunReport> & { rows: string }; // rows: the CSV
  modes?: Written<ModesReport>;
}

export interface Line {
  label: string;
  rmse: number | undefined; // of a spindle the displacement of its nose
  held: number | undefined; // on rows left out of the fit; of a spindle the force of its front set [N]
  unit: string;
  spindle?: boolean;
  of: Case;
}

/// A data file as the engine reads it.
export interface Reading {
  said: Said[];
  rows: number;
  columns: { name: string; from: number | null; to: number | null; levels: number }[];
  noise: { rms: number | null; source: string; estimated_rms?: number };
  defaults?: string[]; // "lubricant.supply = limited (default)"
  unit: string; // of the readings: "Nmm"
  numbers: Map<string, Float64Array>;
}

export interface Problem {
  at: Panel;
  text: string;
}

export interface Key {
  table: string;
  key: string;
  kind: string;
  unit: string | null;
  from: number | null;
  to: number | null;
  choices: string[];
  default: string | null;
  only: string | null; // "law palmgren", "spindle"
  meaning: string;
}

export interface EffectCard {
  id: string;
  title: string;
  mechanism: string;
  formula: string;
}

/// Entries of the catalogue for what was typed.
export interface Offer {
  bearings: { name: string; bore_mm: number; outer_diameter_mm: number; ball_diameter_mm: number; ball_count: number; contact_angle_deg: number }[];
  sameSize: boolean; // none has that name: they have the size that it stands for
}

/// A base law in place of that of the model, all refitted.
export interface LawTried {
  law: string;
  rmse: number;
  held: number | null;
}

export type Panel = 'missing' | 'data' | 'model' | 'compare' | 'steady' | 'programme' | 'modes' | 'history' | 'home';

export interface State extends Case {
  panel: Panel;
  proposal: string; // what the engine proposes as [columns]
  confirmed: boolean; // the map was looked at, or needs no look
  reading: Reading | undefined;
  modelNotes: string[]; // what `new` said of the model
  problem: Problem | undefined;
  result: Result | undefined;
  machine: Machine | undefined; // in place of the result, of a spindle without measurements
  stale: boolean; // the result is of an earlier case
  laws: LawTried[];
  history: Line[];
  at: number; // the line of the history that is shown
  running: number; // actions that are under way
  job: Job | undefined;
  took: { label: string; ms: number } | undefined;
  keys: Key[];
  effects: Map<string, EffectCard>;
  toml: boolean; // the text of the model is shown
}

/// Nothing chosen: every case begins with it.
export const nothing: Case = {
  example: '',
  data: [],
  map: '',
  model: undefined,
  start: undefined,
  bank: false,
  fromRecord: false,
  designation: '',
  oil: '',
  dropNan: false,
  rows: false,
  until: '',
  channel: '',
  law: '',
  on: [],
  forced: false,
  speed: '6000',
  coolantOff: false,
  axialLoad: '',
  radialLoad: '',
  programme: undefined,
  modeSpeeds: '0:20000:1000',
};

const choices = Object.keys(nothing) as (keyof Case)[];

export const caseOf = (state: Case): Case => Object.fromEntries(choices.map((name) => [name, state[name]])) as unknown as Case;

/// What belongs to a case and goes with it.
export const unanswered = { proposal: '', reading: undefined, modelNotes: [], problem: undefined, result: undefined, machine: undefined, stale: false, laws: [] };

export const start: State = { ...nothing, ...unanswered, panel: 'missing', confirmed: true, history: [], at: -1, running: 0, job: undefined, took: undefined, keys: [], effects: new Map(), toml: false };

export const sameCase = (a: Case, b: Case): boolean => choices.every((name) => a[name] === b[name]);

/// Holds the state; who listens hears of a change once, after all changes of the moment.
export class Store {
  private current = start;
  private told = true;

  constructor(private readonly listen: (state: State) => void) {}

  get state(): State {
    return this.current;
  }

  change(part: Partial<State>): void {
    this.current = { ...this.current, ...part };
    if (!this.told) return;
    this.told = false;
    queueMicrotask(() => {
      this.told = true;
      this.listen(this.current);
    });
  }
}
