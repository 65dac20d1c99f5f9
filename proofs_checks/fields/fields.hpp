// Models of Part II that can tell right from wrong: metrics that are neither constant nor diagonal nor
// conformal, and different on body and space; mass that varies; sections that solve nothing; densities that
// depend on everything they may.
//
// All of them are polynomials with random coefficients, so what needs no root runs over the rationals, where
// a residual is exactly zero. Metrics are A^T A, with rational volumes. Each is a callable over any scalar
// that extends S.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "actio/continuum/materials.hpp"
#include "claim.hpp"

namespace actio::checks {

/// The scalar of a column of numbers.
template <class V>
using ScalarOf = typename std::remove_cvref_t<V>::Scalar;

/// c + a.x + (b.x)(d.x) + (e.x)^3, a cubic polynomial in m variables.
template <class S, int m>
struct Cubic {
  S constant;
  Matrix<S, m, 1> a, b, d, e;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    auto const linear = [&](Matrix<S, m, 1> const& c) {
      T sum(0);
      for (int i = 0; i < m; ++i) sum += x[i] * T(c[i]);
      return sum;
    };
    T const cube = linear(e);
    return T(T(constant) + linear(a) + linear(b) * linear(d) + cube * cube * cube);
  }
};
template <class S, int m>
Cubic<S, m> draw_cubic(Draw& draw, S const& size = S(1)) {
  using V = Matrix<S, m, 1>;
  auto const vector = [&] { return V(draw.vector<S, V>(m) * size); };
  S const constant = draw.number<S>() * size;
  auto const a = vector();
  auto const b = vector();
  auto const d = vector();
  auto const e = vector();
  return {constant, a, b, d, e};
}

/// A section that solves nothing: the first coordinates of the body where space has as many, and a cubic of
/// size `size` added to each.
template <class S, int n, int N>
struct AnySection {
  std::array<Cubic<S, n + 1>, N> added;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, N, 1> y;
    for (int a = 0; a < N; ++a) y[a] = a < n ? T(x[a + 1] + added[a](x)) : added[a](x);
    return y;
  }
};
template <class S, int n, int N>
AnySection<S, n, N> draw_section(Draw& draw, S const& size = ratio<S>(1, 5)) {
  AnySection<S, n, N> phi;
  for (auto& c : phi.added) c = draw_cubic<S, n + 1>(draw, size);
  return phi;
}

/// A point of space-time within 1/2 of the origin: there the Jacobian of a drawn section is positive.
template <class S, int n>
Event<S, n> draw_event(Draw& draw) { return draw.vector<S, Event<S, n>>(n + 1) * ratio<S>(1, 2); }

/// A metric A(y)^T A(y) with \f$A = 1 + \text{small}(y)\f$ of second degree: neither constant nor diagonal
/// nor conformal.
template <class S, int n>
struct AnyMetric {
  Matrix<S, n, n> constant;
  std::array<Matrix<S, n, n>, n> slope;
  Matrix<S, n, n> bend;

  template <class V>
  auto frame(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, n, n> A;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        A(i, k) = T(constant(i, k)) + y[i] * y[k] * T(bend(i, k));
        for (int c = 0; c < n; ++c) A(i, k) += y[c] * T(slope[c](i, k));
      }
    return A;
  }
  template <class V>
  auto operator()(V const& y) const {
    auto const A = frame(y);
    return (A.transpose() * A).eval();
  }
};
template <class S, int n>
AnyMetric<S, n> draw_metric(Draw& draw) {
  using M = Matrix<S, n, n>;
  auto const matrix = [&](S const& size) {
    M m;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) m(i, k) = draw.number<S>() * size;
    return m;
  };
  AnyMetric<S, n> g;
  g.constant = M::Identity() + matrix(ratio<S>(1, 5));
  for (auto& s : g.slope) s = matrix(ratio<S>(1, 4));
  g.bend = matrix(ratio<S>(1, 4));
  return g;
}

