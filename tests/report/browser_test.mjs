// Pages of rigs and shafts, written by the built program, in Chromium: see pages.mjs.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { asPrinted, csvOf, documentOf, figures, file, marks, notesOf, open, raceway, RACEWAY, results, ROOT, tableOf, write } from './pages.mjs';

const rig = join(ROOT, 'tests/hidden_effect/rigs/dev-03');
const model = join(rig, 'model.toml');
const train = join(rig, 'train.csv');
const spindle = join(ROOT, 'data/spindles/two_against_one.toml');

/// Displacement of a spindle whose grooves the model does not know, at three preloads, as a
/// transducer reads it.
function measureShaft() {
  const scatter = (k, preload) => 0.05 * (Math.sin(k * k + preload) + Math.sin(7.3 * k * k + 2 * preload));
  const text = readFileSync(spindle, 'utf8');
  writeFileSync(file('shaft.toml'), text.replace('[lubricant]', '[calibration]\nfree = ["outer_conformity"]\n\n[lubricant]'));
  const rows = (truth) => JSON.parse(raceway('displacement', file(truth), '--speed', '500:16000:500', '--json')).rows;
  const grown = ['speed_rpm,preload_N,axial_displacement_um'];
  for (const preload of [300, 900]) {
    writeFileSync(file('grown.toml'), text.replace('preload_N = 600', `preload_N = ${preload}`) + '\n[[effect]]\nid = "centrifugal-ring-growth"\ngrowth_at_10000_rpm_um = 2.0\n');
    rows('grown.toml').forEach((row, k) => grown.push(`${row.speed_rpm},${preload},${(row.axial_displacement_um + scatter(k, preload)).toFixed(4)}`));
  }
  writeFileSync(file('grown.csv'), grown.join('\n') + '\n');
  const lines = ['run_id,speed_rpm,preload_N,axial_displacement_um,std_um'];
  for (const preload of [300, 600, 1200]) {
    writeFileSync(file('truth.toml'), text.replace('preload_N = 600', `preload_N = ${preload}`).replace('outer_conformity = 0.52', 'outer_conformity = 0.53'));
    JSON.parse(raceway('displacement', file('truth.toml'), '--speed', '1000:16000:1000', '--json')).rows.forEach((row, k) => {
      lines.push(`p${preload},${row.speed_rpm},${preload},${(row.axial_displacement_um + scatter(k, preload)).toFixed(4)},0.05`);
    });
  }
  writeFileSync(file('shaft.csv'), lines.join('\n') + '\n');
}

before(async () => {
  write('diagnose', 'diagnose', model, train);
  write('add', 'add', model, 'lubricant-drag', '--data', train, '-o', file('better.toml'));
  raceway('calibrate', model, train, '-o', file('calibrated.toml'));
  write('compare', 'compare', model, file('calibrated.toml'), file('better.toml'), join(rig, 'test.csv'));
  write('table', 'table', file('better.toml'), '--speed', '0:16000:1000', '--axial-load', '600,3000', '--radial-load', '0,400', '--temperature', '25', '--data', train);
  write('shafttable', 'table', spindle, '--speed', '0:16000:1000', '--axial-load', '0,500');
  write('displacement', 'displacement', spindle, '--speed', '0:16000:250', '-o', file('kinematic.csv'));
  measureShaft();
  write('shaftdata', 'table', file('shaft.toml'), '--speed', '0:16000:1000', '--axial-load', '0', '--data', file('shaft.csv'));
  raceway('calibrate', file('shaft.toml'), file('shaft.csv'), '-o', file('fitted.toml'));
  write('comparedshaft', 'compare', file('shaft.toml'), file('fitted.toml'), file('shaft.csv'));
  write('shaftdiagnosis', 'diagnose', file('shaft.toml'), file('grown.csv'));
  write('shaftadded', 'add', file('shaft.toml'), 'centrifugal-ring-growth', '--data', file('grown.csv'));
  const fly = join(ROOT, 'data/measurements');
  raceway('calibrate', join(fly, 'flywheel.toml'), join(fly, 'flywheel_unloaded.csv'), '-o', file('fly.toml'));
  write('coastdown', 'diagnose', file('fly.toml'), join(fly, 'flywheel_unloaded.csv'));
  for (const [name, of] of [['several', 'dev-06'], ['nothing', 'dev-01']]) {
    const other = join(ROOT, 'tests/hidden_effect/rigs', of);
    write(name, 'diagnose', join(other, 'model.toml'), join(other, 'train.csv'));
  }
});

/// The first entry of a picture's legend.
async function legendEntry(page, id) {
  const index = await page.$eval(`#${id} svg`, (svg) => {
    const top = svg.getBoundingClientRect().top;
    return [...svg.querySelectorAll('text')].findIndex((t) => t.getBoundingClientRect().bottom - top < 24);
  });
  return page.locator(`#${id} svg text`).nth(index);
}

