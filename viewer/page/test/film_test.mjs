// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The moving picture at the top of the README: docs/steer.gif is what this leaves in OUT with FILM=1. Without, a
// short one: taking pictures of ten seconds takes minutes.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { test } from "node:test";
import { frameOf, openPage, startBrowser, startServer } from "./browser.mjs";
import { gifOf } from "./gif.mjs";

const kSize = { viewport: { width: 1100, height: 700 }, deviceScaleFactor: 0.7 };
const kBegin = 4, kLength = process.env.FILM ? 10 : 2, kEvery = 0.125;  // of simulated time [s]
const kMostBytes = 1.5e6;
// What a person presses, and when [s].
const kKeys = [[1.5, "a"], [1.9, "a"], [4.5, "d"], [4.8, "d"], [5.1, "d"], [5.4, "d"], [7.5, "q"], [7.9, "q"]];

async function waitUntil(page, time) {
  for (let frame = await frameOf(page); ; await page.waitForTimeout(10), frame = await frameOf(page))
    if (frame.time >= time) return frame;
}

const go = (page, factor) => page.evaluate((f) => window.hexagait.send({ type: "speed", factor: f }), factor);

/** How slow the walk must be for this machine to take a picture as often as it is due. */
async function factorFor(page) {
  const begin = Date.now(), kShots = 3;
  for (let k = 0; k < kShots; ++k) await page.screenshot();
  const shot = (Date.now() - begin) / 1000 / kShots;
  return Math.min(1, Math.max(0.05, kEvery / (2 * shot)));
}

async function film(page) {
  const shots = [], keys = [...kKeys];
  for (let due = kBegin; due < kBegin + kLength;) {
    const frame = await waitUntil(page, due);
    while (keys.length && frame.time >= kBegin + keys[0][0]) await page.keyboard.press(keys.shift()[1]);
    shots.push({ png: await page.screenshot(), time: frame.time, path: frame.path });
    due = Math.max(due + kEvery, frame.time);
  }
  return shots;
}

test("a film of the page, of a robot that is steered over rough ground", async () => {
  const server = await startServer("--port", "0", "--terrain", "boxes:10cm", "--speed", "0.2");
  const browser = await startBrowser();
  try {
    const page = await openPage(browser, server.url, kSize);
    await page.evaluate(() => window.hexagait.quality(1));
    await page.evaluate(() => window.hexagait.camera({ azimuth: -2.65, elevation: 0.55, distance: 3.1 }));
    const factor = await factorFor(page);
    await go(page, 1);
    await waitUntil(page, kBegin - 1);
    await go(page, factor);
    await waitUntil(page, kBegin - kEvery);
    await page.evaluate(() => window.hexagait.camera({ still: true }));
    const shots = await film(page);
    const gif = gifOf(shots, 1.5);
    writeFileSync(`${process.env.OUT}/steer.gif`, gif);
    const last = shots.at(-1), seconds = last.time - shots[0].time;
    assert.ok(gif.length <= kMostBytes, `${gif.length} bytes`);
    assert.ok(seconds > 0.9 * kLength && seconds < 1.2 * kLength, `${seconds} s`);
    assert.ok(shots.length > 0.5 * kLength / kEvery, `${shots.length} pictures`);
    assert.ok(last.path - shots[0].path > 0.1 * kLength, `it walked ${last.path - shots[0].path} m`);
    assert.deepEqual(page.problems, []);
  } finally {
    await browser.close();
    await server.stop();
  }
});
