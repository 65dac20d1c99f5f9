// Discrete fields on the meshes of the library for the checks of chapter 10: densities, solutions and first
// variations of them.
//
// Any section of a mesh solves the field equations of a density that is changed for it: to L is added c.v_0
// with a covector c for each node, which shifts leave as it is. So identities are tried with densities and
// values of the most general kind. Where the symmetry turns space, media are stepped instead.
#pragma once

#include "actio/multisymplectic/discrete_multisymplectic_form.hpp"
#include "actio/multisymplectic/discrete_noether.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"
#include "fields/fields.hpp"

namespace actio::checks {

/// A density L + c.v_0.
template <class L, class S, int n, int N>
struct Pulled {
  L density;
  std::vector<std::pair<Event<S, n>, Matrix<S, N, 1>>> pulls;  ///< c at the nodes, by their events

  template <class T>
  T operator()(Jet<T, n, N> const& j) const {
    T sum = density(j);
    for (auto const& [x, c] : pulls) {
      bool here = true;
      for (int mu = 0; mu <= n && here; ++mu) here = base_value(j.x[mu]) == x[mu];
      if (!here) continue;
      for (int a = 0; a < N; ++a) sum += j.v(a, 0) * T(c[a]);
      break;
    }
    return sum;
  }
};

/// A string in space: L = v_0^2/2 - w(C), which turns of space leave as it is.
template <class S>
struct SpaceString {
  Cubic<S, 1> w;
  template <class T, int n, int N>
  T operator()(Jet<T, n, N> const& j) const {
    Matrix<T, 1, 1> C;
    C[0] = j.v.col(1).dot(j.v.col(1));
    return j.v.col(0).dot(j.v.col(0)) / T(2) - w(C);
  }
};

/// A string whose events move with it: a section s -> (t, X, y) over a mesh of parameters, and a density of
/// the slopes of y in t and X times the area of (t, X). It depends on nothing else: shifts of time, of labels
/// and of space leave it as it is.
template <class S>
struct MovingEvents {
  Cubic<S, 2> l;
  template <class T>
  T operator()(Jet<T, 1, 3> const& j) const {
    auto const minor = [&](int a, int b) { return T(j.v(a, 0) * j.v(b, 1) - j.v(a, 1) * j.v(b, 0)); };
    T const area = minor(0, 1);
    Matrix<T, 2, 1> slopes;
    slopes[0] = minor(2, 1) / area, slopes[1] = minor(0, 2) / area;
    return area * l(slopes);
  }
};

/// A section on a mesh with slabs of different length, a density for which it is a solution, and what
/// is asked about them.
template <class S, int n, int N, class L>
struct DiscreteField {
  using Section = media::DiscreteSection<S, n, N>;
  media::SpaceTimeMesh<S, n> mesh;
  L density;
  Section section;
  S friction = S(0);  ///< E + friction (y_{k+1} - y_{k-1}): no variational principle has that

  int slabs() const { return mesh.levels() - 1; }
  bool moves(int level, Index node) const { return level > 0 && level < slabs() && !mesh.fixed(node); }

