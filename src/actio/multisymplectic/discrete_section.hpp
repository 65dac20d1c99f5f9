// Discrete sections: values at the nodes of a mesh of space-time, level by level (chapter 10 of the thesis).
#pragma once

#include "actio/multisymplectic/discrete_jet.hpp"
#include "actio/multisymplectic/space_time_mesh.hpp"

namespace actio::media {

/// The values of a section at the nodes of one level of time: a vector of points of space, one for each node,
/// in the order of the mesh.
template <class S, int N>
using Level = std::vector<Matrix<S, N, 1>>;

/// A section restricted to the nodes of a mesh.
///
/// It has as many levels as it has been continued to, the mesh may have more. Across the seam of a
/// periodic direction values go on with a jump: by the period of the placement for a body that fills space
/// periodically, and by nothing for a field that is periodic itself, or on a closed ring.
template <class S, int n, int N>
struct DiscreteSection {
  std::vector<Level<S, N>> levels;  ///< values, for each level and node
  Matrix<Base<S>, N, n> jump =
      Matrix<Base<S>, N, n>::Zero();  ///< across each seam, a column for each direction

  /// The value at a node.
  Matrix<S, N, 1> const& operator()(int level, Index node) const { return levels[level][node]; }
  /// The value at a node.
  Matrix<S, N, 1>& operator()(int level, Index node) { return levels[level][node]; }
  /// The last level.
  int last() const { return static_cast<int>(levels.size()) - 1; }
  /// The same section over a scalar that extends S.
  template <class T>
  DiscreteSection<T, n, N> cast() const {
    DiscreteSection<T, n, N> section{{}, jump};
    for (auto const& level : levels) {
      section.levels.emplace_back();
      for (auto const& y : level) section.levels.back().push_back(y.template cast<T>());
    }
    return section;
  }
};

/// Refuses a section that is none of a mesh: other numbers of values than nodes, more levels.
/// @throws NotAMesh
template <class S, int n, int N>
void require_section(SpaceTimeMesh<Base<S>, n> const& mesh, DiscreteSection<S, n, N> const& section) {
  if (section.last() >= mesh.levels())
    throw NotAMesh("discrete section", "its levels are among those of the mesh; levels", section.last() + 1,
                   mesh.levels());
  for (auto const& level : section.levels)
    if (static_cast<Index>(level.size()) != mesh.node_count())
      throw NotAMesh("discrete section", "it has a value at each node of a level; values",
                     double(level.size()), double(mesh.node_count()));
}

/// Refuses a slab that a section does not have.
/// @throws NotAMesh
template <class S, int n, int N>
void require_slab(SpaceTimeMesh<Base<S>, n> const& mesh, DiscreteSection<S, n, N> const& section, int slab) {
  require_section(mesh, section);
  if (slab < 0 || slab >= section.last())
    throw NotAMesh("discrete section", "a slab lies between two of its levels; slab", slab,
                   section.last() - 1);
}

/// The space-time cell over a cell of the body, between level `slab` and the next, with the values of a
/// section.
template <class S, int n, int N>
SpaceTimeCell<S, n, N> cell_of(SpaceTimeMesh<Base<S>, n> const& mesh, DiscreteSection<S, n, N> const& section,
                               int slab, GridIndex<n> const& cell) {
  SpaceTimeCell<S, n, N> here{&mesh.geometry(cell), {mesh.time(slab), mesh.time(slab + 1)}, {}};
  for (int b = 0; b < here.corners; ++b) {
    Index const node = mesh.node(cell, b);
    for (int level = 0; level < 2; ++level) {
      Matrix<S, N, 1> y = section(slab + level, node);
      for (int i = 0; i < n; ++i)
        if (mesh.beyond_seam(cell, b, i))
          for (int a = 0; a < N; ++a) y[a] += section.jump(a, i);
      here.y.col(node_of_corner<n>(b, level)) = y;
    }
  }
  return here;
}

/// A section restricted to the first levels of a mesh.
///
/// @param phi     section: a callable from points of space-time to points of space
/// @param levels  how many
/// @throws NotFinite  where phi is no number at a node
template <class S, int n, class Phi>
  requires SectionOver<Phi, S, n>
auto restricted(SpaceTimeMesh<S, n> const& mesh, Phi const& phi, int levels) {
  constexpr int N = actio::detail::fibre_dimension<Phi, S, n>;
  DiscreteSection<S, n, N> section;
  for (int k = 0; k < levels; ++k) {
    section.levels.emplace_back();
    for (Index node = 0; node < mesh.node_count(); ++node) {
      section.levels.back().push_back(phi(mesh.event(k, node)));
      require_finite(section(k, node), "restriction of a section");
    }
  }
  // What the section gains from one copy of a seam to the other.
  for (int i = 0; i < n; ++i)
    if (mesh.periodic(i)) {
      GridIndex<n> near{}, far{};
      far[i] = mesh.cells()[i] - 1;
      Event<S, n> start, end;
      start << mesh.time(0), mesh.geometry(near).places.col(0);
      end << mesh.time(0), mesh.geometry(far).places.col(1 << i);
      section.jump.col(i) = phi(end) - phi(start);
    }
  return section;
}

/// The section \f$\phi + \epsilon V\f$ to first order in \f$\epsilon\f$.
/// @param V  vertical variation, as a discrete section; its levels are those of the section
template <class S, int n, int N>
DiscreteSection<Dual<S>, n, N> varied(DiscreteSection<S, n, N> const& section,
                                      DiscreteSection<S, n, N> const& V) {
  DiscreteSection<Dual<S>, n, N> moved{{}, section.jump};
  for (std::size_t k = 0; k < section.levels.size(); ++k) {
    moved.levels.emplace_back();
    for (std::size_t i = 0; i < section.levels[k].size(); ++i)
      moved.levels[k].push_back(moved_along(section.levels[k][i], V.levels[k][i]));
  }
  return moved;
}

/// The variation V of a section \f$\phi + \epsilon V\f$.
template <class S, int n, int N>
DiscreteSection<S, n, N> rate_of(DiscreteSection<Dual<S>, n, N> const& moved) {
  DiscreteSection<S, n, N> V;
  for (auto const& level : moved.levels) {
    V.levels.emplace_back();
    for (auto const& y : level) V.levels.back().push_back(rate_of(y));
  }
  return V;
}

}  // namespace actio::media
