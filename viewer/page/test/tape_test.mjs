// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { Player } from "./player.js";
import { Tape } from "./tape.js";

/** The head of a frame: see frame.js. */
function frame(scene, tick, time) {
  const view = new DataView(new ArrayBuffer(24));
  view.setUint32(4, scene, true);
  view.setUint32(8, tick, true);
  view.setFloat64(16, time, true);
  return new Uint8Array(view.buffer);
}
function tapeOf(seconds, span) {
  const tape = new Tape(span);
  tape.scene = { scene: 1 };
  for (let k = 0; k < 60 * seconds; ++k) tape.add(frame(1, k, k / 60));
  return tape;
}

test("a tape keeps the last minute, and no more", () => {
  const tape = tapeOf(600, 60);
  assert.ok(tape.entries.length < 60 * 60 + 70, `${tape.entries.length}`);
  assert.ok(tape.entry(tape.last).clock - tape.entry(tape.first).clock >= 60);
  assert.equal(tape.entry(tape.first).tick, tape.first);
  assert.equal(tape.at(599), 599 * 60);
});
test("a tape keeps a bounded number of frames, however slow the time is", () => {
  const tape = new Tape(60);
  tape.scene = { scene: 1 };
  for (let k = 0; k < 50000; ++k) tape.add(frame(1, k, k / 6000));
  assert.ok(tape.entries.length <= 36000, `${tape.entries.length}`);
});
test("the same tick again replaces it, and a frame of another scene is left out", () => {
  const tape = tapeOf(1);
  assert.ok(tape.add(frame(1, 59, 59 / 60)));
  assert.equal(tape.entries.length, 60);
  assert.ok(!tape.add(frame(2, 60, 1)));
});
test("time goes on from scene to scene", () => {
  const tape = tapeOf(1);
  tape.scene = { scene: 2 };
  tape.add(frame(2, 0, 0));
  tape.add(frame(2, 30, 0.5));
  assert.ok(Math.abs(tape.entry(tape.last).clock - (59 / 60 + 0.5)) < 1e-9);
  assert.equal(tape.before(tape.last, 8).length, 2);
});
test("a player shows all frames on the way on, and begins anew on the way back", () => {
  const tape = tapeOf(20), told = [];
  const player = new Player(tape, {
    show: ({ tick }) => told.push(tick), restart: (entries) => told.push([entries.length, entries.at(-1).tick]), window: 8,
  });
  player.seek(600);
  assert.deepEqual(told.splice(0), [[481, 600]]);
  player.step(1);
  assert.deepEqual(told.splice(0), [601]);
  player.step(-1);
  assert.deepEqual(told.splice(0), [[481, 600]]);
  player.playing = true;
  player.advance(0.05);
  assert.deepEqual(told.splice(0), [601, 602, 603]);
  player.speed = 0.5;
  player.advance(1 / 60);
  player.advance(1 / 60);
  assert.deepEqual(told.splice(0), [604]);
  assert.ok(player.advance(100));
  assert.equal(player.position, tape.last);
  assert.ok(!player.playing);
});
