// Formulas against the same in C++.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "actio/formula/parse_formula.hpp"

using namespace actio;

namespace {

template <class S = double>
S value(Tape const& tape, std::vector<S> const& x) {
  std::vector<S> work;
  S y{};
  tape(x.data(), &y, work);
  return y;
}
double value(std::string const& text, std::vector<double> const& x = {}) {
  std::vector<std::string> const names{"x", "y", "z"};
  return value(parse_formula(text, {names.begin(), names.begin() + static_cast<long>(x.size())}), x);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(formula_values)

BOOST_AUTO_TEST_CASE(a_power_binds_before_a_sign_and_to_the_right) {
  BOOST_TEST(value("-2^2") == -4);
  BOOST_TEST(value("2^3^2") == 512);
  BOOST_TEST(value("2^-1") == 0.5);
  BOOST_TEST(value("1 - 2 - 3") == -4);
  BOOST_TEST(value("8/4/2") == 1);
  BOOST_TEST(value("2*-3 + --4") == -2);
  BOOST_TEST(value("-x^2", {3}) == -9);
}

BOOST_AUTO_TEST_SUITE_END()
