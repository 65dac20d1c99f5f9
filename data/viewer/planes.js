// The momentum of a body in n dimensions, one cell for each plane: above the diagonal its course over time,
// below it how large it is now.

class PlanesView {
  /** @param momentum  the quantity, with one curve for each pair i < j, row by row */
  constructor(canvas, momentum, times) {
    Object.assign(this, { canvas, times, curves: momentum.components.map((c) => c.curve) });
    this.n = Math.round((1 + Math.sqrt(1 + 8 * momentum.of)) / 2);
    this.largest = 0;
    for (const curve of this.curves)
      for (const list of [lowest(curve), highest(curve)])
        for (const x of list)
          if (Math.abs(x) > this.largest) this.largest = Math.abs(x);
    this.largest = this.largest || 1;
    this.shown = { course: true, "size now": true };
    this.colours = { course: "plot-1", "size now": "plot-2" };
  }

  draw(now) {
    if (!fitCanvas(this.canvas)) return;
    const pen = this.canvas.getContext("2d"), width = this.canvas.clientWidth,
          height = this.canvas.clientHeight;
    const side = (Math.min(width, height) - 28) / this.n;
    pen.clearRect(0, 0, width, height);
    pen.save();
    pen.translate((width - this.n * side) / 2, (height - this.n * side) / 2);
    this.drawGrid(pen, side);
    let k = 0;
    for (let i = 0; i < this.n; ++i)
      for (let j = i + 1; j < this.n && k < this.curves.length; ++j, ++k) {
        if (this.shown.course) this.drawCourse(pen, this.curves[k], j * side, i * side, side, now.t);
        if (this.shown["size now"]) this.drawSize(pen, this.curves[k], i * side, j * side, side, now.t);
      }
    pen.restore();
  }
  drawGrid(pen, side) {
    const whole = this.n * side;
    pen.strokeStyle = ink.of("grid");
    pen.lineWidth = 1;
    pen.beginPath();
    for (let i = 0; i <= this.n; ++i) {
      pen.moveTo(0, i * side);
      pen.lineTo(whole, i * side);
      pen.moveTo(i * side, 0);
      pen.lineTo(i * side, whole);
    }
    pen.stroke();
    pen.fillStyle = ink.of("quiet");
    pen.font = `600 ${Math.max(9, Math.min(15, 0.3 * side))}px system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (let i = 0; i < this.n; ++i) pen.fillText(String(i + 1), (i + 0.5) * side, (i + 0.5) * side);
  }
  valueAt(curve, t) {
    const [k, s] = bracket(this.times.from, t), at = Math.min(s > 0.5 ? k + 1 : k, lowest(curve).length - 1);
    return 0.5 * (lowest(curve)[at] + highest(curve)[at]);
  }
  drawCourse(pen, curve, left, top, side, t) {
    const { from, to } = this.times, first = from[0],
                     last = to[to.length - 1] > first ? to[to.length - 1] : first + 1;
    const x = (time) => left + side * (0.06 + (0.88 * (time - first)) / (last - first)),
          y = (v) => top + 0.5 * side - (0.42 * side * v) / this.largest;
    pen.beginPath();
    pen.moveTo(x(first), y(0));
    pen.lineTo(x(last), y(0));
    pen.strokeStyle = ink.of("line");
    pen.lineWidth = 1;
    pen.stroke();
    pen.beginPath();
    lowest(curve).forEach((v, i) => {
      if (v !== null) pen.lineTo(x(from[i]), y(v));
    });
    if (!curve.value)
      for (let i = curve.high.length - 1; i >= 0; --i)
        if (curve.high[i] !== null) pen.lineTo(x(to[i]), y(curve.high[i]));
    pen.strokeStyle = ink.of("plot-1");
    pen.lineWidth = 1.4;
    pen.lineJoin = "round";
    pen.stroke();
    pen.beginPath();
    pen.arc(x(t), y(this.valueAt(curve, t)), 3.2, 0, 2 * Math.PI);
    pen.fillStyle = ink.of("text");
    pen.fill();
  }
  /** A disc whose area is the share of the largest; the second colour where the component is negative. */
  drawSize(pen, curve, left, top, side, t) {
    const value = this.valueAt(curve, t);
    pen.beginPath();
    pen.arc(
      left + 0.5 * side, top + 0.5 * side,
      0.42 * side * Math.sqrt(Math.min(1, Math.abs(value) / this.largest)), 0, 2 * Math.PI);
    pen.fillStyle = ink.of(value < 0 ? "plot-2" : "plot-1", 0.75);
    pen.fill();
  }
}

/** A clock for what has curves and no body: the whole in a quarter of a minute. */
const clockOf = (times) => ({
  from: times.from[0],
  to: times.to[times.to.length - 1],
  get pace() { return (this.to - this.from) / 15; },
  at: (t) => ({ t })
});
