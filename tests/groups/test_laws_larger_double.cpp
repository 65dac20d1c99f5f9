#include "laws_of_the_groups.hpp"

BOOST_AUTO_TEST_CASE(laws_of_larger_matrices_hold_over_double) {
  actio::laws::laws_of_larger_matrices<double>();
}
