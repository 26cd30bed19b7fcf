// How fast the workbench is, and how much memory it takes: the numbers of docs/workbench.md, of the page with its engine, opened from the disk.
//   node tests/workbench/measure.mjs [rig] [million]
// Environment: RACEWAY, CHROMIUM, PACKAGES, ROOT and WORKBENCH, as scripts/workbench sets them.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { file, ROOT, visit } from '../report/pages.mjs';
import { idle } from './steps.mjs';

const address = pathToFileURL(process.env.WORKBENCH).href;
const rig = join(ROOT, 'tests/hidden_effect/rigs/dev-03');
const wanted = process.argv.slice(2);
const seconds = (ms) => `${(ms / 1000).toFixed(2)} s`;
const say = (text) => console.log(`${text} (load average ${loadavg()[0].toFixed(1)})`);

/// Proportional memory of all processes that this one has started [bytes]: the browser with its pages.
function memory() {
  const parents = new Map();
  for (const pid of readdirSync('/proc').filter((name) => /^\d+$/.test(name)))
    try {
      parents.set(pid, readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) \S+ /s, '').split(' ')[0]);
    } catch {
      // It has ended.
    }
  const ours = (pid) => pid !== undefined && (pid === String(process.pid) || ours(parents.get(pid)));
  let sum = 0;
  for (const pid of parents.keys())
    try {
      if (pid !== String(process.pid) && ours(pid)) sum += 1024 * Number(/^Pss:\s*(\d+)/m.exec(readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8'))[1]);
    } catch {
      // The same.
    }
  return sum;
}

/// Counts the longest time in which the page could do nothing else [ms].
const watchGaps = (page) =>
  page.evaluate(() => {
    let last = performance.now();
    window.longestGap = 0;
    setInterval(() => {
      const now = performance.now();
      window.longestGap = Math.max(window.longestGap, now - last);
      last = now;
    }, 5);
  });

const until = (page, condition) => page.waitForFunction(condition, undefined, { timeout: 900000, polling: 10 });

if (wanted.length === 0 || wanted.includes('rig'))
  test('a rig', async () => {
    for (let k = 0; k < 3; ++k) {
      let since = performance.now();
      const { page, close } = await visit(address);
      await until(page, () => document.getElementById('add-0'));
      const recorded = performance.now() - since;
      await until(page, () => !document.getElementById('stale'));
      const own = performance.now() - since;
      await idle(page);
      const drawn = await page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0].startTime);
      say(`opened from the disk: first picture ${seconds(drawn)}, recorded verdict ${seconds(recorded)}, the engine's own ${seconds(own)}`);
      since = performance.now();
      await page.setInputFiles('#file', [join(rig, 'model.toml'), join(rig, 'train.csv')]);
      await until(page, () => /train\.csv/.test(document.querySelector('.verdict .eyebrow')?.textContent) && !document.getElementById('stale'));
      const verdict = performance.now() - since;
      await idle(page);
      say(`120 rows and a model dropped: verdict ${seconds(verdict)}, with all base laws ${seconds(performance.now() - since)}`);
      await page.click('#step-missing');
      const [moved, all] = await page.evaluate(async () => {
        const bar = document.querySelector('#error-bars .bar-now');
        const before = bar.style.width;
        const since = performance.now();
        document.getElementById('candidate-lubricant-drag').click();
        while (bar.style.width === before) await new Promise(requestAnimationFrame);
        const moved = performance.now() - since;
        while (document.documentElement.dataset.idle !== 'yes') await new Promise((done) => setTimeout(done, 5));
        return [moved, performance.now() - since];
      });
      say(`a candidate clicked: bar moved after ${moved.toFixed(0)} ms, all pictures after ${seconds(all)}`);
      await close();
    }
  });

if (wanted.length === 0 || wanted.includes('million'))
  test('a million rows', { timeout: 1800000 }, async () => {
    const rows = 1e6;
    const lines = ['time_s,speed_rpm,spindle_temperature_C,ambient_temperature_C,displacement_z_um'];
    let [warm, z] = [20, 0];
    for (let k = 0; k < rows; ++k) {
      const speed = k % 50000 < 20000 ? 6000 : 0;
      warm += (20 + speed * 0.004 - warm) / 4000;
      z += (2 * (warm - 20) - z) / 8000;
      lines.push(`${k},${speed},${warm.toFixed(3)},${(20 + 2 * Math.sin(k / 40000)).toFixed(2)},${(z + 0.2 * Math.sin(1.7 * k)).toFixed(3)}`);
    }
    const record = file('million.csv');
    writeFileSync(record, `${lines.join('\n')}\n`);
    const { page, close } = await visit(address);
    await idle(page);
    await watchGaps(page);
    let most = memory();
    const opened = most;
    const watch = setInterval(() => (most = Math.max(most, memory())), 500);
    const since = performance.now();
    await page.setInputFiles('#file', record);
    await until(page, () => /million\.csv/.test(document.querySelector('.verdict .eyebrow')?.textContent) && !document.getElementById('stale'));
    const verdict = performance.now() - since;
    await idle(page);
    const all = performance.now() - since;
    clearInterval(watch);
    const gap = await page.evaluate(() => window.longestGap);
    say(`a million rows, ${(readFileSync(record).length / 1e6).toFixed(0)} MB: verdict ${seconds(verdict)}, all answers ${seconds(all)}, longest gap of the page ${seconds(gap)}, memory ${(most / 1e9).toFixed(2)} GB (${(opened / 1e9).toFixed(2)} GB before)`);
    await close();
  });
