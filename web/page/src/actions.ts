// What a user does. Each action replaces the case and asks the engine anew; answers of an earlier case are dropped.
import { Asking, documentOf, Refused, refusal, reportOf } from './asking';
import { decoded, numbersOf, readMap, writeMap, type Mapped } from './columns';
import { Stopped, type Engine } from './engine';
import { viscosities } from './oil';
import * as ask from './questions';
import { quantity } from './report';
import { caseOf, type AddedTo, type Case, type Compared, type Diagnosed, type EffectCard, type Key, type LawTried, type Line, type Problem, type Reading, type Result, type State, type Store, type TextFile } from './state';
import { channelsOf, valueOf, withoutAssumption, withValue } from './toml';
import type { Added } from '../../../report/page/src/document';

export const baseLaws = ['palmgren', 'skf', 'contact'];
const neutral = '7014 C'; // whose model reads columns until the user has named a bearing

/// "lubricant-drag" as people say it.
export const inWords = (id: string): string => (id.startsWith('law:') ? `base law ${id.slice(4)}` : id.startsWith('input:') ? `input ${quantity(id.slice(6)).label}` : id.replace(/-/g, ' '));

/// RMS over the ways to leave rows out.
export function heldOut(list: { rmse_before: number }[]): number | undefined {
  return list.length ? Math.sqrt(list.reduce((sum, h) => sum + h.rmse_before ** 2, 0) / list.length) : undefined;
}

