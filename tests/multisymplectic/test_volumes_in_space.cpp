// Hexahedra that are no parallelepipeds: exact volumes and mean gradients, the patch test, rigid motions,
// gases at rest, and what a motion conserves.
#include <boost/test/unit_test.hpp>

#include <set>

#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "actio/meshes/body_mesh_check.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "plain_body.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Q = Number;

/// St Venant and Kirchhoff's solid, of the strains.
struct StVenant {
  template <class F>
  auto operator()(F const& f) const {
    auto E = f.transpose() * f;
    for (int k = 0; k < E.rows(); ++k) E(k, k) -= 1.0;
    auto const trace = E.trace();
    return trace * trace * 0.125 + E.squaredNorm() * 0.25;
  }
};
/// A gas with the pressure 0.4 in its reference places.
struct Gas {
  template <class F>
  auto operator()(F const& f) const { return 0.4 / small_determinant(f); }
};

/// A cube with every corner moved.
template <class S>
Matrix<S, 3, 8> bent_cube(Draw& draw) {
  Matrix<S, 3, 8> X;
  for (int b = 0; b < 8; ++b)
    for (int i = 0; i < 3; ++i) X(i, b) = S(b >> i & 1) + S(int(draw.below(41)) - 20) / S(100);
  return X;
}

/// The integral over the cube of det times one, and times the slopes of the hat functions, by Simpson's rule,
/// which is exact for third powers of each coordinate: these have second ones.
struct BySimpson {
  Q volume{0};
  Matrix<Q, 3, 8> slopes = Matrix<Q, 3, 8>::Zero();
  explicit BySimpson(Matrix<Q, 3, 8> const& X) {
    for (int k = 0; k < 27; ++k) {
      int const at[] = {k % 3, k / 3 % 3, k / 9};
      Matrix<Q, 3, 8> hats;
      Q w(1);
      for (int const one : at) w *= (one == 1 ? Q(4) : Q(1)) / 6;
      for (int b = 0; b < 8; ++b)
        for (int i = 0; i < 3; ++i) {
          hats(i, b) = b >> i & 1 ? 1 : -1;
          for (int j = 0; j < 3; ++j)
            if (j != i) hats(i, b) *= (b >> j & 1 ? Q(at[j]) : Q(2 - at[j])) / 2;
        }
      Matrix<Q, 3, 3> const A = X * hats.transpose();
      volume += w * determinant(A), slopes += cofactors(A) * hats * w;
    }
  }
};

/// Each tetrahedron cut into four hexahedra, as Gmsh does: one at each of its corners.
BodyMesh cut_into_hexahedra(BodyMesh const& of) {
  BodyMesh mesh;
  mesh.dimension = 3, mesh.shape = CellShape::hexahedron;
  std::map<std::set<int>, int> centres;
  auto const centre = [&](std::set<int> const& corners) {
    auto const [at, is_new] = centres.try_emplace(corners, int(mesh.nodes.size()));
    if (is_new) {
      std::array<double, 3> X{};
      for (int const one : corners)
        for (std::size_t a = 0; a < 3; ++a) X[a] += of.nodes[std::size_t(one)][a] / double(corners.size());
      mesh.nodes.push_back(X);
    }
    return at->second;
  };
  for (auto const& c : of.cells)
    // Three others, such that edges to them have a positive determinant.
    for (auto const& [v, p, q, r] : {std::tuple(c[0], c[1], c[2], c[3]),
                                     {c[1], c[0], c[3], c[2]},
                                     {c[2], c[0], c[1], c[3]},
                                     {c[3], c[0], c[2], c[1]}})
      mesh.cells.push_back({centre({v}), centre({v, p}), centre({v, q}), centre({v, p, q}), centre({v, r}),
                            centre({v, p, r}), centre({v, q, r}), centre({v, p, q, r})});
  require_body_mesh(mesh);
  return mesh;
}
/// A box of cubes, each cut into six tetrahedra around its diagonal, with its nodes moved.
BodyMesh tetrahedra(int n, Draw& draw) {
  auto const box = box_mesh({0, 0, 0}, {1, 1, 1}, {n, n, n});
  BodyMesh mesh;
  mesh.dimension = 3, mesh.shape = CellShape::tetrahedron, mesh.nodes = box.nodes;
  for (auto const& c : box.cells)
    for (auto const& [i, j] : {std::pair(1, 2), {2, 4}, {4, 1}})
      mesh.cells.push_back({c[0], c[i], c[i + j], c[7]}), mesh.cells.push_back({c[0], c[i + j], c[j], c[7]});
  for (auto& X : mesh.nodes)
    for (double& x : X)
      if (x > 0 && x < 1) x += 0.2 / n * draw.number<double>();
  require_body_mesh(mesh);
  return mesh;
}
BodyMesh moved(BodyMesh mesh, double by, Draw& draw) {
  for (auto& node : mesh.nodes)
    for (int a = 0; a < mesh.dimension; ++a) node[std::size_t(a)] += by * draw.number<double>();
  return mesh;
}

