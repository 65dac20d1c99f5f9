// viewer_check.mjs PAGE: runs the script of a page on a stand-in for a browser, and holds it to some laws.
// Prints what it measured; status 1 where a law is broken.
//
// The stand-in takes every call and answers with more of itself, but it looks at the numbers that are drawn:
// each of them is finite.
import fs from 'node:fs';
import vm from 'node:vm';

const page = fs.readFileSync(process.argv[2], 'utf8');
const fail = (what) => { console.error(what); process.exit(1); };
const one = (pattern, what) => {
  const found = [...page.matchAll(pattern)];
  if (found.length !== 1) fail(`${what}: ${found.length} where one is expected`);
  return found[0][1];
};
const json = one(/<script type="application\/json" id="run">([\s\S]*?)<\/script>/g, 'data');
const script = one(/<script>([\s\S]*?)<\/script>/g, 'script');
const run = JSON.parse(json);

let drawn = 0;
const frames = [], listeners = {};
const look = (values, what) => {
  for (const x of values)
    if (typeof x === 'number') {
      ++drawn;
      if (!Number.isFinite(x)) fail(`${what}: drawn with ${x}`);
    }
};
function standIn(known = {}) {
  const target = function () {};
  return new Proxy(Object.assign(target, known), {
    get: (of, key) => (key in of && key !== 'name' && key !== 'length' ? of[key] : key === Symbol.toPrimitive ? () => 0 : key === Symbol.iterator ? undefined : (of[key] = standIn())),
    set: (of, key, value) => { Object.defineProperty(of, key, { value, writable: true, configurable: true }); return true; },
    apply: () => standIn(),
  });
}
function pen() {
  const calls = {};
  for (const name of ['moveTo', 'lineTo', 'arc', 'rect', 'fillRect', 'fillText', 'strokeText', 'createRadialGradient'])
    calls[name] = (...values) => { look(values, name); return { addColorStop() {} }; };
  calls.measureText = (text) => ({ width: 6 * text.length });
  calls.setLineDash = () => {};
  return standIn(calls);
}
function element() {
  const own = { clientWidth: 640, clientHeight: 400, hidden: false, textContent: '', value: '0', children: [], listeners: {} };
  return standIn({
    ...own, append() {}, setAttribute() {}, setPointerCapture() {}, getContext: ((one) => () => one)(pen()), querySelector: () => element(),
    getBoundingClientRect: () => ({ left: 0, top: 0 }), addEventListener(type, does) { (listeners[type] ??= []).push(does); },
  });
}
const byId = new Map();
const sandbox = {
  document: { getElementById: (id) => byId.get(id) ?? byId.set(id, id === 'run' ? { textContent: json } : element()).get(id), createElement: element, documentElement: element(), addEventListener: (type, does) => (listeners[type] ??= []).push(does) },
  window: { devicePixelRatio: 2 }, location: { hash: process.argv[3] ?? '' }, getComputedStyle: () => ({ getPropertyValue: () => ' #4080c0' }),
  matchMedia: () => ({ matches: false, addEventListener() {} }), addEventListener() {}, requestAnimationFrame: (frame) => frames.push(frame), console, Math, JSON, atob,
};
vm.createContext(sandbox);
vm.runInContext(script + '\n;globalThis.made = { panels, stages, player, view, run, missing: tellWhatIsMissing(), tellError };', sandbox);

