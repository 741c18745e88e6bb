// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Screenshots as an animated GIF that stays small: one palette, and of each picture only the pixels that
// have changed since the one before.
import gifenc from "gifenc";
import { inflateSync } from "node:zlib";

const { GIFEncoder, applyPalette, quantize } = gifenc;
const kColours = 127;     // and one that is transparent
const kSame = 6;          // levels of red, green or blue, of 255, that count as no change
const kPaletteOf = 6;     // pictures that the palette is made of

const paeth = (left, up, corner) => {
  const [a, b, c] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)];
  return a <= b && a <= c ? left : b <= c ? up : corner;
};

/** The pixels of a PNG as a browser writes it: 8 bits, RGB or RGBA, not interlaced. */
export function decodePng(png) {
  const width = png.readUInt32BE(16), height = png.readUInt32BE(20), bytes = { 2: 3, 6: 4 }[png[25]];
  if (png[24] !== 8 || !bytes || png[28] !== 0) throw new Error("a PNG of another kind");
  const parts = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  const lines = inflateSync(Buffer.concat(parts)), stride = width * bytes;
  const pixels = new Uint8Array(width * height * 4).fill(255);
  let above = new Uint8Array(stride);
  for (let y = 0; y < height; ++y) {
    const filter = lines[y * (stride + 1)], row = new Uint8Array(stride);
    for (let i = 0; i < stride; ++i) {
      const left = i < bytes ? 0 : row[i - bytes], up = above[i], corner = i < bytes ? 0 : above[i - bytes];
      row[i] = lines[y * (stride + 1) + 1 + i] + [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
      pixels[4 * (y * width + Math.floor(i / bytes)) + (i % bytes)] = row[i];
    }
    above = row;
  }
  return { width, height, pixels };
}

/** @param shots  pictures as PNG, all of one size, and when each was taken: [{ png, time [s] }]
 *  @param rest   how long the last one stays [s] */
export function gifOf(shots, rest) {
  const pictures = shots.map(({ png }) => decodePng(png));
  const { width, height } = pictures[0], clear = kColours;
  const some = pictures.filter((_, k) => k % Math.ceil(pictures.length / kPaletteOf) === 0);
  const palette = quantize(Buffer.concat(some.map(({ pixels }) => pixels)), kColours);
  while (palette.length <= clear) palette.push([0, 0, 0]);
  const gif = GIFEncoder(), shown = new Uint8Array(4 * width * height);
  pictures.forEach(({ pixels }, k) => {
    const index = applyPalette(pixels, palette.slice(0, clear));
    for (let i = 0; i < index.length; ++i) {
      const at = 4 * i, off = (c) => Math.abs(pixels[at + c] - shown[at + c]);
      if (k > 0 && Math.max(off(0), off(1), off(2)) <= kSame) index[i] = clear;
      else shown.set(pixels.subarray(at, at + 4), at);
    }
    const delay = 10 * Math.round(100 * (k + 1 < shots.length ? shots[k + 1].time - shots[k].time : rest));
    gif.writeFrame(index, width, height, { palette: k === 0 ? palette : undefined, delay, dispose: 1, transparent: k > 0, transparentIndex: clear });
  });
  gif.finish();
  return Buffer.from(gif.bytes());
}
