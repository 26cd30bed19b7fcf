// The engine answers as the program of this machine does: the same statuses, messages and files, solver numbers to 1e-9,
// fitted numbers to a thousandth of their standard error, errors on rows that a fit did not see to a ten thousandth.
//   node --test web/engine/engine_test.mjs
// with build/wasm/raceway.{mjs,wasm} and build/release/raceway, or what ENGINE (a folder) and RACEWAY (a program) name.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { progressOf } from './engine.mjs';
import { nativeEngine } from './native.mjs';
import { engineOf } from './node.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const folder = resolve(process.env.ENGINE ?? join(root, 'build/wasm'));
const program = resolve(process.env.RACEWAY ?? join(root, 'build/release/raceway'));
const ask = await engineOf(folder);
const askProgram = nativeEngine(program);

const text = (path) => readFileSync(join(root, path), 'utf8');

/// The question of a command line whose words name files below `base`.
function question(base, line) {
  const words = line.match(/'[^']*'|\S+/g).map((word) => word.replaceAll("'", ''));
  const files = {};
  for (const entry of existsSync(join(root, base)) ? readdirSync(join(root, base), { withFileTypes: true }) : [])
    if (entry.isFile() && /[.](toml|csv)$/.test(entry.name)) files[entry.name] = text(`${base}/${entry.name}`);
  return { arguments: words, files };
}

const solver = 1e-9; // relative
const fitted = 1e-3; // of the standard error
const derived = 1e-5; // relative, of what is made of fitted numbers
const heldOut = 1e-4; // relative, of errors that no fit minimised: a flat minimum ends where rounding lets it

/// Numbers that are differences of larger ones, which stand beside them or are given: of those they have the digits.
const differenceOf = { bias: 'rmse', derivative_error: 'derivative', heat_stored_W: 'friction_power_W', gain: 1 };

/// A document that was printed, or the text itself.
function document(printed) {
  try {
    return JSON.parse(printed);
  } catch {
    return printed;
  }
}

/// The sections of a channel of a correction have no order, and each fit gives them one: here the slowest comes first,
/// among the numbers before and among those after.
function slowestFirst(numbers) {
  const result = Object.fromEntries(Object.entries(numbers).map(([name, number]) => [name, { ...number }]));
  const channels = Object.keys(numbers).flatMap((name) => /^(.*)[.]time_constant_1$/.exec(name)?.[1] ?? []);
  for (const channel of channels)
    for (const [key, ...others] of [['before'], ['after', 'std']]) {
      const lag = (k) => numbers[`${channel}.time_constant_${k}`];
      const sections = [...Array(10).keys()].filter(lag);
      const sorted = [...sections].sort((a, b) => lag(b)[key] - lag(a)[key]);
      for (const of of ['gain', 'time_constant'])
        sections.forEach((k, place) => {
          for (const name of [key, ...others]) result[`${channel}.${of}_${k}`][name] = numbers[`${channel}.${of}_${sorted[place]}`][name];
        });
    }
  return result;
}

/// The rows of a matrix of correlations in the order of its sorted sections.
function sortedCorrelation({ names, rows }, numbers) {
  const lag = (name) => numbers[name.replace(/[.]gain_(\d+)$/, '.time_constant_$1')]?.after ?? 0;
  const kind = (name) => name.replace(/_\d+$/, '');
  const order = [...names.keys()].sort((a, b) => (kind(names[a]) < kind(names[b]) ? -1 : kind(names[a]) > kind(names[b]) ? 1 : lag(names[b]) - lag(names[a])));
  return { names: order.map((k) => kind(names[k])), rows: order.map((k) => order.map((j) => rows[k][j])) };
}

/// A document in which sections have one order.
function sorted(read) {
  if (Array.isArray(read)) return read.map(sorted);
  if (!read || typeof read !== 'object') return read;
  const result = Object.fromEntries(Object.entries(read).map(([name, value]) => [name, sorted(value)]));
  if (read.correlation?.rows && read.base_parameters) result.correlation = sortedCorrelation(read.correlation, read.base_parameters);
  if (read.base_parameters) result.base_parameters = slowestFirst(read.base_parameters);
  return result;
}

