// The one state of the page. Views read it, actions replace it, nothing else holds anything that matters.
import type { Job } from './asking';
import type { AddReport, CompareReport, DiagnoseReport, RecordReport, Said } from '../../../report/page/src/document';

/// Pages of the command: of readings one by one, or of a record over time.
export type Diagnosed = DiagnoseReport | (RecordReport & { command: 'diagnose' });
export type AddedTo = AddReport | (RecordReport & { command: 'add' });
export type Compared = CompareReport | (RecordReport & { command: 'compare' });

export interface TextFile {
  name: string;
  text: string;
}

/// What a step of the history brings back: all that a user has chosen.
export interface Case {
  example: boolean; // the rig that is built in
  data: TextFile[];
  map: string; // the table [columns]; empty where the columns have our names
  model: TextFile | undefined;
  designation: string; // that the model was made of, for the commands; empty of a file
  oil: string; // the same
  dropNan: boolean; // rows with an empty cell are left out
  rows: boolean; // rows of a logger stay apart
  channel: string; // of a model with several displacements the one in question
  law: string; // a base law instead of that of the model; empty: as it is
  on: string[]; // effects
  forced: boolean; // added though the command refuses
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
  refitted?: string; // text, nothing added
  model?: string; // text, refitted, with the effects
  report?: string; // the page of the command
}

export interface Line {
  label: string;
  rmse: number | undefined;
  held: number | undefined; // on rows left out of the fit
  unit: string;
  of: Case;
}

/// A data file as the engine reads it.
export interface Reading {
  said: Said[];
  rows: number;
  columns: { name: string; from: number | null; to: number | null; levels: number }[];
  noise: { rms: number | null; source: string; estimated_rms?: number };
  unit: string; // of the readings: "Nmm"
  numbers: Map<string, Float64Array>;
}

export interface Problem {
  at: 'data' | 'model' | 'missing';
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
  only: string | null; // "law palmgren", "of a spindle"
  meaning: string;
}

export interface EffectCard {
  id: string;
  title: string;
  mechanism: string;
  formula: string;
}

/// A base law in place of that of the model, all refitted.
export interface LawTried {
  law: string;
  rmse: number;
  held: number | null;
}

export type Panel = 'missing' | 'data' | 'model' | 'compare' | 'history' | 'home';

export interface State extends Case {
  panel: Panel;
  proposal: string; // what the engine proposes as [columns]
  confirmed: boolean; // the map was looked at, or needs no look
  reading: Reading | undefined;
  modelNotes: string[]; // what `new` said of the model
  problem: Problem | undefined;
  result: Result | undefined;
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

export const start: State = {
  example: true,
  data: [],
  map: '',
  model: undefined,
  designation: '',
  oil: '',
  dropNan: false,
  rows: false,
  channel: '',
  law: '',
  on: [],
  forced: false,
  panel: 'missing',
  proposal: '',
  confirmed: true,
  reading: undefined,
  modelNotes: [],
  problem: undefined,
  result: undefined,
  stale: false,
  laws: [],
  history: [],
  at: -1,
  running: 0,
  job: undefined,
  took: undefined,
  keys: [],
  effects: new Map(),
  toml: false,
};

export const caseOf = ({ example, data, map, model, designation, oil, dropNan, rows, channel, law, on, forced }: Case): Case => ({ example, data, map, model, designation, oil, dropNan, rows, channel, law, on, forced });

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
