// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { frameOf, openPage, press, says, startBrowser, startServer, until } from "./browser.mjs";

// Low ground: what is tested are the page's controls, one sharp turn after the other. Over boxes of 10 cm
// the robot falls over some of them.
const kGround = ["--terrain", "boxes:4cm"];
let browser, server, page;
const measured = {};
const shot = (of, name) => of.screenshot({ path: `${process.env.OUT}/${name}.png` });

before(async () => {
  browser = await startBrowser();
  server = await startServer("--port", "0", ...kGround);
  page = await openPage(browser, server.url);
});
after(async () => {
  await browser?.close();
  await server?.stop();
  writeFileSync(`${process.env.OUT}/measured.json`, JSON.stringify(measured, null, 2) + "\n");
});

/** From the middle of an element, a drag by so much [px]. */
async function drag(selector, from, to) {
  const box = await page.locator(selector).boundingBox();
  const at = ([x, y]) => [box.x + (0.5 + x) * box.width, box.y + (0.5 + y) * box.height];
  await page.mouse.move(...at(from));
  await page.mouse.down();
  for (let k = 1; k <= 8; ++k) await page.mouse.move(...at(from.map((v, i) => v + ((to[i] - v) * k) / 8)));
  await page.mouse.up();
}
const key = (name) => press(page, name);
const click = (id) => page.locator(`#${id}`).click();
async function reset() {
  const { scene } = await frameOf(page);
  await key("Backspace");
  await until(page, (f, s) => f.scene > s && !f.paused, scene);
}
const curvature = (f) => f.k / f.rho;

// How long it took is measured, and not judged: machines differ, and are busy.
test("the robot is drawn, and walks", async () => {
  measured.drawn_after_ms = page.drawnAfter;
  const before = await frameOf(page);
  await until(page, (f, path) => f.path > path + 0.1, before.path);
  await shot(page, "light");
});

test("feet are drawn where they are in the simulator", async () => {
  for (let k = 0; k < 5; ++k) {
    const { frame, drawn } = await page.evaluate(() => window.hexagait.feet());
    frame.legs.forEach((leg, i) => {
      const off = Math.hypot(...leg.foot.map((v, j) => v - drawn[i][j]));
      assert.ok(off < 1e-3, `leg ${i} is ${off} m off`);
    });
    await page.waitForTimeout(150);
  }
});

