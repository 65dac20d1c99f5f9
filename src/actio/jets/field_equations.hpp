// The Euler-Lagrange derivative of a density (section 6.2 of the thesis).
#pragma once

#include "actio/numbers/divergence_functions.hpp"
#include "actio/jets/density.hpp"

namespace actio {

namespace detail {

/// The first jets around j: along \f$x^\mu\f$ by \f$\delta_\mu\f$ as the section goes, and by \f$\varepsilon_a{}^\mu\f$ in \f$v^a{}_\mu\f$.
///
/// On them a density has \f$D_\mu(\partial L/\partial v^a{}_\mu)\f$ at \f$\tau_a = \delta_\mu\varepsilon_a{}^\mu\f$.
template <class S, int n, int N>
Jet<DivergenceNumber<S, n + 1, N>, n, N> all_ways(SecondJet<S, n, N> const& j) {
  Jet<DivergenceNumber<S, n + 1, N>, n, N> moved;
  for (int mu = 0; mu <= n; ++mu) {
    moved.x[mu].set_value(j.x[mu]);
    moved.x[mu].set_rate(mu, S(1));
  }
  for (int a = 0; a < N; ++a) {
    moved.y[a].set_value(j.y[a]);
    for (int mu = 0; mu <= n; ++mu) {
      moved.y[a].set_rate(mu, j.v(a, mu));
      moved.v(a, mu).set_value(j.v(a, mu));
      moved.v(a, mu).set_slope(mu, a, S(1));
      for (int nu = 0; nu <= n; ++nu) moved.v(a, mu).set_rate(nu, j.w[nu](a, mu));
    }
  }
  return moved;
}

/// How a matrix changes in the direction of its dual numbers.
template <class S, int rows, int columns>
Matrix<S, rows, columns> rates(Matrix<Dual<S>, rows, columns> const& moved) {
  Matrix<S, rows, columns> rate;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) rate(i, k) = moved(i, k).part[0];
  return rate;
}

/// What stands at \f$\tau_a\f$, for each a.
template <int N, class S, int m>
Matrix<S, N, 1> sums(DivergenceNumber<S, m, N> const& x) {
  Matrix<S, N, 1> all;
  for (int a = 0; a < N; ++a) all[a] = x.sum(a);
  return all;
}

}  // namespace detail

/// The total derivative along a section of the momenta, summed: \f$D_\mu\,(\partial L/\partial v^a{}_\mu)\f$.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> momentum_divergence(L const& density, SecondJet<S, n, N> const& j) {
  DivergenceNumber<S, n + 1, N> const value = density(detail::all_ways(j));
  return detail::sums<N>(value);
}

/// The Euler-Lagrange derivative term by term, as (6.12) is written: dual numbers along each \f$x^\mu\f$ around the momenta.
///
/// \implements{eq_6_12}
/// @param j  second jet of a section, \ref second_jet
/// @return   a component for each a, per unit of \f$d^{n+1}x\f$. \ref euler_lagrange is quicker and is held to this.
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> euler_lagrange_by_terms(L const& density, SecondJet<S, n, N> const& j) {
  Jet<S, n, N> const& first = j;
  detail::examine(density, first);
  // [eq_6_12]
  Matrix<S, N, 1> r = place_derivative(density, first);
  for (int mu = 0; mu <= n; ++mu) r -= detail::rates<S, N, 1>(detail::momentum_column(density, along(j, mu), mu));
  // [eq_6_12]
  detail::require_derivative(r, first, "euler_lagrange_by_terms");
  return r;
}

/// The Euler-Lagrange derivative \f$\partial L/\partial y^a - D_\mu\,(\partial L/\partial v^a{}_\mu)\f$ at a second jet (6.12): the left side of the field equations.
///
/// L is evaluated once; \ref euler_lagrange_by_terms is the same in plain words.
/// \implements{eq_6_12,eq_6_9}
/// @param j  second jet of a section, \ref second_jet
/// @return   a component for each a, per unit of \f$d^{n+1}x\f$: zero along solutions
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> euler_lagrange(L const& density, SecondJet<S, n, N> const& j) {
  detail::examine(density, static_cast<Jet<S, n, N> const&>(j));
  // With y^a moved by -tau_a as well, L has D_mu(dL/dv^a_mu) - dL/dy^a at tau_a.
  auto moved = detail::all_ways(j);
  for (int a = 0; a < N; ++a) moved.y[a].set_sum(a, S(-1));
  DivergenceNumber<S, n + 1, N> const value = density(moved);
  Matrix<S, N, 1> const r = -detail::sums<N>(value);
  detail::require_derivative(r, static_cast<Jet<S, n, N> const&>(j), "euler_lagrange");
  return r;
}

/// The same along a section, at a point of space-time.
template <class S, int rows, class L, class Phi>
Matrix<S, detail::fibre_dimension<Phi, S, rows - 1>, 1> euler_lagrange(L const& density, Phi const& phi, Matrix<S, rows, 1> const& x) {
  return euler_lagrange(density, second_jet(phi, x));
}

}  // namespace actio
