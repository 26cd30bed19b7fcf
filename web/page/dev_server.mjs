// Serves the page of the workbench with the program of this machine as its engine, for development and tests.
//   RACEWAY=build/release/raceway node web/page/dev_server.mjs [PORT] [FOLDER_OF_NODE_MODULES]
// Listens on the loopback alone, and answers POST /ask: a question runs the program in a temporary folder.
import { createServer } from 'node:http';
import { resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { nativeEngine } from '../engine/native.mjs';
import { workbench } from './bundle.mjs';

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
        const answered = recorded?.get(key) ?? (await nativeEngine(program)(question, { child: (process) => response.on('close', () => process.kill()) }));
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
