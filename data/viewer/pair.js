// Two bodies that attract each other, with their orbits about the barycentre; in space, or in the frame of the
// first.

/** The motion of a pair, at any time: between two rows the position turns and the attitudes turn evenly. */
class PairMotion extends Motion {
  read(run) {
    this.bodies = run.bodies;
    const mass = this.bodies[0].mass + this.bodies[1].mass;
    /** Of the position, what the centre of each body is at from the barycentre. */
    this.shares = [-this.bodies[1].mass / mass, this.bodies[0].mass / mass];
    this.positions = this.rows("position", ["x", "y", "z"]);
    // The rate of playing, and whether one may interpolate, is that of the orbit.
    this.momenta = this.positions;
    this.turns_of = [1, 2].map((i) => this.rows(`attitude_${i}`, ["w", "x", "y", "z"]));
    this.widest_of = this.turns_of.map((rows) => rows && rows.reduce((most, q, i) => Math.max(most, i > 0 ? angleBetween(rows[i - 1], q) : 0), 0));
    this.even = this.widest_of.map((angle) => angle !== null && angle < Math.PI / 2);
  }
  get playable() { return this.times.length > 1 && Boolean(this.positions); }
  state(between) {
    const nearest = (p, q, s) => (s < 0.5 ? p : q);
    return { position: super.state(between).momentum, turns: this.turns_of.map((rows, k) => between(rows, this.even[k] ? slerp : nearest)) };
  }
  /** Rows, and times between them that are near enough for curves. */
  get fine() {
    const angle = this.even[0] ? Math.max(this.widest, this.widest_of[0]) : this.widest, pieces = Math.max(1, Math.min(12, Math.ceil(angle / 0.1), Math.floor(8000 / this.times.length)));
    return this.times.flatMap((t, i) => Array.from({ length: i + 1 < this.times.length ? pieces : 1 }, (_, k) => t + (k / pieces) * ((this.times[i + 1] ?? t) - t)));
  }
}

class PairView {
  constructor(canvas, motion, changed) {
    Object.assign(this, { motion, bodies: motion.bodies, changed });
    this.stage = new Stage(canvas, { azimuth: 0.6, elevation: 0.55, nearness: 1, changed });
    this.shown = { orbits: true, axes: true, line: true };
    this.colours = { orbits: "plot-4", axes: "quiet", line: "quiet" };
    this.times = motion.fine;
    const largest = motion.positions.reduce((most, x) => Math.max(most, norm(x)), 0);
    this.unit = 1 / largest;
    // A body that would be too small to be seen is drawn larger.
    const least = 0.03;
    this.sizes = this.bodies.map((body) => Math.max(this.unit, least / body.radius));
    this.shapes_of = this.bodies.map((body, k) => this.shapeOf(body, k));
    this.inFrame(0);
  }
  /** The body itself, or a ball where its attitude is not known. */
  shapeOf(body, k) {
    const known = this.motion.turns_of[k], semi = halfSizes(body, 5), mean = Math.cbrt(semi[0] * semi[1] * semi[2]);
    const colour = (i, j) => [`plot-${k + 1}`, known && (Math.floor(i / 3) + Math.floor(j / 4)) % 2 ? 0.12 : 0.42];
    return rounded((known ? semi : [mean, mean, mean]).map((a) => a * this.sizes[k]), body.axes, [0, 0, 0], colour);
  }
  get frames() { return ["in space", ...(this.motion.turns_of[0] ? ["frame of the primary"] : [])]; }
  get choices() { return [{ label: "Frame", title: "Axes of space about the barycentre, or those of the first body about its centre", options: this.frames, choose: (i) => this.inFrame(i) }]; }

