// The Python commands that the page shows: run beside the files that the page saves, they give the numbers on the page.
//   scripts/workbench test
// Environment: that of workbench_test.mjs, PYTHON the interpreter and PYTHONPATH the folder of the package.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { after, before, test } from 'node:test';
import { workbench } from '../../web/page/bundle.mjs';
import { serve } from '../../web/page/dev_server.mjs';
import { file, RACEWAY, ROOT, visit } from '../report/pages.mjs';
import { click, designate, drop, errors, idle, saved, sentence } from './steps.mjs';

let server;
let address;

before(async () => {
  const page = workbench(process.env.PAGE_PACKAGES, true);
  server = await serve(RACEWAY, () => page);
  address = `http://127.0.0.1:${server.address().port}/`;
});
after(() => server?.close());

async function open() {
  const opened = await visit(address, {}, undefined, [`${address}ask`]);
  await idle(opened.page);
  return opened;
}

/// Saves what the page offers and runs its commands beside it: what they print as the page writes it, the folder, the files saved.
async function run(page, name, ids, ...data) {
  const folder = file(name);
  mkdirSync(folder);
  await click(page, '#step-home');
  const files = {};
  for (const id of [...ids, 'python']) {
    const { name, text } = await saved(page, `#save-${id}`);
    writeFileSync(join(folder, name), text);
    files[id] = text;
  }
  for (const path of data) writeFileSync(join(folder, basename(path)), readFileSync(path));
  const printed = execFileSync(process.env.PYTHON, ['commands.py'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  return { printed: printed.replaceAll('->', '→').replaceAll(' um', ' µm'), folder, files };
}

/// Lines of a model apart from comments, which name the command or the call that wrote them.
const values = (text) => text.replace(/ *#.*/g, '').split('\n').filter(Boolean);
const improved = (folder) => values(readFileSync(join(folder, 'improved.toml'), 'utf8'));

/// What is printed has the number that the page shows, at least as exact.
function prints(printed, shown) {
  const digits = shown.replace(/^[-0.]+|[-.]/g, '').length;
  const numbers = (printed.match(/-?\d+(\.\d+)?(e[-+]\d+)?/g) ?? []).map(Number);
  assert.ok(numbers.some((n) => Number(n.toPrecision(digits)) === Number(shown)), `${shown} in ${printed}`);
}

const shownError = async (page) => /error ([\d.]+)/.exec((await page.textContent('#step-compare .summary')).replaceAll('\u00a0', ' '))[1];

/// The commands print the verdict and the error of the page first, and write the same improved model. Returns what they print.
async function agrees(page, verdict, model, ...asked) {
  const { printed, folder, files } = await run(page, ...asked);
  assert.equal(printed.split('\n')[0], verdict);
  prints(printed, await shownError(page));
  assert.deepEqual(improved(folder), values(files[model]));
  return printed;
}

test('a rig with its effect: verdicts, error and improved model of Python are those of the page', async () => {
  const { page, faults, close } = await open();
  const before = await sentence(page);
  await click(page, '#add-0');
  const after = (await sentence(page)).replace(/^With [^:]*: /, '');
  const printed = await agrees(page, before, 'improved', 'rig', ['improved', 'model', 'data']);
  assert.equal(printed.split('\n')[1].toLowerCase(), after.toLowerCase());
  assert.deepEqual(faults, []);
  await close();
});

test('a foreign file with its map, under another base law', async () => {
  const { page, faults, close } = await open();
  const german = join(ROOT, 'data/measurements/german_export.csv');
  await drop(page, german);
  await page.check('#drop-nan');
  await idle(page);
  await click(page, '#confirm-columns');
  await designate(page, 'S 6014 C', '');
  await click(page, '#step-model');
  await click(page, '#law-skf');
  if (await page.locator('#force').count()) await click(page, '#force');
  assert.deepEqual(await errors(page), []);
  await agrees(page, await sentence(page), 'improved', 'foreign', ['improved', 'model', 'columns'], german);
  assert.deepEqual(faults, []);
  await close();
});

test('the measured spindle: the lags of all its sensors, judged by the hours that follow', async () => {
  const { page, faults, close } = await open();
  await click(page, '#example-record');
  await click(page, '#find-lags');
  await agrees(page, await sentence(page), 'model', 'record', ['start', 'model', 'data']);
  assert.deepEqual(faults, []);
  await close();
});

test('the spindle design: steady state, rows of the programme, modes', async () => {
  const { page, faults, close } = await open();
  await click(page, '#example-spindle');
  const [, nose] = /nose ([-\d.]+)/.exec(await sentence(page));
  await click(page, '#step-modes');
  const [, mode] = /first mode ([\d.]+) Hz/.exec(await sentence(page));
  await click(page, '#step-programme');
  const { printed, folder, files } = await run(page, 'spindle', ['model', 'programme', 'rows']);
  prints(printed, nose);
  prints(printed, mode);
  const rows = (csv) => csv.split('\n').filter((line) => !line.startsWith('#'));
  assert.deepEqual(rows(readFileSync(join(folder, 'run.csv'), 'utf8')), rows(files.rows));
  assert.deepEqual(faults, []);
  await close();
});
