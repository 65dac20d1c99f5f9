// Dual numbers over packs: several systems side by side, each with a tangent vector. Every operation is
// inlined, as those of packs are.
#pragma once

#include "actio/numbers/dual.hpp"
#include "actio/numbers/pack.hpp"

namespace actio {

/// Values and rates of change along one direction each. A pack or a double beside it is a constant.
template <int n>
struct Dual<Pack<n>, 1> {
  using B = Pack<n>;        ///< the numbers of all lanes
  B value{};                ///< the numbers themselves
  std::array<B, 1> part{};  ///< their rates

  Dual() = default;
  /// A constant.
  [[gnu::always_inline]] Dual(B const& v) : value(v) {}
  /// The same constant in all lanes.
  [[gnu::always_inline]] Dual(double v) : value(v) {}
  /// Values with these rates.
  [[gnu::always_inline]] Dual(B const& v, B const& rate) : value(v), part{rate} {}

  [[gnu::always_inline]] Dual& operator+=(Dual const& y) {
    value += y.value, part[0] += y.part[0];
    return *this;
  }
  [[gnu::always_inline]] Dual& operator-=(Dual const& y) {
    value -= y.value, part[0] -= y.part[0];
    return *this;
  }
  [[gnu::always_inline]] friend Dual operator-(Dual const& x) { return {-x.value, -x.part[0]}; }
  [[gnu::always_inline]] friend Dual operator+(Dual const& x, Dual const& y) {
    return {x.value + y.value, x.part[0] + y.part[0]};
  }
  [[gnu::always_inline]] friend Dual operator-(Dual const& x, Dual const& y) {
    return {x.value - y.value, x.part[0] - y.part[0]};
  }
  [[gnu::always_inline]] friend Dual operator*(Dual const& x, Dual const& y) {
    return {x.value * y.value, x.value * y.part[0] + x.part[0] * y.value};
  }
  [[gnu::always_inline]] friend Dual operator/(Dual const& x, Dual const& y) {
    B const inverse = 1.0 / y.value, quotient = x.value * inverse;
    return {quotient, (x.part[0] - quotient * y.part[0]) * inverse};
  }
  [[gnu::always_inline]] friend Dual operator+(Dual const& x, B const& c) { return {x.value + c, x.part[0]}; }
  [[gnu::always_inline]] friend Dual operator+(B const& c, Dual const& x) { return {c + x.value, x.part[0]}; }
  [[gnu::always_inline]] friend Dual operator-(Dual const& x, B const& c) { return {x.value - c, x.part[0]}; }
  [[gnu::always_inline]] friend Dual operator-(B const& c, Dual const& x) {
    return {c - x.value, -x.part[0]};
  }
  [[gnu::always_inline]] friend Dual operator*(Dual const& x, B const& c) {
    return {x.value * c, x.part[0] * c};
  }
  [[gnu::always_inline]] friend Dual operator*(B const& c, Dual const& x) { return x * c; }
  [[gnu::always_inline]] friend Dual operator+(Dual const& x, double c) { return x + B(c); }
  [[gnu::always_inline]] friend Dual operator+(double c, Dual const& x) { return x + B(c); }
  [[gnu::always_inline]] friend Dual operator-(Dual const& x, double c) { return x - B(c); }
  [[gnu::always_inline]] friend Dual operator-(double c, Dual const& x) { return B(c) - x; }
  [[gnu::always_inline]] friend Dual operator*(Dual const& x, double c) { return x * B(c); }
  [[gnu::always_inline]] friend Dual operator*(double c, Dual const& x) { return x * B(c); }
  [[gnu::always_inline]] friend Dual operator/(double c, Dual const& x) {
    B const inverse = 1.0 / x.value, quotient = c * inverse;
    return {quotient, -(quotient * inverse) * x.part[0]};
  }
  [[gnu::always_inline]] friend bool operator<(Dual const& x, Dual const& y) { return x.value < y.value; }
  [[gnu::always_inline]] friend bool operator>(Dual const& x, Dual const& y) { return x.value > y.value; }
  [[gnu::always_inline]] friend bool operator<=(Dual const& x, Dual const& y) { return x.value <= y.value; }
};

/// The root in each lane, with its rate.
template <int n>
[[gnu::always_inline]] inline Dual<Pack<n>> sqrt(Dual<Pack<n>> const& x) {
  Pack<n> const root = sqrt(x.value);
  return {root, 0.5 * x.part[0] / root};
}

}  // namespace actio
