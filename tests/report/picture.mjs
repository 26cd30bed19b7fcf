// Takes the picture of a report that the README shows: verdict, ladder, fit and map, one below the other.
// With the name of a figure, that one alone.
//   node picture.mjs PAGE.html OUTPUT.png [FIGURE]      with PACKAGES the folder of node_modules, CHROMIUM the browser
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const { CHROMIUM, PACKAGES } = process.env;
const [page_file, output] = process.argv.slice(2, 4).map((path) => resolve(path));
const [, , , , figure] = process.argv;
const { chromium } = createRequire(join(resolve(PACKAGES), 'package.json'))('playwright-core');
const shown = ['ladder', 'parity', 'residual-speed', 'map'];

const browser = await chromium.launch({ executablePath: CHROMIUM, args: process.getuid() === 0 ? ['--no-sandbox'] : [] });
const page = await browser.newPage({ viewport: { width: 980, height: 900 }, colorScheme: 'light' });
await page.goto(pathToFileURL(page_file).href);
await page.waitForFunction(() => document.documentElement.dataset.drawn === 'yes');
if (figure) {
  await page.$eval(`#${figure} .foot`, (foot) => (foot.hidden = true));
  await page.locator(`#${figure}`).screenshot({ path: output });
  await browser.close();
  process.exit();
}
await page.evaluate((ids) => {
  for (const figure of document.querySelectorAll('figure')) figure.hidden = !ids.includes(figure.id);
  for (const list of document.querySelectorAll('.list, .foot, footer')) list.hidden = true;
  for (const section of document.querySelectorAll('section')) section.hidden = !section.querySelector('figure:not([hidden])');
}, shown);
const missing = await page.evaluate((ids) => ids.filter((id) => !document.getElementById(id)), shown);
if (missing.length) throw new Error(`the report has no ${missing.join(', ')}`);
const { height } = await page.locator('main').boundingBox();
await page.screenshot({ path: output, fullPage: true, clip: { x: 0, y: 0, width: 980, height: Math.ceil(height) } });
await browser.close();