/// The same metric everywhere: that at the origin.
template <class S, int n>
AnyMetric<S, n> flattened(AnyMetric<S, n> metric) {
  for (auto& slope : metric.slope) slope.setZero();
  metric.bend.setZero();
  return metric;
}
/// A constant metric that is not the identity.
template <class S, int n>
ConstantMetric<S, n> draw_constant_metric(Draw& draw) {
  Matrix<S, n, 1> const origin = Matrix<S, n, 1>::Zero();
  return {draw_metric<S, n>(draw)(origin)};
}

/// Mass that varies over the body: 2 + a cubic.
template <class S, int n>
struct AnyMass {
  Cubic<S, n> added;
  template <class V>
  auto operator()(V const& x) const { return ScalarOf<V>(added(x) + 2); }
};
template <class S, int n>
AnyMass<S, n> draw_mass(Draw& draw) { return {draw_cubic<S, n>(draw, ratio<S>(1, 4))}; }

/// A law of a barotropic fluid: \f$w(J) = K/J + a\,J + b\,J^2\f$.
template <class S>
struct AnyFluidLaw {
  S K, a, b;
  template <class T>
  T operator()(T const& J) const { return T(T(K) / J + J * T(a) + J * J * T(b)); }
};
template <class S>
Barotropic<AnyFluidLaw<S>> draw_fluid(Draw& draw) {
  S const K = draw.number<S>() + S(2), a = draw.number<S>(), b = draw.number<S>();
  return {{K, a, b}};
}

/// A law of an isotropic solid: a cubic in the traces of \f$G^{-1}C\f$ and of its square.
template <class S>
struct AnySolidLaw {
  Cubic<S, 2> w;
  template <class T, int n>
  T operator()(Matrix<T, n, n> const& C) const {
    Matrix<T, 2, 1> invariants = Matrix<T, 2, 1>::Zero();
    for (int i = 0; i < n; ++i) {
      invariants[0] += C(i, i);
      for (int k = 0; k < n; ++k) invariants[1] += C(i, k) * C(k, i);
    }
    return w(invariants);
  }
};
template <class S>
OfGreenTensor<AnySolidLaw<S>> draw_solid(Draw& draw) { return {{draw_cubic<S, 2>(draw, ratio<S>(1, 2))}}; }

/// The energy W(x, G, C) of a solid without any symmetry: a cubic in the point of the body and in the entries
/// of its metric and of the Green tensor. Equal directions of the body are not equal to it.
template <class S, int n>
struct AnisotropicSolid {
  static constexpr int entries = n * (n + 1) / 2, arguments = n + 2 * entries;
  Cubic<S, arguments> w;
  template <class BodyMetric, class SpaceMetric, class T, int N>
  T operator()(Matrix<T, n, 1> const& x, BodyMetric const& G, SpaceMetric const& g,
               Matrix<T, N, n> const& F) const {
    Matrix<T, n, n> const body = as_matrix<T>(G), C = green_tensor(g, F);
    Matrix<T, arguments, 1> all;
    int k = 0;
    for (int i = 0; i < n; ++i) all[k++] = x[i];
    for (auto const* m : {&body, &C})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) all[k++] = (*m)(i, j);
    return w(all);
  }
};
/// `draw_solid<S>` is isotropic, `draw_solid<S, n>` has no symmetry.
template <class S, int n>
AnisotropicSolid<S, n> draw_solid(Draw& draw) {
  return {draw_cubic<S, AnisotropicSolid<S, n>::arguments>(draw, ratio<S>(1, 2))};
}

