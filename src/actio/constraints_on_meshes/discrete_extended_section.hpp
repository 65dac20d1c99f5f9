// Discrete sections of the extended bundle: values at the nodes of each level of a mesh, and multipliers for
// each of its cells and levels (chapters 7, 8 and 10 of the thesis).
//
// A constraint of chapter 7 that contains no velocity is a condition on the values of one level. In a cell it
// is integrated by the trapezoidal rule of the discrete Lagrangian, and that sum has one multiplier. So a
// space-time cell of the extended bundle is one with N + k components at its nodes, of which the last k are
// the same at all corners of a level; what chapter 10 does with a density it does with the augmented one.
#pragma once

#include "actio/constraints/augmented.hpp"
#include "actio/multisymplectic/discrete_section.hpp"

namespace actio::media {

/// A discrete section \f$(y, \lambda)\f$ of the extended bundle.
///
/// The multiplier of the last level belongs to no equation yet: the step to the next level determines it.
/// @tparam k  how many multipliers a cell has
template <class S, int n, int N, int k>
struct DiscreteExtendedSection {
  DiscreteSection<S, n, N> phi;     ///< values at the nodes
  std::vector<Level<S, k>> lambda;  ///< multipliers, for each level and cell, in the order of the mesh

  /// The last level.
  int last() const { return phi.last(); }
};

/// A discrete section with multipliers that are zero.
/// @tparam k  how many multipliers a cell has
template <int k, class S, int n, int N>
DiscreteExtendedSection<S, n, N, k> without_reactions(SpaceTimeMesh<Base<S>, n> const& mesh,
                                                      DiscreteSection<S, n, N> const& phi) {
  Level<S, k> const none(static_cast<std::size_t>(mesh.cell_count()), Matrix<S, k, 1>::Zero());
  return {phi, std::vector<Level<S, k>>(phi.levels.size(), none)};
}

/// Refuses an extended section that is none of a mesh: other numbers of values than nodes, or of multipliers
/// than cells.
/// @throws NotAMesh
template <class S, int n, int N, int k>
void require_section(SpaceTimeMesh<Base<S>, n> const& mesh,
                     DiscreteExtendedSection<S, n, N, k> const& section) {
  require_section(mesh, section.phi);
  if (section.lambda.size() != section.phi.levels.size())
    throw NotAMesh("discrete extended section", "each level of values has one of multipliers; levels",
                   double(section.lambda.size()), double(section.phi.levels.size()));
  for (auto const& level : section.lambda)
    if (static_cast<Index>(level.size()) != mesh.cell_count())
      throw NotAMesh("discrete extended section", "each cell of a level has its multipliers; cells",
                     double(level.size()), double(mesh.cell_count()));
}

/// The space-time cell over a cell of the body with the values of an extended section: N components of the
/// value at each node, and below them the k multipliers that the cell has at that level.
template <class S, int n, int N, int k>
SpaceTimeCell<S, n, N + k> cell_of(SpaceTimeMesh<Base<S>, n> const& mesh,
                                   DiscreteExtendedSection<S, n, N, k> const& section, int slab,
                                   GridIndex<n> const& cell) {
  auto const below = cell_of(mesh, section.phi, slab, cell);
  auto const number = static_cast<std::size_t>(mesh.number(cell));
  Matrix<S, N + k, SpaceTimeCell<S, n, N>::nodes> y;
  for (int l = 0; l < below.nodes; ++l)
    y.col(l) << below.y.col(l), section.lambda[slab + l / below.corners][number];
  return below.with(y);
}

/// The values of a space-time cell of the extended bundle, without its multipliers.
template <int N, class S, int n, int M>
SpaceTimeCell<S, n, N> configuration(SpaceTimeCell<S, n, M> const& cell) {
  static_assert(N < M, "a cell of the extended bundle has the multipliers as its last components");
  return cell.with(Matrix<S, N, SpaceTimeCell<S, n, M>::nodes>(cell.y.template topRows<N>()));
}

/// The extended section \f$(y + \epsilon V,\ \lambda + \epsilon\mu)\f$ to first order in \f$\epsilon\f$.
/// @param V  variation of values and multipliers, as an extended section; its levels are those of the section
template <class S, int n, int N, int k>
DiscreteExtendedSection<Dual<S>, n, N, k> varied(DiscreteExtendedSection<S, n, N, k> const& section,
                                                 DiscreteExtendedSection<S, n, N, k> const& V) {
  // Multipliers at the cells of a level and values at its nodes are varied alike.
  auto const multipliers =
      varied(DiscreteSection<S, n, k>{section.lambda}, DiscreteSection<S, n, k>{V.lambda});
  return {varied(section.phi, V.phi), multipliers.levels};
}

/// The variation of an extended section \f$(y + \epsilon V,\ \lambda + \epsilon\mu)\f$.
template <class S, int n, int N, int k>
DiscreteExtendedSection<S, n, N, k> rate_of(DiscreteExtendedSection<Dual<S>, n, N, k> const& moved) {
  return {rate_of(moved.phi), rate_of(DiscreteSection<Dual<S>, n, k>{moved.lambda}).levels};
}

}  // namespace actio::media
