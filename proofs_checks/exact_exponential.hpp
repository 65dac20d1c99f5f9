// exp, log, iex and chi over the rationals, where they are polynomials: on unipotent groups. Include before actio/reduction/natural_chart.hpp.
//
// There every product of more than n-1 matrices of the algebra vanishes, and so do the series after their n-th term. What follows are those series, added
// up from the definition; with them the library's charts and discrete Lagrangians run over the rationals (dual numbers over them included) and nothing is rounded.
#pragma once

#include <utility>

#include "actio/foundations/groups/spanned_group.hpp"
#include "actio/foundations/group.hpp"

namespace actio {

/// \f$\sum_n c_n w^n\f$ of a nilpotent matrix. @throws OutsideDomain where w is not nilpotent
template <class M, class Coefficient>
typename M::PlainObject nilpotent_series(Eigen::MatrixBase<M> const& w, Coefficient const& coefficient) {
  using S = typename M::Scalar;
  typename M::PlainObject power = M::PlainObject::Identity(w.rows(), w.cols()), sum = power * S(coefficient(0));
  for (int n = 1; n <= w.rows(); ++n) {
    power = power * w;
    sum += power * S(coefficient(n));
  }
  if (magnitude(power) != Base<S>(0)) throw OutsideDomain("exact exponential", "the matrix must be nilpotent", to_double(magnitude(power)), 0);
  return sum;
}
/// 1/n!
template <class S>
Base<S> one_over_factorial(int n) {
  Base<S> r(1);
  for (int k = 2; k <= n; ++k) r /= Base<S>(k);
  return r;
}

/// iex from its definition (3.21).
template <class M>
  requires is_exact<typename M::Scalar>
typename M::PlainObject iex(Eigen::MatrixBase<M> const& w) {
  return nilpotent_series(w, [](int n) { return one_over_factorial<typename M::Scalar>(n + 1); });
}
/// chi as the inverse of iex.
template <class M>
  requires is_exact<typename M::Scalar>
typename M::PlainObject chi(Eigen::MatrixBase<M> const& w) {
  return inverse_matrix(iex(w), "chi");
}
/// exp from its series.
template <class S>
  requires is_exact<S>
Element<SpannedGroup, S> exp(Velocity<SpannedGroup, S> const& v) {
  return {v.group, nilpotent_series(v.group.hat(v.coordinates), [](int n) { return one_over_factorial<S>(n); })};
}
/// log from its series.
template <class S>
  requires is_exact<S>
Velocity<SpannedGroup, S> log(Element<SpannedGroup, S> const& g) {
  typename Storage<SpannedGroup, S>::PlainObject w = g.value;
  w.diagonal().array() -= S(1);
  return {g.group, g.group.vee(nilpotent_series(w, [](int n) { return n == 0 ? Base<S>(0) : Base<S>(n % 2 ? 1 : -1) / Base<S>(n); }))};
}

}  // namespace actio
