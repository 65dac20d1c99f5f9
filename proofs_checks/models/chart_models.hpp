// Models for the checks of natural charts: groups whose exponential every scalar can take, base points,
// moving configurations.
#pragma once

#include "actio/reduction/natural_chart.hpp"
#include "models/models.hpp"

namespace actio::checks {

template <class S>
using GroupElement = Element<SpannedGroup, S>;
template <class S>
using Algebra = Velocity<SpannedGroup, S>;

/// Upper triangular matrices with ones on the diagonal: \f$\mathrm{ad}^{n-1} = 0\f$, and no lower power.
inline SpannedGroup unitriangular(int n) {
  std::vector<SpannedGroup::WholeMatrix> basis;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      basis.push_back(SpannedGroup::WholeMatrix::Zero(n, n));
      basis.back()(i, j) = 1;
    }
  return SpannedGroup("UT(" + std::to_string(n) + ")", std::move(basis));
}
/// The group of third-order jets at 0 of curves in G through the identity: \f$1 + tA + t^2B + t^3C\f$ with
/// \f$t^4 = 0\f$, as block matrices.
///
/// It is unipotent, so everything is polynomial; and it has the bracket of G in it, so that an identity that
/// holds on it holds on G as a power series up to the third order.
inline SpannedGroup third_jets(SpannedGroup const& group) {
  int const n = group.matrix_size();
  std::vector<SpannedGroup::WholeMatrix> basis;
  for (int k = 1; k <= 3; ++k)
    for (int a = 0; a < group.dimension(); ++a) {
      SpannedGroup::WholeMatrix const e = group.hat(Vector<int>(Vector<int>::Unit(group.dimension(), a)));
      basis.push_back(SpannedGroup::WholeMatrix::Zero(4 * n, 4 * n));
      for (int i = 0; i + k < 4; ++i) basis.back().block(n * i, n * (i + k), n, n) = e;
    }
  return SpannedGroup("jets in " + group.name(), std::move(basis));
}

/// The group of fifth-order jets at 0 of curves in Aff(1), wherever they begin: \f$\sum_k t^kA_k\f$ with
/// \f$t^6 = 0\f$, as block matrices.
///
/// Configurations are any of them, and Ad of where they begin is that of Aff(1), which is not unimodular.
/// What is put into exp and log begins at the identity: there both are polynomials, ad is seen up to its
/// fifth power, and an identity that holds on it holds on Aff(1) as a power series in the parameter.
inline SpannedGroup const& formal_group() {
  static SpannedGroup const group = [] {
    constexpr int order = 5;
    auto const of = spanned("Aff(1)", Aff1{});
    int const n = of.matrix_size();
    std::vector<SpannedGroup::WholeMatrix> basis;
    for (int k = 0; k <= order; ++k)
      for (int a = 0; a < of.dimension(); ++a) {
        SpannedGroup::WholeMatrix const e = of.hat(Vector<int>(Vector<int>::Unit(of.dimension(), a)));
        basis.push_back(SpannedGroup::WholeMatrix::Zero((order + 1) * n, (order + 1) * n));
        for (int i = 0; i + k <= order; ++i) basis.back().block(n * i, n * (i + k), n, n) = e;
      }
    return SpannedGroup("series in Aff(1)", std::move(basis));
  }();
  return group;
}
/// How many directions of the algebra are not nilpotent: the first of the formal group.
inline int directions_of_start(SpannedGroup const& group) {
  return group.name() == formal_group().name() ? 2 : 0;
}
/// Over the rationals, where exp is a polynomial; over the other scalars the usual groups, with one of those
/// beside them.
template <class S>
std::vector<SpannedGroup> const& chart_groups() {
  static std::vector<SpannedGroup> const unipotent = {unitriangular(4), unitriangular(5),
                                                      third_jets(spanned("Aff(1)", Aff1{}))};
  static std::vector<SpannedGroup> const usual = {spanned("SO(3)", SO<3>{}), spanned("SE(3)", SE<3>{}),
                                                  spanned("Aff(1)", Aff1{}), spanned("SL(2)", SL2{}),
                                                  spanned("GL(2)", GL<2>{}), unitriangular(4)};
  return exact_arithmetic<S>() ? unipotent : usual;
}
/// The groups of \ref chart_groups; over the rationals and prime fields UT(5) and the formal group.
template <class S>
std::vector<SpannedGroup> const& series_groups() {
  static std::vector<SpannedGroup> const exact = {unitriangular(5), formal_group()};
  return exact_arithmetic<S>() ? exact : chart_groups<S>();
}
/// A velocity of which every scalar can take the exponential.
template <class S>
Algebra<S> draw_exponent(Draw& draw, SpannedGroup const& group, S const& size = S(1)) {
  auto v = draw.template velocity<S>(group, size);
  v.coordinates.head(directions_of_start(group)).setZero();
  return v;
}
/// An element of a size such that products of three stay inside the chart; over the rationals the chart has
/// no end.
template <class S>
GroupElement<S> draw_small(Draw& draw, SpannedGroup const& group) {
  return retract(draw_exponent<S>(draw, group, exact_arithmetic<S>() ? S(1) : ratio<S>(2, 5)));
}
/// A configuration that has a logarithm, where not all have one.
template <class S>
GroupElement<S> draw_with_logarithm(Draw& draw, SpannedGroup const& group) {
  return directions_of_start(group) > 0 ? draw_small<S>(draw, group) : draw.template element<S>(group);
}
/// A configuration not far from g.
template <class S>
GroupElement<S> draw_near(Draw& draw, GroupElement<S> const& g) { return draw_small<S>(draw, g.group) * g; }

