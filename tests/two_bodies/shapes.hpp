// Shapes for the tests: octahedra with drawn vertices, and rational rotations.
#pragma once

#include <random>

#include "../rigid_body/random_bodies.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/two_bodies/polyhedron.hpp"

namespace actio::testing {

using namespace actio::bodies;

/// The eight triangles of an octahedron with the vertices +x, -x, +y, -y, +z, -z.
inline std::vector<std::array<int, 3>> octahedron_faces() {
  return {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
}
/// An octahedron whose vertices are moved by up to three tenths of its size, in whole hundredths of it.
template <class S>
Polyhedron<S> drawn_octahedron(std::mt19937& random, S const& size) {
  std::uniform_int_distribution<int> hundredths(-30, 30);
  Polyhedron<S> body{{}, octahedron_faces()};
  for (int k = 0; k < 6; ++k) {
    Matrix<S, 3, 1> x;
    for (int i = 0; i < 3; ++i)
      x[i] = size * (S(i == k / 2 ? (k % 2 ? -1 : 1) : 0) + S(hundredths(random)) / S(100));
    body.vertices.push_back(x);
  }
  return body;
}
/// The rotation of the quaternion (w, x, y, z) of whole numbers, over the rationals.
template <class S>
Matrix<S, 3, 3> rotation_of(long w, long x, long y, long z) {
  S const n(w * w + x * x + y * y + z * z);
  Matrix<S, 3, 3> R;
  R(0, 0) = S(w * w + x * x - y * y - z * z) / n, R(0, 1) = S(2 * (x * y - w * z)) / n;
  R(0, 2) = S(2 * (x * z + w * y)) / n, R(1, 0) = S(2 * (x * y + w * z)) / n;
  R(1, 1) = S(w * w - x * x + y * y - z * z) / n, R(1, 2) = S(2 * (y * z - w * x)) / n;
  R(2, 0) = S(2 * (x * z - w * y)) / n, R(2, 1) = S(2 * (y * z + w * x)) / n;
  R(2, 2) = S(w * w - x * x - y * y + z * z) / n;
  return R;
}

}  // namespace actio::testing
