// The body as it turns, seen from space: its axes, its angular momentum and velocity, and the way of one
// axis.

/** As a lift: nearer to the eye than any body. */
const seenThrough = 10;

class SpaceView {
  constructor(canvas, motion, changed) {
    this.motion = motion;
    this.body = motion.body;
    this.top = this.body.top;
    const up = this.top ? scale(-1, this.top.gravity) : this.spatialMomentum(motion.at(motion.from)) || [0, 0, 1];
    this.stage = new Stage(canvas, { up: norm(up) > 0 ? up : [0, 0, 1], changed, elevation: this.top ? 0.22 : 0.3, nearness: this.top ? 1.25 : 0.94 });
    this.shapes = shapesOf(this.body);
    this.shape = this.shapes[0];
    const moving = Boolean(motion.momenta);
    this.shown = { axes: true, ...(moving ? { momentum: true } : {}), ...(moving && !this.top ? { velocity: true } : {}), trace: true };
    this.colours = { axes: "quiet", momentum: "plot-4", velocity: "plot-5", trace: "plot-2" };
    this.prepare();
  }
  spatialMomentum(now) { return now.momentum && now.attitude && turned(now.attitude, now.momentum); }

  /** Lengths of arrows are shares of the largest; the trace is that of the axis which moves about most visibly. */
  prepare() {
    const { momenta, attitudes } = this.motion;
    const longest = (list) => list.reduce((most, v) => Math.max(most, norm(v)), 0) || 1;
    if (momenta) {
      this.largestMomentum = longest(momenta);
      if (!this.top) this.largestVelocity = longest(momenta.map((m) => this.motion.inertia(m, -1)));
    }
    // The axis whose moment differs most from the others: that of symmetry, where there is one.
    const { moments, axes } = this.body, order = [0, 1, 2].sort((i, j) => moments[i] - moments[j]);
    const [a, b, c] = order.map((i) => moments[i]);
    this.tip = this.top ? this.top.centre_of_mass : axes[order[b - a > c - b ? 0 : 2]];
    this.trace = attitudes.map((q) => scale(this.traceRadius(), unit(turned(q, this.tip))));
    if (!this.top) return;
    // The middle of the picture is half way up the axis, on the mean.
    this.stage.centre = scale(0.5 * (this.trace.reduce((sum, p) => sum + dot(p, this.stage.up), 0) / this.trace.length), this.stage.up);
    const centre = scale(this.shape.size, this.top.centre_of_mass);
    this.axisLength = 0.12 + Math.max(...this.shape.faces.flatMap((face) => face.points.map((p) => norm(add(p, scale(-1, centre))))));
  }
  get choices() {
    return [{ label: "Shape of the body", title: "Its own parts, or a body of the same inertia", options: this.shapes.map((s) => s.name), choose: (i) => this.show(this.shapes[i].name) }];
  }
  traceRadius() { return this.top ? 1.16 : 1.12; }

  show(name) {
    this.shape = this.shapes.find((shape) => shape.name === name);
    this.prepare();
  }

  draw(now) {
    if (!this.stage.begin()) return;
    const q = now.attitude, stage = this.stage, shown = this.shown;
    if (this.top) this.drawGround();
    for (const face of this.shape.faces) {
      const [name, share] = face.colour;
      stage.face(face.points.map((p) => turned(q, p)), turned(q, face.normal), mix(ink.rgb("body"), ink.rgb(name), share));
    }
    if (shown.axes) this.drawAxes(q);
    if (this.top) this.drawPivot(q);
    if (shown.momentum) this.drawMomentum(now);
    if (shown.velocity) this.drawVelocity(now);
    if (shown.trace) this.drawTrace(now);
    stage.paint();
  }
  origin(q) { return this.top ? scale(this.shape.size, turned(q, this.top.centre_of_mass)) : [0, 0, 0]; }

  drawAxes(q) {
    const at = this.origin(q), length = this.top ? this.axisLength : 1.22;
    for (const { axis, name, colour } of namedAxes(this.body)) {
      const way = turned(q, axis);
      this.stage.segment(at, add(at, scale(length, way)), colour, 2);
      this.stage.label(add(at, scale(length + 0.09, way)), name, colour);
    }
  }
  drawMomentum(now) {
    const arrow = scale(1.22 / this.largestMomentum, this.spatialMomentum(now));
    this.stage.arrow([0, 0, 0], arrow, "plot-4", 4);
    this.stage.label(scale(1 + 0.1 / Math.max(norm(arrow), 0.1), arrow), "L", "plot-4");
  }
  drawVelocity(now) {
    const arrow = scale(1.15 / this.largestVelocity, turned(now.attitude, this.motion.inertia(now.momentum, -1)));
    this.stage.arrow([0, 0, 0], arrow, "plot-5", 3);
    this.stage.label(scale(1 + 0.1 / Math.max(norm(arrow), 0.1), arrow), "ω", "plot-5");
  }
  /** The last of the way, paler the longer ago. */
  drawTrace(now) {
    const last = 700, first = Math.max(0, now.row - last);
    const points = this.trace.slice(first, now.row + 1);
    points.push(scale(this.traceRadius(), unit(turned(now.attitude, this.tip))));
    this.stage.line(points, "plot-2", 1.6, { opacity: (s) => Math.round(20 * (0.06 + 0.8 * s * s)) / 20 });
    // A large body would hide the way of a top: it shows through, paler.
    if (this.top) this.stage.line(points, "plot-2", 1.2, { opacity: (s) => Math.round(20 * (0.04 + 0.4 * s * s)) / 20, lift: seenThrough });
    this.stage.dot(points[points.length - 1], 3.4, "plot-2");
  }
  drawGround() {
    const [a, b] = this.stage.frame, ring = (r) => Array.from({ length: 73 }, (_, i) => add(scale(r * Math.cos((i * Math.PI) / 36), a), scale(r * Math.sin((i * Math.PI) / 36), b)));
    for (const r of [0.4, 0.8, 1.2]) this.stage.line(ring(r), "quiet", 1, { opacity: () => 0.35, lift: -0.05 });
    this.stage.segment([0, 0, 0], scale(1.35, this.stage.up), "quiet", 1, { dash: [4, 5] });
  }
  drawPivot(q) {
    this.stage.segment([0, 0, 0], this.origin(q), "text", 3);
    this.stage.segment(this.origin(q), scale(this.traceRadius(), unit(turned(q, this.tip))), "plot-2", 1, { dash: [3, 4] });
    this.stage.dot([0, 0, 0], 5, "text");
    this.stage.dot(this.origin(q), 4, "plot-2");
    // The fixed point and the rod to the centre of mass show through the body.
    this.stage.line([[0, 0, 0], this.origin(q)], "text", 2, { opacity: () => 0.55, lift: seenThrough, dash: [5, 4] });
    this.stage.dot([0, 0, 0], 3.5, "text", seenThrough);
    this.stage.dot(this.origin(q), 3, "plot-2", seenThrough);
  }
}
