// What a user does. Each action replaces the case and asks the engine anew; answers of an earlier case are dropped.
import { Asking, documentOf, Refused, refusal, reportOf } from './asking';
import { decoded, joined, numbersOf, preview, readMap, thinned, writeMap, type Mapped } from './columns';
import { Stopped, type Engine } from './engine';
import { examples } from './example';
import * as ask from './questions';
import { quantity } from './report';
import { askSpindle, isProgramme } from './spindle_asking';
import {
  caseOf,
  nothing,
  sameCase,
  unanswered,
  type AddedTo,
  type Case,
  type Compared,
  type Diagnosed,
  type EffectCard,
  type ExampleName,
  type Key,
  type LawTried,
  type Line,
  type Machine,
  type Offer,
  type Panel,
  type Problem,
  type Reading,
  type Result,
  type State,
  type Store,
  type TextFile,
  type Trust,
} from './state';
import { channelsOf, isCorrection, isSpindle, valueOf, withValue } from './toml';
import type { Added } from '../../../report/page/src/document';

export const baseLaws = ['palmgren', 'skf', 'contact'];
const neutral = '7014 C'; // whose model reads columns until the user has named a bearing

/// "lubricant-drag" as people say it.
export const inWords = (id: string): string => (id.startsWith('law:') ? `base law ${id.slice(4)}` : id.startsWith('input:') ? `input ${quantity(id.slice(6)).label}` : id.replace(/-/g, ' '));

/// Whether a case is a spindle without measurements.
export const alone = ({ model, data }: Case): boolean => data.length === 0 && model !== undefined && isSpindle(model.text);

/// RMS errors on the readings that judge: of the first model, and of the one that is taken.
export function judgedErrors({ compared }: Result): { before: number; now: number } | undefined {
  if (!compared) return undefined;
  const all = 'models' in compared.results ? compared.results.models : [compared.results];
  return { before: all[0]?.rmse ?? NaN, now: all[all.length - 1]?.rmse ?? NaN };
}

/// RMS over the ways to leave rows out.
export function heldOut(list: { rmse_before: number }[]): number | undefined {
  return list.length ? Math.sqrt(list.reduce((sum, h) => sum + h.rmse_before ** 2, 0) / list.length) : undefined;
}

/// Where in the page the words of a refusal belong. The engine knows model and programme by other names than the user.
function placeOf(error: unknown, { model, programme }: Case): Problem {
  const text = error instanceof Error ? error.message : String(error);
  if (!(error instanceof Refused)) return { at: 'missing', text };
  const file = error.file ?? '';
  const begins = (pattern: RegExp) => pattern.test(file) || pattern.test(text);
  const named = (name: string | undefined) => (name ? text.replace(/^(model\.toml|programme\.csv)/, () => name) : text);
  if (begins(/^(model|start|refitted|improved)\.toml\b/)) return { at: 'model', text: named(model?.name) };
  if (begins(/^programme\.csv\b/)) return { at: 'programme', text: named(programme?.name) };
  return { at: file ? 'data' : 'missing', text };
}

/// The next picture is on the screen; of a page that is hidden there is none.
const painted = (): Promise<void> =>
  new Promise((done) => {
    setTimeout(done, 200);
    requestAnimationFrame(() => setTimeout(done));
  });

export class Actions {
  private readonly asking: Asking;
  private generation = 0;
  private dragged: [string, string, string] | undefined;
  private dragging = false;

  constructor(
    private readonly store: Store,
    engine: Engine,
  ) {
    this.asking = new Asking(engine, (job, took) => this.store.change({ job, ...(took ? { took } : {}) }));
  }

  private get state(): State {
    return this.store.state;
  }

  /// Counts what is under way, so that the page can say when it rests.
  private async doing(work: () => Promise<void>): Promise<void> {
    this.store.change({ running: this.state.running + 1 });
    try {
      await work();
    } finally {
      this.store.change({ running: this.state.running - 1 });
    }
  }

  show(panel: Panel): void {
    this.store.change({ panel });
    if (alone(this.state)) void this.evaluate(); // what this step shows may not have been asked yet
  }

  stop(): void {
    this.asking.stop();
  }

