// The Moser-Veselov scheme in three dimensions, solved once for a whole orbit.
//
// The relative motion of a step is a rotation by a unit quaternion (q0, q), and the momenta before and after
// it are, with p = hM/2 and y = Iq,
//
//     p = q0 y + q x y,      p' = q0 y - q x y.
//
// So p' is p after a half turn about y; |p|^2 and sum p_i^2/I_i are the same before and after, and y is the
// null vector of D + [p]x with D_i = (|p|^2 + K^2)/I_i - K and K = sum I_i q_i^2. That the determinant of
// D + [p]x vanishes is an equation for K whose coefficients are constants of the motion: K is the same in all
// steps. In the numbers j_i = |p|/I_i, with elementary symmetric functions e1, e2, e3, and r = sum j_i u_i^2,
// u = p/|p|, the equation for kappa = K/|p| is
//
//     e3 (1 + kappa^2)^2 - e2 kappa (1 + kappa^2) + e1 kappa^2 - kappa + r = 0,
//
// of the fourth degree, the smallest root being the one that grows out of the identity: since Tr(f
// Lambda) = Tr Lambda - 2 K, the four roots are the four ways to choose the eigenvalues of f^T Lambda from
// the pairs that the momentum allows. The parameters of the step are delta_i = (1 + kappa^2) j_i - kappa, tan
// T = kappa.
#pragma once

#include "actio/fast_body/space/half_turn.hpp"
#include "actio/numbers/scalar.hpp"

namespace actio::bodies {

/// The equation for \f$\kappa = \tan T\f$ of the explicit scheme: its residual, and the slope.
template <Scalar S>
class TwistEquation {
 public:
  /// @param j  \f$hL/(2I_i)\f$: half the step, as an angle about each axis at full momentum
  /// @param r  \f$\sum_i j_iu_i^2\f$
  TwistEquation(Three<S> const& j, S const& r)
      : e1_(j[0] + j[1] + j[2]),
        e2_(j[0] * j[1] + j[1] * j[2] + j[2] * j[0]),
        e3_(j[0] * j[1] * j[2]),
        r_(r) {}

  /// The left side.
  S residual(S const& kappa) const {
    // [twist_equation]
    S const sum = S(1) + kappa * kappa;
    return e3_ * sum * sum - e2_ * kappa * sum + e1_ * kappa * kappa - kappa + r_;
    // [twist_equation]
  }
  /// Its derivative.
  S slope(S const& kappa) const {
    S const square = kappa * kappa;
    return S(4) * e3_ * kappa * (S(1) + square) - e2_ * (S(1) + S(3) * square) + S(2) * e1_ * kappa - S(1);
  }

 private:
  S e1_, e2_, e3_, r_;
};

/// Half a step as an angle about each axis at full momentum, and how the axes differ: a difference of the
/// angles would lose its digits for a long body.
template <class S>
struct HalfStep {
  Three<S> j;  ///< \f$j_i = hL/(2I_i)\f$
  S d12;       ///< \f$j_1-j_2\f$
  S d23;       ///< \f$j_2-j_3\f$
};

/// The same equation in \f$x = \delta_2\f$ and the differences:
/// \f$x\,(1 + \delta_1\delta_3) + (1+\kappa^2)\big((j_1-j_2)u_1^2 - (j_2-j_3)u_3^2\big) = 0\f$, which is
/// \f$\det(D+[u]_\times)\f$, over \f$1+\kappa^2\f$. For a long body, one \f$j_i\f$ far above the others, the
/// coefficients of the fourth degree cancel and this does not.
template <Real S>
class TwistFromMiddle {
 public:
  /// @param u  direction of the momentum
  TwistFromMiddle(HalfStep<S> const& step, Three<S> const& u)
      : step_(step), beside_(step.d12 * u[0] * u[0] - step.d23 * u[2] * u[2]) {}

