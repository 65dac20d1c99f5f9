// Models of chapter 9: fluids of even and of varying mass, maps and fields that preserve the volume of a
// curved body, and jets of solutions.
#pragma once

#include "fields/fields.hpp"

#include "actio/incompressible/incompressible_density.hpp"
#include "actio/jets/action.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/relabelling.hpp"

namespace actio::checks {

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
/// and its inverse. On a line \f$s\,x + s - 1\f$.
template <class S, int n>
struct Stretch {
  S s, c;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> to;
    to[0] = x[0] * T(s) + T(S(s - S(1)));
    if constexpr (n > 1) to[1] = x[1] * T(c) + x[0] * x[0] * T(ratio<S>(1, 3));
    if constexpr (n == 3) to[2] = x[2] + x[0] * x[1] * T(ratio<S>(1, 2));
    return to;
  }
  template <class V>
  auto back(V const& to) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> x;
    x[0] = (to[0] - T(S(s - S(1)))) / T(s);
    if constexpr (n > 1) x[1] = (to[1] - x[0] * x[0] * T(ratio<S>(1, 3))) / T(c);
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

/// Any first jet of a motion and a multiplier that is not small: the fluid is under pressure.
template <class S, int n>
Jet<S, n, n + 1> draw_pressed_jet(Draw& draw) {
  auto j = draw_jet<S, n, n + 1>(draw);
  j.y[n] += S(3);
  return j;
}

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

// ----
// Finite maps: relabellings at one particle, any automorphism, and what moves time or space alone.

/// A map of the body near one particle: the affine one with a given image and tangent map there. What a
/// density makes of a relabelling at a jet depends on no more of it.
template <class S, int n>
struct MapAtParticle {
  Matrix<S, n, 1> from, to;
  Matrix<S, n, n> slope;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> moved = to.template cast<T>();
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) moved[i] += (x[k] - T(from[k])) * T(slope(i, k));
    return moved;
  }
  /// The same with a tangent map of this determinant.
  MapAtParticle with_determinant(S const& wanted) const {
    MapAtParticle map = *this;
    map.slope.col(0) *= S(wanted / determinant(slope));
    return map;
  }
};
/// Any image and any tangent map near the identity.
template <class S, int n>
MapAtParticle<S, n> draw_map_at(Matrix<S, n, 1> const& x, Draw& draw) {
  MapAtParticle<S, n> map{x, draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 2), {}};
  map.slope.setIdentity();
  for (int i = 0; i < n; ++i) map.slope.col(i) += draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 4);
  return map;
}
/// Any that preserves the volume of a metric: \f$\sqrt{\det G(\eta(x))}\,\det\partial\eta = \sqrt{\det
/// G(x)}\f$.
template <class S, int n, class Metric>
MapAtParticle<S, n> draw_relabelling_at(Metric const& G, Matrix<S, n, 1> const& x, Draw& draw) {
  auto const map = draw_map_at<S, n>(x, draw);
  return map.with_determinant(S(volume<S>(G(x)) / volume<S>(G(map.to))));
}

/// The relabelling of a bundle whose last fibre coordinate is a density, as the multiplier of
/// incompressibility is: it is divided by the determinant.
template <int N, class Eta>
auto density_relabelling(Eta const& eta) {
  auto const fibre = [eta]<class T, int rows>(Matrix<T, rows, 1> const& point) {
    constexpr int n = rows - 1 - N;
    Matrix<T, N, 1> y = point.template tail<N>();
    y[N - 1] = y[N - 1] / determinant(derivative(eta, Matrix<T, n, 1>(point.template segment<n>(1))).matrix);
    return y;
  };
  return Automorphism{relabelling<N>(eta).base, fibre};
}

/// Any automorphism with an inverse: time and body are stretched and mixed, points of space go by a
/// polynomial of everything.
template <class S, int n, int N>
struct AnyAutomorphism {
  Stretch<S, n> stretch;
  Matrix<S, n, 1> drift;
  std::array<Cubic<S, n + 1 + N>, N> places;
  template <class V>
  auto base(V const& x) const {
    V to;
    to[0] = x[0] * 2;
    to.template tail<n>() = stretch(Matrix<ScalarOf<V>, n, 1>(x.template tail<n>()));
    for (int i = 0; i < n; ++i) to[1 + i] += x[0] * ScalarOf<V>(drift[i]);
    return to;
  }
  template <class V>
  auto back(V const& to) const {
    V x;
    x[0] = to[0] / 2;
    Matrix<ScalarOf<V>, n, 1> body = to.template tail<n>();
    for (int i = 0; i < n; ++i) body[i] -= x[0] * ScalarOf<V>(drift[i]);
    x.template tail<n>() = stretch.back(body);
    return x;
  }
  template <class V>
  auto fibre(V const& point) const {
    Matrix<ScalarOf<V>, N, 1> y = point.template tail<N>();
    for (int a = 0; a < N; ++a) y[a] += places[a](point);
    return y;
  }
};
template <class S, int n, int N>
AnyAutomorphism<S, n, N> draw_automorphism(Draw& draw) {
  AnyAutomorphism<S, n, N> eta{{ratio<S>(3, 2), ratio<S>(4, 5)}, draw.vector<S, Matrix<S, n, 1>>(n), {}};
  for (auto& c : eta.places) c = draw_cubic<S, n + 1 + N>(draw, ratio<S>(1, 5));
  return eta;
}
/// Its two maps as the library takes them.
template <class Any>
auto as_automorphism(Any const& any) {
  return Automorphism{[any](auto const& x) { return any.base(x); },
                      [any](auto const& point) { return any.fibre(point); }};
}

