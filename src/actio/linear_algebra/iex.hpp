// The function iex of (3.21) and its inverse, on square matrices: what the differential of the exponential is
// made of.
//
// exp(eta + d eta) = (1 + iex(ad_eta) d eta) exp(eta) = exp(eta) (1 + iex(-ad_eta) d eta): the plus sign
// belongs to the right translation, where the bracket is the commutator.
#pragma once

#include "actio/linear_algebra/linear.hpp"
#include "actio/numbers/functions.hpp"
#include "actio/numbers/nilpotent_series.hpp"

namespace actio {

/// Largest sum of moduli along a row, by plain values.
template <MatrixLike Derived>
double row_norm(Derived const& m) {
  double norm = 0;
  for (Index i = 0; i < m.rows(); ++i) {
    double sum = 0;
    for (Index j = 0; j < m.cols(); ++j) sum += std::abs(to_double(typename Derived::Scalar(m(i, j))));
    if (sum != sum) return sum;
    if (sum > norm) norm = sum;
  }
  return norm;
}

/// How often a matrix has to be halved to have norm at most 1/2.
/// @throws NotFinite  where an entry is no number
template <MatrixLike Derived>
int halvings(Derived const& m, char const* where) {
  double const norm = row_norm(m);
  if (!std::isfinite(norm)) throw NotFinite(where);
  int s = 0;
  for (double n = norm; n > 0.5; n /= 2) ++s;
  return s;
}

/// \f$\mathrm{iex}(w) = \sum_{n\ge0} w^n/(n+1)!\f$ of a square matrix; \f$w\,\mathrm{iex}(w) = e^w - 1\f$.
///
/// Where the arithmetic has no transcendental functions w must be nilpotent.
///
/// \snippet numbers.cpp iex
///
/// \implements{eq_3_21}
/// @throws NotInThisField  over an exact arithmetic, where w is not nilpotent
/// Accuracy: a few epsilon times \f$e^{|w|}\f$ (series on w/2^s, then doubling).
template <MatrixLike M>
  requires Real<typename M::Scalar>
typename M::PlainObject iex(M const& w) {
  using S = typename M::Scalar;
  using Matrix = typename M::PlainObject;
  if (exact_arithmetic<S>())
    return nilpotent_series(
        w, [](int n) { return one_over_factorial<S>(n + 1); }, "iex");
  int const s = halvings(w, "iex");
  Base<S> scale(1);
  for (int i = 0; i < s; ++i) scale /= Base<S>(2);
  Matrix const small = w * S(scale);
  Matrix const one = Matrix::Identity(w.rows(), w.cols());

  // [eq_3_21]
  Matrix sum = one;
  for (int n = exponential_terms<S>(0.5); n >= 1; --n) sum = one + small * sum / S(n + 1);
  // [eq_3_21]

  // Double the argument: iex(2w) = iex(w) (e^w + 1)/2 with e^w = 1 + w iex(w).
  Matrix half = small;
  for (int i = 0; i < s; ++i) {
    Matrix const exponential_less_one = half * sum;
    sum += sum * exponential_less_one / S(2);
    half *= S(2);
  }
  return sum;
}

/// \f$\chi\f$, the inverse of \ref iex: \f$\chi(w)\,\mathrm{iex}(w) = 1\f$.
///
/// \implements{claim_3_3_chi_function}
/// @throws Singular  where iex(w) has no inverse: an eigenvalue of w at a nonzero multiple of 2 pi i
template <MatrixLike M>
  requires Real<typename M::Scalar>
auto chi(M const& w) {
  // [claim_3_3_chi_function]
  return inverse_matrix(iex(w), "chi");
  // [claim_3_3_chi_function]
}

/// \f$e^w\f$ of a square matrix: \f$1 + w\,\mathrm{iex}(w)\f$ of a small fraction of w, squared as often as
/// it takes.
///
/// Not of w itself, where the two terms would cancel as the matrix contracts. Where the arithmetic has no
/// transcendental functions w must be nilpotent.
///
/// \snippet numbers.cpp matrix_exponential
/// @throws NotInThisField  over an exact arithmetic, where w is not nilpotent
/// Accuracy: a few epsilon times the size of w.
template <MatrixLike M>
  requires Real<typename M::Scalar>
typename M::PlainObject matrix_exponential(M const& w) {
  using S = typename M::Scalar;
  if (exact_arithmetic<S>())
    return nilpotent_series(
        w, [](int n) { return one_over_factorial<S>(n); }, "exp");
  int const s = halvings(w, "exp");
  Base<S> scale(1);
  for (int i = 0; i < s; ++i) scale /= Base<S>(2);
  typename M::PlainObject const small = w * S(scale);
  typename M::PlainObject e = small * iex(small);
  e.diagonal().array() += S(1);
  for (int i = 0; i < s; ++i) e = (e * e).eval();
  return e;
}

}  // namespace actio
