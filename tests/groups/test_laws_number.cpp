// The laws of the smaller groups over the rationals and in many digits.
//
// In a unit of its own, which is as large as a unit may be.
#include "laws_of_the_groups.hpp"

using namespace actio;

BOOST_AUTO_TEST_CASE(laws_in_the_plane_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_in_the_plane<Number>);
}
BOOST_AUTO_TEST_CASE(laws_in_space_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_in_space<Number>);
}
BOOST_AUTO_TEST_CASE(laws_of_small_matrices_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_of_small_matrices<Number>);
}
BOOST_AUTO_TEST_CASE(laws_of_a_span_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_of_a_span<Number>);
}
