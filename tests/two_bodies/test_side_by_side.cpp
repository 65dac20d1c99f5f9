// Pairs of bodies side by side in SIMD lanes: each moves as it does by itself.
#include <boost/test/unit_test.hpp>

#include "actio/two_bodies/side_by_side.hpp"
#include "didymos.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using testing::apart, testing::Didymos, testing::element;

namespace {

/// So many binaries like Didymos, no two of them alike, with moons that keep upright: tumbling ones would
/// make every rounding grow as fast as they part.
std::vector<TwoBodies> binaries(int count, TwoBodyOptions const& options) {
  Didymos const d;
  std::vector<TwoBodies> all;
  for (int k = 0; k < count; ++k) {
    std::array<double, 3> const half_axes{86 - 0.05 * k, 71.5, 66};
    auto const moon = ellipsoid_body(testing::mass_of_ellipsoid(2400, half_axes), half_axes, 4);
    double const r = Didymos::distance + 0.2 * k;
    all.emplace_back(d.primary, moon,
                     state_of_velocities(d.primary, moon, {r, 0, 0}, {0, Didymos::speed, 0}, element(d.q1),
                                         d.omega_1, element(d.q2), d.omega_2),
                     options);
  }
  return all;
}
/// How far two states are from each other, in the distance of the bodies and in radians.
double distance(TwoBodyState const& a, TwoBodyState const& b) {
  return std::max({(a.position - b.position).norm() / a.position.norm(),
                   2 * apart(a.first.attitude, b.first.attitude),
                   2 * apart(a.second.attitude, b.second.attitude)});
}
/// The largest distance from pairs that moved by themselves.
double distance_from_single(std::vector<TwoBodies> const& start, std::vector<TwoBodies> const& together,
                            long steps) {
  double worst = 0;
  for (std::size_t k = 0; k < start.size(); ++k) {
    auto alone = start[k];
    alone.step(steps);
    worst = std::max(worst, distance(alone.state(), together[k].state()));
    BOOST_TEST(together[k].time() == alone.time());
  }
  return worst;
}
/// A rounding of a rate makes a phase that grows with the angle turned, here of the primary; those of many
/// steps add up like a random walk.
double rounding(long steps, double step) {
  double const angle = 2 * std::numbers::pi / 8136 * std::abs(step) * static_cast<double>(steps);
  return epsilon<double>() * (1 + angle) * std::sqrt(static_cast<double>(steps));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(pairs_side_by_side)

BOOST_AUTO_TEST_CASE(each_pair_moves_as_by_itself) {
  constexpr long steps = 300;
  for (int const order : {2, 4})
    for (auto const& [method, step] : {std::pair{pair_splitting(2), 72.0},
                                       {pair_splitting(4), 300.0},
                                       {kepler_splitting(), 1200.0},
                                       {kepler_splitting(), -900.0}}) {
      // Eight packs of eight lanes or sixteen of four, and three that fill one in part.
      auto const start = binaries(67, {.order = order, .step = step, .method = method, .G = Didymos::G});
      auto together = start;
      BOOST_TEST(step_side_by_side(together, steps).empty());
      double const worst = distance_from_single(start, together, steps);
      BOOST_TEST_MESSAGE("order " << order << ", " << method.splitting.name << ": " << worst);
      BOOST_TEST(worst <= rounding(steps, step));
      // A control: neighbours are not taken for each other.
      BOOST_TEST(distance(together[0].state(), together[1].state()) > 1e-5);
    }
}

BOOST_AUTO_TEST_CASE(two_calls_go_on_where_one_ends) {
  auto const start = binaries(8, {.order = 2, .step = 900, .G = Didymos::G});
  auto together = start;
  step_side_by_side(together, 70), step_side_by_side(together, 0), step_side_by_side(together, 30);
  BOOST_TEST(distance_from_single(start, together, 100) <= rounding(100, 900));
}

BOOST_AUTO_TEST_CASE(motions_of_every_kind_share_a_batch) {
  Didymos const d;
  TwoBodyOptions const options{.order = 2, .step = 900, .G = Didymos::G};
  auto start = binaries(8, options);
  auto const other = [&](Vector3d const& x, Vector3d const& v, Vector3d const& w1, Vector3d const& w2) {
    return TwoBodies(d.primary, d.moon,
                     state_of_velocities(d.primary, d.moon, x, v, element(d.q1), w1, element(d.q2), w2),
                     options);
  };
  start[1] = other({3000, 0, 0}, {0, 0.03, 0.05}, d.omega_1, d.omega_2);       // an ellipse that is long
  start[2] = other({1300, 0, 0}, {0.1, 0.5, 0}, d.omega_1, d.omega_2);         // a hyperbola
  start[4] = other({1195, 0, 0}, {0, 0.1735, 0}, {2e-3, 4e-3, 0}, {0, 0, 0});  // half a revolution a step
  start[5] = other({1195, 0, 0}, {0, 0.1735, 0}, {0, 0, 0}, {3e-3, 0, 1e-3});
  auto const ball = sphere_body(1e9, 50, 2);
  start[6] = TwoBodies(d.primary, ball,
                       state_of_velocities(d.primary, ball, {1195, 0, 0}, {0, 0.1735, 0}, element(d.q1),
                                           d.omega_1, element(d.q2), {0, 0, 0}),
                       options);
  auto together = start;
  BOOST_TEST(step_side_by_side(together, 20).empty());
  double const worst = distance_from_single(start, together, 20);
  BOOST_TEST_MESSAGE("motions of every kind: " << worst);
  // A long rotor turns by 3 rad a step; near the pericentre of the long ellipse rounding grows tenfold.
  BOOST_TEST(worst <= 10 * rounding(20, 900));
}

BOOST_AUTO_TEST_CASE(a_pair_that_cannot_move_stays_and_the_others_go_on) {
  Didymos const d;
  TwoBodyOptions const options{.order = 2, .step = 900, .G = Didymos::G};
  auto start = binaries(16, options);
  // Two that fall onto each other, and below one whose neighbours would not have its options.
  for (std::size_t const k : {3u, 9u})
    start[k] = TwoBodies(d.primary, d.moon,
                         state_of_velocities(d.primary, d.moon, {1195, 0, 0}, {0, 0, 0}, element(d.q1),
                                             d.omega_1, element(d.q2), d.omega_2),
                         options);
  // One that passes the primary within its radius, in the middle of a drift.
  start[6] = TwoBodies(d.primary, d.moon,
                       state_of_velocities(d.primary, d.moon, {-9000, 300, 0}, {20, 0, 0}, element(d.q1),
                                           d.omega_1, element(d.q2), d.omega_2),
                       options);
  start[12] = binaries(13, {.order = 2, .step = 900, .method = moser_veselov_pair(), .G = Didymos::G})[12];
  auto together = start;
  auto const failed = step_side_by_side(together, 600);
  BOOST_TEST((failed == std::vector<std::size_t>{3, 6, 9}));
  for (std::size_t k = 0; k < start.size(); ++k) {
    auto alone = start[k];
    if (k == 3 || k == 6 || k == 9) {
      BOOST_CHECK_THROW(alone.step(600), Error);
      BOOST_TEST(together[k].time() == 0);
    } else {
      alone.step(600);
    }
    BOOST_TEST(distance(alone.state(), together[k].state()) <= rounding(600, 900));
  }
}

BOOST_AUTO_TEST_CASE(tangent_vectors_grow_as_those_of_single_pairs) {
  Didymos const d;
  for (int const order : {2, 4}) {
    auto pairs = binaries(9, {.order = order, .step = 900, .G = Didymos::G});
    pairs[4] = TwoBodies(d.primary, d.moon,
                         state_of_velocities(d.primary, d.moon, {1195, 0, 0}, {0, 0.1735, 0}, element(d.q1),
                                             {2e-3, 4e-3, 0}, element(d.q2), d.omega_2),
                         {.order = order, .step = 900, .G = Didymos::G});
    auto const together = lyapunov_exponents(pairs, 100);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      double const alone = pairs[k].lyapunov_exponent(100);
      // Rounding of a logarithm that is not small, and of derivatives that are sums of many terms.
      BOOST_TEST(std::abs(together[k] / alone - 1) <= 100 * rounding(100, 900));
      BOOST_TEST(pairs[k].time() == 0);
    }
    BOOST_TEST(std::abs(together[0] / together[1] - 1) > 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(wrong_counts_and_tides_are_refused) {
  auto pairs = binaries(4, {.order = 2, .step = 900, .G = Didymos::G});
  CHECK_REFUSED(step_side_by_side(pairs, -1), OutsideDomain);
  CHECK_REFUSED(lyapunov_exponents(pairs, 0), OutsideDomain);
  CHECK_REFUSED(lyapunov_exponents(pairs, 10, 0), OutsideDomain);
  TwoBodyOptions tidal_options{.order = 2, .step = 900, .G = Didymos::G};
  tidal_options.tides = std::array{Tide{1e-5, 0.01, 390, 2400}, Tide{1e-5, 0.01, 80, 2400}};
  auto const tidal = binaries(2, tidal_options);
  CHECK_REFUSED(lyapunov_exponents(tidal, 10), OutsideDomain);
  std::vector<TwoBodies> none;
  BOOST_TEST(step_side_by_side(none, 5).empty());
}

BOOST_AUTO_TEST_SUITE_END()
