// What tests of pages share: reports are written by the built program and opened in Chromium from
// file://, as a reader would.
// Environment: RACEWAY the program, CHROMIUM the browser, PACKAGES the folder of node_modules, ROOT.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

export const { RACEWAY, CHROMIUM, PACKAGES, ROOT } = process.env;
const { chromium } = createRequire(join(PACKAGES, 'package.json'))('playwright-core');
const folder = mkdtempSync(join(tmpdir(), 'raceway-report-'));
export const file = (name) => join(folder, name);

/// What the command printed, as its pages write it.
export const asPrinted = (text) => text.replaceAll('\u00a0', ' ').replaceAll('→', '->').replaceAll('± ', '+- ').replaceAll('µm', 'um').replaceAll('°C', 'C');

let browser;
export const results = {}; // what --json printed, by page

export function raceway(...words) {
  return execFileSync(RACEWAY, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 28 });
}

/// Runs a command that writes NAME.html, and keeps what it printed as JSON.
export function write(name, ...words) {
  results[name] = JSON.parse(raceway(...words, '--json', '--report', file(`${name}.html`)));
}

before(async () => {
  // As root Chromium has no sandbox; the pages are this program's own.
  browser = await chromium.launch({ executablePath: CHROMIUM, args: process.getuid() === 0 ? ['--no-sandbox'] : [] });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/// Opens an address. Anything on the console, any error and any request beside the page itself is a
/// fault; `own` are addresses that belong to the page.
export async function visit(url, options = {}, prepare = async () => {}, own = []) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const faults = [];
  page.on('console', (message) => faults.push(`console: ${message.text()}`));
  page.on('pageerror', (error) => faults.push(`error: ${error.message}`));
  page.on('dialog', (dialog) => {
    faults.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  page.on('request', (request) => {
    if (request.url() !== url && !own.includes(request.url()) && !request.url().startsWith('blob:')) faults.push(`request: ${request.url()}`);
  });
  await prepare(page);
  await page.goto(url);
  return { page, faults, close: () => context.close() };
}

/// Opens a page that was written, and waits until all is drawn.
export async function open(name, options = {}, prepare = async () => {}) {
  const opened = await visit(pathToFileURL(file(`${name}.html`)).href, options, prepare);
  await opened.page.waitForFunction(() => document.documentElement.dataset.drawn === 'yes');
  return opened;
}

export const documentOf = (page) => page.evaluate(() => JSON.parse(document.getElementById('document').textContent));
export const figures = (page) => page.$$eval('figure', (all) => all.map((f) => f.id));

/// Filled shapes of a picture that can be seen, the legend's among them; painted pixels / 1000 where it is a canvas.
export const marks = (page, id) =>
  page.$eval(`#${id} .chart`, (chart) => {
    const canvas = chart.querySelector('canvas');
    if (!canvas) return [...chart.querySelectorAll('svg path')].filter((p) => !['none', 'transparent', null].includes(p.getAttribute('fill')) && p.getAttribute('opacity') !== '0' && p.getAttribute('fill-opacity') !== '0').length;
    // Of a copy: a canvas that is read again and again says so on the console.
    const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height }).getContext('2d', { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const pixels = copy.getImageData(0, 0, canvas.width, canvas.height).data;
    let painted = 0;
    for (let k = 3; k < pixels.length; k += 4) painted += pixels[k] > 0;
    return painted / 1000;
  });

/// The lines under Notes.
export const notesOf = (page) => page.$$eval('ul.notes li', (all) => all.map((line) => line.textContent));

/// The table under a picture: text, or the number in full.
export async function tableOf(page, id) {
  await page.$eval(`#${id} details`, (d) => (d.open = true));
  await page.waitForSelector(`#${id} tbody tr`);
  return page.$$eval(`#${id} tbody tr`, (rows) =>
    rows.map((row) => [...row.children].map((cell) => (cell.dataset.value === undefined ? cell.textContent : cell.dataset.value === '' ? null : Number(cell.dataset.value)))),
  );
}

export async function csvOf(page, id) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#${id} .csv`)]);
  const lines = readFileSync(await download.path(), 'utf8').trim().split('\r\n');
  const cells = (line) => [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].slice(0, -1).map((m) => m[1].replace(/^"|"$/g, '').replace(/""/g, '"'));
  return { columns: cells(lines[0]), rows: lines.slice(1).map(cells) };
}
