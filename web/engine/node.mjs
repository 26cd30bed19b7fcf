// The engine in Node, for tests and measurements.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { engine } from './engine.mjs';

/// ask() of the raceway.mjs and raceway.wasm in a folder.
export async function engineOf(folder) {
  globalThis.self ??= { location: new URL('blob:') }; // the factory is made for a worker
  const { default: factory } = await import(pathToFileURL(join(folder, 'raceway.mjs')));
  return engine(factory, await WebAssembly.compile(readFileSync(join(folder, 'raceway.wasm'))));
}
