// The logarithm of a rotation from the identity to within 1e-8 of the edge of its chart: against closed forms
// and against 50 digits.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "angles_next_to_pi.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

BOOST_AUTO_TEST_CASE(log_of_rotations_is_good_to_rounding_up_to_pi) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(1);
  double worst = 0;
  for (int k = 0; k <= 8; ++k)
    for (int repeat = 0; repeat < 50; ++repeat) {
      Number const angle = angle_before_pi(k);
      worst = std::max(worst, error_of_log(SO<2>{}, Coordinates<SO<2>, Number>(angle)));
      worst = std::max(worst, error_of_log(SO<2>{}, Coordinates<SO<2>, Number>(-angle)));
      worst = std::max(worst, error_of_log(SO<3>{}, Coordinates<SO<3>, Number>(direction<3>(draw) * angle)));
    }
  BOOST_TEST_MESSAGE("log on SO(2), SO(3): worst error " << worst / eps << " epsilon");
  BOOST_TEST(worst < 16 * eps);
}

BOOST_AUTO_TEST_CASE(log_of_quaternions_is_good_to_rounding_up_to_two_pi) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(6);
  double worst = 0;
  for (int k = 1; k <= 8; ++k)
    for (int repeat = 0; repeat < 50; ++repeat) {
      Number const angle = 2 * angle_before_pi(k);
      auto const q = exp(velocity(SU2{}, Coordinates<SU2, Number>(direction<3>(draw) * angle)));
      Element<SU2, double> const rounded{{}, in_double(q.value)};
      auto const expected = log(over<Number>(rounded)).coordinates;
      Coordinates<SU2, Number> const found = log(rounded).coordinates.cast<Number>();
      worst =
          std::max(worst, to_double(magnitude((found - expected).eval())) / to_double(magnitude(expected)));
    }
  BOOST_TEST_MESSAGE("log on SU(2): worst error " << worst / eps << " epsilon");
  BOOST_TEST(worst < 16 * eps);
}

BOOST_AUTO_TEST_CASE(log_of_a_turn_about_an_axis_is_the_angle_times_the_axis) {
  WithArithmetic const digits(Arithmetic::decimal(100));
  Number const angle = Number(3), c = cos(angle), s = sin(angle);
  Matrix<Number, 3, 3> r;
  r << c, -s, Number(0), s, c, Number(0), Number(0), Number(0), Number(1);
  auto const v = log(Element<SO<3>, Number>{{}, r}).coordinates;
  BOOST_TEST(to_double(magnitude(Coordinates<SO<3>, Number>(
                 v - Coordinates<SO<3>, Number>(Number(0), Number(0), angle)))) < 1e-98);
  auto const q = log(Element<SU2, Number>{{}, {c, s * 3 / 5, Number(0), s * 4 / 5}}).coordinates;
  BOOST_TEST(to_double(magnitude(Coordinates<SU2, Number>(
                 q - Coordinates<SU2, Number>(angle * 6 / 5, Number(0), angle * 8 / 5)))) < 1e-98);
}
