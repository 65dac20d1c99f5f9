// The covariant momentum map and the Noether current (section 9.1 of the thesis).
//
// With Omega = -dTheta the momentum map of an equivariant density is J(xi) = j1 xi hook Theta, an n-form on
// the jet bundle with dJ(xi) = j1 xi hook Omega. Pulled back by a section it is the Noether current, here by
// its components: J^mu d^n x_mu.
#pragma once

#include "actio/jets/cartan.hpp"
#include "actio/jets/first_variation.hpp"
#include "actio/jets/prolongation.hpp"

namespace actio {

/// The covariant momentum map \f$J_L(\xi) = j^1\xi\lrcorner\,\Theta_L\f$ of a density (9.7).
///
/// \implements{eq_9_7}
/// @param xi  a vector field on Y that covers one on space-time: a callable from points (x, y), one column,
///            to their velocities
/// @return    an n-form on the jet bundle: a callable on coordinates of a jet and n tangent vectors
/// Hypothesis: the density is equivariant under xi; otherwise \f$dJ_L(\xi)\f$ is not
/// \f$j^1\xi\lrcorner\,\Omega_L\f$.
template <int n, int N, class L, class Xi>
auto covariant_momentum_map(L const& density, Xi const& xi) {
  // [eq_9_7]
  return contract(prolonged<n, N>(xi), cartan_form<n, N>(density));
  // [eq_9_7]
}

/// One component of the Noether current \f$(j^1\phi)^*J_L(\xi) = J^\mu\,d^nx_\mu\f$:
/// \f$J^\mu = L\,\xi^\mu + p_a{}^\mu\,(\xi^a - v^a{}_\nu\xi^\nu)\f$.
///
/// \implements{thm_9_1_1}
/// @param j  first jet of the section
/// @throws NoDerivative  where the density has none; and what the density refuses
template <class L, class Xi, class S, int n, int N>
S noether_current(L const& density, Xi const& xi, Jet<S, n, N> const& j, int mu) {
  examine(density, j);
  Variation<S, n, N> const V = xi(point_of(j));
  // [thm_9_1_1]
  S const J = density(j) * V[mu] + partial_v(density, j, mu).dot(vertical_part(j, V));
  // [thm_9_1_1]
  require_derivative(Matrix<S, 1, 1>(J), j, "noether_current");
  return J;
}

/// The components of the Noether current, \f$J^\mu = (L\,\delta^\mu_\nu - p_a{}^\mu
/// v^a{}_\nu)\,\xi^\nu + p_a{}^\mu\xi^a\f$, time first.
///
/// \implements{thm_9_1_1}
/// @param j  first jet of the section
/// @throws NoDerivative  where the density has none; and what the density refuses
template <class L, class Xi, class S, int n, int N>
Event<S, n> noether_current(L const& density, Xi const& xi, Jet<S, n, N> const& j) {
  Event<S, n> current;
  for (int mu = 0; mu <= n; ++mu) current[mu] = noether_current(density, xi, j, mu);
  return current;
}

/// The n-form \f$J^\mu\,d^nx_\mu\f$ on space-time with the components of a vector field.
/// @param current  a callable from points of space-time to components
template <class Current>
auto flux_form(Current const& current) {
  return
      [current]<class S, int rows>(Matrix<S, rows, 1> const& x, Tangents<S, rows, rows - 1> const& V) -> S {
        Matrix<S, rows, rows> all;
        all.col(0) = current(x);
        all.template rightCols<rows - 1>() = V;
        return determinant(all);
      };
}

}  // namespace actio
