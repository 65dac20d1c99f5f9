// Ratios next to the end of 64 bits, decimal numbers of any length, and the names that a formula knows.
#include <cmath>
#include <limits>
#include <string>

#include <boost/test/unit_test.hpp>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "caught.hpp"

using namespace actio;
using testing::caught;

namespace {

using Q = rational;
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max(), least = -largest - 1;

Q exactly(ExactRatio const& x) { return Q(x.above) / Q(x.below); }
Q value(Tape const& tape) {
  std::vector<Q> work(tape.places());
  Q y;
  tape(static_cast<Q const*>(nullptr), &y, work);
  return y;
}
/// Lowest terms with a denominator that is positive.
bool in_lowest_terms(ExactRatio const& x) {
  return x.below > 0 && x.above != least && std::gcd(x.above, x.below) == 1;
}
/// Whether a rational number is one of those.
bool fits(Q const& x) { return abs(numerator(x)) <= largest && denominator(x) <= largest; }
std::string message(std::string const& text, std::vector<std::string> const& names) {
  try {
    parse_formula(text, names);
  } catch (FormulaError const& error) {
    return std::to_string(error.position) + ": " + error.what();
  }
  return "it is taken";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(constants_and_names)

BOOST_AUTO_TEST_CASE(ratios_are_exact_or_do_not_fit) {
  std::vector<ExactRatio> some;
  for (std::int64_t p : {std::int64_t(0), std::int64_t(1), std::int64_t(-6), std::int64_t(35),
                         std::int64_t(3037000500), std::int64_t(-4294967296), largest, -largest, largest - 1})
    for (std::int64_t q : {std::int64_t(1), std::int64_t(4), std::int64_t(-15), std::int64_t(3037000499),
                           largest, largest - 1})
      some.push_back(exact_ratio(p, q).value());
  for (ExactRatio const& x : some) {
    BOOST_TEST(in_lowest_terms(x));
    BOOST_TEST((exactly(-x) == -exactly(x)));
    BOOST_TEST(to_double(x) == to_double(exactly(x)), boost::test_tools::tolerance(2e-16));
    BOOST_TEST(x.whole() == (denominator(exactly(x)) == 1));
    BOOST_TEST((x.is(-6) == (exactly(x) == -6)));
    BOOST_TEST(reciprocal(x).has_value() == (x.above != 0));
    if (auto const r = reciprocal(x)) BOOST_TEST((in_lowest_terms(*r) && exactly(*r) * exactly(x) == 1));
    for (ExactRatio const& y : some) {
      Q const xy = exactly(x) * exactly(y), x_plus_y = exactly(x) + exactly(y);
      auto const p = product(x, y), s = sum(x, y);
      BOOST_TEST(p.has_value() == fits(xy));
      if (p) BOOST_TEST((in_lowest_terms(*p) && exactly(*p) == xy));
      if (s) BOOST_TEST((in_lowest_terms(*s) && exactly(*s) == x_plus_y));
      // On the way stand the numerators over the smallest common denominator.
      Q const common = denominator(exactly(x)) / Q(std::gcd(x.below, y.below)) * Q(y.below);
      if (common <= largest && abs(exactly(x)) * common <= largest && abs(exactly(y)) * common <= largest &&
          abs(x_plus_y) * common <= largest)
        BOOST_TEST(s.has_value());
    }
  }
  BOOST_TEST((exact_ratio(12, -18) == ExactRatio{-2, 3} && exact_ratio(-12, -18) == ExactRatio{2, 3}));
  BOOST_TEST((!exact_ratio(1, 0) && !exact_ratio(least, 3) && !exact_ratio(3, least)));
}

BOOST_AUTO_TEST_CASE(roots_of_squares_are_ratios_and_others_are_not) {
  for (std::int64_t n : {std::int64_t(0), std::int64_t(1), std::int64_t(7), std::int64_t(3037000498),
                         std::int64_t(3037000499)}) {
    BOOST_TEST((exact_root({n * n, 1}) == ExactRatio{n, 1}));
    if (n > 1) BOOST_TEST((exact_root({4, n * n}) == ExactRatio{2, n}));
    if (n > 1)
      BOOST_TEST((!exact_root({n * n - 1, 1}) && !exact_root({n * n + 1, 1}) && !exact_root({1, n * n - 1})));
  }
  BOOST_TEST(
      (!exact_root({-4, 1}) && !exact_root({largest, 1}) && !exact_root({8, 9}) && !exact_root({9, 8})));
}

BOOST_AUTO_TEST_CASE(decimal_numbers_of_any_length_are_exact) {
  for (auto const& [text, digits, power] : std::vector<std::tuple<std::string, std::string, int>>{
           {"7", "7", 0},
           {"007.50", "75", -1},
           {"1200", "12", 2},
           {"123456789012345678", "123456789012345678", 0},
           {"1234567890123456789", "1234567890123456789", 0},
           {"98765432109876543210987654321098765.4321", "987654321098765432109876543210987654321", -4},
           {"100000000000000000000000000000000000001", "100000000000000000000000000000000000001", 0},
           {"0.000000000000000000000000000012345", "12345", -33},
           {"12.5e3", "125", 2},
           {"12.5E+3", "125", 2},
           {"12.5e-3", "125", -4},
           {"12.5e12", "125", 11},
           {"3e25", "3", 25},
           {"3e-25", "3", -25},
           {"0.0", "0", 0},
           {"0e5", "0", 0}}) {
    Q expected(digits);
    for (int k = 0; k < std::abs(power); ++k) expected = power > 0 ? Q(expected * 10) : Q(expected / 10);
    Tape const tape = parse_formula(text, {});
    BOOST_TEST((value(tape) == expected), text);
    BOOST_TEST(tape.constants[tape.outputs[0]] == std::stod(text), text);
  }
}

BOOST_AUTO_TEST_CASE(what_a_constant_is_near_is_kept_where_it_is_recorded_once_more) {
  Tape const f = parse_formula("0.1234567890123456789012*x + -1e-30*y", {"x", "y"});
  Tape const g = with_gradient(f, {0, 1});
  std::vector<double> const x{1, 1};
  std::vector<double> y(3), work;
  g(x.data(), y.data(), work);
  BOOST_TEST((y[1] == 0.1234567890123456789012 && y[2] == -1e-30));
}

BOOST_AUTO_TEST_CASE(a_name_that_is_not_known_is_told_with_those_that_are) {
  BOOST_TEST(
      message("a + Gravity", {"gravity", "a"}).find("4: unknown name 'Gravity'; did you mean 'gravity'?") ==
      0u);
  BOOST_TEST(message("SIN*2", {"x"}).find("0: unknown name 'SIN'; did you mean 'sin'?") == 0u);
  // A letter that differs is no case of another one.
  BOOST_TEST(message("q", {"x"}) == "0: unknown name 'q' (known: x, pi)");
  BOOST_TEST(message("X", {"x"}) == "0: unknown name 'X'; did you mean 'x'? (known: x, pi)");
  BOOST_TEST(message("[", {"{"}).find("it is taken") == std::string::npos);
  std::vector<std::string> many;
  for (char c = 'a'; c < 'a' + 19; ++c) many.push_back("n" + std::string(1, c));
  std::string all;
  for (auto const& name : many) all += (all.empty() ? "" : ", ") + name;
  BOOST_TEST(message("q", many) == "0: unknown name 'q' (known: " + all + ", pi)");
  many.push_back("nt");
  BOOST_TEST(message("q", many) == "0: unknown name 'q' (known: " + all + ", nt, and 1 more)");
  many.push_back("nu"), many.push_back("nv");
  BOOST_TEST(message("q", many) == "0: unknown name 'q' (known: " + all + ", nt, and 3 more)");
}

BOOST_AUTO_TEST_CASE(words_are_shown_in_one_line_and_short) {
  std::string const word(40, 'w');
  BOOST_TEST(message(word + "(1)", {word})
                 .find("40: found '(', expected an operator behind '" + word + "', which") == 0u);
  BOOST_TEST(message(word + "x(1)", {word + "x"}).find("behind '" + word + "...', which") !=
             std::string::npos);
  using detail::shown, detail::shown_character;
  BOOST_TEST((shown("a b\x7F\x1F\x20~\n") == "a b\\x7F\\x1F ~\\x0A"));
  BOOST_TEST((shown_character("a$", 1) == "'$'" && shown_character("\x7F", 0) == "'\\x7F'"));
  // Characters of two, three and four bytes, their first and last, and what is none.
  for (std::string const whole :
       {"\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    BOOST_TEST(shown_character("x" + whole + "y", 1) == "'" + whole + "'");
    BOOST_TEST(shown_character("x" + whole, 1) == "'" + whole + "'");
    std::string const cut = whole.substr(0, whole.size() - 1),
                      byte = "the byte " + std::to_string(static_cast<unsigned char>(whole[0]));
    BOOST_TEST(shown_character(cut, 0) == byte);
    BOOST_TEST(shown_character(cut + "y", 0) == byte);
    BOOST_TEST(shown_character(cut + "\xC0", 0) == byte);
  }
  BOOST_TEST(
      (shown_character("\xC1\x80", 0) == "the byte 193" && shown_character("\x80\x80", 0) == "the byte 128"));
  BOOST_TEST((shown_character("\xF5\x80\x80\x80", 0) == "the byte 245"));
}

BOOST_AUTO_TEST_CASE(a_formula_that_does_not_fit_is_refused_where_it_has_become_too_large) {
  // The power 63 takes five squares and five products, so that each definition takes eleven instructions; a
  // handful more are its constants.
  std::string text = "a0 = x;";
  std::vector<std::size_t> begins;
  for (int k = 1; k < 9200; ++k) {
    begins.push_back(text.size());
    text += "a" + std::to_string(k) + "=a" + std::to_string(k - 1) + "^63*x;";
  }
  text += "x";
  auto const error = caught<FormulaError>([&] { parse_formula(text, {"x"}); });
  BOOST_TEST(std::string(error.what()).find("at most 100000 instructions") != std::string::npos);
  BOOST_TEST((error.position > begins[100000 / 11 - 3] && error.position < begins[100000 / 11 + 2]));
}

BOOST_AUTO_TEST_SUITE_END()
