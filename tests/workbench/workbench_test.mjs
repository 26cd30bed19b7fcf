// The workbench in Chromium, by what a user does: drop, map, type, click, undo, save. The built program answers through
// the development server; the engine in a worker is played by answers that were recorded on the way.
// Environment: that of tests/report/pages.mjs, and PAGE_PACKAGES, the packages that the page is bundled with.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { nativeEngine } from '../../web/engine/native.mjs';
import { withRecorded, workbench } from '../../web/page/bundle.mjs';
import { serve } from '../../web/page/dev_server.mjs';
import { file, PACKAGES, raceway, RACEWAY, ROOT, visit } from '../report/pages.mjs';
import { bars, click, designate, drag, drop, errors, idle, press, reach, saved, sentence } from './steps.mjs';

const rigs = join(ROOT, 'tests/hidden_effect/rigs');
const german = join(ROOT, 'data/measurements/german_export.csv');
const recorded = new Map();
let server;
let address;

before(async () => {
  const page = workbench(process.env.PAGE_PACKAGES, true);
  server = await serve(RACEWAY, () => page, 0, recorded);
  address = `http://127.0.0.1:${server.address().port}/`;
});
after(() => server?.close());

async function open(options = {}) {
  const opened = await visit(address, options, undefined, [`${address}ask`]);
  await idle(opened.page);
  return opened;
}

test('shows a rig that lacks something; a click adds it, the error falls in the fit and on rows left out, undo brings it back', async () => {
  const { page, faults, close } = await open();
  const expected = JSON.parse(raceway('diagnose', join(rigs, 'dev-03/model.toml'), join(rigs, 'dev-03/train.csv'), '--json'));
  assert.equal(await sentence(page), expected.headline.replace('->', '→'));
  const before = await bars(page);
  assert.equal(await page.textContent('#add-0'), 'Add lubricant drag');
  await click(page, '#add-0');
  const after = await bars(page);
  assert.equal(before.length, 2);
  after.forEach((width, k) => assert.ok(width < 0.4 * before[k], `${before[k]} -> ${width}`));
  assert.match(await sentence(page), /^With lubricant drag: nothing is missing/);
  assert.equal(await page.getAttribute('#candidate-lubricant-drag', 'aria-checked'), 'true');
  assert.match(await page.textContent('#over-speed .note'), /with lubricant drag dashed/);
  assert.deepEqual(await errors(page), []);
  await click(page, '#step-history');
  assert.equal(await page.locator('#panel tbody tr').count(), 2);
  await click(page, '#undo');
  assert.deepEqual(await bars(page), before);
  assert.equal(await sentence(page), expected.headline.replace('->', '→'));
  assert.deepEqual(faults, []);
  await close();
});

test('two candidates can be on; base laws stand in the same list; what does not help is refused, and added only when asked', async () => {
  const { page, faults, close } = await open();
  await click(page, '#candidate-lubricant-drag');
  await click(page, '#candidate-windage');
  assert.match(await page.textContent('.verdict .callout.doubt'), /The program refuses this effect: windage explains nothing beyond the other effects/);
  await click(page, '#force');
  assert.match(await sentence(page), /^With lubricant drag and windage/);
  await click(page, '#candidate-windage');
  await click(page, '#candidate-lubricant-drag');
  const law = JSON.parse(raceway('add', join(rigs, 'dev-03/model.toml'), 'law:contact', '--data', join(rigs, 'dev-03/train.csv'), '--force', '--json'));
  assert.match(await page.textContent('[id="candidate-law:contact"]'), new RegExp(law.after.rmse.toPrecision(3)));
  assert.deepEqual(faults, []);
  await close();
});

test('from a file and a designation to the improved model, which the command runs with the same numbers', async () => {
  const { page, faults, close } = await open();
  const data = join(rigs, 'dev-05/train.csv');
  await drop(page, data);
  assert.match(await sentence(page), /Which bearing was measured/);
  await click(page, '#next');
  await designate(page, '7014 AC', 'VG 32');
  assert.deepEqual(await errors(page), []);
  await click(page, '#add-0');
  const fell = await page.$$eval('#error-bars .bar-value', (all) => all.map((v) => v.textContent));
  assert.match(fell[0], /→/);
  await click(page, '#step-model');
  assert.match(await page.textContent('#panel'), /values are assumed or estimated/);
  await click(page, '#step-home');
  const folder = file('home');
  mkdirSync(folder);
  for (const id of ['improved', 'model', 'columns', 'report']) {
    const { name, text } = await saved(page, `#save-${id}`);
    writeFileSync(join(folder, name), text);
  }
  const [shown] = /→ ([\d.]+)/.exec(fell[0]).slice(1).map(Number);
  const { rmse } = JSON.parse(raceway('compare', join(folder, 'improved.toml'), data, '--json'));
  assert.ok(Math.abs(rmse - shown) < 0.01 * shown, `${rmse} ${shown}`);
  assert.match(readFileSync(join(folder, 'report.html'), 'utf8'), /<title>raceway report/);
  // The commands of the page write the same models: of the data alone, and, twice, beside all that was saved.
  const { name: script, text: commands } = await saved(page, '#save-shell');
  const again = file('again');
  mkdirSync(again);
  for (const at of [again, folder, folder]) {
    writeFileSync(join(at, script), commands);
    writeFileSync(join(at, 'train.csv'), readFileSync(data));
    execFileSync('bash', ['-e', script], { cwd: at, stdio: 'pipe', env: { ...process.env, PATH: `${dirname(RACEWAY)}:${process.env.PATH}` } });
  }
  for (const name of ['model.toml', 'improved.toml']) assert.equal(readFileSync(join(again, name), 'utf8'), readFileSync(join(folder, name), 'utf8'));
  assert.equal(readFileSync(join(folder, 'before-improved.toml'), 'utf8'), readFileSync(join(folder, 'improved.toml'), 'utf8'));
  assert.deepEqual(faults, []);
  await close();
});

