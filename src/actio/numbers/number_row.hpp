// A few numbers that are added and multiplied together, two at a time where the machine can.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>

namespace actio::detail {

/// k numbers side by side; an even number of doubles in pairs, which plain x86-64 multiplies at once.
template <class S, int k>
struct Row {
  static constexpr bool in_pairs = std::same_as<S, double> && k % 2 == 0;
  using Pair [[gnu::vector_size(16)]] = double;
  using Piece = std::conditional_t<in_pairs, Pair, S>;
  static constexpr int pieces = in_pairs ? k / 2 : k;

  std::array<Piece, pieces> piece{};

  S operator[](int j) const {
    if constexpr (in_pairs)
      return piece[j / 2][j % 2];
    else
      return piece[j];
  }
  void set(int j, S const& x) {
    if constexpr (in_pairs)
      piece[j / 2][j % 2] = x;
    else
      piece[j] = x;
  }
  /// Adds c y.
  void add(S const& c, Row const& y) {
    for (int j = 0; j < pieces; ++j) piece[j] += c * y.piece[j];
  }
  /// Does to each piece what `f` does to it and to the piece of y.
  template <class F>
  void each(Row const& y, F const& f) {
    for (int j = 0; j < pieces; ++j) f(piece[j], y.piece[j]);
  }
};

}  // namespace actio::detail
