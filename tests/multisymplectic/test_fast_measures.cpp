// What a medium of the optimised implementation says of itself: momenta and energies as sums over its nodes
// and its cells, memory, steps in a pass; and what it refuses in words and numbers.
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"
#include "refused.hpp"
#include "refuses.hpp"

using namespace actio;
using namespace actio::media;
using testing::caught, testing::refuses;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using enum Side;
using Flat = std::array<double, 2>;
using Place = std::array<double, 3>;
constexpr FastStVenantKirchhoff solid{0.9, 0.6};

/// Velocities that differ from node to node.
template <std::size_t n>
std::array<double, n> drawn(std::mt19937& random) {
  std::uniform_real_distribution<double> some(-0.5, 0.5);
  std::array<double, n> out;
  for (double& one : out) one = some(random) + 0.25;
  return out;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_measures)

// With the deformation F everywhere the energy is known. Sums have at most 60 terms, each with some
// roundings.
BOOST_AUTO_TEST_CASE(momenta_and_energies_in_the_plane_are_the_sums_over_the_nodes) {
  FastBox2d const box{{5, 3}, {0.1, 0.125}, {Side::free, sliding}, {fixed, Side::free}, {1, 2}};
  double const F[2][2] = {{1.1, 0.2}, {-0.1, 0.9}}, density = 2.5;
  std::mt19937 random(1);
  FastMedium2d const body(
      solid, box, 0.01, density,
      [&](Flat const& X) {
        return Flat{F[0][0] * X[0] + F[0][1] * X[1], F[1][0] * X[0] + F[1][1] * X[1]};
      },
      [&](Flat const&) { return drawn<2>(random); });
  auto const x = body.places(), v = body.velocities(), w = body.velocities_half_a_step_ago();
  double kinetic = 0, turning = 0, most = 0;
  Flat sum{};
  for (int j = 0, k = 0; j <= 3; ++j)
    for (int i = 0; i <= 5; ++i, ++k) {
      auto const at = static_cast<std::size_t>(k);
      double const m = density * 0.0125 * (i % 5 ? 1 : 0.5) * (j % 3 ? 1 : 0.5);
      kinetic += m / 2 * (v[at][0] * v[at][0] + v[at][1] * v[at][1]);
      sum[0] += m * w[at][0], sum[1] += m * w[at][1];
      turning += m * (x[at][0] * w[at][1] - x[at][1] * w[at][0]);
      most += m * std::hypot(w[at][0], w[at][1]) * std::hypot(x[at][0], x[at][1]);
    }
  double const e1 = (F[0][0] * F[0][0] + F[1][0] * F[1][0] - 1) / 2,
               e2 = (F[0][1] * F[0][1] + F[1][1] * F[1][1] - 1) / 2,
               e3 = (F[0][0] * F[0][1] + F[1][0] * F[1][1]) / 2;
  double const W = 0.45 * (e1 + e2) * (e1 + e2) + 0.6 * (e1 * e1 + e2 * e2 + 2 * e3 * e3);
  BOOST_TEST(std::abs(body.momentum()[0] - sum[0]) <= 100 * eps * most);
  BOOST_TEST(std::abs(body.momentum()[1] - sum[1]) <= 100 * eps * most);
  BOOST_TEST(std::abs(body.angular_momentum() - turning) <= 100 * eps * most);
  BOOST_TEST(body.energies()[0] == kinetic, boost::test_tools::tolerance(100 * eps));
  // Edges lose 2 eps |x|/h, 80 eps, to the subtraction of places.
  BOOST_TEST(std::abs(body.energies()[1] - density * 0.1875 * W) <= density * 0.1875 * 1000 * eps);
  BOOST_TEST(body.energy() == body.energies()[0] + body.energies()[1]);
  BOOST_TEST((body.time() == 0 && body.time_step() == 0.01 && body.steps() == 0));
  BOOST_TEST((body.box().cells == box.cells));
}
BOOST_AUTO_TEST_CASE(momenta_and_energies_in_space_are_the_sums_over_the_nodes) {
  FastBox3d box{{3, 2, 2}, {0.1, 0.125, 0.2}, {}, {1, 2, -1}};
  box.sides = {FastBox3d::Ends{fixed, Side::free}, FastBox3d::Ends{periodic, periodic},
               FastBox3d::Ends{sliding, Side::free}};
  double const density = 2.5;
  std::mt19937 random(1);
  FastMedium3d body(
      solid, box, 0.01, density, [](Place const& X) { return X; },
      [&](Place const&) { return drawn<3>(random); });
  body.step();
  auto const x = body.places(), v = body.velocities(), w = body.velocities_half_a_step_ago();
  double kinetic = 0, most = 0;
  Place sum{}, turning{};
  for (int l = 0, k = 0; l <= 2; ++l)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i <= 3; ++i, ++k) {
        auto const at = static_cast<std::size_t>(k);
        double const m = density * 0.0025 * (i % 3 ? 1 : 0.5) * (l % 2 ? 1 : 0.5);
        for (std::size_t a = 0; a < 3; ++a) {
          std::size_t const b = (a + 1) % 3, c = (a + 2) % 3;
          kinetic += m / 2 * v[at][a] * v[at][a], sum[a] += m * w[at][a];
          turning[a] += m * (x[at][b] * w[at][c] - x[at][c] * w[at][b]);
        }
        most += m * std::hypot(w[at][0], w[at][1], w[at][2]) * std::hypot(x[at][0], x[at][1], x[at][2]);
      }
  for (std::size_t a = 0; a < 3; ++a) {
    BOOST_TEST(std::abs(body.momentum()[a] - sum[a]) <= 100 * eps * most);
    BOOST_TEST(std::abs(body.angular_momentum()[a] - turning[a]) <= 100 * eps * most);
  }
  BOOST_TEST(body.energies()[0] == kinetic, boost::test_tools::tolerance(100 * eps));
  BOOST_TEST((body.time() == 0.01 && body.time_step() == 0.01 && body.levels() == 1));
}

