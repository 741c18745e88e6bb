// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What breaks: buttons for a lost leg, every kind of fault that the server knows, and the plant.

const $ = (id) => document.getElementById(id);

/** "weak:JOINT:SHARE" as {name, part: "JOINT", values: "SHARE"}; `part` is null where it has none. */
export function fieldsOf(syntax) {
  const [name, ...rest] = syntax.split(":");
  const part = ["LEG", "JOINT"].includes(rest[0]) ? rest.shift() : null;
  return { name, part, values: rest.join(":") };
}

/** The legs that are cut off, by number. @param faults  as texts  @param names  of the legs */
export const cutLegs = (faults, names) =>
  faults.map((text) => /^cut:(.*)$/.exec(text)?.[1]).filter(Boolean).map((name) => names.indexOf(name)).filter((i) => i >= 0);

export class Faults {
  /** @param send  a command  @param onLeg  called with the number of a leg that is chosen here */
  constructor(send, onLeg) {
    Object.assign(this, { send, chosen: 0, legs: [], kinds: [], present: [] });
    this.acts = {
      cut: () => this.lose("cut"), dead: () => this.lose("dead"), break: () => this.break(), mend: () => send({ type: "mend" }),
    };
    for (const [id, act] of Object.entries(this.acts)) $(id).addEventListener("click", act);
    $("fault-kind").addEventListener("change", () => this.showKind());
    $("fault-part").addEventListener("change", () => { if (this.kind?.part === "LEG") onLeg($("fault-part").selectedIndex); });
    $("fault-values").addEventListener("keydown", ({ key }) => { if (key === "Enter") this.break(); });
    $("plant").addEventListener("change", () => send({ type: "plant", plant: $("plant").value }));
  }

  get names() { return this.legs.map(({ name }) => name); }
  lose(how) { if (this.legs.length) this.send({ type: "fault", fault: `${how}:${this.names[this.chosen]}` }); }

  break() {
    if (!this.kind) return;
    const words = [this.kind.name, this.kind.part && $("fault-part").value, this.kind.values && $("fault-values").value.trim()];
    this.send({ type: "fault", fault: words.filter(Boolean).join(":") });
  }

  /** The next plant of the list: of two, the other one. */
  otherPlant() {
    const { options, selectedIndex } = $("plant");
    this.send({ type: "plant", plant: options[(selectedIndex + 1) % options.length].value });
  }

  showScene({ legs, faults = [], plants = [] }) {
    this.legs = legs;
    this.kinds = faults.map(({ syntax, meaning, values: example }) => ({ ...fieldsOf(syntax), meaning, example }));
    const last = $("fault-kind").value;
    $("fault-kind").replaceChildren(...this.kinds.map(({ name, meaning }) => Object.assign(new Option(name, name, false, name === last), { title: meaning })));
    $("plant").replaceChildren(...plants.map(({ name, meaning }) => Object.assign(new Option(name, name), { title: meaning })));
    this.showKind();
    this.choose(Math.min(this.chosen, legs.length - 1));
  }

  showKind() {
    this.kind = this.kinds.find(({ name }) => name === $("fault-kind").value);
    if (!this.kind) return;
    const { part, values, meaning } = this.kind;
    const parts = part === "LEG" ? this.names : part === "JOINT" ? this.legs.flatMap(({ joints }) => joints.map(({ name }) => name)) : [];
    $("fault-part").replaceChildren(...parts.map((name) => new Option(name, name)));
    $("fault-part").hidden = parts.length === 0;
    $("fault-values").hidden = !values;
    $("fault-values").value = this.kind.example;
    $("fault-values").title = values;
    $("fault-values").setAttribute("aria-label", `Of the fault: ${values}`);
    $("fault-meaning").textContent = meaning;
    this.choose(this.chosen);
  }

  /** A leg, as it is chosen in the ring. */
  choose(leg) {
    this.chosen = leg;
    const name = this.names[leg];
    if (!name) return;
    $("cut").textContent = `Cut off ${name}`;
    $("dead").textContent = `${name} dead`;
    if (this.kind?.part === "LEG") $("fault-part").selectedIndex = leg;
    if (this.kind?.part === "JOINT") $("fault-part").value = this.legs[leg].joints[0].name;
  }

  /** @param setup  as the server has told it; null: nothing yet */
  showSetup(setup) {
    const { plant, faults } = setup ?? { plant: "", faults: [] };
    const base = [...$("plant").options].map(({ value }) => value).find((name) => plant === name || plant.startsWith(`${name}+`));
    if (base) $("plant").value = base;
    $("mend").disabled = faults.length === 0;
    $("fault-list").replaceChildren(...faults.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
  }
}
