// The action of a section on a box of space-time, and integrals of forms over its boundary (section 6.2 of
// the thesis).
//
// Integrals are sums over tensor grids of a rule on the unit interval: Gauss's where there are roots, and
// over the rationals the rule with equally spaced nodes. Both are exact for polynomials of a degree that the
// caller names.
#pragma once

#include <array>
#include <concepts>
#include <vector>

#include "actio/forms/forms.hpp"
#include "actio/jets/density.hpp"
#include "actio/numbers/gauss_quadrature.hpp"

namespace actio {

/// A box of space-time: \f$[x^\mu_-, x^\mu_+]\f$ in each coordinate, time first.
template <class S, int n>
struct Box {
  Event<S, n> low;   ///< its lower corner
  Event<S, n> high;  ///< its upper corner
};

/// A rule on the unit interval: \f$\int_0^1 f \approx \sum_i b_i f(c_i)\f$.
template <class S>
struct IntervalRule {
  std::vector<S> nodes;    ///< \f$c_i\f$, between 0 and 1
  std::vector<S> weights;  ///< \f$b_i\f$
};

/// A rule that is exact for polynomials of the given degree: Gauss's, and over the rationals the one with
/// degree + 1 equally spaced nodes.
template <class S>
  requires Plain<S>
IntervalRule<S> rule_for(int degree) {
  if constexpr (Real<S>)
    if (!exact_arithmetic<S>()) {
      auto gauss = gauss_quadrature<S>(degree / 2 + 1);
      return {std::move(gauss.nodes), std::move(gauss.weights)};
    }
  // Weights from the moments: sum_i b_i c_i^k = 1/(k + 1).
  int const count = degree + 1;
  Matrix<S, Dynamic, Dynamic> powers(count, count), moments(count, 1);
  IntervalRule<S> rule;
  for (int i = 0; i < count; ++i) rule.nodes.push_back(ratio<S>(i + 1, count + 1));
  for (int k = 0; k < count; ++k) {
    moments(k, 0) = ratio<S>(1, k + 1);
    for (int i = 0; i < count; ++i) powers(k, i) = k == 0 ? S(1) : S(powers(k - 1, i) * rule.nodes[i]);
  }
  auto const weights = solve_linear(powers, moments, "rule_for");
  for (int i = 0; i < count; ++i) rule.weights.push_back(weights(i, 0));
  return rule;
}

/// \f$\int f\,d^{n+1}x\f$ over a box, exact for polynomials of the given degree in each coordinate.
/// @param f  a callable on points of space-time; what it returns is summed, so it may return dual numbers
template <class S, int rows, class F>
auto integral(F const& f, Matrix<S, rows, 1> const& low, Matrix<S, rows, 1> const& high, int degree) {
  using R = std::remove_cvref_t<decltype(f(low))>;
  auto const rule = rule_for<S>(degree);
  int const count = static_cast<int>(rule.nodes.size());
  R sum(0);
  std::array<int, rows> index{};
  for (bool more = true; more;) {
    Matrix<S, rows, 1> x;
    S weight(1);
    for (int mu = 0; mu < rows; ++mu) {
      x[mu] = low[mu] + (high[mu] - low[mu]) * rule.nodes[index[mu]];
      weight *= rule.weights[index[mu]] * (high[mu] - low[mu]);
    }
    sum += f(x) * weight;
    // The next node, as an odometer counts.
    more = false;
    for (int mu = 0; mu < rows && !more; ++mu) {
      more = ++index[mu] < count;
      if (!more) index[mu] = 0;
    }
  }
  return sum;
}

/// The action \f$S(\phi) = \int L(j^1\phi)\,d^{n+1}x\f$ of a section on a box.
///
/// \snippet fields.cpp action
/// @param degree  of \f$L(j^1\phi)\f$ in each coordinate; with that the integral is exact
template <class S, int n, class L, class Phi>
S action(L const& density, Phi const& phi, Box<S, n> const& box, int degree) {
  return integral([&](Event<S, n> const& x) { return S(density(first_jet(phi, x))); }, box.low, box.high,
                  degree);
}

/// The integral of an n-form on space-time over the boundary of a box, with the orientation of Stokes'
/// theorem: outward normal first.
/// @param alpha   n-form: a callable on a point and n tangent vectors
/// @param degree  of its coefficients in each coordinate
template <class S, int n, class Form>
S boundary_integral(Form const& alpha, Box<S, n> const& box, int degree) {
  S total(0);
  for (int mu = 0; mu <= n; ++mu) {
    // The side x^mu = const, with the other coordinates in their order; the outward normal first gives it the
    // sign (-1)^mu at the upper end.
    Tangents<S, n + 1, n> sides = Tangents<S, n + 1, n>::Zero();
    Matrix<S, n, 1> low, high;
    for (int nu = 0, k = 0; nu <= n; ++nu)
      if (nu != mu) {
        sides(nu, k) = S(1);
        low[k] = box.low[nu], high[k] = box.high[nu];
        ++k;
      }
    for (bool upper : {false, true}) {
      auto const side = [&](Matrix<S, n, 1> const& s) {
        Event<S, n> x;
        for (int nu = 0, k = 0; nu <= n; ++nu)
          x[nu] = nu == mu ? (upper ? box.high[nu] : box.low[nu]) : s[k++];
        return S(alpha(x, sides));
      };
      S const part = integral(side, low, high, degree);
      if (upper == (mu % 2 == 0))
        total += part;
      else
        total -= part;
    }
  }
  return total;
}

}  // namespace actio
