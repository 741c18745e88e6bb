// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The connection: keeps it up, tells who listens, and gives signs of life while this page steers.
import { decodeFrame } from "./frame.js";
import { isReplay } from "./replay.js";

const kBeat = 120;         // between two signs of life [ms]
const kMostRetry = 2000;   // between two attempts [ms]

export class Link extends EventTarget {
  constructor() {
    super();
    this.you = 0;
    this.frame = null;
    this.frames = 0;
    this.retry = 200;
    this.beaten = performance.now();
  }

  start() {
    this.connect();
    setInterval(() => this.beat(), kBeat);
    addEventListener("pagehide", () => this.holds && this.send({ type: "release" }));
  }

  /** All that there was to be told has been. */
  end() {
    this.socket.onclose = null;
    this.socket.close();
  }

  beat() {
    this.beaten = performance.now();
    if (this.holds) this.send({ type: "beat" });
  }

  /** Time since the last sign of life, or the last one that there was reason to give [ms]. */
  get silence() { return performance.now() - this.beaten; }

  /** May this page take the wheel, or does it hold it? */
  get mayHold() { return this.open && this.frame !== null && (this.frame.holder === 0 || this.holds); }
  /** Does this page hold the wheel? */
  get holds() { return this.frame !== null && this.you !== 0 && this.frame.holder === this.you; }
  get open() { return this.socket?.readyState === WebSocket.OPEN; }

  connect() {
    const token = new URLSearchParams(location.hash.slice(1)).get("token");
    const query = token ? `?token=${encodeURIComponent(token)}` : "";
    this.socket = new WebSocket(`ws://${location.host}/ws${query}`);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => { this.retry = 200; this.tell("open"); };
    this.socket.onmessage = ({ data }) => this.take(data);
    this.socket.onclose = () => {
      this.you = 0;
      this.tell("closed");
      setTimeout(() => this.connect(), this.retry);
      this.retry = Math.min(kMostRetry, 1.6 * this.retry);
    };
  }

  take(data) {
    if (typeof data !== "string") {
      const bytes = new Uint8Array(data);
      if (isReplay(bytes)) return this.tell("replay", bytes);
      const frame = decodeFrame(bytes);
      if (!frame) return location.reload();  // the server is newer than this page
      this.frame = frame;
      this.frames += 1;
      return this.tell("frame", bytes);
    }
    const message = JSON.parse(data);
    if (message.type === "hello") this.you = message.you;
    this.tell(message.type, message);
  }

  tell(type, detail) { this.dispatchEvent(new CustomEvent(type, { detail })); }
  on(type, listener) { this.addEventListener(type, (event) => listener(event.detail)); }
  send(command) { if (this.open) this.socket.send(JSON.stringify(command)); }
}
