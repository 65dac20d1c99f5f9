// Discrete momenta and the discrete Noether theorem (chapters 9 and 10 of the thesis).
//
// A symmetry of the density that moves points of space, and not of space-time, is a symmetry of its discrete
// Lagrangian on every cell: discrete jets are made of differences, and transform as jets do. Its generator on
// the discrete Cartan forms is a discrete momentum for each node of a cell. These sum up to zero over a cell,
// for any values; along solutions they sum up to zero over the boundary of any box of space-time.
#pragma once

#include "actio/multisymplectic/space_time_box.hpp"
#include "actio/noether/covariant_momentum_map.hpp"
#include "actio/noether/isometries.hpp"

namespace actio::media {

/// A generator that moves points of space-time, which on a mesh has no discrete momentum.
struct NotVertical : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// The generator \f$\xi^a\f$ at a node of a cell.
/// @param xi  a vector field on Y: a callable from points (x, y), one column, to their velocities;
///            \ref motion_of_space makes one of a field on space
/// @throws NotVertical  where it moves the point of space-time
template <class Xi, class S, int n, int N>
Matrix<S, N, 1> generator_at_node(Xi const& xi, SpaceTimeCell<S, n, N> const& cell, int l) {
  auto const j = discrete_jet(cell, l);
  Variation<S, n, N> const V = xi(point_of(j));
  require_finite(V, "generator of a symmetry");
  auto const horizontal = magnitude(V.template head<n + 1>());
  if (ordered_arithmetic<S>() && horizontal > Base<S>(0))
    throw NotVertical("discrete_momentum at x = " + show(j.x),
                      "the nodes of a mesh do not move in space-time; velocity of the event",
                      to_double(horizontal), 0);
  return V.template tail<N>();
}

/// The discrete momentum \f$J^l(\xi) = \Theta^l\cdot\xi(y_l)\f$ of a generator at a node of a cell: the
/// discrete \ref covariant_momentum_map.
///
/// @param xi  a vector field on Y that moves points of space alone
/// @throws NotVertical, NoDerivative; and what the density refuses
/// Accuracy: exact but for the rounding of L and xi.
template <class L, class Xi, class S, int n, int N>
S discrete_momentum(L const& density, Xi const& xi, SpaceTimeCell<S, n, N> const& cell, int l) {
  auto const xi_l = generator_at_node(xi, cell, l);
  // [discrete_momentum]
  return discrete_cartan_form(density, cell, l).dot(xi_l);
  // [discrete_momentum]
}

/// The rate of the discrete Lagrangian of a cell along a generator, \f$dL_d\cdot\xi = \sum_lJ^l(\xi)\f$: zero
/// for a symmetry, whatever the values.
template <class L, class Xi, class S, int n, int N>
SumOfTerms<S, Base<S>> equivariance_of_cell(L const& density, Xi const& xi,
                                            SpaceTimeCell<S, n, N> const& cell) {
  SumOfTerms<S, Base<S>> rate{S(0)};
  for (int l = 0; l < cell.nodes; ++l) rate.add(discrete_momentum(density, xi, cell, l));
  return rate;
}

/// The sum \f$\sum_{\partial U}J^l(\xi)\f$ of the discrete momentum over the boundary of a box U of
/// space-time. It is zero for every box where the section solves the discrete field equations and \f$\xi\f$
/// generates a symmetry of the density: the discrete Noether theorem.
///
/// Nodes of a fixed side are boundary nodes: what they contribute is minus the impulse of the wall.
///
/// \snippet ch10_outlook/try_it.cpp noether_balance
///
/// \implements{claim_10_0_discrete_noether_sum}
/// @param xi  a vector field on Y that moves points of space alone
/// @return    the sum and the magnitudes of its terms
/// @throws NotAMesh  where the box does not lie in the mesh; NotVertical, NoDerivative; and what the density
///         refuses
/// Accuracy: exact but for the rounding of the terms, and of the solution.
template <class L, class Xi, class S, int n, int N>
SumOfTerms<S, S> noether_balance(L const& density, Xi const& xi, SpaceTimeMesh<S, n> const& mesh,
                                 DiscreteSection<S, n, N> const& section, CellBox<n> const& box) {
  require_box(mesh, section, box);
  // [claim_10_0_discrete_noether_sum]
  return boundary_sum(mesh, box, [&](int slab, GridIndex<n> const& cell, int l) {
    return discrete_momentum(density, xi, cell_of(mesh, section, slab, cell), l);
  });
  // [claim_10_0_discrete_noether_sum]
}

/// The momentum of the whole body at the end of a slab, \f$\sum J^{(b,1)}(\xi)\f$ over the cells of the slab
/// and their corners at its later level: linear momentum for a translation, angular momentum for a rotation.
/// For a symmetry and a body with free or periodic sides it is the same for every slab.
///
/// Over a periodic side a rotation is no symmetry: it does not commute with the translation that joins the
/// two copies.
template <class L, class Xi, class S, int n, int N>
SumOfTerms<S, S> momentum_of_level(L const& density, Xi const& xi, SpaceTimeMesh<S, n> const& mesh,
                                   DiscreteSection<S, n, N> const& section, int slab) {
  require_slab(mesh, section, slab);
  SumOfTerms<S, S> total{S(0)};
  mesh.for_cells([&](GridIndex<n> const& cell) {
    auto const here = cell_of(mesh, section, slab, cell);
    for (int b = 0; b < mesh.corners; ++b)
      total.add(discrete_momentum(density, xi, here, node_of_corner<n>(b, 1)));
  });
  return total;
}

}  // namespace actio::media