test('the bearing is typed beside the columns; a name that is none gets the words of the command and can be mended', async () => {
  const { page, faults, close } = await open();
  await drop(page, join(rigs, 'dev-05/train.csv'));
  assert.equal(await page.getAttribute('#panel', 'data-panel'), 'data');
  await designate(page, 'nothing', 'VG 32');
  assert.match((await errors(page)).join(), /nothing/);
  assert.equal(await page.inputValue('#designation'), 'nothing');
  await designate(page, '7014 AC', 'VG 32');
  assert.deepEqual(await errors(page), []);
  assert.match(await sentence(page), /is missing|explains/);
  // Values that a model leaves to the program are named.
  raceway('new', '7014 AC', '--law', 'contact', '-o', file('contact.toml'));
  await drop(page, file('contact.toml'));
  await click(page, '#step-model');
  const defaults = await page.textContent('#defaults');
  assert.match(defaults, /their defaults apply.*lubricant\.supply/s);
  assert.doesNotMatch(defaults, /inner_conformity/); // the model has it, marked as estimated
  assert.deepEqual(faults, []);
  await close();
});

test('the catalogue is offered for what is typed, by its name or by its size; an entry is chosen by keyboard or by mouse', async () => {
  const { page, faults, close } = await open();
  await drop(page, join(rigs, 'dev-05/train.csv'));
  const shown = () => page.$$eval('[role="option"] b', (all) => all.map((b) => b.textContent));
  const names = (filter) => JSON.parse(raceway('bearings', filter, '--json')).bearings.map((b) => b.name);
  await page.focus('#designation');
  await page.keyboard.type('7014');
  await page.waitForSelector('[role="option"]');
  assert.deepEqual(await shown(), names('7014'));
  assert.match(await page.textContent('.catalogue .note'), /^7014 is not in the catalogue; \d+ bearings of the same size/);
  assert.match(await page.textContent('[role="option"]'), /70 × 110 mm, 21 balls of 11\.91 mm, 15°/);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.$eval('#designation', (input) => document.getElementById(input.getAttribute('aria-activedescendant')).querySelector('b').textContent), names('7014')[1]);
  await page.keyboard.press('Enter');
  assert.equal(await page.inputValue('#designation'), names('7014')[1]);
  assert.equal(await page.getAttribute('#designation', 'aria-expanded'), 'false');
  // Escape closes the list alone, and the words stay.
  await page.fill('#designation', 'SM 60');
  await page.waitForSelector('[role="option"]');
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('[role="option"]:visible').count(), 0);
  assert.equal(await page.inputValue('#designation'), 'SM 60');
  // An empty field offers all; a name that is none offers nothing.
  await page.fill('#designation', '');
  await page.keyboard.press('ArrowDown');
  await page.waitForSelector('[role="option"]');
  assert.deepEqual(await shown(), names(''));
  await page.fill('#designation', 'nothing');
  await page.waitForSelector('[role="option"]', { state: 'hidden' });
  await page.fill('#designation', '6014');
  await page.waitForSelector('[role="option"]');
  await page.click('[role="option"]:nth-child(2)');
  assert.equal(await page.inputValue('#designation'), names('6014')[1]);
  await page.keyboard.press('Tab');
  await page.keyboard.type('VG 32');
  await page.keyboard.press('Enter');
  await idle(page);
  assert.deepEqual(await errors(page), []);
  assert.match(await page.textContent('#step-model'), new RegExp(names('6014')[1]));
  assert.deepEqual(faults, []);
  await close();
});

