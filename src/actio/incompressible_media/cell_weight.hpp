// The weight of an incompressible medium, cell by cell (chapter 10C of the book).
//
// Let s be the height, against gravity g = -|g| e. A cell K of density rho has the energy
//
//     V = rho |g| ( integral of s over K + sum over facets of (e.a) D ),
//
// with K where it is now, not where its particles were, a the vector area of a facet outwards and D what the
// trapezoidal rule has beyond the mean of s^2/2 over the facet: p^2/3 for an edge along which s is m + p xi,
// p^2/3 + q^2/3 + 4 r^2/9 for a face on which it is m + p xi + q eta + r xi eta, -1 < xi, eta < 1. By the
// divergence theorem the integral is one of s^2/2 over facets, too. Where two cells of one density meet, the
// facet between them counts twice with opposite signs: the weight of a homogeneous medium acts on its rim
// alone, as in the continuum, where pressure carries the rest, and there it is that of columns of liquid
// above the nodes. Without D a free surface would be too soft in its shortest waves.
//
// Weight at the nodes, m g at each, has the same energy to first order and differs in the second: a pressure
// that carries it makes shears of neighbouring columns grow like exp(t sqrt(g/cell)) (a test shows it).
#pragma once

#include "actio/incompressible_media/cell_volume.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/meshes/body_mesh.hpp"
#include "actio/stored_energy/strain_energies.hpp"

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
    for (int k = 0; k < corners; ++k) points_.push_back(gauss_point(k));
  }

  /// Whether there is gravity.
  bool any() const { return strength_ > 0; }
  /// Its acceleration.
  double strength() const { return strength_; }
  /// The energy of a cell, and what its weight does to its corners.
  /// @param y  places of the corners
  /// @param f  forces, to which minus the derivative is added; may be null
  double of_cell(std::size_t cell, double const (*y)[d], double (*f)[d]) const {
    double const weight = density_[cell] * strength_;
    double height[corners] = {};
    for (int b = 0; b < corners; ++b)
      for (int a = 0; a < d; ++a) height[b] += up_[a] * y[b][a];
    double sum = 0;
    for (auto const& point : points_) sum += inside(point, y, height, weight, f);
    for (auto const& facet : facets_) sum += on_facet(facet, y, height, weight, f);
    return sum;
  }

 private:
  static constexpr int corners = 1 << d;
  /// A point of Gauss' rule with two points along each direction, which integrates s J exactly.
  struct Point {
    double hat[corners], slope[corners][d];
  };
  std::vector<double> density_;
  std::array<double, d> up_{};
  double strength_ = 0;
  std::vector<std::array<int, 4>> facets_;
  std::vector<Point> points_;

  static Point gauss_point(int number) {
    Point out;
    double at[d];
    for (int k = 0; k < d; ++k) at[k] = 0.5 + (number >> k & 1 ? 0.5 : -0.5) / std::sqrt(3.0);
    auto const factor = [&](int b, int k) { return b >> k & 1 ? at[k] : 1 - at[k]; };
    for (int b = 0; b < corners; ++b) {
      out.hat[b] = 1;
      for (int k = 0; k < d; ++k) out.hat[b] *= factor(b, k);
      for (int i = 0; i < d; ++i) out.slope[b][i] = (b >> i & 1 ? 1 : -1) * out.hat[b] / factor(b, i);
    }
    return out;
  }
  /// The part of a point in the integral of s.
  double inside(Point const& point, double const (*y)[d], double const* height, double weight,
                double (*f)[d]) const {
    Matrix<double, d, d> F = Matrix<double, d, d>::Zero();
    double s = 0;
    for (int b = 0; b < corners; ++b) {
      s += point.hat[b] * height[b];
      for (int a = 0; a < d; ++a)
        for (int i = 0; i < d; ++i) F(a, i) += y[b][a] * point.slope[b][i];
    }
    double const J = small_determinant(F), part = weight / corners;
    if (f) {
      Matrix<double, d, d> const C = cofactors(F);
      for (int b = 0; b < corners; ++b)
        for (int a = 0; a < d; ++a) {
          double slope = J * up_[a] * point.hat[b];
          for (int i = 0; i < d; ++i) slope += s * C(a, i) * point.slope[b][i];
          f[b][a] -= part * slope;
        }
    }
    return part * s * J;
  }
  /// (e.a) D of a facet.
  double on_facet(std::array<int, 4> const& at, double const (*y)[d], double const* height, double weight,
                  double (*f)[d]) const {
    constexpr int count = d == 2 ? 2 : 4;
    // Signs of xi, eta and xi eta at the corners, and what D has of the square of each.
    constexpr double signs[3][4] = {{-1, 1, 1, -1}, {-1, -1, 1, 1}, {1, -1, 1, -1}};
    constexpr double of_square[3] = {1.0 / 3, 1.0 / 3, 4.0 / 9};
    double D = 0, by_height[count] = {};
    for (int mode = 0; mode < (d == 2 ? 1 : 3); ++mode) {
      double p = 0;
      for (int k = 0; k < count; ++k) p += signs[mode][k] * height[at[k]] / count;
      D += of_square[mode] * p * p;
      for (int k = 0; k < count; ++k) by_height[k] += 2 * of_square[mode] * p * signs[mode][k] / count;
    }
    double area, by_place[count][d];
    if constexpr (d == 2) {
      // The edge, turned to the right.
      area = (y[at[1]][1] - y[at[0]][1]) * up_[0] - (y[at[1]][0] - y[at[0]][0]) * up_[1];
      by_place[1][0] = -up_[1], by_place[1][1] = up_[0];
      for (int a = 0; a < 2; ++a) by_place[0][a] = -by_place[1][a];
    } else {
      double u[3], v[3];  // half the diagonals
      for (int a = 0; a < 3; ++a) u[a] = 0.5 * (y[at[2]][a] - y[at[0]][a]), v[a] = y[at[3]][a] - y[at[1]][a];
      auto const by_u = detail::cross(v, up_.data()), by_v = detail::cross(up_.data(), u);
      area = detail::dot(u, by_u.data());
      for (int a = 0; a < 3; ++a) {
        by_place[2][a] = 0.5 * by_u[a], by_place[0][a] = -by_place[2][a];
        by_place[3][a] = by_v[a], by_place[1][a] = -by_v[a];
      }
    }
    for (int k = 0; f && k < count; ++k)
      for (int a = 0; a < d; ++a) f[at[k]][a] -= weight * (D * by_place[k][a] + area * by_height[k] * up_[a]);
    return weight * area * D;
  }
};

}  // namespace actio::media
