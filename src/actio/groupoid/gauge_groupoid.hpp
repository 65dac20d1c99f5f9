// The gauge groupoid (M x M)/K of a principal bundle M -> M/K: pairs of configurations modulo the action of K
// on both.
//
// Over a contractible base the bundle is R^m x K, and an arrow is (x0, x1, k): from x0 to x1, with the group
// element k. For a single point it is K, for a trivial K the pairs of points. The spherical pendulum is of
// this kind: x is the height, K the rotations about the vertical.
#pragma once

#include "actio/groupoid/groupoid.hpp"

namespace actio {

/// From x0 to x1, with the group element k.
template <Group K, Scalar S>
struct GaugeArrow {
  using Scalar = S;
  Matrix<S, Dynamic, 1> from;  ///< x0
  Matrix<S, Dynamic, 1> to;    ///< x1
  Element<K, S> element;       ///< k
};
/// A point of the base.
template <Scalar S>
struct BasePoint {
  using Scalar = S;
  Matrix<S, Dynamic, 1> value;  ///< its coordinates
};

/// \f$(M\times M)/K\f$ over \f$\mathbb R^m\f$, \f$M = \mathbb R^m\times K\f$ with K acting from the left: the
/// pair ((x0, k0), (x1, k1)) has the group element \f$k_0^{-1}k_1\f$.
///
/// \f$(x_0, x_1, k)(x_1, x_2, l) = (x_0, x_2, kl)\f$. A vector of the algebroid is
/// \f$(\delta x_1, k^{-1}\delta k)\f$.
template <Group K>
struct GaugeGroupoid {
  static constexpr int dim = Dynamic;
  template <class S>
  using ArrowOver = GaugeArrow<K, S>;
  template <class S>
  using PointOver = BasePoint<S>;
  template <class S>
  using Column = Matrix<S, Dynamic, 1>;
  [[no_unique_address]] K group;
  int base = 1;  ///< m

  int dimension() const { return base + group.dimension(); }
  int base_dimension() const { return base; }

  template <class S>
  static BasePoint<S> source(GaugeArrow<K, S> const& g) { return {g.from}; }
  template <class S>
  static BasePoint<S> target(GaugeArrow<K, S> const& g) { return {g.to}; }
  template <class S>
  static GaugeArrow<K, S> compose(GaugeArrow<K, S> const& g, GaugeArrow<K, S> const& h) {
    return {g.from, h.to, g.element * h.element};
  }
  template <class S>
  static GaugeArrow<K, S> inverse(GaugeArrow<K, S> const& g) {
    return {g.to, g.from, actio::inverse(g.element)};
  }
  template <class S>
  GaugeArrow<K, S> unit(BasePoint<S> const& x) const { return {x.value, x.value, identity<S>(group)}; }
  template <class S>
  GaugeArrow<K, S> near_unit(BasePoint<S> const& x, Column<S> const& v) const {
    return {x.value,
            x.value + v.head(base),
            {group, primitive::near_identity(group, Coordinates<K, S>(v.tail(group.dimension())))}};
  }
  template <Real S>
  GaugeArrow<K, S> leave(BasePoint<S> const& x, Column<S> const& v) const {
    return {x.value, x.value + v.head(base), exp(Velocity<K, S>{group, v.tail(group.dimension())})};
  }
  template <class T, class S>
  static GaugeArrow<K, T> over(GaugeArrow<K, S> const& g) {
    return {g.from.template cast<T>(), g.to.template cast<T>(), actio::over<T>(g.element)};
  }

  template <class S>
  static Column<S> entries(GaugeArrow<K, S> const& g) {
    Index const m = g.from.size();
    Column<S> all(2 * m + g.element.value.size());
    all.head(m) = g.from, all.segment(m, m) = g.to;
    for (Index i = 0; i < g.element.value.size(); ++i) all[2 * m + i] = g.element.value(i);
    return all;
  }
  template <class S>
  GaugeArrow<K, S> moved(GaugeArrow<K, S> const& g, Column<S> const& w) const {
    Coordinates<K, S> const v = w.tail(group.dimension());
    return {g.from + w.head(base), g.to + w.segment(base, base),
            Element<K, S>{group, primitive::near_identity(group, v)} * g.element};
  }
  template <class S>
  static Column<S> base_rate(BasePoint<Dual<S>> const& x) {
    return x.value.unaryExpr([](Dual<S> const& y) { return y.part[0]; });
  }
};

}  // namespace actio