test('several files are one record: their rows are counted, drawn and checked together', async () => {
  const { page, faults, close } = await open();
  const [head, ...rows] = readFileSync(join(rigs, 'dev-05/train.csv'), 'utf8').trim().split('\n');
  const part = (name, from, to) => ({ name, mimeType: 'text/csv', buffer: Buffer.from([head, ...rows.slice(from, to), ''].join('\n')) });
  await drop(page, [part('a.csv', 0, 40), part('b.csv', 40)]);
  assert.match(await page.textContent('#step-data'), new RegExp(`a\\.csv, b\\.csv, ${rows.length} rows`));
  assert.equal(await page.locator('.spark').first().locator('circle').count(), rows.length);
  await drop(page, [part('a.csv', 0, 40), { name: 'b.csv', mimeType: 'text/csv', buffer: Buffer.from(`${head}\n${rows[0].replace(/[^,]*$/, 'x')}\n`) }]);
  assert.match((await errors(page)).join(), /b\.csv:2: /);
  assert.match(await sentence(page), /cannot be read/);
  assert.deepEqual(faults, []);
  await close();
});

test('the bar moves with the click, before the answers that follow are drawn', async () => {
  const { page, faults, close } = await open();
  await click(page, '#candidate-lubricant-drag');
  const once = () =>
    page.evaluate(async () => {
      const bar = document.querySelector('#error-bars .bar-now');
      const before = bar.style.width;
      document.getElementById('candidate-lubricant-drag').click();
      while (bar.style.width === before) await new Promise(requestAnimationFrame);
      return document.documentElement.dataset.idle;
    });
  for (let k = 0; k < 3; ++k) {
    assert.equal(await once(), 'no');
    await idle(page);
  }
  assert.deepEqual(faults, []);
  await close();
});

test('foreign columns are proposed and computed with only when agreed; a wrong unit is answered with those that are known', async () => {
  const { page, faults, close } = await open();
  await drop(page, german);
  assert.match(await sentence(page), /Check the columns/);
  assert.match((await errors(page))[0], /german_export\.csv:23: Reibmoment = "#NV"/);
  await page.check('#drop-nan');
  await idle(page);
  assert.equal(await page.inputValue('#column-friction_torque_Nmm'), 'Reibmoment');
  assert.equal(await page.inputValue('#unit-axial_load_N'), 'kN');
  await page.fill('#unit-speed_rpm', 'parsec');
  await page.keyboard.press('Tab');
  await idle(page);
  assert.match((await errors(page))[0], /unit = "parsec": must be rpm/);
  await page.fill('#unit-speed_rpm', 'rpm');
  await page.keyboard.press('Tab');
  await idle(page);
  assert.deepEqual(await errors(page), []);
  assert.ok((await page.locator('.spark circle').count()) > 100);
  await click(page, '#confirm-columns');
  await designate(page, 'S 6014 C', '');
  assert.match(await sentence(page), /is missing|explains/);
  await click(page, '#step-home');
  assert.match((await saved(page, '#save-columns')).text, /friction_torque_Nmm = \{ column = "Reibmoment", unit = "Nm" \}/);
  assert.deepEqual(faults, []);
  await close();
});

test('fields and text of the model stay in step, and a wrong text gets the message of the command', async () => {
  const { page, faults, close } = await open();
  await click(page, '#step-model');
  await page.click('summary:has-text("Text of")');
  await page.fill('#key-friction-f0', '1,75');
  await page.keyboard.press('Tab');
  await idle(page);
  const text = await page.inputValue('#toml');
  assert.match(text, /^f0 = 1\.75$/m);
  await page.fill('#toml', text.replace('f0 = 1.75', 'f0 = 1.25'));
  await page.waitForFunction(() => document.getElementById('key-friction-f0').value === '1.25');
  await idle(page);
  assert.deepEqual(await errors(page), []);
  await page.fill('#toml', text.replace('ball_count = 20', 'ball_count = 2'));
  await page.waitForSelector('.callout.error');
  assert.match((await errors(page)).join(), /ball_count/);
  await page.fill('#toml', '[bearing');
  await page.waitForFunction(() => /:1:/.test(document.querySelector('.callout.error')?.textContent ?? ''));
  await idle(page);
  await click(page, '#step-history');
  await click(page, '#back-0');
  assert.match(await sentence(page), /Lubricant drag is missing/);
  assert.deepEqual(faults, []);
  await close();
});

test('a number is dragged: the error as entered follows, and is a step when it is let go', async () => {
  const { page, faults, close } = await open();
  await click(page, '#step-compare');
  const entered = () => page.$eval('#panel', (panel) => panel.querySelector('#ladder').textContent);
  const before = await entered();
  await page.focus('#slide-f0');
  for (let k = 0; k < 10; ++k) await page.keyboard.press('ArrowLeft');
  await idle(page);
  assert.notEqual(await entered(), before);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'slide-f0');
  assert.deepEqual(faults, []);
  await close();
});

