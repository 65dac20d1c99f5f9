// Polynomials in three variables up to a total degree, dense: the series of moments of a body, and products
// and substitutions of them.
//
// Coefficients stand degree by degree, and in a degree n by falling powers of x, then of y: n = 2 is xx, xy,
// xz, yy, yz, zz.
#pragma once

#include <array>
#include <vector>

#include "actio/numbers/functions.hpp"

namespace actio::bodies {

/// How many coefficients a polynomial in three variables has up to a degree.
constexpr int coefficients_to(int degree) { return (degree + 1) * (degree + 2) * (degree + 3) / 6; }
/// Where the coefficient of \f$x^iy^jz^l\f$ stands.
constexpr int place_of(int i, int j, int l) {
  return coefficients_to(i + j + l - 1) + (j + l) * (j + l + 1) / 2 + l;
}
/// Calls `f(i, j, l)` for all exponents from one degree to another, in the order of the coefficients.
template <class F>
void over_exponents(int first, int last, F const& f) {
  for (int n = first; n <= last; ++n)
    for (int i = n; i >= 0; --i)
      for (int j = n - i; j >= 0; --j) f(i, j, n - i - j);
}
/// i! j! l!
constexpr long factorials(int i, int j, int l) { return factorial(i) * factorial(j) * factorial(l); }

/// A polynomial in three variables.
template <Scalar S>
struct Polynomial {
  int degree = 0;                     ///< the largest total degree
  std::vector<S> coefficients{S(0)};  ///< in the order of `place_of`

  /// Zero, up to a degree.
  explicit Polynomial(int degree_of = 0)
      : degree(degree_of), coefficients(coefficients_to(degree_of), S(0)) {}
  S& operator()(int i, int j, int l) { return coefficients[place_of(i, j, l)]; }
  S const& operator()(int i, int j, int l) const { return coefficients[place_of(i, j, l)]; }

  /// The same over another scalar.
  template <Scalar T>
  Polynomial<T> over() const {
    Polynomial<T> p(degree);
    for (std::size_t k = 0; k < coefficients.size(); ++k) p.coefficients[k] = T(coefficients[k]);
    return p;
  }
  /// Without what exceeds a degree.
  Polynomial cut(int to) const {
    Polynomial p = *this;
    if (to < degree) p.degree = to, p.coefficients.resize(coefficients_to(to));
    return p;
  }
  /// \f$p(-s)\f$.
  Polynomial reflected() const {
    Polynomial r = *this;
    over_exponents(0, degree, [&](int i, int j, int l) {
      if ((i + j + l) % 2) r(i, j, l) = -r(i, j, l);
    });
    return r;
  }
  /// The product, without what exceeds a degree.
  static Polynomial product(Polynomial const& p, Polynomial const& q, int degree) {
    Polynomial r(degree);
    over_exponents(0, p.degree < degree ? p.degree : degree, [&](int i, int j, int l) {
      if (S const& c = p(i, j, l); c != S(0)) {
        int const rest = degree - (i + j + l);
        over_exponents(0, q.degree < rest ? q.degree : rest,
                       [&](int a, int b, int d) { r(i + a, j + b, l + d) += c * q(a, b, d); });
      }
    });
    return r;
  }

  /// \f$p(A s)\f$, each degree by Horner's rule in the linear forms \f$(As)_1, (As)_2\f$.
  /// @param rows  those of A
  Polynomial substituted(std::array<std::array<S, 3>, 3> const& rows) const {
    Polynomial result(degree);
    result.coefficients[0] = coefficients[0];
    std::vector<Form> powers{Form{0, {S(1)}}};  // of the third form
    for (int n = 1; n <= degree; ++n) {
      powers.push_back(powers.back().times(rows[2]));
      Form whole = inner(n, 0, powers, rows[1]);  // the coefficient of x^n
      for (int m = 1; m <= n; ++m) {
        whole = whole.times(rows[0]);
        Form const part = inner(n - m, m, powers, rows[1]);
        for (std::size_t k = 0; k < part.c.size(); ++k) whole.c[k] += part.c[k];
      }
      for (std::size_t k = 0; k < whole.c.size(); ++k)
        result.coefficients[coefficients_to(n - 1) + k] = whole.c[k];
    }
    return result;
  }

 private:
  /// A homogeneous polynomial, in the order of the coefficients.
  struct Form {
    int n;
    std::vector<S> c;
    Form times(std::array<S, 3> const& linear) const {
      Form r{n + 1, std::vector<S>((n + 2) * (n + 3) / 2, S(0))};
      int k = 0;
      for (int m = 0; m <= n; ++m)  // y and z together have the exponent m
        for (int l = 0; l <= m; ++l, ++k) {
          r.c[k] += linear[0] * c[k];
          int const next = (m + 1) * (m + 2) / 2 + l;
          r.c[next] += linear[1] * c[k], r.c[next + 1] += linear[2] * c[k];
        }
      return r;
    }
  };
  /// The factor of \f$x^i\f$ in degree i + m, with forms in place of y and z.
  Form inner(int i, int m, std::vector<Form> const& powers, std::array<S, 3> const& second) const {
    Form sum{0, {(*this)(i, m, 0)}};
    for (int l = 1; l <= m; ++l) {
      sum = sum.times(second);
      S const& c = (*this)(i, m - l, l);
      for (std::size_t k = 0; k < sum.c.size(); ++k) sum.c[k] += c * powers[l].c[k];
    }
    return sum;
  }
};

}  // namespace actio::bodies
