// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ground: one mesh of all cells or points that the server has told.
import { BufferAttribute, BufferGeometry, Color, Mesh } from "three";

/** A number of a cell that looks random and is always the same, 0 … 1. */
function speck(i, j) {
  let h = (Math.imul(i, 374761393) + Math.imul(j, 668265263)) | 0;
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

class Faces {
  constructor() {
    this.positions = [];
    this.normals = [];
    this.colours = [];
    this.index = [];
  }
  /** A quadrilateral of corners a b c d, counter-clockwise as seen from its front. */
  add(corners, normal, colour) {
    const first = this.positions.length / 3;
    this.index.push(first, first + 1, first + 2, first, first + 2, first + 3);
    for (const corner of corners) {
      this.positions.push(...corner);
      this.normals.push(...normal);
      this.colours.push(colour.r, colour.g, colour.b);
    }
  }
  geometry() {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(this.positions), 3));
    geometry.setAttribute("normal", new BufferAttribute(new Float32Array(this.normals), 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(this.colours), 3));
    geometry.setIndex(this.index);
    return geometry;
  }
}

export class Ground {
  constructor(told, paint) {
    this.told = told;
    this.mesh = new Mesh(this.faces(paint).geometry(), paint.ground());
    this.mesh.receiveShadow = true;
  }

  // Of the a-th and b-th cell; beyond the last, that of the last.
  level(a, b) {
    const { x, y, levels } = this.told;
    const rows = x.length - 1, columns = y.length - 1;
    return levels[Math.min(a, rows - 1) * columns + Math.min(b, columns - 1)];
  }

  faces(paint) { return this.told.smooth ? this.sheet(paint) : this.cells(paint); }

  // How high, between the lowest and the highest level that is shown.
  shade() {
    let low = Infinity, high = -Infinity;
    for (const z of this.told.levels) { low = Math.min(low, z); high = Math.max(high, z); }
    return (z) => (high > low ? (z - low) / (high - low) : 0.35);
  }

  // A surface through all points.
  sheet(paint) {
    const { x, y, levels } = this.told, n = y.length;
    const low = paint.colour("groundLow"), high = paint.colour("groundHigh");
    const faces = new Faces(), colour = new Color(), shade = this.shade();
    for (let a = 0; a + 1 < x.length; ++a)
      for (let b = 0; b + 1 < n; ++b) {
        const z = [levels[a * n + b], levels[(a + 1) * n + b], levels[(a + 1) * n + b + 1], levels[a * n + b + 1]];
        const dx = (z[1] + z[2] - z[0] - z[3]) / 2 / (x[a + 1] - x[a]), dy = (z[2] + z[3] - z[0] - z[1]) / 2 / (y[b + 1] - y[b]);
        const l = Math.hypot(dx, dy, 1);
        const square = (Math.floor(x[a] / 0.3 + 1e-6) + Math.floor(y[b] / 0.3 + 1e-6)) & 1;
        colour.copy(low).lerp(high, shade(z[0])).multiplyScalar((0.98 + 0.02 * speck(a, b) + (square ? 0.025 : 0)) * (0.8 + 0.2 / l));
        faces.add([[x[a], y[b], z[0]], [x[a + 1], y[b], z[1]], [x[a + 1], y[b + 1], z[2]], [x[a], y[b + 1], z[3]]], [-dx / l, -dy / l, 1 / l], colour);
      }
    return faces;
  }

  // Level cells with walls between them, or ramps as wide as `ramp`.
  cells(paint) {
    const { i0, j0, x, y, ramp } = this.told;
    const low = paint.colour("groundLow"), high = paint.colour("groundHigh");
    const faces = new Faces(), half = ramp / 2, colour = new Color(), wall = new Color(), shade = this.shade();
    for (let a = 0; a + 1 < x.length; ++a)
      for (let b = 0; b + 1 < y.length; ++b) {
        const i = i0 + a, j = j0 + b, z = this.level(a, b);
        colour.copy(low).lerp(high, shade(z)).multiplyScalar(0.96 + 0.06 * speck(i, j) + ((i + j) & 1 ? 0.025 : 0));
        const x0 = x[a] + half, x1 = x[a + 1] - half, y0 = y[b] + half, y1 = y[b + 1] - half;
        faces.add([[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]], [0, 0, 1], colour);
        // To the neighbours behind in x and in y: a wall, or a ramp as wide as that between the tops.
        const zx = this.level(a + 1, b), zy = this.level(a, b + 1), zd = this.level(a + 1, b + 1);
        wall.copy(colour).multiplyScalar(0.8);
        const xe = x1 + ramp, ye = y1 + ramp;
        const slope = (dz) => { const l = Math.hypot(dz, ramp) || 1; return [-dz / l, ramp / l]; };
        if (zx !== z || ramp > 0) {
          const [s, up] = slope(zx - z);
          faces.add([[x1, y0, z], [xe, y0, zx], [xe, y1, zx], [x1, y1, z]], [s, 0, up], wall);
        }
        if (zy !== z || ramp > 0) {
          const [s, up] = slope(zy - z);
          faces.add([[x0, y1, z], [x1, y1, z], [x1, ye, zy], [x0, ye, zy]], [0, s, up], wall);
        }
        if (ramp > 0) faces.add([[x1, y1, z], [xe, y1, zx], [xe, ye, zd], [x1, ye, zy]], [0, 0, 1], wall);
      }
    return faces;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.mesh.removeFromParent();
  }
}
