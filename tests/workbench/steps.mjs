// What tests of the workbench do on its page, as a user does, and what they read there.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

export const idle = (page) => page.waitForFunction(() => document.documentElement.dataset.idle === 'yes', undefined, { timeout: 120000 });
export const sentence = async (page) => (await page.textContent('#sentence')).replaceAll('\u00a0', ' ');
export const errors = (page) => page.$$eval('.callout.error', (all) => all.map((e) => e.textContent));
export const bars = (page) => page.$$eval('#error-bars .bar-now', (all) => all.map((bar) => Number.parseFloat(bar.style.width)));

/// A path, files, or a name with its text.
export async function drop(page, name, text) {
  await page.setInputFiles('#file', text === undefined ? name : { name, mimeType: 'text/csv', buffer: Buffer.from(text) });
  await idle(page);
}

/// Drags files onto the page as the desktop does: it shows that they may fall.
export async function drag(page, ...files) {
  const browser = await page.context().newCDPSession(page);
  const marked = () => page.evaluate(() => document.getElementById('workbench').classList.contains('dragging'));
  const step = (type) => browser.send('Input.dispatchDragEvent', { type, x: 200, y: 400, data: { items: [], files, dragOperationsMask: 1 } });
  await step('dragEnter');
  await step('dragOver');
  assert.equal(await marked(), true);
  await step('drop');
  const name = files.at(-1).split('/').pop();
  await page.waitForFunction((name) => document.getElementById('step-data').textContent.includes(name), name);
  await idle(page);
  assert.equal(await marked(), false);
}

export async function click(page, selector) {
  await page.click(selector);
  await idle(page);
}

export async function designate(page, designation, oil) {
  await page.fill('#designation', designation);
  await page.fill('#oil', oil);
  await page.keyboard.press('Enter');
  await idle(page);
}

export async function saved(page, selector) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
}

/// Presses Tab until the control has the focus, which can be seen.
export async function reach(page, id) {
  for (let k = 0; k < 80; ++k) {
    const at = await page.evaluate(() => {
      const control = document.activeElement;
      const marked = control.matches('.visually-hidden') ? control.nextElementSibling : control;
      return { id: control.id, seen: getComputedStyle(marked).outlineStyle !== 'none' && control.matches(':focus-visible') };
    });
    if (at.id === id) return assert.ok(at.seen, `the focus on ${id} is seen`);
    await page.keyboard.press('Tab');
  }
  assert.fail(`${id} is not reached`);
}

export async function press(page, id, key = 'Enter') {
  await reach(page, id);
  await page.keyboard.press(key);
  await idle(page);
}