  /// The discrete Euler-Lagrange derivative with friction, over S or its duals.
  template <class T>
  Matrix<T, N, 1> equation(media::DiscreteSection<T, n, N> const& y, int level, Index node) const {
    Matrix<T, N, 1> E = discrete_euler_lagrange(density, mesh, y, level, node).sum;
    for (int a = 0; a < N; ++a) E[a] += (y(level + 1, node)[a] - y(level - 1, node)[a]) * T(friction);
    return E;
  }
  Section zero() const {
    Section V = section;
    for (auto& level : V.levels)
      for (auto& v : level) v.setZero();
    V.jump.setZero();
    return V;
  }
  /// A variation that vanishes at fixed nodes.
  Section draw_variation(Draw& draw) const {
    Section V = zero();
    for (auto& level : V.levels)
      for (Index i = 0; i < mesh.node_count(); ++i)
        if (!mesh.fixed(i)) level[i] = draw.vector<S, Matrix<S, N, 1>>(N);
    return V;
  }
  /// Two first variations with random values at the first and the last level: the linearised equations solved
  /// for the others.
  std::array<Section, 2> first_variations(Draw& draw) const {
    std::vector<std::pair<int, Index>> inside;
    for (int level = 1; level < slabs(); ++level)
      for (Index i = 0; i < mesh.node_count(); ++i)
        if (moves(level, i)) inside.push_back({level, i});
    int const unknowns = N * static_cast<int>(inside.size());
    auto const residual = [&](Section const& V) {
      auto const moved = varied(section, V);
      Matrix<S, Dynamic, 1> column(unknowns);
      for (int i = 0; i < unknowns; i += N) {
        auto const rate = rate_of(equation(moved, inside[i / N].first, inside[i / N].second));
        for (int a = 0; a < N; ++a) column[i + a] = rate[a];
      }
      return column;
    };
    Matrix<S, Dynamic, Dynamic> slope(unknowns, unknowns), right(unknowns, 2);
    for (int i = 0; i < unknowns; ++i) {
      auto unit = zero();
      unit(inside[i / N].first, inside[i / N].second)[i % N] = S(1);
      slope.col(i) = residual(unit);
    }
    std::array<Section, 2> V{draw_variation(draw), draw_variation(draw)};
    for (int k = 0; k < 2; ++k) {
      for (auto const& [level, i] : inside) V[k](level, i).setZero();
      right.col(k) = -residual(V[k]);
    }
    auto const inner = solve_linear(slope, right, "first_variations");
    for (int k = 0; k < 2; ++k)
      for (int i = 0; i < unknowns; ++i) V[k](inside[i / N].first, inside[i / N].second)[i % N] = inner(i, k);
    return V;
  }

