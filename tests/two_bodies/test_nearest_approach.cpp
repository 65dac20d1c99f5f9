// The least distance in a drift, against orbits that are followed point by point; and steps between whose
// ends two bodies come too near.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/two_bodies/two_bodies.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

namespace {

Element<SU2, double> const upright{{}, Eigen::Vector4d(1, 0, 0, 0)};

/// Two balls of radii 0.6 and 0.4, total mass 1, with this velocity at this position and steps of this
/// length.
TwoBodies balls(Vector3d const& x, Vector3d const& v, PairMethod method, double step, double G) {
  auto const one = sphere_body(0.75, 0.6, 2), two = sphere_body(0.25, 0.4, 2);
  return TwoBodies(one, two,
                   state_of_velocities(one, two, x, v, upright, {0, 0, 0.01}, upright, {0, 0.005, 0}),
                   {.order = 2, .step = step, .method = std::move(method), .G = G});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(nearest_approach)

BOOST_AUTO_TEST_CASE(the_least_distance_on_an_orbit_is_that_of_its_points) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> draw(-1, 1);
  auto const three = [&](double size) {
    return Three<double>{size * draw(generator), size * draw(generator), size * draw(generator)};
  };
  int passed = 0, around = 0;
  for (int n = 0; n < 800; ++n) {
    Three<double> const x = three(1), v = three(1.3), h = cross_product(x, v);
    double const time = draw(generator) * std::pow(10, draw(generator));
    if (dot(h, h) < 0.04)
      continue;  // points of an orbit that is nearly a line are far apart in the pericentre
    constexpr int points = 2000;
    double least = dot(x, x);
    Three<double> y = x, w = v;
    for (int k = 1; k <= points; ++k) {
      auto const moved = kepler_drift<double>(x, v, 1, time * k / points);
      for (int i = 0; i < 3; ++i) y[i] = x[i] + moved.position[i], w[i] = v[i] + moved.velocity[i];
      least = std::min(least, dot(y, y));
    }
    double const ends = std::min(dot(x, x), dot(y, y));
    double found = ends;
    if (bodies::detail::may_pass_the_nearest(x, v, y, w, time, true, 1))
      found = std::min(found, bodies::detail::square_in_pericentre(x, v, y, w, time, 1));
    // Between two points half a piece is missed, in which r^2 falls by its second derivative at most: 2
    // (v^2 + 1/r) half the square of the time, with r >= q and v^2 <= 2/q, q the pericentre.
    double const piece = time / points, room = 6 * piece * piece / std::sqrt(found);
    BOOST_TEST((found <= least * (1 + 1e-12) && found >= least - room), found << " for " << least);
    passed += found < ends * (1 - 1e-9);
    double const beta = 2 / std::sqrt(dot(x, x)) - dot(v, v);  // 1/a
    around += beta > 0 && std::abs(time) * beta * std::sqrt(beta) > 2 * M_PI;
  }
  BOOST_TEST(passed > 50);
  BOOST_TEST(around > 20);
}

BOOST_AUTO_TEST_CASE(a_pericentre_within_a_long_step_is_refused_where_the_spheres_meet_in_it) {
  // An ellipse with q = a (1 - e) a thousandth below or above the sum of the radii, from the apocentre; a
  // drift of Kepler's splitting has the pericentre between its ends.
  double const a = 10, period = 2 * M_PI * std::sqrt(a * a * a);
  for (double const q : {0.999, 1.001}) {
    double const e = 1 - q / a, far = a * (1 + e), speed = std::sqrt((1 - e) / (1 + e) / a);
    auto pair = balls({far, 0, 0}, {0, speed, 0}, kepler_splitting(), period * 0.7, 1);
    if (q > 1) {
      pair.step(2);
      BOOST_TEST(pair.nearness() < 0.2);  // at the ends nothing is seen of it
      continue;
    }
    CHECK_REFUSED(pair.step(2), OutsideDomain);
    BOOST_TEST(pair.time() == 0);
    BOOST_TEST((pair.state().position - Vector3d(far, 0, 0)).norm() == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_fly_by_within_a_long_step_is_refused_by_every_method) {
  // So little attraction that the way is straight, at this distance from the first body; one step.
  for (auto const& method : {pair_splitting(2), pair_splitting(4), moser_veselov_pair(), kepler_splitting()})
    for (double const distance : {0.999, 1.001})
      for (double const there : {1.0, -1.0}) {
        auto pair = balls({-20 * there, distance, 0}, {1, 0, 0}, method, 43 * there, 1e-9);
        if (distance > 1) {
          pair.step();
          BOOST_TEST(std::abs(pair.state().position[0] - 23 * there) < 1e-3);
        } else {
          CHECK_REFUSED(pair.step(), OutsideDomain);
          BOOST_TEST(pair.state().position[0] == -20 * there);
        }
      }
}

BOOST_AUTO_TEST_SUITE_END()
