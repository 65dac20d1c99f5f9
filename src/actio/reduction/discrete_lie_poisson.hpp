// The discrete Lie-Poisson algorithm: the momentum of an invariant system, transported by relative motions.
//
// The state of a right-invariant system is the spatial momentum mu, that of a left-invariant one the body
// momentum Pi; the other one is constant. Momenta have their physical sign: the step from g0 to g1 starts
// with mu0 = -R*_f l'(f) and ends with mu1 = -L*_f l'(f), f = g0 g1^-1.
#pragma once

#include "actio/reduction/discrete_euler_poincare.hpp"

namespace actio {

/// \f$\mu_0 = -R_f^*\ell'(f)\f$: the spatial momentum at the start of a right-invariant step with relative
/// motion \f$f = g_0g_1^{-1}\f$.
template <Group G, Scalar S, class F>
Momentum<G, S> momentum_before_right(F const& l, Element<G, S> const& f) { return -right_differential(l, f); }
/// \f$\Pi_0 = -L_f^*\ell'(f)\f$: the body momentum at the start of a left-invariant step with relative motion
/// \f$f = g_1^{-1}g_0\f$.
///
/// \snippet reduction.cpp momentum_before_left
template <Group G, Scalar S, class F>
Momentum<G, S> momentum_before_left(F const& l, Element<G, S> const& f) { return -left_differential(l, f); }

/// \f$\mu_{k+1} = \mathrm{Ad}^*_{f_{k,k+1}}\,\mu_k\f$, right-invariant.
///
/// \implements{eq_3_17}
template <Group G, Scalar S>
Momentum<G, S> lie_poisson_update_right(Element<G, S> const& f, Momentum<G, S> const& mu) {
  // [eq_3_17]
  return Ad_star(f, mu);
  // [eq_3_17]
}
/// \f$\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1,k}^{-1}}\,\Pi_k\f$, left-invariant. The thesis omits the inverse.
///
/// \implements{eq_3_18}
template <Group G, Scalar S>
Momentum<G, S> lie_poisson_update_left(Element<G, S> const& f, Momentum<G, S> const& pi) {
  // [eq_3_18]
  return Ad_star(inverse(f), pi);
  // [eq_3_18]
}

/// The relative motion of the step that starts with a given spatial momentum: solves
/// \f$-R_f^*\ell'(f) = \mu\f$ near `start`.
/// @throws NotConverged, Singular  where the step is too long for the momentum
template <ExponentialGroup G, Real S, class F>
Solved<Element<G, S>> relative_motion_from_momentum_right(F const& l, Momentum<G, S> const& mu,
                                                          Element<G, S> const& start) {
  return solve_on_group(momentum_equation_right(l, mu), start);
}
/// The relative motion of the step that starts with a given body momentum: solves \f$-L_f^*\ell'(f) = \Pi\f$
/// near `start`. Otherwise as \ref relative_motion_from_momentum_right.
///
/// \snippet reduction.cpp relative_motion_from_momentum_left
template <ExponentialGroup G, Real S, class F>
Solved<Element<G, S>> relative_motion_from_momentum_left(F const& l, Momentum<G, S> const& pi,
                                                         Element<G, S> const& start) {
  return solve_on_group(momentum_equation_left(l, pi), start);
}

/// The equations of right-invariant systems, for what is written once for both sides.
struct RightInvariant {
  /// \f$\mu_1 = -L_f^*\ell'(f)\f$: the momentum at the end of a step.
  static auto momentum_after(auto const& l, auto const& f) { return -left_differential(l, f); }
  /// \ref momentum_equation_right.
  static auto momentum_equation(auto const& l, auto const& mu) { return momentum_equation_right(l, mu); }
  /// \ref lie_poisson_update_right.
  static auto lie_poisson_update(auto const& f, auto const& mu) { return lie_poisson_update_right(f, mu); }
  /// The relative motion over two steps, \f$g_0g_2^{-1} = f_{01}f_{12}\f$.
  static auto joined(auto const& f01, auto const& f12) { return f01 * f12; }
};
/// The equations of left-invariant systems.
struct LeftInvariant {
  /// \f$\Pi_1 = -R_f^*\ell'(f)\f$: the momentum at the end of a step.
  static auto momentum_after(auto const& l, auto const& f) { return -right_differential(l, f); }
  /// \ref momentum_equation_left.
  static auto momentum_equation(auto const& l, auto const& pi) { return momentum_equation_left(l, pi); }
  /// \ref lie_poisson_update_left.
  static auto lie_poisson_update(auto const& f, auto const& pi) { return lie_poisson_update_left(f, pi); }
  /// The relative motion over two steps, \f$g_2^{-1}g_0 = f_{21}f_{10}\f$.
  static auto joined(auto const& f10, auto const& f21) { return f21 * f10; }
};

}  // namespace actio