namespace {
FastMedium2d<FastStVenantKirchhoff> body_on(FastBox2d const& box, FastOptions const& options = {}) {
  return {solid, box, 1e-4, 1, [](Flat const& X) { return X; }, [](Flat const&) { return Flat{}; }, options};
}
FastMedium3d<FastStVenantKirchhoff> body_on(FastBox3d const& box, FastOptions const& options = {}) {
  return {solid,  box, 1e-4, 1, [](Place const& X) { return X; }, [](Place const&) { return Place{}; },
          options};
}
}  // namespace

// Places, velocities and forces of the rows of all levels fit into half a megabyte, 192 bytes for four nodes.
BOOST_AUTO_TEST_CASE(a_pass_makes_as_many_steps_as_the_cache_allows) {
  for (int const nodes : {4, 2000, 2600, 4000, 16000}) {
    int const levels = body_on(FastBox2d{{nodes - 1, 1}, {0.1, 0.1}}).levels();
    int const bytes = 192 * nodes / 4;
    BOOST_TEST_INFO(nodes << " nodes in a row");
    BOOST_TEST((levels == 1 || levels * bytes <= 500000));
    BOOST_TEST((levels == 8 || (levels + 1) * bytes > 500000));
    BOOST_TEST((levels >= 1 && levels <= 8));
  }
  FastBox2d const box{{3, 1}, {0.1, 0.1}};
  BOOST_TEST((body_on(box, {1, 9}).levels() == 9 && body_on(box, {1, 100}).levels() == 64));
}

// A register is a place or a velocity of four nodes: 64 bytes in the plane, 96 in space. Rows of a multiple
// of sixteen or eight of them are lengthened, so that they are not a page apart.
BOOST_AUTO_TEST_CASE(memory_is_that_of_two_states_and_of_what_threads_hold_of_their_neighbours) {
  // Rows of three registers of places; each thread has two times as many rows of neighbours as there are
  // levels, and a row of forces for each.
  BOOST_TEST(body_on(FastBox2d{{9, 5}, {0.1, 0.1}}, {2, 5}).bytes() ==
             64u * (2 * 6 * 6 + 2 * 5 * (2 * 6 + 3)));
  BOOST_TEST(body_on(FastBox2d{{63, 1}, {0.1, 0.1}}, {1, 1}).bytes() == 64u * (2 * 2 * 34 + 2 * 34 + 16));
  // Planes of four rows of three registers: a copy of the plane below or above of a thread, where there is
  // one, and room for forces, four rows and six more.
  FastBox3d box{{9, 3, 2}, {0.1, 0.1, 0.1}};
  BOOST_TEST(body_on(box, {2}).bytes() == 96u * (2 * 3 * 4 * 6 + 2 * 12 + 2 * 10 * 3));
  box.sides[2] = {periodic, periodic}, box.cells[2] = 4;
  // Each has a plane below now, and the first plane is held a period further.
  BOOST_TEST(body_on(box, {2}).bytes() == 96u * (2 * 4 * 4 * 6 + 3 * 12 + 12 + 2 * 10 * 3));
  BOOST_TEST(body_on(FastBox3d{{31, 1, 1}, {0.1, 0.1, 0.1}}).bytes() == 96u * (2 * 2 * 2 * 17 + 8 * 8));
}

