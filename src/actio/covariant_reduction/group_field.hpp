// Fields on a grid of space-time with values in a group, their relative motions, and the way back.
//
// A node has a number a in space, 0 to n - 1 along a line or round a ring, and a number k in time. An edge
// leads from a node to the next one, in time or in space, and carries the relative motion of its ends in the
// convention of (3.11): the later configuration inverted, times the earlier one.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "actio/reduction/relative_motion.hpp"

namespace actio {

/// In which of the two directions an edge of a grid of space-time leads.
enum class Direction {
  time,  ///< from a level to the next
  space  ///< from a node of a level to the next
};

/// What an end of a line is. A ring has neither end: both are `joined`.
enum class End {
  free,   ///< the field equation holds there, with the terms of the edges that there are
  held,   ///< the values are given
  joined  ///< the next node is the first one of the line
};

/// An edge of a grid of space-time, by the node at which it starts.
struct GridEdge {
  Direction direction;  ///< from level to level or along the line
  Index node;           ///< a, in space
  Index level;          ///< k, in time
};

/// A grid of space-time: a line or a ring of nodes, at several levels of time.
struct SpaceTimeGrid {
  Index nodes;                                    ///< how many there are in space
  Index levels;                                   ///< and in time
  std::array<End, 2> ends{End::free, End::free};  ///< of the line: the first and the last one

  /// Whether the line is a ring.
  bool ring() const { return ends[0] == End::joined; }
  /// The number of a node of a ring, counted on past its last one; of a line as it is.
  Index wrapped(Index node) const { return ring() ? (node % nodes + nodes) % nodes : node; }
  /// Whether the values at a node are given at all levels.
  bool held(Index node) const {
    return (node == 0 && ends[0] == End::held) || (node == nodes - 1 && ends[1] == End::held);
  }
  /// Whether the grid has this edge, by the number of its first node; `node` may be -1 or, on a ring, any.
  bool has(GridEdge const& e) const {
    bool const in_time = e.direction == Direction::time;
    return e.level >= 0 && e.level < levels - (in_time ? 1 : 0) &&
           (ring() || (e.node >= 0 && e.node < nodes - (in_time ? 0 : 1)));
  }
  /// Calls `visit(edge, leaves)` for each edge at a node, in a fixed order: those that arrive (`leaves` is
  /// false) and those that leave.
  template <class Visit>
  void over_edges_at(Index node, Index level, Visit const& visit) const {
    auto const one = [&](Direction direction, Index a, Index k, bool leaves) {
      if (GridEdge const e{direction, wrapped(a), k}; has(e)) visit(e, leaves);
    };
    one(Direction::time, node, level - 1, false), one(Direction::time, node, level, true);
    one(Direction::space, node - 1, level, false), one(Direction::space, node, level, true);
  }
};

/// Refuses a grid with fewer than two nodes, or one with one joined end only.
/// @throws OutsideDomain  with the number of nodes, or of joined ends
inline void require_grid(SpaceTimeGrid const& grid) {
  if (grid.nodes < 2)
    throw OutsideDomain("field on a grid", "a line needs two nodes", static_cast<double>(grid.nodes), 2);
  if ((grid.ends[0] == End::joined) != (grid.ends[1] == End::joined))
    throw OutsideDomain("field on a grid", "a ring has both ends joined, and a line none; joined ends", 1, 2);
}

/// A field with values in a group: \f$g_a^k\f$, for each level k the values at the nodes a. A function of
/// edges too, its relative motions.
///
/// \snippet covariant_reduction.cpp chiral_field
template <Group G, Scalar S>
struct GroupField {
  using GroupType = G;
  using Scalar = S;
  std::vector<std::vector<Element<G, S>>> levels;  ///< \f$g_a^k\f$ is levels[k][a]
  std::array<End, 2> ends{End::free, End::free};   ///< of the line