  /// What is the same for all models.
  private async learn(): Promise<void> {
    const { document: keys } = await this.asking.document<{ keys: Key[] }>('Reading the table of keys', ask.keys);
    const { document: effects } = await this.asking.document<{ effects: EffectCard[] }>('Reading the catalogue of effects', ask.effects);
    this.store.change({ keys: keys.keys, effects: new Map(effects.effects.map((e) => [e.id, e])) });
  }

  /// A case in place of all that is shown, and of its history: an example, or what `raceway workbench` was given.
  open(of: Promise<Case>, label: string, recorded?: Promise<Diagnosed | undefined>): Promise<void> {
    return this.doing(async () => {
      const opened = await of;
      this.store.change({ ...opened, ...unanswered, history: [], at: -1, confirmed: true, panel: alone(opened) ? 'steady' : 'missing' });
      const known = recorded?.then((base) => {
        if (base && !this.state.result && caseOf(this.state).model === opened.model) this.store.change({ result: { on: [], entered: opened.model?.text ?? '', base, recorded: true }, stale: true });
      });
      await Promise.all([this.evaluate(label), known]);
      if (!this.state.keys.length) await this.learn();
    });
  }

  async openExample(name: ExampleName): Promise<void> {
    const { open, label } = examples[name];
    try {
      await this.open(open(), label);
    } catch (error) {
      this.store.change({ problem: placeOf(error, this.state) });
    }
  }

  /// Asks everything about the case; `label` makes a line of the history of it.
  evaluate(label?: string): Promise<void> {
    return this.doing(() => this.asked(label));
  }

  private async asked(label?: string): Promise<void> {
    const generation = ++this.generation;
    const of = caseOf(this.state);
    const { data, model } = of;
    const tell = (part: Partial<State>) => {
      if (generation === this.generation) this.store.change(part);
      else throw new Stopped();
    };
    try {
      tell({ problem: undefined, stale: true });
      if (model && alone(of)) return void (await this.askedOfSpindle(of, model.text, label, tell));
      if (!data.length) return;
      tell({ machine: undefined });
      const reader = model?.text ?? (await this.neutralModel());
      // A case that is built in needs no look at its columns before its verdict.
      if (!of.example || !model) await this.read(of, reader, tell);
      if (!model || !this.state.confirmed) return;
      let entered = model.text;
      let refused: string | undefined;
      if (of.law && of.law !== (valueOf(entered, 'friction', 'law') ?? 'palmgren')) {
        const taken = await this.asking.ask(`Fitting the law ${of.law}`, ask.add(of, entered, [`law:${of.law}`]));
        const { refused: no, reason } = documentOf<Added>(taken);
        if (no && !of.forced) refused = `law ${of.law}: ${reason}`;
        else entered = taken.files['improved.toml'] ?? entered;
      }
      const diagnosed = await this.asking.ask('Diagnosing', ask.diagnose(of, entered));
      documentOf(diagnosed);
      const page = diagnosed.files['report.html'] as string;
      let result: Result = { on: of.on, entered, base: reportOf<Diagnosed>(page), report: page, ...(refused ? { refused } : {}) };
      const known = (more: Partial<Result>) => {
        result = { ...result, ...more };
        tell({ result, stale: false });
      };
      if (of.start) {
        const before = await this.asking.ask('Diagnosing', ask.diagnose(of, of.start.text));
        result.before = documentOf<{ rmse_before: number }>(before).rmse_before;
      }
      if (of.on.length === 0) known({});
      let refitted: string | undefined;
      const calibrate = async () => {
        try {
          const answer = await this.asking.ask('Refitting', ask.calibrate(of, entered));
          documentOf(answer);
          refitted = answer.files['refitted.toml'];
        } catch (error) {
          if (!(error instanceof Refused)) throw error;
        }
      };
      if (of.on.length) {
        const added = await this.asking.ask(`Adding ${of.on.map(inWords).join(' and ')}`, ask.add(of, entered, of.on));
        const said = documentOf<Added>(added);
        const report = added.files['report.html'];
        const model = added.files['improved.toml'];
        known({ ...(report ? { added: reportOf<AddedTo>(report), report } : {}), ...(said.refused && !of.forced ? { refused: said.reason } : {}), ...(model ? { model } : {}) });
        this.record(label, of, result);
        if (model) {
          const rest = await this.asking.ask('Diagnosing the remaining misfit', ask.diagnose(of, model));
          documentOf(rest);
          known({ rest: reportOf<Diagnosed>(rest.files['report.html'] as string) });
        }
        await calibrate();
      } else {
        this.record(label, of, result);
        if (of.example) await this.read(of, reader, tell);
        // Lags that were just found stay as they are: their trust is of hours ahead, that of a refit of parts between others.
        if (!of.start) await calibrate();
        known({ model: refitted ?? entered });
      }
      if (refitted) known({ refitted });
      known(await this.compare(of, result, entered));
      if (label !== undefined) this.judged(result);
      if (isCorrection(entered)) known({ trust: await this.trustOf(of, result.model ?? entered) });
      await this.tryLaws(of, model.text, tell);
      if (of.example && !this.state.reading) await this.read(of, reader, tell);
    } catch (error) {
      if (generation !== this.generation) return;
      const { panel } = this.state;
      const here: Panel = alone(of) && (panel === 'programme' || panel === 'modes') ? panel : alone(of) ? 'steady' : 'missing';
      const problem = error instanceof Stopped ? { at: here, text: 'Stopped. Results may be incomplete. Change something, or calculate again.' } : placeOf(error, of);
      this.store.change({ problem: problem.at === 'missing' ? { ...problem, at: here } : problem });
    }
  }