  inFrame(i) {
    this.ofFirst = i === 1;
    const { motion, times } = this, [first] = motion.positions, now = times.map((t) => motion.at(t));
    // Above is the normal of the orbit, or the axis about which the first body turns most.
    const normal = motion.positions.map((x) => cross(first, x)).reduce((most, n) => (norm(n) > norm(most) ? n : most), [0, 0, 0]);
    const { moments, axes } = this.bodies[0], axis = axes[moments.indexOf(Math.max(...moments))];
    this.stage.up = unit(this.ofFirst ? axis : norm(normal) > 0 ? normal : [0, 0, 1]);
    this.stage.frame = frameAbout(this.stage.up);
    this.ways = [0, 1].map((k) => now.map((state) => this.centre(k, state)));
    const reach = [0, 1].flatMap((k) => this.ways[k].map((p) => norm(p) + this.sizes[k] * this.bodies[k].radius));
    // An orbit is wider than high, as it is seen.
    const { clientWidth, clientHeight } = this.stage.canvas, wide = Math.min(1.5, Math.max(1, clientWidth / clientHeight)) || 1;
    this.stage.nearness = (1.25 * wide) / reach.reduce((most, x) => Math.max(most, x), 0);
    // Where the first body turns too far from row to row there is no curve in its frame, but its points.
    this.dotted = this.ofFirst && !motion.even[0];
    this.changed();
  }
  /** What turns a vector of space to the frame that is shown. */
  turning(now) { return this.ofFirst ? inverse(now.turns[0]) : [1, 0, 0, 0]; }
  centre(k, now) {
    const share = this.ofFirst ? k : this.motion.shares[k];
    return scale(share * this.unit, turned(this.turning(now), now.position));
  }

  draw(now) {
    if (!this.stage.begin()) return;
    if (this.shown.orbits) this.drawOrbits(now);
    const q = this.turning(now), at = [0, 1].map((k) => this.centre(k, now));
    if (this.shown.line) this.stage.segment(...at, "quiet", 1, { dash: [4, 5], opacity: () => 0.7 });
    for (const k of [0, 1]) this.drawBody(k, at[k], q, now.turns[k] || [1, 0, 0, 0]);
    if (!this.ofFirst) this.stage.dot([0, 0, 0], 2.5, "text", seenThrough);
    this.stage.paint();
  }
  drawBody(k, at, frame, attitude) {
    const body = this.bodies[k], into = (v) => turned(frame, turned(attitude, v)), reach = this.sizes[k] * body.radius;
    for (const { points, normal, colour: [name, share] } of this.shapes_of[k])
      this.stage.face(points.map((p) => add(at, into(p))), into(normal), mix(ink.rgb("body"), ink.rgb(name), share));
    if (this.shown.axes && this.motion.turns_of[k])
      for (const { axis, colour } of namedAxes(body)) this.stage.segment(at, add(at, scale(1.4 * reach, into(axis))), colour, 1.6);
    this.stage.label(add(at, scale(reach + 0.1 / this.stage.nearness, this.stage.up)), ["1", "2"][k], `plot-${k + 1}`, seenThrough);
  }
  /** The last of the ways, paler the longer ago. */
  drawOrbits(now) {
    const end = bracket(this.times, now.t)[0] + 1, most = 700, colours = ["plot-1", "plot-2"];
    for (const k of this.ofFirst ? [1] : [0, 1]) {
      const points = this.ways[k].slice(Math.max(0, end - most), end);
      if (this.dotted) points.slice(-150).forEach((p) => this.stage.dot(p, 1.6, colours[k], 0));
      else this.stage.line([...points, this.centre(k, now)], colours[k], 1.6, { opacity: (s) => Math.round(20 * (0.1 + 0.8 * s * s)) / 20 });
    }
  }
  /** What is not to scale, or not to be seen, in words. */
  get said() {
    const { turns_of, even } = this.motion, name = ["first", "second"], both = [0, 1];
    // A ball looks like one.
    const unknown = both.filter((k) => !turns_of[k] && this.bodies[k].moments.some((m) => m < (1 - 1e-9) * Math.max(...this.bodies[k].moments)));
    return [
      ...both.map((k) => this.sizes[k] > this.unit && `The ${name[k]} body is drawn ${shownNumber(this.sizes[k] / this.unit, 2)} times as large as it is.`),
      unknown.length > 0 && `Add ${unknown.map((k) => `"attitude_${k + 1}"`).join(" and ")} to the quantities of [output] to see the ${unknown.map((k) => name[k]).join(" and the ")} body turn, drawn as a ball here.`,
      ...both.map((k) => turns_of[k] && !even[k] && `The ${name[k]} body turns by more than 90° from row to row: its attitude is shown at the rows alone.`),
    ];
  }
}
