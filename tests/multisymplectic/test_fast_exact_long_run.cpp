// The optimised implementation of media against exact solutions: simple waves oblique to the mesh, whose
// error has order 2, and motions of which the discrete equations have a closed solution.
#include <boost/test/unit_test.hpp>

#include "acoustic.hpp"
#include "actio/fast_media/fast_medium_2d.hpp"
#include "simple_wave.hpp"

using namespace actio;
using namespace actio::media;
using SimpleWave = testing::SimpleWave<2>;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Place = std::array<double, 2>;
using enum Side;

FastBox2d periodic_box(int n, double length) {
  return {{n, n}, {length / n, length / n}, {periodic, periodic}, {periodic, periodic}};
}

Place still(Place const&) { return {0, 0}; }
/// The largest of `off(X, x)` over the nodes, X where one is at rest and x where it is.
template <class Medium, class Off>
double largest_over(FastMedium2d<Medium> const& fast, Off const& off) {
  auto const x = fast.places();
  double worst = 0;
  std::size_t at = 0;
  for (int j = 0; j < fast.box().nodes(1); ++j)
    for (int i = 0; i < fast.box().nodes(0); ++i, ++at)
      worst = std::max(worst, off(fast.box().at(i, j), x[at]));
  return worst;
}
/// The largest distance of a node from the exact wave at time 0.25 on n x n cells.
template <class Medium>
double error_on(Medium const& medium, SimpleWave const& wave, int n) {
  FastBox2d const box = periodic_box(n, 1);
  double const time = 0.25;
  long const steps = n;
  FastMedium2d<Medium> fast(
      medium, box, time / static_cast<double>(steps), 1, [&](Place const& X) { return wave.at(X, 0); },
      [&](Place const& X) { return wave.velocity_at(X); });
  fast.step(steps);
  return largest_over(fast, [&](Place const& X, Place const& x) {
    Place const exact = wave.at(X, time);
    return std::hypot(x[0] - exact[0], x[1] - exact[1]);
  });
}
/// Four refinements from 24 to 384: the slope of each of them.
template <class Medium>
void has_order_two(char const* name, Medium const& medium, std::function<double(double)> const& c) {
  double const root = std::sqrt(5.0);
  SimpleWave const wave{c, {2 / root, 1 / root}, 1 / root, 0.02};
  double before = 0;
  for (int const n : {24, 48, 96, 192, 384}) {
    double const error = error_on(medium, wave, n);
    if (before > 0) {
      double const order = std::log2(before / error);
      BOOST_TEST_MESSAGE(name << ", simple wave, " << n << "^2 cells: error " << error << ", order "
                              << order);
      BOOST_TEST(std::abs(order - 2) <= 0.05);
    }
    before = error;
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_exact_solutions)

BOOST_AUTO_TEST_CASE(oblique_simple_waves_have_order_two) {
  has_order_two("gas, gamma 2", FastFluid{PolytropicByRoots<1, 2>{0.5}},
                [](double q) { return std::pow(q, -1.5); });
  has_order_two("gas, gamma 7/5", FastFluid{PolytropicByRoots<5, 7>{0.7}},
                [](double q) { return std::sqrt(0.98) * std::pow(q, -1.2); });
  has_order_two("St Venant-Kirchhoff", FastStVenantKirchhoff{0.6, 0.2},
                [](double q) { return std::sqrt((3 * q * q - 1) / 2); });
  has_order_two("neo-Hookean", neo_hookean(0.6, 0.2),
                [](double q) { return std::sqrt(0.2 + (0.8 - 0.6 * std::log(q)) / (q * q)); });
  has_order_two("Blatz-Ko", blatz_ko<1>(0.25),
                [](double q) { return std::sqrt(0.25 * (1 + 3 / (q * q * q * q))); });
}

// The law is linear in the displacement, and the discrete equations have the solution sin(kX) cos(wt) with
// sin(w dt/2)/dt = c sin(k h/2)/h. Differences are rounding alone: a rounding or two of places below 1 in
// each step, which goes on as a velocity: with n steps n^2/2 of them at most and n^1.5/2 as a walk, which for
// 200 steps is 6e-13.
BOOST_AUTO_TEST_CASE(a_standing_wave_has_the_discrete_dispersion_relation) {
  int const n = 40;
  for (bool const held : {false, true}) {
    FastBox2d const box{{n, 5},
                        {1.0 / n, 0.03},
                        {held ? fixed : periodic, held ? fixed : periodic},
                        {held ? sliding : periodic, held ? sliding : periodic}};
    double const c = 1.3, h = 1.0 / n, dt = 0.6 * h / c, k = 2 * M_PI * 3;
    double const w = 2 / dt * std::asin(dt * c * std::sin(k * h / 2) / h);
    auto const u = [&](double X, double t) { return 0.03 * std::sin(k * X) * std::cos(w * t); };
    FastMedium2d fast(
        FastFluid{testing::Acoustic{c}}, box, dt, 1,
        [&](Place const& X) {
          return Place{X[0] + u(X[0], 0), X[1]};
        },
        still);
    fast.step(200);
    double const worst = largest_over(fast, [&](Place const& X, Place const& x) {
      return std::max(std::abs(x[0] - X[0] - u(X[0], fast.time())), std::abs(x[1] - X[1]));
    });
    BOOST_TEST_MESSAGE("standing wave: difference from the discrete dispersion relation " << worst);
    BOOST_TEST(worst <= 1e-12);
  }
}

// A shear wave leaves J = 1 at every corner, and its equation is linear at any amplitude: here neighbours
// slide past each other by three widths of a cell.
BOOST_AUTO_TEST_CASE(a_neo_hookean_shear_wave_of_any_amplitude_has_it_too) {
  int const n = 30;
  FastBox2d const box = periodic_box(n, 1);
  double const mu = 0.8, h = 1.0 / n, dt = 0.1 * h, k = 2 * M_PI, amplitude = 0.5;
  double const w = 2 / dt * std::asin(dt * std::sqrt(mu) * std::sin(k * h / 2) / h);
  auto const u = [&](double Y, double t) { return amplitude * std::sin(k * Y) * std::cos(w * t); };
  FastMedium2d fast(
      neo_hookean(2, mu), box, dt, 1,
      [&](Place const& X) {
        return Place{X[0] + u(X[1], 0), X[1]};
      },
      still);
  fast.step(200);
  double const worst = largest_over(fast, [&](Place const& X, Place const& x) {
    return std::max(std::abs(x[0] - X[0] - u(X[1], fast.time())), std::abs(x[1] - X[1]));
  });
  BOOST_TEST_MESSAGE("shear wave: difference from the discrete dispersion relation " << worst);
  BOOST_TEST(worst <= 1e-12);
}

// A block with one deformation everywhere, periodic as such, moves without forces: what rounding leaves of
// them is a sum of at most 80 roundings of a stress over h, and places gain at most eps a step.
BOOST_AUTO_TEST_CASE(a_homogeneous_periodic_block_moves_on_a_straight_line) {
  double const F[2][2] = {{1.2, 0.3}, {-0.1, 0.8}}, dt = 0.01;
  int const n = 16, steps = 300;
  FastBox2d box = periodic_box(n, 1);
  box.period = {{{F[0][0], F[1][0]}, {F[0][1], F[1][1]}}};
  auto const place = [&](Place const& X) {
    return Place{F[0][0] * X[0] + F[0][1] * X[1], F[1][0] * X[0] + F[1][1] * X[1]};
  };
  auto const test = [&](auto const& medium) {
    FastMedium2d fast(medium, box, dt, 1, place, [](Place const&) { return Place{0.2, -0.1}; });
    fast.step(steps);
    double const t = fast.time(), rate = 4.0 * n * eps * (80 + 4.0 * n);
    double const worst = largest_over(fast, [&](Place const& node, Place const& x) {
      Place const X = place(node);
      return std::max(std::abs(x[0] - X[0] - 0.2 * t), std::abs(x[1] - X[1] + 0.1 * t));
    });
    BOOST_TEST(worst <= t * t * rate + 2 * steps * eps);
  };
  test(FastFluid{PolytropicByRoots<1, 2>{0.5}});
  test(FastStVenantKirchhoff{0.6, 0.2});
  test(neo_hookean(0.6, 0.2));
}

namespace {
/// How far a body, thrown and let go, comes from what it started with.
struct Changes {
  double momentum = 0, angular_momentum = 0, energy = 0, drift = 0;
};
template <class Medium>
Changes thrown(char const* name, Medium const& medium, long steps) {
  int const n = 24, m = 16;
  FastBox2d const box{
      {n, m}, {1.0 / n, 1.0 / n}, {Side::free, Side::free}, {Side::free, Side::free}, {-0.5, -0.3}};
  FastMedium2d fast(
      medium, box, 0.2 / n, 3,
      [](Place const& X) {
        return Place{X[0] * 1.02 + 0.01 * X[1] * X[1], X[1]};
      },
      [](Place const& X) {
        return Place{0.03 - 0.3 * X[1], 0.02 + 0.3 * X[0]};
      });
  Place const p = fast.momentum();
  double const L = fast.angular_momentum(), E = fast.energy();
  // What the parts have, whichever way they go; all nodes as heavy as those inside.
  double parts = 0;
  for (auto const& v : fast.velocities()) parts += 3.0 / (n * n) * std::hypot(v[0], v[1]);
  Changes most;
  int const samples = 100;
  for (int k = 0; k < samples; ++k) {
    fast.step(steps / samples);
    Place const q = fast.momentum();
    most.momentum = std::max(most.momentum, std::hypot(q[0] - p[0], q[1] - p[1]) / parts);
    most.angular_momentum = std::max(most.angular_momentum, std::abs(fast.angular_momentum() / L - 1));
    double const e = fast.energy() / E - 1;
    most.energy = std::max(most.energy, std::abs(e));
    // The mean of the last quarter less that of the first.
    most.drift += (k >= 75 ? e : k < 25 ? -e : 0) / 25;
  }
  BOOST_TEST_MESSAGE(name << ", " << steps << " steps: momentum " << most.momentum << ", angular momentum "
                          << most.angular_momentum << ", energy " << most.energy << ", change of its mean "
                          << most.drift);
  return most;
}
}  // namespace

// Momenta to rounding: each step rounds the velocities and places of 425 nodes, which is a walk of
// eps sqrt(steps/425), 1e-15 for ten thousand steps, or less than ten times that where the same rounding
// comes again and again, as it does while a node moves slowly. The energy stays in a band of the size (w
// dt)^2/8 of the motions that hold it, and its mean does not go through the band.
BOOST_AUTO_TEST_CASE(bodies_let_go_conserve_momenta_and_their_energy_does_not_drift) {
  auto const test = [](Changes const& most, double of_momenta) {
    BOOST_TEST(most.momentum <= of_momenta);
    BOOST_TEST(most.angular_momentum <= of_momenta);
    BOOST_TEST(most.energy <= 1e-3);
    BOOST_TEST(std::abs(most.drift) <= 0.5 * most.energy);
  };
  for (auto const& [steps, of_momenta] : {std::pair{10000L, 1e-14}, {100000L, 1e-13}}) {
    test(thrown("St Venant-Kirchhoff", FastStVenantKirchhoff{1, 0.5}, steps), of_momenta);
    test(thrown("neo-Hookean", neo_hookean(1, 0.5), steps), of_momenta);
    test(thrown("Blatz-Ko", blatz_ko<1>(0.5), steps), of_momenta);
  }
}
// A gas goes apart, so that its energy has no band to be in.
BOOST_AUTO_TEST_CASE(a_gas_let_go_conserves_momenta) {
  Changes const most = thrown("gas", FastFluid{PolytropicByRoots<1, 2>{0.05}}, 1000);
  BOOST_TEST(most.momentum <= 1e-14);
  BOOST_TEST(most.angular_momentum <= 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
