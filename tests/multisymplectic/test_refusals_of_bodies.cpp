// Bodies on meshes at the edge of what is accepted: densities, cells, loads and steps that are none, with the
// numbers that were measured; and the largest frequency of a chain, which is known.
#include <boost/test/unit_test.hpp>

#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "refused.hpp"
#include "refuses.hpp"

using namespace actio;
using namespace actio::media;
using testing::caught, testing::refuses;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Spot = std::array<double, 2>;

template <class F>
void not_finite(F const& f, std::string const& words) {
  BOOST_CHECK_EXCEPTION(f(), NotFinite, [&](NotFinite const& e) {
    BOOST_TEST(std::string(e.what()).find(words) != std::string::npos, e.what());
    return true;
  });
}
auto rubber() { return stored_energy<2>(neo_hookean(1, 0.5)); }
MediumOnMesh<2> body(BodyMesh const& mesh, BodyStart<2> const& start = {},
                     BodyStepping const& by = {.step = 0.01}, BodyLoads<2> const& loads = {}) {
  return {mesh, rubber(), start, by, {}, loads};
}
BodyMesh two_by_one() { return box_mesh({0, 0}, {2, 1}, {2, 1}); }
}  // namespace

BOOST_AUTO_TEST_SUITE(refusals_of_bodies)

BOOST_AUTO_TEST_CASE(cells_and_densities_that_are_none_are_refused_with_the_cell) {
  auto dart = two_by_one();
  // The corner (2, 1) at (1.25, 0.25): its edges are (1/4, -3/4) and (-3/4, 1/4).
  dart.nodes[5] = {1.25, 0.25, 0};
  refuses<InvertedCell>([&] { body(dart); }, -0.5, 0, "cell (1, 0), corner 3");
  BodyStart<2> start;
  start.density = [](Spot const& X) { return X[0] > 1.5 ? -0.125 : 1; };
  refuses<OutsideDomain>([&] { body(two_by_one(), start); }, -0.125, 0,
                         "density in cell (1, 0): a density of mass is not negative");
  start.density = [](Spot const& X) { return X[0] > 1 ? 0.0 : 1; };
  refuses<OutsideDomain>([&] { body(two_by_one(), start); }, 0, 0, "density in cell (1, 0): a cell has mass");
  start.density = [](Spot const& X) { return X[0] > 1 ? HUGE_VAL : 1; };
  not_finite([&] { body(two_by_one(), start); }, "density in cell (1, 0)");
  refuses<NotABodyMesh>([] { body(box_mesh({0}, {1}, {2})); }, 1, 2, "the dimension of the medium");
  start = {}, start.placement = [](Spot const& X) { return Spot{X[0] == 1 ? NAN : X[0], X[1]}; };
  not_finite([&] { body(two_by_one(), start); }, "placement and velocity of node 1");
  start = {}, start.velocity = [](Spot const& X) { return Spot{X[0] == 2 ? HUGE_VAL : X[0], X[1]}; };
  not_finite([&] { body(two_by_one(), start); }, "placement and velocity of node 2");
  start = {}, start.placement = [](Spot const& X) { return Spot{X[0] == 2 ? 0.75 : X[0], X[1]}; };
  auto const e = caught<BodyCellInverts>([&] { body(two_by_one(), start); });
  BOOST_TEST((e.measured == -0.25 && e.bound == 0 && e.cell == 1 && e.step == 0 && e.time_step == 0));
  BOOST_TEST((e.would_do == 0 && e.largest_step == 0));
}

BOOST_AUTO_TEST_CASE(steps_that_are_none_are_refused_with_what_was_asked_for) {
  auto const with = [](BodyStepping const& by) { return [by] { body(two_by_one(), {}, by); }; };
  not_finite(with({.step = HUGE_VAL}), "time step");
  refuses<OutsideDomain>(with({.step = 0}), 0, 0, "a positive time step");
  refuses<OutsideDomain>(with({.step = 1, .order = 1}), 1, 2, "2 or 4");
  refuses<OutsideDomain>(with({.step = 1, .order = 3}), 3, 4, "2 or 4");
  refuses<OutsideDomain>(with({.step = 1, .order = 6}), 6, 4, "2 or 4");
  refuses<OutsideDomain>(with({.step = 1, .order = 4, .viscosity = {0, 1}}), 4, 2, "viscosity");
  refuses<OutsideDomain>(with({.step = 1, .conserve = Conserve::energy, .viscosity = {1, 0}}), 2, 2,
                         "viscosity");
  auto one = body(two_by_one());
  refuses<OutsideDomain>([&] { one.step(-2); }, -2, 0, "must not be negative");
  BOOST_CHECK_NO_THROW(one.step(0));
  one.step(3);
  refuses<OutsideDomain>([&] { one.set_time_step(0.1); }, 3, 0, "before the first one");
  refuses<OutsideDomain>([&] { one.restore(std::vector<double>(48, 0)); }, 48, 49, "four numbers");
  auto viscous = body(two_by_one(), {}, {.step = 0.01, .viscosity = {1, 1}});
  refuses<OutsideDomain>([&] { viscous.restore(std::vector<double>(49, 0)); }, 49, 62, "with viscosity five");
  BOOST_TEST((one.remember().size() == 49 && viscous.remember().size() == 62));
  BOOST_TEST((viscous.numbers_of_state() == 62 && one.steps() == 3));
}

