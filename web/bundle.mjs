// Makes the workbench, one file: the page of web/page with the engine inside.
//   node web/bundle.mjs OUTPUT.html FOLDER_OF_ENGINE [FOLDER_OF_NODE_MODULES]
// FOLDER_OF_ENGINE holds raceway.mjs and raceway.wasm (cmake --build --preset wasm: build/wasm). `raceway workbench`
// puts a model and records in place of the comment <!--@LOADED@-->.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { engineOf } from './engine/node.mjs';
import { packed, withRecorded, workbench } from './page/bundle.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const largest = 8e6; // bytes of the file

/// The script of the worker: engine.mjs with the factory of the WebAssembly.
export function workerScript(engine, packages) {
  const esbuild = createRequire(join(packages, 'package.json'))('esbuild');
  return esbuild
    .buildSync({
      entryPoints: [join(here, 'engine/worker.mjs')],
      alias: { 'raceway.mjs': join(engine, 'raceway.mjs') },
      bundle: true,
      minify: true,
      write: false,
      charset: 'ascii',
      legalComments: 'none',
      format: 'iife',
      target: ['chrome100', 'firefox100', 'safari15'],
      logLevel: 'error',
    })
    .outputFiles[0].text.trim();
}

/// The page with the engine inside.
export function withEngine(page, engine, packages) {
  const script = workerScript(engine, packages);
  if (/<\/script|<!--/i.test(script)) throw new Error('the script would end early inside a page');
  const place = '<!--@ENGINE@-->';
  if (!page.includes(place)) throw new Error(`the page has no place for the engine, ${place}`);
  const inside =
    `<script type="text/plain" id="engine-worker">${script}</script>\n` +
    `${packed('engine-wasm', readFileSync(join(engine, 'raceway.wasm')))}\n<!--@LOADED@-->`;
  return page.replace(place, () => inside);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [output, engine, packages = join(here, '../build/wasm/report/page')] = process.argv.slice(2).map((path) => resolve(path));
  if (!engine) throw new Error('node web/bundle.mjs OUTPUT.html FOLDER_OF_ENGINE [FOLDER_OF_NODE_MODULES]');
  const page = withEngine(await withRecorded(workbench(packages), await engineOf(engine)), engine, packages);
  if (page.length > largest) throw new Error(`${output}: ${page.length} bytes; ${largest} at most`);
  writeFileSync(output, page);
  console.log(`${output}: ${page.length} bytes`);
}
