// Formulas against the same in C++: over double, exactly over the rationals, and in 50 digits.
#include <cmath>
#include <numbers>
#include <random>

#include <boost/test/unit_test.hpp>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/term.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "functions_of_cpp.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <class S>
S value(Tape const& tape, std::vector<S> const& x) {
  std::vector<S> work;
  S y{};
  tape(x.data(), &y, work);
  return y;
}
template <class S = double>
S value(std::string const& text, std::vector<S> const& x = {},
        std::map<std::string, double> const& constants = {}) {
  std::vector<std::string> names{"x", "y", "z"};
  names.resize(x.size());
  return value(parse_formula(text, names, constants), x);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(formula_values)

BOOST_AUTO_TEST_CASE(functions_are_those_of_cpp) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  std::mt19937_64 random(1971);
  for (auto const& [name, function, least, most] : actio::testing::functions_of_cpp()) {
    Tape const f = parse_formula(name + "(x)", {"x"});
    std::uniform_real_distribution<double> uniform(least, most);
    for (int k = 0; k < 50; ++k) {
      double const x = uniform(random);
      // The same function of the same library, so the same number.
      BOOST_REQUIRE_EQUAL(value(f, std::vector{x}), function(x));
      // In 50 digits it is made of other functions: here it may lose what its definition loses.
      BOOST_TEST(to_double(value(f, std::vector{Number(x)})) == function(x),
                 boost::test_tools::tolerance(8 * eps * (1 + 1 / std::abs(x))));
    }
  }
  BOOST_TEST(value("atan2(y, x)", {-1, 2}) == std::atan2(2, -1));
  BOOST_TEST(value("hypot(x, y)", {3, 4}) == 5);
}

BOOST_AUTO_TEST_CASE(functions_undo_each_other_in_50_digits) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (auto const& [there, back] : std::vector<std::pair<std::string, std::string>>{{"sin", "asin"},
                                                                                    {"cos", "acos"},
                                                                                    {"tan", "atan"},
                                                                                    {"sinh", "asinh"},
                                                                                    {"cosh", "acosh"},
                                                                                    {"tanh", "atanh"},
                                                                                    {"exp", "log"},
                                                                                    {"2^", "log2"},
                                                                                    {"10^", "log10"},
                                                                                    {"x*x*", "cbrt"},
                                                                                    {"x*", "sqrt"}}) {
    Number const x = Number(7) / 10;
    Number const back_again = value<Number>(back + "(" + there + "(x))", {x});
    BOOST_TEST_CONTEXT(back) BOOST_TEST(to_double(abs(back_again - x)) < 1e-48);
  }
  Number const minus = Number(-7) / 10;
  for (auto const* f :
       {"cbrt(x^3)", "asinh(sinh(x))", "atanh(tanh(x))", "atan2(sin(x), cos(x))", "-hypot(0.6*x, 0.8*x)"})
    BOOST_TEST_CONTEXT(f) BOOST_TEST(to_double(abs(value<Number>(f, {minus}) - minus)) < 1e-48);
  BOOST_TEST(to_double(abs(sin(value<Number>("pi")))) < 1e-48);
}

BOOST_AUTO_TEST_CASE(odd_functions_vanish_at_zero_in_50_digits) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (auto const* f : {"sin", "tan", "asin", "atan", "sinh", "tanh", "asinh", "atanh", "cbrt"})
    BOOST_TEST_CONTEXT(f) BOOST_TEST((value<Number>(std::string(f) + "(x)", {Number(0)}) == 0));
}

