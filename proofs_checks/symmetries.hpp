// Models of chapter 9: fluids of even and of varying mass, maps and fields that preserve the volume of a
// curved body, and jets of solutions.
#pragma once

#include "fields.hpp"

#include "actio/incompressible/incompressible_density.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/relabelling.hpp"

namespace actio::checks {

/// Calls `visit` for each of the dimensions, at one random point.
template <class Dims, class Visit>
void over_points(Dims dimensions, Visit const& visit) { over_dimensions(dimensions, visit); }
/// The plane alone, for what costs much.
using Plane = std::tuple<Dimensions<2, 2>>;

/// A polynomial that is the same everywhere.
template <class S, int m>
Cubic<S, m> constant_cubic(S const& value) {
  using V = Matrix<S, m, 1>;
  V const none = V::Zero();
  return {value, none, none, none, none};
}
/// Mass that is the same everywhere, of the type of one that varies.
template <class S, int n>
AnyMass<S, n> even_mass(S const& rho) { return {constant_cubic<S, n>(rho - S(2))}; }

template <class S, int n>
using AnyFluid = Continuum<AnyMetric<S, n>, AnyMetric<S, n>, AnyMass<S, n>, Barotropic<AnyFluidLaw<S>>>;

/// A homogeneous barotropic fluid over curved metrics that differ.
template <class S, int n>
AnyFluid<S, n> draw_homogeneous_fluid(Draw& draw) {
  auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
  return {G, g, even_mass<S, n>(ratio<S>(7, 5)), draw_fluid<S>(draw)};
}
/// The same with mass that varies, by a good part of it.
template <class S, int n>
AnyFluid<S, n> with_varying_mass(AnyFluid<S, n> fluid, Draw& draw) {
  fluid.rho.added = draw_cubic<S, n>(draw, ratio<S>(1, 2));
  return fluid;
}
/// The ideal incompressible fluid: no stored energy.
template <class S, int n>
auto ideal(AnyFluid<S, n> fluid) {
  fluid.W.w = {S(0), S(0), S(0)};
  return incompressible(fluid);
}

/// A potential of fields on the body: one component for n = 2, three for n = 3, and a common factor.
template <class S, int n>
struct AnyPotential {
  static constexpr int components = n == 2 ? 1 : 3;
  Cubic<S, n> factor;
  std::array<Cubic<S, n>, components> A;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, components, 1> value;
    T const common = factor(x);
    for (int i = 0; i < components; ++i) value[i] = common * A[i](x);
    return value;
  }
};
template <class S, int n>
AnyPotential<S, n> draw_potential(Draw& draw) {
  AnyPotential<S, n> potential{constant_cubic<S, n>(S(1)), {}};
  for (auto& A : potential.A) A = draw_cubic<S, n>(draw);
  return potential;
}
/// A field that preserves the volume of a body.
template <class S, int n>
using PotentialField = RelabellingField<AnyMetric<S, n>, AnyPotential<S, n>>;
template <class S, int n>
PotentialField<S, n> draw_relabelling(AnyMetric<S, n> const& G, Draw& draw) {
  return {G, draw_potential<S, n>(draw)};
}
/// A field that does not: the volume it preserves is that of another metric.
template <class S, int n>
PotentialField<S, n> draw_compression(Draw& draw) {
  return {draw_metric<S, n>(draw), draw_potential<S, n>(draw)};
}

