// The sign of the quaternion counts the turns: an evaluation at a far time gives the quaternion that small
// steps arrive at, not its negative.
#include <boost/test/unit_test.hpp>

#include "hard_bodies.hpp"

using namespace actio;
using namespace actio::bodies;
using namespace actio::testing;

namespace {

/// How many places of a motion have the other sign than at(t), and how many were looked at.
struct Signs {
  int wrong = 0, seen = 0;
};
/// @param time  of the motion, before or after the start; steps are a twentieth of a turn or less
Signs compare(FreeProblem const& p, double time) {
  auto const body = p.body();
  double const fastest = body.magnitude() / std::min({p.moments[0], p.moments[1], p.moments[2]});
  int const steps = 20 + static_cast<int>(4 * std::abs(time) * fastest);
  FreeSteps small(body, time / steps);
  Signs signs;
  for (int k = 1; k <= steps; ++k) {
    small.advance();
    auto const here = small.state().attitude.value, at = body.at(k * (time / steps)).attitude.value;
    ++signs.seen;
    if (!((at - here).norm() < (at + here).norm())) ++signs.wrong;
  }
  return signs;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(continuous_quaternion)

BOOST_AUTO_TEST_CASE(a_far_time_has_the_sign_that_small_steps_arrive_at) {
  HardProblems problems(1971);
  Signs all;
  for (int trial = 0; trial < 400; ++trial) {
    auto const p = problems.next(1);
    double const fastest = p.magnitude() / std::min({p.moments[0], p.moments[1], p.moments[2]});
    auto const signs = compare(p, problems.sign() * problems.between(5, 200) / fastest);
    all.wrong += signs.wrong, all.seen += signs.seen;
    BOOST_TEST(signs.wrong == 0, "problem " << trial);
  }
  BOOST_TEST(all.seen > 50000);
}

BOOST_AUTO_TEST_CASE(both_ways_round_and_next_to_the_separatrix) {
  std::array<double, 3> const moments{0.6, 0.8, 1.0};
  // On the separatrix M1^2 (1/I1 - 1/I2) = M3^2 (1/I2 - 1/I3).
  double const x = std::sqrt(0.25), z = std::sqrt(1 / 0.6 - 1 / 0.8);
  for (double const off : {0.0, 1e-12, -1e-12, 1e-6, -1e-6, 0.05, -0.05, 0.5, -0.5})
    for (double const m2 : {0.0, 0.3, 1.0})
      for (double const sense : {1.0, -1.0}) {
        FreeProblem const p{moments, {x * (1 + off), m2, sense * z}, 0};
        BOOST_TEST(compare(p, 150).wrong == 0, "off " << off << ", M2 " << m2 << ", sense " << sense);
        BOOST_TEST(compare(p, -150).wrong == 0, "off " << off << ", M2 " << m2 << ", sense " << sense);
      }
}

BOOST_AUTO_TEST_CASE(a_full_turn_of_a_sphere_is_minus_one) {
  FreeProblem const p{{2, 2, 2}, {0, 0, 2}, 0};
  double const turn = 2 * JacobiFunctions<double>::pi();
  for (int const turns : {1, 2, 7})
    BOOST_TEST(p.body().at(turns * turn).attitude.value[0] == (turns % 2 ? -1 : 1),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(momenta_alone_are_the_same_to_the_bit) {
  HardProblems problems(7);
  for (int trial = 0; trial < 2000; ++trial) {
    auto const p = problems.next(1e4);
    auto const body = p.body();
    BOOST_TEST((body.body_momentum_at(p.time).components == body.at(p.time).body_momentum.components),
               "problem " << trial);
  }
}

BOOST_AUTO_TEST_SUITE_END()
