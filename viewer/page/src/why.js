// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why a leg steps or does not, in a sentence: what the gait state of a frame says about it.
import { has, isLost, kPhases, ring } from "./frame.js";

const kAir = {
  unload: "hands its load over before it lifts", lift: "lifts", transfer: "is on its way to its next foothold",
  descend: "comes down", retreat: "has hit something and goes around it", search: "looks for the ground",
  follow: "follows a script", hold: "is held up",
};

/** The neighbours of a leg, and whether each steps before it. */
function neighbours(frame, leg) {
  const order = ring(frame), n = order.length, k = order.indexOf(leg), before = (k + n - 1) % n;
  return [
    { leg: order[before], first: ((frame.state >> before) & 1) === 0 },  // `before > leg`
    { leg: order[(k + 1) % n], first: ((frame.state >> k) & 1) === 1 },  // `leg < after`
  ];
}

/** @param names  of all legs  @returns a sentence about one of them */
export function why(frame, leg, names) {
  const { phase, lag } = frame.legs[leg], name = names[leg];
  if (isLost(frame, leg)) return `${name} is lost: the robot does without it. The ring has closed over it: the legs beside it are neighbours now.`;
  const both = neighbours(frame, leg), list = (legs) => legs.map(({ leg: i }) => names[i]).join(" and ");
  const is = (legs) => `${list(legs)} ${legs.length > 1 ? "are" : "is"}`;
  if (kPhases[phase] !== "support") return `${name} ${kAir[kPhases[phase]]}.`;

  const behind = `It is ${Math.abs(100 * lag).toFixed(1)} cm ${lag >= 0 ? "behind" : "ahead of"} its centre${has(frame.urgent, leg) ? ", near the end of its reach" : ""}.`;
  const first = both.filter((one) => one.first), up = both.filter((one) => !has(frame.support, one.leg));
  if (!frame.moving) return `${name} stands, as the robot does. ${behind}`;
  if (first.length) {
    const why = first.some((one) => !has(frame.support, one.leg)) ? "" : first.length > 1 ? ", which lag more or were put first" : ", which lags more or was put first";
    return `${name} waits for ${list(first)}${why}${up.length ? `: ${is(up)} in the air` : ""}. ${behind}`;
  }
  if (up.length) return `${name} is next, once ${is(up)} down. ${behind}`;
  if (has(frame.waits, leg)) return `${name} may step and is held back: by its gait, or as a neighbour is not sure of its ground. ${behind}`;
  return `${name} may step now. ${behind}`;
}
