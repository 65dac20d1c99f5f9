// The logarithm from the identity to within 1e-8 of the edge of its chart: against closed forms, against 50 digits, and refused at the edge.
#include <boost/test/unit_test.hpp>

#include "actio/foundations/groups/motions.hpp"
#include "actio/foundations/groups/unit_quaternions.hpp"
#include "angles_next_to_pi.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

double const eps = epsilon<double>();

/// exp(v) computed in 50 digits and rounded to double, so that the only error of its logarithm is that of one rounding and of `log` itself.
/// The error of `log`, relative to v.
template <Group G>
double error_of_log(G const& group, Coordinates<G, dec50> const& v) {
  auto const g = exp(velocity(group, v));
  Element<G, double> rounded{group, g.value.template cast<double>()};
  Coordinates<G, dec50> const found = log(rounded).coordinates.template cast<dec50>();
  return to_double(magnitude((found - v).eval())) / to_double(magnitude(v));
}

}  // namespace

// Rounding exp(v) moves each entry by half an epsilon; log passes it on, magnified by no more than (angle/2)/tan(angle/2) < pi/2 or so, to at most
// nine entries; log itself does some ten roundings.
BOOST_AUTO_TEST_CASE(log_of_rotations_is_good_to_rounding_up_to_pi) {
  Draw draw(1);
  double worst = 0;
  for (int k = 0; k <= 8; ++k)
    for (int repeat = 0; repeat < 50; ++repeat) {
      dec50 const angle = angle_before_pi(k);
      worst = std::max(worst, error_of_log(SO<2>{}, Coordinates<SO<2>, dec50>(angle)));
      worst = std::max(worst, error_of_log(SO<2>{}, Coordinates<SO<2>, dec50>(-angle)));
      worst = std::max(worst, error_of_log(SO<3>{}, Coordinates<SO<3>, dec50>(direction<3>(draw) * angle)));
    }
  BOOST_TEST_MESSAGE("log on SO(2), SO(3): worst error " << worst / eps << " epsilon");
  BOOST_TEST(worst < 16 * eps);
}

BOOST_AUTO_TEST_CASE(log_of_motions_is_good_to_rounding_up_to_pi) {
  Draw draw(2);
  double worst = 0;
  for (int k = 0; k <= 8; ++k)
    for (int repeat = 0; repeat < 50; ++repeat) {
      dec50 const angle = angle_before_pi(k);
      Coordinates<SE<2>, dec50> plane;
      plane << angle, direction<2>(draw);
      Coordinates<SE<3>, dec50> space;
      space << direction<3>(draw) * angle, direction<3>(draw);
      worst = std::max({worst, error_of_log(SE<2>{}, plane), error_of_log(SE<3>{}, space)});
    }
  BOOST_TEST_MESSAGE("log on SE(2), SE(3): worst error " << worst / eps << " epsilon");
  BOOST_TEST(worst < 32 * eps);
}

BOOST_AUTO_TEST_CASE(log_of_small_rotations_keeps_relative_accuracy) {
  Draw draw(3);
  double worst = 0;
  for (dec50 angle = dec50(1) / 2; angle > dec50("1e-40"); angle /= 10) {
    worst = std::max(worst, error_of_log(SO<2>{}, Coordinates<SO<2>, dec50>(angle)));
    worst = std::max(worst, error_of_log(SO<3>{}, Coordinates<SO<3>, dec50>(direction<3>(draw) * angle)));
    worst = std::max(worst, error_of_log(SU2{}, Coordinates<SU2, dec50>(direction<3>(draw) * angle)));
    worst = std::max(worst, error_of_log(SO<4>{}, Coordinates<SO<4>, dec50>(direction<6>(draw) * angle)));
    worst = std::max(worst, error_of_log(SO<5>{}, Coordinates<SO<5>, dec50>(direction<10>(draw) * angle)));
  }
  BOOST_TEST_MESSAGE("log of small rotations: worst error " << worst / eps << " epsilon, relative");
  BOOST_TEST(worst < 32 * eps);
}