const expected = {
  diagnose: { ladder: 8, ranking: 12, share: 120, hidden: 18, parity: 120, 'residual-speed': 120, 'residual-axial-load': 120, 'residual-temperature': 120, 'residual-order-of-the-rows': 120, map: 24, plan: 120, detectable: 24 },
  add: { ladder: 8, parity: 120, 'residual-speed': 120, 'residual-axial-load': 120, 'residual-temperature': 120, 'residual-order-of-the-rows': 120, map: 24 },
  compare: { 'over-speed': 60, ladder: 3, parity: 60, 'residual-speed': 60, 'residual-axial-load': 60, 'residual-temperature': 60, 'residual-order-of-the-rows': 60, map: 15 },
  comparedshaft: { 'over-speed': 48, ladder: 2, parity: 48, 'residual-speed': 48, 'residual-preload': 48, 'residual-order-of-the-rows': 48, map: 24 },
  table: { stribeck: 34, parts: 51, angles: 136, balls: 68, around: 100 },
  shafttable: { stribeck: 33, parts: 51 },
  shaftdata: { stribeck: 16, position: 32, parts: 51 },
  displacement: { displacement: 11, 'law-residual': 11, forces: 22, stiffness: 11, 'contact-angles': 44, 'ball-loads': 44, pressures: 44, torque: 33, power: 33, heat: 44 },
  coastdown: { ladder: 1, ranking: 12, share: 41, hidden: 27, parity: 41, 'residual-speed': 41, 'residual-order-of-the-rows': 41, map: 8, plan: 41, detectable: 13 },
  several: { ladder: 8, ranking: 12, share: 120, hidden: 18, parity: 120, 'residual-speed': 120, 'residual-axial-load': 120, 'residual-temperature': 120, 'residual-order-of-the-rows': 120, map: 24, plan: 123, detectable: 20 },
  nothing: { ladder: 1, parity: 120, 'residual-speed': 120, 'residual-axial-load': 120, 'residual-temperature': 120, 'residual-order-of-the-rows': 120, map: 24, plan: 120, detectable: 20 },
};

for (const [name, least] of Object.entries(expected))
  test(`${name}: opens without a message or a request, every picture has its marks, on a phone as well`, async () => {
    const { page, faults, close } = await open(name);
    assert.deepEqual(await figures(page), Object.keys(least));
    const drawn = async () => {
      for (const [id, count] of Object.entries(least)) assert.ok((await marks(page, id)) >= count, `${id}: ${await marks(page, id)} of ${count}`);
    };
    await drawn();
    await page.setViewportSize({ width: 390, height: 844 });
    await page.waitForFunction(() => [...document.querySelectorAll('.chart > div')].every((chart) => chart.clientWidth < 390));
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, name);
    await drawn();
    assert.deepEqual(faults, []);
    await close();
  });

for (const name of Object.keys(expected))
  test(`${name}: names law, oil and defaults, and saves every picture as PNG and SVG`, async () => {
    const { page, faults, close } = await open(name);
    const assumed = await page.textContent('#assumed');
    for (const words of ['palmgren', 'mm²/s at 40 °C', 'solver.']) assert.ok(assumed.includes(words), `${words}: ${assumed}`);
    const ids = await figures(page);
    for (const kind of ['PNG', 'SVG']) assert.equal(await page.locator(`figure button:text-is("${kind}")`).count(), ids.length);
    // A browser takes ten downloads a second.
    for (const id of new Set([ids[0], ids[1], ids.at(-1)]))
      for (const [kind, starts] of [['PNG', '\x89PNG'], ['SVG', '<svg']]) {
        const waiting = page.waitForEvent('download');
        await page.click(`#${id} button:text-is("${kind}")`);
        const saved = await waiting;
        assert.equal(saved.suggestedFilename(), `${id}.${kind.toLowerCase()}`);
        assert.ok(readFileSync(await saved.path(), 'latin1').startsWith(starts), `${id}.${kind}`);
      }
    assert.deepEqual(faults, []);
    await close();
  });

test('table: every measured point is drawn, and the page counts them', async () => {
  const { page, close } = await open('table');
  const note = await page.textContent('#stribeck .note');
  const [, all, ...parts] = /Of (\d+) measured points, (\d+) lie within.*; (\d+) are colder.* and (\d+) warmer.*; (\d+) are at other loads/.exec(note).map(Number);
  assert.equal(all, 120);
  assert.equal(parts.reduce((sum, count) => sum + count, 0), all);
  assert.ok((await marks(page, 'stribeck')) >= 34 + all);
  await close();
});

for (const name of ['diagnose', 'add', 'compare', 'comparedshaft', 'coastdown'])
  test(`${name}: holds the document that --json prints, and shows its numbers`, async () => {
    const { page, faults, close } = await open(name);
    const { results: held, models } = await documentOf(page);
    const printed = results[name];
    assert.deepEqual(held, printed);
    const ladder = await tableOf(page, 'ladder');
    if (name.startsWith('compare')) {
      assert.deepEqual(ladder.map((row) => row.slice(1, 4)), printed.models.map((m) => [m.rmse, m.bias, m.fit_percent]));
    } else if (name === 'add') {
      assert.deepEqual(ladder.map((row) => row.slice(1)), [[printed.before.rmse, printed.after.rmse], ...printed.hold_out.map((h) => [h.rmse_before, h.rmse_after])]);
    } else {
      assert.equal(asPrinted(await page.textContent('#sentence')), printed.headline);
      assert.equal(asPrinted(await page.textContent('.more')), printed.sentence);
      const ranking = await tableOf(page, 'ranking');
      assert.deepEqual(ranking.map((row) => row.slice(0, 4)), printed.effects.map((e) => [e.id, e.in_verdict ? 'yes' : 'no', e.gain, e.rmse]));
      assert.equal((await tableOf(page, 'detectable')).length, printed.would_have_been_found.length);
      assert.ok((await marks(page, 'detectable')) >= printed.would_have_been_found.length);
    }
    // The rows behind the pictures give the error that the document names.
    const { columns, rows } = await csvOf(page, 'parity');
    const last = models.length - 1;
    const residual = columns.findIndex((c) => c.startsWith(`residual_${name === 'comparedshaft' ? 'um' : 'Nmm'}`)) + last;
    const rms = Math.sqrt(rows.reduce((sum, row) => sum + Number(row[residual]) ** 2, 0) / rows.length);
    // Seven digits of torques that are up to a hundred times their residual.
    assert.ok(Math.abs(rms / models[last].rmse - 1) < 1e-5, `${rms} ${models[last].rmse}`);
    assert.deepEqual(faults, []);
    await close();
  });

