// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The report of a short nine-bar run in Chromium: it plays, switches, zooms and exports, and it shows the run file's numbers.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openBrowser, openReport, readDownload, showFigure, waitForFrames, waitUntil } from './browser.mjs';
import { findExample, gudgeon, makeReport, readColumn, removeFolder } from './runs.mjs';

let browser;
let page;
let report;

before(async () => {
  report = makeReport(findExample('nine_bar/nine_bar.toml'), 'press', ['study.cycles=2', 'study.warm_up_cycles=1', 'study.wear_acceleration=20000'],
    { cases: ['base', 'clearance_0_3'] });
  gudgeon('export', 'press/base.h5', '-o', 'csv');
  browser = await openBrowser();
  page = await openReport(browser, report);
});

after(async () => {
  await browser?.close();
  removeFolder();
});

const findRange = (name) => page.evaluate((id) => document.getElementById(id).card.chart.findRanges(), `figure-${name}`);
const findPicture = (name) => page.evaluate((id) => document.getElementById(id).querySelector('canvas').toDataURL(), `figure-${name}`);
const findTime = () => page.evaluate(() => document.querySelector('article:not([hidden]) .mechanism').panel.player.time);

/** Every value within single precision of the scale of its column. */
function assertSame(ours, theirs, what) {
  assert.equal(ours.length, theirs.length, what);
  const scale = Math.max(...theirs.map(Math.abs));
  ours.forEach((value, k) => assert.ok(Math.abs(value - theirs[k]) <= 1.2e-7 * scale, `${what}, sample ${k}: ${value} and ${theirs[k]}`));
}

/** Elements wider than the screen that do not scroll by themselves. */
const findWhatSticksOut = (one) => one.evaluate(() => [...document.querySelectorAll('body *')]
  .filter((element) => element.getBoundingClientRect().right > innerWidth + 1 && !element.closest('.table, pre, nav'))
  .map((element) => `${element.tagName} ${element.className} ${element.textContent.slice(0, 40)}`));

const readTable = (bytes) => {
  const [header, ...rows] = bytes.toString().trim().split('\n').map((row) => row.split(','));
  return { header, column: (name) => rows.map((row) => Number(row[header.findIndex((one) => one.startsWith(name))])) };
};

test('the mechanism plays, pauses, steps and is scrubbed', async () => {
  const panel = page.locator('article:not([hidden]) .mechanism');
  await panel.locator('button[aria-label="Play"]').click();
  const start = await findTime();
  await page.waitForFunction((t) => document.querySelector('.mechanism').panel.player.time !== t, start);
  await panel.locator('button[aria-label="Pause"]').click();
  const paused = await findTime();
  await waitForFrames(page);
  assert.equal(await findTime(), paused);
  await panel.locator('button[aria-label="One sample on"]').click();
  const first = await findTime();
  await panel.focus();
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await findTime()) - first - 0.002) < 1e-9, 'a key steps one of 500 samples a cycle of 1 s');
  const picture = await readDownload(page, panel.locator('button', { hasText: 'PNG' }));
  assert.match(picture.name, /^base\.no_wear\..*_s\.png$/);
  assert.equal(picture.bytes.subarray(1, 4).toString(), 'PNG');
  await panel.locator('input[type=range]').fill('0');
  assert.equal(await findTime(), await page.evaluate(() => document.querySelector('.mechanism').panel.motion.begin));
  await page.keyboard.press('End');
});

test('playing loops one cycle', async () => {
  const times = await page.evaluate(async () => {
    const { player, loopBox } = document.querySelector('.mechanism').panel;
    player.show(1.5);
    loopBox.click();
    const seen = [];
    const show = player.show.bind(player);
    player.show = (t) => { seen.push(t); show(t); };
    player.speed = 2; // at most 0.2 s a frame
    player.play();
    const begins = () => seen.some((t, k) => k > 0 && t < seen[k - 1]);
    while (!begins()) await new Promise(requestAnimationFrame);
    player.pause();
    delete player.show;
    player.speed = 0.25;
    loopBox.click();
    return seen;
  });
  assert.ok(times.some((t, k) => k > 0 && t < times[k - 1]), 'it began again');
  assert.ok(Math.max(...times) - Math.min(...times) <= 1 + 1e-9, 'within one cycle');
});

test('the time cursor runs through the plots', async () => {
  await showFigure(page, 'base.slider_9.x');
  const positions = await page.evaluate(() => [2.2, 2.7].map((t) => {
    document.querySelector('.mechanism').panel.player.show(t);
    const { cursor, plot } = document.getElementById('figure-base.slider_9.x').card.chart;
    return [new DOMMatrix(getComputedStyle(cursor).transform).m41, plot.valToPos(t, 'x')];
  }));
  for (const [shown, expected] of positions) assert.ok(Math.abs(shown - expected) < 0.51);
  assert.ok(positions[1][0] > positions[0][0]);
});