  /// The grid on which the field is given.
  SpaceTimeGrid grid() const {
    return {levels.empty() ? 0 : static_cast<Index>(levels[0].size()), static_cast<Index>(levels.size()),
            ends};
  }
  /// \f$g_a^k\f$; on a ring any a.
  Element<G, S> const& operator()(Index a, Index k) const {
    return levels[static_cast<std::size_t>(k)][static_cast<std::size_t>(grid().wrapped(a))];
  }
  /// The relative motion of an edge: \f$f_a^k = (g_a^{k+1})^{-1}g_a^k\f$ in time, \f$e_a^k =
  /// (g_{a+1}^k)^{-1}g_a^k\f$ in space.
  Element<G, S> motion(GridEdge const& e) const {
    bool const in_time = e.direction == Direction::time;
    return relative_motion_left((*this)(e.node, e.level),
                                (*this)(e.node + (in_time ? 0 : 1), e.level + (in_time ? 1 : 0)));
  }
  /// Puts a level behind the last one, by the relative motions that lead to it.
  /// @param finish  what is done to each new element; nothing, or \ref restore
  template <class Finish = std::identity>
  void append(std::vector<Element<G, S>> const& f, Finish const& finish = {}) {
    levels.push_back(levels.back());
    for (std::size_t a = 0; a < f.size(); ++a)
      levels.back()[a] = finish(reconstruct_left(levels.back()[a], f[a]));
  }
};

/// The relative motions of a field, without the field: the reduced field.
template <Group G, Scalar S>
struct RelativeField {
  using GroupType = G;
  using Scalar = S;
  std::vector<std::vector<Element<G, S>>> time;   ///< \f$f_a^k\f$ is time[k][a]
  std::vector<std::vector<Element<G, S>>> space;  ///< \f$e_a^k\f$ is space[k][a]
  std::array<End, 2> ends{End::free, End::free};  ///< of the line

