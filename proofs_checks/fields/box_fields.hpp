// Polynomials and fields on the box of all points whose coordinates lie between -1 and 1: what is claimed of
// integrals over a body with walls is computed there, exactly, without quadrature.
#pragma once

#include <map>

#include "fields/fields.hpp"

namespace actio::checks {

/// A polynomial in k variables, term by term.
template <class S, int k>
struct BoxPolynomial {
  using Powers = std::array<int, k>;
  std::map<Powers, S> terms;

  static BoxPolynomial constant(S const& c) { return {{{Powers{}, c}}}; }
  static BoxPolynomial variable(int i) {
    Powers powers{};
    powers[i] = 1;
    return {{{powers, S(1)}}};
  }
  BoxPolynomial& operator+=(BoxPolynomial const& other) {
    for (auto const& [powers, c] : other.terms) add(powers, c);
    return *this;
  }
  friend BoxPolynomial operator+(BoxPolynomial a, BoxPolynomial const& b) { return a += b; }
  friend BoxPolynomial operator-(BoxPolynomial a, BoxPolynomial const& b) { return a += b * S(-1); }
  friend BoxPolynomial operator*(BoxPolynomial a, S const& c) {
    for (auto& [powers, value] : a.terms) value *= c;
    return a;
  }
  friend BoxPolynomial operator*(BoxPolynomial const& a, BoxPolynomial const& b) {
    BoxPolynomial product;
    for (auto const& [p, x] : a.terms)
      for (auto const& [q, y] : b.terms) product.add(sum(p, q), x * y);
    return product;
  }
  /// The derivative by a variable.
  BoxPolynomial slope(int i) const {
    BoxPolynomial d;
    for (auto const& [p, x] : terms)
      if (p[i] > 0) {
        Powers lower = p;
        --lower[i];
        d.add(lower, x * S(p[i]));
      }
    return d;
  }
  template <class V>
  auto operator()(V const& y) const {
    ScalarOf<V> value(0);
    for (auto const& [p, x] : terms) {
      ScalarOf<V> term(x);
      for (int i = 0; i < k; ++i)
        for (int power = 0; power < p[i]; ++power) term *= y[i];
      value += term;
    }
    return value;
  }
  static Powers sum(Powers p, Powers const& q) {
    for (int i = 0; i < k; ++i) p[i] += q[i];
    return p;
  }

