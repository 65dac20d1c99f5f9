// The motion of a body, at any time: between two rows its attitude turns at constant angular velocity.

class Motion {
  constructor(run) {
    this.columns = run.motion.columns;
    this.times = this.columns.t;
    this.from = this.times[0];
    this.to = this.times[this.times.length - 1];
    this.read(run);
    this.measureTurns();
  }
  read(run) {
    this.body = run.body;
    this.attitudes = this.rows("attitude", ["w", "x", "y", "z"]);
    this.momenta = this.bodyMomenta();
  }
  rows(name, ends) {
    const lists = ends.map((end) => this.columns[`${name}_${end}`]);
    return lists.every(Boolean) ? this.times.map((_, i) => lists.map((list) => list[i])) : null;
  }
  /** In the frame of the body, from whatever was asked for. */
  bodyMomenta() {
    const xyz = ["x", "y", "z"];
    const momentum = this.rows("body_momentum", xyz), velocity = this.rows("angular_velocity", xyz), spatial = this.rows("spatial_momentum", xyz);
    if (momentum) return momentum;
    // Of a top the momentum is about the fixed point, and its inertia here about the centre of mass.
    if (velocity && this.body && !this.body.top) return velocity.map((w) => this.inertia(w));
    return spatial && this.attitudes ? spatial.map((m, i) => turned(inverse(this.attitudes[i]), m)) : null;
  }
  inertia(v, power = 1) {
    return this.body.axes.map((a, i) => scale(dot(a, v) * this.body.moments[i] ** power, a)).reduce(add);
  }
  /** How far neighbouring rows are apart, which says whether one may interpolate, and how fast to play. */
  measureTurns() {
    const rows = this.attitudes || this.momenta || [];
    const angle = this.attitudes ? angleBetween : angleOfDirections;
    let total = 0;
    this.widest = 0;
    for (let i = 1; i < rows.length; ++i) {
      const turn = angle(rows[i - 1], rows[i]);
      total += turn;
      this.widest = Math.max(this.widest, turn);
    }
    this.turns = total / (2 * Math.PI);
    this.smooth = this.widest < Math.PI / 2;
  }
  get playable() { return this.times.length > 1 && Boolean(this.attitudes || this.momenta); }
  /** Time of the run per second at ordinary speed: the whole in a quarter of a minute, or a turn in two seconds and a half where that takes longer. */
  get pace() { return (this.to - this.from) / Math.max(15, 2.5 * this.turns); }

  at(t) {
    let [i, s] = bracket(this.times, t);
    if (!this.smooth) s = Math.round(s);
    const between = (rows, by) => rows && by(rows[i], rows[Math.min(i + 1, rows.length - 1)], s);
    return { t, row: i, ...this.state(between) };
  }
  state(between) {
    const momentum = between(this.momenta, (a, b, u) => scale(norm(a) + u * (norm(b) - norm(a)), unit(mix(a, b, u))));
    return { attitude: between(this.attitudes, slerp), momentum };
  }
}
