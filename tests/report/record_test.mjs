// Pages of records over time, written by the built program, in Chromium: see pages.mjs.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { asPrinted, csvOf, documentOf, figures, file, marks, notesOf, open, raceway, results, ROOT, tableOf, write } from './pages.mjs';

const records = join(ROOT, 'data/corrections');
const of = (name, what) => join(records, name, what);

const model = `[correction]
name = "z"
displacement = "displacement_z_um"
tolerance_um = 2

[[correction.channel]]
name = "spindle"
input = "nose_temperature_C"
sections = [{ gain_um_K = 2, time_constant_s = 1500 }, { gain_um_K = -0.5, time_constant_s = 12000 }]

[[correction.channel]]
name = "screw"
input = "x_feed_m_min"
sections = [{ gain_um_m_min = 0.4, time_constant_s = 1800 }]
`;

/// Runs of a machine, with a gap of three hours in each and a reading at every tenth row. The clock
/// begins anew with each run.
function writeRuns() {
  const rows = ['time_s,run_id,speed_rpm,x_feed_m_min,coolant_on,nose_temperature_C,hall_temperature_C,displacement_z_um'];
  for (const [r, run] of ['monday', 'tuesday', 'friday'].entries())
    for (let k = 0; k < 900; ++k) {
      const t = 30 * k + (k >= 300 ? 10800 : 0);
      const nose = 25 + 8 * Math.sin(t / 5000 + r);
      const read = k % 10 === 0 ? (9 * Math.sin(t / 5000 + r - 0.3) + 5 * r + 0.2 * Math.sin(k * k)).toFixed(3) : '';
      rows.push(`${t},${run},${[0, 4000, 9000][Math.floor(t / 5400) % 3]},${Math.floor(t / 4000) % 2 ? 8 : 0},${Math.floor(t / 7000) % 2},${nose.toFixed(3)},${(20 + t / 20000).toFixed(3)},${read}`);
    }
  writeFileSync(file('runs.csv'), `${rows.join('\n')}\n`);
}

/// A day and a half of rows every ten seconds, with single rows far off the others.
const longRows = 12000;
const spikes = { hall_temperature_C: 4567, speed_rpm: 8123, displacement_z_um: 9871 };
function writeLong() {
  const rows = ['time_s,speed_rpm,x_feed_m_min,nose_temperature_C,hall_temperature_C,displacement_z_um'];
  for (let k = 0; k < longRows; ++k) {
    const t = 10 * k;
    const spike = (name, value, count = 1) => (k >= spikes[name] && k < spikes[name] + count ? 95 : value);
    const nose = 25 + 8 * Math.sin(t / 5000);
    rows.push(`${t},${spike('speed_rpm', 50)},${Math.floor(t / 4000) % 2 ? 8 : 0},${nose.toFixed(3)},${spike('hall_temperature_C', 20 + 2 * Math.sin(t / 20000)).toFixed(3)},${spike('displacement_z_um', 9 * Math.sin(t / 5000 - 0.3), 4).toFixed(3)}`);
  }
  writeFileSync(file('long.csv'), `${rows.join('\n')}\n`);
}

before(() => {
  const [start, train, later] = ['correction.toml', 'train.csv', 'test.csv'].map((what) => of('ambient', what));
  write('diagnose', 'diagnose', start, train);
  raceway('calibrate', start, train, '-o', file('base.toml'));
  write('add', 'add', start, 'ambient-drift', '--data', train, '-o', file('better.toml'));
  write('compare', 'compare', file('base.toml'), file('better.toml'), later);
  write('power', 'compare', of('power', 'correction.toml'), of('power', 'test.csv'));
  writeFileSync(file('z.toml'), model);
  writeFileSync(file('zy.toml'), model.replace('[correction]', '[[correction]]') + model.replace('[correction]', '[[correction]]').replaceAll('_z_', '_y_'));
  writeRuns();
  writeLong();
  write('runs', 'correct', file('z.toml'), file('runs.csv'));
  write('axes', 'correct', file('zy.toml'), file('runs.csv'));
  write('long', 'compare', file('z.toml'), file('long.csv'));
});

/// Painted pixels / 1000 of canvases, shapes of the rest.
const expected = {
  diagnose: { ladder: 16, 'over-time': 4, contributions: 20, residual: 10, steps: 4 },
  add: { ladder: 4, 'over-time': 4, contributions: 20, residual: 10, steps: 4 },
  compare: { 'over-time': 4, contributions: 20, residual: 10, ladder: 2, steps: 4 },
  power: { 'over-time': 4, contributions: 20, residual: 10, ladder: 1, steps: 2 },
  runs: { 'over-time': 4, contributions: 8, residual: 8, ladder: 1, steps: 3 },
  axes: { 'over-time': 4, contributions: 8, residual: 8, ladder: 1, steps: 3 },
  long: { 'over-time': 4, contributions: 8, residual: 8, ladder: 1, steps: 3 },
};

