// Power series in the time.
//
// A series is a scalar like any other: formulas of the library run on it, also inside dual numbers, and give
// the series of their result. Reference solutions by them are in taylor_reference.hpp.
#pragma once

#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>

#include "actio/numbers/dual.hpp"
#include "actio/numbers/errors.hpp"

namespace actio {

/// A power series \f$\sum_k c_k t^k\f$, known up to \f$t^{order}\f$; a constant is known to all orders and
/// stores one coefficient.
///
/// \snippet numbers.cpp taylor
template <class S>
struct Taylor {
  static constexpr int all = INT_MAX;  ///< the order of a constant

  std::vector<S> coefficients{S(0)};  ///< at least one; those not stored, up to `order`, are zero
  int order = all;                    ///< the last power that is known; `all` for constants alone

  Taylor() = default;
  /// The constant series.
  Taylor(S const& constant) : coefficients{constant} {}
  /// The same from an integer or the number at the bottom of S.
  template <class T>
    requires(!std::same_as<T, S> && (std::integral<T> || std::same_as<T, Base<S>>))
  Taylor(T constant) : coefficients{S(constant)} {}
  /// The series with these coefficients, known as far as they go.
  static Taylor series(std::vector<S> coefficients) {
    Taylor x;
    x.order = static_cast<int>(coefficients.size()) - 1;
    x.coefficients = std::move(coefficients);
    return x;
  }

  /// How many coefficients are stored.
  int stored() const { return static_cast<int>(coefficients.size()); }
  /// \f$c_k\f$, zero where it is not stored.
  S coefficient(int k) const { return k < stored() ? coefficients[k] : S(0); }

  /// The value at time t.
  template <class T>
  S at(T const& t) const {
    S sum = coefficients.back();
    for (int k = stored() - 2; k >= 0; --k) sum = sum * t + coefficients[k];
    return sum;
  }

  Taylor& operator+=(Taylor const& y) {
    agree(y);
    if (stored() < stored_of(y.stored())) coefficients.resize(stored_of(y.stored()), S(0));
    for (int k = 0; k < stored_of(y.stored()); ++k) coefficients[k] += y.coefficients[k];
    return *this;
  }
  Taylor& operator-=(Taylor const& y) {
    agree(y);
    if (stored() < stored_of(y.stored())) coefficients.resize(stored_of(y.stored()), S(0));
    for (int k = 0; k < stored_of(y.stored()); ++k) coefficients[k] -= y.coefficients[k];
    return *this;
  }
  Taylor& operator*=(Taylor const& y) { return *this = *this * y; }
  Taylor& operator/=(Taylor const& y) { return *this = *this / y; }

  friend Taylor operator+(Taylor x, Taylor const& y) { return x += y; }
  friend Taylor operator-(Taylor x, Taylor const& y) { return x -= y; }
  friend Taylor operator-(Taylor x) {
    for (S& c : x.coefficients) c = -c;
    return x;
  }
  friend Taylor operator+(Taylor const& x) { return x; }
  friend Taylor operator*(Taylor const& x, Taylor const& y) {
    Taylor z = blank(x, y, x.stored() + y.stored() - 1);
    for (int i = 0; i < x.stored(); ++i)
      for (int j = 0; j < y.stored() && i + j < z.stored(); ++j)
        add_product(z.coefficients[i + j], x.coefficients[i], y.coefficients[j]);
    return z;
  }
  friend Taylor operator/(Taylor const& x, Taylor const& y) {
    // x = q y, solved from the lowest power up.
    Taylor q = blank(x, y, y.stored() == 1 ? x.stored() : all);
    for (int k = 0; k < q.stored(); ++k) {
      S rest = x.coefficient(k);
      for (int j = 1; j <= k && j < y.stored(); ++j) rest -= y.coefficients[j] * q.coefficients[k - j];
      q.coefficients[k] = rest / y.coefficients[0];
    }
    return q;
  }

  // Order is that of the values at t = 0; equality is that of everything.
  friend bool operator<(Taylor const& x, Taylor const& y) { return x.coefficients[0] < y.coefficients[0]; }
  friend bool operator>(Taylor const& x, Taylor const& y) { return x.coefficients[0] > y.coefficients[0]; }
  friend bool operator<=(Taylor const& x, Taylor const& y) { return x.coefficients[0] <= y.coefficients[0]; }
  friend bool operator>=(Taylor const& x, Taylor const& y) { return x.coefficients[0] >= y.coefficients[0]; }
  friend bool operator==(Taylor const& x, Taylor const& y) {
    for (int k = 0; k < std::max(x.stored(), y.stored()); ++k)
      if (!(x.coefficient(k) == y.coefficient(k))) return false;
    return true;
  }

  /// Room for a result that is known as far as x and y are, with `wanted` coefficients at most.
  static Taylor blank(Taylor const& x, Taylor const& y, int wanted) {
    Taylor z;
    z.order = std::min(x.order, y.order);
    z.coefficients.assign(z.stored_of(wanted), S(0));
    return z;
  }
  /// How many of `wanted` coefficients are known.
  int stored_of(int wanted) const { return order == all ? std::min(wanted, 1) : std::min(wanted, order + 1); }

