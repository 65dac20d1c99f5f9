// Balances of a field with values in a group: the momentum and the multisymplectic form of its solutions,
// over the boundary of any box of nodes.
//
// Both are numbers of edges. An edge that leaves a box counts once, one that enters it counts negatively, and
// edges inside do not count.
#pragma once

#include "actio/covariant_reduction/field_equations.hpp"

namespace actio {

/// A box of nodes of a grid of space-time. On a ring it may go on past the last node.
struct NodeBox {
  Index first_node;   ///< a, in space
  Index nodes;        ///< how many in space
  Index first_level;  ///< k, in time
  Index levels;       ///< how many in time
};

/// A sum of differences, over the edges through a boundary or of one edge, and how large its terms are.
template <class Value, class B>
struct BoundarySum {
  Value sum;   ///< what leaves less what enters
  B terms{0};  ///< the sum of the magnitudes: what rounding is a part of
};

/// Refuses a box with a node at which the field equation does not hold: at the first or last level, or held.
/// @throws OutsideDomain  with the level or node
inline void require_box(SpaceTimeGrid const& grid, NodeBox const& box) {
  auto const refuse = [](char const* what, Index measured, Index bound) {
    throw OutsideDomain("box of nodes", what, static_cast<double>(measured), static_cast<double>(bound));
  };
  Index const last_level = box.first_level + box.levels - 1, last_node = box.first_node + box.nodes - 1;
  if (box.nodes < 1 || box.levels < 1)
    refuse("one node and one level at least are needed", std::min(box.nodes, box.levels), 1);
  if (box.first_level < 1) refuse("its first level must lie inside of the grid", box.first_level, 1);
  if (last_level > grid.levels - 2)
    refuse("its last level must lie inside of the grid", last_level, grid.levels - 2);
  if (box.nodes > grid.nodes) refuse("it has more nodes than the grid", box.nodes, grid.nodes);
  if (grid.ring()) return;
  if (box.first_node < 0) refuse("its first node must lie in the grid", box.first_node, 0);
  if (last_node >= grid.nodes) refuse("its last node must lie in the grid", last_node, grid.nodes - 1);
  if (grid.held(box.first_node)) refuse("a node that is held has no field equation; first node", 0, 1);
  if (grid.held(last_node))
    refuse("a node that is held has no field equation; last node", last_node, grid.nodes - 2);
}

/// Calls `visit(edge, leaves)` for each edge with one end in the box and the other outside.
template <class Visit>
void over_boundary(SpaceTimeGrid const& grid, NodeBox const& box, Visit const& visit) {
  auto const inside = [&](Index a, Index k) {
    Index const b = grid.ring() ? grid.wrapped(a - box.first_node) : a - box.first_node;
    return b >= 0 && b < box.nodes && k >= box.first_level && k < box.first_level + box.levels;
  };
  for (Index k = box.first_level; k < box.first_level + box.levels; ++k)
    for (Index a = box.first_node; a < box.first_node + box.nodes; ++a)
      grid.over_edges_at(a, k, [&](GridEdge const& e, bool leaves) {
        bool const in_time = e.direction == Direction::time;
        if (!(leaves ? inside(e.node + (in_time ? 0 : 1), e.level + (in_time ? 1 : 0))
                     : inside(e.node, e.level)))
          visit(e, leaves);
      });
}

/// The momentum that an edge carries, as space sees it: \f$\mu = -\mathrm{Ad}^*_{g^{-1}}L^*_f\ell'(f)\f$ with
/// g at its start. With \f$-R^*_f\ell'(f)\f$ and g at its end it is the same, since the action of the edge is
/// invariant. In time it is the momentum of a node, and in space what flows from a node to the next one in
/// one step.
///
/// @param motions  whose relative motions are taken: a RelativeField, or g itself
template <class L, class Motions, Group G, Scalar S>
Momentum<G, S> edge_momentum(L const& l, Motions const& motions, GroupField<G, S> const& g,
                             GridEdge const& edge) {
  return Ad_star(inverse(g(edge.node, edge.level)),
                 -left_differential(detail::on_edge(l, edge), motions.motion(edge)));
}

/// What leaves a box of nodes of the momentum in space, less what enters it. It is zero for every box where
/// the field solves the field equation at the nodes of the box.
///
/// \implements{bridge_covariant_noether}
/// @param motions  whose relative motions are taken: a RelativeField, or g itself. Where steps are short
///                 those of g are differences of near values: with a relative motion of the size
///                 \f$\vartheta\f$ rounding is \f$\epsilon/\vartheta\f$ of a momentum, and that of a
///                 RelativeField is not
/// @param g        the field
/// @throws OutsideDomain  where the box has nodes at which there is no field equation
template <class L, class Motions, Group G, Scalar S>
BoundarySum<Momentum<G, S>, Base<S>> noether_balance(L const& l, Motions const& motions,
                                                     GroupField<G, S> const& g, NodeBox const& box) {
  require_field(motions);
  require_field(g);
  require_box(g.grid(), box);
  auto const& group = g(0, 0).group;
  BoundarySum<Momentum<G, S>, Base<S>> balance{{group, Coordinates<G, S>::Zero(group.dimension())}};
  // [bridge_covariant_noether]
  over_boundary(g.grid(), box, [&](GridEdge const& edge, bool leaves) {
    auto const mu = edge_momentum(l, motions, g, edge);
    balance.sum = leaves ? balance.sum + mu : balance.sum - mu;
    balance.terms += magnitude(mu.components);
  });
  // [bridge_covariant_noether]
  return balance;
}

/// The same with the relative motions of the field itself.
template <class L, Group G, Scalar S>
BoundarySum<Momentum<G, S>, Base<S>> noether_balance(L const& l, GroupField<G, S> const& g,
                                                     NodeBox const& box) {
  return noether_balance(l, g, g, box);
}

/// A variation of a field, \f$\zeta_a^k = (g_a^k)^{-1}\delta g_a^k\f$: levels[k][a].
template <Group G, Scalar S>
using FieldVariation = std::vector<std::vector<Velocity<G, S>>>;

/// The multisymplectic form of an edge on two variations,
/// \f$\omega(V, W) = V_0\cdot MW_1 - W_0\cdot MV_1\f$, where 0 is its start, 1 its end and \f$M\f$ says how
/// \f$L^*_f\ell'(f)\f$ changes (\ref left_second_differential). It is the exterior derivative of the one-form
/// \f$\langle L^*_f\ell'(f),\zeta_0\rangle\f$, the discrete Lagrange form of the edge, and needs relative
/// motions alone.
///
/// @param field  a GroupField or a RelativeField
/// @return       the form, and the magnitudes of its two terms, which are much larger where a step is short
template <class L, class Field, Group G, Scalar S>
BoundarySum<S, Base<S>> edge_form(L const& l, Field const& field, GridEdge const& edge,
                                  FieldVariation<G, S> const& V, FieldVariation<G, S> const& W) {
  bool const in_time = edge.direction == Direction::time;
  auto const start = [&](auto const& U) { return U[edge.level][edge.node].coordinates; };
  auto const end = [&](auto const& U) {
    return U[edge.level + (in_time ? 1 : 0)][field.grid().wrapped(edge.node + (in_time ? 0 : 1))].coordinates;
  };
  // [covariant_form_of_edge]
  auto const M = left_second_differential(detail::on_edge(l, edge), field.motion(edge));
  S const first = start(V).dot(M * end(W)), second = start(W).dot(M * end(V));
  // [covariant_form_of_edge]
  return {first - second, magnitude(first) + magnitude(second)};
}

/// What leaves a box of nodes of the multisymplectic form, less what enters it. It is zero for every box
/// where the field solves the field equation at the nodes of the box, and V and W its linearisation.
///
/// \implements{bridge_covariant_form}
/// @throws OutsideDomain  where the box has nodes at which there is no field equation, or a variation is not
///                        one of this field
template <class L, class Field, Group G, Scalar S>
BoundarySum<S, Base<S>> form_balance(L const& l, Field const& field, FieldVariation<G, S> const& V,
                                     FieldVariation<G, S> const& W, NodeBox const& box) {
  require_field(field);
  for (auto const* variation : {&V, &W})
    detail::require_rows("form_balance: variation", *variation, field.grid().levels, field.grid().nodes);
  require_box(field.grid(), box);
  BoundarySum<S, Base<S>> balance{S(0)};
  // [bridge_covariant_form]
  over_boundary(field.grid(), box, [&](GridEdge const& edge, bool leaves) {
    auto const omega = edge_form(l, field, edge, V, W);
    balance.sum += leaves ? omega.sum : -omega.sum;
    balance.terms += omega.terms;
  });
  // [bridge_covariant_form]
  return balance;
}

namespace detail {
/// The relative motions of a field moved along a variation: \f$e^{-\epsilon\zeta_1}f\,e^{\epsilon\zeta_0}\f$.
/// A level behind the last one of the variation does not move.
template <class Field, Group G, Scalar S>
struct VariedField {
  Field const& field;             ///< a GroupField or a RelativeField
  FieldVariation<G, S> const& V;  ///< how it moves

