// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { eventually, press, says, until, withPage } from "./browser.mjs";

// Two robots on the same ground.
let page;

withPage(["--terrain", "boxes:6cm"], (parts) => ({ page } = parts));

const rival = () => page.evaluate(() => window.hexagait.rival());
const untilRival = (condition) => eventually(page, rival, condition);

test("G begins a race: a second robot of another gait walks as it is told, and both distances are shown", async () => {
  await press(page, "g");
  await untilRival((f) => f?.tripod && f.path > 0);
  await page.locator("#race[aria-pressed=true]").waitFor();
  await page.locator("#go").click();
  // Who is ahead depends on where the robots were put down, and so on when G was pressed.
  await until(page, (f) => f.path > 0.2 && f.rival?.path > 0.4);
  await says(page, "race-facts", /^free \d+\.\d\d m · tripod, pale: \d+\.\d\d m · (ahead|behind) by/);
  // Of one moment, also on a machine that draws slowly.
  const [own, other] = await page.evaluate(() => [window.hexagait.frame(), window.hexagait.rival()]);
  assert.equal(own.tick, other.tick);
  assert.ok(!own.tripod && other.tripod && own.path > 0.2 && own.path !== other.path, JSON.stringify([own.path, other.path]));
  await page.screenshot({ path: `${process.env.OUT}/race.png` });
});

test("the gait of the second robot changes, and it goes as it came", async () => {
  await page.locator("#race-gait").selectOption("clocked");
  await page.waitForFunction(() => window.hexagait.setup()?.race === "clocked");
  await page.locator("#race").click();
  await until(page, (f) => f.path >= 0);
  await page.waitForFunction(() => window.hexagait.setup()?.race === null && !window.hexagait.rival());
  await page.locator("#race-facts").waitFor({ state: "hidden" });
  assert.deepEqual(page.problems, []);
});
