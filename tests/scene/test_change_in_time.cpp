// No short event of a formula in time is stepped over, wherever it is.
#include <boost/test/unit_test.hpp>

#include <fmt/format.h>

#include <random>

#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "program/registry/change_in_time.hpp"

using namespace actio::scene;

namespace {

ChangeInTime change(std::string const& formula, double until, double enough = 0) {
  return change_in_time(actio::with_hessian(actio::parse_formula(formula, {"t"}, {}), {0}), {0}, until,
                        enough, 2000);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(change_in_time_suite)

BOOST_AUTO_TEST_CASE(pulses_of_any_width_are_found_wherever_they_are) {
  std::mt19937 random(std::random_device{}());
  std::uniform_real_distribution<double> u(0, 1);
  for (int k = 0; k < 60; ++k) {
    double const until = std::pow(10, 5 * u(random)), width = until * std::pow(10, -2 - 6 * u(random)),
                 at = until * (0.05 + 0.9 * u(random)), height = std::pow(10, 4 * u(random) - 2);
    for (auto const& [shape, bend] : {std::pair("{2}*exp(-((t - {0})/{1})^2)", 2.0),
                                      {"{2}*tanh((t - {0})/{1})", 0.7698},
                                      {"{2}/(1 + ((t - {0})/{1})^2)", 2.0}}) {
      std::string const formula = fmt::format(fmt::runtime(shape), at, width, height);
      ChangeInTime const found = change(formula, until);
      double const most = bend * height / (width * width);
      BOOST_TEST(found.settled, formula << " until " << until);
      BOOST_TEST((found.bend >= most / 4 && found.bend <= 1.01 * most),
                 formula << " until " << until << ": " << found.bend << " of " << most);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_wave_has_its_frequency_whatever_the_time) {
  for (double const until : {10.0, 1e3, 1e6}) {
    ChangeInTime const found = change("3*cos(2*t) + 1", until);
    BOOST_TEST(found.settled);
    BOOST_TEST((found.frequency() > 0.5 && found.frequency() <= 2.001), found.frequency());
  }
  BOOST_TEST(change("2", 10).frequency() == 0);
}

BOOST_AUTO_TEST_CASE(what_does_not_settle_is_told_with_its_place) {
  ChangeInTime const kink = change("sqrt((t - 5)^2)", 12);
  BOOST_TEST(!kink.settled);
  BOOST_TEST((kink.from <= 5 && kink.to >= 5 && kink.to - kink.from < 1e-6), kink.from << " to " << kink.to);
}

BOOST_AUTO_TEST_CASE(what_is_slower_than_what_matters_is_not_looked_for) {
  ChangeInTime const found = change("1e-3*exp(-((t - 7)/0.1)^2)", 1000, 10);
  BOOST_TEST(found.settled);
  BOOST_TEST(found.bound <= 10);
}

BOOST_AUTO_TEST_SUITE_END()
