// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which frame of a tape is seen: the newest of a walk that goes on, or where the person has gone back to.

export class Player {
  /** @param show     called with the entry that follows the one that is seen
   *  @param restart  called with entries, the last of which is to be seen: those before are what led to it
   *  @param window   how much of that is needed [s] */
  constructor(tape, { show, restart, window }) {
    Object.assign(this, { tape, show, restart, window });
    this.position = -1;
    this.follows = true;   // the newest
    this.playing = false;
    this.speed = 1;
    this.clock = 0;        // of the tape, where it plays [s]
  }

  get entry() { return this.tape.entry(this.position); }
  get begin() { return this.tape.entry(this.tape.first)?.clock ?? 0; }
  get end() { return this.tape.entry(this.tape.last)?.clock ?? 0; }
  get atEnd() { return this.position >= this.tape.last; }

  /** The tape has a new frame. */
  grown() {
    if (this.follows) this.goTo(this.tape.last, true);
  }

  /** Stops playing, and goes to an entry. */
  seek(k) {
    this.playing = this.follows = false;
    this.goTo(k);
  }
  seekTime(clock) { this.seek(this.tape.at(clock)); }
  step(way) { this.seek(this.position + way); }

  play() {
    if (this.atEnd) this.goTo(this.tape.first);
    this.playing = true;
    this.follows = false;
  }
  pause() { this.playing = false; }
  follow() {
    this.playing = false;
    this.follows = true;
    this.goTo(this.tape.last);
  }

  /** So much time has passed [s]. @returns whether it has come to the end just now */
  advance(seconds) {
    if (!this.playing) return false;
    this.clock = Math.min(this.clock + seconds * this.speed, this.end);
    const clock = this.clock;
    this.goTo(this.tape.at(clock));
    this.clock = clock;
    if (!this.atEnd) return false;
    this.playing = false;
    return true;
  }

  goTo(wanted, again = false) {
    if (this.tape.last < this.tape.first) return;
    const k = Math.min(this.tape.last, Math.max(this.tape.first, wanted));
    if (k === this.position && !again) return;
    const onward = k >= this.position && k <= this.position + 30 && this.position >= this.tape.first;
    if (onward && this.tape.entry(this.position).scene === this.tape.entry(k).scene)
      for (let j = Math.min(k, this.position + 1); j <= k; ++j) this.show(this.tape.entry(j));
    else this.restart(this.tape.before(k, this.window));
    this.position = k;
    this.clock = this.entry.clock;
  }
}
