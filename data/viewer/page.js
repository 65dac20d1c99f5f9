// The page itself: what was run, the stages, the curves and the summary, and one clock for all of them.

const run = JSON.parse(document.getElementById("run").textContent);
const byId = (id) => document.getElementById(id);
function element(name, text, ...children) {
  const out = document.createElement(name);
  if (text !== null && text !== undefined) out.textContent = text;
  out.append(...children);
  return out;
}
const withTime = (text) => text + (run.scene.time_unit ? " " + run.scene.time_unit : "");

/** One drawing for all that changed since the last frame. */
const stages = [], panels = [];
let player = null, dirty = true;
const changed = () => { dirty = true; };

function tellScene() {
  const { scene } = run, order = scene.order && (scene.order === "exact" ? "exact" : "order " + scene.order);
  byId("title").textContent = scene.title;
  byId("subtitle").textContent = [scene.system, scene.method, order, scene.step && "step " + withTime(shownNumber(scene.step)), "until " + withTime(shownNumber(scene.until, 8)), run.times && run.times.rows + " rows"]
    .filter(Boolean).join(" · ");
  byId("subtitle").title = scene.meaning;
}

const view = {
  times: run.times || { from: [0], to: [0] },
  pointer: null, drag: null, now: null, changed,
  look(from, to) {
    Object.assign(this, { from, to });
    byId("whole").hidden = from === this.whole[0] && to === this.whole[1];
    changed();
  },
  go(t) { if (player) player.go(t); else { this.now = t; changed(); } },
  /** The first and the last piece that are seen, and one on either side. */
  indices() {
    const last = this.times.from.length - 1;
    return [Math.max(0, bracket(this.times.from, this.from)[0] - 1), Math.min(last, bracket(this.times.from, this.to)[0] + 2)];
  },
};

function layOutCurves() {
  const end = view.times.to[view.times.to.length - 1];
  view.whole = [view.times.from[0], end > view.times.from[0] ? end : view.times.from[0] + 1];
  view.look(...view.whole);
  for (const q of run.quantities) {
    const heading = q.words + (q.of > q.components.length ? ` (${q.components.length} of ${q.of} components)` : "");
    panels.push(new Panel(view, { heading, unit: q.unit, meaning: q.meaning, components: q.components }));
  }
  if (run.drifts.length) panels.push(new Panel(view, { heading: "relative drift", meaning: "|Q(t) − Q(0)| in the unit that the summary names", components: run.drifts, log: true }));
  if (run.scene.time_unit) byId("over-time").textContent = `Curves over time, ${run.scene.time_unit}`;
  byId("curves").append(...panels.map((panel) => panel.element));
  byId("whole").addEventListener("click", () => view.look(...view.whole));
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") view.look(...view.whole); });
  if (run.times && run.times.rows_per_piece > 1) {
    byId("curves-note").hidden = false;
    byId("curves-note").textContent = `Each curve is the band from the lowest to the highest of ${run.times.rows_per_piece} rows at a time; all ${run.times.rows} rows are in the series of the run.`;
  }
}

/** Buttons that show and hide what is on a stage. */
function addToggles(place, theatre) {
  for (const name of Object.keys(theatre.shown)) {
    const key = element("span");
    key.className = "key";
    key.style.color = `var(--${theatre.colours[name]})`;
    const button = element("button", null, key, name);
    button.type = "button";
    button.setAttribute("aria-pressed", String(theatre.shown[name]));
    button.addEventListener("click", () => {
      theatre.shown[name] = !theatre.shown[name];
      button.setAttribute("aria-pressed", String(theatre.shown[name]));
      changed();
    });
    place.append(button);
  }
}
function addShapes(place, space) {
  const choice = element("select");
  choice.setAttribute("aria-label", "Shape of the body");
  choice.title = "Its own parts, or a body of the same inertia";
  for (const { name } of space.shapes) choice.append(element("option", name));
  choice.addEventListener("change", () => { space.show(space.shapes[choice.selectedIndex].name); changed(); });
  place.append(choice);
}

