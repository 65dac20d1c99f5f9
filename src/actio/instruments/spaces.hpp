// The spaces that a map may be judged on: how their points move to first order, and the bracket that a
// Poisson map preserves.
//
//   LiePoissonPlus, LiePoissonMinus g* Momentum momenta of right- and of left-invariant systems
//   CotangentBundle                                  T*G Costate spatial momentum, translated to the identity
//                           on the right
//   PairsOfConfigurations<L>                                 G x G PairArrow the two-form of a discrete
//   Lagrangian (discrete_spaces.hpp) RelativeMotionsRight<l>, RelativeMotionsLeft<l> G Element the bracket of
//   a reduced discrete Lagrangian (discrete_spaces.hpp)
//
// A tangent vector is written in coordinates: the change of a momentum by its components, that of a
// configuration as theta = dg g^-1. The sizes of a space at a point are one positive number for each
// coordinate, in its unit: what is computed in coordinates divided by them does not depend on the units of
// mass, length and time. A point is moved by its sizes, so that what solves an equation at dual numbers meets
// numbers of one scale.
#pragma once

#include "actio/instruments/points.hpp"
#include "actio/instruments/units_of_momenta.hpp"
#include "actio/variational/lie_poisson.hpp"

namespace actio {

/// A space of points that maps can be judged on.
///
/// `dimension(x)`: of the space. `sizes(x)`: a positive number for each coordinate, in its unit.
/// `moved(x, sizes, first)`: x moved infinitely little along the coordinates first, first + 1, ..., as many
/// as a batch has, by the size of each. `change(y)`: the coordinates of the infinitesimals of y.
/// `difference(x, y)`: the coordinates that lead from x to y. `bivector(x)`: the matrix of the bracket,
/// \f$\{F, H\} = dF^T\,B\,dH\f$ in coordinates.
template <class Space, class Point>
concept SpaceOf = requires(Space const& space, Point const& x) {
  { space.dimension(x) } -> std::convertible_to<int>;
  { space.sizes(x) } -> std::convertible_to<detail::AnyVector<typename Point::Scalar>>;
  { value_of(space.moved(x, space.sizes(x), 0)) } -> std::convertible_to<Point>;
  {
    space.change(space.moved(x, space.sizes(x), 0))
  } -> std::convertible_to<detail::AnyVector<Moved<typename Point::Scalar>>>;
  { space.bivector(x) } -> std::convertible_to<detail::AnyMatrix<typename Point::Scalar>>;
};
/// A space with a two-form: `two_form(x)`, \f$\omega(w_1, w_2) = w_1^T\,\Omega\,w_2\f$.
template <class Space, class Point>
concept SymplecticSpaceOf = SpaceOf<Space, Point> && requires(Space const& space, Point const& x) {
  { space.two_form(x) } -> std::convertible_to<detail::AnyMatrix<typename Point::Scalar>>;
};

namespace detail {

/// The infinitesimals of the coordinates first, first + 1, ... among those from `offset` on.
template <class V, class S>
void seed(V& v, AnyVector<S> const& sizes, int offset, int first) {
  for (int a = 0; a < batch; ++a)
    if (int const i = first + a - offset; i >= 0 && i < v.size()) v[i].part[a] = sizes[first + a];
}
template <Group G, Scalar S>
Element<G, Moved<S>> moved_element(Element<G, S> const& g, AnyVector<S> const& sizes, int offset, int first) {
  Coordinates<G, Moved<S>> v = Coordinates<G, Moved<S>>::Zero(g.group.dimension());
  seed(v, sizes, offset, first);
  return Element<G, Moved<S>>{g.group, primitive::near_identity(g.group, v)} * over<Moved<S>>(g);
}
template <Group G, Scalar S>
Momentum<G, Moved<S>> moved_momentum(Momentum<G, S> const& mu, AnyVector<S> const& sizes, int offset,
                                     int first) {
  Momentum<G, Moved<S>> moved = over<Moved<S>>(mu);
  seed(moved.components, sizes, offset, first);
  return moved;
}
/// \f$\delta g\,g^{-1}\f$ of the infinitesimals of g.
template <Group G, Scalar S>
Coordinates<G, Moved<S>> change_of_element(Element<G, Moved<S>> const& g) {
  auto const back = inverse(value_of(g));
  if constexpr (MatrixGroup<G>) {
    Coordinates<G, Moved<S>> change = Coordinates<G, Moved<S>>::Zero(g.group.dimension());
    for (int a = 0; a < batch; ++a) {
      Storage<G, S> const rate = g.value.unaryExpr([a](Moved<S> const& x) -> S { return x.part[a]; });
      Coordinates<G, S> const theta = g.group.vee(Storage<G, S>(rate * back.value));
      for (Index i = 0; i < theta.size(); ++i) change[i].part[a] = theta[i];
    }
    return change;
  } else {
    return log(g * over<Moved<S>>(back)).coordinates;
  }
}
template <Group G, Scalar S>
Coordinates<G, S> difference_of_elements(Element<G, S> const& g, Element<G, S> const& k) {
  return log(k * inverse(g)).coordinates;
}
/// One column on top of another.
template <class V, class W>
auto stacked(V const& v, W const& w) {
  AnyVector<typename V::Scalar> both(v.size() + w.size());
  for (Index i = 0; i < v.size(); ++i) both[i] = v[i];
  for (Index i = 0; i < w.size(); ++i) both[v.size() + i] = w[i];
  return both;
}
/// What the two signs of the bracket on the dual of an algebra have in common.
struct DualOfAlgebra {
  /// Of the space.
  template <Group G, Scalar S>
  static int dimension(Momentum<G, S> const& mu) { return mu.group.dimension(); }
  /// A positive number for each coordinate, in its unit.
  template <Group G, Plain S>
  static AnyVector<S> sizes(Momentum<G, S> const& mu) { return sizes_by_unit(mu); }
  /// x moved infinitely little along a batch of coordinates, by the size of each.
  template <Group G, Scalar S>
  static auto moved(Momentum<G, S> const& mu, AnyVector<S> const& sizes, int first) {
    return moved_momentum(mu, sizes, 0, first);
  }
  /// The coordinates of the infinitesimals.
  template <Group G, Scalar S>
  static auto change(Momentum<G, S> const& mu) { return mu.components; }
  /// The coordinates that lead from the first point to the second.
  template <Group G, Scalar S>
  static AnyVector<S> difference(Momentum<G, S> const& mu, Momentum<G, S> const& nu) {
    return nu.components - mu.components;
  }
};

}  // namespace detail

/// The dual of an algebra with the plus bracket: spatial momenta of right-invariant systems.
struct LiePoissonPlus : detail::DualOfAlgebra {
  /// The matrix of the bracket.
  template <Group G, Scalar S>
  static detail::AnyMatrix<S> bivector(Momentum<G, S> const& mu) { return lie_poisson_tensor_plus(mu); }
};
/// The dual of an algebra with the minus bracket: body momenta of left-invariant systems.
struct LiePoissonMinus : detail::DualOfAlgebra {
  /// The matrix of the bracket.
  template <Group G, Scalar S>
  static detail::AnyMatrix<S> bivector(Momentum<G, S> const& mu) { return -lie_poisson_tensor_plus(mu); }
};

/// T*G with its canonical form; coordinates \f$(\vartheta, \delta\mu)\f$, spatial.
///
/// A shift has the size that makes, with the momentum of shifts, what a turn by 1 makes with that of turns.
/// In \f$\mathbb R^n\f$, where nothing turns, it is the user's unit of length.
struct CotangentBundle {
  /// Of the space.
  template <Group G, Scalar S>
  static int dimension(Costate<G, S> const& p) { return 2 * p.configuration.group.dimension(); }
  /// A positive number for each coordinate, in its unit.
  template <Group G, Plain S>
  static detail::AnyVector<S> sizes(Costate<G, S> const& p) {
    auto const momenta = sizes_by_unit(p.momentum);
    auto const classes = unit_classes(p.configuration.group);
    detail::AnyVector<S> configurations = detail::AnyVector<S>::Constant(momenta.size(), S(1));
    S turns(0);
    for (Index a = 0; a < momenta.size(); ++a)
      if (!classes.has_length[classes.of[a]]) turns = momenta[a];
    for (Index a = 0; a < momenta.size() && turns > S(0); ++a) configurations[a] = turns / momenta[a];
    return detail::stacked(configurations, momenta);
  }
  /// x moved infinitely little along a batch of coordinates, by the size of each.
  template <Group G, Scalar S>
  static Costate<G, Moved<S>> moved(Costate<G, S> const& p, detail::AnyVector<S> const& sizes, int first) {
    return {detail::moved_element(p.configuration, sizes, 0, first),
            detail::moved_momentum(p.momentum, sizes, p.configuration.group.dimension(), first)};
  }
  /// The coordinates of the infinitesimals.
  template <Group G, Scalar S>
  static auto change(Costate<G, S> const& p) {
    return detail::stacked(detail::change_of_element(p.configuration), p.momentum.components);
  }
  /// The coordinates that lead from the first point to the second.
  template <Group G, Scalar S>
  static auto difference(Costate<G, S> const& p, Costate<G, S> const& q) {
    return detail::stacked(detail::difference_of_elements(p.configuration, q.configuration),
                           (q.momentum - p.momentum).components);
  }
  /// \f$\{F, H\} = \langle\partial_gF, H_\mu\rangle - \langle\partial_gH, F_\mu\rangle + \langle\mu, [F_\mu,
  /// H_\mu]\rangle\f$ as a matrix.
  template <Group G, Scalar S>
  static detail::AnyMatrix<S> bivector(Costate<G, S> const& p) {
    int const n = p.configuration.group.dimension();
    detail::AnyMatrix<S> b = detail::AnyMatrix<S>::Zero(2 * n, 2 * n);
    for (int a = 0; a < n; ++a) b(a, n + a) = S(1), b(n + a, a) = S(-1);
    b.bottomRightCorner(n, n) = lie_poisson_tensor_plus(p.momentum);
    return b;
  }
  /// \f$\omega(w_1, w_2) = \langle\delta\mu_2, \vartheta_1\rangle - \langle\delta\mu_1,
  /// \vartheta_2\rangle - \langle\mu, [\vartheta_1,
  /// \vartheta_2]\rangle\f$ as a matrix.
  template <Group G, Scalar S>
  static detail::AnyMatrix<S> two_form(Costate<G, S> const& p) {
    int const n = p.configuration.group.dimension();
    detail::AnyMatrix<S> omega = detail::AnyMatrix<S>::Zero(2 * n, 2 * n);
    for (int a = 0; a < n; ++a) omega(a, n + a) = S(1), omega(n + a, a) = S(-1);
    omega.topLeftCorner(n, n) = -lie_poisson_tensor_plus(p.momentum);
    return omega;
  }
  /// Where the momentum of a symmetry is read.
  template <Group G, Scalar S>
  static Costate<G, S> costate(Costate<G, S> const& p) { return p; }
};

}  // namespace actio
