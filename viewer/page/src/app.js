// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The page: takes what the server tells, draws it, and sends what the person wants.
//
//     Link ──frame──▶ Robot, Overlays, charts, panels          Steering, panels, keys ──command──▶ Link
import { chartColours, drawRing, GaitDiagram, legAt, Strip } from "./charts.js";
import { Ground } from "./ground.js";
import { Link } from "./link.js";
import { Overlays, yaw } from "./overlays.js";
import { Panels } from "./panels.js";
import { Robot } from "./robot.js";
import { Steering } from "./steering.js";
import { why } from "./why.js";
import { World } from "./world.js";

const $ = (id) => document.getElementById(id);
const kHiccup = 2000;  // silence after which a page that steered goes on by itself [ms]

class App {
  constructor() {
    this.link = new Link();
    this.world = new World($("world"));
    this.steering = new Steering((command) => { this.away = false; this.link.send(command); });
    this.panels = new Panels(this.link, this.steering);
    this.colours = chartColours();
    this.world.onScheme(() => { this.colours = chartColours(); this.build(); });
    this.link.on("scene", (scene) => { this.scene = scene; this.frame = null; this.begun = true; this.build(); this.panels.showScene(scene); });
    this.link.on("ground", (told) => { this.told = told; this.buildGround(); });
    this.link.on("error", ({ what }) => this.panels.notice(what));
    this.link.on("closed", () => this.panels.showState("not connected", "bad"));
    this.link.on("frame", (frame) => this.take(frame));
    this.addPointer();
    this.chosen = 0;  // the leg of which a sentence is shown
    $("ring").addEventListener("click", ({ offsetX, offsetY }) => this.choose(legAt($("ring"), this.names.length, offsetX, offsetY)));
    this.panels.onLeg = (leg) => this.choose(leg);
    this.drawn = this.panelsDrawn = 0;
    document.body.classList.toggle("plain", this.world.software);
    requestAnimationFrame(() => this.draw());
  }

  build() {
    if (!this.scene) return;
    this.robot?.dispose();
    this.overlays?.dispose();
    this.robot = new Robot(this.scene, this.world.paint);
    this.overlays = new Overlays(this.scene, this.world.paint);
    this.world.scene.add(this.robot.group, this.overlays.group);
    const names = this.scene.legs.map(({ name }) => name.slice(0, 3));
    this.names = names;
    this.chosen = Math.min(this.chosen, names.length - 1);
    this.diagram = new GaitDiagram($("diagram"), names);
    this.strips = [
      new Strip($("strip-speed"), { title: "speed", unit: "m/s", digits: 2, bounds: [0, 0.3] }),
      new Strip($("strip-margin"), { title: "stability margin", unit: "cm", digits: 1, bounds: [0, 15], warn: 0 }),
      new Strip($("strip-slip"), { title: "slip of a foot", unit: "cm/s", digits: 1, bounds: [0, 5], warn: 10, below: false }),
      new Strip($("strip-cost"), { title: "cost of transport", unit: "", digits: 2, bounds: [0, 1] }),
    ];
    if (this.sized !== this.overlays.size) this.world.stepBack(this.sized = this.overlays.size);
    this.buildGround();
  }

  buildGround() {
    if (!this.told) return;
    this.ground?.dispose();
    this.ground = new Ground(this.told, this.world.paint);
    this.world.scene.add(this.ground.mesh);
  }

  take(frame) {
    if (!this.scene || frame.scene !== this.scene.scene) return;
    this.frame = frame;
    this.resume(frame);
    if (!this.link.holds || this.begun) this.steering.follow(frame);
    this.begun = false;
    this.diagram.take(frame);
    const speed = Math.hypot(frame.vx, frame.vy);
    this.strips[0].take(frame.time, speed);
    this.strips[1].take(frame.time, 100 * frame.margin);
    this.strips[2].take(frame.time, 100 * frame.slip);
    if (speed > 0.03) this.strips[3].take(frame.time, frame.power / (this.scene.mass * 9.81 * speed));
  }

  choose(leg) { if (leg >= 0 && leg < (this.names?.length ?? 0)) this.chosen = leg; }