/// A stored energy W(x, G, g, F) of the most general form: it depends on the metrics other than through the
/// Green tensor or the Jacobian, and the point of the body.
template <class S, int n, int N>
struct AnyEnergy {
  static constexpr int arguments = n + n * n + N * N + N * n;
  Cubic<S, arguments> w;
  template <class BodyMetric, class SpaceMetric, class T>
  T operator()(Matrix<T, n, 1> const& x, BodyMetric const& G, SpaceMetric const& g,
               Matrix<T, N, n> const& F) const {
    Matrix<T, n, n> const body = as_matrix<T>(G);
    Matrix<T, N, N> const space = as_matrix<T>(g);
    Matrix<T, arguments, 1> all;
    int k = 0;
    for (int i = 0; i < n; ++i) all[k++] = x[i];
    for (int i = 0; i < n * n; ++i) all[k++] = body(i / n, i % n);
    for (int i = 0; i < N * N; ++i) all[k++] = space(i / N, i % N);
    for (int i = 0; i < N * n; ++i) all[k++] = F(i / n, i % n);
    return w(all);
  }
};
template <class S, int n, int N>
AnyEnergy<S, n, N> draw_energy(Draw& draw) {
  return {draw_cubic<S, AnyEnergy<S, n, N>::arguments>(draw, ratio<S>(1, 2))};
}

/// A density of the most general form: a cubic in all coordinates of the jet bundle, with a product of
/// velocity and place that no medium has.
template <class S, int n, int N>
struct AnyDensity {
  Cubic<S, Jet<S, n, N>::dimension> l, m;
  template <class T>
  T operator()(Jet<T, n, N> const& j) const {
    auto const c = coordinates(j);
    return l(c) + m(c) * (j.v(0, 0) * j.v(N - 1, n) + j.y[0]);
  }
};
template <class S, int n, int N>
AnyDensity<S, n, N> draw_density(Draw& draw) {
  auto const l = draw_cubic<S, Jet<S, n, N>::dimension>(draw, ratio<S>(1, 2));
  return {l, draw_cubic<S, Jet<S, n, N>::dimension>(draw, ratio<S>(1, 2))};
}

/// Any first jet near that of the identity, at a point near the origin.
template <class S, int n, int N>
Jet<S, n, N> draw_jet(Draw& draw) {
  Event<S, n> const x = draw_event<S, n>(draw);
  return first_jet(draw_section<S, n, N>(draw), x);
}

/// k random vectors with D components, as columns.
template <class S, int D, int k>
Tangents<S, D, k> draw_tangents(Draw& draw) {
  Tangents<S, D, k> V;
  for (int c = 0; c < k; ++c) V.col(c) = draw.vector<S, Matrix<S, D, 1>>(D);
  return V;
}

/// Dimensions (n, N) of body and space, as a type.
template <int n_, int N_>
struct Dimensions {
  static constexpr int n = n_, N = N_;
  static std::string name() { return "n = " + std::to_string(n) + ", N = " + std::to_string(N); }
};

/// Calls `visit(dimensions, name)` for each of the dimensions.
template <class... D, class Visit>
void over_dimensions(std::tuple<D...>, Visit const& visit) { (visit(D{}, D::name()), ...); }
/// Calls `visit(dimensions, name)` at one random point each. In a prime field, where a check is called often,
/// all of them come in the first call and then one at a time, in turn. Bodies of three dimensions are left
/// out where numbers grow: the prime field and the digits have them.
template <class S, class... D, class Visit>
void over_points(Claim<S> const& claim, std::tuple<D...>, Visit const& visit) {
  bool const in_turn = claim.pass > 0 && exact_arithmetic<S>() && !numbers_grow();
  int k = 0;
  auto const at = [&]<class One>(One one) {
    bool const now = !in_turn || claim.pass % int(sizeof...(D)) == k;
    ++k;
    if (now && (One::n < 3 || !numbers_grow())) visit(one, One::name());
  };
  (at(D{}), ...);
}
/// The plane alone, for what costs much.
using Plane = std::tuple<Dimensions<2, 2>>;
/// Bodies as large as their space, for what needs a Jacobian.
using PlaneAndSpace = std::tuple<Dimensions<2, 2>, Dimensions<3, 3>>;
/// Bodies as large as their space and thinner ones, a rod and a shell, for what needs no inverse of F.
using BodiesInSpace = std::tuple<Dimensions<1, 3>, Dimensions<2, 3>, Dimensions<3, 3>>;

}  // namespace actio::checks
