// A small theatre on a canvas: faces, lines and arrows in space, painted from the back to the front.

/** Colours of the page, as three numbers, and as text with a share of opacity. */
const ink = {
  known: new Map(),
  forget() { this.known.clear(); },
  rgb(name) {
    if (!this.known.has(name)) {
      const hex = getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim() || "#808080";
      this.known.set(name, [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)));
    }
    return this.known.get(name);
  },
  text(rgb, opacity = 1) { return `rgba(${rgb.map(Math.round).join(",")},${opacity})`; },
  of(name, opacity = 1) { return this.text(this.rgb(name), opacity); },
};

/** Brings a canvas to the size and density of the screen; false where it has no size. */
function fitCanvas(canvas) {
  const density = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * density), height = Math.round(canvas.clientHeight * density);
  if (!(width > 0 && height > 0)) return false;
  if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
  canvas.getContext("2d").setTransform(density, 0, 0, density, 0, 0);
  return true;
}

class Stage {
  /** @param up  what stands upright on the screen */
  constructor(canvas, { up = [0, 0, 1], azimuth = 0.6, elevation = 0.32, nearness = 1, changed }) {
    Object.assign(this, { canvas, up: unit(up), azimuth, elevation, nearness, changed, centre: [0, 0, 0], items: [] });
    this.frame = frameAbout(this.up);
    this.listen();
  }

