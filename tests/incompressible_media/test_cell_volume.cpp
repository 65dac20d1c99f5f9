// Volumes of cells and their slopes: against integrals by Gauss' rule, quotients of differences and known
// areas; and the symmetries on which momenta rest.
#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <numbers>
#include <random>

#include "actio/incompressible_media/cell_weight.hpp"
#include "actio/incompressible_media/mesh_volumes.hpp"

using namespace actio::media;

namespace {
std::mt19937 generator(1);
double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(generator); }

/// Corners of a cell near the unit square or cube.
template <class Cell>
struct Corners {
  double y[Cell::corners][Cell::space];
  Corners() {
    for (int b = 0; b < Cell::corners; ++b) {
      for (int a = 0; a < Cell::space; ++a) y[b][a] = (a < Cell::body ? b >> a & 1 : 2) + uniform(-0.2, 0.2);
      if constexpr (Cell::space > Cell::body) {
        double const size = std::hypot(y[b][0], y[b][1], y[b][2]);
        for (double& one : y[b]) one /= size;
      }
    }
  }
};

/// The integral of s to some power times the Jacobian over a cell with multilinear map, by Gauss' rule with
/// two points along each direction, which is exact for it.
template <int d>
double by_gauss(double const (*y)[d], int power, double const* up) {
  double sum = 0;
  for (int g = 0; g < 1 << d; ++g) {
    double hat[1 << d], place[d] = {}, slope[d][d] = {};
    double at[d];
    for (int k = 0; k < d; ++k) at[k] = 0.5 + (g >> k & 1 ? 0.5 : -0.5) / std::sqrt(3.0);
    for (int b = 0; b < 1 << d; ++b) {
      hat[b] = 1;
      for (int k = 0; k < d; ++k) hat[b] *= b >> k & 1 ? at[k] : 1 - at[k];
      for (int a = 0; a < d; ++a) {
        place[a] += hat[b] * y[b][a];
        for (int i = 0; i < d; ++i) {
          double rate = b >> i & 1 ? 1 : -1;
          for (int k = 0; k < d; ++k)
            if (k != i) rate *= b >> k & 1 ? at[k] : 1 - at[k];
          slope[a][i] += rate * y[b][a];
        }
      }
    }
    double J;
    if constexpr (d == 2)
      J = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
    else
      J = slope[0][0] * (slope[1][1] * slope[2][2] - slope[1][2] * slope[2][1]) -
          slope[0][1] * (slope[1][0] * slope[2][2] - slope[1][2] * slope[2][0]) +
          slope[0][2] * (slope[1][0] * slope[2][1] - slope[1][1] * slope[2][0]);
    double s = 0;
    for (int a = 0; a < d; ++a) s += up[a] * place[a];
    sum += J / (1 << d) * std::pow(s, power);
  }
  return sum;
}