/// Whether a node lies on a facet of one cell alone.
std::vector<bool> rim_of(BodyMesh const& mesh) {
  std::map<std::set<int>, int> count;
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    for (int f = 0; f < facet_count(mesh.shape); ++f) {
      auto const nodes = facet_nodes(mesh, {cell, f});
      ++count[{nodes.begin(), nodes.end()}];
    }
  std::vector<bool> rim(mesh.nodes.size(), false);
  for (auto const& [nodes, times] : count)
    for (int const node : nodes)
      if (times == 1 && node >= 0) rim[std::size_t(node)] = true;
  return rim;
}
/// Bodies of every kind of cells.
template <class F>
void on_every_body(F const& f) {
  Draw draw(11);
  f.template operator()<2>("disc", disc_mesh(1, {3, 4}));
  f.template operator()<2>("annulus", annulus_mesh(1, 2, {3, 9}));
  f.template operator()<2>("quadrilaterals", moved(box_mesh({0, 0}, {1, 1}, {4, 4}), 0.06, draw));
  f.template operator()<3>("ball", ball_mesh(1, {2, 3}));
  f.template operator()<3>("shell", shell_mesh(1, 2, {3, 3}));
  f.template operator()<3>("hexahedra", moved(box_mesh({0, 0, 0}, {1, 1, 1}, {4, 4, 4}), 0.06, draw));
  f.template operator()<3>("tetrahedra", tetrahedra(3, draw));
  f.template operator()<3>("tetrahedra cut into hexahedra", cut_into_hexahedra(tetrahedra(2, draw)));
}
/// Nodes at F X.
template <int d>
List<double> homogeneous(BodyMesh const& mesh, Matrix<double, d, d> const& F) {
  List<double> x;
  for (auto const& X : mesh.nodes)
    for (int a = 0; a < d; ++a) {
      x.push_back(0.3 * a);
      for (int i = 0; i < d; ++i) x.back() += F(a, i) * X[std::size_t(i)];
    }
  return x;
}
template <int d>
double volume_of(BodyMesh const& mesh) {
  PlainBody<d> plain{mesh};
  double sum = 0;
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    sum += plain.simplex ? plain.volume(cell, 0) : plain.integrals(cell, 2).first;
  return sum;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(volumes_in_space)

// In fractions, without a rounding.
BOOST_AUTO_TEST_CASE(corners_of_a_hexahedron_have_its_volume_and_its_mean_gradient) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Draw draw(7);
  for (int k = 0; k < 10; ++k) {
    auto const X = bent_cube<Q>(draw);
    auto const cell = cell_geometry<Q, 3>(X, "Q");
    BySimpson const exact(X);
    BOOST_TEST(cell.correction.any);
    Q volume(0);
    for (Q const& v : cell.volume) volume += v;
    BOOST_TEST((volume == exact.volume));
    // The slopes of the hat function of corner c: of the values 1 there and 0 elsewhere.
    for (int c = 0; c < 8; ++c) {
      Matrix<Q, 1, 8> hat = Matrix<Q, 1, 8>::Zero();
      hat(0, c) = 1;
      Matrix<Q, 1, 3> sum = Matrix<Q, 1, 3>::Zero();
      auto const common = cell.correction.common<Q, 1>([&](int b, int) { return hat(0, b); });
      for (int b = 0; b < 8; ++b)
        sum += (edges_at_corner<3>(hat, b) * cell.inverse_edges[std::size_t(b)] + common) *
               cell.volume[std::size_t(b)];
      for (int i = 0; i < 3; ++i) BOOST_TEST((sum(0, i) == exact.slopes(i, c)));
    }
    // Of an affine section K is zero.
    auto const none =
        cell.correction.common<Q, 2>([&](int b, int a) { return Q(a + 1) * X(0, b) - X(a, b) / 3 + 5; });
    for (int a = 0; a < 2; ++a)
      for (int i = 0; i < 3; ++i) BOOST_TEST((none(a, i) == 0));
  }
}