/// Numbers of documents and texts agree; every other difference is told with its place.
function differences(ours, theirs, tolerance, place = '', size = 0) {
  if (typeof ours === 'number' && typeof theirs === 'number') {
    const allowed = tolerance * Math.max(Math.abs(ours), Math.abs(theirs), size);
    return Math.abs(ours - theirs) <= Math.max(allowed, 1e-12) ? [] : [`${place}: ${ours}, by the program ${theirs}`];
  }
  if (ours && theirs && typeof ours === 'object' && typeof theirs === 'object') {
    const names = new Set([...Object.keys(ours), ...Object.keys(theirs)]);
    const error = [theirs.std, theirs.standard_error].find(Number.isFinite);
    const largest = Array.isArray(theirs) ? Math.max(0, ...theirs.filter(Number.isFinite).map(Math.abs)) : 0;
    return [...names].flatMap((name) => {
      const near = error !== undefined && [ours[name], theirs[name]].every(Number.isFinite) && Math.abs(ours[name] - theirs[name]) <= fitted * error;
      const of = differenceOf[name];
      const beside = Number.isFinite(of) ? of : Math.abs(theirs[of] ?? 0);
      if (name === 'std' && Math.abs(ours.std - theirs.std) <= fitted * theirs.std) return [];
      const allowed = /held_out|cross_validated/.test(name) ? Math.max(tolerance, heldOut) : tolerance;
      return near ? [] : differences(ours[name], theirs[name], allowed, `${place}.${name}`, Math.max(largest, beside));
    });
  }
  if (typeof ours === 'string' && typeof theirs === 'string') return textDifferences(ours, theirs, tolerance, place);
  return Object.is(ours, theirs) ? [] : [`${place}: ${JSON.stringify(ours)}, by the program ${JSON.stringify(theirs)}`];
}