  /// The left side.
  S residual(S const& kappa) const {
    S const sum = S(1) + kappa * kappa, x = sum * step_.j[1] - kappa, first = x + sum * step_.d12,
            third = x - sum * step_.d23;
    return x * (first * third + S(1)) / sum + beside_;
  }
  /// Its derivative.
  S slope(S const& kappa) const {
    S const sum = S(1) + kappa * kappa, twice = S(2) * kappa, x = sum * step_.j[1] - kappa,
            first = x + sum * step_.d12, third = x - sum * step_.d23;
    S const dx = twice * step_.j[1] - S(1), product = first * third + S(1);
    return (dx * product + x * ((dx + twice * step_.d12) * third + first * (dx - twice * step_.d23)) -
            twice * x * product / sum) /
           sum;
  }
  /// The parameters of the step with this twist, with all digits of the delta_i: the difference that x is has
  /// lost some.
  StepParameters<S> parameters(S const& kappa) const {
    using std::sqrt;
    S const sum = S(1) + kappa * kappa, cosine = S(1) / S(sqrt(sum)), to_first = sum * step_.d12,
            to_third = sum * step_.d23;
    S x = sum * step_.j[1] - kappa;
    for (int round = 0; round < 3; ++round) {
      S const first = x + to_first, third = x - to_third, product = first * third + S(1),
              slope = product + x * (first + third);
      if (!(slope > S(0))) break;
      x -= (x * product + sum * beside_) / slope;
    }
    Three<S> const delta{x + to_first, x, x - to_third};
    return {delta, {-to_third, to_first + to_third, -to_first}, cosine, kappa * cosine, stretch_of(delta)};
  }

 private:
  HalfStep<S> step_;
  S beside_;
};

/// What Newton's method found.
template <class S>
struct Twist {
  S kappa;         ///< the root
  int iterations;  ///< evaluations of the equation
  bool found;      ///< whether it is the smallest root
};

/// The smallest root, by Newton's method from the left of it, where the equation falls.
///
/// `found` is false where it stops falling before there is a root: the step is too long.
template <Real S, class Equation>
Twist<S> smallest_root(Equation const& equation, S const& r) {
  // Left of the smallest root the residual is positive; the bracket holds the iteration where the equation is
  // not convex.
  S kappa = r, low(0), high = std::numeric_limits<S>::infinity(), last = std::numeric_limits<S>::infinity();
  for (int iteration = 1; iteration <= 60; ++iteration) {
    S const residual = equation.residual(kappa), slope = equation.slope(kappa);
    if (residual > S(0))
      low = kappa;
    else
      high = kappa;
    if (!(slope < S(0))) {
      if (residual > S(0) || !(low < kappa)) return {kappa, iteration, false};
      kappa = (low + kappa) / S(2);
      continue;
    }
    S next = kappa - residual / slope;
    S const move = magnitude(S(next - kappa));
    if (move <= S(2) * epsilon<S>() * magnitude(next) || (move >= last && move <= S(1e-6) * magnitude(next)))
      return {next, iteration, true};
    if (next >= high) next = (low + high) / S(2);
    last = move, kappa = next;
  }
  return {kappa, 60, false};
}

/// The parameters of a step of the Moser-Veselov scheme; `found` tells whether there is one. A step back in
/// time is one with all signs changed.
template <Real S>
StepParameters<S> moser_veselov_parameters(HalfStep<S> const& step, Three<S> const& u, bool& found) {
  Three<S> const& j = step.j;
  S const r = j[0] * u[0] * u[0] + j[1] * u[1] * u[1] + j[2] * u[2] * u[2], sign = r < S(0) ? S(-1) : S(1);
  HalfStep<S> const forward{{sign * j[0], sign * j[1], sign * j[2]}, sign * step.d12, sign * step.d23};
  Twist<S> const twist = smallest_root<S>(TwistFromMiddle<S>(forward, u), sign * r);
  found = twist.found;
  return TwistFromMiddle<S>(step, u).parameters(sign * twist.kappa);
}

}  // namespace actio::bodies
