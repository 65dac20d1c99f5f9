// Truncated polynomials: a value with its first and second derivatives along m directions.
//
// Arithmetic of polynomials in m infinitesimals, cut after the second degree. One evaluation of a map gives
// its second-order Taylor polynomial, exactly, with each mixed derivative once: for m = 4 there are 15
// numbers, where dual numbers of dual numbers carry 25.
#pragma once

#include <array>

#include "actio/numbers/dual.hpp"

namespace actio {

template <class S, int m>
struct SecondOrder;

template <class S, int m>
struct BaseOf<SecondOrder<S, m>> {
  using type = Base<S>;
};

/// A number \f$x + \sum_i x_i\,s_i + \tfrac12\sum_{ij} x_{ij}\,s_is_j\f$ up to terms of third degree.
template <class S, int m>
struct SecondOrder {
  static constexpr int pairs = m * (m + 1) / 2;  ///< how many second derivatives there are

  S value{};                      ///< the number itself
  std::array<S, m> first{};       ///< \f$x_i\f$, its first derivatives
  std::array<S, pairs> second{};  ///< \f$x_{ij}\f$ with \f$i\ge j\f$, row by row

  /// Where \f$x_{ij}\f$ stands in `second`.
  static constexpr int at(int i, int j) { return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j; }

  SecondOrder() = default;
  SecondOrder(S const& v) : value(v) {}
  template <ConstantOver<S> T>
    requires(!std::same_as<T, S>)
  SecondOrder(T v) : value(v) {}
  /// The variable along direction i, at v.
  static SecondOrder variable(S const& v, int i) {
    SecondOrder x(v);
    x.first[i] = S(1);
    return x;
  }

  SecondOrder& operator+=(SecondOrder const& y) {
    value += y.value;
    for (int i = 0; i < m; ++i) first[i] += y.first[i];
    for (int k = 0; k < pairs; ++k) second[k] += y.second[k];
    return *this;
  }
  SecondOrder& operator-=(SecondOrder const& y) {
    value -= y.value;
    for (int i = 0; i < m; ++i) first[i] -= y.first[i];
    for (int k = 0; k < pairs; ++k) second[k] -= y.second[k];
    return *this;
  }
  SecondOrder& operator*=(SecondOrder const& y) { return *this = *this * y; }
  SecondOrder& operator/=(SecondOrder const& y) { return *this = *this / y; }
  template <ConstantOver<S> T>
  SecondOrder& operator*=(T const& c) {
    value *= c;
    for (S& f : first) f *= c;
    for (S& s : second) s *= c;
    return *this;
  }
  template <ConstantOver<S> T>
  SecondOrder& operator/=(T const& c) {
    value /= c;
    for (S& f : first) f /= c;
    for (S& s : second) s /= c;
    return *this;
  }

  friend SecondOrder operator+(SecondOrder x, SecondOrder const& y) { return x += y; }
  friend SecondOrder operator-(SecondOrder x, SecondOrder const& y) { return x -= y; }
  friend SecondOrder operator-(SecondOrder x) {
    x.value = -x.value;
    for (S& f : x.first) f = -f;
    for (S& s : x.second) s = -s;
    return x;
  }
  friend SecondOrder operator+(SecondOrder const& x) { return x; }
  friend SecondOrder operator*(SecondOrder const& x, SecondOrder const& y) {
    SecondOrder z(S(x.value * y.value));
    for (int i = 0; i < m; ++i) z.first[i] = x.value * y.first[i] + x.first[i] * y.value;
    for (int i = 0, k = 0; i < m; ++i)
      for (int j = 0; j <= i; ++j, ++k)
        z.second[k] =
            x.value * y.second[k] + x.second[k] * y.value + x.first[i] * y.first[j] + x.first[j] * y.first[i];
    return z;
  }
  friend SecondOrder operator/(SecondOrder const& x, SecondOrder const& y) {
    S const inverse = S(1) / y.value, square = inverse * inverse;
    return x * chain(y, inverse, S(-square), S((square + square) * inverse));
  }

