// The logarithm of a motion of the plane and of space, from the identity to within 1e-8 of half a turn:
// against 50 digits.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "angles_next_to_pi.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

// The bound: that of a rotation (test_logarithm_of_rotations.cpp), and as much again for the translation.
BOOST_AUTO_TEST_CASE(log_of_motions_is_good_to_rounding_up_to_pi) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(2);
  double worst = 0;
  for (int k = 0; k <= 8; ++k)
    for (int repeat = 0; repeat < 50; ++repeat) {
      Number const angle = angle_before_pi(k);
      Coordinates<SE<2>, Number> plane;
      plane << angle, direction<2>(draw);
      Coordinates<SE<3>, Number> space;
      space << direction<3>(draw) * angle, direction<3>(draw);
      worst = std::max({worst, error_of_log(SE<2>{}, plane), error_of_log(SE<3>{}, space)});
    }
  BOOST_TEST_MESSAGE("log on SE(2), SE(3): worst error " << worst / eps << " epsilon");
  BOOST_TEST(worst < 32 * eps);
}
