// Whether a linear map is onto, with the measured pivot, and the vectors that it sends to zero.
//
// A constraint is regular where its derivative is onto: there its zeros are a submanifold, and multipliers
// exist (section 7.1 of the thesis).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "actio/linear_algebra/linear.hpp"

namespace actio {

/// A constraint whose derivative is not onto at a point: its zeros need not be a submanifold there, and a
/// multiplier need not exist.
struct NotRegular : OutsideDomain {
  std::vector<double> point;  ///< where
  /// @param at  the point, @param pivot  the smallest one over its terms, @param bound  what it has to exceed
  NotRegular(std::string const& where, std::vector<double> at, double pivot, double bound)
      : OutsideDomain(where + " at " + shown(at), required, pivot, bound), point(std::move(at)) {}

 private:
  static constexpr std::string_view required =
      "the derivative of the constraint is onto; smallest pivot over the terms it is made from";
  static std::string shown(std::vector<double> const& at) {
    std::string text = "(";
    for (double const x : at) text += (text.size() > 1 ? ", " : "") + show(x);
    return text + ")";
  }
};

/// A linear map brought to echelon form by elimination with full pivoting: its rank, how clear that is, and
/// its kernel.
template <class S>
struct Echelon {
  /// the first `rank` rows have the identity in the first `rank` of the exchanged columns
  Matrix<S, Dynamic, Dynamic> matrix;
  std::vector<int> column;  ///< where the columns came from
  int rank = 0;             ///< how many pivots stand out of rounding
  /// the last pivot that was tried, over the largest term it was made from: 0 where nothing was left
  double pivot = 1;
  double bound = 0;  ///< what a pivot has to exceed

  /// Whether the map reaches everything.
  bool onto() const { return rank == matrix.rows(); }

  /// A basis of the vectors that are sent to zero, as columns.
  Matrix<S, Dynamic, Dynamic> kernel() const {
    int const m = static_cast<int>(matrix.cols());
    Matrix<S, Dynamic, Dynamic> basis(m, m - rank);
    for (int c = rank; c < m; ++c) {
      for (int i = 0; i < m; ++i)
        basis(column[i], c - rank) = i < rank ? S(-matrix(i, c)) : S(i == c ? 1 : 0);
    }
    return basis;
  }
};

/// Brings a matrix to echelon form. Rows may have different units: each is measured by its own largest entry,
/// and a pivot counts as rounding noise by comparison with the terms whose difference it is.
/// @throws NotFinite  where an entry is a NaN or an infinity
/// Accuracy: exact over the rationals.
template <MatrixLike M>
Echelon<typename M::Scalar> echelon(M const& given) {
  using S = typename M::Scalar;
  using T = Base<S>;
  require_finite(given, "echelon");
  Echelon<S> e{given, {}};
  auto& a = e.matrix;
  int const k = static_cast<int>(a.rows()), m = static_cast<int>(a.cols());
  for (int c = 0; c < m; ++c) e.column.push_back(c);
  Matrix<T, Dynamic, Dynamic> terms(k, m);
  for (int i = 0; i < k; ++i) {
    T largest(0);
    for (int c = 0; c < m; ++c)
      if (T const size = magnitude(base_value(a(i, c))); size > largest) largest = size;
    // In units of its largest entry.
    if (largest > T(0)) a.row(i) *= S(T(T(1) / largest));
    for (int c = 0; c < m; ++c) terms(i, c) = magnitude(base_value(a(i, c)));
  }
  T const bound = T(8 * (k > m ? k : m)) * epsilon<S>();
  e.bound = to_double(bound);
  for (; e.rank < k; ++e.rank) {
    int const r = e.rank;
    int row = r, column = r;
    for (int i = r; i < k; ++i)
      for (int c = r; c < m; ++c)
        if (magnitude(base_value(a(i, c))) > magnitude(base_value(a(row, column)))) row = i, column = c;
    T const found = r < m ? T(magnitude(base_value(a(row, column)))) : T(0),
            of = r < m ? terms(row, column) : T(0);
    e.pivot = of > T(0) ? to_double(T(found / of)) : 0.0;
    if (!(found > bound * of)) break;
    a.row(r).swap(a.row(row)), a.col(r).swap(a.col(column));
    terms.row(r).swap(terms.row(row)), terms.col(r).swap(terms.col(column));
    std::swap(e.column[r], e.column[column]);
    S const inverse = S(1) / a(r, r);
    for (int c = r; c < m; ++c) a(r, c) *= inverse;
    for (int i = 0; i < k; ++i) {
      if (i == r) continue;
      S const factor = a(i, r);
      for (int c = r; c < m; ++c) {
        S const term = factor * a(r, c);
        a(i, c) -= term;
        if (T const size = magnitude(base_value(term)); size > terms(i, c)) terms(i, c) = size;
      }
    }
  }
  return e;
}

/// Refuses a derivative that is not onto.
/// @param at     the point, for the message
/// @param where  who asks
/// @throws NotRegular  with the point, the pivot and its bound
template <MatrixLike M, MatrixLike V>
void require_onto(M const& derivative, V const& at, char const* where) {
  auto const e = echelon(derivative);
  if (e.onto()) return;
  std::vector<double> point;
  for (Index i = 0; i < at.size(); ++i) point.push_back(to_double(base_value(at(i))));
  throw NotRegular(where, std::move(point), e.pivot, e.bound);
}

}  // namespace actio
