// Square roots over every scalar, the rationals included.
//
// The volume of a metric is a square root. Over the rationals it exists where the number is the square of a
// rational, and metrics made as A^T A have such determinants: formulas of Riemannian geometry then run
// exactly, derivatives and all.
#pragma once

#include <cmath>
#include <optional>

#include "actio/numbers/dual.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/numbers/second_order.hpp"

namespace actio {

/// A number without a square root in its field.
struct NotASquare : NotInThisField {
  using NotInThisField::NotInThisField;
};

/// Roots in an exact field: `ExactRoot<S>::of(x)` is the root of x where x is a square, else empty.
template <class S>
struct ExactRoot;

/// \f$\sqrt x\f$ of a number: that of its scalar.
/// @throws NotASquare  over the rationals, where it is irrational or imaginary; the measured number is x
///                     itself, the bound 0
/// Accuracy: that of the scalar's root; exact over the rationals.
template <Plain S>
S square_root(S const& x) {
  if constexpr (is_exact<S>) {
    if (auto const root = ExactRoot<S>::of(x)) return *root;
    throw NotASquare("square_root", "the square of a rational number is needed over the rationals",
                     to_double(x), 0);
  } else {
    using std::sqrt;
    return sqrt(x);
  }
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
