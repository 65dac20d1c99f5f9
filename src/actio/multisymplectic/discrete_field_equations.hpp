// The discrete Euler-Lagrange field equations (chapter 10 of the thesis; Marsden, Patrick and Shkoller 1998).
//
// A discrete section is stationary for the discrete action, with variations that vanish at the boundary of
// space-time, where at every inner node the Cartan forms of the cells that meet there sum up to zero. `step`
// in step_field_equations.hpp solves them for the next level of time.
#pragma once

#include "actio/multisymplectic/discrete_cartan_form.hpp"

namespace actio::media {

/// A sum, and the terms that it is made from.
template <class Value, class B>
struct SumOfTerms {
  Value sum;   ///< their sum
  B terms{0};  ///< the sum of their magnitudes: what rounding is a part of

  /// Adds a term.
  void add(Value const& term) {
    sum += term;
    terms += magnitude(term);
  }
};

namespace detail {

/// The sum of the Cartan forms at a node over the cells of one slab, the node being at their earlier (0) or
/// later level (1).
template <class S, int n, int N, class L>
SumOfTerms<Matrix<S, N, 1>, Base<S>> cartan_forms_of_slab(L const& density,
                                                          SpaceTimeMesh<Base<S>, n> const& mesh,
                                                          DiscreteSection<S, n, N> const& section, int slab,
                                                          Index node, int level) {
  SumOfTerms<Matrix<S, N, 1>, Base<S>> Theta{Matrix<S, N, 1>::Zero()};
  mesh.for_cells_at(node, [&](GridIndex<n> const& cell, int b) {
    Theta.add(cartan_form_at_node(density, cell_of(mesh, section, slab, cell), node_of_corner<n>(b, level)));
  });
  return Theta;
}

}  // namespace detail

/// The discrete momentum at a node at the end of a slab, \f$\sum_{\text{cells}}\Theta^{(b,1)}\f$ over the
/// cells of the slab that meet there: mass times velocity, and half a step of the force.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> momentum_at_end(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                                DiscreteSection<S, n, N> const& section, int slab, Index node) {
  require_slab(mesh, section, slab);
  examine_slab(density, mesh, section, slab);
  return detail::cartan_forms_of_slab(density, mesh, section, slab, node, 1).sum;
}

/// The discrete momentum at a node at the start of a slab, \f$-\sum_{\text{cells}}\Theta^{(b,0)}\f$.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
Matrix<S, N, 1> momentum_at_start(L const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                                  DiscreteSection<S, n, N> const& section, int slab, Index node) {
  require_slab(mesh, section, slab);
  examine_slab(density, mesh, section, slab);
  return -detail::cartan_forms_of_slab(density, mesh, section, slab, node, 0).sum;
}

/// The discrete Euler-Lagrange derivative at a node, \f$\sum_{\text{cells}}\Theta^l\f$ over all space-time
/// cells that meet there: zero along discrete solutions, and only there. (At a node of a fixed side it is the
/// impulse that holds the node, with a minus.)
///
/// @param level  with a slab before and a slab after it
/// @return       the sum, a component for each a, and the magnitudes of its terms
/// @throws NotAMesh  where the section has no such slabs; NoDerivative; and what the density itself refuses
/// Accuracy: exact but for the rounding of L. Divided by the volume that the node stands for it is the
/// \ref euler_lagrange derivative of a smooth section, to second order on a uniform mesh.
template <class S, int n, int N, class L>
  requires DensityOver<L, S, n, N>
SumOfTerms<Matrix<S, N, 1>, Base<S>> discrete_euler_lagrange(L const& density,
                                                             SpaceTimeMesh<Base<S>, n> const& mesh,
                                                             DiscreteSection<S, n, N> const& section,
                                                             int level, Index node) {
  require_slab(mesh, section, level - 1);
  require_slab(mesh, section, level);
  SumOfTerms<Matrix<S, N, 1>, Base<S>> E{Matrix<S, N, 1>::Zero()};
  // [discrete_euler_lagrange]
  for (int slab : {level - 1, level})
    mesh.for_cells_at(node, [&](GridIndex<n> const& cell, int b) {
      E.add(discrete_cartan_form(density, cell_of(mesh, section, slab, cell),
                                 node_of_corner<n>(b, level - slab)));
    });
  // [discrete_euler_lagrange]
  return E;
}

}  // namespace actio::media
