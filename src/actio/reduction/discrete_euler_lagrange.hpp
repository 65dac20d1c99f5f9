// Discrete mechanics on G x G: the discrete Euler-Lagrange equations.
//
// A discrete Lagrangian is any callable L(g0, g1), at every scalar. It is an action (energy x time), about
// the integral of the continuous Lagrangian over the step, so that D2 is a momentum and steps may differ. The
// thesis divides by the step; no statement changes. Differentials in either slot are translated to the
// identity on the right, variations being theta = dg g^-1.
#pragma once

#include "actio/groups/solve.hpp"

namespace actio {

/// \f$D_1 L(g_0, g_1)\f$: the differential in the first slot, read on
/// \f$\vartheta\mapsto\frac{d}{d\epsilon}L(e^{\epsilon\vartheta}g_0, g_1)\f$.
template <Group G, Scalar S, class L>
Momentum<G, S> D1(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1) {
  return right_differential([&](auto const& g) { return lagrangian(g, like(g, g1)); }, g0);
}

/// \f$D_2 L(g_0, g_1)\f$: the differential in the second slot, read on
/// \f$\vartheta\mapsto\frac{d}{d\epsilon}L(g_0, e^{\epsilon\vartheta}g_1)\f$.
template <Group G, Scalar S, class L>
Momentum<G, S> D2(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1) {
  return right_differential([&](auto const& g) { return lagrangian(like(g, g0), g); }, g1);
}

/// The residual of the discrete Euler-Lagrange equations: zero along discrete motions, and only there.
///
/// \f[ D_2 L(g_0, g_1) + D_1 L(g_1, g_2) \f]
///
/// \implements{eq_3_2}
/// @param lagrangian  discrete Lagrangian, \f$G\times G\to\mathbb R\f$, energy x time
/// @return            covector at the identity (translated from \f$g_1\f$ on the right)
/// Exact up to rounding.
template <Group G, Scalar S, class L>
Momentum<G, S> discrete_euler_lagrange(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1,
                                       Element<G, S> const& g2) {
  // [eq_3_2]
  return D2(lagrangian, g0, g1) + D1(lagrangian, g1, g2);
  // [eq_3_2]
}

/// The next configuration: solves \ref discrete_euler_lagrange for \f$g_2\f$; the initial guess repeats the
/// last relative motion.
///
/// @throws NotConverged, Singular  where the step is too long for the discrete Lagrangian to be regular
template <ExponentialGroup G, Real S, class L>
Solved<Element<G, S>> step_euler_lagrange(L const& lagrangian, Element<G, S> const& g0,
                                          Element<G, S> const& g1) {
  // The momentum at the end of the step before is given: solve for the configuration whose step starts with
  // it.
  auto const end_momentum = D2(lagrangian, g0, g1);
  auto const start = g1 * inverse(g0) * g1;
  return solve_on_group(
      [&](auto const& g2) { return like(g2, end_momentum) + D1(lagrangian, like(g2, g1), g2); }, start);
}

/// The discrete action of a sequence of configurations: \f$\sum_k L(g_k, g_{k+1})\f$ over every neighbouring
/// pair of it.
///
/// \implements{eq_3_1}
template <class L, class Configurations>
auto discrete_action(L const& lagrangian, Configurations const& configurations) {
  // [eq_3_1]
  auto sum = lagrangian(configurations[0], configurations[1]);
  for (std::size_t k = 1; k + 1 < configurations.size(); ++k)
    sum += lagrangian(configurations[k], configurations[k + 1]);
  // [eq_3_1]
  return sum;
}

}  // namespace actio
