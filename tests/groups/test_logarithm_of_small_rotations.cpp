// The logarithm is relatively accurate down to angles of 1e-40: against 50 digits.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "angles_next_to_pi.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

BOOST_AUTO_TEST_CASE(log_of_small_rotations_keeps_relative_accuracy) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(3);
  double worst = 0;
  for (Number angle = Number(1) / 2; angle > Number(1e-40); angle /= 10) {
    worst = std::max(worst, error_of_log(SO<2>{}, Coordinates<SO<2>, Number>(angle)));
    worst = std::max(worst, error_of_log(SO<3>{}, Coordinates<SO<3>, Number>(direction<3>(draw) * angle)));
    worst = std::max(worst, error_of_log(SU2{}, Coordinates<SU2, Number>(direction<3>(draw) * angle)));
    worst = std::max(worst, error_of_log(SO<4>{}, Coordinates<SO<4>, Number>(direction<6>(draw) * angle)));
    worst = std::max(worst, error_of_log(SO<5>{}, Coordinates<SO<5>, Number>(direction<10>(draw) * angle)));
  }
  BOOST_TEST_MESSAGE("log of small rotations: worst error " << worst / eps << " epsilon, relative");
  BOOST_TEST(worst < 32 * eps);
}
