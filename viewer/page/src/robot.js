// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The robot as three sees it: the shapes of its links, moved by base pose and joint angles.
import {
  BoxGeometry, ConeGeometry, CylinderGeometry, Group, Matrix4, Mesh, Quaternion, SphereGeometry, Vector3,
} from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import { has } from "./frame.js";

const kZ = new Vector3(0, 0, 1);
const kOrder = 10;  // of drawing: after what lies on the ground, before what is always seen
const pose = ({ p, q }) => new Matrix4().compose(new Vector3(...p), new Quaternion(...q), new Vector3(1, 1, 1));

function geometry(shape) {
  const [a, b, c] = shape.size;
  if (shape.kind === "sphere") return new SphereGeometry(a, 20, 14);
  if (shape.kind === "cylinder") return new CylinderGeometry(a, a, b, 20).rotateX(Math.PI / 2);
  const edge = 0.28 * Math.min(a, b, c);
  return edge > 0 ? new RoundedBoxGeometry(a, b, c, 3, edge) : new BoxGeometry(a, b, c);
}

/** How thick a link is about its joint: the thinnest of its shapes' cross-sections, halved [m]. */
function thickness(link, otherwise) {
  const halves = link.shapes.map(({ kind, size: [a, b, c] }) => (kind === "box" ? 0.5 * Math.min(a, b, c) : a));
  return halves.length ? Math.min(...halves) : otherwise;
}

export class Robot {
  /** @param paint  colours and materials: see world.js */
  constructor(scene, paint) {
    this.legs = scene.legs;
    this.paint = paint;
    this.group = new Group();
    this.moved = [];   // [mesh or group, leg, joint] whose matrix is that of a link
    this.feet = [];

    const body = new Group();
    body.applyMatrix4(pose(scene.base.pose));
    for (const shape of scene.base.shapes) body.add(this.shape(shape, "body"));
    this.group.add(body);
    this.addFront(scene.base);
    this.legs.forEach((leg, i) => this.addLeg(leg, i, scene.foot_radius));
    this.group.traverse((object) => (object.renderOrder = kOrder));
  }

  shape(shape, colour) {
    const mesh = new Mesh(geometry(shape), this.paint.solid(colour));
    mesh.applyMatrix4(pose(shape.pose));
    mesh.castShadow = mesh.receiveShadow = true;
    return mesh;
  }

  /** A wedge on the back of the body that points ahead. */
  addFront(base) {
    let front = 0, top = 0, wide = 0.05;
    for (const { size: [a, b, c], pose: { p }, kind } of base.shapes) {
      const [x, y, z] = kind === "box" ? [a / 2, b / 2, c / 2] : [a, a, a];
      front = Math.max(front, p[0] + x);
      top = Math.max(top, p[2] + z);
      wide = Math.max(wide, y);
    }
    const size = 0.55 * wide;
    const wedge = new Mesh(new ConeGeometry(size, 1.5 * size, 3).rotateZ(-Math.PI / 2).rotateX(Math.PI / 2), this.paint.solid("accent"));
    wedge.scale.z = 0.16;
    wedge.position.set(front - 1.3 * size, 0, top);
    this.group.add(wedge);
  }

  addLeg(leg, i, footRadius) {
    leg.joints.forEach(({ link, axis, point }, k) => {
      const part = new Group();
      part.matrixAutoUpdate = false;
      const own = pose(link.pose), inverse = own.clone().invert();
      for (const shape of link.shapes) part.add(this.shape(shape, k + 1 === leg.joints.length ? "shin" : "limb"));
      // The joint: a hub about its axis, in the link that it moves.
      const r = 1.25 * thickness(link, 0.6 * footRadius);
      const hub = new Mesh(new CylinderGeometry(r, r, 2.1 * r, 20).rotateX(Math.PI / 2), this.paint.solid("joint"));
      hub.quaternion.setFromUnitVectors(kZ, new Vector3(...axis));
      hub.position.set(...point);
      hub.applyMatrix4(inverse);
      hub.castShadow = true;
      part.add(hub);
      if (k + 1 === leg.joints.length) this.addFoot(part, leg, inverse, footRadius);
      this.moved.push({ part, leg: i, joint: k, own });
      this.group.add(part);
    });
  }

  addFoot(part, leg, inverse, radius) {
    const foot = new Mesh(new SphereGeometry(1.12 * radius, 20, 14), this.paint.solid("support").clone());
    foot.position.set(...leg.foot).applyMatrix4(inverse);
    foot.castShadow = true;
    part.add(foot);
    this.feet.push(foot);
  }

  move(frame) {
    this.group.position.set(...frame.p);
    this.group.quaternion.set(...frame.q);
    const turn = new Matrix4(), there = new Matrix4(), back = new Matrix4(), chain = [];
    for (const { part, leg, joint, own } of this.moved) {
      const { axis, point } = this.legs[leg].joints[joint];
      turn.makeRotationAxis(new Vector3(...axis), frame.legs[leg].q[joint]);
      there.makeTranslation(...point);
      back.makeTranslation(-point[0], -point[1], -point[2]);
      const step = there.clone().multiply(turn).multiply(back);
      chain[joint] = joint === 0 ? step : chain[joint - 1].clone().multiply(step);
      part.matrix.copy(chain[joint]).multiply(own);
      part.matrixWorldNeedsUpdate = true;
    }
    this.feet.forEach((foot, i) => foot.material.color.copy(this.paint.colour(this.state(frame, i))));
  }

  /** These legs are not there any more. */
  lose(legs) {
    this.lost = legs;
    for (const { part, leg } of this.moved) part.visible = !legs.includes(leg);
  }

  state(frame, i) {
    if (!has(frame.contact, i)) return "swing";
    return has(frame.urgent, i) ? "urgent" : "support";
  }

  /** Where the page draws the feet, in the world [m]. */
  footPositions() {
    this.group.updateMatrixWorld(true);
    return this.feet.map((foot) => foot.getWorldPosition(new Vector3()).toArray());
  }

  dispose() {
    this.group.traverse((object) => object.geometry?.dispose());
    this.group.removeFromParent();
  }
}
