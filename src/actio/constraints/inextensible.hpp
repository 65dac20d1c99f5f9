// The inextensible string: a curve in space whose lengths are constant, with the tension as multiplier.
#pragma once

#include "actio/constraints/augmented.hpp"
#include "actio/forms/metric.hpp"

namespace actio {

/// The constraint \f$\tfrac12(1 - g(\phi_s, \phi_s)) = 0\f$ on curves, n = 1: s is the length along the
/// string. Its multiplier in `AugmentedDensity` is the tension.
/// @tparam SpaceMetric  g, a callable on points of space
template <class SpaceMetric>
struct Inextensible {
  static constexpr int components = 1;  ///< one multiplier, the tension
  SpaceMetric g;                        ///< metric of the space

  /// Half of what is missing in the squared length of the tangent.
  template <class S, int N>
  Matrix<S, 1, 1> operator()(Jet<S, 1, N> const& j) const {
    Matrix<S, N, 1> const along = j.v.col(1);
    Matrix<S, 1, 1> value;
    value[0] = (S(1) - inner(g(j.y), along, along)) / S(2);
    return value;
  }
};
/// The constraint in a space with a metric.
template <class SpaceMetric>
Inextensible(SpaceMetric) -> Inextensible<SpaceMetric>;

/// The density of a string without stiffness, which the constraint alone keeps from stretching:
/// \f$L = \rho\,(\tfrac12|\phi_t|^2 + \mathbf g\cdot\phi)\f$, in flat space with a uniform gravity.
template <class S, int N>
struct HeavyString {
  S rho;                    ///< mass per length
  Matrix<S, N, 1> gravity;  ///< acceleration of a free fall

  /// Kinetic energy and potential per length.
  template <class T>
  T operator()(Jet<T, 1, N> const& j) const {
    T sum(0);
    for (int a = 0; a < N; ++a) sum += j.v(a, 0) * j.v(a, 0) / T(2) + j.y[a] * T(Base<T>(gravity[a]));
    return sum * T(Base<T>(rho));
  }
};

}  // namespace actio
