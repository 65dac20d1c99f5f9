// The natural-chart scheme by closed forms: against the generic implementation, its orders, what it
// conserves, and where it ends.
#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/natural_chart_steps.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "hard_bodies.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Moment = Momentum<SO<3>, double>;

Inertia<3> const inertia = inertia_from_moments(0.6, 0.8, 1.0);
Vector3d const spin(0.7, -0.4, 0.5);
Moment const start{SO<3>{}, spin.cwiseProduct(Vector3d(inertia.moments))};
Element<SU2, double> const upright = identity<double>(SU2{});

Vector3d vector(Three<double> const& x) { return {x[0], x[1], x[2]}; }
double apart(FreeState const& a, FreeState const& b) {
  return (a.body_momentum.components - b.body_momentum.components).norm() +
         (a.attitude.value - b.attitude.value).norm();
}
}  // namespace

BOOST_AUTO_TEST_SUITE(natural_chart_steps)

BOOST_AUTO_TEST_CASE(the_closed_form_of_the_momentum_is_chi) {
  std::mt19937 random(testing::seed);
  for (int trial = 0; trial < 30; ++trial) {
    auto const [body, turn] = testing::random_body<3>(random);
    // Angles on either side of the one where a series gives way to the cotangent, and up to the end of the
    // chart.
    for (double const angle : {1e-9, 1e-3, 0.3, 0.4999, 0.5001, 1.0, 2.0, 3.1}) {
      auto const v = velocity(SO<3>{}, Vector3d(turn.coordinates.normalized() * angle));
      auto const& I = body.moments;
      Vector3d const closed = vector(NaturalChartStep({I[0], I[1], I[2]})
                                         .momentum({v.coordinates[0], v.coordinates[1], v.coordinates[2]}));
      // The matrix functions of the generic implementation take some ten products.
      BOOST_TEST((closed - NaturalChartScheme<3>(body, 1.0).momentum_of(v).components).norm() <=
                 50 * eps * magnitude(I) * angle);
    }
  }
}

BOOST_AUTO_TEST_CASE(its_steps_are_those_of_the_general_way) {
  std::mt19937 random(testing::seed);
  for (int trial = 0; trial < 5; ++trial) {
    auto const [body, turn] = testing::random_body<3>(random);
    auto pi = body_momentum(body, turn);
    double const h = 0.1 * std::pow(4.0, trial / 2) / turn.coordinates.norm(), size = pi.components.norm();
    NaturalChartScheme<3> const general(body, h);
    NaturalChartSteps fast(body, pi, upright, h);
    auto g = identity<double>(SO<3>{});
    for (int k = 1; k <= 10; ++k) {
      auto const f = general.relative_motion(pi).value;
      pi = general.step_lie_poisson(pi), g = reconstruct_left(g, f);
      fast.advance();
      auto const s = fast.state();
      auto const& q = s.attitude.value;
      Eigen::Matrix3d const R = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
      // a residual of tens of epsilon over the least moment a step by the generic implementation
      double const room = 200 * k * eps;
      BOOST_TEST((s.body_momentum.components - pi.components).norm() <= room * size);
      BOOST_TEST((R - g.value).norm() <= room);
    }
  }
}

BOOST_AUTO_TEST_CASE(orders_two_four_and_six_are_measured_against_the_exact_motion) {
  FreeBody const body(inertia, start, upright);
  for (auto const& [order, fractions] : {std::pair(2, std::vector<double>{1}), std::pair(4, suzuki<double>()),
                                         std::pair(6, kahan_li<double>())}) {
    std::vector<double> steps, errors;
    for (int const count : {20, 28, 40, 56}) {
      NaturalChartSteps motion(inertia, start, upright, 10.0 / count, fractions);
      motion.advance(count);
      steps.push_back(10.0 / count), errors.push_back(apart(motion.state(), body.at(10)));
    }
    auto const fit = testing::fit_order(steps, errors);
    BOOST_TEST_MESSAGE("natural chart, order " << order << ": measured " << fit.slope << ", errors "
                                               << errors.front() << " to " << errors.back());
    BOOST_TEST(std::abs(fit.slope - order) < 0.2);
  }
}

