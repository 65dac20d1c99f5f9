// Formulas of which only values are taken: comparisons, cases, functions with kinks and jumps, all to the bit
// as in C++; and that none of them is differentiated.
#include <cmath>
#include <functional>
#include <random>

#include <boost/test/unit_test.hpp>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/formula/value_range.hpp"
#include "functions_of_cpp.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

std::vector<std::string> const names{"X", "Y", "Z"};

double value(std::string const& text, std::vector<double> const& point = {0, 0, 0},
             FormulaUse use = for_values) {
  std::vector<double> work;
  double y;
  parse_formula(text, names, {}, use)(point.data(), &y, work);
  return y;
}
/// A formula in X alone over any scalar.
template <class S>
S evaluate(std::string const& text, S const& x) {
  std::vector<S> work;
  S y;
  parse_formula(text, {"X"}, {}, for_values)(&x, &y, work);
  return y;
}
/// What is wrong with a text, behind its place.
std::string complaint(std::string const& text, FormulaUse use = for_values) {
  try {
    parse_formula(text, names, {}, use);
  } catch (FormulaError const& error) {
    return std::to_string(error.position) + ": " + error.what();
  }
  return "taken";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(values_with_kinks)

BOOST_AUTO_TEST_CASE(functions_are_those_of_cpp) {
  std::vector<actio::testing::NamedFunction> functions{
      {"abs", [](double x) { return std::abs(x); }, -9, 9},
      {"floor", [](double x) { return std::floor(x); }, -9, 9},
      {"ceil", [](double x) { return std::ceil(x); }, -9, 9},
      {"round", [](double x) { return std::round(x); }, -9, 9},
      {"sign", [](double x) { return double((x > 0) - (x < 0)); }, -9, 9},
  };
  for (auto& smooth : actio::testing::functions_of_cpp()) functions.push_back(std::move(smooth));
  std::mt19937 random(1971);
  for (auto const& [name, function, least, most] : functions) {
    std::uniform_real_distribution<double> uniform(least, most);
    for (int k = 0; k < 100; ++k) {
      double const x = uniform(random);
      // The same function of the same library, so the same number.
      BOOST_REQUIRE_EQUAL(value(name + "(X)", {x, 0, 0}), function(x));
    }
  }
  BOOST_TEST(value("min(X, Y, Z) - max(X, Y, Z)", {3, 4, 5}) == -2);
  BOOST_TEST(value("min(X) + max(Y, 7)", {3, 4, 5}) == 10);
  BOOST_TEST(value("sign(X)") == 0);
  BOOST_TEST(value("round(X) + round(Y)", {2.5, -0.5, 0}) == 2);
}

BOOST_AUTO_TEST_CASE(operators_bind_alike_whatever_a_formula_is_for) {
  std::vector<double> const point{3, 0.5, -2};
  for (auto const& [text, expected] :
       std::vector<std::pair<std::string, double>>{{"-2^2", -4},
                                                   {"2^3^2", 512},
                                                   {"2^-1", 0.5},
                                                   {"2^-2^2", 1. / 16},
                                                   {"-X^2", -9},
                                                   {"-X^3", -27},
                                                   {"(-X)^2", 9},
                                                   {"1 - 2 - 3", -4},
                                                   {"12/3/2", 2},
                                                   {"2*-3 + --4", -2},
                                                   {"1 + 2*3^2", 19},
                                                   {"+X", 3},
                                                   {"-(-X)", 3},
                                                   {"a = X; b = a*Y; b - a", -1.5},
                                                   {"(2 + 3)*4 - 6/(1 + 1)", 17},
                                                   {"\t1\n+\r 1", 2},
                                                   {"1.5e3 + 1e-3 + 0.5", 1500.501}}) {
    BOOST_TEST(value(text, point) == expected, text);
    BOOST_TEST(value(text, point, {}) == expected, text);
  }
}

BOOST_AUTO_TEST_CASE(comparisons_bind_after_sums_and_before_and_or_and_cases) {
  for (auto const& [text, expected] : std::vector<std::pair<std::string, double>>{
           {"X < 4 ? 10 : 20", 10},
           {"X < 1 ? 10 : X < 2 ? 20 : 30", 30},
           {"X > 1 ? X > 2 ? 1 : 2 : 3", 1},
           {"(X >= 3) + (X == 3) + (X != 3) + (X <= 3) + (X < 3) + (X > 3)", 3},
           {"1 + 1 == 2", 1},
           {"X > 4 && Z || Y > 0", 1},  // and binds before or
           {"Y > 0 || X > 4 && X > 9", 1},
           {"(X > 2) == (Y < 1)", 1},
           {"Y && Z", 1},  // any number but 0 holds
           {"!X", 0},
           {"!(X > 9) + !0", 2},
           {"!!Y", 1},
           {"-!0^2", -1},
           {"X != 3 || !(Y == 0.5)", 0},
           {"2*(X > 2 ? Y : Z)", 1},
           {"m = max(X, Y); m > Z ? m : Z", 3},
       })
    BOOST_TEST(value(text, {3, 0.5, -2}) == expected, text);
}

BOOST_AUTO_TEST_CASE(a_case_that_does_not_hold_leaves_no_trace) {
  BOOST_TEST(value("X > 0 ? sqrt(X) : 5", {-1, 0, 0}) == 5);
  BOOST_TEST(value("X > 0 ? 5 : 1/X", {1, 0, 0}) == 5);
  BOOST_TEST(value("X ? 1/Y : 1/X", {0.5, 0.25, 0}) == 4);
  BOOST_TEST(std::signbit(value("X > 0 ? Y : 1", {1, -0.0, 0})));
  BOOST_TEST(!std::signbit(value("X > 0 ? 1 : Y", {0, 0.0, 0})));
  // A NaN is not equal to anything, and smaller than nothing.
  BOOST_TEST(value("(sqrt(X) == sqrt(X)) + (sqrt(X) < 0) + (sqrt(X) >= 0)", {-1, 0, 0}) == 0);
  std::string steps;
  for (int k = 0; k < 150; ++k) steps += "X<" + std::to_string(k) + "?" + std::to_string(k % 7) + ":";
  for (double const x : {-0.5, 3.5, 10.5, 148.5, 200.0})
    BOOST_TEST(value(steps + "9", {x, 0, 0}) == (x > 149 ? 9 : static_cast<int>(std::floor(x) + 1) % 7));
}

BOOST_AUTO_TEST_CASE(random_formulas_have_the_bits_that_cpp_gives_them) {
  std::mt19937 random(1971);
  std::vector<double> const point{0.3, -1.7, 2.4};
  struct Told {
    std::string text;
    double value;
  };
  // In brackets throughout, so that the value does not hang on the order of operations.
  std::function<Told(int)> const any = [&](int depth) -> Told {
    auto const kind = depth == 0 ? random() % 2 : 2 + random() % 9;
    if (kind == 0) {
      auto const i = random() % 3;
      return {names[i], point[i]};
    }
    if (kind == 1) {
      double const x = static_cast<double>(random() % 1000) / 8;
      return {std::to_string(x), x};
    }
    Told const a = any(depth - 1), b = any(depth - 1);
    switch (kind) {
      case 2:
        return {"(" + a.text + " + " + b.text + ")", a.value + b.value};
      case 3:
        return {"(" + a.text + "-" + b.text + ")", a.value - b.value};
      case 4:
        return {"(" + a.text + "*" + b.text + ")", a.value * b.value};
      case 5:
        return {"sin(" + a.text + ")", std::sin(a.value)};
      case 6:
        return {"(" + a.text + "/(1 + " + b.text + "^2))", a.value / (1 + b.value * b.value)};
      case 7:
        return {"max(" + a.text + ", " + b.text + ", 1)", std::max({a.value, b.value, 1.0})};
      case 8:
        return {"(" + a.text + " <= " + b.text + ")", double(a.value <= b.value)};
      case 9:
        return {"(" + a.text + " > 0 ? " + b.text + " : " + a.text + "/3)",
                a.value > 0 ? b.value : a.value / 3};
      default:
        return {"abs(-" + a.text + ")", std::abs(-a.value)};
    }
  };
  for (int k = 0; k < 500; ++k) {
    Told const told = any(1 + static_cast<int>(random() % 4));
    if (told.text.size() <= 1000) BOOST_REQUIRE_EQUAL(value(told.text, point), told.value);
  }
}

BOOST_AUTO_TEST_CASE(several_tapes_are_joined_and_stay_what_they_are) {
  std::vector<std::string> const texts{"X/3 + sin(Y)", "0.1234567890123456789012*sin(Y) - X/3",
                                       "Y > 0 ? 1 : Z"};
  std::vector<Tape> tapes;
  for (auto const& text : texts) tapes.push_back(parse_formula(text, names, {}, for_values));
  Tape const all = joined(tapes);
  BOOST_TEST(all.instructions.size() <
             tapes[0].instructions.size() + tapes[1].instructions.size() + tapes[2].instructions.size());
  std::vector<double> const point{0.7, 0.9, -4};
  std::vector<double> work, y(3);
  all(point.data(), y.data(), work);
  for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(y[k] == value(texts[k], point), texts[k]);
}

BOOST_AUTO_TEST_CASE(a_formula_that_is_differentiated_is_smooth) {
  for (char const* const name : {"abs", "sign", "floor", "ceil", "round", "min", "max"}) {
    std::string const call = std::string(name) + "(Y)";
    BOOST_TEST(complaint(call) == "taken");
    BOOST_TEST(complaint("X + " + call, {}).starts_with("4: '" + std::string(name) + "' has kinks or jumps"));
  }
  for (char const* const sign : {"<", "<=", ">", ">=", "==", "!=", "&&", "||"}) {
    std::string const text = std::string("X ") + sign + " Y";
    BOOST_TEST(complaint(text) == "taken");
    BOOST_TEST(
        complaint(text, {}).starts_with("2: found '" + std::string(sign) + "', but this formula is smooth"));
  }
  BOOST_TEST(complaint("X ? 1 : 2", {}).starts_with("2: found '?', but this formula is smooth"));
  BOOST_TEST(complaint("!X", {}).starts_with("0: found '!', but this formula is smooth"));
  // Names that cannot be meant are not proposed.
  BOOST_TEST(complaint("mix(X)", {}).find("max") == std::string::npos);
  BOOST_TEST(complaint("mix(X)").starts_with("0: unknown function 'mix'; did you mean 'min'?"));
}

BOOST_AUTO_TEST_CASE(comparisons_do_not_follow_one_another) {
  BOOST_TEST(complaint("0 < X < 1").starts_with("6: a second comparison in a row; a range is written"));
  BOOST_TEST(complaint("Y ? 1 : X > 2 == Z").starts_with("14: a second comparison in a row"));
  BOOST_TEST(complaint("(0 < X) < 1") == "taken");
  BOOST_TEST(complaint("0 < X && X < 1") == "taken");
}

BOOST_AUTO_TEST_CASE(no_derivative_is_taken_of_a_kink) {
  auto const tape = [](std::string const& text) { return parse_formula(text, names, {}, for_values); };
  CHECK_REFUSED(with_gradient(tape("abs(X)"), {0}), Error);
  CHECK_REFUSED(with_gradient(tape("X < Y ? X : Z"), {2}), Error);
  CHECK_REFUSED(with_hessian(tape("max(X, Y)*Z"), {1}), Error);
  // By what is smooth in it a formula has derivatives.
  std::vector<double> const point{-2, 5, 7};
  std::vector<double> work, y(2);
  with_gradient(tape("abs(X)*Y^2 + (X < 0 ? 3 : 4)"), {1})(point.data(), y.data(), work);
  BOOST_TEST((y[0] == 53 && y[1] == 20));
  // Beside a kink dual numbers have the derivative that is there, and on it that of one side.
  auto const rate_at = [](std::string const& text, double x) {
    Dual<double> moved(x);
    moved.part[0] = 1;
    return evaluate(text, moved).part[0];
  };
  BOOST_TEST(rate_at("abs(X)", -0.5) == -1);
  BOOST_TEST(rate_at("X*abs(X)", -0.5) == 1);
  BOOST_TEST(rate_at("max(X, X^2)", 0.5) == 1);
  BOOST_TEST(rate_at("min(X, X^2)", 0.5) == 1);
  BOOST_TEST(rate_at("X < 1 ? 3*X : X", 0.5) == 3);
  BOOST_TEST(rate_at("floor(X) + sign(X)", 0.5) == 0);
  BOOST_TEST(std::abs(rate_at("abs(X)", 0)) == 1);
  // Numbers of no other kind have values.
  CHECK_REFUSED(evaluate("floor(X)", ValueRange(-1, 1)), Error);
  WithArithmetic const digits(Arithmetic::decimal(50));
  CHECK_REFUSED(evaluate("min(X, 2)", Number(3)), Error);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_together_is_refused_at_its_place) {
  for (auto const& [text, expected] : std::vector<std::pair<std::string, std::string>>{
           {"X + sn(Y)", "4: unknown function 'sn'; did you mean 'sin'? (known: atan2, hypot, "},
           {"W", "0: unknown name 'W' (known: X, Y, Z, pi)"},
           {"X + 2Y", "5: found 'Y' behind the number 2"},
           {"0x1F", "1: found 'x' behind the number 0"},
           {"1.5.2", "3: found '.' behind the number 1.5"},
           {"1e", "1: found 'e' behind the number 1"},
           {"X + 1e999", "4: the number 1e999 is too large or too small"},
           {"(X + (Y)", "0: this bracket is not closed"},
           {"X)", "1: found ')', expected an operator"},
           {"X = 1", "0: the name 'X' stands for a number already"},
           {"(X = 1) + 2", "3: found '=', expected an operator or ')'; 'is equal to' is =="},
           {"X += 1", "3: found '=', expected a number, a name or '('; 'is equal to' is =="},
           {"X, Y", "1: found ',', expected an operator"},
           {"X & Y", "2: found '&', expected '&&' for and, '||' for or"},
           {"X ? Y", "5: found the end, expected an operator, or ':' and what holds otherwise"},
           {"X ? Y : ", "8: found the end, expected a number"},
           {"X : Y", "2: found ':', expected an operator"},
           {"1 ? 2 : 3 : 4", "10: found ':', expected an operator"},
           {"(1 ? 2) : 3", "6: found ')', expected an operator, or ':' and"},
           {"X ? (Y : Z)", "7: found ':', expected an operator or ')'"},
           {"X == == Y", "5: found '==', expected a number"},
           {"X < > Y", "4: found '>', expected a number"},
           {"X ! Y", "2: found '!', expected an operator"},
           {"min()", "4: found ')', expected a number"},
           {"sin(X, Y)", "5: found ',', expected ')', for sin is a function of one number"},
           {"X > 0 ? 1/0 : 1", "9: the divisor is zero"},
           {"X > 0 ? asin(2) : 1", "8: this constant does not exist"},
       })
    BOOST_TEST(complaint(text).starts_with(expected), text << ": " << complaint(text));
  for (char const* text : {"",       "  ",           "X +",    "* X",      "()",
                           "sin",    "sin()",        "sin X",  "atan2(X)", "X Y",
                           "pi(X)",  "X(1)",         "1 2",    "X ^",      "&& X",
                           "(X, Y)", "? :",          "pi = 3", "(,)",      "hypot(X, Y, Z)",
                           "\"X\"",  "X \xc3\x97 Y", "X =! Y"})
    BOOST_TEST(complaint(text) != "taken", text);
}

BOOST_AUTO_TEST_CASE(long_and_deep_formulas_are_refused) {
  BOOST_TEST(complaint(std::string(1 << 20, 'X')).starts_with("2000: a formula has at most 2000 characters"));
  BOOST_TEST(complaint(std::string(100, '(') + "X" + std::string(100, ')')) ==
             "50: at most 50 brackets, powers and cases may be open");
  BOOST_TEST(complaint(std::string(50, '(') + "X" + std::string(50, ')')) == "taken");
  std::string powers = "1", questions, signs;
  for (int k = 0; k < 900; ++k) powers += "^1";
  for (int k = 0; k < 400; ++k) questions += "1?", signs += "!-";
  BOOST_TEST(complaint(powers).starts_with("101: at most 50 brackets"));
  BOOST_TEST(complaint(questions).starts_with("101: at most 50 brackets"));
  BOOST_TEST(value(signs + "X", {2, 0, 0}) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
