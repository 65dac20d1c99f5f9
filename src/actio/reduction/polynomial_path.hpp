// Polynomials of low degree over a step, as Galerkin methods use them: by their values at equal distances,
// read at the nodes of Gauss's rule.
#pragma once

#include "actio/numbers/gauss_quadrature.hpp"

namespace actio {

/// Polynomials of degree s on the unit interval that begin at 0, by their values at 1/s, 2/s, ..., 1, and
/// Gauss's rule with s nodes.
template <Real S>
  requires Plain<S>
struct PolynomialPath {
  /// Numbers by node of the rule and by polynomial.
  using Table = Matrix<S, Dynamic, Dynamic>;

  std::vector<S> nodes;        ///< \f$c_i\f$, fractions of the step
  std::vector<S> weights;      ///< \f$b_i\f$
  Table value;                 ///< \f$\lambda_\nu(c_i)\f$, row: node of the rule, column: \f$\nu\f$
  Table slope;                 ///< \f$\lambda_\nu'(c_i)\f$
  std::vector<S> final_slope;  ///< \f$\lambda_\nu'(1)\f$

  /// @param s  degree, 1 to 8
  /// @throws OutsideDomain  where it is none of these: equal distances are a good choice for low degrees only
  explicit PolynomialPath(int s) : value(at_least_one(s), s), slope(s, s), final_slope(s) {
    auto const rule = gauss_quadrature<S>(s);
    nodes = rule.nodes, weights = rule.weights;
    for (int nu = 0; nu < s; ++nu) {
      for (int i = 0; i < s; ++i) {
        auto const x = basis(nu, rule.nodes[i]);
        value(i, nu) = x.value, slope(i, nu) = x.rate;
      }
      final_slope[nu] = basis(nu, S(1)).rate;
    }
  }
  /// The degree s, which is the number of nodes too.
  int degree() const { return static_cast<int>(weights.size()); }

 private:
  static int at_least_one(int s) {
    if (s < 1 || s > 8)
      throw OutsideDomain("PolynomialPath", "a degree from 1 to 8 is needed", s, s < 1 ? 1 : 8);
    return s;
  }
  /// \f$\lambda_\nu\f$ with its derivative: 1 at (nu+1)/s, 0 at the other s nodes.
  ValueAndRate<S> basis(int nu, S const& time) const {
    int const s = static_cast<int>(final_slope.size());
    return derivative(
        [&]<class T>(T const& x) {
          T product(S(1));
          for (int m = 0; m <= s; ++m)
            if (m != nu + 1) product *= (x * S(s) - S(m)) / S(nu + 1 - m);
          return product;
        },
        time);
  }
};

}  // namespace actio
