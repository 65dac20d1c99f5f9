#include <boost/test/unit_test.hpp>

#include <set>

#include "program/registry/quantity.hpp"

using namespace actio::scene;
using Kind = Quantity::Kind;
using Names = std::vector<std::string>;

BOOST_AUTO_TEST_SUITE(column_names)

BOOST_AUTO_TEST_CASE(matrices_count_from_one_row_by_row) {
  BOOST_TEST(column_ends(Kind::matrix, 2) == (Names{"_11", "_12", "_21", "_22"}),
             boost::test_tools::per_element());
  BOOST_TEST(column_ends(Kind::skew, 4) == (Names{"_12", "_13", "_14", "_23", "_24", "_34"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(indices_stand_apart_where_one_of_them_has_two_digits_and_only_there) {
  auto const skew = column_ends(Kind::skew, 11), matrix = column_ends(Kind::matrix, 11);
  BOOST_TEST(skew.front() == "_12");
  BOOST_TEST(skew[8] == "_1_10");
  BOOST_TEST(skew.back() == "_10_11");
  BOOST_TEST(matrix[0] == "_11");
  BOOST_TEST(matrix[10] == "_1_11");
  BOOST_TEST(matrix[110] == "_11_1");
  // No two have one name, however many rows there are.
  auto const many = column_ends(Kind::matrix, 120);
  BOOST_TEST(std::set<std::string>(many.begin(), many.end()).size() == 120u * 120u);
}

BOOST_AUTO_TEST_SUITE_END()
