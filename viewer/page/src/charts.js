// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The gait diagram, the ring of relations, and strips of numbers over time.
import { has, isLost, ring } from "./frame.js";

export const kWindow = 8;  // shown [s]

/** A canvas in CSS pixels, sharp on any screen. */
function begin(canvas) {
  const ratio = Math.min(2, devicePixelRatio), width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "11px system-ui, sans-serif";
  return { context, width, height };
}

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
export function chartColours() {
  return Object.fromEntries(["text", "faint", "line", "support", "swing", "urgent", "target", "field"].map((n) => [n, css(n)]));
}

/** Left legs above right ones, the front ones first. */
function rows(n) {
  const left = [], right = [];
  for (let i = 0; i < n; i += 2) { left.push(i); right.push(i + 1); }
  return [...left, ...right];
}

export class GaitDiagram {
  constructor(canvas, names) {
    this.canvas = canvas;
    this.names = names;
    this.rows = rows(names.length);
    this.spans = names.map(() => []);  // [from, to, state]
    this.types = [];                   // [from, to, type]
  }

  static extend(spans, time, what) {
    const last = spans.at(-1);
    if (last && last[2] === what) last[1] = time;
    else spans.push([last ? last[1] : time, time, what]);
    while (spans.length && spans[0][1] < time - kWindow) spans.shift();
  }

  take(frame) {
    this.time = frame.time;
    this.spans.forEach((spans, i) =>
      GaitDiagram.extend(spans, frame.time, !has(frame.contact, i) ? "swing" : has(frame.urgent, i) ? "urgent" : "support"));
    GaitDiagram.extend(this.types, frame.time, frame.type);
  }

  draw(colours) {
    if (this.time === undefined) return;
    const { context: c, width, height } = begin(this.canvas);
    const left = 24, foot = 15, rowHeight = (height - foot) / this.rows.length;
    const x = (t) => left + ((width - left) * (t - this.time + kWindow)) / kWindow;
    c.textBaseline = "middle";
    this.rows.forEach((leg, row) => {
      const y = row * rowHeight;
      c.fillStyle = colours.faint;
      c.fillText(this.names[leg], 0, y + rowHeight / 2);
      for (const [from, to, state] of this.spans[leg]) {
        const a = Math.max(left, x(from)), b = x(to);
        if (b <= a) continue;
        c.fillStyle = colours[state];
        if (state === "swing") c.fillRect(a, y + rowHeight / 2 - 1.5, b - a, 3);
        else c.fillRect(a, y + 2, b - a, rowHeight - 4);
      }
    });
    c.fillStyle = colours.faint;
    c.fillText("type", 0, height - foot / 2 + 1);
    for (const [from, to, type] of this.types) {
      const a = Math.max(left, x(from)), b = x(to);
      if (b - a < 1) continue;
      c.fillStyle = type === "D" ? colours.target : colours.line;
      c.fillRect(a, height - foot + 3, b - a - 0.5, foot - 4);
      if (b - a < 11) continue;
      c.fillStyle = type === "D" ? colours.field : colours.text;
      c.fillText(type, (a + b) / 2 - 3, height - foot / 2 + 1.5);
    }
  }
}

/** Where a leg is in the picture of the ring [px]. */
function placeInRing(leg, n, width, height) {
  const row = Math.floor(leg / 2), pairs = n / 2;
  const bulge = 0.06 * width * (row > 0 && row + 1 < pairs ? 1 : 0);
  return [leg % 2 === 0 ? 0.2 * width - bulge + 4 : 0.8 * width + bulge - 4, 13 + (row * (height - 26)) / (pairs - 1)];
}

/** The leg at a point of the picture of the ring; −1 if there is none. */
export function legAt(canvas, n, x, y) {
  return Array.from({ length: n }, (_, leg) => leg).findIndex((leg) => {
    const [a, b] = placeInRing(leg, n, canvas.clientWidth, canvas.clientHeight);
    return Math.hypot(a - x, b - y) < 15;
  });
}

