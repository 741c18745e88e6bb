// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, describe, test } from "node:test";
import { eventually, frameOf, openPage, press, says, serve, startBrowser, until } from "./browser.mjs";
import { openReplay } from "./replay.js";

const folder = mkdtempSync(join(tmpdir(), "hexagait-replay-"));
const record = join(folder, "walk.replay"), html = join(folder, "walk.html");
const measured = {};
let browser, page;
const shot = (of, name) => of.screenshot({ path: `${process.env.OUT}/${name}.png` });
const player = (of = page) => of.evaluate(() => window.hexagait.player());
const still = { reducedMotion: "reduce" };  // it does not play by itself

before(async () => {
  execFileSync(process.env.HEXAGAIT, ["walk", "--quiet", "--radius", "2", "--terrain", "boxes:10cm", "--seconds", "30",
    "--record", record, "--html", html], { stdio: "ignore" });
  browser = await startBrowser();
  page = await openPage(browser, pathToFileURL(html).href, still);
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
  writeFileSync(`${process.env.OUT}/measured_replay.json`, JSON.stringify(measured, null, 2) + "\n");
});

const key = (name, of = page) => press(of, name);
/** Sets the slider as a hand does. */
const scrub = (seconds, of = page) => of.locator("#scrub").fill(String(Math.round(1000 * seconds)));
/** Waits until the player is as asked. */
const untilPlayer = (condition, of = page) => eventually(of, () => player(of), condition);
async function feetAreRight(of) {
  const { frame, drawn } = await of.evaluate(() => window.hexagait.feet());
  frame.legs.forEach((leg, i) => {
    const off = Math.hypot(...leg.foot.map((v, j) => v - drawn[i][j]));
    assert.ok(off < 1e-3, `leg ${i} is ${off} m off`);
  });
}

test("30 s of argos are a page of at most 1 MB", () => {
  measured.replay_bytes = statSync(record).size;
  measured.html_bytes = statSync(html).size;
  assert.ok(measured.html_bytes < 1e6, `${measured.html_bytes} bytes`);
});

