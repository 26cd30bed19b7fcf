// The engine of the workbench: the command raceway as WebAssembly, in a file system in memory. A question is a command
// line with the files that it names; the answer is what the command prints and writes.
//
//   question  { arguments: ['diagnose', 'rig.toml', 'rig.csv', '--json'], files: { 'rig.toml': text, 'rig.csv': text } }
//   answer    { status: 0, out: text, err: text, files: { 'new.toml': text } }
//
// A file of a question may be a text or a Uint8Array. `files` of an answer are those that the run wrote or changed.

const folder = '/work';

/// Names of files are relative and stay in their folder.
function checked(name) {
  const parts = name.split('/');
  if (name.startsWith('/') || name.includes('\0') || parts.some((part) => ['', '.', '..'].includes(part)))
    throw new Error(`${name}: is not a valid file name`);
  return name;
}

function put(FS, name, content) {
  const path = `${folder}/${checked(name)}`;
  FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
  FS.writeFile(path, content);
}

/// [name, bytes] of each file below a folder.
function* filesBelow(FS, path, prefix = '') {
  for (const name of FS.readdir(path).filter((entry) => entry !== '.' && entry !== '..')) {
    const below = `${path}/${name}`;
    if (FS.isDir(FS.stat(below).mode)) yield* filesBelow(FS, below, `${prefix}${name}/`);
    else yield [prefix + name, FS.readFile(below)];
  }
}

const same = (a, b) => a.length === b.length && a.every((byte, k) => byte === b[k]);

/// The share from 0 to 1 and the step that a line of the progress bar tells; null for other texts.
export function progressOf(text) {
  const line = /\[#*\.*\] +(\d+) %(?: {2}([^\r]*))?$/.exec(text);
  return line && { share: Number(line[1]) / 100, step: (line[2] ?? '').trim() };
}

/// A terminal in place of stderr, on which the command shows its progress: `tell` hears of it, the rest is kept.
function terminal(FS, tell) {
  const kept = [];
  const device = FS.makedev(64, 0);
  FS.registerDevice(device, {
    open: (stream) => {
      stream.tty = { ops: {} };
      stream.seekable = false;
    },
    write: (stream, buffer, offset, length) => {
      const bytes = buffer.slice(offset, offset + length);
      const text = new TextDecoder().decode(bytes);
      if (text.startsWith('\r\x1b[K')) {
        const progress = progressOf(text.slice(4));
        if (progress) tell(progress);
      } else {
        kept.push(bytes);
      }
      return length;
    },
  });
  FS.mkdev('/dev/stderr_of_question', device);
  return kept;
}

const joined = (pieces) => {
  const all = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
};

/// Gives ask(question, { progress }) of a compiled module and `factory`, the function of raceway.mjs that makes an
/// instance of it. Each question has an instance of its own: nothing is left of the one before.
export function engine(factory, module) {
  return async function ask({ arguments: words, files = {} }, { progress } = {}) {
    const { FS, callMain } = await factory({
      noInitialRun: true,
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
        return {};
      },
      print: () => {},
      printErr: () => {},
    });
    FS.mkdir(folder);
    FS.chdir(folder);
    const given = new Map();
    for (const [name, content] of Object.entries(files)) {
      put(FS, name, content);
      given.set(name, FS.readFile(`${folder}/${name}`));
    }
    // Streams are the first three files that are opened. The next that opens takes the number that was closed.
    FS.close(FS.streams[1]);
    FS.open('/out', 'w', 0o600);
    FS.close(FS.streams[2]);
    const kept = progress ? terminal(FS, progress) : null;
    FS.open(kept ? '/dev/stderr_of_question' : '/err', 'w', 0o600);
    let status = callMain(words.map(String));
    const text = (bytes) => new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes);
    const written = {};
    for (const [name, bytes] of filesBelow(FS, folder))
      if (!given.has(name) || !same(given.get(name), bytes)) written[name] = text(bytes);
    return { status, out: text(FS.readFile('/out')), err: text(kept ? joined(kept) : FS.readFile('/err')), files: written };
  };
}
