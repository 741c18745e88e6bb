// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bar of time: of a walk that goes on its last minute, of a replay all of it.

const $ = (id) => document.getElementById(id);
const kFine = 1000;  // steps of the slider per second

export class Timeline {
  /** @param player  what is seen
   *  @param live    {paused(), pause(on), step(), speed(factor)} of a walk that goes on; null of a replay */
  constructor(player, live) {
    this.player = player;
    this.live = live;
    this.held = false;  // the walk was paused because the person went back
    $("scrub").addEventListener("input", () => { this.hold(); this.wanted = Number($("scrub").value) / kFine; });
    $("speed").addEventListener("change", () => this.changeSpeed());
    $("live").hidden = !live;
    $("live").addEventListener("click", () => this.toNow());
  }

  /** Does it go on whatever the person does? A live robot does. */
  get keepsOn() { return this.live?.keepsOn() ?? false; }
  get paused() { return this.live?.paused() ?? false; }
  get isBack() { return !this.player.follows; }

  /** The walk waits while the person looks back, if it may be told to. */
  hold() {
    if (!this.live || this.keepsOn || this.isBack || this.paused) return;
    this.held = this.live.pause(true);
  }

  changeSpeed() {
    this.player.speed = Number($("speed").value);
    if (!this.keepsOn) this.live?.speed(this.player.speed);
  }

  /** On with the walk, from its newest frame. */
  toNow() {
    this.wanted = undefined;
    this.player.follow();
    if (this.held) this.live?.pause(false);
    this.held = false;
  }

  toggle() {
    if (this.live && !this.isBack) { if (!this.keepsOn) this.live.pause(!this.paused); return; }
    if (this.player.playing) this.player.pause();
    else this.player.play();
  }

  back() {
    this.hold();
    this.player.step(-1);
  }
  on() {
    if (this.keepsOn && (!this.isBack || this.player.atEnd)) return this.toNow();
    if (this.live && !this.isBack) return this.live.step();
    if (this.live && this.player.atEnd) { this.player.follow(); return this.live.step(); }
    this.player.step(1);
  }
  toBegin() {
    this.hold();
    this.player.seek(this.player.tape.first);
  }
  toEnd() {
    if (this.live) this.toNow();
    else this.player.seek(this.player.tape.last);
  }

  /** Before each picture. @param seconds  since the last one */
  advance(seconds) {
    if (this.wanted !== undefined) this.player.seekTime(this.wanted);
    this.wanted = undefined;
    if (this.player.advance(seconds) && this.live) this.toNow();
  }

  /** @param frame  that is seen */
  show(frame) {
    const { begin, end, position, tape } = this.player;
    const clock = this.player.follows ? end : tape.entry(position)?.clock ?? begin;
    const scrub = $("scrub"), last = Math.round(end * kFine), first = Math.round(begin * kFine), now = Math.round(clock * kFine);
    if (Number(scrub.max) !== last) scrub.max = last;
    if (Number(scrub.min) !== first) scrub.min = first;
    if (Number(scrub.value) !== now) scrub.value = now;
    const words = !this.live ? `${(clock - begin).toFixed(2)} of ${(end - begin).toFixed(2)} s` : this.isBack ? `−${(end - clock).toFixed(2)} s` : "now";
    if ($("clock").textContent !== words) {
      $("clock").textContent = words;
      scrub.setAttribute("aria-valuetext", words);
    }
    const stands = this.isBack || !this.live ? !this.player.playing : frame.paused;
    $("pause").textContent = stands ? "Play" : "Pause";
    $("pause").setAttribute("aria-pressed", String(stands && Boolean(this.live)));
    const ticks = this.live && !this.keepsOn && (!this.isBack || this.player.atEnd);
    $("pause").disabled = $("step").disabled = this.keepsOn && !this.isBack;
    $("step").textContent = ticks ? "1 tick" : "→";
    $("step").setAttribute("aria-label", ticks ? "One tick on" : "One frame on");
    $("live").disabled = !this.isBack;
  }
}
