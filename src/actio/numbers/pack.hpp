// Several doubles that go through the same operations: the lanes of SIMD registers.
//
// A pack is a scalar like any other, so that a formula written once moves one system, or several side by
// side. A comparison is true where it is true in all lanes: code that asks whether a short cut is allowed
// takes it for all of them or for none. So neither of x < y and y <= x need be true.
//
// The vectors are those of the compiler (GNU extension). Every operation is inlined, into a kernel that
// registers.hpp compiles for the machine it runs on.
#pragma once

#include <cstdint>
#include <cstring>

#include "actio/numbers/scalar.hpp"

namespace actio {

namespace detail {
/// What the compiler calls n doubles, and n integers, in one register or several.
template <int n>
struct VectorOf {};
template <>
struct VectorOf<4> {
  using Double [[gnu::vector_size(32)]] = double;
  using Integer [[gnu::vector_size(32)]] = std::int64_t;
};
template <>
struct VectorOf<8> {
  using Double [[gnu::vector_size(64)]] = double;
  using Integer [[gnu::vector_size(64)]] = std::int64_t;
};
/// Whether a comparison holds in all lanes.
template <class Mask>
[[gnu::always_inline]] inline bool in_all(Mask const& mask) {
  std::int64_t all = -1;
  for (std::size_t k = 0; k < sizeof mask / sizeof all; ++k) all &= mask[k];
  return all != 0;
}
}  // namespace detail

/// So many doubles, 4 or 8.
template <int n>
struct Pack {
  using Vector = typename detail::VectorOf<n>::Double;  ///< what the compiler calls them
  using Bits = typename detail::VectorOf<n>::Integer;  ///< the same registers as integers, and truth by lanes
  static constexpr int lanes = n;                      ///< their number

  alignas(8 * n) Vector lane;  ///< the numbers

  Pack() = default;
  // Written out, or the compiler copies records of them by halves and through memory.
  /// The same numbers.
  [[gnu::always_inline]] Pack(Pack const& x) : lane(x.lane) {}
  /// Takes the same numbers.
  [[gnu::always_inline]] Pack& operator=(Pack const& x) {
    lane = x.lane;
    return *this;
  }
  /// The same number in all lanes.
  [[gnu::always_inline]] Pack(double x) : lane(x - Vector{}) {}
  /// These numbers.
  [[gnu::always_inline]] explicit Pack(Vector const& x) : lane(x) {}
  /// The numbers that have these bits.
  [[gnu::always_inline]] explicit Pack(Bits const& x) : lane(reinterpret_cast<Vector>(x)) {}

  [[gnu::always_inline]] Pack& operator+=(Pack const& y) { return *this = *this + y; }
  [[gnu::always_inline]] Pack& operator-=(Pack const& y) { return *this = *this - y; }
  [[gnu::always_inline]] friend Pack operator+(Pack const& x, Pack const& y) { return Pack(x.lane + y.lane); }
  [[gnu::always_inline]] friend Pack operator-(Pack const& x, Pack const& y) { return Pack(x.lane - y.lane); }
  [[gnu::always_inline]] friend Pack operator*(Pack const& x, Pack const& y) { return Pack(x.lane * y.lane); }
  [[gnu::always_inline]] friend Pack operator/(Pack const& x, Pack const& y) { return Pack(x.lane / y.lane); }
  [[gnu::always_inline]] friend Pack operator-(Pack const& x) { return Pack(-x.lane); }

  [[gnu::always_inline]] friend bool operator<(Pack const& x, Pack const& y) {
    return detail::in_all(x.lane < y.lane);
  }
  [[gnu::always_inline]] friend bool operator>(Pack const& x, Pack const& y) { return y < x; }
  [[gnu::always_inline]] friend bool operator<=(Pack const& x, Pack const& y) {
    return detail::in_all(x.lane <= y.lane);
  }
  [[gnu::always_inline]] friend bool operator==(Pack const& x, Pack const& y) {
    return detail::in_all(x.lane == y.lane);
  }
};

/// Whether a scalar is several doubles.
template <class S>
inline constexpr bool is_pack = false;
/// \copydoc is_pack
template <int n>
inline constexpr bool is_pack<Pack<n>> = true;
/// Packs are plain, and round as doubles do.
template <int n>
struct NumberTraits<Pack<n>> {
  static constexpr bool plain = true;   ///< extended by nothing
  static constexpr bool exact = false;  ///< as doubles
};
/// Scalars that are made of doubles: one, several, and dual numbers over these.
template <class S>
concept OfDoubles = std::same_as<Base<S>, double> || is_pack<Base<S>>;

/// The modulus in each lane.
template <int n>
[[gnu::always_inline]] inline Pack<n> magnitude(Pack<n> const& x) {
  return Pack<n>(reinterpret_cast<typename Pack<n>::Bits>(x.lane) & 0x7fffffffffffffff);
}
/// The root in each lane: of positive normal numbers, to one unit in the last place.
///
/// Half the bits, read as an integer, are within some per cent half the logarithm; then Newton's method for
/// \f$y=x^{-1/2}\f$, and one step of it for the root.
template <int n>
[[gnu::always_inline]] inline Pack<n> sqrt(Pack<n> const& x) {
  using B = Pack<n>;
  B const half = 0.5 * x;
  B y(0x5fe6eb50c7b537a9 - (reinterpret_cast<typename B::Bits>(x.lane) >> 1));
  for (int round = 0; round < 4; ++round) y = y + y * (0.5 - half * (y * y));
  B const root = x * y;
  return root + (0.5 * y) * (x - root * root);
}

/// What lane k of a record of packs holds, as the same record of doubles. Both are numbers in the same
/// order and nothing else.
template <class One, class All>
One in_lane(All const& all, int k) {
  constexpr std::size_t size = sizeof(double), count = sizeof(One) / size, width = sizeof(All) / count;
  static_assert(sizeof(One) == count * size && sizeof(All) == count * width);
  One one;
  auto const* const from = reinterpret_cast<std::byte const*>(&all) + static_cast<std::size_t>(k) * size;
  auto* const to = reinterpret_cast<std::byte*>(&one);
  for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * size, from + i * width, size);
  return one;
}
/// Puts it there.
template <class All, class One>
void set_lane(All& all, int k, One const& one) {
  constexpr std::size_t size = sizeof(double), count = sizeof(One) / size, width = sizeof(All) / count;
  static_assert(sizeof(One) == count * size && sizeof(All) == count * width);
  auto const* const from = reinterpret_cast<std::byte const*>(&one);
  auto* const to = reinterpret_cast<std::byte*>(&all) + static_cast<std::size_t>(k) * size;
  for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * width, from + i * size, size);
}
/// Puts the same record of doubles into all lanes.
template <class All, class One>
void set_all_lanes(All& all, One const& one) {
  for (std::size_t k = 0; k < sizeof(All) / sizeof(One); ++k) set_lane(all, static_cast<int>(k), one);
}

}  // namespace actio
