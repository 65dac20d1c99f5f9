// The discrete Lagrange forms on G x G, the two Legendre transformations, and the tangent of the discrete
// flow.
//
// A tangent vector at (g0, g1) is written (theta0, theta1), theta = dg g^-1 in each slot.
#pragma once

#include "actio/reduction/discrete_euler_lagrange.hpp"

namespace actio {

/// A tangent vector to G x G.
template <Group G, Scalar S>
struct PairChange {
  Velocity<G, S> first;   ///< \f$\delta g_0\,g_0^{-1}\f$
  Velocity<G, S> second;  ///< \f$\delta g_1\,g_1^{-1}\f$
};

/// \f$\theta^-_L(g_0, g_1)\cdot w = D_1 L\,\delta g_0\f$.
template <Group G, Scalar S, class L>
S discrete_one_form_minus(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1,
                          PairChange<G, S> const& w) {
  return pair(D1(lagrangian, g0, g1), w.first);
}
/// \f$\theta^+_L(g_0, g_1)\cdot w = D_2 L\,\delta g_1\f$.
template <Group G, Scalar S, class L>
S discrete_one_form_plus(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1,
                         PairChange<G, S> const& w) {
  return pair(D2(lagrangian, g0, g1), w.second);
}

/// \f$\partial_2 D_1 L\f$: how \f$D_1 L(g_0, g_1)\f$ changes when \f$g_1\f$ does. Row: component of D1;
/// column: direction in which g1 moves. L is regular at (g0, g1) where this matrix has an inverse.
template <Group G, Scalar S, class L>
auto mixed_derivative(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1) {
  int const n = g0.group.dimension();
  Matrix<S, G::dim, G::dim> m(n, n);
  over_batches(n, [&](int first) {
    auto const moved = moved_left(g1, first);
    store_parts(m, D1(lagrangian, like(moved, g0), moved).components, first);
  });
  return m;
}

/// The discrete Lagrange two-form \f$\omega_L = d\theta^-_L = -d\theta^+_L\f$ on two tangent vectors.
///
/// In coordinates \f$\omega_L = \frac{\partial^2 L}{\partial g_0^i\,\partial g_1^j}\,dg_1^j\wedge dg_0^i\f$.
/// \implements{eq_3_5}
template <Group G, Scalar S, class L>
S discrete_two_form(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1,
                    PairChange<G, S> const& w1, PairChange<G, S> const& w2) {
  auto const m = mixed_derivative(lagrangian, g0, g1);
  // [eq_3_5]
  auto const product = [&](auto const& earlier, auto const& later) {
    return earlier.first.coordinates.dot(m * later.second.coordinates);
  };
  return product(w2, w1) - product(w1, w2);
  // [eq_3_5]
}

/// The momentum at the start of the step, at \f$g_0\f$: \f$-D_1 L(g_0, g_1)\f$, with its physical sign,
/// spatial.
template <Group G, Scalar S, class L>
Momentum<G, S> legendre_source(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1) {
  // [claim_3_1_pullback_canonical]
  return -D1(lagrangian, g0, g1);
  // [claim_3_1_pullback_canonical]
}
/// The momentum at the end of the step, at \f$g_1\f$: \f$D_2 L(g_0, g_1)\f$, spatial.
template <Group G, Scalar S, class L>
Momentum<G, S> legendre_target(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1) {
  return D2(lagrangian, g0, g1);
}

/// The tangent of the discrete flow \f$(g_0, g_1)\mapsto(g_1, g_2)\f$ on a tangent vector, where
/// \f$g_0, g_1, g_2\f$ satisfy (3.2).
///
/// Differentiates the equation instead of the solver, so it is exact at every scalar, the rationals included.
/// @throws Singular  where L is not regular at (g1, g2)
template <Group G, Scalar S, class L>
PairChange<G, S> discrete_flow_tangent(L const& lagrangian, Element<G, S> const& g0, Element<G, S> const& g1,
                                       Element<G, S> const& g2, PairChange<G, S> const& w) {
  // Move g0 and g1 along w, hold g2: how the equation changes.
  using D = Dual<S>;
  auto const shifted = [](Element<G, S> const& g, Velocity<G, S> const& theta) {
    Coordinates<G, D> v = Coordinates<G, D>::Zero(g.group.dimension());
    for (Index a = 0; a < v.size(); ++a) v[a].part[0] = theta.coordinates[a];
    return Element<G, D>{g.group, primitive::near_identity(g.group, v)} * over<D>(g);
  };
  auto const changed =
      discrete_euler_lagrange(lagrangian, shifted(g0, w.first), shifted(g1, w.second), over<D>(g2))
          .components;
  Coordinates<G, S> right(changed.size());
  for (Index a = 0; a < right.size(); ++a) right[a] = -changed[a].part[0];
  // The change of g2 that makes up for it.
  return {w.second,
          {g0.group, solve_linear(mixed_derivative(lagrangian, g1, g2), right, "discrete flow: D2 D1 L")}};
}

}  // namespace actio
