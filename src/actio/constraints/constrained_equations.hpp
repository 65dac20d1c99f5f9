// The constrained field equations with a given multiplier (7.2), written out term by term.
//
// `AugmentedDensity` has the same equations by way of the extended bundle. These need no extended bundle, and have the sign of the thesis: they belong to L - <lambda, Phi>.
#pragma once

#include "actio/constraints/constraint.hpp"
#include "actio/jets/field_equations.hpp"

namespace actio {

namespace detail {
/// \f$\langle\lambda, \Phi\rangle\f$ with \f$\lambda\f$ held fixed, as a density.
template <class T, class Phi>
struct Paired {
  Phi const& constraint;
  Matrix<T, Phi::components, 1> lambda;

  template <class S, int n, int N>
  S operator()(Jet<S, n, N> const& jet) const {
    Matrix<S, Phi::components, 1> const value = constraint(jet);
    S sum(0);
    for (int i = 0; i < Phi::components; ++i) sum += value[i] * S(lambda[i]);
    return sum;
  }
};
}  // namespace detail

/// What the multiplier contributes: \f$\langle\lambda, \partial\Phi/\partial y^a\rangle - D_\mu\langle\lambda, \partial\Phi/\partial v^a{}_\mu\rangle\f$. Minus this is the force of the constraint in (7.2).
/// @param j       second jet of the section
/// @param lambda  first jet of the multiplier at the same point, \ref first_jet
template <class S, int n, int N, class Phi>
  requires ConstraintOver<Phi, S, n, N>
Matrix<S, N, 1> reaction(Phi const& constraint, SecondJet<S, n, N> const& j, Jet<S, n, Phi::components> const& lambda) {
  constexpr int k = Phi::components;
  Matrix<S, N, 1> r = place_derivative(detail::Paired<S, Phi>{constraint, lambda.y}, static_cast<Jet<S, n, N> const&>(j));
  for (int mu = 0; mu <= n; ++mu) {
    // The total derivative meets lambda(x) as well.
    Matrix<Dual<S>, k, 1> moved = lambda.y.template cast<Dual<S>>();
    for (int i = 0; i < k; ++i) moved[i].part[0] = lambda.v(i, mu);
    Matrix<Dual<S>, N, 1> const p = detail::momentum_column(detail::Paired<Dual<S>, Phi>{constraint, moved}, along(j, mu), mu);
    for (int a = 0; a < N; ++a) r[a] -= p[a].part[0];
  }
  return r;
}

/// The left side of the constrained field equations as the thesis has them (7.2).
///
/// \implements{eq_7_2}
/// @param j       second jet of the section
/// @param lambda  first jet of the multiplier at the same point, with the sign of the thesis: minus that of \ref AugmentedDensity
/// @return        a component for each a, per unit of \f$d^{n+1}x\f$: zero along solutions that satisfy the constraint
/// @throws NoDerivative  where the density or the constraint has none
/// Accuracy: exact but for rounding.
template <class S, int n, int N, class L, class Phi>
  requires DensityOver<L, S, n, N> && ConstraintOver<Phi, S, n, N>
Matrix<S, N, 1> constrained_field_equations(L const& density, Phi const& constraint, SecondJet<S, n, N> const& j,
                                                   Jet<S, n, Phi::components> const& lambda) {
  auto const& jet = static_cast<Jet<S, n, N> const&>(j);
  detail::examine(density, jet);
  detail::examine(constraint, jet);
  // [eq_7_2]
  Matrix<S, N, 1> const r = momentum_divergence(density, j) - place_derivative(density, jet) + reaction(constraint, j, lambda);
  // [eq_7_2]
  detail::require_derivative(r, jet, "constrained_field_equations");
  return r;
}

}  // namespace actio