test('wrong files get the words of the command, and hostile names, cells and texts inject nothing', async () => {
  const { page, faults, close } = await open();
  const hostile = '<img src=x onerror=alert(1)>';
  await page.setInputFiles('#file', { name: 'mine.toml', mimeType: 'text/plain', buffer: Buffer.from('no model') });
  await idle(page);
  assert.match((await errors(page)).join(), /^mine\.toml:1:/);
  await click(page, '#example-rig');
  const cases = [
    ['empty.csv', '', /the file is empty/],
    ['words.csv', 'hello\n', /no data rows/],
    [`${hostile}.csv`, `"${hostile}",speed_rpm,friction_torque_Nmm\n1,2,${hostile}\n2,3,4\n`, /^_img_src_x_onerror_alert_1__\.csv:1: the axial load is missing: give a column/],
    ['a -o $(touch b).csv', 'hello\n', /no data rows/],
    ['-o.csv', 'speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n1000,nan,40,3\n', /axial_load_N/],
  ];
  for (const [name, text, words] of cases) {
    await drop(page, name, text);
    assert.match((await errors(page)).join(), words, name);
    assert.equal(await page.locator('img').count(), 0, name);
    await click(page, '#step-home');
    assert.ok((await page.textContent('#shell')).includes(name.startsWith('-') ? `./${name}` : /[<$]/.test(name) ? `'${name}'` : name), name);
    assert.doesNotMatch(await page.textContent('#shell'), /^for.*\$\(/m);
  }
  // What no column has can be a number.
  await drop(page, 'no load.csv', 'speed_rpm,temperature_C,friction_torque_Nmm\n1000,40,3\n2000,40,4\n');
  assert.match((await errors(page)).join(), /the axial load is missing/);
  await page.fill('#number-axial_load_N', '300');
  await page.keyboard.press('Tab');
  await idle(page);
  assert.deepEqual(await errors(page), []);
  await drop(page, 'model.toml', `[bearing]\nname = "${hostile}"\n`);
  await page.click('#step-model');
  await idle(page);
  await page.fill('#designation', `${hostile} --force`);
  await page.keyboard.press('Enter');
  await idle(page);
  assert.equal(await page.locator('img').count(), 0);
  await page.click('#step-home');
  const commands = await page.textContent('#shell');
  assert.match(commands, /'no load\.csv'/);
  assert.deepEqual(faults, []);
  await close();
});

test('a record over time with its correction: the missing lag is added, and the correction exported', async () => {
  const { page, faults, close } = await open();
  const record = join(ROOT, 'data/corrections/ambient');
  await page.setInputFiles('#file', [join(record, 'correction.toml'), join(record, 'train.csv')]);
  await idle(page);
  assert.deepEqual(await errors(page), []);
  assert.match(await sentence(page), /^Ambient drift is missing: gain -6\.8 µm\/K/);
  const before = await bars(page);
  await click(page, '#step-missing');
  await click(page, '#add-0');
  (await bars(page)).forEach((width, k) => assert.ok(width < 0.2 * before[k]));
  assert.match(await page.textContent('#panel'), /Contributions to the displacement/);
  await click(page, '#step-compare');
  assert.match(await page.textContent('#panel'), /Step responses/);
  await click(page, '#step-model');
  assert.equal(await page.locator('#identify').count(), 1);
  await click(page, '#step-home');
  const { name, text } = await saved(page, '#export-c');
  assert.equal(name, 'correction.h');
  assert.match(text, /#include <math\.h>/);
  assert.deepEqual(await errors(page), []);
  assert.deepEqual(faults, []);
  await close();
});

test('the measured spindle is built in: the lags of its sensors are found in 26 h and judged by the 8 h that follow, with its trust', async () => {
  const { page, faults, close } = await open();
  await click(page, '#example-record');
  assert.deepEqual(await errors(page), []);
  assert.match(await page.textContent('#trust'), /do not use/);
  // A correction that is not to be used is exported only when asked twice, as by the command.
  await click(page, '#step-home');
  await click(page, '#export-c');
  assert.match(await page.textContent('#export'), /do not use, because/);
  const untrusted = await saved(page, '#accept-untrusted');
  assert.match(untrusted.text, /Trust in displacement_ch3_um: do not use/);
  // The record cut elsewhere: other readings judge.
  await click(page, '#step-data');
  const cut = async (until) => {
    await page.fill('#until', until);
    await page.keyboard.press('Tab');
    await idle(page);
  };
  await cut('20 h');
  assert.match(await page.textContent('#error-bars'), /after 20\u00a0h, not fitted/);
  await cut('noon');
  assert.match((await errors(page)).join(), /noon/);
  await cut('26h');
  await click(page, '#step-missing');
  await click(page, '#find-lags');
  assert.deepEqual(await errors(page), []);
  const record = join(ROOT, 'data/measurements/spindle_thermal');
  const found = file('found.toml');
  const { trust } = JSON.parse(raceway('identify', join(record, 'bare3.toml'), join(record, 'record.csv'), '--lags', 'auto', '--until', '26h', '-o', found, '--json'));
  assert.equal(trust.verdict, 'within-range');
  assert.match(await page.textContent('#trust'), /only inside its range/);
  assert.ok((await page.textContent('#trust')).replaceAll('\u00a0', ' ').includes(trust.because.replaceAll(' um', ' µm')));
  const ahead = JSON.parse(raceway('compare', join(record, 'bare3.toml'), found, join(record, 'record.csv'), '--from', '26h', '--zero', 'none', '--json'));
  const [before, now] = ahead.models.map((m) => m.rmse.toPrecision(3));
  assert.match((await page.textContent('#error-bars')).replaceAll('\u00a0', ' '), new RegExp(`after 26 h, not fitted${before} → ${now} µm`));
  await click(page, '#step-home');
  const folder = file('bank');
  mkdirSync(folder);
  for (const id of ['start', 'model', 'data']) {
    const { name, text } = await saved(page, `#save-${id}`);
    writeFileSync(join(folder, name === 'model.toml' ? 'saved.toml' : name), text);
  }
  execFileSync('bash', ['-ec', await page.textContent('#shell')], { cwd: folder, stdio: 'pipe', env: { ...process.env, PATH: `${dirname(RACEWAY)}:${process.env.PATH}` } });
  assert.equal(readFileSync(join(folder, 'saved.toml'), 'utf8'), readFileSync(join(folder, 'model.toml'), 'utf8'));
  assert.match((await saved(page, '#export-python')).text, /only inside its range/);
  // Lags that were found in more of the record would not be judged by readings that no fit saw.
  await click(page, '#step-data');
  await cut('20h');
  assert.equal(await page.locator('#find-lags').count(), 1);
  assert.deepEqual(faults, []);
  await close();
});

test('of a large record as many rows are drawn as can be seen, all are read, and what is wrong is said of its line', async () => {
  const { page, faults, close } = await open();
  const rows = 150000;
  const lines = ['time_s,speed_rpm,spindle_temperature_C,displacement_z_um'];
  let [warm, z] = [20, 0];
  for (let k = 0; k < rows; ++k) {
    const speed = k % 50000 < 20000 ? 6000 : 0;
    warm += (20 + speed * 0.004 - warm) / 4000;
    z += (2 * (warm - 20) - z) / 8000;
    lines.push(`${k},${speed},${warm.toFixed(3)},${(z + 0.2 * Math.sin(1.7 * k)).toFixed(3)}`);
  }
  await drop(page, 'long.csv', `${lines.join('\n')}\n`);
  assert.deepEqual(await errors(page), []);
  await click(page, '#step-data');
  assert.match(await page.textContent('#panel'), new RegExp(`${rows} rows`));
  const dots = await page.$$eval('.spark', (all) => all.map((spark) => spark.querySelectorAll('circle').length));
  assert.ok(dots.length >= 4 && dots.every((count) => count > 100 && count <= 500), dots.join());
  assert.match(await page.textContent('#step-compare .summary'), /error/);
  lines[rows - 10] = lines[rows - 10].replace(/[^,]*$/, 'wrong');
  await drop(page, 'long.csv', `${lines.join('\n')}\n`);
  assert.match((await errors(page)).join(), new RegExp(`long\\.csv:${rows - 9}: `));
  assert.deepEqual(faults, []);
  await close();
});

const facts = (page) => page.$$eval('.facts div', (all) => Object.fromEntries(all.map((f) => [f.querySelector('dt').textContent, f.querySelector('dd').textContent])));
const steady = (model, ...flags) => JSON.parse(raceway('spindle', model, '--speed', '6000', '--steady', ...flags, '--json')).steady[0];

test('a spindle is designed: its cross-section follows the model; steady state, programme and modes are those of the program', async () => {
  const { page, faults, close } = await open();
  const design = join(ROOT, 'data/spindles/externally_driven.toml');
  await click(page, '#example-spindle');
  assert.match(await sentence(page), new RegExp(`nose ${steady(design).axial_displacement_um.toPrecision(4)} µm`));
  assert.equal(await page.locator('#assumptions tbody tr').count(), 5);
  await page.uncheck('#coolant');
  await idle(page);
  const warm = steady(design, '--coolant', 'off');
  assert.equal((await facts(page))['front set'], `${warm.front_force_N.toPrecision(4)} N`);
  await page.check('#coolant');
  await idle(page);
  // A longer piece at the rear: the picture and the numbers follow, the text too.
  await click(page, '#step-model');
  const picture = () => page.$eval('#cross-section .chart', (chart) => chart.innerHTML);
  const before = await picture();
  await page.fill('#piece-4-length_mm', '95');
  await page.keyboard.press('Tab');
  await idle(page);
  assert.notEqual(await picture(), before);
  const text = readFileSync(design, 'utf8').replace('length_mm = 75.0', 'length_mm = 95');
  await page.click('summary:has-text("Text of")');
  assert.equal(await page.inputValue('#toml'), text);
  writeFileSync(file('longer.toml'), text);
  assert.match(await sentence(page), new RegExp(`nose ${steady(file('longer.toml')).axial_displacement_um.toPrecision(4)} µm`));
  await click(page, '#piece-4-remove');
  await click(page, '#piece-3-add');
  assert.equal(await page.locator('.pieces tbody tr').count(), 5);
  await page.fill('#piece-1-length_mm', '-3');
  await page.keyboard.press('Tab');
  await idle(page);
  assert.match((await errors(page)).join(), /length_mm = -3 mm: must be from/);
  assert.match(await page.textContent('#cross-section'), /the last model with a solution/);
  await click(page, '#step-history');
  await click(page, '#back-0');
  assert.deepEqual(await errors(page), []);
  await click(page, '#step-programme');
  const run = JSON.parse(raceway('spindle', design, '--speed-profile', join(ROOT, 'data/spindles/day.csv'), '--json'));
  assert.equal((await facts(page))['highest front force'], `${run.highest_front_force.force_N.toPrecision(4)} N`);
  assert.deepEqual(await page.$$eval('#panel figure', (all) => all.map((f) => f.id)), ['section', 'nose', 'forces', 'temperatures', 'heat']);
  await page.click('summary:has-text("Text of the programme")');
  await page.fill('#programme', 'time_s,speed_rpm\n0,0\n600,x\n');
  await click(page, '#run-programme');
  assert.match((await errors(page)).join(), /^day\.csv:3: /);
  await page.fill('#programme', 'time_s,speed_rpm\n0,0\n600,3000\n');
  await click(page, '#run-programme');
  assert.match(await sentence(page), /nose from 0 µm/);
  await click(page, '#step-modes');
  assert.match(await sentence(page), /first mode [\d.]+ Hz at 0 rpm/);
  assert.equal(await page.locator('#campbell, #shapes').count(), 2);
  await click(page, '#step-home');
  const folder = file('spindle');
  mkdirSync(folder);
  for (const id of ['model', 'programme']) {
    const { name, text: own } = await saved(page, `#save-${id}`);
    writeFileSync(join(folder, name), own);
  }
  const rows = await saved(page, '#save-rows');
  execFileSync('bash', ['-ec', await page.textContent('#shell')], { cwd: folder, stdio: 'pipe', env: { ...process.env, PATH: `${dirname(RACEWAY)}:${process.env.PATH}` } });
  const numbers = (csv) => csv.split('\n').filter((line) => !line.startsWith('#')).join('\n');
  assert.equal(numbers(readFileSync(join(folder, 'run.csv'), 'utf8')), numbers(rows.text));
  assert.deepEqual(faults, []);
  await close();
});

test('a spindle begins with a template whose assumptions are marked; a dropped programme runs on it, a dropped rig takes its place', async () => {
  const { page, faults, close } = await open();
  await click(page, '#example-spindle');
  await click(page, '#step-model');
  await page.fill('#preload', '250');
  await designate(page, 'S 6010 E', 'VG 22');
  assert.deepEqual(await errors(page), []);
  assert.match(await sentence(page), /S 6010 E/);
  await designate(page, 'S 6014 C', '');
  assert.match(await sentence(page), /S 6014 C/);
  await page.fill('#preload', '250');
  await designate(page, 'S 6010 E', 'VG 22');
  assert.equal(await page.inputValue('#key-arrangement-preload_N'), '250');
  assert.ok((await page.locator('.field.assumed').count()) > 3);
  assert.equal(await page.locator('#example-spindle').count(), 0);
  await drop(page, 'shift.csv', 'time_s,speed_rpm,ambient_temperature_C\n0,0,20\n900,4000,22\n');
  assert.match(await sentence(page), /nose from/);
  await drop(page, join(rigs, 'dev-05/train.csv'));
  assert.match(await sentence(page), /Which bearing was measured/);
  await drop(page, join(ROOT, 'data/spindles/small.toml'));
  assert.match(await sentence(page), /6000 rpm: nose/);
  await click(page, '#step-model');
  await page.fill('#piece-2-bore_mm', '30');
  await page.keyboard.press('Tab');
  await idle(page);
  assert.deepEqual(await errors(page), []);
  await page.click('summary:has-text("Text of")');
  assert.match(await page.inputValue('#toml'), /\{length_mm = 180, diameter_mm = 82, bore_mm = 30\}/);
  // A record that is there already stays when its spindle is dropped.
  await drop(page, join(ROOT, 'data/corrections/ambient/train.csv'));
  await drop(page, join(ROOT, 'data/spindles/small.toml'));
  assert.equal(await page.locator('#step-data').count(), 1);
  assert.deepEqual(faults, []);
  await close();
});

test('candidates are switched and undone by keyboard alone', async () => {
  const { page, faults, close } = await open();
  await press(page, 'add-0');
  assert.match(await sentence(page), /^With lubricant drag/);
  await press(page, 'candidate-windage', 'Space');
  assert.equal(await page.getAttribute('#candidate-windage', 'aria-checked'), 'true');
  await page.keyboard.press('Control+z');
  await idle(page);
  assert.equal(await page.getAttribute('#candidate-windage', 'aria-checked'), 'false');
  assert.deepEqual(faults, []);
  await close();
});

test('from a file to the improved model and the report by keyboard alone', async () => {
  const { page, faults, close } = await open();
  const chooser = page.waitForEvent('filechooser'); // well before the key: the browser has to know that somebody waits
  await reach(page, 'file');
  await page.keyboard.press('Enter');
  await (await chooser).setFiles(join(rigs, 'dev-05/train.csv'));
  await idle(page);
  assert.match(await sentence(page), /Which bearing was measured/);
  await reach(page, 'designation');
  await page.keyboard.type('7014');
  await page.waitForSelector('[role="option"]');
  await page.keyboard.type(' AC');
  await page.keyboard.press('Tab');
  assert.equal(await page.inputValue('#designation'), '7014 AC');
  await page.keyboard.type('VG 32');
  await page.keyboard.press('Enter');
  await idle(page);
  assert.deepEqual(await errors(page), []);
  await press(page, 'add-0');
  assert.match(await sentence(page), /^With /);
  await press(page, 'step-home');
  for (const name of ['improved', 'report']) {
    await reach(page, `save-${name}`);
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
    assert.match(readFileSync(await download.path(), 'utf8'), name === 'report' ? /<title>raceway report/ : /^\[\[effect\]\]/m);
  }
  assert.deepEqual(faults, []);
  await close();
});

test('files are dragged onto the page: it shows that they may fall, and reads them', async () => {
  const { page, faults, close } = await open();
  const [model, rows] = ['model.toml', 'train.csv'].map((name) => join(rigs, 'dev-03', name));
  await drag(page, model, rows);
  assert.deepEqual(await errors(page), []);
  assert.equal(await sentence(page), JSON.parse(raceway('diagnose', model, rows, '--json')).headline.replace('->', '→'));
  assert.deepEqual(faults, []);
  await close();
});

test('cells are pasted from the clipboard, anywhere on the page', async () => {
  const { page, faults, close } = await open();
  const lines = readFileSync(join(rigs, 'dev-05/train.csv'), 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.evaluate((cells) => navigator.clipboard.writeText(cells), lines.map((line) => line.replaceAll(',', '\t')).join('\r\n'));
  await page.click('h1');
  await page.keyboard.press('Control+v');
  await page.waitForFunction(() => /pasted\.csv/.test(document.getElementById('step-data').textContent));
  await idle(page);
  assert.deepEqual(await errors(page), []);
  assert.match(await page.textContent('#step-data'), new RegExp(`pasted\\.csv, ${lines.length - 1} rows`));
  // A name in its field is no table.
  await page.evaluate(() => navigator.clipboard.writeText('7014 AC'));
  await page.focus('#designation');
  await page.keyboard.press('Control+v');
  assert.equal(await page.inputValue('#designation'), '7014 AC');
  assert.match(await sentence(page), /Which bearing was measured/);
  assert.deepEqual(faults, []);
  await close();
});

/// Texts whose contrast with what is behind them is below 4.5.
const faint = () => {
  const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  const rgba = (colour) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, 1, 1);
    return canvas.getImageData(0, 0, 1, 1).data;
  };
  const light = ([r, g, b]) => [r, g, b].map((v) => (v / 255 <= 0.03928 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4)).reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
  const behind = (e) => {
    for (let at = e; at; at = at.parentElement) {
      const colour = rgba(getComputedStyle(at).backgroundColor);
      if (colour[3] > 250) return colour;
    }
    return [255, 255, 255, 255];
  };
  return [...document.querySelectorAll('#workbench *')]
    .filter((e) => !e.closest('svg, .chart, :disabled') && e.checkVisibility() && [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim()))
    .flatMap((e) => {
      const [a, b] = [light(rgba(getComputedStyle(e).color)), light(behind(e))];
      const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      return ratio < 4.5 ? [`${e.textContent.trim().slice(0, 30)}: ${ratio.toFixed(2)}`] : [];
    });
};

const axe = readFileSync(join(PACKAGES, 'node_modules/axe-core/axe.min.js'), 'utf8');

/// Rules of axe-core that the page breaks, with the elements that break them.
async function broken(page) {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { preload: false, resultTypes: ['violations'] });
    return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
  });
}