  /// Steady state, and what the step that is shown needs.
  private async askedOfSpindle(of: Case, model: string, label: string | undefined, tell: (part: Partial<State>) => void): Promise<void> {
    const { machine: before, panel } = this.state;
    // Answers of the case before stand until those of this one are there.
    let machine: Machine = before && sameCase(before.of, of) ? before : { of };
    await askSpindle(this.asking, machine, model, panel, (part) => {
      machine = { ...machine, ...part };
      if (part.steady && label !== undefined) this.recordSpindle(label, machine);
      tell({ machine, result: undefined });
    });
    tell({ stale: false });
  }

  private recordSpindle(label: string, { of, steady }: Machine): void {
    const { history, at } = this.state;
    const rows = steady?.report.rows.columns ?? [];
    const last = (name: string) => {
      const column = rows.find((c) => c.name === name);
      return column?.values?.[column.values.length - 1] ?? column?.constant ?? undefined;
    };
    const line: Line = { label, rmse: last('axial_displacement_um'), held: last('front_force_N'), unit: 'um', spindle: true, of };
    this.store.change({ history: [...history.slice(0, at + 1), line], at: at + 1 });
  }

  /// Before its lags were found, as entered, refitted, with the effects.
  private async compare(of: Case, { refitted, model }: Result, entered: string): Promise<{ compared: Compared; names: string[] }> {
    const models: [string, string | undefined, string][] = [
      ['start.toml', of.start?.text, 'before the lags were found'],
      ['model.toml', entered, of.start ? 'with the lags found' : 'as entered'],
      ['refitted.toml', refitted, 'refitted'],
      ['improved.toml', of.on.length ? model : undefined, `with ${of.on.map(inWords).join(' and ')}`],
    ];
    const known = models.filter((m): m is [string, string, string] => m[1] !== undefined);
    const answer = await this.asking.ask(
      'Comparing',
      ask.compare(
        of,
        known.map(([name, text]) => [name, text]),
      ),
    );
    documentOf(answer);
    return { compared: reportOf<Compared>(answer.files['report.html'] as string), names: known.map(([, , words]) => words) };
  }

  /// How far a correction may be trusted: its own displacement where it has several.
  private async trustOf(of: Case, model: string): Promise<Trust> {
    type Axis = { displacement: string; trust: Trust };
    const { document } = await this.asking.document<Axis & { axes?: Axis[] }>('Checking the trust in the correction', ask.correct(of, model));
    return (document.axes?.find((a) => a.displacement === of.channel) ?? document.axes?.[0] ?? document).trust;
  }

