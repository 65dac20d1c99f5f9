// The pair groupoid G x G: the arrows are pairs of configurations, (g0, g1)(g1, g2) = (g0, g2). Its algebroid
// is TG.
#pragma once

#include "actio/groupoid/groupoid.hpp"
#include "actio/groups/group.hpp"
#include "actio/variational/curves.hpp"

namespace actio {

/// A pair of configurations: the arrow from the first to the second.
template <Group G, Scalar S>
struct PairArrow {
  using Scalar = S;
  Element<G, S> first;   ///< from here
  Element<G, S> second;  ///< to here
};

/// \f$G\times G\f$ over G. A vector of its algebroid at g is a tangent vector, translated to the identity on
/// the right: \f$\vartheta = \delta g\,g^{-1}\f$ of the target.
///
/// \implements{claim_4_1_groupoids}
template <Group G>
struct PairGroupoid {
  static constexpr int dim = G::dim;
  template <class S>
  using ArrowOver = PairArrow<G, S>;
  template <class S>
  using PointOver = Element<G, S>;
  [[no_unique_address]] G group;

  int dimension() const { return group.dimension(); }
  int base_dimension() const { return group.dimension(); }

  template <class S>
  static Element<G, S> source(PairArrow<G, S> const& g) { return g.first; }
  template <class S>
  static Element<G, S> target(PairArrow<G, S> const& g) { return g.second; }
  template <class S>
  static PairArrow<G, S> compose(PairArrow<G, S> const& g, PairArrow<G, S> const& h) {
    // [claim_4_1_groupoids]
    return {g.first, h.second};
    // [claim_4_1_groupoids]
  }
  template <class S>
  static PairArrow<G, S> inverse(PairArrow<G, S> const& g) { return {g.second, g.first}; }
  template <class S>
  static PairArrow<G, S> unit(Element<G, S> const& x) { return {x, x}; }
  template <class S>
  static PairArrow<G, S> near_unit(Element<G, S> const& x, Coordinates<G, S> const& v) {
    return {x, Element<G, S>{x.group, primitive::near_identity(x.group, v)} * x};
  }
  template <Real S>
  static PairArrow<G, S> leave(Element<G, S> const& x, Coordinates<G, S> const& v) {
    return {x, exp(Velocity<G, S>{x.group, v}) * x};
  }
  template <class T, class S>
  static PairArrow<G, T> over(PairArrow<G, S> const& g) {
    return {actio::over<T>(g.first), actio::over<T>(g.second)};
  }

  template <class S>
  static Matrix<S, Dynamic, 1> entries(PairArrow<G, S> const& g) {
    Matrix<S, Dynamic, 1> all(2 * g.first.value.size());
    for (Index i = 0; i < g.first.value.size(); ++i)
      all[i] = g.first.value(i), all[g.first.value.size() + i] = g.second.value(i);
    return all;
  }
  template <class S>
  PairArrow<G, S> moved(PairArrow<G, S> const& g, Matrix<S, Dynamic, 1> const& w) const {
    Coordinates<G, S> const first = w.head(dimension()), second = w.tail(dimension());
    return {near_unit(g.first, first).second, near_unit(g.second, second).second};
  }
  template <class S>
  static Matrix<S, Dynamic, 1> base_rate(Element<G, Dual<S>> const& x) { return rate_right(x).coordinates; }
};

}  // namespace actio
