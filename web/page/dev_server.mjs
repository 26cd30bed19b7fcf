// Serves the page of the workbench with the program of this machine as its engine, for development and tests.
//   RACEWAY=build/release/raceway node web/page/dev_server.mjs [PORT] [FOLDER_OF_NODE_MODULES]
// Listens on the loopback alone, and answers POST /ask: a question runs the program in a temporary folder.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { workbench } from './bundle.mjs';

/// Runs the program on a question, {arguments, files}; `child` hears of the process.
export function answer(program, question, child = () => {}) {
  const folder = mkdtempSync(join(tmpdir(), 'raceway-workbench-'));
  for (const [name, text] of Object.entries(question.files)) {
    if (!/^[^/\0]+$/.test(name) || name === '..' || name === '.') throw new Error(`no file name: ${name}`);
    writeFileSync(join(folder, name), text);
  }
  return new Promise((done, fail) => {
    const process = spawn(program, question.arguments, { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
    child(process);
    const texts = { stdout: '', stderr: '' };
    for (const stream of ['stdout', 'stderr']) process[stream].setEncoding('utf8').on('data', (text) => (texts[stream] += text));
    process.on('error', fail);
    process.on('close', (status) => {
      const files = {};
      for (const name of readdirSync(folder)) {
        const text = readFileSync(join(folder, name), 'utf8');
        if (text !== question.files[name]) files[name] = text;
      }
      rmSync(folder, { recursive: true, force: true });
      done({ status, out: texts.stdout, err: texts.stderr, files });
    });
  });
}

/// Key of a question among recorded answers.
export const recordKey = (question) => JSON.stringify([question.arguments, question.files]);

/// Listens. `recorded`, a Map, keeps every answer by its question: equal ones are answered once.
export function serve(program, page, port = 0, recorded = undefined) {
  const server = createServer((request, response) => {
    const reply = (status, type, text) => response.writeHead(status, { 'Content-Type': `${type}; charset=utf-8`, 'Cache-Control': 'no-store' }).end(text);
    if (!/^(127\.0\.0\.1|localhost)(:\d+)?$/.test(request.headers.host ?? '')) return reply(403, 'text/plain', 'loopback only');
    if (request.method === 'GET' && request.url === '/') return reply(200, 'text/html', page());
    if (request.method !== 'POST' || request.url !== '/ask' || request.headers['content-type'] !== 'application/json') return reply(404, 'text/plain', 'not here');
    let body = '';
    request.setEncoding('utf8').on('data', (text) => (body += text));
    request.on('end', async () => {
      try {
        const question = JSON.parse(body);
        const key = recordKey(question);
        const answered = recorded?.get(key) ?? (await answer(program, question, (child) => response.on('close', () => child.kill())));
        recorded?.set(key, answered);
        reply(200, 'application/json', JSON.stringify(answered));
      } catch (error) {
        reply(500, 'text/plain', error.message);
      }
    });
  });
  return new Promise((done) => server.listen(port, '127.0.0.1', () => done(server)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [port = '8321', packages] = process.argv.slice(2);
  const program = resolve(process.env.RACEWAY ?? 'build/release/raceway');
  const server = await serve(program, () => workbench(packages && resolve(packages), true), Number(port));
  console.log(`http://127.0.0.1:${server.address().port}/ with ${program}`);
}
