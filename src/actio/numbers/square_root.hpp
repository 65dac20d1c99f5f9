// Square roots over every scalar, the rationals included.
//
// The volume of a metric is a square root. Over the rationals it exists where the number is the square of a
// rational, and metrics made as A^T A have such determinants: formulas of Riemannian geometry then run
// exactly, derivatives and all.
#pragma once

#include <string>

#include "actio/numbers/dual.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/numbers/second_order.hpp"

namespace actio {

/// A number without a square root in its field.
struct NotASquare : NotInThisField {
  using NotInThisField::NotInThisField;
};

/// \f$\sqrt x\f$ of a real number: that of its scalar.
template <Plain S>
  requires(!is_exact<S>)
S square_root(S const& x) {
  using std::sqrt;
  return sqrt(x);
}

/// \f$\sqrt x\f$ of a rational number.
/// @throws NotASquare  where it is irrational or imaginary; the measured number is x itself, the bound 0
/// Accuracy: exact.
inline rational square_root(rational const& x) {
  using boost::multiprecision::mpz_int;
  auto const fail = [&] {
    throw NotASquare("square_root", "the square of a rational number is needed over the rationals",
                     to_double(x), 0);
  };
  if (x < 0) fail();
  mpz_int const above = numerator(x), below = denominator(x);
  mpz_int const p = sqrt(above), q = sqrt(below);
  if (p * p != above || q * q != below) fail();
  return rational(p) / rational(q);
}

/// \f$\sqrt{x + \epsilon x'} = \sqrt x + \epsilon x'/(2\sqrt x)\f$.
template <class S, int N>
Dual<S, N> square_root(Dual<S, N> const& x) {
  S const root = square_root(x.value);
  return chain(x, root, S(S(1) / (root + root)));
}

/// The same to second order.
template <class S, int m>
SecondOrder<S, m> square_root(SecondOrder<S, m> const& x) {
  S const root = square_root(x.value);
  S const slope = S(1) / (root + root);
  return chain(x, root, slope, S(-slope / (x.value + x.value)));
}

}  // namespace actio
