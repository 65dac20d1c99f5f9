#include "actio/foundations/schur_form_in_digits.hpp"
#include "../laws_of_the_groups.hpp"

BOOST_AUTO_TEST_CASE(laws_in_five_dimensions_hold_over_dec100) { actio::laws::laws_in_five_dimensions<actio::dec100>(); }
