// Small linear systems over any field: elimination with row exchanges.
//
// Written out because it must run over rationals and nested dual numbers, and because for six unknowns it compiles in half
// the time of a general decomposition. Pivots are chosen by their plain value, so a dual number with value zero is never one.
#pragma once

#include <utility>

#include "actio/foundations/dual.hpp"
#include "actio/foundations/errors.hpp"

namespace actio {

/// The cross product of 3-space.
template <class A, class B>
Eigen::Matrix<typename A::Scalar, 3, 1> cross(Eigen::MatrixBase<A> const& v, Eigen::MatrixBase<B> const& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

/// The solution X of A X = B, for one or several right sides.
///
/// @param where  who asks, for the message
/// @throws Singular  where a pivot falls below rounding: (smallest pivot)/(largest entry) and its bound
/// Accuracy: that of elimination with partial pivoting; exact over the rationals.
template <class A, class B>
auto solve_linear(Eigen::MatrixBase<A> const& matrix, Eigen::MatrixBase<B> const& right, char const* where = "solve_linear") {
  using S = typename A::Scalar;
  using Right = Eigen::Matrix<S, B::RowsAtCompileTime, B::ColsAtCompileTime>;
  typename A::PlainObject a = matrix;
  Right x = right.template cast<S>();
  Eigen::Index const n = a.rows();

  // A pivot that is rounding noise beside the entries it came from means that the matrix has no inverse.
  Base<S> largest(0);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      Base<S> const size = magnitude(base_value(a(i, j)));
      if (!(size <= largest)) largest = size;
    }
  Base<S> const floor = Base<S>(static_cast<long>(n)) * epsilon<S>() * largest;

  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < n; ++i)
      if (magnitude(base_value(a(i, k))) > magnitude(base_value(a(pivot, k)))) pivot = i;
    Base<S> const size = magnitude(base_value(a(pivot, k)));
    if (!(size > floor)) {
      double const scale = to_double(largest);
      throw Singular(where, "a matrix with an inverse is needed; smallest pivot over largest entry",
                     scale > 0 ? to_double(size) / scale : 0.0, to_double(floor) / (scale > 0 ? scale : 1.0));
    }
    if (pivot != k) {
      a.row(k).swap(a.row(pivot));
      x.row(k).swap(x.row(pivot));
    }
    S const inverse = S(1) / a(k, k);
    for (Eigen::Index i = k + 1; i < n; ++i) {
      S const factor = a(i, k) * inverse;
      for (Eigen::Index j = k + 1; j < n; ++j) a(i, j) -= factor * a(k, j);
      for (Eigen::Index j = 0; j < x.cols(); ++j) x(i, j) -= factor * x(k, j);
    }
    a(k, k) = inverse;
  }
  for (Eigen::Index k = n - 1; k >= 0; --k)
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
      S sum = x(k, j);
      for (Eigen::Index i = k + 1; i < n; ++i) sum -= a(k, i) * x(i, j);
      x(k, j) = sum * a(k, k);
    }
  return x;
}

/// The inverse of a square matrix over any field.
template <class A>
auto inverse_matrix(Eigen::MatrixBase<A> const& matrix, char const* where = "inverse_matrix") {
  typename A::PlainObject const identity = A::PlainObject::Identity(matrix.rows(), matrix.cols());
  return solve_linear(matrix, identity, where);
}

}  // namespace actio
