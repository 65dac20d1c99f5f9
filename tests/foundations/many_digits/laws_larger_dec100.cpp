#include "actio/foundations/schur_form_in_digits.hpp"
#include "../laws_of_the_groups.hpp"

BOOST_AUTO_TEST_CASE(laws_of_larger_matrices_hold_over_dec100) { actio::laws::laws_of_larger_matrices<actio::dec100>(); }
