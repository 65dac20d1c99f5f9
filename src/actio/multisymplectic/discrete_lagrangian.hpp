// The discrete Lagrangian of a density on a space-time cell (chapter 10 of the thesis).
//
// A discrete Lagrangian is an action: the integral of the density over the cell, by the trapezoidal rule at
// the cell's nodes. Every density of jets/ has one.
#pragma once

#include "actio/multisymplectic/discrete_section.hpp"

namespace actio::media {

/// What one node contributes to the discrete Lagrangian of a cell: the density at the discrete jet there,
/// times the volume that the node stands for.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
S action_at_node(L const& density, SpaceTimeCell<S, n, N> const& cell, int l) {
  // [discrete_lagrangian]
  return density(discrete_jet(cell, l)) * cell.volume(l);
  // [discrete_lagrangian]
}

/// The discrete Lagrangian \f$L_d(y_1, \dots, y_{2^{n+1}}) = \sum_l\frac{|\text{cell}_l|}2\,\Delta t\;
/// L(j_l)\f$ of a density on a space-time cell, energy x time.
///
/// For a medium, \f$L = \tfrac\rho2|\dot\phi|^2 - W(F)\f$, it is \f$\sum_b\bigl(\tfrac{m_b}2\,|y_{b,1} -
/// y_{b,0}|^2/\Delta t\bigr) - \tfrac{\Delta t}2(E_0 + E_1)\f$ with masses lumped at the corners and with the
/// stored energy \f$E = \sum_b|\text{cell}_b|\,W(F_b)\f$ of a level: the explicit scheme.
///
/// @param density  any density of first jets
/// @throws what the density refuses
/// Accuracy: of second order, the action of a smooth section over the cells of a box; see \ref
/// discrete_action.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
S discrete_lagrangian(L const& density, SpaceTimeCell<S, n, N> const& cell) {
  S sum(0);
  for (int l = 0; l < cell.nodes; ++l) {
    examine(density, discrete_jet(cell, l));
    sum += action_at_node(density, cell, l);
  }
  return sum;
}

/// The discrete action \f$S_d = \sum_{\text{cells}}L_d\f$ of a section over the slabs that it has.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
S discrete_action(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                  DiscreteSection<S, n, N> const& section) {
  require_section(mesh, section);
  S sum(0);
  for (int slab = 0; slab < section.last(); ++slab)
    mesh.for_cells([&](GridIndex<n> const& cell) {
      sum += discrete_lagrangian(density, cell_of(mesh, section, slab, cell));
    });
  return sum;
}

/// Asks a density whether it is defined at every discrete jet of a slab: its `examine` refuses, for instance
/// a cell that is turned inside out.
template <class S, int n, int N, class L>
void examine_slab(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                  DiscreteSection<S, n, N> const& section, int slab) {
  if constexpr (Plain<S>)
    mesh.for_cells([&](GridIndex<n> const& cell) {
      auto const here = cell_of(mesh, section, slab, cell);
      for (int l = 0; l < here.nodes; ++l) examine(density, discrete_jet(here, l));
    });
}

}  // namespace actio::media
