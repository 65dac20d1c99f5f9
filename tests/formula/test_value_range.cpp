// Bounds of what a formula comes to over an interval hold its values there.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/formula/value_range.hpp"

using namespace actio;

namespace {

std::vector<std::string> const formulas{"0.8*exp(-((t - 3)/0.1)^2)",
                                        "tanh((t - 3)/0.01)",
                                        "1/(t + 1)",
                                        "sqrt(t^2 + 1)",
                                        "cos(3*t)*sin(t)^3",
                                        "hypot(t - 4, 1) + atan2(t, 2) + atan2(t - 3, -1) + cbrt(t - 2)",
                                        "log(1 + t) - log2(2 + t) + log10(1 + t)",
                                        "asin(t/10) + acos(t/10) + atan(t) + tan(t/7)",
                                        "sinh(t/3) - cosh(t - 2) + asinh(t) + acosh(1 + t)",
                                        "atanh(t/10) + t^1.5 - 1/(t - 3)^2 + (t - 3)^5",
                                        "t*t - t*t*t + pi"};

}  // namespace

BOOST_AUTO_TEST_SUITE(value_range)

BOOST_AUTO_TEST_CASE(values_and_derivatives_lie_within_their_bounds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(0, 1);
  for (auto const& text : formulas) {
    Tape const tape = with_hessian(parse_formula(text, {"t"}, {}), {0});
    std::vector<ValueRange> range_work;
    std::vector<double> work;
    for (int k = 0; k < 200; ++k) {
      double const from = 6 * u(random), to = from + std::pow(10, -4 * u(random)) * (6 - from);
      ValueRange const x(from, to);
      ValueRange bounds[3];
      tape(&x, bounds, range_work);
      for (int j = 0; j < 20; ++j) {
        double const t = from + u(random) * (to - from);
        double y[3];
        tape(&t, y, work);
        for (int i = 0; i < 3; ++i) {
          double const rounding = 1e-12 * (1 + std::abs(y[i]));
          BOOST_TEST(!(y[i] < bounds[i].lower() - rounding || y[i] > bounds[i].upper() + rounding),
                     text << " at " << t << ", derivative " << i << ": " << y[i] << " in ["
                          << bounds[i].lower() << ", " << bounds[i].upper() << "]");
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(bounds_over_a_point_are_the_value) {
  std::vector<ValueRange> range_work;
  std::vector<double> work;
  for (auto const& text : formulas) {
    Tape const tape = parse_formula(text, {"t"}, {});
    double const t = 1.7;
    ValueRange const x(t);
    ValueRange bounds;
    double y;
    tape(&x, &bounds, range_work), tape(&t, &y, work);
    // Of the angle of a point to the left of the origin nothing is known but that it is one.
    if (text.find("atan2") == std::string::npos)
      BOOST_TEST(bounds.largest() == std::abs(y), boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()
