// Vectors, and unit quaternions (scalar first) that turn them.
"use strict";

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scale = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => (norm(a) > 0 ? scale(1 / norm(a), a) : [0, 0, 0]);
const mix = (a, b, s) => a.map((x, i) => x + s * (b[i] - x));

/** Two unit vectors that make a right-handed frame with a third. */
function frameAbout(axis) {
  const a = unit(axis);
  const helper = Math.abs(a[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const right = unit(cross(helper, a));
  return [right, cross(a, right)];
}

/** v turned by q. */
function turned(q, v) {
  const t = scale(2, cross(q.slice(1), v));
  return add(add(v, scale(q[0], t)), cross(q.slice(1), t));
}
const inverse = (q) => [q[0], -q[1], -q[2], -q[3]];

/** The angle between two attitudes. */
function angleBetween(p, q) {
  const cosine = Math.abs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3]);
  return 2 * Math.acos(Math.min(1, cosine));
}

/** The angle between two vectors of any length; none where one of them is zero. */
function angleOfDirections(a, b) {
  const lengths = Math.hypot(...a) * Math.hypot(...b);
  return lengths > 0 ? Math.acos(Math.max(-1, Math.min(1, a.reduce((sum, x, i) => sum + x * b[i], 0) / lengths))) : 0;
}

/** The unit quaternion of a rotation matrix, from its largest component. */
function quaternionOf(R) {
  const [[a, b, c], [d, e, f], [g, h, i]] = R;
  const squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i];
  const k = squares.indexOf(Math.max(...squares));
  const q = [[squares[0], h - f, c - g, d - b], [h - f, squares[1], b + d, c + g], [c - g, b + d, squares[2], f + h], [d - b, c + g, f + h, squares[3]]][k];
  const length = Math.hypot(...q);
  return q.map((x) => x / length);
}

/** From p to q at constant angular velocity, the shorter way. */
function slerp(p, q, s) {
  const product = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
  const sign = product < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(product)));
  const a = angle < 1e-4 ? 1 - s : Math.sin((1 - s) * angle) / Math.sin(angle);
  const b = sign * (angle < 1e-4 ? s : Math.sin(s * angle) / Math.sin(angle));
  const out = p.map((x, i) => a * x + b * q[i]);
  const length = Math.hypot(...out);
  return out.map((x) => x / length);
}

/** The last index whose time is not after t, and how far t is from there to the next, from 0 to 1. */
function bracket(times, t) {
  let low = 0, high = times.length - 1;
  while (low + 1 < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle; else high = middle;
  }
  if (times.length < 2) return [0, 0];
  return [low, Math.min(1, Math.max(0, (t - times[low]) / (times[low + 1] - times[low])))];
}
