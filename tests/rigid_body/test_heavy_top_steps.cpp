// The heavy top stepped by a solver that remembers, against Newton's iteration from scratch; and what the
// motion conserves.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/advected_steps.hpp"
#include "actio/rigid_body/heavy_top.hpp"

using namespace actio;

namespace {

double const eps = epsilon<double>();

}  // namespace

BOOST_AUTO_TEST_SUITE(heavy_top_steps)

BOOST_AUTO_TEST_CASE(steps_that_remember_are_those_of_newton_and_keep_what_the_top_keeps) {
  auto const known = kovalevskaya_top<double>();
  double const h = 0.05;
  int const steps = 400;
  auto const l = natural_chart_lagrangian(known.top, h);
  Element<SO<3>, double> const first = exp(-h * known.spin);
  Vector<double, 3> const up(0, 0, 1);
  AdvectedStepsLeft motion(l, first, up);
  auto const casimir = [&] { return motion.state().momentum.components.dot(motion.state().vector); };
  double const vertical = casimir();
  auto f = motion.relative_motion();
  Vector<double, 3> before = up;
  double worst = 0;
  for (int k = 0; k < steps; ++k) {
    auto const reference = step_advected_euler_poincare_left(l, f, before).value;
    before = advect_left(f, before);
    f = motion.advance();
    worst = std::max(worst, magnitude((f.value - reference.value).eval()));
    BOOST_TEST_REQUIRE(motion.report().residuals.back() <= 4 * motion.report().tolerance);
  }
  // Two solvers, 16 epsilon of a row each; the moments are 2, 2 and 1.
  BOOST_TEST(worst < 2 * 64 * eps);
  // Both drift by roundings: one or two a step in each of three terms, all the same way at worst.
  BOOST_TEST(std::abs(motion.state().vector.norm() - 1) < 8 * eps * steps);
  BOOST_TEST(std::abs(casimir() - vertical) < 16 * eps * steps * motion.state().momentum.components.norm());
}

BOOST_AUTO_TEST_SUITE_END()
