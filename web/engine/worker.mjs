// The engine in a worker of the page. The first message is { packed: base64 of gzip }, answered by the compiled { module },
// or { module } that another worker compiled; each further one is a question, answered by one message. With `progress: true` in the question, messages
// { progress: { share, step } } come before. What breaks the engine down is an error of the worker (onerror).
// A busy worker hears nothing: to stop a question, end the worker and start another.
import raceway from 'raceway.mjs';
import { engine } from './engine.mjs';

let ask = null;
let last = Promise.resolve();

/// Compiles while it unpacks.
function compiled(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < bytes.length; ++k) bytes[k] = text.charCodeAt(k);
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compileStreaming(new Response(unpacked, { headers: { 'Content-Type': 'application/wasm' } }));
}

async function hear({ data }) {
  if (data.packed || data.module) {
    const module = data.module ?? (await compiled(data.packed));
    if (data.packed) self.postMessage({ module });
    ask = engine(raceway, module);
    return;
  }
  const progress = data.progress ? (told) => self.postMessage({ progress: told }) : undefined;
  self.postMessage(await ask(data, { progress }));
}

self.onmessage = (event) => {
  last = last.then(() => hear(event)).catch((error) => setTimeout(() => { throw error; }));
};
