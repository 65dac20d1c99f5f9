// Media for the checks of Part II that differ in what their stored energy knows, all of one type: of the most
// general form, of a fluid, of a fluid with entropy, of a solid without symmetry, or none at all.
#pragma once

#include "fields/fields.hpp"

namespace actio::checks {

/// What the energy of a medium knows.
enum class Kind { any, fluid, isentropic, solid, dust };

/// The law of a particle with the entropy s: \f$w(J) + s\,J^2\f$.
template <class S, class R>
struct LawWithEntropy {
  AnyFluidLaw<S> w;
  R entropy;
  template <class T>
  T operator()(T const& J) const { return T(w(J) + J * J * T(entropy)); }
};

/// A stored energy of one of these kinds, chosen when it is drawn: one type for all of them, so that what is
/// made of a medium is compiled once. A fluid has as many dimensions as its space.
template <class S, int n, int N = n>
struct EnergyOfKind {
  Kind kind;
  AnyEnergy<S, n, N> any;
  AnyFluidLaw<S> w;     ///< of a fluid
  Cubic<S, n> entropy;  ///< of its particles; the same everywhere, and 0, where the fluid has none
  AnisotropicSolid<S, n> solid;

  /// The law of a fluid's particle.
  template <class T>
  auto law_at(Matrix<T, n, 1> const& x) const { return LawWithEntropy<S, T>{w, entropy(x)}; }

  template <class T>
  T operator()(Matrix<T, n, 1> const& x, Matrix<T, n, n> const& G, Matrix<T, N, N> const& g,
               Matrix<T, N, n> const& F) const {
    if constexpr (n == N)
      if (kind == Kind::fluid || kind == Kind::isentropic) return law_at(x)(jacobian(G, g, F));
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
template <class S, int n, int N = n>
EnergyOfKind<S, n, N> draw_energy_of(Draw& draw, Kind kind) {
  auto const any = draw_energy<S, n, N>(draw);
  auto const fluid = draw_fluid<S>(draw);
  auto const entropy = draw_cubic<S, n>(draw, S(kind == Kind::isentropic ? 1 : 0));
  return {kind, any, fluid.w, entropy, draw_solid<S, n>(draw)};
}

/// A medium on a body with metric and mass that vary, in a space with another such metric.
template <class S, int n, int N = n>
using AnyContinuum = Continuum<AnyMetric<S, n>, AnyMetric<S, N>, AnyMass<S, n>, EnergyOfKind<S, n, N>>;
template <class S, int n, int N = n>
AnyContinuum<S, n, N> draw_medium(Draw& draw, Kind kind) {
  auto const G = draw_metric<S, n>(draw);
  auto const g = draw_metric<S, N>(draw);
  auto const rho = draw_mass<S, n>(draw);
  return {G, g, rho, draw_energy_of<S, n, N>(draw, kind)};
}

/// The same medium with the metrics that it has at the origin everywhere.
template <class S, int n, int N>
AnyContinuum<S, n, N> flattened(AnyContinuum<S, n, N> medium) {
  medium.G = flattened(medium.G);
  medium.g = flattened(medium.g);
  return medium;
}

}  // namespace actio::checks

namespace actio {
/// Those that are drawn as fluids are.
template <class S, int n>
inline constexpr bool is_barotropic<checks::EnergyOfKind<S, n, n>> = true;
}  // namespace actio
