// The page: it shows the state that the program tells of, and tells the program what is wanted.
import { Stage } from "./stage.js";
import { Knobs } from "./knobs.js";
import { show_numbers, show_plan } from "./numbers.js";

const at = (id) => document.getElementById(id);
const page = document.documentElement.dataset;  // for tests: what is shown
let state = { version: 0, scene: 0, details: 0, wanted: 0, render: { picture: 0 } };
const shown = { version: 0, scene: 0, details: 0, picture: 0 };

async function post(path, body = {}) {
  const response = await fetch(path, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });
  const answer = await response.json().catch(() => ({ message: `the program answered ${response.status}` }));
  if (!response.ok) throw new Error([answer.key, answer.message].filter(Boolean).join(": "));
  take(answer);
}

let told = 0;
function tell(text, is_bad = false) {
  at("status").textContent = text;
  at("status").classList.toggle("bad", is_bad);
  told = Date.now() + 4000;
}
const tried = (work) => async (...given) => {
  try {
    await work(...given);
  } catch (error) {
    tell(error.message, true);
  }
};

// Values on their way: one of a key, the newest; sent when the state before is shown, or has taken long.
const waiting = new Map();
let sent_at = 0, timer = 0;
const PATIENCE_MS = 400;
function set(path, value) {
  waiting.set(path, value);
  send();
}
function send() {
  clearTimeout(timer);
  if (waiting.size === 0) return;
  const is_busy = state.tried !== state.wanted && state.version !== state.wanted;
  const rest = sent_at + PATIENCE_MS - performance.now();
  if (is_busy && rest > 0) {
    timer = setTimeout(send, rest);
    return;
  }
  const values = Object.fromEntries(waiting);
  waiting.clear();
  sent_at = performance.now();
  tried(post)("/set", values);
}

const stage = new Stage(at("canvas"));
const keys = (await (await fetch("/keys.json")).json()).keys;
const knobs = new Knobs(at("knobs"), at("help"), at("find"), keys, set);

// --- What is told ----------------------------------------------------------------------------------------------------------

function take(next) {
  if (next.revision < state.revision) return;
  state = next;
  document.title = `${state.changed.length ? "• " : ""}${state.name} – shatterpave`;
  at("name").textContent = state.name;
  if (document.activeElement !== at("seed")) at("seed").value = state.seed;
  at("save").disabled = at("revert").disabled = state.changed.length === 0;
  knobs.mark(state.changed);
  show_error(state.error);
  show_render(state.render);
  const is_busy = state.tried !== state.wanted;
  if (Date.now() > told) {
    const changes = state.changed.length ? `${state.changed.length} changed, not saved` : "as in the file";
    at("status").textContent = state.error ? "the picture is of an earlier state" : is_busy ? "making …" : changes;
    at("status").classList.remove("bad");
  }
  page.changed = state.changed.length;
  load();
  send();
}

function show_error(error) {
  at("error").hidden = !error;
  page.error = error ? `${error.line}:${error.column}` : "";
  if (!error) return;
  const place = [error.file.split("/").pop(), error.line || "", error.line ? error.column : ""].filter(Boolean).join(":");
  at("error-place").textContent = [place, error.key].filter(Boolean).join(" · ");
  at("error-text").textContent = error.message;
}

// One at a time; what has come meanwhile follows.
let is_loading = false;
const load = tried(async () => {
  if (is_loading) return;
  is_loading = true;
  try {
    while (shown.version !== state.version || shown.scene !== state.scene || shown.details !== state.details) {
      const { version, scene, details } = state;
      if (shown.version !== version) {
        const response = await fetch(`/model.glb?${version}`);
        if (response.ok) await stage.show(await response.arrayBuffer());
        shown.version = version;
        page.version = version;
      }
      if (shown.scene !== scene) {
        const { values, idle } = await (await fetch(`/values.json?${scene}`)).json();
        knobs.show(values, idle, state.changed);
        shown.scene = scene;
        page.scene = scene;
      }
      if (shown.details !== details) {
        const statistics = await (await fetch(`/statistics.json?${details}`)).json();
        show_numbers(at("numbers"), statistics);
        show_plan(at("plan"), statistics, details);
        shown.details = details;
        page.details = details;
      }
    }
  } finally {
    is_loading = false;
  }
});

