// The same scheme for media in the plane as anybody would write it: nodes in a list, cells that name theirs,
// a deformation gradient at each corner, its stress in matrices of Eigen, forces gathered and scattered.
#pragma once

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

namespace peers {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// The transposed inverse times the determinant.
inline Matrix2d cofactors(Matrix2d const& F) {
  Matrix2d c;
  c << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  return c;
}
/// A polytropic gas: dW/dF.
struct GasStress {
  double K, gamma;
  Matrix2d operator()(Matrix2d const& F) const {
    return -K * std::pow(F.determinant(), -gamma) * cofactors(F);
  }
};
/// The same with the exponent 2.
struct GasOfTwoStress {
  double K;
  Matrix2d operator()(Matrix2d const& F) const {
    double const J = F.determinant();
    return -K / (J * J) * cofactors(F);
  }
};
/// St Venant and Kirchhoff's solid.
struct StVenantKirchhoffStress {
  double lambda, mu;
  Matrix2d operator()(Matrix2d const& F) const {
    Matrix2d const E = 0.5 * (F.transpose() * F - Matrix2d::Identity());
    return F * (lambda * E.trace() * Matrix2d::Identity() + 2 * mu * E);
  }
};
/// A neo-Hookean solid, the volume by the logarithm.
struct NeoHookeanStress {
  double lambda, mu;
  Matrix2d operator()(Matrix2d const& F) const {
    double const J = F.determinant();
    return mu * F + (lambda * std::log(J) - mu) / J * cofactors(F);
  }
};
/// Blatz and Ko's solid with m = 1.
struct BlatzKoStress {
  double mu;
  Matrix2d operator()(Matrix2d const& F) const {
    return mu * F - mu * std::pow(F.determinant(), -3) * cofactors(F);
  }
};

/// A medium on cells of one size.
template <class Stress>
class GatheredMedium {
 public:
  /// A cell: its nodes (left below, right below, left above, right above), and how far each is from where the
  /// cell has it.
  struct Cell {
    std::array<int, 4> node;
    std::array<Vector2d, 4> shift;
  };
  Stress stress;
  double h1, h2, dt;
  std::vector<Cell> cells;
  std::vector<Vector2d> x, v;  ///< places, and velocities half a step back
  std::vector<Vector2d>
      response;  ///< per node and component: one over its reference area, 0 where it is held

  /// Forces per mass density at the present places.
  std::vector<Vector2d> forces() const {
    std::vector<Vector2d> f(x.size(), Vector2d::Zero());
    for (Cell const& cell : cells) {
      Vector2d p[4];
      for (std::size_t k = 0; k < 4; ++k) p[k] = x[static_cast<std::size_t>(cell.node[k])] + cell.shift[k];
      for (int corner = 0; corner < 4; ++corner) {
        // The edges that meet at this corner.
        int const row = corner & 2, column = corner & 1;
        Matrix2d F;
        F.col(0) = (p[row + 1] - p[row]) / h1;
        F.col(1) = (p[column + 2] - p[column]) / h2;
        Matrix2d const P = h1 * h2 / 4 * stress(F);
        f[index(cell, row)] += P.col(0) / h1, f[index(cell, row + 1)] -= P.col(0) / h1;
        f[index(cell, column)] += P.col(1) / h2, f[index(cell, column + 2)] -= P.col(1) / h2;
      }
    }
    return f;
  }
  /// v += share dt a(x): with share 1 the kick of a step.
  void kick(double share) {
    auto const f = forces();
    for (std::size_t k = 0; k < x.size(); ++k) v[k] += share * dt * response[k].cwiseProduct(f[k]);
  }
  void step() {
    kick(1);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += dt * v[k];
  }

 private:
  static std::size_t index(Cell const& cell, int corner) {
    return static_cast<std::size_t>(cell.node[static_cast<std::size_t>(corner)]);
  }
};

/// On a box of the fast road, from the places and velocities of its nodes, row by row.
/// @param box  has `cells`, `spacing`, `nodes`, `periodic`, `shift`, `response`
template <class Stress, class Box, class Points>
GatheredMedium<Stress> gathered(Stress const& stress, Box const& box, double dt, Points const& x,
                                Points const& v) {
  GatheredMedium<Stress> out{stress, box.spacing[0], box.spacing[1], dt, {}, {}, {}, {}};
  int const n1 = box.nodes(0), n2 = box.nodes(1);
  for (int j = 0; j < box.cells[1]; ++j)
    for (int i = 0; i < box.cells[0]; ++i) {
      typename GatheredMedium<Stress>::Cell cell;
      for (int k = 0; k < 4; ++k) {
        int const a = i + k % 2, b = j + k / 2;
        auto const to = static_cast<std::size_t>(k);
        cell.node[to] = b % n2 * n1 + a % n1;
        cell.shift[to].setZero();
        if (a >= n1) cell.shift[to] += Vector2d(box.shift(0).x, box.shift(0).y);
        if (b >= n2) cell.shift[to] += Vector2d(box.shift(1).x, box.shift(1).y);
      }
      out.cells.push_back(cell);
    }
  for (int j = 0, k = 0; j < n2; ++j)
    for (int i = 0; i < n1; ++i, ++k) {
      auto const at = static_cast<std::size_t>(k);
      out.x.emplace_back(x[at][0], x[at][1]), out.v.emplace_back(v[at][0], v[at][1]);
      out.response.emplace_back(box.response(i, j, 0), box.response(i, j, 1));
    }
  out.kick(-0.5);
  return out;
}

}  // namespace peers
