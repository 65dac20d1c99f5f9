// The angular momentum as the body sees it: it moves on a sphere, along the curve where the sphere meets the
// ellipsoid of energy.

/** The sphere of size one, behind what is drawn on it. */
function paintGlass(pen, stage) {
  const [x, y] = stage.place([0, 0, 0]), edge = stage.place(stage.right), r = 1.012 * Math.hypot(edge[0] - x, edge[1] - y);
  const light = pen.createRadialGradient(x - 0.4 * r, y - 0.5 * r, 0.1 * r, x, y, r);
  light.addColorStop(0, ink.of("light", 0.9));
  light.addColorStop(0.55, ink.of("body", 0.28));
  light.addColorStop(1, ink.of("body", 0.6));
  pen.fillStyle = light;
  if (matchMedia("(prefers-color-scheme: dark)").matches) pen.globalAlpha = 0.35;
  pen.beginPath();
  pen.arc(x, y, r, 0, 2 * Math.PI);
  pen.fill();
  pen.globalAlpha = 1;
}

class MomentumView {
  constructor(canvas, motion, changed) {
    this.motion = motion;
    this.body = motion.body;
    this.stage = new Stage(canvas, { up: this.body.axes[2], azimuth: 0.75, elevation: 0.4, nearness: 0.97, changed });
    this.shown = { polhode: true, "other energies": true, "energy ellipsoid": false };
    this.colours = { polhode: "plot-4", "other energies": "quiet", "energy ellipsoid": "plot-1" };
    const length = motion.momenta.reduce((most, m) => Math.max(most, norm(m)), 0) || 1;
    this.points = motion.momenta.map((m) => scale(1 / length, m));
    this.length = length;
    this.others = this.levels();
    // Twice the energy over |M|^2, which names the curve.
    this.level = dot(this.points[0], motion.inertia(this.points[0], -1));
  }

  /** Curves of other energies on the sphere, about the axes of least and of greatest moment, and the separatrices between them. */
  levels() {
    const order = [0, 1, 2].sort((i, j) => this.body.moments[i] - this.body.moments[j]);
    const [least, middle, most] = order.map((i) => ({ axis: this.body.axes[i], inverse: 1 / this.body.moments[i] }));
    const out = [];
    const about = (pole, one, two, level) => {
      const share = (other) => Math.min(1, Math.sqrt(Math.max(0, (level - pole.inverse) / (other.inverse - pole.inverse))));
      const [a, b] = [share(one), share(two)];
      for (const side of [1, -1])
        out.push(Array.from({ length: 97 }, (_, i) => {
          const u = a * Math.cos((i * Math.PI) / 48), v = b * Math.sin((i * Math.PI) / 48), w = side * Math.sqrt(Math.max(0, 1 - u * u - v * v));
          return add(add(scale(u, one.axis), scale(v, two.axis)), scale(w, pole.axis));
        }));
    };
    for (const s of [0.12, 0.4, 0.75, 1]) {
      if (middle.inverse - most.inverse > 1e-9 * least.inverse) about(most, least, middle, most.inverse + s * (middle.inverse - most.inverse));
      if (least.inverse - middle.inverse > 1e-9 * least.inverse) about(least, middle, most, least.inverse + s * (middle.inverse - least.inverse));
    }
    return out;
  }

  draw(now) {
    const stage = this.stage;
    if (!stage.begin()) return;
    // What is behind the sphere is seen through it, paler.
    const fade = (strong, pale) => (_, p) => (dot(p, stage.eye) > 0.1 ? strong : pale);
    this.drawAxes();
    if (this.shown["other energies"]) for (const curve of this.others) stage.line(curve, "quiet", 0.9, { opacity: fade(0.5, 0.13) });
    if (this.shown["energy ellipsoid"]) this.drawEllipsoid(fade);
    if (this.shown.polhode) stage.line(this.points, "plot-4", 2.2, { opacity: fade(0.95, 0.3), lift: 0.01 });
    const tip = scale(1 / this.length, now.momentum);
    stage.arrow([0, 0, 0], tip, "plot-4", 3, false);
    stage.dot(tip, 5, "plot-4", 0.05);
    stage.paint((pen) => paintGlass(pen, stage));
  }
  drawAxes() {
    for (const { axis, name, colour } of namedAxes(this.body)) {
      this.stage.line([[0, 0, 0], scale(1.22, axis)], colour, 1.6);
      this.stage.label(scale(1.31, axis), name, colour);
    }
  }
  /** All momenta of this energy. */
  drawEllipsoid(fade) {
    const semi = this.body.moments.map((m) => Math.sqrt(this.level * m));
    const circle = (f) => Array.from({ length: 61 }, (_, i) => outOf(this.body.axes, f((i * Math.PI) / 30).map((x, k) => x * semi[k])));
    for (let k = 0; k < 6; ++k) this.stage.line(circle((t) => [Math.cos(t) * Math.cos((k * Math.PI) / 6), Math.cos(t) * Math.sin((k * Math.PI) / 6), Math.sin(t)]), "plot-1", 1, { opacity: fade(0.75, 0.18) });
    for (let k = -2; k <= 2; ++k) {
      const z = Math.sin((k * Math.PI) / 6), r = Math.cos((k * Math.PI) / 6);
      this.stage.line(circle((t) => [r * Math.cos(t), r * Math.sin(t), z]), "plot-1", 1, { opacity: fade(0.75, 0.18) });
    }
  }
}
