// An action groupoid: a group together with vectors it acts on. Its arrows are (g, a), from a to g^-1 a.
//
// A system whose symmetry is broken by a vector, such as gravity in the frame of a top, is a system on it: g
// = g0^-1 g1 is how the top turns in a step, a = g0^-1 a0 is the vector in the body before it. The Lagrange
// equations of this groupoid are the discrete Euler-Poincare equations with an advected quantity.
#pragma once

#include "actio/groupoid/groupoid.hpp"

namespace actio {

/// A group element and the vector at its source.
template <Group G, Scalar S>
struct ActionArrow {
  using Scalar = S;
  Element<G, S> element;         ///< g
  Matrix<S, Dynamic, 1> vector;  ///< a
};
/// A vector, as a point of the base.
template <Scalar S>
struct CarriedVector {
  using Scalar = S;
  Matrix<S, Dynamic, 1> value;  ///< its components
};

/// \f$G\ltimes\mathbb R^m\f$ over \f$\mathbb R^m\f$ for a group of m by m matrices that acts on vectors by
/// multiplication: \f$(g, a)(h, g^{-1}a) = (gh, a)\f$.
template <MatrixGroup G>
struct ActionGroupoid {
  static constexpr int dim = G::dim;
  template <class S>
  using ArrowOver = ActionArrow<G, S>;
  template <class S>
  using PointOver = CarriedVector<S>;
  template <class S>
  using Column = Matrix<S, Dynamic, 1>;
  [[no_unique_address]] G group;

  int dimension() const { return group.dimension(); }
  int base_dimension() const { return group.matrix_size(); }

  template <class S>
  static CarriedVector<S> source(ActionArrow<G, S> const& g) { return {g.vector}; }
  template <class S>
  static CarriedVector<S> target(ActionArrow<G, S> const& g) {
    return {Column<S>(actio::inverse(g.element).value * g.vector)};
  }
  template <class S>
  static ActionArrow<G, S> compose(ActionArrow<G, S> const& g, ActionArrow<G, S> const& h) {
    return {g.element * h.element, g.vector};
  }
  template <class S>
  static ActionArrow<G, S> inverse(ActionArrow<G, S> const& g) {
    return {actio::inverse(g.element), target(g).value};
  }
  template <class S>
  ActionArrow<G, S> unit(CarriedVector<S> const& x) const { return {identity<S>(group), x.value}; }
  template <class S>
  ActionArrow<G, S> near_unit(CarriedVector<S> const& x, Coordinates<G, S> const& v) const {
    return {{group, primitive::near_identity(group, v)}, x.value};
  }
  template <Real S>
  ActionArrow<G, S> leave(CarriedVector<S> const& x, Coordinates<G, S> const& v) const {
    return {exp(Velocity<G, S>{group, v}), x.value};
  }
  template <class T, class S>
  static ActionArrow<G, T> over(ActionArrow<G, S> const& g) {
    return {actio::over<T>(g.element), g.vector.template cast<T>()};
  }

  template <class S>
  static Column<S> entries(ActionArrow<G, S> const& g) {
    Column<S> all(g.element.value.size() + g.vector.size());
    for (Index i = 0; i < g.element.value.size(); ++i) all[i] = g.element.value(i);
    all.tail(g.vector.size()) = g.vector;
    return all;
  }
  template <class S>
  ActionArrow<G, S> moved(ActionArrow<G, S> const& g, Column<S> const& w) const {
    Coordinates<G, S> const v = w.tail(dimension());
    return {Element<G, S>{group, primitive::near_identity(group, v)} * g.element,
            g.vector + w.head(base_dimension())};
  }
  template <class S>
  static Column<S> base_rate(CarriedVector<Dual<S>> const& x) {
    return x.value.unaryExpr([](Dual<S> const& y) { return y.part[0]; });
  }
};

}  // namespace actio
