// The equations of motion of incompressible media, as section 8.2 to 8.4 of the thesis write them.
//
// Each function returns the residual of an equation: left side minus right side, zero along solutions.
// Arguments are second jets of the extended section (phi, lambda). Off the constraint, where J is not 1,
// (8.7) to (8.9) keep their J and (8.11) does not; the Euler-Lagrange derivative of the density is
// \f$-\sqrt{\det G}\f$ times (8.7) whatever J is.
#pragma once

#include "actio/continuum/continuum_equations.hpp"
#include "actio/incompressible/incompressible_density.hpp"

namespace actio {

/// \f$\partial P/\partial x^k\,(F^{-1})^k{}_a\f$: the derivatives in space, where the particle is,
/// of the pressure \f$p = P\circ\phi_t^{-1}\f$.
/// @throws Singular  where the deformation gradient has no inverse
template <class BodyMetric, class S, int n, int M>
Matrix<S, n, 1> spatial_pressure_gradient(BodyMetric const& G, SecondJet<S, n, M> const& j) {
  return inverse_matrix(deformation(j).gradient(), "deformation gradient").transpose() *
         pressure_gradient(G, j);
}

/// The force of the pressure on a unit of volume of the body,
/// \f$\frac{\partial P}{\partial x^k}\,(v^{-1})^k{}_a\,J\f$ of (8.7) and (8.9).
template <class BodyMetric, class SpaceMetric, class S, int n, int M>
Matrix<S, n, 1> pressure_term(BodyMetric const& G, SpaceMetric const& g, SecondJet<S, n, M> const& extended) {
  auto const j = deformation(extended);
  S const J = jacobian(G(j.particle()), g(j.y), j.gradient());
  return spatial_pressure_gradient(G, extended) * J;
}

/// \f$g_{ab}(D_g\dot\phi/Dt)^b\f$, the material acceleration with its index lowered.
template <class SpaceMetric, class S, int n>
Matrix<S, n, 1> lowered_acceleration(SpaceMetric const& g, SecondJet<S, n, n> const& j) {
  return lowered(g(j.y), material_acceleration(g, j));
}

/// The residual of the equation of motion with stored energy and pressure (8.7), a component for each a.
///
/// \implements{eq_8_7}
/// @throws Singular  where the deformation gradient has no inverse; NotOrientationPreserving where it turns
/// the body inside out Accuracy: exact but for rounding.
template <class Medium, class BodyMetric, class SpaceMetric, class S, int n, int M>
Matrix<S, n, 1> motion_residual(
    AugmentedDensity<Medium, VolumeConstraint<BodyMetric, SpaceMetric>> const& density,
    SecondJet<S, n, M> const& extended) {
  examine(density, static_cast<Jet<S, n, M> const&>(extended));
  auto const& medium = density.density;
  // [eq_8_7]
  return medium_equation(medium, deformation(extended)) + pressure_term(medium.G, medium.g, extended);
  // [eq_8_7]
}

/// The derivatives \f$\partial_kP\f$ on the body that (8.7) asks of the pressure along a motion: what holds
/// the volume, were it held.
///
/// They are those of a function where the motion is one of the medium, and of none where it is not.
/// @param density  medium and constraint; @param j  second jet of the deformation, without a multiplier
/// @throws NotOrientationPreserving  where the body is turned inside out
template <class Medium, class BodyMetric, class SpaceMetric, class S, int n>
Matrix<S, n, 1> required_pressure_gradient(
    AugmentedDensity<Medium, VolumeConstraint<BodyMetric, SpaceMetric>> const& density,
    SecondJet<S, n, n> const& j) {
  examine(density.constraint, static_cast<Jet<S, n, n> const&>(j));
  Matrix<S, n, 1> const force = medium_equation(density.density, j);
  return -(j.gradient().transpose() * force) / density.constraint.volume_ratio(j);
}

/// The residual of the equation of an ideal homogeneous fluid with the material pressure (8.9), the density
/// of mass being 1.
///
/// \implements{eq_8_9}
template <class BodyMetric, class SpaceMetric, class S, int n, int M>
Matrix<S, n, 1> ideal_fluid_residual(BodyMetric const& G, SpaceMetric const& g,
                                     SecondJet<S, n, M> const& extended) {
  // [eq_8_9]
  return lowered_acceleration(g, deformation(extended)) + pressure_term(G, g, extended);
  // [eq_8_9]
}

/// The residual of the same equation with the spatial pressure \f$p = P\circ\phi_t^{-1}\f$ (8.11):
/// \f$D_g\dot\phi/Dt + \mathrm{grad}\,p\circ\phi\f$, a vector. It supposes J = 1.
///
/// \implements{eq_8_11,eq_8_13}
template <class BodyMetric, class SpaceMetric, class S, int n, int M>
Matrix<S, n, 1> spatial_pressure_residual(BodyMetric const& G, SpaceMetric const& g,
                                          SecondJet<S, n, M> const& extended) {
  auto const j = deformation(extended);
  // [eq_8_11]
  return material_acceleration(g, j) + raised(g(j.y), spatial_pressure_gradient(G, extended));
  // [eq_8_11]
}

/// The residual of the equation of an incompressible solid in components (section 8.4); its stored energy is
/// a function of the Green tensor.
///
/// \implements{claim_8_4_elasticity_components}
template <class Medium, class BodyMetric, class SpaceMetric, class S, int n, int M>
Matrix<S, n, 1> elastic_residual(
    AugmentedDensity<Medium, VolumeConstraint<BodyMetric, SpaceMetric>> const& density,
    SecondJet<S, n, M> const& extended) {
  auto const& medium = density.density;
  auto const j = deformation(extended);
  // [claim_8_4_elasticity_components]
  return inertial_force(medium, j) - stress_divergence(medium, j) +
         pressure_term(medium.G, medium.g, extended);
  // [claim_8_4_elasticity_components]
}

/// The same as vectors, \f$\rho\,D_gV/Dt - \mathrm{DIV}\,\mathcal P + \mathrm{grad}\,p\circ\phi\f$. It
/// supposes J = 1.
///
/// \implements{claim_8_4_elasticity_covariant}
template <class Medium, class BodyMetric, class SpaceMetric, class S, int n, int M>
Matrix<S, n, 1> covariant_elastic_residual(
    AugmentedDensity<Medium, VolumeConstraint<BodyMetric, SpaceMetric>> const& density,
    SecondJet<S, n, M> const& extended) {
  auto const& medium = density.density;
  auto const j = deformation(extended);
  // [claim_8_4_elasticity_covariant]
  return solid_equation(medium, j) + raised(medium.g(j.y), spatial_pressure_gradient(medium.G, extended));
  // [claim_8_4_elasticity_covariant]
}

}  // namespace actio
