// Incompressible media of scenes, against exact motions: what a scene writes is compared, places and
// pressures of a snapshot.
#include <boost/test/unit_test.hpp>

#include "incompressible_media/exact_motions.hpp"
#include "program/run/run.hpp"
#include "refusal.hpp"
#include "refused.hpp"

using namespace actio::scene;
using std::numbers::pi;

namespace {

/// The fields of a scene of the program at its end: positions, velocities and what it asks for, node by node.
struct End {
  std::vector<SnapshotArray> reference, fields;
  std::vector<double> const& of(std::string const& name) const {
    for (auto const* all : {&fields, &reference})
      for (auto const& one : *all)
        if (one.name == name) return one.numbers;
    BOOST_FAIL("no field " << name);
    return fields.front().numbers;
  }
};
End end_of(std::string const& name, std::vector<std::string> const& overrides) {
  Scene scene = Scene::read(SceneFile::read(ACTIO_DATA "/scenes/" + name + ".toml", overrides));
  std::vector<double> table;
  auto const report = run_in_memory(scene, table, {.quiet = true});
  BOOST_REQUIRE_MESSAGE((report.ending == Ending::done), report.message);
  return {scene.simulation.snapshots->coordinates(), scene.simulation.snapshots->fields()};
}
/// The root mean square of what positions are off by.
template <class Exact>
double off_by(End const& end, Exact const& exact) {
  auto const &X = end.of("reference"), &x = end.of("position");
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); k += 2) {
    auto const there = exact(std::array{X[k], X[k + 1]});
    sum += std::pow(x[k] - there[0], 2) + std::pow(x[k + 1] - there[1], 2);
  }
  return std::sqrt(2 * sum / static_cast<double>(x.size()));
}

std::string const head =
    "[system]\nkind = \"incompressible_fluid\"\nmesh = { lower = [0, 0], upper = [1, 1], cells = [4, 4] }\n";
std::string const tail = "[run]\nuntil = 0.1\nevery = 0.1\n[output]\nquantities = [\"energy\"]\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(incompressible_scenes)

BOOST_AUTO_TEST_CASE(a_drop_stays_the_ellipse_of_a_geodesic) {
  auto const end = end_of("flying_drop", {"run.until=2"});
  using Square = actio::Matrix<double, 2, 2>;
  actio::testing::Drop<2> drop{Square::Identity(), Square::Zero()};
  drop.V(0, 0) = 0.5, drop.V(0, 1) = -0.6, drop.V(1, 0) = 0.8, drop.V(1, 1) = -0.5;
  drop = drop.after(2);
  double const off = off_by(end, [&](auto const& X) {
    return std::array{drop.A(0, 0) * X[0] + drop.A(0, 1) * X[1], drop.A(1, 0) * X[0] + drop.A(1, 1) * X[1]};
  });
  BOOST_TEST_MESSAGE("drop: places off by " << off);
  // The square of a cell, and more at the kinks of the mesh.
  BOOST_TEST(off <= 5e-3);
  auto const &P = end.of("pressure"), &X = end.of("reference");
  double const m = actio::testing::Drop<2>::pull(drop.A, drop.V);
  double worst = 0;
  for (std::size_t k = 0; k < P.size(); ++k) {
    double const square = X[2 * k] * X[2 * k] + X[2 * k + 1] * X[2 * k + 1];
    // Means over the cells at a node inside.
    if (square < 0.7) worst = std::max(worst, std::abs(P[k] - m / 2 * (1 - square)));
  }
  BOOST_TEST(worst <= 0.01 * std::abs(m));
}

BOOST_AUTO_TEST_CASE(cells_turn_with_their_pressure) {
  auto const end = end_of("turning_cells", {"run.until=1"});
  double const off = off_by(end, [](auto const& X) {
    return actio::testing::integrated(X, 1, 200, &actio::testing::TurningCells::velocity);
  });
  BOOST_TEST_MESSAGE("turning cells: places off by " << off);
  BOOST_TEST(off <= 1.3e-3);
  auto const &P = end.of("pressure"), &x = end.of("position");
  double square = 0, mean = 0, inside = 0;
  for (std::size_t k = 0; k < P.size(); ++k) {
    std::array const at{x[2 * k], x[2 * k + 1]};
    // A node at a wall has the mean over cells on one side.
    if (std::min({at[0], at[1], 2 * pi - at[0], 2 * pi - at[1]}) < 0.2) continue;
    double const error = P[k] - actio::testing::TurningCells::pressure(at);
    square += error * error, mean += error, inside += 1;
  }
  BOOST_TEST(std::sqrt(square / inside - std::pow(mean / inside, 2)) <= 1e-2);
}

