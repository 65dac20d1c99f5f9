// Numbers that carry a divergence: of a map, one evaluation gives the sums over mu of its second derivatives
// along delta_mu and epsilon_a^mu, for all a.
//
// They are polynomials in infinitesimals delta_mu and epsilon_a^mu whose products all vanish but delta_mu
// epsilon_a^mu = tau_a, the same for each mu. So of the second derivatives no more is stored than the N sums
// that a divergence is made of: for m = 4 and N = 3 there are 20 numbers, where dual numbers of dual numbers
// need four evaluations with 8.
#pragma once

#include <array>

#include "actio/numbers/dual.hpp"
#include "actio/numbers/number_row.hpp"

namespace actio {

template <class S, int m, int N>
struct DivergenceNumber;

template <class S, int m, int N>
struct BaseOf<DivergenceNumber<S, m, N>> {
  using type = Base<S>;
};

/// A number \f$x + \sum_\mu x_\mu\delta_\mu + \sum_{a\mu} x^a{}_\mu\,\varepsilon_a{}^\mu + \sum_a
/// x^a\,\tau_a\f$ with m values of mu and N of a, where \f$\delta_\mu\varepsilon_a{}^\mu = \tau_a\f$ and all
/// other products are zero.
template <class S, int m, int N>
struct DivergenceNumber {
  using Row = detail::Row<S, N + 1>;  ///< what belongs to one mu

  Row head;                ///< \f$x\f$, then \f$x^a\f$
  std::array<Row, m> row;  ///< for each mu \f$x_\mu\f$, then \f$x^a{}_\mu\f$

  DivergenceNumber() = default;
  /// A constant.
  DivergenceNumber(S const& v) { head.set(0, v); }
  /// A constant.
  template <ConstantOver<S> T>
    requires(!std::same_as<T, S>)
  DivergenceNumber(T v) { head.set(0, S(v)); }

  S value() const { return head[0]; }                                   ///< \f$x\f$
  S sum(int a) const { return head[1 + a]; }                            ///< \f$x^a\f$
  S rate(int mu) const { return row[mu][0]; }                           ///< \f$x_\mu\f$
  S slope(int mu, int a) const { return row[mu][1 + a]; }               ///< \f$x^a{}_\mu\f$
  void set_value(S const& x) { head.set(0, x); }                        ///< sets \f$x\f$
  void set_sum(int a, S const& x) { head.set(1 + a, x); }               ///< sets \f$x^a\f$
  void set_rate(int mu, S const& x) { row[mu].set(0, x); }              ///< sets \f$x_\mu\f$
  void set_slope(int mu, int a, S const& x) { row[mu].set(1 + a, x); }  ///< sets \f$x^a{}_\mu\f$

  DivergenceNumber& operator+=(DivergenceNumber const& y) {
    return each(y, [](auto& to, auto const& from) { to += from; });
  }
  DivergenceNumber& operator-=(DivergenceNumber const& y) {
    return each(y, [](auto& to, auto const& from) { to -= from; });
  }
  DivergenceNumber& operator*=(DivergenceNumber const& y) { return *this = *this * y; }
  DivergenceNumber& operator/=(DivergenceNumber const& y) { return *this = *this / y; }
  template <ConstantOver<S> T>
  DivergenceNumber& operator*=(T const& c) {
    return each(*this, [f = Base<S>(c)](auto& to, auto const&) { to *= f; });
  }
  template <ConstantOver<S> T>
  DivergenceNumber& operator/=(T const& c) {
    return each(*this, [f = Base<S>(c)](auto& to, auto const&) { to /= f; });
  }

  friend DivergenceNumber operator+(DivergenceNumber x, DivergenceNumber const& y) { return x += y; }
  friend DivergenceNumber operator-(DivergenceNumber x, DivergenceNumber const& y) { return x -= y; }
  friend DivergenceNumber operator-(DivergenceNumber x) {
    return x.each(x, [](auto& to, auto const& from) { to = -from; });
  }
  friend DivergenceNumber operator+(DivergenceNumber const& x) { return x; }
  friend DivergenceNumber operator*(DivergenceNumber const& x, DivergenceNumber const& y) {
    DivergenceNumber z;
    add_product(z, x, y);
    return z;
  }
  friend DivergenceNumber operator/(DivergenceNumber const& x, DivergenceNumber const& y) {
    S const inverse = S(1) / y.value(), square = inverse * inverse;
    return x * chain(y, inverse, S(-square), S((square + square) * inverse));
  }