BOOST_AUTO_TEST_CASE(refusals_say_what_was_measured_and_which_bound_it_breaks) {
  FastBox2d const box{{4, 3}, {0.25, 0.25}};
  auto const made = [&](double dt, double density) {
    FastMedium2d(
        solid, box, dt, density, [](Flat const& X) { return X; }, [](Flat const&) { return Flat{}; });
  };
  refuses<OutsideDomain>([&] { made(-0.5, 1); }, -0.5, 0, "a positive time step");
  refuses<OutsideDomain>([&] { made(0.01, 0); }, 0, 0, "a positive density");
  auto body = body_on(box);
  refuses<OutsideDomain>([&] { body.step(-2); }, -2, 0, "number of steps");
  body.step(3);
  auto const kept = body.state();
  auto other = kept;
  other.places.pop_back();
  refuses<OutsideDomain>([&] { body.go_on_from(other); }, 19, 20, "each node");
  other = kept, other.velocities.push_back({});
  refuses<OutsideDomain>([&] { body.go_on_from(other); }, 21, 20, "each node");
  other = kept, other.steps = -1;
  refuses<OutsideDomain>([&] { body.go_on_from(other); }, -1, 0, "number of steps");
  // A node on the other side of its left neighbour.
  other = kept, other.places[2 * 5 + 3] = {0.5, 0.375};
  CHECK_REFUSED(body.go_on_from(other), CellInverts);
  other = kept, other.places[0][1] = NAN;
  CHECK_REFUSED(body.go_on_from(other), NotFinite);
  other = kept, other.velocities.back()[0] = HUGE_VAL;
  CHECK_REFUSED(body.go_on_from(other), NotFinite);
  BOOST_TEST((body.steps() == 3 && body.places() == kept.places));
  other = kept, other.steps = 0;
  body.go_on_from(other);
  BOOST_TEST(body.time() == 0);
}

// Turned over, all corners of all cells have the Jacobian -1, without rounding.
BOOST_AUTO_TEST_CASE(of_cells_that_are_as_bad_the_first_is_named) {
  FastBox2d const box{{4, 3}, {0.25, 0.25}};
  auto const made = [&](auto const& place, auto const& velocity) {
    FastMedium2d(solid, box, 0.01, 1, place, velocity);
  };
  auto const still = [](Flat const&) { return Flat{}; };
  refuses<OutsideDomain>(
      [&] {
        made([](Flat const& X) { return Flat{-X[0], X[1]}; }, still);
      },
      -1, 0, "medium: cell (0, 0) is inside out at the start");
  // A node beyond its right neighbour: the edge between them is turned over, and two cells have it.
  refuses<OutsideDomain>(
      [&] {
        made([](Flat const& X) { return X[0] == 0.5 && X[1] == 0.5 ? Flat{0.9375, 0.5} : X; }, still);
      },
      -0.75, 0, "medium: cell (2, 1) is inside out at the start");
  for (bool const of_places : {true, false}) {
    auto const none = [](Flat const& X) { return X[0] == 0.75 && X[1] == 0.25 ? Flat{X[0], NAN} : X; };
    auto const error = caught<NotFinite>(
        [&] { of_places ? made(none, still) : made([](Flat const& X) { return X; }, none); });
    BOOST_TEST(std::string(error.what()).find("node (3, 1)") != std::string::npos);
  }
}

BOOST_AUTO_TEST_SUITE_END()