/// Words are the same; a number may differ by one of its last digit, and by the tolerance.
function textDifferences(ours, theirs, tolerance, place) {
  if (ours === theirs) return [];
  const number = /[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?/gi;
  const [a, b] = [ours, theirs].map((all) => all.replace(number, '#'));
  if (a !== b) {
    const at = [...a].findIndex((c, k) => c !== b[k]);
    return [`${place}: "${a.slice(Math.max(0, at - 40), at + 60)}", by the program "${b.slice(Math.max(0, at - 40), at + 60)}"`];
  }
  const digit = (word) => 10 ** (Number(/e([-+]?\d+)/i.exec(word)?.[1] ?? 0) - (/\.(\d+)/.exec(word)?.[1].length ?? 0));
  const [x, y] = [ours.match(number), theirs.match(number)];
  return x.flatMap((word, k) => {
    const [p, q] = [Number(word), Number(y[k])];
    const allowed = Math.max(tolerance * Math.abs(q), 1.001 * Math.max(digit(word), digit(y[k])));
    return Math.abs(p - q) <= allowed ? [] : [`${place}: ${word}, by the program ${y[k]}`];
  });
}

function answersAlike(base, line, tolerance, pick = (read) => read) {
  test(`${line} (${base})`, async () => {
    const asked = question(base, line);
    const [ours, theirs] = await Promise.all([ask(asked), askProgram(asked)]);
    const [a, b] = [ours, theirs].map((answer) => ({ ...answer, out: pick(sorted(document(answer.out))) }));
    assert.deepEqual(differences(a, b, tolerance), []);
  });
}

const solved = (base, line) => answersAlike(base, line, solver);
const learnt = (base, line, pick) => answersAlike(base, line, derived, pick);

solved('none', '--version');
solved('none', '--help');
solved('none', 'frobnicate');
solved('none', 'effects --json');
solved('none', 'effects churning');
solved('none', 'keys --json');
solved('none', 'bearings --json');
solved('none', "new 'S 6014 C' -o my.toml");
solved('none', 'new --spindle -o spindle.toml');
solved('none', 'check none.toml --json');
solved('data/examples', 'check 7014.toml --json');
solved('data/examples', 'solve 7014.toml --speed 6000 --axial-load 300 --json');
solved('data/examples', 'table 7014.toml --speed 0:12000:1000 --axial-load 100,300,900 --json');
solved('data/examples', 'solve n1012.toml --speed 6000 --radial-load 300 --json');
solved('data/examples', 'solve race-control.toml --speed 6000 --axial-load 300 --json');
solved('data/spindles', 'displacement two_against_one.toml --speed 0:18000:3000 --json');
solved('data/spindles', 'spindle small.toml --speed 6000 --steady --json');
solved('data/spindles', 'modes small.toml --speed 0:6000:3000 --json');
solved('data/spindles', 'sensitivity small.toml --speed 6000 --json');

for (const rig of readdirSync(join(root, 'tests/hidden_effect/rigs')).sort()) {
  const base = `tests/hidden_effect/rigs/${rig}`;
  solved(base, 'check model.toml train.csv --json');
  solved(base, 'compare model.toml train.csv --json');
  learnt(base, 'calibrate model.toml train.csv -o fitted.toml --json');
  learnt(base, 'diagnose model.toml train.csv --json');
}
for (const record of ['ambient', 'exact', 'noise_free', 'power']) {
  const base = `data/corrections/${record}`;
  solved(base, 'compare correction.toml train.csv --json');
  // Without noise no candidate lowers the error, which is 0 but for rounding: their order and errors are of rounding too.
  learnt(base, 'diagnose correction.toml train.csv --json', record === 'noise_free' ? ({ effects, ...rest }) => rest : undefined);
}
for (const record of ['clean', 'drive', 'seats', 'sleeve'])
  solved(`data/spindles/${record}`, 'compare model.toml train.csv --json');
solved('data/measurements', 'check flywheel.toml flywheel_unloaded.csv --json');
learnt('data/measurements', 'diagnose flywheel.toml flywheel_unloaded.csv --json');
learnt('data/measurements', 'calibrate-sensor torque_weights.csv -o sensor.toml --json');
learnt('data/measurements/spindle_thermal', 'compare ch1.toml record.csv --json');
learnt('data/spindles', 'fit-law other_grooves.csv --json');

const rig = question('tests/hidden_effect/rigs/dev-02', 'diagnose model.toml train.csv --json');

test('a question leaves nothing behind: the next finds its own files alone and answers the same', async () => {
  const first = await ask(rig);
  await ask({ arguments: ['new', 'S 6014 C', '-o', 'left.toml', '--quiet'] });
  await ask({ arguments: ['solve', 'left.toml', '--speed', '1000'] }).then(({ err }) => assert.match(err, /left.toml: no such file/));
  await ask({ arguments: ['check', '-'], files: {} });
  assert.deepEqual(await ask(rig), first);
});

test('files may lie in folders and be bytes; those that were written or changed are in the answer', async () => {
  const { out, files, err } = await ask({
    arguments: ['new', 'S 6014 C', '-o', 'below/my.toml'],
    files: { 'below/other.csv': new Uint8Array([0xb0, 0x43]) },
  });
  assert.equal(out, '');
  assert.match(err, /below\/my.toml written/);
  assert.deepEqual(Object.keys(files), ['below/my.toml']);
});

test('a name that leads out of the folder is refused', async () => {
  for (const name of ['/etc/passwd', '../a', 'a/../b', 'a//b', '', 'a\0b'])
    await assert.rejects(ask({ arguments: ['--version'], files: { [name]: '' } }), /is not a valid file name/);
});

test('a report is the page that the program writes', async () => {
  const asked = question('tests/hidden_effect/rigs/dev-02', 'compare model.toml train.csv --report page.html');
  const { files } = await ask(asked);
  assert.match(files['page.html'], /^<!doctype html>/i);
});

test('progress is told on the way and stands in no message', async () => {
  const told = [];
  const { err } = await ask(rig, { progress: (step) => told.push(step) });
  assert.ok(told.length > 0);
  for (const { share } of told) assert.ok(share >= 0 && share <= 1);
  assert.doesNotMatch(err, /\[#|\[\./);
  assert.deepEqual(progressOf('[####......]  37 %  12 s left  pairs'), { share: 0.37, step: '12 s left  pairs' });
  assert.equal(progressOf('note: 5 % of the rows'), null);
});
