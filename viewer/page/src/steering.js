// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The wheel, the dial and what they stand for. Curvature, not radius: straight is 0, not infinity.

export const kMostCurvature = 2;  // at the stops of the wheel [1/m]
export const kStop = 150;         // angle of the wheel there [°]

const clamp = (x, least, most) => Math.min(most, Math.max(least, x));
const wrapped = (degrees) => ((((degrees + 180) % 360) + 360) % 360) - 180;

/** Fine about the middle: curvature grows with the square of the angle. Left is positive. */
export const curvatureOf = (angle) => -Math.sign(angle) * kMostCurvature * (angle / kStop) ** 2;
export const angleOf = (curvature) => -Math.sign(curvature) * kStop * Math.sqrt(Math.min(1, Math.abs(curvature) / kMostCurvature));

export const radiusText = (curvature) => (Math.abs(curvature) < 1e-4 ? "inf" : (1 / curvature).toFixed(2));

/** Turns an SVG by dragging: calls with the change of the angle about its middle [°, clockwise]. */
function onTurn(svg, begin, turn) {
  const angle = (event) => {
    const box = svg.getBoundingClientRect();
    return (Math.atan2(event.clientX - box.x - box.width / 2, box.y + box.height / 2 - event.clientY) * 180) / Math.PI;
  };
  let last = null;
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    last = angle(event);
    begin(last);
  });
  svg.addEventListener("pointermove", (event) => {
    if (last === null) return;
    const now = angle(event);
    turn(wrapped(now - last), now);
    last = now;
  });
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => (last = null));
}

export class Steering {
  /** @param drive  called with a command whenever the person steers */
  constructor(drive) {
    this.drive = drive;
    this.curvature = 0;
    this.crab = 0;  // [°]
    this.limit = {};  // of the speed, as part of a command
    this.last = null;  // command that was given
    this.find("wheel", "wheel-turn", "radius", "dial", "dial-turn");
    this.addTicks();
    let raw = 0;
    onTurn(this.wheel, () => (raw = angleOf(this.curvature)), (turn) => {
      raw = clamp(raw + turn, -kStop, kStop);
      this.set(curvatureOf(raw), this.crab);
    });
    onTurn(this.dial, (at) => this.set(this.curvature, -at), (_, at) => this.set(this.curvature, -at));
    this.addKeys();
    this.addFields();
    this.addLimit();
    this.show();
  }

  find(...ids) {
    for (const id of ids) this[id.replace(/-./g, (m) => m[1].toUpperCase())] = document.getElementById(id);
  }

  addTicks() {
    const ticks = document.getElementById("dial-ticks");
    for (let k = 0; k < 24; ++k) {
      const line = document.createElementNS("http://www.w3.org/2000/svg", "path");
      line.setAttribute("class", "tick");
      line.setAttribute("d", k % 6 === 0 ? "M0 -56V-51" : "M0 -55V-52.5");
      line.setAttribute("transform", `rotate(${15 * k})`);
      ticks.append(line);
    }
  }

  addKeys() {
    const onKey = (element, act) =>
      element.addEventListener("keydown", (event) => {
        const way = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 }[event.key];
        if (way === undefined && event.key !== "Home") return;
        event.preventDefault();
        event.stopPropagation();
        act(way ?? 0);
      });
    onKey(this.wheel, (way) => (way ? this.bend(way) : this.set(0, this.crab)));
    onKey(this.dial, (way) => (way ? this.turn(way) : this.set(this.curvature, 0)));
  }

  addFields() {
    this.radius.addEventListener("change", () => {
      const text = this.radius.value.trim().toLowerCase(), value = Number.parseFloat(text);
      if (/^[-+]?inf/.test(text)) this.set(0, this.crab);
      else if (Number.isFinite(value) && Math.abs(value) >= 0.001) this.set(1 / value, this.crab);
      else this.show();
    });
    const crab = document.getElementById("crab");
    crab.addEventListener("change", () => {
      const value = Number.parseFloat(crab.value);
      if (Number.isFinite(value)) this.set(this.curvature, value);
      else this.show();
    });
  }

  /** At the right end there is no limit: the robot is as fast as its gait. */
  addLimit() {
    const slider = document.getElementById("limit");
    slider.addEventListener("input", () => {
      const most = Number(slider.value) >= Number(slider.max);
      this.limit = most ? {} : { limit: Number(slider.value) };
      document.getElementById("limit-out").textContent = most ? "none" : `${Number(slider.value).toFixed(2)} m/s`;
      if (this.last?.type === "spin") this.spin(this.last.turn);
      else if (this.last?.type === "follow" && this.isOnPath?.()) this.command({ ...this.last, limit: undefined, ...this.limit });
      else if (this.last?.type !== "stop") this.go();
    });
  }

  /** One notch to the left (1) or right (−1). */
  bend(way) { this.set(curvatureOf(clamp(angleOf(this.curvature) - 12 * way, -kStop, kStop)), this.crab); }
  turn(way) { this.set(this.curvature, Math.round(this.crab / 15) * 15 + 15 * way); }

  set(curvature, crab) {
    this.curvature = clamp(curvature, -100, 100);
    this.crab = wrapped(crab);
    this.show();
    this.go();
  }

  go() { this.command({ type: "drive", curvature: this.curvature, crab: (this.crab * Math.PI) / 180, ...this.limit }); }
  stop() { this.command({ type: "stop" }); }
  spin(turn) { this.command({ type: "spin", turn, ...this.limit }); }

  follow(path) { this.command({ type: "follow", ...path, ...this.limit }); }

  /** A scripted action; whatever was commanded before is not repeated after it. */
  perform(action) {
    this.last = { type: "stop" };
    this.drive({ type: "action", ...action });
  }

  /** After an emergency stop: nothing is repeated by itself. */
  forget() { this.last = null; }

  command(command) {
    this.last = command;
    this.drive(command);
  }

  /** Shows what the robot is told, while another steers, or nobody. */
  showCommand(frame) {
    const curvature = frame.rho > 1e-6 ? frame.k / frame.rho : Math.sign(frame.k) * kMostCurvature;
    const crab = (frame.crab * 180) / Math.PI;
    if (Math.abs(curvature - this.curvature) < 1e-5 && Math.abs(wrapped(crab - this.crab)) < 0.01) return;
    this.curvature = curvature;
    this.crab = wrapped(crab);
    this.show();
  }

  show() {
    const turn = angleOf(this.curvature);
    this.wheelTurn.setAttribute("transform", `rotate(${turn})`);
    this.dialTurn.setAttribute("transform", `rotate(${-this.crab})`);
    this.wheel.setAttribute("aria-valuenow", this.curvature.toFixed(3));
    this.wheel.setAttribute("aria-valuetext", this.curvature === 0 ? "straight" : `radius ${radiusText(this.curvature)} metres`);
    this.dial.setAttribute("aria-valuenow", this.crab.toFixed(0));
    if (document.activeElement !== this.radius) this.radius.value = radiusText(this.curvature);
    const field = document.getElementById("crab");
    if (document.activeElement !== field) field.value = this.crab.toFixed(0);
  }
}
