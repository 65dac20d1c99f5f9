// The discrete covariant Euler-Poincare equations: fields with values in a group, and a Lagrangian that does
// not change when all values are multiplied from the left by the same element.
//
// Such a Lagrangian is a sum over the edges of a grid of space-time. That of an edge is an action, a function
// of the relative motion of its ends. At a node the equation is the discrete Euler-Poincare equation (3.11)
// twice, once in time and once in space. Both directions have the same rights: a field whose space and time
// are exchanged satisfies the same equation.
//
// A Lagrangian is any callable l(edge, f) over every scalar, f the relative motion; `time_and_space` makes
// one of an action in time and one in space that are the same on all edges.
#pragma once

#include "actio/covariant_reduction/group_field.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"

namespace actio {

/// The Lagrangian with one action for all edges in time and one for all edges in space, energy x time.
template <class InTime, class InSpace>
auto time_and_space(InTime in_time, InSpace in_space) {
  return [=](GridEdge const& edge, auto const& f) {
    return edge.direction == Direction::time ? in_time(f) : in_space(f);
  };
}
/// The Lagrangian of the \ref transposed field.
template <class L>
auto transposed_lagrangian(L l) {
  return [=](GridEdge const& e, auto const& f) {
    auto const other = e.direction == Direction::time ? Direction::space : Direction::time;
    return l(GridEdge{other, e.level, e.node}, f);
  };
}

namespace detail {
/// The action of one edge, as a function on the group.
template <class L>
auto on_edge(L const& l, GridEdge const& edge) { return [&l, edge](auto const& f) { return l(edge, f); }; }
}  // namespace detail

/// The left side of the field equation at a node, a covector at the identity as the node sees it: the
/// derivative of the sum of all actions by \f$g_a^k\f$ along \f$\delta g = g\,\zeta\f$. At an inner node it
/// is
/// \f[ L^*_f\ell_t'(f_a^k) - R^*_f\ell_t'(f_a^{k-1}) + L^*_e\ell_s'(e_a^k) - R^*_e\ell_s'(e_{a-1}^k) , \f]
/// at others the terms of the edges that there are.
///
/// \implements{bridge_covariant_euler_poincare}
/// @param l      (edge, relative motion) -> energy x time
/// @param field  a GroupField or a RelativeField
/// @return       zero at all nodes that are not held, at all levels but the first and the last one, along
///               solutions and only there; exact up to rounding
template <class L, class Field>
auto field_equation(L const& l, Field const& field, Index a, Index k) {
  auto const grid = field.grid();
  using Covector = decltype(left_differential(detail::on_edge(l, {}), field.motion({})));
  auto const& group = field.motion({Direction::space, 0, 0}).group;
  Covector sum{group, decltype(Covector::components)::Zero(group.dimension())};
  // [bridge_covariant_euler_poincare]
  grid.over_edges_at(a, k, [&](GridEdge const& edge, bool leaves) {
    auto const action = detail::on_edge(l, edge);
    auto const f = field.motion(edge);
    if (leaves)
      sum = sum + left_differential(action, f);
    else
      sum = sum - right_differential(action, f);
  });
  // [bridge_covariant_euler_poincare]
  return sum;
}
/// The left side at an inner node where the actions are the same on all edges, from the relative motions of
/// the four edges that meet there: (3.11) in time plus (3.11) in space.
///
/// @param f10, f21  relative motions in time, over the step before and the step after
/// @param e10, e21  relative motions in space, on the edge before and on the edge after
template <Group G, Scalar S, class InTime, class InSpace>
Momentum<G, S> covariant_euler_poincare(InTime const& l_t, Element<G, S> const& f10, Element<G, S> const& f21,
                                        InSpace const& l_s, Element<G, S> const& e10,
                                        Element<G, S> const& e21) {
  // [covariant_euler_poincare]
  return euler_poincare_left(l_t, f10, f21) + euler_poincare_left(l_s, e10, e21);
  // [covariant_euler_poincare]
}

/// Puts the next level behind the last one: solves the field equation at each node of the last level for the
/// relative motion in time, one node at a time, since nodes of a level are not coupled. Values that are held
/// stay; where they move the caller writes them into the new level of a GroupField.
///
/// \snippet covariant_reduction.cpp chiral_field
/// @param field     a GroupField or a RelativeField with one level or more
/// @param impulses  what each node receives at the last level beside the actions, as its body sees it, energy
///                  x time: its momentum at the start, which the first step needs; the impulse of a force
///                  later
/// @return          the report of the node that took most evaluations
/// @throws OutsideDomain  where this is no field, or impulses are for some nodes or absent at a first step
/// @throws NotConverged, NotFinite  with node and level; Singular: where the action in time is not regular.
///                        The field is as it was then
template <class L, class Field>
Report step_in_time(
    L const& l, Field& field,
    std::vector<Momentum<typename Field::GroupType, typename Field::Scalar>> const& impulses = {}) {
  using Motion = Element<typename Field::GroupType, typename Field::Scalar>;
  require_field(field);
  auto const grid = field.grid();
  bool const first = grid.levels < 2;
  if ((first || !impulses.empty()) && static_cast<Index>(impulses.size()) != grid.nodes)
    throw OutsideDomain("step_in_time",
                        "a first step needs a momentum for each node, and impulses are for all",
                        static_cast<double>(impulses.size()), static_cast<double>(grid.nodes));
  Index const k = grid.levels - 1;
  auto const one = identity<typename Field::Scalar>(field.motion({Direction::space, 0, 0}).group);
  std::vector<Motion> next(static_cast<std::size_t>(grid.nodes), one);
  Report worst;
  for (Index a = 0; a < grid.nodes; ++a) {
    if (grid.held(a)) continue;
    // What arrives: the last level has no edge ahead.
    auto momentum = field_equation(l, field, a, k);
    if (!impulses.empty()) momentum = momentum + impulses[static_cast<std::size_t>(a)];
    auto const action = detail::on_edge(l, {Direction::time, a, k});
    auto const where = [&] {
      return "step_in_time: node " + std::to_string(a) + ", level " + std::to_string(k);
    };
    try {
      auto const found = solve_on_group(momentum_equation_left(action, momentum),
                                        first ? one : Motion(field.motion({Direction::time, a, k - 1})));
      next[static_cast<std::size_t>(a)] = found.value;
      if (found.report.evaluations > worst.evaluations) worst = found.report;
    } catch (NotConverged const& failed) {
      throw NotConverged(where(), failed.residuals, failed.tolerance);
    } catch (NotFinite const&) {
      throw NotFinite(where());
    }
  }
  field.append(next, [](Motion const& g) { return restore(g); });  // products drift off the group
  if constexpr (requires { field.levels; })
    for (Index const a : {Index(0), grid.nodes - 1})
      if (grid.held(a)) field.levels.back()[a] = field(a, k);
  return worst;
}

}  // namespace actio
