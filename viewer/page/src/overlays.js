// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the robot thinks, drawn over it: footholds, footprints, traces, support polygon and centre of
// mass, turning centre and the arcs of legs and body, workspaces.
import {
  BufferAttribute, BufferGeometry, CircleGeometry, DynamicDrawUsage, Group, InstancedMesh, LineBasicMaterial,
  LineSegments, Matrix4, Mesh, RingGeometry, Vector3,
} from "three";
import { has } from "./frame.js";

const kMostRoute = 1100, kPrints = 120, kTrace = 90, kArcSteps = 40;
const kFarCentre = 60;  // a turning centre beyond this is drawn as straight lines [m]

/** A flat band of some width through points in the plane; rebuilt in place. */
class Band {
  constructor(most, material, order) {
    this.most = most;
    this.array = new Float32Array(most * 6);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(this.array, 3).setUsage(DynamicDrawUsage));
    const index = [];
    for (let k = 0; k + 1 < most; ++k) index.push(2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 2, 2 * k + 1, 2 * k + 3);
    this.geometry.setIndex(index);
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
  }
  /** @param points  [x, y, z] each  @param width  of the band at k-th point, or one number */
  set(points, width) {
    const n = Math.min(points.length, this.most);
    for (let k = 0; k < n; ++k) {
      const a = points[Math.max(0, k - 1)], b = points[Math.min(n - 1, k + 1)];
      const l = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
      const w = 0.5 * (typeof width === "function" ? width(k / Math.max(1, n - 1)) : width);
      const x = (-(b[1] - a[1]) / l) * w, y = ((b[0] - a[0]) / l) * w, [px, py, pz] = points[k];
      this.array.set([px + x, py + y, pz, px - x, py - y, pz], 6 * k);
    }
    this.geometry.setDrawRange(0, Math.max(0, 6 * (n - 1)));
    this.geometry.attributes.position.needsUpdate = true;
  }
}

/** Turns and moves p about the centre as the body goes on by `s` [m at the body's origin, or rad]. */
function along(frame, p, s) {
  const straight = !Number.isFinite(frame.centre[0]) ||
    Math.hypot(frame.centre[0] - frame.p[0], frame.centre[1] - frame.p[1]) > kFarCentre;
  if (straight) {
    const heading = yaw(frame.q) + frame.crab;
    return [p[0] + s * Math.cos(heading), p[1] + s * Math.sin(heading)];
  }
  const [ox, oy] = frame.centre, r = Math.hypot(frame.p[0] - ox, frame.p[1] - oy);
  const angle = (Math.sign(frame.k) * s) / Math.max(r, 0.35);
  const c = Math.cos(angle), d = Math.sin(angle), x = p[0] - ox, y = p[1] - oy;
  return [ox + c * x - d * y, oy + d * x + c * y];
}

export const yaw = ([x, y, z, w]) => Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));

