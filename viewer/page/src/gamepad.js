// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A gamepad of the standard layout. The left stick drives while it is held, and the robot stops when it is
// let go: ahead or back, curved by its sideways part. The right stick sets the crab angle.
import { curvatureOf, kStop } from "./steering.js";

const kDead = 0.18;     // of a stick's way, about its middle
const kPause = 60;      // between two commands of a stick [ms]
const kButtons = { 0: "go", 1: "stop", 2: "push", 4: "spin-left", 5: "spin-right", 8: "estop", 9: "pause", 14: "back", 15: "step" };

/** Where a stick of a pad is: nothing about its middle, then from 0 to 1. */
export function stick([x, y]) {
  const r = Math.hypot(x, y);
  if (!(r > kDead)) return null;
  const share = Math.min(1, (r - kDead) / (1 - kDead)) / r;
  return [x * share, y * share];
}

export class Pad {
  /** @param steering  @param acts  functions by the names of their buttons on the page */
  constructor(steering, acts) {
    Object.assign(this, { steering, acts, pressed: new Set(), drives: false, told: -Infinity });
  }

  /** Before each picture. @param now [ms] */
  poll(now) {
    const pad = [...(navigator.getGamepads?.() ?? [])].find((one) => one?.connected && one.mapping === "standard");
    if (!pad || document.hidden) return this.letGo();
    for (const [k, name] of Object.entries(kButtons)) this.button(name, pad.buttons[k]?.pressed);
    if (now - this.told < kPause) return;
    this.sticks(stick(pad.axes.slice(0, 2)), stick(pad.axes.slice(2, 4)), now);
  }

  button(name, down) {
    const was = this.pressed.has(name);
    if (down) this.pressed.add(name);
    else this.pressed.delete(name);
    if (down && !was) this.acts[name]();
  }

  sticks(left, right, now) {
    const { steering } = this;
    // Rounded, so that a hand that trembles does not send.
    const turned = right ? Math.round((-Math.atan2(right[0], -right[1]) * 180) / Math.PI / 5) * 5 : null;
    if (!left && turned === null) return this.letGo();
    const bent = left ? curvatureOf(Math.round(kStop * left[0] / 3) * 3) : steering.curvature;
    const crab = turned ?? (left && left[1] > Math.abs(left[0]) ? 180 : 0);
    const same = this.drives === Boolean(left) && bent === steering.curvature && Math.abs(crab - steering.crab) % 360 < 1;
    if (same) return;
    if (this.drives && !left) steering.stop();
    else steering.set(bent, crab);
    this.drives = Boolean(left);
    this.told = now;
  }

  letGo() {
    if (this.drives) this.steering.stop();
    this.drives = false;
  }
}
