// The page in a real browser: it loads without complaint, plays, picks a peak, shows findings. Usage: node report_page_test.js FOLDER
import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import assert from 'node:assert/strict';
import { launch, open } from './chromium.js';

const folder = process.argv[2];
const expected = JSON.parse(readFileSync(join(folder, 'expected.json'), 'utf8'));
const file = (name) => join(folder, name);
const moment = (page) => page.locator('#moment').evaluate((node) => ({ line: Number(node.dataset.line), time: Number(node.dataset.time) }));

/** Share of the canvas's pixels that differ from the most frequent colour: something is drawn. */
async function drawnShare(page) {
  const shot = await page.locator('#view').screenshot();
  return page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const counts = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const key = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
    return { drawn: 1 - Math.max(...counts.values()) / (data.length / 4), colours: counts.size };
  }, shot.toString('base64'));
}

const tests = {
  async 'loads without a complaint and draws the part'({ page }) {
    assert.match(await page.locator('#verdict').innerText(), /^REJECTED: 1 finding/);
    const { drawn, colours } = await drawnShare(page);
    assert.ok(drawn > 0.15 && colours > 200, `only ${drawn} of the canvas in ${colours} colours is drawn`);
    assert.equal(await page.locator('.cards .card').count(), 7);
    assert.match(await page.locator('#table-2').innerText(), /Sharp corners/);
  },

  async 'plays and pauses'({ page }) {
    await page.selectOption('#speed', '10');
    await page.click('#play');
    await page.waitForFunction(() => Number(document.getElementById('moment').dataset.time) > 0.5);
    await page.click('#play');
    const { time } = await moment(page);
    await page.waitForTimeout(300);
    assert.equal((await moment(page)).time, time, 'it moves on after Pause');
    assert.ok(time < expected.end_time);
  },

  async 'a click near a peak shows its moment and its line'({ page }) {
    const over = page.locator('.panel[data-quantity="velocity"] .u-over');
    const box = await over.boundingBox();
    // The plots show the whole cutting range; the click stands a few pixels beside the spike.
    await over.click({ position: { x: (box.width * expected.spike_time) / expected.end_time + 3, y: box.height / 2 } });
    const { line, time } = await moment(page);
    assert.equal(line, expected.spike_line);
    assert.ok(Math.abs(time - expected.spike_time) < 1e-3, `${time} instead of ${expected.spike_time}`);
    assert.equal(await page.locator('.row.current .number').innerText(), String(expected.spike_line));
    assert.match(await page.locator('#moment').innerText(), /axis velocity of A/);
  },

  async 'the hardest moment of all is the spike'({ page }) {
    await page.locator('#hardest tr').nth(1).click();
    assert.match(await page.locator('#hardest tr').nth(1).innerText(), /A velocity/);
    assert.equal((await moment(page)).line, expected.spike_line);
  },

  async 'a finding shows its moment'({ page }) {
    const row = page.locator('#findings-table tr').nth(1);
    assert.match(await row.innerText(), /<\/script><b>/, 'text is shown as text');
    await row.click();
    assert.equal((await moment(page)).line, expected.finding_line);
  },

  async 'a line of the program shows its moment'({ page }) {
    await page.locator('#program').evaluate((box) => { box.scrollTop = 99 * 18; });
    await page.locator('.row', { hasText: /^\s*104/ }).first().click();
    assert.equal((await moment(page)).line, 104);
  },

  async 'a click on the path in the 3D view picks a moment'({ page }) {
    await page.selectOption('#look', 'top');
    await page.selectOption('#machine-shown', 'hidden');
    await page.locator('#time').evaluate((slider) => { slider.value = 0; slider.dispatchEvent(new Event('input')); });
    const box = await page.locator('#view').boundingBox();
    await page.locator('#view').click({ position: { x: box.width / 2 + 60, y: box.height / 2 + 60 } });
    assert.ok((await moment(page)).time > 0);
  },

  async 'every colouring and switch draws'({ page }) {
    const ids = await page.locator('#path-colour option').evaluateAll((options) => options.map((option) => option.value));
    assert.ok(ids.includes('plan-turn') && ids.includes('limit') && ids.includes('speed-A'));
    for (const id of ids) await page.selectOption('#path-colour', id);
    await page.check('#deviation');
    assert.match(await page.locator('.legend').innerText(), /deviation of the surface/);
    await page.check('#tool-axes');
    await page.selectOption('#machine-shown', 'solid');
    await page.selectOption('#axis-group', 'linear');
    await page.click('#whole-run');
    assert.ok((await drawnShare(page)).drawn > 0.15);
  },
};

/** Tests of the whole page that need no 3D: they have to pass without WebGL too. */
const withoutScene = ['plays and pauses', 'a click near a peak shows its moment and its line', 'the hardest moment of all is the spike',
  'a finding shows its moment', 'a line of the program shows its moment'];