  media::CellBox<n> whole() const { return {0, slabs(), {}, mesh.cells()}; }
  auto form_on(media::CellBox<n> const& box, std::array<Section, 2> const& V) const {
    return media::multisymplectic_balance(density, mesh, section, V[0], V[1], box);
  }
  auto momenta_on(media::CellBox<n> const& box, auto const& xi) const {
    return media::noether_balance(density, xi, mesh, section, box);
  }
  /// The form that the cells of a slab have at their later level.
  media::SumOfTerms<S, S> form_after(int slab, std::array<Section, 2> const& V) const {
    media::SumOfTerms<S, S> sum{S(0)};
    mesh.for_cells([&](media::GridIndex<n> const& cell) {
      for (int b = 0; b < mesh.corners; ++b)
        sum.add(media::discrete_multisymplectic_form(
            density, media::cell_of(mesh, section, slab, cell), media::node_of_corner<n>(b, 1),
            media::cell_of(mesh, V[0], slab, cell).y, media::cell_of(mesh, V[1], slab, cell).y));
    });
    return sum;
  }
};
/// Three slabs of different length, the first of a fifth of `scale`; two where numbers grow.
template <class S>
std::vector<S> levels_of(S const& scale) {
  std::vector<S> times{S(0), scale * ratio<S>(1, 5), scale * ratio<S>(1, 2), scale * ratio<S>(5, 6)};
  if (numbers_grow()) times.pop_back();
  return times;
}
template <class S, int n>
media::SpaceTimeMesh<S, n> mesh_with(std::vector<S> const& times, media::GridIndex<n> const& cells,
                                     media::Sides<n> const& sides) {
  // Cells of different shapes: the unit cube, bent inside; its sides stay where they are.
  return {times, cells, sides, [](Matrix<S, n, 1> const& u) {
            S bump = ratio<S>(1, 3);
            for (int i = 0; i < n; ++i) bump *= u[i] * (S(1) - u[i]);
            Matrix<S, n, 1> x = u;
            for (int i = 0; i < n; ++i) x[i] += bump;
            return x;
          }};
}

/// The pulls with which a section solves the equations of a density.
/// @param equation  what is left of them without: a callable on levels and nodes
template <int n, int N, class S, class Equation>
auto pulls_that_solve(media::SpaceTimeMesh<S, n> const& mesh, Equation const& equation) {
  // With the mass m of a node c adds m (c_{k-1} - c_{k+1})/2 to its equation at level k.
  std::vector<media::Level<S, N>> c(mesh.levels(),
                                    media::Level<S, N>(mesh.node_count(), Matrix<S, N, 1>::Zero()));
  for (int level = 1; level < mesh.levels() - 1; ++level)
    for (Index i = 0; i < mesh.node_count(); ++i) {
      if (mesh.fixed(i)) continue;
      S mass(0);
      mesh.for_cells_at(
          i, [&](media::GridIndex<n> const& cell, int b) { mass += mesh.geometry(cell).volume[b]; });
      Matrix<S, N, 1> const E = equation(level, i);
      for (int a = 0; a < N; ++a) c[level + 1][i][a] = c[level - 1][i][a] + E[a] * S(2) / mass;
    }
  std::vector<std::pair<Event<S, n>, Matrix<S, N, 1>>> pulls;
  for (int level = 0; level < mesh.levels(); ++level)
    mesh.for_cells([&](media::GridIndex<n> const& cell) {
      for (int b = 0; b < mesh.corners; ++b) {
        Event<S, n> x;
        x << mesh.time(level), mesh.geometry(cell).places.col(b);
        pulls.push_back({x, c[level][mesh.node(cell, b)]});
      }
    });
  return pulls;
}

/// A field with values drawn near those of the identity, where space has as many dimensions, and a density
/// pulled so that they solve its equations, with friction where there is some.
template <int n, int N, class S, class L>
DiscreteField<S, n, N, Pulled<L, S, n, N>> pulled_field(Draw& draw, L const& density,
                                                        media::GridIndex<n> const& cells,
                                                        media::Sides<n> const& sides,
                                                        S const& friction = S(0)) {
  using Field = DiscreteField<S, n, N, Pulled<L, S, n, N>>;
  Field field{mesh_with<S, n>(levels_of<S>(S(1)), cells, sides), {density, {}}, {}, friction};
  auto const& mesh = field.mesh;
  field.section.levels.resize(mesh.levels());
  for (int level = 0; level < mesh.levels(); ++level)
    for (Index i = 0; i < mesh.node_count(); ++i) {
      Matrix<S, N, 1> y = draw.vector<S, Matrix<S, N, 1>>(N) * ratio<S>(1, 8);
      auto const x = mesh.event(level, i);
      for (int a = 0; a < N && a <= n; ++a) y[a] += x[a];
      field.section.levels[level].push_back(y);
    }
  field.density.pulls = pulls_that_solve<n, N>(
      mesh, [&](int level, Index i) { return field.equation(field.section, level, i); });
  return field;
}

/// A medium stepped from places near those of the body and velocities that are drawn, in steps so short that
/// it does not fly apart.
template <int n, int N, class S, class L>
DiscreteField<S, n, N, L> stepped_field(Draw& draw, L const& density, media::GridIndex<n> const& cells) {
  auto const times = levels_of<S>(ratio<S>(1, 16));
  DiscreteField<S, n, N, L> field{
      mesh_with<S, n>(times, cells, media::all_sides<n>(media::Side::free)), density, {}};
  field.section.levels.resize(2);
  for (Index i = 0; i < field.mesh.node_count(); ++i) {
    Matrix<S, N, 1> y = draw.vector<S, Matrix<S, N, 1>>(N) * ratio<S>(1, 16);
    auto const X = field.mesh.place(i);
    for (int a = 0; a < n; ++a) y[a] += X[a];
    field.section.levels[0].push_back(y);
    field.section.levels[1].push_back(y + draw.vector<S, Matrix<S, N, 1>>(N) * times[1]);
  }
  while (field.section.last() < field.slabs()) media::step(field.density, field.mesh, field.section);
  return field;
}
/// First variations of a medium: the run repeated over dual numbers.
template <class S, int n, int N, class L>
std::array<media::DiscreteSection<S, n, N>, 2> stepped_variations(Draw& draw,
                                                                  DiscreteField<S, n, N, L> const& field) {
  std::array<media::DiscreteSection<S, n, N>, 2> V;
  for (auto& one : V) {
    auto start = field.section, change = field.draw_variation(draw);
    start.levels.resize(2), change.levels.resize(2);
    auto moved = varied(start, change);
    while (moved.last() < field.slabs()) media::step(field.density, field.mesh, moved);
    one = rate_of(moved);
  }
  return V;
}

/// A box of cells, by chance, with a node inside it where the mesh has one for it: from the first slab.
template <class S, int n>
media::CellBox<n> draw_cell_box(Draw& draw, media::SpaceTimeMesh<S, n> const& mesh) {
  media::CellBox<n> box{static_cast<int>(draw.below(mesh.levels() - 2)), 2, {}, mesh.cells()};
  for (int i = 0; i < n; ++i)
    if (mesh.cells()[i] > 1 && draw.below(2) == 0) {
      box.cells[i] = mesh.cells()[i] - 1;
      box.first_cell[i] = static_cast<int>(draw.below(2));
    }
  return box;
}

}  // namespace actio::checks
