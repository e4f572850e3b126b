// Knobs, made from the table of keys: those that have an effect on what the scene holds, the rest by search.
const SETTABLE = new Set(["flag", "number", "whole_number", "choice", "point", "place", "pixels", "limits"]);
const WIDTHS = { point: 2, place: 3, pixels: 2, limits: 2 };
const PARTS = { point: ["x", "y"], place: ["x", "y", "z"], pixels: ["width", "height"], limits: ["least", "greatest"] };
// Tables that switch something on by being there.
const SWITCHES = /(^|\.)(shards|steps|crack_sheet|frames|plan|camera|light|laminate|tempering)$/;

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === false || value === undefined) continue;
    if (key in made && typeof value !== "string") made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

function value_at(values, path) {
  let at = values;
  for (const step of path.matchAll(/([^.[\]]+)|\[(\d+)\]/g)) {
    at = at?.[step[1] ?? Number(step[2])];
  }
  return at;
}

// "pane[].growth.apex_deg" for each pane of the scene.
function instances(path, values) {
  let found = [""];
  path.split("[]").forEach((part, i, all) => {
    found = found.flatMap((prefix) => {
      const here = prefix + part;
      if (i === all.length - 1) return [here];
      const list = value_at(values, here);
      return Array.isArray(list) ? list.map((_, k) => `${here}[${k}]`) : [];
    });
  });
  return found;
}

const readable = (name) => name.replace(/_(mm2|mm|deg|us|ms|s|m_s|m|percent|ev|px|mpa|kg_m3|us_m)$/, "").replaceAll("_", " ");

function help_text(key) {
  const parts = [key.sentence.replaceAll("`", "") + "."];
  if (key.low !== undefined && key.type !== "choice" && Math.abs(key.high) < 1e15) {
    parts.push(`From ${key.low} to ${key.high}${key.unit ? ` ${key.unit}` : ""}.`);
  }
  const given = key.default !== null && key.default !== undefined ? JSON.stringify(key.default).replaceAll('"', "") : "";
  const words = key.default_words?.replaceAll("`", "") ?? "";
  if (given || words) parts.push(`Default: ${[given, words].filter(Boolean).join("; ")}.`);
  return parts.join(" ");
}

export class Knobs {
  // `set(path, value)` is called when a knob is turned.
  constructor(place, help, find, keys, set) {
    this.place = place;
    this.help = help;
    this.find = find;
    this.set = set;
    this.keys = keys.filter((key) => SETTABLE.has(key.type));
    this.rows = new Map();
    this.shape = "";
    this.number = 0;
    this.is_held = false;
    place.addEventListener("pointerdown", () => { this.is_held = true; });
    for (const end of ["pointerup", "pointercancel"]) {
      document.addEventListener(end, () => {
        this.is_held = false;
        if (this.values) this.show(this.values, this.idle, this.changed);
      });
    }
    find.addEventListener("input", () => this.build());
    place.addEventListener("focusin", (event) => this.tell(event.target.closest(".knob")));
    place.addEventListener("pointerover", (event) => this.tell(event.target.closest(".knob")));
  }

  tell(row) {
    if (!row) return;
    this.help.replaceChildren(element("code", {}, row.dataset.path), ` ${row.dataset.help}`);
  }

  // What the scene says, which keys have no effect, and which are changed.
  show(values, idle, changed) {
    this.values = values;
    this.idle = new Set(idle);
    this.changed = new Set(changed);
    const shape = JSON.stringify([Object.keys(values), (values.pane ?? []).map((pane) => [pane.name, (pane.impact ?? []).length]),
      (values.pavement ?? []).map((pavement) => pavement.name), [...this.idle]]);
    // Not under the hand that holds a slider.
    if (shape !== this.shape && !this.is_held) {
      this.shape = shape;
      this.build();
    }
    for (const row of this.rows.values()) this.fill(row);
  }

  mark(changed) {
    this.changed = new Set(changed);
    for (const row of this.rows.values()) row.node.classList.toggle("changed", this.changed.has(row.path));
  }

