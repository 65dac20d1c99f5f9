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

#include "actio/multisymplectic/fast_lanes.hpp"

namespace actio::detail {

inline constexpr double two_52 = 4503599627370496.0;             ///< \f$2^{52}\f$
inline constexpr std::int64_t two_52_bits = 0x4330000000000000;  ///< its bits

/// \f$x^{-1/n}\f$: relative error below one unit in the last place.
///
/// A guess from the bits, and twice the binomial series of \f$y\,(1-t)^{-1/n}\f$ in \f$t = 1-xy^n\f$ to the
/// fourth power: the guess has \f$|t| < 0.1\,(1+1/n)\,n/(n+1)+\dots < 0.2\f$, the first round leaves
/// \f$|t| < 10^{-4}\f$, and the second nothing that a double holds.
template <int n>
[[gnu::always_inline]] inline Quad inverse_root(Quad const& x) {
  constexpr double c1 = 1.0 / n, c2 = c1 * (c1 + 1) / 2, c3 = c2 * (c1 + 2) / 3, c4 = c3 * (c1 + 3) / 4;
  // Bits are shifted by 12 places, which leaves 52: 1023 * 2^40 stands for 1. The last term halves the error.
  constexpr double one = 1023.0 * 1099511627776.0,
                   offset = one * (1 + c1) - 0.0450466 * 1099511627776.0 * (1 + c1);
  Quad const log_x = Quad(Quad::Bits((reinterpret_cast<Quad::Bits>(x.lane) >> 12) | two_52_bits)) - two_52;
  Quad const log_y = (offset - c1 * log_x) + two_52;
  Quad y(Quad::Bits(reinterpret_cast<Quad::Bits>(log_y.lane) << 12));
  for (int round = 0; round < 2; ++round) {
    Quad power = y;
    for (int k = 1; k < n; ++k) power = power * y;
    Quad const t = 1.0 - x * power;
    y = y + y * (t * (c1 + t * (c2 + t * (c3 + t * c4))));
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
/// \f$x = 2^km\f$ with \f$m\f$ between \f$\sqrt{1/2}\f$ and \f$\sqrt2\f$, and
/// \f$\log m = f - s\,(f-R(s^2))\f$ with \f$f = m-1\f$, \f$s = f/(2+f)\f$ and the polynomial R of fdlibm.
[[gnu::always_inline]] inline Quad log(Quad const& x) {
  constexpr std::int64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  Quad::Bits const shifted = reinterpret_cast<Quad::Bits>(x.lane) + (one - root_half);
  // The shift brings no sign with it: shifted is positive.
  Quad const k = Quad(Quad::Bits((shifted >> 52) | two_52_bits)) - (two_52 + 1023);
  Quad const m(Quad::Bits((shifted & 0x000fffffffffffff) + root_half));
  Quad const f = m - 1.0, s = f / (2.0 + f), z = s * s, w = z * z;
  Quad const odd = z * (6.666666666666735130e-01 +
                        w * (2.857142874366239149e-01 +
                             w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01))),
             even = w * (3.999999999940941908e-01 +
                         w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  Quad const half_square = 0.5 * f * f;
  return k * 6.93147180369123816490e-01 -
         ((half_square - (s * (half_square + (odd + even)) + k * 1.90821492927058770002e-10)) - f);
}

/// \f$e^x\f$ for \f$|x|\le700\f$, beyond which it stays at \f$e^{\pm700}\f$: relative error below 2 units in
/// the last place.
///
/// \f$x = k\log2+r\f$ with \f$|r|\le0.347\f$, and the exponential series of r to the thirteenth power, whose
/// remainder is \f$r^{14}/14! < 5\cdot10^{-18}\f$.
[[gnu::always_inline]] inline Quad exp(Quad const& argument) {
  Quad const above = chosen(argument.lane < Quad(700).lane, argument, Quad(700)),
             x = chosen(above.lane > Quad(-700).lane, above, Quad(-700));
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: its last bits are those of the integer added
  Quad const shifted = x * 1.44269504088896338700 + shift, k = shifted - shift;
  Quad const r = (x - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10;
  Quad const r2 = r * r, r4 = r2 * r2;
  Quad const a = 1.0 / 2 + r * (1.0 / 6) + r2 * (1.0 / 24 + r * (1.0 / 120)),
             b = 1.0 / 720 + r * (1.0 / 5040) + r2 * (1.0 / 40320 + r * (1.0 / 362880)),
             c = 1.0 / 3628800 + r * (1.0 / 39916800) + r2 * (1.0 / 479001600 + r * (1.0 / 6227020800));
  Quad const series = r + r2 * (a + r4 * (b + r4 * c));
  Quad const power(Quad::Bits((reinterpret_cast<Quad::Bits>(shifted.lane) << 52) + 0x3ff0000000000000));
  return power + power * series;
}

}  // namespace actio::detail
