// The reference shape of a cell of a mesh of the body: a box with 2^n corners, mapped (chapter 10 of the
// thesis).
//
// A corner is a number whose bit i says at which end of the cell it lies in direction i: its neighbour along
// the edge in that direction is b with bit i flipped. Every corner has a frame of its own, the n edges that
// meet there, so that a deformation gradient at the corner needs no interpolation.
#pragma once

#include <bit>

#include "actio/jets/density.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/meshes/corner_correction.hpp"

namespace actio::media {

/// A cell of a mesh of the body that is flat, or turned inside out.
struct InvertedCell : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// The edges that meet at a corner: column i is \f$z_{b^i} - z_b\f$, where \f$b^i\f$ is the neighbour of the
/// corner b in direction i.
/// @param z  values at the corners, a column for each: places of the body, or of space
template <int n, MatrixLike Z>
auto edges_at_corner(Z const& z, int b) {
  constexpr int rows = Z::RowsAtCompileTime;
  Matrix<typename Z::Scalar, rows, n> edges;
  for (int i = 0; i < n; ++i)
    for (int a = 0; a < rows; ++a) edges(a, i) = z(a, b ^ (1 << i)) - z(a, b);
  return edges;
}

/// What the discrete jets need of the reference shape of a cell.
template <class S, int n>
struct CellGeometry {
  static constexpr int corners = corners_of_cell<n>;  ///< how many corners it has

  Matrix<S, n, corners> places;  ///< points of the body, a column for each corner
  /// At each corner, the inverse of the matrix of the edges that meet there.
  std::array<Matrix<S, n, n>, corners> inverse_edges;
  /// The part of the volume \f$d^nx\f$ that each corner stands for: \f$2^{-n}\f$ of the parallelepiped on its
  /// edges, times the ratio of the correction.
  std::array<S, corners> volume;
  CornerCorrection<S, n> correction;  ///< of a hexahedron that is no parallelepiped
};

/// The geometry of a cell with these corners.
/// @param places  points of the body, a column for each corner
/// @param name    of the cell, for the message
/// @throws InvertedCell  where the edges at a corner do not span a parallelepiped with the orientation of the
///         body: the measured number is its volume over the product of its edges
/// Accuracy: the volumes of the corners sum up to the integral of the Jacobian of the multilinear map.
template <class S, int n>
CellGeometry<S, n> cell_geometry(Matrix<S, n, corners_of_cell<n>> const& places, std::string const& name) {
  CellGeometry<S, n> geometry{places, {}, {}, corner_correction<S, n>(places)};
  for (int b = 0; b < geometry.corners; ++b) {
    auto const edges = edges_at_corner<n>(places, b);
    // An edge that runs backwards from the far end of the cell turns the orientation once.
    S const det = determinant(edges);
    S const J = std::popcount(unsigned(b)) % 2 == 0 ? det : S(-det);
    S box(1);
    for (int i = 0; i < n; ++i) box *= magnitude(edges.col(i));
    // An entry of an edge is a difference of coordinates, and n! products of them make the determinant: one
    // that is not above their rounding has no sign.
    S const bound = S(64) * epsilon<S>();
    if (ordered_arithmetic<S>() && !(J > bound * box))
      throw InvertedCell("cell " + name + ", corner " + std::to_string(b) + " at x = " + show(places.col(b)),
                         "the edges of a cell span a volume that is not turned inside out; "
                         "volume over the product of the edges",
                         box > S(0) ? to_double(S(J / box)) : to_double(J), to_double(bound));
    geometry.inverse_edges[b] = inverse_matrix(edges, "cell_geometry");
    geometry.volume[b] = J / S(geometry.corners) * geometry.correction.ratio;
  }
  S const& ratio = geometry.correction.ratio;
  if (ordered_arithmetic<S>() && !(ratio > S(0)))
    throw InvertedCell("cell " + name, "a cell has a volume; over that of its corners", to_double(ratio), 0);
  return geometry;
}

}  // namespace actio::media
