// Continuous media for the checks of chapter 6: any metrics, any mass, and a stored energy of the most general form, of a fluid, or of a solid.
#pragma once

#include "actio/jets/continuum_equations.hpp"
#include "actio/jets/field_equations.hpp"
#include "fields.hpp"

namespace actio::checks {

/// Calls `visit(dimensions, name)` for bodies as large as their space, at three random points each: the probability that a false identity of degree 200 is zero
/// at all of them is \f$10^{-8}\f$.
template <class Visit>
void over_points(Visit const& visit) {
  for (int point = 0; point < 3; ++point) over_dimensions(PlaneAndSpace{}, visit);
}

/// A medium on a body with metric and mass that vary, in a space with another such metric.
template <class S, int n, class Energy>
using AnyContinuum = Continuum<AnyMetric<S, n>, AnyMetric<S, n>, AnyMass<S, n>, Energy>;
template <class S, int n, class Energy>
AnyContinuum<S, n, Energy> draw_continuum(Draw& draw, Energy const& W) {
  auto const G = draw_metric<S, n>(draw);
  auto const g = draw_metric<S, n>(draw);
  return {G, g, draw_mass<S, n>(draw), W};
}
template <class S, int n>
auto draw_any_medium(Draw& draw) {
  return draw_continuum<S, n>(draw, draw_energy<S, n, n>(draw));
}
template <class S, int n>
auto draw_fluid_medium(Draw& draw) {
  return draw_continuum<S, n>(draw, draw_fluid<S>(draw));
}
template <class S, int n>
auto draw_solid_medium(Draw& draw) {
  return draw_continuum<S, n>(draw, draw_solid<S>(draw));
}

/// The same with constant metrics, neither of them the identity.
template <class S, int n, class Energy>
auto draw_flat_continuum(Draw& draw, Energy const& W) {
  auto const G = draw_constant_metric<S, n>(draw);
  auto const g = draw_constant_metric<S, n>(draw);
  return Continuum<ConstantMetric<S, n>, ConstantMetric<S, n>, AnyMass<S, n>, Energy>{G, g, draw_mass<S, n>(draw), W};
}

/// The second jet of a section that solves nothing.
template <class S, int n>
SecondJet<S, n, n> draw_second_jet(Draw& draw) {
  auto const phi = draw_section<S, n, n>(draw);
  return second_jet(phi, draw_event<S, n>(draw));
}

/// What the thesis divides by: \f$\sqrt{\det G}\f$ at the particle.
template <class Medium, class S, int n, int N>
S body_volume(Medium const& medium, Jet<S, n, N> const& j) {
  return volume<S>(medium.G(j.particle()));
}

/// The values that a medium has at a jet, all as matrices.
template <class S, int n>
struct PointOfMedium {
  Eigen::Matrix<S, n, n> G, g, F, inverse;  ///< metrics, deformation gradient and its inverse
  S rho, J;
};
template <class Medium, class S, int n>
PointOfMedium<S, n> point_of_medium(Medium const& medium, Jet<S, n, n> const& j) {
  Eigen::Matrix<S, n, n> const G = as_matrix<S>(medium.G(j.particle())), g = as_matrix<S>(medium.g(j.y)), F = j.gradient();
  return {G, g, F, inverse_matrix(F), S(medium.rho(j.particle())), jacobian(G, g, F)};
}

/// The slopes \f$\partial P/\partial x^k\f$ of a fluid's material pressure along a section.
template <class Medium, class S, int n>
Eigen::Matrix<S, n, 1> pressure_slopes(Medium const& fluid, SecondJet<S, n, n> const& j) {
  Eigen::Matrix<S, n, 1> slope;
  for (int k = 0; k < n; ++k) slope[k] = material_pressure(fluid, along(j, k + 1)).part[0];
  return slope;
}

}  // namespace actio::checks
