// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { why } from "./why.js";

const names = ["LF", "RF", "LM", "RM", "LR", "RR"];
const bits = (...legs) => legs.reduce((set, leg) => set | (1 << leg), 0);
// <><><> around LF RF RM RR LR LM: RF, RR and LM step first. All legs stand.
const frame = (change = {}) => ({
  state: 0b010101, moving: true, support: 0b111111, urgent: 0, waits: 0, mayStep: bits(1, 2, 5),
  legs: names.map((_, i) => ({ phase: 0, lag: 0.01 * i })), ...change,
});

test("a leg inside < a > may step", () => assert.match(why(frame(), 1, names), /^RF may step now. It is 1.0 cm behind/));
test("a leg waits for the neighbours that step first", () => {
  assert.match(why(frame(), 0, names), /^LF waits for LM and RF, which lag more/);
  // LM > LF, LF > RF: only LM is before LF.
  assert.match(why(frame({ state: 0b010100 }), 0, names), /^LF waits for LM, which lags more/);
});
test("a neighbour in the air is named", () => {
  assert.match(why(frame({ support: 0b111101 }), 0, names), /^LF waits for LM and RF: RF is in the air/);
  assert.match(why(frame({ support: 0b111110 }), 1, names), /^RF is next, once LF is down/);
});
test("a leg in the air says what it does", () => {
  const legs = frame().legs.map((leg, i) => (i === 3 ? { ...leg, phase: 5 } : leg));
  assert.equal(why(frame({ legs }), 3, names), "RM has hit something and goes around it.");
});
test("a leg that is held back, one that is urgent, and a robot that stands", () => {
  assert.match(why(frame({ waits: bits(1) }), 1, names), /^RF may step and is held back/);
  assert.match(why(frame({ urgent: bits(1) }), 1, names), /near the end of its reach/);
  assert.match(why(frame({ moving: false }), 1, names), /^RF stands, as the robot does/);
});
test("a leg that is lost is said to be, and its neighbours are side by side", () => {
  const lost = frame().legs.map((leg, i) => (i === 1 ? { ...leg, phase: 9 } : leg));
  assert.match(why(frame({ legs: lost }), 1, names), /^RF is lost/);
  // LF RM RR LR LM are left: LF < RM and LM < LF, so that LF waits for RM, and LM for LF.
  assert.match(why(frame({ legs: lost, state: 0b10001 }), 0, names), /^LF waits for RM, which lags more/);
});