BOOST_AUTO_TEST_CASE(loads_that_are_none_are_refused_by_name) {
  auto const with = [](BodyLoads<2> const& loads) {
    return [loads] { body(two_by_one(), {}, {.step = 0.01}, loads); };
  };
  BodyLoads<2> loads;
  loads.outside_pressure = HUGE_VAL;
  not_finite(with(loads), "outside pressure");
  loads = {}, loads.tractions["top"] = {0, NAN};
  not_finite(with(loads), "traction on side 'top'");
  loads = {}, loads.pressures["top"] = [](double t) { return t < 0.015 ? 1 : NAN; };
  auto pressed = body(two_by_one(), {}, {.step = 0.01}, loads);
  not_finite([&] { pressed.step(5); }, "pressure on side 'top' at t = 0.02:");
  BOOST_TEST(pressed.steps() == 1);
  loads = {}, loads.pressures["up"] = [](double) { return 1; };
  CHECK_REFUSED(with(loads)(), UnknownSide);
  // A potential without a value, and one without a gradient.
  loads = {},
  loads.potentials = {
      {[](Spot const& x) { return x[0] == 2 ? NAN : 0; }, [](Spot const&) { return Spot{}; }, {}}};
  auto const hill = body(two_by_one(), {}, {.step = 0.01}, loads);
  not_finite([&] { hill.energies(); }, "potential at node 2, x = (2, 0):");
  loads.potentials = {{[](Spot const&) { return 0; },
                       [](Spot const& x) {
                         return Spot{0, x[0] == 2 ? NAN : 0};
                       },
                       {}}};
  not_finite(with(loads), "gradient of the potential at node 2, x = (2, 0):");
}

// A chain of n equal masses and springs between fixed ends has 2 sqrt(k/m) sin(n pi/(2 (n + 1))).
BOOST_AUTO_TEST_CASE(the_largest_frequency_of_a_chain_is_met_from_below_within_half_a_per_cent) {
  for (std::size_t const n : {1u, 2u, 3u, 10u, 60u}) {
    double const k = 3, m = 0.7;
    std::vector<double> u;
    for (std::size_t i = 0; i < n; ++i) u.push_back(std::sin(1.0 + 7.0 * double(i)));
    int applied = 0;
    double const found = media::detail::largest_frequency(
        [&](std::size_t) { return m; }, u,
        [&](std::vector<double> const& x, std::vector<double>& out) {
          ++applied, out.resize(n);
          for (std::size_t i = 0; i < n; ++i)
            out[i] = (2 * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < n ? x[i + 1] : 0)) * k / m;
        });
    double const exact = 2 * std::sqrt(k / m) * std::sin(M_PI / 2 * double(n) / double(n + 1));
    BOOST_TEST((found <= exact * (1 + 20 * eps) && found >= exact * 0.995),
               n << " masses: " << found / exact);
    BOOST_TEST(applied <= 40);
  }
  auto const none = [](std::vector<double> const& x, std::vector<double>& out) { out.assign(x.size(), 0); };
  BOOST_TEST(media::detail::largest_frequency([](std::size_t) { return 1.0; }, {1, 2}, none) == 0);
  BOOST_TEST(media::detail::largest_frequency([](std::size_t) { return 1.0; }, {0, 0}, none) == 0);
}

// The matrix with 2 on the diagonal and 1 beside it: 2 + 2 cos(pi/(n + 1)), and the last component of its
// vector is sqrt(2/(n + 1)) sin(pi/(n + 1)).
BOOST_AUTO_TEST_CASE(the_top_of_a_tridiagonal_matrix_is_known) {
  for (std::size_t const n : {1u, 2u, 3u, 8u, 20u}) {
    auto const [top, last] =
        media::detail::top_of_lanczos_matrix(std::vector<double>(n, 2), std::vector<double>(n, 1));
    double const angle = M_PI / double(n + 1);
    BOOST_TEST(std::abs(top - (n == 1 ? 2 : 2 + 2 * std::cos(angle))) <= 16 * eps);
    // Rounding of the eigenvalue grows along the vector by the gap to the next one, above 1/n^2.
    BOOST_TEST(std::abs(last - std::sqrt(2 / double(n + 1)) * std::sin(n == 1 ? M_PI / 2 : angle)) <=
               1e4 * eps);
  }
}

BOOST_AUTO_TEST_SUITE_END()
