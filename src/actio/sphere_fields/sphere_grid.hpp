// Grids on the sphere: parallels that lie symmetrically about the equator, with the weights of integrals.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "actio/numbers/errors.hpp"

namespace actio::sphere {

/// Numbers on a grid: a row for each parallel, from the north, a column for each meridian, from longitude 0.
using GridField = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Parallels that lie symmetrically about the equator, and meridians at equal distances.
struct SphereGrid {
  Eigen::ArrayXd colatitude;  ///< of the parallels, rising, in (0, pi)
  Eigen::ArrayXd weight;      ///< of the parallels in an integral over cos(theta); their sum is 2
  int longitudes = 0;         ///< how many meridians there are; the one k is at 2 pi k/longitudes
  bool gaussian = false;  ///< whether the integral of a polynomial of a degree below 2 x parallels is exact

  /// How many circles of latitude there are.
  int latitudes() const { return static_cast<int>(colatitude.size()); }
  /// In radians, north positive.
  double latitude(int row) const { return M_PI / 2 - colatitude[row]; }
  /// In radians.
  double longitude(int column) const { return 2 * M_PI * column / longitudes; }
  /// The integral over the sphere.
  double integral(GridField const& field) const {
    return 2 * M_PI / longitudes * weight.matrix().dot(field.rowwise().sum());
  }

  /// The middles of the cells of a net with equal steps in both angles; no parallel is a pole.
  /// @throws OutsideDomain  where there are fewer than one of each
  static SphereGrid uniform(int latitudes, int longitudes);
  /// Parallels at the zeros of the Legendre polynomial, with the weights of Gauss.
  ///
  /// Accuracy: a few epsilon, relative to the angle and to the weight.
  /// @throws OutsideDomain  where there are fewer than one of each
  static SphereGrid gauss(int latitudes, int longitudes);

 private:
  SphereGrid(int rows, int columns);
};

}  // namespace actio::sphere
