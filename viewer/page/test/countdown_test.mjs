// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { Countdown } from "./countdown.js";

const kAll = 0b111111;
const frame = (time, up, state) => ({ time, support: kAll & ~up, state, moving: true, wave: false, tripod: false, legs: Array(6).fill({ phase: 0 }) });

// RF steps for 0.5 s, then RR and LM; the relations alternate at 0.75 s, which are 1.5 step times.
test("the bound counts down in step times, from the first lift on", () => {
  const c = new Countdown(6);
  c.take(frame(0, 0, 0b000111));
  assert.equal(c.words(frame(0, 0, 0b000111)), "");
  c.take(frame(1, 0b10, 0b000111));
  c.take(frame(1.5, 0b10, 0b000111));
  c.take(frame(1.6, 0, 0b001011));
  assert.equal(c.words(frame(1.6, 0, 0b001011)), "Alternates within 1.8 step times");
  c.take(frame(1.75, 0b100100, 0b010101));
  assert.equal(c.words(frame(1.75, 0, 0)), "Alternating after 1.5 < 3 step times");
  c.take(frame(9, 0, 0b000111));  // it is told once
  assert.match(c.words(frame(9, 0, 0)), /after 1\.5/);
});
test("steps that are not alike may take longer, and it is said", () => {
  const c = new Countdown(6);
  c.take(frame(0, 0b10, 0b000111));
  c.take(frame(0.5, 0b10, 0b000111));
  c.take(frame(2, 0, 0b000111));
  c.take(frame(4.5, 0, 0b000111));
  assert.match(c.words(frame(4.5, 0, 0b000111)), /^Over 3 step times/);
  c.take(frame(5, 0, 0b010101));
  assert.equal(c.words(frame(5, 0, 0b010101)), "Alternating after 10.0 step times");
});
test("both ways of alternating count; of clocked gaits it says nothing", () => {
  for (const state of [0b010101, 0b101010]) {
    const c = new Countdown(6);
    c.take(frame(0, 0b10, state));
    assert.match(c.words(frame(0, 0, state)), /^Alternating after 0\.0/);
    assert.equal(c.words({ ...frame(0, 0, state), wave: true }), "");
  }
});
