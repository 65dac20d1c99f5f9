// DEP, DLP and DEL are three forms of one motion, and that of the general road.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "random_bodies.hpp"

using namespace actio;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

// DEP, DLP and DEL from one start, each by its own function, and by chapter 3's.
template <int n>
void three_forms_agree(double angle) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<n>(random);
  MoserVeselov<n> const scheme(inertia, angle / spin.coordinates.norm());
  auto pi = body_momentum(inertia, spin);
  auto f = scheme.relative_motion(pi).value;
  auto g0 = identity<double>(SO<n>{}), g1 = reconstruct_left(g0, f);
  double const scale = magnitude(pi.components);
  for (int k = 0; k < 20; ++k) {
    auto const next = scheme.step_euler_poincare(f).value;
    auto const next_pi = scheme.step_lie_poisson(pi);
    auto const g2 = scheme.step_euler_lagrange(g0, g1);
    double const room = 100 * (k + 1) * eps;  // the error of a relative motion is a residual of 4 epsilon over the least moment; they add up
    BOOST_TEST(magnitude((scheme.momentum_before(next) - next_pi).components) <= room * scale);
    BOOST_TEST(magnitude((relative_motion_left(g1, g2).value - next.value).eval()) <= room);
    BOOST_TEST(magnitude((lie_poisson_update_left(f, pi) - next_pi).components) <= room * scale);
    BOOST_TEST(magnitude(scheme.residual(f, next).components) <= room * scale);
    // The general road: the equation of chapter 3 for the trace Lagrangian, derivatives by dual numbers.
    BOOST_TEST(magnitude(euler_poincare_left(scheme.lagrangian(), f, next).components) <= room * scale / scheme.step());
    g0 = g1, g1 = g2, f = next, pi = next_pi;
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(moser_veselov)

BOOST_AUTO_TEST_CASE(the_three_forms_are_one_motion) {
  for (double const angle : {0.01, 0.3, 0.8}) {
    three_forms_agree<3>(angle);
    three_forms_agree<4>(angle);
  }
  three_forms_agree<5>(0.3);
}

BOOST_AUTO_TEST_CASE(its_momentum_is_that_of_the_general_road) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<4>(random);
  MoserVeselov<4> const scheme(inertia, 0.2);
  auto const pi = body_momentum(inertia, spin);
  auto const f = scheme.relative_motion(pi).value;
  double const scale = 64 * eps * magnitude(pi.components) / scheme.step();
  BOOST_TEST(magnitude((momentum_before_left(scheme.lagrangian(), f) - pi).components) <= scale);
  BOOST_TEST(magnitude((-right_differential(scheme.lagrangian(), f) - scheme.momentum_after(f)).components) <= scale);
  BOOST_TEST(magnitude((scheme.momentum_after(f) - scheme.transport(f, pi)).components) <= scale);
}

BOOST_AUTO_TEST_SUITE_END()
