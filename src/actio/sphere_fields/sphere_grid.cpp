#include "actio/sphere_fields/sphere_grid.hpp"

namespace actio::sphere {

SphereGrid SphereGrid::uniform(int latitudes, int longitudes) {
  SphereGrid grid(latitudes, longitudes);
  for (int j = 0; j < latitudes; ++j) {
    grid.colatitude[j] = M_PI * (j + 0.5) / latitudes;
    grid.weight[j] = 2 * std::sin(grid.colatitude[j]) * std::sin(M_PI / (2 * latitudes));
  }
  return grid;
}

SphereGrid SphereGrid::gauss(int latitudes, int longitudes) {
  SphereGrid grid(latitudes, longitudes);
  grid.gaussian = true;
  int const n = latitudes;
  for (int j = 0; j < (n + 1) / 2; ++j) {
    // Newton's iteration in the angle, from Tricomi's guess, by the differences of neighbours.
    long double theta = std::numbers::pi_v<long double> * (4.0L * j + 3) / (4.0L * n + 2), slope = 0;
    for (int round = 0; round < 4; ++round) {
      long double const half = std::sin(theta / 2), t = 2 * half * half;
      long double p = 1, difference = 0;
      for (int l = 0; l < n; ++l) {
        difference = (l * difference - (2 * l + 1) * t * p) / (l + 1);
        p += difference;
      }
      // sin(theta) dP_n/d theta = n (cos(theta) P_n - P_{n-1}).
      slope = n * (difference - t * p) / std::sin(theta);
      theta -= p / slope;
    }
    if (2 * j + 1 == n) theta = std::numbers::pi_v<long double> / 2;
    grid.colatitude[j] = static_cast<double>(theta);
    grid.colatitude[n - 1 - j] = static_cast<double>(std::numbers::pi_v<long double> - theta);
    grid.weight[j] = grid.weight[n - 1 - j] = static_cast<double>(2 / (slope * slope));
  }
  return grid;
}

SphereGrid::SphereGrid(int rows, int columns)
    : colatitude(std::max(rows, 0)), weight(std::max(rows, 0)), longitudes(columns) {
  if (rows < 1 || columns < 1)
    throw OutsideDomain("grid on the sphere", "at least one parallel and one meridian are needed",
                        std::min(rows, columns), 1);
}

}  // namespace actio::sphere
