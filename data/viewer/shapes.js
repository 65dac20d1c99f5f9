// What a body looks like: its own parts where the catalogue knows them, otherwise a box or an ellipsoid with
// the same principal moments. A shape is a list of faces in the frame of the scene, each with points, outward
// normal and colour; sizes are in the unit of the scene.

/** Squared radii of gyration along the principal axes: (I2 + I3 - I1) / 2 and so on, per unit of mass. */
function spreads(body) {
  const [a, b, c] = body.moments, mass = body.top ? body.top.mass : body.mass || 1;
  return [b + c - a, c + a - b, a + b - c].map((x) => Math.max(0, x) / 2 / mass);
}
/** Half the sides of the box, or the semi-axes of the ellipsoid; a plate keeps a little thickness, to be seen. */
function halfSizes(body, factor) {
  const sizes = spreads(body).map((x) => Math.sqrt(factor * x)), largest = Math.max(...sizes);
  return sizes.map((x) => Math.max(x, 0.025 * largest));
}
/** The axes to show: those of the frame where they are principal, so that they have the colours of the components; otherwise the principal ones. */
function namedAxes(body) {
  const along = (axis) => axis.findIndex((x) => Math.abs(x) > 1 - 1e-9);
  const framed = body.axes.every((axis) => along(axis) >= 0);
  return body.axes.map((axis, i) => {
    const k = framed ? along(axis) : i;
    return { axis: framed ? scale(Math.sign(axis[k]), axis) : axis, name: framed ? "xyz"[k] : String(i + 1), colour: "plot-" + (k + 1) };
  });
}
const outOf = (axes, p) => add(add(scale(p[0], axes[0]), scale(p[1], axes[1])), scale(p[2], axes[2]));

/** A box of uniform density has sides s with s^2 / 12 as its squared radius of gyration. */
function box(body) {
  const half = halfSizes(body, 3), cuts = 6, faces = [], named = namedAxes(body);
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [-1, 1])
      for (let i = 0; i < cuts; ++i)
        for (let j = 0; j < cuts; ++j) {
          const corner = (u, v) => {
            const p = [0, 0, 0];
            p[axis] = side * half[axis];
            p[(axis + 1) % 3] = (2 * u / cuts - 1) * half[(axis + 1) % 3];
            p[(axis + 2) % 3] = (2 * v / cuts - 1) * half[(axis + 2) % 3];
            return outOf(body.axes, p);
          };
          faces.push({ points: [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)], normal: scale(side, body.axes[axis]), colour: [named[axis].colour, side > 0 ? 0.5 : 0.22] });
        }
  return faces;
}

/** A solid ellipsoid has a^2 / 5 as its squared radius of gyration along each semi-axis. */
function ellipsoid(body) {
  return rounded(halfSizes(body, 5), body.axes, [0, 0, 0], (latitude, longitude) => ["plot-1", (Math.floor(latitude / 3) + Math.floor(longitude / 4)) % 2 ? 0.12 : 0.42]);
}
function rounded(semi, axes, at, colour, latitudes = 18, longitudes = 32) {
  const faces = [];
  const point = (i, j, by) => {
    const a = (i / latitudes) * Math.PI, b = (j / longitudes) * 2 * Math.PI;
    const p = [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)];
    return outOf(axes, p.map((x, k) => by(x, semi[k])));
  };
  for (let i = 0; i < latitudes; ++i)
    for (let j = 0; j < longitudes; ++j) {
      const onto = (u, v) => add(at, point(u, v, (x, s) => x * s));
      const points = i === 0 ? [onto(0, 0), onto(1, j), onto(1, j + 1)] : [onto(i, j), onto(i + 1, j), onto(i + 1, j + 1), onto(i, j + 1)];
      faces.push({ points, normal: unit(point(i + 0.5, j + 0.5, (x, s) => x / s)), colour: colour(i, j) });
    }
  return faces;
}

function cylinder(part, colour) {
  const around = 48, rings = Math.max(2, Math.round((1.5 * part.length) / part.radius)), faces = [];
  const [a, b] = frameAbout(part.along);
  const out = (j) => add(scale(Math.cos((2 * Math.PI * j) / around), a), scale(Math.sin((2 * Math.PI * j) / around), b));
  const point = (i, j, r = part.radius) => add(add(part.at, scale(part.length * (i / rings - 0.5), part.along)), scale(r, out(j)));
  for (let j = 0; j < around; ++j) {
    for (let i = 0; i < rings; ++i) faces.push({ points: [point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i + 1, j)], normal: out(j + 0.5), colour });
    for (const end of [0, rings])
      for (let k = 0; k < 3; ++k) {
        const [r, s] = [(k * part.radius) / 3, ((k + 1) * part.radius) / 3];
        faces.push({ points: [point(end, j, r), point(end, j, s), point(end, j + 1, s), point(end, j + 1, r)], normal: scale(end ? 1 : -1, part.along), colour });
      }
  }
  return faces;
}

const ownAxes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
/** Cylinders, or point masses as balls on thin rods from the centre of mass. */
function parts(body) {
  return body.parts.flatMap((part, i) => {
    const colour = ["plot-" + (1 + (i % 2)), 0.5];
    if (part.cylinder) return cylinder(part, colour);
    const ball = rounded([part.radius, part.radius, part.radius], ownAxes, part.at, () => (i === 0 ? ["plot-2", 0.6] : ["plot-1", 0.35]), 14, 22);
    if (norm(part.at) < part.radius) return ball;
    return ball.concat(cylinder({ at: scale(0.5, part.at), along: unit(part.at), length: norm(part.at), radius: 0.18 * part.radius }, ["plot-6", 0.3]));
  });
}

/** The shapes that a body can be shown in, by name, the best first; brought to size one, a top with its fixed point at the origin. */
function shapesOf(body) {
  const symmetric = body.moments.some((m, i) => Math.abs(m - body.moments[(i + 1) % 3]) < 1e-6 * m);
  const made = body.parts.length ? { "its parts": parts(body) } : {};
  const likely = symmetric ? ["ellipsoid", "box"] : ["box", "ellipsoid"];
  for (const name of likely) made[name] = name === "box" ? box(body) : ellipsoid(body);
  const offset = body.top ? body.top.centre_of_mass : [0, 0, 0];
  return Object.entries(made).map(([name, faces]) => {
    const moved = faces.map((f) => ({ ...f, points: f.points.map((p) => add(p, offset)) }));
    const reach = Math.max(...moved.flatMap((f) => f.points.map(norm)));
    return { name, size: 1 / reach, faces: moved.map((f) => ({ ...f, points: f.points.map((p) => scale(1 / reach, p)) })) };
  });
}