describe("steering", () => {
  test("the wheel bends the path", async () => {
    await reset();
    await page.locator("#wheel").focus();
    await page.keyboard.press("Home");
    await until(page, (f) => f.k === 0 && f.moving);
    // A quarter of a turn, of 150 degrees to the stop at 2 per metre: 2 (90/150)².
    await drag("#wheel", [0, -0.4], [-0.4, 0]);
    await until(page, (f) => Math.abs(f.k / f.rho - 0.72) < 0.05);
    await drag("#wheel", [0, -0.4], [0.4, 0]);
    await drag("#wheel", [0, -0.4], [0.4, 0]);
    await until(page, (f) => Math.abs(f.k / f.rho + 0.72) < 0.05);
    assert.equal((await frameOf(page)).holder, await page.evaluate(() => window.hexagait.you()));
  });
  test("the wheel turns by keys, and says its value", async () => {
    const before = curvature(await frameOf(page));
    await page.locator("#wheel").focus();
    await page.keyboard.press("ArrowLeft");
    await until(page, (f, k) => f.k / f.rho > k + 0.001, before);
    const now = Number(await page.locator("#wheel").getAttribute("aria-valuenow"));
    assert.ok(Math.abs(now - curvature(await frameOf(page))) < 0.01);
    await page.keyboard.press("Home");
    await until(page, (f) => f.k === 0);
  });
  test("the dial sets the crab angle", async () => {
    await drag("#dial", [0, -0.4], [-0.4, 0]);
    await until(page, (f) => Math.abs(f.crab - Math.PI / 2) < 0.1);
    await page.locator("#dial").focus();
    await page.keyboard.press("Home");
    await until(page, (f) => f.crab === 0);
  });
  test("radius and crab angle can be typed", async () => {
    await page.locator("#radius").fill("-1.25");
    await page.locator("#radius").press("Enter");
    await page.locator("#crab").fill("30");
    await page.locator("#crab").press("Enter");
    await until(page, (f) => Math.abs(f.rho / f.k + 1.25) < 0.01 && Math.abs(f.crab - Math.PI / 6) < 1e-3);
    await page.locator("#radius").fill("inf");
    await page.locator("#radius").press("Enter");
    await until(page, (f) => f.k === 0);
  });
  test("keys W S A D Q E X", async () => {
    await key("s");
    await until(page, (f) => Math.abs(Math.abs(f.crab) - Math.PI) < 1e-5);
    await key("w");
    await until(page, (f) => f.crab === 0 && f.moving);
    await key("a");
    await until(page, (f) => f.k > 0);
    await key("d");
    await key("d");
    await until(page, (f) => f.k < 0);
    await key("q");
    await until(page, (f) => Math.abs(f.crab - Math.PI / 12) < 1e-5);
    await key("e");
    await key("e");
    await until(page, (f) => Math.abs(f.crab + Math.PI / 12) < 1e-5);
    await key("x");
    await until(page, (f) => !f.moving);
  });
  test("the speed has a limit", async () => {
    await reset();
    await click("go");
    await page.locator("#limit").fill("0.04");
    await page.waitForTimeout(2500);
    await until(page, (f) => f.moving && Math.hypot(f.vx, f.vy) < 0.06);
    await page.waitForTimeout(500);
    assert.ok(Math.hypot((await frameOf(page)).vx, (await frameOf(page)).vy) < 0.07);
    await page.locator("#limit").fill("0.4");
    await says(page, "limit-out", "none");
    await until(page, (f) => Math.hypot(f.vx, f.vy) > 0.12);
  });
  test("spin, stop and go", async () => {
    await click("spin-left");
    await until(page, (f) => f.rho < 1e-6 && f.k > 0 && f.moving);
    await click("spin-right");
    await until(page, (f) => f.rho < 1e-6 && f.k < 0);
    await click("stop");
    await until(page, (f) => !f.moving);
    await click("go");
    await until(page, (f) => f.moving && f.rho > 0);
  });
  test("a click on the ground circles that point", async () => {
    await reset();
    await page.evaluate(() => window.hexagait.camera({ azimuth: -1.57, elevation: 1.3, distance: 4.5 }));
    await page.waitForTimeout(600);
    await page.mouse.click(560, 330);
    await until(page, (f) => Math.abs(f.rho / f.k - 3) > 0.05 && f.holder > 0);
    const f = await frameOf(page), r = Math.hypot(f.centre[0] - f.p[0], f.centre[1] - f.p[1]);
    assert.ok(r > 0.2 && r < 4, `radius ${r}`);
    assert.ok(Math.abs(r - Math.abs(f.rho / f.k)) < 0.02);
    await shot(page, "circle");
    await page.evaluate(() => window.hexagait.camera({ azimuth: -2.35, elevation: 0.52, distance: 2.7 }));
  });
});

describe("time", () => {
  test("Space pauses, and the right arrow makes one tick", async () => {
    await key("Space");
    await until(page, (f) => f.paused);
    const before = await frameOf(page);
    await key("ArrowRight");
    await until(page, (f, tick) => f.tick === tick + 1, before.tick);
    await page.waitForTimeout(200);
    assert.equal((await frameOf(page)).tick, before.tick + 1);
    await click("step");
    await until(page, (f, tick) => f.tick === tick + 2, before.tick);
    await key("Space");
    await until(page, (f, tick) => !f.paused && f.tick > tick + 10, before.tick);
  });
  test("the speed of time changes", async () => {
    await page.locator("#speed").selectOption("0.25");
    await until(page, (f) => f.factor < 0.35);
    await page.locator("#speed").selectOption("1");
    await until(page, (f) => f.factor > 0.8);
  });
});

