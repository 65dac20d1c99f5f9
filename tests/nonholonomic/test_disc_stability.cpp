// A thin disc that rolls upright, or spins on the spot: the speeds from which on it does not fall, by the
// eigenvalues of the tangent of a step.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/eigenvalues_of.hpp"
#include "actio/reduction/composition.hpp"
#include "rolling_systems.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

/// Of radius, mass and gravity 1; its axis is e3, and the plane touches it where its rim is lowest.
struct Disc {
  Constrained system{"SE(3)", "(w1^2/4 + w2^2/4 + w3^2/2 + v1^2 + v2^2 + v3^2)/2 - q",    point_rests, {"u"},
                     {},      "q = sqrt(u1^2 + u2^2); r1 = -u1/q; r2 = -u2/q; r3 = 0*u3;"};
  ConstrainedState upright(Triple const& w) const {
    return system.state(rolling_velocity(w, {0, -1, 0}), {0, 1, 0, 0});
  }
  /// The multipliers of a step of order 4, seen from a frame that has turned about e3 with the plane: the
  /// motion is at rest there.
  Eigen::VectorXcd multipliers(Triple const& w, double h) const {
    auto const start = upright(w);
    RattleMap const map(*system.system, *system.constraints, symmetric_composition<double>(4),
                        start.velocity);
    auto const image = map(h, ReducedPointOver<double>{start.point.momentum, start.point.vectors});
    double const c = image.vectors[1], s = image.vectors[0];  // of the angle by which the vertical turned
    Eigen::MatrixXd back = Eigen::MatrixXd::Identity(10, 10);
    for (Index k : {0, 3, 6}) back(k, k) = back(k + 1, k + 1) = c, back(k, k + 1) = -s, back(k + 1, k) = s;
    Eigen::VectorXd moved(10);
    for (std::size_t k = 0; k < 10; ++k)
      moved[static_cast<Index>(k)] = k < 6 ? image.momentum[k] - 0 : image.vectors[k - 6];
    moved = back * moved;
    for (std::size_t k = 0; k < 4; ++k)
      BOOST_TEST(std::abs(moved[static_cast<Index>(6 + k)] - start.point.vectors[k]) < 1e-13);
    return eigenvalues_of(back *
                          tangent_of([&](auto const& p) { return map(Moved<double>(h), p); }, start.point));
  }
  /// The square of the rate at which a tilt grows: that of the pair of multipliers that are furthest from 1.
  double square_of_rate(Triple const& w, double h) const {
    std::complex<double> furthest = 0;
    for (auto const& x : multipliers(w, h)) {
      if (std::abs(x) < 0.5) continue;  // zero: reactions
      auto const square = (x + 1.0 / x - 2.0) / (h * h);
      if (std::abs(square) > std::abs(furthest)) furthest = square;
    }
    return furthest.real();
  }
  double largest_modulus(Triple const& w, double h) const {
    double largest = 0;
    for (auto const& x : multipliers(w, h)) largest = std::max(largest, std::abs(x));
    return largest;
  }
};

/// @param motion  square of the speed over that of the threshold -> angular velocity
template <class Motion>
void has_its_threshold(char const* name, Motion const& motion) {
  Disc const disc;
  double const h = 0.05;
  // One per cent to either side: a tilt grows at the root of 0.8 times that.
  double const below = disc.largest_modulus(motion(0.99), h), above = disc.largest_modulus(motion(1.01), h);
  BOOST_TEST(below > 1 + 0.08 * h);
  // Multipliers that are 1 with a single eigenvector are found to the root of the rounding.
  BOOST_TEST(above < 1 + 1e-6);
  // The square of the rate is smooth and nearly linear: the threshold is where it vanishes.
  double const low = disc.square_of_rate(motion(0.99), h), high = disc.square_of_rate(motion(1.01), h);
  double const threshold = 0.99 + 0.02 * low / (low - high);
  BOOST_TEST_MESSAGE(name << ": threshold " << threshold
                          << " times the square of the known speed; multipliers " << below << ", " << above);
  BOOST_TEST(std::abs(threshold - 1) < 1e-6);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(stability_of_a_disc)

BOOST_AUTO_TEST_CASE(a_disc_rolls_upright_from_v2_over_gr_a_third_on) {
  has_its_threshold("rolling", [](double square) { return Triple(0, 0, std::sqrt(square / 3)); });
}

BOOST_AUTO_TEST_CASE(a_disc_spins_upright_from_omega2_r_over_g_four_fifths_on) {
  has_its_threshold("spinning", [](double square) { return Triple(0, std::sqrt(square * 4 / 5), 0); });
}

BOOST_AUTO_TEST_CASE(a_tilt_grows_below_the_threshold_and_stays_above) {
  Disc const disc;
  auto const largest_tilt = [&](Triple const& w) {
    double const tilt = 1e-6;
    auto const start =
        constrained_state(*disc.system.system, *disc.system.constraints, rolling_velocity(w, {0, -1, 0}),
                          {0, std::cos(tilt), std::sin(tilt), 0}, 0, 1e-3);
    auto run = disc.system.run(0.05, {1}, start);
    double largest = 0;
    for (int k = 0; k < 1000; ++k) run.step(), largest = std::max(largest, std::abs(run.point().vectors[2]));
    return largest;
  };
  for (bool const rolling : {true, false}) {
    auto const motion = [&](double square) {
      return rolling ? Triple(0, 0, std::sqrt(square / 3)) : Triple(0, std::sqrt(square * 4 / 5), 0);
    };
    double const below = largest_tilt(motion(0.9)), above = largest_tilt(motion(1.1));
    BOOST_TEST_MESSAGE((rolling ? "rolling" : "spinning")
                       << ": tilt from 1e-6 to " << below << " and " << above);
    // Over 50 units of time, at a rate of 0.28 below.
    BOOST_TEST(below > 1e-2);
    BOOST_TEST(above < 1e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