/// Where in the page the words of a refusal belong.
function placeOf(error: unknown): Problem {
  const text = error instanceof Error ? error.message : String(error);
  if (!(error instanceof Refused)) return { at: 'missing', text };
  const file = error.file ?? '';
  if (/^(model|refitted|improved)\.toml$/.test(file) || /^(model|refitted|improved)\.toml\b/.test(text)) return { at: 'model', text };
  return { at: file ? 'data' : 'missing', text };
}

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

  show(panel: State['panel']): void {
    this.store.change({ panel });
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

  /// A case of its own, with its line in the history: the example, or what `raceway workbench` was given.
  async open(of: Partial<Case>, label: string): Promise<void> {
    this.store.change({ ...of, confirmed: true });
    await this.doing(async () => {
      await this.evaluate(label);
      await this.learn();
    });
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
      if (!data.length) return;
      const reader = model?.text ?? (await this.neutralModel());
      await this.read(of, reader, tell);
      if (!model || !this.state.confirmed) return;
      let entered = model.text;
      let refused: string | undefined;
      if (of.law && of.law !== (valueOf(entered, 'friction', 'law') ?? 'palmgren')) {
        const taken = await this.asking.ask(`Taking the law ${of.law}`, ask.add(of, entered, [`law:${of.law}`]));
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
          const rest = await this.asking.ask('Diagnosing what remains', ask.diagnose(of, model));
          documentOf(rest);
          known({ rest: reportOf<Diagnosed>(rest.files['report.html'] as string) });
        }
        await calibrate();
      } else {
        this.record(label, of, result);
        await calibrate();
        known({ ...(refitted ? { model: refitted } : {}) });
      }
      if (refitted) known({ refitted });
      known({ compared: await this.compare(of, result, entered) });
      await this.tryLaws(of, model.text, tell);
    } catch (error) {
      if (generation !== this.generation) return;
      if (error instanceof Stopped) this.store.change({ problem: { at: 'missing', text: 'Stopped. Results may be incomplete: change something, or ask again.' } });
      else this.store.change({ problem: placeOf(error) });
    }
  }

  /// As entered, refitted, with the effects.
  private async compare(of: Case, { refitted, model }: Result, entered: string): Promise<Compared> {
    const models: [string, string | undefined][] = [
      ['model.toml', entered],
      ['refitted.toml', refitted],
      ['improved.toml', of.on.length ? model : undefined],
    ];
    const answer = await this.asking.ask(
      'Comparing',
      ask.compare(
        of,
        models.filter((m): m is [string, string] => m[1] !== undefined),
      ),
    );
    documentOf(answer);
    return reportOf<Compared>(answer.files['report.html'] as string);
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
    const answer = await this.asking.ask('Reading', ask.newModel(neutral, 'palmgren'));
    return answer.files['model.toml'] as string;
  }

  private async read(of: Case, model: string, tell: (part: Partial<State>) => void): Promise<void> {
    if (!this.state.proposal) {
      const proposed = await this.asking.ask('Looking at the columns', ask.suggest(model, of.data[0] as TextFile));
      if (proposed.status === 0) tell({ proposal: proposed.out });
    }
    const answer = await this.asking.ask('Reading the data', ask.check(of, model));
    const document = documentOf<Omit<Reading, 'numbers'>>(answer);
    tell({ reading: { ...document, numbers: numbersOf(answer.files['rows.csv'] ?? '') } });
  }

  // ---- data and columns

  drop(files: Promise<{ name: string; bytes: ArrayBuffer }[]>): Promise<void> {
    return this.doing(async () => this.take(await files));
  }

  private async take(files: { name: string; bytes: ArrayBuffer }[]): Promise<void> {
    const texts = files.map(({ name, bytes }): TextFile => ({ name, text: decoded(bytes) }));
    const isMap = (t: TextFile) => /^\s*\[columns\]/m.test(t.text) && !/^\s*\[(bearing|arrangement|correction)/m.test(t.text);
    const tomls = texts.filter((t) => /\.toml$/i.test(t.name));
    const data = texts.filter((t) => !tomls.includes(t));
    const map = tomls.find(isMap);
    const model = tomls.find((t) => !isMap(t));
    const part: Partial<State> = { law: '', on: [], forced: false };
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
        example: false,
        confirmed: true,
        ...(this.state.example ? { model: undefined, designation: '', oil: '', channel: '' } : {}),
      });
    if (model) Object.assign(part, { model, designation: '', oil: '', channel: channelsOf(model.text)[0] ?? '', modelNotes: [], ...(data.length ? {} : { panel: 'model' }) });
    if (map) Object.assign(part, { map: map.text, proposal: map.text });
    this.store.change(part);
    if (data.length && !map) await this.propose();
    if (data.length && !readMap(this.state.proposal).mapped.some((m) => /torque|displacement/.test(m.ours))) await this.fromRecord();
    await this.evaluate(data.length ? data.map((d) => d.name).join(', ') : (model ?? map)?.name);
  }

  /// Asks which column is which. Columns that have our names, or those of the model, need no map.
  private async propose(): Promise<void> {
    const { data, model } = this.state;
    try {
      const reader = model?.text ?? (await this.neutralModel());
      const answer = await this.asking.ask('Looking at the columns', ask.suggest(reader, data[0] as TextFile));
      if (answer.status !== 0) throw new Refused(refusal(answer), ask.dataFiles(data)[0]?.name ?? null, null);
      const { mapped } = readMap(answer.out);
      const named = mapped.length > 0 && mapped.every((m) => m.column === m.ours);
      const ours = named || (await this.asking.ask('Reading the data', ask.check(caseOf(this.state), reader))).status === 0;
      this.store.change({ proposal: answer.out, map: ours ? '' : answer.out, confirmed: ours });
    } catch (error) {
      if (!(error instanceof Stopped)) this.store.change({ problem: placeOf(error), confirmed: true });
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
    const own = (await this.asking.ask('Looking for displacements over time', ask.newRecord(tried))).files['model.toml'];
    const text = own ?? (of.map ? (await this.asking.ask('Looking for displacements over time', ask.newRecord(of))).files['model.toml'] : undefined);
    if (!text) return;
    this.store.change({
      model: { name: 'model.toml', text },
      channel: channelsOf(text)[0] ?? '',
      ...(own ? { proposal: '', map: '', confirmed: true } : {}),
      problem: undefined,
      modelNotes: ['Made from the record: look through its channels, and find their lags.'],
    });
  }

  /// Lags and gains from the record, in place of those of the model.
  identify(bank: boolean): Promise<void> {
    return this.doing(async () => {
      const of = caseOf(this.state);
      if (!of.model) return;
      try {
        const answer = await this.asking.ask('Finding the lags', ask.identify(of, of.model.text, bank));
        documentOf(answer);
        const text = answer.files['found.toml'];
        if (text) await this.editModel(text, bank ? 'lags found, a bank of them' : 'lags found');
      } catch (error) {
        this.store.change({ problem: error instanceof Stopped ? { at: 'model', text: 'Stopped.' } : { ...placeOf(error), at: 'model' } });
      }
    });
  }

  async takeChannel(channel: string): Promise<void> {
    this.store.change({ channel, on: [], result: undefined });
    await this.evaluate(channel);
  }

  /// The text that `export` writes of a correction.
  async exported(model: string, format: string): Promise<string> {
    const answer = await this.asking.ask(`Writing ${format}`, ask.exported(model, format));
    if (answer.status !== 0) throw new Refused(refusal(answer), null, null);
    return answer.out;
  }

  // ---- model

  /// A model of a designation, with an oil; what is not known is estimated by the command and marked.
  designate(designation: string, oil: string, preload: string): Promise<void> {
    return this.doing(() => this.makeModel(designation, oil, preload));
  }

  private async makeModel(designation: string, oil: string, preload: string): Promise<void> {
    try {
      const answer = await this.asking.ask('Writing the model', ask.newModel(designation, 'palmgren'));
      const text = answer.files['model.toml'];
      if (!text) throw new Refused(refusal(answer), 'model.toml', null);
      let model = text;
      if (oil.trim()) {
        const [at40, at100] = viscosities(oil) ?? [];
        if (at40 === undefined || at100 === undefined) throw new Refused(`Oil "${oil}": not an ISO VG grade from 5 to 220. Leave it empty and enter the viscosities below.`, 'model.toml', null);
        model = withoutAssumption(model, 'lubricant');
        model = withValue(model, 'lubricant', 'viscosity_40C_mm2_s', String(at40), `ISO VG ${at40}`);
        model = withValue(model, 'lubricant', 'viscosity_100C_mm2_s', String(at100), 'assumed: mineral oil of viscosity index 100');
      }
      if (preload.trim()) model = withValue(model, 'rig', 'axial_load_N', preload.trim().replace(',', '.'));
      const notes = answer.err
        .split('\n')
        .filter((line) => line.startsWith('note: '))
        .map((line) => line.slice(6));
      const ready = this.state.data.length > 0 && this.state.confirmed;
      this.store.change({ model: { name: 'model.toml', text: model }, designation, oil: oil.trim(), channel: '', modelNotes: notes, law: '', on: [], forced: false, ...(ready ? { panel: 'missing' } : {}) });
      await this.evaluate(`${designation}${oil.trim() ? `, ${oil.trim()}` : ''}`);
    } catch (error) {
      this.store.change({ problem: { at: 'model', text: error instanceof Error ? error.message : String(error) } });
    }
  }

  async editModel(text: string, label: string): Promise<void> {
    const { model } = this.state;
    if (model?.text === text) return;
    this.store.change({ model: { name: model?.name ?? 'model.toml', text } });
    await this.evaluate(label);
  }

  // ---- candidates

  async toggle(id: string): Promise<void> {
    const { on } = this.state;
    const off = on.includes(id);
    this.store.change({ on: off ? on.filter((e) => e !== id) : [...on, id], forced: false });
    await this.evaluate(`${off ? '−' : '+'} ${inWords(id)}`);
  }

  /// All of an explanation at once; a base law of it is taken, not added.
  async turnOn(ids: string[]): Promise<void> {
    const law = ids.find((id) => id.startsWith('law:'));
    const effects = ids.filter((id) => !id.startsWith('law:') && !this.state.on.includes(id));
    this.store.change({ on: [...this.state.on, ...effects], forced: false, ...(law ? { law: law.slice(4) } : {}) });
    await this.evaluate(`+ ${ids.map(inWords).join(' and ')}`);
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
        if (this.state.result) this.store.change({ result: { ...this.state.result, compared } });
      }
    } catch (error) {
      if (!(error instanceof Stopped)) this.store.change({ problem: placeOf(error) });
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
    this.store.change({ ...line.of, at, confirmed: true });
    await this.evaluate();
  }
}
