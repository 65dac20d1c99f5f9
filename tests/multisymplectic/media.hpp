// Media, meshes and discrete solutions that the tests of the generic implementation share.
#pragma once

#include "actio/continuum/materials.hpp"
#include "actio/multisymplectic/discrete_multisymplectic_form.hpp"
#include "actio/multisymplectic/discrete_noether.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"
#include "witness/draw.hpp"

namespace actio::testing {

/// A gas with \f$p\sim J^{-2}\f$ between Euclidean spaces, with a density of mass that varies.
template <class S, int n>
auto gas() {
  Matrix<S, n, 1> slope;
  for (int i = 0; i < n; ++i) slope[i] = ratio<S>(1, 3 + i);
  return Continuum{Euclidean<n>{}, Euclidean<n>{}, LinearDensity<S, n>{S(2), slope},
                   Barotropic{WholePolytropic<S, 1>{ratio<S>(3, 4)}}};
}
/// St Venant and Kirchhoff's solid.
template <class S, int n>
auto solid() {
  return Continuum{Euclidean<n>{}, Euclidean<n>{}, Homogeneous<S>{ratio<S>(3, 2)},
                   OfGreenTensor{StVenantKirchhoff<S>{ratio<S>(1, 2), ratio<S>(2, 3)}}};
}

/// A curved shape of the body: the unit cube, bent inside, its sides flat.
template <class S, int n>
auto bent_cube() {
  return [](Matrix<S, n, 1> const& u) {
    S bump(1);
    for (int i = 0; i < n; ++i) bump *= u[i] * (S(1) - u[i]);
    Matrix<S, n, 1> x = u;
    for (int i = 0; i < n; ++i) x[i] += bump * ratio<S>(i + 1, 3);
    return x;
  };
}

/// A field with components in (-1, 1) at every node of the first two levels.
template <class S, int N, int n>
media::DiscreteSection<S, n, N> drawn_start(media::SpaceTimeMesh<S, n> const& mesh, Draw& draw) {
  media::DiscreteSection<S, n, N> V;
  V.levels.resize(2);
  for (auto& level : V.levels)
    for (Index i = 0; i < mesh.node_count(); ++i) {
      level.push_back(mesh.fixed(i) ? Matrix<S, N, 1>(Matrix<S, N, 1>::Zero())
                                    : draw.template vector<S, Matrix<S, N, 1>>(N));
      for (int a = 0; a < N; ++a)
        if (mesh.held_across(i) >> a & 1) level.back()[a] = S(0);
    }
  return V;
}

/// The identity on the first two levels, disturbed at every node: a part of the mesh width away, with
/// velocities of about one that differ by an eighth.
template <class S, int n>
media::DiscreteSection<S, n, n> disturbed_identity(media::SpaceTimeMesh<S, n> const& mesh, Draw& draw) {
  auto section = media::restricted(
      mesh, []<class T>(Matrix<T, n + 1, 1> const& x) { return Matrix<T, n, 1>(x.template tail<n>()); }, 2);
  auto const away = drawn_start<S, n>(mesh, draw);
  S const width = ratio<S>(1, 16 * *std::max_element(mesh.cells().begin(), mesh.cells().end()));
  S const h = mesh.time(1) - mesh.time(0);
  auto const common = draw.template vector<S, Matrix<S, n, 1>>(n);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    if (mesh.fixed(i)) continue;
    section(0, i) += away(0, i) * width;
    Matrix<S, n, 1> velocity = common + away(1, i) * ratio<S>(1, 8);
    for (int a = 0; a < n; ++a)
      if (mesh.held_across(i) >> a & 1) velocity[a] = S(0);
    section(1, i) = section(0, i) + velocity * h;
  }
  return section;
}

/// A solution continued to the last level of the mesh.
template <class L, class S, int n, int N>
void run(L const& density, media::SpaceTimeMesh<Base<S>, n> const& mesh,
         media::DiscreteSection<S, n, N>& section) {
  while (section.last() + 1 < mesh.levels()) media::step(density, mesh, section);
}

/// A first variation of a solution: the derivative of the run along a change of its first two levels.
template <class L, class S, int n, int N>
media::DiscreteSection<S, n, N> first_variation(L const& density, media::SpaceTimeMesh<S, n> const& mesh,
                                                media::DiscreteSection<S, n, N> const& solution,
                                                media::DiscreteSection<S, n, N> const& start) {
  auto two_levels = solution;
  two_levels.levels.resize(2);
  auto moved = varied(two_levels, start);
  run(density, mesh, moved);
  return rate_of(moved);
}

/// A box of cells somewhere in a mesh, of any size.
template <class S, int n>
media::CellBox<n> drawn_box(media::SpaceTimeMesh<S, n> const& mesh, Draw& draw) {
  auto const below = [&](int count) {
    return static_cast<int>(draw.below(static_cast<std::uint64_t>(count)));
  };
  media::CellBox<n> box{};
  box.slabs = 1 + below(mesh.levels() - 1);
  box.first_slab = below(mesh.levels() - box.slabs);
  for (int i = 0; i < n; ++i) {
    int const all = mesh.cells()[i];
    box.cells[i] = 1 + below(all);
    box.first_cell[i] = mesh.periodic(i) ? below(all) : below(all - box.cells[i] + 1);
  }
  return box;
}

/// The turn of space in the plane of the first two axes, about the origin, with a shift of space.
template <class S, int N>
auto turning() {
  RigidMotion<S, N> field{Matrix<S, N, N>::Zero(), Matrix<S, N, 1>::Zero()};
  if constexpr (N > 1) field.turn(0, 1) = S(-1), field.turn(1, 0) = S(1);
  return motion_of_space<N>(field);
}
/// A shift of space along an axis.
template <class S, int N>
auto shifting(int axis) {
  RigidMotion<S, N> field{Matrix<S, N, N>::Zero(), Matrix<S, N, 1>::Unit(axis)};
  return motion_of_space<N>(field);
}
/// A growth of space from the origin, which is no isometry.
template <class S, int N>
auto growing() {
  return motion_of_space<N>([](auto const& y) { return std::remove_cvref_t<decltype(y)>(y); });
}

}  // namespace actio::testing