  template <ConstantOver<S> T>
  friend DivergenceNumber operator+(DivergenceNumber x, T const& c) { return x.shift(c); }
  template <ConstantOver<S> T>
  friend DivergenceNumber operator+(T const& c, DivergenceNumber x) { return x.shift(c); }
  template <ConstantOver<S> T>
  friend DivergenceNumber operator-(DivergenceNumber x, T const& c) { return x.shift(-Base<S>(c)); }
  template <ConstantOver<S> T>
  friend DivergenceNumber operator-(T const& c, DivergenceNumber const& x) { return -x + c; }
  template <ConstantOver<S> T>
  friend DivergenceNumber operator*(DivergenceNumber x, T const& c) { return x *= c; }
  template <ConstantOver<S> T>
  friend DivergenceNumber operator*(T const& c, DivergenceNumber x) { return x *= c; }
  template <ConstantOver<S> T>
  friend DivergenceNumber operator/(DivergenceNumber x, T const& c) { return x /= c; }
  template <ConstantOver<S> T>
  friend DivergenceNumber operator/(T const& c, DivergenceNumber const& x) {
    return DivergenceNumber(S(c)) / x;
  }

  // Order is that of the values; equality is that of everything.
  friend bool operator<(DivergenceNumber const& x, DivergenceNumber const& y) {
    return x.value() < y.value();
  }
  friend bool operator>(DivergenceNumber const& x, DivergenceNumber const& y) {
    return x.value() > y.value();
  }
  friend bool operator<=(DivergenceNumber const& x, DivergenceNumber const& y) {
    return x.value() <= y.value();
  }
  friend bool operator>=(DivergenceNumber const& x, DivergenceNumber const& y) {
    return x.value() >= y.value();
  }
  friend bool operator==(DivergenceNumber const& x, DivergenceNumber const& y) {
    for (int j = 0; j <= N; ++j) {
      if (!(x.head[j] == y.head[j])) return false;
      for (int mu = 0; mu < m; ++mu)
        if (!(x.row[mu][j] == y.row[mu][j])) return false;
    }
    return true;
  }

 private:
  template <class F>
  DivergenceNumber& each(DivergenceNumber const& y, F const& f) {
    head.each(y.head, f);
#pragma GCC unroll 8
    for (int mu = 0; mu < m; ++mu) row[mu].each(y.row[mu], f);
    return *this;
  }
  template <class T>
  DivergenceNumber& shift(T const& c) {
    head.set(0, head[0] + c);
    return *this;
  }
};

/// z += x y.
template <class S, int m, int N>
void add_product(DivergenceNumber<S, m, N>& __restrict z, DivergenceNumber<S, m, N> const& x,
                 DivergenceNumber<S, m, N> const& y) {
  S const p = x.value(), q = y.value(), value = z.value() + p * q;
  detail::Row<S, N + 1> head = z.head;
  head.add(p, y.head);
  head.add(q, x.head);
#pragma GCC unroll 8
  for (int mu = 0; mu < m; ++mu) {
    head.add(x.rate(mu), y.row[mu]);
    head.add(y.rate(mu), x.row[mu]);
    z.row[mu].add(p, y.row[mu]);
    z.row[mu].add(q, x.row[mu]);
  }
  // In the first place of the head stands what is no product of the algebra.
  head.set(0, value);
  z.head = head;
}

/// The chain rule: a function with value `f` and derivatives `df`, `ddf` at the value of `x`, applied to `x`.
template <class S, int m, int N>
DivergenceNumber<S, m, N> chain(DivergenceNumber<S, m, N> const& x, S const& f, S const& df, S const& ddf) {
  DivergenceNumber<S, m, N> y;
  y.head.add(df, x.head);
#pragma GCC unroll 8
  for (int mu = 0; mu < m; ++mu) {
    y.row[mu].add(df, x.row[mu]);
    y.head.add(ddf * x.rate(mu), x.row[mu]);
  }
  y.head.set(0, f);
  return y;
}

template <class S, int m, int N>
Base<S> base_value(DivergenceNumber<S, m, N> const& x) { return base_value(x.value()); }
template <class S, int m, int N>
Base<S> magnitude(DivergenceNumber<S, m, N> const& x) {
  Base<S> largest = magnitude(x.value());
  auto const look = [&](detail::Row<S, N + 1> const& row) {
    for (int j = 0; j <= N; ++j) {
      Base<S> const size = magnitude(row[j]);
      if (largest == largest && !(size <= largest)) largest = size;  // a NaN stays
    }
  };
  look(x.head);
  for (auto const& row : x.row) look(row);
  return largest;
}
template <class S, int m, int N>
bool is_finite(DivergenceNumber<S, m, N> const& x) {
  for (int j = 0; j <= N; ++j) {
    if (!is_finite(x.head[j])) return false;
    for (auto const& row : x.row)
      if (!is_finite(row[j])) return false;
  }
  return true;
}

}  // namespace actio
