// The elliptic integral of the third kind that the precession of a rigid body needs.
//
// Carlson's symmetric integral R_J by duplication \cite carlson_1995, where each round brings its arguments
// four times nearer to their mean, then a Taylor polynomial ends it. For arguments x <= y <= z <= p nothing
// cancels.
#pragma once

#include <cmath>

#include "actio/numbers/scalar.hpp"

namespace actio::bodies {

/// \f$\frac1{\sqrt e}\arctan\sqrt e\f$, for e not negative.
template <Real S>
S arctan_ratio(S const& e) {
  using std::atan, std::sqrt;
  if (e > S(1) / S(64)) {
    S const root = sqrt(e);
    return S(atan(root)) / root;
  }
  S sum(0), power(1);
  for (int n = 0; n < 400; ++n) {
    S const term = power / S(2 * n + 1);
    sum += term;
    if (!(magnitude(term) > epsilon<S>() / S(8))) break;
    power *= -e;
  }
  return sum;
}

/// \f[ \int_0^u \frac{\mathrm{sn}^2w}{1+g\,\mathrm{sn}^2w}\,dw = \frac{s^3}{3}\,R_J(c^2, d^2, 1, 1+g s^2),
///   \qquad s, c, d = \mathrm{sn}, \mathrm{cn}, \mathrm{dn}\ \text{of}\ u \f]
///
/// @param s  sn u, for u from 0 to the quarter period
/// @param x,y,k2  \f$\mathrm{cn}^2u\f$, \f$\mathrm{dn}^2u\f$, \f$k^2\f$
/// @param g  not negative
template <Real S>
S elliptic_integral_third_kind(S const& s, S x, S y, S const& k2, S const& g) {
  using std::pow, std::sqrt;
  S const square = s * s;
  if (square == S(0)) return S(0);
  S z(1), p = S(1) + g * square;
  S const mean0 = (x + y + S(1) + S(2) * p) / S(5);
  // Deviations from the mean and the product of the differences to p, from what they are made of.
  S const dx = mean0 - x, dy = mean0 - y, dz = mean0 - z;
  S e = (S(1) + g) * square * ((k2 + g) * square) * (g * square);
  S const spread = std::max({magnitude(dx), magnitude(dy), magnitude(dz), magnitude(S(mean0 - p))});
  // The polynomial stops before the sixth power of the deviations.
  S const enough = S(pow(S(epsilon<S>() / S(4)), S(1) / S(6)));
  S mean = mean0, quarter(1), sum(0);
  for (int round = 0; round < 600 && spread * quarter > enough * mean; ++round) {
    S const rx = sqrt(x), ry = sqrt(y), rz = sqrt(z), rp = sqrt(p);
    S const d = (rp + rx) * (rp + ry) * (rp + rz), lambda = rx * ry + ry * rz + rz * rx;
    sum += quarter / d * arctan_ratio<S>(e / (d * d));
    x = (x + lambda) / S(4), y = (y + lambda) / S(4), z = (z + lambda) / S(4), p = (p + lambda) / S(4),
    mean = (mean + lambda) / S(4);
    quarter /= S(4), e /= S(64);
  }
  S const X = dx * quarter / mean, Y = dy * quarter / mean, Z = dz * quarter / mean, P = -(X + Y + Z) / S(2);
  S const xyz = X * Y * Z, e2 = X * Y + X * Z + Y * Z - S(3) * P * P,
          e3 = xyz + S(2) * P * (e2 + S(2) * P * P), e4 = P * (S(2) * xyz + P * (e2 + S(3) * P * P)),
          e5 = xyz * P * P;
  S const series = S(1) - S(3) * e2 / S(14) + e3 / S(6) + S(9) * e2 * e2 / S(88) - S(3) * e4 / S(22) -
                   S(9) * e2 * e3 / S(52) + S(3) * e5 / S(26);
  S const integral = quarter * series / (mean * S(sqrt(mean))) + S(6) * sum;
  return s * square * integral / S(3);
}

/// The same integral for k = 1, where sn is the hyperbolic tangent: \f$\frac1{1+g}\Big(u-\frac{1}{\sqrt
/// g}\arctan(\sqrt g\,\tanh u)\Big)\f$. For u not small.
template <Real S>
S elliptic_integral_third_kind_on_separatrix(S const& u, S const& tanh_u, S const& g) {
  return (u - tanh_u * arctan_ratio<S>(g * tanh_u * tanh_u)) / (S(1) + g);
}

}  // namespace actio::bodies
