// Curves over time: a panel for each quantity, all with the same times. A drag looks closer, a click goes
// there.

const raised = (n) => String(n).replace(/./g, (c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"["0123456789".indexOf(c)] || "⁻");
const lowered = (n) => String(n).replace(/\d/g, (c) => "₀₁₂₃₄₅₆₇₈₉"[c]);
/** What a component is called: by its own name, v1, or, where it has numbers alone, by its quantity with these: gravity₁; entries of matrices by one letter: c₁₂, c₁₀,₁. */
function componentName({ name, words, kind }, label) {
  if (!/^\d[\d_]*$/.test(label)) return label;
  return (kind === "list" && name.length <= 12 ? words : name[0]) + lowered(label.replace("_", ","));
}
/** A number for a reader: 0.25, −3, 4.2·10⁻⁸. */
function shownNumber(x, digits = 5) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(x)) + 1e-12);
  const plain = exponent >= -4 && exponent < 6;
  const mantissa = Number((plain ? x : x / 10 ** exponent).toPrecision(digits));
  return String(mantissa).replace("-", "−") + (plain ? "" : "·10" + raised(exponent));
}

/** A few round values from low to high. */
function ticksOf(low, high, wanted) {
  const raw = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((m) => m * power >= raw * 0.999) * power;
  const out = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push(k * step);
  return out;
}

/** A curve is the list of its values where every row is there, otherwise the band between lowest and highest. */
const lowest = (curve) => curve.value || curve.low;
const highest = (curve) => curve.value || curve.high;

