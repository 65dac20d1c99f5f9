// One step of the natural-chart scheme for a free body in three dimensions, in closed form.
//
// A step turns the body by the vector v = h zeta, |v| less than pi. The momenta before and after it, times h,
// are chi(ad* v) I v and the same at -v (thesis, 5.1). For rotations in 3-space the series
// chi(x) = x/(e^x - 1) ends with the square of x: with y = I v,
//
//     p = a y + v x y/2 + c (v.y) v,          c = (1 - a)/|v|^2,          a = (|v|/2) cot(|v|/2),
//
// p' = p turned back by v. It remains to find v for a given p: Newton's method, with the derivative from the
// same closed forms. The generic implementation is natural_chart_scheme.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "actio/fast_body/space/half_turn.hpp"

namespace actio::bodies {

/// The two factors of the momentum of a step, as functions of \f$s=|v|^2\f$, and their slopes.
struct ChartFactors {
  double a,        ///< \f$\frac{|v|}2\cot\frac{|v|}2\f$
      c;           ///< \f$(1-a)/s\f$
  double slope_a,  ///< \f$da/ds\f$
      slope_c;     ///< \f$dc/ds\f$

  /// @param s  from 0 up to, but not including, \f$4\pi^2\f$
  explicit ChartFactors(double s);
};

/// The body of the scheme.
class NaturalChartStep {
 public:
  /// @param moments  principal moments of inertia, positive, in any unit
  explicit NaturalChartStep(Three<double> const& moments)
      : moments_(moments), gap_{moments[2] - moments[1], moments[0] - moments[2], moments[1] - moments[0]} {}

  /// What a rotation of the body over a step came to.
  struct StepRotation {
    Three<double> v;       ///< rotation vector, body frame
    double angle_squared;  ///< \f$|v|^2\f$
    /// whether v is less than half a turn, on the branch that grows out of the identity
    bool found;
  };

  /// \f$\chi(\mathrm{ad}^*_v)\,Iv\f$: step times momentum before a step that turns by v; after it, the same
  /// at -v with the other sign.
  Three<double> momentum(Three<double> const& v) const { return at(v).p; }

  /// The turn of the step that begins with p = h M, by Newton's method from a guess.
  StepRotation turn(Three<double> const& p, Three<double> v) const;

  /// The same from the identity, along the momenta between 0 and p: finds it wherever the branch leads there.
  StepRotation followed(Three<double> const& p) const;

  /// \f$I^{-1}p\f$, where a search begins.
  Three<double> velocity(Three<double> const& p) const {
    return {p[0] / moments_[0], p[1] / moments_[1], p[2] / moments_[2]};
  }

 private:
  static constexpr double half_turn_squared = 9.869604401089358;  // pi^2

  /// Momentum and slope at one v.
  struct Linearization {
    Three<double> p;
    double s, determinant;
    std::array<Three<double>, 3> rows;  // of the derivative
    std::array<Three<double>, 3> cofactors;

    /// \f$A^{-1}r\f$ by Cramer's rule.
    Three<double> solve(Three<double> const& r) const;
  };
  Linearization at(Three<double> const& v) const;
  static Three<double> cross(Three<double> const& a, Three<double> const& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static double largest(Three<double> const& x) {
    return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
  }

  Three<double> moments_, gap_;
};

}  // namespace actio::bodies
