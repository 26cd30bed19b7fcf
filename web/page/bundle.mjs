// Makes the page of the workbench, one file that asks nothing of any host:
//   node web/page/bundle.mjs OUTPUT.html [FOLDER_OF_NODE_MODULES] [--server]
// FOLDER_OF_NODE_MODULES is where the packages of report/page are; default build/release/report/page.
//
// The page has a place for the engine, the comment <!--@ENGINE@-->. What stands there:
//   <script type="text/plain" id="engine-worker">…</script>  text of the worker's script
//   <script type="text/plain" id="engine-wasm">…</script>    base64 of the gzipped WebAssembly, if the script has none inside
//   <script type="application/json" id="loaded">…</script>   optional: {"model": {"name", "text"}, "data": [{"name", "text"}], "map": "text"}
// The worker's first message is {"wasm": ArrayBuffer}, where there is an engine-wasm; each further one is a question
// {"arguments": [...], "files": {...}, "progress": true}, answered by one message {"status", "out", "err", "files"};
// messages {"progress": {"share": 0.4}} may come before.
//
// With --server the page asks the server that it comes from instead (dev_server.mjs).
import { writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { onePage } from '../../report/page/one_page.mjs';

const source = dirname(fileURLToPath(import.meta.url));
const root = join(source, '../..');

/// The text of the page.
export function workbench(packages = join(root, 'build/release/report/page'), server = false) {
  return onePage(packages, source, {
    policy: { 'script-src': "'wasm-unsafe-eval'", 'worker-src': 'blob:', 'connect-src': server ? "'self'" : "'none'" },
    options: { loader: { '.toml': 'text', '.csv': 'text' } },
  }).page;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const words = process.argv.slice(2).filter((word) => word !== '--server');
  const [output, packages] = words.map((path) => resolve(path));
  if (!output) throw new Error('node web/page/bundle.mjs OUTPUT.html [FOLDER_OF_NODE_MODULES] [--server]');
  const page = workbench(packages, process.argv.includes('--server'));
  writeFileSync(output, page);
  console.log(`${output}: ${page.length} bytes`);
}
