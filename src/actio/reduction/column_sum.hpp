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
  /// Adds c times the column that begins there.
  [[gnu::always_inline]] void add(S const* column, Base<S> const& c) {
    for (Index k = 0; k < out_.size(); ++k) out_[k] += column[k] * c;
  }
  /// The same, c of any kind.
  [[gnu::always_inline]] void add(S const* column, S const& c)
    requires(!std::same_as<S, Base<S>>)
  {
    for (Index k = 0; k < out_.size(); ++k) out_[k] += column[k] * c;
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
  /// Adds c times the column that begins there.
  [[gnu::always_inline]] void add(double const* column, double c) {
#pragma GCC unroll 8
    for (int k = 0; k < pairs; ++k) {
      Pair p;
      __builtin_memcpy(&p, column + 2 * k, sizeof p);
      pair_[k] += p * c;
    }
    if constexpr (rest) last_ += column[2 * pairs] * c;
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

/// out = first + a square matrix times a column; `out` is neither column.
template <class V, class M>
[[gnu::always_inline]] inline void add_columns(V const& first, M const& matrix, V const& by, V& out) {
  ColumnSum<V> sum(first, out);
  if constexpr (constexpr Index n = V::RowsAtCompileTime; n != Dynamic && n <= 8)
    [&]<Index... b>(std::integer_sequence<Index, b...>) {
      (sum.add(matrix.data() + b * n, by[b]), ...);
    }(std::make_integer_sequence<Index, n>());
  else
    for (Index b = 0; b < by.size(); ++b) sum.add(matrix.data() + b * by.size(), by[b]);
  sum.store();
}

}  // namespace actio::detail