BOOST_AUTO_TEST_CASE(a_tube_rings_as_knowles_found) {
  auto const end = end_of("incompressible_tube", {"run.until=2"});
  actio::testing::Annulus const tube{1, 0, 0, 0.8};
  auto const at = tube.after(2, {});
  double const off = off_by(end, [&](auto const& X) {
    double const square = X[0] * X[0] + X[1] * X[1], ratio = std::sqrt(1 + at.s / square);
    return std::array{ratio * X[0], ratio * X[1]};
  });
  BOOST_TEST_MESSAGE("tube: places off by " << off);
  BOOST_TEST(off <= 3e-3);
}

BOOST_AUTO_TEST_CASE(a_tank_sways_and_its_pressure_is_hydrostatic) {
  double const k = pi, g = 9.81, depth = 0.7, omega = std::sqrt(g * k * std::tanh(k * depth));
  // A quarter of a period: the wave is highest, and nothing moves.
  auto const end = end_of("sloshing_tank", {"run.until=" + std::to_string(pi / 2 / omega), "run.every=0.1"});
  auto const &X = end.of("reference"), &x = end.of("position"), &P = end.of("pressure");
  double worst = 0, heavy = 0;
  for (std::size_t n = 0; n < P.size(); ++n) {
    double const here = X[2 * n + 1];
    if (here == depth)
      worst = std::max(worst, std::abs(x[2 * n + 1] - depth - 0.01 * std::cos(k * X[2 * n])));
    // 1000 g (H - y) and the wave's, which falls off with depth.
    double const wave = 0.01 * std::cosh(k * here) / std::cosh(k * depth) * std::cos(k * X[2 * n]);
    if (here > 0.1 && here < 0.6)
      heavy = std::max(heavy, std::abs(P[n] / (1000 * g) - (depth - x[2 * n + 1]) - wave));
  }
  BOOST_TEST_MESSAGE("tank: surface off by " << worst << ", pressure by " << heavy << " m of water");
  // The square of the amplitude times k, and of the edge of a cell times that.
  BOOST_TEST(worst <= 5e-4);
  BOOST_TEST(heavy <= 1e-3);
}

BOOST_AUTO_TEST_CASE(both_solvers_lead_to_the_same_places) {
  std::vector<double> places[2];
  for (int k = 0; k < 2; ++k)
    places[k] = end_of("turning_cells", {"run.until=0.5", std::string("method.solver=") +
                                                              (k ? "\"cholesky\"" : "\"multigrid\"")})
                    .of("position");
  double apart = 0;
  for (std::size_t k = 0; k < places[0].size(); ++k)
    apart = std::max(apart, std::abs(places[0][k] - places[1][k]));
  // The tolerance of volumes, over a hundred steps.
  BOOST_TEST(apart <= 1e-10);
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_a_scene_is_told_at_its_place) {
  auto const refused = [](std::string const& text) {
    CHECK_REFUSED(Scene::read(SceneFile::parse(text, "scene.toml")), SceneError);
  };
  refused(head + "[initial]\nvelocity = [\"X\", \"0\"]\n" + tail);
  refused(head + "[initial]\nplacement = [\"1.5*X\", \"Y\"]\n" + tail);
  refused(head + "load = { gravity = \"x*y\" }\n" + tail);
  refused(head + "material = { name = \"neo_hookean\", mu = 1, kappa = 1 }\n" + tail);
  refused(head + "boundary = { left = \"fixed\", right = \"fixed\", bottom = \"fixed\", top = \"fixed\" }\n" +
          tail);
  refused(head + "[method]\ntolerance = 1\n" + tail);
  refused(
      "[system]\nkind = \"incompressible_fluid\"\nmesh = { shape = \"disc\", radius = 1, cells = [2, 4] }\n"
      "[method]\nsolver = \"multigrid\"\n" +
      tail);
  refused(
      "[system]\nkind = \"incompressible_fluid\"\n"
      "mesh = { lower = [0, 0, 0], upper = [1, 1, 1], cells = [3, 3, 3] }\n"
      "[method]\nsolver = \"cholesky\"\n" +
      tail);
  refused("[system]\nkind = \"incompressible_fluid\"\nmesh = { lower = [0], upper = [1], cells = [4] }\n" +
          tail);
  CHECK_REFUSED(Scene::read(SceneFile::parse(
                    head + "load = { gravity = \"9.81*y\" }\n[method]\nstep = 1\n" + tail, "scene.toml")),
                NumericsError);
}

BOOST_AUTO_TEST_SUITE_END()
