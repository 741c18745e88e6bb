// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a pose frame: the bytes of hexagait/viewer/display/pose_frame.hpp.

export const kVersion = 2;
export const kPhases = ["support", "unload", "lift", "transfer", "descend", "retreat", "follow", "search", "hold", "lost"];
export const kFaults = ["", "not started", "bad measurement", "plant late", "plant closed", "emergency stop", "bad command"];
export const kEmergencyStop = kFaults.indexOf("emergency stop");
const kFlags = { paused: 1, fell: 2, silent: 4, wave: 8, tripod: 16, holding: 32, follows: 64, refuses: 128 };
const kTypes = ["–", "A", "B", "C", "D"];

class Reader {
  constructor(bytes) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }
  u8() { return this.view.getUint8(this.at++); }
  u16() { this.at += 2; return this.view.getUint16(this.at - 2, true); }
  u32() { this.at += 4; return this.view.getUint32(this.at - 4, true); }
  f32() { this.at += 4; return this.view.getFloat32(this.at - 4, true); }
  f64() { this.at += 8; return this.view.getFloat64(this.at - 8, true); }
  get ends() { return this.at >= this.view.byteLength; }
  vector(n) { return Array.from({ length: n }, () => this.f32()); }
}

/** @param bytes  as a Uint8Array; in a race the frame of the second robot is behind that of the first; the zeros that
 *                a replay has there are none
 *  @returns the frame, with that of the second robot as `rival` (null: there is none); or null if it is of another
 *           version than this page */
export function decodeFrame(bytes) {
  const r = new Reader(bytes), frame = read(r);
  if (frame) frame.rival = r.ends ? null : read(r);
  return frame;
}

function read(r) {
  if (r.u8() !== kVersion) return null;
  const n = r.u8(), bits = r.u8(), fault = r.u8();
  const f = { fault, scene: r.u32(), tick: r.u32(), holder: r.u32(), time: r.f64(), factor: r.f32() };
  for (const [name, bit] of Object.entries(kFlags)) f[name] = (bits & bit) !== 0;
  f.p = r.vector(3);
  f.q = r.vector(4);
  [f.vx, f.vy, f.wz] = r.vector(3);
  [f.rho, f.k, f.crab] = r.vector(3);
  f.moving = r.f32() !== 0;
  f.centre = r.vector(2);
  f.margin = r.f32();
  f.com = r.vector(3);
  [f.lateral, f.path, f.slip, f.power] = r.vector(4);
  f.raw = r.u16();
  f.state = r.u16();
  f.ccn = r.u8();
  f.type = kTypes[r.u8()];
  for (const set of ["priority", "mayStep", "waits", "contact", "support", "urgent"]) f[set] = r.u16();
  f.legs = Array.from({ length: n }, () => {
    const leg = { foot: r.vector(3), target: r.vector(3), force: r.f32(), lag: r.f32(), phase: r.u8() };
    leg.q = r.vector(r.u8());
    return leg;
  });
  f.polygon = Array.from({ length: r.u8() }, () => r.vector(2));
  return f;
}

export const has = (set, leg) => ((set >> leg) & 1) === 1;

/** Does the robot do without this leg? */
export const isLost = (frame, leg) => kPhases[frame.legs[leg].phase] === "lost";

/** The legs around the ring, clockwise from the left front one: (gait 1); it closes over lost ones. */
export function ring(frame) {
  const n = frame.legs.length;
  return Array.from({ length: n }, (_, k) => (k === 0 ? 0 : 2 * k <= n ? 2 * k - 1 : 2 * (n - k))).filter((leg) => !isLost(frame, leg));
}