test('table: holds the numbers that --json prints', async () => {
  const { page, faults, close } = await open('table');
  const { columns, rows } = await csvOf(page, 'stribeck');
  assert.equal(rows.length, results.table.rows.length);
  const torque = columns.findIndex((c) => c.startsWith('friction torque'));
  results.table.rows.forEach((row, k) => {
    assert.ok(Math.abs(Number(rows[k][0]) - row.speed_rpm) <= 1e-6 * row.speed_rpm);
    assert.ok(Math.abs(Number(rows[k][torque]) / row.friction_torque_Nmm - 1) < 1e-6);
  });
  assert.deepEqual(faults, []);
  await close();
});

test('table of a shaft: measured displacement is drawn as it is, at the preload of the model', async () => {
  const { page, faults, close } = await open('shaftdata');
  const { measured, preload_N: preload } = await documentOf(page);
  const column = (name) => measured.rows.columns.find((c) => c.name === name);
  const lines = readFileSync(file('shaft.csv'), 'utf8').trim().split('\n').slice(1).map((line) => line.split(','));
  assert.equal(measured.quantity.unit, 'um');
  assert.deepEqual(column('measured_um').values, lines.map((cells) => Number(cells[3])));
  assert.equal(preload, 600);
  const told = new Set();
  await page.locator('#position .chart').scrollIntoViewIfNeeded();
  for (const [x, y] of await shapes(page, 'position')) {
    await page.mouse.move(x, y);
    await page.waitForTimeout(20);
    for (const text of await page.$$eval('#position .tip', (tips) => tips.map((t) => t.textContent))) told.add(text);
  }
  assert.ok([...told].some((text) => /measured, line \d+/.test(text)), [...told].join('; '));
  // Those at other preloads are drawn as well, and counted apart.
  const other = column('preload_N').values.filter((load) => Math.abs(load - preload) > 0.1 * preload).length;
  assert.match(await page.textContent('#position .note'), new RegExp(`; ${other} are at other loads`));
  assert.deepEqual(faults, []);
  await close();
});

test('displacement: holds the numbers that --json and fit-law print, and the law is that of its parameters', async () => {
  const { page, faults, close } = await open('displacement');
  const held = await documentOf(page);
  const printed = results.displacement;
  assert.deepEqual(held.results, { ...printed, rows: [] });
  const { columns, rows } = await csvOf(page, 'displacement');
  assert.equal(rows.length, printed.rows.length);
  const at = (name) => {
    const k = columns.indexOf(name);
    assert.ok(k >= 0, `${name} of ${columns}`);
    return (row) => Number(rows[row][k]);
  };
  const near = (value, wanted, what) => assert.ok(Math.abs(value - wanted) <= 1e-6 * Math.abs(wanted) + 1e-12, `${what}: ${value} ${wanted}`);
  const shaft = { axial_displacement_um: 'axial displacement [µm]', front_force_N: 'front force [N]', rear_force_N: 'rear force [N]', axial_stiffness_N_um: 'axial stiffness [N/µm]', friction_torque_Nmm: 'friction torque [N mm]', power_loss_W: 'power loss [W]' };
  const bearing = { axial_load_N: 'axial load [N]', inner_contact_angle_deg: 'inner contact angle [°]', outer_contact_angle_deg: 'outer contact angle [°]', inner_load_N: 'inner load [N]', outer_load_N: 'outer load [N]', inner_contact_pressure_MPa: 'inner contact pressure [MPa]', outer_contact_pressure_MPa: 'outer contact pressure [MPa]', friction_torque_Nmm: 'friction torque [N mm]', power_loss_W: 'power loss [W]', inner_ring_heat_W: 'inner ring heat [W]', outer_ring_heat_W: 'outer ring heat [W]' };
  printed.rows.forEach((row, k) => {
    near(at('speed [rpm]')(k), row.speed_rpm, 'speed');
    for (const [key, name] of Object.entries(shaft)) near(at(name)(k), row[key], `${key} ${k}`);
    for (const b of row.bearings) for (const [key, name] of Object.entries(bearing)) near(at(`${b.place.replace('_', ' ')} ${name}`)(k), b[key], `${b.place} ${key} ${k}`);
  });
  // fit-law of the curve that the same command wrote.
  const law = JSON.parse(raceway('fit-law', file('kinematic.csv'), '--json'));
  const close_to = (value, wanted, what) => assert.ok(Math.abs(value / wanted - 1) < 1e-5, `${what}: ${value} ${wanted}`);
  for (const name of ['A', 'B', 'C']) close_to(held.law.parameters[name].value, law.parameters[name].value, name);
  for (const key of ['mae_um', 'max_abs_um', 'max_abs_at_rpm', 'rows']) close_to(held.law[key], law[key], key);
  const { A, B, C } = Object.fromEntries(Object.entries(held.law.parameters).map(([name, p]) => [name, p.value]));
  const u = (n) => (n === 0 ? 0 : A * n ** (1 - B * Math.exp(-C * n)));
  const table = await tableOf(page, 'law-residual');
  let sum = 0;
  printed.rows.forEach((row, k) => {
    assert.ok(Math.abs(table[k][1] - (u(row.speed_rpm) - row.axial_displacement_um)) < 1e-6, `residual at ${row.speed_rpm}`);
    if (row.speed_rpm > 0) sum += Math.abs(table[k][1]);
  });
  close_to(sum / law.rows, law.mae_um, 'mean absolute error');
  assert.deepEqual(await page.$$eval('#warnings li', (all) => all.map((li) => li.textContent)), printed.judgement.map((j) => j.text));
  assert.deepEqual(faults, []);
  await close();
});

