#include "laws_of_the_groups.hpp"

BOOST_AUTO_TEST_CASE(laws_of_larger_matrices_hold_over_rational) { actio::laws::laws_of_larger_matrices<actio::rational>(); }
BOOST_AUTO_TEST_CASE(laws_in_five_dimensions_hold_over_rational) { actio::laws::laws_in_five_dimensions<actio::rational>(); }
BOOST_AUTO_TEST_CASE(laws_of_a_span_hold_over_rational) { actio::laws::laws_of_a_span<actio::rational>(); }
