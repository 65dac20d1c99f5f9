// The clock of the page: plays, stops, goes to a time.

class Player {
  /** @param shown  called with the time whenever it changes */
  constructor(motion, timeUnit, shown) {
    Object.assign(this, { motion, timeUnit, shown, time: motion.from, playing: false, speed: 1, again: false });
    this.button = document.getElementById("play");
    this.scrubber = document.getElementById("scrubber");
    this.clock = document.getElementById("clock");
    this.choice = document.getElementById("speed");
    this.scrubber.min = motion.from;
    this.scrubber.max = motion.to;
    for (const speed of Player.speeds) {
      const option = document.createElement("option");
      option.value = String(speed);
      option.textContent = (speed < 1 ? { 0.125: "⅛", 0.25: "¼", 0.5: "½" }[speed] : speed) + " ×";
      option.selected = speed === 1;
      this.choice.append(option);
    }
    this.choice.addEventListener("change", () => { this.speed = Number(this.choice.value); });
    this.button.addEventListener("click", () => this.toggle());
    this.scrubber.addEventListener("input", () => this.go(Number(this.scrubber.value)));
    document.addEventListener("keydown", (event) => this.key(event));
    this.say();
  }
  static speeds = [0.125, 0.25, 0.5, 1, 2, 4, 8];

  toggle(playing = !this.playing) {
    this.playing = playing;
    if (playing && this.time >= this.motion.to) this.time = this.motion.from;
    this.last = null;
    this.say();
  }
  go(t) {
    this.time = Math.min(this.motion.to, Math.max(this.motion.from, t));
    this.say();
    this.shown(this.time);
  }
  changeSpeed(by) {
    const at = Player.speeds.indexOf(this.speed) + by;
    if (at < 0 || at >= Player.speeds.length) return;
    this.speed = Player.speeds[at];
    this.choice.value = String(this.speed);
  }
  key(event) {
    if (event.altKey || event.ctrlKey || event.metaKey || event.target === this.choice) return;
    const whole = this.motion.to - this.motion.from, step = (event.shiftKey ? 0.1 : 0.01) * whole;
    const does = {
      " ": () => { if (event.target.tagName === "BUTTON") return false; this.toggle(); },
      ArrowLeft: () => this.go(this.time - step), ArrowRight: () => this.go(this.time + step),
      Home: () => this.go(this.motion.from), End: () => this.go(this.motion.to),
      "[": () => this.changeSpeed(-1), "]": () => this.changeSpeed(1),
    }[event.key];
    if (does && does() !== false) event.preventDefault();
  }
  /** To be called for each frame, with the milliseconds of the screen. */
  frame(milliseconds) {
    if (!this.playing) return;
    const passed = this.last === null ? 0 : Math.min(0.1, (milliseconds - this.last) / 1000);
    this.last = milliseconds;
    const t = this.time + passed * this.speed * this.motion.pace;
    if (t >= this.motion.to && !this.again) this.toggle(false);
    this.go(t >= this.motion.to && this.again && this.time >= this.motion.to ? this.motion.from : t);
  }
  say() {
    const icon = this.playing ? "M2 1h4v14H2zM10 1h4v14h-4z" : "M3 1l11 7-11 7z";
    if (this.icon !== icon) {
      this.button.innerHTML = `<svg viewBox="0 0 16 16" aria-hidden="true"><path d="${icon}"/></svg>`;
      this.button.setAttribute("aria-label", this.playing ? "Pause" : "Play");
      this.icon = icon;
    }
    const text = `t = ${fixedLike(this.time, this.motion.to - this.motion.from)}${this.timeUnit ? " " + this.timeUnit : ""}`;
    this.clock.textContent = text;
    this.scrubber.value = String(this.time);
    this.scrubber.setAttribute("aria-valuetext", text);
  }
}

/** A time with as many digits as it takes to tell a thousandth of the whole, so that the text does not jump about. */
function fixedLike(t, whole) {
  const exponent = Math.floor(Math.log10(whole));
  if (exponent >= 6 || exponent < -3) return (t / 10 ** exponent).toFixed(3) + "·10" + raised(exponent);
  return t.toFixed(Math.max(0, 3 - exponent));
}