export class Overlays {
  constructor(scene, paint) {
    this.legs = scene.legs;
    this.group = new Group();
    this.paint = paint;
    this.radius = scene.foot_radius;
    this.size = Math.max(...scene.legs.map(({ centre: [x, y] }) => Math.hypot(x, y)));
    const n = this.legs.length, unit = this.size;

    this.routes = ["route", "sketch"].map((kind) => this.band(kMostRoute, paint.overlay(kind === "route" ? "path" : "target", 0.9), 4));
    for (const { mesh } of this.routes) mesh.visible = false;
    this.path = this.band(kArcSteps, paint.overlay("path", 0.55), 2);
    this.arcs = this.legs.map(() => this.band(kArcSteps, paint.overlay("path", 0.4), 2));
    this.polygonFill = this.flat(new BufferGeometry(), paint.overlay("polygon", 0.16), 3);
    this.polygonFill.geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * 3 * n), 3).setUsage(DynamicDrawUsage));
    this.polygonEdge = this.band(n + 2, paint.overlay("polygon", 0.9), 4);
    this.marginLine = this.band(2, paint.overlay("com", 0.9), 20);
    this.com = this.flat(new RingGeometry(0.013 * unit, 0.034 * unit, 32), paint.overlay("com", 0.95), 21);
    this.centre = this.flat(new RingGeometry(0.05 * unit, 0.075 * unit, 40), paint.overlay("path", 0.95), 5);
    this.centreDot = this.flat(new CircleGeometry(0.018 * unit, 20), paint.overlay("path", 0.95), 5);
    const ring = new RingGeometry(1.0 * this.radius, 1.6 * this.radius, 32);
    this.targets = this.legs.map(() => this.flat(ring, paint.overlay("target", 0.95), 5));
    this.workspaces = this.legs.map((leg) =>
      this.flat(new RingGeometry(leg.radius - 0.004, leg.radius + 0.004, 48), paint.overlay("faint", 0.45), 1));
    this.addTraces(n);
  }

  band(most, material, order) {
    const band = new Band(most, material, order);
    this.group.add(band.mesh);
    return band;
  }

  flat(geometry, material, order) {
    const mesh = new Mesh(geometry, material);
    mesh.renderOrder = order;
    mesh.frustumCulled = false;
    this.group.add(mesh);
    return mesh;
  }

  addTraces(n) {
    this.prints = new InstancedMesh(new CircleGeometry(0.85 * this.radius, 20), this.paint.overlay("support", 0.4), kPrints);
    this.prints.material.depthTest = true;
    this.prints.count = this.printed = 0;
    this.prints.frustumCulled = false;
    this.prints.renderOrder = 1;
    this.traces = this.legs.map(() => []);
    this.traceArray = new Float32Array(n * kTrace * 6);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.traceArray, 3).setUsage(DynamicDrawUsage));
    this.traceLines = new LineSegments(geometry, new LineBasicMaterial({ color: this.paint.colour("swing"), transparent: true, opacity: 0.75 }));
    this.traceLines.frustumCulled = false;
    this.group.add(this.prints, this.traceLines);
    this.standing = this.legs.map(() => true);
  }

  update(frame) {
    const ground = frame.legs.reduce((sum, leg) => sum + leg.foot[2] / frame.legs.length, 0) - this.radius + 0.004;
    this.showPath(frame, ground);
    this.showPolygon(frame, ground);
    this.showFeet(frame, ground);
  }

  /** The path on the ground that the robot is told to follow; null: none. @param route  as the server has told it */
  showRoute(route) { this.line(this.routes[0], route?.points ?? [], 0.03); }
  /** What is being drawn. @param points  [x, y] each [m] */
  showSketch(points) { this.line(this.routes[1], points, 0.02); }

  line(band, points, width) {
    band.mesh.visible = points.length > 1;
    if (band.mesh.visible) band.set(points.slice(-kMostRoute).map(([x, y]) => [x, y, 0]), width * this.size);
  }

  showPath(frame, z) {
    for (const { mesh } of this.routes) mesh.position.z = z;
    const arc = (p, length) => Array.from({ length: kArcSteps }, (_, k) => [...along(frame, p, (length * k) / (kArcSteps - 1)), z]);
    const shown = frame.moving;
    const taper = (width) => (t) => width * (1 - 0.75 * t);
    this.path.mesh.visible = shown;
    if (shown) this.path.set(arc(frame.p, 3.2 * this.size), taper(0.05 * this.size));
    const heading = yaw(frame.q), c = Math.cos(heading), s = Math.sin(heading);
    this.legs.forEach(({ centre: [x, y] }, i) => {
      const p = [frame.p[0] + c * x - s * y, frame.p[1] + s * x + c * y];
      this.workspaces[i].position.set(p[0], p[1], z);
      this.arcs[i].mesh.visible = shown;
      if (shown) this.arcs[i].set(arc(p, 0.9 * this.size), taper(0.016 * this.size));
    });
    const [ox, oy] = frame.centre, near = Number.isFinite(ox) && Math.hypot(ox - frame.p[0], oy - frame.p[1]) < kFarCentre;
    for (const mark of [this.centre, this.centreDot]) {
      mark.visible = near && frame.moving;
      if (near) mark.position.set(ox, oy, z);
    }
  }

  showPolygon(frame, z) {
    const corners = frame.polygon, colour = frame.margin < 0 ? "urgent" : frame.margin < 0.03 ? "swing" : "polygon";
    for (const part of [this.polygonFill, this.polygonEdge.mesh]) part.material.color.copy(this.paint.colour(colour));
    const closed = corners.length > 1 ? [...corners, corners[0], corners[1]] : [];
    this.polygonEdge.set(closed.map((p) => [...p, z]), 0.015 * this.size);
    const fill = this.polygonFill.geometry, array = fill.attributes.position.array;
    for (let k = 1; k + 1 < corners.length; ++k)
      array.set([...corners[0], z, ...corners[k], z, ...corners[k + 1], z], 9 * (k - 1));
    fill.setDrawRange(0, Math.max(0, 3 * (corners.length - 2)));
    fill.attributes.position.needsUpdate = true;

    this.com.position.set(frame.com[0], frame.com[1], z);
    const nearest = corners.length > 2 ? nearestOnEdge(corners, frame.com) : null;
    this.marginLine.mesh.visible = nearest !== null;
    if (nearest) this.marginLine.set([[frame.com[0], frame.com[1], z], [...nearest, z]], 0.011 * this.size);
  }

  showFeet(frame) {
    frame.legs.forEach((leg, i) => {
      const target = this.targets[i];
      target.visible = Number.isFinite(leg.target[0]);
      if (target.visible) target.position.set(leg.target[0], leg.target[1], leg.target[2] - this.radius + 0.006);
    });
    this.remember(frame);
    this.writeTraces();
  }

  /** Adds to footprints and ways of the feet. */
  remember(frame) {
    frame.legs.forEach((leg, i) => {
      const stands = has(frame.contact, i);
      if (stands && !this.standing[i]) this.print(leg.foot);
      this.standing[i] = stands;
      this.trace(i, leg.foot, stands);
    });
  }

  /** No footprints and no ways: the next frame is not one that follows. */
  forget() {
    this.prints.count = this.printed = 0;
    this.traces = this.legs.map(() => []);
    this.standing = this.legs.map(() => true);
  }

  print([x, y, z]) {
    this.prints.setMatrixAt(this.printed % kPrints, new Matrix4().makeTranslation(x, y, z - this.radius + 0.003));
    this.printed += 1;
    this.prints.count = Math.min(this.printed, kPrints);
    this.prints.instanceMatrix.needsUpdate = true;
  }

  trace(i, p, stands) {
    const trace = this.traces[i], last = trace.at(-1);
    if (stands) { if (last) trace.push(null); }
    else if (!last || Math.hypot(p[0] - last[0], p[1] - last[1], p[2] - last[2]) > 0.012) trace.push(p);
    if (stands && last === null) trace.pop();
    while (trace.length > kTrace) trace.shift();
  }

  writeTraces() {
    let at = 0;
    for (const trace of this.traces)
      for (let k = 1; k < trace.length; ++k) {
        if (!trace[k - 1] || !trace[k]) continue;
        this.traceArray.set(trace[k - 1], at);
        this.traceArray.set(trace[k], at + 3);
        at += 6;
      }
    this.traceLines.geometry.setDrawRange(0, at / 3);
    this.traceLines.geometry.attributes.position.needsUpdate = true;
  }

  dispose() {
    this.group.traverse((object) => object.geometry?.dispose());
    this.group.removeFromParent();
  }
}

function nearestOnEdge(corners, [x, y]) {
  let best = null, least = Infinity;
  corners.forEach(([ax, ay], k) => {
    const [bx, by] = corners[(k + 1) % corners.length];
    const l = (bx - ax) ** 2 + (by - ay) ** 2;
    const t = l > 0 ? Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / l)) : 0;
    const p = [ax + t * (bx - ax), ay + t * (by - ay)], d = Math.hypot(x - p[0], y - p[1]);
    if (d < least) [best, least] = [p, d];
  });
  return best;
}
