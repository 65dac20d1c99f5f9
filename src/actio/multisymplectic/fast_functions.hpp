// Roots, exponentials and logarithms of the numbers in SIMD lanes, without a table and without a branch.
//
// Arguments are the Jacobians of cells and what laws of media make of them: positive normal numbers. For
// others the results are meaningless, and the steps that use them find the sign of the Jacobian.
//
// The bits of a positive double, read as an integer, are up to a scale its logarithm, within some per cent.
// Lanes without AVX-512 do not convert integers of 64 bits to doubles and back, but an integer m below 2^52
// is the last bits of the double 2^52 + m, so that an addition converts.
#pragma once

#include <cmath>
#include <concepts>

#include "actio/multisymplectic/fast_lanes.hpp"

namespace actio::detail {

inline constexpr double two_52 = 4503599627370496.0;             ///< \f$2^{52}\f$
inline constexpr std::int64_t two_52_bits = 0x4330000000000000;  ///< its bits

/// Four registers that go through the same operations in turns: what one of them waits for, the others do.
struct Fourfold {
  Quad quad[4];

  [[gnu::always_inline]] friend Fourfold operator+(Fourfold const& x, Fourfold const& y) {
    return {x.quad[0] + y.quad[0], x.quad[1] + y.quad[1], x.quad[2] + y.quad[2], x.quad[3] + y.quad[3]};
  }
  [[gnu::always_inline]] friend Fourfold operator-(Fourfold const& x, Fourfold const& y) {
    return {x.quad[0] - y.quad[0], x.quad[1] - y.quad[1], x.quad[2] - y.quad[2], x.quad[3] - y.quad[3]};
  }
  [[gnu::always_inline]] friend Fourfold operator*(Fourfold const& x, Fourfold const& y) {
    return {x.quad[0] * y.quad[0], x.quad[1] * y.quad[1], x.quad[2] * y.quad[2], x.quad[3] * y.quad[3]};
  }
  [[gnu::always_inline]] friend Fourfold operator/(Fourfold const& x, Fourfold const& y) {
    return {x.quad[0] / y.quad[0], x.quad[1] / y.quad[1], x.quad[2] / y.quad[2], x.quad[3] / y.quad[3]};
  }
  [[gnu::always_inline]] friend Fourfold operator+(double c, Fourfold const& x) {
    return {c + x.quad[0], c + x.quad[1], c + x.quad[2], c + x.quad[3]};
  }
  [[gnu::always_inline]] friend Fourfold operator-(double c, Fourfold const& x) {
    return {c - x.quad[0], c - x.quad[1], c - x.quad[2], c - x.quad[3]};
  }
  [[gnu::always_inline]] friend Fourfold operator-(Fourfold const& x, double c) { return -c + x; }
  [[gnu::always_inline]] friend Fourfold operator*(double c, Fourfold const& x) {
    return {c * x.quad[0], c * x.quad[1], c * x.quad[2], c * x.quad[3]};
  }
};
/// One register or four.
template <class T>
concept QuadOrFour = std::same_as<T, Quad> || std::same_as<T, Fourfold>;

/// Bits moved down without regard to a sign.
[[gnu::always_inline]] inline void move_down(Quad const& x, std::int64_t more, int places, Quad::Bits& out) {
  using Unsigned [[gnu::vector_size(32)]] = std::uint64_t;
  out = reinterpret_cast<Quad::Bits>(
      (reinterpret_cast<Unsigned>(x.lane) + static_cast<std::uint64_t>(more)) >> places);
}
/// What \ref inverse_root begins with: \f$x^{-1/n}\f$ within some per cent.
template <int n>
[[gnu::always_inline]] inline Quad root_guess(Quad const& x) {
  // Bits are shifted by 12 places, which leaves 52: 1023 * 2^40 stands for 1. The last term halves the error.
  constexpr double c = 1.0 / n, unit = 1099511627776.0, offset = (1023.0 - 0.0450466) * unit * (1 + c);
  Quad::Bits bits;
  move_down(x, 0, 12, bits);
  Quad const log_x = Quad(Quad::Bits(bits | two_52_bits)) - two_52, log_y = (offset - c * log_x) + two_52;
  return Quad(Quad::Bits(reinterpret_cast<Quad::Bits>(log_y.lane) << 12));
}
template <int n>
[[gnu::always_inline]] inline Fourfold root_guess(Fourfold const& x) {
  return {root_guess<n>(x.quad[0]), root_guess<n>(x.quad[1]), root_guess<n>(x.quad[2]),
          root_guess<n>(x.quad[3])};
}
/// \f$x = 2^km\f$ with m between \f$\sqrt{1/2}\f$ and \f$\sqrt2\f$.
[[gnu::always_inline]] inline void split(Quad const& x, Quad& k, Quad& m) {
  constexpr std::int64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  Quad::Bits exponent;
  move_down(x, one - root_half, 52, exponent);
  k = Quad(Quad::Bits(exponent | two_52_bits)) - (two_52 + 1023);
  Quad::Bits const shifted = reinterpret_cast<Quad::Bits>(x.lane) + (one - root_half);
  m = Quad(Quad::Bits((shifted & 0x000fffffffffffff) + root_half));
}
[[gnu::always_inline]] inline void split(Fourfold const& x, Fourfold& k, Fourfold& m) {
  split(x.quad[0], k.quad[0], m.quad[0]), split(x.quad[1], k.quad[1], m.quad[1]);
  split(x.quad[2], k.quad[2], m.quad[2]), split(x.quad[3], k.quad[3], m.quad[3]);
}
/// x between -700 and 700.
[[gnu::always_inline]] inline Quad within_700(Quad const& x) {
  Quad const above = chosen(x.lane < Quad(700).lane, x, Quad(700));
  return chosen(above.lane > Quad(-700).lane, above, Quad(-700));
}
[[gnu::always_inline]] inline Fourfold within_700(Fourfold const& x) {
  return {within_700(x.quad[0]), within_700(x.quad[1]), within_700(x.quad[2]), within_700(x.quad[3])};
}
/// \f$2^k\f$ from the double \f$1.5\cdot2^{52}+k\f$.
[[gnu::always_inline]] inline Quad power_of_two(Quad const& shifted) {
  return Quad(Quad::Bits((reinterpret_cast<Quad::Bits>(shifted.lane) << 52) + 0x3ff0000000000000));
}
[[gnu::always_inline]] inline Fourfold power_of_two(Fourfold const& shifted) {
  return {power_of_two(shifted.quad[0]), power_of_two(shifted.quad[1]), power_of_two(shifted.quad[2]),
          power_of_two(shifted.quad[3])};
}

/// \f$x^{-1/n}\f$: relative error below one unit in the last place.
///
/// A guess from the bits, and twice the binomial series of \f$y\,(1-t)^{-1/n}\f$ in \f$t = 1-xy^n\f$ to the
/// fourth power: the guess has \f$|t| < 0.2\f$, the first round leaves \f$|t| < 10^{-4}\f$, and the second
/// nothing that a double holds.
template <int n, QuadOrFour T>
[[gnu::always_inline]] inline T inverse_root(T const& x) {
  constexpr double c1 = 1.0 / n, c2 = c1 * (c1 + 1) / 2, c3 = c2 * (c1 + 2) / 3, c4 = c3 * (c1 + 3) / 4;
  T y = root_guess<n>(x);
#pragma GCC unroll 2
  for (int round = 0; round < 2; ++round) {
    T power = y;
#pragma GCC unroll 8
    for (int k = 1; k < n; ++k) power = power * y;
    T const t = 1.0 - x * power;
    y = y + y * (t * (c1 + t * (c2 + t * (c3 + c4 * t))));
  }
  return y;
}
/// The same for other scalars: numbers, and dual numbers.
template <int n, class T>
T inverse_root(T const& x) {
  using std::pow;
  if constexpr (n == 1)
    return T(1) / x;
  else
    return pow(x, -1.0 / n);
}

/// \f$\log x\f$: relative error below 2 units in the last place.
///
/// \f$x = 2^km\f$ with m between \f$\sqrt{1/2}\f$ and \f$\sqrt2\f$, and
/// \f$\log m = f - s\,(f-R(s^2))\f$ with \f$f = m-1\f$, \f$s = f/(2+f)\f$ and the polynomial R of fdlibm.
template <QuadOrFour T>
[[gnu::always_inline]] inline T log(T const& x) {
  T k, m;
  split(x, k, m);
  T const f = m - 1.0, s = f / (2.0 + f), z = s * s, w = z * z;
  T const odd = z * (6.666666666666735130e-01 +
                     w * (2.857142874366239149e-01 +
                          w * (1.818357216161805012e-01 + 1.479819860511658591e-01 * w))),
          even =
              w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + 1.531383769920937332e-01 * w));
  T const half_square = 0.5 * (f * f);
  return 6.93147180369123816490e-01 * k -
         ((half_square - (s * (half_square + (odd + even)) + 1.90821492927058770002e-10 * k)) - f);
}

