// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Buttons, choices, keys, and the words about what is going on.
import { Actions } from "./actions.js";
import { Faults } from "./faults.js";
import { kEmergencyStop, kFaults } from "./frame.js";

const $ = (id) => document.getElementById(id);
const kTypeWords = {
  A: "one leg first", B: "two, one neighbour apart", C: "two, opposite", D: "three legs: tripod",
  "–": "",
};

/** With two digits, and no −0. */
const hundredths = (x) => (Math.abs(x) < 0.005 ? 0 : x).toFixed(2);

export class Panels {
  constructor(link, steering) {
    this.link = link;
    this.steering = steering;
    const send = (command) => () => this.link.send(command);
    const acts = {
      scramble: send({ type: "scramble" }), reset: send({ type: "reset" }),
      push: () => this.link.send({ type: "push", angle: Math.random() < 0.5 ? Math.PI / 2 : -Math.PI / 2 }),
      pause: () => this.timeline?.toggle(), step: () => this.timeline?.on(), back: () => this.timeline?.back(),
      go: () => steering.go(), stop: () => steering.stop(),
      "spin-left": () => steering.spin("ccw"), "spin-right": () => steering.spin("cw"),
      "gait-free": () => this.gait("free"), "gait-tripod": () => this.gait("tripod"), "gait-wave": () => this.gait("wave"),
      "hide-hints": () => $("hints").classList.add("away"),
      race: () => this.race(),
      estop: () => this.stopAll(), "release-estop": send({ type: "release_estop" }),
      more: () => $("more").setAttribute("aria-expanded", document.body.classList.toggle("more")),
    };
    for (const [id, act] of Object.entries(acts)) $(id).addEventListener("click", act);
    this.acts = acts;
    this.faults = new Faults((command) => this.link.send(command), (leg) => this.onLeg?.(leg));
    this.actions = new Actions({
      perform: (action) => steering.perform(action), stop: () => steering.stop(), notice: (words) => this.notice(words),
      mayDrop: () => Boolean(this.timeline?.live && this.link.open),
    });
    $("robot").addEventListener("change", () => this.link.send({ type: "restart", robot: $("robot").value }));
    $("terrain").addEventListener("change", () => this.restart());
    $("roughness").addEventListener("change", () => this.restart());
    $("roughness").addEventListener("input", () => this.showRoughness());
    $("race-gait").addEventListener("change", () => { if (this.races) this.race(true); });
    $("duty").addEventListener("input", () => {
      $("duty-out").textContent = Number($("duty").value).toFixed(2);
      if (this.frame?.wave) this.gait("wave");
    });
    addEventListener("keydown", (event) => this.key(event));
  }

  /** Whoever this page is: not only for who steers. */
  stopAll() {
    this.steering.forget();
    if (this.link.open) this.link.send({ type: "estop" });
    else this.notice("Not connected: the stop was not sent. Use the robot's own switch.");
  }

  /** @param by     client of the emergency stop that lasts; null: none does
   *  @param fault  that holds the robot: a live one is released from it too */
  showStop(by, fault = 0) {
    const { link } = this, held = by === null && this.isLive ? fault : 0, stopped = by !== null || held > 0;
    const who = held ? kFaults[held] : by === link.you && stopped ? "by this page" : by ? `by page ${by}` : "";
    const title = held ? "STOPPED" : "EMERGENCY STOP";
    if (stopped && $("stopped-title").textContent !== title) $("stopped-title").textContent = title;
    const may = link.mayHold, words = `${who}; ${may ? "it stands still until you release it" : "who holds the wheel can release it"}`;
    if (stopped && $("stopped-by").textContent !== words) $("stopped-by").textContent = words;
    if ($("stopped").hidden === stopped) $("stopped").hidden = !stopped;
    $("release-estop").disabled = !may;
    const pressed = String(by !== null);
    if ($("estop").getAttribute("aria-pressed") !== pressed) $("estop").setAttribute("aria-pressed", pressed);
    $("estop").classList.toggle("off", !link.open);
  }

  gait(kind) { this.link.send({ type: "gait", gait: kind === "wave" ? `wave:${$("duty").value}` : kind }); }

