// A medium in motion: its cells, or in space its surface, in the colours of a field, with the outline of the
// body and what the colours mean.

/** The medium at any time: between two snapshots places and colours go straight from one to the other. */
class Medium {
  constructor({ dimension, times, points, lower, upper, faces, outline, places, fields, palette }) {
    const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), shorts = (text) => new Uint16Array(bytes(text).buffer);
    Object.assign(this, { dimension, times, points, lower, upper, palette, from: times[0], to: times[times.length - 1] });
    Object.assign(this, { faces: shorts(faces), outline: shorts(outline), places: shorts(places), fields: fields.map((field) => ({ ...field, values: bytes(field.values) })) });
    this.count = this.faces.length / 4;
    this.colours = palette.map((hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)));
    this.measure();
  }
  /** Time of the run per second at ordinary speed: the whole in a quarter of a minute. */
  get pace() { return (this.to - this.from) / 15; }
  /** Places of all points at a snapshot, or between it and the next one. */
  placesAt(i, s) {
    const d = this.dimension, size = d * this.points, next = Math.min(i + 1, this.times.length - 1), out = new Float64Array(size);
    const step = this.lower.map((low, a) => (this.upper[a] - low) / 65535);
    for (let k = 0; k < size; ++k) {
      const p = this.places[i * size + k], a = k % d;
      out[k] = this.lower[a] + step[a] * (p + s * (this.places[next * size + k] - p));
    }
    return out;
  }
  boxOf(places) {
    const d = this.dimension, lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
    places.forEach((x, k) => { lower[k % d] = Math.min(lower[k % d], x); upper[k % d] = Math.max(upper[k % d], x); });
    if (d === 2) { lower[2] = upper[2] = 0; }
    return { middle: mix(lower, upper, 0.5), half: scale(0.5, add(upper, scale(-1, lower))) };
  }
  /** How large the body is, how far it goes, and whether edges keep their lengths half way between snapshots. */
  measure() {
    const boxes = this.times.map((_, i) => this.boxOf(this.placesAt(i, 0)));
    this.half = boxes.reduce((most, { half }) => half.map((x, a) => Math.max(x, most[a])), [0, 0, 0]);
    this.whole = { middle: mix(this.lower, this.upper, 0.5), half: scale(0.5, add(this.upper, scale(-1, this.lower))) };
    this.travels = norm(this.whole.half) > 2 * norm(this.half);
    this.smooth = this.times.slice(1).every((_, i) => this.isNear(i));
  }
  isNear(i) {
    const [from, between, to] = [this.placesAt(i, 0), this.placesAt(i, 0.5), this.placesAt(i + 1, 0)];
    for (let f = 0; f < this.count; f += 1 + (this.count >> 6)) {
      const length = (places) => norm(add(this.corner(places, f, 1), scale(-1, this.corner(places, f, 0))));
      if (length(between) < 0.9 * Math.min(length(from), length(to))) return false;
    }
    return true;
  }
  corner(places, f, k) {
    const at = this.dimension * this.faces[4 * f + k];
    return [places[at], places[at + 1], this.dimension === 3 ? places[at + 2] : 0];
  }
  at(t) {
    let [i, s] = bracket(this.times, t);
    if (!this.smooth) s = Math.round(s);
    const places = this.placesAt(i, s);
    return { t, i, s, places, box: this.boxOf(places) };
  }
  /** The colour of a face, by its number in the palette. */
  colourOf(field, { i, s }, f) {
    const next = Math.min(i + 1, this.times.length - 1), value = field.values[i * this.count + f];
    return Math.round(((value + s * (field.values[next * this.count + f] - value)) / 255) * (this.palette.length - 1));
  }
  /** One that varies first. */
  get first() { return Math.max(0, this.fields.findIndex(({ low, high }) => high - low > 1e-9 * Math.abs(high))); }
}