  SpaceTimeGrid grid() const { return field.grid(); }
  Element<G, Dual<S>> step(Index a, Index k, S const& sign) const {
    auto const& group = V[0][0].group;
    Coordinates<G, Dual<S>> v = Coordinates<G, Dual<S>>::Zero(group.dimension());
    if (k < static_cast<Index>(V.size()))
      for (Index i = 0; i < v.size(); ++i) v[i].part[0] = V[k][grid().wrapped(a)].coordinates[i] * sign;
    return {group, primitive::near_identity(group, v)};
  }
  Element<G, Dual<S>> motion(GridEdge const& e) const {
    bool const in_time = e.direction == Direction::time;
    return step(e.node + (in_time ? 0 : 1), e.level + (in_time ? 1 : 0), S(-1)) *
           over<Dual<S>>(Element<G, S>(field.motion(e))) * step(e.node, e.level, S(1));
  }
};
}  // namespace detail

/// The change of the field equation at a node along a variation: its linearisation. Levels that the variation
/// does not have are at rest.
/// @return  a covector
template <class L, class Field, Group G, Scalar S>
Momentum<G, S> linearised_equation(L const& l, Field const& field, FieldVariation<G, S> const& V, Index a,
                                   Index k) {
  auto const changed = field_equation(l, detail::VariedField<Field, G, S>{field, V}, a, k);
  Momentum<G, S> rate{changed.group, Coordinates<G, S>::Zero(changed.components.size())};
  for (Index i = 0; i < rate.components.size(); ++i) rate.components[i] = changed.components[i].part[0];
  return rate;
}

/// Puts the next level behind the last one of a first variation of a solution: solves the linearised field
/// equation, exactly, at any scalar. Values that are held stay.
///
/// @param field  the solution, which has the level already
/// @param V      two levels or more
/// @throws OutsideDomain  where the variation has fewer than two levels, or no fewer than the field
/// @throws Singular       where the action of an edge in time is not regular
template <class L, class Field, Group G, Scalar S>
void step_variation(L const& l, Field const& field, FieldVariation<G, S>& V) {
  auto const grid = field.grid();
  Index const k = static_cast<Index>(V.size()) - 1;
  if (k < 1 || k + 2 > grid.levels)
    throw OutsideDomain("step_variation", "two levels at least are needed and fewer than the field has",
                        static_cast<double>(k + 1), static_cast<double>(k < 1 ? 2 : grid.levels - 1));
  detail::require_rows("step_variation: variation", V, k + 1, grid.nodes);
  std::vector<Velocity<G, S>> next;
  for (Index a = 0; a < grid.nodes; ++a) {
    GridEdge const ahead{Direction::time, a, k};
    auto const change = linearised_equation(l, field, V, a, k);
    next.push_back({change.group, Coordinates<G, S>::Zero(change.components.size())});
    // Its own end moves the edge ahead by -M.
    if (!grid.held(a))
      next.back().coordinates =
          solve_linear(left_second_differential(detail::on_edge(l, ahead), field.motion(ahead)),
                       change.components, "step_variation: second derivative of the action in time");
  }
  V.push_back(next);
}

}  // namespace actio
