// The laws of the larger groups over the rationals and in many digits.
//
// In a unit of its own, which is as large as a unit may be.
#include "actio/linear_algebra/schur_form_in_digits.hpp"
#include "laws_of_more_groups.hpp"

using namespace actio;

BOOST_AUTO_TEST_CASE(laws_of_larger_matrices_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_of_larger_matrices<Number>);
}
BOOST_AUTO_TEST_CASE(laws_in_five_dimensions_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_in_five_dimensions<Number>);
}
BOOST_AUTO_TEST_CASE(laws_of_families_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_of_families<Number>);
}
BOOST_AUTO_TEST_CASE(laws_of_products_and_spans_hold_in_each_arithmetic) {
  laws::in_each_arithmetic(laws::laws_of_products_and_spans<Number>);
}
