// Two pressures: of a stored energy that depends on the volume, and of the multiplier that holds the volume (section 8.3 of the thesis).
#pragma once

#include "actio/incompressible/incompressible_equations.hpp"
#include "actio/jets/materials.hpp"

namespace actio {

/// The pressure \f$P_W = -\rho\,\partial W/\partial J\f$ of a barotropic fluid (6.16).
/// @param law  stored energy per unit mass as a function of J
template <class Law, class S>
S stored_pressure(Law const& law, S const& rho, S const& J) {
  Dual<S> moved(J);
  moved.part[0] = S(1);
  return -rho * law(moved).part[0];
}

/// The pressures of a barotropic fluid whose volume is held.
template <class S>
struct Pressures {
  S stored;      ///< \f$P_W\f$
  S multiplier;  ///< \f$P_\lambda\f$
  /// What the equation of motion knows of (8.12).
  S total() const {
    // [eq_8_12]
    return stored + multiplier;
    // [eq_8_12]
  }
};

/// Both pressures at a jet of the extended bundle (8.12).
///
/// \implements{eq_8_12}
/// @throws VolumeNotPositive  where the body is turned inside out
template <class BodyMetric, class SpaceMetric, class Mass, class Law, class S, int n, int M>
Pressures<S> pressures(Continuum<BodyMetric, SpaceMetric, Mass, Barotropic<Law>> const& fluid, Jet<S, n, M> const& extended) {
  auto const j = deformation(extended);
  VolumeConstraint<BodyMetric, SpaceMetric> const constraint{fluid.G, fluid.g};
  constraint.examine(j);
  S const rho = fluid.rho(j.particle());
  return {stored_pressure(fluid.W.w, rho, constraint.volume_ratio(j)), material_pressure(fluid.G, extended)};
}

/// What is left of the equation of motion of such a fluid, written with the sum of the pressures:
/// \f$\rho\,g_{ab}(D_g\dot\phi/Dt)^b + \partial_k(P_W + P_\lambda)\,J(F^{-1})^k{}_a\f$.
///
/// \implements{claim_8_3_combined_pressure_equation}
template <class BodyMetric, class SpaceMetric, class Mass, class Law, class S, int n, int M>
Eigen::Matrix<S, n, 1> two_pressures_residual(Continuum<BodyMetric, SpaceMetric, Mass, Barotropic<Law>> const& fluid, SecondJet<S, n, M> const& extended) {
  auto const j = deformation(extended);
  Eigen::Matrix<S, n, 1> slope;
  for (int k = 0; k < n; ++k) slope[k] = pressures(fluid, along(extended, k + 1)).total().part[0];
  S const rho = fluid.rho(j.particle()), J = jacobian(fluid.G(j.particle()), fluid.g(j.y), j.gradient());
  Eigen::Matrix<S, n, 1> const force = inverse_matrix(j.gradient(), "deformation gradient").transpose() * slope;
  return rho * lowered_acceleration(fluid.g, j) + force * J;
}

}  // namespace actio
