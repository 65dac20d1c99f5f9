// Fields on a grid with values in a group, and Lagrangians of which they are solutions.
//
// As in sequences of configurations nothing is solved for: values are drawn, and the action of the edge in
// time after a node gets quadratic terms until the field equation holds at that node.
#pragma once

#include "actio/covariant_reduction/balances.hpp"
#include "models/pairs.hpp"

namespace actio::checks {

template <class S>
using Field = GroupField<SpannedGroup, S>;

/// An action for each edge: a base that is the same on all edges of a direction, and a polynomial of the
/// edge.
template <class S, class L>
struct EdgeActions {
  L base;                                             ///< (edge, relative motion) -> action
  std::vector<std::vector<GroupPolynomial<S>>> time;  ///< [level][node]; none where there is no correction
  template <class T>
  T operator()(GridEdge const& e, GroupElement<T> const& f) const {
    T sum = base(e, f);
    if (e.direction == Direction::time && e.level < static_cast<Index>(time.size()))
      for (Index i = 0; i < time[e.level][e.node].correction.size(); ++i) {
        auto const& p = time[e.level][e.node];
        sum += contract(p.phi[i], f.value) * contract(p.psi[i], f.value) * T(p.correction[i]);
      }
    return sum;
  }
};

/// Polynomials that are different on each edge.
template <class S>
struct UnevenActions {
  std::vector<GroupPolynomial<S>> each;
  Index nodes;
  template <class T>
  T operator()(GridEdge const& e, GroupElement<T> const& f) const {
    return each[2 * (e.level * nodes + e.node) + (e.direction == Direction::time ? 0 : 1)](f);
  }
};
template <class S>
UnevenActions<S> draw_uneven_actions(Draw& draw, SpannedGroup const& group, SpaceTimeGrid const& grid) {
  UnevenActions<S> l{{}, grid.nodes};
  for (Index i = 0; i < 2 * grid.nodes * grid.levels; ++i)
    l.each.push_back(draw_group_polynomial<S>(draw, group));
  return l;
}

/// A body with the masses of four points, and a rod of Cayley's strains: rational functions of the relative
/// motion in SE(3).
template <class S>
struct RodActions {
  S h, length;          ///< of a step and of an element
  Vector<S> stiffness;  ///< three for the shear and the stretch, three for bending and torsion
  Matrix<S> points;     ///< in the body, with a mass below each
  template <class T>
  T operator()(GridEdge const& e, GroupElement<T> const& f) const {
    // Forwards: (E, eps) is the inverse of f.
    Matrix<T> const E = f.value.topLeftCorner(3, 3).transpose();
    Vector<T> const eps = -(E * f.value.topRightCorner(3, 1));
    T sum(0);
    if (e.direction == Direction::time) {
      for (Index p = 0; p < points.cols(); ++p) {
        Vector<T> const x = points.col(p).head(3).template cast<T>(), way = E * x + eps - x;
        sum += way.dot(way) * T(points(3, p)) / T(S(2) * h);
      }
      return sum;
    }
    T const scale = T(2) / (T(1) + E(0, 0) + E(1, 1) + E(2, 2));
    Vector<T> const w = Vector<T>{{E(2, 1) - E(1, 2), E(0, 2) - E(2, 0), E(1, 0) - E(0, 1)}} * scale;
    Vector<T> const turned{
        {w[1] * eps[2] - w[2] * eps[1], w[2] * eps[0] - w[0] * eps[2], w[0] * eps[1] - w[1] * eps[0]}};
    for (int i = 0; i < 3; ++i) {
      T const gamma = (eps[i] - turned[i] / T(2)) / T(length) - T(i == 0 ? 1 : 0), kappa = w[i] / T(length);
      sum -=
          (gamma * gamma * T(stiffness[i]) + kappa * kappa * T(stiffness[3 + i])) * T(S(h * length / S(2)));
    }
    return sum;
  }
};
template <class S>
RodActions<S> draw_rod(Draw& draw) {
  RodActions<S> rod{ratio<S>(1, 16), ratio<S>(1, 4), draw.vector<S>(6) / S(2) + Vector<S>::Ones(6),
                    draw_matrix<S>(draw, 4, 4)};
  rod.points.row(3) = (rod.points.row(3).transpose() / S(2) + Vector<S>::Ones(4)).transpose() / S(4);
  return rod;
}
/// Rotors of Moser and Veselov in a row, whose axes turn each other: a spin chain, on SO(3).
template <class S>
struct SpinChain {
  Matrix<S> lambda;  ///< second moments of a rotor, over the step
  S coupling;        ///< energy x time
  template <class T>
  T operator()(GridEdge const& e, GroupElement<T> const& f) const {
    return e.direction == Direction::time ? -contract(lambda, f.value) : f.value(2, 2) * T(coupling);
  }
};
/// The sigma model, also called principal chiral: traces of relative motions.
template <class S>
struct SigmaModel {
  S in_time, in_space;
  template <class T>
  T operator()(GridEdge const& e, GroupElement<T> const& f) const {
    return f.value.trace() * T(e.direction == Direction::time ? S(-in_time) : in_space);
  }
};

/// A field of values near the identity.
template <class S>
Field<S> draw_field(Draw& draw, SpannedGroup const& group, Index nodes, Index levels,
                    std::array<End, 2> const& ends, std::type_identity_t<S> const& size = ratio<S>(1, 2)) {
  Field<S> g{{}, ends};
  for (Index k = 0; k < levels; ++k)
    g.levels.push_back(draw_points<S>(draw, group, static_cast<int>(nodes), size));
  return g;
}
/// Where the field equation has to hold.
inline std::vector<std::array<Index, 2>> inner_nodes(SpaceTimeGrid const& grid) {
  std::vector<std::array<Index, 2>> all;
  for (Index k = 1; k + 1 < grid.levels; ++k)
    for (Index a = 0; a < grid.nodes; ++a)
      if (!grid.held(a)) all.push_back({a, k});
  return all;
}
/// `base` with terms added to the actions in time until `g` is a solution.
template <class S, class L>
EdgeActions<S, L> with_solution(Draw& draw, L const& base, Field<S> const& g) {
  auto const& group = g(0, 0).group;
  int const d = group.dimension(), n = group.matrix_size(), terms = (exact_arithmetic<S>() ? 1 : 2) * d;
  EdgeActions<S, L> l{base, {}};
  l.time.assign(g.levels.size(), std::vector<GroupPolynomial<S>>(g.levels[0].size()));
  for (auto const& [a, k] : inner_nodes(g.grid())) {
    auto& p = l.time[k][a];
    for (int i = 0; i < 2 * d; ++i)
      p.phi.push_back(draw_matrix<S>(draw, n, n)), p.psi.push_back(draw_matrix<S>(draw, n, n));
    p.correction = Vector<S>::Zero(terms);
    Vector<S> const left = field_equation(l, g, a, k).components;
    Matrix<S> columns(d, terms);
    for (int i = 0; i < terms; ++i) {
      p.correction[i] = S(1);
      columns.col(i) = field_equation(l, g, a, k).components - left;
      p.correction[i] = S(0);
    }
    // As in with_motion_along: where numbers are rounded the least coefficients of twice as many terms.
    if (exact_arithmetic<S>()) {
      p.correction = -solve_linear(columns, left, "with_solution");
    } else {
      Matrix<S> const transposed = columns.transpose(), square = columns * transposed;
      for (int pass = 0; pass < 3; ++pass)
        p.correction -= transposed * solve_linear(square, Vector<S>(field_equation(l, g, a, k).components),
                                                  "with_solution");
    }
  }
  return l;
}
/// The solution \f$g_a^k = A^kB^a\f$ of every sigma model.
template <class S>
Field<S> product_solution(GroupElement<S> const& A, GroupElement<S> const& B, Index nodes, Index levels) {
  Field<S> g{{}, {End::held, End::held}};
  auto in_time = identity<S>(A.group);
  for (Index k = 0; k < levels; ++k, in_time = in_time * A) {
    g.levels.push_back({in_time});
    for (Index a = 1; a < nodes; ++a) g.levels.back().push_back(g.levels.back().back() * B);
  }
  return g;
}
/// A box of inner nodes.
inline NodeBox draw_node_box(Draw& draw, SpaceTimeGrid const& grid) {
  auto const below = [&](Index n) { return static_cast<Index>(draw.below(static_cast<std::uint64_t>(n))); };
  NodeBox box{};
  Index const low = grid.held(0) ? 1 : 0, room = grid.nodes - low - (grid.held(grid.nodes - 1) ? 1 : 0);
  box.nodes = 1 + below(room), box.levels = 1 + below(grid.levels - 2);
  box.first_node = grid.ring() ? below(grid.nodes) : low + below(room - box.nodes + 1);
  box.first_level = 1 + below(grid.levels - 1 - box.levels);
  return box;
}
template <class S>
FieldVariation<SpannedGroup, S> draw_variation(Draw& draw, Field<S> const& g, Index levels) {
  FieldVariation<SpannedGroup, S> V(levels);
  for (auto& level : V)
    for (Index a = 0; a < g.grid().nodes; ++a)
      level.push_back(g.grid().held(a) ? rest<S>(g(0, 0).group) : draw.template velocity<S>(g(0, 0).group));
  return V;
}
/// A first variation of a solution, from two levels that are drawn.
template <class S, class L>
FieldVariation<SpannedGroup, S> first_variation(Draw& draw, L const& l, Field<S> const& g) {
  auto V = draw_variation(draw, g, 2);
  while (V.size() < g.levels.size()) step_variation(l, g, V);
  return V;
}

}  // namespace actio::checks
