// Pointwise constraints on first jets, and what they are along a section (section 7.2 of the thesis).
//
// A constraint is a callable Phi on first jets with k components, over any scalar, and says how many:
// `static constexpr int components`. It may have a member `examine(jet)` that refuses a jet.
// `constraint<k>(callable)` makes one from any callable.
#pragma once

#include "actio/constraints/regularity.hpp"
#include "actio/jets/density.hpp"

namespace actio {

/// A constraint over jets with n and N: `Phi(jet)` has `Phi::components` numbers.
template <class Phi, class S, int n, int N>
concept ConstraintOver = requires(Phi const& phi, Jet<S, n, N> const& jet) {
  { Phi::components } -> std::convertible_to<int>;
  { Matrix<S, Phi::components, 1>(phi(jet)) };
};

/// A callable with k components as a constraint.
template <int k, class F>
struct Constraint {
  static constexpr int components = k;  ///< how many numbers it has
  F phi;                                ///< a callable on first jets that returns a column of k numbers

  /// Its components at a jet.
  template <class S, int n, int N>
  Matrix<S, k, 1> operator()(Jet<S, n, N> const& jet) const { return phi(jet); }
};
/// A callable with k components as a constraint.
template <int k, class F>
Constraint<k, F> constraint(F phi) { return {std::move(phi)}; }

/// The induced constraint \f$\Psi(\phi)(x) = \Phi((j^1\phi)(x))\f$ of a section (7.1): a callable on points
/// of space-time.
///
/// \implements{eq_7_1}
/// Accuracy: exact but for the rounding of phi and Phi.
template <class Phi, class Section>
auto induced_constraint(Phi const& constraint, Section const& phi) {
  return [constraint, phi]<class S, int rows>(Matrix<S, rows, 1> const& x) -> Matrix<S, Phi::components, 1> {
    // [eq_7_1]
    return constraint(first_jet(phi, x));
    // [eq_7_1]
  };
}

/// The derivative of a constraint at a jet by the point of space and the velocities,
/// \f$(\partial\Phi/\partial y^a,\ \partial\Phi/\partial v^a{}_\mu)\f$: a row for each component, columns as
/// in \ref coordinates without x.
template <class S, int n, int N, class Phi>
  requires ConstraintOver<Phi, S, n, N>
auto constraint_derivative(Phi const& constraint, Jet<S, n, N> const& jet) {
  constexpr int directions = N * (n + 2);
  // A jet over the same x from y and v in one column.
  auto const over_x = [&](auto const& fibre) {
    using T = typename std::remove_cvref_t<decltype(fibre)>::Scalar;
    Jet<T, n, N> moved{jet.x.template cast<T>(), fibre.template head<N>(), {}};
    for (int mu = 0; mu <= n; ++mu) moved.v.col(mu) = fibre.template segment<N>(N * (mu + 1));
    return Matrix<T, Phi::components, 1>(constraint(moved));
  };
  auto const rate =
      derivative(over_x, Matrix<S, directions, 1>(coordinates(jet).template tail<directions>())).matrix;
  require_derivative(rate, jet, "constraint_derivative");
  return rate;
}

/// Refuses a jet at which the derivative of the constraint by y and v is not onto: the jets over
/// x that satisfy it need not be a submanifold.
///
/// That is the local half of the hypothesis of the multiplier theorem. The other half is about sections and
/// their boundary values: with them a volume, for instance, is fixed, and the multiplier is free up to a
/// constant.
/// @throws NotRegular  with the \ref coordinates of the jet
template <class S, int n, int N, class Phi>
  requires ConstraintOver<Phi, S, n, N>
void require_regular(Phi const& constraint, Jet<S, n, N> const& jet) {
  require_onto(constraint_derivative(constraint, jet), coordinates(jet), "constraint");
}

}  // namespace actio
