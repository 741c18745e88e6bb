// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The page: takes what the server tells, draws it, and sends what the person wants.
//
//     Link ──frame──▶ Tape ──▶ Player ──▶ Robot, Overlays, charts, panels
//                                         Steering, panels, keys ──command──▶ Link
import { chartColours, drawRing, GaitDiagram, kWindow, legAt, Strip } from "./charts.js";
import { Countdown } from "./countdown.js";
import { cutLegs } from "./faults.js";
import { decodeFrame } from "./frame.js";
import { Pad } from "./gamepad.js";
import { Ground } from "./ground.js";
import { Link } from "./link.js";
import { Overlays, yaw } from "./overlays.js";
import { Panels } from "./panels.js";
import { Player } from "./player.js";
import { embedded, openReplay } from "./replay.js";
import { Robot } from "./robot.js";
import { Sketch } from "./sketch.js";
import { Steering } from "./steering.js";
import { Tape } from "./tape.js";
import { Timeline } from "./timeline.js";
import { why } from "./why.js";
import { World } from "./world.js";

const $ = (id) => document.getElementById(id);
const kHiccup = 2000;  // silence after which a page that steered goes on by itself [ms]
const kBegin = 0.1;    // of a scene [s]
const kKept = 60;      // of a walk that goes on, to look back at [s]

class App {
  constructor() {
    this.link = new Link();
    this.stopped = null;  // client of the emergency stop that lasts
    this.world = new World($("world"));
    this.steering = new Steering((command) => this.drive(command));
    this.panels = new Panels(this.link, this.steering);
    this.steering.isOnPath = () => Boolean(this.frame?.follows);
    this.sketch = new Sketch(this.world, (path) => this.steering.follow(path));
    this.pad = new Pad(this.steering, this.panels.acts);
    this.colours = chartColours();
    this.world.onScheme(() => { this.colours = chartColours(); this.build(); });
    this.addPointer();
    this.chosen = 0;  // the leg of which a sentence is shown
    $("ring").addEventListener("click", ({ offsetX, offsetY }) => this.choose(legAt($("ring"), this.names.length, offsetX, offsetY)));
    this.panels.onDraw = () => this.sketch.toggle();
    $("draw").addEventListener("click", () => this.sketch.toggle());
    $("path").addEventListener("change", () => this.followNamed());
    this.panels.onLeg = (leg) => this.choose(leg);
    this.drawn = this.panelsDrawn = 0;
    document.body.classList.toggle("plain", this.world.software);
    const replay = embedded();
    if (replay) this.play(replay);
    else this.listen();
    requestAnimationFrame(() => this.draw());
  }

  /** A walk that goes on, or a replay, as the server has it. */
  listen() {
    const { link } = this, tape = new Tape(kKept);
    link.on("scene", (scene) => { [tape.scene, tape.ground, tape.setup] = [scene, null, null]; });
    link.on("ground", (told) => { if (told.scene === tape.scene?.scene) tape.ground = told; });
    link.on("setup", (setup) => { if (setup.scene === tape.scene?.scene) tape.setup = setup; });
    link.on("frame", (bytes) => { if (tape.add(bytes)) this.player.grown(); });
    link.on("action", (news) => this.panels.actions.show(news));
    link.on("error", ({ what }) => this.panels.notice(what));
    link.on("closed", () => { this.panels.showState("not connected", "bad"); this.panels.showStop(this.stopped); });
    link.on("setup", (setup) => {
      this.stopped = setup.estop ?? null;
      if (this.stopped !== null) this.steering.forget();
      this.panels.showStop(this.stopped);
    });
    link.on("replay", (bytes) => { link.end(); this.play(bytes); });
    this.watch(tape, {
      keepsOn: () => Boolean(tape.scene?.live),
      paused: () => link.frame?.paused ?? false,
      pause: (on) => { if (link.mayHold) link.send({ type: "pause", on }); return link.mayHold; },
      step: () => link.send({ type: "step", ticks: 1 }),
      speed: (factor) => link.send({ type: "speed", factor }),
    });
    link.start();
  }

