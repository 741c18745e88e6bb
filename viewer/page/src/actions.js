// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scripted actions: those of the server's list, and YAML files of the person's own, which are dropped on the page or
// chosen. What the server finds in one is listed with its lines.

const $ = (id) => document.getElementById(id);
const kMostBytes = 65536;  // of an action: command.hpp
const kLongestName = 64;

/** What is going on, in words. @param news  as the server tells it */
export function progressWords({ name, state, step, steps, why }) {
  const because = why ? `: ${why}` : "";
  if (state === "checking") return `${name}: is checked`;
  if (state === "running") return step > 0 ? `${name}: step ${step} of ${steps}` : `${name}: the robot stops first`;
  if (state === "failed" && step > 0) return `${name}: failed in step ${step} of ${steps}${because}`;
  return `${name}: ${state}${because}`;
}

/** Where a finding is: "line 3, column 17"; empty for the whole action. */
export const placeWords = ({ line, column }) =>
  (line > 0 ? `line ${line}${column > 0 ? `, column ${column}` : ""}` : "");

/** An element with a class and a text. */
function element(tag, className, text) {
  return Object.assign(document.createElement(tag), { className, textContent: text });
}

function listItem(finding) {
  const item = element("li", finding.error ? "error" : "warning", "");
  const place = placeWords(finding), kind = finding.error ? "error" : "warning";
  item.append(element("strong", "", place ? `${place}: ${kind}` : kind), ` ${finding.text}`);
  if (finding.source) item.append(element("code", "", finding.source));
  return item;
}

export class Actions {
  /** @param perform  sends an action  @param stop  ends it  @param notice  shows words  @param mayDrop  is there a walk? */
  constructor({ perform, stop, notice, mayDrop }) {
    Object.assign(this, { perform, stop, notice, mayDrop, goesOn: false, follows: false });
    this.acts = {
      perform: () => (this.goesOn ? this.stop() : this.ask({ action: $("action").value })),
      "own-action": () => $("action-file").click(), "hide-findings": () => this.hide(),
    };
    for (const [id, act] of Object.entries(this.acts)) $(id).addEventListener("click", act);
    $("action-file").addEventListener("change", () => {
      this.take($("action-file").files);
      $("action-file").value = "";  // so that the same file can be chosen again
    });
    this.addDrop();
  }

  addDrop() {
    const shows = (event, on) => {
      if (!event.dataTransfer?.types.includes("Files") || !this.mayDrop()) return false;
      event.preventDefault();
      document.body.classList.toggle("drops", on);
      return true;
    };
    addEventListener("dragover", (event) => shows(event, true));
    addEventListener("dragleave", (event) => { if (!event.relatedTarget) shows(event, false); });
    addEventListener("drop", (event) => { if (shows(event, false)) this.take(event.dataTransfer.files); });
  }

  ask(action) {
    if (action.action === "") return;
    this.follows = true;
    this.perform(action);
  }

  /** A file of the person's own. */
  async take([file]) {
    if (!file) return;
    if (file.size > kMostBytes) return this.notice(`${file.name} has ${file.size} bytes; an action has at most ${kMostBytes}`);
    if (file.size === 0) return this.notice(`${file.name} is empty`);
    const text = await file.text();
    this.ask({ yaml: text, name: file.name.slice(-kLongestName) });
  }

  showScene({ actions = [] }) {
    const last = $("action").value;
    $("action").replaceChildren(...actions.map((name) => new Option(name, name, false, name === last)));
    $("perform").disabled = actions.length === 0;
  }

  /** @param news  as the server tells it. What was over before this page came is not shown. */
  show(news) {
    this.goesOn = ["checking", "running"].includes(news.state);
    this.follows ||= this.goesOn;
    if (!this.follows) return;
    const words = progressWords(news);
    if ($("action-facts").textContent !== words) $("action-facts").textContent = words;
    $("perform").textContent = this.goesOn ? "Stop it" : "Perform";
    $("action-facts").classList.toggle("error", ["refused", "failed"].includes(news.state));
    if (news.state === "checking") this.hide();
    else this.list(news);
  }

  list({ name, state, why, findings }) {
    const key = JSON.stringify([name, findings]);
    if (findings.length === 0 || key === this.listed) return;
    this.listed = key;
    $("findings-title").textContent = state === "refused" ? `${name} is refused: ${why}` : `${name}: warnings`;
    $("finding-list").replaceChildren(...findings.map(listItem));
    $("findings").hidden = false;
  }

  hide() {
    this.listed = "";
    $("findings").hidden = true;
  }
}
