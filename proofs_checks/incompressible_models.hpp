// Models of chapter 8: media with a pressure that solve nothing, motions that preserve volume exactly, and
// metrics that they preserve it for.
//
// Compositions of shears are polynomial and have polynomial inverses, and preserve dy^1 ... dy^n. A metric
// A^T A with A unitriangular has this volume, and is curved. Together they keep J = 1 where neither the
// metric nor the motion is simple.
#pragma once

#include "fields.hpp"

#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/two_pressures.hpp"
#include "actio/jets/field_equations.hpp"

namespace actio::checks {

/// A metric with volume 1 that is neither constant nor flat: A is upper triangular with ones.
template <class S, int n>
AnyMetric<S, n> draw_unimodular_metric(Draw& draw) {
  auto g = draw_metric<S, n>(draw);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k <= i; ++k) {
      g.constant(i, k) = S(i == k ? 1 : 0);
      for (auto& slope : g.slope) slope(i, k) = S(0);
      g.bend(i, k) = S(0);
    }
  return g;
}
/// The metric of the same type that is the same everywhere.
template <class S, int n>
AnyMetric<S, n> constant_metric(AnyMetric<S, n> g) {
  for (auto& slope : g.slope) slope.setZero();
  g.bend.setZero();
  return g;
}
/// A density of mass 1 everywhere, of the same type as one that varies.
template <class S, int n>
AnyMass<S, n> unit_mass() {
  using V = Matrix<S, n, 1>;
  V const zero = V::Zero();
  return {Cubic<S, n>{S(-1), zero, zero, zero, zero}};
}
/// A stored energy that is the same everywhere, of the same type as one that is not.
template <class S, int n>
AnyEnergy<S, n, n> constant_energy(S const& value) {
  using V = Matrix<S, AnyEnergy<S, n, n>::arguments, 1>;
  V const zero = V::Zero();
  return {Cubic<S, AnyEnergy<S, n, n>::arguments>{value, zero, zero, zero, zero}};
}

template <class S, int n>
using Medium = Continuum<AnyMetric<S, n>, AnyMetric<S, n>, AnyMass<S, n>, AnyEnergy<S, n, n>>;
template <class S, int n>
using Fluid = Continuum<AnyMetric<S, n>, AnyMetric<S, n>, AnyMass<S, n>, Barotropic<AnyFluidLaw<S>>>;

/// A medium of the most general kind: metrics of body and space, mass and energy all vary.
template <class S, int n>
Medium<S, n> draw_medium(Draw& draw) {
  auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
  auto const rho = draw_mass<S, n>(draw);
  return {G, g, rho, draw_energy<S, n, n>(draw)};
}
/// An ideal homogeneous fluid: mass 1, a stored energy that is the same everywhere.
template <class S, int n>
Medium<S, n> ideal_fluid(AnyMetric<S, n> const& G, AnyMetric<S, n> const& g,
                         S const& energy = ratio<S>(2, 7)) {
  return {G, g, unit_mass<S, n>(), constant_energy<S, n>(energy)};
}
template <class S, int n>
Fluid<S, n> draw_barotropic(Draw& draw) {
  auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
  auto const rho = draw_mass<S, n>(draw);
  return {G, g, rho, draw_fluid<S>(draw)};
}

/// n shears one after the other: each adds to one coordinate a cubic in time and the others. Volume is
/// preserved, and the inverse is a polynomial too.
template <class S, int n>
struct Shears {
  std::array<Cubic<S, n + 1>, n> added;

  template <class V>
  auto operator()(V const& x) const {
    auto moved = x.eval();
    for (int a = 0; a < n; ++a) moved[a + 1] += added[a](moved);
    return moved.template tail<n>().eval();
  }
  /// The particle that is at a point of space: from (t, y) to (t, x).
  template <class V>
  auto particle(V const& y) const {
    auto moved = y.eval();
    for (int a = n - 1; a >= 0; --a) moved[a + 1] -= added[a](moved);
    return moved;
  }
};
template <class S, int n>
Shears<S, n> draw_shears(Draw& draw, S const& size = ratio<S>(1, 4)) {
  Shears<S, n> phi;
  for (int a = 0; a < n; ++a) {
    phi.added[a] = draw_cubic<S, n + 1>(draw, size);
    // What a coordinate is moved by does not depend on it.
    for (auto* vector : {&phi.added[a].a, &phi.added[a].b, &phi.added[a].d, &phi.added[a].e})
      (*vector)[a + 1] = S(0);
  }
  return phi;
}