/// Any field on Y that covers one on space-time.
template <class S, int n, int N>
struct AnyField {
  std::array<Cubic<S, n + 1>, n + 1> base;
  std::array<Cubic<S, n + 1 + N>, N> fibre;
  template <class V>
  auto operator()(V const& point) const {
    using T = ScalarOf<V>;
    Matrix<T, n + 1, 1> const x = point.template head<n + 1>();
    Matrix<T, n + 1 + N, 1> rate;
    for (int mu = 0; mu <= n; ++mu) rate[mu] = base[mu](x);
    for (int a = 0; a < N; ++a) rate[n + 1 + a] = fibre[a](point);
    return rate;
  }
};
template <class S, int n, int N>
AnyField<S, n, N> draw_field(Draw& draw) {
  AnyField<S, n, N> xi;
  for (auto& c : xi.base) c = draw_cubic<S, n + 1>(draw);
  for (auto& c : xi.fibre) c = draw_cubic<S, n + 1 + N>(draw);
  return xi;
}

/// The map \f$(s\,x^1 + s - 1,\ c\,x^2 + (x^1)^2/3,\ x^3 + x^1x^2/2)\f$ of the body, with determinant s c;
/// and its inverse.
template <class S, int n>
struct Stretch {
  S s, c;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> to;
    to[0] = x[0] * T(s) + T(S(s - S(1)));
    to[1] = x[1] * T(c) + x[0] * x[0] * T(ratio<S>(1, 3));
    if constexpr (n == 3) to[2] = x[2] + x[0] * x[1] * T(ratio<S>(1, 2));
    return to;
  }
  template <class V>
  auto back(V const& to) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> x;
    x[0] = (to[0] - T(S(s - S(1)))) / T(s);
    x[1] = (to[1] - x[0] * x[0] * T(ratio<S>(1, 3))) / T(c);
    if constexpr (n == 3) x[2] = to[2] - x[0] * x[1] * T(ratio<S>(1, 2));
    return x;
  }
};
/// A curved metric with \f$\sqrt{\det G} = 1 + x^1\f$, whose volume is preserved by stretches with
/// \f$s^2c = 1\f$; with `even` it is 1, and those with s c = 1 do.
template <class S, int n>
AnyMetric<S, n> draw_stretchable_metric(Draw& draw, bool even = false) {
  auto G = draw_metric<S, n>(draw);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k <= i; ++k) {
      G.constant(i, k) = G.bend(i, k) = S(0);
      for (auto& slope : G.slope) slope(i, k) = S(0);
    }
  G.constant += Matrix<S, n, n>::Identity();
  if (!even) G.slope[0](0, 0) = S(1);
  return G;
}

/// A curved metric that does not depend on the first coordinate: to shift that is an isometry.
template <class S, int n>
AnyMetric<S, n> draw_shiftable_metric(Draw& draw) {
  auto g = draw_metric<S, n>(draw);
  g.slope[0].setZero();
  g.bend.row(0).setZero();
  g.bend.col(0).setZero();
  return g;
}
/// The field of that shift.
template <int N>
struct FirstShift {
  template <class V>
  auto operator()(V const&) const {
    using T = ScalarOf<V>;
    Matrix<T, N, 1> k = Matrix<T, N, 1>::Zero();
    k[0] = T(1);
    return k;
  }
};

/// The second jet of a solution through a first jet: of the second derivatives all but the acceleration as
/// given, and the acceleration that the field equations want.
template <class Medium, class S, int n, int N>
SecondJet<S, n, N> of_a_solution(Medium const& medium, SecondJet<S, n, N> j) {
  Matrix<S, n, 1> const x = j.particle();
  S const mass = volume<S>(medium.G(x)) * medium.rho(x);
  Matrix<S, N, N> const inertia = as_matrix<S>(medium.g(j.y)) * mass;
  j.w[0].col(0) += solve_linear(inertia, euler_lagrange(medium, j), "of_a_solution");
  return j;
}

/// The second jet of a section that solves nothing.
template <class S, int n, int N>
SecondJet<S, n, N> draw_second_jet(Draw& draw) {
  auto const phi = draw_section<S, n, N>(draw);
  return second_jet(phi, draw_event<S, n>(draw));
}
template <class S, int n, int N>
Jet<S, n, N> first(SecondJet<S, n, N> const& j) { return j; }

}  // namespace actio::checks
