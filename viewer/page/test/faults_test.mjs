// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { frameOf, press, says, until, withPage } from "./browser.mjs";

// What breaks while it walks, on flat ground.
let page;
const kLost = 9;  // in place of a phase

withPage(["--terrain", "flat"], (parts) => ({ page } = parts));

const key = (name) => press(page, name);
const faults = async () => (await page.evaluate(() => window.hexagait.setup()))?.faults;
async function untilFaults(...wanted) {
  for (const end = Date.now() + 8000; Date.now() < end; await page.waitForTimeout(30))
    if (JSON.stringify(await faults()) === JSON.stringify(wanted)) return;
  assert.deepEqual(await faults(), wanted);
}
const listed = () => page.locator("#fault-list li").allTextContents();

test("C cuts off the chosen leg: it goes, the controller finds out, and walks on with five", async () => {
  await page.locator("#go").click();
  await key("4");
  await says(page, "cut", "Cut off RM");
  const { scene } = await frameOf(page);
  await key("c");
  await untilFaults("cut:RM");
  assert.deepEqual(await listed(), ["cut:RM"]);
  assert.deepEqual(await page.evaluate(() => window.hexagait.cut()), [3]);
  await until(page, (f, lost) => f.legs[3].phase === lost, kLost);
  await says(page, "why", /^RM is lost/);
  await says(page, "countdown", "");
  const { path } = await frameOf(page);
  await until(page, (f, before) => f.path > before + 0.15 && !f.fell, path);
  assert.equal((await frameOf(page)).scene, scene);
  await page.screenshot({ path: `${process.env.OUT}/lost_leg.png` });
});

test("M mends it, where it is", async () => {
  const { p, scene } = await frameOf(page);
  await key("m");
  await untilFaults();
  await until(page, (f, before) => f.scene > before, scene);
  const now = await frameOf(page);
  assert.ok(Math.hypot(now.p[0] - p[0], now.p[1] - p[1]) < 0.3);
  assert.deepEqual(await page.evaluate(() => window.hexagait.cut()), []);
  assert.ok(await page.locator("#mend").isDisabled());
});

test("with one leg on a side it stands, and says why", async () => {
  for (const leg of ["1", "3"]) {
    await key(leg);
    await key("c");
  }
  await untilFaults("cut:LF", "cut:LM");
  await until(page, (f) => f.refuses && !f.moving);
  await says(page, "state", "stands: too few legs left to walk");
  await key("m");
  await untilFaults();
  await until(page, (f) => !f.refuses && f.moving);
});

test("every kind of fault that the library knows can be chosen, with its legs, joints and values", async () => {
  const known = await page.evaluate(() => window.hexagait.scene().faults);
  const names = await page.locator("#fault-kind option").allTextContents();
  assert.deepEqual(names, known.map(({ syntax }) => syntax.split(":")[0]));
  for (const { syntax, values } of known) {
    await page.locator("#fault-kind").selectOption(syntax.split(":")[0]);
    const parts = await page.locator("#fault-part option").count();
    assert.equal(parts, syntax.includes("LEG") ? 6 : syntax.includes("JOINT") ? 18 : 0, syntax);
    assert.equal(await page.locator("#fault-values").inputValue(), values);
  }
  await page.locator("#fault-kind").selectOption("contact_late");
  await page.locator("#fault-part").selectOption("LR");
  await page.locator("#break").click();
  await untilFaults("contact_late:LR:50ms");
  await page.locator("#fault-kind").selectOption("noise");
  await page.locator("#fault-part").selectOption("RF_knee");
  await page.locator("#fault-values").fill("2mrad");
  await key("b");
  await untilFaults("contact_late:LR:50ms", "noise:RF_knee:2mrad");
});

test("a fault that is none is refused in words, and changes nothing", async () => {
  await page.locator("#fault-values").fill("90deg");
  await page.locator("#fault-values").press("Enter");
  await page.locator("#notice.on").waitFor();
  await says(page, "notice", /'90deg' must be an angle of up to 0.2 rad/);
  await untilFaults("contact_late:LR:50ms", "noise:RF_knee:2mrad");
});

test("N changes to a real plant and back, where the robot is; what is broken stays so", async () => {
  await key("n");
  await page.waitForFunction(() => window.hexagait.setup()?.plant === "real");
  await untilFaults("contact_late:LR:50ms", "noise:RF_knee:2mrad");
  assert.equal(await page.locator("#plant").inputValue(), "real");
  await until(page, (f) => f.path > 0.05 && !f.fell);
  await page.locator("#plant").selectOption("ideal");
  await page.waitForFunction(() => window.hexagait.setup()?.plant === "ideal");
  await key("Backspace");
  await untilFaults();
});

test("nothing went wrong in the page", () => assert.deepEqual(page.problems, []));
