// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ground: one mesh of all cells that the server has told, with walls or ramps between them.
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

  level(i, j) {
    const { i0, j0, cells, levels } = this.told;
    const a = Math.min(Math.max(i - i0, 0), cells - 1), b = Math.min(Math.max(j - j0, 0), cells - 1);
    return levels[a * cells + b];
  }
  heightAt(x, y) { return this.level(Math.floor(x / this.told.cell), Math.floor(y / this.told.cell)); }

  faces(paint) {
    const { i0, j0, cells, cell, ramp, highest } = this.told;
    const low = paint.colour("groundLow"), high = paint.colour("groundHigh");
    const faces = new Faces(), half = ramp / 2, colour = new Color(), wall = new Color();
    for (let a = 0; a < cells; ++a)
      for (let b = 0; b < cells; ++b) {
        const i = i0 + a, j = j0 + b, z = this.level(i, j);
        const share = highest > 0 ? z / highest : 0.35;
        colour.copy(low).lerp(high, share).multiplyScalar(0.96 + 0.06 * speck(i, j) + ((i + j) & 1 ? 0.025 : 0));
        const x0 = i * cell + half, x1 = (i + 1) * cell - half, y0 = j * cell + half, y1 = (j + 1) * cell - half;
        faces.add([[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]], [0, 0, 1], colour);
        if (highest === 0 && ramp === 0) continue;
        // To the neighbours behind in x and in y: a wall, or a ramp as wide as that between the tops.
        const zx = this.level(i + 1, j), zy = this.level(i, j + 1), zd = this.level(i + 1, j + 1);
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
