// Random numbers, vectors and elements of groups: the same on every machine and, up to rounding, over every
// scalar.
//
// A number is k/65537 with k uniform in -65536, ..., 65536 (131073 equally likely numbers), in floating point
// the number next to it: since 65537 is an odd prime these fill all digits, so that rounding is not hidden by
// short numbers. A Number over the rationals and over a prime field has a set of its own (Number::drawn). No
// distribution of the standard library is used: their algorithms differ from one implementation to the next.
#pragma once

#include <cstdint>
#include <random>

#include "actio/groups/group.hpp"

namespace actio {

/// A sequence of random draws, fixed by its seed. The sequence does not depend on the scalar.
struct Draw {
  static constexpr long denominator = 65537;
  static constexpr long numerators = 131073;  ///< how many numbers are equally likely

  /// @param fractions  whether a scalar that has a set of its own to draw from is drawn as the others are
  explicit Draw(std::uint64_t seed, bool fractions = false) : generator(seed), fractions_(fractions) {}

  /// A whole number in 0, ..., count - 1, each equally likely.
  std::uint64_t below(std::uint64_t count) {
    // Reject what would favour the small remainders.
    std::uint64_t const whole = UINT64_MAX - UINT64_MAX % count;
    std::uint64_t bits = generator();
    while (bits >= whole) bits = generator();
    return bits % count;
  }

  /// A number in (-1, 1). One whose arithmetic is chosen at run time may have a set of its own to draw from:
  /// `Number::drawn`.
  template <Scalar S>
  S number() {
    if constexpr (ChosenAtRunTime<Base<S>>)
      if (!fractions_) return S(Base<S>::drawn(*this));
    return ratio<S>(static_cast<long>(below(numerators)) - (denominator - 1), denominator);
  }

  /// n numbers in (-1, 1).
  template <Scalar S, class V = Matrix<S, Dynamic, 1>>
  V vector(int n) {
    V v(n);
    for (int i = 0; i < n; ++i) v[i] = number<S>();
    return v;
  }

  /// A velocity whose coordinates lie within `size` of zero.
  template <Scalar S, Group G>
  Velocity<G, S> velocity(G const& group, std::type_identity_t<S> const& size = S(1)) {
    return {group, vector<S, Coordinates<G, S>>(group.dimension()) * size};
  }
  /// A momentum whose components lie within `size` of zero.
  template <Scalar S, Group G>
  Momentum<G, S> momentum(G const& group, std::type_identity_t<S> const& size = S(1)) {
    return {group, vector<S, Coordinates<G, S>>(group.dimension()) * size};
  }
  /// The retraction of a velocity of that size: with the default, inside the chart of every group of the
  /// library.
  template <Scalar S, Group G>
  Element<G, S> element(G const& group, std::type_identity_t<S> const& size = ratio<S>(1, 2)) {
    return retract(velocity<S>(group, size));
  }

 private:
  std::mt19937_64 generator;
  bool fractions_;
};

/// Draws of the fractions k/65537 over every scalar. Draw takes sixty-fourths of a Number over the rationals:
/// now and then two of them are equal, or one is -1, 0 or 1, and a test that divides by their difference
/// fails.
struct FineDraw : Draw {
  explicit FineDraw(std::uint64_t seed) : Draw(seed, true) {}
};

}  // namespace actio