/// Slopes against quotients of central differences, and the momenta that they exert.
template <class Cell>
void slopes_are_derivatives() {
  for (int trial = 0; trial < 20; ++trial) {
    Corners<Cell> cell;
    double slope[Cell::corners][Cell::space];
    double const volume = Cell::volume(cell.y, slope);
    BOOST_TEST(std::abs(volume - Cell::volume(cell.y)) <= 4e-16);
    double push[3] = {}, turn[3] = {};
    for (int b = 0; b < Cell::corners; ++b) {
      double at[3] = {}, f[3] = {};
      for (int a = 0; a < Cell::space; ++a) {
        at[a] = cell.y[b][a], f[a] = slope[b][a], push[a] += f[a];
        auto const moved = [&](double by) {
          auto other = cell;
          other.y[b][a] += by;
          if constexpr (Cell::space > Cell::body) {
            double const size = std::hypot(other.y[b][0], other.y[b][1], other.y[b][2]);
            for (double& one : other.y[b]) one /= size;
          }
          return Cell::volume(other.y);
        };
        double const h = 1e-4,
                     quotient = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
        BOOST_TEST(std::abs(quotient - f[a]) <= 1e-11);
      }
      auto const c = detail::cross(at, f);
      for (int a = 0; a < 3; ++a) turn[a] += c[a];
    }
    for (int a = 0; a < 3; ++a) {
      if (Cell::space == Cell::body) BOOST_TEST(std::abs(push[a]) <= 1e-15);
      BOOST_TEST(std::abs(turn[a]) <= 2e-15);
    }
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(cell_volume)

BOOST_AUTO_TEST_CASE(slopes_are_derivatives_and_exert_no_force_and_no_torque) {
  slopes_are_derivatives<PlaneCell>();
  slopes_are_derivatives<SpaceCell>();
  slopes_are_derivatives<SphereCell>();
}

BOOST_AUTO_TEST_CASE(volumes_are_integrals_of_the_jacobian) {
  for (int trial = 0; trial < 50; ++trial) {
    Corners<PlaneCell> plane;
    Corners<SpaceCell> space;
    double const up[3] = {0, 0, 1};
    BOOST_TEST(std::abs(PlaneCell::volume(plane.y) - by_gauss<2>(plane.y, 0, up)) <= 1e-15);
    BOOST_TEST(std::abs(SpaceCell::volume(space.y) - by_gauss<3>(space.y, 0, up)) <= 1e-15);
  }
  // An eighth of the sphere less a half: the triangle of the axes cut at its middle.
  double const r = 1 / std::sqrt(2.0);
  double const cell[4][3] = {
      {1, 0, 0}, {r, r, 0}, {r, 0, r}, {1 / std::sqrt(3.0), 1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}};
  BOOST_TEST(std::abs(SphereCell::volume(cell) - std::numbers::pi / 6) <= 1e-15);
}

// The mean of the Jacobians at the corners is not the volume of a hexahedron: the sum over cells between
// fixed walls depends on the nodes inside, so that it could not be kept cell by cell.
BOOST_AUTO_TEST_CASE(corner_means_of_hexahedra_do_not_add_up_between_walls) {
  auto mesh = box_mesh({0, 0, 0}, {3, 3, 3}, {3, 3, 3});
  for (auto& X : mesh.nodes) {
    bool inside = true;
    for (double const one : X) inside = inside && one > 0.5 && one < 2.5;
    if (inside)
      for (double& one : X) one += uniform(-0.2, 0.2);
  }
  MeshVolumes<SpaceCell> const volumes(mesh);
  std::vector<double> y, exact;
  for (auto const& X : mesh.nodes) y.insert(y.end(), X.begin(), X.end());
  volumes.volumes({y, {}}, exact, volumes.all());
  double sum = 0, by_corners = 0;
  for (double const one : exact) sum += one;
  for (double const one : volumes.corner_jacobians(y)) by_corners += one / 8;
  BOOST_TEST(std::abs(sum - 27) <= 1e-13);
  BOOST_TEST(std::abs(by_corners - 27) >= 1e-4);
  BOOST_TEST_MESSAGE("27 cells between walls: volumes add up to 27 + "
                     << sum - 27 << ", corner means to 27 + " << by_corners - 27);
}

BOOST_AUTO_TEST_CASE(the_weight_is_that_of_the_cell_and_its_force_the_derivative) {
  for (int trial = 0; trial < 20; ++trial) {
    auto const exact = [&]<int d>(auto const& cell, std::array<double, d> const& g) {
      using Cell = std::decay_t<decltype(cell)>;
      auto const mesh = d == 2 ? box_mesh({0, 0}, {1, 1}, {1, 1}) : box_mesh({0, 0, 0}, {1, 1, 1}, {1, 1, 1});
      CellWeight<d> const weight(mesh, g, {2.0});
      double f[1 << d][d] = {};
      weight.of_cell(0, cell.y, f);
      for (int b = 0; b < 1 << d; ++b)
        for (int a = 0; a < d; ++a) {
          auto const moved = [&](double by) {
            Cell other = cell;
            other.y[b][a] += by;
            return weight.of_cell(0, other.y, nullptr);
          };
          double const h = 1e-3,
                       slope = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
          BOOST_TEST(std::abs(slope + f[b][a]) <= 1e-11);
        }
      // A translation lifts the whole weight.
      for (int a = 0; a < d; ++a) {
        double sum = 0;
        for (int b = 0; b < 1 << d; ++b) sum += f[b][a];
        double volume;
        if constexpr (d == 2)
          volume = PlaneCell::volume(cell.y);
        else
          volume = SpaceCell::volume(cell.y);
        BOOST_TEST(std::abs(sum - 2 * volume * g[a]) <= 1e-14);
      }
    };
    exact.template operator()<2>(Corners<PlaneCell>{}, {0.3, -0.8});
    exact.template operator()<3>(Corners<SpaceCell>{}, {0.3, -0.8, 0.5});
  }
  // Of a parallelogram the energy is that of its centre.
  double const y[4][2] = {{0, 0}, {2, 0.5}, {0.3, 1}, {2.3, 1.5}};
  CellWeight<2> const weight(box_mesh({0, 0}, {1, 1}, {1, 1}), {0, -9.81}, {1.0});
  BOOST_TEST(std::abs(weight.of_cell(0, y, nullptr) - 9.81 * PlaneCell::volume(y) * 0.75) <= 1e-14);
}

// Cells of one density share facets that cancel: nodes inside feel no weight.
BOOST_AUTO_TEST_CASE(a_homogeneous_medium_is_heavy_at_its_rim_alone) {
  auto mesh = box_mesh({0, 0, 0}, {3, 3, 3}, {3, 3, 3});
  for (auto& X : mesh.nodes)
    for (double& one : X) one += uniform(-0.1, 0.1);
  MeshVolumes<SpaceCell> const volumes(mesh);
  CellWeight<3> const weight(mesh, {0, 0, -1}, std::vector<double>(27, 1.0));
  std::vector<double> y, f(3 * mesh.nodes.size(), 0);
  for (auto const& X : mesh.nodes) y.insert(y.end(), X.begin(), X.end());
  for (std::size_t cell = 0; cell < 27; ++cell) {
    double at[8][3], on[8][3] = {};
    volumes.gather(y, cell, at), weight.of_cell(cell, at, on);
    for (int b = 0; b < 8; ++b)
      for (int a = 0; a < 3; ++a) f[3 * volumes.node(cell, b) + a] += on[b][a];
  }
  int inside = 0;
  for (int node = 0; node < 64; ++node) {
    bool const inner = node % 4 % 3 != 0 && node / 4 % 4 % 3 != 0 && node / 16 % 3 != 0;
    double const size = std::hypot(f[3 * node], f[3 * node + 1], f[3 * node + 2]);
    if (!inner) continue;
    BOOST_TEST(size <= 1e-14);
    ++inside;
  }
  BOOST_TEST(inside == 8);
}

// The table of kernels: how many combinations of volumes of equal squares or cubes nothing can change, to
// first order.
BOOST_AUTO_TEST_CASE(the_kernel_of_the_slopes_is_that_of_the_table) {
  auto const kernel = [](BodyMesh const& mesh, auto const& held) {
    auto const count = [&]<class Cell>(Cell) {
      MeshVolumes<Cell> const volumes(mesh);
      std::vector<double> y, slopes;
      for (auto const& X : mesh.nodes) y.insert(y.end(), X.begin(), X.begin() + Cell::space);
      volumes.slopes({y, {}}, slopes, volumes.all());
      Eigen::MatrixXd G =
          Eigen::MatrixXd::Zero(static_cast<long>(volumes.cells()), static_cast<long>(y.size()));
      for (std::size_t cell = 0; cell < volumes.cells(); ++cell)
        for (int b = 0; b < Cell::corners; ++b)
          for (int a = 0; a < Cell::space; ++a) {
            long const at = Cell::space * volumes.node(cell, b) + a;
            if (!held(mesh.nodes[static_cast<std::size_t>(volumes.node(cell, b))], a))
              G(static_cast<long>(cell), at) += slopes[(cell * Cell::corners + b) * Cell::space + a];
          }
      Eigen::FullPivLU<Eigen::MatrixXd> lu(G);
      lu.setThreshold(1e-9);
      return static_cast<int>(G.rows() - lu.rank());
    };
    return mesh.dimension == 2 ? count(PlaneCell{}) : count(SpaceCell{});
  };
  auto const free = [](auto const&, int) { return false; };
  for (int const n : {4, 5}) {
    std::vector<double> const low2{0, 0}, up2(2, n), low3{0, 0, 0}, up3(3, n);
    std::vector<int> const cells2(2, n), cells3(3, n);
    auto const at_wall = [n](double x) { return x == 0 || x == n; };
    auto const slip = [&](auto const& X, int a) { return at_wall(X[static_cast<std::size_t>(a)]); };
    auto const rim2 = [&](auto const& X, int) { return at_wall(X[0]) || at_wall(X[1]); };
    auto const rim3 = [&](auto const& X, int) { return at_wall(X[0]) || at_wall(X[1]) || at_wall(X[2]); };
    bool const even = n % 2 == 0;
    BOOST_TEST(kernel(box_mesh(low2, up2, cells2), free) == 0);
    BOOST_TEST(kernel(box_mesh(low2, up2, cells2), slip) == 1);
    BOOST_TEST(kernel(box_mesh(low2, up2, cells2), rim2) == 2);
    BOOST_TEST(kernel(box_mesh(low2, up2, cells2, {true, true}), free) == (even ? 2 : 1));
    BOOST_TEST(kernel(box_mesh(low3, up3, cells3), free) == 0);
    BOOST_TEST(kernel(box_mesh(low3, up3, cells3), slip) == 1);
    BOOST_TEST(kernel(box_mesh(low3, up3, cells3), rim3) == 3 * n - 1);
    BOOST_TEST(kernel(box_mesh(low3, up3, cells3, {true, true, true}), free) == (even ? 3 * n - 1 : 1));
  }
}

BOOST_AUTO_TEST_SUITE_END()
