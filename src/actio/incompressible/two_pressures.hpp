// Two pressures: of a stored energy that depends on the volume, and of the multiplier that holds the volume
// (section 8.3 of the thesis).
#pragma once

#include "actio/incompressible/incompressible_equations.hpp"

namespace actio {

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
/// @throws NotOrientationPreserving  where the body is turned inside out
template <FluidMedium Medium, class S, int n, int M>
Pressures<S> pressures(Medium const& fluid, Jet<S, n, M> const& extended) {
  return {material_pressure(fluid, deformation(extended)), multiplier_pressure(fluid.G, extended)};
}

/// The residual of the equation of motion of such a fluid, written with the sum of the pressures:
/// \f$\rho\,g_{ab}(D_g\dot\phi/Dt)^b + \partial_k(P_W + P_\lambda)\,J(F^{-1})^k{}_a\f$.
///
/// \implements{claim_8_3_combined_pressure_equation}
template <FluidMedium Medium, class S, int n, int M>
Matrix<S, n, 1> two_pressures_residual(Medium const& fluid, SecondJet<S, n, M> const& extended) {
  auto const j = deformation(extended);
  Matrix<S, n, 1> dP;
  for (int k = 0; k < n; ++k)
    dP[k] = total_derivative(
        k + 1, [&](auto const& jet) { return pressures(fluid, jet).total(); }, extended);
  return inertial_force(fluid, j) +
         area_transformation(fluid.G(j.particle()), fluid.g(j.y), j.gradient()) * dP;
}

}  // namespace actio