// Pairs of angles: apart, equal, opposite, one of them zero or tiny, one of them next to pi.
BOOST_AUTO_TEST_CASE(log_on_SO4_and_SO5_is_good_to_rounding_for_all_pairs_of_angles) {
  Draw draw(4);
  double worst4 = 0, worst5 = 0;
  dec50 const half = acos(dec50(0)), tiny = dec50("1e-9");
  for (int k = 0; k <= 8; ++k) {
    dec50 const a = angle_before_pi(k);
    std::vector<std::pair<dec50, dec50>> pairs = {{a, dec50(1) / 3}, {a, dec50(0)}, {a, tiny}, {a, -half}, {half, half}, {half, -half}, {half, dec50(0)}};
    if (k == 0) pairs.insert(pairs.end(), {{a, a}, {a, -a}, {a, a + tiny}, {a, a + dec50("1e-16")}});
    for (auto const& [first, second] : pairs)
      for (int repeat = 0; repeat < 10; ++repeat) {
        worst4 = std::max(worst4, error_of_log(SO<4>{}, in_a_random_frame<4>(draw, first, second)));
        worst5 = std::max(worst5, error_of_log(SO<5>{}, in_a_random_frame<5>(draw, first, second)));
      }
  }
  BOOST_TEST_MESSAGE("log on SO(4): worst error " << worst4 / eps << " epsilon, on SO(5): " << worst5 / eps);
  BOOST_TEST(worst4 < 32 * eps);
  BOOST_TEST(worst5 < 64 * eps);  // the Schur form brings more roundings than the pair of quaternions
}

// Where both angles come within d of pi the logarithm magnifies rounding by 1/d; its exponential is the rotation all the same.
BOOST_AUTO_TEST_CASE(two_angles_next_to_pi_cost_what_they_must) {
  Draw draw(5);
  for (int repeat = 0; repeat < 20; ++repeat) {
    dec50 const a = angle_before_pi(8), b = angle_before_pi(7);
    auto const v = in_a_random_frame<4>(draw, a, b);
    auto const w = in_a_random_frame<5>(draw, a, -b);
    BOOST_TEST(error_of_log(SO<4>{}, v) < 32e8 * eps);
    BOOST_TEST(error_of_log(SO<5>{}, w) < 64e8 * eps);
    Element<SO<5>, double> const g{{}, exp(velocity(SO<5>{}, w)).value.cast<double>()};
    BOOST_TEST(magnitude((exp(log(g)).value - g.value).eval()) < 64 * eps);
  }
}

// Next to -1 the axis is a short vector. As a function of the numbers stored, the logarithm keeps all digits; as a function of
// what they were rounded from, it cannot.
BOOST_AUTO_TEST_CASE(log_of_quaternions_is_good_to_rounding_up_to_two_pi) {
  Draw draw(6);
  double worst = 0;
  for (int k = 1; k <= 8; ++k)
    for (int repeat = 0; repeat < 50; ++repeat) {
      dec50 const angle = 2 * angle_before_pi(k);
      auto const q = exp(velocity(SU2{}, Coordinates<SU2, dec50>(direction<3>(draw) * angle)));
      Element<SU2, double> const rounded{{}, q.value.cast<double>()};
      auto const expected = log(over<dec50>(rounded)).coordinates;
      Coordinates<SU2, dec50> const found = log(rounded).coordinates.cast<dec50>();
      worst = std::max(worst, to_double(magnitude((found - expected).eval())) / to_double(magnitude(expected)));
    }
  BOOST_TEST_MESSAGE("log on SU(2): worst error " << worst / eps << " epsilon");
  BOOST_TEST(worst < 16 * eps);
}

BOOST_AUTO_TEST_CASE(log_of_a_turn_about_an_axis_is_the_angle_times_the_axis) {
  dec100 const angle = dec100(3), c = cos(angle), s = sin(angle);
  Eigen::Matrix<dec100, 3, 3> r;
  r << c, -s, dec100(0), s, c, dec100(0), dec100(0), dec100(0), dec100(1);
  auto const v = log(Element<SO<3>, dec100>{{}, r}).coordinates;
  BOOST_TEST(to_double(magnitude(Coordinates<SO<3>, dec100>(v - Coordinates<SO<3>, dec100>(dec100(0), dec100(0), angle)))) < 1e-98);
  auto const q = log(Element<SU2, dec100>{{}, {c, s * 3 / 5, dec100(0), s * 4 / 5}}).coordinates;
  BOOST_TEST(to_double(magnitude(Coordinates<SU2, dec100>(q - Coordinates<SU2, dec100>(angle * 6 / 5, dec100(0), angle * 8 / 5)))) < 1e-98);
}