for (const [name, least] of Object.entries(expected))
  for (const colorScheme of ['light', 'dark'])
    test(`${name}, ${colorScheme}: opens without a message or a request, every picture has its marks, on a phone as well`, async () => {
      const { page, faults, close } = await open(name, { colorScheme });
      assert.deepEqual(await figures(page), Object.keys(least));
      const drawn = async (share) => {
        for (const [id, count] of Object.entries(least)) assert.ok((await marks(page, id)) >= share * count, `${id}: ${await marks(page, id)} of ${count}`);
      };
      await drawn(1);
      await page.setViewportSize({ width: 390, height: 844 });
      await page.waitForFunction(() => [...document.querySelectorAll('.chart > div')].every((chart) => chart.clientWidth < 390));
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, name);
      await drawn(0.25); // of the pixels that there are
      assert.deepEqual(faults, []);
      await close();
    });

const column = (d, name) => {
  const c = d.rows.columns.find((one) => one.name === name);
  return c.values ?? Array.from({ length: d.rows.rows }, () => c.constant);
};
const rms = (list) => Math.sqrt(list.reduce((sum, v) => sum + v * v, 0) / list.length);
const near = (value, wanted, share, what) => assert.ok(Math.abs(value - wanted) <= share * Math.abs(wanted), `${what}: ${value} ${wanted}`);

for (const name of ['diagnose', 'add', 'compare', 'runs'])
  test(`${name}: holds the document that --json prints, and shows its numbers`, async () => {
    const { page, faults, close } = await open(name);
    const d = await documentOf(page);
    const printed = results[name];
    assert.deepEqual(d.results, printed);
    const ladder = await tableOf(page, 'ladder');
    if (name === 'compare') {
      assert.deepEqual(ladder.map((row) => row[1]), printed.models.map((m) => m.rmse));
    } else if (name === 'add') {
      assert.deepEqual(ladder.map((row) => row.slice(1, 3)), [[printed.before.rmse, printed.rmse_held_out_before], [printed.after.rmse, printed.rmse_held_out_after]]);
    } else if (name === 'diagnose') {
      assert.equal(asPrinted(await page.textContent('#sentence')), printed.headline);
      assert.equal(asPrinted(await page.textContent('.more')), printed.sentence);
      assert.deepEqual(ladder.map((row) => row.slice(1, 3)), [[printed.rmse_before, printed.rmse_held_out_um], ...printed.effects.map((e) => [e.rmse, e.rmse_held_out_um])]);
      assert.ok((await page.textContent('main')).includes('needs a column coolant_on that changes between 0 and 1'));
    } else {
      assert.deepEqual(ladder.map((row) => row[1]), [printed.metrics.rmse_um]);
    }
    // The rows behind the pictures give the error that the document names.
    const last = d.models.length - 1;
    const { columns, rows } = await csvOf(page, 'residual');
    const at = columns.length - 1;
    const wanted = { compare: printed.models?.[last].rmse, add: printed.after?.rmse, runs: printed.metrics?.rmse_um }[name];
    if (wanted !== undefined) near(rms(rows.filter((row) => row[at]).map((row) => Number(row[at]))), wanted, 1e-4, 'RMS of the rows');
    assert.deepEqual(faults, []);
    await close();
  });

test('diagnose: errors on parts that no fit saw are drawn, and are those of the verdict', async () => {
  const { page, close } = await open('diagnose');
  const { models, results: d } = await documentOf(page);
  assert.deepEqual(models.map((m) => m.name), ['refitted, no effect added', 'with ambient-drift']);
  near(rms(models[0].held_out.residual), d.rmse_held_out_um, 1e-5, 'without');
  near(rms(models[1].held_out.residual), d.effects[0].rmse_held_out_um, 1e-5, 'with');
  const parts = await tableOf(page, 'residual');
  assert.deepEqual(parts.map((row) => row[0]), [1, 2, 3, 4, 5, 6, 7, 8]);
  const counts = parts.map(([part]) => models[1].held_out.part.filter((p) => p === part).length);
  const total = counts.reduce((sum, n) => sum + n, 0);
  near(Math.sqrt(parts.reduce((sum, row, k) => sum + (counts[k] / total) * row[6] ** 2, 0)), d.effects[0].rmse_held_out_um, 1e-5, 'by parts');
  await close();
});

