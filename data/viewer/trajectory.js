// The way of a momentum through the space of its components: on its sphere, in a box, or, of more than three
// components, of two of them that are chosen.

class TrajectoryView {
  constructor(canvas, motion, changed) {
    Object.assign(this, { canvas, motion, changed, chosen: 0 });
    this.all = motion.trajectories;
    this.solid = this.all[0].labels.length === 3;
    this.shown = { trajectory: true, ...(this.solid && !this.all[0].sphere ? { shadows: true } : {}) };
    this.colours = { trajectory: "plot-4", shadows: "quiet" };
    if (this.solid) this.stage = new Stage(canvas, { azimuth: 0.75, elevation: 0.4, nearness: this.all[0].sphere ? 0.97 : 0.9, changed });
    else this.pair = this.liveliest();
    this.choose(0);
  }
  get now() { return this.all[this.chosen]; }
  /** Choices that stand beside the picture. */
  get choices() {
    const out = [], labels = this.now.labels;
    if (this.all.length > 1) out.push({ label: "Momentum", options: this.all.map((t) => t.words), chosen: 0, choose: (i) => this.choose(i) });
    if (!this.solid && labels.length > 2)
      for (const [k, label, way] of [[0, "To the right", "→ "], [1, "Upwards", "↑ "]]) out.push({ label, options: labels.map((l) => way + l), chosen: this.pair[k], choose: (i) => { this.pair[k] = i; this.choose(this.chosen); } });
    return out;
  }
  /** The two components that vary most. */
  liveliest() {
    const { labels, rows } = this.all[0], range = labels.map((_, i) => rows.reduce((most, r) => Math.max(most, r[i]), -Infinity) - rows.reduce((least, r) => Math.min(least, r[i]), Infinity));
    return labels.map((_, i) => i).sort((i, j) => range[j] - range[i]).slice(0, 2).sort((i, j) => i - j);
  }
  choose(i) {
    this.chosen = i;
    const { rows, labels, sphere } = this.now;
    if (!this.solid) this.points = rows.map((row) => this.pair.map((k) => row[k]));
    else if (sphere) this.length = this.all.flatMap((t) => t.rows).reduce((most, m) => Math.max(most, norm(m)), 0) || 1;
    else {
      this.box = new Box(rows, labels, false);
      Object.assign(this.stage, { nearness: this.box.nearness, ...this.facing() });
    }
    if (this.solid) this.points = rows.map((row) => this.placed(row));
    this.changed();
  }
  /** From where a plane that the momentum stays in is seen as one. */
  facing() {
    const flat = this.box.half.indexOf(0);
    return flat < 0 ? { azimuth: 0.75, elevation: 0.4 } : [{ azimuth: 1.2, elevation: 0.4 }, { azimuth: 0.35, elevation: 0.4 }, { azimuth: 0.35, elevation: 1 }][flat];
  }
  placed(m) { return this.box ? this.box.place(m) : scale(1 / this.length, m); }

