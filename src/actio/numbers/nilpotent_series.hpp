// Power series of nilpotent matrices: finite sums, over any field.
//
// In a unipotent group every product of more than n - 1 matrices of the algebra vanishes, and so do exp, log
// and iex after their n-th term. Over a field without transcendental functions these finite sums are all that
// is left of them, and nothing is rounded.
#pragma once

#include "actio/numbers/dual.hpp"
#include "actio/numbers/errors.hpp"

namespace actio {

/// \f$\sum_n c_n w^n\f$ of a nilpotent matrix.
/// @param w            square
/// @param coefficient  \f$c_n\f$ as a function of n
/// @param where        who asks, for the message
/// @throws NotInThisField  where w is not nilpotent
template <class M, class Coefficient>
typename M::PlainObject nilpotent_series(M const& w, Coefficient const& coefficient, char const* where) {
  using S = typename M::Scalar;
  typename M::PlainObject power = M::PlainObject::Identity(w.rows(), w.cols()),
                          sum = power * S(coefficient(0));
  for (int n = 1; n <= w.rows(); ++n) {
    power = typename M::PlainObject(power * w);
    sum += power * S(coefficient(n));
  }
  if (magnitude(power) != Base<S>(0))
    throw NotInThisField(where,
                         "over a field without transcendental functions the matrix must be nilpotent; "
                         "largest entry of its n-th power",
                         to_double(magnitude(power)), 0);
  return sum;
}

/// 1/n!
template <class S>
Base<S> one_over_factorial(int n) {
  Base<S> r(1);
  for (int k = 2; k <= n; ++k) r /= Base<S>(k);
  return r;
}

/// The logarithm of a matrix that differs from the identity by a nilpotent one.
/// @throws NotInThisField  where it does not
template <class M>
typename M::PlainObject nilpotent_logarithm(M const& a) {
  using S = typename M::Scalar;
  typename M::PlainObject w = a;
  for (int i = 0; i < w.rows(); ++i) w(i, i) -= S(1);
  return nilpotent_series(
      w, [](int n) { return n == 0 ? Base<S>(0) : Base<S>(Base<S>(n % 2 ? 1 : -1) / Base<S>(n)); }, "log");
}

}  // namespace actio