/** How many pixels of an image element are not of its first one's colour. */
const drawnInImage = (page, selector) => page.locator(selector).evaluate((image) => {
  const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
  return pixels.reduce((count, pixel) => count + (pixel !== pixels[0] ? 1 : 0), 0);
});

async function withoutWebgl() {
  const flat = await launch({ webgl: false });
  const opened = await open(flat, file('example.html'));
  const { page, complaints } = opened;
  assert.match(await page.locator('#verdict').innerText(), /^REJECTED: 1 finding/);
  assert.match(await page.locator('#no-webgl').innerText(), /no 3D/);
  assert.ok(await page.locator('#still').isVisible(), 'the still picture is gone');
  const stage = await page.locator('.stage').boundingBox(), still = await page.locator('#still').boundingBox();
  assert.ok(still.width > 0.9 * stage.width && still.height > 0.9 * stage.height, 'the still does not stand where the 3D view would');
  assert.ok(await drawnInImage(page, '#still') > 10000, 'the still is empty');
  assert.equal(await page.locator('.panel').count(), 4);
  assert.ok(await page.locator('.panel canvas').first().isVisible());
  for (const name of withoutScene) await tests[name](opened);
  await page.evaluate(() => scrollTo(0, 0));
  await page.screenshot({ path: file('without-webgl.png') });
  assert.deepEqual(complaints, []);
  await flat.close();
}

/** A browser that is asked for the document alone draws no frames. */
async function withoutFrames(browser) {
  const { page, complaints } = await open(browser, file('example.html'), { before: () => { window.requestAnimationFrame = () => 0; } });
  assert.equal(await page.locator('.panel').count(), 4);
  assert.ok(await page.locator('#program .row').count() > 10);
  assert.deepEqual(complaints, []);
  await page.close();
}

async function inWindow(browser, size) {
  const opened = await open(browser, file('example.html'), size);
  const wide = await opened.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(wide <= 1, `the page is ${wide} pixels wider than a window of ${size.width}`);
  await opened.page.screenshot({ path: file(`window-${size.width}.png`) });
  assert.deepEqual(opened.complaints, []);
  await opened.page.close();
}

async function foreignProgram(browser) {
  const { page, complaints } = await open(browser, file('foreign.html'));
  assert.match(await page.locator('#verdict').innerText(), /^PASSED/);
  assert.ok((await drawnShare(page)).drawn > 0.02);
  assert.deepEqual(complaints, []);
  await page.close();
}

/** A hundred thousand blocks, and a million samples. Times are told, not asserted: they belong to the machine. */
async function large(browser, name) {
  const { page, complaints, pictureMs, allMs } = await open(browser, file(name));
  const zoomMs = await page.evaluate(async () => {
    const over = document.querySelector('.panel .u-over');
    const { left, width, top } = over.getBoundingClientRect();
    let busy = 0;
    for (let i = 0; i < 20; ++i) {
      const start = performance.now();
      over.dispatchEvent(new WheelEvent('wheel', { clientX: left + width / 3, clientY: top + 5, deltaY: i < 10 ? -1 : 1, cancelable: true }));
      await Promise.resolve();   // uPlot draws in a microtask
      busy += performance.now() - start;
      await new Promise(requestAnimationFrame);
    }
    return busy / 20;
  });
  console.log(`  ${name}: ${(statSync(file(name)).size / 1e6).toFixed(2)} MB, first picture ${pictureMs.toFixed(0)} ms, everything ${allMs.toFixed(0)} ms, a zoom of four plots ${zoomMs.toFixed(1)} ms`);
  assert.deepEqual(complaints, []);
  await page.close();
}

const browser = await launch();
let failed = 0;
const check = async (name, body) => {
  try {
    await body();
    console.log(`ok   ${name}`);
  } catch (error) {
    ++failed;
    console.log(`FAIL ${name}: ${error.message}`);
  }
};
const opened = await open(browser, file('example.html'));
for (const [name, body] of Object.entries(tests)) await check(name, () => body(opened));
await opened.page.screenshot({ path: file('example.png'), fullPage: true });
await check('no console error, no exception, no request', async () => assert.deepEqual(opened.complaints, []));
await opened.page.close();
for (const width of [1100, 700, 390]) await check(`fits a window of ${width} pixels`, () => inWindow(browser, { width, height: 850 }));
await check('without WebGL everything works but the 3D view', withoutWebgl);
await check('where no frame is ever drawn everything is there', () => withoutFrames(browser));
await check('a program of others, without part, report and plan', () => foreignProgram(browser));
await check('a program of 100,000 blocks', () => large(browser, 'large.html'));
await check('a run of 1,000,000 samples', () => large(browser, 'million.html'));
await browser.close();
process.exit(failed === 0 ? 0 : 1);
