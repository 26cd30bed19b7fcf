// Questions stand in a queue; equal ones are asked once. Says what is being asked, and how long the last one took.
import { Stopped, type Answer, type Engine, type Question } from './engine';

export interface Job {
  label: string; // "Diagnosing"
  since: number; // [ms], of performance.now()
  share?: number; // done, from 0 to 1
}

/// Something that the command refused, in its words.
export class Refused extends Error {
  constructor(
    message: string,
    readonly file: string | null,
    readonly line: number | null,
  ) {
    super(message);
  }
}

const mostKept = 60; // answers
const largestKept = 1.5e8; // characters of all of them

export class Asking {
  private readonly kept = new Map<string, Promise<Answer>>();
  private readonly sizes = new Map<string, number>(); // of answers
  private readonly numbers = new Map<string, number>(); // of texts
  private last: Promise<unknown> = Promise.resolve();
  private era = 0;

  constructor(
    private readonly engine: Engine,
    private readonly tell: (job: Job | undefined, took?: { label: string; ms: number }) => void,
  ) {}

  private keyOf(question: Question): string {
    const number = (text: string) => {
      if (!this.numbers.has(text)) this.numbers.set(text, this.numbers.size);
      return this.numbers.get(text);
    };
    return JSON.stringify([question.arguments, Object.entries(question.files).map(([name, text]) => [name, number(text)])]);
  }

  ask(label: string, question: Question): Promise<Answer> {
    const key = this.keyOf(question);
    const known = this.kept.get(key);
    if (known) return known;
    const { era } = this;
    const answer = this.last.then(async () => {
      if (era !== this.era) throw new Stopped();
      const since = performance.now();
      this.tell({ label, since });
      try {
        const answered = await this.engine.ask(question, (share) => this.tell({ label, since, share }));
        this.tell(undefined, { label, ms: performance.now() - since });
        return answered;
      } catch (error) {
        this.tell(undefined);
        throw error;
      }
    });
    this.last = answer.catch(() => {});
    this.kept.set(key, answer);
    answer.then(
      ({ out, files }) => {
        this.sizes.set(key, out.length + Object.values(files).reduce((sum, text) => sum + text.length, 0));
        this.forget();
      },
      () => this.kept.delete(key),
    );
    return answer;
  }

  /// Lets go of the oldest answers.
  private forget(): void {
    let size = [...this.sizes.values()].reduce((sum, s) => sum + s, 0);
    for (const [key, of] of this.sizes) {
      if (this.sizes.size <= mostKept && size <= largestKept) break;
      size -= of;
      this.sizes.delete(key);
      this.kept.delete(key);
    }
  }

  /// The document that a question with --json prints. Fails with Refused where the command does.
  async document<T>(label: string, question: Question): Promise<{ document: T; answer: Answer }> {
    const answer = await this.ask(label, question);
    return { document: documentOf<T>(answer), answer };
  }

  /// Ends the question that is being answered, and all that wait.
  stop(): void {
    ++this.era;
    this.engine.stop();
  }
}

/// A document of --json; refusals of `add` are documents too.
export function documentOf<T>(answer: Answer): T {
  let parsed: (T & { error?: { message: string; file: string | null; line: number | null } }) | undefined;
  try {
    parsed = JSON.parse(answer.out);
  } catch {
    throw new Refused(refusal(answer), null, null);
  }
  const error = parsed?.error;
  if (error) throw new Refused(error.message, error.file, error.line);
  return parsed as T;
}

/// The words of a command that wrote no document.
export function refusal(answer: Answer): string {
  const lines = answer.err
    .trim()
    .split('\n')
    .filter((line) => !line.startsWith('note: '));
  return lines.join('\n') || `The command ended with status ${answer.status} and printed no message.`;
}

/// The data inside a page that --report wrote.
export function reportOf<T>(page: string): T {
  const open = '<script type="application/json" id="document">';
  const start = page.indexOf(open);
  const end = page.indexOf('</script>', start);
  if (start < 0 || end < 0) throw new Error('the report contains no document');
  return JSON.parse(page.slice(start + open.length, end)) as T;
}
