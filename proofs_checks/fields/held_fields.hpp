// Discrete fields with multipliers on the meshes of the library, for the checks of the principle of chapters
// 7 and 8 on a mesh: solutions and first variations in which nothing is rounded.
//
// Values and multipliers are drawn, and the density is pulled so that they solve its equations; or the
// multipliers are drawn, and values stepped with them. The constraint has then whatever value the section
// gives it: the identities are about its slopes alone.
#pragma once

#include "actio/constraints_on_meshes/extended_balances.hpp"
#include "fields/discrete_fields.hpp"

namespace actio::checks {

/// At which levels a force of the multiplier is taken, counted from that of its node: the true scheme has
/// both at zero.
struct Taken {
  int slope = 0;       ///< of the slopes of the constraint
  int multiplier = 0;  ///< of the multiplier
};

/// An extended section on a mesh, and an augmented density for which it is a solution.
template <class S, int n, int N, class L, class Phi>
struct HeldField {
  static constexpr int k = Phi::components;
  using Section = media::DiscreteExtendedSection<S, n, N, k>;
  media::SpaceTimeMesh<S, n> mesh;
  AugmentedDensity<L, Phi> density;
  Section section;
  Taken taken;

  int slabs() const { return mesh.levels() - 1; }
  /// Half of the two slabs at a level.
  S half(int level) const { return (mesh.time(level + 1) - mesh.time(level - 1)) / S(2); }

  /// The force of the multipliers on a node, over S or its duals, from the slopes of the constraint.
  template <class T>
  Matrix<T, N, 1> reaction(media::DiscreteExtendedSection<T, n, N, k> const& y, int level, Index node) const {
    Matrix<T, N, 1> force = Matrix<T, N, 1>::Zero();
    int const at = level + taken.slope;
    mesh.for_cells_at(node, [&](media::GridIndex<n> const& cell, int b) {
      auto const here = cell_of(mesh, y.phi, at > 0 ? at - 1 : at, cell);
      auto const slope = constraint_slope(density.constraint, here, at > 0 ? 1 : 0, b);
      force += slope.transpose() * y.lambda[level + taken.multiplier][mesh.number(cell)] * T(half(level));
    });
    return force;
  }
  /// The field equation at a node: of the true scheme by the Cartan forms of the augmented density.
  template <class T>
  Matrix<T, N, 1> equation(media::DiscreteExtendedSection<T, n, N, k> const& y, int level, Index node) const {
    if (taken.slope == 0 && taken.multiplier == 0)
      return discrete_euler_lagrange(density, mesh, y, level, node).sum;
    return discrete_euler_lagrange(density.density, mesh, y.phi, level, node).sum + reaction(y, level, node);
  }
  template <class T>
  Matrix<T, k, 1> constraint(media::DiscreteExtendedSection<T, n, N, k> const& y, int level,
                             media::GridIndex<n> const& cell) const {
    int const slab = level > 0 ? level - 1 : 0;
    return constraint_of_cell(density.constraint, cell_of(mesh, y.phi, slab, cell), level > 0 ? 1 : 0);
  }

  Section zero() const {
    Section V = section;
    for (auto& level : V.phi.levels)
      for (auto& v : level) v.setZero();
    for (auto& level : V.lambda)
      for (auto& v : level) v.setZero();
    V.phi.jump.setZero();
    return V;
  }
  /// A variation of all values and multipliers.
  Section draw_variation(Draw& draw) const {
    Section V = zero();
    for (auto& level : V.phi.levels)
      for (Index i = 0; i < mesh.node_count(); ++i)
        if (!mesh.fixed(i)) level[i] = draw.vector<S, Matrix<S, N, 1>>(N);
    for (auto& level : V.lambda)
      for (auto& v : level) v = draw.vector<S, Matrix<S, k, 1>>(k);
    return V;
  }

