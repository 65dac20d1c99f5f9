// Sums of multiples of short columns, in registers.
#pragma once

#include <concepts>
#include <utility>

#include "actio/matrices/matrix.hpp"

namespace actio::detail {

/// A sum of multiples of columns of one size, in `out`, which none of them is.
template <class V>
class ColumnSum {
  using S = typename V::Scalar;

 public:
  ColumnSum(V const& first, V& out) : out_(out) {
    for (Index k = 0; k < out.size(); ++k) out[k] = first[k];
  }
  /// Begins with c times the column that begins there.
  template <class C>
  ColumnSum(S const* column, C const& c, V& out) : out_(out) {
    for (Index k = 0; k < out.size(); ++k) out[k] = column[k] * c;
  }
  /// Adds c times the column that begins there.
  [[gnu::always_inline]] ColumnSum& add(S const* column, Base<S> const& c) {
    for (Index k = 0; k < out_.size(); ++k) out_[k] += column[k] * c;
    return *this;
  }
  /// The same, c of any kind.
  [[gnu::always_inline]] ColumnSum& add(S const* column, S const& c)
    requires(!std::same_as<S, Base<S>>)
  {
    for (Index k = 0; k < out_.size(); ++k) out_[k] += column[k] * c;
    return *this;
  }
  /// The last call.
  void store() const {}

 private:
  V& out_;
};

/// The same of doubles whose number is known to the compiler: in pairs, and a single one where it is odd.
template <class V>
  requires(std::same_as<typename V::Scalar, double> && V::RowsAtCompileTime != Dynamic)
class ColumnSum<V> {
  static constexpr int pairs = V::RowsAtCompileTime / 2, rest = V::RowsAtCompileTime % 2;
  using Pair [[gnu::vector_size(16)]] = double;

 public:
  ColumnSum(V const& first, V& out) : out_(out) {
    __builtin_memcpy(pair_, first.data(), sizeof(Pair) * pairs);
    if constexpr (rest) last_ = first[2 * pairs];
  }
  /// Begins with c times the column that begins there.
  ColumnSum(double const* column, double c, V& out) : out_(out) {
#pragma GCC unroll 8
    for (int k = 0; k < pairs; ++k) {
      Pair p;
      __builtin_memcpy(&p, column + 2 * k, sizeof p);
      pair_[k] = p * c;
    }
    if constexpr (rest) last_ = column[2 * pairs] * c;
  }
  /// Adds c times the column that begins there.
  [[gnu::always_inline]] ColumnSum& add(double const* column, double c) {
#pragma GCC unroll 8
    for (int k = 0; k < pairs; ++k) {
      Pair p;
      __builtin_memcpy(&p, column + 2 * k, sizeof p);
      pair_[k] += p * c;
    }
    if constexpr (rest) last_ += column[2 * pairs] * c;
    return *this;
  }
  /// The last call.
  void store() const {
    __builtin_memcpy(out_.data(), pair_, sizeof(Pair) * pairs);
    if constexpr (rest) out_[2 * pairs] = last_;
  }

 private:
  V& out_;
  Pair pair_[pairs + (pairs == 0)];
  double last_ = 0;
};

/// Adds to a sum a square matrix times a column, but for its columns before `from`.
template <int from, class V, class M>
[[gnu::always_inline]] inline void add_columns(ColumnSum<V>& sum, M const& matrix, V const& by) {
  if constexpr (constexpr Index n = V::RowsAtCompileTime; n >= from && n <= 8)
    [&]<Index... b>(std::integer_sequence<Index, b...>) {
      (sum.add(matrix.data() + (b + from) * n, by[b + from]), ...);
    }(std::make_integer_sequence<Index, n - from>());
  else
    for (Index b = from; b < by.size(); ++b) sum.add(matrix.data() + b * by.size(), by[b]);
}
/// out = first + a square matrix times a column; `out` is neither column.
template <class V, class M>
[[gnu::always_inline]] inline void multiply_and_add(V const& first, M const& matrix, V const& by, V& out) {
  ColumnSum<V> sum(first, out);
  add_columns<0>(sum, matrix, by);
  sum.store();
}
/// out = a square matrix of one row or more times a column, which `out` is not.
template <class V, class M>
[[gnu::always_inline]] inline void multiply(M const& matrix, V const& by, V& out) {
  ColumnSum<V> sum(matrix.data(), by[0], out);
  add_columns<1>(sum, matrix, by);
  sum.store();
}

}  // namespace actio::detail
