// What values look like on the terminal.
#include <boost/test/unit_test.hpp>

#include "actio/groups/group.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/numbers/print.hpp"

using namespace actio;
using detail::printed;

BOOST_AUTO_TEST_SUITE(printed_values)

BOOST_AUTO_TEST_CASE(numbers_have_six_significant_digits_and_zero_no_sign) {
  BOOST_TEST(printed(1.0 / 3) == "0.333333");
  BOOST_TEST(printed(-1.25e-17) == "-1.25e-17");
  BOOST_TEST(printed(-0.0) == "0");
  BOOST_TEST(printed(7) == "7");
  BOOST_TEST(printed(true) == "yes");
  BOOST_TEST(printed(false) == "no");
  BOOST_TEST(printed("as it is") == "as it is");
}

BOOST_AUTO_TEST_CASE(vectors_take_a_line_and_matrices_one_for_each_row) {
  Matrix<double, 2, 3> m;
  m << 1, 2, 3, 4, 5, 6;
  BOOST_TEST(printed(m) == "\n  1  2  3\n  4  5  6");
  Matrix<double, 1, 3> const row = m.row(1);
  BOOST_TEST(printed(row) == "4  5  6");
  Matrix<double, 3, 1> const column(0.5, -2, 1e10);
  BOOST_TEST(printed(column) == "0.5  -2  1e+10");
}

BOOST_AUTO_TEST_CASE(elements_velocities_and_momenta_are_their_coordinates) {
  Matrix<double, 3, 1> const v(1, 2, 3);
  BOOST_TEST(printed(velocity(SO<3>{}, v)) == "1  2  3");
  BOOST_TEST(printed(momentum(SO<3>{}, v)) == "1  2  3");
  BOOST_TEST(printed(identity<double>(SO<3>{})) == "\n  1  0  0\n  0  1  0\n  0  0  1");
}

BOOST_AUTO_TEST_SUITE_END()
