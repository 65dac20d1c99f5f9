// Isometries of space as symmetries of a medium (the introduction of chapter 9 of the thesis).
//
// A field k on space is Killing where the Lie derivative of g along it vanishes. A medium whose stored energy
// depends on g and the deformation through the Green tensor alone is equivariant under isometries, whatever
// its body is made of.
#pragma once

#include "actio/forms/metric.hpp"
#include "actio/jets/density.hpp"

namespace actio {

/// A field on space that does not preserve its metric.
struct NotKilling : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// Refuses a field that is not Killing at a point.
/// @param rate  what the Lie derivative is compared with: the metric's size times the rates of the field
/// @throws NotKilling  with the largest entry of the Lie derivative over `rate`
template <class Metric, class Field, class S, int N>
void require_killing(Metric const& g, Field const& k, Matrix<S, N, 1> const& y, Base<S> const& rate) {
  Base<S> const found = magnitude(lie_derivative(g, k, y));
  Base<S> const bound = Base<S>(256 * N) * epsilon<S>();
  if (!is_finite(found)) throw NotFinite("Killing field at y = " + show(y));
  if (found > bound * rate)
    throw NotKilling("field at y = " + show(y),
                     "an isometry preserves the metric; Lie derivative over the rates of the field",
                     rate > Base<S>(0) ? to_double(Base<S>(found / rate)) : to_double(found),
                     to_double(bound));
}

/// The rotation \f$k^a = A^a{}_by^b\f$ of flat space about the origin, A skew; with `shift` a translation
/// too.
template <class S, int N>
struct RigidMotion {
  Matrix<S, N, N> turn;   ///< A, skew
  Matrix<S, N, 1> shift;  ///< velocity of the origin
  /// The field at a point.
  template <class V>
  auto operator()(V const& y) const {
    using T = typename V::Scalar;
    Matrix<T, N, 1> k;
    for (int a = 0; a < N; ++a) {
      k[a] = T(shift[a]);
      for (int b = 0; b < N; ++b) k[a] += y[b] * T(turn(a, b));
    }
    return k;
  }
};

/// The metric \f$4R^2\,\delta_{ab}/(1+|y|^2)^2\f$ of the sphere of radius R in stereographic coordinates;
/// rational, with a rational volume.
template <class S, int N>
struct StereographicSphere {
  S radius = S(1);  ///< R
  /// The metric at a point.
  template <class V>
  auto operator()(V const& y) const {
    using T = typename V::Scalar;
    T square(1);
    for (int a = 0; a < N; ++a) square += y[a] * y[a];
    T const root = T(S(2 * radius)) / square;
    Matrix<T, N, N> g = Matrix<T, N, N>::Zero();
    for (int a = 0; a < N; ++a) g(a, a) = root * root;
    return g;
  }
};

/// The Killing fields \f$k = Ay + \tfrac12(1-|y|^2)\,b + (b\cdot y)\,y\f$ of the sphere in stereographic
/// coordinates: A skew turns it about the axis of the projection, b about others.
template <class S, int N>
struct SphereRotation {
  Matrix<S, N, N> turn;  ///< A, skew
  Matrix<S, N, 1> tilt;  ///< b
  /// The field at a point.
  template <class V>
  auto operator()(V const& y) const {
    using T = typename V::Scalar;
    T square(0), along(0);
    for (int a = 0; a < N; ++a) {
      square += y[a] * y[a];
      along += y[a] * T(tilt[a]);
    }
    Matrix<T, N, 1> k;
    for (int a = 0; a < N; ++a) {
      k[a] = along * y[a] + (T(1) - square) * T(S(tilt[a] / S(2)));
      for (int b = 0; b < N; ++b) k[a] += y[b] * T(turn(a, b));
    }
    return k;
  }
};

/// The field \f$(0, 0, k(y))\f$ on Y that moves points of space and leaves space-time fixed.
template <int N, class Field>
struct SpaceMotion {
  Field k;  ///< field on space
  /// The field at a point (x, y) of Y.
  template <class V>
  auto operator()(V const& point) const {
    using T = typename V::Scalar;
    Matrix<T, V::RowsAtCompileTime, 1> rate = Matrix<T, V::RowsAtCompileTime, 1>::Zero();
    rate.template tail<N>() = k(Matrix<T, N, 1>(point.template tail<N>()));
    return rate;
  }
};
/// The motion of points of space along a field on space of dimension N.
template <int N, class Field>
SpaceMotion<N, Field> motion_of_space(Field const& k) { return {k}; }

}  // namespace actio
