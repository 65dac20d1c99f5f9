// Numbers of many digits and exact ones, from Boost.Multiprecision and GMP.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/gmp.hpp>

#include "actio/numbers/scalar.hpp"
#include "actio/numbers/square_root.hpp"

namespace actio {

/// Floating point with 50 decimal digits: `dec50("0.1")` is the number nearest to the text, `dec50(0.1)` that
/// double. Functions of numbers are called without `std::`, as `sqrt(x)`.
///
/// \snippet numbers.cpp digits
using dec50 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
/// Floating point with 100 decimal digits.
using dec100 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
/// Exact rational numbers: a residual over them is zero or it is not. `rational(1, 3)` is a third;
/// `rational(0.1)` is the double that is nearest to a tenth. A denominator of zero throws.
using rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Numbers of Boost.Multiprecision are plain; the rational ones are exact.
template <class Backend>
struct NumberTraits<boost::multiprecision::number<Backend, boost::multiprecision::et_off>> {
  static constexpr bool plain = true;  ///< extended by nothing
  /// Without rounding.
  static constexpr bool exact = std::same_as<Backend, boost::multiprecision::gmp_rational>;
};

/// The root of a rational number p/q where p and q are squares.
template <>
struct ExactRoot<rational> {
  /// The root, or nothing where x is no square.
  static std::optional<rational> of(rational const& x) {
    using boost::multiprecision::mpz_int;
    if (x < 0) return {};
    mpz_int const above = numerator(x), below = denominator(x);
    mpz_int const p = sqrt(above), q = sqrt(below);
    if (p * p != above || q * q != below) return {};
    return rational(p) / rational(q);
  }
};

}  // namespace actio