  listen() {
    let held = null;
    this.canvas.addEventListener("pointerdown", (event) => { held = [event.clientX, event.clientY]; this.canvas.setPointerCapture(event.pointerId); });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!held) return;
      this.turn((held[0] - event.clientX) * 0.009, (event.clientY - held[1]) * 0.009);
      held = [event.clientX, event.clientY];
    });
    for (const end of ["pointerup", "pointercancel"]) this.canvas.addEventListener(end, () => { held = null; });
    // The wheel belongs to the page until the picture has been chosen.
    this.canvas.addEventListener("wheel", (event) => { if (document.activeElement !== this.canvas && !event.ctrlKey) return; event.preventDefault(); this.approach(Math.exp(-event.deltaY * 0.0012)); }, { passive: false });
    this.canvas.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (event.altKey && way) this.turn(...way);
      else if (event.key === "+" || event.key === "=") this.approach(1.1);
      else if (event.key === "-") this.approach(1 / 1.1);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }
  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.max(-1.5, Math.min(1.5, this.elevation + elevation));
    this.changed();
  }
  approach(factor) {
    this.nearness = Math.max(0.4, Math.min(6, this.nearness * factor));
    this.changed();
  }

  /** An empty stage; false where it is not seen. */
  begin() {
    this.items = [];
    if (!fitCanvas(this.canvas)) return false;
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    const [a, b] = this.frame, c = Math.cos(this.azimuth), s = Math.sin(this.azimuth);
    const level = add(scale(c, a), scale(s, b));
    this.eye = add(scale(Math.cos(this.elevation), level), scale(Math.sin(this.elevation), this.up));
    this.right = add(scale(-s, a), scale(c, b));
    this.above = cross(this.eye, this.right);
    this.lamp = unit(add(add(scale(0.75, this.eye), scale(0.75, this.above)), scale(-0.45, this.right)));
    return true;
  }
  /** Where a point is on the screen, and how near. Things of size one fill two thirds of the height. */
  place(p) {
    const distance = 7, from = add(p, scale(-1, this.centre)), depth = dot(from, this.eye);
    const size = 0.36 * Math.min(this.height, this.width) * this.nearness * (distance / (distance - Math.min(depth, distance - 1)));
    return [this.width / 2 + size * dot(from, this.right), this.height / 2 - size * dot(from, this.above), depth];
  }

  /** A flat convex face; one that looks away is left out. Light falls from above the left shoulder; gloss is how far it whitens. */
  face(points, normal, colour, gloss = 0.55) {
    const middle = scale(1 / points.length, points.reduce(add));
    const towards = dot(normal, add(add(scale(7, this.eye), this.centre), scale(-1, middle)));
    if (towards <= 0) return;
    const lit = dot(normal, this.lamp);
    const shaded = lit > 0 ? mix(colour, ink.rgb("light"), gloss * lit ** 3) : mix(colour, ink.rgb("shade"), -0.45 * lit);
    const dim = mix(shaded, ink.rgb("shade"), 0.3 * (1 - Math.max(0, lit)));
    this.items.push({ depth: dot(add(middle, scale(-1, this.centre)), this.eye), fill: ink.text(dim), points: points.map((p) => this.place(p)) });
  }
  /** A line through points, in pieces that are sorted one by one. */
  line(points, colour, width = 1.5, { opacity = () => 1, lift = 0, dash = [] } = {}) {
    for (let i = 1; i < points.length; ++i) {
      const a = this.place(points[i - 1]), b = this.place(points[i]), dx = b[0] - a[0], dy = b[1] - a[1], more = 0.35 / (Math.hypot(dx, dy) || 1);
      // Each piece is a little longer than it is, or hairlines would show between them.
      const ends = [[a[0] - more * dx, a[1] - more * dy], [b[0] + more * dx, b[1] + more * dy]];
      this.items.push({ depth: (a[2] + b[2]) / 2 + lift, stroke: ink.of(colour, opacity(i / (points.length - 1), points[i])), width, points: ends, dash });
    }
  }
  /** A straight line that may pass through things. */
  segment(a, b, colour, width = 1.5, options = {}) {
    this.line(Array.from({ length: 25 }, (_, i) => mix(a, b, i / 24)), colour, width, options);
  }
  arrow(from, to, colour, width = 3.5, throughThings = true) {
    const a = this.place(from), b = this.place(to), dx = b[0] - a[0], dy = b[1] - a[1], length = Math.hypot(dx, dy);
    const head = Math.min(4.4 * width, 0.6 * length);
    const stop = length > 0 ? 1 - (0.8 * head) / length : 1;
    if (throughThings) this.segment(from, mix(from, to, stop), colour, width);
    else this.line([from, mix(from, to, stop)], colour, width);
    if (length < 1) return;
    const u = [dx / length, dy / length], foot = [b[0] - head * u[0], b[1] - head * u[1]], half = 0.42 * head;
    this.items.push({ depth: b[2], fill: ink.of(colour), points: [b, [foot[0] - half * u[1], foot[1] + half * u[0]], [foot[0] + half * u[1], foot[1] - half * u[0]]] });
  }
  dot(p, radius, colour, lift = 0.02) {
    const at = this.place(p);
    this.items.push({ depth: at[2] + lift, disc: radius, fill: ink.of(colour), points: [at] });
  }
  label(p, text, colour, lift = 0.05) {
    const at = this.place(p);
    this.items.push({ depth: at[2] + lift, text, fill: ink.of(colour), points: [at] });
  }

  /** Everything, the farthest first. */
  paint(before = () => {}) {
    const pen = this.canvas.getContext("2d");
    pen.clearRect(0, 0, this.width, this.height);
    before(pen);
    pen.lineCap = "butt";
    pen.lineJoin = "round";
    this.items.sort((a, b) => a.depth - b.depth);
    // What is alike and follows one another is painted at once, so that no seams show between pieces.
    const alike = (a, b) => a.fill === b.fill && a.stroke === b.stroke && a.width === b.width && a.text === undefined && b.text === undefined;
    for (let first = 0, end; first < this.items.length; first = end) {
      for (end = first + 1; end < this.items.length && alike(this.items[first], this.items[end]);) ++end;
      this.paintAlike(pen, this.items.slice(first, end));
    }
  }
  paintAlike(pen, items) {
    const { text, fill, stroke, width, dash } = items[0];
    if (text !== undefined) return this.paintText(pen, text, fill, items[0].points[0]);
    pen.beginPath();
    for (const { points, disc } of items) {
      if (disc) {
        pen.moveTo(points[0][0] + disc, points[0][1]);
        pen.arc(points[0][0], points[0][1], disc, 0, 2 * Math.PI);
        continue;
      }
      points.forEach((p, i) => (i ? pen.lineTo(p[0], p[1]) : pen.moveTo(p[0], p[1])));
      if (fill) pen.closePath();
    }
    if (fill) {
      // A thin edge of the same colour closes the seam to the next face.
      pen.fillStyle = pen.strokeStyle = fill;
      pen.lineWidth = 0.9;
      pen.fill();
    } else {
      pen.strokeStyle = stroke;
      pen.lineWidth = width;
      pen.setLineDash(dash);
    }
    pen.stroke();
    pen.setLineDash([]);
  }
  paintText(pen, text, fill, [x, y]) {
    pen.font = "600 13px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.lineWidth = 3;
    pen.strokeStyle = ink.of("stage", 0.85);
    pen.strokeText(text, x, y);
    pen.fillStyle = fill;
    pen.fillText(text, x, y);
  }
}
