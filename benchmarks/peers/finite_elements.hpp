// The explicit step of finite elements for the same media: multilinear shape functions, two Gauss points
// along each direction, lumped masses, central differences in time. It is what codes of elastodynamics do for
// bricks with full integration; the scheme of the library has its points at the corners instead.
#pragma once

#include "peers/gathered_medium.hpp"

namespace peers {

/// Elements on the nodes and cells of a gathered medium, all of one size.
template <class Stress, int n>
class FiniteElements {
 public:
  using Medium = GatheredMedium<Stress, n>;
  using Vector = typename Medium::Vector;
  static constexpr int corners = Medium::corners;
  Medium medium;

  explicit FiniteElements(Medium start) : medium(std::move(start)) {
    // Gradients of the shape functions, the same in every cell.
    for (int point = 0; point < corners; ++point)
      for (int k = 0; k < corners; ++k) {
        auto const along = [&](int d) {
          double const xi = (point >> d & 1 ? 1 : -1) / std::sqrt(3.0);
          return (1 + (k >> d & 1 ? xi : -xi)) / 2;
        };
        for (int d = 0; d < n; ++d) {
          double slope = (k >> d & 1 ? 1 : -1) / medium.h[d];
          for (int other = 0; other < n; ++other)
            if (other != d) slope *= along(other);
          slopes_[point](d, k) = slope;
        }
      }
  }

  /// Forces per mass density at the present positions.
  std::vector<Vector> forces() const {
    std::vector<Vector> f(medium.x.size(), Vector::Zero());
    for (auto const& cell : medium.cells) {
      Eigen::Matrix<double, n, corners> p, out = Eigen::Matrix<double, n, corners>::Zero();
      for (int k = 0; k < corners; ++k)
        p.col(k) = medium.x[node(cell, k)] + cell.shift[static_cast<std::size_t>(k)];
      for (auto const& slopes : slopes_) {
        Gradient<n> const F = p * slopes.transpose();
        out.noalias() -= medium.h.prod() / corners * medium.stress(F) * slopes;
      }
      for (int k = 0; k < corners; ++k) f[node(cell, k)] += out.col(k);
    }
    return f;
  }
  void step() {
    auto const f = forces();
    for (std::size_t k = 0; k < medium.x.size(); ++k) {
      medium.v[k] += medium.dt * medium.response[k].cwiseProduct(f[k]);
      medium.x[k] += medium.dt * medium.v[k];
    }
  }

 private:
  static std::size_t node(typename Medium::Cell const& cell, int k) {
    return static_cast<std::size_t>(cell.node[static_cast<std::size_t>(k)]);
  }
  std::array<Eigen::Matrix<double, n, corners>, corners> slopes_;
};

/// How far the forces of both schemes are apart, relative to the largest: rounding where the gradient of the
/// deformation is the same everywhere.
template <class Stress, int n>
double forces_apart(GatheredMedium<Stress, n> const& medium) {
  auto const a = medium.forces(), b = FiniteElements<Stress, n>(medium).forces();
  double apart = 0, largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    apart = std::max(apart, (a[k] - b[k]).norm()), largest = std::max(largest, a[k].norm());
  return apart / largest;
}

}  // namespace peers
