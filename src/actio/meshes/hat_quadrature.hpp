// A rule of integration on cells: three points of Gauss along each direction, with the hat functions there.
#pragma once

#include <array>
#include <cmath>

#include "actio/meshes/body_mesh.hpp"

namespace actio::media {

namespace detail {
/// Points and weights of a cell of some shape, with the hat functions of its corners there.
struct HatQuadrature {
  struct Sample {
    std::array<double, 8> hat{};
    double weight;
    std::array<std::array<double, 3>, 8> slope{};  // of the hat functions, of box-like cells
  };
  std::vector<Sample> samples;
  std::array<double, 8> total{};  ///< of each hat function
  double all = 0;

  HatQuadrature(BodyMesh::Shape shape, int d);
};
}  // namespace detail

}  // namespace actio::media
