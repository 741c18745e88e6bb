// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { dirname, resolve } from "node:path";
import { test } from "node:test";
import { eventually, frameOf, openPage, press, says, until, withPage } from "./browser.mjs";

// The emergency stop, and a live robot: here a simulated one, in a process of its own.
const kPlantLate = 3, kEmergencyStop = 5;
const built = resolve(dirname(process.env.HEXAGAIT), "..");
const robot = resolve(built, "../../robots/argos.urdf");
let browser, server, page;

// The machine may stop the robot's process for a moment: the browser takes all processors.
withPage(["--late-limit", "3s", "--live", `${built}/examples/simulated_robot --real-time ${robot}`], (parts) => ({ browser, server, page } = parts));

/** Is it in the picture, in front of everything, and large enough for a finger? */
async function inSight(of, id) {
  const box = await of.locator(id).boundingBox(), { width, height } = of.viewportSize();
  assert.ok(box && box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height, JSON.stringify(box));
  assert.ok(box.width >= 44 && box.height >= 44, JSON.stringify(box));
  const front = await of.evaluate(([x, y]) => document.elementFromPoint(x, y)?.closest("button")?.id, [box.x + box.width / 2, box.y + box.height / 2]);
  assert.equal(`#${front}`, id);
}

test("a live robot stands until it is steered, and what needs a simulated one is not offered", async () => {
  assert.ok(!(await frameOf(page)).moving);
  await says(page, "facts", /^LIVE ROBOT argos/);
  for (const id of ["faults", "robot", "terrain", "push", "scramble", "reset", "race", "speed", "strip-cost"])
    assert.ok(await page.locator(`#${id}`).isHidden(), id);
  assert.ok(await page.locator("#pause").isDisabled());
  await press(page, "p");
  await press(page, " ");
  await page.locator("#go").click();
  await until(page, (f) => f.moving && f.path > 0.05);
  assert.ok(!(await frameOf(page)).paused);
  assert.doesNotMatch(await page.locator("#notice").textContent(), /a live robot can't/);  // nothing was asked for
});

test("the red button is in sight, stops the robot, and another one releases it", async () => {
  await inSight(page, "#estop");
  await page.locator("#estop").click();
  await until(page, (f, stop) => f.fault === stop, kEmergencyStop);
  await page.locator("#stopped").waitFor();
  await page.screenshot({ path: `${process.env.OUT}/live_stopped.png` });
  await says(page, "stopped-by", /by this page/);
  await page.locator("#estop").click();  // again: it is no switch
  await page.evaluate(() => {  // another notice may follow at once: that a busy machine's robot is late
    const notice = document.getElementById("notice");
    window.notices = [];
    new MutationObserver(() => window.notices.push(notice.textContent)).observe(notice, { childList: true });
  });
  await page.locator("#go").click();
  await eventually(page, () => page.evaluate(() => window.notices), (all) => all.some((words) => /release it first/.test(words)));
  assert.equal((await frameOf(page)).fault, kEmergencyStop);
  await page.locator("#release-estop").click();
  await until(page, (f) => f.fault === 0 && !f.moving);
  await page.locator("#stopped").waitFor({ state: "hidden" });
  await page.evaluate(() => { for (const end = performance.now() + 800; performance.now() < end;); });  // no beat
  const { tick } = await until(page, (f) => f.silent);
  await until(page, (f, seen) => f.tick > seen + 100, tick);
  assert.ok(!(await frameOf(page)).moving);  // what was refused is not done later
  await page.locator("#go").click();
  await until(page, (f) => f.moving);
});

test("a phone without the wheel stops it, in every mode; who steers releases it", async () => {
  const phone = await openPage(browser, server.url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await inSight(phone, "#estop");
  await phone.screenshot({ path: `${process.env.OUT}/phone_estop.png` });
  await phone.locator("#more").tap();
  await phone.evaluate(() => document.body.scrollTo(0, 400));
  await inSight(phone, "#estop");
  await phone.locator("#estop").tap();
  await until(page, (f, stop) => f.fault === stop, kEmergencyStop);
  await phone.locator("#stopped").waitFor();
  assert.ok(await phone.locator("#release-estop").isDisabled());
  await says(page, "stopped-by", /by page \d+/);
  assert.ok(await page.locator("#release-estop").isEnabled());
  await page.locator("#release-estop").click();
  await until(phone, (f) => f.fault === 0);
  assert.deepEqual(phone.problems, []);
  await phone.context().close();
});

test("Esc stops from inside a field, while the person looks back too", async () => {
  await press(page, "w");
  await until(page, (f) => f.moving);
  await press(page, "ArrowLeft");  // the robot goes on meanwhile
  await page.locator("#radius").focus();
  await page.keyboard.press("Escape");
  await page.locator("#stopped").waitFor();
  await press(page, "End");
  await until(page, (f, stop) => f.fault === stop, kEmergencyStop);
  assert.deepEqual(page.problems, []);
});

test("a robot that was silent for long is stopped, says so, and is released by the same button", async () => {
  await page.locator("#release-estop").click();
  await until(page, (f) => f.fault === 0);
  const process = execFileSync("pgrep", ["-P", String(server.pid)], { encoding: "utf8" }).trim();
  execFileSync("kill", ["-STOP", process]);
  await until(page, (f, late) => f.fault === late, kPlantLate);
  await page.locator("#stopped").waitFor();
  await says(page, "stopped", /STOPPED plant late/);
  assert.equal(await page.locator("#estop").getAttribute("aria-pressed"), "false");
  execFileSync("kill", ["-CONT", process]);
  await page.locator("#release-estop").click();
  await until(page, (f) => f.fault === 0);
  await page.locator("#stopped").waitFor({ state: "hidden" });
  assert.deepEqual(page.problems, []);
});
