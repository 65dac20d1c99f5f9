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
#include <iterator>
#include <numbers>

#include "actio/stored_energy/fast_lanes.hpp"

namespace actio::media::detail {

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
  // Bits are shifted by 12 places, which leaves 52: 1023 * 2^40 stands for 1. The term 0.045 halves the
  // error. That 2^52 is added to what is read and to what is written is taken into the offset.
  constexpr double c = 1.0 / n, unit = 1099511627776.0,
                   offset = ((1023.0 - 0.0450466) * unit + two_52) * (1 + c);
  Quad::Bits bits;
  move_down(x, 0, 12, bits);
  Quad const log_x(Quad::Bits(bits | two_52_bits)), log_y = offset - c * log_x;
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
/// x between -1000 and 1000.
[[gnu::always_inline]] inline Quad within_1000(Quad const& x) {
  Quad const above = chosen(x.lane < Quad(1000).lane, x, Quad(1000));
  return chosen(above.lane > Quad(-1000).lane, above, Quad(-1000));
}
[[gnu::always_inline]] inline Fourfold within_1000(Fourfold const& x) {
  return {within_1000(x.quad[0]), within_1000(x.quad[1]), within_1000(x.quad[2]), within_1000(x.quad[3])};
}
/// 1/x: relative error below one unit in the last place.
[[gnu::always_inline]] inline Quad reciprocal(Quad const& x) { return Quad(1) / x; }
/// Of four registers by one division: below three units in the last place, where the product of all is no
/// denormal number.
[[gnu::always_inline]] inline Fourfold reciprocal(Fourfold const& x) {
  Quad const a = x.quad[0] * x.quad[1], b = x.quad[2] * x.quad[3], inverse = Quad(1) / (a * b),
             of_a = b * inverse, of_b = a * inverse;
  return {of_a * x.quad[1], of_a * x.quad[0], of_b * x.quad[3], of_b * x.quad[2]};
}
/// \f$2^k\f$ from the double \f$1.5\cdot2^{52}+k\f$.
[[gnu::always_inline]] inline Quad power_of_two(Quad const& shifted) {
  return Quad(Quad::Bits((reinterpret_cast<Quad::Bits>(shifted.lane) << 52) + 0x3ff0000000000000));
}
[[gnu::always_inline]] inline Fourfold power_of_two(Fourfold const& shifted) {
  return {power_of_two(shifted.quad[0]), power_of_two(shifted.quad[1]), power_of_two(shifted.quad[2]),
          power_of_two(shifted.quad[3])};
}

/// \f$y^m\f$ by squares.
template <int m, class T>
[[gnu::always_inline]] inline T power_of(T const& y) {
  if constexpr (m == 1)
    return y;
  else if constexpr (m % 2 == 0)
    return power_of<m / 2, T>(y * y);
  else
    return y * power_of<m - 1, T>(y);
}
/// \f$y^p\f$ and \f$t = 1-xy^n\f$.
template <int n, int p, QuadOrFour T>
[[gnu::always_inline]] inline T power_and_distance(T const& x, T const& y, T& t) {
  T const to_n = power_of<n>(y);
  t = 1.0 - x * to_n;
  if constexpr (p == n)
    return to_n;
  else if constexpr (p > n)
    return to_n * power_of<p - n>(y);
  else
    return power_of<p>(y);
}
/// The binomial series \f$(1-t)^{-p/n} = 1+c_1t+c_2t^2+\dots\f$
template <int n, int p>
struct RootSeries {
  static constexpr double c1 = static_cast<double>(p) / n, c2 = c1 * (c1 + 1) / 2, c3 = c2 * (c1 + 2) / 3,
                          c4 = c3 * (c1 + 3) / 4;
};
/// \f$y\,(1-t)^{-1/n}\f$ by its series to the fourth power of t: where y is nearly \f$x^{-1/n}\f$, it is
/// \f$x^{-1/n}\f$.
template <int n, QuadOrFour T>
[[gnu::always_inline]] inline T better_root(T const& x, T const& y) {
  using C = RootSeries<n, 1>;
  T t = y;
  power_and_distance<n, 1>(x, y, t);
  return y + y * (t * (C::c1 + t * (C::c2 + t * (C::c3 + C::c4 * t))));
}
/// The best polynomial for \f$(1-t)^{-1/n}\f$ on the t that the guess has, its powers from the lowest on; and
/// what the t that it leaves is bounded by.
///
/// The guess has t between -0.0691 and 0.0676 for n = 2, -0.1203 and 0.0901 for n = 3, -0.1858 and 0.1351 for
/// n = 5: found on 4e5 arguments, evenly spread in their logarithms over the factor \f$2^n\f$ after which it
/// repeats itself. The coefficients are Remez's, for the relative error.
template <int n>
struct RootFit {};
template <>
struct RootFit<2> {
  static constexpr double q[] = {1.0000001843153037, 0.5010957811662636, 0.3755269497228546}, left = 5e-5;
};
template <>
struct RootFit<3> {
  static constexpr double q[] = {1.000018029555036, 0.3346402371356632, 0.21616354620386605}, left = 1.46e-4;
};
template <>
struct RootFit<5> {
  static constexpr double q[] = {0.9999953254377271, 0.20006891022971668, 0.12155066789404623,
                                 0.08311922294000758},
                          left = 2.72e-5;
};
/// Whether there is one.
template <int n>
concept FittedRoot = requires { RootFit<n>::left; };

/// Whether the series to the third power of t is enough for the second round.
template <int n, int p>
constexpr bool three_terms_do() {
  if constexpr (FittedRoot<n>) {
    constexpr double r2 = RootFit<n>::left * RootFit<n>::left;
    return RootSeries<n, p>::c4 * r2 * r2 / 8 < 0x1p-52;
  } else {
    return false;
  }
}

/// The first round of \ref inverse_root.
template <int n, QuadOrFour T>
[[gnu::always_inline]] inline T first_root(T const& x) {
  T const y = root_guess<n>(x);
  if constexpr (FittedRoot<n>) {
    constexpr auto& q = RootFit<n>::q;
    // In this order the powers of y need not be waited for.
    T const t = 1.0 - (x * y) * power_of<n - 1>(y);
    if constexpr (std::size(q) == 3)
      return y * (q[0] + t * (q[1] + q[2] * t));
    else
      return y * (q[0] + t * (q[1] + t * (q[2] + q[3] * t)));
  } else {
    return better_root<n>(x, y);
  }
}
/// Its second round, from what the first one has found, with the power p and a factor at once:
/// \f$f\,x^{-p/n}\f$. Relative error below (p + 2) units in the last place.
template <int n, int p, QuadOrFour T>
[[gnu::always_inline]] inline T second_power(double f, T const& x, T const& y) {
  using C = RootSeries<n, p>;
  T t = y;
  T const power = power_and_distance<n, p>(x, y, t);
  if constexpr (three_terms_do<n, p>()) {
    // The next term c4 t^4 is put down to the lower ones, up to an eighth of its size at the end.
    constexpr double r2 = RootFit<n>::left * RootFit<n>::left, c0 = 1 - C::c4 * r2 * r2 / 8,
                     c2 = C::c2 + C::c4 * r2;
    return power * (f * c0 + t * (f * C::c1 + t * (f * c2 + f * C::c3 * t)));
  } else {
    return power * (f + t * (f * C::c1 + t * (f * C::c2 + t * (f * C::c3 + f * C::c4 * t))));
  }
}
/// \f$x^{-1/n}\f$: relative error below one unit in the last place.
///
/// A guess from the bits with \f$|t| < 0.2\f$, where \f$t = 1-xy^n\f$; a round that leaves
/// \f$|t| < 1.5\cdot10^{-4}\f$; and one that leaves less than what a double holds.
template <int n, QuadOrFour T>
[[gnu::always_inline]] inline T inverse_root(T const& x) { return better_root<n>(x, first_root<n>(x)); }
/// The same for other scalars: numbers, and dual numbers.
template <int n, class T>
T inverse_root(T const& x) {
  using std::pow;
  if constexpr (n == 1)
    return T(1) / x;
  else
    return pow(x, -1.0 / n);
}

/// \f$\log_2x\f$: relative error below 4 units in the last place.
///
/// \f$x = 2^km\f$ with m between \f$\sqrt{1/2}\f$ and \f$\sqrt2\f$, and \f$\log_2m = s\,A(s^2)\f$ with
/// \f$s = (m-1)/(m+1)\f$ and the best polynomial A of degree 7, whose relative error is 2e-18.
template <QuadOrFour T>
[[gnu::always_inline]] inline T log2(T const& x) {
  T k, m;
  split(x, k, m);
  T const f = m - 1.0, s = f * reciprocal(2.0 + f), z = s * s, w = z * z;
  T const even = 2.8853900817779268 +
                 w * (0.5770780163454704 + w * (0.3205985339264623 + 0.22091186685788852 * w)),
          odd = 0.9617966939259898 +
                w * (0.41219858585106456 + w * (0.26233440174514827 + 0.21367077946267188 * w));
  return k + s * (even + z * odd);
}
/// \f$2^x\f$ for \f$|x|\le1000\f$, beyond which it stays at \f$2^{\pm1000}\f$: relative error below one unit
/// in the last place.
///
/// \f$x = k+r\f$ with \f$|r|\le\tfrac12\f$, and \f$2^r = 1+r\,B(r)\f$ with the best polynomial B of degree
/// 10, whose error is 6e-18.
template <QuadOrFour T>
[[gnu::always_inline]] inline T exp2(T const& argument) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: its last bits are those of the integer added
  T const x = within_1000(argument), shifted = shift + x, r = x - (shifted - shift), r2 = r * r;
  T const even = 0.6931471805599453 +
                 r2 * (0.05550410866482166 +
                       r2 * (0.0013333558146395997 +
                             r2 * (1.5252733853281571e-05 +
                                   r2 * (1.017805172938865e-07 + 4.4566749682698136e-10 * r2)))),
          odd =
              0.24022650695910097 +
              r2 * (0.009618129107606887 + r2 * (0.00015403530441738348 +
                                                 r2 * (1.3215442586740476e-06 + 7.072586159513708e-09 * r2)));
  T const power = power_of_two(shifted);
  return power + power * (r * (even + r * odd));
}
/// The same for other scalars: numbers, and dual numbers.
template <class T>
T log2(T const& x) {
  using std::log;
  return log(x) / std::numbers::ln2;
}
template <class T>
T exp2(T const& x) {
  using std::exp;
  return exp(std::numbers::ln2 * x);
}
template <class T>
T reciprocal(T const& x) { return T(1) / x; }

}  // namespace actio::media::detail
