// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The colours, light and dark. What means something is of Okabe and Ito's palette, which colour-blind
// people can tell apart, and is never told by its colour alone.
import { Color, MeshBasicMaterial, MeshLambertMaterial, MeshStandardMaterial } from "three";

const kLight = {
  sky: "#e9eef3", groundLow: "#b9bfbd", groundHigh: "#f3efe6", body: "#f2f4f6", limb: "#c3cad2", shin: "#8d98a4",
  joint: "#4a5560", accent: "#e69f00", support: "#0072b2", swing: "#e69f00", urgent: "#d55e00", target: "#009e73",
  polygon: "#0072b2", com: "#1b1f23", path: "#cc79a7", text: "#1b1f23", faint: "#5c6670", line: "#cfd6dc",
};
const kDark = {
  sky: "#14181d", groundLow: "#3a424b", groundHigh: "#77818c", body: "#e4e8ec", limb: "#aab4be", shin: "#93a0ad",
  joint: "#55616d", accent: "#e69f00", support: "#56b4e9", swing: "#e69f00", urgent: "#ff7a33", target: "#2bd3a2",
  polygon: "#56b4e9", com: "#ffffff", path: "#dd96bd", text: "#e8ecf0", faint: "#9aa5b0", line: "#39424c",
};

export const scheme = matchMedia("(prefers-color-scheme: dark)");

export class Paint {
  /** @param plain  cheap materials, for a machine that draws in software */
  constructor(plain) {
    this.plain = plain;
    this.refresh();
  }

  refresh() {
    this.hex = scheme.matches ? kDark : kLight;
    this.dark = scheme.matches;
    this.colours = Object.fromEntries(Object.entries(this.hex).map(([name, hex]) => [name, new Color(hex)]));
    this.solids = {};
  }

  colour(name) { return this.colours[name]; }

  solid(name) {
    // In the transparent pass, so that the robot is drawn after what lies on the ground, and over it.
    const options = { color: this.colours[name], transparent: true };
    this.solids[name] ??= this.plain
      ? new MeshLambertMaterial(options)
      : new MeshStandardMaterial({ ...options, roughness: 0.55, metalness: name === "joint" ? 0.5 : 0.08 });
    return this.solids[name];
  }

  /** The same for a second robot: paler, and seen through. */
  pale() {
    const made = {};
    const solid = (name) => (made[name] ??= Object.assign(this.solid(name).clone(), { opacity: 0.38, depthWrite: false }));
    return { solid, colour: (name) => this.colour(name) };
  }

  ground() { return new MeshLambertMaterial({ vertexColors: true }); }

  /** For what is drawn over everything: it is never hidden by the robot or the ground. */
  overlay(name, opacity = 1) {
    return new MeshBasicMaterial({
      color: this.colours[name], transparent: true, opacity, depthTest: false, depthWrite: false, side: 2,
    });
  }
}
