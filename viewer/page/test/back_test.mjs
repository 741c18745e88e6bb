// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { frameOf, press, says, until, withPage } from "./browser.mjs";

let page;
const shot = (of, name) => of.screenshot({ path: `${process.env.OUT}/${name}.png` });

withPage(["--terrain", "boxes:4cm"], (parts) => ({ page } = parts));

const key = (name) => press(page, name);
async function reset() {
  const { scene } = await frameOf(page);
  await key("Backspace");
  await until(page, (f, s) => f.scene > s && !f.paused, scene);
}

describe("a gamepad", () => {
  /** What the pad that the page sees does. */
  const pad = (axes, down = []) =>
    page.evaluate(([axes, down]) => {
      const buttons = Array.from({ length: 17 }, (_, k) => ({ pressed: down.includes(k) }));
      navigator.getGamepads = () => [null, { connected: true, mapping: "standard", axes, buttons }];
    }, [axes, down]);
  test("drives while its left stick is held, and stops when it is let go", async () => {
    await reset();
    await pad([0, -1, 0, 0]);
    await until(page, (f) => f.moving && f.k === 0 && f.crab === 0 && f.holder > 0);
    await pad([-0.7, -0.7, 0, 0]);  // to the left: 2 (0.707)² per metre
    await until(page, (f) => Math.abs(f.k / f.rho - 1) < 0.1);
    await pad([0.1, 0.1, 0, 0]);    // about the middle
    await until(page, (f) => !f.moving);
    await pad([0, 1, 0, 0]);
    await until(page, (f) => f.moving && Math.abs(Math.abs(f.crab) - Math.PI) < 1e-5);
    await page.evaluate(() => { navigator.getGamepads = () => [null]; });  // pulled out
    await until(page, (f) => !f.moving);
  });
  test("turns the crab angle by its right stick, and has buttons", async () => {
    await pad([0, -1, -1, 0]);
    await until(page, (f) => f.moving && Math.abs(f.crab - Math.PI / 2) < 0.05);
    await pad([0, 0, 0, 0]);
    await until(page, (f) => !f.moving);
    await pad([0, 0, 0, 0], [4]);
    await until(page, (f) => f.moving && f.rho < 1e-6 && f.k > 0);
    await pad([0, 0, 0, 0], [1]);
    await until(page, (f) => !f.moving);
    await pad([0, 0, 0, 0], [9]);
    await until(page, (f) => f.paused);
    await pad([0, 0, 0, 0]);
    await page.waitForTimeout(200);
    await pad([0, 0, 0, 0], [9]);
    await until(page, (f) => !f.paused);
    await page.evaluate(() => { navigator.getGamepads = () => []; });
    await reset();
  });
});

describe("looking back", () => {
  test("← looks back at the poses before, frame by frame, and → comes back", async () => {
    // The frames before are of the same scene, whose ticks are compared: on a busy machine it may be one tick old.
    await until(page, (f) => f.tick > 50);
    await key("Space");
    await until(page, (f) => f.paused);
    await page.waitForTimeout(300);
    const player = () => page.evaluate(() => window.hexagait.player());
    const now = await frameOf(page), { position } = await player();
    await key("ArrowLeft");
    await until(page, (f, tick) => f.tick < tick, now.tick);
    const before = await frameOf(page);
    assert.notDeepEqual(before.legs.map(({ q }) => q), now.legs.map(({ q }) => q));
    const { frame, drawn } = await page.evaluate(() => window.hexagait.feet());
    frame.legs.forEach((leg, i) => assert.ok(Math.hypot(...leg.foot.map((v, j) => v - drawn[i][j])) < 1e-3));
    await page.locator("#back").click();
    assert.equal((await player()).position, position - 2);
    await page.locator("#step").click();
    await key("ArrowRight");
    assert.deepEqual((await frameOf(page)).legs, now.legs);
    await key("ArrowRight");  // at the end: one tick of the walk
    await until(page, (f, tick) => f.tick === tick + 1, now.tick);
    assert.ok((await player()).follows);
  });
  test("the slider looks back while the walk waits; End goes on with it", async () => {
    await key("Space");
    await until(page, (f, tick) => !f.paused && f.tick > tick, (await frameOf(page)).tick);
    // However fast the tests before were, there are two seconds to look back on.
    await page.waitForFunction(() => {
      const { begin, end } = window.hexagait.player();
      return end - begin > 2.2;
    });
    const { end } = await page.evaluate(() => window.hexagait.player());
    await page.locator("#scrub").fill(String(Math.round(1000 * (end - 2))));
    await page.waitForFunction((now) => window.hexagait.player().clock < now - 1, end);
    await says(page, "state", "looks back");
    await page.waitForTimeout(400);
    const waits = await page.evaluate(() => window.hexagait.player().end);
    await page.waitForTimeout(500);
    assert.equal(await page.evaluate(() => window.hexagait.player().end), waits);
    await shot(page, "back");
    await key("End");
    await page.waitForFunction((now) => window.hexagait.player().clock > now + 0.2, waits);
    await says(page, "clock", "now");
  });
  test("whoever steers is back at the walk that goes on", async () => {
    await key("ArrowLeft");
    await page.waitForFunction(() => !window.hexagait.player().follows);
    await key("a");
    await until(page, (f) => f.k > 0 && !f.paused);
    assert.ok(await page.evaluate(() => window.hexagait.player().follows));
  });
});

test("nothing went wrong in the page", () => assert.deepEqual(page.problems, []));
