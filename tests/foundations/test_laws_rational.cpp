#include "laws_of_the_groups.hpp"

BOOST_AUTO_TEST_CASE(laws_in_the_plane_hold_over_rational) { actio::laws::laws_in_the_plane<actio::rational>(); }
BOOST_AUTO_TEST_CASE(laws_of_small_matrices_hold_over_rational) { actio::laws::laws_of_small_matrices<actio::rational>(); }
