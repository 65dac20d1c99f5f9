// Products of matrices whose numbers are not the machine's: three plain loops in place of Eigen's blocked kernels.
//
// Eigen's product of matrices of any size is made for the registers and caches of machine numbers. For dual numbers, power series and multiprecision it is
// no faster than plain loops, and each kind of number costs the compiler a second for kernels that are never worth entering. The products of double stay Eigen's.
#pragma once

#include <Eigen/Core>

#include <type_traits>

#include "actio/numbers/matrix.hpp"

namespace actio {

namespace detail {

/// Whether products of matrices over S are the plain loops of this file. True for the library's own kinds of number, false for the machine's.
template <class S>
inline constexpr bool own_arithmetic = false;

/// Entries in memory, `inner` apart along a column and `outer` apart along a row.
template <class S>
struct Strided {
  S* data;                    ///< the entry (0, 0)
  Index inner, outer;  ///< steps from row to row, and from column to column

  /// The entry in row i and column j.
  S& operator()(Index i, Index j) const { return data[i * inner + j * outer]; }
};

/// out += sign a b, for an l x m matrix a and an m x n matrix b; `out` overlaps neither.
template <class S>
void add_plain_product(Strided<S> out, Strided<S const> a, Strided<S const> b, Index l, Index m, Index n, bool negative) {
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < l; ++i) {
      S sum(0);
      for (Index k = 0; k < m; ++k) add_product(sum, a(i, k), b(k, j));
      if (negative)
        out(i, j) -= sum;
      else
        out(i, j) += sum;
    }
}

/// Where the entries of an expression lie; one that is computed on the way is stored first.
template <class Expression>
decltype(auto) entries_in_memory(Expression const& e) {
  if constexpr (bool(Eigen::internal::traits<Expression>::Flags & Eigen::DirectAccessBit))
    return (e);
  else
    return e.eval();
}
template <class S, class Expression>
Strided<S> strided(Expression& e) {
  return {e.data(), e.rowStride(), e.colStride()};
}

/// What Eigen calls for a product over own arithmetic.
template <class Left, class Right>
struct PlainProduct {
  using S = typename Left::Scalar;

  template <class Out>
  static void add(Out& out, Left const& left, Right const& right, bool negative) {
    decltype(auto) a = entries_in_memory(left);
    decltype(auto) b = entries_in_memory(right);
    add_plain_product<S>(strided<S>(out), strided<S const>(a), strided<S const>(b), a.rows(), a.cols(), b.cols(), negative);
  }
  template <class Out>
  static void evalTo(Out& out, Left const& left, Right const& right) {
    out.setZero();
    add(out, left, right, false);
  }
  template <class Out>
  static void addTo(Out& out, Left const& left, Right const& right) {
    add(out, left, right, false);
  }
  template <class Out>
  static void subTo(Out& out, Left const& left, Right const& right) {
    add(out, left, right, true);
  }
  template <class Out>
  static void scaleAndAddTo(Out& out, Left const& left, Right const& right, S const& factor) {
    typename Left::PlainObject const scaled = factor * left;
    PlainProduct<typename Left::PlainObject, Right>::add(out, scaled, right, false);
  }
};

}  // namespace detail
}  // namespace actio

namespace Eigen::internal {

template <class Left, class Right>
  requires actio::detail::own_arithmetic<typename Left::Scalar>
struct generic_product_impl<Left, Right, DenseShape, DenseShape, GemmProduct> : actio::detail::PlainProduct<Left, Right> {};
template <class Left, class Right>
  requires actio::detail::own_arithmetic<typename Left::Scalar>
struct generic_product_impl<Left, Right, DenseShape, DenseShape, GemvProduct> : actio::detail::PlainProduct<Left, Right> {};

}  // namespace Eigen::internal
