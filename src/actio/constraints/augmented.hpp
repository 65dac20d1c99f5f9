// The multiplier as a field: the extended bundle and the augmented density (section 7.2 of the thesis).
//
// Over a point of X the fibre of the extended bundle E has the coordinates y^1, ..., y^N, lambda^1, ...,
// lambda^k in one column, so a jet of E is a jet over (n, N + k). The sign is that of chapter 8, L + <lambda,
// Phi>: with Phi = J - 1 the multiplier is a pressure, positive in compression. The theorem and (7.2)
// subtract the pairing, which is the same with -lambda.
#pragma once

#include "actio/constraints/constraint.hpp"

namespace actio {

/// The part of a jet of E that is a jet of the configuration bundle: its first N components.
template <int N, class S, int n, int M>
Jet<S, n, N> configuration(Jet<S, n, M> const& jet) {
  static_assert(N < M, "a jet of the extended bundle has the multipliers as its last components");
  return {jet.x, jet.y.template head<N>(), jet.v.template topRows<N>()};
}
/// The part that belongs to the multipliers: the last k components, as a jet of their own bundle.
template <int k, class S, int n, int M>
Jet<S, n, k> multiplier_part(Jet<S, n, M> const& jet) {
  static_assert(k < M, "a jet of the extended bundle has the point of space before the multipliers");
  return {jet.x, jet.y.template tail<k>(), jet.v.template bottomRows<k>()};
}

/// A section of E from a section of the configuration bundle and one of the multipliers.
template <class Section, class Multiplier>
struct ExtendedSection {
  Section phi;  ///< \f$\phi\f$
  /// \f$\lambda\f$, a callable on points of space-time that returns a column of k numbers
  Multiplier lambda;

  /// Point of space and multiplier at a point of space-time, in one column.
  template <class V>
  auto operator()(V const& x) const {
    auto const y = phi(x);
    auto const l = lambda(x);
    constexpr int N = decltype(y)::RowsAtCompileTime, k = decltype(l)::RowsAtCompileTime;
    Matrix<typename V::Scalar, N + k, 1> both;
    both << y, l;
    return both;
  }
};
/// The section of E that its parts make.
template <class Section, class Multiplier>
ExtendedSection(Section, Multiplier) -> ExtendedSection<Section, Multiplier>;

/// The augmented density \f$L_\Phi = L + \langle\lambda, \Phi\rangle\f$ over jets of E: its field equations
/// are the constrained ones and \f$\Phi = 0\f$.
///
/// \snippet fields.cpp augmented_density
///
/// \implements{claim_7_2_augmented_lagrangian}
/// @tparam L    density over jets with (n, N)
/// @tparam Phi  constraint over the same jets, with k components
template <class L, class Phi>
struct AugmentedDensity {
  static constexpr int components = Phi::components;  ///< how many multipliers there are
  L density;                                          ///< over jets with (n, N)
  Phi constraint;                                     ///< over the same jets

  /// Its value at a jet of E.
  template <class S, int n, int M>
  S operator()(Jet<S, n, M> const& jet) const {
    auto const j = configuration<M - components>(jet);
    Matrix<S, components, 1> const value = constraint(j), lambda = jet.y.template tail<components>();
    S sum = density(j);
    // [claim_7_2_augmented_lagrangian]
    for (int i = 0; i < components; ++i) sum += lambda[i] * value[i];
    // [claim_7_2_augmented_lagrangian]
    return sum;
  }

  /// Refuses what the density and the constraint refuse.
  template <class S, int n, int M>
  void examine(Jet<S, n, M> const& jet) const {
    auto const j = configuration<M - components>(jet);
    actio::examine(density, j);
    actio::examine(constraint, j);
  }
};
/// The augmented density of a density and a constraint.
template <class L, class Phi>
AugmentedDensity(L, Phi) -> AugmentedDensity<L, Phi>;

}  // namespace actio
