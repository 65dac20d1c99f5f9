// The constraint of an incompressible medium, its multiplier and the material pressure (section 8.1 of the
// thesis).
//
// The extended bundle E has the fibre coordinates (y^1, ..., y^n, lambda): its sections are a deformation and
// a multiplier, its jets are jets over (n, n + 1).
#pragma once

#include "actio/constraints/augmented.hpp"
#include "actio/continuum/continuum.hpp"

namespace actio {

/// The constraint \f$\Phi = J - 1\f$ of an incompressible medium (8.1), a function of first jets over (n, n).
///
/// \implements{eq_8_1}
/// @tparam BodyMetric   G, a callable on points of the body
/// @tparam SpaceMetric  g, a callable on points of space
template <class BodyMetric, class SpaceMetric>
struct VolumeConstraint {
  static constexpr int components = 1;
  BodyMetric G;   ///< metric of the body
  SpaceMetric g;  ///< metric of the space

  /// The Jacobian of the motion at a jet.
  template <class S, int n>
  S volume_ratio(Jet<S, n, n> const& j) const { return jacobian(G(j.particle()), g(j.y), j.gradient()); }
  /// \f$\Phi\f$, a column of one component as all constraints are.
  template <class S, int n>
  Matrix<S, 1, 1> operator()(Jet<S, n, n> const& j) const {
    // [eq_8_1]
    S const Phi = volume_ratio(j) - S(1);
    // [eq_8_1]
    return Matrix<S, 1, 1>(Phi);
  }
  /// Refuses what is no metric, and a jet whose Jacobian is not positive: there \f$\partial\Phi/\partial v\f$
  /// may vanish, and no pressure holds the volume.
  /// @throws NotAMetric, NotOrientationPreserving
  template <class S, int n>
  void examine(Jet<S, n, n> const& j) const {
    Matrix<S, n, 1> const x = j.particle();
    require_metric(G(x), x, "metric of the body");
    require_metric(g(j.y), j.y, "metric of the space");
    require_orientation(volume_ratio(j), x, "volume constraint");
  }
};
template <class BodyMetric, class SpaceMetric>
VolumeConstraint(BodyMetric, SpaceMetric) -> VolumeConstraint<BodyMetric, SpaceMetric>;

/// The deformation of a jet of the extended bundle: the multiplier and its derivatives are left out.
template <class S, int n, int M>
Jet<S, n, M - 1> deformation(Jet<S, n, M> const& j) { return configuration<M - 1>(j); }
/// The same of a second jet.
template <class S, int n, int M>
SecondJet<S, n, M - 1> deformation(SecondJet<S, n, M> const& j) {
  SecondJet<S, n, M - 1> below;
  static_cast<Jet<S, n, M - 1>&>(below) = configuration<M - 1>(static_cast<Jet<S, n, M> const&>(j));
  for (int mu = 0; mu <= n; ++mu) below.w[mu] = j.w[mu].template topRows<M - 1>();
  return below;
}

/// The section \f$(\phi, \lambda)\f$ of the extended bundle with the multiplier
/// \f$\lambda = \sqrt{\det G}\,P\f$ (8.2).
///
/// \implements{eq_8_2}
/// @param phi  deformation: a callable from points of space-time to points of space
/// @param P    material pressure: a callable on points of space-time
template <class Phi, class Pressure, class BodyMetric>
auto with_pressure(Phi const& phi, Pressure const& P, BodyMetric const& G) {
  return [phi, P, G]<class S, int rows>(Matrix<S, rows, 1> const& x) {
    auto const place = phi(x).eval();
    constexpr int N = std::remove_cvref_t<decltype(place)>::RowsAtCompileTime;
    Matrix<S, rows - 1, 1> const particle = x.template tail<rows - 1>();
    Matrix<S, N + 1, 1> both;
    both.template head<N>() = place;
    // [eq_8_2]
    both[N] = volume<S>(G(particle)) * P(x);
    // [eq_8_2]
    return both;
  };
}

/// The material pressure \f$P = \lambda/\sqrt{\det G}\f$ of a jet of the extended bundle (8.2).
template <class BodyMetric, class S, int n, int M>
S multiplier_pressure(BodyMetric const& G, Jet<S, n, M> const& j) {
  return j.y[M - 1] / volume<S>(G(j.particle()));
}

/// The derivatives \f$\partial P/\partial x^k\f$, k = 1, ..., n, of the material pressure.
template <class BodyMetric, class S, int n, int M>
Matrix<S, n, 1> pressure_gradient(BodyMetric const& G, SecondJet<S, n, M> const& j) {
  Matrix<S, n, 1> rates;
  for (int k = 0; k < n; ++k)
    rates[k] = total_derivative(
        k + 1, [&](auto const& jet) { return multiplier_pressure(G, jet); }, j);
  return rates;
}

}  // namespace actio
