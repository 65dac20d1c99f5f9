// Roots and transcendental functions of numbers that carry a divergence, by the chain rule.
#pragma once

#include "actio/numbers/divergence_number.hpp"
#include "actio/numbers/square_root.hpp"

namespace actio {

template <class S, int m, int N>
DivergenceNumber<S, m, N> sqrt(DivergenceNumber<S, m, N> const& x) {
  using std::sqrt;
  S const root = sqrt(x.value()), slope = S(1) / (root + root);
  return chain(x, root, slope, S(-slope / (x.value() + x.value())));
}
/// The root over any scalar, the rationals included.
template <class S, int m, int N>
DivergenceNumber<S, m, N> square_root(DivergenceNumber<S, m, N> const& x) {
  S const root = square_root(x.value()), slope = S(1) / (root + root);
  return chain(x, root, slope, S(-slope / (x.value() + x.value())));
}
template <class S, int m, int N>
DivergenceNumber<S, m, N> exp(DivergenceNumber<S, m, N> const& x) {
  using std::exp;
  S const e = exp(x.value());
  return chain(x, e, e, e);
}
template <class S, int m, int N>
DivergenceNumber<S, m, N> log(DivergenceNumber<S, m, N> const& x) {
  using std::log;
  S const inverse = S(1) / x.value();
  return chain(x, S(log(x.value())), inverse, S(-inverse * inverse));
}
template <class S, int m, int N>
DivergenceNumber<S, m, N> sin(DivergenceNumber<S, m, N> const& x) {
  using std::cos, std::sin;
  S const s = sin(x.value()), c = cos(x.value());
  return chain(x, s, c, S(-s));
}
template <class S, int m, int N>
DivergenceNumber<S, m, N> cos(DivergenceNumber<S, m, N> const& x) {
  using std::cos, std::sin;
  S const s = sin(x.value()), c = cos(x.value());
  return chain(x, c, S(-s), S(-c));
}
/// \f$x^e\f$ with a constant exponent, x > 0.
template <class S, int m, int N>
DivergenceNumber<S, m, N> pow(DivergenceNumber<S, m, N> const& x, Base<S> const& exponent) {
  using std::pow;
  S const power = pow(x.value(), exponent), slope = power * exponent / x.value();
  return chain(x, power, slope, S(slope * (exponent - Base<S>(1)) / x.value()));
}
template <class S, int m, int N>
DivergenceNumber<S, m, N> abs(DivergenceNumber<S, m, N> const& x) { return x.value() < S(0) ? -x : x; }
/// The angle of the point (x, y): the derivatives are those of the arc tangent of the smaller ratio.
template <class S, int m, int N>
DivergenceNumber<S, m, N> atan2(DivergenceNumber<S, m, N> const& y, DivergenceNumber<S, m, N> const& x) {
  using std::abs, std::atan2;
  bool const steep = abs(y.value()) > abs(x.value());
  auto const ratio = steep ? -x / y : y / x;
  S const slope = S(1) / (S(1) + ratio.value() * ratio.value());
  return chain(ratio, S(atan2(y.value(), x.value())), slope,
               S(-(ratio.value() + ratio.value()) * slope * slope));
}

}  // namespace actio
