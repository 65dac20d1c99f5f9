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

/** Of a matrix, the entries that vary, where some do: those that are constant can be asked for. */
function worthSeeing({ kind, components }) {
  const varies = components.map(({ curve }) => lowest(curve).some((x) => x !== lowest(curve)[0]) || highest(curve).some((x) => x !== lowest(curve)[0]));
  return kind === "matrix" && varies.includes(true) ? varies : varies.map(() => true);
}
function layOutCurves() {
  const end = view.times.to[view.times.to.length - 1];
  view.whole = [view.times.from[0], end > view.times.from[0] ? end : view.times.from[0] + 1];
  view.look(...view.whole);
  for (const q of run.quantities) {
    const heading = q.words + (q.of > q.components.length ? ` (${q.components.length} of ${q.of} components)` : "");
    const components = q.components.map(({ label, curve }) => ({ label: componentName(q, label), curve }));
    panels.push(new Panel(view, { heading, unit: q.unit, meaning: q.meaning, components, shown: worthSeeing(q) }));
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
/** One of several, with what is to be done when it is chosen. */
function addChoice(place, { label, title = label, options, chosen = 0, choose }) {
  const choice = element("select");
  choice.setAttribute("aria-label", label);
  choice.title = title;
  for (const name of options) choice.append(element("option", name));
  choice.selectedIndex = chosen;
  choice.addEventListener("change", () => { choose(choice.selectedIndex); changed(); });
  place.append(choice);
}

/** What to ask for where there is nothing to see, or less than there could be. */
function tellWhatIsMissing() {
  const asked = (name) => run.quantities.some((q) => q.name === name);
  if (run.bodies && !asked("position")) return 'Add "position" to the quantities of [output] to see both bodies move.';
  if (run.body && !asked("attitude")) return 'Add "attitude" to the quantities of [output] to see the body turn.';
  const shown = (...ways) => Object.keys(run.scene.shown || {}).filter((name) => ways.includes(run.scene.shown[name]));
  const [planes] = shown("planes"), [frame] = shown("rotation", "motion"), momenta = shown("trajectory", "sphere");
  const add = (name, to) => `Add "${name}" to the quantities of [output] to see ${to}.`;
  if (planes && !asked(planes)) return add(planes, "it go from plane to plane");
  if (frame && !asked(frame)) return add(frame, "the frame move");
  if (!frame && momenta.length && !momenta.some(asked)) return add(momenta[0], "its trajectory");
  if (run.scene.snapshots === false) return "Add snapshots = [] and snapshot_every, the time from one to the next, to [output] to see it move.";
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
/** The stages in use; the others are hidden. */
function useStages(...names) {
  byId("motion").hidden = false;
  for (const name of ["space", "pair", "sphere", "planes", "frame", "trajectory", "map", "medium"]) byId(name).hidden = !names.includes(name);
}
function raise(name, theatre) {
  stages.push(theatre);
  for (const choice of theatre.choices || []) addChoice(byId(name + "-toggles"), choice);
  addToggles(byId(name + "-toggles"), theatre);
}
const canvasOf = (name) => byId(name).querySelector("canvas");
function raiseFrames() {
  const motion = run.motion.columns.t.length > 1 ? new FrameMotion(run) : null;
  if (!motion || !motion.playable) return withoutStages();
  const framed = Boolean(motion.attitudes), moving = motion.trajectories.length > 0;
  useStages(framed && "frame", moving && "trajectory");
  if (framed) raise("frame", new FrameView(canvasOf("frame"), motion, changed));
  if (moving) raise("trajectory", new TrajectoryView(canvasOf("trajectory"), motion, changed));
  const [first] = motion.trajectories;
  if (motion.trajectories.length === 1) byId("trajectory").querySelector("h2").textContent = first.words[0].toUpperCase() + first.words.slice(1);
  byId("trajectory").className += moving && first.labels.length !== 3 ? " flat" : "";
  tellLimits(motion, moving && first.of > first.labels.length && `Of the momentum there are the first ${first.labels.length} of ${first.of} components.`);
  play(motion);
}
function play(motion) {
  player = new Player(motion, run.scene.time_unit, (t) => { view.now = t; changed(); });
  player.motionNow = () => motion.at(player.time);
}
function raisePlanes() {
  const shown = run.scene.shown || {}, momentum = run.times && run.quantities.find((q) => shown[q.name] === "planes" && q.components.length > 0);
  if (!momentum) return raiseFrames();
  if (!(view.whole[1] > view.whole[0]) || run.times.rows < 2) return withoutStages();
  useStages("planes");
  raise("planes", new PlanesView(canvasOf("planes"), momentum, run.times));
  say(momentum.of > momentum.components.length && `The first ${momentum.components.length} of ${momentum.of} components are shown.`);
  play(clockOf(run.times));
}
function raiseMedium() {
  const medium = new Medium(run.medium), { of, cells, of_cells } = run.medium, flat = medium.dimension === 2;
  useStages("medium");
  byId("medium").className += flat ? " flat" : "";
  raise("medium", flat ? new PlaneMediumView(canvasOf("medium"), medium) : new SpaceMediumView(canvasOf("medium"), medium, changed));
  say(
    medium.times.length < of && `${medium.times.length} of ${of} snapshots are shown.`,
    cells < of_cells && `There are ${of_cells} ${flat ? "cells" : "faces"}, and ${cells} larger ones are shown in their place.`,
    !medium.smooth && "The snapshots are too far apart to tell what is between them: it is shown at these alone.",
  );
  play(medium);
}
function raiseMaps() {
  if (run.medium) return raiseMedium();
  if (!run.maps) return raisePlanes();
  const { times, of } = run.maps;
  useStages("map");
  raise("map", new MapView(canvasOf("map"), run.maps, changed));
  say(times.length < of && `${times.length} of ${of} snapshots are shown.`);
  play(clockOf({ from: times, to: times }));
}
function raisePair() {
  const motion = run.motion.columns.t.length > 1 ? new PairMotion(run) : null;
  if (!motion || !motion.playable) return withoutStages();
  useStages("pair");
  const pair = new PairView(canvasOf("pair"), motion, changed);
  raise("pair", pair);
  tellLimits(motion, ...pair.said);
  play(motion);
}
function raiseStages() {
  if (run.bodies) return raisePair();
  if (!run.body) return raiseMaps();
  const motion = run.motion.columns.t.length > 1 ? new Motion(run) : null;
  if (!motion || !motion.playable) return withoutStages();
  const turning = Boolean(motion.attitudes), onSphere = motion.momenta && !run.body.top && !run.body.torqued;
  useStages(turning && "space", onSphere && "sphere");
  if (turning) raise("space", new SpaceView(canvasOf("space"), motion, changed));
  if (onSphere) raise("sphere", new MomentumView(canvasOf("sphere"), motion, changed));
  tellLimits(motion);
  play(motion);
}
/** Of a power of two: 2nd, 4th, 32nd, 512th. */
const ordinal = (n) => n + (n % 10 === 2 && n % 100 !== 12 ? "nd" : "th");
function tellLimits(motion, ...said) {
  if (run.motion.beginning_only) said.push(`The motion is played until t = ${withTime(shownNumber(motion.to))}: it is too fast for more of it to be on this page.`);
  if (run.motion.stride > 1) said.push(`It is played from every ${ordinal(run.motion.stride)} row.`);
  if (!motion.smooth) said.push(`The rows are up to ${Math.round((motion.widest * 180) / Math.PI)}° of turning apart, too far to tell what is between them: it is shown at the rows alone.`);
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
  const rows = Object.entries(error).filter(([n]) => n !== "how").map(([n, v]) => [n.replaceAll("_", " "), typeof v === "number" ? shownNumber(v, 2) + (units[n] || "") : v]);
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

/** A page in a frame rests while the frame is out of sight. */
let inSight = true;
function drawAll(milliseconds) {
  requestAnimationFrame(drawAll);
  if (!inSight) return;
  if (player) player.frame(milliseconds);
  if (dirty) {
    dirty = false;
    const now = player && player.motionNow();
    for (const stage of stages) stage.draw(now);
    for (const panel of panels) panel.draw();
  }
}

/** #t=12.5 stands for a moment, #play for playing from it, #stage for the moving picture alone, again and again. */
function begin() {
  const alone = /[#&]stage/.test(location.hash) && Boolean(document.body);
  if (alone) {
    document.body.classList.add("alone");
    if (typeof IntersectionObserver === "function") new IntersectionObserver(([seen]) => { inSight = seen.isIntersecting; }).observe(document.body);
  }
  tellScene();
  layOutCurves();
  raiseStages();
  tellSummary();
  const asked = /[#&]t=([-+.\deE]+)/.exec(location.hash);
  if (player) {
    player.again = alone;
    player.go(asked ? Number(asked[1]) : player.motion.from);
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!still && (!asked || location.hash.includes("play"))) player.toggle(true);
  }
  addEventListener("resize", changed);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { ink.forget(); changed(); });
  requestAnimationFrame(drawAll);
}
begin();