/** The ring: legs as discs, an arrowhead on each edge towards the leg that steps first. */
export function drawRing(canvas, frame, names, colours, chosen) {
  const { context: c, width, height } = begin(canvas);
  const n = names.length, order = ring(frame), edges = order.length, place = (leg) => placeInRing(leg, n, width, height);
  c.lineWidth = 1.5;
  for (let k = 0; k < edges; ++k) {
    const lower = (frame.state >> k) & 1;  // set: `<`, the next one steps first
    const from = place(order[lower ? k : (k + 1) % edges]), to = place(order[lower ? (k + 1) % edges : k]);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]), ux = (to[0] - from[0]) / length, uy = (to[1] - from[1]) / length;
    c.strokeStyle = c.fillStyle = colours.faint;
    c.beginPath();
    c.moveTo(from[0] + 11 * ux, from[1] + 11 * uy);
    c.lineTo(to[0] - 14 * ux, to[1] - 14 * uy);
    c.stroke();
    c.beginPath();
    c.moveTo(to[0] - 11 * ux, to[1] - 11 * uy);
    c.lineTo(to[0] - 18 * ux - 4 * uy, to[1] - 18 * uy + 4 * ux);
    c.lineTo(to[0] - 18 * ux + 4 * uy, to[1] - 18 * uy - 4 * ux);
    c.fill();
  }
  c.textAlign = "center";
  c.textBaseline = "middle";
  c.font = "600 9.5px system-ui, sans-serif";
  for (let leg = 0; leg < n; ++leg) {
    const [x, y] = place(leg), lost = isLost(frame, leg), stands = !lost && has(frame.contact, leg);
    c.beginPath();
    c.arc(x, y, 10, 0, 2 * Math.PI);
    c.fillStyle = stands ? colours.support : colours.field;
    c.fill();
    c.lineWidth = has(frame.priority, leg) ? 3 : 1.5;
    c.strokeStyle = lost ? colours.line : has(frame.priority, leg) ? colours.swing : stands ? colours.support : colours.swing;
    c.stroke();
    if (lost) {
      c.beginPath();
      c.moveTo(x - 8, y + 8);
      c.lineTo(x + 8, y - 8);
      c.stroke();
    }
    if (leg === chosen) {
      c.beginPath();
      c.arc(x, y, 12.5, 0, 2 * Math.PI);
      c.lineWidth = 1;
      c.strokeStyle = colours.text;
      c.stroke();
    }
    c.fillStyle = stands ? colours.field : colours.text;
    c.fillText(names[leg], x, y + 0.5);
  }
  c.textAlign = "left";
}

export class Strip {
  /** @param bounds  [least, most] that are always shown  @param warn  value below or above which it is drawn as urgent */
  constructor(canvas, { title, unit, digits, bounds, warn = null, below = true }) {
    Object.assign(this, { canvas, title, unit, digits, bounds, warn, below });
    this.points = [];
  }

  take(time, value) {
    if (!Number.isFinite(value)) return;
    if (this.points.length && time < this.points.at(-1)[0]) this.points = [];
    this.points.push([time, value]);
    while (this.points[0][0] < time - kWindow) this.points.shift();
  }

  draw(colours) {
    const { context: c, width, height } = begin(this.canvas);
    if (!this.points.length) return;
    const [time, now] = this.points.at(-1), top = 15;
    let [least, most] = this.bounds;
    for (const [, value] of this.points) { least = Math.min(least, value); most = Math.max(most, value); }
    const x = (t) => (width * (t - time + kWindow)) / kWindow;
    const y = (v) => height - 2 - ((height - top - 4) * (v - least)) / (most - least || 1);
    const bad = this.warn !== null && (this.below ? now < this.warn : now > this.warn);
    c.textBaseline = "top";
    c.fillStyle = colours.faint;
    c.fillText(this.title, 0, 0);
    c.fillStyle = bad ? colours.urgent : colours.text;
    c.textAlign = "right";
    c.font = "600 12px system-ui, sans-serif";
    c.fillText(`${bad ? "▲ " : ""}${now.toFixed(this.digits)} ${this.unit}`, width, 0);
    c.textAlign = "left";
    c.strokeStyle = colours.line;
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(0, y(Math.max(0, least)));
    c.lineTo(width, y(Math.max(0, least)));
    c.stroke();
    c.strokeStyle = bad ? colours.urgent : colours.support;
    c.lineWidth = 1.6;
    c.beginPath();
    for (const [t, v] of this.points) c.lineTo(x(t), y(v));
    c.stroke();
  }
}
