// The Euler-Lagrange derivative of a density, as section 6.2 of the thesis writes it.
//
// `euler_lagrange`, which comes with this header, computes the same from one evaluation of the density and is
// held to these lines.
#pragma once

#include "actio/jets/field_equations_in_one_pass.hpp"

namespace actio {

/// The divergence of the momenta along a section, \f$D_\mu\,(\partial L/\partial v^a{}_\mu)\f$.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> momentum_divergence(L const& density, SecondJet<S, n, N> const& j) {
  Matrix<S, N, 1> sum = Matrix<S, N, 1>::Zero();
  for (int mu = 0; mu <= n; ++mu)
    sum += total_derivative(
        mu, [&](auto const& z) { return partial_v(density, z, mu); }, j);
  return sum;
}

/// The Euler-Lagrange derivative \f$\frac{\partial L}{\partial y^a} - \frac{\partial}{\partial
/// x^\mu}\frac{\partial L}{\partial v^a{}_\mu}\f$, term by term as (6.12) is written.
///
/// \implements{eq_6_12}
/// @param j  second jet of a section, \ref second_jet
/// @return   a component for each a, per unit of \f$d^{n+1}x\f$. \ref euler_lagrange is quicker and is held
///           to this.
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> euler_lagrange_by_terms(L const& density, SecondJet<S, n, N> const& j) {
  Jet<S, n, N> const& first = j;
  examine(density, first);
  auto const dL_dv = [&](int mu) {
    return [&density, mu](auto const& z) { return partial_v(density, z, mu); };
  };
  // [eq_6_12]
  Matrix<S, N, 1> E = partial_y(density, first);
  for (int mu = 0; mu <= n; ++mu) E -= total_derivative(mu, dL_dv(mu), j);
  // [eq_6_12]
  require_derivative(E, first, "euler_lagrange_by_terms");
  return E;
}

}  // namespace actio
