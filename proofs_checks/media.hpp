// Continuous media for the checks of chapter 6: any metrics, any mass, and a stored energy of the most
// general form, of a fluid, or of a solid.
#pragma once

#include "actio/continuum/continuum_equations.hpp"
#include "actio/jets/field_equations.hpp"
#include "fields.hpp"

namespace actio::checks {

/// Calls `visit(dimensions, name)` for bodies as large as their space, at one random point each. What follows
/// from an identity that has been checked in space is checked in the plane alone.
template <class... D, class Visit>
void over_points(std::tuple<D...> dimensions, Visit const& visit) { over_dimensions(dimensions, visit); }
using Plane = std::tuple<Dimensions<2, 2>>;

/// What the energy of a medium knows.
enum class Kind { any, fluid, solid, dust };

/// A stored energy of one of these kinds, chosen when it is drawn: one type for all of them, so that what is
/// made of a medium is compiled once. A fluid has as many dimensions as its space.
template <class S, int n, int N = n>
struct EnergyOfKind {
  Kind kind;
  AnyEnergy<S, n, N> any;
  AnyFluidLaw<S> w;  ///< of a fluid
  AnisotropicSolid<S, n> solid;
  template <class T>
  T operator()(Matrix<T, n, 1> const& x, Matrix<T, n, n> const& G, Matrix<T, N, N> const& g,
               Matrix<T, N, n> const& F) const {
    if constexpr (n == N)
      if (kind == Kind::fluid) return w(jacobian(G, g, F));
    switch (kind) {
      case Kind::any:
        return any(x, G, g, F);
      case Kind::solid:
        return solid(x, G, g, F);
      default:
        return T(0);
    }
  }
};

/// A medium on a body with metric and mass that vary, in a space with another such metric.
template <class S, int n, int N = n>
using AnyContinuum = Continuum<AnyMetric<S, n>, AnyMetric<S, N>, AnyMass<S, n>, EnergyOfKind<S, n, N>>;
template <class S, int n, int N = n>
AnyContinuum<S, n, N> draw_medium(Draw& draw, Kind kind) {
  auto const G = draw_metric<S, n>(draw);
  auto const g = draw_metric<S, N>(draw);
  auto const rho = draw_mass<S, n>(draw);
  auto const any = draw_energy<S, n, N>(draw);
  auto const fluid = draw_fluid<S>(draw);
  return {G, g, rho, {kind, any, fluid.w, draw_solid<S, n>(draw)}};
}

/// The same medium with the metrics that it has at the origin everywhere.
template <class S, int n, int N>
AnyContinuum<S, n, N> flattened(AnyContinuum<S, n, N> medium) {
  auto const flatten = [](auto& metric) {
    for (auto& slope : metric.slope) slope.setZero();
    metric.bend.setZero();
  };
  flatten(medium.G), flatten(medium.g);
  return medium;
}

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

namespace actio {
/// Those that are drawn as fluids are.
template <class S, int n>
inline constexpr bool is_barotropic<checks::EnergyOfKind<S, n, n>> = true;
}  // namespace actio
