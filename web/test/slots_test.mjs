// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks and pins in slots, in Chromium: the magnified picture against what the run file recorded.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openReport, readDownload, showFigure } from './browser.mjs';
import { findExample, gudgeon, makeReport, readColumn, removeFolder } from './runs.mjs';

let browser;

before(async () => { browser = await openBrowser(); });
after(async () => {
  await browser?.close();
  removeFolder();
});

const kSettings = ['study.cycles=1', 'study.warm_up_cycles=1', 'study.outputs_per_cycle=400'];

/** The picture at the times of some samples of the stage without wear: its layout and its pixels. */
async function drawAt(page, times) {
  return page.evaluate((all) => {
    const { player, insets: [inset] } = document.querySelector('.mechanism').panel;
    return all.map((time) => {
      player.show(time);
      return { ...inset.layout, picture: inset.canvas.toDataURL(), text: inset.text.textContent };
    });
  }, times);
}

/** Gaps of a picture's corners, in m: the drawn distance to the wall over the drawn clearance. */
function findGaps({ corners, radius, wall, isBlock, scale, factor }) {
  return corners.map(([, y], k) => (wall - radius - (k < (isBlock ? 2 : 1) ? -y : y)) / (scale * factor));
}

async function checkSlot(example, joint, tolerance) {
  const name = joint;
  const page = await openReport(browser, makeReport(findExample(example), name, kSettings));
  await page.waitForFunction(() => document.querySelector('.mechanism').panel);
  gudgeon('export', `${name}/base.h5`, '-o', `${name}_csv`);
  const read = (channel) => readColumn(`${name}_csv`, 'no_wear_channels.csv', channel).map(Number);
  const [times, penetrations, counts] = [read('time'), read(`${joint}.penetration`), read(`${joint}.n_contacts`)];
  const chosen = Array.from({ length: 25 }, (unused, k) => Math.floor((k * times.length) / 25));
  const drawn = await drawAt(page, chosen.map((k) => times[k]));
  drawn.forEach((layout, i) => {
    const least = Math.min(...findGaps(layout));
    assert.ok(Math.abs(least + penetrations[chosen[i]]) < tolerance, `gap ${least}, penetration ${penetrations[chosen[i]]} at ${times[chosen[i]]} s`);
    assert.equal(layout.touching.length, counts[chosen[i]], `corners that touch at ${times[chosen[i]]} s`);
  });
  assert.ok(new Set(drawn.map(({ picture }) => picture)).size > 20, 'it moves');
  assert.ok(drawn.some(({ text }) => /contact.*clearance.* × \d/.test(text)), 'it states its factor');
  return page;
}

async function checkWear(page, joint, figure, count) {
  const card = await showFigure(page, `base.${joint}.${figure}`);
  const curves = await page.evaluate((id) => document.getElementById(id).card.figure.curves
    .filter((curve) => curve.group).map(({ color, line, name }) => ({ look: `${color} ${line}`, name })), `figure-base.${joint}.${figure}`);
  assert.equal(new Set(curves.map(({ look }) => look)).size, count);
  assert.equal(new Set(curves.map(({ name }) => name)).size, count);
  assert.ok(await card.locator('.legend button').count() >= count);
  const header = (await readDownload(page, card.locator('button', { hasText: 'CSV' }))).bytes.toString().split('\n')[0];
  for (const { name } of curves) assert.ok(header.includes(name), `${name} in ${header}`);
}

test('a block in its slot', async () => {
  // Heights in single precision; the drawing leaves out 1 − cos of the tilt, half a square of 4 mrad on 15 mm.
  const page = await checkSlot('slider_crank_guide.toml', 'guide', 3e-7);
  await checkWear(page, 'guide', 'wear_depth', 2);
  await checkWear(page, 'guide', 'journal_surface', 4);
  const orbit = await showFigure(page, 'base.guide.orbit');
  assert.match(await orbit.locator('.legend').textContent(), /clearance/);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test('a pin in its slot', async () => {
  const page = await checkSlot('scotch_yoke.toml', 'pin', 3e-8);
  await checkWear(page, 'pin', 'wear_depth', 2);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});