test('what adds up is the prediction but for the zero of each run', async () => {
  const { page, close } = await open('runs');
  const d = await documentOf(page);
  const predicted = column(d, d.models[0].predicted);
  const parts = d.models[0].parts.map((p) => column(d, p.column));
  const runs = column(d, 'run');
  const zero = predicted.map((v, k) => v - parts.reduce((sum, p) => sum + p[k], 0));
  for (const run of [0, 1, 2]) {
    const own = zero.filter((_, k) => runs[k] === run);
    assert.ok(Math.max(...own) - Math.min(...own) < 1e-4, `${run}`);
  }
  const { columns, rows } = await csvOf(page, 'contributions');
  assert.deepEqual(columns.slice(2), d.models[0].parts.map((p) => `${p.name} [µm]`));
  assert.equal(rows.length, d.rows.rows);
  await close();
});

/// A picture as it is saved.
async function svgOf(page, id) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#${id} button:text-is("SVG")`)]);
  return readFileSync(await download.path(), 'utf8');
}

/// Points of the open lines of a colour and a width, line by line.
function linesOf(svg, colour, width) {
  const paths = [...svg.matchAll(/<path d="([^"]*)"[^>]*?>/g)].filter(([tag]) => tag.includes(`stroke="${colour}"`) && tag.includes(`stroke-width="${width}"`) && tag.includes('fill="none"'));
  return paths.flatMap(([, d]) => d.split('M').slice(1)).map((part) => [...part.matchAll(/(-?[\d.]+(?:e-?\d+)?)[ ,](-?[\d.]+(?:e-?\d+)?)/g)].map((m) => [Number(m[1]), Number(m[2])]));
}

test('runs: no line is drawn across a gap or from run to run, and readings are points', async () => {
  const { page, faults, close } = await open('runs', { viewport: { width: 1300, height: 900 } });
  const svg = await svgOf(page, 'over-time');
  const predicted = linesOf(svg, '#0072B2', '1.8').filter((points) => points.length > 10);
  assert.equal(predicted.length, 6); // three runs, each with a gap
  for (const points of predicted) for (let k = 1; k < points.length; ++k) assert.ok(Math.abs(points[k][0] - points[k - 1][0]) < 10, `${points[k - 1]} to ${points[k]}`);
  // Every reading is a point, and only a reading is.
  const d = await documentOf(page);
  const read = column(d, d.models[0].measured).filter((v) => v !== null).length;
  assert.equal(read, 270);
  assert.equal((await csvOf(page, 'residual')).rows.filter((row) => row[2]).length, read);
  for (const run of ['monday', 'tuesday', 'friday']) assert.ok(svg.includes(`>${run}</text>`), run);
  assert.ok(svg.includes('runs one after the other'));
  assert.deepEqual(faults, []);
  await close();
});

test('runs: a run or a part can be looked at alone', async () => {
  const { page, faults, close } = await open('runs');
  const time = page.locator('#choices select').last();
  const offered = await time.locator('option').allTextContents();
  assert.deepEqual(offered.slice(0, 4), ['the whole record', 'run monday', 'run tuesday', 'run friday']);
  assert.equal(offered.filter((text) => text.startsWith('part ')).length, 8);
  await time.selectOption({ label: 'run tuesday' });
  const { rows } = await csvOf(page, 'over-time');
  assert.equal(rows.length, 900);
  assert.equal(rows[0][0], '902');
  const svg = await svgOf(page, 'over-time');
  assert.equal(linesOf(svg, '#0072B2', '1.8').filter((points) => points.length > 10).length, 2);
  assert.deepEqual(faults, []);
  await close();
});

test('axes: of several displacements each can be chosen; one that was not read has no residual', async () => {
  const { page, faults, close } = await open('axes');
  assert.equal(await page.locator('#choices select').first().locator('option').count(), 2);
  await page.locator('#choices select').first().selectOption({ label: 'displacement y' });
  const { columns } = await csvOf(page, 'over-time');
  assert.ok(!columns.includes('measured [µm]'), `${columns}`);
  assert.ok(columns.includes('displacement y [µm]'));
  assert.match(await page.textContent('#sentence'), /displacement z: .* predicted, .* RMS residual\. displacement y: .* predicted\.$/);
  assert.deepEqual(faults, []);
  await close();
});

