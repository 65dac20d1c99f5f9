// Differentials of functions on a group, translated to the identity from either side, and of functions on vector spaces.
//
// The side is in the name. A differential is taken by evaluating the function on elements moved infinitely little: exact, and alive at
// every scalar. Directions are taken in small batches, so the size of a scalar does not depend on the group.
#pragma once

#include "actio/foundations/group.hpp"

namespace actio {

/// How many directions a dual number carries at once.
inline constexpr int batch = 3;

/// The scalar on which one differential of a function at `S` is evaluated.
template <class S>
using Moved = Dual<S, batch>;

/// \f$(1 + \sum_a\varepsilon_a e_{first+a})\,g\f$: g moved on the left by infinitesimals, one for each direction of a batch.
template <Group G, Field S>
Element<G, Moved<S>> moved_left(Element<G, S> const& g, int first) {
  Coordinates<G, Moved<S>> v = Coordinates<G, Moved<S>>::Zero(g.group.dimension());
  for (int a = 0; a < batch && first + a < g.group.dimension(); ++a) v[first + a].part[a] = S(1);
  return {g.group, primitive::compose(g.group, primitive::near_identity(g.group, v), Storage<G, Moved<S>>(g.value.template cast<Moved<S>>()))};
}
/// \f$g\,(1 + \sum_a\varepsilon_a e_{first+a})\f$: g moved on the right.
template <Group G, Field S>
Element<G, Moved<S>> moved_right(Element<G, S> const& g, int first) {
  Coordinates<G, Moved<S>> v = Coordinates<G, Moved<S>>::Zero(g.group.dimension());
  for (int a = 0; a < batch && first + a < g.group.dimension(); ++a) v[first + a].part[a] = S(1);
  return {g.group, primitive::compose(g.group, Storage<G, Moved<S>>(g.value.template cast<Moved<S>>()), primitive::near_identity(g.group, v))};
}

/// Calls `visit(first)` for the first direction of each batch.
template <class Visit>
void over_batches(int dimension, Visit const& visit) {
  for (int first = 0; first < dimension; first += batch) visit(first);
}

/// \f$R_g^*\,l'(g)\f$: the differential of l at g, read on \f$\vartheta\mapsto\frac{d}{d\epsilon}l(e^{\epsilon\vartheta}g)\f$.
///
/// @param l  function on G, callable at `S` and at dual numbers over it; energy x time where it is an action
/// @param g  where
/// @return   covector at the identity
/// Exact up to rounding.
template <Group G, Field S, FunctionOnGroup<G, Moved<S>> F>
Momentum<G, S> right_differential(F const& l, Element<G, S> const& g) {
  int const n = g.group.dimension();
  Momentum<G, S> d{g.group, Coordinates<G, S>(n)};
  over_batches(n, [&](int first) {
    Moved<S> const change = l(moved_left(g, first));
    for (int a = 0; a < batch && first + a < n; ++a) d.components[first + a] = change.part[a];
  });
  return d;
}

/// \f$L_g^*\,l'(g)\f$: the differential of l at g, read on \f$\vartheta\mapsto\frac{d}{d\epsilon}l(g\,e^{\epsilon\vartheta})\f$.
///
/// Equal to \f$\mathrm{Ad}^*_g\,R_g^*\,l'(g)\f$. Parameters and accuracy as in \ref right_differential.
template <Group G, Field S, FunctionOnGroup<G, Moved<S>> F>
Momentum<G, S> left_differential(F const& l, Element<G, S> const& g) {
  int const n = g.group.dimension();
  Momentum<G, S> d{g.group, Coordinates<G, S>(n)};
  over_batches(n, [&](int first) {
    Moved<S> const change = l(moved_right(g, first));
    for (int a = 0; a < batch && first + a < n; ++a) d.components[first + a] = change.part[a];
  });
  return d;
}

/// \f$\partial l/\partial\xi\f$ of a function on the algebra: a covector.
template <Group G, Field S, class F>
Momentum<G, S> gradient(F const& l, Velocity<G, S> const& xi) {
  int const n = xi.group.dimension();
  Momentum<G, S> d{xi.group, Coordinates<G, S>(n)};
  over_batches(n, [&](int first) {
    Velocity<G, Moved<S>> moved = over<Moved<S>>(xi);
    for (int a = 0; a < batch && first + a < n; ++a) moved.coordinates[first + a].part[a] = S(1);
    Moved<S> const change = l(moved);
    for (int a = 0; a < batch && first + a < n; ++a) d.components[first + a] = change.part[a];
  });
  return d;
}

/// \f$\partial h/\partial\mu\f$ of a function on the dual of the algebra: a velocity.
template <Group G, Field S, class F>
Velocity<G, S> gradient(F const& h, Momentum<G, S> const& mu) {
  int const n = mu.group.dimension();
  Velocity<G, S> d{mu.group, Coordinates<G, S>(n)};
  over_batches(n, [&](int first) {
    Momentum<G, Moved<S>> moved = over<Moved<S>>(mu);
    for (int a = 0; a < batch && first + a < n; ++a) moved.components[first + a].part[a] = S(1);
    Moved<S> const change = h(moved);
    for (int a = 0; a < batch && first + a < n; ++a) d.coordinates[first + a] = change.part[a];
  });
  return d;
}

/// The parts of a column of dual numbers along one batch, as columns of a matrix beginning at column `first`.
template <class Matrix, class Column>
void store_parts(Matrix& matrix, Column const& column, int first) {
  for (Eigen::Index i = 0; i < column.size(); ++i)
    for (int a = 0; a < batch && first + a < matrix.cols(); ++a) matrix(i, first + a) = column[i].part[a];
}

}  // namespace actio
