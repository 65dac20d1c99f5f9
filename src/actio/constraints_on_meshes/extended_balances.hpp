// The discrete form formula and the discrete Noether theorem with multipliers (chapters 7 to 10 of the
// thesis).
//
// The augmented density contains no derivative of the multiplier: it has no momentum, and what the sums over
// the boundary of a box contain are values at nodes alone. The multipliers are in the Cartan forms.
#pragma once

#include "actio/constraints_on_meshes/extended_field_equations.hpp"
#include "actio/multisymplectic/discrete_multisymplectic_form.hpp"
#include "actio/multisymplectic/discrete_noether.hpp"

namespace actio::media {

/// The discrete multisymplectic form of a node on variations of values and multipliers, its part in the
/// values: \f$\Omega^l(V, W) = \delta_W\Theta^l_y\cdot V_l - \delta_V\Theta^l_y\cdot W_l\f$.
///
/// @param V, W  at the nodes of the cell, a column for each: N components of the value, then the multipliers
/// @throws NoDerivative  where the density has no second derivative; and what the density itself refuses
template <class L, class Phi, class S, int n, int M>
S multisymplectic_form_of_values(AugmentedDensity<L, Phi> const& density, SpaceTimeCell<S, n, M> const& cell,
                                 int l,
                                 std::type_identity_t<Matrix<S, M, SpaceTimeCell<S, n, M>::nodes>> const& V,
                                 std::type_identity_t<Matrix<S, M, SpaceTimeCell<S, n, M>::nodes>> const& W) {
  constexpr int N = M - Phi::components;
  for (int m = 0; m < cell.nodes; ++m) examine(density, discrete_jet(cell, m));
  auto const delta_Theta = [&](auto const& by) {
    return rate_of(detail::cartan_form_with_reaction(density, cell.with(moved_along(cell.y, by)), l));
  };
  // [extended_multisymplectic_form]
  S const Omega =
      delta_Theta(W).dot(V.col(l).template head<N>()) - delta_Theta(V).dot(W.col(l).template head<N>());
  // [extended_multisymplectic_form]
  require_derivative(Matrix<S, 1, 1>(Omega), discrete_jet(cell, l), "multisymplectic_form_of_values");
  return Omega;
}

/// The sum \f$\sum_{\partial U}\Omega^l(V, W)\f$ over the boundary of a box of space-time. It is zero for
/// every box where V and W are first variations: solutions of the linearised field equations at the inner
/// nodes, with their own variations of the multipliers, that keep the constraint of each cell at all levels,
/// \f$\delta_VC_K = 0\f$.
///
/// \implements{bridge_multiplier_form}
/// @param V, W  variations, extended sections with as many levels
/// @return      the sum and the magnitudes of its terms
/// @throws NotAMesh  where the box does not lie in the mesh; NoDerivative; and what the density refuses
template <class L, class Phi, class S, int n, int N>
SumOfTerms<S, S> multisymplectic_balance(AugmentedDensity<L, Phi> const& density,
                                         SpaceTimeMesh<S, n> const& mesh,
                                         DiscreteExtendedSection<S, n, N, Phi::components> const& section,
                                         DiscreteExtendedSection<S, n, N, Phi::components> const& V,
                                         DiscreteExtendedSection<S, n, N, Phi::components> const& W,
                                         CellBox<n> const& box) {
  for (auto const* extended : {&section, &V, &W}) {
    require_section(mesh, *extended);
    require_box(mesh, extended->phi, box);
  }
  // [bridge_multiplier_form]
  return boundary_sum(mesh, box, [&](int slab, GridIndex<n> const& cell, int l) {
    return multisymplectic_form_of_values(density, cell_of(mesh, section, slab, cell), l,
                                          cell_of(mesh, V, slab, cell).y, cell_of(mesh, W, slab, cell).y);
  });
  // [bridge_multiplier_form]
}

/// The discrete momentum \f$J^l(\xi) = \Theta^l\cdot\xi(y_l)\f$ of a generator at a node of a space-time cell
/// of the extended bundle: multipliers stay as they are.
/// @param xi  a vector field on Y that moves points of space alone
/// @throws NotVertical, NoDerivative; and what density and constraint refuse
template <class L, class Phi, class Xi, class S, int n, int M>
S momentum_of_values(AugmentedDensity<L, Phi> const& density, Xi const& xi,
                     SpaceTimeCell<S, n, M> const& cell, int l) {
  auto const xi_l = generator_at_node(xi, configuration<M - Phi::components>(cell), l);
  return cartan_form_of_values(density, cell, l).dot(xi_l);
}

/// The sum \f$\sum_{\partial U}J^l(\xi)\f$ of the discrete momentum over the boundary of a box of space-time,
/// with the multipliers in the momenta. It is zero for every box where the section solves the discrete field
/// equations and \f$\xi\f$ generates a symmetry of density and constraint.
///
/// \implements{bridge_multiplier_noether}
/// @param xi  a vector field on Y that moves points of space alone
/// @return    the sum and the magnitudes of its terms
/// @throws NotAMesh  where the box does not lie in the mesh; NotVertical, NoDerivative; and what the density
///         refuses
template <class L, class Phi, class Xi, class S, int n, int N>
SumOfTerms<S, S> noether_balance(AugmentedDensity<L, Phi> const& density, Xi const& xi,
                                 SpaceTimeMesh<S, n> const& mesh,
                                 DiscreteExtendedSection<S, n, N, Phi::components> const& section,
                                 CellBox<n> const& box) {
  require_section(mesh, section);
  require_box(mesh, section.phi, box);
  // [bridge_multiplier_noether]
  return boundary_sum(mesh, box, [&](int slab, GridIndex<n> const& cell, int l) {
    return momentum_of_values(density, xi, cell_of(mesh, section, slab, cell), l);
  });
  // [bridge_multiplier_noether]
}

}  // namespace actio::media
