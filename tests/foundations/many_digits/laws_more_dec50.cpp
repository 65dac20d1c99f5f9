#include "../laws_of_more_groups.hpp"

BOOST_AUTO_TEST_CASE(laws_of_families_hold_over_dec50) { actio::laws::laws_of_families<actio::dec50>(); }
BOOST_AUTO_TEST_CASE(laws_of_products_and_spans_hold_over_dec50) { actio::laws::laws_of_products_and_spans<actio::dec50>(); }
