// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Drawing a path on the ground: while it is on, a drag draws instead of turning the view.
import { pathAlong } from "./path.js";

const $ = (id) => document.getElementById(id);
const kLeast = 4;  // that a pointer moves between two points [px]

export class Sketch {
  /** @param world  see world.js  @param follow  called with a path that has been drawn */
  constructor(world, follow) {
    Object.assign(this, { world, follow, on: false, line: [], pointer: null, last: null, spacing: 0.2 });
  }

  toggle(on = !this.on) {
    this.on = on;
    $("draw").setAttribute("aria-pressed", String(on));
    $("world").classList.toggle("draws", on);
  }

  /** @param height  of the ground [m]  @returns whether it takes the pointer */
  begin(event, height) {
    if (!this.on || this.pointer !== null) return this.on;
    $("world").setPointerCapture(event.pointerId);
    Object.assign(this, { pointer: event.pointerId, height, line: [], last: null });
    this.add(event);
    return true;
  }

  go(event) {
    if (this.pointer === null) return false;
    if (event.pointerId === this.pointer) this.add(event);
    return true;
  }

  add({ clientX: x, clientY: y }) {
    if (this.last && Math.hypot(x - this.last[0], y - this.last[1]) < kLeast) return;
    this.last = [x, y];
    const p = this.world.groundAt(x, y, this.height);
    if (p) this.line.push([p.x, p.y]);
  }

  /** @returns whether a drag has ended that was a drawing; then it is followed */
  end(event, overlays) {
    if (event.pointerId !== this.pointer) return this.on;
    const path = pathAlong(this.line, this.spacing);
    this.cancel(overlays);
    if (path) {
      this.toggle(false);
      this.follow(path);
    }
    return true;
  }

  cancel(overlays) {
    this.pointer = null;
    this.line = [];
    overlays?.showSketch([]);
  }
}
