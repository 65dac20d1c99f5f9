// Gauss quadrature on the unit interval, at any precision.
//
// The nodes are the zeros of a Legendre polynomial, found by Newton's iteration in the scalar itself: no
// table of decimals to outgrow.
#pragma once

#include <vector>

#include "actio/numbers/derivative.hpp"
#include "actio/numbers/errors.hpp"

namespace actio {

/// A rule \f$\int_0^1 f(t)\,dt \approx \sum_i b_i\,f(c_i)\f$: nodes in (0, 1), rising, and weights that add
/// up to 1.
template <Real S>
struct GaussRule {
  std::vector<S> nodes;    ///< \f$c_1 < \dots < c_s\f$
  std::vector<S> weights;  ///< \f$b_1, \dots, b_s\f$, positive
};

/// The Legendre polynomial \f$P_n(x)\f$, by \f$k\,P_k = (2k-1)\,x\,P_{k-1} - (k-1)\,P_{k-2}\f$.
/// @param n  degree, at least 1
template <Real S>
S legendre_polynomial(int n, S const& x) {
  S before(1), now = x;
  for (int k = 2; k <= n; ++k) {
    S const next = (x * now * S(2 * k - 1) - before * S(k - 1)) / S(k);
    before = now, now = next;
  }
  return now;
}

/// Gauss's rule with s nodes: \f$\int_0^1 f(t)\,dt \approx \sum_i b_i\,f(c_i)\f$, exact for polynomials of
/// degree below 2s.
///
/// With x a zero of \f$P_s\f$, \f$c = (1+x)/2\f$ and \f$b = 1/((1-x^2)\,P_s'(x)^2)\f$.
/// @param s  number of nodes, 1 to 1000
/// @throws OutsideDomain  where there are to be none, or more than 1000
/// Accuracy: a few epsilon for the few nodes that a step of an integrator has.
template <Real S>
  requires Plain<S>
GaussRule<S> gauss_quadrature(int s) {
  if (s < 1 || s > 1000)
    throw OutsideDomain("gauss_quadrature", "1 to 1000 nodes are needed", s, s < 1 ? 1 : 1000);
  GaussRule<S> rule{std::vector<S>(s), std::vector<S>(s)};
  for (int i = 0; i < s; ++i) {
    // Tricomi's guess is good to a few digits; each round doubles them, and one more does no harm.
    S x(-std::cos(M_PI * (i + 0.75) / (s + 0.5)));
    S slope(0);
    for (double digits = 2; digits < 3 * decimal_digits<S>(); digits *= 2) {
      auto const p = derivative([s](auto const& y) { return legendre_polynomial(s, y); }, x);
      slope = p.rate;
      x -= p.value / slope;
    }
    rule.nodes[i] = (S(1) + x) / S(2);
    rule.weights[i] = S(1) / ((S(1) - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace actio
