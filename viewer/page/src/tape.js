// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What has been seen: frames in the order of time, each with its scene, ground and setup.

const kMostFrames = 36000;  // that are kept of a walk that goes on: 16 MB of them

/** Scene, tick and time [s] of the bytes of a frame: see frame.js. */
export function headOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return { scene: view.getUint32(4, true), tick: view.getUint32(8, true), time: view.getFloat64(16, true) };
}

export class Tape {
  /** @param span  that is kept, of simulated time [s] */
  constructor(span = Infinity) {
    this.span = span;
    this.entries = [];
    this.dropped = 0;  // before the first of them
    this.scene = this.ground = this.setup = null;
  }

  /** A frame goes on as the tick does; the same tick again replaces it. @returns whether it was of this scene */
  add(bytes) {
    const head = headOf(bytes);
    if (!this.scene || head.scene !== this.scene.scene) return false;
    const last = this.entries.at(-1), same = last?.scene === this.scene;
    if (same && head.tick === last.tick) this.entries.pop();
    const before = same ? last.clock - last.time : last ? last.clock : 0;
    this.entries.push({ bytes, scene: this.scene, ground: this.ground, setup: this.setup, tick: head.tick, time: head.time, clock: before + head.time });
    this.forget();
    return true;
  }

  forget() {
    const { entries } = this, oldest = entries.at(-1).clock - this.span;
    let n = 0;
    while (entries[n].clock < oldest || (Number.isFinite(this.span) && entries.length - n > kMostFrames)) n += 1;
    // Some at a time: each time costs as much as there are entries.
    if (n < 64 && entries.length <= kMostFrames) return;
    entries.splice(0, n);
    this.dropped += n;
  }

  get first() { return this.dropped; }
  get last() { return this.dropped + this.entries.length - 1; }
  /** By a number that stays the same while others are forgotten. */
  entry(k) { return this.entries[k - this.dropped]; }

  /** The last entry that is not after a time of the tape [s]. */
  at(clock) {
    let low = 0, high = this.entries.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.entries[middle].clock <= clock) low = middle;
      else high = middle - 1;
    }
    return this.dropped + low;
  }

  /** The k-th entry and those of its scene in the time before [s]. */
  before(k, seconds) {
    const { scene, clock } = this.entry(k);
    let from = k;
    while (from > this.first && this.entry(from - 1).scene === scene && this.entry(from - 1).clock >= clock - seconds) from -= 1;
    return this.entries.slice(from - this.dropped, k - this.dropped + 1);
  }
}
