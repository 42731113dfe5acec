// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reports of runs that lack something, in Chromium: what is there is shown, and nothing complains.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openReport, waitUntil } from './browser.mjs';
import { findExample, makeReport, removeFolder, writeFailing, writeLongWords, writeTwelveJoints } from './runs.mjs';

let browser;

before(async () => { browser = await openBrowser(); });
after(async () => {
  await browser?.close();
  removeFolder();
});

/** The figures whose canvas has no drawn pixel. */
function findEmptyFigures(page) {
  return page.evaluate(() => {
    const cards = [...document.querySelectorAll('.figure')].map((one) => one.card);
    return cards.filter((card) => {
      const canvas = card.place.querySelector('canvas');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return !data.some((value) => value > 0);
    }).map((card) => card.name);
  });
}

async function checkReport(file, { figures, joints, text }) {
  const page = await openReport(browser, file);
  assert.equal(await page.locator('.figure').count(), figures);
  await page.waitForFunction(() => document.querySelector('.mechanism').panel);
  assert.equal(await page.evaluate(() => document.querySelector('.mechanism').panel.insets.length), joints);
  await page.evaluate(() => document.querySelectorAll('.figure').forEach((one) => one.card.draw()));
  await waitUntil(page, () => findEmptyFigures(page), (empty) => empty.length === 0, 'figures without a drawn pixel');
  if (text) assert.match(await page.locator('main').textContent(), text);
  await page.evaluate(() => document.querySelector('.mechanism').panel.player.step(3));
  assert.deepEqual(page.complaints, []);
  await page.context().close();
}

test('no clearance joint, no slider', async () => {
  await checkReport(makeReport(findExample('pendulum.toml'), 'pendulum', ['study.cycles=2']), { figures: 3, joints: 0 });
});

test('clearance without wear', async () => {
  const file = makeReport(findExample('slider_crank_clearance.toml'), 'loose', ['study.cycles=1', 'study.warm_up_cycles=0']);
  await checkReport(file, { figures: 13, joints: 1 });
});

test('twelve clearance joints, one of two at a time magnified', async () => {
  await checkReport(makeReport(writeTwelveJoints(), 'twelve'), { figures: 3 + 12 * 10, joints: 2 });
});

test('a run that failed half-way', async () => {
  const file = makeReport(writeFailing(), 'failed', ['study.compare_ideal=false', 'study.cycles=1'], { mayFail: true });
  await checkReport(file, { figures: 15, joints: 1, text: /Stage “no wear” failed at .* what it recorded is shown/ });
});

test('words of five hundred letters leave the page its width', async () => {
  const page = await openReport(browser, makeReport(writeLongWords(), 'long', [], { cases: ['base', 'wide'] }));
  for (const width of [1200, 700, 400]) {
    await page.setViewportSize({ width, height: 900 });
    const shown = await page.evaluate(() => {
      document.querySelectorAll('details').forEach((one) => { one.open = true; });
      return { scroll: document.documentElement.scrollWidth, client: document.documentElement.clientWidth };
    });
    assert.ok(shown.scroll <= shown.client, `${shown.scroll} px in a window of ${shown.client}`);
  }
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});
