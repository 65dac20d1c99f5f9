// How near two bodies come to each other between the two ends of a drift.
//
// The way of a drift is known exactly, a straight line or an orbit of Kepler. The distance on it is least at
// one of its ends, or where it stops falling: at the foot of the perpendicular, or in the pericentre.
#pragma once

#include <limits>

#include "actio/two_bodies/kepler_drift.hpp"
#include "actio/two_bodies/rotor_drift.hpp"

namespace actio::bodies::detail {

/// Whether a drift may pass a point where the distance is least; cheap, and never wrongly no.
/// @param x,v    position and velocity at its start
/// @param y,w    those at its end
/// @param time   that it takes, of any sign
/// @param kepler whether it follows an orbit of Kepler, with this mu; otherwise it is straight
[[gnu::always_inline]] inline bool may_pass_the_nearest(Three<double> const& x, Three<double> const& v,
                                                        Three<double> const& y, Three<double> const& w,
                                                        double time, bool kepler, double mu) {
  if (time * dot(x, v) < 0 && time * dot(y, w) >= 0) return true;
  if (!kepler) return false;
  // Otherwise it takes more than half a period, pi (a^3/mu)^(1/2), of an ellipse, where r < 2a.
  double const square = dot(x, x), most = 0.8106 * mu * time * time;  // 8/pi^2 = 0.81057
  return most * most > square * square * square;
}

/// The square of the distance in the pericentre, where a drift along an orbit of Kepler passes it; otherwise
/// infinity. The ends are not looked at. Parameters as above.
/// Accuracy: a few epsilon of the size of the orbit.
[[gnu::noinline, gnu::cold]] inline double square_in_pericentre(Three<double> const& x,
                                                                Three<double> const& v,
                                                                Three<double> const& y,
                                                                Three<double> const& w, double time,
                                                                double mu) {
  double const r = std::sqrt(dot(x, x)), t = std::abs(time), beta = 2 * mu / r - dot(v, v),
               half = beta > 0 ? M_PI * mu / (beta * std::sqrt(beta)) : HUGE_VAL;
  bool const falls = time * dot(x, v) < 0, rises = time * dot(y, w) >= 0;
  // From falling to rising by the pericentre alone; from rising to falling by the apocentre alone, or all the
  // way around; otherwise all of the half is passed in which the sign is the other one.
  bool const passed = falls && rises ? true : !falls && !rises ? t > 2 * half : t > half;
  if (!passed) return std::numeric_limits<double>::infinity();
  Three<double> const h = cross_product(x, v);
  Three<double> e = cross_product(v, h);  // Laplace's vector
  for (int i = 0; i < 3; ++i) e[i] = e[i] / mu - x[i] / r;
  double const q = dot(h, h) / mu / (1 + std::sqrt(dot(e, e)));
  return q * q;
}

/// The square of the distance at the foot of the perpendicular of a straight line.
[[gnu::noinline, gnu::cold]] inline double square_at_foot(Three<double> const& x, Three<double> const& v) {
  Three<double> const h = cross_product(x, v);
  return dot(h, h) / dot(v, v);
}

}  // namespace actio::bodies::detail