BOOST_AUTO_TEST_CASE(slopes_are_the_derivatives_of_the_logarithm_of_the_ratio) {
  Draw draw(8);
  auto const X = bent_cube<double>(draw);
  auto const slopes = corner_correction<double, 3>(X).slopes;
  for (int b = 0; b < 8; ++b)
    for (int i = 0; i < 3; ++i) {
      Matrix<Dual<double>, 3, 8> moving = X.cast<Dual<double>>();
      moving(i, b) = variable(X(i, b));
      auto const s = corner_correction<Dual<double>, 3>(moving).ratio;
      BOOST_TEST(std::abs(rate_of(s) / base_value(s) - slopes(i, b)) <= 100 * eps);
    }
}

BOOST_AUTO_TEST_CASE(parallelepipeds_have_no_correction_wherever_they_are) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Matrix<Q, 3, 8> exact;
  Matrix<double, 3, 8> far;
  for (int b = 0; b < 8; ++b) {
    int const u = b & 1, v = b >> 1 & 1, w = b >> 2;
    exact.col(b) = Matrix<Q, 3, 1>(Q(2 * u + v), Q(3 * v - u) / 7, Q(w) + Q(u) / 3);
    far.col(b) =
        Matrix<double, 3, 1>(1e6 + 0.1 * u + 0.07 * v, 0.3 * v - 0.02 * u, -1e5 + 0.2 * w + u / 30.0);
  }
  BOOST_TEST(!(corner_correction<Q, 3>(exact).any));
  BOOST_TEST(!(corner_correction<double, 3>(far).any));
  BodyQuadrature<3> const box(box_mesh({1, 2, 3}, {4, 6, 9}, {3, 7, 11}), *stored_energy<3>(Fibred{}),
                              [](auto const&) { return 1.0; });
  BOOST_TEST(box.corrections.empty());
}

BOOST_AUTO_TEST_CASE(every_body_has_the_mass_of_its_volume) {
  on_every_body([]<int d>(char const* name, BodyMesh const& mesh) {
    auto const law = stored_energy<d>(Fibred{});
    BodyQuadrature<d> const body(mesh, *law, [](auto const&) { return 1.5; });
    double mass = 0, volume = 0;
    for (double const one : body.masses) mass += one;
    for (auto const& point : body.points) volume += point.volume;
    double const exact = volume_of<d>(mesh);
    // Sums of at most a thousand terms, each rounded some tens of times.
    BOOST_TEST(std::abs(mass - 1.5 * exact) <= 1000 * eps * exact, name);
    BOOST_TEST(std::abs(volume - exact) <= 1000 * eps * exact, name);
  });
}

// The moments of a density of the second degree, by Gauss' rule, whatever the cells of a cube are.
BOOST_AUTO_TEST_CASE(a_density_that_varies_has_its_mass_in_every_cell) {
  Draw draw(12);
  auto const density = [](auto const& X) { return 1 + X[0] - 0.5 * X[1] * X[2] + 0.25 * X[0] * X[0]; };
  for (auto mesh : {cut_into_hexahedra(tetrahedra(2, draw)), box_mesh({0, 0, 0}, {1, 1, 1}, {3, 3, 3})}) {
    auto const rim = rim_of(mesh);
    for (std::size_t k = 0; k < rim.size(); ++k)
      for (double& x : mesh.nodes[k])
        if (!rim[k]) x += 0.004 * draw.number<double>();
    BodyQuadrature<3> const body(mesh, *stored_energy<3>(Fibred{}), density);
    double mass = 0;
    for (double const one : body.masses) mass += one;
    BOOST_TEST(std::abs(mass - (1 + 0.5 - 0.125 + 0.25 / 3)) <= 1000 * eps);
  }
}

