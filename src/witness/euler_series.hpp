// The free body by power series in the time, in any number of digits: the reference solution for everything
// that moves one faster.
//
// Euler's equations M' = M x omega and q' = q (0, omega)/2, omega = M/I, are of second degree: each
// coefficient is a sum of products of the ones before it. Nothing here knows of orbits, half turns or
// elliptic functions.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

#include "actio/numbers/errors.hpp"
#include "actio/numbers/scalar.hpp"

namespace actio {

/// Body momentum and attitude, in the scalars of the series.
template <Real S>
struct EulerState {
  Eigen::Matrix<S, 3, 1> momentum;  ///< energy x time
  Eigen::Matrix<S, 4, 1> attitude;  ///< quaternion, scalar first, body to space
};

/// The state after `duration`, by power series whose remainder is below rounding.
///
/// @param moments   principal moments of inertia
/// @param start     state at time 0
/// @param duration  time; negative to go back
/// @throws NotFinite  where a number is none
/// Accuracy: a few epsilon for each series, of which there is about one for each radian, magnified as the
/// motion magnifies errors.
template <Real S>
EulerState<S> euler_series(Eigen::Matrix<S, 3, 1> const& moments, EulerState<S> start, S const& duration) {
  using std::exp, std::log;
  if (!is_finite(start.momentum) || !is_finite(start.attitude) || !is_finite(duration))
    throw NotFinite("euler_series");
  int const terms = std::max(16, static_cast<int>(1.2 * std::numeric_limits<S>::digits10));
  std::vector<Eigen::Matrix<S, 3, 1>> M(terms + 1), omega(terms + 1);
  std::vector<Eigen::Matrix<S, 4, 1>> q(terms + 1);
  S reached(0);
  while (reached != duration) {
    M[0] = start.momentum, q[0] = start.attitude;
    for (int n = 0; n < terms; ++n) {
      omega[n] = M[n].cwiseQuotient(moments);
      Eigen::Matrix<S, 3, 1> torque = Eigen::Matrix<S, 3, 1>::Zero();
      Eigen::Matrix<S, 4, 1> turn = Eigen::Matrix<S, 4, 1>::Zero();
      for (int k = 0; k <= n; ++k) {
        auto const& m = M[k];
        auto const& p = q[k];
        auto const& w = omega[n - k];
        for (int i = 0; i < 3; ++i) {
          int const j = (i + 1) % 3, l = (i + 2) % 3;
          torque[i] += m[j] * w[l] - m[l] * w[j];
          turn[1 + i] += p[0] * w[i] + p[1 + j] * w[l] - p[1 + l] * w[j];
          turn[0] -= p[1 + i] * w[i];
        }
      }
      M[n + 1] = torque / S(n + 1), q[n + 1] = turn / S(2 * n + 2);
    }
    // As far as the last two terms stay below rounding.
    S const rest = duration - reached;
    S step = magnitude(rest);
    for (int n = terms - 1; n <= terms; ++n) {
      S const last = std::max(S(magnitude(M[n]) / magnitude(M[0])), S(magnitude(q[n]) / magnitude(q[0])));
      if (last > S(0)) step = std::min(step, S(exp(S((log(S(epsilon<S>())) - log(last)) / S(n)))));
    }
    bool const whole = step == magnitude(rest);
    S const t = rest < S(0) ? S(-step) : step;
    start = {M[terms], q[terms]};
    for (int n = terms; n-- > 0;)
      start.momentum = (start.momentum * t + M[n]).eval(),
      start.attitude = (start.attitude * t + q[n]).eval();
    if (!is_finite(start.momentum) || !is_finite(start.attitude)) throw NotFinite("euler_series");
    reached = whole ? duration : S(reached + t);
  }
  return start;
}

}  // namespace actio
