// Continuous media for the checks of chapter 6: any metrics, any mass, and a stored energy of the most
// general form, of a fluid, or of a solid.
#pragma once

#include "actio/continuum/continuum_equations.hpp"
#include "actio/jets/field_equations.hpp"
#include "fields/stored_energies.hpp"

namespace actio::checks {

/// The second jet of a section that solves nothing.
template <class S, int n, int N = n>
SecondJet<S, n, N> draw_second_jet(Draw& draw) {
  auto const phi = draw_section<S, n, N>(draw);
  return second_jet(phi, draw_event<S, n>(draw));
}

/// What the thesis divides by: \f$\sqrt{\det G}\f$ at the particle.
template <class Medium, class S, int n, int N>
S body_volume(Medium const& medium, Jet<S, n, N> const& j) { return volume<S>(medium.G(j.particle())); }

/// The values that a medium has at a jet, all as matrices; for bodies as large as their space.
template <class S, int n>
struct PointOfMedium {
  Matrix<S, n, n> G, g, F, inverse;  ///< metrics, deformation gradient and its inverse
  S rho, J;
};
template <class Medium, class S, int n>
PointOfMedium<S, n> point_of_medium(Medium const& medium, Jet<S, n, n> const& j) {
  Matrix<S, n, n> const G = as_matrix<S>(medium.G(j.particle())), g = as_matrix<S>(medium.g(j.y)),
                        F = j.gradient();
  return {G, g, F, inverse_matrix(F), S(medium.rho(j.particle())), jacobian(G, g, F)};
}

/// The slopes \f$\partial P/\partial x^k\f$ of a fluid's material pressure along a section.
template <class Medium, class S, int n>
Matrix<S, n, 1> pressure_slopes(Medium const& fluid, SecondJet<S, n, n> const& j) {
  Matrix<S, n, 1> slope;
  for (int k = 0; k < n; ++k) slope[k] = material_pressure(fluid, along(j, k + 1)).part[0];
  return slope;
}

}  // namespace actio::checks