/// The velocity \f$u = \dot\phi\circ\phi_t^{-1}\f$ in space of shears.
template <class S, int n>
struct VelocityInSpace {
  Shears<S, n> phi;
  template <class V>
  auto operator()(V const& y) const { return first_jet(phi, phi.particle(y)).velocity(); }
};

/// A field or function of time and space at the position of a particle: from (t, x) to its value at (t,
/// phi(t, x)).
template <class Field, class Phi>
struct CarriedBy {
  Field field;
  Phi phi;
  template <class V>
  auto operator()(V const& x) const {
    auto const place = phi(x).eval();
    Matrix<ScalarOf<V>, V::RowsAtCompileTime, 1> at;
    at << x[0], place;
    return field(at);
  }
};
template <class Field, class Phi>
CarriedBy(Field, Phi) -> CarriedBy<Field, Phi>;

/// A field \f$u^a = \frac{1}{\sqrt{\det g}}\,\partial_b\psi^{ab}\f$ with antisymmetric cubics \f$\psi\f$: its
/// divergence vanishes everywhere.
template <class S, int n, class Metric>
struct SolenoidalField {
  Metric g;
  std::array<Cubic<S, n + 1>, n*(n - 1) / 2> psi;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> u = Matrix<T, n, 1>::Zero();
    for (int a = 0, k = 0; a < n; ++a)
      for (int b = 0; b < a; ++b, ++k) {
        auto const slope = derivative(psi[k], Matrix<T, n + 1, 1>(y)).gradient();
        u[a] += slope[b + 1];
        u[b] -= slope[a + 1];
      }
    Matrix<T, n, 1> const place = y.template tail<n>();
    return (u / volume<T>(g(place))).eval();
  }
};
template <class S, int n, class Metric>
SolenoidalField<S, n, Metric> draw_solenoidal(Draw& draw, Metric const& g) {
  SolenoidalField<S, n, Metric> u{g, {}};
  for (auto& psi : u.psi) psi = draw_cubic<S, n + 1>(draw);
  return u;
}

/// The second jet at a random event of a deformation with a random pressure.
template <class S, int n, class Phi, class BodyMetric>
SecondJet<S, n, n + 1> draw_extended_jet(Draw& draw, Phi const& phi, BodyMetric const& G) {
  auto const P = draw_cubic<S, n + 1>(draw);
  return second_jet(with_pressure(phi, P, G), draw_event<S, n>(draw));
}

/// The Euler-Lagrange derivative by the motion, over \f$-\sqrt{\det G}\f$: what equations of motion per unit
/// of volume leave.
template <class L, class S, int n, int M>
Matrix<S, n, 1> per_volume(L const& density, SecondJet<S, n, M> const& j) {
  Matrix<S, M, 1> const E = euler_lagrange(density, j);
  return -E.template head<n>() / volume<S>(density.constraint.G(j.particle()));
}
/// The size of what an equation of motion is made of.
template <class S, int n, int M, class Metric>
S size_of_forces(Metric const& g, SecondJet<S, n, M> const& j) {
  return size_of(lowered_acceleration(g, deformation(j))) + size_of(spatial_pressure_gradient(g, j)) + S(1);
}

/// Bodies in the plane; and in space as well, where the dimension counts.
using Plane = std::tuple<Dimensions<2, 2>>;
using TwoAndThree = std::tuple<Dimensions<2, 2>, Dimensions<3, 3>>;
/// One random point in each of the dimensions.
template <class Dims, class Visit>
void over_points(Dims dims, Visit const& visit) { over_dimensions(dims, visit); }

}  // namespace actio::checks