  private async tryLaws(of: Case, model: string, tell: (part: Partial<State>) => void): Promise<void> {
    const laws: LawTried[] = [];
    tell({ laws });
    if (valueOf(model, 'bearing', 'type') !== undefined || !/^\s*\[bearing\]/m.test(model)) return; // of balls on a rig alone
    for (const law of baseLaws) {
      if (law === (valueOf(model, 'friction', 'law') ?? 'palmgren')) continue;
      try {
        const answer = await this.asking.ask(`Trying the law ${law}`, ask.tryLaw(of, model, law));
        const tried = documentOf<Added>(answer);
        laws.push({ law, rmse: tried.after.rmse, held: tried.rmse_held_out_after });
        tell({ laws: [...laws] });
      } catch (error) {
        if (!(error instanceof Refused)) throw error; // a law that this bearing has not
      }
    }
  }

  /// The line of the history gets the error on the readings that judge.
  private judged(result: Result): void {
    const { history, at, until } = this.state;
    const held = until ? judgedErrors(result)?.now : undefined;
    if (held !== undefined) this.store.change({ history: history.map((line, k) => (k === at ? { ...line, held } : line)) });
  }

  private record(label: string | undefined, of: Case, { base, added }: Result): void {
    if (label === undefined) return;
    const { history, at } = this.state;
    const d = base.results;
    const line: Line = added
      ? { label, rmse: added.results.after.rmse, held: added.results.rmse_held_out_after ?? undefined, unit: d.baseline.unit, of }
      : { label, rmse: d.rmse_before, held: heldOut(d.hold_out), unit: d.baseline.unit, of };
    this.store.change({ history: [...history.slice(0, at + 1), line], at: at + 1 });
  }

  private async neutralModel(): Promise<string> {
    const answer = await this.asking.ask('Reading', ask.newModel(neutral));
    return answer.files['model.toml'] as string;
  }

  private async read(of: Case, model: string, tell: (part: Partial<State>) => void): Promise<void> {
    const [first] = of.data as [TextFile];
    // Of a large file as many rows are proposed from and drawn as can be seen; all of them are checked.
    if (!this.state.proposal) {
      const proposed = await this.asking.ask('Reading the columns', ask.suggest(model, { ...first, text: thinned(first.text) }));
      if (proposed.status === 0) tell({ proposal: proposed.out });
    }
    const readings: Reading[] = [];
    for (const file of of.data) {
      const few = { ...file, text: thinned(file.text) };
      const whole = few.text === file.text;
      const answer = await this.asking.ask(`Reading ${of.data.length > 1 ? file.name : 'the data'}`, ask.check({ ...of, data: [file] }, model, whole));
      const document = documentOf<Omit<Reading, 'numbers'>>(answer);
      const drawn = whole ? answer : await this.asking.ask('Drawing the columns', ask.check({ ...of, data: [few] }, model, true));
      readings.push({ ...document, numbers: numbersOf(drawn.files['rows.csv'] ?? '') });
    }
    tell({ reading: joined(readings) });
  }

  // ---- data and columns

  drop(files: Promise<{ name: string; bytes: ArrayBuffer }[]>): Promise<void> {
    return this.doing(async () => this.takeFiles(await files));
  }