  /// The grid whose edges these are.
  SpaceTimeGrid grid() const {
    Index const edges = space.empty() ? 0 : static_cast<Index>(space[0].size());
    return {edges + (ends[0] == End::joined ? 0 : 1), static_cast<Index>(space.size()), ends};
  }
  /// The relative motion of an edge.
  Element<G, S> const& motion(GridEdge const& e) const {
    auto const& row = (e.direction == Direction::time ? time : space)[static_cast<std::size_t>(e.level)];
    return row[static_cast<std::size_t>(grid().wrapped(e.node))];
  }
  /// Puts a level behind the last one; the cells between are flat: \f$e_a^{k+1} =
  /// f_{a+1}^k\,e_a^k\,(f_a^k)^{-1}\f$.
  /// @param finish  what is done to each new element; nothing, or \ref restore
  template <class Finish = std::identity>
  void append(std::vector<Element<G, S>> const& f, Finish const& finish = {}) {
    time.push_back(f), space.push_back(space.back());
    auto& e = space.back();
    for (std::size_t a = 0; a < e.size(); ++a) e[a] = finish(f[(a + 1) % f.size()] * e[a] * inverse(f[a]));
  }
};

namespace detail {
/// Refuses a table that has not this many rows, or a row that has not this many entries.
template <class Table>
void require_rows(char const* where, Table const& table, Index rows, Index each) {
  auto const number = [](auto x) { return static_cast<double>(x); };
  if (static_cast<Index>(table.size()) != rows)
    throw OutsideDomain(where, "levels that are needed", number(table.size()), number(rows));
  for (auto const& row : table)
    if (static_cast<Index>(row.size()) != each)
      throw OutsideDomain(where, "entries that each level needs", number(row.size()), number(each));
}
}  // namespace detail

/// Refuses what is no field on a grid: too few nodes, one joined end, levels of different length.
/// @throws OutsideDomain  with the number that is wrong
template <Group G, Scalar S>
void require_field(GroupField<G, S> const& g) {
  require_grid(g.grid());
  detail::require_rows("field on a grid", g.levels, g.grid().levels, g.grid().nodes);
}
/// The same for relative motions, in time and in space.
template <Group G, Scalar S>
void require_field(RelativeField<G, S> const& reduced) {
  auto const grid = reduced.grid();
  require_grid(grid);
  detail::require_rows("relative motions in time", reduced.time, grid.levels - 1, grid.nodes);
  detail::require_rows("relative motions in space", reduced.space, grid.levels,
                       static_cast<Index>(reduced.space[0].size()));
}

/// The relative motions of a field: the quotient by the multiplications \f$g\mapsto hg\f$ of all its values.
/// @throws OutsideDomain  where this is no field (\ref require_field)
template <Group G, Scalar S>
RelativeField<G, S> relative_motions(GroupField<G, S> const& g) {
  require_field(g);
  auto const grid = g.grid();
  RelativeField<G, S> reduced{{}, {}, g.ends};
  for (Index k = 0; k < grid.levels; ++k) {
    reduced.space.emplace_back();
    if (k + 1 < grid.levels) reduced.time.emplace_back();
    for (Index a = 0; a < grid.nodes; ++a)
      for (auto const direction : {Direction::time, Direction::space})
        if (GridEdge const e{direction, a, k}; grid.has(e))
          (direction == Direction::time ? reduced.time : reduced.space).back().push_back(g.motion(e));
  }
  return reduced;
}

/// The curvature of the cell between the nodes a and a + 1 and the levels k and k + 1: the product of the
/// relative motions round it, \f$(f_{a+1}^ke_a^k)^{-1}\,e_a^{k+1}f_a^k\f$. Those of a field give the
/// identity.
template <class Field>
auto curvature(Field const& field, Index a, Index k) {
  // [covariant_flatness]
  auto const f = [&](Index b) { return field.motion({Direction::time, b, k}); };
  auto const e = [&](Index j) { return field.motion({Direction::space, a, j}); };
  return inverse(f(a + 1) * e(k)) * (e(k + 1) * f(a));
  // [covariant_flatness]
}

/// One move along an edge: which edge, and whether from its start to its end.
struct GridMove {
  Direction direction;  ///< of the edge
  bool forward;         ///< to the later level or the next node, not back
};

/// The value at the end of a path through the grid that starts at the node `a` of the level `k` with the
/// value `g`. Where all cells are flat it is the same for all paths between two nodes that do not go round a
/// ring.
///
/// @param path  the moves, each from where the last one led to
/// @throws OutsideDomain  where a move leaves the grid, with the number of moves before it
template <class Field, Group G, Scalar S>
Element<G, S> reconstruct_along(Field const& field, Index a, Index k, Element<G, S> g,
                                std::vector<GridMove> const& path) {
  auto const grid = field.grid();
  for (std::size_t i = 0; i < path.size(); ++i) {
    Index& at = path[i].direction == Direction::time ? k : a;
    if (!path[i].forward) --at;
    GridEdge const edge{path[i].direction, a, k};
    if (!grid.has(edge))
      throw OutsideDomain("reconstruct_along", "a move of the path has no edge of the grid; moves before it",
                          static_cast<double>(i), static_cast<double>(path.size()));
    g = path[i].forward ? reconstruct_left(g, field.motion(edge)) : g * field.motion(edge);
    if (path[i].forward) ++at;
  }
  return g;
}

/// The field with these relative motions and the value `g` at the first node of the first level: along the
/// first level, and from there in time.
template <Group G, Scalar S>
GroupField<G, S> reconstruct(RelativeField<G, S> const& reduced, Element<G, S> const& g) {
  require_field(reduced);
  GroupField<G, S> field{{}, reduced.ends};
  field.levels.push_back({g});
  for (Index a = 0; a + 1 < reduced.grid().nodes; ++a)
    field.levels[0].push_back(
        reconstruct_left(field.levels[0].back(), reduced.motion({Direction::space, a, 0})));
  for (auto const& f : reduced.time) field.append(f);
  return field;
}

/// The same field with space and time exchanged, on an open line: \f$g_k^a\f$. What steps in time steps then
/// in space.
/// @param ends  what the first and the last level of time are
/// @throws OutsideDomain  where this is no field, or one on a ring
template <Group G, Scalar S>
GroupField<G, S> transposed(GroupField<G, S> const& g, std::array<End, 2> ends) {
  require_field(g);
  if (g.grid().ring()) throw OutsideDomain("transposed", "an open line is needed; joined ends", 2, 0);
  GroupField<G, S> other{{}, ends};
  other.levels.resize(static_cast<std::size_t>(g.grid().nodes));
  for (auto const& level : g.levels)
    for (std::size_t a = 0; a < level.size(); ++a) other.levels[a].push_back(level[a]);
  return other;
}

}  // namespace actio
