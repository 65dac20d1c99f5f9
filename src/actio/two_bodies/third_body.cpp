#include "actio/two_bodies/third_body.hpp"

namespace actio::bodies {

PointMotion<double> at_pericentre(OrbitElements const& orbit, double mu) {
  double const a = orbit.half_axis, e = orbit.eccentricity;
  for (double const x : {a, e, orbit.inclination, orbit.node, orbit.pericentre, orbit.time, mu})
    if (!is_finite(x)) throw NotFinite("orbit: element");
  if (e < 0) throw OutsideDomain("orbit", "the eccentricity must not be negative", e, 0);
  if (!(a * (1 - e) > 0))
    throw OutsideDomain("orbit",
                        "the half axis must be positive on an ellipse, negative on a hyperbola; a (1 - e)",
                        a * (1 - e), 0);
  double const near = a * (1 - e), speed = std::sqrt(mu * (1 + e) / near);
  double const cn = std::cos(orbit.node), sn = std::sin(orbit.node), ci = std::cos(orbit.inclination),
               si = std::sin(orbit.inclination), cp = std::cos(orbit.pericentre),
               sp = std::sin(orbit.pericentre);
  Three<double> const P{cn * cp - sn * sp * ci, sn * cp + cn * sp * ci, sp * si},
      Q{-cn * sp - sn * cp * ci, -sn * sp + cn * cp * ci, cp * si};
  return {{near * P[0], near * P[1], near * P[2]}, {speed * Q[0], speed * Q[1], speed * Q[2]}};
}

ThirdBody third_body(double mass, OrbitElements const& orbit, double inner, double G) {
  if (!(mass > 0) || !is_finite(mass))
    throw OutsideDomain("third body", "the mass must be positive", mass, 0);
  double const mu = G * (mass + inner);
  return {mass, at_pericentre(orbit, mu), orbit.time, mu};
}

}  // namespace actio::bodies
