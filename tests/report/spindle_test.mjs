// Pages of the commands of a spindle, written by the built program, in Chromium: see pages.mjs.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { asPrinted, csvOf, documentOf, figures, file, marks, open, raceway, results, ROOT, tableOf, write } from './pages.mjs';

const spindles = join(ROOT, 'data/spindles');
const model = join(spindles, 'externally_driven.toml');
const seats = join(spindles, 'seats/model.toml');

before(() => {
  write('run', 'spindle', model, '--speed-profile', join(spindles, 'day.csv'), '--assumptions');
  writeFileSync(file('few.csv'), 'time_s,speed_rpm,coolant_on,ambient_temperature_C\n3600,3000,1,20\n7200,5000,0,22\n14400,0,1,23\n');
  write('few', 'spindle', seats, '--speed-profile', file('few.csv'), '--assumptions');
  write('steady', 'spindle', seats, '--speed', '6000', '--steady');
  write('speeds', 'spindle', model, '--speed', '2000:10000:2000', '--steady');
  const text = readFileSync(model, 'utf8').replace('externally driven, 70 mm, two against one', 'a <img src=x onerror=alert(1)>');
  writeFileSync(
    file('network.toml'),
    `${text.slice(0, text.indexOf('[shaft]'))}[[network.node]]\nname = "rotor"\ncapacity_J_K = 900\nheat_W = 40\n[[network.node]]\nname = "body"\ncapacity_J_K = 20000\n[[network.link]]\nfrom = "rotor"\nto = "body"\nconductance_W_K = 5\n[[network.link]]\nfrom = "body"\nto = "ambient"\nconductance_W_K = 2\n`,
  );
  const [train, later] = ['train.csv', 'test.csv'].map((what) => join(spindles, 'seats', what));
  raceway('add', seats, 'seat-conductance', '--data', train, '-o', file('better.toml'), '--quiet');
  write('compare', 'compare', seats, file('better.toml'), later);
  write('alone', 'compare', seats, later);
  write('diagnose', 'diagnose', seats, train, '--no-pairs');
  write('add', 'add', seats, 'seat-conductance', '--data', train);
  write('modes', 'modes', model, '--speed', '0:40000:2000');
  write('warm', 'modes', model, '--speed', '2000:8000:2000', '--warm');
  write('shaken', 'modes', model, '--speed', '0:40000:2000', '--damping', '0.03', '--unbalance', '5');
  write('belt', 'spindle', join(spindles, 'belt_driven.toml'), '--speed', '4000', '--steady', '--assumptions');
  write('deflection', 'deflection', model, '--force', '1000', '--speed', '8000', '--warm');
  write('axial', 'deflection', model, '--force', '200', '--direction', 'axial');
  write('steps', 'step-response', model, '--speed', '2000:8000:2000', '--coolant', 'off', '--hours', '8', '--correction', file('correction.toml'), '--programme', join(spindles, 'day.csv'));
  write('loads', 'step-response', model, '--speed', '2000,6000', '--axial-load=-500,250,500', '--radial-load', '1000,2000', '--coolant', 'off', '--hours', '4');
  writeFileSync(file('fe.csv'), ['load_case,time_s,axial_displacement_um,power_W', ...[50, 100].flatMap((p) => Array.from({ length: 40 }, (_, k) => `<b>${p}</b>,${60 * k},${(p / 10) * (1 - Math.exp(-k / 9))},${p}`))].join('\n'));
  write('imported', 'step-response', '--import', file('fe.csv'));
  write('network', 'spindle', file('network.toml'), '--speed-profile', file('few.csv'));
});

