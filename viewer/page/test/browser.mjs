// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Servers of hexagait, and pages in Chromium.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { after, before } from "node:test";
import { chromium } from "playwright-core";

// What does not happen within so long hangs [ms]. Ample: another program may have the processor.
const PATIENCE = 60000;

export const startServer = (...options) => serve("steer", ...options);

/** A server of `hexagait steer` or `hexagait replay`. */
export async function serve(command, ...options) {
  const child = spawn(process.env.HEXAGAIT, [command, "--quiet", ...options], { stdio: ["ignore", "pipe", "inherit"] });
  const [line] = await once(child.stdout, "data");
  const url = String(line).trim();
  return {
    pid: child.pid,
    url, port: new URL(url).port,
    async stop() {
      if (child.exitCode !== null) return;
      child.kill("SIGINT");
      await once(child, "exit");
    },
  };
}

export const startBrowser = () =>
  chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });

/** A page that shows a walking robot. Whatever goes wrong in it is in `problems`. */
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.problems = [];
  page.on("pageerror", (error) => page.problems.push(error.message));
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  const own = ({ protocol, host }) => ["data:", "blob:"].includes(protocol) || host === new URL(url).host;
  page.on("request", (request) => own(new URL(request.url())) || page.problems.push(`asks ${request.url()}`));
  const begin = Date.now();
  await page.goto(url);
  await page.waitForFunction(() => window.hexagait?.view().drawn > 0);
  page.drawnAfter = Date.now() - begin;
  return page;
}

/** A browser, a server and a page for the tests of a file: given to `take` before them, and closed after them. */
export function withPage(options, take) {
  let browser, server;
  before(async () => {
    browser = await startBrowser();
    server = await startServer("--port", "0", ...options);
    take({ browser, server, page: await openPage(browser, server.url) });
  });
  after(async () => {
    await browser?.close();
    await server?.stop();
  });
}

/** Presses a key on the world. */
export async function press(page, name) {
  await page.locator("#world").focus();
  await page.keyboard.press(name);
}

/** Asks until the answer is as wanted, and returns it. `wanted` is `text` in the message of one that never is. */
export async function eventually(page, ask, wanted, text = wanted) {
  let answer;
  for (const end = Date.now() + PATIENCE; Date.now() < end; await page.waitForTimeout(30)) {
    answer = await ask();
    if (wanted(answer)) return answer;
  }
  const last = JSON.stringify(answer, (key, value) => (key === "legs" ? [] : value));
  throw new Error(`not within ${PATIENCE} ms: ${text}; the last answer: ${last}`);
}

/** Waits until the element `id` says `words`, a string or a pattern: panels are drawn less often than the robot. */
export const says = (page, id, words) =>
  eventually(page, () => page.locator(`#${id}`).textContent(), (text) => (words instanceof RegExp ? words.test(text) : text === words), `#${id} says ${words}`);

/** The newest frame; after a new scene there is none for a moment. */
export const frameOf = (page) => eventually(page, () => page.evaluate(() => window.hexagait.frame()), Boolean, "a frame");

/** Waits until a function of the frame, and of `argument`, is true. It is asked here: the page's policy
 *  lets no text be run there. */
export const until = (page, condition, argument) =>
  eventually(page, () => frameOf(page), (frame) => condition(frame, argument), condition);
