// One step of the natural-chart scheme for a free body in three dimensions, in closed form.
//
// A step turns the body by the vector v = h zeta, |v| less than pi. The momenta before and after it, times h,
// are chi(ad* v) I v and the same at -v (thesis, 5.1). For rotations in 3-space the series
// chi(x) = x/(e^x - 1) ends with the square of x: with y = I v,
//
//     p = a y + v x y/2 + c (v.y) v,          c = (1 - a)/|v|^2,          a = (|v|/2) cot(|v|/2),
//
// p' = p turned back by v. It remains to find v for a given p: Newton's method, with the derivative from the
// same closed forms. The general road is natural_chart_scheme.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "actio/fast_body/space/half_turn.hpp"

namespace actio {

/// The two factors of the momentum of a step, as functions of \f$s=|v|^2\f$, and their slopes.
struct ChartFactors {
  double a,        ///< \f$\frac{|v|}2\cot\frac{|v|}2\f$
      c;           ///< \f$(1-a)/s\f$
  double slope_a,  ///< \f$da/ds\f$
      slope_c;     ///< \f$dc/ds\f$

  /// @param s  from 0 up to, but not including, \f$4\pi^2\f$
  explicit ChartFactors(double s) {
    if (s < 0.25) {
      // c = sum |B_2k| s^(k-1)/(2k)!: the first term that is left out is below 1e-18.
      constexpr double b[] = {1.0 / 12,
                              1.0 / 720,
                              1.0 / 30240,
                              1.0 / 1209600,
                              1.0 / 47900160,
                              691.0 / 1307674368000,
                              1.0 / 74724249600,
                              3617.0 / 10670622842880000,
                              43867.0 / 5109094217170944000,
                              174611.0 / 802857662698291200000.0};
      c = b[9], slope_c = 0;
      for (int k = 8; k >= 0; --k) slope_c = slope_c * s + c, c = c * s + b[k];
      a = 1 - c * s, slope_a = -(c + slope_c * s);
      return;
    }
    double const half = std::sqrt(s) / 2;
    a = half * std::cos(half) / std::sin(half);
    c = (1 - a) / s, slope_a = (a - a * a - s / 4) / (2 * s), slope_c = -(slope_a + c) / s;
  }
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
  StepRotation turn(Three<double> const& p, Three<double> v) const {
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 12; ++iteration) {
      Linearization const l = at(v);
      if (!(l.s < half_turn_squared) || !(l.determinant > 0)) return {v, l.s, false};
      Three<double> const change = l.solve(minus(p, l.p));
      v = plus(v, change);
      double const moved = largest(change), size = largest(v);
      // The error after a move is its square, over a few tenths.
      if (moved <= 1e-10 * size) return {v, dot(v, v), dot(v, v) < half_turn_squared};
      // No smaller than the move before: rounding, or nothing to be found from here.
      if (!(moved < last)) return {v, dot(v, v), moved <= 1e-7 * size && dot(v, v) < half_turn_squared};
      last = moved;
    }
    return {v, dot(v, v), false};
  }

  /// The same from the identity, along the momenta between 0 and p: finds it wherever the branch leads there.
  StepRotation followed(Three<double> const& p) const {
    StepRotation reached{{0, 0, 0}, 0, true};
    constexpr int pieces = 32;
    for (int k = 1; k <= pieces; ++k) {
      double const part = static_cast<double>(k) / pieces;
      Three<double> const ahead = at(reached.v).solve({p[0] / pieces, p[1] / pieces, p[2] / pieces});
      reached = turn({part * p[0], part * p[1], part * p[2]}, plus(reached.v, ahead));
      if (!reached.found) break;
    }
    return reached;
  }

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
    Three<double> solve(Three<double> const& r) const {
      Three<double> x;
      for (int i = 0; i < 3; ++i)
        x[i] = (cofactors[0][i] * r[0] + cofactors[1][i] * r[1] + cofactors[2][i] * r[2]) / determinant;
      return x;
    }
  };
  Linearization at(Three<double> const& v) const {
    Linearization l;
    l.s = dot(v, v);
    ChartFactors const f(l.s < half_turn_squared * 3 ? l.s : half_turn_squared * 3);
    Three<double> const y{moments_[0] * v[0], moments_[1] * v[1], moments_[2] * v[2]};
    double const vy = dot(v, y), along = f.c * vy;
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      // (v x y)_i = (I_k - I_j) v_j v_k: of a long body the difference would lose its digits.
      l.p[i] = f.a * y[i] + 0.5 * gap_[i] * (v[j] * v[k]) + along * v[i];
      double const rate = 2 * (f.slope_a * y[i] + f.slope_c * vy * v[i]), across = 2 * f.c * v[i];
      l.rows[i][i] = f.a * moments_[i] + along + rate * v[i] + across * y[i];
      l.rows[i][j] = 0.5 * gap_[i] * v[k] + rate * v[j] + across * y[j];
      l.rows[i][k] = 0.5 * gap_[i] * v[j] + rate * v[k] + across * y[k];
    }
    for (int i = 0; i < 3; ++i) l.cofactors[i] = cross(l.rows[(i + 1) % 3], l.rows[(i + 2) % 3]);
    l.determinant = dot(l.rows[0], l.cofactors[0]);
    return l;
  }
  static Three<double> cross(Three<double> const& a, Three<double> const& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static double largest(Three<double> const& x) {
    return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
  }

  Three<double> moments_, gap_;
};

}  // namespace actio
