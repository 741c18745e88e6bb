// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { eventually, frameOf, openPage, press, says, until, withPage } from "./browser.mjs";

// A path that is drawn on the ground, and one that comes along.
let browser, server, page;

withPage(["--terrain", "flat"], (parts) => ({ browser, server, page } = parts));

const route = () => page.evaluate(() => window.hexagait.setup()?.path);
const untilRoute = (condition) => eventually(page, route, condition);
const key = (name) => press(page, name);
/** Along points of the picture [px]. */
async function drag(points) {
  await page.mouse.move(...points[0]);
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...point, { steps: 12 });
  await page.mouse.up();
}

test("what is drawn on the ground is followed to its end, and its distance is shown", async () => {
  await key("x");
  await page.evaluate(() => window.hexagait.camera({ azimuth: -1.57, elevation: 1.3, distance: 4.5 }));
  await page.waitForTimeout(800);
  await key("f");
  assert.equal(await page.locator("#draw").getAttribute("aria-pressed"), "true");
  const azimuth = await page.evaluate(() => window.hexagait.camera({}).azimuth);
  await drag([[740, 420], [860, 330], [900, 250]]);
  const path = await untilRoute((now) => now?.points.length > 2);
  assert.ok(!path.closed);
  assert.equal(await page.evaluate(() => window.hexagait.camera({}).azimuth), azimuth);  // it drew, and did not turn
  assert.equal(await page.locator("#draw").getAttribute("aria-pressed"), "false");
  await until(page, (f) => f.follows && f.moving);
  await says(page, "heading", /cm (left|right) of its path/);
  await page.waitForTimeout(2500);
  await page.screenshot({ path: `${process.env.OUT}/path.png` });
  await page.locator("#speed").selectOption("4");
  for (const end = Date.now() + 20000; (await frameOf(page)).follows && Date.now() < end; ) await page.waitForTimeout(100);
  const f = await frameOf(page), [x, y] = path.points.at(-1);
  assert.ok(!f.follows && !f.moving && !f.fell);
  // Half a stroke: the page's silences stop the robot on a busy machine. followed_path_test.cpp has 3 cm.
  assert.ok(Math.hypot(f.p[0] - x, f.p[1] - y) < 0.1, `${f.p} is not at ${[x, y]}`);
  await says(page, "heading", /^at the end/);
  await page.locator("#speed").selectOption("1");
});

test("a path that comes along is followed; whoever steers leaves it", async () => {
  assert.deepEqual(await page.locator("#path option").allTextContents(),
    ["Follow …", ...(await page.evaluate(() => window.hexagait.scene().paths))]);
  await page.locator("#path").selectOption("square");
  await until(page, (f) => f.follows);
  assert.ok((await untilRoute((now) => now?.closed)).points.length > 10);
  await page.locator("#limit").fill("0.1");  // another speed, the same path
  await page.waitForTimeout(300);
  assert.ok((await frameOf(page)).follows);
  await page.locator("#limit").fill("0.4");
  await key("w");
  await until(page, (f) => !f.follows && f.moving);
  await untilRoute((now) => now === null);
});

test("a path that doubles back is refused in words, and nothing changes", async () => {
  await page.evaluate(() => window.hexagait.send({ type: "follow", points: [[0, 0], [3, 0], [2.9, 0]] }));
  await page.locator("#notice.on").waitFor();
  await says(page, "notice", /turns by 180° within .* it doubles back/);
  const f = await frameOf(page);
  assert.ok(!f.follows && f.moving);
  assert.equal(await route(), null);
});

test("on a phone a finger draws", async () => {
  assert.deepEqual(page.problems, []);
  await page.context().close();
  const phone = await openPage(browser, server.url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await phone.evaluate(() => window.hexagait.camera({ azimuth: -1.57, elevation: 1.2, distance: 6 }));
  await phone.waitForTimeout(800);
  await phone.locator("#draw").tap();
  const session = await phone.context().newCDPSession(phone);
  const touch = (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  await touch("touchStart", [195, 330]);
  for (let k = 1; k <= 12; ++k) await touch("touchMove", [195 + 8 * k, 330 - 12 * k]);
  await touch("touchEnd");
  await until(phone, (f) => f.follows);
  await phone.screenshot({ path: `${process.env.OUT}/phone_path.png` });
  assert.deepEqual(phone.problems, []);
  await phone.context().close();
});
