// The weight of an incompressible medium, cell by cell (chapter 10C of the book).
//
// Let s be the height, against gravity g = -|g| e. By the divergence theorem a cell of density rho has the
// energy rho |g| times the integral of s^2/2 n.e over its facets. Each corner of a facet takes its part of
// the facet's area:
//
//     V = rho |g| sum over facets, over corners b of s_b^2/2 a_b.e.
//
// Where two cells of one density meet, the facet between them counts twice with opposite signs. So the weight
// of a homogeneous medium acts on its rim alone, as in the continuum, where pressure carries the rest. Weight
// at the nodes, m g at each, has the same energy to first order and differs in the second: a pressure that
// carries it makes shears of neighbouring columns grow like exp(t sqrt(g/cell)) (a test shows it).
#pragma once

#include "actio/incompressible_media/cell_volume.hpp"
#include "actio/meshes/body_mesh.hpp"

namespace actio::media {

/// Uniform gravity on the cells of a medium that keep their volumes.
template <int d>
class CellWeight {
 public:
  /// @param gravity  the acceleration
  /// @param density  of each cell, mass per volume
  CellWeight(BodyMesh const& mesh, std::array<double, d> const& gravity, std::vector<double> density)
      : density_(std::move(density)) {
    double square = 0;
    for (double const g : gravity) square += g * g;
    strength_ = std::sqrt(square);
    for (int a = 0; a < d && any(); ++a) up_[a] = -gravity[a] / strength_;
    for (int facet = 0; facet < facet_count(mesh.shape); ++facet)
      facets_.push_back(facet_corners(mesh.shape, facet));
  }

  /// Whether there is gravity.
  bool any() const { return strength_ > 0; }
  /// The energy of a cell, and what its weight does to its corners.
  /// @param y  places of the corners
  /// @param f  forces, to which minus the derivative is added; may be null
  double of_cell(std::size_t cell, double const (*y)[d], double (*f)[d]) const {
    double const weight = density_[cell] * strength_;
    double sum = 0;
    for (auto const& facet : facets_)
      for (int k = 0; k < on_facet; ++k) {
        double const* at = y[facet[k]];
        double s = 0;
        for (int a = 0; a < d; ++a) s += up_[a] * at[a];
        double const scale = weight / on_facet, half = 0.5 * s * s;
        double area;
        if constexpr (d == 2) {
          // The whole edge, turned to the right.
          int const from = facet[0], to = facet[1];
          area = (y[to][1] - y[from][1]) * up_[0] - (y[to][0] - y[from][0]) * up_[1];
          if (f) {
            double const push[] = {scale * half * up_[1], -scale * half * up_[0]};
            for (int a = 0; a < d; ++a) f[to][a] += push[a], f[from][a] -= push[a];
          }
        } else {
          int const next = facet[(k + 1) % 4], before = facet[(k + 3) % 4];
          std::array<double, 3> u, v;
          for (int a = 0; a < 3; ++a) u[a] = y[next][a] - at[a], v[a] = y[before][a] - at[a];
          auto const by_u = detail::cross(v.data(), up_.data()), by_v = detail::cross(up_.data(), u.data());
          area = detail::dot(u.data(), by_u.data());
          for (int a = 0; f && a < 3; ++a) {
            f[next][a] -= scale * half * by_u[a], f[before][a] -= scale * half * by_v[a];
            f[facet[k]][a] += scale * half * (by_u[a] + by_v[a]);
          }
        }
        sum += scale * half * area;
        for (int a = 0; f && a < d; ++a) f[facet[k]][a] -= scale * s * area * up_[a];
      }
    return sum;
  }

 private:
  static constexpr int on_facet = d == 2 ? 2 : 4;
  std::vector<double> density_;
  std::array<double, d> up_{};
  double strength_ = 0;
  std::vector<std::array<int, 4>> facets_;
};

}  // namespace actio::media
