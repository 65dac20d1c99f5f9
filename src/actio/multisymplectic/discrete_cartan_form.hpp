// The discrete Cartan forms of a discrete Lagrangian (chapter 10 of the thesis; Marsden, Patrick and Shkoller
// 1998).
//
// The differential of L_d on a cell is a sum over its nodes: dL_d = sum_l Theta^l with one one-form for each
// node. Where the continuous theory has one Cartan form whose boundary term is integrated over the boundary
// of a region, the discrete theory has 2^(n+1) of them, each the boundary term of its node.
#pragma once

#include "actio/multisymplectic/discrete_lagrangian.hpp"

namespace actio::media {

namespace detail {

/// The part of the discrete Lagrangian that depends on the values at two nodes, l and m, both moved.
template <class T, class S, int n, int N, class L>
T action_with(L const& density, SpaceTimeCell<S, n, N> const& cell, int l, Matrix<T, N, 1> const& y_l, int m,
              Matrix<T, N, 1> const& y_m) {
  auto moved = cell.template cast<T>();
  moved.y.col(m) = y_m;
  moved.y.col(l) = y_l;
  T sum(0);
  for (int k = 0; k < cell.nodes; ++k)
    if (jet_contains(cell, k, l) && jet_contains(cell, k, m)) sum += action_at_node(density, moved, k);
  return sum;
}

/// \ref discrete_cartan_form of a density that has been asked whether it is defined.
template <class S, int n, int N, class L>
Matrix<S, N, 1> cartan_form_at_node(L const& density, SpaceTimeCell<S, n, N> const& cell, int l) {
  Matrix<S, N, 1> const y_l = cell.y.col(l);
  auto const L_d = [&]<class T>(Matrix<T, N, 1> const& y) -> T {
    return action_with(density, cell, l, y, l, y);
  };
  // [discrete_cartan_form]
  return derivative(L_d, y_l).gradient();
  // [discrete_cartan_form]
}

}  // namespace detail

/// The discrete Cartan form \f$\Theta^l = \frac{\partial L_d}{\partial y_l}\,dy_l\f$ of a node, by its
/// components: \f$dL_d = \sum_l\Theta^l\f$.
///
/// At a node of the later level it is the momentum at the end of the slab, at one of the earlier level minus
/// the momentum at the start, each with what the stresses on the faces of the cell add in half a step.
///
/// @param l  node of the cell
/// @return   a covector at \f$y_l\f$, a component for each a
/// @throws NoDerivative  where the density has none; and what the density itself refuses
/// Accuracy: exact but for the rounding of L.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> discrete_cartan_form(L const& density, SpaceTimeCell<S, n, N> const& cell, int l) {
  for (int k = 0; k < cell.nodes; ++k)
    if (jet_contains(cell, k, l)) examine(density, discrete_jet(cell, k));
  auto const Theta = detail::cartan_form_at_node(density, cell, l);
  require_derivative(Theta, discrete_jet(cell, l), "discrete_cartan_form");
  return Theta;
}

/// The second derivative \f$\partial^2L_d/\partial y_l\,\partial y_m\f$ of two different nodes of a cell.
/// Row: component at l; column: direction in which the value at m moves.
///
/// L is regular, as far as a cell is concerned, where this has an inverse for the two ends of an edge in
/// time.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, N> discrete_mixed_derivative(L const& density, SpaceTimeCell<S, n, N> const& cell, int l,
                                          int m) {
  Matrix<S, N, 1> const y_l = cell.y.col(l), y_m = cell.y.col(m);
  auto const Theta_l = [&]<class T>(Matrix<T, N, 1> const& z) -> Matrix<T, N, 1> {
    auto const L_d = [&]<class U>(Matrix<U, N, 1> const& y) -> U {
      return detail::action_with(density, cell, l, y, m, Matrix<U, N, 1>(z.template cast<U>()));
    };
    return derivative(L_d, Matrix<T, N, 1>(y_l.template cast<T>())).gradient();
  };
  return derivative(Theta_l, y_m).matrix;
}

}  // namespace actio::media