describe("things to try", () => {
  test("R scrambles the legs where the robot stands", async () => {
    const before = await frameOf(page);
    await key("r");
    await until(page, (f, scene) => f.scene > scene, before.scene);
    const now = await frameOf(page);
    assert.ok(Math.hypot(now.p[0] - before.p[0], now.p[1] - before.p[1]) < 0.3);
  });
  test("a robot that is scrambled says when its legs alternate", async () => {
    await reset();
    await click("go");
    const { scene } = await frameOf(page);
    await key("r");
    await until(page, (f, before) => f.scene > before, scene);
    await page.waitForTimeout(300);
    await says(page, "countdown", /^(Alternates within|Alternating after) /);
  });
  test("P pushes the body aside", async () => {
    await reset();
    await key("x");
    await until(page, (f) => !f.moving && Math.hypot(f.vx, f.vy) < 1e-3);
    await key("p");
    await until(page, (f) => Math.abs(f.vy) > 5e-3);
  });
  test("the gait changes while it walks", async () => {
    await click("gait-wave");
    await until(page, (f) => f.wave);
    await page.locator("#gait-wave[aria-pressed=true]").waitFor();
    await page.locator("#duty").fill("0.83");
    await click("gait-tripod");
    await until(page, (f) => f.tripod);
    await click("gait-free");
    await until(page, (f) => !f.tripod && !f.wave);
  });
  test("another ground, another height, another robot", async () => {
    const scene = () => page.evaluate(() => window.hexagait.scene());
    await page.locator("#terrain").selectOption("steps");
    await page.waitForFunction(() => window.hexagait.scene().terrain.startsWith("steps:"));
    await page.locator("#roughness").fill("5");
    await page.waitForFunction(() => window.hexagait.scene().terrain === "steps:0.05");
    await shot(page, "steps");
    await page.locator("#robot").selectOption("hexapod_4dof");
    await page.waitForFunction(() => window.hexagait.scene().legs[0].joints.length === 4);
    await until(page, (f) => f.path > 0.05);
    const feet = await page.evaluate(() => window.hexagait.feet());
    feet.frame.legs.forEach((leg, i) => assert.ok(Math.hypot(...leg.foot.map((v, j) => v - feet.drawn[i][j])) < 1e-3));
    await shot(page, "four_joints");
    assert.equal((await scene()).legs.length, 6);
  });
  test("Backspace begins again, as it began", async () => {
    await reset();
    assert.equal((await page.evaluate(() => window.hexagait.scene())).terrain, "boxes:0.04");
    await until(page, (f) => f.moving && Math.abs(f.rho / f.k - 3) < 0.01);
  });
});

test("a sentence says why a leg steps or does not", async () => {
  await key("x");
  await until(page, (f) => !f.moving && f.contact === 0b111111);
  await key("4");
  await says(page, "why", /^RM stands, as the robot does\. It is \d+\.\d cm/);
  await page.locator("#ring").click({ position: { x: 22, y: 14 } });
  await says(page, "why", /^LF /);
});