  race(on = !this.races) { this.link.send(on ? { type: "race", on, gait: $("race-gait").value } : { type: "race", on }); }

  /** How far both have come. @param gait  of the second robot; null: there is no race */
  showRace(frame, gait) {
    this.races = Boolean(gait);
    if ($("race").getAttribute("aria-pressed") !== String(this.races)) $("race").setAttribute("aria-pressed", String(this.races));
    const { rival } = frame, own = frame.tripod ? "tripod" : frame.wave ? "wave" : "free", ahead = rival ? frame.path - rival.path : 0;
    const far = (f) => `${f.path.toFixed(2)} m${f.fell ? ", fell" : ""}`;
    const words = rival ? `${own} ${far(frame)} · ${gait}, pale: ${far(rival)} · ${ahead < 0 ? "behind" : "ahead"} by ${Math.abs(ahead).toFixed(2)} m` : "";
    if ($("race-facts").hidden !== !rival) $("race-facts").hidden = !rival;
    if ($("race-facts").textContent !== words) $("race-facts").textContent = words;
  }

  restart() {
    const terrain = $("terrain").value, whole = terrain === "flat" || terrain.includes(":");
    this.link.send({ type: "restart", terrain: whole ? terrain : `${terrain}:${$("roughness").value}cm` });
  }

