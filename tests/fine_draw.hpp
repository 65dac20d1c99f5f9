// Random draws of fractions with a large denominator, over the rationals too.
#pragma once

#include "witness/draw.hpp"

namespace actio::testing {

/// Draws as \ref Draw does, and of a Number over the rationals the same fractions k/65537 as of every other
/// scalar. Draw takes sixty-fourths there: now and then two of them are equal, or one is -1, 0 or 1, and what
/// a test says of numbers that differ, or divides by, is not there.
struct FineDraw : Draw {
  using Draw::Draw;

  template <Scalar S>
  S number() { return ratio<S>(static_cast<long>(below(numerators)) - (denominator - 1), denominator); }
  template <Scalar S, class V = Matrix<S, Dynamic, 1>>
  V vector(int n) {
    V v(n);
    for (int i = 0; i < n; ++i) v[i] = number<S>();
    return v;
  }
  template <Scalar S, Group G>
  Velocity<G, S> velocity(G const& group, std::type_identity_t<S> const& size = S(1)) {
    return {group, vector<S, Coordinates<G, S>>(group.dimension()) * size};
  }
  template <Scalar S, Group G>
  Momentum<G, S> momentum(G const& group, std::type_identity_t<S> const& size = S(1)) {
    return {group, vector<S, Coordinates<G, S>>(group.dimension()) * size};
  }
  template <Scalar S, Group G>
  Element<G, S> element(G const& group, std::type_identity_t<S> const& size = ratio<S>(1, 2)) {
    return retract(velocity<S>(group, size));
  }
};

}  // namespace actio::testing
