// Moments of the mass of a body, A_{ijl} = integral of x^i y^j z^l over its mass: what its gravity depends
// on.
#pragma once

#include <Eigen/Core>

#include "actio/numbers/errors.hpp"
#include "actio/two_bodies/polynomial.hpp"

namespace actio::bodies {

/// The moments of a body up to an order. Made by \ref sphere_moments, \ref ellipsoid_moments,
/// \ref polyhedron_moments, or from numbers that are given.
template <Scalar S = double>
struct Moments {
  /// \f$\sum_kA_k\,s^k/k!\f$, the integral of \f$e^{s\cdot x}\f$ over the mass; mass x length^degree
  Polynomial<S> series;

  /// All zero.
  explicit Moments(int order = 0) : series(order) {}
  /// Of this series.
  explicit Moments(Polynomial<S> of) : series(std::move(of)) {}
  /// Up to which total degree there are moments.
  int order() const { return series.degree; }
  /// The same over another scalar.
  template <Scalar T>
  Moments<T> over() const {
    return Moments<T>(series.template over<T>());
  }
  /// \f$A_{ijl}=\int x^iy^jz^l\,dm\f$.
  S operator()(int i, int j, int l) const { return series(i, j, l) * S(factorials(i, j, l)); }
  /// Sets \f$A_{ijl}\f$.
  void set(int i, int j, int l, S const& value) { series(i, j, l) = value / S(factorials(i, j, l)); }

  /// \f$A_{000}\f$.
  S const& mass() const { return series.coefficients[0]; }
  /// The centre of mass, length.
  Matrix<S, 3, 1> centre() const {
    return {series(1, 0, 0) / mass(), series(0, 1, 0) / mass(), series(0, 0, 1) / mass()};
  }
  /// The tensor of inertia about the origin, mass x length^2.
  Matrix<S, 3, 3> inertia_tensor() const {
    S const xx = (*this)(2, 0, 0), yy = (*this)(0, 2, 0), zz = (*this)(0, 0, 2);
    Matrix<S, 3, 3> I;
    I(0, 0) = yy + zz, I(1, 1) = zz + xx, I(2, 2) = xx + yy;
    I(0, 1) = I(1, 0) = -(*this)(1, 1, 0);
    I(1, 2) = I(2, 1) = -(*this)(0, 1, 1);
    I(2, 0) = I(0, 2) = -(*this)(1, 0, 1);
    return I;
  }

  /// The moments with another origin: the series times \f$e^{-c\cdot s}\f$.
  /// @param c  the new origin
  Moments seen_from(Matrix<S, 3, 1> const& c) const {
    Polynomial<S> shift(order());
    shift(0, 0, 0) = S(1);
    over_exponents(1, order(), [&](int i, int j, int l) {
      int const axis = i > 0 ? 0 : j > 0 ? 1 : 2;
      shift(i, j, l) = -shift(i - (axis == 0), j - (axis == 1), l - (axis == 2)) * c[axis] /
                       S(axis == 0   ? i
                         : axis == 1 ? j
                                     : l);
    });
    return Moments(Polynomial<S>::product(series, shift, order()));
  }
  /// The moments along other axes: of the coordinates \f$R^Tx\f$, whose series is that of x at \f$Rs\f$.
  /// @param axes  R, whose columns are the new axes
  Moments along(Matrix<S, 3, 3> const& axes) const {
    std::array<std::array<S, 3>, 3> rows;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) rows[i][j] = axes(i, j);
    return Moments(series.substituted(rows));
  }
};

/// The moments of a homogeneous ellipsoid about its centre, along its axes:
/// \f[ A_{2i,2j,2l} = \frac{3m}{2n+3}\,\frac{(2i-1)!!\,(2j-1)!!\,(2l-1)!!}{(2n+1)!!}\,a^{2i}b^{2j}c^{2l},
///     \qquad n=i+j+l, \f]
/// and zero with an odd exponent.
/// @param half_axes  length
/// @throws OutsideDomain  where the mass or a half axis is not positive, or the order negative
template <Scalar S>
Moments<S> ellipsoid_moments(S const& mass, std::array<S, 3> const& half_axes, int order) {
  if (!(mass > S(0)))
    throw OutsideDomain("moments of an ellipsoid", "the mass must be positive", to_double(mass), 0);
  for (S const& a : half_axes)
    if (!(a > S(0)))
      throw OutsideDomain("moments of an ellipsoid", "a half axis must be positive", to_double(a), 0);
  if (order < 0) throw OutsideDomain("moments of an ellipsoid", "the order must not be negative", order, 0);
  Moments<S> moments(order);
  auto const odd_factorial = [](int n) {  // (2n-1)!!
    S product(1);
    for (int k = 1; k <= n; ++k) product = product * S(2 * k - 1);
    return product;
  };
  auto const power = [](S const& a, int n) {
    S product(1);
    for (int k = 0; k < n; ++k) product = product * a;
    return product;
  };
  over_exponents(0, order, [&](int i, int j, int l) {
    if (i % 2 || j % 2 || l % 2) return;
    int const n = (i + j + l) / 2;
    moments.set(i, j, l,
                S(3) * mass / S(2 * n + 3) * odd_factorial(i / 2) * odd_factorial(j / 2) *
                    odd_factorial(l / 2) / odd_factorial(n + 1) * power(half_axes[0], i) *
                    power(half_axes[1], j) * power(half_axes[2], l));
  });
  return moments;
}
/// The moments of a homogeneous ball.
/// @throws OutsideDomain  where mass or radius is not positive
template <Scalar S>
Moments<S> sphere_moments(S const& mass, S const& radius, int order) {
  return ellipsoid_moments<S>(mass, {radius, radius, radius}, order);
}

}  // namespace actio::bodies