for (const [width, colorScheme] of [[1300, 'light'], [1300, 'dark'], [390, 'light'], [390, 'dark']])
  test(`every step fits ${width} px, reads well in ${colorScheme}, and breaks no rule of accessibility`, async () => {
    const { page, faults, close } = await open({ viewport: { width, height: 900 }, colorScheme });
    const steps = { rig: ['missing', 'data', 'model', 'compare', 'history', 'home'], record: ['missing', 'data', 'model', 'home'], spindle: ['model', 'steady', 'programme', 'modes', 'history', 'home'] };
    for (const [example, step] of Object.entries(steps).flatMap(([name, list]) => list.map((s) => [name, s]))) {
      if ((await page.getAttribute(`#example-${example}`, 'aria-pressed')) !== 'true') await click(page, `#example-${example}`);
      await click(page, `#step-${step}`);
      assert.deepEqual(await errors(page), [], step);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, step);
      assert.deepEqual(await page.evaluate(faint), [], step);
      assert.deepEqual(await broken(page), [], `${example}, ${step}`);
    }
    // Data of their own, with points to measure next.
    await drop(page, join(rigs, 'dev-03/train.csv'));
    for (const step of ['data', 'missing', 'compare']) {
      if (step === 'missing') {
        await page.fill('#designation', '7014');
        await page.waitForSelector('[role="option"]');
        assert.deepEqual(await broken(page), [], 'the catalogue');
        await designate(page, '7014 AC', 'VG 32');
      }
      await click(page, `#step-${step}`);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, step);
      const [at, list] = await page.$$eval('.steps [aria-current], .steps', ([nav, current]) => [current.getBoundingClientRect(), nav.getBoundingClientRect()].map(({ left, right }) => ({ left, right })));
      assert.ok(at.left >= list.left - 1 && at.right <= list.right + 1, `${step} is seen in the list of steps`);
      assert.deepEqual(await broken(page), [], step);
    }
    assert.deepEqual(faults, []);
    await close();
  });