  template <ConstantOver<S> T>
  friend SecondOrder operator+(SecondOrder x, T const& c) {
    x.value += c;
    return x;
  }
  template <ConstantOver<S> T>
  friend SecondOrder operator+(T const& c, SecondOrder x) {
    x.value += c;
    return x;
  }
  template <ConstantOver<S> T>
  friend SecondOrder operator-(SecondOrder x, T const& c) {
    x.value -= c;
    return x;
  }
  template <ConstantOver<S> T>
  friend SecondOrder operator-(T const& c, SecondOrder const& x) { return -x + c; }
  template <ConstantOver<S> T>
  friend SecondOrder operator*(SecondOrder x, T const& c) { return x *= c; }
  template <ConstantOver<S> T>
  friend SecondOrder operator*(T const& c, SecondOrder x) { return x *= c; }
  template <ConstantOver<S> T>
  friend SecondOrder operator/(SecondOrder x, T const& c) { return x /= c; }
  template <ConstantOver<S> T>
  friend SecondOrder operator/(T const& c, SecondOrder const& x) { return SecondOrder(S(c)) / x; }

  // Order is that of the values; equality is that of everything.
  friend bool operator<(SecondOrder const& x, SecondOrder const& y) { return x.value < y.value; }
  friend bool operator>(SecondOrder const& x, SecondOrder const& y) { return x.value > y.value; }
  friend bool operator<=(SecondOrder const& x, SecondOrder const& y) { return x.value <= y.value; }
  friend bool operator>=(SecondOrder const& x, SecondOrder const& y) { return x.value >= y.value; }
  friend bool operator==(SecondOrder const& x, SecondOrder const& y) {
    return x.value == y.value && x.first == y.first && x.second == y.second;
  }
};

/// The chain rule to second order: a function with value `f` and derivatives `df`, `ddf` at the value of `x`,
/// applied to `x`.
template <class S, int m>
SecondOrder<S, m> chain(SecondOrder<S, m> const& x, S const& f, S const& df, S const& ddf) {
  SecondOrder<S, m> y(f);
  for (int i = 0; i < m; ++i) y.first[i] = df * x.first[i];
  for (int i = 0, k = 0; i < m; ++i)
    for (int j = 0; j <= i; ++j, ++k) y.second[k] = df * x.second[k] + ddf * x.first[i] * x.first[j];
  return y;
}

template <class S, int m>
SecondOrder<S, m> sqrt(SecondOrder<S, m> const& x) {
  using std::sqrt;
  S const root = sqrt(x.value), slope = S(1) / (root + root);
  return chain(x, root, slope, S(-slope / (x.value + x.value)));
}
template <class S, int m>
SecondOrder<S, m> exp(SecondOrder<S, m> const& x) {
  using std::exp;
  S const e = exp(x.value);
  return chain(x, e, e, e);
}
template <class S, int m>
SecondOrder<S, m> log(SecondOrder<S, m> const& x) {
  using std::log;
  S const inverse = S(1) / x.value;
  return chain(x, S(log(x.value)), inverse, S(-inverse * inverse));
}
template <class S, int m>
SecondOrder<S, m> sin(SecondOrder<S, m> const& x) {
  using std::cos, std::sin;
  S const s = sin(x.value), c = cos(x.value);
  return chain(x, s, c, S(-s));
}
template <class S, int m>
SecondOrder<S, m> cos(SecondOrder<S, m> const& x) {
  using std::cos, std::sin;
  S const s = sin(x.value), c = cos(x.value);
  return chain(x, c, S(-s), S(-c));
}
/// \f$x^e\f$ with a constant exponent, x > 0.
template <class S, int m>
SecondOrder<S, m> pow(SecondOrder<S, m> const& x, Base<S> const& exponent) {
  using std::pow;
  S const power = pow(x.value, exponent), slope = power * exponent / x.value;
  return chain(x, power, slope, S(slope * (exponent - Base<S>(1)) / x.value));
}

template <class S, int m>
Base<S> const& base_value(SecondOrder<S, m> const& x) { return base_value(x.value); }
template <class S, int m>
Base<S> magnitude(SecondOrder<S, m> const& x) {
  Base<S> largest = magnitude(x.value);
  auto const look = [&](S const& c) {
    Base<S> const size = magnitude(c);
    if (largest == largest && !(size <= largest)) largest = size;  // a NaN stays
  };
  for (S const& f : x.first) look(f);
  for (S const& s : x.second) look(s);
  return largest;
}
template <class S, int m>
bool is_finite(SecondOrder<S, m> const& x) {
  if (!is_finite(x.value)) return false;
  for (S const& f : x.first)
    if (!is_finite(f)) return false;
  for (S const& s : x.second)
    if (!is_finite(s)) return false;
  return true;
}

}  // namespace actio
