// Answers a question as engine.mjs does, by the program of this machine in a folder of its own. For development and tests.
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';

/// Exit status and texts of a run; `child` gets the process, to stop it.
function run(program, words, folder, child) {
  return new Promise((done, fail) => {
    const process = spawn(program, words, { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
    child(process);
    const texts = { stdout: '', stderr: '' };
    for (const stream of ['stdout', 'stderr']) process[stream].setEncoding('utf8').on('data', (text) => (texts[stream] += text));
    process.on('error', fail);
    process.on('close', (status) => done({ status, out: texts.stdout, err: texts.stderr }));
  });
}

export function nativeEngine(program) {
  return async function ask({ arguments: words, files = {} }, { child = () => {} } = {}) {
    const folder = mkdtempSync(join(tmpdir(), 'raceway-question-'));
    try {
      for (const [name, content] of Object.entries(files)) {
        const path = join(folder, name);
        if (relative(folder, path).startsWith('..')) throw new Error(`${name}: is not a valid file name`);
        mkdirSync(dirname(path), { recursive: true });
        writeFileSync(path, content);
      }
      const told = await run(program, words, folder, child);
      const written = {};
      for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
        if (!entry.isFile()) continue;
        const path = join(entry.parentPath ?? entry.path, entry.name);
        const name = relative(folder, path);
        const bytes = readFileSync(path);
        if (!(name in files) || !bytes.equals(Buffer.from(files[name]))) written[name] = bytes.toString();
      }
      return { ...told, files: written };
    } finally {
      rmSync(folder, { recursive: true });
    }
  };
}
