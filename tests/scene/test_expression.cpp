// Formulas of scenes, against the same in C++.
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <boost/test/unit_test.hpp>

#include "../formula/functions_of_cpp.hpp"
#include "program/document/expression.hpp"

using namespace actio::scene;

namespace {

constexpr unsigned seed = 1971;
constexpr double eps = std::numeric_limits<double>::epsilon();

/// A formula that stands alone in a file, in quotes that begin at 3:9.
Expression formula(std::string const& text, std::vector<std::string> const& variables = {"X", "Y", "Z"}) {
  return {text, variables, {{"f", 3, 9}, true}};
}
double value(std::string const& text, std::vector<double> const& point = {0, 0, 0}) {
  return formula(text)(point);
}
template <class Use>
std::string said_by(Use const& use) {
  try {
    use();
  } catch (SceneError const& error) {
    return error.what();
  }
  return "taken";
}
std::string complaint(std::string const& text) {
  return said_by([&] { formula(text); });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(expressions)

BOOST_AUTO_TEST_CASE(functions_are_those_of_cpp) {
  std::vector<actio::testing::NamedFunction> functions{
      {"abs", [](double x) { return std::abs(x); }, -9, 9},
      {"floor", [](double x) { return std::floor(x); }, -9, 9},
      {"ceil", [](double x) { return std::ceil(x); }, -9, 9},
      {"round", [](double x) { return std::round(x); }, -9, 9},
      {"sign", [](double x) { return double((x > 0) - (x < 0)); }, -9, 9},
  };
  for (auto& smooth : actio::testing::functions_of_cpp()) functions.push_back(std::move(smooth));
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  for (auto const& [name, function, least, most] : functions) {
    Expression f = formula(name + "(X)");
    std::uniform_real_distribution<double> uniform(least, most);
    for (int k = 0; k < 100; ++k) {
      double const x = uniform(random);
      // The same function of the same library, so the same number.
      BOOST_REQUIRE_EQUAL(f(std::vector<double>{x, 0, 0}), function(x));
    }
  }
  BOOST_TEST(value("atan2(Y, X)", {-1, 2, 0}) == std::atan2(2, -1));
  BOOST_TEST(value("hypot(X, Y)", {3, 4, 0}) == 5);
  BOOST_TEST(value("min(X, Y, Z) - max(X, Y, Z)", {3, 4, 5}) == -2);
  BOOST_TEST(value("pi") == std::numbers::pi);
}

BOOST_AUTO_TEST_CASE(operators_bind_as_in_mathematics) {
  BOOST_TEST(value("-2^2") == -4);
  BOOST_TEST(value("2^3^2") == 512);
  BOOST_TEST(value("2^-1") == 0.5);
  BOOST_TEST(value("-X^2", {3, 0, 0}) == -9);
  BOOST_TEST(value("-X^3", {3, 0, 0}) == -27);
  BOOST_TEST(value("(-X)^2", {3, 0, 0}) == 9);
  BOOST_TEST(value("1 - 2 - 3") == -4);
  BOOST_TEST(value("12/3/2") == 2);
  BOOST_TEST(value("2*-3") == -6);
  BOOST_TEST(value("1 + 2*3^2") == 19);
  BOOST_TEST(value("+X", {3, 0, 0}) == 3);
  BOOST_TEST(value("-(-X)", {3, 0, 0}) == 3);
  BOOST_TEST(value("X < 1 ? 10 : 20", {0.5, 0, 0}) == 10);
  BOOST_TEST(value("X < 1 ? 10 : X < 2 ? 20 : 30", {2.5, 0, 0}) == 30);
  BOOST_TEST(value("(X >= 1) + (X == 1) + (X != 1) + (X <= 1)", {1, 0, 0}) == 3);
  BOOST_TEST(value("X > 0 && Y > 0 || Z > 0", {1, -1, 1}) == 1);
  BOOST_TEST(value("1.5e3 + 1e-3 + 0.5") == 1500.501);
}

BOOST_AUTO_TEST_CASE(random_formulas_have_the_value_that_cpp_gives_them) {
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  std::vector<double> const point{0.3, -1.7, 2.4};
  struct Told {
    std::string text;
    double value, size;  // the size of what cancels in it
  };
  // In brackets throughout, so that the value does not hang on the order of operations.
  std::function<Told(int)> const any = [&](int depth) -> Told {
    auto const kind = depth == 0 ? random() % 2 : 2 + random() % 6;
    if (kind == 0) return {std::string(1, "XYZ"[random() % 3]), 0, 0};
    if (kind == 1) {
      double const x = static_cast<double>(random() % 1000) / 8;
      return {std::to_string(x), x, x};
    }
    auto const fill = [&](Told t) {
      if (t.text.size() == 1)
        t.value = point[static_cast<std::size_t>(t.text[0] - 'X')], t.size = std::abs(t.value);
      return t;
    };
    Told const a = fill(any(depth - 1)), b = fill(any(depth - 1));
    switch (kind) {
      case 2:
        return {"(" + a.text + " + " + b.text + ")", a.value + b.value, a.size + b.size};
      case 3:
        return {"(" + a.text + "-" + b.text + ")", a.value - b.value, a.size + b.size};
      case 4:
        return {"(" + a.text + "*" + b.text + ")", a.value * b.value, a.size * b.size};
      case 5:
        return {"sin(" + a.text + ")", std::sin(a.value), 1 + a.size};
      case 6:
        return {"(" + a.text + "/(1 + " + b.text + "^2))", a.value / (1 + b.value * b.value),
                a.size * (1 + b.size)};
      default:
        return {"abs(-" + a.text + ")", std::abs(-a.value), a.size};
    }
  };
  for (int k = 0; k < 500; ++k) {
    Told const told = any(1 + static_cast<int>(random() % 4));
    if (told.text.size() > 1000) continue;
    // A rounding for each of at most 2^5 operations, in units of what cancels.
    BOOST_REQUIRE_SMALL(formula(told.text)(point) - told.value, 32 * eps * (1 + told.size));
  }
}

BOOST_AUTO_TEST_CASE(a_complaint_points_into_the_text) {
  // The quote is at column 9, so the first character at 10.
  BOOST_TEST(complaint("X + sn(Y)")
                 .starts_with("f:3:14: unknown name 'sn'; did you mean 'sin'? (known: X, Y, Z, pi, sin, "));
  BOOST_TEST(complaint("W").starts_with("f:3:10: unknown name 'W'"));
  BOOST_TEST(complaint("X + 2Y") == "f:3:15: an operator is expected after 2");
  BOOST_TEST(complaint("0x1F").starts_with("f:3:11: "));
  BOOST_TEST(complaint("1.5.2").starts_with("f:3:13: "));
  BOOST_TEST(complaint("1e") == "f:3:11: an operator is expected after 1");
  BOOST_TEST(complaint("X + 1e999") == "f:3:14: the number 1e999 is too large or too small");
  BOOST_TEST(complaint("(X + (Y)") == "f:3:10: this bracket is not closed");
  BOOST_TEST(complaint("X)") == "f:3:11: this bracket was not opened");
  BOOST_TEST(complaint("X = 1") == "f:3:12: nothing is assigned in a formula; 'is equal to' is ==");
  BOOST_TEST(complaint("X += 1").starts_with("f:3:13: nothing is assigned"));
  BOOST_TEST(complaint("X, Y").starts_with("f:3:11: one formula is expected"));
  BOOST_TEST(complaint("\"X\"") == "f:3:10: '\"' is no part of a formula");
  BOOST_TEST(complaint("X \xc3\x97 Y") == "f:3:12: '\xc3\x97' is no part of a formula");
  BOOST_TEST(complaint("X\nY") == "f:3:11: '\\u000a' is no part of a formula");
  BOOST_TEST(complaint(std::string("X\0", 2)) == "f:3:11: '\\u0000' is no part of a formula");
  BOOST_TEST(complaint("") == "f:3:10: a formula is expected, for example \"1\"");
  BOOST_TEST(complaint("  ").starts_with("f:3:10: a formula is expected"));
  for (char const* text :
       {"X +",        "* X",           "()",          "sin",       "sin()",  "sin X",    "sin(X, Y)",
        "atan2(X)",   "min()",         "X Y",         "X ? Y",     "X : Y",  "X ? Y : ", "pi(X)",
        "X(1)",       "1 2",           "X ^",         "&& X",      "X ! Y",  "(X, Y)",   "X < > Y",
        "? :",        "1 ? 2 : 3 : 4", "(1 ? 2) : 3", "X == == Y", "pi = 3", "(,)",      "hypot(X, Y, Z)",
        "X ? (Y : Z)"})
    BOOST_TEST(complaint(text).starts_with("f:3:"), text << ": " << complaint(text));
}

BOOST_AUTO_TEST_CASE(long_and_deep_formulas_are_refused) {
  BOOST_TEST(
      complaint(std::string(1 << 20, 'X')).starts_with("f:3:2010: a formula has at most 2000 characters"));
  BOOST_TEST(complaint(std::string(100, '(') + "X" + std::string(100, ')')) ==
             "f:3:60: at most 50 brackets may be open");
  std::string signs(1999, '-'), powers = "1", questions = "1";
  for (int k = 0; k < 900; ++k) powers += "^1";
  for (int k = 0; k < 400; ++k) questions += "?1:1";
  // Whatever is said of them, it is said.
  for (auto const& text : {signs + "X", powers, questions, std::string(50, '(') + "X" + std::string(50, ')')})
    BOOST_TEST(!complaint(text).empty());
}

BOOST_AUTO_TEST_CASE(no_value_is_a_nan_or_infinite) {
  Expression root = formula("sqrt(X - 1)/Y");
  BOOST_TEST(root(std::vector<double>{5, 2, 0}) == 1);
  BOOST_TEST(said_by([&] {
               root(std::vector<double>{0.5, 2, 0});
             }).starts_with("f:3:10: a finite value is expected, found "));
  BOOST_TEST(said_by([&] {
               root(std::vector<double>{5, 0, 0});
             }) == "f:3:10: a finite value is expected, found inf at X = 5, Y = 0, Z = 0");
  BOOST_TEST(root(std::vector<double>{5, 2, 0}) == 1);
  Expression constant("1/0", {}, {{"f", 1, 1}, true});
  BOOST_TEST(said_by([&] { constant({}); }) == "f:1:2: a finite value is expected, found inf");
}

BOOST_AUTO_TEST_CASE(a_copy_has_variables_of_its_own) {
  Expression a = formula("X + 10*Y");
  Expression b = a;
  BOOST_TEST(a(std::vector<double>{1, 2, 0}) == 21);
  BOOST_TEST(b(std::vector<double>{3, 4, 0}) == 43);
  b = formula("Z");
  Expression c = std::move(a);
  BOOST_TEST(b(std::vector<double>{3, 4, 5}) == 5);
  BOOST_TEST(c(std::vector<double>{3, 4, 5}) == 43);
  BOOST_TEST(c.uses("X"));
  BOOST_TEST(!c.uses("Z"));
}

BOOST_AUTO_TEST_CASE(places_are_those_of_the_file) {
  std::string const text = "[a]\nx = [\"1\", 'sn(X)']\ny = \"\\u0058 + sn(X)\"\nz = \"\"\"sn(X)\"\"\"\n";
  auto const table = SceneFile::parse(text, "f", {"a.w=\"sn(X)\"", "a.u=sn"}).section("a");
  auto const said = [&](std::string const& t, TextPlace const& place) {
    std::string const whole = said_by([&] { Expression(t, {"X"}, place); });
    return whole.substr(0, whole.find(" name"));
  };
  BOOST_TEST(said(table.texts("x")[1], table.text_place("x", 1)) == "f:2:12: unknown");
  BOOST_TEST(said(table.text("y"), table.text_place("y")) == "f:3:5: at character 5 of the text: unknown");
  BOOST_TEST(said(table.text("z"), table.text_place("z")) == "f:4:5: at character 1 of the text: unknown");
  BOOST_TEST(said(table.text("w"), table.text_place("w")) == "--set a.w=\"sn(X)\":1:6: unknown");
  BOOST_TEST(said(table.text("u"), table.text_place("u")) ==
             "--set a.u=sn:1:5: at character 1 of the text: unknown");
}

BOOST_AUTO_TEST_SUITE_END()