/// An arbitrary base point that is equivariant under right translations: c g2. It is on no geodesic from g1
/// to g2.
template <class S>
auto beside_right(GroupElement<S> c) { return [c](auto const&, auto const& g2) { return like(g2, c) * g2; }; }
/// An arbitrary base point that is equivariant under left translations: g2 c.
template <class S>
auto beside_left(GroupElement<S> c) { return [c](auto const&, auto const& g2) { return g2 * like(g2, c); }; }
/// A base point that stays where it is, wherever the configurations are.
template <class S>
auto staying_at(GroupElement<S> c) { return [c](auto const&, auto const& g2) { return like(g2, c); }; }

/// A step that is neither 1 nor a power of 2: a factor of it that is lost shows.
template <class S>
S step_length() { return ratio<S>(3, 7); }
/// Steps of a fit in double: errors stay far above rounding.
inline std::vector<double> const& halving_steps() {
  static std::vector<double> const steps = {1.0 / 64,  1.0 / 128,  1.0 / 256,
                                            1.0 / 512, 1.0 / 1024, 1.0 / 2048};
  return steps;
}
/// The groups of the fits.
inline std::vector<SpannedGroup> const& order_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SE(3)", SE<3>{}), spanned("Aff(1)", Aff1{}),
                                                   spanned("SL(2)", SL2{})};
  return groups;
}
/// A curve that is no one-parameter group: \f$e^{ta}e^{t^2b}e^{t^3c}g_0\f$.
template <class S>
struct Curve {
  Algebra<S> a, b, c;
  GroupElement<S> g0;
  template <class T>
  GroupElement<T> operator()(T const& t) const {
    return exp(t * over<T>(a)) * exp(t * t * over<T>(b)) * exp(t * t * t * over<T>(c)) * over<T>(g0);
  }
};
template <class S>
Curve<S> draw_curve(Draw& draw, SpannedGroup const& group) {
  auto const velocity = [&] { return draw.velocity<S>(group, S(1)); };
  auto const a = velocity(), b = velocity(), c = velocity();
  return {a, b, c, draw.element<S>(group, ratio<S>(1, 2))};
}
/// Size of the terms that l is made of at \f$\xi\f$.
template <class S>
Base<S> size_of_terms(AlgebraPolynomial<S> const& l, Algebra<S> const& xi) {
  Base<S> const x = size_of(xi), along = magnitude(l.c) * x;
  return magnitude(l.a) * x * x + magnitude(l.b) * x + magnitude(l.kappa) * along * along * along;
}

/// Size of the terms that a Lagrangian on TG is made of at a configuration, for velocities of this size.
template <class S>
Base<S> size_of_terms(StatePolynomial<S> const& l, GroupElement<S> const& q, Base<S> const& velocity) {
  Base<S> const along = magnitude(l.kinetic.c) * velocity, well = magnitude(l.w) * size_of(q);
  return magnitude(l.kinetic.a) * velocity * velocity + magnitude(l.kinetic.b) * velocity +
         magnitude(l.kinetic.kappa) * along * along * along +
         magnitude(l.u) * size_of(q) * magnitude(l.v) * velocity + well * well;
}

/// The number t that moves at unit rate.
template <class S>
Dual<S> moving(S const& t) {
  Dual<S> d(t);
  d.part[0] = S(1);
  return d;
}
/// \f$\eta + \epsilon\,\zeta\f$.
template <class S>
Algebra<Dual<S>> moving(Algebra<S> const& eta, Algebra<S> const& zeta) {
  auto along = over<Dual<S>>(eta);
  for (int a = 0; a < eta.group.dimension(); ++a) along.coordinates[a].part[0] = zeta.coordinates[a];
  return along;
}
/// \f$e^{\epsilon\xi}\f$: the identity, moving off along \f$\xi\f$. Cayley's transform agrees with exp to
/// this order.
template <class S>
GroupElement<Dual<S>> moving_along(Algebra<S> const& xi) { return retract(moving(S(0) * xi, xi)); }
template <class S>
Matrix<S> value_part(Matrix<Dual<S>> const& m) {
  Matrix<S> v(m.rows(), m.cols());
  for (Index i = 0; i < m.size(); ++i) v(i) = m(i).value;
  return v;
}
template <class S>
Matrix<S> rate_part(Matrix<Dual<S>> const& m) {
  Matrix<S> v(m.rows(), m.cols());
  for (Index i = 0; i < m.size(); ++i) v(i) = m(i).part[0];
  return v;
}
/// Where a moving configuration is, and its \f$\dot g g^{-1}\f$, as matrices say: no formula for the
/// differential of exp or log enters.
template <class S>
State<SpannedGroup, S> state_of(GroupElement<Dual<S>> const& moving_element) {
  auto const& group = moving_element.group;
  GroupElement<S> const g{group, value_part<S>(moving_element.value)};
  Matrix<S> const velocity = rate_part<S>(moving_element.value) * inverse_matrix(g.value);
  return {g, {group, group.vee(velocity)}};
}
/// \f$(\psi_g^{-1})_*\f$ at \f$\eta\f$, of \f$\zeta\f$: (3.20) to the letter, the push-forward by dual
/// numbers.
template <class S>
State<SpannedGroup, S> push_forward(GroupElement<S> const& g, Algebra<S> const& eta, Algebra<S> const& zeta) {
  return state_of(exp(moving(eta, zeta)) * over<Dual<S>>(g));
}

}  // namespace actio::checks