BOOST_AUTO_TEST_CASE(amount_and_momentum_in_space_are_kept_to_rounding_over_many_steps) {
  for (auto const& fractions : {std::vector<double>{1}, suzuki<double>()}) {
    NaturalChartSteps motion(inertia, start, upright, 0.05, fractions);
    motion.advance(100000);
    auto const s = motion.state();
    double const size = start.components.norm();
    // The sums are compensated: the error is the rounding of the changes, a walk of 1e5 parts of epsilon.
    double const room = 4 * eps * std::sqrt(1e5) * 0.1;
    BOOST_TEST(std::abs(s.body_momentum.components.norm() / size - 1) <= room);
    BOOST_TEST((s.spatial_momentum().components - start.components).norm() / size <= 2 * room);
  }
}

BOOST_AUTO_TEST_CASE(momenta_alone_are_the_same_to_the_bit_and_the_attitude_is_then_unknown) {
  NaturalChartSteps both(inertia, start, upright, 0.1), alone(inertia, start, upright, 0.1),
      one(inertia, start, upright, 0.1);
  both.advance(500), alone.advance_momentum(500);
  for (int k = 0; k < 500; ++k) one.advance();
  BOOST_TEST((both.body_momentum().components == alone.body_momentum().components));
  BOOST_TEST((both.state().attitude.value == one.state().attitude.value));
  CHECK_REFUSED(alone.state(), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(steps_beyond_half_a_turn_are_refused_with_the_longest_that_would_do) {
  // About a principal axis: half a turn a step.
  for (int axis = 0; axis < 3; ++axis) {
    Moment const turn{SO<3>{}, Vector3d(Vector3d::Unit(axis) * inertia.moments[axis] * 2)};
    try {
      NaturalChartSteps(inertia, turn, upright, 10);
      BOOST_ERROR("took a step of more than half a turn");
    } catch (StepTooLong const& error) {
      BOOST_TEST(error.measured == 10);
      BOOST_TEST(std::abs(error.largest_step * 2 / JacobiFunctions<double>::pi() - 1) <= 1e-9);
    }
  }
  testing::HardProblems problems(testing::seed);
  for (int trial = 0; trial < 300; ++trial) {
    auto const p = problems.next(1);
    auto const body = inertia_from_moments(p.moments[0], p.moments[1], p.moments[2]);
    Moment const M{SO<3>{}, Vector3d(p.momentum[0], p.momentum[1], p.momentum[2])};
    for (auto const& fractions : {std::vector<double>{1}, suzuki<double>()}) try {
        NaturalChartSteps(body, M, upright, 1e3 / p.rate(), fractions);
        BOOST_ERROR("problem " << trial << ": took a step of many turns");
      } catch (StepTooLong const& error) {
        BOOST_CHECK_NO_THROW(NaturalChartSteps(body, M, upright, error.largest_step, fractions).advance());
        BOOST_CHECK_THROW(NaturalChartSteps(body, M, upright, 1.000001 * error.largest_step, fractions),
                          StepTooLong);
      }
  }
}

BOOST_AUTO_TEST_CASE(the_turn_of_a_momentum_is_found_up_to_half_a_turn) {
  std::mt19937 random(testing::seed + 2);
  for (int trial = 0; trial < 60; ++trial) {
    auto const [body, turn] = testing::random_body<3>(random);
    auto const& I = body.moments;
    NaturalChartStep const scheme({I[0], I[1], I[2]});
    for (double const angle : {1e-12, 1e-3, 0.49, 0.51, 1.0, 2.0, 2.6}) {
      Vector3d const v = turn.coordinates.normalized() * angle;
      Three<double> const p = scheme.momentum({v[0], v[1], v[2]});
      auto const found = scheme.followed(p);
      // Where the derivative is singular before this turn another one has the momentum too, or none is found.
      if (!found.found) continue;
      BOOST_TEST((angle > 2 || (vector(found.v) - v).norm() <= 64 * eps * angle));
      BOOST_TEST((vector(scheme.momentum(found.v)) - vector(p)).norm() <= 32 * eps * vector(p).norm());
      BOOST_TEST(std::abs(found.angle_squared - vector(found.v).squaredNorm()) <=
                 4 * eps * found.angle_squared);
      // From nearby Newton's method alone gets there, to the same digits.
      auto const near = scheme.turn(p, {found.v[0] * 1.1, found.v[1] * 0.95, found.v[2] * 1.05});
      BOOST_TEST((near.found && (vector(near.v) - vector(found.v)).norm() <= 64 * eps * angle));
    }
  }
}

// Steps that are nearly the longest at the start: on its way the body turns faster, and after a few of them
// there is no other.
BOOST_AUTO_TEST_CASE(a_run_that_ends_leaves_the_body_at_the_last_step_that_had_a_solution) {
  auto const body = inertia_from_moments(0.5, 0.6, 1.05);
  Moment const M{SO<3>{}, Vector3d(0.8, 0.4, 0.4)};
  for (auto const& fractions : {std::vector<double>{1}, suzuki<double>()})
    for (double const sign : {1.0, -1.0}) {
      double h = 0;
      try {
        NaturalChartSteps(body, M, upright, sign * 100, fractions);
      } catch (StepTooLong const& error) {
        h = sign * 0.98 * error.largest_step;
      }
      NaturalChartSteps motion(body, M, upright, h, fractions), one(body, M, upright, h, fractions);
      int taken = 0;
      try {
        for (; taken < 1000; ++taken) one.advance();
        BOOST_ERROR("no step was too long");
      } catch (StepTooLong const&) {
      }
      BOOST_TEST(taken > 0);
      auto const last = one.state();
      double longest = 0;
      for (int again = 0; again < 2; ++again) try {
          (again ? one : motion).advance(taken + 5);
          BOOST_ERROR("went on");
        } catch (StepTooLong const& error) {
          BOOST_TEST(error.measured == std::abs(h));
          BOOST_TEST((longest == 0 || error.largest_step == longest));
          longest = error.largest_step;
        }
      BOOST_TEST((motion.state().attitude.value == last.attitude.value));
      BOOST_TEST((motion.body_momentum().components == last.body_momentum.components));
      BOOST_TEST((one.state().attitude.value == last.attitude.value));
      // From here a step of the length that is named has a solution, and a little more has none.
      BOOST_CHECK_NO_THROW(
          NaturalChartSteps(body, last.body_momentum, last.attitude, sign * longest * (1 - 1e-9), fractions));
      CHECK_REFUSED(
          NaturalChartSteps(body, last.body_momentum, last.attitude, sign * longest * (1 + 1e-6), fractions),
          StepTooLong);
      BOOST_TEST(motion.step() == h);
    }
}

BOOST_AUTO_TEST_CASE(units_do_not_matter) {
  NaturalChartSteps usual(inertia, start, upright, 0.25);
  usual.advance(100);
  for (int const k : {-900, -156, 30, 400}) {
    auto const size = std::ldexp(1.0, k);
    NaturalChartSteps other(inertia_from_moments<double>((inertia.moments * size).eval()), size * start,
                            upright, 0.25);
    other.advance(100);
    BOOST_TEST((other.state().attitude.value == usual.state().attitude.value));
    BOOST_TEST((other.body_momentum().components == size * usual.body_momentum().components));
  }
}

BOOST_AUTO_TEST_CASE(rest_and_next_to_rest_and_input_that_has_no_answer) {
  NaturalChartSteps rest(inertia, {SO<3>{}, Vector3d::Zero()}, upright, 1e100),
      slow(inertia, 1e-300 * start, upright, 1);
  rest.advance(10), slow.advance(10);
  BOOST_TEST((rest.state().attitude.value == upright.value));
  BOOST_TEST((slow.body_momentum().components / 1e-300 - start.components).norm() <= 8 * eps);
  CHECK_REFUSED(NaturalChartSteps(inertia, start, upright, 0), OutsideDomain);
  CHECK_REFUSED(NaturalChartSteps(inertia, start, upright, std::nan("")), NotFinite);
  CHECK_REFUSED(NaturalChartSteps(inertia, {SO<3>{}, Vector3d(1, INFINITY, 0)}, upright, 0.1), NotFinite);
  CHECK_REFUSED(NaturalChartSteps(inertia, 1e200 * start, upright, 0.1), NotFinite);
  CHECK_REFUSED(NaturalChartSteps(inertia, start, upright, 0.1, {0.5, 0.4}), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
