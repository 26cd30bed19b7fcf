// A record over time with the corrections that are drawn over it, and what the reader has chosen.
import type { ModelOverTime, RecordReport } from './document';
import type { Figure } from './figure';
import { choice } from './figure';
import { capital, el, number, plain, quantity, signed, unitOfKey } from './text';
import type { Share } from './time_panels';
import { TimeView } from './time_view';

interface Stretch {
  label: string;
  span: [number, number];
}

const mostShares = 6; // that stay readable on top of each other

export class RecordView extends TimeView {
  readonly spans: Stretch[];
  private readonly figures: Figure[] = [];

  constructor(
    readonly report: RecordReport,
    public model: number,
  ) {
    super(report.rows);
    this.spans = this.findSpans();
  }

  get chosen(): ModelOverTime {
    return this.report.models[this.model] as ModelOverTime;
  }
  /// Units of a reading and of an error of the chosen model: °C, K.
  get unit(): string {
    return unitOfKey(this.chosen.unit);
  }
  get errorUnit(): string {
    return this.chosen.unit === 'C' ? 'K' : this.unit;
  }
  predicted(of = this.chosen): Float64Array {
    return this.rows.get(of.predicted);
  }
  /// NaN where nothing was read.
  measured(of = this.chosen): Float64Array {
    return of.measured ? this.rows.get(of.measured) : new Float64Array(this.rows.count).fill(NaN);
  }
  residual(of = this.chosen): Float64Array {
    const measured = this.measured(of);
    return this.predicted(of).map((p, k) => p - (measured[k] as number));
  }
  hasReadings(of = this.chosen): boolean {
    return of.measured !== undefined && this.measured(of).some(Number.isFinite);
  }

  /// Models of the displacement of the chosen one.
  together(): ModelOverTime[] {
    return this.report.models.filter((m) => m.displacement === this.chosen.displacement);
  }

  /// What is said of a prediction where several may stand beside each other.
  label(of: ModelOverTime): string {
    return this.together().length > 1 ? of.name : 'predicted';
  }

  /// A note with the model that it is about, where there are several.
  about(text: string): string {
    return this.report.models.length > 1 ? `“${this.chosen.name}”: ${text}` : capital(text);
  }

  /// The largest shares of the chosen model, and the rest as one; what is constant in none.
  shares(): Share[] {
    const size = (v: Float64Array) => v.reduce((sum, x) => sum + (Number.isFinite(x) ? x * x : 0), 0);
    const all = (this.chosen.parts ?? []).map((p) => ({ name: p.name, values: this.rows.get(p.column) })).sort((a, b) => size(b.values) - size(a.values));
    if (all.length <= mostShares + 1) return all;
    const rest = new Float64Array(this.rows.count);
    for (const { values } of all.slice(mostShares)) values.forEach((v, k) => (rest[k] = (rest[k] as number) + v));
    return [...all.slice(0, mostShares), { name: `${all.length - mostShares} others`, values: rest }];
  }

  /// Columns that drive the chosen model, those of its largest shares first.
  drivers(): string[] {
    const order = this.shares().map((s) => s.name);
    const place = (name: string) => (order.includes(name) ? order.indexOf(name) : order.length);
    const parts = (this.chosen.parts ?? []).slice().sort((a, b) => place(a.name) - place(b.name));
    return [...new Set(parts.flatMap((p) => p.inputs))];
  }

  tell(row: number): (string | [string, string])[] {
    const lines: (string | [string, string])[] = [`line ${plain(this.rows.at('line', row))}`, ['time', `${number(this.hours[row], 4)} h`]];
    if (this.report.runs.length > 1) lines.push(['run', this.report.runs[this.rows.at('run', row)] ?? '']);
    const measured = this.measured()[row] as number;
    if (this.chosen.measured) lines.push(['measured', Number.isFinite(measured) ? `${number(measured)} ${this.unit}` : 'no reading']);
    for (const m of this.together()) lines.push([this.label(m), `${number(this.predicted(m)[row])} ${this.unit}`]);
    if (Number.isFinite(measured)) lines.push(['predicted − measured', `${signed(this.residual()[row] as number)} ${this.errorUnit}`]);
    return lines;
  }
  tellInputs(row: number): [string, string][] {
    const shown = [...new Set([...this.drivers(), ...this.report.inputs.filter((n) => quantity(n).unit !== '°C' && this.rows.varies(n))])].slice(0, 8);
    return shown.map((name): [string, string] => [quantity(name).label, `${plain(this.rows.at(name, row), 5)} ${quantity(name).unit}`]);
  }

  override get axisName(): string {
    return this.report.runs_in_sequence ? 'time, runs one after the other' : 'time';
  }

  /// The whole record, its runs, the parts of it that are held out.
  private findSpans(): Stretch[] {
    const last = this.rows.count - 1;
    const list: Stretch[] = [{ label: 'the whole record', span: [this.hours[0] ?? 0, this.hours[last] ?? 1] }];
    const hours = (span: [number, number]) => `${number(span[0], 3)} to ${number(span[1], 3)} h`;
    if (this.report.runs.length > 1) {
      const runs = this.rows.get('run');
      this.report.runs.forEach((name, run) => {
        const of = Array.from(this.hours.filter((_, k) => runs[k] === run));
        if (of.length > 1) list.push({ label: `run ${name}`, span: [of[0] as number, of[of.length - 1] as number] });
      });
    }
    for (const p of this.report.models[0]?.held_out_parts ?? []) list.push({ label: `part ${p.part}, ${hours([p.from_h, p.to_h])}`, span: [p.from_h, p.to_h] });
    return list;
  }

  add(figure: Figure): HTMLElement {
    this.figures.push(figure);
    return figure.element;
  }
  redraw(): void {
    for (const figure of this.figures) figure.draw();
  }

  /// What all pictures of the record share.
  choices(label: string): HTMLElement {
    const bar = el('div', { class: 'choices', id: 'choices' });
    const { models } = this.report;
    const choose = (name: string, options: string[], chosen: number, model: (k: number) => number) => {
      if (options.length > 1)
        bar.append(
          choice(name, options, chosen, (k) => {
            this.model = model(k);
            this.redraw();
          }),
        );
    };
    // Of spindles every model has every channel, one model after the other.
    const channels = [...new Set(models.map((m) => m.displacement))];
    const names = [...new Set(models.map((m) => m.name))];
    if (models.length > Math.max(channels.length, names.length)) {
      choose(
        'Channel',
        channels.map((c) => models.find((m) => m.displacement === c)?.in_words ?? c),
        this.model % channels.length,
        (k) => this.model - (this.model % channels.length) + k,
      );
      choose(label, names, Math.floor(this.model / channels.length), (k) => (this.model % channels.length) + k * channels.length);
    } else choose(models.some((m) => m.parts) ? label : 'Channel', channels.length > 1 && names.length === 1 ? models.map((m) => m.in_words) : models.map((m) => m.name), this.model, (k) => k);
    if (this.spans.length > 1)
      bar.append(
        choice(
          'Time',
          this.spans.map((s) => s.label),
          0,
          (k) => {
            this.span = (this.spans[k] as Stretch).span;
            this.redraw();
          },
        ),
      );
    return bar;
  }
}
