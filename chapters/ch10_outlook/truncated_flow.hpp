// The classical scheme for the fluid on the sphere: d zeta/dt = -u . grad zeta, of which the harmonics below
// a degree are kept.
#pragma once

#include "actio/sphere_fields/sphere_flow.hpp"

// Steps of the truncated equations. Products are made on a grid that integrates them exactly.
class TruncatedFlow {
 public:
  // @param degrees  that are kept: those below
  // @param step     time
  TruncatedFlow(int degrees, double step)
      : degrees_(degrees),
        step_(step),
        grid_(actio::sphere::SphereGrid::gauss(3 * degrees / 2 + 2, 3 * degrees + 4)) {}

  actio::sphere::SphereHarmonics rate(actio::sphere::SphereHarmonics const& zeta) const {
    // The slopes of zeta are the velocities of a flow with the stream function zeta.
    actio::sphere::SphereHarmonics as_stream = zeta;
    for (int l = 0; l < degrees_; ++l) as_stream.coefficient.row(l) *= -(l * (l + 1.0));
    auto const u = actio::sphere::flow_on(grid_, zeta), slopes = actio::sphere::flow_on(grid_, as_stream);
    actio::sphere::GridField const transport =
        u.east.cwiseProduct(slopes.north) - u.north.cwiseProduct(slopes.east);
    auto f = actio::sphere::harmonics_from(grid_, transport, degrees_);
    f.coefficient *= -1;
    return f;
  }
  // The midpoint rule conserves what is quadratic: whatever else changes, the truncation changes.
  void advance(actio::sphere::SphereHarmonics& zeta) const {
    actio::sphere::SphereHarmonics middle = zeta;
    double moved = 1;
    for (int k = 0; k < 100 && moved > 1e-15; ++k) {
      auto const next = (zeta.coefficient + 0.5 * step_ * rate(middle).coefficient).eval();
      moved = (next - middle.coefficient).norm() / next.norm();
      middle.coefficient = next;
    }
    zeta.coefficient = 2 * middle.coefficient - zeta.coefficient;
  }

 private:
  int degrees_;
  double step_;
  actio::sphere::SphereGrid grid_;
};
