// Torques on a body that depend on its angular velocity, and kicks by them.
//
// A kick holds attitude and time, and the momentum obeys dM/ds = tau(q, t, I^-1 M). Where the torque does not
// depend on the velocity it is a sum; here it is taken by the method of Gauss with two stages, of order 4,
// which is its own inverse when s changes its sign. So a splitting with such kicks has its order up to 4.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include "actio/fast_body/space/middle_axis_frame.hpp"
#include "actio/numbers/errors.hpp"

namespace actio::bodies {

/// A torque that depends on the velocity: a function of attitude, time, angular velocity and middle of the
/// step.
///
/// \snippet bodies.cpp velocity_torque
///
/// Torque and angular velocity are in the frame of the body, energy and 1/time. What is held over a step has
/// its value in the middle of the step.
template <class T>
concept TorqueOfVelocity =
    requires(T const& torque, Four<double> const& q, double t, Three<double> const& w) {
      { torque(q, t, w, t) } -> std::convertible_to<Three<double>>;
    };

namespace detail {

/// Such a torque in the axes in which the body is moved, as a function of the momentum that is moved.
template <class Torque>
struct TorqueOfMomentum {
  Torque torque;                                  ///< in the frame of the body
  MiddleAxisFrame frame;                          ///< the axes
  std::array<Three<double>, 3> velocity_of = {};  ///< the rows of the map from the momentum to the velocity

  Three<double> operator()(Four<double> const& q, double time, Three<double> const& p, double middle) const {
    Eigen::Vector4d const outside = frame.leave(q);
    Three<double> w;
    for (std::size_t i = 0; i < 3; ++i) w[i] = dot(velocity_of[i], p);
    Three<double> const t =
        torque(Four<double>{outside[0], outside[1], outside[2], outside[3]}, time, w, middle);
    return frame.enter(Eigen::Vector3d(t[0], t[1], t[2]));
  }
};

/// The momentum after dp/ds = c f(p) over a unit of s, by Gauss' method with two stages.
/// @throws OutsideDomain  where the iteration for the stages does not contract: c is too long for the torque
/// @throws NotFinite      where the torque is no number
template <class Torque>
Three<double> gauss_kick(Torque const& f, double c, Three<double> const& p) {
  double const off = std::sqrt(3.0) / 6, least = 4 * std::numeric_limits<double>::epsilon();
  double const a[2][2] = {{0.25, 0.25 - off}, {0.25 + off, 0.25}};
  Three<double> slope[2] = {f(p), {}};
  slope[1] = slope[0];
  double before = HUGE_VAL, factor = 0;
  for (int k = 0; k < 100; ++k) {
    Three<double> next[2];
    double change = 0, size = 0;
    for (int s = 0; s < 2; ++s) {
      Three<double> stage = p;
      for (std::size_t i = 0; i < 3; ++i) stage[i] += c * (a[s][0] * slope[0][i] + a[s][1] * slope[1][i]);
      next[s] = f(stage);
      if (!std::isfinite(dot(next[s], next[s]))) throw NotFinite("torqued body: torque");
      for (std::size_t i = 0; i < 3; ++i) {
        change = std::max(change, std::abs(c * (next[s][i] - slope[s][i])));
        size = std::max({size, std::abs(stage[i]), std::abs(c * next[s][i])});
      }
    }
    slope[0] = next[0], slope[1] = next[1];
    // Rounding ends the iteration where it is as small as that of a product of a few roundings.
    if (change <= least * size || (change <= 64 * least * size && change >= before)) {
      Three<double> end = p;
      for (std::size_t i = 0; i < 3; ++i) end[i] += c * (slope[0][i] + slope[1][i]) / 2;
      return end;
    }
    factor = change / before, before = change;
    if (k > 8 && !(factor < 1)) break;
  }
  throw OutsideDomain(
      "torqued body",
      "the step is too long for how the torque depends on the velocity, or the torque jumps: from "
      "one iteration to the next the change must shrink; factor",
      factor, 1);
}

}  // namespace detail

}  // namespace actio::bodies
