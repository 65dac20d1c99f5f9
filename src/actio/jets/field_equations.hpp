// The Euler-Lagrange derivative of a density, as section 6.2 of the thesis writes it.
#pragma once

#include "actio/jets/density.hpp"

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
/// x^\mu}\frac{\partial L}{\partial v^a{}_\mu}\f$ at a second jet (6.12): the left side of the field
/// equations.
///
/// \snippet fields.cpp euler_lagrange_of_a_field
///
/// \implements{eq_6_12,eq_6_9}
/// @param j  second jet of a section, \ref second_jet
/// @return   a component for each a, per unit of \f$d^{n+1}x\f$: zero along solutions
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> euler_lagrange(L const& density, SecondJet<S, n, N> const& j) {
  Jet<S, n, N> const& first = j;
  examine(density, first);
  auto const dL_dv = [&](int mu) {
    return [&density, mu](auto const& z) { return partial_v(density, z, mu); };
  };
  // [eq_6_12]
  Matrix<S, N, 1> E = partial_y(density, first);
  for (int mu = 0; mu <= n; ++mu) E -= total_derivative(mu, dL_dv(mu), j);
  // [eq_6_12]
  require_derivative(E, first, "euler_lagrange");
  return E;
}

/// The same along a section, at a point of space-time.
template <class S, int rows, class L, class Phi>
Matrix<S, detail::fibre_dimension<Phi, S, rows - 1>, 1> euler_lagrange(L const& density, Phi const& phi,
                                                                       Matrix<S, rows, 1> const& x) {
  return euler_lagrange(density, second_jet(phi, x));
}

}  // namespace actio