class Panel {
  /** @param view  what all panels share: times, the part that is seen, where the pointer is */
  constructor(view, { heading, unit: unitText, meaning, components, shown = components.map(() => true), log = false }) {
    Object.assign(this, { view, components, log, shown });
    this.element = document.createElement("figure");
    this.element.className = "card panel";
    const caption = document.createElement("figcaption"), title = document.createElement("h2");
    title.append(heading);
    this.note = document.createElement("span");
    this.note.className = "unit";
    this.unitText = unitText && unitText !== "1" && unitText !== heading ? ", " + unitText : "";
    title.append(this.note);
    title.title = meaning || "";
    const toggles = document.createElement("span");
    toggles.className = "toggles";
    this.readouts = components.map((component, i) => this.addToggle(toggles, component, i));
    caption.append(title, toggles);
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `${heading}${this.unitText}: curves over time`);
    this.element.append(caption, this.canvas);
    this.listen();
  }
  colour(i) { return "plot-" + (1 + (i % 6)); }
  addToggle(toggles, component, i) {
    const button = document.createElement("button"), key = document.createElement("span"), text = document.createElement("span");
    button.type = "button";
    button.setAttribute("aria-pressed", String(this.shown[i]));
    button.title = "Show or hide";
    key.className = i < 6 ? "key" : "key dashed";
    key.style.color = `var(--${this.colour(i)})`;
    button.append(key, text);
    button.addEventListener("click", () => {
      this.shown[i] = !this.shown[i];
      button.setAttribute("aria-pressed", String(this.shown[i]));
      this.view.changed();
    });
    toggles.append(button);
    return { text, label: component.label };
  }

  listen() {
    const timeAt = (event) => {
      const box = this.canvas.getBoundingClientRect(), { left, right } = this.frame();
      return this.view.from + Math.max(0, Math.min(1, (event.clientX - box.left - left) / (right - left))) * (this.view.to - this.view.from);
    };
    this.canvas.addEventListener("pointerdown", (event) => { this.view.drag = [timeAt(event), timeAt(event)]; this.canvas.setPointerCapture(event.pointerId); });
    this.canvas.addEventListener("pointermove", (event) => {
      this.view.pointer = timeAt(event);
      if (this.view.drag) this.view.drag[1] = this.view.pointer;
      this.view.changed();
    });
    this.canvas.addEventListener("pointerup", () => {
      if (!this.view.drag) return;
      const [a, b] = this.view.drag.sort((x, y) => x - y);
      this.view.drag = null;
      if (b - a > 0.01 * (this.view.to - this.view.from)) this.view.look(a, b); else this.view.go(a);
    });
    this.canvas.addEventListener("pointercancel", () => { this.view.drag = null; });
    this.canvas.addEventListener("pointerleave", () => { this.view.pointer = null; this.view.changed(); });
    this.canvas.addEventListener("dblclick", () => this.view.look(...this.view.whole));
  }

  frame() { return { left: 66, right: this.canvas.clientWidth - 14, top: 8, bottom: this.canvas.clientHeight - 24 }; }
  /** The values that are seen, with a little room. */
  range() {
    let low = Infinity, high = -Infinity;
    const [first, last] = this.view.indices();
    this.components.forEach(({ curve }, k) => {
      if (!this.shown[k]) return;
      for (let i = first; i <= last; ++i) {
        const a = lowest(curve)[i], b = highest(curve)[i];
        if (a !== null && a < low && (!this.log || a > 0)) low = a;
        if (b !== null && b > high) high = b;
      }
    });
    return low <= high ? [low, high] : [0, 1];
  }
  /** Ticks, their labels, and the way from a value to a height. */
  scaleOf({ top, bottom }) {
    let [low, high] = this.range(), datum = 0;
    if (this.log) {
      low = Math.log10(Math.max(low, 1e-20)) - 0.3;
      high = Math.max(Math.log10(Math.max(high, 1e-20)) + 0.3, low + 1);
      const every = Math.max(1, Math.ceil((high - low) / 5)), ticks = [];
      for (let k = Math.ceil(low); k <= high; ++k) if (k % every === 0) ticks.push(k);
      const y = (v) => bottom - ((Math.max(Math.log10(Math.max(v, 1e-300)), low) - low) / (high - low)) * (bottom - top);
      return { ticks: ticks.map((k) => [bottom - ((k - low) / (high - low)) * (bottom - top), "10" + raised(k)]), y, datum };
    }
    const size = Math.max(Math.abs(low), Math.abs(high));
    const rounding = high - low <= 2e-13 * size;
    if (rounding) { low -= 0.5 * (size || 1); high += 0.5 * (size || 1); }
    else if (high - low < 1e-3 * size) { datum = lowest(this.components[0].curve)[0]; low -= datum; high -= datum; }
    const room = 0.06 * (high - low);
    low -= room;
    high += room;
    const y = (v) => bottom - ((v - datum - low) / (high - low)) * (bottom - top);
    return { ticks: ticksOf(low, high, 4).map((v) => [y(v + datum), Math.abs(v) < 1e-9 * (high - low) ? "0" : shownNumber(v, 4)]), y, datum };
  }

  draw() {
    if (!fitCanvas(this.canvas)) return;
    const pen = this.canvas.getContext("2d"), frame = this.frame(), { left, right, top, bottom } = frame, view = this.view;
    const scaleY = this.scaleOf(frame), x = (t) => left + ((t - view.from) / (view.to - view.from)) * (right - left);
    pen.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    this.drawAxes(pen, frame, scaleY, x);
    pen.save();
    pen.beginPath();
    pen.rect(left, top - 2, right - left, bottom - top + 4);
    pen.clip();
    this.components.forEach(({ curve }, i) => { if (this.shown[i]) this.drawCurve(pen, curve, i, x, scaleY.y); });
    this.drawCursors(pen, frame, x);
    pen.restore();
    this.note.textContent = this.unitText + (scaleY.datum ? `  ${scaleY.datum < 0 ? "+" : "−"} ${shownNumber(Math.abs(scaleY.datum), 10)}` : "");
  }
  drawAxes(pen, { left, right, top, bottom }, { ticks }, x) {
    pen.font = "11.5px system-ui, sans-serif";
    pen.lineWidth = 1;
    pen.strokeStyle = ink.of("grid");
    pen.fillStyle = ink.of("quiet");
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    pen.beginPath();
    for (const [y, text] of ticks) {
      pen.moveTo(left, Math.round(y) + 0.5);
      pen.lineTo(right, Math.round(y) + 0.5);
      pen.fillText(text, left - 7, y);
    }
    pen.textAlign = "center";
    const times = ticksOf(this.view.from, this.view.to, Math.max(3, (right - left) / 110));
    for (const t of times) {
      pen.moveTo(Math.round(x(t)) + 0.5, top);
      pen.lineTo(Math.round(x(t)) + 0.5, bottom);
      const text = Math.abs(t) < 1e-9 * (this.view.to - this.view.from) ? "0" : shownNumber(t, 6), half = pen.measureText(text).width / 2;
      pen.fillText(text, Math.min(x(t), this.canvas.clientWidth - 4 - half), bottom + 13);
    }
    pen.stroke();
  }
  drawCurve(pen, curve, i, x, y) {
    const [first, last] = this.view.indices(), { from, to } = this.view.times;
    const colour = ink.of(this.colour(i)), low = lowest(curve), high = highest(curve);
    pen.lineJoin = "round";
    pen.setLineDash(i < 6 ? [] : [5, 3]);
    pen.beginPath();
    if (this.log) this.traceLargest(pen, curve.value, first, last, x, y);
    else for (let k = first; k <= last; ++k) if (low[k] !== null) pen.lineTo(x(from[k]), y(low[k]));
    if (!curve.value) {
      // The band: along its lower edge and back along the upper one.
      for (let k = last; k >= first; --k) if (high[k] !== null) pen.lineTo(x(to[k]), y(high[k]));
      pen.closePath();
      pen.fillStyle = ink.of(this.colour(i), 0.35);
      pen.fill();
    }
    pen.strokeStyle = colour;
    pen.lineWidth = curve.value ? 1.6 : 1;
    pen.stroke();
    pen.setLineDash([]);
  }
  /** The largest in every three pixels: rounding errors that come and go would hatch the panel otherwise. */
  traceLargest(pen, values, first, last, x, y) {
    const { from } = this.view.times;
    for (let k = first; k <= last;) {
      const end = x(from[k]) + 3;
      let largest = k;
      for (; k <= last && x(from[k]) < end; ++k) if (values[k] > values[largest]) largest = k;
      if (values[largest] > 0) pen.lineTo(x(from[largest]), y(values[largest]));
    }
  }
  drawCursors(pen, { top, bottom, left, right }, x) {
    const line = (t, colour, dash) => {
      pen.strokeStyle = colour;
      pen.lineWidth = 1.2;
      pen.setLineDash(dash);
      pen.beginPath();
      pen.moveTo(x(t), top);
      pen.lineTo(x(t), bottom);
      pen.stroke();
      pen.setLineDash([]);
    };
    const { drag, pointer, now } = this.view;
    if (drag) {
      pen.fillStyle = ink.of("accent", 0.15);
      pen.fillRect(x(Math.min(...drag)), top, Math.abs(x(drag[1]) - x(drag[0])), bottom - top);
    }
    if (now !== null) line(now, ink.of("text", 0.75), []);
    if (pointer !== null) line(pointer, ink.of("quiet", 0.8), [3, 3]);
    this.read(pointer !== null ? pointer : now);
  }
  /** The values at a time, in the toggles. */
  read(t) {
    this.readouts.forEach(({ text, label }, i) => {
      const { curve } = this.components[i], said = label ? label + " " : "";
      if (t === null) { text.textContent = label || "value"; return; }
      const [k, s] = bracket(this.view.times.from, t), nearest = s > 0.5 ? k + 1 : k;
      text.textContent = curve.value ? said + shownNumber(curve.value[nearest]) : `${said}${shownNumber(curve.low[k], 3)} … ${shownNumber(curve.high[k], 3)}`;
    });
  }
}
