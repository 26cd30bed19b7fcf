// Makes the page of the workbench, one file that asks nothing of any host:
//   node web/page/bundle.mjs OUTPUT.html [FOLDER_OF_NODE_MODULES] [--server]
// FOLDER_OF_NODE_MODULES is where the packages of report/page are; default build/release/report/page.
//
// The page has a place for the engine, the comment <!--@ENGINE@-->. What stands there:
//   <script type="text/plain" id="recorded">…</script>         optional: what the engine says of the built-in rig (withRecorded)
//   <script type="text/plain" id="engine-worker">…</script>  text of the worker's script
//   <script type="text/plain" id="engine-wasm">…</script>    base64 of the gzipped WebAssembly, if the script has none inside
//   <script type="application/json" id="loaded">…</script>   optional: {"model": {"name", "text"}, "data": [{"name", "text"}], "map": "text"}
// The worker's first message is {"packed": that base64} or {"module": WebAssembly.Module}, where there is an engine-wasm; to the
// first one it may answer {"module"}, once. Each further one is a question
// {"arguments": [...], "files": {...}, "progress": true}, answered by one message {"status", "out", "err", "files"};
// messages {"progress": {"share": 0.4}} may come before.
//
// With --server the page asks the server that it comes from instead (dev_server.mjs).
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { onePage } from '../../report/page/one_page.mjs';

const source = dirname(fileURLToPath(import.meta.url));
const root = join(source, '../..');

/// A text inside the page, as base64 of gzip.
export const packed = (id, text) => `<script type="text/plain" id="${id}">${gzipSync(text, { level: 9 }).toString('base64')}</script>`;

/// The text of the page.
export function workbench(packages = join(root, 'build/release/report/page'), server = false) {
  const { page } = onePage(packages, source, {
    policy: { 'script-src': "'wasm-unsafe-eval'", 'worker-src': 'blob:', 'connect-src': server ? "'self'" : "'none'" },
    options: { loader: { '.toml': 'text', '.csv': 'text' } },
  });
  return page.replace('<!--@EXAMPLES@-->', () => packed('spindle-record', readFileSync(join(root, 'data/measurements/spindle_thermal/record.csv'))));
}

/// The page with what the engine says of the built-in rig, which stands until the engine has answered in the page itself.
export async function withRecorded(page, ask) {
  const rig = join(root, 'tests/hidden_effect/rigs/dev-03');
  const files = { 'model.toml': readFileSync(join(rig, 'model.toml'), 'utf8'), 'rig.csv': readFileSync(join(rig, 'train.csv'), 'utf8') };
  const { status, err, files: written } = await ask({ arguments: ['diagnose', 'model.toml', 'rig.csv', '--json', '--report', 'report.html'], files });
  if (status !== 0) throw new Error(err);
  const [, document] = /<script type="application\/json" id="document">(.*?)<\/script>/s.exec(written['report.html']);
  return page.replace('<!--@ENGINE@-->', () => `${packed('recorded', document)}\n<!--@ENGINE@-->`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const words = process.argv.slice(2).filter((word) => word !== '--server');
  const [output, packages] = words.map((path) => resolve(path));
  if (!output) throw new Error('node web/page/bundle.mjs OUTPUT.html [FOLDER_OF_NODE_MODULES] [--server]');
  const page = workbench(packages, process.argv.includes('--server'));
  writeFileSync(output, page);
  console.log(`${output}: ${page.length} bytes`);
}