  key(event) {
    if (event.key === "Escape" && this.timeline?.live) {  // wherever the focus is, whatever else is pressed
      event.preventDefault();
      document.activeElement.blur();
      return this.stopAll();
    }
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.matches("input:not([type=range]), select") && event.key !== "Escape") return;
    if (event.target.matches("button") && [" ", "Enter"].includes(event.key)) return;
    if (event.target.matches("input[type=range]:not(#scrub)") && event.key.startsWith("Arrow")) return;
    if (/^[1-9]$/.test(event.key)) return this.onLeg?.(Number(event.key) - 1);
    const s = this.steering, { timeline } = this;
    const ofTime = {
      " ": this.acts.pause, ArrowRight: this.acts.step, ArrowLeft: this.acts.back,
      Home: () => timeline?.toBegin(), End: () => timeline?.toEnd(), Escape: () => document.activeElement.blur(),
    };
    const ofWalk = timeline?.live ? {
      w: () => s.set(s.curvature, 0), s: () => s.set(s.curvature, 180), a: () => s.bend(1), d: () => s.bend(-1),
      q: () => s.turn(1), e: () => s.turn(-1), x: this.acts.stop, ArrowUp: () => s.go(), f: () => this.onDraw?.(),
      t: this.actions.acts.perform, o: this.actions.acts["own-action"],
    } : {};
    const ofSimulation = timeline?.live && !this.isLive ? {
      p: this.acts.push, r: this.acts.scramble, c: this.faults.acts.cut, k: this.faults.acts.dead, b: this.faults.acts.break,
      m: this.faults.acts.mend, g: this.acts.race, n: () => this.faults.otherPlant(), Backspace: this.acts.reset,
    } : {};
    const act = { ...ofTime, ...ofWalk, ...ofSimulation }[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  showScene(scene) {
    this.isLive = Boolean(scene.live);  // a live robot: what only a simulated one can do is not offered
    document.body.classList.toggle("live", this.isLive);
    const options = (select, entries, chosen) => {
      select.replaceChildren(...entries.map((name) => new Option(name, name, false, name === chosen)));
      if (!entries.includes(chosen)) select.prepend(new Option(chosen, chosen, true, true));
    };
    options($("robot"), scene.robots, scene.robot);
    $("path").replaceChildren(new Option("Follow …", ""), ...(scene.paths ?? []).map((name) => new Option(name, name)));
    // Kinds that are given by their height have a slider; of the others, an example.
    const kinds = scene.terrains.map(({ example, height }) => (height ? example.split(":")[0] : example));
    const simple = /^([a-z]+):([^,+]+)$/.exec(scene.terrain);
    const sized = simple && kinds.includes(simple[1]);
    options($("terrain"), kinds, sized ? simple[1] : scene.terrain);
    if (sized) $("roughness").value = 100 * Number(simple[2]);
    $("roughness-label").hidden = !sized;
    this.showRoughness();
    this.faults.showScene(scene);
    this.actions.showScene(scene);
    const legs = scene.legs.length, joints = scene.legs[0].joints.length;
    const where = this.isLive ? `LIVE ROBOT ${scene.robot}: ` : this.timeline?.live ? "" : `${scene.robot} on ${scene.terrain}: `;
    $("facts").textContent = `${where}${legs} legs × ${joints} joints, ${scene.mass.toFixed(1)} kg${this.isLive ? "" : `, seed ${scene.seed}`}`;
  }

  showRoughness() { $("roughness-out").textContent = `${$("roughness").value} cm`; }

  showState(words, lamp) {
    if ($("state").textContent !== words) $("state").textContent = words;
    if ($("lamp").className !== lamp) $("lamp").className = lamp;
  }

  state(frame) {
    const { timeline } = this;
    if (!timeline.live) {
      if (frame.fell) return ["fell", "bad"];
      if (timeline.player.playing) return ["plays", "good"];
      return [timeline.player.atEnd ? "at the end" : "paused", "held"];
    }
    if (!this.link.open) return ["not connected", "bad"];
    if (timeline.isBack) return [timeline.player.playing ? "looks back, plays" : "looks back", "held"];
    if (frame.fell) return ["fell – Backspace begins again", "bad"];
    if (frame.fault === kEmergencyStop) return ["EMERGENCY STOP", "bad"];
    if (frame.fault) return [`stopped: ${kFaults[frame.fault]}`, "bad"];
    if (frame.holding && this.isLive) return ["no state of the robot: holds", "bad"];
    if (frame.paused) return ["paused", "held"];
    if (frame.silent) return ["stopped: nobody at the wheel", "held"];
    if (frame.refuses) return ["stands: too few legs left to walk", "bad"];
    const who = frame.holder === 0 ? "by itself" : this.link.holds ? "you steer" : "another page steers";
    if (this.actions.goesOn && !frame.moving) return [`performing, ${who}`, "good"];
    return [frame.moving ? `walking, ${who}` : `standing, ${who}`, "good"];
  }

  showFrame(frame, world) {
    this.frame = frame;
    this.showState(...this.state(frame));
    const pressed = { "gait-free": !frame.wave && !frame.tripod, "gait-wave": frame.wave, "gait-tripod": frame.tripod };
    for (const [id, on] of Object.entries(pressed)) {
      const text = String(on);
      if ($(id).getAttribute("aria-pressed") !== text) $(id).setAttribute("aria-pressed", text);
    }
    $("gait-type").textContent = frame.type === "–" ? "–" : `Type ${frame.type}`;
    $("gait-words").textContent = `CCN ${frame.ccn}${kTypeWords[frame.type] ? " · " + kTypeWords[frame.type] : ""}`;
    const spin = frame.rho < 1e-6;
    const where = spin ? "turns on the spot" : `radius ${Math.abs(frame.k) < 1e-4 ? "∞" : (frame.rho / frame.k).toFixed(2) + " m"}, crab ${((frame.crab * 180) / Math.PI).toFixed(0)}°`;
    $("heading").textContent = this.onRoute(frame) ?? where;
    $("twist").textContent = `vx ${hundredths(frame.vx)}  vy ${hundredths(frame.vy)} m/s  ωz ${hundredths(frame.wz)} rad/s`;
    const text = `${frame.time.toFixed(1)} s, ${frame.path.toFixed(2)} m, ${frame.factor.toFixed(2)} × real time, ${world.fps.toFixed(0)} fps`;
    if (this.shownFacts !== text) $("world").title = this.shownFacts = text;
  }

  /** Where it is on the path that it follows, or has followed; null if there is none. */
  onRoute(frame) {
    if (!this.route) return null;
    const off = `${Math.abs(100 * frame.lateral).toFixed(1)} cm ${frame.lateral > 0 ? "left of" : "right of"} its path`;
    if (frame.follows) return off;
    return frame.silent ? "interrupted on its path" : `at the end, ${off}`;
  }

  notice(words) {
    $("notice").textContent = words;
    $("notice").classList.add("on");
    clearTimeout(this.noticeTimer);
    this.noticeTimer = setTimeout(() => $("notice").classList.remove("on"), 3500);
  }
}
