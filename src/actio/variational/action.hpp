// The action of a curve: the integral of a Lagrangian along its tangent.
#pragma once

#include <cmath>
#include <vector>

#include "actio/variational/curves.hpp"

namespace actio {

/// Nodes and weights on (0, 1) that integrate polynomials up to a degree with rounding only, over the
/// rationals with no error at all.
///
/// The nodes are fractions next to those of Chebyshev, where interpolation is harmless.
///
/// \snippet numbers.cpp quadrature
template <Scalar S>
struct Quadrature {
  std::vector<S> nodes;    ///< inside (0, 1)
  std::vector<S> weights;  ///< they sum to 1

  /// @param degree  of the polynomials that come out exactly
  explicit Quadrature(int degree) {
    if (degree < 0) throw OutsideDomain("Quadrature", "a degree is at least zero", degree, 0);
    int const n = degree + 1;
    for (int j = 0; j < n; ++j)
      nodes.push_back(ratio<S>(2048 + std::lround(2047 * std::cos(M_PI * (j + 0.5) / n)), 4096));

    // The weights give each Chebyshev polynomial of 2x - 1 its integral: 1/(1 - k^2) for even k, 0 for odd.
    Matrix<S, Dynamic, Dynamic> values(n, n);
    Matrix<S, Dynamic, 1> integrals(n);
    for (int k = 0; k < n; ++k) {
      integrals[k] = k % 2 == 0 ? ratio<S>(1, 1 - long(k) * k) : S(0);
      for (int j = 0; j < n; ++j) {
        S const x = nodes[j] * S(2) - S(1);
        values(k, j) = k == 0 ? S(1) : k == 1 ? x : S(x * values(k - 1, j) * S(2) - values(k - 2, j));
      }
    }
    auto const solved = solve_linear(values, integrals, "Quadrature: nodes must differ");
    weights.assign(solved.data(), solved.data() + n);
  }

  /// The integral of f from a to b, at the scalar that f returns.
  template <Scalar T, class F>
  auto operator()(F const& f, T const& a, T const& b) const {
    using Value = decltype(f(a));
    Value sum(S(0));
    for (std::size_t j = 0; j < nodes.size(); ++j) sum += f(T(a + (b - a) * T(nodes[j]))) * Value(weights[j]);
    return sum * Value(b - a);
  }
};

/// The action \f$S(g(\cdot)) = \int_a^b L(g, \dot g)\,dt\f$ of a curve.
///
/// \implements{eq_2_1}
/// @param L      Lagrangian, energy
/// @param curve  time at any scalar -> Element at the same
/// @param rule   exact where L along the curve is a polynomial of its degree
/// @return energy x time
template <Scalar S, class Lagrangian, class Curve>
S action(Lagrangian const& L, Curve const& curve, S const& a, S const& b, Quadrature<Base<S>> const& rule) {
  // [eq_2_1]
  return rule([&](S const& t) { return L(tangent(curve, t)); }, a, b);
  // [eq_2_1]
}

/// \f$dS(g(\cdot))\cdot\delta g\f$: how the action changes along a family of curves.
///
/// \implements{eq_2_2}
/// @param family  (epsilon, time) at any scalar -> Element at the same
template <Scalar S, class Lagrangian, class Family>
S action_variation(Lagrangian const& L, Family const& family, S const& a, S const& b,
                   Quadrature<Base<S>> const& rule) {
  // [eq_2_2]
  return rule([&](S const& t) { return L(varied_tangent(family, t)).part[0]; }, a, b);
  // [eq_2_2]
}

}  // namespace actio
