// The volume of a cell as a constraint, exact for bent hexahedra as well (chapters 8 and 10 of the thesis).
#pragma once

#include "actio/meshes/cell_geometry.hpp"

namespace actio::media {

/// The volume of the image of a cube under the multilinear map with these corners, with a sign.
///
/// The mean of the Jacobians at the corners in one and two dimensions; in three \f$8(\det a + \tfrac13D)\f$
/// in the notation of corner_correction.hpp. The volumes of cells that share their faces add up.
/// @param y  a column for each corner
template <class S, int n>
S volume_of_cell(Matrix<S, n, (1 << n)> const& y) {
  S volume(0);
  if constexpr (n == 3) {
    using Vector = Matrix<S, 3, 1>;
    using detail::cross_of, detail::end_of_corner;
    Vector a[3], h[3];
    for (int i = 0; i < 3; ++i) {
      a[i] = h[i] = Vector::Zero();
      for (int b = 0; b < 8; ++b) {
        a[i] += y.col(b) * (S(end_of_corner(b, i)) / S(8));
        h[i] += y.col(b) * (S(end_of_corner(b, i + 1) * end_of_corner(b, i + 2)) / S(8));
      }
    }
    for (int i = 0, j = 1, k = 2; i < 3; ++i, j = (j + 1) % 3, k = (k + 1) % 3)
      volume += a[i].dot(cross_of(h[k], h[j])) / S(3);
    volume = (volume + a[0].dot(cross_of(a[1], a[2]))) * S(8);
  } else {
    for (int b = 0; b < (1 << n); ++b) {
      // An edge that runs backwards from the far end of the cell turns the orientation once.
      S const det = determinant(edges_at_corner<n>(y, b));
      volume += std::popcount(unsigned(b)) % 2 == 0 ? det : S(-det);
    }
    volume = volume / S(1 << n);
  }
  return volume;
}

/// The constraint of an incompressible medium between Euclidean spaces, given for whole cells: the volume of
/// the cell in space less that in the body. Its multiplier is the material pressure.
///
/// In the plane it is \ref VolumeConstraint at the corners, in other words; of hexahedra it is the volume
/// that their faces enclose, so that closed walls leave a constraint that follows from the others.
///
struct CellVolumes {
  static constexpr int components = 1;  ///< one multiplier
  /// What the volume of a cell has gained.
  template <class S, int n>
  Matrix<S, 1, 1> of_cell(CellGeometry<Base<S>, n> const& geometry, Matrix<S, n, (1 << n)> const& y) const {
    return Matrix<S, 1, 1>(S(volume_of_cell(y) - volume_of_cell(geometry.places)));
  }
};

}  // namespace actio::media