BOOST_AUTO_TEST_CASE(inner_nodes_follow_a_homogeneous_motion_of_the_rim) {
  on_every_body([]<int d>(char const* name, BodyMesh const& mesh) {
    BodyForces<d> const forces(mesh, stored_energy<d>(Fibred{}), [](auto const&) { return 1.0; }, {});
    Matrix<double, d, d> F = Matrix<double, d, d>::Identity();
    for (int a = 0; a < d; ++a)
      for (int i = 0; i < d; ++i) F(a, i) += 0.1 * (a + 1) - 0.07 * i * a;
    auto const x = homogeneous<d>(mesh, F);
    List<double> f;
    forces.forces(x, 0, f);
    auto const rim = rim_of(mesh);
    double inside = 0, all = 0;
    int nodes = 0;
    for (std::size_t k = 0; k < f.size(); ++k) {
      all = std::max(all, std::abs(f[k]));
      if (!rim[k / d]) inside = std::max(inside, std::abs(f[k])), ++nodes;
    }
    BOOST_TEST(nodes > 0, name);
    // A force is a sum over at most some tens of cells, each with eight points rounded some ten times.
    BOOST_TEST(inside <= 300 * eps * all, name);
    double const exact = volume_of<d>(mesh) * Fibred{}(F);
    BOOST_TEST(std::abs(forces.stored(x) - exact) <= 1000 * eps * exact, name);
  });
}

BOOST_AUTO_TEST_CASE(rigid_motions_cost_no_energy_and_no_force) {
  on_every_body([]<int d>(char const* name, BodyMesh const& mesh) {
    BodyForces<d> const forces(mesh, stored_energy<d>(StVenant{}), [](auto const&) { return 1.0; }, {});
    Matrix<double, d, d> R = Matrix<double, d, d>::Identity();
    R(0, 0) = R(1, 1) = 0.28, R(0, 1) = -0.96, R(1, 0) = 0.96;
    List<double> f;
    forces.forces(homogeneous<d>(mesh, R), 0, f);
    // Strains are rounded by some ten times the places over the edges; at most ten of these are on a body.
    for (double const one : f) BOOST_TEST(std::abs(one) <= 3000 * eps, name);
    BOOST_TEST(std::abs(forces.stored(homogeneous<d>(mesh, R))) <= 3000 * eps, name);
  });
}

// The pressure on a facet is that of the gas behind it, corner by corner.
BOOST_AUTO_TEST_CASE(a_gas_under_its_own_pressure_is_at_rest_on_curved_bodies) {
  Draw draw(13);
  auto bent = moved(box_mesh({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), 0.1, draw);
  for (auto const& mesh : {ball_mesh(1, {1, 2}), shell_mesh(1, 2, {2, 2}), bent})
    for (bool const everywhere : {true, false}) {
      auto const law = stored_energy<3>(Gas{});
      BodyLoads<3> loads;
      if (everywhere)
        loads.outside_pressure = 0.4;
      else
        for (auto const& side : mesh.sides) loads.pressures[side.first] = [](double) { return 0.4; };
      BodyForces<3> const forces(
          mesh, law, [](auto const&) { return 1.0; }, loads);
      List<double> f;
      forces.forces(homogeneous<3>(mesh, Matrix<double, 3, 3>::Identity()), 0, f);
      for (double const one : f) BOOST_TEST(std::abs(one) <= 300 * eps);
    }
}

BOOST_AUTO_TEST_CASE(momenta_and_the_energy_of_a_step_that_keeps_it_are_conserved) {
  Draw draw(14);
  auto const mesh = cut_into_hexahedra(tetrahedra(1, draw));
  BodyStart<3> start;
  start.density = [](auto const& X) { return 1 + 0.3 * X[0]; };
  start.velocity = [](auto const& X) { return std::array{0.3 * X[1], -0.2 * X[0], 0.1 * X[0] * X[2]}; };
  for (Conserve const conserve : {Conserve::form, Conserve::energy}) {
    MediumOnMesh<3> body(mesh, stored_energy<3>(neo_hookean(1.0, 1.0)), start,
                         {.step = 0.02, .conserve = conserve});
    auto const p = body.momentum();
    auto const L = body.angular_momentum();
    double const E = body.energies().total();
    body.step(50);
    // Fifty steps, in each of which the forces of 48 cells are rounded.
    double const bound = 50 * 48 * eps * 0.1;
    for (std::size_t a = 0; a < 3; ++a) {
      BOOST_TEST(std::abs(body.momentum()[a] - p[a]) <= bound);
      BOOST_TEST(std::abs(body.angular_momentum()[a] - L[a]) <= bound);
    }
    if (conserve == Conserve::energy) BOOST_TEST(std::abs(body.energies().total() - E) <= 10 * bound);
  }
}

BOOST_AUTO_TEST_SUITE_END()