/// Painted pixels / 1000 of canvases, shapes of the rest.
const expected = {
  run: { section: 400, nose: 8, forces: 8, temperatures: 8, heat: 40 },
  few: { section: 400, nose: 8, forces: 8, temperatures: 8, heat: 20 },
  steady: { section: 400, heat: 6, temperatures: 6 },
  speeds: { section: 400, nose: 3, forces: 2, heat: 3, stiffness: 1, rings: 3, 'bearing-forces': 3, friction: 3, 'contact-angles': 3, 'ball-loads': 3, pressures: 3 },
  network: { temperatures: 4, heat: 20 },
  modes: { campbell: 40, shapes: 20, radial: 5, axial: 5, forces: 5 },
  warm: { campbell: 12, shapes: 20, radial: 5, axial: 5, forces: 5, rings: 3 },
  shaken: { campbell: 40, unbalance: 1, 'unbalance-lag': 1, shapes: 20, radial: 5, axial: 5, forces: 5 },
  belt: { section: 400, heat: 6, temperatures: 6 },
  deflection: { line: 20, balls: 20, stiffness: 9 },
  axial: { balls: 20, stiffness: 9 },
  steps: { courses: 8, left: 2, gain: 4, 'time-constant': 4, 'two-gains': 2, 'two-times': 2, superposition: 8 },
  loads: { courses: 4, left: 2, gain: 4, 'time-constant': 4, 'two-gains': 1, 'two-times': 1, 'load-courses': 8, 'axial-gain': 1, 'axial-at-once': 1, 'radial-gain': 1, 'radial-at-once': 1 },
  imported: { courses: 4, left: 1, gain: 2, 'time-constant': 2 },
  compare: { ladder: 2, channels: 14, 'over-time': 8, residual: 10 },
  alone: { channels: 7, 'over-time': 8, residual: 10 },
  diagnose: { channels: 21, ladder: 20, 'over-time': 8, residual: 10 },
  add: { channels: 14, 'over-time': 8, residual: 10 },
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
      await drawn(0.2); // of the pixels that there are
      assert.deepEqual(faults, []);
      await close();
    });

const near = (value, wanted, share, what) => assert.ok(Math.abs(value - wanted) <= share * Math.abs(wanted) + 1e-6, `${what}: ${value} ${wanted}`);
const column = (d, name) => {
  const c = d.rows.columns.find((one) => one.name === name);
  assert.ok(c, name);
  return c.values ?? Array.from({ length: d.rows.rows }, () => c.constant);
};

for (const name of ['run', 'few'])
  test(`${name}: has the numbers that --json prints, and every row of the programme`, async () => {
    const { page, faults, close } = await open(name);
    const d = await documentOf(page);
    const printed = results[name];
    assert.deepEqual(d.results, { ...printed, rows_asked: 0, rows_reached: 0, rows: [] });
    assert.equal(d.rows_asked, printed.rows.length);
    const time = column(d, 'time_s');
    for (const row of printed.rows) {
      const at = time.reduce((best, t, k) => (Math.abs(t - row.time_s) < Math.abs(time[best] - row.time_s) ? k : best), 0);
      near(time[at], row.time_s, 1e-6, 'time');
      for (const key of Object.keys(row)) if (key !== 'time_s') near(column(d, key)[at], row[key], 2e-6, key);
    }
    const text = await page.textContent('main');
    const { force_N: force } = printed.highest_front_force;
    assert.ok(text.includes(`${force.toPrecision(4)} N`), `${force}`);
    assert.deepEqual(faults, []);
    await close();
  });

test('run: the highest force is marked where it was, beyond that at the end', async () => {
  const { page, close } = await open('run');
  await page.click('#forces button:text-is("SVG")'); // also saves without a fault
  const svg = await page.evaluate(() => document.querySelector('#forces .chart').innerHTML.length);
  assert.ok(svg > 100);
  const { results: r } = await documentOf(page);
  const { rows, columns } = await csvOf(page, 'forces');
  const at = columns.findIndex((c) => c.startsWith('force of a set, front set'));
  const highest = rows.reduce((best, row) => (Number(row[at]) > Number(best[at]) ? row : best));
  near(Number(highest[at]), r.highest_front_force.force_N, 1e-6, 'force');
  near(Number(highest[0]), r.highest_front_force.time_s, 1e-6, 'time');
  await close();
});

