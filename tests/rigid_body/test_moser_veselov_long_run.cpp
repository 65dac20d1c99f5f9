// Long runs: Casimir and momentum in space of the Moser-Veselov body, and how their changes grow. A million
// steps in space; in four and five dimensions, where a step takes ten times as long, a quarter of that, and
// in eight a twentieth, with a bound that is smaller in proportion: stress_long_drift takes all.
#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/body_in_motion.hpp"
#include "random_bodies.hpp"

using namespace actio;

namespace {

template <int n>
void keeps_its_momenta(double angle, double bound, long count, int dimension = n) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<n>(random, dimension);
  MoserVeselov<n> const scheme(inertia, angle / spin.coordinates.norm());
  auto body = release(inertia, identity<double>(inertia.group), spin);
  auto const start = body.spatial_momentum();
  double const size = start.components.norm(), energy = kinetic_energy(inertia, body.body_momentum);
  double casimir = 0, spatial = 0, lost = 0;
  std::vector<double> steps, drift;
  for (long k = 1, next = 100; k <= count; ++k) {
    advance(scheme, body);
    if (k % 1000 && k != next) continue;
    casimir = std::max(casimir, std::abs((body.body_momentum.components / size).squaredNorm() - 1));
    spatial = std::max(spatial, (body.spatial_momentum() - start).components.norm() / size);
    lost = std::max(lost, std::abs(kinetic_energy(inertia, body.body_momentum) / energy - 1));
    if (k == next)
      steps.push_back(static_cast<double>(k)), drift.push_back(std::max(spatial, 1e-16)), next = next * 3 / 2;
  }
  double const growth = testing::fit_order(steps, drift).slope;
  BOOST_TEST_MESSAGE("SO(" << dimension << "), " << angle << " rad a step, " << count << " steps: Casimir "
                           << casimir << ", momentum in space " << spatial << ", energy " << lost
                           << ", growth exponent " << growth);
  BOOST_TEST(casimir <= bound);
  BOOST_TEST(spatial <= bound);
  BOOST_TEST(lost <= 10 * bound);
  // A random walk of roundings grows with the power 1/2; one that always pulls the same way with the power 1.
  BOOST_TEST(growth < 0.85);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(long_run)

BOOST_AUTO_TEST_CASE(momenta_stay_over_a_million_steps_in_space) {
  keeps_its_momenta<3>(0.01, 1e-11, 1000000);
  keeps_its_momenta<3>(0.2, 1e-11, 1000000);
}

BOOST_AUTO_TEST_CASE(momenta_stay_in_more_dimensions) {
  keeps_its_momenta<Dynamic>(0.1, 5e-11, 250000, 4);
  keeps_its_momenta<Dynamic>(0.1, 5e-11, 250000, 5);
  keeps_its_momenta<Dynamic>(0.05, 1e-11, 50000, 8);
}

BOOST_AUTO_TEST_SUITE_END()
