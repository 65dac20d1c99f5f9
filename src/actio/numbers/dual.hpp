// Dual numbers: a value and its first-order change along N directions at once.
//
// Arithmetic with infinitesimals e_1, ..., e_N whose products are all zero. Evaluating a formula on them
// gives its exact derivative: no step size, nothing left out. They nest: over Dual<Dual<double>> one gets
// second derivatives, and over the rationals the derivative of a rational function is a rational number.
//
// N is the size of a small batch of directions, never the dimension of a space: callers loop over batches.
#pragma once

#include <array>

#include "actio/numbers/dual_lanes.hpp"
#include "actio/numbers/scalar.hpp"

namespace actio {

template <class S, int N = 1>
struct Dual;

template <class S, int N>
struct BaseOf<Dual<S, N>> {
  using type = Base<S>;
};

template <class S>
inline constexpr bool is_dual = false;
template <class S, int N>
inline constexpr bool is_dual<Dual<S, N>> = true;

/// What may stand beside a dual number over `S` without being one: an integer or the plain number at its
/// bottom.
template <class T, class S>
concept ConstantOver = std::integral<T> || std::same_as<T, Base<S>>;

/// z += x y, written so that nested products need no intermediate results.
template <class S, int N>
  requires(detail::in_pairs<S, N>)
[[gnu::always_inline]] inline void add_product(Dual<S, N>& __restrict z, Dual<S, N> const& x,
                                               Dual<S, N> const& y) {
  detail::Lanes<N> sum(z);
  sum.add_product(x, y);
  sum.store(z);
}
/// z += x y, written so that nested products need no intermediate results.
template <class S, int N>
void add_product(Dual<S, N>& __restrict z, Dual<S, N> const& x, Dual<S, N> const& y) {
  add_product(z.value, x.value, y.value);
  for (int a = 0; a < N; ++a) {
    add_product(z.part[a], x.value, y.part[a]);
    add_product(z.part[a], x.part[a], y.value);
  }
}

/// A number \f$x + \sum_a x_a\,\varepsilon_a\f$ with \f$\varepsilon_a\varepsilon_b = 0\f$.
template <class S, int N>
struct Dual {
  S value{};                ///< the number itself
  std::array<S, N> part{};  ///< its rates of change along the N directions

  Dual() = default;
  Dual(S const& v) : value(v) {}
  template <ConstantOver<S> T>
    requires(!std::same_as<T, S>)
  Dual(T v) : value(v) {}

  Dual& operator+=(Dual const& y) {
    if constexpr (detail::in_pairs<S, N>) {
      detail::Lanes<N> x(*this);
      x += detail::Lanes<N>(y);
      x.store(*this);
      return *this;
    }
    value += y.value;
    for (int a = 0; a < N; ++a) part[a] += y.part[a];
    return *this;
  }
  Dual& operator-=(Dual const& y) {
    if constexpr (detail::in_pairs<S, N>) {
      detail::Lanes<N> x(*this);
      x -= detail::Lanes<N>(y);
      x.store(*this);
      return *this;
    }
    value -= y.value;
    for (int a = 0; a < N; ++a) part[a] -= y.part[a];
    return *this;
  }
  Dual& operator*=(Dual const& y) { return *this = *this * y; }
  Dual& operator/=(Dual const& y) { return *this = *this / y; }
  template <ConstantOver<S> T>
  Dual& operator*=(T const& c) {
    if constexpr (detail::in_pairs<S, N>) {
      detail::Lanes<N> x(*this);
      x *= static_cast<double>(c);
      x.store(*this);
      return *this;
    }
    value *= c;
    for (int a = 0; a < N; ++a) part[a] *= c;
    return *this;
  }
  template <ConstantOver<S> T>
  Dual& operator/=(T const& c) {
    if constexpr (detail::in_pairs<S, N>) {
      detail::Lanes<N> x(*this);
      x /= static_cast<double>(c);
      x.store(*this);
      return *this;
    }
    value /= c;
    for (int a = 0; a < N; ++a) part[a] /= c;
    return *this;
  }

  friend Dual operator+(Dual x, Dual const& y) { return x += y; }
  friend Dual operator-(Dual x, Dual const& y) { return x -= y; }
  [[gnu::always_inline]] friend Dual operator*(Dual const& x, Dual const& y)
    requires(detail::in_pairs<S, N>)
  {
    Dual z;
    detail::Lanes<N> product(0.0);
    product.add_product(x, y);
    product.store(z);
    return z;
  }
  friend Dual operator*(Dual const& x, Dual const& y)
    requires(!detail::in_pairs<S, N>)
  {
    Dual z;
    add_product(z, x, y);
    return z;
  }
  friend Dual operator/(Dual const& x, Dual const& y) {
    // (x/y)' = (x' - (x/y) y') / y
    if constexpr (detail::in_pairs<S, N>) {
      Dual q;
      S const quotient = x.value / y.value;
      detail::Lanes<N> lanes(x), other(y);
      lanes -= other *= quotient;
      lanes *= S(1) / y.value;
      lanes.set_value(quotient);
      lanes.store(q);
      return q;
    }
    Dual q;
    S const inverse = S(1) / y.value;
    q.value = x.value / y.value;
    for (int a = 0; a < N; ++a) q.part[a] = (x.part[a] - q.value * y.part[a]) * inverse;
    return q;
  }
  friend Dual operator-(Dual x) {
    if constexpr (detail::in_pairs<S, N>) {
      detail::Lanes<N> lanes(x);
      lanes *= -1;
      lanes.store(x);
      return x;
    }
    x.value = -x.value;
    for (int a = 0; a < N; ++a) x.part[a] = -x.part[a];
    return x;
  }
  friend Dual operator+(Dual const& x) { return x; }

