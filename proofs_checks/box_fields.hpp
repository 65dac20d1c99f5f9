// Polynomials and fields on the unit box: what is claimed of integrals over a body with walls is computed
// there, exactly, without quadrature.
#pragma once

#include <map>

#include "fields.hpp"

namespace actio::checks {

/// A polynomial in k variables, term by term.
template <class S, int k>
struct Polynomial {
  using Powers = std::array<int, k>;
  std::map<Powers, S> terms;

  static Polynomial constant(S const& c) { return {{{Powers{}, c}}}; }
  static Polynomial variable(int i) {
    Powers powers{};
    powers[i] = 1;
    return {{{powers, S(1)}}};
  }
  Polynomial& operator+=(Polynomial const& other) {
    for (auto const& [powers, c] : other.terms) add(powers, c);
    return *this;
  }
  friend Polynomial operator+(Polynomial a, Polynomial const& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, Polynomial const& b) { return a += b * S(-1); }
  friend Polynomial operator*(Polynomial a, S const& c) {
    for (auto& [powers, value] : a.terms) value *= c;
    return a;
  }
  friend Polynomial operator*(Polynomial const& a, Polynomial const& b) {
    Polynomial product;
    for (auto const& [p, x] : a.terms)
      for (auto const& [q, y] : b.terms) product.add(sum(p, q), x * y);
    return product;
  }
  /// The derivative by a variable.
  Polynomial slope(int i) const {
    Polynomial d;
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

/// An integral over the unit box, and the sum of the moduli of what it was added up from.
template <class S>
struct Integral {
  S value{0};
  Base<S> size{0};
  Integral& operator+=(Integral const& other) {
    value += other.value, size += other.size;
    return *this;
  }
};
/// The integral of a product.
template <class S, int k>
Integral<S> integral(Polynomial<S, k> const& a, Polynomial<S, k> const& b) {
  Integral<S> total;
  for (auto const& [p, x] : a.terms)
    for (auto const& [q, y] : b.terms) {
      long measure = 1;
      for (int i = 0; i < k; ++i) measure *= p[i] + q[i] + 1;
      S const term = x * y / S(measure);
      total.value += term, total.size += magnitude(term);
    }
  return total;
}

/// n polynomials in k variables: a field, or a covector field.
template <class S, int n, int k>
using Polynomials = std::array<Polynomial<S, k>, n>;
template <class S, int n, int k>
Integral<S> integral(Polynomials<S, n, k> const& a, Polynomials<S, n, k> const& b) {
  Integral<S> total;
  for (int i = 0; i < n; ++i) total += integral(a[i], b[i]);
  return total;
}

/// A random polynomial of first degree in all variables, or with one more product.
template <class S, int k>
Polynomial<S, k> draw_polynomial(Draw& draw, bool product = false) {
  auto const linear = [&] {
    auto p = Polynomial<S, k>::constant(draw.number<S>());
    for (int i = 0; i < k; ++i) p += Polynomial<S, k>::variable(i) * draw.number<S>();
    return p;
  };
  auto const p = linear();
  return product ? p * linear() : p;
}
/// s (1 - s) of one of the variables: zero at two walls.
template <class S, int k>
Polynomial<S, k> wall(int i) {
  auto const s = Polynomial<S, k>::variable(i);
  return s - s * s;
}

/// The field \f$w^a = \partial_b\psi^{ab}\f$ of an antisymmetric matrix, of which psi has the entries below
/// the diagonal: without divergence for the volume of coordinates. The last n of k variables are places.
template <class S, int n, int k>
Polynomials<S, n, k> rotated(std::array<Polynomial<S, k>, n*(n - 1) / 2> const& psi) {
  Polynomials<S, n, k> w;
  for (int a = 0, at = 0; a < n; ++a)
    for (int b = 0; b < a; ++b, ++at) {
      w[a] += psi[at].slope(k - n + b);
      w[b] += psi[at].slope(k - n + a) * S(-1);
    }
  return w;
}
/// The same of random polynomials that vanish at the walls that they belong to: the field is along the walls.
/// `open` leaves one wall open.
template <class S, int n, int k>
Polynomials<S, n, k> draw_along_walls(Draw& draw, bool open = false) {
  std::array<Polynomial<S, k>, n*(n - 1) / 2> psi;
  for (int a = 0, at = 0; a < n; ++a)
    for (int b = 0; b < a; ++b, ++at) {
      auto const of_b = open && b == 0 ? Polynomial<S, k>::variable(k - n) : wall<S, k>(k - n + b);
      psi[at] = draw_polynomial<S, k>(draw) * wall<S, k>(k - n + a) * of_b;
    }
  return rotated<S, n, k>(psi);
}
/// \f$\partial_b(\beta\,\omega_{ab})\f$ with \f$\omega_{ab} = \partial_a\alpha_b - \partial_b\alpha_a\f$ and
/// a function \f$\beta\f$ that vanishes at all walls: a field without divergence along the walls, on which the
/// covector field does the work \f$-\tfrac12\int\beta\,\omega_{ab}\omega_{ab}\f$... with the sign of
/// `work_of_curl`.
template <class S, int n>
struct CurlField {
  Polynomials<S, n, n> w;
  Integral<S> work;  ///< \f$\int\beta\sum_{a<b}\omega_{ab}^2\f$
  explicit CurlField(Polynomials<S, n, n> const& alpha) {
    auto beta = Polynomial<S, n>::constant(S(1));
    for (int i = 0; i < n; ++i) beta = beta * wall<S, n>(i);
    std::array<Polynomial<S, n>, n*(n - 1) / 2> psi;
    for (int a = 0, at = 0; a < n; ++a)
      for (int b = 0; b < a; ++b, ++at) {
        auto const omega = alpha[b].slope(a) - alpha[a].slope(b);
        psi[at] = beta * omega;
        work += integral(psi[at], omega);
      }
    w = rotated<S, n, n>(psi);
  }
};

}  // namespace actio::checks