test('heat in is heat out and stored, at all times', async () => {
  const { page, close } = await open('few');
  const { rows } = await csvOf(page, 'heat');
  for (const row of rows) {
    const [friction, drive, coolant, air, machine, stored] = row.slice(1).map(Number);
    assert.ok(Math.abs(friction + drive - coolant - air - machine - stored) < 1e-3 * (1 + Math.abs(coolant)), row.join());
  }
  await close();
});

test('the cross-section is that of --field, to scale, at a choice of moments', async () => {
  raceway('spindle', seats, '--speed-profile', file('few.csv'), '-o', file('few_run.csv'), '--field', file('field.csv'));
  const field = readFileSync(file('field.csv'), 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).slice(1).map((line) => line.split(','));
  const { page, faults, close } = await open('few');
  const select = page.locator('#section select');
  const moments = await select.locator('option').allTextContents();
  assert.equal(moments.length, 12);
  assert.ok(moments.some((text) => text.includes('highest front force')));
  await select.selectOption({ index: moments.length - 1 });
  assert.match(await page.textContent('#section .note'), /^4\.00 h, 0 rpm, the end: /);
  const { rows } = await csvOf(page, 'section');
  assert.equal(rows.length, field.length);
  rows.forEach((row, k) => {
    const [position, radius, part, temperature] = field[k];
    assert.equal(row[0], part);
    near(Number(row[1]), Number(position), 1e-4, 'position');
    near(Number(row[2]), Number(radius), 1e-4, 'radius');
    assert.ok(Math.abs(Number(row[3]) - Number(temperature)) < 0.006, `${row[3]} ${temperature}`);
  });
  // A ball is round and as large as its diameter says.
  const { section } = await documentOf(page);
  const { cells, bearings } = section;
  const scale = await page.$eval('#section svg', (svg) => {
    const paths = [...svg.querySelectorAll('path')].filter((p) => (p.getAttribute('d') ?? '').includes('A'));
    return paths.map((p) => p.getBBox()).filter((b) => b.width > 12).map((b) => [b.width, b.height]);
  });
  assert.ok(scale.length >= bearings.length, `${scale.length} balls`);
  for (const [w, h] of scale) assert.ok(Math.abs(w - h) < 0.5, `${w} x ${h}`);
  assert.ok(Math.max(...cells.end_mm) === 375);
  assert.deepEqual(faults, []);
  await close();
});