  draw(now) {
    const momentum = now.momenta[this.chosen];
    if (!this.solid) return this.drawPair(this.pair.map((k) => momentum[k]), now.row);
    if (!this.stage.begin()) return;
    if (this.box) this.drawInBox(this.placed(momentum), now.row);
    else this.drawOnSphere(this.placed(momentum));
  }
  drawOnSphere(tip) {
    const stage = this.stage;
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, i) => {
      stage.line([[0, 0, 0], scale(1.22, axis)], "plot-" + (i + 1), 1.6);
      stage.label(scale(1.31, axis), this.now.labels[i], "plot-" + (i + 1));
    });
    if (this.shown.trajectory) stage.line(this.points, "plot-4", 2.2, { opacity: (_, p) => (dot(p, stage.eye) > 0.1 ? 0.95 : 0.3), lift: 0.01 });
    stage.arrow([0, 0, 0], tip, "plot-4", 3, false);
    stage.dot(tip, 5, "plot-4", 0.05);
    stage.paint((pen) => paintGlass(pen, stage));
  }
  drawInBox(tip, row) {
    const stage = this.stage;
    this.box.draw(stage);
    for (let k = 0; k < 3 && this.shown.shadows; ++k) {
      const side = this.box.behind(stage, k) * this.box.half[k], flattened = (p) => p.map((x, i) => (i === k ? side : x));
      if (this.box.half[k] === 0) continue;
      stage.line(this.points.map(flattened), "quiet", 1.2, { opacity: () => 0.25, lift: -0.02 });
      stage.dot(flattened(tip), 3, "quiet", -0.01);
    }
    if (this.shown.trajectory) {
      stage.line(this.points, "plot-4", 1.4, { opacity: () => 0.4 });
      stage.line([...this.points.slice(0, row + 1), tip], "plot-4", 2.2, { lift: 0.01 });
    }
    stage.dot(tip, 5, "plot-4", 0.05);
    stage.paint();
  }

  /** From where to where a component goes, with a little room; of a constant one its surroundings. */
  span(i) {
    let low = this.points.reduce((least, p) => Math.min(least, p[i]), Infinity), high = this.points.reduce((most, p) => Math.max(most, p[i]), -Infinity);
    const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
    if (high - low < 1e-6 * size) [low, high] = [low - 0.5 * size, high + 0.5 * size];
    const room = 0.06 * (high - low);
    return [low - room, high + room];
  }
  drawPair(tip, row) {
    if (!fitCanvas(this.canvas)) return;
    const pen = this.canvas.getContext("2d"), width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    const top = 26, bottom = height - 46, side = Math.min(width - 84, 1.5 * (bottom - top)), left = 0.5 * (width - side) + 24, right = left + side, [[x0, x1], [y0, y1]] = [this.span(0), this.span(1)];
    const x = (v) => left + ((v - x0) / (x1 - x0)) * (right - left), y = (v) => bottom - ((v - y0) / (y1 - y0)) * (bottom - top);
    pen.clearRect(0, 0, width, height);
    this.drawScales(pen, { left, right, top, bottom, x, y }, ticksOf(x0, x1, 6), ticksOf(y0, y1, 6));
    const curve = (points, opacity, thickness) => {
      pen.beginPath();
      for (const p of points) pen.lineTo(x(p[0]), y(p[1]));
      pen.strokeStyle = ink.of("plot-4", opacity);
      pen.lineWidth = thickness;
      pen.lineJoin = "round";
      pen.stroke();
    };
    if (this.shown.trajectory) {
      curve(this.points, 0.4, 1.4);
      curve([...this.points.slice(0, row + 1), tip], 1, 2.2);
    }
    pen.beginPath();
    pen.arc(x(tip[0]), y(tip[1]), 5, 0, 2 * Math.PI);
    pen.fillStyle = ink.of("plot-4");
    pen.fill();
  }
  drawScales(pen, { left, right, top, bottom, x, y }, across, upwards) {
    const said = (v, all) => (Math.abs(v) < 1e-9 * (all[all.length - 1] - all[0]) ? "0" : shownNumber(v, 4));
    pen.font = "11.5px system-ui, sans-serif";
    pen.strokeStyle = ink.of("grid");
    pen.fillStyle = ink.of("quiet");
    pen.lineWidth = 1;
    pen.textBaseline = "middle";
    pen.beginPath();
    pen.textAlign = "center";
    for (const v of across) {
      pen.moveTo(Math.round(x(v)) + 0.5, top);
      pen.lineTo(Math.round(x(v)) + 0.5, bottom);
      pen.fillText(said(v, across), x(v), bottom + 13);
    }
    pen.textAlign = "right";
    for (const v of upwards) {
      pen.moveTo(left, Math.round(y(v)) + 0.5);
      pen.lineTo(right, Math.round(y(v)) + 0.5);
      pen.fillText(said(v, upwards), left - 7, y(v));
    }
    pen.stroke();
    pen.font = "600 13px system-ui, sans-serif";
    pen.fillStyle = ink.of("text");
    const [one, two] = this.pair.map((k) => this.now.labels[k]);
    pen.textAlign = "center";
    pen.fillText(one, 0.5 * (left + right), bottom + 32);
    pen.fillText(two, left, top - 13);
  }
}