describe("a page from disk", () => {
  test("shows the walk from its beginning, and asks nobody", async () => {
    const p = await player();
    assert.deepEqual([p.position, p.first, p.playing], [0, 0, false]);
    assert.equal(p.last, 1499);  // 50 frames per second, from 0 on
    assert.equal((await frameOf(page)).time, 0);
    await says(page, "clock", "0.00 of 29.98 s");
    assert.match(await page.title(), /^argos on boxes:0\.1/);
    await feetAreRight(page);
  });
  test("Space plays: the robot moves, and the slider and the clock with it", async () => {
    const before = await frameOf(page), slider = await page.locator("#scrub").inputValue();
    await key("Space");
    await until(page, (f, path) => f.path > path + 0.2, before.path);
    await says(page, "state", "plays");
    assert.ok(Number(await page.locator("#scrub").inputValue()) > Number(slider));
    await key("Space");
    await untilPlayer((p) => !p.playing);
    const stopped = await player();
    await page.waitForTimeout(300);
    assert.equal((await player()).position, stopped.position);
  });
  test("the slider goes to a time", async () => {
    await scrub(20);
    await untilPlayer((p) => Math.abs(p.clock - 20) < 0.021);
    await until(page, (f) => Math.abs(f.time - 20) < 0.021);
    await feetAreRight(page);
    await says(page, "clock", "20.00 of 29.98 s");
    await shot(page, "replay");
  });
  test("one frame back shows the pose before, and one on the pose again", async () => {
    const now = await frameOf(page), { position } = await player();
    await key("ArrowLeft");
    await untilPlayer((p) => p.position === position - 1);
    const before = await frameOf(page);
    assert.ok(Math.abs(now.time - before.time - 0.02) < 1e-4);
    assert.notDeepEqual(before.legs.map(({ q }) => q), now.legs.map(({ q }) => q));
    await feetAreRight(page);
    await page.locator("#back").click();
    await untilPlayer((p) => p.position === position - 2);
    await page.locator("#step").click();
    await key("ArrowRight");
    await untilPlayer((p) => p.position === position);
    assert.deepEqual(await frameOf(page), now);
  });
  test("Home and End go to the ends, and it plays no further", async () => {
    await key("End");
    await untilPlayer((p) => p.position === p.last);
    await key("ArrowRight");
    assert.equal((await player()).position, (await player()).last);
    await key("Home");
    await untilPlayer((p) => p.position === 0);
    await key("ArrowLeft");
    assert.equal((await player()).position, 0);
    await scrub(29.5);
    await untilPlayer((p) => p.clock > 29);
    await key("Space");
    await untilPlayer((p) => p.position === p.last && !p.playing);
    await says(page, "state", "at the end");
    await key("Space");  // from the beginning again
    await untilPlayer((p) => p.playing && p.clock < 5);
    await key("Space");
  });
  test("plays as fast as is chosen", async () => {
    const pace = async (factor) => {
      await scrub(2);
      await page.locator("#speed").selectOption(factor);
      await untilPlayer((p) => Math.abs(p.clock - 2) < 0.03);
      await key("Space");
      const from = await page.evaluate(() => [performance.now(), window.hexagait.player().clock]);
      await page.waitForTimeout(1500);
      const to = await page.evaluate(() => [performance.now(), window.hexagait.player().clock]);
      await key("Space");
      return (1000 * (to[1] - from[1])) / (to[0] - from[0]);
    };
    const slow = await pace("0.25"), fast = await pace("4");
    // A machine that draws less than four pictures a second plays more slowly.
    assert.ok(slow > 0.03 && slow < 0.4, `${slow}`);
    assert.ok(fast > 4 * slow && fast < 4.6, `${fast}, ${slow}`);
    await page.locator("#speed").selectOption("1");
  });
  test("a click on the ground steers nothing, and neither do the keys", async () => {
    const before = await frameOf(page);
    await page.mouse.click(640, 420);
    for (const name of ["w", "a", "x", "r", "Backspace"]) await key(name);
    assert.deepEqual(await frameOf(page), before);
  });
  test("runs no script but its own", async () => {
    const ran = await page.evaluate(() => {
      const script = document.createElement("script");
      script.textContent = "window.foreign = true";
      document.body.append(script);
      return window.foreign === true;
    });
    assert.equal(ran, false);
    page.problems = page.problems.filter((problem) => !problem.includes("Content Security Policy"));
    assert.deepEqual(page.problems, []);
  });
  test("plays by itself, in the dark and on a phone", async () => {
    const dark = await openPage(browser, pathToFileURL(html).href, { colorScheme: "dark" });
    await until(dark, (f) => f.path > 0.1);
    await shot(dark, "replay_dark");
    assert.deepEqual(dark.problems, []);
    await dark.context().close();
    const phone = await openPage(browser, pathToFileURL(html).href, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await phone.waitForTimeout(1000);
    await shot(phone, "replay_phone");
    const wide = await phone.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `${wide} px wide`);
    await phone.context().close();
  });
  test("of a damaged replay says that it can't be played", async () => {
    const bad = join(folder, "bad.html");
    writeFileSync(bad, readFileSync(html, "utf8").replace(/(id="replay">.{2000}).{400}/, `$1${"A".repeat(400)}`));
    const context = await browser.newContext(), broken = await context.newPage();
    await broken.goto(pathToFileURL(bad).href);
    await says(broken, "state", "the replay is cut off or damaged");
    await context.close();
  });
});

describe("a page from the server", () => {
  test("plays the same", async () => {
    const server = await serve("replay", record, "--port", "0");
    const served = await openPage(browser, server.url, still);
    await served.waitForFunction(() => window.hexagait.player().last === 1499);
    await scrub(20, served);
    await untilPlayer((p) => Math.abs(p.clock - 20) < 0.021, served);
    await scrub(20);
    await untilPlayer((p) => Math.abs(p.clock - 20) < 0.021);
    assert.deepEqual(await frameOf(served), await frameOf(page));
    await server.stop();
    await key("ArrowRight", served);  // it has all that it needs
    await until(served, (f) => f.time > 20.01);
    assert.deepEqual(served.problems, []);
    await served.context().close();
  });
});

test("bytes that are no replay are refused in words", async () => {
  const bytes = new Uint8Array(readFileSync(record));
  await assert.rejects(openReplay(bytes.subarray(0, bytes.length - 20)), /cut off or damaged/);
  await assert.rejects(openReplay(new TextEncoder().encode("an ordinary text file")), /no replay/);
  const other = bytes.slice();
  other[8] = 9;
  await assert.rejects(openReplay(other), /version 9; this page plays version 1/);
  const tape = await openReplay(bytes);
  assert.equal(tape.entries.length, 1500);
});