/** What to ask for where there is nothing to see, or less than there could be. */
function tellWhatIsMissing() {
  const asked = (name) => run.quantities.some((q) => q.name === name);
  if (run.body && !asked("attitude")) return 'Add "attitude" to the quantities of [output] to see the body turn.';
  const planes = run.scene.planes;
  if (planes && !asked(planes)) return `Add "${planes}" to the quantities of [output] to see it go from plane to plane.`;
  return "";
}
function say(...texts) {
  const said = texts.filter(Boolean).join(" ");
  byId("motion-note").hidden = said === "";
  byId("motion-note").textContent = said;
}
/** Stages that there is nothing for are left out. */
function withoutStages() {
  const missing = tellWhatIsMissing();
  byId("motion").hidden = missing === "";
  for (const id of ["stages", "transport"]) byId(id).hidden = true;
  say(missing);
}
function raisePlanes() {
  const momentum = run.scene.planes && run.times && run.quantities.find((q) => q.name === run.scene.planes && q.components.length > 0);
  if (!momentum || !(view.whole[1] > view.whole[0]) || run.times.rows < 2) return withoutStages();
  byId("motion").hidden = false;
  for (const id of ["space", "sphere"]) byId(id).hidden = true;
  byId("planes").hidden = false;
  const planes = new PlanesView(byId("planes").querySelector("canvas"), momentum, run.times);
  stages.push(planes);
  addToggles(byId("planes-toggles"), planes);
  say(momentum.of > momentum.components.length && `The first ${momentum.components.length} of ${momentum.of} components are shown.`);
  const clock = clockOf(run.times);
  player = new Player(clock, run.scene.time_unit, (t) => { view.now = t; changed(); });
  player.motionNow = () => clock.at(player.time);
}
function raiseStages() {
  if (!run.body) return raisePlanes();
  const motion = run.motion.columns.t.length > 1 ? new Motion(run) : null;
  if (!motion || !motion.playable) return withoutStages();
  byId("motion").hidden = false;
  if (motion.attitudes) {
    const space = new SpaceView(byId("space").querySelector("canvas"), motion, changed);
    stages.push(space);
    addShapes(byId("space-toggles"), space);
    addToggles(byId("space-toggles"), space);
  } else byId("space").hidden = true;
  if (motion.momenta && !run.body.top && !run.body.torqued) {
    const sphere = new MomentumView(byId("sphere").querySelector("canvas"), motion, changed);
    stages.push(sphere);
    addToggles(byId("sphere-toggles"), sphere);
  } else byId("sphere").hidden = true;
  tellLimits(motion);
  player = new Player(motion, run.scene.time_unit, (t) => { view.now = t; changed(); });
  player.motionNow = () => motion.at(player.time);
}
function tellLimits(motion) {
  const said = [];
  if (run.motion.beginning_only) said.push(`The motion is played until t = ${withTime(shownNumber(motion.to))}: the body turns too fast for more of it to be on this page.`);
  if (run.motion.stride > 1) said.push(`It is played from every ${run.motion.stride}th row.`);
  if (!motion.smooth) said.push(`The rows are up to ${Math.round((motion.widest * 180) / Math.PI)}° of turning apart, too far to tell what is between them: the body is shown at the rows alone.`);
  say(...said, tellWhatIsMissing());
}

function card(title, rows) {
  const out = element("div", null, element("h3", title));
  out.className = "card";
  const table = element("table");
  for (const [name, value] of rows) table.append(element("tr", null, element("th", name), element("td", value)));
  out.append(table);
  return out;
}
/** How far the run may be from the true motion, beside how far it is from what it should conserve. */
function tellError(error) {
  const exact = /^exact\b/.test(error.how || ""), units = { attitude: " rad" };
  const rows = Object.entries(error).filter(([, v]) => typeof v === "number").map(([n, v]) => [n.replaceAll("_", " "), shownNumber(v, 2) + (units[n] || "")]);
  if (!rows.length && !error.how) return;
  const out = card(exact ? "Error: exact to rounding" : rows.length ? "Error, estimated" : "Error", rows);
  if (error.how) out.append(element("p", error.how));
  byId("summary").append(out);
}
function tellSummary() {
  const s = run.summary;
  if (!s) return;
  const took = [["status", s.status], ["steps", s.steps], ["rows", s.rows], ["wall time", s.wall_seconds !== undefined ? shownNumber(s.wall_seconds, 3) + " s" : null]];
  byId("summary").append(card("Run", took.filter(([, value]) => value !== null && value !== undefined).map(([n, v]) => [n, String(v)])));
  const drift = Object.entries(s.drift || {});
  if (drift.length) byId("summary").append(card("Largest relative drift", drift.map(([n, v]) => [n.replaceAll("_", " "), shownNumber(v, 3)])));
  if (s.error) tellError(s.error);
  const evaluated = Object.entries(s.evaluations || {}).map(([n, v]) => [n.replaceAll("_", " "), v ? String(v) : "skipped"]);
  if (evaluated.length) byId("summary").append(card("Evaluations", evaluated));
  const said = [s.message, ...(s.shortcuts || []), ...(s.remarks || [])].filter(Boolean);
  if (said.length) {
    const remarks = card("Remarks", []);
    remarks.append(...said.map((text) => element("p", text)));
    byId("summary").append(remarks);
  }
}

function drawAll(milliseconds) {
  if (player) player.frame(milliseconds);
  if (dirty) {
    dirty = false;
    const now = player && player.motionNow();
    for (const stage of stages) stage.draw(now);
    for (const panel of panels) panel.draw();
  }
  requestAnimationFrame(drawAll);
}

/** #t=12.5 stands for a moment, #play for playing from it. */
function begin() {
  tellScene();
  layOutCurves();
  raiseStages();
  tellSummary();
  const asked = /[#&]t=([-+.\deE]+)/.exec(location.hash);
  if (player) {
    player.go(asked ? Number(asked[1]) : player.motion.from);
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!still && (!asked || location.hash.includes("play"))) player.toggle(true);
  }
  addEventListener("resize", changed);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { ink.forget(); changed(); });
  requestAnimationFrame(drawAll);
}
begin();
