// Answers a question as engine.mjs does, by the program of this machine in a folder of its own. For tests.
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';

export function nativeEngine(program) {
  return async function ask({ arguments: words, files = {} }) {
    const folder = mkdtempSync(join(tmpdir(), 'raceway-question-'));
    try {
      for (const [name, content] of Object.entries(files)) {
        mkdirSync(dirname(join(folder, name)), { recursive: true });
        writeFileSync(join(folder, name), content);
      }
      const run = spawnSync(program, words, { cwd: folder, maxBuffer: 1 << 30, stdio: ['ignore', 'pipe', 'pipe'] });
      if (run.error) throw run.error;
      const written = {};
      for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
        if (!entry.isFile()) continue;
        const path = join(entry.parentPath ?? entry.path, entry.name);
        const name = relative(folder, path);
        const bytes = readFileSync(path);
        if (!(name in files) || !bytes.equals(Buffer.from(files[name]))) written[name] = bytes.toString();
      }
      return { status: run.status, out: run.stdout.toString(), err: run.stderr.toString(), files: written };
    } finally {
      rmSync(folder, { recursive: true });
    }
  };
}