test('a spindle and its programme that were put into the page are open in it', async () => {
  const given = { model: 'externally_driven.toml', programme: 'day.csv' };
  const [model, day] = Object.values(given).map((name) => ({ name, text: readFileSync(join(ROOT, 'data/spindles', name), 'utf8') }));
  const loaded = `<script type="application/json" id="loaded">${JSON.stringify({ model, data: [day] }).replace(/</g, '\\u003c')}</script>`;
  const page_ = workbench(process.env.PAGE_PACKAGES, true).replace('<!--@ENGINE@-->', () => loaded);
  const own = await serve(RACEWAY, () => page_);
  const at = `http://127.0.0.1:${own.address().port}/`;
  const { page, faults, close } = await visit(at, {}, undefined, [`${at}ask`]);
  await idle(page);
  assert.match(await sentence(page), /6000 rpm.*nose/);
  await click(page, '#step-programme');
  assert.match(await page.textContent('#panel'), /day\.csv/);
  assert.match(await sentence(page), /nose from/);
  assert.deepEqual(faults, []);
  await close();
  own.close();
});

/// The page as one file, with a worker that plays what was recorded.
function withWorker(name, more = '', bundled = workbench(process.env.PAGE_PACKAGES)) {
  const answers = JSON.stringify([...recorded]).replace(/</g, '\\u003c');
  const worker = `const known = new Map(${answers});
onmessage = ({ data: question }) => {
  ${more}
  postMessage(known.get(JSON.stringify([question.arguments, question.files])) ?? { status: 1, out: '', err: 'not recorded: ' + question.arguments.join(' '), files: {} });
};`;
  const path = file(`${name}.html`);
  writeFileSync(path, bundled.replace('<!--@ENGINE@-->', () => `<script type="text/plain" id="engine-worker">${worker}</script>`));
  return pathToFileURL(path).href;
}

