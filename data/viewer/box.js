// A box around points in space, drawn with the values at the ends of its sides: a scale for what is in it.

class Box {
  /** @param names  of the three directions
   *  @param alike  whether they are drawn to one scale */
  constructor(points, names, alike) {
    this.names = names;
    this.low = [0, 1, 2].map((i) => points.reduce((least, p) => Math.min(least, p[i]), Infinity));
    this.high = [0, 1, 2].map((i) => points.reduce((most, p) => Math.max(most, p[i]), -Infinity));
    this.middle = mix(this.low, this.high, 0.5);
    const largest = Math.max(...[...this.low, ...this.high].map(Math.abs));
    // What is so thin is constant, and not to be blown up.
    let sides = this.low.map((low, i) => (this.high[i] - low > 1e-6 * largest ? this.high[i] - low : 0));
    if (!sides.some((side) => side > 0)) sides = this.around(largest || 2);
    const longest = Math.max(...sides);
    this.half = sides.map((side) => (side === 0 ? 0 : 0.95 * (alike ? side / longest : Math.max(side / longest, 0.45))));
    this.factors = sides.map((side, i) => (side === 0 || alike ? 1.9 / longest : (2 * this.half[i]) / side));
  }
  /** About points that are all the same, a cube; in the plane, which the third direction has no name for, a square. */
  around(side) {
    const half = this.names.map((name) => (name ? 0.5 * side : 0));
    this.low = this.middle.map((x, i) => x - half[i]);
    this.high = this.middle.map((x, i) => x + half[i]);
    return half.map((x) => 2 * x);
  }
  /** How near the eye has to be for the box to fill the stage. */
  get nearness() { return 1.05 / Math.max(1, Math.hypot(...this.half)) ** 0.6; }
  place(p) { return p.map((x, i) => this.factors[i] * (x - this.middle[i])); }
  /** The side of the box, 1 or -1, that is behind what is in it. */
  behind(stage, i) { return stage.eye[i] > 0 ? -1 : 1; }

  draw(stage) {
    const back = [0, 1, 2].map((i) => this.behind(stage, i));
    for (let k = 0; k < 3; ++k) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      for (const [a, b] of [[1, 1], [1, -1], [-1, 1], [-1, -1]]) {
        const corner = (side) => { const p = [0, 0, 0]; p[k] = side * this.half[k]; p[i] = a * this.half[i]; p[j] = b * this.half[j]; return p; };
        // The edges that meet in the corner next to the eye would be in front of everything.
        if (this.half[k] > 0 && (a === back[i] || b === back[j])) stage.segment(corner(-1), corner(1), "quiet", 1, { opacity: () => 0.35, lift: -0.02 });
      }
      this.label(stage, k, back);
    }
  }
  /** Beside the outermost edge that is lowest on the screen: what the direction is called, and from where to where it goes. */
  label(stage, k, back) {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3], shift = 0.1;
    const at = (share, a, b) => { const p = [0, 0, 0]; p[k] = share * this.half[k]; p[i] = a * (this.half[i] + shift); p[j] = b * (this.half[j] + shift); return p; };
    const lowness = ([a, b]) => { const [x, y] = stage.place(at(0, a, b)); return y - 0.35 * x; };
    const [a, b] = [[back[i], -back[j]], [-back[i], back[j]]].sort((p, q) => lowness(q) - lowness(p))[0];
    const colour = "plot-" + (k + 1);
    if (this.half[k] === 0) {
      // Of a plane, what is constant in it, away from its scales.
      if (this.names[k]) stage.label(at(0, back[i], back[j]), `${this.names[k]} = ${shownNumber(this.middle[k], 3)}`, colour);
      return;
    }
    stage.label(at(0, a, b), this.names[k], colour);
    // Of a side so short that its ends would be written over one another, the length alone.
    if (this.half[k] < 0.3) return;
    stage.label(at(-0.8, a, b), shownNumber(this.low[k], 3), "quiet");
    stage.label(at(0.8, a, b), shownNumber(this.high[k], 3), "quiet");
  }
}