  async play(bytes) {
    try {
      document.body.classList.add("replay");
      $("knobs").inert = true;  // they show what the robot was told
      this.watch(await openReplay(bytes), null);
      this.player.seek(0);
      const { robot, terrain } = this.scene;
      document.title = `${robot} on ${terrain} – hexagait replay`;
      if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.player.play();
    } catch (error) {
      this.panels.showState(error.message, "bad");
    }
  }

  watch(tape, live) {
    this.player = new Player(tape, {
      show: (entry) => this.show(entry), restart: (entries) => this.restart(entries), window: kWindow,
    });
    this.panels.timeline = this.timeline = new Timeline(this.player, live);
  }

  show({ scene, ground, setup, bytes }) {
    if (scene !== this.scene) {
      this.scene = scene;
      this.begun = true;
      this.build();
      this.panels.showScene(scene);
    }
    if (ground && ground !== this.told) {
      this.told = ground;
      this.buildGround();
    }
    if (setup !== this.setup) {
      this.setup = setup;
      this.showSetup();
    }
    this.take(decodeFrame(bytes));
  }

  showSetup() {
    this.panels.faults.showSetup(this.setup);
    this.overlays.showRoute(this.setup?.path ?? null);
    this.panels.route = this.setup?.path ?? null;
    for (const robot of [this.robot, this.ghost]) robot.lose(cutLegs(this.setup?.faults ?? [], this.names));
  }

  restart(entries) {
    const now = entries.pop();
    if (now.scene === this.scene) {
      this.overlays.forget();
      this.makeCharts();
      const whole = (entries[0] ?? now).time < kBegin;
      this.countdown = whole ? new Countdown(this.names.length) : null;  // it counts from the beginning
      for (const { bytes } of entries) {
        const frame = decodeFrame(bytes);
        this.overlays.remember(frame);
        this.chart(frame);
      }
    }
    this.show(now);
    this.leap = true;
  }

  build() {
    if (!this.scene) return;
    this.robot?.dispose();
    this.ghost?.dispose();
    this.overlays?.dispose();
    this.robot = new Robot(this.scene, this.world.paint);
    this.overlays = new Overlays(this.scene, this.world.paint);
    this.ghost = new Robot(this.scene, this.world.paint.pale());
    this.world.scene.add(this.robot.group, this.ghost.group, this.overlays.group);
    const names = this.scene.legs.map(({ name }) => name.slice(0, 3));
    this.names = names;
    this.sketch.spacing = 0.8 * Math.min(...this.scene.legs.map(({ radius }) => radius));
    this.countdown = new Countdown(names.length);
    this.chosen = Math.min(this.chosen, names.length - 1);
    this.makeCharts();
    if (this.sized !== this.overlays.size) this.world.stepBack(this.sized = this.overlays.size);
    this.buildGround();
    this.showSetup();
    this.panels.faults.choose(this.chosen);
  }

  makeCharts() {
    this.diagram = new GaitDiagram($("diagram"), this.names);
    this.strips = [
      new Strip($("strip-speed"), { title: "speed", unit: "m/s", digits: 2, bounds: [0, 0.3] }),
      new Strip($("strip-margin"), { title: "stability margin", unit: "cm", digits: 1, bounds: [0, 15], warn: 0 }),
      new Strip($("strip-slip"), { title: "slip of a foot", unit: "cm/s", digits: 1, bounds: [0, 5], warn: 10, below: false }),
      new Strip($("strip-cost"), { title: "cost of transport", unit: "", digits: 2, bounds: [0, 1] }),
    ];
  }

  buildGround() {
    if (!this.told) return;
    this.ground?.dispose();
    this.ground = new Ground(this.told, this.world.paint);
    this.world.scene.add(this.ground.mesh);
  }

  take(frame) {
    this.frame = frame;
    if (this.player.follows) this.resume(frame);
    if (!this.link.holds || this.begun || !this.player.follows) this.steering.showCommand(frame);
    this.begun = false;
    this.chart(frame);
  }

