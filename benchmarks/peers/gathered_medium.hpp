// The same scheme for media as anybody would write it, in the plane and in space: nodes in a list, cells that
// name theirs, a deformation gradient at each corner, its stress in matrices of Eigen, forces gathered and
// scattered.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

namespace peers {

template <int n>
using Gradient = Eigen::Matrix<double, n, n>;

/// The transposed inverse times the determinant.
template <int n>
Gradient<n> cofactors(Gradient<n> const& F) {
  Gradient<n> c;
  if constexpr (n == 2)
    c << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  else
    c << F.col(1).cross(F.col(2)), F.col(2).cross(F.col(0)), F.col(0).cross(F.col(1));
  return c;
}
/// A polytropic gas: dW/dF.
struct GasStress {
  double K, gamma;
  template <int n>
  Gradient<n> operator()(Gradient<n> const& F) const {
    return -K * std::pow(F.determinant(), -gamma) * cofactors(F);
  }
};
/// The same with the exponent 2.
struct GasOfTwoStress {
  double K;
  template <int n>
  Gradient<n> operator()(Gradient<n> const& F) const {
    double const J = F.determinant();
    return -K / (J * J) * cofactors(F);
  }
};
/// St Venant and Kirchhoff's solid.
struct StVenantKirchhoffStress {
  double lambda, mu;
  template <int n>
  Gradient<n> operator()(Gradient<n> const& F) const {
    Gradient<n> const E = 0.5 * (F.transpose() * F - Gradient<n>::Identity());
    return F * (lambda * E.trace() * Gradient<n>::Identity() + 2 * mu * E);
  }
};
/// A neo-Hookean solid, the volume by the logarithm.
struct NeoHookeanStress {
  double lambda, mu;
  template <int n>
  Gradient<n> operator()(Gradient<n> const& F) const {
    double const J = F.determinant();
    return mu * F + (lambda * std::log(J) - mu) / J * cofactors(F);
  }
};
/// The same, the volume by its square.
struct NeoHookeanSquareStress {
  double mu, kappa;
  template <int n>
  Gradient<n> operator()(Gradient<n> const& F) const {
    double const J = F.determinant();
    return mu * F + (kappa * (J - 1) - mu / J) * cofactors(F);
  }
};
/// Blatz and Ko's solid with m = 1.
struct BlatzKoStress {
  double mu;
  template <int n>
  Gradient<n> operator()(Gradient<n> const& F) const {
    return mu * F - mu * std::pow(F.determinant(), -3) * cofactors(F);
  }
};

/// A medium on cells of one size, in n dimensions.
template <class Stress, int n>
class GatheredMedium {
 public:
  static constexpr int corners = 1 << n;
  using Vector = Eigen::Matrix<double, n, 1>;
  /// A cell: its nodes, bit d of whose number says that it is at the upper end along direction d, and how far
  /// each is from where the cell has it.
  struct Cell {
    std::array<int, corners> node;
    std::array<Vector, corners> shift;
  };
  Stress stress;
  Vector h;
  double dt;
  std::vector<Cell> cells;
  std::vector<Vector> x, v;      ///< places, and velocities half a step back
  std::vector<Vector> response;  ///< per node: one over its reference measure, 0 where it is held

  /// Forces per mass density at the present places.
  std::vector<Vector> forces() const {
    std::vector<Vector> f(x.size(), Vector::Zero());
    for (Cell const& cell : cells) {
      Vector p[corners];
      for (std::size_t k = 0; k < corners; ++k)
        p[k] = x[static_cast<std::size_t>(cell.node[k])] + cell.shift[k];
      for (int corner = 0; corner < corners; ++corner) {
        // The edges that meet at this corner.
        Gradient<n> F;
        for (int d = 0; d < n; ++d) F.col(d) = (p[corner | 1 << d] - p[corner & ~(1 << d)]) / h[d];
        Gradient<n> const P = h.prod() / corners * stress(F);
        for (int d = 0; d < n; ++d) {
          f[index(cell, corner & ~(1 << d))] += P.col(d) / h[d];
          f[index(cell, corner | 1 << d)] -= P.col(d) / h[d];
        }
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

/// On a box of the optimised implementation, from the places and velocities of its nodes, row by row.
/// @param box  has `dimension`, `cells`, `spacing`, `nodes`, `periodic`, `period`, `response`
template <class Stress, class Box, class Points>
auto gathered(Stress const& stress, Box const& box, double dt, Points const& x, Points const& v) {
  constexpr int n = Box::dimension;
  using Medium = GatheredMedium<Stress, n>;
  using Vector = typename Medium::Vector;
  Medium out{stress, Vector(box.spacing.data()), dt, {}, {}, {}, {}};
  auto const period = [&](int d) -> Vector {
    Vector const given(box.period[static_cast<std::size_t>(d)].data());
    return given.isZero(0) ? Vector(Vector::Unit(d) * box.cells[d] * box.spacing[d]) : given;
  };
  auto const each = [&](auto const& count, auto const& visit) {
    int all = 1;
    for (int d = 0; d < n; ++d) all *= count(d);
    for (int k = 0; k < all; ++k) {
      std::array<int, n> at;
      for (int d = 0, rest = k; d < n; rest /= count(d), ++d) at[d] = rest % count(d);
      visit(at);
    }
  };
  each([&](int d) { return box.cells[d]; },
       [&](std::array<int, n> const& at) {
         typename Medium::Cell cell;
         for (int k = 0; k < Medium::corners; ++k) {
           auto const to = static_cast<std::size_t>(k);
           cell.node[to] = 0, cell.shift[to].setZero();
           for (int d = n - 1; d >= 0; --d) {
             int const i = at[d] + (k >> d & 1);
             cell.node[to] = cell.node[to] * box.nodes(d) + i % box.nodes(d);
             if (i == box.nodes(d)) cell.shift[to] += period(d);
           }
         }
         out.cells.push_back(cell);
       });
  each([&](int d) { return box.nodes(d); },
       [&](std::array<int, n> const& at) {
         Vector response;
         for (int c = 0; c < n; ++c) response[c] = box.response(at, c);
         out.response.push_back(response);
       });
  for (std::size_t k = 0; k < x.size(); ++k) out.x.emplace_back(x[k].data()), out.v.emplace_back(v[k].data());
  out.kick(-0.5);
  return out;
}

}  // namespace peers