  /** The robot was stopped because this page was silent: after a hiccup it goes on; after long, or when the
   *  page was out of sight, only when the person steers again. */
  resume(frame) {
    if (this.link.silence > kHiccup || document.hidden) this.away = true;
    const last = this.steering.last;
    if (frame.silent && this.link.holds && !this.away && last && last.type !== "stop") this.link.send(last);
  }

  addPointer() {
    const canvas = $("world");
    const pointers = new Map();
    let moved = 0;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, event);
      if (pointers.size === 1) moved = 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY;
      moved += Math.abs(dx) + Math.abs(dy);
      if (pointers.size === 1) this.world.orbit(dx, dy);
      else this.pinch(pointers, event);
      pointers.set(event.pointerId, event);
    });
    canvas.addEventListener("pointerup", (event) => {
      if (pointers.size === 1 && moved < 5) this.circle(event.clientX, event.clientY);
      pointers.delete(event.pointerId);
    });
    canvas.addEventListener("pointercancel", (event) => pointers.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.world.zoom(Math.exp(0.0012 * event.deltaY));
    }, { passive: false });
  }

  pinch(pointers, event) {
    const [other] = [...pointers.values()].filter(({ pointerId }) => pointerId !== event.pointerId);
    const last = pointers.get(event.pointerId);
    const apart = (a) => Math.hypot(a.clientX - other.clientX, a.clientY - other.clientY);
    if (apart(event) > 1) this.world.zoom(apart(last) / apart(event));
  }

  /** Circles the point of the ground that was clicked: as near to straight ahead as it can be done. */
  circle(x, y) {
    if (!this.frame) return;
    const p = this.world.groundAt(x, y, this.frame.legs.reduce((sum, leg) => sum + leg.foot[2] / this.frame.legs.length, 0));
    if (!p) return;
    const heading = yaw(this.frame.q), dx = p.x - this.frame.p[0], dy = p.y - this.frame.p[1];
    const forward = Math.cos(heading) * dx + Math.sin(heading) * dy, left = Math.cos(heading) * dy - Math.sin(heading) * dx;
    const r = Math.hypot(forward, left);
    if (r < 0.05 || r > 20) return;
    // o = r (−sin α, cos α): of the two senses the one whose α is nearer to ahead.
    const side = left >= 0 ? 1 : -1;
    const crab = Math.atan2(-side * forward, side * left);
    this.steering.set(side / r, (crab * 180) / Math.PI);
  }

  draw() {
    requestAnimationFrame(() => this.draw());
    if (this.frame && this.robot) {
      this.robot.move(this.frame);
      this.overlays.update(this.frame);
      this.world.follow(this.frame.p, this.drawn === 0 ? 1 : 0.08);
      if (performance.now() - this.panelsDrawn > (this.world.software ? 140 : 40)) this.drawPanels();
      this.drawn += 1;
    }
    this.world.draw();
  }

  drawPanels() {
    this.panelsDrawn = performance.now();
    const frame = this.frame;
    this.diagram.draw(this.colours);
    drawRing($("ring"), frame, this.names, this.colours, this.chosen);
    const sentence = why(frame, this.chosen, this.names);
    if ($("why").textContent !== sentence) $("why").textContent = sentence;
    for (const strip of this.strips) strip.draw(this.colours);
    this.panels.showFrame(frame, this.world);
  }
}

try {
  const app = new App();
  // For tests, and for who looks from the console.
  window.hexagait = {
    frame: () => app.frame,
    scene: () => app.scene,
    feet: () => { app.robot.move(app.frame); return { frame: app.frame, drawn: app.robot.footPositions() }; },
    you: () => app.link.you,
    view: () => ({ drawn: app.drawn, frames: app.link.frames, fps: app.world.fps, level: app.world.level, software: app.world.software }),
    send: (command) => app.link.send(command),
    quality: (level) => app.world.fix(level),
    camera: (view) => Object.assign(app.world.view, view),
  };
} catch (error) {
  $("state").textContent = error.message;
  $("lamp").className = "bad";
}