  chart(frame) {
    this.countdown?.take(frame);
    this.diagram.take(frame);
    const speed = Math.hypot(frame.vx, frame.vy);
    this.strips[0].take(frame.time, speed);
    this.strips[1].take(frame.time, 100 * frame.margin);
    this.strips[2].take(frame.time, 100 * frame.slip);
    if (speed > 0.03) this.strips[3].take(frame.time, frame.power / (this.scene.mass * 9.81 * speed));
  }

  followNamed() {
    const path = $("path").value;
    $("path").selectedIndex = 0;
    if (path && this.timeline.live) this.steering.follow({ path });
  }

  choose(leg) { if (leg >= 0 && leg < (this.names?.length ?? 0)) this.panels.faults.choose(this.chosen = leg); }

  drive(command) {
    this.away = false;
    this.timeline?.toNow();
    this.link.send(command);
    if (this.stopped !== null) this.steering.forget();  // it is refused: after the release nothing goes by itself
  }

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
      if (this.sketch.begin(event, this.groundHeight())) return;
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, event);
      if (pointers.size === 1) moved = 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      if (this.sketch.go(event)) return this.overlays?.showSketch(this.sketch.line);
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY;
      moved += Math.abs(dx) + Math.abs(dy);
      if (pointers.size === 1) this.world.orbit(dx, dy);
      else this.pinch(pointers, event);
      pointers.set(event.pointerId, event);
    });
    canvas.addEventListener("pointerup", (event) => {
      if (this.sketch.end(event, this.overlays)) return;
      if (pointers.size === 1 && moved < 5) this.circle(event.clientX, event.clientY);
      pointers.delete(event.pointerId);
    });
    canvas.addEventListener("pointercancel", (event) => {
      this.sketch.cancel(this.overlays);
      pointers.delete(event.pointerId);
    });
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

  /** Of the feet, on average [m]. */
  groundHeight() { return this.frame?.legs.reduce((sum, leg) => sum + leg.foot[2] / this.frame.legs.length, 0) ?? 0; }

  /** Circles the point of the ground that was clicked: as near to straight ahead as it can be done. */
  circle(x, y) {
    if (!this.frame || !this.timeline.live) return;
    const p = this.world.groundAt(x, y, this.groundHeight());
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
    const now = performance.now();
    this.timeline?.advance(Math.min(0.25, (now - (this.drawnAt ?? now)) / 1000));
    this.drawnAt = now;
    if (this.timeline?.live) this.pad.poll(now);
    if (this.frame && this.robot) {
      this.robot.move(this.frame);
      const { rival } = this.frame;
      this.ghost.group.visible = Boolean(rival);
      if (rival) this.ghost.move(rival);
      this.overlays.update(this.frame);
      this.world.follow(this.frame.p, this.drawn === 0 || this.leap ? 1 : 0.08);
      this.leap = false;
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
    const left = this.countdown?.words(frame) ?? "";
    if ($("countdown").textContent !== left) $("countdown").textContent = left;
    for (const strip of this.strips) strip.draw(this.colours);
    this.panels.showFrame(frame, this.world);
    if (this.timeline.live) this.panels.showStop(this.stopped, frame.fault);
    this.panels.showRace(frame, this.setup?.race);
    this.timeline.show(frame);
  }
}

try {
  const app = new App();
  // For tests, and for who looks from the console.
  window.hexagait = {
    frame: () => app.frame,
    scene: () => app.scene,
    setup: () => app.setup,
    rival: () => app.frame?.rival,
    cut: () => app.robot.lost,
    feet: () => { app.robot.move(app.frame); return { frame: app.frame, drawn: app.robot.footPositions() }; },
    you: () => app.link.you,
    player: () => app.player && {
      position: app.player.position, last: app.player.tape.last, first: app.player.tape.first, clock: app.player.clock,
      begin: app.player.begin, end: app.player.end, playing: app.player.playing, follows: app.player.follows,
    },
    view: () => ({ drawn: app.drawn, frames: app.link.frames, fps: app.world.fps, level: app.world.level, software: app.world.software }),
    send: (command) => app.link.send(command),
    quality: (level) => app.world.fix(level),
    camera: (view) => Object.assign(app.world.view, view),
  };
} catch (error) {
  $("state").textContent = error.message;
  $("lamp").className = "bad";
}
