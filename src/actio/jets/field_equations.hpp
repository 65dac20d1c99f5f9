// The Euler-Lagrange derivative of a density (section 6.2 of the thesis).
#pragma once

#include "actio/jets/density.hpp"

namespace actio {

/// The total derivative along a section of the momenta, summed: \f$D_\mu\,(\partial L/\partial v^a{}_\mu)\f$.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Eigen::Matrix<S, N, 1> momentum_divergence(L const& density, SecondJet<S, n, N> const& j) {
  Eigen::Matrix<S, N, 1> sum = Eigen::Matrix<S, N, 1>::Zero();
  for (int mu = 0; mu <= n; ++mu) {
    Eigen::Matrix<Dual<S>, N, 1> const p = detail::momentum_column(density, along(j, mu), mu);
    for (int a = 0; a < N; ++a) sum[a] += p[a].part[0];
  }
  return sum;
}

/// The Euler-Lagrange derivative \f$\partial L/\partial y^a - D_\mu\,(\partial L/\partial v^a{}_\mu)\f$ at a second jet (6.12): the left side of the field equations.
///
/// \implements{eq_6_12,eq_6_9}
/// @param j  second jet of a section, \ref second_jet
/// @return   a component for each a, per unit of \f$d^{n+1}x\f$: zero along solutions
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Eigen::Matrix<S, N, 1> euler_lagrange(L const& density, SecondJet<S, n, N> const& j) {
  detail::examine(density, static_cast<Jet<S, n, N> const&>(j));
  // [eq_6_12]
  Eigen::Matrix<S, N, 1> const r = place_derivative(density, static_cast<Jet<S, n, N> const&>(j)) - momentum_divergence(density, j);
  // [eq_6_12]
  detail::require_derivative(r, static_cast<Jet<S, n, N> const&>(j), "euler_lagrange");
  return r;
}

/// The same along a section, at a point of space-time.
template <class S, int rows, class L, class Phi>
Eigen::Matrix<S, detail::fibre_dimension<Phi, S, rows - 1>, 1> euler_lagrange(L const& density, Phi const& phi, Eigen::Matrix<S, rows, 1> const& x) {
  return euler_lagrange(density, second_jet(phi, x));
}

}  // namespace actio