  private async takeFiles(files: { name: string; bytes: ArrayBuffer }[]): Promise<void> {
    const texts = files.map(({ name, bytes }): TextFile => ({ name, text: decoded(bytes) }));
    const isMap = (t: TextFile) => /^\s*\[columns\]/m.test(t.text) && !/^\s*\[(bearing|arrangement|correction)/m.test(t.text);
    const tomls = texts.filter((t) => /\.toml$/i.test(t.name));
    const data = texts.filter((t) => !tomls.includes(t));
    const map = tomls.find(isMap);
    const model = tomls.find((t) => !isMap(t));
    const spindle = model ? isSpindle(model.text) : alone(this.state);
    const [programme] = data.filter((d) => spindle && isProgramme(preview(d.text, ['time_s'], 1).header));
    // A record that is there already is one of this spindle.
    const names = this.state.reading?.columns.map((c) => c.name) ?? [];
    const measured = !this.state.example && names.includes('time_s') && !names.some((name) => name.startsWith('friction_torque'));
    if (spindle && (programme ? data.length === 1 : !data.length && !measured)) return this.takeSpindle(model, programme);
    const part: Partial<State> = { law: '', on: [], forced: false, start: undefined, fromRecord: false, until: '', machine: undefined };
    if (data.length)
      Object.assign(part, {
        data,
        map: '',
        proposal: '',
        dropNan: false,
        rows: false,
        reading: undefined,
        result: undefined,
        panel: 'data',
        example: '',
        confirmed: true,
        programme: undefined,
        ...(this.state.example || alone(this.state) ? { model: undefined, designation: '', oil: '', channel: '' } : {}),
      });
    if (model) Object.assign(part, { model, designation: '', oil: '', channel: channelsOf(model.text)[0] ?? '', modelNotes: [], ...(data.length ? {} : { panel: 'model' }) });
    if (map) Object.assign(part, { map: map.text, proposal: map.text });
    this.store.change(part);
    if (data.length && !map) await this.propose();
    if (data.length && !readMap(this.state.proposal).mapped.some((m) => /torque|displacement/.test(m.ours))) await this.fromRecord();
    await this.evaluate(data.length ? data.map((d) => d.name).join(', ') : (model ?? map)?.name);
  }

  /// A spindle without measurements, a programme of speeds for it, or both.
  private async takeSpindle(model: TextFile | undefined, programme: TextFile | undefined): Promise<void> {
    const change: Partial<State> = model ? { ...nothing, ...unanswered, model, confirmed: true } : {};
    this.store.change({ ...change, ...(programme ? { programme } : {}), panel: programme ? 'programme' : 'steady' });
    await this.evaluate((model ?? programme)?.name);
  }

  /// Asks which column is which. Columns that have our names, or those of the model, need no map.
  private async propose(): Promise<void> {
    const { data, model } = this.state;
    try {
      const reader = model?.text ?? (await this.neutralModel());
      const first = data[0] as TextFile;
      const few = thinned(first.text);
      let answer = await this.asking.ask('Reading the columns', ask.suggest(reader, { ...first, text: few }));
      // What is wrong in a line is said of the line in the file.
      if (answer.status !== 0 && few !== first.text) answer = await this.asking.ask('Reading the columns', ask.suggest(reader, first));
      if (answer.status !== 0) throw new Refused(refusal(answer), ask.dataFiles(data)[0]?.name ?? null, null);
      const { mapped } = readMap(answer.out);
      const named = mapped.length > 0 && mapped.every((m) => m.column === m.ours);
      const ours = named || (await this.asking.ask('Reading the data', ask.check(caseOf(this.state), reader, few === first.text))).status === 0;
      this.store.change({ proposal: answer.out, map: ours ? '' : answer.out, confirmed: ours });
    } catch (error) {
      if (!(error instanceof Stopped)) this.store.change({ problem: placeOf(error, this.state), confirmed: true });
    }
  }

  /// Another column, unit or number for one of our quantities.
  async mapColumn(ours: string, change: Partial<Mapped>): Promise<void> {
    const { mapped } = readMap(this.state.map || this.state.proposal);
    const at = mapped.findIndex((m) => m.ours === ours);
    const line: Mapped = { ours, column: '', unit: '', number: '', ...mapped[at], ...(change.column === undefined ? {} : { unit: '' }), ...change };
    const next = at < 0 ? [...mapped, line] : mapped.map((m, k) => (k === at ? line : m));
    this.store.change({ map: writeMap(next), reading: undefined });
    await this.evaluate(this.state.confirmed && this.state.model ? `column ${ours}` : undefined);
  }

  /// How rows are read: those with an empty cell left out, those of a logger kept apart.
  async readAs(part: Partial<Pick<Case, 'dropNan' | 'rows'>>): Promise<void> {
    this.store.change({ ...part, reading: undefined });
    await this.evaluate(this.state.model && this.state.confirmed ? (part.rows === undefined ? 'rows with empty cells' : 'rows of the logger') : undefined);
  }

  async confirmColumns(): Promise<void> {
    this.store.change({ confirmed: true, panel: this.state.model ? 'missing' : 'model' });
    await this.evaluate(this.state.model ? 'columns' : undefined);
  }

  /// What a record over time tells of itself: a correction of its displacements, with the channels that may drive it.
  private async fromRecord(): Promise<void> {
    const of = caseOf(this.state);
    if (of.model || !of.data.length) return;
    // By the names of the file; by the map that was proposed where these do not say it.
    const tried = { ...of, map: '' };
    const own = (await this.asking.ask('Searching for displacements over time', ask.newRecord(tried))).files['model.toml'];
    const text = own ?? (of.map ? (await this.asking.ask('Searching for displacements over time', ask.newRecord(of))).files['model.toml'] : undefined);
    if (!text) return;
    this.store.change({
      model: { name: 'model.toml', text },
      fromRecord: true,
      channel: channelsOf(text)[0] ?? '',
      ...(own ? { proposal: '', map: '', confirmed: true } : {}),
      problem: undefined,
      modelNotes: ['The page made this model from the record. Check its channels, then find their lags.'],
    });
  }

  /// Lags and gains from the record, in place of those of the model.
  identify(bank: boolean): Promise<void> {
    return this.doing(async () => {
      const of = caseOf(this.state);
      if (!of.model) return;
      try {
        const answer = await this.asking.ask('Finding the lags', ask.identify(of, (of.start ?? of.model).text, bank));
        documentOf(answer);
        const text = answer.files['found.toml'];
        if (!text) return;
        this.store.change({ model: { name: of.model.name, text }, start: of.start ?? of.model, bank, on: [], law: '', forced: false, modelNotes: [], panel: 'missing' });
        await this.evaluate(bank ? 'lags of all sensors' : 'lags of the channels');
      } catch (error) {
        this.store.change({ problem: error instanceof Stopped ? { at: 'model', text: 'Stopped.' } : { ...placeOf(error, of), at: 'model' } });
      }
    });
  }

  async takeChannel(channel: string): Promise<void> {
    this.store.change({ channel, on: [], result: undefined });
    await this.evaluate(channel);
  }

  /// The text that `export` writes of a correction.
  async exported(model: string, format: string, untrusted: boolean): Promise<string> {
    const answer = await this.asking.ask(`Writing ${format}`, ask.exported(model, format, untrusted));
    if (answer.status !== 0) throw new Refused(refusal(answer), null, null);
    return answer.out;
  }

  // ---- model

  /// A model of a designation, with an oil; what is not known is estimated by the command and marked.
  designate(designation: string, oil: string, preload: string, spindle = false): Promise<void> {
    return this.doing(() => this.makeModel(designation, oil, preload, spindle));
  }

  private async makeModel(designation: string, oil: string, preload: string, spindle: boolean): Promise<void> {
    try {
      const answer = await this.asking.ask('Writing the model', ask.newModel(designation, spindle, oil.trim()));
      const text = answer.files['model.toml'];
      if (!text) throw new Refused(refusal(answer), 'model.toml', null);
      let model = text;
      if (preload.trim()) model = withValue(model, spindle ? 'arrangement' : 'rig', spindle ? 'preload_N' : 'axial_load_N', preload.trim().replace(',', '.'));
      const notes = answer.err
        .split('\n')
        .filter((line) => line.startsWith('note: '))
        .map((line) => line.slice(6));
      if (spindle) this.store.change({ ...nothing, ...unanswered, speed: this.state.speed, programme: this.state.programme, confirmed: true, panel: 'model' });
      const ready = this.state.data.length > 0 && this.state.confirmed;
      this.store.change({
        start: undefined,
        fromRecord: false,
        model: { name: 'model.toml', text: model },
        designation,
        oil: oil.trim(),
        channel: '',
        modelNotes: notes,
        law: '',
        on: [],
        forced: false,
        ...(ready ? { panel: 'missing' } : {}),
      });
      await this.evaluate(`${designation}${oil.trim() ? `, ${oil.trim()}` : ''}`);
    } catch (error) {
      this.store.change({ problem: { at: 'model', text: error instanceof Error ? error.message : String(error) } });
    }
  }

  /// Bearings of the catalogue for what is typed; none where the engine knows none, or was stopped.
  async offers(typed: string): Promise<Offer> {
    try {
      const { document, answer } = await this.asking.document<Pick<Offer, 'bearings'>>('Looking in the catalogue', ask.bearings(typed));
      return { bearings: document.bearings, sameSize: answer.err.includes('note: ') };
    } catch (error) {
      if (error instanceof Refused || error instanceof Stopped) return { bearings: [], sameSize: false };
      throw error;
    }
  }

  async editModel(text: string, label: string): Promise<void> {
    const { model } = this.state;
    if (model?.text === text) return;
    this.store.change({ model: { name: model?.name ?? 'model.toml', text } });
    await this.evaluate(label);
  }

  /// Up to when a record is fitted to. Lags that were found in another part of it would be judged by readings that they know.
  async cut(until: string): Promise<void> {
    const { start } = this.state;
    this.store.change({ until, ...(start ? { model: start, start: undefined, on: [] } : {}) });
    await this.evaluate(until ? `fitted until ${until}` : 'fitted to all readings');
  }

  /// How a spindle runs.
  async choose(part: Partial<Pick<Case, 'speed' | 'coolantOff' | 'axialLoad' | 'radialLoad' | 'programme' | 'modeSpeeds'>>, label: string): Promise<void> {
    this.store.change(part);
    await this.evaluate(label);
  }

  // ---- candidates

  async toggle(id: string): Promise<void> {
    const { on } = this.state;
    const off = on.includes(id);
    await this.turn({ on: off ? on.filter((e) => e !== id) : [...on, id] }, `${off ? '−' : '+'} ${inWords(id)}`);
  }

  /// The bar moves before anything else is asked or drawn: answers that are known make many pictures at once.
  private turn(part: Partial<Case>, label: string): Promise<void> {
    this.store.change({ ...part, forced: false });
    return this.doing(async () => {
      await painted();
      await this.asked(label);
    });
  }

  /// All of an explanation at once; a base law of it is taken, not added.
  async turnOn(ids: string[]): Promise<void> {
    const law = ids.find((id) => id.startsWith('law:'));
    const effects = ids.filter((id) => !id.startsWith('law:') && !this.state.on.includes(id));
    await this.turn({ on: [...this.state.on, ...effects], ...(law ? { law: law.slice(4) } : {}) }, `+ ${ids.map(inWords).join(' and ')}`);
  }

  /// A number of the model while it is dragged: of many in a row the last is compared, nothing is refitted.
  async drag(table: string, key: string, value: string): Promise<void> {
    this.dragged = [table, key, value];
    if (!this.dragging) await this.doing(() => this.follow());
  }

  private async follow(): Promise<void> {
    this.dragging = true;
    try {
      while (this.dragged) {
        const [inTable, name, now] = this.dragged;
        this.dragged = undefined;
        const { result } = this.state;
        if (!result) break;
        const compared = await this.compare(caseOf(this.state), result, withValue(result.entered, inTable, name, now));
        if (this.state.result) this.store.change({ result: { ...this.state.result, ...compared } });
      }
    } catch (error) {
      if (!(error instanceof Stopped)) this.store.change({ problem: placeOf(error, this.state) });
    } finally {
      this.dragging = false;
    }
  }

  /// Where it was let go: a step like any other.
  async dragEnd(table: string, key: string, value: string): Promise<void> {
    const { model } = this.state;
    if (model) await this.editModel(withValue(model.text, table, key, value), `${key} = ${value}`);
  }

  async takeLaw(law: string): Promise<void> {
    const own = valueOf(this.state.model?.text ?? '', 'friction', 'law') ?? 'palmgren';
    this.store.change({ law: law === own ? '' : law, forced: false });
    await this.evaluate(`base law ${law}`);
  }

  async force(): Promise<void> {
    this.store.change({ forced: true });
    await this.evaluate('added although refused');
  }

  // ---- history

  async back(at: number): Promise<void> {
    const line = this.state.history[at];
    if (!line) return;
    const { panel } = this.state;
    const there = panel === 'history' || panel === 'home' || panel === 'model' || alone(line.of) === alone(this.state);
    this.store.change({ ...line.of, at, confirmed: true, ...(there ? {} : { panel: alone(line.of) ? 'steady' : 'missing' }), ...(line.of.data === this.state.data ? {} : { proposal: '', reading: undefined }) });
    await this.evaluate();
  }
}
