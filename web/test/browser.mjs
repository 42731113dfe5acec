// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Chromium without a screen, and pages in it that complain about any error and any request.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const { chromium } = createRequire(`${process.env.GUDGEON_WEB_PACKAGES}/`)('playwright-core');

const kPatience = 120_000; // [ms]

/** Waits until the page has drawn what it was told to. */
export const waitForFrames = (page) => page.evaluate(() => new Promise((resolve) => {
  let left = 3;
  const count = () => (--left > 0 ? requestAnimationFrame(count) : resolve());
  requestAnimationFrame(count);
}));

/** Waits until find() gives what check accepts; returns it. */
export async function waitUntil(page, find, check, what) {
  const end = Date.now() + kPatience;
  for (;;) {
    const found = await find();
    if (check(found)) return found;
    assert.ok(Date.now() < end, `${what}: ${JSON.stringify(found)?.slice(0, 300)}`);
    await waitForFrames(page);
  }
}

export async function openBrowser() {
  const program = process.env.GUDGEON_CHROMIUM;
  assert.ok(existsSync(program), `Chromium is missing (${program}); setup.sh installs it`);
  // A sandbox needs privileges that containers do not have; the page is our own.
  return chromium.launch({ executablePath: program, args: ['--no-sandbox', '--disable-gpu'] });
}

/** Opens a report; what it complains about or asks the network for is in page.complaints. */
export async function openReport(browser, file, { width = 1280, scheme = 'light' } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme, acceptDownloads: true });
  // A busy machine takes long; what is wrong takes for ever.
  context.setDefaultTimeout(kPatience);
  const page = await context.newPage();
  page.complaints = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && page.complaints.push(message.text()));
  page.on('pageerror', (error) => page.complaints.push(error.message));
  page.on('request', (request) => /^(https?|wss?):/.test(request.url()) && page.complaints.push(request.url()));
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector('html[data-ready]');
  return page;
}

/** Scrolls to a figure of a case and waits until it is drawn. */
export async function showFigure(page, name) {
  const figure = page.locator(`[id="figure-${name}"]`);
  await figure.scrollIntoViewIfNeeded();
  await page.waitForFunction((id) => document.getElementById(id).card.chart, `figure-${name}`);
  return figure;
}

/** The text of the file that a button offers. */
export async function readDownload(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'), button.click()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
}
