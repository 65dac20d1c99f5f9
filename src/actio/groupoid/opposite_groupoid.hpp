// The opposite groupoid: the same arrows, read from their target to their source, composed in the other
// order.
#pragma once

#include "actio/groupoid/groupoid.hpp"

namespace actio {

/// \f$\Gamma^{\mathrm{op}}\f$: source and target change places, \f$g\cdot_{\mathrm{op}}h = hg\f$.
///
/// What is near a unit and used to arrive now leaves; v stays the velocity of the free end, with the sign
/// that makes the opposite of a group have the group's own near_unit.
template <Groupoid Gamma>
struct Opposite {
  static constexpr int dim = Gamma::dim;
  template <class S>
  using ArrowOver = Arrow<Gamma, S>;
  template <class S>
  using PointOver = Point<Gamma, S>;
  Gamma of;  ///< the groupoid of which it is the opposite

  int dimension() const { return of.dimension(); }
  int base_dimension() const { return of.base_dimension(); }

  template <class A>
  auto source(A const& g) const { return of.target(g); }
  template <class A>
  auto target(A const& g) const { return of.source(g); }
  template <class A>
  A compose(A const& g, A const& h) const { return of.compose(h, g); }
  template <class A>
  A inverse(A const& g) const { return of.inverse(g); }
  template <class X>
  auto unit(X const& x) const { return of.unit(x); }
  template <class X, class V>
  auto near_unit(X const& x, V const& v) const { return of.inverse(of.near_unit(x, V(-v))); }
  template <class X, class V>
  auto leave(X const& x, V const& v) const { return of.inverse(of.leave(x, V(-v))); }
  template <class T, class A>
  auto over(A const& g) const { return of.template over<T>(g); }
  template <class A>
  auto entries(A const& g) const { return of.entries(g); }
  template <class A, class W>
  A moved(A const& g, W const& w) const { return of.moved(g, w); }
  template <class X>
  auto base_rate(X const& x) const { return of.base_rate(x); }
};

}  // namespace actio
