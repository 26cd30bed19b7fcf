// The workbench as people open it: one file with the WebAssembly inside, from the disk, in Chromium.
//   node --test tests/workbench/assembled_test.mjs
// Environment: that of tests/report/pages.mjs, and WORKBENCH, the file (cmake --build --preset wasm).
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { file, raceway, ROOT, visit } from '../report/pages.mjs';
import { bars, designate, drag, drop, errors, idle, saved, sentence } from './steps.mjs';

const rigs = join(ROOT, 'tests/hidden_effect/rigs');
const address = pathToFileURL(process.env.WORKBENCH).href;
const headline = (...words) => JSON.parse(raceway('diagnose', ...words, '--json')).headline.replace('->', '→');

async function open() {
  const opened = await visit(address);
  await idle(opened.page);
  return opened;
}

test('the verdict of the built-in rig is that of the program; an effect is added and the error falls', async (t) => {
  const since = performance.now();
  const { page, faults, close } = await visit(address);
  await page.waitForFunction(() => /is missing/.test(document.getElementById('sentence')?.textContent));
  const verdict = performance.now() - since;
  const recorded = await sentence(page);
  await page.waitForFunction(() => !document.getElementById('stale'), undefined, { timeout: 60000 });
  const own = performance.now() - since;
  assert.equal(await sentence(page), recorded);
  await idle(page);
  const drawn = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);
  t.diagnostic(`opened: first picture ${drawn.toFixed(0)} ms, recorded verdict ${verdict.toFixed(0)} ms, that of the engine ${own.toFixed(0)} ms, all laws ${(performance.now() - since).toFixed(0)} ms`);
  assert.equal(await sentence(page), headline(join(rigs, 'dev-03/model.toml'), join(rigs, 'dev-03/train.csv')));
  const before = await bars(page);
  await page.click('#add-0');
  await idle(page);
  const after = await bars(page);
  assert.equal(after.length, 2);
  after.forEach((width, k) => assert.ok(width < 0.4 * before[k], `${before[k]} -> ${width}`));
  assert.match(await sentence(page), /^With lubricant drag: nothing is missing/);
  assert.match(await page.textContent('[id="candidate-law:contact"]'), /\d/);
  assert.deepEqual(await errors(page), []);
  assert.deepEqual(faults, []);
  await close();
});

test('a file is dropped, a bearing named: the model and verdict are those of the program; a wrong file gets its words', async () => {
  const { page, faults, close } = await open();
  await drop(page, 'wrong.csv', 'speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n1000,500,30,12\n2000,500,30,x\n');
  assert.match((await errors(page))[0], /wrong\.csv:3: /);
  await drag(page, join(rigs, 'dev-05/train.csv'));
  await page.click('#next');
  await designate(page, '7014 AC', 'VG 32');
  assert.deepEqual(await errors(page), []);
  const said = await sentence(page);
  await page.click('#step-home');
  const folder = file('assembled');
  mkdirSync(folder);
  for (const id of ['model', 'columns']) {
    const { name, text } = await saved(page, `#save-${id}`);
    writeFileSync(join(folder, name), text);
  }
  assert.equal(said, headline(join(folder, 'model.toml'), join(rigs, 'dev-05/train.csv'), '--columns', join(folder, 'columns.toml')));
  assert.deepEqual(faults, []);
  await close();
});

test('the measured spindle and the spindle design have the numbers of the program', async () => {
  const { page, faults, close } = await open();
  const record = join(ROOT, 'data/measurements/spindle_thermal');
  const [bare, rows, found] = [join(record, 'bare3.toml'), join(record, 'record.csv'), file('found.toml')];
  await page.click('#example-record');
  await idle(page);
  assert.equal(await sentence(page), headline(bare, rows, '--until', '26h').replaceAll(' um', ' µm'));
  await page.click('#find-lags');
  await idle(page);
  raceway('identify', bare, rows, '--lags', 'auto', '--until', '26h', '-o', found);
  const { models } = JSON.parse(raceway('compare', bare, found, rows, '--from', '26h', '--zero', 'none', '--json'));
  assert.match((await page.textContent('#error-bars')).replaceAll('\u00a0', ' '), new RegExp(`not fitted${models.map((m) => m.rmse.toPrecision(3)).join(' → ')} µm`));
  await page.click('#example-spindle');
  await idle(page);
  const design = join(ROOT, 'data/spindles/externally_driven.toml');
  const [steady] = JSON.parse(raceway('spindle', design, '--speed', '6000', '--steady', '--json')).steady;
  assert.match(await sentence(page), new RegExp(`nose ${steady.axial_displacement_um.toPrecision(4)} µm .*, ${steady.front_force_N.toPrecision(4)} N in the front set`));
  await page.click('#step-programme');
  await idle(page);
  assert.match(await sentence(page), /nose from/);
  await page.click('#step-modes');
  await idle(page);
  assert.match(await sentence(page), /first mode/);
  assert.deepEqual(await errors(page), []);
  assert.deepEqual(faults, []);
  await close();
});

test('a question is stopped, and the next one is answered by a new worker', async () => {
  const { page, faults, close } = await open();
  const before = await sentence(page);
  const waits = page.waitForSelector('#stop', { state: 'visible' });
  await page.click('#candidate-lubricant-drag');
  await waits;
  await page.keyboard.press('Escape');
  await idle(page);
  assert.match(await page.textContent('body'), /Stopped/);
  await page.click('#candidate-lubricant-drag');
  await idle(page);
  assert.equal(await sentence(page), before);
  await page.click('#candidate-lubricant-drag');
  await idle(page);
  assert.match(await sentence(page), /^With lubricant drag/);
  assert.deepEqual(faults, []);
  await close();
});