 private:
  void agree(Taylor const& y) {
    order = std::min(order, y.order);
    if (stored() > stored_of(stored())) coefficients.resize(stored_of(stored()));
  }
};

template <class S>
struct BaseOf<Taylor<S>> {
  using type = Base<S>;
};
template <class S>
Base<S> const& base_value(Taylor<S> const& x) { return base_value(x.coefficients[0]); }
template <class S>
Base<S> magnitude(Taylor<S> const& x) {
  Base<S> largest(0);
  for (S const& c : x.coefficients) {
    Base<S> const size = magnitude(c);
    if (size != size) return size;
    if (size > largest) largest = size;
  }
  return largest;
}
template <class S>
bool is_finite(Taylor<S> const& x) {
  for (S const& c : x.coefficients)
    if (!is_finite(c)) return false;
  return true;
}

/// dx/dt, known to one power less.
template <class S>
Taylor<S> derivative(Taylor<S> const& x) {
  if (x.order == Taylor<S>::all) return {};
  Taylor<S> d;
  d.order = x.order - 1;
  for (int k = 1; k < x.stored(); ++k) {
    if (k > 1) d.coefficients.emplace_back();
    d.coefficients[k - 1] = x.coefficients[k] * S(k);
  }
  return d;
}

/// The series that is known as far as x is, with value `value`, whose k-th coefficient is `next(y, k)` from
/// the ones before.
template <class S, class Next>
Taylor<S> from_recurrence(Taylor<S> const& x, S const& value, Next const& next) {
  Taylor<S> y = Taylor<S>::blank(x, x, Taylor<S>::all);
  y.coefficients[0] = value;
  for (int k = 1; k < y.stored(); ++k) y.coefficients[k] = next(y, k);
  return y;
}

template <class S>
  requires Real<S>
Taylor<S> sqrt(Taylor<S> const& x) {
  // y y = x
  using std::sqrt;
  return from_recurrence(x, S(sqrt(x.coefficients[0])), [&](Taylor<S> const& y, int k) {
    S rest = x.coefficient(k);
    for (int j = 1; j < k; ++j) rest -= y.coefficients[j] * y.coefficients[k - j];
    return S(rest / (S(2) * y.coefficients[0]));
  });
}
template <class S>
  requires Real<S>
Taylor<S> exp(Taylor<S> const& x) {
  // y' = y x'
  using std::exp;
  return from_recurrence(x, S(exp(x.coefficients[0])), [&](Taylor<S> const& y, int k) {
    S sum(0);
    for (int j = 1; j <= k && j < x.stored(); ++j) sum += S(j) * x.coefficients[j] * y.coefficients[k - j];
    return S(sum / S(k));
  });
}
template <class S>
  requires Real<S>
Taylor<S> log(Taylor<S> const& x) {
  // x y' = x'
  using std::log;
  return from_recurrence(x, S(log(x.coefficients[0])), [&](Taylor<S> const& y, int k) {
    S rest = S(k) * x.coefficient(k);
    for (int j = 1; j < k && j < x.stored(); ++j)
      rest -= x.coefficients[j] * S(k - j) * y.coefficients[k - j];
    return S(rest / (S(k) * x.coefficients[0]));
  });
}
/// Sine and cosine together: s' = c x', c' = -s x'.
template <class S>
  requires Real<S>
std::pair<Taylor<S>, Taylor<S>> sine_and_cosine(Taylor<S> const& x) {
  using std::cos, std::sin;
  Taylor<S> s = Taylor<S>::blank(x, x, Taylor<S>::all), c = s;
  s.coefficients[0] = sin(x.coefficients[0]);
  c.coefficients[0] = cos(x.coefficients[0]);
  for (int k = 1; k < s.stored(); ++k) {
    for (int j = 1; j <= k && j < x.stored(); ++j) {
      s.coefficients[k] += S(j) * x.coefficients[j] * c.coefficients[k - j];
      c.coefficients[k] -= S(j) * x.coefficients[j] * s.coefficients[k - j];
    }
    s.coefficients[k] /= S(k);
    c.coefficients[k] /= S(k);
  }
  return {s, c};
}
template <class S>
  requires Real<S>
Taylor<S> sin(Taylor<S> const& x) { return sine_and_cosine(x).first; }
template <class S>
  requires Real<S>
Taylor<S> cos(Taylor<S> const& x) { return sine_and_cosine(x).second; }
template <class S>
  requires Real<S>
Taylor<S> atan2(Taylor<S> const& y, Taylor<S> const& x) {
  // a' = (x y' - y x') / (x^2 + y^2), integrated power by power.
  using std::atan2;
  S const value = atan2(y.coefficients[0], x.coefficients[0]);
  if (x.order == Taylor<S>::all && y.order == Taylor<S>::all) return value;
  Taylor<S> const rate = (x * derivative(y) - y * derivative(x)) / (x * x + y * y);
  Taylor<S> a = Taylor<S>::blank(x, y, Taylor<S>::all);
  a.coefficients[0] = value;
  for (int k = 1; k < a.stored(); ++k) a.coefficients[k] = rate.coefficient(k - 1) / S(k);
  return a;
}
template <class S>
Taylor<S> abs(Taylor<S> const& x) { return x.coefficients[0] < S(0) ? -x : x; }

}  // namespace actio