 private:
  void add(Powers const& p, S const& x) {
    if (auto const [at, fresh] = terms.try_emplace(p, x); !fresh) at->second += x;
  }
};

/// An integral over the box, and the sum of the moduli of what it was added up from.
template <class S>
struct Integral {
  S value{0};
  Base<S> size{0};
  Integral& operator+=(Integral const& other) {
    value += other.value, size += other.size;
    return *this;
  }
};
/// By how much adding up monomials magnifies rounding: the sum of their moduli over the size of what is
/// compared, which is made of integrals.
template <class S>
double magnification(Base<S> const& moduli, S const& size) {
  if (exact_arithmetic<S>()) return 1;
  return std::max(1.0, to_double(Base<S>(moduli / size_of(size))));
}
/// The integral of a product.
template <class S, int k>
Integral<S> integral(BoxPolynomial<S, k> const& a, BoxPolynomial<S, k> const& b) {
  Integral<S> total;
  for (auto const& [p, x] : a.terms)
    for (auto const& [q, y] : b.terms) {
      long measure = 1;
      bool odd = false;
      for (int i = 0; i < k; ++i) odd = odd || (p[i] + q[i]) % 2 == 1, measure *= p[i] + q[i] + 1;
      if (odd) continue;
      S const term = x * y * ratio<S>(1 << k, measure);
      total.value += term, total.size += magnitude(term);
    }
  return total;
}

/// n polynomials in k variables: a field, or a covector field.
template <class S, int n, int k>
struct BoxField {
  std::array<BoxPolynomial<S, k>, n> component;
  BoxPolynomial<S, k>& operator[](int a) { return component[a]; }
  BoxPolynomial<S, k> const& operator[](int a) const { return component[a]; }
  template <class V>
  auto operator()(V const& at) const {
    Matrix<ScalarOf<V>, n, 1> out;
    for (int a = 0; a < n; ++a) out[a] = component[a](at);
    return out;
  }
};
template <class S, int n, int k>
Integral<S> integral(BoxField<S, n, k> const& a, BoxField<S, n, k> const& b) {
  Integral<S> total;
  for (int i = 0; i < n; ++i) total += integral(a[i], b[i]);
  return total;
}

/// A random polynomial of first degree in the first of the variables.
template <class S, int k>
BoxPolynomial<S, k> draw_linear(Draw& draw, int variables = k) {
  auto p = BoxPolynomial<S, k>::constant(draw.number<S>());
  for (int i = 0; i < variables; ++i) p += BoxPolynomial<S, k>::variable(i) * draw.number<S>();
  return p;
}
/// \f$1 - s^2\f$ of one of the variables: zero at two walls.
template <class S, int k>
BoxPolynomial<S, k> wall(int i) {
  auto const s = BoxPolynomial<S, k>::variable(i);
  return BoxPolynomial<S, k>::constant(S(1)) - s * s;
}

/// The field \f$w^a = \partial_b\psi^{ab}\f$ of an antisymmetric matrix, of which psi has the entries below
/// the diagonal: without divergence for the volume of coordinates. The last n of k variables are places.
template <class S, int n, int k>
BoxField<S, n, k> rotated(std::array<BoxPolynomial<S, k>, n*(n - 1) / 2> const& psi) {
  BoxField<S, n, k> w;
  for (int a = 0, at = 0; a < n; ++a)
    for (int b = 0; b < a; ++b, ++at) {
      w[a] += psi[at].slope(k - n + b);
      w[b] += psi[at].slope(k - n + a) * S(-1);
    }
  return w;
}
/// The same of random polynomials that vanish at the walls that they belong to: the field is along the walls.
/// `open` leaves one wall open. In space the polynomials have no terms that are not needed.
template <class S, int n, int k>
BoxField<S, n, k> draw_along_walls(Draw& draw, bool open = false) {
  std::array<BoxPolynomial<S, k>, n*(n - 1) / 2> psi;
  for (int a = 0, at = 0; a < n; ++a)
    for (int b = 0; b < a; ++b, ++at) {
      auto const of_b = open && b == 0
                            ? BoxPolynomial<S, k>::constant(S(1)) + BoxPolynomial<S, k>::variable(k - n)
                            : wall<S, k>(k - n + b);
      psi[at] = draw_linear<S, k>(draw, n == 2 ? k : k - n) * wall<S, k>(k - n + a) * of_b;
    }
  return rotated<S, n, k>(psi);
}
/// \f$w^a = \partial_b(\beta\,\omega^{ab})\f$ with
/// \f$\omega^{ab} = \partial_a\alpha_b - \partial_b\alpha_a\f$ and a function \f$\beta\f$ that is positive
/// inside the box and zero at its walls: a field without divergence along the walls.
template <class S, int n>
struct CurlField {
  BoxField<S, n, n> w;
  Integral<S> work;  ///< \f$\int\beta\sum_{a<b}(\omega^{ab})^2\f$: what \f$\alpha\f$ does along w
  explicit CurlField(BoxField<S, n, n> const& alpha) {
    auto beta = BoxPolynomial<S, n>::constant(S(1));
    for (int i = 0; i < n; ++i) beta = beta * wall<S, n>(i);
    std::array<BoxPolynomial<S, n>, n*(n - 1) / 2> psi;
    for (int a = 0, at = 0; a < n; ++a)
      for (int b = 0; b < a; ++b, ++at) {
        auto const omega = alpha[b].slope(a) - alpha[a].slope(b);
        psi[at] = beta * omega;
        work += integral(psi[at], omega);
      }
    w = rotated<S, n, n>(psi);
  }
};

/// The fields of the fluid in a box, over time and place.
template <class S, int n>
using FieldsInTime = BoxField<S, n, n + 1>;
/// \f$\partial_tw + u^b\partial_bw - w^b\partial_bu\f$, the change of a velocity field where the motion
/// is varied by w; or with the bracket turned round.
template <class S, int n>
FieldsInTime<S, n> varied_velocity(FieldsInTime<S, n> const& u, FieldsInTime<S, n> const& w,
                                   int bracket = 1) {
  FieldsInTime<S, n> out;
  for (int a = 0; a < n; ++a) {
    out[a] = w[a].slope(0);
    for (int b = 0; b < n; ++b) out[a] += (u[b] * w[a].slope(b + 1) - w[b] * u[a].slope(b + 1)) * S(bracket);
  }
  return out;
}
/// A metric with polynomial entries and volume 1: neither constant nor diagonal nor conformal.
template <class S, int n>
struct BoxMetric {
  std::array<BoxField<S, n, n>, n> entries;
  template <class V>
  auto operator()(V const& y) const {
    Matrix<ScalarOf<V>, n, n> g;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) g(a, b) = entries[a][b](y);
    return g;
  }
  /// The entries as polynomials in time and place.
  BoxPolynomial<S, n + 1> at(int a, int b) const { return with_time(entries[a][b]); }
  /// \f$\Gamma_{abc} = \tfrac12(\partial_cg_{ab} + \partial_bg_{ac} - \partial_ag_{bc})\f$.
  BoxPolynomial<S, n + 1> christoffel(int a, int b, int c) const {
    return with_time((entries[a][b].slope(c) + entries[a][c].slope(b) - entries[b][c].slope(a)) *
                     ratio<S>(1, 2));
  }
  static BoxPolynomial<S, n + 1> with_time(BoxPolynomial<S, n> const& p) {
    BoxPolynomial<S, n + 1> out;
    for (auto const& [powers, c] : p.terms) {
      std::array<int, n + 1> moved{};
      std::copy(powers.begin(), powers.end(), moved.begin() + 1);
      out.terms[moved] = c;
    }
    return out;
  }
};
template <class S, int n>
BoxMetric<S, n> draw_box_metric(Draw& draw) {
  // A^T A with a triangular A.
  std::array<BoxField<S, n, n>, n> A;
  for (int i = 0; i < n; ++i) {
    A[i][i] = BoxPolynomial<S, n>::constant(S(1));
    for (int k = i + 1; k < n; ++k) A[i][k] = draw_linear<S, n>(draw, n == 2 ? n : 1);
  }
  BoxMetric<S, n> g;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      for (int i = 0; i <= std::min(a, b); ++i) g.entries[a][b] += A[i][a] * A[i][b];
  return g;
}

/// \f$g_{ab}u^b\f$.
template <class S, int n>
FieldsInTime<S, n> lowered_in_box(BoxMetric<S, n> const& g, FieldsInTime<S, n> const& u) {
  FieldsInTime<S, n> out;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) out[a] += g.at(a, b) * u[b];
  return out;
}
/// \f$g_{ab}(\partial_tu^b + u^c\partial_cu^b) + \Gamma_{abc}u^bu^c\f$.
template <class S, int n>
FieldsInTime<S, n> acceleration_in_box(BoxMetric<S, n> const& g, FieldsInTime<S, n> const& u) {
  FieldsInTime<S, n> out;
  for (int b = 0; b < n; ++b) out[b] = u[b].slope(0);
  for (int b = 0; b < n; ++b)
    for (int c = 0; c < n; ++c) out[b] += u[c] * u[b].slope(c + 1);
  out = lowered_in_box(g, out);
  for (int b = 0; b < n; ++b)
    for (int c = 0; c < n; ++c) {
      auto const product = u[b] * u[c];
      for (int a = 0; a < n; ++a) out[a] += g.christoffel(a, b, c) * product;
    }
  return out;
}

}  // namespace actio::checks