  is_idle(path) {
    for (let at = path; at; at = at.slice(0, Math.max(at.lastIndexOf("."), 0))) {
      if (this.idle.has(at)) return true;
    }
    return false;
  }

  is_switch(path) {
    const table = path.slice(0, Math.max(path.lastIndexOf("."), 0));
    return SWITCHES.test(table) && value_at(this.values, table) === undefined;
  }

  // Of an outline one form is given; what belongs to the others would get in its way.
  is_beside_outline(path) {
    const table = value_at(this.values, path.slice(0, Math.max(path.lastIndexOf("."), 0))) ?? {};
    const name = path.slice(path.lastIndexOf(".") + 1);
    if (name === "size_mm") return "outline_mm" in table || "outline_file" in table;
    return ["outline_units", "outline_width_mm", "holes_width_mm"].includes(name) && !("outline_file" in table);
  }

  build() {
    if (!this.values) return;
    const words = this.find.value.trim().toLowerCase().split(/\s+/).filter(Boolean);
    const open = new Set([...this.place.querySelectorAll("details[open]")].map((part) => part.dataset.table));
    const focus = document.activeElement?.closest?.(".knob")?.dataset.path;
    const is_first = this.rows.size === 0;
    this.rows.clear();
    const groups = new Map();
    for (const key of this.keys) {
      if (key.path === "seed") continue;
      for (const path of instances(key.path, this.values)) {
        if (!this.wanted(key, path, words)) continue;
        const table = path.slice(0, Math.max(path.lastIndexOf("."), 0));
        if (!groups.has(table)) groups.set(table, []);
        groups.get(table).push([key, path]);
      }
    }
    const parts = [];
    let thing = "";
    for (const [table, entries] of this.in_order(groups)) {
      const of = table.match(/^(pane|pavement)\[\d+\]/)?.[0] ?? "scene";
      if (of !== thing) parts.push(element("h2", {}, this.title(of)));
      thing = of;
      const is_open = words.length > 0 || open.has(table) || (is_first && (table === of || this.is_given(table)));
      const name = table === of ? "shape" : table.slice(of === "scene" ? 0 : of.length + 1) || "scene";
      const order = ([, path]) => (value_at(this.values, path) === undefined ? 1 : 0);
      const rows = entries.sort((a, b) => order(a) - order(b)).map(([key, path]) => this.row(key, path));
      parts.push(element("details", { open: is_open, "data-table": table }, element("summary", {}, readable(name)), ...rows));
    }
    if (parts.length === 0) parts.push(element("p", { class: "none" }, "No key is like that."));
    this.place.replaceChildren(...parts);
    for (const row of this.rows.values()) this.fill(row);
    if (focus) this.rows.get(focus)?.inputs[0].focus();
  }

  wanted(key, path, words) {
    if (words.length === 0) {
      return value_at(this.values, path) !== undefined || !(this.is_idle(path) || this.is_switch(path) || this.is_beside_outline(path));
    }
    const text = `${path} ${readable(path)} ${key.sentence}`.toLowerCase();
    return words.every((word) => text.includes(word));
  }

  is_given(table) {
    const value = value_at(this.values, table);
    return typeof value === "object" && value !== null && Object.values(value).some((part) => typeof part !== "object");
  }