function show_render(render) {
  const is_running = render.state === "running";
  at("progress").hidden = !is_running;
  at("part").value = render.part;
  at("render").disabled = is_running;
  if (render.state === "failed" && shown.failure !== render.message) tell(`the draft failed: ${render.message}`, true);
  shown.failure = render.message;
  if (render.picture === shown.picture) return;
  shown.picture = render.picture;
  const picture = new Image();
  picture.alt = "The draft";
  picture.src = `/render.png?${render.picture}`;
  picture.onload = () => {
    page.picture = render.picture;
    page.pictureSize = `${picture.naturalWidth}x${picture.naturalHeight}`;
  };
  at("draft").replaceChildren(picture);
  at("tab-draft").hidden = false;
  choose("draft");
}

// --- What is asked for -----------------------------------------------------------------------------------------------------

const VIEWS = ["bodies", "plan", "draft"];
function choose(view) {
  for (const name of VIEWS) {
    const tab = at(`tab-${name}`);
    tab.setAttribute("aria-selected", String(name === view));
    tab.tabIndex = name === view ? 0 : -1;
    at(name).hidden = name !== view;
  }
  page.view = view;
}
for (const name of VIEWS) {
  at(`tab-${name}`).addEventListener("click", () => choose(name));
  at(`tab-${name}`).addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.stopPropagation();
    const there = VIEWS.filter((view) => !at(`tab-${view}`).hidden);
    const next = there[(there.indexOf(name) + step + there.length) % there.length];
    choose(next);
    at(`tab-${next}`).focus();
  });
}

const step_seed = tried((by) => post("/seed", { by }));
at("seed-back").addEventListener("click", () => step_seed(-1));
at("seed-on").addEventListener("click", () => step_seed(1));
at("seed").addEventListener("change", () => {
  if (at("seed").value !== "") set("seed", Math.max(0, Math.round(Number(at("seed").value))));
});

at("save").addEventListener("click", tried(async () => {
  await post("/save");
  tell("saved");
}));
at("revert").addEventListener("click", tried(() => {
  waiting.clear();
  return post("/revert");
}));
at("render").addEventListener("click", tried(() => post("/render", render_size())));
at("stop").addEventListener("click", tried(() => post("/render/stop")));
at("copy").addEventListener("click", tried(async () => {
  const response = await fetch("/scene.toml");
  if (!response.ok) throw new Error((await response.json()).message);
  await navigator.clipboard.writeText(await response.text());
  tell("the scene's text is on the clipboard");
}));
// Another size for tests: /?draft=64x48.
function render_size() {
  const [width, height] = (new URLSearchParams(location.search).get("draft") ?? "640x480").split("x").map(Number);
  return { width, height };
}

const TURN = Math.PI / 24;
document.addEventListener("keydown", (event) => {
  if (event.target.closest("input, select, textarea, [role=tab]") || event.ctrlKey || event.metaKey || event.altKey) return;
  const turns = { ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, -TURN], ArrowDown: [0, TURN] };
  if (event.shiftKey && turns[event.key]) stage.turn(...turns[event.key]);
  else if (event.key === "ArrowLeft") step_seed(-1);
  else if (event.key === "ArrowRight") step_seed(1);
  else if (event.key === "+" || event.key === "=") stage.move(0.9);
  else if (event.key === "-") stage.move(1 / 0.9);
  else if (event.key === "0") stage.frame();
  else if (event.key === "/") at("find").focus();
  else return;
  event.preventDefault();
});
document.addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.key !== "s") return;
  event.preventDefault();
  if (!at("save").disabled) at("save").click();
});

const events = new EventSource("/events");
events.onmessage = (event) => take(JSON.parse(event.data));
events.onerror = () => tell("the program does not answer", true);
choose("bodies");
