// Forces in discrete mechanics: the discrete Lagrange-d'Alembert equations, on pairs of configurations and
// reduced.
//
// A force over a step is two covectors, one at either end, each an action: about half of the step times the
// force there. What the discrete Lagrangian leaves of the momentum at a configuration is what the force of
// the step before adds at its end and that of the step after at its start.
#pragma once

#include <utility>

#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/reduction/natural_chart.hpp"

namespace actio {

/// A force over a step, as covectors at the identity, energy x time.
/// @tparam Start, End  callables of a step, at every scalar: of a pair (g0, g1), or of a relative motion
template <class Start, class End>
struct DiscreteForce {
  Start at_start;  ///< \f$F^-\f$, at the configuration before the step
  End at_end;      ///< \f$F^+\f$, at the one behind it
};
template <class Start, class End>
DiscreteForce(Start, End) -> DiscreteForce<Start, End>;

/// The residual of the discrete Euler-Lagrange equations with a force:
/// \f$D_2L(g_0, g_1) + D_1L(g_1, g_2) + F^+(g_0, g_1) + F^-(g_1, g_2)\f$.
/// @param force  of pairs, translated to the identity on the right
/// @return       covector at the identity; exact up to rounding
template <Group G, Scalar S, class L, class Start, class End>
Momentum<G, S> forced_euler_lagrange(L const& lagrangian, DiscreteForce<Start, End> const& force,
                                     Element<G, S> const& g0, Element<G, S> const& g1,
                                     Element<G, S> const& g2) {
  // [forced_euler_lagrange]
  return discrete_euler_lagrange(lagrangian, g0, g1, g2) + force.at_end(g0, g1) + force.at_start(g1, g2);
  // [forced_euler_lagrange]
}

/// The residual of (3.10) with a force: \f$R^*_{f_{12}}\ell'(f_{12}) - L^*_{f_{01}}\ell'(f_{01}) +
/// F^+(f_{01}) + F^-(f_{12})\f$.
/// @param force  of relative motions, in space
/// @return       covector at the identity; exact up to rounding
template <Group G, Scalar S, class F, class Start, class End>
Momentum<G, S> forced_euler_poincare_right(F const& l, DiscreteForce<Start, End> const& force,
                                           Element<G, S> const& f01, Element<G, S> const& f12) {
  // [forced_euler_poincare_right]
  return euler_poincare_right(l, f01, f12) + force.at_end(f01) + force.at_start(f12);
  // [forced_euler_poincare_right]
}
/// The residual of (3.11) with a force: \f$L^*_{f_{21}}\ell'(f_{21}) - R^*_{f_{10}}\ell'(f_{10}) +
/// F^+(f_{10}) + F^-(f_{21})\f$.
/// @param force  of relative motions, in the body
template <Group G, Scalar S, class F, class Start, class End>
Momentum<G, S> forced_euler_poincare_left(F const& l, DiscreteForce<Start, End> const& force,
                                          Element<G, S> const& f10, Element<G, S> const& f21) {
  return euler_poincare_left(l, f10, f21) + force.at_end(f10) + force.at_start(f21);
}

/// The force of a step of the natural chart: half of the step times the force at the velocity
/// \f$-\log(f)/h\f$, at either end. The step is then its own inverse with h for -h, so that it has order 2,
/// and symmetric compositions have theirs.
/// @param force  velocity at any scalar -> covector, energy: of the body (left-invariant) or in space
/// @param h      step, time
template <class Force, class T>
auto force_at_both_ends(Force force, T h) {
  auto const half = [force, h]<class G, class S>(Element<G, S> const& f) {
    return detail::constant<S>(T(h / T(2))) * force(log(f) / detail::constant<S>(T(-h)));
  };
  return DiscreteForce{half, half};
}

/// A step of a left-invariant system with a force, from the body momentum at its start: solves
/// \f$L_f^*\ell'(f) + F^-(f) + \Pi = 0\f$.
/// @param near  where the search begins: the relative motion of the step before, or the identity
/// @return      the relative motion \f$g_1^{-1}g_0\f$, and the momentum \f$F^+(f) - R_f^*\ell'(f)\f$ at the
///              end
/// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular
template <ExponentialGroup G, Real S, class F, class Start, class End>
std::pair<Element<G, S>, Momentum<G, S>> forced_step_left(F const& l, DiscreteForce<Start, End> const& force,
                                                          Momentum<G, S> const& pi,
                                                          Element<G, S> const& near) {
  // [forced_step_left]
  auto const equation = momentum_equation_left(l, pi);
  auto const f = solve_on_group([&](auto const& x) { return equation(x) + force.at_start(x); }, near).value;
  return {f, force.at_end(f) - right_differential(l, f)};
  // [forced_step_left]
}

}  // namespace actio
