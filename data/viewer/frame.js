// A frame that moves: its axes at its place, the way of its origin, and the vectors that it carries.

class FrameView {
  constructor(canvas, motion, changed) {
    this.motion = motion;
    const { flat, places, carried } = motion;
    this.stage = new Stage(canvas, { ...(flat ? { azimuth: 0, elevation: 1.5 } : { azimuth: 0.6, elevation: 0.35 }), nearness: 0.92, changed });
    this.axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].slice(0, flat ? 2 : 3);
    this.shown = { axes: true, body: true, ...(places ? { path: true, "frames on the way": true } : { traces: true }) };
    this.colours = { axes: "plot-1", body: "quiet", path: "text", traces: "plot-2", "frames on the way": "quiet" };
    carried.forEach(({ name }, i) => {
      this.shown[name] = true;
      this.colours[name] = "plot-" + (4 + (i % 3));
    });
    this.prepare();
  }
  /** All that moves has to fit on the stage; a frame that only turns fills it. */
  prepare() {
    const { places, carried, attitudes, flat } = this.motion;
    this.length = places ? 0.34 : 1;
    this.box = places && new Box([...places, ...carried.filter((c) => c.point).flatMap((c) => c.rows)], ["x", "y", flat ? "" : "z"], true);
    if (this.box) this.stage.nearness = this.box.nearness;
    this.path = places && places.map((p) => this.box.place(p));
    this.tips = places ? [] : this.axes.map((axis) => attitudes.map((q) => turned(q, axis)));
    this.longest = carried.map(({ rows }) => rows.reduce((most, v) => Math.max(most, norm(v)), 0) || 1);
    this.block = blockOf([0.3, 0.2, flat ? 0.001 : 0.1].map((x) => x * this.length));
  }
  placed(p) { return this.box ? this.box.place(p) : p; }

  draw(now) {
    if (!this.stage.begin()) return;
    const at = this.placed(now.place);
    if (this.box) this.box.draw(this.stage);
    else this.drawCircles();
    if (this.shown.body) this.drawBody(now.attitude, at);
    if (this.shown.path) this.drawPath(now, at);
    if (this.shown["frames on the way"]) this.drawFramesOnTheWay();
    if (this.shown.traces) this.drawTraces(now);
    if (this.shown.axes) this.drawAxes(now.attitude, at);
    this.drawCarried(now, at);
    this.stage.paint();
  }
  drawBody(q, at) {
    for (const { points, normal, colour } of this.block)
      this.stage.face(points.map((p) => add(at, turned(q, p))), turned(q, normal), mix(ink.rgb("body"), ink.rgb(colour), 0.4));
  }
  drawAxes(q, at) {
    this.axes.forEach((axis, i) => {
      const way = turned(q, axis), colour = "plot-" + (i + 1);
      this.stage.arrow(at, add(at, scale(this.length, way)), colour, 3);
      this.stage.label(add(at, scale(this.length + 0.09, way)), "e" + lowered(i + 1), colour);
    });
  }
  /** The whole of it pale, what has been gone of it strong. */
  drawPath(now, at) {
    this.stage.line(this.path, "text", 1.2, { opacity: () => 0.3 });
    this.stage.line([...this.path.slice(0, now.row + 1), at], "text", 2, { opacity: () => 0.8, lift: 0.01 });
    this.stage.dot(at, 4, "text", 0.04);
  }
  drawFramesOnTheWay() {
    const count = Math.min(16, this.path.length);
    for (let k = 0; k < count; ++k) {
      const row = Math.round((k * (this.path.length - 1)) / Math.max(1, count - 1)), at = this.path[row];
      this.axes.forEach((axis, i) => this.stage.segment(at, add(at, scale(0.4 * this.length, turned(this.motion.attitudes[row], axis))), "plot-" + (i + 1), 1.5, { opacity: () => 0.5 }));
    }
  }
  /** The last of the ways of the tips, paler the longer ago. */
  drawTraces(now) {
    const first = Math.max(0, now.row - 400);
    this.tips.forEach((tip, i) => {
      const points = [...tip.slice(first, now.row + 1), turned(now.attitude, this.axes[i])];
      this.stage.line(points, "plot-" + (i + 1), 1.5, { opacity: (s) => Math.round(20 * (0.06 + 0.7 * s * s)) / 20 });
    });
  }
  /** What does not move: the circle, or the circles, that the tips of the axes are on. */
  drawCircles() {
    const circle = (a, b) => Array.from({ length: 97 }, (_, i) => add(scale(Math.cos((i * Math.PI) / 48), a), scale(Math.sin((i * Math.PI) / 48), b)));
    const [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    for (const [a, b] of this.motion.flat ? [[x, y]] : [[x, y], [y, z], [z, x]]) this.stage.line(circle(a, b), "quiet", 1, { opacity: (_, p) => (dot(p, this.stage.eye) > -0.1 ? 0.4 : 0.15) });
    this.axes.forEach((axis, i) => this.stage.label(scale(1.32, axis), "xyz"[i], "quiet"));
    this.axes.forEach((axis) => this.stage.line([axis, scale(1.24, axis)], "quiet", 1));
  }
  drawCarried(now, at) {
    this.motion.carried.forEach(({ name, point }, i) => {
      if (!this.shown[name]) return;
      const colour = this.colours[name], v = now.carried[i];
      if (point) {
        const there = this.placed(v);
        this.stage.segment(at, there, colour, 1, { dash: [4, 4], opacity: () => 0.7 });
        this.stage.dot(there, 5, colour);
        this.stage.label(add(there, [0, 0.09, 0.09]), name, colour);
        return;
      }
      const arrow = scale((0.85 * this.length) / this.longest[i], v), long = norm(arrow);
      this.stage.arrow(at, add(at, arrow), colour, 4);
      if (long > 0) this.stage.label(add(at, scale(1 + 0.1 / long, arrow)), name, colour);
    });
  }
}

/** The faces of a block about the origin, with these halves of its sides, in the colours of the axes. */
function blockOf(half) {
  const faces = [];
  for (let k = 0; k < 3; ++k)
    for (const side of [-1, 1]) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      const corner = (a, b) => { const p = [0, 0, 0]; p[k] = side * half[k]; p[i] = a * half[i]; p[j] = b * half[j]; return p; };
      const normal = [0, 0, 0];
      normal[k] = side;
      faces.push({ points: [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], normal, colour: "plot-" + (k + 1) });
    }
  return faces;
}