  // Things first, then what is of the whole scene.
  in_order(groups) {
    const rank = (table) => (/^pane\[/.test(table) ? 0 : /^pavement\[/.test(table) ? 1 : 2);
    const thing = (table) => table.match(/^\w+\[(\d+)\]/)?.[1] ?? 0;
    return [...groups].sort(([a], [b]) => rank(a) - rank(b) || thing(a) - thing(b));
  }

  title(of) {
    if (of === "scene") return "Scene";
    const name = value_at(this.values, of)?.name ?? of;
    return `${of.startsWith("pane[") ? "Pane" : "Pavement"} ${name}`;
  }

  row(key, path) {
    const id = `knob-${++this.number}`;
    const name = readable(path.slice(path.lastIndexOf(".") + 1));
    const unit = key.unit ? element("span", { class: "unit" }, ` ${key.unit.replace("deg", "°").replace("percent", "%").replaceAll("_", "/")}`) : "";
    const text = help_text(key);
    const help = element("span", { class: "hidden-text", id: `${id}-help` }, text);
    const row = { key, path, inputs: [], node: null };
    const described = { "aria-describedby": `${id}-help` };
    const width = WIDTHS[key.type];
    const controls = [];
    let label = element("label", { for: id }, name, unit);
    if (width) {
      label = element("span", { class: "title", id: `${id}-title` }, name, unit);
      const several = element("span", { class: "several", role: "group", "aria-labelledby": `${id}-title` });
      for (let i = 0; i < width; ++i) {
        const input = element("input", { type: "number", step: key.type === "pixels" ? "1" : "any", "aria-label": `${name} ${PARTS[key.type][i]}`, ...described });
        input.addEventListener("change", () => this.turned_list(row));
        row.inputs.push(input);
        several.append(input);
      }
      controls.push(several);
    } else if (key.type === "flag") {
      const input = element("input", { type: "checkbox", id, ...described });
      input.addEventListener("change", () => this.set(path, input.checked));
      row.inputs.push(input);
      controls.push(input);
    } else if (key.type === "choice") {
      const input = element("select", { id, ...described });
      input.append(...(key.choices ?? []).map((choice) => element("option", { value: choice }, choice.replaceAll("_", " "))));
      input.addEventListener("change", () => input.value && this.set(path, input.value));
      row.inputs.push(input);
      controls.push(input);
    } else {
      const whole = key.type === "whole_number";
      const input = element("input", { type: "number", id, step: whole ? "1" : "any", ...described });
      const slider = element("input", { type: "range", "aria-label": name, ...described });
      input.addEventListener("change", () => input.value !== "" && this.set(path, Number(input.value)));
      slider.addEventListener("input", () => {
        const value = whole ? Math.round(Number(slider.value)) : Number(Number(slider.value).toPrecision(4));
        input.value = value;
        this.set(path, value);
      });
      slider.addEventListener("change", () => this.fill(row));
      row.inputs.push(input, slider);
      controls.push(input, slider);
    }
    row.node = element("div", { class: "knob", "data-path": path, "data-help": text }, label, ...controls, help);
    this.rows.set(path, row);
    return row.node;
  }

  turned_list(row) {
    const values = row.inputs.map((input) => Number(input.value));
    if (row.inputs.every((input) => input.value !== "")) this.set(row.path, values);
  }

  fill(row) {
    const { key, path, inputs, node } = row;
    const given = value_at(this.values, path);
    const value = given ?? key.default;
    node.classList.toggle("changed", this.changed.has(path));
    node.classList.toggle("unset", given === undefined);
    if (key.type === "flag") {
      inputs[0].checked = value === true;
    } else if (key.type === "choice") {
      if (value === null && !inputs[0].querySelector('[value=""]')) {
        inputs[0].prepend(element("option", { value: "" }, key.default_words?.replaceAll("`", "") || "–"));
      }
      inputs[0].value = value ?? "";
    } else if (WIDTHS[key.type]) {
      inputs.forEach((input, i) => {
        if (document.activeElement !== input) input.value = Array.isArray(value) ? value[i] : "";
      });
    } else {
      this.fill_number(key, inputs, typeof value === "number" ? value : null);
    }
  }

  // A slider reaches as far as is of use near the value; the box takes all that the key does.
  fill_number(key, [input, slider], value) {
    if (document.activeElement !== input) input.value = value ?? "";
    input.placeholder = value === null ? (key.default_words?.replaceAll("`", "") ?? "") : "";
    if (document.activeElement === slider && slider.matches(":active")) return;
    const size = Math.max(Math.abs(value ?? 0), Math.abs(key.default ?? 0), key.type === "whole_number" ? 10 : 1e-3);
    const low = Math.max(key.low ?? 0, key.low < 0 ? -3 * size : 0);
    const high = key.high - low > 6 * size ? 3 * size : key.high;
    slider.min = Math.max(low, key.low ?? low);
    slider.max = Math.max(high, low + 1e-6);
    slider.step = key.type === "whole_number" ? 1 : (high - low) / 400;
    slider.value = value ?? low;
  }
}
