// The covariant divergence of a two-point tensor along a section (section 6.2 of the thesis).
//
// A two-point tensor has one leg in the body and one in space, at a point and its image. Here it is a
// callable on first jets, T(jet), over any scalar, whose value has a row for each lower index a of space and
// a column for each upper index i of the body, as the first Piola-Kirchhoff stress has.
#pragma once

#include "actio/continuum/stresses.hpp"

namespace actio {

/// A two-point tensor at a jet, and the sum \f$D_iT_a{}^i\f$ of its total derivatives.
template <class S, int n, int N>
struct TwoPointRates {
  Matrix<S, N, n> value;       ///< \f$T_a{}^i\f$
  Matrix<S, N, 1> divergence;  ///< \f$D_iT_a{}^i\f$, without Christoffel symbols
};
/// The value of a two-point tensor along a section and the sum \f$D_iT_a{}^i\f$ of its total derivatives.
/// @param T  two-point tensor: a callable on first jets, over any scalar
/// @param j  second jet of the section
template <class S, int n, int N, class Tensor>
TwoPointRates<S, n, N> two_point_rates(Tensor const& T, SecondJet<S, n, N> const& j) {
  TwoPointRates<S, n, N> rates;
  rates.divergence.setZero();
  for (int i = 0; i < n; ++i) {
    auto const [value, D_i] = along_section(i + 1, T, j);
    rates.value.col(i) = value.col(i);
    rates.divergence += D_i.col(i);
  }
  return rates;
}

/// The sum \f$D_iT_a{}^i\f$ of the total derivatives of a two-point tensor, without Christoffel symbols.
/// @param T  two-point tensor: a callable on first jets, over any scalar
/// @param j  second jet of the section
template <class S, int n, int N, class Tensor>
Matrix<S, N, 1> total_divergence(Tensor const& T, SecondJet<S, n, N> const& j) {
  return two_point_rates(T, j).divergence;
}

/// The covariant divergence \f$T_a{}^i{}_{|i} = \partial_iT_a{}^i + T_a{}^j\,\Gamma^k_{jk}
/// - T_b{}^j\,\gamma^b_{ac}\,F^c{}_j\f$ along a section.
///
/// The thesis prints \f$T_b{}^i\f$ and \f$F^c{}_j\f$ in the last term; i and j are one index, summed.
///
/// \implements{claim_6_2_covariant_divergence}
/// @param G, g  metrics of body and space; constant ones have no Christoffel symbols and cost nothing
/// @param j     second jet of the section
/// @param T     two-point tensor: a callable on first jets, over any scalar
/// @return      a covector of space: a component for each a
/// Accuracy: exact but for the rounding of T and of the metrics.
template <class BodyMetric, class SpaceMetric, class S, int n, int N, class Tensor>
Matrix<S, N, 1> two_point_divergence(BodyMetric const& G, SpaceMetric const& g, SecondJet<S, n, N> const& j,
                                     Tensor const& T) {
  auto const rates = two_point_rates(T, j);
  Matrix<S, N, 1> sum = rates.divergence;
  // [claim_6_2_covariant_divergence]
  if constexpr (!is_constant_metric<BodyMetric>) {
    auto const Gamma = christoffel(G, j.particle());
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) sum += rates.value.col(i) * Gamma[k](i, k);
  }
  if constexpr (!is_constant_metric<SpaceMetric>) {
    auto const gamma = christoffel(g, j.y);
    Matrix<S, N, N> const on_space = rates.value * j.gradient().transpose();
    for (int a = 0; a < N; ++a)
      for (int b = 0; b < N; ++b)
        for (int c = 0; c < N; ++c) sum[a] -= gamma[b](a, c) * on_space(b, c);
  }
  // [claim_6_2_covariant_divergence]
  return sum;
}

/// What Piola's identity says is zero: the covariant divergence of \f$J\,(F^{-1})^i{}_a\f$ along a section.
///
/// Zero at the second jet of a section; not at other points with \f$w^a{}_{ik} \ne w^a{}_{ki}\f$.
///
/// \implements{claim_6_2_cancelling_terms}
/// @throws Singular  where F has no inverse
template <class BodyMetric, class SpaceMetric, class S, int n>
Matrix<S, n, 1> piola_identity(BodyMetric const& G, SpaceMetric const& g, SecondJet<S, n, n> const& j) {
  // [claim_6_2_cancelling_terms]
  return two_point_divergence(G, g, j, [&](auto const& jet) {
    return area_transformation(G(jet.particle()), g(jet.y), jet.gradient());
  });
  // [claim_6_2_cancelling_terms]
}

}  // namespace actio
