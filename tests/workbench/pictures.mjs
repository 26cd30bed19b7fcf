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
await page.goto(`http://127.0.0.1:${server.address().port}/`);
await picture('verdict');
await page.click('#add-0');
await picture('added');
await page.setInputFiles('#file', join(ROOT, 'data/measurements/german_export.csv'));
await idle();
await page.check('#drop-nan');
await picture('columns');
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
await browser.close();
server.close();
