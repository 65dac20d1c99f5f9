// Incompressible media as they are used: what is kept, what goes on bit for bit, how a heavy liquid rests and
// sloshes, and what is refused.
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "actio/incompressible_media/incompressible_medium.hpp"
#include "actio/incompressible_media/incompressible_sphere.hpp"
#include "actio/meshes/body_shapes.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using std::numbers::pi;

namespace {
using Spot = std::array<double, 2>;

BodySides<2> tank() {
  return {{"left", {Side::sliding, {}}}, {"right", {Side::sliding, {}}}, {"bottom", {Side::sliding, {}}}};
}
BodySides<2> box() {
  auto out = tank();
  out["top"] = {Side::sliding, {}};
  return out;
}
/// Cells that turn, in a box of n x n cells.
IncompressibleMedium<2> turning(int n, double step, VolumeSolving const& solving = {}) {
  IncompressibleStart<2> start;
  start.velocity = [](Spot const& X) {
    return Spot{std::sin(X[0]) * std::cos(X[1]), -std::cos(X[0]) * std::sin(X[1])};
  };
  return {box_mesh({0, 0}, {pi, pi}, {n, n}), {}, start, step, box(), {}, solving};
}
auto rubber() {
  return stored_energy<2>([](auto const& F) {
    auto sum = F(0, 0) * F(0, 0);
    sum += F(0, 1) * F(0, 1) + F(1, 0) * F(1, 0) + F(1, 1) * F(1, 1);
    return typename std::decay_t<decltype(F)>::Scalar(0.5 * sum);
  });
}
/// A block of rubber in free flight, which turns and quivers.
IncompressibleMedium<2> thrown(double step) {
  IncompressibleStart<2> start;
  start.velocity = [](Spot const& X) { return Spot{1 + 0.3 * X[0] - 0.5 * X[1], 0.5 * X[0] - 0.3 * X[1]}; };
  return {box_mesh({-1, -0.5}, {1, 0.5}, {9, 5}), rubber(), start, step};
}

/// Liquid in a tank of length 1 and depth 0.7 that sloshes with a small amplitude, or weight at the nodes.
struct Sloshing {
  double g = 9.81, depth = 0.7, k = pi, amplitude = 1e-4;
  double frequency() const { return std::sqrt(g * k * std::tanh(k * depth)); }
  IncompressibleMedium<2> medium(int across, int up, double step, bool at_nodes = false) const {
    IncompressibleStart<2> start;
    start.velocity = [*this](Spot const& X) {
      double const c = amplitude * frequency() / std::sinh(k * depth);
      return Spot{-c * std::cosh(k * X[1]) * std::sin(k * X[0]),
                  c * std::sinh(k * X[1]) * std::cos(k * X[0])};
    };
    start.project = true;
    BodyLoads<2> loads;
    if (at_nodes)
      loads.potentials.push_back(space_potential<2>([g = g](auto const& x) { return x[1] * g; }));
    else
      start.gravity = {0, -g};
    return {box_mesh({0, 0}, {1, depth}, {across, up}), {}, start, step, tank(), loads};
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(incompressible_medium)

BOOST_AUTO_TEST_CASE(momenta_and_volumes_of_a_thrown_block_are_kept) {
  auto block = thrown(0.01);
  auto const p = block.momentum();
  auto const L = block.angular_momentum();
  double const E = block.energies().total();
  double worst = 0;
  for (int k = 0; k < 1000; ++k) block.step(), worst = std::max(worst, block.volume_defect());
  BOOST_TEST(worst <= 2e-13);
  double mass = 0;
  for (double const m : block.masses()) mass += m;
  BOOST_TEST(std::abs(mass - 2) <= 1e-14);
  for (std::size_t a = 0; a < 2; ++a) BOOST_TEST(std::abs(block.momentum()[a] - p[a]) <= 1e-14 * 2);
  // It has flown ten lengths from the origin by then.
  BOOST_TEST(std::abs(block.angular_momentum()[2] - L[2]) <= 1e-13);
  BOOST_TEST(std::abs(block.energies().total() - E) <= 1e-3 * E);
}

BOOST_AUTO_TEST_CASE(steps_are_reversible) {
  auto block = thrown(0.01);
  auto const before = block.places();
  block.step(100);
  // The same steps backwards: from the same places with the opposite velocities.
  auto const x = block.places(), v = block.velocities();
  std::map<Spot, std::size_t> number;
  auto const mesh = block.mesh();
  for (std::size_t k = 0; k < x.size(); ++k) number[{mesh.nodes[k][0], mesh.nodes[k][1]}] = k;
  IncompressibleStart<2> start;
  start.placement = [&](Spot const& X) { return x[number.at(X)]; };
  start.velocity = [&](Spot const& X) { return Spot{-v[number.at(X)][0], -v[number.at(X)][1]}; };
  IncompressibleMedium<2> back(mesh, rubber(), start, 0.01);
  back.step(100);
  double off = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t a = 0; a < 2; ++a) off = std::max(off, std::abs(back.places()[k][a] - before[k][a]));
  BOOST_TEST(off <= 1e-11);
}

BOOST_AUTO_TEST_CASE(a_remembered_state_goes_on_bit_for_bit) {
  auto one = turning(12, 0.02);
  one.step(17);
  auto const kept = one.remember();
  one.pressures();
  one.step(8);
  one.look_ahead(0.013);
  BOOST_TEST(one.places() != turning(12, 0.02).places());
  one.look_ahead(0);
  one.step(5);
  auto other = turning(12, 0.02);
  other.restore(kept);
  other.step(13);
  BOOST_TEST((one.places() == other.places() && one.velocities() == other.velocities()));
  BOOST_TEST((one.pressures() == other.pressures()));
  // Nor does what is asked for between two steps, wherever the matrix is due.
  auto asked = turning(12, 0.02), left = turning(12, 0.02);
  for (int k = 0; k < 25; ++k) {
    asked.look_ahead(0.011), asked.pressures(), asked.velocities(), asked.look_ahead(0);
    asked.step(), left.step();
  }
  BOOST_TEST((asked.remember() == left.remember()));
  // Looking ahead of a remembered state changes nothing of it.
  one.look_ahead(0.01);
  BOOST_TEST((one.remember() == other.remember()));
  // So does one after a change of the step.
  one.look_ahead(0);
  one.change_step(0.003, 0.01, 60);
  auto third = turning(12, 0.01);
  third.restore(one.remember());
  one.step(7), third.step(7);
  BOOST_TEST((one.places() == third.places()));
  auto shorter = other.remember();
  shorter.pop_back();
  CHECK_REFUSED(other.restore(shorter), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(what_is_looked_ahead_to_is_on_the_way) {
  // A step of half the length ends off by the third power of it from the middle of the way.
  double before = 0;
  for (double const h : {0.04, 0.02}) {
    auto coarse = turning(8, h), fine = turning(8, h / 8);
    coarse.step(4), fine.step(36);
    coarse.look_ahead(h / 2);
    double off = 0;
    for (std::size_t k = 0; k < coarse.places().size(); ++k)
      off = std::max(off, std::hypot(coarse.places()[k][0] - fine.places()[k][0],
                                     coarse.places()[k][1] - fine.places()[k][1]));
    if (before > 0) BOOST_TEST(before / off >= 3.5);
    before = off;
    BOOST_TEST(coarse.volume_defect() <= 2e-13);
    auto changed = turning(8, h);
    changed.step(4), changed.change_step(h / 2, h / 2, 9), changed.step(3);
    fine.step(12);
    double apart = 0;
    for (std::size_t k = 0; k < fine.places().size(); ++k)
      apart = std::max(apart, std::hypot(changed.places()[k][0] - fine.places()[k][0],
                                         changed.places()[k][1] - fine.places()[k][1]));
    BOOST_TEST(apart <= 4 * off + 1e-6);
    BOOST_TEST(std::abs(changed.time() - 12 * h / 2) <= 1e-15);
  }
}

// The first step of a closed box takes some forty cycles. That is no reason for factors, which take minutes
// on half a million cells, as long as each cycle gains.
BOOST_AUTO_TEST_CASE(cycles_go_on_as_long_as_they_gain) {
  VolumeSolving solving;
  solving.by = PressureBy::multigrid;
  for (int const most : {8, 1}) {
    solving.most_rounds = most;
    auto medium = turning(48, 0.015, solving);
    medium.step();
    bool const fell_back = medium.remember()[4] == 1;
    BOOST_TEST(fell_back == (most == 1),
               "new matrices after " << most << ": " << medium.rounds() << " rounds");
    BOOST_TEST(medium.rounds() > 2 * most);
    BOOST_TEST(medium.volume_defect() <= solving.tolerance);
  }
}

BOOST_AUTO_TEST_CASE(velocities_change_no_volume) {
  auto cells = turning(16, 0.02);
  cells.step(10);
  auto const v = cells.velocities();
  std::vector<double> flat, places, rates, slopes;
  for (auto const& one : v) flat.insert(flat.end(), one.begin(), one.end());
  for (auto const& one : cells.places()) places.insert(places.end(), one.begin(), one.end());
  MeshVolumes<PlaneCell> const volumes(cells.mesh());
  volumes.slopes({places, {}}, slopes, volumes.all()), volumes.rates(slopes, flat, rates, volumes.all());
  double most = 0;
  for (double const one : rates) most = std::max(most, std::abs(one));
  BOOST_TEST(most <= 1e-14);
}

// The dispersion of gravity waves: omega^2 = g k tanh(k H).
BOOST_AUTO_TEST_CASE(a_tank_sloshes_with_the_frequency_of_gravity_waves) {
  Sloshing const sloshing;
  double before = 0;
  for (auto const& [across, up, bound] : {std::tuple{16, 11, 3e-3}, {32, 22, 7e-4}, {64, 45, 2e-4}}) {
    int const per_period = 4 * across;
    double const h = 2 * pi / sloshing.frequency() / per_period;
    auto water = sloshing.medium(across, up, h);
    // The amplitude of the mode on the surface, and when it is zero.
    auto const mode = [&, across = across, up = up] {
      auto const x = water.places();
      double sum = 0;
      for (int i = 0; i <= across; ++i)
        sum += (i == 0 || i == across ? 0.5 : 1) * std::cos(pi * i / across) *
               (x[static_cast<std::size_t>(up * (across + 1) + i)][1] - sloshing.depth);
      return 2 * sum / across;
    };
    std::vector<double> zeros;
    double last = mode();
    for (int k = 1; k <= 5.3 * per_period; ++k) {
      water.step();
      double const now = mode();
      if (k > 1 && (now > 0) != (last > 0)) zeros.push_back((k - 1 + last / (last - now)) * h);
      last = now;
    }
    double const frequency = pi * static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
    double const off = frequency / sloshing.frequency() - 1;
    BOOST_TEST_MESSAGE("sloshing, " << across << " x " << up << ": frequency off by " << 100 * off << " %");
    BOOST_TEST(std::abs(off) <= bound);
    if (before != 0) BOOST_TEST(std::abs(std::log2(before / off) - 2) <= 0.25);
    before = off;
  }
}

BOOST_AUTO_TEST_CASE(steps_of_a_tank_are_stable_up_to_the_estimate) {
  Sloshing const sloshing;
  double const longest = 2 / sloshing.medium(16, 11, 0.01).largest_frequency();
  auto calm = sloshing.medium(16, 11, 0.9 * longest);
  calm.step(200);
  for (double const J : calm.jacobians()) BOOST_TEST(std::abs(J - 1) <= 0.01);
  auto wild = sloshing.medium(16, 11, 1.5 * longest);
  BOOST_CHECK_THROW(wild.step(200), Error);
}

// At rest the pressure is hydrostatic and nothing moves, up to what volumes may be off by: 2e-13, and as much
// is h^2 times minus the Laplacian of the pressure.
BOOST_AUTO_TEST_CASE(a_heavy_liquid_rests_under_hydrostatic_pressure) {
  Sloshing still;
  still.amplitude = 0;
  auto water = still.medium(16, 11, 0.01);
  water.step(500);
  auto const P = water.pressures();
  double off = 0, away = 0;
  for (std::size_t cell = 0; cell < P.size(); ++cell) {
    double const y = (static_cast<double>(cell / 16) + 0.5) * still.depth / 11;
    off = std::max(off, std::abs(P[cell] - still.g * (still.depth - y)));
  }
  auto const x = water.places();
  for (std::size_t k = 0; k < x.size(); ++k)
    away = std::max(away, std::hypot(x[k][0] - water.mesh().nodes[k][0], x[k][1] - water.mesh().nodes[k][1]));
  BOOST_TEST(off <= 2e-13 * still.depth * still.depth / 2 / 1e-4);
  BOOST_TEST(away <= 1e-10);
}

// The control: weight at the nodes makes shears grow within seconds, faster on finer meshes, where weight of
// the cells leaves an oscillation that is as large as it was.
BOOST_AUTO_TEST_CASE(weight_at_the_nodes_makes_shears_grow) {
  Sloshing const sloshing;
  auto const largest = [&](bool at_nodes) {
    auto water = sloshing.medium(16, 11, 0.017, at_nodes);
    double most = 0;
    for (int k = 0; k < 13; ++k) {
      water.step(15);
      auto const J = water.jacobians();
      for (double const one : J) most = std::max(most, std::abs(one - 1));
    }
    return most;
  };
  double const cells = largest(false), nodes = largest(true);
  BOOST_TEST_MESSAGE(
      "largest |J - 1| of a corner after 3.3 units of time: " << cells << ", with weight at nodes " << nodes);
  BOOST_TEST(cells <= 3e-4);
  BOOST_TEST(nodes >= 10 * cells);
}

// Two liquids: light over heavy rests, heavy over light turns over.
BOOST_AUTO_TEST_CASE(a_heavier_liquid_sinks) {
  for (bool const heavy_above : {false, true}) {
    IncompressibleStart<2> start;
    start.density = [&](Spot const& X) { return (X[1] > 0.5) == heavy_above ? 3.0 : 1.0; };
    start.gravity = {0, -1};
    start.project = true;
    start.velocity = [](Spot const& X) {
      return Spot{-1e-3 * std::sin(pi * X[0]) * std::cos(pi * X[1]),
                  1e-3 * std::cos(pi * X[0]) * std::sin(pi * X[1])};
    };
    IncompressibleMedium<2> both(box_mesh({0, 0}, {1, 1}, {12, 12}), {}, start, 0.02, box());
    both.step(100);
    double most = 0;
    auto const x = both.places();
    for (std::size_t k = 0; k < x.size(); ++k)
      most = std::max(most, std::abs(x[k][1] - both.mesh().nodes[k][1]));
    // Growth of the interface: omega^2 = k g (1 - 3)/(1 + 3) tanh(k/2).
    if (heavy_above)
      BOOST_TEST(most >= 3e-3);
    else
      BOOST_TEST(most <= 2e-3);
  }
}

// A side that moves: a piston of which the opposite surface is free pushes the whole.
BOOST_AUTO_TEST_CASE(a_moved_side_takes_the_medium_along) {
  IncompressibleStart<2> start;
  auto const chi = [](auto const& X, auto t) {
    using T = std::decay_t<decltype(t)>;
    return std::array<T, 2>{T(X[0]) + T(0.1) * (T(1) - cos(t)), T(X[1])};
  };
  BodySides<2> sides{{"left", {Side::moved, prescribed_motion<2>(chi)}},
                     {"bottom", {Side::sliding, {}}},
                     {"top", {Side::sliding, {}}}};
  IncompressibleMedium<2> plug(box_mesh({0, 0}, {2, 1}, {8, 4}), {}, start, 0.02, sides);
  plug.step(100);
  auto const x = plug.places();
  double off = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    off = std::max(off, std::abs(x[k][0] - plug.mesh().nodes[k][0] - 0.1 * (1 - std::cos(2.0))));
  BOOST_TEST(off <= 1e-12);
  // The pressure accelerates it: rho a (2 - X) with a = 0.1 cos t, by the second difference of the places.
  double const h = 0.02, a = 0.1 * std::cos(2.0) * 2 * (1 - std::cos(h)) / (h * h);
  auto const P = plug.pressures();
  for (std::size_t cell = 0; cell < P.size(); ++cell)
    BOOST_TEST(std::abs(P[cell] - a * (2 - (static_cast<double>(cell % 8) + 0.5) / 4)) <= 1e-10);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_incompressible_is_refused) {
  auto const mesh = [] { return box_mesh({0, 0}, {1, 1}, {4, 4}); };
  IncompressibleStart<2> start;
  start.velocity = [](Spot const& X) { return Spot{X[0], 0}; };
  CHECK_REFUSED((IncompressibleMedium<2>(mesh(), {}, start, 0.01)), StartChangesVolumes);
  start.project = true;
  IncompressibleMedium<2> projected(mesh(), {}, start, 0.01);
  BOOST_TEST(projected.projected() > 0.1);
  start = {};
  start.placement = [](Spot const& X) { return Spot{1.5 * X[0], X[1]}; };
  CHECK_REFUSED((IncompressibleMedium<2>(mesh(), {}, start, 0.01)), StartChangesVolumes);
  start = {};
  BodySides<2> held;
  for (char const* side : {"left", "right", "bottom", "top"}) held[side] = {Side::fixed, {}};
  CHECK_REFUSED((IncompressibleMedium<2>(mesh(), {}, start, 0.01, held)), VolumesNotIndependent);
  CHECK_REFUSED((IncompressibleMedium<2>(box_mesh({0, 0}, {1, 1}, {4, 4}, {true, true}), {}, start, 0.01)),
                VolumesNotIndependent);
  IncompressibleMedium<2>(box_mesh({0, 0}, {1, 1}, {4, 5}, {true, true}), {}, start, 0.01);
  CHECK_REFUSED(
      (IncompressibleMedium<3>(box_mesh({0, 0, 0}, {1, 1, 1}, {4, 4, 4}, {true, true, true}), {}, {}, 0.01)),
      VolumesNotIndependent);
  // Not known as a box: by the pivots of its factorization.
  auto nameless = mesh();
  nameless.grid = {};
  CHECK_REFUSED((IncompressibleMedium<2>(nameless, {}, start, 0.01, held)), VolumesNotIndependent);
  CHECK_REFUSED((IncompressibleMedium<2>(mesh(), {}, start, 0)), OutsideDomain);
  BOOST_CHECK_THROW((IncompressibleMedium<2>(mesh(), {}, start, NAN)), NotFinite);
  start.density = [](Spot const&) { return 0.0; };
  CHECK_REFUSED((IncompressibleMedium<2>(mesh(), {}, start, 0.01)), NotADensity);
  auto triangles = mesh();
  triangles.shape = BodyMesh::Shape::triangle;
  CHECK_REFUSED((IncompressibleMedium<2>(triangles, {}, {}, 0.01)), NotABodyMesh);
  CHECK_REFUSED(sphere_mesh(1), NotABodyMesh);
  auto round = sphere_mesh(2);
  round.nodes[0] = {1, 1, 1};
  CHECK_REFUSED((IncompressibleSphere(
                    round,
                    [](auto const&) {
                      return std::array{0.0, 0.0, 0.0};
                    },
                    0.01)),
                NotABodyMesh);
  // A lid that comes down on water which has nowhere to go.
  auto const lid = [](auto const& X, auto t) {
    using T = std::decay_t<decltype(t)>;
    return std::array<T, 2>{T(X[0]), T(X[1]) - t * t};
  };
  auto pressed = tank();
  pressed["top"] = {Side::moved, prescribed_motion<2>(lid)};
  IncompressibleMedium<2> jar(mesh(), {}, {}, 0.01, pressed);
  CHECK_REFUSED(jar.step(), WallsChangeVolume);
}

// Cells of a fluid that are sheared for long fold while volume, energy and momentum look perfect.
BOOST_AUTO_TEST_CASE(a_cell_that_folds_ends_the_run_with_its_time) {
  auto cells = turning(8, 0.02);
  auto const folds = testing::caught<CellFolds>([&] { cells.step(400); });
  BOOST_TEST_MESSAGE(folds.what());
  BOOST_TEST((folds.time > cells.time() && folds.time <= cells.time() + 0.02));
  BOOST_TEST((folds.time > 1.5 && folds.time < 3));
  BOOST_TEST(cells.volume_defect() <= 2e-13);
  auto const J = cells.jacobians();
  BOOST_TEST(*std::min_element(J.begin(), J.end()) > 0);
  BOOST_TEST((cells.jacobians()[static_cast<std::size_t>(folds.cell)] < 0.2));
}

BOOST_AUTO_TEST_SUITE_END()
