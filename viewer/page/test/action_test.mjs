// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { frameOf, openPage, press, says, until, withPage } from "./browser.mjs";

// Scripted actions: of the list, and of a file.
let browser, server, page;

withPage(["--terrain", "flat", "--speed", "3"], (parts) => ({ browser, server, page } = parts));

const kRight = 1;  // the right front leg, which paw lifts
const kBad = "steps:\n- step:\n  - base_auto: {hieght: 0.2}\n- step:\n  - wait: {}\n";
const key = (name) => press(page, name);
const words = (pattern, timeout = 60000) => page.waitForFunction(
  ([source]) => new RegExp(source).test(document.getElementById("action-facts").textContent), [pattern], { timeout });
const yaml = (name, text) => ({ name, mimeType: "application/yaml", buffer: Buffer.from(text) });
/** Drags a file over the page, and drops it. */
const drop = (name, text) => page.evaluate(([file, content]) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([content], file));
  const fire = (type) => {
    const event = new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true });
    document.getElementById("world").dispatchEvent(event);
    return event.defaultPrevented;
  };
  const over = fire("dragover"), marked = document.body.classList.contains("drops");
  return { over, marked, dropped: fire("drop"), after: document.body.classList.contains("drops") };
}, [name, text]);

test("an action of the list is performed step by step, and then the robot walks again", async () => {
  const names = await page.locator("#action option").allTextContents();
  assert.deepEqual(names, await page.evaluate(() => window.hexagait.scene().actions));
  assert.ok(names.includes("paw") && names.includes("push_up"));
  await page.locator("#action").selectOption("paw");
  await key("t");
  await words("^paw: step [1-9] of \\d+$");
  await says(page, "perform", "Stop it");
  await until(page, (f, leg) => !f.moving && f.legs[leg].foot[2] > 0.15, kRight);
  await says(page, "state", /^performing, you steer/);
  await page.screenshot({ path: `${process.env.OUT}/action.png` });
  await words("^paw: done$", 40000);
  await says(page, "perform", "Perform");
  const { path } = await frameOf(page);
  await key("w");
  await until(page, (f, before) => f.moving && f.path > before + 0.1 && !f.fell, path);
});

test("Stop ends it, with all feet on the ground", async () => {
  await page.locator("#perform").click();
  await until(page, (f, leg) => f.legs[leg].foot[2] > 0.15, kRight);
  await page.locator("#perform").click();  // which is Stop it
  await words("^paw: stopped$");
  await until(page, (f) => !f.moving && f.legs.every(({ foot }) => foot[2] < 0.1));
});

test("a YAML file that is dropped is refused with the lines of its errors, and nothing changes", async () => {
  await key("w");
  await until(page, (f) => f.moving);
  const { scene } = await frameOf(page);
  assert.deepEqual(await drop("my.yaml", kBad), { over: true, marked: true, dropped: true, after: false });
  await page.locator("#findings").waitFor();
  await says(page, "findings-title", "my.yaml is refused: 2 errors");
  const found = await page.locator("#finding-list li.error").allTextContents();
  assert.equal(found.length, 2);
  assert.match(found[0], /^line 3, column 17: error unknown key of base_auto "hieght"; did you mean "height"\?/);
  assert.deepEqual(await page.locator("#finding-list code").allTextContents(), ["  - base_auto: {hieght: 0.2}", "  - wait: {}"]);
  await says(page, "action-facts", /^my\.yaml: refused: 2 errors$/);
  assert.equal(await page.locator("#findings").getAttribute("role"), "alert");
  await page.screenshot({ path: `${process.env.OUT}/findings.png` });
  const f = await frameOf(page);
  assert.ok(f.moving && f.scene === scene);
  await page.locator("#hide-findings").click();
  assert.ok(await page.locator("#findings").isHidden());
});

test("O chooses a file by the keyboard; a good one is performed", async () => {
  const chooser = page.waitForEvent("filechooser");
  await key("o");
  await (await chooser).setFiles(yaml("down.yaml", "steps:\n- step:\n  - base_auto: {height: 0.22}\n"));
  await words("^down\\.yaml: done$");
  assert.ok(await page.locator("#findings").isHidden());
});

test("what the robot can't do is found before it moves; what is no action, and too long, is not sent", async () => {
  const file = page.locator("#action-file");
  await file.setInputFiles(yaml("far.yaml",
    "steps:\n- step:\n  - base_target:\n      target: {frame: footprint, position: [0, 0, 3], orientation: [0, 0, 0]}\n      average_linear_velocity: 1\n"));
  await page.locator("#findings").waitFor();
  assert.match(await page.locator("#finding-list li.error").first().textContent(), /^line 3, .*beyond where the leg reaches/);
  await file.setInputFiles(yaml("long.yaml", "#".repeat(65537)));
  await page.locator("#notice.on").waitFor();
  await says(page, "notice", /^long\.yaml has 65537 bytes; an action has at most 65536/);
  await file.setInputFiles(yaml("full.yaml", `steps: # ${"\n".repeat(65000)}`));  // of allowed length, in JSON twice as long
  await words("^full\\.yaml: refused");
});

test("an action for a robot of other legs is refused by name", async () => {
  await page.locator("#action").selectOption("push_up");
  await page.locator("#perform").click();
  await words("^push_up: refused");
  assert.match(await page.locator("#finding-list li").textContent(), /quadruped/);
});

test("the emergency stop holds it, and its release lets it stand", async () => {
  await page.locator("#action").selectOption("paw");
  await key("t");
  await until(page, (f, leg) => f.legs[leg].foot[2] > 0.15, kRight);
  await key("Escape");
  await words("^paw: stopped: by the emergency stop$");
  await page.waitForTimeout(500);
  const f = await frameOf(page);
  assert.ok(f.fault > 0 && f.legs[kRight].foot[2] > 0.1);  // the leg in the air too
  await page.locator("#release-estop").click();
  await until(page, (g) => g.fault === 0 && g.legs.every(({ foot }) => foot[2] < 0.1));
});

test("another page sees it, and what was over before it came is not shown", async () => {
  const other = await openPage(browser, server.url);
  await other.waitForTimeout(300);
  await says(other, "action-facts", "");
  await page.locator("#action").selectOption("height");
  await key("t");
  await says(other, "action-facts", /^height: /);
  await words("^height: done$");
  assert.deepEqual(other.problems, []);
  await other.context().close();
});

test("on a phone it can be chosen too", async () => {
  assert.deepEqual(page.problems, []);
  await page.context().close();
  const phone = await openPage(browser, server.url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await phone.locator("#more").tap();
  await phone.locator("#action").selectOption("push_up");
  await phone.locator("#perform").tap();
  await phone.locator("#findings").waitFor();
  const box = await phone.locator("#findings").boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 390);
  await phone.screenshot({ path: `${process.env.OUT}/phone_action.png` });
  assert.deepEqual(phone.problems, []);
  await phone.context().close();
});
