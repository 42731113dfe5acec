// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// picture.mjs REPORT OUTPUT: a picture of the report's first screens, for the README.
import { openBrowser, openReport, waitForFrames } from './test/browser.mjs';

const [report, output] = process.argv.slice(2);
const browser = await openBrowser();
const page = await openReport(browser, report, { width: 1100 });
await page.waitForFunction(() => document.querySelector('.mechanism').panel);
await page.evaluate(() => {
  for (const id of ['simulated', 'reference']) document.getElementById(`base-${id}`)?.remove();
  for (const table of document.querySelectorAll('.table, .note')) table.remove();
  document.querySelector('.mechanism').panel.player.show(5.1);
});
await page.setViewportSize({ width: 1100, height: 1330 });
await page.evaluate(() => document.querySelectorAll('#base-wear .figure').forEach((figure) => figure.card.draw()));
await waitForFrames(page);
await page.screenshot({ path: output });
await browser.close();
