// Lie groups, their algebras and the duals of these: three types that do not mix.
//
// A group is a small struct of primitives (concepts `Group` and `ExponentialGroup`); geometry is the free
// functions below, named as the thesis names them. The same struct serves every scalar. Most groups have no
// data; one may (the span of a basis of matrices, a run-time size), so elements carry their group along: it
// costs nothing where it is empty.
//
// Conventions, once for all: bracket is the commutator of matrices, ad_xi eta = [xi, eta]; stars are duals,
// <Ad*_g mu, xi> = <mu, Ad_g xi> and <ad*_xi mu, eta> = <mu, ad_xi eta>.
#pragma once

#include "actio/groups/matrix_group.hpp"

namespace actio {

/// A group that is not stored as a matrix and brings all its primitives.
template <class G>
concept PrimitiveGroup =
    requires(G const& group, Storage<G, double> const& a, Coordinates<G, double> const& v) {
      { G::dim } -> std::convertible_to<int>;
      { group.dimension() } -> std::convertible_to<int>;
      { group.template identity<double>() } -> std::convertible_to<Storage<G, double>>;
      { group.compose(a, a) } -> std::convertible_to<Storage<G, double>>;
      { group.inverse(a) } -> std::convertible_to<Storage<G, double>>;
      { group.Ad(a, v) } -> std::convertible_to<Coordinates<G, double>>;
      { group.bracket(v, v) } -> std::convertible_to<Coordinates<G, double>>;
      { group.retract(v) } -> std::convertible_to<Storage<G, double>>;
      { group.near_identity(v) } -> std::convertible_to<Storage<G, double>>;
    };

/// A Lie group over any field, the rationals included: a matrix group, or one that brings all its primitives.
///
/// Laws, checked for every group of the library and usable on a reader's own (`tests/groups/group_laws.hpp`):
/// compose is associative, identity neutral, inverse inverse; Ad(gh) = Ad(g) Ad(h); the bracket is bilinear,
/// antisymmetric, satisfies Jacobi's identity and is the derivative of Ad; `retract(-v)` is the inverse of
/// `retract(v)`, and along a line it agrees with the exponential to second order; `near_identity(v)` is
/// `retract(v)` for infinitesimal v.
template <class G>
concept Group = MatrixGroup<G> || PrimitiveGroup<G>;

/// A group with exponential, logarithm and `restore`, where the scalar has roots.
///
/// Laws: log inverts exp inside the chart of (3.19) and refuses outside; exp((s+t)v) = exp(sv) exp(tv);
/// `restore` is the identity on the group, up to rounding, and brings an element that rounding has moved off
/// the group back on it.
template <class G>
concept ExponentialGroup =
    MatrixGroup<G> || (PrimitiveGroup<G> && requires(G const& group, Storage<G, double> const& a,
                                                     Coordinates<G, double> const& v) {
      { group.exp(v) } -> std::convertible_to<Storage<G, double>>;
      { group.log(a) } -> std::convertible_to<Coordinates<G, double>>;
      { group.restore(a) } -> std::convertible_to<Storage<G, double>>;
    });

/// g in G.
///
/// \snippet numbers.cpp group
template <Group G, Scalar S>
struct Element {
  using GroupType = G;
  using Scalar = S;
  [[no_unique_address]] G group;
  Storage<G, S> value;
};

/// xi in the algebra of G, by its coordinates; 1/time where it is a velocity.
template <Group G, Scalar S>
struct Velocity {
  using GroupType = G;
  using Scalar = S;
  [[no_unique_address]] G group;
  Coordinates<G, S> coordinates;
};

/// mu in the dual of the algebra of G, by its components in the dual basis; energy x time.
template <Group G, Scalar S>
struct Momentum {
  using GroupType = G;
  using Scalar = S;
  [[no_unique_address]] G group;
  Coordinates<G, S> components;
};

// Making elements, velocities and momenta of a group.

template <Scalar S, Group G>
Element<G, S> identity(G const& group) { return {group, primitive::identity<S>(group)}; }
template <Group G, MatrixLike V>
auto velocity(G const& group, V const& coordinates) {
  return Velocity<G, typename V::Scalar>{group, coordinates};
}
template <Group G, MatrixLike V>
auto momentum(G const& group, V const& components) {
  return Momentum<G, typename V::Scalar>{group, components};
}
/// The a-th basis vector of the algebra.
template <Scalar S, Group G>
Velocity<G, S> basis_velocity(G const& group, int a) {
  Velocity<G, S> e{group, Coordinates<G, S>::Zero(group.dimension())};
  e.coordinates[a] = S(1);
  return e;
}

// Linear operations, each inside its own space.

template <Group G, Scalar S>
Velocity<G, S> operator+(Velocity<G, S> const& a, Velocity<G, S> const& b) {
  return {a.group, a.coordinates + b.coordinates};
}
template <Group G, Scalar S>
Velocity<G, S> operator-(Velocity<G, S> const& a, Velocity<G, S> const& b) {
  return {a.group, a.coordinates - b.coordinates};
}
template <Group G, Scalar S>
Velocity<G, S> operator-(Velocity<G, S> const& a) { return {a.group, -a.coordinates}; }
template <Group G, Scalar S>
Velocity<G, S> operator*(std::type_identity_t<S> const& s, Velocity<G, S> const& a) {
  return {a.group, a.coordinates * s};
}
template <Group G, Scalar S>
Velocity<G, S> operator/(Velocity<G, S> const& a, std::type_identity_t<S> const& s) {
  return {a.group, a.coordinates / s};
}

template <Group G, Scalar S>
Momentum<G, S> operator+(Momentum<G, S> const& a, Momentum<G, S> const& b) {
  return {a.group, a.components + b.components};
}
template <Group G, Scalar S>
Momentum<G, S> operator-(Momentum<G, S> const& a, Momentum<G, S> const& b) {
  return {a.group, a.components - b.components};
}
template <Group G, Scalar S>
Momentum<G, S> operator-(Momentum<G, S> const& a) { return {a.group, -a.components}; }
template <Group G, Scalar S>
Momentum<G, S> operator*(std::type_identity_t<S> const& s, Momentum<G, S> const& a) {
  return {a.group, a.components * s};
}
template <Group G, Scalar S>
Momentum<G, S> operator/(Momentum<G, S> const& a, std::type_identity_t<S> const& s) {
  return {a.group, a.components / s};
}

/// \f$\langle\mu, \xi\rangle\f$: the only thing that joins the algebra and its dual.
///
/// \snippet numbers.cpp group
template <Group G, Scalar S>
S pair(Momentum<G, S> const& mu, Velocity<G, S> const& xi) {
  S sum(0);
  for (Index a = 0; a < mu.components.size(); ++a) sum += mu.components[a] * xi.coordinates[a];
  return sum;
}

// The group.

template <Group G, Scalar S>
Element<G, S> operator*(Element<G, S> const& g, Element<G, S> const& h) {
  return {g.group, primitive::compose(g.group, g.value, h.value)};
}
template <Group G, Scalar S>
Element<G, S> inverse(Element<G, S> const& g) { return {g.group, primitive::inverse(g.group, g.value)}; }

/// \f$\mathrm{Ad}_g\,\xi = g\,\xi\,g^{-1}\f$.
///
/// \snippet numbers.cpp adjoint
template <Group G, Scalar S>
Velocity<G, S> Ad(Element<G, S> const& g, Velocity<G, S> const& xi) {
  return {g.group, primitive::Ad(g.group, g.value, xi.coordinates)};
}
/// The matrix of \f$\mathrm{Ad}_g\f$ in the basis of the algebra.
template <Group G, Scalar S>
auto Ad_matrix(Element<G, S> const& g) { return primitive::Ad_matrix<S>(g.group, g.value); }
/// \f$\langle\mathrm{Ad}^*_g\,\mu, \xi\rangle = \langle\mu, \mathrm{Ad}_g\,\xi\rangle\f$: the dual map, with
/// no inverse in it.
///
/// \snippet numbers.cpp adjoint
template <Group G, Scalar S>
Momentum<G, S> Ad_star(Element<G, S> const& g, Momentum<G, S> const& mu) {
  return {g.group, primitive::Ad_star(g.group, g.value, mu.components)};
}
/// \f$[\xi, \eta]\f$, the commutator.
template <Group G, Scalar S>
Velocity<G, S> bracket(Velocity<G, S> const& xi, Velocity<G, S> const& eta) {
  return {xi.group, primitive::bracket(xi.group, xi.coordinates, eta.coordinates)};
}
/// \f$\mathrm{ad}_\xi\,\eta = [\xi, \eta]\f$.
template <Group G, Scalar S>
Velocity<G, S> ad(Velocity<G, S> const& xi, Velocity<G, S> const& eta) { return bracket(xi, eta); }
/// The matrix of \f$\mathrm{ad}_\xi\f$ in the basis of the algebra.
template <Group G, Scalar S>
auto ad_matrix(Velocity<G, S> const& xi) { return primitive::ad_matrix(xi.group, xi.coordinates); }
/// \f$\langle\mathrm{ad}^*_\xi\,\mu, \eta\rangle = \langle\mu, [\xi, \eta]\rangle\f$.
template <Group G, Scalar S>
Momentum<G, S> ad_star(Velocity<G, S> const& xi, Momentum<G, S> const& mu) {
  return {xi.group, ad_matrix(xi).transpose() * mu.components};
}

/// From the algebra to the group over any field; agrees with \ref exp to second order.
/// @throws Singular  where the retraction is not defined (Cayley's: an eigenvalue 2)
template <Group G, Scalar S>
Element<G, S> retract(Velocity<G, S> const& xi) {
  require_finite(xi.coordinates, "retract");
  Element<G, S> const g{xi.group, primitive::retract(xi.group, xi.coordinates)};
  require_finite(g.value, "retract: result");
  return g;
}
/// The exponential: where the motion with the constant velocity \f$\xi\f$ is at the time 1.
///
/// \snippet numbers.cpp group
/// @throws NotFinite  where the argument is no number, or so large that the result is none
template <ExponentialGroup G, Real S>
Element<G, S> exp(Velocity<G, S> const& xi) {
  require_finite(xi.coordinates, "exp");
  Element<G, S> const g{xi.group, primitive::exp(xi.group, xi.coordinates)};
  require_finite(g.value, "exp: result");
  return g;
}
/// The inverse of \ref exp in the natural chart (3.19).
///
/// \snippet numbers.cpp group
/// @throws OutsideDomain  where g has no logarithm in the chart, with the angle (or eigenvalue) that was met
template <ExponentialGroup G, Real S>
Velocity<G, S> log(Element<G, S> const& g) {
  require_finite(g.value, "log");
  return {g.group, primitive::log_of<G, S>(g.group, g.value)};
}
/// g brought back on the group after rounding has moved it off.
/// @throws OutsideDomain  where g is nowhere near the group
template <ExponentialGroup G, Real S>
Element<G, S> restore(Element<G, S> const& g) {
  require_finite(g.value, "restore");
  return {g.group, primitive::restore(g.group, g.value)};
}

// The same element, velocity or momentum over a larger scalar T, where it is a constant.

template <Scalar T, Group G, Scalar S>
Element<G, T> over(Element<G, S> const& g) { return {g.group, g.value.template cast<T>()}; }
template <Scalar T, Group G, Scalar S>
Velocity<G, T> over(Velocity<G, S> const& xi) { return {xi.group, xi.coordinates.template cast<T>()}; }
template <Scalar T, Group G, Scalar S>
Momentum<G, T> over(Momentum<G, S> const& mu) { return {mu.group, mu.components.template cast<T>()}; }
/// `x` as a constant of the scalar of `model`: `like(f, mu)` inside a residual that is being differentiated.
template <class Model, class X>
auto like(Model const&, X const& x) { return over<typename Model::Scalar>(x); }

/// A function of elements of G: callable at `S`, and written so that it is callable at dual numbers over `S`
/// too.
template <class F, class G, class S>
concept FunctionOnGroup = Group<G> && requires(F const& f, Element<G, S> const& g) {
  { f(g) } -> std::convertible_to<S>;
};

}  // namespace actio
