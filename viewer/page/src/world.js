// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws: light, a camera that follows the robot, and a quality that the machine can keep up with.
import {
  DirectionalLight, Fog, HemisphereLight, PCFShadowMap, PerspectiveCamera, Plane, Raycaster, Scene, Vector2, Vector3,
  WebGLRenderer,
} from "three";
import { Paint, scheme } from "./palette.js";

const kLevels = [  // from the best
  { ratio: 2, shadows: true }, { ratio: 1.25, shadows: true }, { ratio: 1, shadows: false },
  { ratio: 0.75, shadows: false }, { ratio: 0.5, shadows: false },
];
const kSlow = 38, kFast = 19;  // mean time between two pictures [ms] at which the quality changes

/** Is WebGL computed by the processor? */
function drawsInSoftware(gl) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return /swiftshader|llvmpipe|software|softpipe/i.test(String(name));
}

export class World {
  constructor(canvas) {
    const probe = document.createElement("canvas").getContext("webgl2");
    if (!probe) throw new Error("this browser has no WebGL 2");
    this.software = drawsInSoftware(probe);
    probe.getExtension("WEBGL_lose_context")?.loseContext();
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.software, powerPreference: "high-performance" });
    this.renderer.shadowMap.type = PCFShadowMap;
    this.paint = new Paint(this.software);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(42, 1, 0.05, 60);
    this.camera.up.set(0, 0, 1);
    this.addLight();
    this.focus = new Vector3(0, 0, 0.25);
    this.view = { azimuth: -2.35, elevation: 0.52, distance: 2.7 };
    this.level = this.software ? 3 : 0;
    this.interval = 1000 / 60;
    this.frames = 0;
    this.settled = 0;
    addEventListener("resize", () => this.resize());
    this.resize();
    this.applyScheme();
  }

  addLight() {
    this.sky = new HemisphereLight(0xffffff, 0x8a8f98, 1.5);
    this.sun = new DirectionalLight(0xfff4e0, 2.2);
    this.sun.shadow.mapSize.set(1536, 1536);
    this.sun.shadow.radius = 3;
    this.sun.shadow.bias = -0.0005;
    const box = this.sun.shadow.camera;
    [box.left, box.right, box.top, box.bottom, box.near, box.far] = [-2, 2, 2, -2, 0.5, 9];
    this.scene.add(this.sky, this.sun, this.sun.target);
  }

  applyScheme() {
    this.paint.refresh();
    this.scene.background = this.paint.colour("sky");
    this.scene.fog = new Fog(this.paint.colour("sky"), 5, 11);
    this.sky.intensity = this.paint.dark ? 1.5 : 1.6;
    this.sun.intensity = this.paint.dark ? 1.9 : 2.0;
  }

  onScheme(listener) {
    scheme.addEventListener("change", () => { this.applyScheme(); listener(); });
  }

  resize() {
    const { ratio, shadows } = kLevels[this.level];
    const width = innerWidth, height = innerHeight;
    this.renderer.setPixelRatio(Math.min(ratio, this.software ? ratio : devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.renderer.shadowMap.enabled = shadows;
    this.sun.castShadow = shadows;
    this.camera.aspect = width / height;
    // What panels cover is no place for the robot: the middle of the picture moves.
    const [dx, dy] = width > 900 ? [0.0, 0.06] : [0, 0.3];
    this.camera.setViewOffset(width, height, dx * width * 0.5, dy * height * 0.5, width, height);
    this.camera.updateProjectionMatrix();
  }

  /** As far away as a robot of this size needs, the more so on a narrow screen. */
  stepBack(size) { this.view.distance = 3.4 * Math.max(0.25, size) * Math.max(1, 0.8 / this.camera.aspect); }

  /** Follows a point, softly; a camera that is to be still stays where it is. */
  follow(p, share) {
    if (this.view.still) return;
    this.focus.lerp(new Vector3(p[0], p[1], 0.55 * p[2] + 0.05), share);
  }

  orbit(dx, dy) {
    this.view.azimuth -= 0.006 * dx;
    this.view.elevation = Math.min(1.5, Math.max(0.06, this.view.elevation + 0.005 * dy));
  }
  zoom(factor) { this.view.distance = Math.min(9, Math.max(0.7, this.view.distance * factor)); }

  /** Where a point of the picture [px] is on a level plane; null above the horizon. */
  groundAt(x, y, height) {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / innerWidth - 1, 1 - (2 * y) / innerHeight), this.camera);
    return ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -height), new Vector3());
  }

  draw() {
    const { azimuth, elevation, distance } = this.view, flat = distance * Math.cos(elevation);
    this.camera.position.set(
      this.focus.x + flat * Math.cos(azimuth), this.focus.y + flat * Math.sin(azimuth),
      this.focus.z + distance * Math.sin(elevation));
    this.camera.lookAt(this.focus);
    this.sun.position.copy(this.focus).add(new Vector3(-1.6, 2.2, 3.6));
    this.sun.target.position.copy(this.focus);
    this.renderer.render(this.scene, this.camera);
    this.watchTime();
  }

  /** A quality for a picture of the page: it stays so. */
  fix(level) {
    this.level = level;
    this.fixed = true;
    this.resize();
  }

  /** Goes down a level when pictures take too long, and up when there is time; not to and fro. */
  watchTime() {
    const now = performance.now(), passed = now - (this.last ?? now);
    this.last = now;
    this.frames += 1;
    if (passed <= 0 || passed > 400) return;
    this.interval += 0.05 * (passed - this.interval);
    if (++this.settled < 45 || this.fixed) return;
    const down = this.interval > kSlow && this.level + 1 < kLevels.length;
    const up = this.interval < kFast && this.level > (this.software ? 2 : 0) && !this.wasTooMuch;
    if (!down && !up) return;
    this.wasTooMuch ||= down;
    this.level += down ? 1 : -1;
    this.settled = 0;
    this.resize();
  }

  get fps() { return 1000 / this.interval; }
}
