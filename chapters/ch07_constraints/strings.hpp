// Strings that cannot stretch and run along themselves: their shapes, their motion phi(t, s) = X(s - vt) and
// its tension.
//
// A shape X is a curve by arc length s, over any scalar. Run along it at the speed v and phi_tt = v^2 X''.
// The tension rho v^2 then solves
//
//   rho (phi_tt - g) = (T phi_s)_s
//
// without gravity, whatever the shape; with gravity the catenary does, and rho g times the height above its
// directrix is added.
#pragma once

#include <cmath>
#include <type_traits>

#include "actio/jets/jet.hpp"
#include "actio/numbers/gauss_quadrature.hpp"

// A closed loop with three lobes, by its direction angle 2 pi s/l + a sin(6 pi s/l): of unit speed by
// construction, and closed.
struct Loop {
  double length, a;
  double angle(double s) const { return 2 * M_PI * s / length + a * std::sin(6 * M_PI * s / length); }
  double turning(double s) const { return 2 * M_PI / length * (1 + 3 * a * std::cos(6 * M_PI * s / length)); }
  actio::Vector<double, 2> direction(double s) const { return {std::cos(angle(s)), std::sin(angle(s))}; }
  // The place, by Gauss's rule on pieces of the length.
  actio::Vector<double, 2> place(double s) const {
    static auto const rule = actio::gauss_quadrature<double>(10);
    actio::Vector<double, 2> sum(0, 0);
    int const pieces = 16;
    for (int p = 0; p < pieces; ++p)
      for (int i = 0; i < 10; ++i)
        sum += rule.weights[i] * s / pieces * direction((p + rule.nodes[i]) * s / pieces);
    return sum;
  }
  // The shape over truncated polynomials, from the place and two derivatives.
  template <class T>
  actio::Matrix<T, 2, 1> operator()(T const& s) const {
    if constexpr (std::is_same_v<T, double>) {
      return place(s);
    } else {
      actio::Vector<double, 2> const X = place(s.value), X1 = direction(s.value),
                                     X2 = turning(s.value) * actio::Vector<double, 2>(-X1[1], X1[0]);
      return {chain(s, X[0], X1[0], X2[0]), chain(s, X[1], X1[1], X2[1])};
    }
  }
};

// The curve of a string that hangs, by arc length from its lowest point: (c arsinh(s/c), sqrt(c^2 + s^2)).
struct Catenary {
  double c;
  template <class T>
  actio::Matrix<T, 2, 1> operator()(T const& s) const {
    using std::log, std::sqrt;
    T const y = sqrt(s * s + c * c);
    return {log((s + y) / c) * c, y};
  }
};

// The section of a string that runs along its shape.
template <class Shape>
struct Running {
  Shape X;
  double v, rho;  // speed along itself, mass per length
  template <class V>
  auto operator()(V const& x) const { return X(typename V::Scalar(x[1] - x[0] * v)); }
};

// Its tension: rho v^2, and with gravity rho g times the height above the directrix.
template <class Shape>
struct Tension {
  Running<Shape> phi;
  double g, part = 1;  // of rho v^2
  template <class V>
  auto operator()(V const& x) const {
    using T = typename V::Scalar;
    actio::Matrix<T, 1, 1> tension;
    tension[0] = part * phi.rho * phi.v * phi.v;
    if (g != 0) tension[0] += phi(x)[1] * (phi.rho * g);
    return tension;
  }
  double at(double t, double s) const { return (*this)(actio::Event<double, 1>(t, s))[0]; }
};
