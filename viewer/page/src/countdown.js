// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long it takes until the legs step in alternating groups, the tripod gait of six legs. With CCN = n/2, equal
// step times, and legs that step as soon as they may, it is less than n/2 step times: docs/theory.md, Convergence.
import { has, isLost } from "./frame.js";

/** The relations around the ring alternate: < > < > …. */
const alternates = (state, n) => {
  const even = Array.from({ length: n }, (_, k) => (k % 2 === 0 ? 1 << k : 0)).reduce((a, b) => a | b);
  return state === even || state === (even << 1);
};

export class Countdown {
  /** @param n  legs */
  constructor(n) {
    this.n = n;
    this.lifted = Array(n).fill(null);  // when each leg that is up has left the ground [s]
    this.longest = 0;                   // step so far [s]
    this.begun = this.taken = null;     // when the first leg has lifted; after how many step times [1] it was so
    this.elapsed = 0;                   // step times since then
  }

  take(frame) {
    if (this.taken !== null) return;
    for (let leg = 0; leg < this.n; ++leg) {
      if (has(frame.support, leg)) this.lifted[leg] = null;
      else this.lifted[leg] ??= frame.time;
      if (this.lifted[leg] !== null) this.longest = Math.max(this.longest, frame.time - this.lifted[leg]);
      if (this.lifted[leg] !== null) this.begun ??= frame.time;
    }
    if (this.begun === null) return;
    this.elapsed = this.longest > 0 ? (frame.time - this.begun) / this.longest : 0;
    if (alternates(frame.state, this.n)) this.taken = this.elapsed;
  }

  /** @returns a sentence; empty where the theorem has nothing to say */
  words(frame) {
    const most = this.n / 2;
    if (frame.wave || frame.tripod || frame.legs.some((_, leg) => isLost(frame, leg)) || this.n % 2 || this.begun === null) return "";
    if (this.taken !== null && this.taken >= most) return `Alternating after ${this.taken.toFixed(1)} step times`;
    if (this.taken !== null) return `Alternating after ${this.taken.toFixed(1)} < ${most} step times`;
    if (!frame.moving) return "";
    const left = most - this.elapsed;
    return left > 0 ? `Alternates within ${left.toFixed(1)} step times` : `Over ${most} step times: steps are not alike`;
  }
}