  /// Unknown values at the nodes of a level, those of fixed nodes left out.
  std::vector<std::pair<Index, int>> components() const {
    std::vector<std::pair<Index, int>> all;
    for (Index i = 0; i < mesh.node_count(); ++i)
      for (int a = 0; !mesh.fixed(i) && a < N; ++a) all.push_back({i, a});
    return all;
  }
  /// The rates of all constraints at a level along a variation.
  Matrix<S, Dynamic, 1> rates(media::DiscreteExtendedSection<Dual<S>, n, N, k> const& moved,
                              int level) const {
    Matrix<S, Dynamic, 1> all(k * static_cast<int>(mesh.cell_count()));
    mesh.for_cells([&](media::GridIndex<n> const& cell) {
      all.template segment<k>(k * static_cast<int>(mesh.number(cell))) =
          rate_of(constraint(moved, level, cell));
    });
    return all;
  }
  /// Takes from a variation at a level what changes the constraints, along their slopes.
  void keep_constraint(Section& V, int level) const {
    auto const free = components();
    auto const rates_along = [&](Section const& W) { return rates(varied(section, W), level); };
    Matrix<S, Dynamic, Dynamic> G(k * static_cast<int>(mesh.cell_count()), static_cast<int>(free.size()));
    for (std::size_t c = 0; c < free.size(); ++c) {
      auto unit = zero();
      unit.phi(level, free[c].first)[free[c].second] = S(1);
      G.col(static_cast<int>(c)) = rates_along(unit);
    }
    Matrix<S, Dynamic, Dynamic> const square = G * G.transpose();
    Matrix<S, Dynamic, 1> const along = G.transpose() * solve_linear(square, rates_along(V), "rates");
    for (std::size_t c = 0; c < free.size(); ++c)
      V.phi(level, free[c].first)[free[c].second] -= along[static_cast<int>(c)];
  }

  /// Two first variations: drawn at the first and at the last level so that the constraint is kept there,
  /// with any change of the multipliers; at the inner levels the linearised equations and constraints are
  /// solved.
  /// @param keeps  false: the constraints are not kept, and the multipliers change as they are drawn
  std::array<Section, 2> first_variations(Draw& draw, bool keeps = true) const {
    auto const free = components();
    int const values = static_cast<int>(free.size()), cells = static_cast<int>(mesh.cell_count()),
              of_level = values + (keeps ? k * cells : 0), unknowns = of_level * (slabs() - 1);
    auto const residual = [&](Section const& V) {
      auto const moved = varied(section, V);
      Matrix<S, Dynamic, 1> column(unknowns);
      for (int level = 1; level < slabs(); ++level) {
        int const first = of_level * (level - 1);
        for (int c = 0; c < values; ++c)
          column[first + c] = rate_of(equation(moved, level, free[c].first))[free[c].second];
        if (keeps) column.segment(first + values, k * cells) = rates(moved, level);
      }
      return column;
    };
    auto const entry = [&](Section& V, int i) -> S& {
      int const level = i / of_level + 1, c = i % of_level;
      if (c < values) return V.phi(level, free[c].first)[free[c].second];
      return V.lambda[level][(c - values) / k][(c - values) % k];
    };
    Matrix<S, Dynamic, Dynamic> slope(unknowns, unknowns), right(unknowns, 2);
    for (int i = 0; i < unknowns; ++i) {
      auto unit = zero();
      entry(unit, i) = S(1);
      slope.col(i) = residual(unit);
    }
    std::array<Section, 2> V{draw_variation(draw), draw_variation(draw)};
    for (int m = 0; m < 2; ++m) {
      for (int i = 0; i < unknowns; ++i) entry(V[m], i) = S(0);
      for (int const level : {0, slabs()})
        if (keeps) keep_constraint(V[m], level);
      right.col(m) = -residual(V[m]);
    }
    auto const inner = solve_linear(slope, right, "first_variations");
    for (int m = 0; m < 2; ++m)
      for (int i = 0; i < unknowns; ++i) entry(V[m], i) = inner(i, m);
    return V;
  }