test('bodies stand where the run file has them', async () => {
  const k = 777;
  const time = Number(readColumn('csv', 'no_wear_channels.csv', 'time')[k]);
  const shown = await page.evaluate((t) => {
    const { motion } = document.querySelector('.mechanism').panel;
    return Object.fromEntries(motion.scene.bodies.map((body, b) => [body.name, motion.findPoses(t)[b]]));
  }, time);
  for (const body of ['crank_1', 'rod_2', 'panel_7', 'slider_9']) {
    for (const part of ['x', 'y', 'angle']) {
      const stored = Number(readColumn('csv', 'no_wear_channels.csv', `${body}.${part} `)[k]);
      assert.ok(Math.abs(shown[body][part] - stored) < 2e-6, `${body}.${part}: ${shown[body][part]} and ${stored}`);
    }
  }
});

test('the legend takes a stage away and brings it back', async () => {
  const figure = await showFigure(page, 'base.A.normal_force');
  await waitForFrames(page);
  const full = await findPicture('base.A.normal_force');
  const button = figure.locator('.legend button', { hasText: 'no wear' });
  await button.click();
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  const picture = () => findPicture('base.A.normal_force');
  await waitUntil(page, picture, (now) => now !== full, 'the stage is away');
  await button.click();
  await page.mouse.move(0, 0);
  await waitUntil(page, picture, (now) => now === full, 'the stage is back');
});

test('dragging zooms, a double click and keys show more', async () => {
  for (const name of ['base.slider_9.x_velocity', 'base.A.orbit']) {
    const figure = await showFigure(page, name);
    const before = await findRange(name);
    const box = await figure.locator('canvas').first().boundingBox();
    await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.3 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.6 * box.height, { steps: 4 });
    await page.mouse.up();
    const length = ({ x }) => x[1] - x[0];
    const range = () => findRange(name);
    const zoomed = await waitUntil(page, range, (now) => length(now) < 0.6 * length(before), `${name} zooms`);
    await figure.locator('.chart').focus();
    await page.keyboard.press('-');
    await waitUntil(page, range, (now) => length(now) > 1.5 * length(zoomed), `${name} shows more`);
    await page.mouse.dblclick(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    await waitUntil(page, range, (now) => length(now) >= length(before) * 0.999, `${name} shows all`);
  }
});

