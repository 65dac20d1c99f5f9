// The discrete field equations of the extended bundle: those of the medium with the forces of the
// multipliers, and the constraint of each cell at each level (chapters 7, 8 and 10 of the thesis).
#pragma once

#include "actio/constraints_on_meshes/discrete_extended_section.hpp"
#include "actio/multisymplectic/discrete_field_equations.hpp"

namespace actio::media {

/// A constraint with a velocity in it: the values of one level do not say whether it holds.
struct NotSpatial : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// Refuses a constraint whose value at a jet depends on the velocity \f$v_0\f$. For such constraints the
/// restricted principle of Hamilton is not that of virtual work (section 7.2), and a multiplier for each
/// level does not belong to them.
/// @throws NotSpatial  with the largest derivative
template <class Phi, class S, int n, int N>
  requires ConstraintOver<Phi, S, n, N>
void require_spatial(Phi const& constraint, Jet<S, n, N> const& jet) {
  auto const with_velocity = [&]<class T>(Matrix<T, N, 1> const& velocity) {
    Jet<T, n, N> moved{jet.x.template cast<T>(), jet.y.template cast<T>(), jet.v.template cast<T>()};
    moved.v.col(0) = velocity;
    return Matrix<T, Phi::components, 1>(constraint(moved));
  };
  auto const rate = magnitude(derivative(with_velocity, Matrix<S, N, 1>(jet.v.col(0))).matrix);
  if (!(rate == Base<S>(0)))
    throw NotSpatial("constraint on a mesh at x = " + show(jet.x),
                     "it contains no velocity; derivative by the velocity", to_double(rate), 0);
}

/// The constraint \f$C_K(y)\f$ of a cell at a level, a function of the values there.
///
/// Of a constraint on jets it is \f$\sum_b|K_b|\,\Phi(j_b)\f$, the trapezoidal rule of the discrete
/// Lagrangian over the corners of the cell: volume times \f$\Phi\f$. For \ref VolumeConstraint between
/// Euclidean planes it is the area of the cell in space less that of the body, exactly; bent hexahedra have
/// \ref CellVolumes.
/// @param constraint  a constraint of chapter 7; or one that is given for whole cells by a member
///                    `of_cell(geometry, y)`, over any scalar, from the values at the corners, a column each
/// @param level       the earlier (0) or the later one (1)
template <class Phi, class S, int n, int N>
Matrix<S, Phi::components, 1> constraint_of_cell(Phi const& constraint, SpaceTimeCell<S, n, N> const& cell,
                                                 int level) {
  using Corners = Matrix<S, N, corners_of_cell<n>>;
  if constexpr (requires(Corners const& y) { constraint.of_cell(*cell.geometry, y); }) {
    return constraint.of_cell(*cell.geometry,
                              Corners(cell.y.template middleCols<corners_of_cell<n>>(level * cell.corners)));
  } else {
    Matrix<S, Phi::components, 1> C = Matrix<S, Phi::components, 1>::Zero();
    for (int b = 0; b < cell.corners; ++b) {
      // [discrete_constraint]
      C += constraint(discrete_jet(cell, node_of_corner<n>(b, level))) * cell.geometry->volume[b];
      // [discrete_constraint]
    }
    return C;
  }
}

/// The derivative \f$\partial C_K/\partial y_b\f$ of the constraint of a cell by the value at a corner: a row
/// for each component. Times the multiplier it is the force of the reaction on the corner.
template <class Phi, class S, int n, int N>
Matrix<S, Phi::components, N> constraint_slope(Phi const& constraint, SpaceTimeCell<S, n, N> const& cell,
                                               int level, int b) {
  int const l = node_of_corner<n>(b, level);
  auto const C = [&]<class T>(Matrix<T, N, 1> const& y) {
    auto moved = cell.template cast<T>();
    moved.y.col(l) = y;
    return constraint_of_cell(constraint, moved, level);
  };
  return derivative(C, Matrix<S, N, 1>(cell.y.col(l))).matrix;
}

/// The discrete action of an extended section over the slabs that it has, of an augmented density
/// \f$L + \langle\lambda,\Phi\rangle\f$: that of L, and \f$\sum\tfrac12(h_{k-1} + h_k)\,\lambda_{K,k}\cdot
/// C_K(y_k)\f$ over cells and levels, with half of it at the first and at the last level.
///
/// Of a constraint on jets this is the sum of \ref discrete_lagrangian of the augmented density over the
/// space-time cells of the extended bundle.
template <class L, class Phi, class S, int n, int N>
S discrete_action(AugmentedDensity<L, Phi> const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
                  DiscreteExtendedSection<S, n, N, Phi::components> const& section) {
  require_section(mesh, section);
  S sum = discrete_action(density.density, mesh, section.phi);
  for (int slab = 0; slab < section.last(); ++slab)
    mesh.for_cells([&](GridIndex<n> const& cell) {
      auto const here = cell_of(mesh, section.phi, slab, cell);
      for (int level = 0; level < 2; ++level)
        sum += section.lambda[slab + level][mesh.number(cell)].dot(
                   constraint_of_cell(density.constraint, here, level)) *
               (here.duration() / Base<S>(2));
    });
  return sum;
}

namespace detail {

/// \ref cartan_form_of_values where density and constraint have been asked whether they are defined.
template <class L, class Phi, class S, int n, int M>
auto cartan_form_with_reaction(AugmentedDensity<L, Phi> const& density, SpaceTimeCell<S, n, M> const& cell,
                               int l) {
  constexpr int k = Phi::components, N = M - k;
  auto const below = configuration<N>(cell);
  Matrix<S, k, 1> const lambda = cell.y.col(l).template tail<k>();
  // [cartan_form_of_values]
  auto const slope = constraint_slope(density.constraint, below, l / cell.corners, l % cell.corners);
  return Matrix<S, N, 1>(cartan_form_at_node(density.density, below, l) +
                         slope.transpose() * lambda * (cell.duration() / Base<S>(2)));
  // [cartan_form_of_values]
}

}  // namespace detail

/// The discrete Cartan form of a node of a space-time cell of the extended bundle, its part in the values:
/// \f$\Theta^l = \bigl(\frac{\partial L_d}{\partial y_l} + \tfrac h2\,\lambda\cdot\frac{\partial
/// C_K}{\partial y_l}\bigr)dy_l\f$, with the multiplier of its level. The augmented density has no momentum
/// of the multiplier.
/// @return  a covector at \f$y_l\f$, a component for each a
/// @throws NoDerivative  where density or constraint have none; and what they refuse
template <class L, class Phi, class S, int n, int M>
Matrix<S, M - Phi::components, 1> cartan_form_of_values(AugmentedDensity<L, Phi> const& density,
                                                        SpaceTimeCell<S, n, M> const& cell, int l) {
  for (int m = 0; m < cell.nodes; ++m) examine(density, discrete_jet(cell, m));
  auto const Theta = detail::cartan_form_with_reaction(density, cell, l);
  require_derivative(Theta, discrete_jet(cell, l), "cartan_form_of_values");
  return Theta;
}

/// The derivative of the discrete action by the value at a node: the sum of the Cartan forms of all
/// space-time cells that meet there, the forces of their multipliers included. Zero along solutions.
///
/// For equal steps and a medium it is \f$-\tfrac{m_v}h(y_{k+1} - 2y_k + y_{k-1}) - h\,\partial\mathcal
/// E/\partial y_v(y_k) + h\sum_K\lambda_{K,k}\cdot\partial C_K/\partial y_v(y_k)\f$: constraint, forces and
/// multiplier at one level.
/// @param level  with a slab before and a slab after it
/// @return       the sum, a component for each a, and the magnitudes of its terms
/// @throws NotAMesh  where the section has no such slabs; NoDerivative; and what density and constraint
///                   refuse
template <class L, class Phi, class S, int n, int N>
SumOfTerms<Matrix<S, N, 1>, Base<S>> discrete_euler_lagrange(
    AugmentedDensity<L, Phi> const& density, SpaceTimeMesh<Base<S>, n> const& mesh,
    DiscreteExtendedSection<S, n, N, Phi::components> const& section, int level, Index node) {
  require_section(mesh, section);
  require_slab(mesh, section.phi, level - 1);
  require_slab(mesh, section.phi, level);
  SumOfTerms<Matrix<S, N, 1>, Base<S>> E{Matrix<S, N, 1>::Zero()};
  for (int slab : {level - 1, level})
    mesh.for_cells_at(node, [&](GridIndex<n> const& cell, int b) {
      E.add(cartan_form_of_values(density, cell_of(mesh, section, slab, cell),
                                  node_of_corner<n>(b, level - slab)));
    });
  return E;
}

}  // namespace actio::media
