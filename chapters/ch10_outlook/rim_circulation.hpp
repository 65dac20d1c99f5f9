// The circulation of the velocity along the rim of a body in the plane that is star-shaped about the origin.
#pragma once

#include "actio/media_on_meshes/medium_on_mesh.hpp"

// Along the edges of all sides, counter-clockwise, by the mean of the velocities at both ends: exact where
// the velocity is linear.
inline double rim_circulation(actio::media::MediumOnMesh<2> const& medium) {
  auto const x = medium.places(), u = medium.velocities();
  double sum = 0;
  for (auto const& [name, edges] : medium.mesh().sides)
    for (auto const& edge : edges) {
      int const a = edge[0], b = edge[1];
      auto const &A = medium.mesh().nodes[a], &B = medium.mesh().nodes[b];
      double const sign = A[0] * B[1] > A[1] * B[0] ? 1 : -1;
      for (int c = 0; c < 2; ++c) sum += sign * (u[a][c] + u[b][c]) / 2 * (x[b][c] - x[a][c]);
    }
  return sum;
}