const { panels, stages, player } = sandbox.made;
const frame = (milliseconds) => frames.pop()(milliseconds);
frame(0);
if (player) {
  const { motion } = player;
  player.toggle(true);
  for (let k = 1; k <= 30; ++k) frame(1000 + 50 * k);
  if (!(player.time > motion.from)) fail('the clock stands still while it plays');
  player.go(Infinity);
  if (player.time !== motion.to) fail('the clock goes past the end');
  if (sandbox.made.missing && !stages.length) fail('there is a clock, and nothing to see');
  // At a row the attitude is that of the row; between two rows it is of unit length.
  for (let i = 0; motion.attitudes && i < motion.times.length; i += 1 + (motion.times.length >> 6)) {
    const q = motion.at(motion.times[i]).attitude;
    if (!(Math.abs(q.reduce((sum, x, k) => sum + x * motion.attitudes[i][k], 0)) > 1 - 1e-5)) fail(`row ${i}: the attitude is ${q}, in the run it is ${motion.attitudes[i]}`);
    const between = motion.at(motion.times[i] + 0.37 * ((motion.times[i + 1] ?? motion.to) - motion.times[i])).attitude;
    if (!(Math.abs(Math.hypot(...between) - 1) < 1e-12)) fail(`after row ${i}: the attitude has length ${Math.hypot(...between)}`);
  }
}
// A frame at a row is that of the matrix of the run, and what it carries stands still in space, or in the
// frame.
function holdFrame(motion) {
  const { columns } = run.motion, { flat, onLeft } = motion, n = flat ? 2 : 3;
  const name = Object.keys(run.scene.shown).find((q) => ['rotation', 'motion'].includes(run.scene.shown[q])), moves = run.scene.shown[name] === 'motion';
  // Six digits of the largest are on the page.
  const near = (a, b, what, size = 1) => { if (!(Math.abs(a - b) <= 2e-5 * (1 + size))) fail(`${what}: ${a} instead of ${b}`); };
  const R = (i, j, row) => columns[`${name}_${i + 1}${j + 1}`][row];
  // Of R^T the rows are the columns of R: the vector as the frame sees it.
  const inFrame = (v, row) => [...Array(n).keys()].map((i) => [...Array(n).keys()].reduce((sum, j) => sum + R(j, i, row) * v[j], 0));
  for (let row = 0; row < motion.times.length; row += 1 + (motion.times.length >> 5)) {
    const { attitude, place, carried } = motion.at(motion.times[row]);
    for (let j = 0; j < n; ++j) vm.runInContext('turned', sandbox)(attitude, [0, 1, 2].map((i) => Number(i === j))).slice(0, n).forEach((x, i) => near(x, R(i, j, row), `row ${row}: entry ${i + 1}, ${j + 1}`));
    for (let i = 0; i < n; ++i) near(place[i], moves ? R(i, n, row) : 0, `row ${row}: component ${i + 1} of the place`, Math.hypot(...place));
    const first = motion.at(motion.times[0]);
    carried.forEach((v, k) => {
      const { point, name } = motion.carried[k];
      const still = ({ carried, place }, at) => (onLeft ? carried[k].slice(0, n) : inFrame(carried[k].map((x, i) => x - (point ? place[i] : 0)), at));
      still({ carried, place }, row).forEach((x, i) => near(x, still(first, 0)[i], `row ${row}: component ${i + 1} of ${name}`, Math.hypot(...place, ...v)));
    });
  }
}
if (player?.motion.attitudes && !run.body) holdFrame(player.motion);
// Momenta at a row are those of the run.
for (const [k, { name, rows }] of (player?.motion.trajectories ?? []).entries())
  for (const row of [0, rows.length >> 1, rows.length - 1]) {
    const ends = run.quantities.find((q) => q.name === name).components.map((c) => c.label);
    player.motion.at(player.motion.times[row]).momenta[k].forEach((x, i) => { if (Math.abs(x - run.motion.columns[`${name}_${ends[i]}`][row]) > 1e-12 * Math.abs(x)) fail(`row ${row}: ${name} is ${x}`); });
  }
