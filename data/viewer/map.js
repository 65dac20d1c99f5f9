// A field on the sphere at the times of its snapshots, in colours: the whole sphere in the projection of
// Mollweide, which keeps areas, or a globe; or a field on a flat torus. At each moment it is the last snapshot
// before it.

/** Colours from blue for the most negative over nearly white to red, in 1023 steps. */
const signedColours = (() => {
  const [blue, none, red] = [[24, 80, 150], [244, 244, 240], [176, 48, 24]];
  return Array.from({ length: 1023 }, (_, i) => mix(none, i < 511 ? blue : red, Math.abs(i / 511 - 1) ** 0.75));
})();

/** The cubic through four values that passes the middle two with the slopes of their neighbours. */
const cubic = (a, b, c, d, s) => b + 0.5 * s * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a)));

class MapView extends Stage {
  /** @param maps  times of the snapshots, their values as pictures in grey, the largest modulus, and whether they are flat: then the lowest row first */
  constructor(canvas, maps, changed) {
    super(canvas, { changed, azimuth: Math.PI, elevation: 0.35 });
    Object.assign(this, { maps, shown: maps.flat ? {} : { net: true }, colours: { net: "quiet" }, at: -1, values: null, globe: false, drawn: "" });
    if (!maps.flat) this.choices = [{ label: "projection", title: "What is seen of the sphere", options: ["whole sphere", "globe"], choose: (k) => { this.globe = k === 1; } }];
  }
  /** The values of a snapshot, from the shades of its picture. */
  load(at) {
    this.at = at;
    const picture = document.createElement("img");
    picture.onload = () => {
      if (this.at !== at) return;
      const sheet = document.createElement("canvas");
      const [columns, rows] = [(sheet.width = picture.naturalWidth), (sheet.height = picture.naturalHeight)];
      const pen = sheet.getContext("2d");
      pen.drawImage(picture, 0, 0);
      const { data } = pen.getImageData(0, 0, columns, rows), values = new Float32Array(rows * columns);
      for (let k = 0; k < values.length; ++k) values[k] = data[4 * k] - 127;
      this.values = { rows, columns, values };
      this.drawn = "";
      this.changed();
    };
    picture.src = "data:image/png;base64," + this.maps.pictures[at];
  }
  /** From -127 to 127, cubic between the points of the grid, across the poles as well; at a place of the grid. */
  valueAt(down, right) {
    const { rows, columns, values } = this.values, { flat } = this.maps, i = Math.floor(down), j = Math.floor(right);
    const row = (k) => {
      const over = !flat && (k < 0 || k >= rows), inside = flat ? (k + rows) % rows : over ? (k < 0 ? -1 - k : 2 * rows - 1 - k) : k;
      const start = inside * columns, from = j + (over ? columns / 2 : 0) + 2 * columns;
      const value = (l) => values[start + ((from + l) % columns)];
      return cubic(value(-1), value(0), value(1), value(2), right - j);
    };
    return cubic(row(i - 1), row(i), row(i + 1), row(i + 2), down - i);
  }
  /** Where a point of the picture, in [-1, 1] x [-1, 1], is in the grid; nothing beyond the rim. */
  inGrid(x, y) {
    const { rows, columns } = this.values;
    if (this.maps.flat) return [((y + 1) / 2) * rows, ((this.azimuth + Math.PI * x) / (2 * Math.PI)) * columns];
    const at = this.onSphere(x, y);
    return at && [(at[0] / Math.PI) * rows - 0.5, (at[1] / (2 * Math.PI)) * columns];
  }
  /** Colatitude and longitude of a point of the picture. */
  onSphere(x, y) {
    if (!this.globe) {
      const c = Math.sqrt(1 - y * y);
      if (Math.abs(x) > c) return null;
      const a = Math.asin(y);
      return [Math.PI / 2 - Math.asin((2 * a + Math.sin(2 * a)) / Math.PI), this.azimuth + (Math.PI * x) / (c || 1)];
    }
    const square = x * x + y * y;
    if (square > 1) return null;
    const z = Math.sqrt(1 - square), s = Math.sin(this.elevation), c = Math.cos(this.elevation);
    return [Math.acos(Math.max(-1, Math.min(1, y * c + z * s))), this.azimuth + Math.atan2(x, z * c - y * s)];
  }
  /** Where a latitude and a longitude from the middle are in the picture; nothing on the other side of a globe. */
  inPicture(latitude, from) {
    if (this.globe) {
      const s = Math.sin(this.elevation), c = Math.cos(this.elevation), out = Math.cos(latitude) * Math.cos(from), up = Math.sin(latitude);
      return out * c + up * s < 0 ? null : [Math.cos(latitude) * Math.sin(from), up * c - out * s];
    }
    let a = latitude;
    for (let k = 0; k < 30 && Math.abs(latitude) < 1.57; ++k) a -= (2 * a + Math.sin(2 * a) - Math.PI * Math.sin(latitude)) / (2 + 2 * Math.cos(2 * a));
    return [(from / Math.PI) * Math.cos(a), Math.sin(a)];
  }
  /** The colours, on a sheet of their own; it is made anew where the moment or the view has changed. */
  paintSheet(width, height) {
    const kind = [this.at, this.globe, this.azimuth, this.globe && this.elevation, width, height].join();
    if (kind === this.drawn || !this.values) return;
    this.drawn = kind;
    this.sheet = document.createElement("canvas");
    Object.assign(this.sheet, { width, height });
    const pen = this.sheet.getContext("2d"), image = pen.createImageData(width, height);
    for (let i = 0, k = 0; i < height; ++i)
      for (let j = 0; j < width; ++j, k += 4) {
        // A little of the rim is painted twice, so that the outline falls on colours.
        const x = (2 * j + 1) / width - 1, y = 1 - (2 * i + 1) / height, at = this.inGrid(x, y) || this.inGrid(0.992 * x, 0.992 * y);
        if (!at) continue;
        const colour = signedColours[Math.round(511 + Math.max(-511, Math.min(511, (511 / 127) * this.valueAt(...at))))];
        for (let c = 0; c < 3; ++c) image.data[k + c] = colour[c];
        image.data[k + 3] = 255;
      }
    pen.putImageData(image, 0, 0);
  }
  draw({ t }) {
    const { times } = this.maps, near = 1e-9 * (times[times.length - 1] - times[0]);
    let at = 0;
    while (at + 1 < times.length && times[at + 1] <= t + near) ++at;
    if (at !== this.at) this.load(at);
    if (!fitCanvas(this.canvas)) return;
    const pen = this.canvas.getContext("2d"), { clientWidth, clientHeight } = this.canvas, shape = this.globe || this.maps.flat ? 1 : 2;
    const height = Math.min(clientHeight - 64, (clientWidth - 24) / shape), width = shape * height, x = clientWidth / 2, y = 12 + height / 2;
    pen.clearRect(0, 0, clientWidth, clientHeight);
    if (!this.values || !(height > 0)) return;
    const fine = Math.min(window.devicePixelRatio || 1, 1000 / width);
    this.paintSheet(Math.round(fine * width), Math.round(fine * height));
    const rim = () => {
      pen.beginPath();
      if (this.maps.flat) pen.rect(x - width / 2, y - height / 2, width, height);
      else pen.ellipse(x, y, width / 2, height / 2, 0, 0, 2 * Math.PI);
    };
    pen.save();
    rim();
    pen.clip();
    pen.drawImage(this.sheet, x - width / 2, y - height / 2, width, height);
    pen.restore();
    if (this.shown.net) this.drawNet(pen, x, y, width, height);
    rim();
    pen.strokeStyle = ink.of("quiet");
    pen.lineWidth = 1.2;
    pen.stroke();
    this.drawBar(pen, x, y + height / 2 + 14, Math.min(280, 0.6 * clientWidth));
  }
  /** Parallels and meridians, 30 degrees apart. */
  drawNet(pen, x, y, width, height) {
    const step = Math.PI / 6, along = (pieces, place) => {
      let on = false;
      for (let k = 0; k <= pieces; ++k) {
        const p = this.inPicture(...place(k / pieces));
        if (p) pen[on ? "lineTo" : "moveTo"](x + (p[0] * width) / 2, y - (p[1] * height) / 2);
        on = Boolean(p);
      }
    };
    pen.beginPath();
    for (let k = -2; k <= 2; ++k) along(72, (s) => [k * step, (2 * s - 1) * Math.PI]);
    // Meridians turn with the sphere.
    const turned = (longitude) => Math.PI - ((((Math.PI - longitude + this.azimuth) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI));
    for (let k = 0; k < 12; ++k) along(48, (s) => [(s - 0.5) * Math.PI, turned(k * step)]);
    pen.strokeStyle = "rgba(20,24,28,0.17)";
    pen.lineWidth = 0.8;
    pen.stroke();
  }
  drawBar(pen, x, y, width) {
    for (let k = 0; k < 128; ++k) {
      pen.fillStyle = ink.text(signedColours[8 * k]);
      pen.fillRect(x - width / 2 + (k * width) / 128, y, width / 128 + 0.5, 9);
    }
    pen.font = "12px system-ui, sans-serif";
    pen.fillStyle = ink.of("text");
    pen.textAlign = "center";
    pen.textBaseline = "alphabetic";
    for (const [text, share] of [[shownNumber(-this.maps.largest, 3), 0], ["vorticity", 0.5], [shownNumber(this.maps.largest, 3), 1]]) pen.fillText(text, x + (share - 0.5) * width, y + 24);
  }
}
