// Small linear systems over any field: elimination with row exchanges.
//
// Written out because it must run over rationals and nested dual numbers, and because for six unknowns it
// compiles in half the time of a general decomposition. Pivots are chosen by their plain value, so a dual
// number with value zero is never one.
#pragma once

#include <type_traits>
#include <utility>

#include "actio/numbers/dual.hpp"
#include "actio/numbers/errors.hpp"

namespace actio {

namespace detail {

/// The size that the elimination is compiled for. A fixed size makes it quicker over machine numbers; over
/// others it does not, and one for all sizes compiles sooner.
template <class S, int size>
inline constexpr int compiled_size = std::is_arithmetic_v<Base<S>> ? size : Dynamic;

/// What tells a pivot from rounding noise.
template <class T, int size>
struct PivotScale {
  Matrix<T, size, size> terms;  ///< of each entry the largest term that it is made from, so far
  Matrix<T, size, 1> per_row;   ///< one over the largest entry of each row; 0 where there is none
};

/// The scale of a matrix before its elimination.
template <class S, int size>
[[gnu::always_inline]] inline PivotScale<Base<S>, size> pivot_scale(Matrix<S, size, size> const& a) {
  using T = Base<S>;
  int const n = static_cast<int>(a.rows());
  PivotScale<T, size> scale{Matrix<T, size, size>(n, n), Matrix<T, size, 1>(n)};
  for (int i = 0; i < n; ++i) {
    T largest(0);
    for (int j = 0; j < n; ++j) {
      scale.terms(i, j) = magnitude(base_value(a(i, j)));
      if (scale.terms(i, j) > largest) largest = scale.terms(i, j);
    }
    scale.per_row[i] = largest > T(0) ? T(T(1) / largest) : T(0);
  }
  return scale;
}

/// Exchanges row k with the one that has the largest pivot for its scale, among those from k on.
/// @param bound  what a pivot is over the terms it is made from, at least
/// @throws Singular  where none is above the bound
template <class S, int size, int columns>
[[gnu::always_inline]] inline void exchange_for_pivot(int k, Matrix<S, size, size>& a,
                                                      MatrixView<S, size, columns>& x,
                                                      PivotScale<Base<S>, size>& scale, Base<S> const& bound,
                                                      char const* where) {
  using T = Base<S>;
  int const n = static_cast<int>(a.rows());
  int pivot = k;
  T best = magnitude(base_value(a(k, k))) * scale.per_row[k];
  for (int i = k + 1; i < n; ++i) {
    T const candidate = magnitude(base_value(a(i, k))) * scale.per_row[i];
    if (candidate > best) pivot = i, best = candidate;
  }
  T const found = magnitude(base_value(a(pivot, k)));
  if (!(found > bound * scale.terms(pivot, k))) {
    T const of = scale.terms(pivot, k);
    throw Singular(where, "a matrix with an inverse is needed; pivot over the terms it is made from",
                   of > T(0) ? to_double(T(found / of)) : 0.0, to_double(bound));
  }
  if (pivot == k) return;
  using std::swap;
  for (int j = 0; j < n; ++j) swap(a(k, j), a(pivot, j)), swap(scale.terms(k, j), scale.terms(pivot, j));
  for (int j = 0; j < x.cols(); ++j) swap(x(k, j), x(pivot, j));
  swap(scale.per_row[k], scale.per_row[pivot]);
}

/// The solution, from the upper triangle that elimination leaves, with the inverses of the pivots on its
/// diagonal.
template <class S, int size, int columns>
[[gnu::always_inline]] inline void substitute_back(Matrix<S, size, size> const& a,
                                                   MatrixView<S, size, columns>& x) {
  int const n = static_cast<int>(a.rows());
  for (int k = n - 1; k >= 0; --k)
    for (int j = 0; j < x.cols(); ++j) {
      S sum = x(k, j);
      for (int i = k + 1; i < n; ++i) sum -= a(k, i) * x(i, j);
      x(k, j) = sum * a(k, k);
    }
}

/// Elimination in place, \ref solve_linear: a is lost, and x, the right sides, becomes the solution.
template <class S, int size, int columns>
void eliminate(Matrix<S, size, size>& a, MatrixView<S, size, columns> x, char const* where) {
  using T = Base<S>;
  require_finite(a, where);
  require_finite(x, where);
  int const n = static_cast<int>(a.rows());
  auto scale = pivot_scale(a);
  // Elimination divides again and again: what a scalar knows of the degrees of its numbers is better told by
  // Cramer's rule.
  [[maybe_unused]] double degree = 0;
  if constexpr (ChosenAtRunTime<T>) degree = T::degree_of_solution(a, x);

  // Eight roundings for each of the n terms: entries that come out of a computation carry a few of their own.
  T const bound = T(8 * n) * epsilon<S>();
  for (int k = 0; k < n; ++k) {
    exchange_for_pivot(k, a, x, scale, bound, where);
    S const inverse = S(1) / a(k, k);
    for (int i = k + 1; i < n; ++i) {
      S const factor = a(i, k) * inverse;
      for (int j = k + 1; j < n; ++j) {
        S const term = factor * a(k, j);
        a(i, j) -= term;
        T const subtracted = magnitude(base_value(term));
        if (subtracted > scale.terms(i, j)) scale.terms(i, j) = subtracted;
      }
      for (int j = 0; j < x.cols(); ++j) x(i, j) -= factor * x(k, j);
    }
    a(k, k) = inverse;
  }
  substitute_back(a, x);
  if constexpr (ChosenAtRunTime<T>) T::bound_degrees(x, degree);
  if constexpr (!is_exact<S>)
    for (Index j = 0; j < x.cols(); ++j)
      for (int i = 0; i < n; ++i)
        if (!is_finite(base_value(x(i, j))))
          throw NotFinite(std::string(where) + ": the solution is beyond the largest number");
}

}  // namespace detail

/// The solution X of A X = B, for one or several right sides.
///
/// Rows and columns may have different units: pivots are chosen relative to their row, and a pivot counts as
/// rounding noise by comparison with the terms whose difference it is, never with entries elsewhere.
///
/// \snippet numbers.cpp solve_linear
/// @param where  who asks, for the message
/// @throws Singular   where a pivot is rounding noise: (pivot)/(largest term it was made from), and the bound
/// @throws NotFinite  where an entry is a NaN or an infinity, or where the solution would be
/// Accuracy: that of elimination with partial pivoting; exact over the rationals.
template <MatrixLike A, MatrixLike B>
auto solve_linear(A const& matrix, B const& right, char const* where = "solve_linear") {
  using S = typename A::Scalar;
  constexpr int size = detail::compiled_size<S, A::RowsAtCompileTime>,
                columns = detail::compiled_size<S, B::ColsAtCompileTime>;
  Matrix<S, size, size> a = matrix;
  Matrix<S, B::RowsAtCompileTime, B::ColsAtCompileTime> x = right.template cast<S>();
  detail::eliminate<S, size, columns>(
      a, MatrixView<S, size, columns>(x.data(), x.rows(), x.cols(), 1, x.rows()), where);
  return x;
}

/// The inverse of a square matrix over any field.
template <MatrixLike A>
auto inverse_matrix(A const& matrix, char const* where = "inverse_matrix") {
  typename A::PlainObject const identity = A::PlainObject::Identity(matrix.rows(), matrix.cols());
  return solve_linear(matrix, identity, where);
}

}  // namespace actio