// A surface is closed: its vector areas have the sum zero. The places of a medium stay in their box, and
// faces in the plane that are its cells are as many times larger than at the start as their colours say, as
// far as both are resolved: places in 65535 steps of the box, colours in 255.
function holdMedium(medium) {
  const jacobian = medium.fields.find(({ name }) => name === 'jacobian'), first = medium.at(medium.from), steps = medium.upper.map((x, a) => (x - medium.lower[a]) / 65535);
  const area = (places, f) => {
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => medium.corner(places, f, k));
    return 0.5 * ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]));
  };
  const J = (i, f) => jacobian.low + ((jacobian.high - jacobian.low) * jacobian.values[i * medium.count + f]) / 255;
  medium.times.forEach((t, i) => {
    const { places } = medium.at(t);
    places.forEach((x, k) => { const a = k % medium.dimension; if (!(x >= medium.lower[a] - steps[a] && x <= medium.upper[a] + steps[a])) fail(`t = ${t}: a place outside the box`); });
    if (run.medium.cells !== run.medium.of_cells) return;
    const sum = [0, 0, 0];
    let whole = 0;
    for (let f = 0; medium.dimension === 3 && f < medium.count; ++f) {
      const [a, b, c, d] = [0, 1, 2, 3].map((k) => medium.corner(places, f, k)), [u, v] = [c.map((x, i) => x - a[i]), d.map((x, i) => x - b[i])];
      const normal = [0, 1, 2].map((i) => u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
      normal.forEach((x, i) => { sum[i] += x; });
      whole += Math.hypot(...normal);
    }
    if (!(Math.hypot(...sum) <= 1e-12 * whole)) fail(`t = ${t}: the surface is open: ${sum} of ${whole}`);
    for (let f = 0; medium.dimension === 2 && f < medium.count; ++f) {
      const then = area(first.places, f), now = area(places, f), round = Math.sqrt(Math.max(then, now)) * 4 * Math.max(...steps), least = Math.min(then, now);
      if (!(then > 0)) fail(`face ${f} has the area ${then}`);
      const bound = (now / then) * (2 * round / least + (jacobian.high - jacobian.low) / 255 / J(0, f)) + (jacobian.high - jacobian.low) / 255 / J(0, f) + 1e-12;
      if (!(Math.abs(now / then - J(i, f) / J(0, f)) <= bound)) fail(`t = ${t}: face ${f} is ${now / then} times as large, and its colour says ${J(i, f) / J(0, f)}`);
    }
  });
}
if (stages[0]?.medium) holdMedium(stages[0].medium);
// The barycentre of two bodies is at rest in space, and the distance of their centres is that of the run; in the frame
// of the first body the position is that of the run, turned back by its attitude.
function holdPair(view) {
  const { motion, unit, bodies } = view, [turned, inverse] = ['turned', 'inverse'].map((name) => vm.runInContext(name, sandbox));
  const near = (a, b, what) => { if (!(Math.abs(a - b) <= 1e-5)) fail(`${what}: ${a} instead of ${b}`); };
  for (let row = 0; row < motion.times.length; row += 1 + (motion.times.length >> 5)) {
    const now = motion.at(motion.times[row]), X = ['x', 'y', 'z'].map((end) => unit * run.motion.columns[`position_${end}`][row]);
    const [a, b] = [0, 1].map((k) => view.centre(k, now)), expected = view.ofFirst ? turned(inverse(motion.turns_of[0][row]), X) : X;
    expected.forEach((x, i) => near(b[i] - a[i], x, `row ${row}: component ${i + 1} of the position`));
    a.forEach((x, i) => near(view.ofFirst ? x : (bodies[0].mass * x + bodies[1].mass * b[i]) / (bodies[0].mass + bodies[1].mass), 0, `row ${row}: component ${i + 1} of what is at rest`));
  }
}
if (stages[0]?.constructor.name === 'PairView') for (let i = stages[0].frames.length; i-- > 0;) stages[0].inFrame(i), holdPair(stages[0]);
// Every choice beside a picture.
for (const stage of stages)
  for (const [k, { options }] of (stage.choices ?? []).entries())
    for (let i = options.length; i-- > 0;) {
      stage.choices[k].choose(i);
      sandbox.made.view.changed();
      frame(2600);
    }
// Looking at a tenth of the run, with a component hidden, and at a shape that is not the first.
sandbox.made.view.look(sandbox.made.view.whole[0], sandbox.made.view.whole[0] + 0.1 * (sandbox.made.view.whole[1] - sandbox.made.view.whole[0]));
if (panels[0]) panels[0].shown[0] = false;
for (const stage of stages) if (stage.shapes) stage.show(stage.shapes.at(-1).name);
frame(4000);
if (panels.length !== run.quantities.length + (run.drifts.length > 0)) fail('a panel for each quantity is expected');
if (!(drawn > 100)) fail(`only ${drawn} numbers were drawn`);
// What the panel says of the error: its card is made once more, and listened to.
let error = '';
if (run.summary?.error) {
  vm.runInContext(`globalThis.shown = []; { const own = card; globalThis.told = ((title, rows) => { shown.push(title, ...rows.map(([n, v]) => n + ' ' + v)); return own(title, rows); }); }`, sandbox);
  vm.runInContext(`(${String(sandbox.made.tellError).replace(/\bcard\(/g, 'told(')})(run.summary.error)`, sandbox);
  error = sandbox.shown.join(' | ');
}
const largest = Object.fromEntries(run.drifts.map(({ label, curve }) => [label, Math.max(0, ...curve.value)]));
console.log(JSON.stringify({ title: run.scene.title, subject: page.match(/<title>([\s\S]*?)<\/title>/)[1], drawn, stages: stages.length, views: stages.map((s) => s.constructor.name + (s.all ? (s.box ? ' in a box' : s.solid ? ' on a sphere' : ' of pairs') : '')).join(', '), rows: run.times.rows, perPiece: run.times.rows_per_piece, played: run.motion.columns.t.length, asks: sandbox.made.missing ? 1 : 0, faces: stages[0]?.medium?.count ?? 0, fields: (stages[0]?.medium?.fields ?? []).map(({ name, low, high }) => `${name} ${low} ${high}`).join(', '), error, largest }));
