// Scalars: the numbers that every formula of the library is written over.
//
// A formula is written once and evaluated in double, in 50 or 100 decimal digits, over the rationals (where
// it needs no root and no transcendental function; multiprecision.hpp has these numbers), and in each of
// these extended by infinitesimals (dual.hpp) or by powers of the time (taylor.hpp). `Scalar` asks for the
// four operations; `Real` asks for roots and transcendental functions as well.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#include "actio/matrices/matrix.hpp"

namespace actio {

/// The plain number at the bottom of a scalar: `double` of a dual number over dual numbers over `double`.
template <class S>
struct BaseOf {
  using type = S;
};
template <class S>
using Base = typename BaseOf<S>::type;

/// A number whose arithmetic is chosen when the program runs, and says which it is. Over a field it may know
/// of what degree its numbers are.
template <class S>
concept ChosenAtRunTime = requires {
  { S::arithmetic().exact() } -> std::convertible_to<bool>;
  { S::arithmetic().ordered() } -> std::convertible_to<bool>;
};

/// What is said once of a type of numbers of another library: that it is a plain number, and whether its
/// arithmetic has no rounding at all.
template <class S>
struct NumberTraits {
  static constexpr bool plain = std::is_arithmetic_v<S>;  ///< extended by nothing
  static constexpr bool exact = false;                    ///< without rounding
};

/// A plain number: extended by nothing.
template <class S>
concept Plain = NumberTraits<S>::plain || ChosenAtRunTime<S>;

/// Numbers that add, subtract, multiply and divide exactly or to rounding.
template <class S>
concept Scalar = requires(S const& a, S const& b) {
  { a + b } -> std::convertible_to<S>;
  { a - b } -> std::convertible_to<S>;
  { a* b } -> std::convertible_to<S>;
  { a / b } -> std::convertible_to<S>;
  { a < b } -> std::convertible_to<bool>;
  S(1);
};

/// Whether a scalar has no rounding at all, as its type says. One whose arithmetic is chosen at run time is
/// not counted: \ref exact_arithmetic.
template <class S>
inline constexpr bool is_exact = NumberTraits<Base<S>>::exact;

/// Whether the arithmetic of a scalar has no rounding at all: known to the compiler, or, where it is chosen
/// at run time, now.
template <class S>
constexpr bool exact_arithmetic() {
  if constexpr (ChosenAtRunTime<Base<S>>)
    return Base<S>::arithmetic().exact();
  else
    return is_exact<S>;
}
/// Whether numbers of the scalar are larger and smaller than others. Modulo a prime they are not: what is
/// said to be positive cannot be looked at there.
template <class S>
constexpr bool ordered_arithmetic() {
  if constexpr (ChosenAtRunTime<Base<S>>)
    return Base<S>::arithmetic().ordered();
  else
    return true;
}
/// Decimal digits that a number carries; 0 over an exact arithmetic.
template <class S>
constexpr int decimal_digits() {
  if constexpr (ChosenAtRunTime<Base<S>>)
    return Base<S>::arithmetic().digits();
  else
    return std::numeric_limits<Base<S>>::digits10;
}

/// Numbers with roots and transcendental functions: everything but the rationals and what is built on them.
///
/// A scalar whose arithmetic is chosen at run time counts as one; where that has no roots, they refuse
/// (NotInThisField).
template <class S>
concept Real = Scalar<S> && !is_exact<S>;

/// Spacing of the numbers next to 1: \f$2^{-52}\f$ in double, about \f$10^{-50}\f$ and \f$10^{-100}\f$, and 0
/// over the rationals.
template <class S>
Base<S> epsilon() {
  if constexpr (is_exact<S>)
    return Base<S>(0);
  else
    return std::numeric_limits<Base<S>>::epsilon();
}

/// The plain number at the bottom of `x`, without what it is extended by.
template <Plain S>
S const& base_value(S const& x) { return x; }

/// A plain number as double, for printing and for choosing.
template <class S>
double to_double(S const& x) {
  if constexpr (std::same_as<Base<S>, double>)
    return base_value(x);
  else
    return base_value(x).template convert_to<double>();
}

/// The largest modulus among all coefficients of `x`; of a plain number, its modulus.
template <Plain S>
S magnitude(S const& x) { return x < 0 ? S(-x) : x; }

/// Whether every coefficient of `x` is a finite number.
template <Plain S>
  requires(!ChosenAtRunTime<S>)
bool is_finite(S const& x) {
  using std::isfinite;
  if constexpr (is_exact<S>)
    return true;
  else
    return isfinite(x);
}

/// Two integers as an exact fraction of the scalar: `ratio<S>(1, 3)`. A decimal literal would be wrong after
/// 16 digits.
template <class S>
S ratio(long numerator, long denominator) { return S(Base<S>(numerator) / Base<S>(denominator)); }

/// A matrix or vector of scalars with as many rows and columns, whose largest coefficient is asked for.
template <MatrixLike Derived>
auto magnitude(Derived const& m) {
  Base<typename Derived::Scalar> largest(0);
  for (Index j = 0; j < m.cols(); ++j)
    for (Index i = 0; i < m.rows(); ++i) {
      auto const size = magnitude(typename Derived::Scalar(m(i, j)));
      if (size != size) return size;  // no number: say so, whatever follows
      if (size > largest) largest = size;
    }
  return largest;
}

template <MatrixLike Derived>
bool is_finite(Derived const& m) {
  for (Index j = 0; j < m.cols(); ++j)
    for (Index i = 0; i < m.rows(); ++i)
      if (!is_finite(typename Derived::Scalar(m(i, j)))) return false;
  return true;
}

}  // namespace actio
