// The engine answers questions as the command does: arguments and files in, standard streams and written files out.

export interface Question {
  arguments: string[];
  files: Record<string, string>;
}

export interface Answer {
  status: number;
  out: string;
  err: string;
  files: Record<string, string>; // those that the run wrote
}

export interface Engine {
  /// One question at a time; `progress` hears shares from 0 to 1, where the engine tells them.
  ask(question: Question, progress?: (share: number) => void): Promise<Answer>;
  /// Ends the question that is being answered; its promise fails with Stopped.
  stop(): void;
}

/// A question that was ended.
export class Stopped extends Error {
  constructor() {
    super('Stopped.');
  }
}

/// The command as WebAssembly in a worker. A busy worker hears nothing: to stop it, it is ended and a new one begins.
class WorkerEngine implements Engine {
  private worker: Worker | undefined;
  private waiting: { done: (answer: Answer) => void; fail: (error: Error) => void; progress: ((share: number) => void) | undefined } | undefined;

  private module: WebAssembly.Module | undefined; // that the first worker compiled

  /// The first worker unpacks and compiles while the page is made.
  constructor(
    private readonly script: string,
    private readonly packed: string | undefined,
  ) {
    this.worker = this.begin();
  }

  private begin(): Worker {
    const url = URL.createObjectURL(new Blob([this.script], { type: 'text/javascript' }));
    const worker = new Worker(url);
    worker.addEventListener('message', ({ data }: MessageEvent<Answer | { progress: { share: number } } | { module: WebAssembly.Module }>) => {
      if ('module' in data) this.module = data.module;
      else if ('progress' in data) this.waiting?.progress?.(data.progress.share);
      else this.end((w) => w.done(data));
    });
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      this.dismiss();
      this.end((w) => w.fail(new Error(`The engine ended with an error: ${event.message || 'unknown'}. The next calculation starts it again.`)));
    });
    if (this.module) worker.postMessage({ module: this.module });
    else if (this.packed) worker.postMessage({ packed: this.packed });
    return worker;
  }

  private dismiss(): void {
    this.worker?.terminate();
    this.worker = undefined;
  }

  private end(how: (waiting: NonNullable<WorkerEngine['waiting']>) => void): void {
    const { waiting } = this;
    this.waiting = undefined;
    if (waiting) how(waiting);
  }

  async ask(question: Question, progress?: (share: number) => void): Promise<Answer> {
    const answer = new Promise<Answer>((done, fail) => (this.waiting = { done, fail, progress }));
    this.worker ??= this.begin();
    this.worker.postMessage({ ...question, progress: progress !== undefined });
    return answer;
  }

  stop(): void {
    this.dismiss();
    this.end((w) => w.fail(new Stopped()));
  }
}

/// A program behind the server that the page came from.
class ServerEngine implements Engine {
  private abort: AbortController | undefined;

  async ask(question: Question): Promise<Answer> {
    this.abort = new AbortController();
    try {
      const reply = await fetch('/ask', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(question), signal: this.abort.signal });
      if (!reply.ok) throw new Error(await reply.text());
      return (await reply.json()) as Answer;
    } catch (error) {
      if (error instanceof DOMException && error.name === 'AbortError') throw new Stopped();
      throw error;
    }
  }

  stop(): void {
    this.abort?.abort();
  }
}

/// The engine of this page: that inside it, else the server that it came from.
export function engineOfPage(): Engine {
  const script = document.getElementById('engine-worker')?.textContent;
  const wasm = document.getElementById('engine-wasm')?.textContent;
  return script ? new WorkerEngine(script, wasm ?? undefined) : new ServerEngine();
}
