// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts a page together that has all its files in itself, compressed, as base64; then its script runs.
const file = async (id) => {
  const bytes = Uint8Array.from(atob(document.getElementById(id).textContent.trim()), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
};
const add = (name, text, properties = {}) =>
  document.head.append(Object.assign(document.createElement(name), { textContent: text, ...properties }));

try {
  const [page, style, app, icon] = await Promise.all(["page", "style", "app", "icon"].map(file));
  const address = `data:image/svg+xml,${encodeURIComponent(icon)}`;
  const { body } = new DOMParser().parseFromString(page, "text/html");
  for (const image of body.querySelectorAll("img")) image.src = address;
  add("style", style);
  add("link", "", { rel: "icon", href: address });
  document.body.prepend(...body.childNodes);
  add("script", app, { type: "module" });
} catch (error) {
  document.body.textContent = `This browser can't play the walk: ${error.message}`;
}