test('displacement: warnings stand on the page as the command says them, and without a law it says why', async () => {
  const told = spawnSync(RACEWAY, ['displacement', spindle, '--speed', '0:15000:7500', '--axial-load', '1200', '--report', file('loaded.html')], { encoding: 'utf8' });
  const said = told.stderr.split('\n').filter((line) => /minimum load|no contact|mounted preload/.test(line)).map((line) => line.replace('warning: ', ''));
  assert.ok(said.length > 0, told.stderr);
  const { page, faults, close } = await open('loaded');
  assert.deepEqual(await page.$$eval('#warnings li', (all) => all.map((li) => li.textContent)), said);
  assert.match(await page.textContent('#law-statement'), /^No law was fitted: 2 different speeds above zero: .*needs at least 4\.$/);
  assert.equal(await page.locator('#law-residual').count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test('compare: the ladder shows every model in its order against the noise, and what each has that the last had not', async () => {
  const { page, faults, close } = await open('compare');
  const { steps } = await documentOf(page);
  const { models } = results.compare;
  assert.equal(models[0].noise.rms, null);
  // The page states what the JSON states.
  const noise = models[models.length - 1].noise.estimated_rms;
  // The rows have 2 % of noise; a diagnosis of other rows of the same rig finds 10.1 N mm.
  assert.ok(Math.abs(noise / results.diagnose.noise.rms - 1) < 0.3, `${noise}`);
  assert.deepEqual((await tableOf(page, 'ladder')).map((row) => [row[1], row[4]]), models.map((m) => [m.rmse, m.rmse / noise]));
  assert.ok(models[0].rmse > models[1].rmse && models[1].rmse > models[2].rmse);
  assert.deepEqual(steps.map((s) => s.added), [[], ['lubricant-drag']]);
  const told = await page.$$eval('#steps tbody tr', (rows) => rows.map((r) => r.lastChild.textContent));
  assert.match(told[0], /^f0 2 → 1\.6\d+, z 0\.0008 → 0\.0009\d+$/);
  assert.match(told[1], /^\+ lubricant-drag, f0 1\.6\d+ → 1\.498, z .*, lubricant-drag\.torque_at_10000_rpm_Nmm = 65\.11 N mm$/);
  assert.match(asPrinted(await page.textContent('#sentence')), /^better\.toml has the smallest error: RMS error 69\.94 -> 11\.72 N mm; noise/);
  assert.deepEqual(faults, []);
  await close();
});

test('compare: a worse model behind the best one does not lead the page', async () => {
  write('worselast', 'compare', file('better.toml'), model, join(rig, 'test.csv'));
  const { page, faults, close } = await open('worselast');
  assert.match(asPrinted(await page.textContent('#sentence')), /^better\.toml has the smallest error: RMS error 11\.72 N mm, model\.toml 69\.94 N mm; noise/);
  assert.match(await page.textContent('.facts'), /RMS error11\.72 N mm/);
  assert.deepEqual(faults, []);
  await close();
});

test('compare of a shaft: everything is in µm, over the inputs that it has', async () => {
  const { page, faults, close } = await open('comparedshaft');
  const text = await page.evaluate(() => (document.querySelectorAll('#assumed, ul.notes').forEach((part) => part.remove()), document.body.innerText) + [...document.querySelectorAll('svg text')].map((t) => t.textContent).join(' '));
  assert.doesNotMatch(text, /N mm|radial|torque/);
  assert.match(text, /measured \[µm\]/);
  assert.match(text, /preload \[N\]/);
  const { models } = results.comparedshaft;
  assert.equal(models[0].unit, 'um');
  assert.match(await page.textContent('#steps'), /outer_conformity 0\.52 → 0\.53/);
  // Rows as the file has them.
  const { columns, rows } = await csvOf(page, 'parity');
  const file_rows = readFileSync(file('shaft.csv'), 'utf8').trim().split('\n').slice(1).map((line) => line.split(','));
  assert.equal(rows.length, file_rows.length);
  rows.forEach((row, k) => {
    assert.deepEqual(['run', 'speed_rpm', 'preload_N', 'measured_um', 'std_um'].map((c) => row[columns.indexOf(c)]), file_rows[k].map((v) => (v.startsWith('p') ? v : String(Number(v)))));
  });
  assert.deepEqual(faults, []);
  await close();
});

for (const name of ['shaftdiagnosis', 'shaftadded'])
  test(`${name}: the loop on the displacement of a shaft is in µm as well`, async () => {
    const { page, faults, close } = await open(name);
    const { results: held } = await documentOf(page);
    assert.deepEqual(held, results[name]);
    assert.equal(held.unit, 'um');
    const shown = await page.evaluate(() => document.body.innerText + [...document.querySelectorAll('svg text')].map((t) => t.textContent).join(' '));
    assert.doesNotMatch(shown, /N mm|radial load/);
    assert.match(shown, /µm/);
    for (const id of await figures(page)) assert.ok((await marks(page, id)) >= 1, id);
    assert.ok((await marks(page, 'parity')) >= 64);
    if (name === 'shaftdiagnosis') {
      assert.ok(held.effects.length > 1 && held.effects.some((e) => e.id === 'centrifugal-ring-growth'));
      assert.match(shown, /share of the displacement/);
      assert.ok((await page.locator('#effect option').count()) >= 2);
      const options = await page.$$eval('#effect option', (all) => all.map((o) => o.textContent));
      await page.locator('#effect select').selectOption({ index: options.findIndex((o) => o.startsWith('centrifugal-ring-growth')) });
      assert.match(await page.textContent('#base-parameters'), /outer_conformity/);
    }
    assert.deepEqual(faults, []);
    await close();
  });

test('any effect of the ranking can be chosen, to see its share and the part that the base parameters hide', async () => {
  const { page, faults, close } = await open('diagnose');
  const { explanations, rows } = await documentOf(page);
  const { effects } = results.diagnose;
  const options = await page.$$eval('#effect option', (all) => all.map((o) => o.textContent.split(' ')[0]));
  assert.deepEqual(options, effects.map((e) => e.id));
  const column = (name) => rows.columns.find((c) => c.name === name).values;
  const measured = column('measured_Nmm');
  for (const [k, effect] of [[1, effects[1]], [5, effects[5]]]) {
    const before = await page.$eval('#share svg', (svg) => svg.outerHTML);
    await page.locator('#effect select').selectOption(String(k));
    assert.notEqual(await page.$eval('#share svg', (svg) => svg.outerHTML), before);
    const [total, base, one] = [explanations[k].total, explanations[k].base, explanations[k].effects[0].column].map(column);
    const rms = Math.sqrt(measured.reduce((sum, m, i) => sum + (total[i] - m) ** 2, 0) / measured.length);
    assert.ok(Math.abs(rms / effect.rmse - 1) < 1e-4, `${effect.id}: ${rms} ${effect.rmse}`);
    const table = await tableOf(page, 'share');
    table.forEach((row, i) => {
      const [torque, of, share] = row.slice(-3);
      assert.ok(Math.abs(torque - one[i]) < 1e-9 && Math.abs(of - total[i]) < 1e-9 && Math.abs(share - (100 * one[i]) / total[i]) < 1e-9);
      assert.ok(Math.abs(total[i] - base[i] - one[i]) < 1e-6 * total[i]);
    });
    const shown = await page.$$eval('#base-parameters tbody tr', (all) => all.map((r) => [...r.children].slice(0, 3).map((c) => c.textContent)));
    assert.deepEqual(shown.map((r) => r[0]), Object.keys(effect.base_parameters));
    const near = (text, value) => assert.ok(Math.abs(Number(text.replace(/−/g, '-')) - value) <= 6e-4 * Math.abs(value), `${effect.id}: ${text} ${value}`);
    for (const [name, without, with_it] of shown) {
      near(without, effect.base_parameters[name].before);
      near(with_it, effect.base_parameters[name].after);
    }
    assert.ok((await page.textContent('#hidden .note')).startsWith(`Refitted without and with ${effect.id}: `));
  }
  assert.deepEqual(faults, []);
  await close();
});

test('a click on a legend entry takes its marks away, another brings them back', async () => {
  const { page, faults, close } = await open('diagnose');
  for (const id of ['parity', 'residual-speed', 'ranking', 'share']) {
    const before = await marks(page, id);
    const entry = await legendEntry(page, id);
    await entry.scrollIntoViewIfNeeded();
    await entry.click();
    await eventually(page, async () => (await marks(page, id)) < before, `${id}: ${before}`);
    await (await legendEntry(page, id)).click();
    await eventually(page, async () => (await marks(page, id)) === before, `${id}: again`);
  }
  assert.deepEqual(faults, []);
  await close();
});

/// Centres of some of the marks of a picture in the window.
const markPlaces = (page, id) =>
  page.$$eval(`#${id} svg path`, (paths) =>
    paths
      .filter((p) => !['none', 'transparent', null].includes(p.getAttribute('fill')))
      .map((p) => p.getBoundingClientRect())
      .filter((box) => box.width > 4 && box.width < 12 && box.top > paths[0].ownerSVGElement.getBoundingClientRect().top + 60)
      .filter((_, k) => k > 8 && k % 5 === 0)
      .map((box) => [box.x + box.width / 2, box.y + box.height / 2]),
  );

test('hovering over a mark shows its row as it stands in the file', async () => {
  const { page, faults, close } = await open('diagnose');
  await page.locator('#residual-temperature').scrollIntoViewIfNeeded();
  const places = await markPlaces(page, 'residual-temperature');
  const lines = readFileSync(train, 'utf8').split('\n');
  const column = lines[0].split(',');
  const seen = [];
  for (const [x, y] of places) {
    await page.mouse.move(x, y);
    await page.waitForTimeout(30);
    const tip = await page.$$eval('#residual-temperature .tip', (tips) => tips.filter((t) => t.checkVisibility({ visibilityProperty: true, opacityProperty: true })).map((t) => [...t.children].map((c) => c.textContent)));
    if (!tip.length) continue;
    const line = Number(tip[0][0].replace('line ', ''));
    const fields = lines[line - 1].split(',');
    const told = (label) => parseFloat(tip[0][tip[0].indexOf(label) + 1]);
    assert.equal(told('speed'), Number(fields[column.indexOf('speed_rpm')]));
    assert.ok(Math.abs(told('measured') / Number(fields[column.indexOf('friction_torque_Nmm')]) - 1) < 1e-3);
    seen.push([told('temperature'), x]);
  }
  assert.ok(seen.length >= 10, `${seen.length} of ${places.length} marks answered`);
  // It is the row of that mark, or of one that covers it: places on the axis follow the temperatures
  // told. Levels are 60 pixels apart.
  seen.sort((a, b) => a[0] - b[0]);
  const [low, high] = [seen[0], seen[seen.length - 1]];
  assert.ok(high[0] - low[0] > 1);
  for (const [value, x] of seen) assert.ok(Math.abs(low[1] + ((value - low[0]) / (high[0] - low[0])) * (high[1] - low[1]) - x) < 12, `${value} at ${x}`);
  assert.deepEqual(faults, []);
  await close();
});

/// Filled shapes of a picture below its legend, evenly picked.
const shapes = (page, id) =>
  page.$$eval(`#${id} svg path`, (paths) => {
    const top = paths[0].ownerSVGElement.getBoundingClientRect().top;
    const all = paths
      .filter((p) => !['none', 'transparent', null].includes(p.getAttribute('fill')) && p.getAttribute('fill-opacity') !== '0')
      .map((p) => p.getBoundingClientRect())
      .filter((box) => box.width > 2 && box.height > 2 && box.top > top + 46)
      .map((box) => [box.x + box.width / 2, box.y + box.height / 2]);
    return all.filter((_, k) => k % Math.ceil(all.length / 10) === 0);
  });

/** A picture is drawn anew when the browser comes to it: on a loaded machine not at once. */
async function eventually(page, holds, what) {
  for (let waited = 0; waited < 10000; waited += 50) {
    if (await holds()) return;
    await page.waitForTimeout(50);
  }
  assert.fail(what);
}

for (const name of ['add', 'comparedshaft', 'table', 'displacement', 'several'])
  test(`${name}: every picture tells numbers under the pointer, and its legend takes marks away`, async () => {
    const { page, faults, close } = await open(name);
    for (const id of await figures(page)) {
      await page.locator(`#${id} .chart`).scrollIntoViewIfNeeded();
      const told = new Set();
      for (const [x, y] of await shapes(page, id)) {
        await page.mouse.move(x, y);
        await page.waitForTimeout(20);
        for (const text of await page.$$eval(`#${id} .tip`, (tips) => tips.map((t) => t.textContent))) told.add(text);
      }
      assert.ok(told.size >= 1, `${id}: nothing told`);
      for (const text of told) {
        assert.match(text, /\d/, id);
        assert.doesNotMatch(text, /NaN|undefined|null/, id);
      }
      if (['map', 'detectable'].includes(id) || (id === 'ladder' && name === 'comparedshaft')) continue; // without legend
      await page.mouse.move(2, 2);
      const before = await marks(page, id);
      await (await legendEntry(page, id)).click();
      await eventually(page, async () => (await marks(page, id)) < before, `${id}: the legend`);
      await (await legendEntry(page, id)).click();
      await eventually(page, async () => (await marks(page, id)) === before, `${id}: the legend again`);
    }
    assert.deepEqual(faults, []);
    await close();
  });

test('the points to measure next are drawn into the plan', async () => {
  const { page, faults, close } = await open('several');
  const next = results.several.suggested_measurements;
  assert.ok(next.length > 0);
  assert.deepEqual((await tableOf(page, 'plan')).map((row) => row.slice(0, 5)), next.map((m) => [m.speed_rpm, m.axial_load_N, m.radial_load_N, m.temperature_C, m.repeats]));
  const words = await page.$$eval('#plan svg text', (all) => all.map((t) => t.textContent));
  for (const m of next) assert.ok(words.includes(`${m.repeats}×`), `${m.repeats}×`);
  assert.deepEqual(faults, []);
  await close();
});

test('another model and another colour change the pictures', async () => {
  const { page, faults, close } = await open('diagnose');
  const picture = () => page.$eval('#residual-speed svg', (svg) => svg.outerHTML);
  const first = await picture();
  await page.locator('#of-rows select').first().selectOption('1');
  const second = await picture();
  assert.notEqual(second, first);
  await page.locator('#of-rows select').nth(1).selectOption('1');
  assert.notEqual(await picture(), second);
  assert.deepEqual(faults, []);
  await close();
});

test('names with markup in them stay text on every kind of page', async () => {
  const evil = '<img src=x onerror=alert(1)>';
  const end = '</script><script>alert(2)</script>';
  const other = '${x}<svg onload=alert(3)>';
  const effect = '<b>mine</b>';
  const bearing = '<h1>7014</h1>';
  const toml = file(`m"${evil}.toml`);
  writeFileSync(
    toml,
    readFileSync(model, 'utf8').replace('name = "7014"', `name = "${bearing}"`) +
      `\n[[effect]]\nid = "${effect}"\ntorque_Nmm = "c * (speed_rpm < 9000)"\nc = { value = 0.0, unit = "${evil}" }\n`,
  );
  // Two runs with names that would end the data early, and be markup after that; a column that is not known.
  const [head, ...rows] = readFileSync(train, 'utf8').trim().split('\n');
  const csv = file(`d${evil}.csv`);
  writeFileSync(csv, [`${head},${end}`, ...rows.map((row, k) => row.replace(/^[^,]*/, k < 60 ? `${end}${evil}` : other) + ',1')].join('\n') + '\n');
  const shaft = file(`s"${evil}.toml`);
  writeFileSync(shaft, readFileSync(file('shaft.toml'), 'utf8').replace(/name = ".*"/, `name = "${bearing}"`));
  const moved = file(`u${evil}.csv`);
  writeFileSync(moved, readFileSync(file('shaft.csv'), 'utf8').replace(/^p300/gm, `${end}${evil}`).replace(/^p\d+/gm, other));
  const pages = {
    hostile_compare: ['compare', toml, csv],
    hostile_diagnose: ['diagnose', toml, csv, '--no-pairs'],
    hostile_add: ['add', toml, effect, '--data', csv, '--force'],
    hostile_table: ['table', toml, '--speed', '0:9000:1000', '--axial-load', '100,900', '--data', csv],
    hostile_displacement: ['displacement', shaft, '--speed', '0:9000:1000'],
    hostile_shaft: ['compare', shaft, moved],
  };
  for (const [name, words] of Object.entries(pages)) {
    raceway(...words, '--report', file(`${name}.html`));
    const { page, faults, close } = await open(name);
    const whole = async () => {
      for (const tag of ['img', 'main b:not(.tip b)', 'script[src]', 'iframe', 'object', 'svg[onload]', 'h1 h1']) assert.equal(await page.locator(tag).count(), 0, `${name}: ${tag}`);
      assert.equal(await page.locator('script').count(), 2);
      assert.equal(await page.locator('h1').count(), 1);
      assert.deepEqual(faults, [], name);
    };
    await whole();
    assert.ok((await page.textContent('header')).includes(evil), name);
    for (const id of await figures(page)) await page.$eval(`#${id} details`, (d) => (d.open = true));
    const svg = (id) => page.$$eval(`#${id} svg text`, (all) => all.map((t) => t.textContent).join('\n'));
    if (['hostile_table', 'hostile_displacement'].includes(name)) assert.ok((await page.textContent('#sentence')).includes(bearing), name);
    else {
      await page.locator('#of-rows select').last().selectOption({ label: 'run' });
      assert.ok((await svg('residual-speed')).includes(other), name);
      await page.locator('#residual-speed svg').scrollIntoViewIfNeeded();
      const told = [];
      for (const [x, y] of await markPlaces(page, 'residual-speed')) {
        await page.mouse.move(x, y);
        await page.waitForTimeout(20);
        told.push(...(await page.$$eval('#residual-speed .tip', (tips) => tips.map((t) => t.textContent))));
      }
      assert.ok(told.length > 0 && told.every((t) => t.includes(other) || t.includes(end)), `${name}: ${told}`);
    }
    if (name === 'hostile_diagnose') {
      await page.locator('#effect select').selectOption({ label: (await page.$$eval('#effect option', (all) => all.map((o) => o.textContent))).find((t) => t.startsWith(effect)) });
      assert.ok((await page.textContent('#base-parameters')).includes(effect));
      assert.ok((await page.textContent('#ranking table')).includes(effect));
    }
    if (name === 'hostile_add') assert.ok((await page.textContent('#sentence')).includes(effect));
    if (name === 'hostile_table') assert.ok((await svg('parts')).includes(effect));
    await whole();
    await close();
  }
});

test('no cell of a CSV is a formula to a spreadsheet', async () => {
  const [head, ...rows] = readFileSync(train, 'utf8').trim().split('\n');
  writeFileSync(file('formula.csv'), [head, ...rows.map((row, k) => row.replace(/^[^,]*/, k < 60 ? '=1+1' : '@x'))].join('\n') + '\n');
  write('formula', 'compare', model, file('formula.csv'));
  const { page, close } = await open('formula');
  const cells = (await csvOf(page, 'residual-speed')).rows.flat();
  for (const run of ['=1+1', '@x']) {
    assert.ok(cells.includes(`'${run}`));
    assert.ok(!cells.includes(run));
  }
  await close();
});

test('the policy of the page lets nothing else run, load or be sent', async () => {
  const { page, close } = await open('diagnose');
  const done = await page.evaluate(async () => {
    const script = document.createElement('script');
    script.textContent = 'window.ran = true';
    document.body.append(script);
    const box = document.createElement('div');
    box.innerHTML = '<img src=x onerror="window.ran = true"><p style="color: red">x</p>';
    document.body.append(box);
    const sent = await fetch('https://example.org/').then(() => 'sent', () => 'refused');
    await new Promise((resolve) => setTimeout(resolve, 100));
    return { ran: window.ran === true, sent, colour: getComputedStyle(box.querySelector('p')).color };
  });
  assert.equal(done.ran, false);
  assert.equal(done.sent, 'refused');
  assert.notEqual(done.colour, 'rgb(255, 0, 0)');
  await close();
});

test('prints without empty halves of pages, and lines differ by more than their colour', async () => {
  const { page, faults, close } = await open('diagnose');
  await page.emulateMedia({ media: 'print' });
  await page.waitForFunction(() => document.querySelector('#parity svg').getAttribute('width') === '312');
  const paper = await page.evaluate(() => {
    const lines = [...document.querySelectorAll('#hidden svg path')].filter((p) => p.getAttribute('fill') === 'none' && p.getBBox().width > 100 && p.getBBox().height > 5);
    return { dashes: lines.map((p) => p.getAttribute('stroke-dasharray')), symbols: new Set([...document.querySelectorAll('#parity svg path')].map((p) => p.getAttribute('d'))).size };
  });
  assert.equal(new Set(paper.dashes).size, 3, `${paper.dashes}`);
  assert.ok(paper.symbols >= 5, `${paper.symbols}`);
  const pdf = (await page.pdf({ preferCSSPageSize: true, format: 'A4' })).toString('latin1');
  const pages = [...pdf.matchAll(/\/Type\s*\/Page\b/g)].length;
  // All that is on the page, one below the other on sheets of 190 mm by 275 mm.
  await page.setViewportSize({ width: 718, height: 1039 });
  const sheets = (await page.evaluate(() => document.querySelector('main').getBoundingClientRect().height)) / 1039;
  assert.ok(pages >= sheets && pages < 1.35 * sheets + 0.5, `${pages} pages of ${sheets.toFixed(1)}`);
  assert.deepEqual(faults, []);
  await close();
});

test('follows a dark screen, and prints in two columns on white', async () => {
  const dark = await open('diagnose', { colorScheme: 'dark' });
  const paper = () => dark.page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const ink = async () => (await legendEntry(dark.page, 'parity')).getAttribute('fill');
  assert.equal(await paper(), 'rgb(15, 20, 25)');
  assert.equal(await ink(), '#e8edf2');
  await dark.page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  await dark.page.waitForFunction(() => document.querySelector('#parity svg').getAttribute('width') === '312');
  assert.equal(await paper(), 'rgb(255, 255, 255)');
  assert.equal(await ink(), '#1b2430');
  assert.ok((await marks(dark.page, 'parity')) >= 120);
  assert.equal(await dark.page.locator('#parity .csv').isVisible(), false);
  assert.deepEqual(dark.faults, []);
  await dark.close();
});

test('120 000 rows: under 15 MB, soon open, and the page says what it draws', async () => {
  const rows = ['run_id,time_s,speed_rpm,axial_load_N,radial_load_N,temperature_C,friction_torque_Nmm,std_Nmm'];
  for (let k = 0; k < 120000; ++k) {
    const speed = 500 + ((k * 7919) % 15500) + (k % 97) / 100;
    const load = [250, 600, 1400, 3000][k % 4] + (k % 13);
    const temperature = 25 + ((k * 31) % 4000) / 100;
    rows.push([Math.floor(k / 20000), k / 2, speed, load, (k % 2) * 200, temperature, (0.11 * (20 * speed) ** (2 / 3) + load / 10 + ((k * 17) % 29) - 14).toFixed(3), (5 + speed / 1000).toFixed(3)].join(','));
  }
  writeFileSync(file('big.csv'), rows.join('\n') + '\n');
  raceway('compare', model, file('big.csv'), '--report', file('big.html'));
  assert.ok(statSync(file('big.html')).size < 15e6);
  // The time that the page's own thread works, which others at work on the machine do not stretch.
  let devtools;
  const start = performance.now();
  const { page, faults, close } = await open('big', {}, async (of) => {
    devtools = await of.context().newCDPSession(of);
    await devtools.send('Performance.enable', { timeDomain: 'threadTicks' });
  });
  const seconds = (performance.now() - start) / 1000;
  const { metrics } = await devtools.send('Performance.getMetrics');
  const worked = metrics.find((m) => m.name === 'TaskDuration').value;
  console.log(`120 000 rows: ${(statSync(file('big.html')).size / 1e6).toFixed(1)} MB, all drawn after ${seconds.toFixed(1)} s, of which its thread worked ${worked.toFixed(1)} s`);
  assert.ok(worked > 0.1 && worked < 3, `${worked} s`);
  const note = await page.textContent('#thinned');
  assert.match(note, /holds 10\d{4} of 120000 rows/);
  assert.match(note, /draw about 3000 of 10\d{4}/);
  for (const id of await figures(page)) assert.ok((await marks(page, id)) >= 1, id);
  const held = await documentOf(page);
  assert.equal(held.results.rows, 120000);
  assert.deepEqual(faults, []);
  await close();
});

test('the same inputs give the same bytes, and a page is replaced only by --force', () => {
  const commands = {
    diagnose: ['diagnose', model, train],
    add: ['add', model, 'lubricant-drag', '--data', train],
    compare: ['compare', model, file('calibrated.toml'), file('better.toml'), join(rig, 'test.csv')],
    comparedshaft: ['compare', file('shaft.toml'), file('fitted.toml'), file('shaft.csv')],
    table: ['table', file('better.toml'), '--speed', '0:16000:1000', '--axial-load', '600,3000', '--radial-load', '0,400', '--temperature', '25', '--data', train],
    displacement: ['displacement', spindle, '--speed', '0:16000:250'],
  };
  for (const [name, command] of Object.entries(commands)) {
    const page = file(`${name}-again.html`);
    raceway(...command, '--report', page);
    const bytes = readFileSync(page);
    assert.ok(bytes.equals(readFileSync(file(`${name}.html`))), name);
    const refused = spawnSync(RACEWAY, [...command, '--report', page], { encoding: 'utf8' });
    assert.equal(refused.status, 1, name);
    assert.match(refused.stderr, /exists already; --force replaces it/);
    writeFileSync(page, 'of another day');
    assert.equal(spawnSync(RACEWAY, [...command, '--report', page]).status, 1);
    assert.equal(readFileSync(page, 'utf8'), 'of another day', name);
    raceway(...command, '--report', page, '--force');
    assert.ok(readFileSync(page).equals(bytes), name);
  }
});

test('what was said of a record stands on its pages', async () => {
  for (const name of ['coastdown', 'comparedshaft', 'shaftadded']) {
    const { notes } = results[name];
    assert.ok(notes.length > 0, name);
    const { page, close } = await open(name);
    const shown = await notesOf(page);
    for (const note of notes) assert.ok(shown.includes(note), `${name}: ${note}`);
    await close();
  }
});
