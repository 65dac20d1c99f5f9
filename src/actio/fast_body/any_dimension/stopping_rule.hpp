// When a step on SO(n) by sweeps is done, and how many squares it will take from a given guess.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "actio/fast_body/any_dimension/relative_motion_sweeps.hpp"

namespace actio::bodies {

/// How far a step on SO(n) goes in solving its equation.
enum class Sweeps {
  /// until the relative motion is a rotation to the rounding of its entries: the fewest squares
  to_rounding,
  /// Until the residual is below the rounding of the square, and once more, so that no error has the same
  /// sign in every step: for long runs.
  beyond_rounding,
  /// Until half the digits of the square are right: for a run of order 2 whose own error is to be measured,
  /// and is larger.
  to_half_the_digits
};

namespace detail {

/// When a sweep was the last.
///
/// e made of G has \f$ff^T - 1 = ee^T - G\f$: the change of the square is the defect of f. That of the next f
/// is smaller, by at least \f$q = \sqrt2\,\sigma|e|\f$ in the norm of Frobenius, with
/// \f$\sigma^2 = \max(\Lambda_i^2+\Lambda_j^2)/(\Lambda_i+\Lambda_j)^2\f$, which is at most 1 for
/// \f$\Lambda\ge0\f$, and \f$|e|^2\le|ee^T|_F\f$. Where n is large the last inequality gives much away: once
/// two changes have been measured, twice their ratio is taken if that is less. The defect allowed is half of
/// \f$\epsilon|e|_F\f$, what the rounding of e makes of it, and of \f$\epsilon|e|_F^2\f$, that of its square.
///
/// All numbers here are squares of norms, so that few roots are taken.
struct StoppingRule {
  Sweeps sweeps;
  double spread;      ///< \f$\sigma^2\f$
  bool any_negative;  ///< whether a \f$\Lambda_i\f$ is

  static constexpr double half_the_digits = 1e-16;  ///< the square of a relative defect
  static constexpr double eps2 =
      std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();

  /// The bound on \f$q^2\f$.
  double contraction(Defect const& d) const { return 2 * spread * std::sqrt(d.square); }
  static double allowed(Defect const& d) { return eps2 * d.trace * (1 + d.trace) / 4; }
  /// The square of the defect after one more pass. Where the iteration does not contract for sure, only the
  /// measured defect is used.
  static double next(double change, double q2) { return q2 < 0.25 ? q2 * change : change; }

  /// @param before  the change in the sweep before, infinite where there is none
  /// @param factor  by which more is allowed
  bool at_rounding(Defect const& d, double before, double factor = 1) const {
    double q2 = contraction(d);
    if (before < HUGE_VAL) q2 = std::min(q2, 4 * d.change / before);
    return next(d.change, q2) <= factor * factor * allowed(d);
  }
  bool done(Defect const& d, double before) const {
    bool const stalls = d.change > before / 4;
    if (sweeps == Sweeps::to_half_the_digits && d.change <= half_the_digits * d.square) return true;
    if (sweeps != Sweeps::beyond_rounding)
      return at_rounding(d, before) || (stalls && at_rounding(d, before, 16));
    return d.change <= eps2 * d.square || (stalls && at_rounding(d, before));
  }

  /// Whether f is sure to be the solution that grows out of the identity. For \f$\Lambda\ge0\f$:
  /// \f$f + f^T = 2 - ee^T\f$ is positive definite, so the spectrum of \f$f^T\Lambda\f$ is to the right. Else
  /// by contraction: the solution is the only one in a ball, for this step and all shorter ones.
  bool on_branch_of_identity(Defect const& d) const {
    return any_negative ? contraction(d) < 0.25 : d.square < 4;
  }

  /// How many squares a guess will take whose error has the square `error`, where sweeps divide errors by
  /// 1/q; with some room, so that it is right for the next steps too.
  /// @param amplification  of errors of past squares in the guess: what a step leaves must not grow from step
  ///                       to step
  int squares_needed(double error, Defect const& d, double q2, double amplification) const {
    constexpr int most = 9;
    double const room = 16, bound = contraction(d);
    int count = 1;
    for (double left = q2; count < most; ++count, error *= q2, left *= q2) {
      double const seen = count > 1 ? std::min(bound, 4 * q2) : bound;
      double const part = sweeps == Sweeps::to_half_the_digits ? half_the_digits : eps2;
      bool const enough = sweeps == Sweeps::to_rounding ? room * next(error, seen) <= allowed(d)
                                                        : room * error <= part * d.square;
      if (enough && amplification * amplification * left <= 0.25) break;
    }
    return sweeps == Sweeps::beyond_rounding ? count + 1 : count;
  }
};

}  // namespace detail
}  // namespace actio::bodies
