#include "laws_of_the_groups.hpp"

BOOST_AUTO_TEST_CASE(laws_in_five_dimensions_hold_over_double) {
  actio::laws::laws_in_five_dimensions<double>();
}
