// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a replay: the bytes of hexagait/viewer/replay/replay_file.hpp.
import { Tape } from "./tape.js";

const kMagic = "hxreplay", kVersion = 1, kHead = 12;
const latin = new TextDecoder("latin1"), utf8 = new TextDecoder();

/** Do these bytes begin as a replay does? */
export const isReplay = (bytes) => latin.decode(bytes.subarray(0, kMagic.length)) === kMagic;

export async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The frames of an item of kind F, after the row of bytes `last`; which is then the last of these. */
function* frames(content, last) {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const count = view.getUint16(0, true), width = view.getUint16(2, true);
  last.length = Math.min(last.length, width);
  while (last.length < width) last.push(0);
  for (let k = 0; k < count; ++k) {
    const frame = new Uint8Array(width);
    for (let byte = 0; byte < width; ++byte) frame[byte] = last[byte] = (last[byte] + content[4 + byte * count + k]) & 255;
    yield frame;
  }
}

/** @returns a tape with all of it  @throws Error  in words for the person, if it can't be read */
export async function openReplay(bytes) {
  if (!isReplay(bytes)) throw new Error("this is no replay");
  const version = new DataView(bytes.buffer, bytes.byteOffset).getUint32(kMagic.length, true);
  if (version !== kVersion) throw new Error(`a replay of version ${version}; this page plays version ${kVersion}`);
  const body = await inflate(bytes.subarray(kHead)).catch(() => { throw new Error("the replay is cut off or damaged"); });
  const view = new DataView(body.buffer), tape = new Tape(), last = [];
  for (let at = 0; at + 5 <= body.length; ) {
    const kind = String.fromCharCode(body[at]), size = view.getUint32(at + 1, true);
    const content = body.subarray(at + 5, at + 5 + size);
    at += 5 + size;
    if (kind === "F") for (const frame of frames(content, last)) tape.add(frame);
    if (kind !== "T") continue;
    const message = JSON.parse(utf8.decode(content));
    if (message.type === "scene") [tape.scene, tape.ground, tape.setup] = [message, null, null];
    if (message.type === "ground") tape.ground = message;
    if (message.type === "setup") tape.setup = message;
  }
  if (tape.entries.length === 0) throw new Error("nothing moves in this replay");
  return tape;
}

/** The replay that a page has in it, as one file from disk; null if it has none. */
export function embedded() {
  const element = document.getElementById("replay");
  return element ? Uint8Array.from(atob(element.textContent.trim()), (c) => c.charCodeAt(0)) : null;
}
