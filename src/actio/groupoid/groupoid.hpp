// Lie groupoids: arrows between points, composed where one ends and the next begins.
//
// An arrow g leads from alpha(g), its source, to beta(g), its target; gh is defined where beta(g) = alpha(h).
// What is infinitely near the unit of a point x and leaves from x is a vector of the algebroid over x. Pairs
// of configurations and groups are groupoids, and so are things in between (action_groupoid.hpp,
// gauge_groupoid.hpp, diagonal_quotient.hpp); mechanics on all of them is one equation
// (lagrange_equations.hpp).
#pragma once

#include "actio/groups/differential.hpp"

namespace actio {

/// An arrow of the groupoid over the scalar S.
template <class Gamma, class S>
using Arrow = typename Gamma::template ArrowOver<S>;
/// A point of its base.
template <class Gamma, class S>
using Point = typename Gamma::template PointOver<S>;
/// Coordinates in a fibre of its algebroid, or of the dual of that.
template <class Gamma, class S>
using Fibre = Matrix<S, Gamma::dim, 1>;

/// A Lie groupoid over any field.
///
/// Laws (`tests/groupoid/groupoid_laws.hpp`): source(gh) = source(g), target(gh) = target(h); composition is
/// associative; unit(source(g)) g = g = g unit(target(g)); g inverse(g) = unit(source(g)), inverse(g)
/// g = unit(target(g)). `near_unit(x, v)` is the arrow from x that differs from the unit by an infinitesimal
/// v.
template <class Gamma>
concept Groupoid = requires(Gamma const& gamma, Arrow<Gamma, double> const& g, Point<Gamma, double> const& x,
                            Fibre<Gamma, double> const& v) {
  { gamma.dimension() } -> std::convertible_to<int>;
  { gamma.source(g) } -> std::convertible_to<Point<Gamma, double>>;
  { gamma.target(g) } -> std::convertible_to<Point<Gamma, double>>;
  { gamma.compose(g, g) } -> std::convertible_to<Arrow<Gamma, double>>;
  { gamma.unit(x) } -> std::convertible_to<Arrow<Gamma, double>>;
  { gamma.inverse(g) } -> std::convertible_to<Arrow<Gamma, double>>;
  { gamma.near_unit(x, v) } -> std::convertible_to<Arrow<Gamma, double>>;
  { gamma.template over<double>(g) } -> std::convertible_to<Arrow<Gamma, double>>;
};

/// A groupoid whose arrows and points can be moved about and written down: what its algebroid is computed
/// from (algebroid.hpp).
template <class Gamma>
concept MovableGroupoid =
    Groupoid<Gamma> && requires(Gamma const& gamma, Arrow<Gamma, double> const& g, Vector<double> const& w,
                                Point<Gamma, Dual<double>> const& x) {
      // of the base; that of the groupoid is base_dimension() + dimension()
      { gamma.base_dimension() } -> std::convertible_to<int>;
      // numbers that tell arrows apart, by their first derivatives too
      { gamma.entries(g) } -> std::convertible_to<Vector<double>>;
      // g moved by an infinitesimal w, base_dimension() + dimension() components
      { gamma.moved(g, w) } -> std::convertible_to<Arrow<Gamma, double>>;
      // how a point moves, base_dimension() components
      { gamma.base_rate(x) } -> std::convertible_to<Vector<double>>;
    };

/// A point of the dual of the algebroid: a covector on the fibre over a point of the base.
template <class Gamma, Scalar S>
struct DualPoint {
  using Scalar = S;
  Point<Gamma, S> base;        ///< where
  Fibre<Gamma, S> components;  ///< of the covector
};

/// A step can start at any point in any direction: `leave(x, v)` is an arrow from x, the unit for v = 0,
/// near_unit(x, v) to first order.
template <class Gamma>
concept ExponentialGroupoid = Groupoid<Gamma> && requires(Gamma const& gamma, Point<Gamma, double> const& x,
                                                          Fibre<Gamma, double> const& v) {
  { gamma.leave(x, v) } -> std::convertible_to<Arrow<Gamma, double>>;
};

}  // namespace actio