/// \f$e^x\f$ for \f$|x|\le700\f$, beyond which it stays at \f$e^{\pm700}\f$: relative error below 2 units in
/// the last place.
///
/// \f$x = k\log2+r\f$ with \f$|r|\le0.347\f$, and the exponential series of r to the thirteenth power, whose
/// remainder is \f$r^{14}/14! < 5\cdot10^{-18}\f$.
template <QuadOrFour T>
[[gnu::always_inline]] inline T exp(T const& argument) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: its last bits are those of the integer added
  T const x = within_700(argument), shifted = shift + 1.44269504088896338700 * x, k = shifted - shift;
  T const r = (x - 6.93147180369123816490e-01 * k) - 1.90821492927058770002e-10 * k;
  T const r2 = r * r, r4 = r2 * r2;
  T const a = (1.0 / 2 + 1.0 / 6 * r) + r2 * (1.0 / 24 + 1.0 / 120 * r),
          b = (1.0 / 720 + 1.0 / 5040 * r) + r2 * (1.0 / 40320 + 1.0 / 362880 * r),
          c = (1.0 / 3628800 + 1.0 / 39916800 * r) + r2 * (1.0 / 479001600 + 1.0 / 6227020800 * r);
  T const series = r + r2 * (a + r4 * (b + r4 * c)), power = power_of_two(shifted);
  return power + power * series;
}

}  // namespace actio::detail
