// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// node build.mjs SOURCE BUILD: makes BUILD/page_files.cpp of the page in SOURCE: one script and one
// style sheet, compressed, as bytes; and the frame of a page that has all of them, and a replay, in one
// file. BUILD has the node_modules.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { gzipSync } from "node:zlib";

const [source, build] = process.argv.slice(2).map((path) => resolve(path));
const { buildSync } = createRequire(join(build, "package.json"))("esbuild");

const bundled = (file) =>
  Buffer.from(buildSync({
    entryPoints: [join(source, file)], bundle: true, minify: true, write: false, format: "esm",
    target: "es2022", legalComments: "eof", nodePaths: [join(build, "node_modules")],
  }).outputFiles[0].contents);

// Of what is bundled.
function licences() {
  const text = readFileSync(join(build, "node_modules/three/LICENSE"), "utf8");
  return Buffer.from(`The page of hexagait (BSD-3-Clause) has three (https://threejs.org) built in:\n\n${text}`);
}

const files = [
  ["/index.html", "text/html; charset=utf-8", readFileSync(join(source, "index.html"))],
  ["/app.js", "text/javascript; charset=utf-8", bundled("app.js")],
  ["/style.css", "text/css; charset=utf-8", bundled("style.css")],
  ["/icon.svg", "image/svg+xml", readFileSync(join(source, "icon.svg"))],
  ["/licences.txt", "text/plain; charset=utf-8", licences()],
];

// One file: its policy lets run the loader, the script and the style sheet that it was made with, by
// their hashes, and asks nobody for anything.
function alone() {
  const hash = (content) => `'sha256-${createHash("sha256").update(content).digest("base64")}'`;
  const content = (path) => files.find(([p]) => p === path)[2];
  const loader = bundled("alone.js").toString().trim();
  return readFileSync(join(source, "alone.html"), "utf8")
    .replace("@POLICY@", () => `default-src 'none'; script-src ${hash(loader)} ${hash(content("/app.js"))}; ` +
      `style-src ${hash(content("/style.css"))}; img-src data:; base-uri 'none'; form-action 'none'`)
    .replace("@LICENCES@", () => content("/licences.txt").toString())
    .replace("@LOADER@", () => loader);
}

// In lines of 32 numbers.
const numbers = (bytes) => bytes.toString("hex").replace(/../g, (hex) => `${parseInt(hex, 16)},`).replace(/(\d+,){32}/g, "$&\n");

const compressed = files.map(([path, type, content]) => [path, type, gzipSync(content, { level: 9 })]);
writeFileSync(join(build, "page_files.cpp"), `// Made by build.mjs.
#include <hexagait/viewer/server/page_files.hpp>

namespace hexagait::viewer {
namespace {
${compressed.map(([, , bytes], k) => `constexpr unsigned char kFile${k}[] = {\n${numbers(bytes)}};`).join("\n")}
std::string_view text(std::span<const unsigned char> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
const PageFile kFiles[] = {
${compressed.map(([path, type], k) => `    {"${path}", "${type}", text(kFile${k})},`).join("\n")}
};
}  // namespace

std::span<const PageFile> page_files() { return kFiles; }

std::string_view page_alone() {
  static constexpr unsigned char kText[] = {
${numbers(Buffer.from(alone()))}};
  return text(kText);
}

}  // namespace hexagait::viewer
`);
const size = (path) => compressed.find(([p]) => p === path)[2].length;
const all = compressed.reduce((sum, [, , bytes]) => sum + bytes.length, 0);
console.log(`page: ${all} bytes compressed, of which the script ${size("/app.js")}`);
if (all > 250_000) throw new Error("the page is larger than 250 kB");