test('long: of 12 000 rows no extreme is lost, and the page says how they are drawn', async () => {
  const { page, faults, close } = await open('long');
  assert.match(await page.textContent('#thinned'), /the first, the lowest, the highest and the last row/);
  const svg = await svgOf(page, 'over-time');
  // Axes go as high as what is drawn: the speed to the spike of a single row, the displacement to one of four. A single
  // reading of a temperature or a displacement that leaves and returns takes no part.
  const numbers = [...svg.matchAll(/>(\d+)<\/text>/g)].map((m) => Number(m[1]));
  assert.equal(numbers.filter((v) => v >= 95).length, 2, `${numbers}`);
  const points = linesOf(svg, '#0072B2', '1.8').reduce((sum, line) => sum + line.length, 0);
  assert.ok(points > 500 && points < 5000, `${points} of ${longRows}`);
  assert.deepEqual(faults, []);
  await close();
});

test('steps: gains and time constants of the file stand at the curves', async () => {
  const { page, faults, close } = await open('runs');
  const text = await page.$eval('#steps svg', (svg) => [...svg.querySelectorAll('text')].map((t) => t.textContent).join('|'));
  for (const words of ['section 1: +2.00 µm, 25.0 min', 'section 2: −0.500 µm, 3.33 h', 'together: +1.50 µm', '+0.400 µm, 30.0 min', 'spindle: 1 K of nose temperature', 'screw: 1 m/min of x feed']) assert.ok(text.includes(words), `${words}: ${text}`);
  assert.deepEqual(await tableOf(page, 'steps'), [
    ['spindle', '1 K of nose temperature', 'section 1', 2, 1500],
    ['spindle', '1 K of nose temperature', 'section 2', -0.5, 12000],
    ['screw', '1 m/min of x feed', 'section 1', 0.4, 1800],
  ]);
  assert.deepEqual(faults, []);
  await close();
});

test('power: the loss that a friction table makes of the speed is drawn as an input', async () => {
  const { page, close } = await open('power');
  const { inputs, models } = await documentOf(page);
  assert.ok(inputs.includes('power_of_spindle_W'));
  assert.deepEqual(models[0].parts[0].inputs, ['power_of_spindle_W']);
  assert.ok((await svgOf(page, 'over-time')).includes('power of spindle [W]'));
  await close();
});

test('runs: hovering tells the row with its inputs, and a row of what was not read says so', async () => {
  const { page, faults, close } = await open('runs');
  const chart = page.locator('#over-time .chart');
  await chart.scrollIntoViewIfNeeded();
  const box = await chart.boundingBox();
  const told = [];
  for (const share of [0.08, 0.09, 0.1]) {
    await page.mouse.move(box.x + share * box.width, box.y + 150);
    await page.waitForTimeout(60);
    told.push(...(await page.$$eval('#over-time .tip', (tips) => tips.map((t) => t.textContent))));
  }
  assert.ok(told.some((text) => /^line \d+time[\d.]+ h.*runmonday.*measured.*predicted.*nose temperature/.test(text)), told.join('; '));
  assert.ok(told.some((text) => text.includes('no reading')), told.join('; '));
  assert.deepEqual(faults, []);
  await close();
});

test('notes and the assumptions of the model are on the page', async () => {
  const { page, close } = await open('runs');
  assert.ok(results.runs.notes.length > 0);
  assert.deepEqual(await notesOf(page), [...results.runs.notes, ...results.runs.messages]);
  assert.ok((await page.textContent('#assumed')).includes('from rest'));
  await close();
});

test('names of files and runs are data, never markup', async () => {
  writeFileSync(file('evil.csv'), readFileSync(file('runs.csv'), 'utf8').replaceAll('monday', '<img src=x onerror=alert(1)>'));
  raceway('correct', file('z.toml'), file('evil.csv'), '--report', file('evil.html'));
  const { page, faults, close } = await open('evil');
  assert.equal(await page.locator('img').count(), 0);
  assert.ok((await page.locator('#choices option').allTextContents()).some((text) => text.includes('<img')));
  assert.deepEqual(faults, []);
  await close();
});

test('on paper no picture is cut, and each fits on a page', async () => {
  const { page, faults, close } = await open('runs');
  await page.emulateMedia({ media: 'print' });
  await page.waitForFunction(() => document.querySelector('#over-time .chart > div').clientWidth === 676);
  for (const id of await figures(page)) {
    const { tall, drawn } = await page.$eval(`#${id}`, (figure) => ({ tall: figure.offsetHeight, drawn: figure.querySelector('.chart').offsetHeight }));
    assert.ok(tall < 1030, `${id}: ${tall}`); // A4 less its margins
    const lowest = await page.$eval(`#${id} .chart`, (chart) => Math.max(...[...chart.querySelectorAll('svg text')].map((t) => t.getBoundingClientRect().bottom - chart.getBoundingClientRect().top), 0));
    assert.ok(lowest <= drawn + 1, `${id}: text to ${lowest} of ${drawn}`);
  }
  assert.deepEqual(faults, []);
  await close();
});