  media::CellBox<n> whole() const { return {0, slabs(), {}, mesh.cells()}; }
  auto form_on(media::CellBox<n> const& box, std::array<Section, 2> const& V) const {
    return multisymplectic_balance(density, mesh, section, V[0], V[1], box);
  }
  auto momenta_on(media::CellBox<n> const& box, auto const& xi) const {
    return noether_balance(density, xi, mesh, section, box);
  }
};

/// Values near those of the identity and multipliers, drawn at all levels.
template <class S, int n, int N, int k>
media::DiscreteExtendedSection<S, n, N, k> draw_extended(Draw& draw, media::SpaceTimeMesh<S, n> const& mesh,
                                                         S const& size) {
  media::DiscreteExtendedSection<S, n, N, k> y;
  y.phi.levels.resize(mesh.levels()), y.lambda.resize(mesh.levels());
  for (int level = 0; level < mesh.levels(); ++level) {
    for (Index i = 0; i < mesh.node_count(); ++i) {
      Matrix<S, N, 1> at = draw.vector<S, Matrix<S, N, 1>>(N) * size;
      auto const X = mesh.place(i);
      for (int a = 0; a < N && a < n; ++a) at[a] += X[a];
      y.phi.levels[level].push_back(at);
    }
    for (Index K = 0; K < mesh.cell_count(); ++K)
      y.lambda[level].push_back(draw.vector<S, Matrix<S, k, 1>>(k));
  }
  return y;
}

/// A field with drawn values and multipliers, and a density pulled so that they solve its equations.
template <int n, int N, class S, class L, class Phi>
HeldField<S, n, N, Pulled<L, S, n, N>, Phi> pulled_held_field(Draw& draw, L const& density, Phi const& Phi_,
                                                              media::GridIndex<n> const& cells,
                                                              media::Sides<n> const& sides,
                                                              Taken const& taken = {}) {
  auto const mesh = mesh_with<S, n>(levels_of<S>(S(1)), cells, sides);
  auto const section = draw_extended<S, n, N, Phi::components>(draw, mesh, ratio<S>(1, 16));
  HeldField<S, n, N, Pulled<L, S, n, N>, Phi> field{
      mesh, {Pulled<L, S, n, N>{density, {}}, Phi_}, section, taken};
  field.density.density.pulls =
      pulls_that_solve<n, N>(mesh, [&](int level, Index i) { return field.equation(section, level, i); });
  return field;
}

/// A medium stepped from drawn values with drawn multipliers: its equations are linear in the next level.
template <int n, int N, class S, class L, class Phi>
HeldField<S, n, N, L, Phi> stepped_held_field(Draw& draw, L const& density, Phi const& Phi_,
                                              media::GridIndex<n> const& cells, Taken const& taken = {}) {
  auto const mesh =
      mesh_with<S, n>(levels_of<S>(ratio<S>(1, 16)), cells, media::all_sides<n>(media::Side::free));
  HeldField<S, n, N, L, Phi> field{
      mesh, {density, Phi_}, draw_extended<S, n, N, Phi::components>(draw, mesh, ratio<S>(1, 16)), taken};
  auto& y = field.section.phi;
  for (Index i = 0; i < mesh.node_count(); ++i)
    y(1, i) = y(0, i) + draw.vector<S, Matrix<S, N, 1>>(N) * mesh.time(1);
  auto const free = field.components();
  int const unknowns = static_cast<int>(free.size());
  for (int level = 1; level < field.slabs(); ++level) {
    for (Index i = 0; i < mesh.node_count(); ++i) y(level + 1, i) = y(level, i);
    auto const residual = [&](auto const& section) {
      using T = std::remove_cvref_t<decltype(section.phi(0, 0)[0])>;
      Matrix<T, Dynamic, 1> column(unknowns);
      for (int c = 0; c < unknowns; ++c)
        column[c] = field.equation(section, level, free[c].first)[free[c].second];
      return column;
    };
    Matrix<S, Dynamic, Dynamic> slope(unknowns, unknowns);
    for (int c = 0; c < unknowns; ++c) {
      auto unit = field.zero();
      unit.phi(level + 1, free[c].first)[free[c].second] = S(1);
      slope.col(c) = rate_of(residual(varied(field.section, unit)));
    }
    Matrix<S, Dynamic, 1> const change = solve_linear(slope, residual(field.section), "stepped_held_field");
    for (int c = 0; c < unknowns; ++c) y(level + 1, free[c].first)[free[c].second] -= change[c];
  }
  return field;
}

}  // namespace actio::checks
