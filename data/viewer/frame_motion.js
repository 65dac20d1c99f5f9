// The motion of a frame in the plane or in space, with what it carries and with momenta of any number of
// components, at any time: between two rows it turns at constant angular velocity, and goes straight.

class FrameMotion extends Motion {
  read(run) {
    this.shown = run.scene.shown || {};
    this.quantities = run.quantities;
    this.onLeft = run.scene.side !== "right";
    this.readFrame();
    this.carried = this.attitudes ? this.named("beside").map((q) => this.carriedVector(q)).filter(Boolean) : [];
    this.trajectories = [...this.named("trajectory"), ...this.named("sphere")].map((q) => this.trajectory(q)).filter(Boolean);
    this.momenta = this.trajectories.length ? this.trajectories[0].rows : null;
  }
  named(...ways) { return this.quantities.filter((q) => ways.includes(this.shown[q.name])); }
  /** Of a quantity, as many components as are there. */
  trajectory(quantity) {
    const { name, words, of, components } = quantity, ends = components.map((c) => c.label);
    const rows = this.rows(name, ends), labels = ends.map((end) => componentName(quantity, end));
    return rows && rows[0].length > 1 ? { name, words, of, labels, rows, sphere: this.shown[name] === "sphere" } : null;
  }

  /** A frame of the plane is one of space that turns about the third axis. */
  readFrame() {
    const [quantity] = this.named("rotation", "motion");
    if (!quantity) return;
    const moves = this.shown[quantity.name] === "motion", size = Math.round(Math.sqrt(quantity.of)), n = moves ? size - 1 : size;
    const entry = (i, j) => this.columns[`${quantity.name}_${i + 1}${j + 1}`];
    const at = (i, j, row) => (i < n && j < n ? entry(i, j)[row] : i === j ? 1 : 0);
    const axes = [0, 1, 2], matrices = this.times.map((_, row) => axes.map((i) => axes.map((j) => at(i, j, row))));
    // A reflection, or what is no rotation at all, cannot be turned to.
    if (!matrices.every(([a, b, c]) => Math.abs(dot(cross(a, b), c) - 1) < 1e-3)) return;
    this.flat = n === 2;
    this.attitudes = matrices.map(quaternionOf);
    if (moves) this.places = this.times.map((_, row) => axes.map((i) => (i < n ? entry(i, n)[row] : 0)));
  }
  /** As it is in space: a direction, or a point where the last number of the vector is not zero. */
  carriedVector({ name, components }) {
    const n = this.flat ? 2 : 3, rows = this.rows(name, components.map((c) => c.label));
    if (!rows || rows[0].length < n) return null;
    const weight = rows[0].length > n ? rows[0][n] : 0;
    const inSpace = rows.map((row, i) => {
      const v = [row[0], row[1], n === 3 ? row[2] : 0];
      const moved = this.onLeft ? turned(this.attitudes[i], v) : v;
      if (Math.abs(weight) < 1e-12) return moved;
      return scale(1 / weight, this.onLeft ? add(moved, scale(weight, this.places[i])) : moved);
    });
    return { name, rows: inSpace, point: Math.abs(weight) >= 1e-12 };
  }

  state(between) {
    const list = (all) => all.map(({ rows }) => between(rows, mix));
    return { attitude: between(this.attitudes, slerp), place: between(this.places, mix) || [0, 0, 0], carried: list(this.carried), momenta: list(this.trajectories) };
  }
}
