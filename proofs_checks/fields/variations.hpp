// Variations of sections and what they are tried on: fields on Y that move space-time too, densities whose
// action is integrated exactly, and solutions.
#pragma once

#include "fields/fields.hpp"

#include "actio/forms/wedge.hpp"
#include "actio/jets/cartan.hpp"
#include "actio/jets/prolongation.hpp"
#include "actio/jets/tilted_section.hpp"

namespace actio::checks {

/// Few coordinates in all, for what differentiates many times.
using SmallDimensions = std::tuple<Dimensions<1, 2>, Dimensions<2, 1>>;

/// A polynomial without its terms above a degree.
template <class S, int m>
Cubic<S, m> cut(Cubic<S, m> c, int degree) {
  if (degree < 3) c.e.setZero();
  if (degree < 2) c.d.setZero();
  return c;
}

/// The polynomial that is zero.
template <class S, int m>
Cubic<S, m> no_polynomial() {
  using V = Matrix<S, m, 1>;
  return {S(0), V::Zero(), V::Zero(), V::Zero(), V::Zero()};
}

/// A section of second degree at most; of first degree it is a state of uniform strain.
template <class S, int n, int N>
AnySection<S, n, N> draw_section_of_degree(Draw& draw, int degree, S const& size = ratio<S>(1, 5)) {
  auto phi = draw_section<S, n, N>(draw, size);
  for (auto& c : phi.added) c = cut(c, degree);
  return phi;
}

/// A density of third degree in the coordinates of the jet bundle: its action on a box is integrated exactly
/// with few nodes.
template <class S, int n, int N>
AnyDensity<S, n, N> draw_low_density(Draw& draw) {
  auto L = draw_density<S, n, N>(draw);
  return {cut(L.l, 2), cut(L.m, 1)};
}

/// Where \f$v^a{}_\mu\f$ stands among the coordinates of a jet.
template <int n, int N>
constexpr int place_of_derivative(int a, int mu) { return n + 1 + N + N * mu + a; }

/// A density whose second derivatives in the velocities have an inverse: the product of the first velocity
/// and the last, four times, and what is small beside it.
template <class S, int n, int N>
AnyDensity<S, n, N> draw_regular_density(Draw& draw) {
  static_assert(N <= 2);
  auto L = draw_density<S, n, N>(draw);
  L.l.b[place_of_derivative<n, N>(0, 0)] += S(2);
  L.l.d[place_of_derivative<n, N>(N - 1, 0)] += S(2);
  return L;
}

/// The density of a medium that is the same everywhere: a cubic in the derivatives alone. Every section of
/// first degree solves its field equations, and the linearised ones then have constant coefficients.
template <class S, int n, int N>
AnyDensity<S, n, N> draw_uniform_density(Draw& draw) {
  auto L = draw_regular_density<S, n, N>(draw);
  for (auto* c : {&L.l.a, &L.l.b, &L.l.d, &L.l.e}) c->template head<n + 1 + N>().setZero();
  L.m = no_polynomial<S, Jet<S, n, N>::dimension>();
  return L;
}

/// A density with a force that is the same everywhere added to its field equations.
template <class S, int n, int N>
AnyDensity<S, n, N> with_force(AnyDensity<S, n, N> L, Matrix<S, N, 1> const& force) {
  L.l.a.template segment<N>(n + 1) += force;
  return L;
}

/// A vector field on Y that covers one on space-time: \f$V^\mu(x)\f$ and \f$V^a(x, y)\f$.
template <class S, int n, int N>
struct AnyVariation {
  std::array<Cubic<S, n + 1>, n + 1> horizontal;
  std::array<Cubic<S, n + 1 + N>, N> vertical;
  template <class V>
  auto operator()(V const& point) const {
    using T = ScalarOf<V>;
    Matrix<T, n + 1, 1> const x = point.template head<n + 1>();
    Variation<T, n, N> rate;
    for (int mu = 0; mu <= n; ++mu) rate[mu] = horizontal[mu](x);
    for (int a = 0; a < N; ++a) rate[n + 1 + a] = vertical[a](point);
    return rate;
  }
  /// The same field, its part along space-time left out.
  AnyVariation upright() const {
    AnyVariation V = *this;
    for (auto& c : V.horizontal) c = no_polynomial<S, n + 1>();
    return V;
  }
  /// The i-th coordinate field times \f$c + s\,x^\mu\f$.
  static AnyVariation coordinate(int i, S const& constant, S const& slope = S(0), int mu = 0) {
    AnyVariation V;
    for (auto& c : V.horizontal) c = no_polynomial<S, n + 1>();
    for (auto& c : V.vertical) c = no_polynomial<S, n + 1 + N>();
    if (i <= n)
      V.horizontal[i].constant = constant, V.horizontal[i].a[mu] = slope;
    else
      V.vertical[i - n - 1].constant = constant, V.vertical[i - n - 1].a[mu] = slope;
    return V;
  }
};
template <class S, int n, int N>
AnyVariation<S, n, N> draw_variation(Draw& draw, int degree) {
  AnyVariation<S, n, N> V;
  for (auto& c : V.horizontal) c = cut(draw_cubic<S, n + 1>(draw), degree);
  for (auto& c : V.vertical) c = cut(draw_cubic<S, n + 1 + N>(draw), degree);
  return V;
}

/// A vector field that is the same everywhere.
template <class S, int D>
struct ConstantField {
  Matrix<S, D, 1> value;
  template <class V>
  Matrix<ScalarOf<V>, D, 1> operator()(V const&) const { return value.template cast<ScalarOf<V>>(); }
};

/// The point of Y over x in which a section meets its fibre.
template <class Phi, class S, int rows>
auto graph(Phi const& phi, Matrix<S, rows, 1> const& x) { return point_of(first_jet(phi, x)); }

/// The components \f$B^\mu\f$ of an n-form \f$B^\mu\,d^nx_\mu\f$ on space-time.
template <class S, int rows, class Form>
Matrix<S, rows, 1> components_of(Form const& alpha, Matrix<S, rows, 1> const& x) {
  Matrix<S, rows, 1> B;
  for (int mu = 0; mu < rows; ++mu) {
    Tangents<S, rows, rows - 1> sides = Tangents<S, rows, rows - 1>::Zero();
    for (int nu = 0, k = 0; nu < rows; ++nu)
      if (nu != mu) sides(nu, k++) = S(1);
    B[mu] = alpha(x, sides);
    if (mu % 2 == 1) B[mu] = -B[mu];
  }
  return B;
}

/// The coefficient of an (n+1)-form on space-time.
template <class S, int rows, class Form>
S coefficient_of(Form const& alpha, Matrix<S, rows, 1> const& x) {
  Tangents<S, rows, rows> const all = Tangents<S, rows, rows>::Identity();
  return alpha(x, all);
}

/// \f$p_a{}^\mu\,dy^a\wedge d^nx_\mu + \Pi\,d^{n+1}x\f$ by exterior products, on coordinates of jets.
template <int n, int N, class S, int D>
S by_exterior_products(Matrix<S, N, n + 1> const& p, S const& Pi, Matrix<S, D, 1> const& at,
                       Tangents<S, D, n + 1> const& V) {
  S sum = Pi * determinant(Matrix<S, n + 1, n + 1>(V.template topRows<n + 1>()));
  for (int mu = 0; mu <= n; ++mu) {
    auto const below = [mu]<class T, int E>(Matrix<T, E, 1> const&, Tangents<T, E, n> const& U) -> T {
      Matrix<T, n + 1, n + 1> all = Matrix<T, n + 1, n + 1>::Zero();
      all(mu, 0) = T(1);
      all.template rightCols<n>() = U.template topRows<n + 1>();
      return determinant(all);
    };
    for (int a = 0; a < N; ++a) sum += p(a, mu) * wedge(differential_of_coordinate(n + 1 + a), below)(at, V);
  }
  return sum;
}

/// A box about the origin, its sides not alike.
template <class S, int n>
Box<S, n> draw_box(Draw& draw) {
  Box<S, n> box;
  for (int mu = 0; mu <= n; ++mu) {
    box.low[mu] = ratio<S>(-1, 2) + draw.number<S>() * ratio<S>(1, 5);
    box.high[mu] = ratio<S>(1, 2) + draw.number<S>() * ratio<S>(1, 5);
  }
  return box;
}

/// A vertical variation of second degree in x with \f$\tfrac12k\,(t - t_0)^2\f$ added.
template <class S, int n, int N>
struct Accelerated {
  AnySection<S, n, N> V;
  Matrix<S, N, 1> k;
  S start;
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    Matrix<T, N, 1> y = V(x);
    T const time = x[0] - T(start);
    for (int a = 0; a < N; ++a) y[a] += time * time * T(S(k[a] / S(2)));
    return y;
  }
};

template <class S, int n, int N>
Accelerated<S, n, N> not_accelerated(AnySection<S, n, N> const& V) {
  return {V, Matrix<S, N, 1>::Zero(), S(0)};
}

/// A variation that solves the linearised field equations at a point: the second time derivatives are solved
/// for.
template <class S, int n, int N, class L>
Accelerated<S, n, N> first_variation_at(L const& density, SecondJet<S, n, N> const& j,
                                        Accelerated<S, n, N> const& V) {
  Matrix<S, N, N> mass;
  for (int b = 0; b < N; ++b) {
    SecondJet<S, n, N> unit{};
    unit.y.setZero(), unit.v.setZero();
    for (auto& m : unit.w) m.setZero();
    unit.w[0](b, 0) = S(1);
    mass.col(b) = -linearised_euler_lagrange(density, j, unit);
  }
  auto const excess = linearised_euler_lagrange(density, j, second_jet(V, j.x));
  return {V.V, solve_linear(mass, excess, "first_variation_at"), j.x[0]};
}

}  // namespace actio::checks
