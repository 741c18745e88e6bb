// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A line that is drawn by hand, as the points of a path.

export const kMostPoints = 100;
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

export const lengthOf = (line) => line.reduce((sum, p, k) => sum + (k ? apart(p, line[k - 1]) : 0), 0);

/** Points along a line, as far from each other as is said; its ends are among them. */
export function spaced(line, spacing) {
  const pieces = Math.max(1, Math.round(lengthOf(line) / spacing)), step = lengthOf(line) / pieces;
  const points = [line[0]];
  let gone = 0;
  for (let k = 1; k < line.length; ++k) {
    const [a, b] = [line[k - 1], line[k]], l = apart(a, b);
    for (; l > 0 && points.length < pieces && gone + l >= step * points.length; ) {
      const share = (step * points.length - gone) / l;
      points.push([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
    }
    gone += l;
  }
  return [...points, line.at(-1)];
}

/** A path along what a hand has drawn: without its trembling, of at most kMostPoints points; closed if it ends
 *  where it begins. @param line  [x, y] each [m]  @param spacing  of its points [m]
 *  @returns {points, closed}, or null if it is too short to be one */
export function pathAlong(line, spacing) {
  const length = lengthOf(line);
  if (line.length < 2 || length < spacing) return null;
  const fine = spaced(line, spacing / 4), reach = 2;
  const smooth = fine.map((p, k) => {
    const n = Math.min(reach, k, fine.length - 1 - k), near = fine.slice(k - n, k + n + 1);
    return [0, 1].map((i) => near.reduce((sum, q) => sum + q[i], 0) / near.length);
  });
  const closed = apart(line[0], line.at(-1)) < 1.5 * spacing && length > 8 * spacing;
  const points = spaced(smooth, Math.max(spacing, length / (kMostPoints - 2))).slice(0, kMostPoints);
  if (closed) points.pop();
  return { points: points.map((p) => p.map((v) => Math.round(1e3 * v) / 1e3)), closed };
}
