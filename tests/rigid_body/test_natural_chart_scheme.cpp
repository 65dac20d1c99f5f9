// The natural-chart scheme: its momentum in closed form, its three forms and the unreduced run, and where it
// refuses.
#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "random_bodies.hpp"
#include "refused.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

template <int n>
void the_forms_are_one_motion() {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<n>(random);
  NaturalChartScheme<n> const scheme(inertia, 0.4 / spin.coordinates.norm());
  auto pi = body_momentum(inertia, spin);
  auto f = scheme.relative_motion(pi).value;
  auto g0 = identity<double>(SO<n>{}), g1 = reconstruct_left(g0, f), u0 = g0, u1 = g1;
  double const scale = magnitude(pi.components);
  for (int k = 0; k < 5; ++k) {
    auto const next = scheme.step_euler_poincare(f).value;
    auto const next_pi = scheme.step_lie_poisson(pi);
    auto const g2 = scheme.step_euler_lagrange(g0, g1), u2 = scheme.step_unreduced(u0, u1).value;
    // a residual of tens of epsilon over the least moment a step; they add up
    double const room = 200 * (k + 1) * eps;
    BOOST_TEST(magnitude((scheme.momentum_before(next) - next_pi).components) <= room * scale);
    BOOST_TEST(magnitude((scheme.momentum_after(f) - next_pi).components) <= room * scale);
    BOOST_TEST(magnitude((relative_motion_left(g1, g2).value - next.value).eval()) <= room);
    BOOST_TEST(magnitude((u2.value - g2.value).eval()) <= 10 * room);
    g0 = g1, g1 = g2, u0 = u1, u1 = u2, f = next, pi = next_pi;
  }
}

// The momentum by dual numbers is chi(ad*) J zeta, on either side of the step.
template <int n>
void the_momentum_has_a_closed_form() {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<n>(random);
  double const h = 0.4 / spin.coordinates.norm();
  NaturalChartScheme<n> const scheme(inertia, h);
  auto const f = exp(-h * spin);
  double const room = 100 * eps * magnitude(body_momentum(inertia, spin).components);
  BOOST_TEST(magnitude((scheme.momentum_before(f) - scheme.momentum_of(spin)).components) <= room);
  auto const backward = -scheme.momentum_of(-spin);
  BOOST_TEST(magnitude((scheme.momentum_after(f) - backward).components) <= room);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(natural_chart_scheme)

BOOST_AUTO_TEST_CASE(its_forms_and_the_unreduced_run_are_one_motion) {
  the_forms_are_one_motion<3>();
  the_forms_are_one_motion<4>();
}

BOOST_AUTO_TEST_CASE(its_momentum_has_a_closed_form) {
  the_momentum_has_a_closed_form<3>();
  the_momentum_has_a_closed_form<4>();
}

BOOST_AUTO_TEST_CASE(it_is_another_scheme_than_that_of_moser_and_veselov) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<3>(random);
  auto const pi = body_momentum(inertia, spin);
  double const h = 0.1;
  auto const chart = NaturalChartScheme<3>(inertia, h).step_lie_poisson(pi),
             trace = MoserVeselov<3>(inertia, h).step_lie_poisson(pi);
  double const apart = magnitude((chart - trace).components);
  BOOST_TEST(apart > 1e-6);  // third order in the step,
  BOOST_TEST(apart < 1e-2);  // but not more
}

BOOST_AUTO_TEST_CASE(a_turn_about_a_principal_axis_is_where_the_iteration_begins) {
  // The exact motion is the scheme's; a second look is left to rounding. The inverse motion, one radian the
  // other way, takes three.
  auto const inertia = inertia_from_moments(0.6, 0.8, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    auto const pi = momentum(SO<3>{}, Vector3d(inertia.moments[axis] * Vector3d::Unit(axis)));
    BOOST_TEST(NaturalChartScheme<3>(inertia, 1.0).relative_motion(pi).report.evaluations <= 2);
  }
}

BOOST_AUTO_TEST_CASE(steps_that_have_no_answer_are_refused) {
  auto const inertia = inertia_from_moments(0.6, 0.8, 1.0);
  auto const pi = momentum(SO<3>{}, Vector3d(0.6, 0.8, 1.0));
  CHECK_REFUSED(NaturalChartScheme<3>(inertia, std::nan("")), NotFinite);
  CHECK_REFUSED(NaturalChartScheme<3>(inertia, 0.0), OutsideDomain);
  CHECK_REFUSED(
      NaturalChartScheme<3>(inertia, 0.1).relative_motion(momentum(SO<3>{}, Vector3d(1, std::nan(""), 0))),
      NotFinite);
  // About the middle axis the derivative is singular at half a turn at the latest: a typed error, never a
  // number.
  for (double const h : {3.5, 10.0, 1000.0}) {
    try {
      auto const solved = NaturalChartScheme<3>(inertia, h).relative_motion(pi);
      // An answer is a root of the equation, inside the chart.
      auto const miss = NaturalChartScheme<3>(inertia, h).momentum_before(solved.value) - pi;
      BOOST_TEST(magnitude(miss.components) <= 64 * solved.report.tolerance);
      BOOST_TEST(log(solved.value).coordinates.norm() < M_PI);
    } catch (Error const&) {
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