BOOST_AUTO_TEST_CASE(powers_are_products_roots_or_exponentials) {
  double const x = 1.7, y = -0.3;
  BOOST_TEST(value("x^-3", {-x}) == 1 / std::pow(-x, 3), boost::test_tools::tolerance(4 * eps));
  BOOST_TEST(value("x^64", {x}) == std::pow(x, 64), boost::test_tools::tolerance(16 * eps));
  BOOST_TEST(value("x^0.5", {x}) == std::sqrt(x));
  BOOST_TEST(value("x^-(1/2)", {x}) == 1 / std::sqrt(x));
  BOOST_TEST(value("x^-1.5", {x}) == std::pow(x, -1.5));
  BOOST_TEST(value("x^65", {-x}) == std::pow(-x, 65));
  BOOST_TEST(value("x^pi", {x}) == std::pow(x, std::numbers::pi));
  BOOST_TEST(value("x^y", {x, y}) == std::pow(x, y), boost::test_tools::tolerance(4 * eps));
  BOOST_TEST(value("2^y", {x, y}) == std::exp2(y), boost::test_tools::tolerance(4 * eps));
  BOOST_TEST(value("x^n", {x}, {{"n", 3}}) == x * x * x, boost::test_tools::tolerance(2 * eps));
}

BOOST_AUTO_TEST_CASE(outside_of_its_domain_a_function_is_no_number) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (auto const* f : {"sqrt(x)", "log(x)", "x^1.5", "x^y", "acosh(x)", "asin(x)", "atanh(x)"}) {
    BOOST_TEST_CONTEXT(f) BOOST_TEST(std::isnan(value(f, {-2, 0.5})));
    BOOST_TEST_CONTEXT(f) BOOST_TEST(!is_finite(value<Number>(f, {-2, 0.5})));
  }
  BOOST_TEST(std::isinf(value("1/x", {0})));
}

BOOST_AUTO_TEST_CASE(decimal_numbers_are_exact) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  BOOST_TEST((value<rational>("0.1 + 0.20") == rational(3) / 10));
  BOOST_TEST((value<rational>("2.5e-3") == rational(1) / 400));
  BOOST_TEST((value<rational>("1.5E+2") == 150));
  // What does not fit into 64 bits.
  BOOST_TEST((value<rational>("1e-30 * 1e30") == 1));
  BOOST_TEST((value<rational>("3.14159265358979323846") ==
              rational("314159265358979323846") / rational("100000000000000000000")));
  BOOST_TEST((value<rational>("0.1^40 * 10^40") == 1));
  BOOST_TEST((value<rational>("9007199254740993 * 9007199254740993") ==
              rational("9007199254740993") * rational("9007199254740993")));
  // A constant is the shortest decimal number that reads as it.
  BOOST_TEST((value<rational>("c", {}, {{"c", 0.1}}) == rational(1) / 10));
  BOOST_TEST((value<rational>("c", {}, {{"c", -1.25e-7}}) == rational(-1) / 8000000));
  BOOST_TEST(to_double(abs(value<Number>("0.1*10 - 1"))) == 0);
  // Over double each is the nearest one.
  for (double c : {0.1, 1. / 3, 6.02214076e23, 1.380649e-23, -2.2250738585072014e-308, 5e-324,
                   1.7976931348623157e308, std::numbers::pi})
    BOOST_TEST(value("c", {}, {{"c", c}}) == c);
  BOOST_TEST(value("3.14159265358979323846") == std::numbers::pi);
  BOOST_TEST(value("4.9e-324") == 5e-324);
  BOOST_TEST(value("0." + std::string(300, '0') + "1e301") == 1);
  BOOST_TEST(value(std::string(9000, '7') + "e-9000") == 7. / 9);
}

BOOST_AUTO_TEST_CASE(a_rational_function_is_exact_over_the_rationals) {
  auto const f = [](auto const& x, auto const& y, auto const& z) {
    return (x * x * x - y / 10) / (z * z + 1) + y * y / (x * x) - 13 * (x * y * z) / 4;
  };
  rational const x = rational(2) / 3, y = rational(-5) / 7, z = rational(11) / 13;
  BOOST_TEST((value<rational>("(x^3 - 0.1*y)/(z^2 + 1) + x^-2*y^2 - 3.25*x*y*z", {x, y, z}) == f(x, y, z)));
  // The same recorded by calling it.
  TapeBuilder b(3);
  Term const recorded = f(Term(b, b.input(0)), Term(b, b.input(1)), Term(b, b.input(2)));
  BOOST_TEST((value<rational>(b.tape(std::vector{recorded.entry()}), {x, y, z}) == f(x, y, z)));
  // A root of a square is rational, other roots are not.
  BOOST_TEST((value<rational>("sqrt(x^2) + hypot(3*x, 4*x)", {x}) == 6 * x));
  for (auto const* g : {"sqrt(x)", "sin(x)", "pi*x", "x^0.3", "x^100", "atan2(x, 1)", "x^x"})
    CHECK_REFUSED(value<rational>(g, {x}), NotInThisField);
}