test('steady: the table of bearings and the heat are those that the command prints', async () => {
  const { page, faults, close } = await open('steady');
  const [state] = results.steady.steady;
  const bars = await tableOf(page, 'heat');
  const sum = (direction) => bars.filter((row) => row[2] === direction).reduce((total, row) => total + row[1], 0);
  near(sum('in'), state.friction_power_W + state.drive_heat_W, 1e-6, 'in');
  near(sum('out'), sum('in'), 1e-6, 'out');
  const rings = await tableOf(page, 'temperatures');
  near(rings.find((row) => row[0] === 'front 1, inner ring')[1], state.front_1_inner_ring_temperature_C, 1e-6, 'ring');
  const table = await page.$$eval('#bearings tbody tr', (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.equal(table.length, 3);
  near(Number(table[2][3]), state.rear_1_force_N, 1e-3, 'force');
  assert.ok((await page.textContent('main')).includes(`${state.axial_stiffness_N_um.toPrecision(4)} N/µm`));
  assert.deepEqual(faults, []);
  await close();
});

const rms = (list) => Math.sqrt(list.reduce((sum, v) => sum + v * v, 0) / list.length);

test('compare: errors of each channel are those of --json, and of the rows behind the pictures', async () => {
  const { page, faults, close } = await open('compare');
  const printed = results.compare;
  assert.deepEqual((await documentOf(page)).results, printed);
  const bars = await tableOf(page, 'channels');
  assert.equal(bars.length, 7);
  printed.models[1].channels.forEach((c, k) => {
    assert.equal(bars[k][0], c.quantity.replaceAll('_', ' '));
    assert.deepEqual(bars[k].slice(2, 4), printed.models.map((m) => m.channels[k].rmse));
    assert.equal(bars[k][4], c.tolerance_um ?? c.tolerance_K);
  });
  assert.match(await page.textContent('#sentence'), /^7 of 7 channels within their tolerance with better\.toml; all together 1\.\d+ → 0\.\d+ times the tolerance/);
  assert.ok((await page.textContent('#steps')).includes('+ seat-conductance'));
  // Each channel can be chosen, and has its own rows.
  const channel = page.locator('#choices select').first();
  const offered = await channel.locator('option').allTextContents();
  assert.deepEqual(offered, printed.models[1].channels.map((c) => c.quantity.replaceAll('_', ' ')));
  for (const [k, label] of [[0, 'axial displacement'], [6, 'front outer ring temperature']]) {
    await channel.selectOption({ label });
    assert.ok((await page.textContent('#residual h3')).includes(label));
    const { columns, rows } = await csvOf(page, 'residual');
    const at = columns.findIndex((c) => c.startsWith(`better.toml, ${label}`));
    assert.ok(columns[at].endsWith(k === 0 ? '[µm]' : '[K]'), columns[at]);
    near(rms(rows.map((row) => Number(row[at]))), printed.models[1].channels[k].rmse, 1e-4, label);
    const over = await csvOf(page, 'over-time');
    assert.ok(over.columns.includes(`measured [${k === 0 ? 'µm' : '°C'}]`), over.columns.join());
  }
  assert.deepEqual(faults, []);
  await close();
});

test('diagnose: verdict, each channel before, after and held out, and effects in their order', async () => {
  const { page, faults, close } = await open('diagnose');
  const d = results.diagnose;
  assert.equal(await page.textContent('#verdict'), 'one effect');
  assert.equal(asPrinted(await page.textContent('#sentence')), d.headline);
  const bars = await tableOf(page, 'channels');
  d.channels.forEach((c, k) => assert.deepEqual(bars[k].slice(2, 5), [c.rmse_before, c.rmse_after, c.rmse_held_out_um ?? c.rmse_held_out_K]));
  const ladder = await tableOf(page, 'ladder');
  assert.deepEqual(ladder.slice(1).map((row) => row[0].replace(' (verdict)', '')), d.effects.map((e) => e.id));
  assert.ok(ladder[1][2] < 0.5 && ladder[0][2] > 1, `${ladder[1][2]} ${ladder[0][2]}`);
  // Errors that no fit saw are drawn, and are those of the table.
  const { models } = await documentOf(page);
  assert.equal(models.length, 14);
  near(rms(models[0].held_out.residual), d.channels[0].rmse_held_out_um, 0.02, 'held out');
  assert.deepEqual(faults, []);
  await close();
});

test('modes: every frequency is that of --json, crossings lie on their lines, shapes are those of --shapes', async () => {
  const { page, faults, close } = await open('modes');
  const { rows } = results.modes;
  const table = await csvOf(page, 'campbell');
  assert.deepEqual(table.rows.map((row) => [Number(row[0]), Number(row[2]), row[3]]), rows.flatMap((r) => r.modes.map((m) => [r.speed_rpm, m.frequency_Hz, m.whirl])));
  const crossings = await page.$$eval('.list tbody tr', (all) => all.map((row) => [...row.children].map((c) => c.textContent)).filter((cells) => /^[12]×$/.test(cells[0])));
  assert.ok(crossings.length > 0, 'twice per turn meets the first mode below 40 000 rpm');
  for (const [order, , speed, frequency] of crossings) near(Number(frequency), (parseInt(order, 10) * Number(speed)) / 60, 2e-3, 'crossing');
  raceway('modes', model, '--speed', '0', '--shapes', file('shapes.csv'));
  const shapes = readFileSync(file('shapes.csv'), 'utf8').split('\n').filter((line) => /^0,1,/.test(line)).map((line) => line.split(','));
  const drawn = await csvOf(page, 'shapes');
  assert.equal(drawn.rows.length, shapes.length);
  shapes.forEach((line, k) => {
    near(Number(drawn.rows[k][0]), Number(line[4]), 1e-4, 'position');
    assert.ok(Math.abs(Math.abs(Number(drawn.rows[k][1])) - Math.abs(Number(line[5]))) < 1e-4);
  });
  await page.locator('#shapes select').selectOption({ label: '40000 rpm' });
  assert.match(await page.textContent('#shapes .note'), /^At 40000 rpm/);
  assert.deepEqual(faults, []);
  await close();
});

test('modes: the diagram has the frequencies of every bearing and the path under an unbalance', async () => {
  const { page, faults, close } = await open('shaken');
  const { rows, crossings } = results.shaken;
  const listed = await page
    .locator('.list', { hasText: 'Crossings with modes' })
    .locator('tbody tr')
    .evaluateAll((all) => all.map((row) => [...row.children].map((c) => c.textContent)));
  assert.equal(listed.length, crossings.length);
  assert.ok(listed.some(([what]) => what === 'front 1 outer race'));
  assert.match(await page.textContent('#campbell'), /Thin lines: cage, outer-race and inner-race/);
  const path = await csvOf(page, 'unbalance');
  path.rows.forEach((row, k) => near(Number(row[1]), rows[k].nose_amplitude_um, 1e-4, 'nose'));
  assert.deepEqual(faults, []);
  await close();
});

test('steady: a roller bearing is drawn with its roller, and the assumptions are those of --json', async () => {
  const { page, faults, close } = await open('belt');
  const { section } = await documentOf(page);
  const rollers = section.bearings.filter((b) => b.roller_diameter_mm !== undefined);
  assert.equal(rollers.length, 1);
  assert.equal(section.bearings.length, 5);
  assert.ok(rollers[0].roller_length_mm > 0 && rollers[0].ball_diameter_mm === undefined);
  const { most } = results.belt.assumptions;
  const listed = await page.$$eval('#assumptions tbody tr', (all) => all.map((row) => row.children[0].textContent));
  assert.deepEqual(
    listed,
    most.map((one) => one.name),
  );
  assert.deepEqual(faults, []);
  await close();
});

test('deflection: the line goes through the displacement where the force acts, and rigid bearings leave less of it', async () => {
  const { page, faults, close } = await open('deflection');
  const r = results.deflection;
  const { rows } = await csvOf(page, 'line');
  near(Number(rows[0][1]), r.nose_displacement_um, 1e-4, 'nose');
  near(Number(rows[0][2]), r.tangent_displacement_um, 1e-4, 'tangent');
  assert.ok(Number(rows[0][3]) < Number(rows[0][1]) && Number(rows[0][3]) > 0, rows[0].join());
  const balls = await tableOf(page, 'balls');
  assert.deepEqual(balls.map((row) => row[2]), r.bearings.flatMap((b) => b.balls.map((ball) => ball.inner_load_N)));
  const table = await page.$$eval('#bearings tbody tr', (all) => all.map((row) => [...row.children].map((c) => c.textContent)));
  table.forEach((row, k) => near(Number(row[2]), r.bearings[k].radial_load_N, 1e-3, 'radial'));
  assert.deepEqual(faults, []);
  await close();
});

test('steps: gains and laws are those of --json, and the programme has the error that the command says', async () => {
  const { page, faults, close } = await open('steps');
  const r = results.steps;
  const gains = await tableOf(page, 'gain');
  assert.deepEqual(gains.map((row) => row.slice(1)), r.rows.map((row) => [row.power_end_W, row.K_um]));
  const { rows } = await csvOf(page, 'superposition');
  assert.equal(rows.length, r.superposition.rows);
  near(rms(rows.map((row) => Number(row[3]))), r.superposition.rms_um, 1e-4, 'rms');
  const { rows: courses } = await csvOf(page, 'courses');
  const last = courses.filter((row) => row[0] === '8000 rpm');
  near(rms(last.map((row) => Number(row[3]) - Number(row[2]))), r.rows[3].fit_rms_um, 1e-2, 'what one time constant leaves');
  near(rms(last.map((row) => Number(row[4]) - Number(row[2]))), r.rows[3].fit_rms_two_um, 5e-2, 'what two leave');
  assert.deepEqual(faults, []);
  await close();
});

test('loads: every step of a load is drawn, with the gains of --json', async () => {
  const { page, faults, close } = await open('loads');
  const of = (speed) => results.loads.load_rows.filter((row) => row.axial_load_N !== null && row.speed_rpm === speed).map((row) => row.K_um);
  const gains = await tableOf(page, 'axial-gain');
  assert.deepEqual(gains.map((row) => row[0]), [-500, 250, 500]);
  assert.deepEqual(gains.map((row) => row[1]), of(2000));
  assert.deepEqual(gains.map((row) => row[2]), of(6000));
  const { rows } = await csvOf(page, 'load-courses');
  assert.deepEqual([...new Set(rows.map((row) => row[0]))].slice(0, 2), ['−500 N axial, 2000 rpm', '250 N axial, 2000 rpm']);
  assert.deepEqual(faults, []);
  await close();
});

test('imported steps: names of load cases are data', async () => {
  const { page, faults, close } = await open('imported');
  assert.equal(await page.locator('main b').count(), 0);
  assert.ok((await page.textContent('main')).includes('<b>50</b>'));
  assert.deepEqual(faults, []);
  await close();
});

test('a run that ends early says when, why, and how much of it is there', async () => {
  writeFileSync(file('fast.csv'), 'time_s,speed_rpm\n0,0\n7200,30000\n');
  try {
    raceway('spindle', model, '--speed-profile', file('fast.csv'), '--report', file('runaway.html'));
    assert.fail('it should not converge');
  } catch (error) {
    assert.equal(error.status, 2);
  }
  const { page, faults, close } = await open('runaway');
  assert.equal(await page.textContent('#verdict'), 'thermal runaway');
  assert.match(await page.textContent('#sentence'), /ended after 1\d\.\d s: thermal runaway: the friction heat .*1 of 2 rows were computed/);
  assert.ok((await marks(page, 'nose')) > 5);
  assert.deepEqual(faults, []);
  await close();
});

test('names are data, never markup', async () => {
  const { page, faults, close } = await open('network');
  assert.equal(await page.locator('img').count(), 0);
  assert.ok((await page.textContent('#sentence')).includes('<img'));
  assert.deepEqual(faults, []);
  await close();
});

test('on paper no picture is cut, and each fits on a page', async () => {
  for (const name of ['run', 'steady', 'speeds', 'modes', 'deflection', 'steps', 'diagnose']) {
    const { page, faults, close } = await open(name);
    await page.emulateMedia({ media: 'print' });
    await page.waitForFunction(() => document.querySelector('figure.wide .chart > div').clientWidth === 676);
    for (const id of await figures(page)) {
      const { tall, drawn } = await page.$eval(`#${id}`, (figure) => ({ tall: figure.offsetHeight, drawn: figure.querySelector('.chart').offsetHeight }));
      assert.ok(tall < 1030, `${id}: ${tall}`); // A4 less its margins
      const lowest = await page.$eval(`#${id} .chart`, (chart) => Math.max(...[...chart.querySelectorAll('svg text')].map((t) => t.getBoundingClientRect().bottom - chart.getBoundingClientRect().top), 0));
      assert.ok(lowest <= drawn + 1, `${id}: text to ${lowest} of ${drawn}`);
    }
    assert.deepEqual(faults, []);
    await close();
  }
});
