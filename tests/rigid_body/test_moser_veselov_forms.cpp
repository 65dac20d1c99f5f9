// DEP, DLP and DEL are three forms of one motion, and that of the generic implementation.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "random_bodies.hpp"
#include "witness/number.hpp"

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
    // the error of a relative motion is a residual of 4 epsilon over the least moment; they add up
    double const room = 100 * (k + 1) * eps;
    BOOST_TEST(magnitude((scheme.momentum_before(next) - next_pi).components) <= room * scale);
    BOOST_TEST(magnitude((relative_motion_left(g1, g2).value - next.value).eval()) <= room);
    BOOST_TEST(magnitude((lie_poisson_update_left(f, pi) - next_pi).components) <= room * scale);
    BOOST_TEST(magnitude(scheme.residual(f, next).components) <= room * scale);
    // The generic implementation: the equation of chapter 3 for the trace Lagrangian, derivatives by dual
    // numbers.
    BOOST_TEST(magnitude(euler_poincare_left(scheme.lagrangian(), f, next).components) <=
               room * scale / scheme.step());
    g0 = g1, g1 = g2, f = next, pi = next_pi;
  }
}

// The printed line (5.8) and the sum of small changes that the steps use.
template <int n, class S>
void increment_is_the_printed_line(double angle) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<n>(random);
  Momentum<SO<n>, S> const pi{{}, body_momentum(inertia, spin).components.template cast<S>()};
  Velocity<SO<n>, S> const turn{{}, spin.coordinates.template cast<S>() * S(angle / spin.coordinates.norm())};
  auto const f = exp(turn);
  auto const printed = MoserVeselov<n, S>::transport(f, pi),
             by_increment = MoserVeselov<n, S>::transport_by_increment(f, pi);
  // Two products of n by n matrices each, of entries at most 1 but for M: 2n roundings in either.
  BOOST_TEST(
      (magnitude((printed - by_increment).components) <= 4 * n * epsilon<S>() * magnitude(pi.components)));
  // Neither is the identity: a turn of this size moves the momentum.
  BOOST_TEST((magnitude((printed - pi).components) > 1e-3 * angle * magnitude(pi.components)));
}
}  // namespace

BOOST_AUTO_TEST_SUITE(moser_veselov)

BOOST_AUTO_TEST_CASE(the_increment_of_a_step_is_that_of_the_printed_line) {
  for (double const angle : {0.01, 0.3, 2.0}) {
    increment_is_the_printed_line<3, double>(angle);
    increment_is_the_printed_line<4, double>(angle);
    WithArithmetic const digits(Arithmetic::decimal(50));
    increment_is_the_printed_line<3, Number>(angle);
  }
}

BOOST_AUTO_TEST_CASE(the_three_forms_are_one_motion) {
  for (double const angle : {0.01, 0.3, 0.8}) {
    three_forms_agree<3>(angle);
    three_forms_agree<4>(angle);
  }
  three_forms_agree<5>(0.3);
}

BOOST_AUTO_TEST_CASE(its_momentum_is_that_of_the_general_way) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<4>(random);
  MoserVeselov<4> const scheme(inertia, 0.2);
  auto const pi = body_momentum(inertia, spin);
  auto const f = scheme.relative_motion(pi).value;
  double const scale = 64 * eps * magnitude(pi.components) / scheme.step();
  BOOST_TEST(magnitude((momentum_before_left(scheme.lagrangian(), f) - pi).components) <= scale);
  BOOST_TEST(magnitude((-right_differential(scheme.lagrangian(), f) - scheme.momentum_after(f)).components) <=
             scale);
  BOOST_TEST(magnitude((scheme.momentum_after(f) - scheme.transport(f, pi)).components) <= scale);
}

BOOST_AUTO_TEST_SUITE_END()