BOOST_AUTO_TEST_CASE(definitions_are_shared) {
  BOOST_TEST(value("a = x + 1; b = a^2; b - a", {2}) == 6);
  Tape const once = parse_formula("exp(sin(x))", {"x"});
  Tape const often = parse_formula("s = sin(x); exp(s) + 0*s + 1*exp(sin(x)) - exp(s)", {"x"});
  BOOST_TEST(often.instructions.size() == once.instructions.size());
  BOOST_TEST(parse_formula("a = exp(x); x", {"x"}).instructions.empty());
}

BOOST_AUTO_TEST_CASE(constants_are_folded_and_zeros_and_ones_are_gone) {
  BOOST_TEST(parse_formula("x*0 + x*1 + 0 - 0*sin(x)", {"x"}).instructions.empty());
  Tape const one = parse_formula("2*(3*x) + x/2 - x", {"x"});
  BOOST_TEST(one.instructions.size() == 1u);
  BOOST_TEST((one.numbers == std::vector{ExactRatio{11, 2}}));
  BOOST_TEST(parse_formula("cos(0) + sqrt(4/9) - 5/3 + log(1)", {}).is_constant(0));
  BOOST_TEST((value<rational>("cos(0) + sqrt(4/9) - 5/3 + log(1)") == 0));
  Tape const f = parse_formula("x^2 + 0*y", {"x", "y"});
  BOOST_TEST((f.depends_on(0) && !f.depends_on(1)));
  Tape const g = parse_formula("x - sin(z)", {"x", "y", "z"});
  BOOST_TEST((g.depends_on(0) && !g.depends_on(1) && g.depends_on(2)));
  BOOST_TEST(parse_formula("x/y", {"x", "y"}).depends_on(1));
  BOOST_TEST(parse_formula("y", {"x", "y"}).depends_on(1));
}

BOOST_AUTO_TEST_CASE(constant_factors_are_not_joined_beyond_the_range_of_double) {
  double const tiny = value("1e-200*x*(1e-200*y)", {1e150, 1e150}),
               large = value("1e200*x*(1e200*y)/1e300", {1e-150, 1e-150});
  BOOST_TEST(tiny == 1e-100, boost::test_tools::tolerance(8 * eps));
  BOOST_TEST(large == 1e-200, boost::test_tools::tolerance(8 * eps));
  BOOST_TEST(value("x/1e-310*1e-10", {1e-20}) == 1e280, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(value("(1e-200*x)/(1e200*y)", {1e300, 1e-50}) == 1e-50, boost::test_tools::tolerance(8 * eps));
  BOOST_TEST((value<rational>("1e-200*x*(1e-200*y)*1e200*1e200", {rational(2), rational(3)}) == 6));
}

BOOST_AUTO_TEST_CASE(nothing_is_allocated_where_the_memory_is_there) {
  Tape const small = parse_formula("x + y", {"x", "y"}), large = parse_formula("sin(x)*y + x/y", {"x", "y"});
  std::vector<double> work(large.places());
  double const* const before = work.data();
  std::vector<double> const x{2, 3};
  double y = 0;
  for (int k = 0; k < 3; ++k) {
    small(x.data(), &y, work);
    BOOST_TEST(y == 5);
    BOOST_TEST(work.data() == before);
    large(x.data(), &y, work);
    BOOST_TEST(y == std::sin(2.) * 3 + 2. / 3);
  }
  BOOST_TEST(work.data() == before);
}

BOOST_AUTO_TEST_SUITE_END()
