// Times of questions, as processor time of the thread that answers (Linux), which others on the machine lengthen little:
//   node web/engine/measure.mjs [FOLDER_OF_ENGINE]
// The first of five times compiles what is asked for the first time; the median of the others is what a page sees later.
import { readFileSync, statSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { engineOf } from './node.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const folder = resolve(process.argv[2] ?? join(root, 'build/wasm'));
const milliseconds = () => Number(readFileSync(`/proc/self/task/${process.pid}/schedstat`, 'utf8').split(' ')[0]) / 1e6;
const rig = join(root, 'tests/hidden_effect/rigs/dev-03');
const files = Object.fromEntries(['model.toml', 'train.csv'].map((name) => [name, readFileSync(join(rig, name), 'utf8')]));

const wasm = join(folder, 'raceway.wasm');
console.log(`raceway.wasm: ${statSync(wasm).size} bytes, ${gzipSync(readFileSync(wasm), { level: 9 }).length} compressed`);
const ask = await engineOf(folder);
const lines = [
  '--version',
  'effects --json',
  'check model.toml train.csv --json',
  'compare model.toml train.csv --json',
  'calibrate model.toml train.csv -o fitted.toml --json',
  'diagnose model.toml train.csv --json',
  'add model.toml lubricant-drag --data train.csv -o improved.toml --json',
  'add model.toml law:skf --data train.csv --force -o skf.toml --json',
  'add model.toml law:contact --data train.csv --force -o contact.toml --json',
];
for (const line of lines) {
  const times = [];
  for (let k = 0; k < 5; ++k) {
    const since = milliseconds();
    const { status, err } = await ask({ arguments: line.split(' '), files });
    if (status !== 0) throw new Error(err);
    times.push(milliseconds() - since);
  }
  const [first, ...later] = times;
  console.log(`${line}: ${later.sort((a, b) => a - b)[1].toFixed(0)} ms, at first ${first.toFixed(0)} ms`);
}
