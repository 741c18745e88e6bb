// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { kMostPoints, lengthOf, pathAlong, spaced } from "./path.js";

test("points are as far apart as is said, from end to end", () => {
  const points = spaced([[0, 0], [1, 0], [1, 1]], 0.25);
  assert.equal(points.length, 9);
  assert.deepEqual([points[0], points[4], points.at(-1)], [[0, 0], [1, 0], [1, 1]]);
});
test("a trembling line becomes a smooth path between its ends", () => {
  const line = Array.from({ length: 201 }, (_, k) => [0.01 * k, 0.01 * (k % 2)]);
  const { points, closed } = pathAlong(line, 0.2);
  assert.ok(!closed);
  assert.deepEqual([points[0], points.at(-1)], [[0, 0], [2, 0]]);
  assert.ok(lengthOf(points) < 2.01, `${lengthOf(points)}`);
});
test("a loop is closed, without its first point again", () => {
  const line = Array.from({ length: 101 }, (_, k) => [Math.cos(0.0628 * k), Math.sin(0.0628 * k)]);
  const { points, closed } = pathAlong(line, 0.2);
  assert.ok(closed);
  const gap = Math.hypot(points[0][0] - points.at(-1)[0], points[0][1] - points.at(-1)[1]);
  assert.ok(gap > 0.1 && gap < 0.4, `${gap}`);
});
test("a click is no path, and a long way has no more points than the server takes", () => {
  assert.equal(pathAlong([[0, 0]], 0.2), null);
  assert.equal(pathAlong([[0, 0], [0.01, 0]], 0.2), null);
  const line = Array.from({ length: 5001 }, (_, k) => [0.02 * k, 0]);
  assert.ok(pathAlong(line, 0.2).points.length <= kMostPoints);
});
