// The discrete multisymplectic form formula (chapter 10 of the thesis; Marsden, Patrick and Shkoller 1998).
//
// Each discrete Cartan form has a two-form Omega^l = -dTheta^l, and since dL_d is their sum and d dL_d = 0,
// the two-forms of a cell sum up to zero: an identity, for any values. On a solution and two first
// variations of it the forms at an inner node sum up to zero as well, so that the sum over any box of
// space-time is a sum over its boundary.
#pragma once

#include "actio/multisymplectic/space_time_box.hpp"

namespace actio::media {

/// The discrete multisymplectic form \f$\Omega^l = -d\Theta^l\f$ of a node of a cell, on two vertical
/// variations: \f$\Omega^l(V, W) = \delta_W\Theta^l\cdot V_l - \delta_V\Theta^l\cdot W_l\f$.
///
/// @param V, W  values of the variations at the nodes of the cell, a column for each
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
S discrete_multisymplectic_form(L const& density, SpaceTimeCell<S, n, N> const& cell, int l,
                                std::type_identity_t<Matrix<S, N, SpaceTimeCell<S, n, N>::nodes>> const& V,
                                std::type_identity_t<Matrix<S, N, SpaceTimeCell<S, n, N>::nodes>> const& W) {
  for (int k = 0; k < cell.nodes; ++k)
    if (jet_contains(cell, k, l)) examine(density, discrete_jet(cell, k));
  auto const delta_Theta = [&](auto const& by) {
    return rate_of(detail::cartan_form_at_node(density, cell.with(moved_along(cell.y, by)), l));
  };
  // [discrete_multisymplectic_form]
  S const Omega = delta_Theta(W).dot(V.col(l)) - delta_Theta(V).dot(W.col(l));
  // [discrete_multisymplectic_form]
  require_derivative(Matrix<S, 1, 1>(Omega), discrete_jet(cell, l), "discrete_multisymplectic_form");
  return Omega;
}

/// The sum \f$\sum_{\partial U}\Omega^l(V, W)\f$ over the boundary of a box U of space-time: over the nodes
/// of the boundary, and at each over the cells of U that meet there. It is zero for every box where the
/// section solves the discrete field equations and V and W are first variations of it: the discrete
/// multisymplectic form formula.
///
/// \implements{claim_10_0_variational_discretisation}
/// @param V, W  variations, discrete sections with as many levels; first variations are the solutions of the
///              linearised equations, for instance \ref rate_of a section that was stepped over dual numbers
/// @return      the sum and the magnitudes of its terms
/// @throws NotAMesh  where the box does not lie in the mesh; NoDerivative; and what the density refuses
/// Accuracy: exact but for the rounding of the terms, and of the solution.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
SumOfTerms<S, S> multisymplectic_balance(L const& density, SpaceTimeMesh<S, n> const& mesh,
                                         DiscreteSection<S, n, N> const& section,
                                         DiscreteSection<S, n, N> const& V, DiscreteSection<S, n, N> const& W,
                                         CellBox<n> const& box) {
  for (auto const* levels : {&section, &V, &W}) require_box(mesh, *levels, box);
  // [claim_10_0_variational_discretisation]
  return boundary_sum(mesh, box, [&](int slab, GridIndex<n> const& cell, int l) {
    return discrete_multisymplectic_form(density, cell_of(mesh, section, slab, cell), l,
                                         cell_of(mesh, V, slab, cell).y, cell_of(mesh, W, slab, cell).y);
  });
  // [claim_10_0_variational_discretisation]
}

}  // namespace actio::media
