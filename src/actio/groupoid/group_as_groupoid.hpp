// A group is a groupoid over a single point: any two arrows can be composed. Its algebroid is the algebra.
#pragma once

#include "actio/groupoid/groupoid.hpp"

namespace actio {

/// The point.
template <Scalar S>
struct SinglePoint {
  using Scalar = S;
};

/// G as a groupoid.
template <Group G>
struct GroupAsGroupoid {
  static constexpr int dim = G::dim;
  template <class S>
  using ArrowOver = Element<G, S>;
  template <class S>
  using PointOver = SinglePoint<S>;
  [[no_unique_address]] G group;

  int dimension() const { return group.dimension(); }
  static int base_dimension() { return 0; }

  template <class S>
  static SinglePoint<S> source(Element<G, S> const&) { return {}; }
  template <class S>
  static SinglePoint<S> target(Element<G, S> const&) { return {}; }
  template <class S>
  static Element<G, S> compose(Element<G, S> const& g, Element<G, S> const& h) { return g * h; }
  template <class S>
  static Element<G, S> inverse(Element<G, S> const& g) { return actio::inverse(g); }
  template <class S>
  Element<G, S> unit(SinglePoint<S> const&) const { return identity<S>(group); }
  template <class S>
  Element<G, S> near_unit(SinglePoint<S> const&, Coordinates<G, S> const& v) const {
    return {group, primitive::near_identity(group, v)};
  }
  template <Real S>
  Element<G, S> leave(SinglePoint<S> const&, Coordinates<G, S> const& v) const {
    return exp(Velocity<G, S>{group, v});
  }
  template <class T, class S>
  static Element<G, T> over(Element<G, S> const& g) { return actio::over<T>(g); }

  template <class S>
  static Matrix<S, Dynamic, 1> entries(Element<G, S> const& g) {
    Matrix<S, Dynamic, 1> all(g.value.size());
    for (Index i = 0; i < g.value.size(); ++i) all[i] = g.value(i);
    return all;
  }
  template <class S>
  Element<G, S> moved(Element<G, S> const& g, Matrix<S, Dynamic, 1> const& w) const {
    return near_unit(SinglePoint<S>{}, Coordinates<G, S>(w)) * g;
  }
  template <class S>
  static Matrix<S, Dynamic, 1> base_rate(SinglePoint<Dual<S>> const&) { return Matrix<S, Dynamic, 1>(0); }
};

}  // namespace actio
