// Formulas of a scene at a point: what is wrong with them is told at its place in the file, with the point.
#include <cmath>
#include <thread>

#include <boost/test/unit_test.hpp>

#include "caught.hpp"
#include "program/systems/media/place_formula.hpp"

using namespace actio::scene;
using actio::testing::message_of;

namespace {

/// A formula that stands alone in a file, in quotes that begin at 3:9.
PlaceFormula formula(std::string const& text, int dimension = 3) {
  return {text, dimension, {{"f", 3, 9}, true}};
}
double value(PlaceFormula const& f, std::array<double, 3> const& point) {
  double y;
  f(point, &y);
  return y;
}
std::string complaint(std::string const& text) {
  return message_of([&] { formula(text); });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(place_formulas)

BOOST_AUTO_TEST_CASE(a_complaint_points_into_the_text) {
  // The quote is at column 9, so the first character at 10.
  BOOST_TEST(
      complaint("X + sn(Y)").starts_with("f:3:14: unknown function 'sn'; did you mean 'sin'? (known: "));
  BOOST_TEST(complaint("W") == "f:3:10: unknown name 'W' (known: X, Y, Z, pi)");
  BOOST_TEST(complaint("X + 1e999").starts_with("f:3:14: the number 1e999 is too large or too small"));
  BOOST_TEST(complaint("(X + (Y)") == "f:3:10: this bracket is not closed");
  BOOST_TEST(complaint("\"X\"") == "f:3:10: '\"' is no part of a formula");
  BOOST_TEST(complaint("X \xc3\x97 Y").starts_with("f:3:12: '\xc3\x97' is no part of a formula"));
  BOOST_TEST(complaint("X\nY").starts_with("f:3:12: found 'Y', expected an operator"));
  BOOST_TEST(complaint(std::string("X\0", 2)) == "f:3:11: '\\x00' is no part of a formula");
  BOOST_TEST(complaint("").starts_with("f:3:10: found the end, expected a number"));
  BOOST_TEST(complaint("a = 2; X").starts_with("f:3:10: 'a' is defined, and nothing in the formula uses it"));
  BOOST_TEST(
      complaint(std::string(1 << 20, 'X')).starts_with("f:3:2010: a formula has at most 2000 characters"));
  BOOST_TEST(complaint(std::string(100, '(') + "X" + std::string(100, ')')) ==
             "f:3:60: at most 50 brackets, powers and cases may be open");
}

BOOST_AUTO_TEST_CASE(places_are_those_of_the_file) {
  std::string const text = "[a]\nx = [\"1\", 'sn(X)']\ny = \"\\u0058 + sn(X)\"\nz = \"\"\"sn(X)\"\"\"\n";
  auto const table = SceneFile::parse(text, "f", {"a.w=\"sn(X)\"", "a.u=sn"}).section("a");
  auto const said = [&](std::string const& t, TextPlace const& place) {
    std::string const whole = message_of([&] { PlaceFormula(t, 1, place); });
    return whole.substr(0, whole.find(" unknown"));
  };
  BOOST_TEST(said(table.texts("x")[1], table.text_place("x", 1)) == "f:2:12:");
  BOOST_TEST(said(table.text("y"), table.text_place("y")) == "f:3:5: at character 5 of the text:");
  BOOST_TEST(said(table.text("z"), table.text_place("z")) == "f:4:5: at character 1 of the text:");
  BOOST_TEST(said(table.text("w"), table.text_place("w")) == "--set a.w=\"sn(X)\":1:6:");
  BOOST_TEST(said(table.text("u"), table.text_place("u")) == "--set a.u=sn:1:5: at character 1 of the text:");
}

BOOST_AUTO_TEST_CASE(no_value_is_a_nan_or_infinite) {
  PlaceFormula const root = formula("sqrt(X - 1)/Y");
  BOOST_TEST(value(root, {5, 2, 0}) == 1);
  BOOST_TEST(message_of([&] {
               value(root, {0.5, 2, 0});
             }) == "f:3:10: a finite value is expected, found nan at X = 0.5, Y = 2, Z = 0");
  BOOST_TEST(message_of([&] {
               value(root, {5, 0, 0});
             }) == "f:3:10: a finite value is expected, found inf at X = 5, Y = 0, Z = 0");
  BOOST_TEST(value(root, {5, 2, 0}) == 1);
  BOOST_TEST(complaint("1/0") == "f:3:11: the divisor is zero");
}

BOOST_AUTO_TEST_CASE(a_formula_is_constant_where_no_coordinate_is_written) {
  BOOST_TEST(formula("2*pi").is_constant());
  BOOST_TEST(!formula("1 + 0*Y").is_constant());
  BOOST_TEST(!formula("a = Z; 2 > 1 ? 3 : a").is_constant());
}

BOOST_AUTO_TEST_CASE(several_formulas_are_told_apart) {
  auto const table = SceneFile::parse("[a]\nx = [\"X + Y\", \"1/(X + Y)\"]\ny = [\"X\"]\n", "f").section("a");
  PlaceFormula const both(table, "x", {"X", "Y"});
  std::array<double, 2> y;
  both(std::array{1.0, 3.0}, y.data());
  BOOST_TEST((y[0] == 4 && y[1] == 0.25));
  BOOST_TEST(message_of([&] {
               both(std::array{1.0, -1.0}, y.data());
             }) == "f:2:16: a finite value is expected, found inf at X = 1, Y = -1");
  BOOST_TEST(message_of([&] {
               PlaceFormula(table, "y", {"X", "Y"});
             }) == "f:3:5: y: 2 formulas in X, Y are expected, one for each dimension, found 1");
}

BOOST_AUTO_TEST_CASE(threads_share_a_formula) {
  PlaceFormula const f = formula("sin(X)*Y + (Z > 0 ? X/3 : Y/7)");
  std::array<double, 4> wrong{};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&, t] {
      for (int k = 0; k < 20000; ++k) {
        double const x = k * 1e-3, y = static_cast<double>(t) - 1.5, z = k % 2;
        wrong[t] += value(f, {x, y, z}) != std::sin(x) * y + (z > 0 ? x / 3 : y / 7);
      }
    });
  for (auto& thread : threads) thread.join();
  for (double const w : wrong) BOOST_TEST(w == 0);
}

BOOST_AUTO_TEST_SUITE_END()
