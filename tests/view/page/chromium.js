// Opens a page file in the Chromium that is installed, without network, and gathers what it complains about.
import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

export const chromiumPath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);

const flags = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const drawing = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];

/** `webgl`: whether pages may draw in 3D. */
export function launch({ webgl = true } = {}) {
  return chromium.launch({ executablePath: chromiumPath, headless: true, args: [...flags, ...(webgl ? drawing : ['--disable-3d-apis'])] });
}

/** `before`: runs in the page before its own scripts. The page, its complaints (console errors, exceptions, requests to anything but the file), and milliseconds to the first picture. */
export async function open(browser, file, { width = 1500, height = 1000, before = null } = {}) {
  const page = await browser.newPage({ viewport: { width, height } });
  if (before) await page.addInitScript(before);
  const complaints = [];
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(`console: ${message.text()}`); });
  page.on('pageerror', (error) => complaints.push(`exception: ${error.message}`));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) complaints.push(`request: ${request.url()}`); });
  const start = performance.now();
  await page.goto(pathToFileURL(file).href, { waitUntil: 'commit' });
  await page.waitForFunction(() => ['picture', 'scene', 'all'].includes(document.documentElement.dataset.ready), null, { timeout: 60000, polling: 20 });
  const pictureMs = performance.now() - start;
  await page.waitForFunction(() => document.documentElement.dataset.ready === 'all', null, { timeout: 60000, polling: 20 });
  return { page, complaints, pictureMs, allMs: performance.now() - start };
}