describe("who steers", () => {
  test("a second page watches until the wheel is free", async () => {
    await click("go");
    const second = await openPage(browser, server.url);
    await second.locator("#stop").click();
    await second.locator("#notice.on").waitFor();
    await says(second, "notice", /another page/);
    await says(second, "state", /another page/);
    await page.evaluate(() => window.hexagait.send({ type: "release" }));
    await until(second, (f) => f.holder === 0);
    await second.locator("#spin-left").click();
    await until(second, (f, you) => f.holder === you, await second.evaluate(() => window.hexagait.you()));
    await second.context().close();
    await until(page, (f) => f.holder === 0 && !f.moving);
  });
  test("the robot stops when the page that steers hangs", async () => {
    await click("go");
    await until(page, (f) => f.moving && f.holder > 0);
    const watcher = await openPage(browser, server.url);
    const hang = (ms) => page.evaluate((length) => { const end = performance.now() + length; while (performance.now() < end); }, ms);
    const short = hang(1000);
    await until(watcher, (f) => f.silent && !f.moving);
    await short;
    await until(watcher, (f) => !f.silent && f.moving);  // a hiccup: it goes on
    const long = hang(2700);
    await until(watcher, (f) => f.silent && !f.moving);
    await long;
    await page.waitForTimeout(1000);
    assert.ok((await frameOf(watcher)).silent);  // too long: it waits for a hand
    await click("go");
    await until(watcher, (f) => !f.silent && f.moving);
    await watcher.context().close();
  });
  test("a foreign page gets no connection", async () => {
    const context = await browser.newContext();
    const foreign = await context.newPage();
    await foreign.goto("about:blank");
    const outcome = await foreign.evaluate((port) => new Promise((resolve) => {
      const socket = new WebSocket(`ws://127.0.0.1:${port}/ws`);
      socket.onopen = () => resolve("open");
      socket.onerror = () => resolve("refused");
    }), server.port);
    assert.equal(outcome, "refused");
    await context.close();
  });
});

describe("looks", () => {
  test("dark, and on a phone held upright", async () => {
    const dark = await openPage(browser, server.url, { colorScheme: "dark", reducedMotion: "reduce" });
    await dark.waitForTimeout(2500);
    await shot(dark, "dark");
    await dark.context().close();
    const phone = await openPage(browser, server.url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await phone.waitForTimeout(1000);
    await shot(phone, "phone");
    await phone.locator("#more").tap();
    await phone.waitForTimeout(600);
    await shot(phone, "phone_panels");
    const wide = await phone.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `${wide} px wide`);
    await phone.context().close();
  });
  test("as well as a machine with a graphics card draws it", async () => {
    await reset();
    const fine = await openPage(browser, server.url, { viewport: { width: 1200, height: 760 } });
    await until(fine, (f) => f.moving && f.path > 0.2);
    await fine.evaluate(() => { window.hexagait.quality(1); window.hexagait.camera({ azimuth: -2.0, elevation: 0.5, distance: 2.5 }); });
    await fine.waitForTimeout(2000);
    await shot(fine, "fine");
    await fine.context().close();
  });
  test("everything that can be operated has a name and is reached by Tab", async () => {
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll("button, select, input, [role=slider]")]
        .filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.closest("label")))
        .map((e) => e.id));
    assert.deepEqual(nameless, []);
    const sliders = await page.evaluate(() => [...document.querySelectorAll("[role=slider]")].every((e) => e.tabIndex === 0));
    assert.ok(sliders);
  });
  test("finds a quality that the machine can draw", async () => {
    await page.waitForTimeout(5000);
    const from = await page.evaluate(() => ({ drawn: window.hexagait.view().drawn, at: performance.now() }));
    await page.waitForTimeout(5000);
    const to = await page.evaluate(() => ({ ...window.hexagait.view(), at: performance.now() }));
    measured.pictures_per_second = (1000 * (to.drawn - from.drawn)) / (to.at - from.at);
    measured.quality_level = to.level;
    assert.ok(to.software);
    // 20 a second are asked for; a machine that is busy with other things gives less. So it is measured,
    // and judged only by whether it draws.
    assert.ok(to.level > 0);
    assert.ok(to.drawn > from.drawn);
  });
});

test("comes back when the server does", async () => {
  assert.deepEqual(page.problems, []);
  const port = server.port;
  await server.stop();
  await says(page, "state", "not connected");
  server = await startServer("--port", port, ...kGround);
  await says(page, "state", /^walking/);
  const { path } = await frameOf(page);
  await until(page, (f, before) => f.path !== before, path);
});