test('from a file, with the engine in a worker: no request, the same verdict; a question can be stopped, a crash is told', async () => {
  const { page, faults, close } = await visit(withWorker('workbench', "if (question.arguments.includes('endless')) for (;;);\n  if (question.arguments.includes('crash')) throw new Error('out of memory');"));
  await idle(page);
  assert.match(await sentence(page), /Lubricant drag is missing/);
  await click(page, '#add-0');
  assert.match(await sentence(page), /^With lubricant drag: nothing is missing/);
  await click(page, '#step-model');
  await page.fill('#designation', 'endless');
  await page.keyboard.press('Enter');
  await page.click('#stop');
  await idle(page);
  assert.match((await errors(page)).join(), /Stopped/);
  await page.fill('#designation', 'crash');
  await page.keyboard.press('Enter');
  await idle(page);
  assert.match((await errors(page)).join(), /The engine ended with an error/);
  await click(page, '#step-history');
  await click(page, '#back-0');
  assert.match(await sentence(page), /Lubricant drag is missing/);
  assert.deepEqual(faults, []);
  await close();
});

test('the verdict of the built-in rig stands before the engine has answered, and says that it is recorded', async () => {
  const bundled = await withRecorded(workbench(process.env.PAGE_PACKAGES), nativeEngine(RACEWAY));
  const slow = "if (question.arguments[0] === 'diagnose') for (const until = Date.now() + 3000; Date.now() < until; );";
  const { page, faults, close } = await visit(withWorker('recorded', slow, bundled));
  await page.waitForSelector('#add-0');
  assert.match(await page.textContent('#stale'), /recorded when this page was made/);
  assert.match(await sentence(page), /Lubricant drag is missing/);
  const before = await bars(page);
  await idle(page);
  assert.equal(await page.locator('#stale').count(), 0);
  assert.deepEqual(await bars(page), before);
  await close();
  assert.deepEqual(faults, []);
});
