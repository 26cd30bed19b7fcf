// The engine in a worker of the page. The first message is { wasm: ArrayBuffer } or { wasm: WebAssembly.Module }; each
// further one is a question, answered by one message. With `progress: true` in the question, messages
// { progress: { share, step } } come before. What breaks the engine down is an error of the worker (onerror).
// A busy worker hears nothing: to stop a question, end the worker and start another.
import raceway from 'raceway.mjs';
import { engine } from './engine.mjs';

let ask = null;
let last = Promise.resolve();

async function hear({ data }) {
  if (data.wasm) {
    const module = data.wasm instanceof WebAssembly.Module ? data.wasm : await WebAssembly.compile(data.wasm);
    ask = engine(raceway, module);
    return;
  }
  const progress = data.progress ? (told) => self.postMessage({ progress: told }) : undefined;
  self.postMessage(await ask(data, { progress }));
}

self.onmessage = (event) => {
  last = last.then(() => hear(event)).catch((error) => setTimeout(() => { throw error; }));
};