test('data, pictures and readout of a figure come out', async () => {
  const figure = await showFigure(page, 'base.slider_9.x_acceleration');
  const csv = await readDownload(page, figure.locator('button', { hasText: 'CSV' }));
  assert.equal(csv.name, 'base.slider_9.x_acceleration.csv');
  const table = readTable(csv.bytes);
  const stored = readColumn('csv', 'wear_1_channels.csv', 'slider_9.x_acceleration').map(Number);
  assertSame(table.column('first wear'), stored, 'acceleration');
  assertSame(table.column('Time'), readColumn('csv', 'wear_1_channels.csv', 'time').map(Number), 'time');
  await figure.locator('.chart').focus();
  await page.keyboard.press('.');
  const readout = () => figure.locator('.readout').textContent();
  const read = await waitUntil(page, readout, (text) => /s: ideal/.test(text), 'a key reads values');
  await page.keyboard.press('.');
  await waitUntil(page, readout, (text) => /s: ideal/.test(text) && text !== read, 'the next key reads the next ones');
  const svg = await readDownload(page, figure.locator('button', { hasText: 'SVG' }));
  const seen = await page.evaluate((text) => {
    const parsed = new DOMParser().parseFromString(text, 'image/svg+xml');
    return { broken: parsed.querySelector('parsererror') !== null, lines: parsed.querySelectorAll('polyline').length, text: parsed.documentElement.textContent };
  }, svg.bytes.toString());
  assert.deepEqual([seen.broken, seen.lines], [false, 4]);
  assert.match(seen.text, /Acceleration in x \(m\/s²\)/);
  const png = await readDownload(page, figure.locator('button', { hasText: 'PNG' }));
  assert.equal(png.bytes.subarray(1, 4).toString(), 'PNG');
  assert.equal(png.bytes.readUInt32BE(16), 1440);
  // Pictures of figures that nobody has scrolled to yet; that of an exaggerated one says by how much.
  const unseen = await page.evaluate(() => {
    const { card } = document.getElementById('figure-base.A.surfaces');
    const { card: signal } = document.getElementById('figure-base.A.normal_force');
    return { surfaces: card.makeSvg(), signal: signal.makeSvg() };
  });
  assert.match(unseen.surfaces, /Depth × \d+/);
  assert.match(unseen.signal, /<polyline points="[\d.]+,[\d.]+ /);
  const box = await figure.locator('canvas').first().boundingBox();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  await waitUntil(page, () => figure.locator('.readout').textContent(), (text) => /s: ideal .*first wear [−\d]/.test(text), 'hover values');
});

test('wear depths are those of the run file', async () => {
  const figure = await showFigure(page, 'base.B.wear_depth');
  const { bytes } = await readDownload(page, figure.locator('button', { hasText: 'CSV' }));
  const ofB = (file, start) => {
    const joints = readColumn('csv', file, 'joint');
    return readColumn('csv', file, start).filter((value, k) => joints[k] === 'B').map(Number);
  };
  const first = ofB('no_wear_wear.csv', 'total_depth_added');
  const second = ofB('wear_1_wear.csv', 'total_depth_added').map((depth, k) => depth + first[k]);
  assertSame(readTable(bytes).column('first wear'), first, 'first wear');
  assertSame(readTable(bytes).column('second wear'), second, 'second wear');
});

test('tables tell the run file\'s peaks', async () => {
  const channels = readColumn('csv', 'no_wear_statistics.csv', 'channel');
  const peak = Number(readColumn('csv', 'no_wear_statistics.csv', 'maximum')[channels.indexOf('B.normal_force')]);
  const row = page.locator('article:not([hidden]) .forces tr', { hasText: 'B.normal_force' }).filter({ hasText: 'no wear' });
  const [value, unit] = (await row.locator('td').nth(1).textContent()).split(' ');
  const told = Number(value) * { N: 1, kN: 1000 }[unit];
  assert.ok(Math.abs(told - peak) <= 0.0005 * peak, `${told} and ${peak}`);
  const assumed = page.locator('article:not([hidden]) .stated tr', { hasText: 'joints.A.width' });
  assert.match(await assumed.textContent(), /20 mm\s*A/);
});

test('a case is chosen, cases stand side by side', async () => {
  await page.selectOption('#case-choice', 'clearance_0_3');
  assert.deepEqual(await page.evaluate(() => [...document.querySelectorAll('article')].map((one) => [one.dataset.case, one.hidden])),
    [['base', true], ['clearance_0_3', false]]);
  await showFigure(page, 'clearance_0_3.A.orbit');
  const figure = await showFigure(page, 'A.wear_depth_over_clearance');
  assert.match(await figure.textContent(), /300\.0 µm: second wear.*500\.0 µm: second wear/);
  await page.selectOption('#case-choice', 'base');
});

test('the page answers in 100 ms', async () => {
  const times = await page.evaluate(() => {
    const { player, motion } = document.querySelector('.mechanism').panel;
    const cards = [...document.querySelectorAll('.figure')].map((one) => one.card).filter((card) => card.chart);
    const measure = (act) => {
      const start = performance.now();
      act();
      return performance.now() - start;
    };
    // The least of some: what other programs take is not the page's.
    const least = (count, act) => Math.min(...Array.from({ length: count }, (unused, k) => measure(() => act(k))));
    const scrub = least(15, (k) => player.show(motion.begin + 0.1 * k));
    const redraw = Math.max(...cards.map((card) => least(3, () => card.chart.zoomBy(0.9))));
    return { scrub, redraw, figures: cards.length };
  });
  assert.ok(times.figures > 5);
  assert.ok(times.scrub < 100 && times.redraw < 100, JSON.stringify(times));
});

test('every control has a name, every figure its keys', async () => {
  const nameless = await page.evaluate(() => [...document.querySelectorAll('button, select, input, canvas[role], .chart')]
    .filter((one) => !(one.getAttribute('aria-label') || one.textContent.trim() || one.closest('label')?.textContent.trim()))
    .map((one) => one.outerHTML.slice(0, 80)));
  assert.deepEqual(nameless, []);
  const deaf = await page.evaluate(() => [...document.querySelectorAll('.figure')].filter((one) => {
    const texts = [...one.querySelectorAll('.buttons button')].map((button) => button.textContent);
    return !['CSV', 'SVG', 'PNG', 'All', 'Reset'].every((text) => texts.includes(text)) || one.querySelector('.chart').tabIndex !== 0;
  }).map((one) => one.id));
  assert.deepEqual(deaf, []);
});

test('the links at the top stand in one line', async () => {
  const nav = await page.evaluate(() => {
    const one = document.getElementById('sections');
    return { over: one.scrollWidth - one.clientWidth, rows: new Set([...one.children].map((link) => link.offsetTop)).size, links: one.children.length };
  });
  assert.deepEqual(nav, { over: 0, rows: 1, links: 12 });
});

test('it is dark or light as the reader wants, and fits a phone', async () => {
  const ground = (one) => one.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await ground(page);
  await page.click('#theme');
  assert.notEqual(await ground(page), light);
  await page.click('#theme');
  const phone = await openReport(browser, report, { width: 400, scheme: 'dark' });
  assert.notEqual(await ground(phone), light);
  await showFigure(phone, 'base.A.surfaces');
  await phone.evaluate(() => scrollTo(0, 0));
  assert.deepEqual(await findWhatSticksOut(phone), []);
  assert.deepEqual(phone.complaints, []);
  await phone.context().close();
});

test('nothing complained, nothing was asked of the network', () => assert.deepEqual(page.complaints, []));
