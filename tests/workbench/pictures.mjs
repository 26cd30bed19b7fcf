// Makes the pictures of docs/workbench.md: docs/workbench-*.png, of the page with the built program as its engine.
//   node tests/workbench/pictures.mjs, with the environment of workbench_test.mjs; then optipng -o3 docs/workbench-*.png
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { workbench } from '../../web/page/bundle.mjs';
import { serve } from '../../web/page/dev_server.mjs';

const { RACEWAY, CHROMIUM, PACKAGES, PAGE_PACKAGES, ROOT } = process.env;
const { chromium } = createRequire(join(PACKAGES, 'package.json'))('playwright-core');
const server = await serve(RACEWAY, () => workbench(PAGE_PACKAGES, true));
const browser = await chromium.launch({ executablePath: CHROMIUM, args: process.getuid() === 0 ? ['--no-sandbox'] : [] });
const page = await browser.newPage({ viewport: { width: 1200, height: 740 } });
const idle = () => page.waitForFunction(() => document.documentElement.dataset.idle === 'yes');
const picture = async (name) => {
  await idle();
  await page.waitForTimeout(700); // bars that move
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.screenshot({ path: join(ROOT, `docs/workbench-${name}.png`) });
};
const address = `http://127.0.0.1:${server.address().port}/`;
await page.goto(address);
await picture('verdict');
await page.click('#add-0');
await picture('added');
await page.click('#step-compare');
await picture('compare');
await page.click('#step-history');
await picture('history');
await page.click('#step-home');
await picture('home');
await page.setInputFiles('#file', join(ROOT, 'data/measurements/german_export.csv'));
await idle();
await page.check('#drop-nan');
await picture('columns');
await page.click('#confirm-columns');
await idle();
await page.fill('#designation', '7014');
await page.waitForSelector('[role="option"]');
await page.keyboard.press('ArrowDown');
await picture('model');
await page.click('#step-data');
await page.click('#see-record');
await idle();
await page.click('#find-lags');
await picture('record');
await page.click('#example-spindle');
await picture('spindle');
await page.click('#step-programme');
await idle();
await page.waitForTimeout(1000);
const nose = await page.$('#nose');
await nose.screenshot({ path: join(ROOT, 'docs/workbench-programme.png') });
await page.click('#step-modes');
await picture('modes');

// Steps at 390 px, side by side.
await page.setViewportSize({ width: 390, height: 780 });
const narrow = [];
const column = async () => {
  await idle();
  await page.waitForTimeout(700);
  await page.evaluate(() => window.scrollTo(0, 0));
  narrow.push((await page.screenshot()).toString('base64'));
};
await page.goto(address);
await idle();
await page.setInputFiles('#file', join(ROOT, 'tests/hidden_effect/rigs/dev-05/train.csv'));
await column();
await page.click('#next');
await page.fill('#designation', '7014');
await page.waitForSelector('[role="option"]');
await column();
await page.fill('#designation', '7014 AC');
await page.fill('#oil', 'VG 32');
await page.keyboard.press('Enter');
await idle();
await page.click('#add-0');
await column();
await page.click('#step-home');
await column();
// The page of the workbench allows no pictures of others: they stand on one of their own.
const beside = await browser.newPage({ viewport: { width: 4 * 390 + 3 * 16, height: 780 } });
await beside.setContent(`<body style="margin:0;display:flex;gap:16px;background:#8b95a1">${narrow.map((data) => `<img src="data:image/png;base64,${data}">`).join('')}`);
await beside.waitForTimeout(500);
await beside.screenshot({ path: join(ROOT, 'docs/workbench-narrow.png') });
await browser.close();
server.close();
