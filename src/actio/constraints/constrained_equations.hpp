// The constrained field equations with a given multiplier (7.2), written out term by term.
//
// `AugmentedDensity` has the same equations by way of the extended bundle. These need no extended bundle, and
// have the sign of the thesis: they belong to L - <lambda, Phi>.
#pragma once

#include "actio/constraints/constraint.hpp"
#include "actio/jets/field_equations.hpp"

namespace actio {

/// The pairing \f$\langle\lambda(x), \Phi\rangle\f$ of a constraint with a given multiplier, as a density.
/// Around the point of a jet of the multiplier it has the right first derivatives, and that is all that field
/// equations there ask for.
template <class R, int n, class Phi>
struct PairedConstraint {
  Phi const& constraint;              ///< \f$\Phi\f$
  Jet<R, n, Phi::components> lambda;  ///< first jet of the multiplier

  /// Its value at a jet.
  template <class S, int N>
  S operator()(Jet<S, n, N> const& jet) const {
    Event<S, n> const away = jet.x - lambda.x.template cast<S>();
    Matrix<S, Phi::components, 1> const multiplier =
                                            lambda.y.template cast<S>() + lambda.v.template cast<S>() * away,
                                        value = constraint(jet);
    return multiplier.dot(value);
  }
};

/// What the multiplier contributes: \f$\langle\lambda, \partial\Phi/\partial
/// y^a\rangle - D_\mu\langle\lambda, \partial\Phi/\partial v^a{}_\mu\rangle\f$, the Euler-Lagrange derivative
/// of the pairing. Minus this is the force of the constraint in (7.2).
/// @param j       second jet of the section
/// @param lambda  first jet of the multiplier at the same point, \ref first_jet
template <class S, int n, int N, class Phi>
  requires ConstraintOver<Phi, S, n, N>
Matrix<S, N, 1> reaction(Phi const& constraint, SecondJet<S, n, N> const& j,
                         Jet<S, n, Phi::components> const& lambda) {
  return euler_lagrange(PairedConstraint<S, n, Phi>{constraint, lambda}, j);
}

/// The left side of the constrained field equations as the thesis has them (7.2).
///
/// \implements{eq_7_2}
/// @param j       second jet of the section
/// @param lambda  first jet of the multiplier at the same point, with the sign of the thesis: minus that of
///                \ref AugmentedDensity
/// @return        a component for each a, per unit of \f$d^{n+1}x\f$: zero along solutions that satisfy the
///                constraint
/// @throws NoDerivative  where the density or the constraint has none
/// Accuracy: exact but for rounding.
template <class S, int n, int N, class L, class Phi>
  requires DensityOver<L, S, n, N> && ConstraintOver<Phi, S, n, N>
Matrix<S, N, 1> constrained_field_equations(L const& density, Phi const& constraint,
                                            SecondJet<S, n, N> const& j,
                                            Jet<S, n, Phi::components> const& lambda) {
  auto const& jet = static_cast<Jet<S, n, N> const&>(j);
  examine(density, jet);
  examine(constraint, jet);
  // [eq_7_2]
  Matrix<S, N, 1> const r =
      momentum_divergence(density, j) - partial_y(density, jet) + reaction(constraint, j, lambda);
  // [eq_7_2]
  require_derivative(r, jet, "constrained_field_equations");
  return r;
}

}  // namespace actio