  template <ConstantOver<S> T>
  friend Dual operator+(Dual x, T const& c) {
    x.value += c;
    return x;
  }
  template <ConstantOver<S> T>
  friend Dual operator+(T const& c, Dual x) {
    x.value += c;
    return x;
  }
  template <ConstantOver<S> T>
  friend Dual operator-(Dual x, T const& c) {
    x.value -= c;
    return x;
  }
  template <ConstantOver<S> T>
  friend Dual operator-(T const& c, Dual const& x) { return -x + c; }
  template <ConstantOver<S> T>
  friend Dual operator*(Dual x, T const& c) { return x *= c; }
  template <ConstantOver<S> T>
  friend Dual operator*(T const& c, Dual x) { return x *= c; }
  template <ConstantOver<S> T>
  friend Dual operator/(Dual x, T const& c) { return x /= c; }
  template <ConstantOver<S> T>
  friend Dual operator/(T const& c, Dual const& x) { return Dual(S(c)) / x; }

  // Order is that of the values; equality is that of everything.
  friend bool operator<(Dual const& x, Dual const& y) { return x.value < y.value; }
  friend bool operator>(Dual const& x, Dual const& y) { return x.value > y.value; }
  friend bool operator<=(Dual const& x, Dual const& y) { return x.value <= y.value; }
  friend bool operator>=(Dual const& x, Dual const& y) { return x.value >= y.value; }
  friend bool operator==(Dual const& x, Dual const& y) { return x.value == y.value && x.part == y.part; }
};

/// The chain rule: a function with value `f` and derivative `df` at the value of `x`, applied to `x`.
template <class S, int N>
Dual<S, N> chain(Dual<S, N> const& x, S const& f, S const& df) {
  if constexpr (detail::in_pairs<S, N>) {
    Dual<S, N> y;
    detail::Lanes<N> lanes(x);
    lanes *= df;
    lanes.set_value(f);
    lanes.store(y);
    return y;
  }
  Dual<S, N> y(f);
  for (int a = 0; a < N; ++a) y.part[a] = df * x.part[a];
  return y;
}

template <class S, int N>
Dual<S, N> sqrt(Dual<S, N> const& x) {
  using std::sqrt;
  S const root = sqrt(x.value);
  return chain(x, root, S(S(1) / (root + root)));
}
template <class S, int N>
Dual<S, N> exp(Dual<S, N> const& x) {
  using std::exp;
  S const e = exp(x.value);
  return chain(x, e, e);
}
template <class S, int N>
Dual<S, N> log(Dual<S, N> const& x) {
  using std::log;
  return chain(x, S(log(x.value)), S(S(1) / x.value));
}
template <class S, int N>
Dual<S, N> sin(Dual<S, N> const& x) {
  using std::cos, std::sin;
  return chain(x, S(sin(x.value)), S(cos(x.value)));
}
template <class S, int N>
Dual<S, N> cos(Dual<S, N> const& x) {
  using std::cos, std::sin;
  return chain(x, S(cos(x.value)), S(-sin(x.value)));
}
template <class S, int N>
Dual<S, N> atan2(Dual<S, N> const& y, Dual<S, N> const& x) {
  using std::atan2;
  S const square = x.value * x.value + y.value * y.value;
  Dual<S, N> angle(S(atan2(y.value, x.value)));
  for (int a = 0; a < N; ++a) angle.part[a] = (x.value * y.part[a] - y.value * x.part[a]) / square;
  return angle;
}
/// \f$x^e\f$ with a constant exponent, x > 0.
template <class S, int N>
Dual<S, N> pow(Dual<S, N> const& x, Base<S> const& exponent) {
  using std::pow;
  S const power = pow(x.value, exponent);
  return chain(x, power, S(power * exponent / x.value));
}
template <class S, int N>
Dual<S, N> abs(Dual<S, N> const& x) { return x.value < S(0) ? -x : x; }

template <class S, int N>
Base<S> const& base_value(Dual<S, N> const& x) { return base_value(x.value); }
template <class S, int N>
Base<S> magnitude(Dual<S, N> const& x) {
  Base<S> largest = magnitude(x.value);
  if (largest != largest) return largest;
  for (S const& p : x.part) {
    Base<S> const size = magnitude(p);
    if (!(size <= largest)) largest = size;
    if (size != size) break;
  }
  return largest;
}
template <class S, int N>
bool is_finite(Dual<S, N> const& x) {
  if (!is_finite(x.value)) return false;
  for (S const& p : x.part)
    if (!is_finite(p)) return false;
  return true;
}

}  // namespace actio
