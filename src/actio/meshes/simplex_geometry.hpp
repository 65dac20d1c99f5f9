// The reference shape of a simplex, and the discrete jets of a section that is linear in it (chapter 10 of
// the thesis).
//
// On a simplex a section that is given at the corners has one deformation gradient. Its stored energy is
// still taken at each corner, with the density there, so that bodies need not be homogeneous and potentials
// of space act at the nodes, where the mass is.
#pragma once

#include "actio/jets/density.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/meshes/body_mesh_check.hpp"

namespace actio::media {

/// What discrete jets need of the reference shape of a simplex.
template <int n>
struct SimplexGeometry {
  static constexpr int corners = n + 1;  ///< how many it has
  Matrix<double, n, n + 1> places;       ///< points of the body, a column for each corner, length
  /// Row c is the gradient of the linear function that is 1 at corner c + 1 and 0 at the others, 1/length.
  /// The gradients of all corners sum up to zero.
  Matrix<double, n, n> gradients;
  double volume;  ///< the part of the volume \f$d^nx\f$ that each corner stands for: \f$|cell|/(n+1)\f$
};

/// The geometry of a cell of a mesh that \ref require_body_mesh accepts.
/// @throws NotABodyMesh  where cells are no simplices of this dimension, or lie across a seam
template <int n>
SimplexGeometry<n> simplex_geometry(BodyMesh const& mesh, int cell) {
  if (mesh.dimension != n || corner_count(mesh.shape) != n + 1 || !mesh.wraps.empty())
    throw NotABodyMesh(std::string("mesh of ") + name_of(mesh.shape) + "s",
                       "cells are simplices, and the body is not periodic; corners of a cell",
                       corner_count(mesh.shape), n + 1);
  SimplexGeometry<n> geometry;
  for (int c = 0; c <= n; ++c)
    for (int i = 0; i < n; ++i) geometry.places(i, c) = mesh.nodes[mesh.cells[cell][c]][i];
  Matrix<double, n, n> edges;
  for (int c = 0; c < n; ++c)
    for (int i = 0; i < n; ++i) edges(i, c) = geometry.places(i, c + 1) - geometry.places(i, 0);
  geometry.gradients = inverse_matrix(edges, "simplex_geometry");
  double factorial = 1;
  for (int k = 2; k <= n + 1; ++k) factorial *= k;
  geometry.volume = determinant(edges) / factorial;
  return geometry;
}

/// The jet of a section that is linear in a simplex, at a corner of it and at a time: at rest, with the
/// deformation gradient of the simplex.
/// @param y  values at the corners, a column for each
template <class S, int n, int N>
Jet<S, n, N> jet_at_rest(SimplexGeometry<n> const& cell, double time, Matrix<S, N, n + 1> const& y, int b) {
  Jet<S, n, N> j;
  j.x[0] = S(time);
  for (int i = 0; i < n; ++i) j.x[1 + i] = S(cell.places(i, b));
  j.y = y.col(b);
  j.v.setZero();
  for (int c = 0; c < n; ++c)
    for (int a = 0; a < N; ++a)
      for (int i = 0; i < n; ++i) j.v(a, 1 + i) += (y(a, c + 1) - y(a, 0)) * cell.gradients(c, i);
  return j;
}

/// The energy that a density stores in a simplex at rest,
/// \f$E = -\sum_b|\text{cell}_b|\,L(x_b, y_b, 0, F)\f$.
template <class S, int n, int N, class L>
S stored_energy(L const& density, SimplexGeometry<n> const& cell, double time, Matrix<S, N, n + 1> const& y) {
  S sum(0);
  for (int b = 0; b <= n; ++b) sum -= density(jet_at_rest(cell, time, y, b)) * cell.volume;
  return sum;
}

/// The forces \f$-\partial E/\partial y_c\f$ on the corners of a simplex, a column for each: those of the
/// stresses \f$\partial L/\partial F\f$ sum up to zero, and \f$\partial L/\partial y\f$ adds those of space.
template <class S, int n, int N, class L>
Matrix<S, N, n + 1> forces_on_corners(L const& density, SimplexGeometry<n> const& cell, double time,
                                      Matrix<S, N, n + 1> const& y) {
  Matrix<S, N, n + 1> f = Matrix<S, N, n + 1>::Zero();
  Matrix<S, N, n> stress = Matrix<S, N, n>::Zero();
  for (int b = 0; b <= n; ++b) {
    auto const j = jet_at_rest(cell, time, y, b);
    examine(density, j);
    stress += partial_v(density, j).template rightCols<n>() * cell.volume;
    f.col(b) = partial_y(density, j) * cell.volume;
  }
  for (int c = 0; c < n; ++c)
    for (int a = 0; a < N; ++a) {
      S along(0);
      for (int i = 0; i < n; ++i) along += stress(a, i) * cell.gradients(c, i);
      f(a, c + 1) += along;
      f(a, 0) -= along;
    }
  return f;
}

/// The mass that a density gives to a corner of a simplex.
/// @throws OutsideDomain  where momentum is not a positive mass times velocity, the same in all directions:
///         then no node moves freely between the steps of its cells
template <int N, int n, class L>
double mass_of_corner(L const& density, SimplexGeometry<n> const& cell, Matrix<double, N, n + 1> const& y,
                      int b) {
  auto j = jet_at_rest(cell, 0.0, y, b);
  examine(density, j);
  Matrix<double, N, N> mass;
  for (int a = 0; a < N; ++a) {
    j.v.col(0) = Matrix<double, N, 1>::Unit(a);
    mass.col(a) = partial_v(density, j, 0);
  }
  double const m = mass(0, 0),
               off = magnitude(Matrix<double, N, N>(mass - m * Matrix<double, N, N>::Identity()));
  if (!(m > 0) || !(off <= 64 * epsilon<double>() * m))
    throw OutsideDomain("mass at x = " + show(cell.places.col(b)),
                        "momentum is a positive mass times velocity; what else it is", off,
                        64 * epsilon<double>() * m);
  return m * cell.volume;
}

}  // namespace actio::media