/// Galileo's boost \f$y\mapsto y + t\,b\f$.
template <int N, class S>
auto galilean_boost(Matrix<S, N, 1> const& b) {
  return Automorphism{[](auto const& x) { return x; },
                      [b](auto const& point) {
                        using T = ScalarOf<decltype(point)>;
                        Matrix<T, N, 1> y = point.template tail<N>();
                        for (int a = 0; a < N; ++a) y[a] += point[0] * T(b[a]);
                        return y;
                      }};
}

/// The map \f$u\mapsto(\eta_X(u), \eta_Y(u, \phi(u)))\f$ into Y: a section, moved and not brought back.
template <class Eta, class Phi>
auto moved_map(Eta const& eta, Phi const& phi) {
  return [eta, phi]<class T, int rows>(Matrix<T, rows, 1> const& u) {
    auto const y = phi(u).eval();
    constexpr int N = std::remove_cvref_t<decltype(y)>::RowsAtCompileTime;
    Matrix<T, rows + N, 1> point, to;
    point << u, y;
    to << eta.base(u), eta.fibre(point);
    return to;
  };
}

// ----
// Fluids whose actions are integrals of polynomials, and motions that solve their equations exactly.

/// A homogeneous fluid whose action is the integral of a polynomial: flat space, \f$w = aJ + bJ^2\f$, and a
/// body with curved metric and \f$\sqrt{\det G} = 1\f$.
template <class S, int n>
AnyFluid<S, n> draw_polynomial_fluid(Draw& draw) {
  auto fluid = draw_homogeneous_fluid<S, n>(draw);
  fluid.G = draw_stretchable_metric<S, n>(draw, true);
  fluid.g = flattened(fluid.g);
  fluid.W.w.K = S(0);
  return fluid;
}

/// The map \f$(x^1 + k\,(x^1)^2/2,\ x^2 + (x^1)^2/3,\ x^3 + x^1x^2/2)\f$ of the body, with determinant
/// \f$1 + k\,x^1\f$.
template <int n>
struct Straightening {
  int k;  ///< 1 for bodies with \f$\sqrt{\det G} = 1 + x^1\f$, 0 for those where it is 1
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> to;
    to[0] = x[0] + x[0] * x[0] * T(k) / T(2);
    to[1] = x[1] + x[0] * x[0] / T(3);
    if constexpr (n == 3) to[2] = x[2] + x[0] * x[1] / T(2);
    return to;
  }
};
/// A motion \f$(A + tB)\,\sigma(x)\f$. Where \f$\det\partial\sigma = \sqrt{\det G}\f$ and space is flat, J
/// depends on time alone: nothing pushes a homogeneous fluid, and nothing is accelerated.
template <class S, int n>
struct FreeMotion {
  Matrix<S, n, n> A, B;
  Straightening<n> sigma;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    auto const place = sigma(Matrix<T, n, 1>(x.template tail<n>()));
    Matrix<T, n, 1> y = Matrix<T, n, 1>::Zero();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < n; ++i) y[a] += (T(A(a, i)) + x[0] * T(B(a, i))) * place[i];
    return y;
  }
};
template <class S, int n>
FreeMotion<S, n> draw_free_motion(Draw& draw, int k) {
  FreeMotion<S, n> phi{Matrix<S, n, n>::Identity(), {}, {k}};
  for (int i = 0; i < n; ++i) {
    phi.A.col(i) += draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 5);
    phi.B.col(i) = draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 5);
  }
  return phi;
}
/// One that preserves the volume as well, between a body with \f$\sqrt{\det G} = \det\partial\sigma\f$ and
/// this flat space: \f$A\,(1 + tN)\,\sigma(x)\f$ with a nilpotent N.
template <class S, int n>
FreeMotion<S, n> draw_shearing_motion(AnyMetric<S, n> const& flat, Draw& draw, int k) {
  auto phi = draw_free_motion<S, n>(draw, k);
  phi.A.col(0) /= S(determinant(phi.A) * volume<S>(flat(Matrix<S, n, 1>(Matrix<S, n, 1>::Zero()))));
  Matrix<S, n, n> shear = Matrix<S, n, n>::Zero();
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) shear(i, j) = draw.number<S>();
  phi.B = phi.A * shear;
  return phi;
}

}  // namespace actio::checks