/** What all pictures of a medium have: a field that is chosen, and a bar of its colours. */
class MediumView {
  constructor(canvas, medium) {
    Object.assign(this, { canvas, medium, field: medium.fields[medium.first] });
    this.shown = { cells: medium.count <= 3000, outline: true, follow: medium.travels };
    this.colours = { cells: "quiet", outline: "text", follow: "accent" };
    this.choices = [{ label: "field", title: "What the colours show", options: medium.fields.map(({ name }) => name), chosen: medium.first, choose: (k) => { this.field = medium.fields[k]; } }];
  }
  /** What is to be seen at a moment: its middle, and how far it goes from there. */
  window({ box }) { return this.shown.follow ? { middle: box.middle, half: this.medium.half } : this.medium.whole; }
  drawBar(pen) {
    const { palette } = this.medium, { name, low, high } = this.field, width = Math.min(280, 0.6 * this.canvas.clientWidth);
    const left = (this.canvas.clientWidth - width) / 2, top = this.canvas.clientHeight - 36;
    palette.forEach((colour, k) => {
      pen.fillStyle = colour;
      pen.fillRect(left + (k * width) / palette.length, top, width / palette.length + 0.5, 9);
    });
    pen.font = "12px system-ui, sans-serif";
    pen.fillStyle = ink.of("text");
    pen.textAlign = "center";
    pen.textBaseline = "alphabetic";
    const texts = high > low ? [[shownNumber(low, 4), 0], [name, 0.5], [shownNumber(high, 4), 1]] : [[`${name} ${shownNumber(low, 6)} everywhere`, 0.5]];
    for (const [text, share] of texts) pen.fillText(text, left + share * width, top + 24);
  }
}

/** In the plane: cells that are painted flat. */
class PlaneMediumView extends MediumView {
  draw(now) {
    if (!fitCanvas(this.canvas)) return;
    const pen = this.canvas.getContext("2d"), { medium } = this, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    pen.clearRect(0, 0, width, height);
    const { middle, half } = this.window(now), length = Math.min((width - 36) / (2 * half[0] || 1), (height - 76) / (2 * half[1] || 1));
    const x = new Float64Array(medium.points), y = new Float64Array(medium.points);
    for (let k = 0; k < medium.points; ++k) {
      x[k] = width / 2 + length * (now.places[2 * k] - middle[0]);
      y[k] = (height - 40) / 2 - length * (now.places[2 * k + 1] - middle[1]);
    }
    const around = (f) => {
      for (let k = 0; k < 4; ++k) {
        const point = medium.faces[4 * f + k];
        if (k) pen.lineTo(x[point], y[point]); else pen.moveTo(x[point], y[point]);
      }
      pen.closePath();
    };
    const ofColour = medium.palette.map(() => []);
    for (let f = 0; f < medium.count; ++f) ofColour[medium.colourOf(this.field, now, f)].push(f);
    pen.lineJoin = "round";
    ofColour.forEach((faces, k) => {
      if (!faces.length) return;
      pen.beginPath();
      faces.forEach(around);
      // A thin edge of the same colour closes the seam to the next cell.
      pen.fillStyle = pen.strokeStyle = medium.palette[k];
      pen.lineWidth = 0.7;
      pen.fill();
      pen.stroke();
    });
    if (this.shown.cells) {
      pen.beginPath();
      for (let f = 0; f < medium.count; ++f) around(f);
      this.stroke(pen, "stage", 0.35, 0.6);
    }
    if (this.shown.outline) {
      pen.beginPath();
      for (let k = 0; k < medium.outline.length; k += 2) {
        pen.moveTo(x[medium.outline[k]], y[medium.outline[k]]);
        pen.lineTo(x[medium.outline[k + 1]], y[medium.outline[k + 1]]);
      }
      this.stroke(pen, "text", 0.9, 1.3);
    }
    this.drawBar(pen);
  }
  stroke(pen, colour, opacity, width) {
    pen.strokeStyle = ink.of(colour, opacity);
    pen.lineWidth = width;
    pen.stroke();
  }
}

/** In space: the surface, shaded. */
class SpaceMediumView extends MediumView {
  constructor(canvas, medium, changed) {
    super(canvas, medium);
    delete this.shown.cells;
    this.stage = new Stage(canvas, { changed, azimuth: -0.9, elevation: 0.4, nearness: 1.1 });
  }
  draw(now) {
    const { medium, stage } = this;
    if (!stage.begin()) return;
    const { middle, half } = this.window(now), size = 2.5 / (norm(half) + Math.max(...half) || 1);
    const place = (k) => [0, 1, 2].map((a) => size * (now.places[3 * k + a] - middle[a]));
    for (let f = 0; f < medium.count; ++f) {
      const points = [0, 1, 2, 3].map((k) => place(medium.faces[4 * f + k]));
      const normal = unit(cross(add(points[2], scale(-1, points[0])), add(points[3], scale(-1, points[1]))));
      stage.face(points, normal, medium.colours[medium.colourOf(this.field, now, f)], 0.15);
    }
    if (this.shown.outline)
      for (let k = 0; k < medium.outline.length; k += 2) stage.line([place(medium.outline[k]), place(medium.outline[k + 1])], "text", 1.2, { opacity: () => 0.7, lift: 0.01 });
    stage.paint();
    this.drawBar(this.canvas.getContext("2d"));
  }
}
