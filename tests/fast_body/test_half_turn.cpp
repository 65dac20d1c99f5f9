// The Moser-Veselov scheme as a half turn, against its equation: exactly over the rationals, and against the
// general solver to rounding.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/compensated_half_turn.hpp"
#include "actio/fast_body/space/free_body.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

template <class S>
Three<S> cross_product(Three<S> const& a, Three<S> const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A relative motion (q0, q) and a body for which |p| and |Iq| are rational, p = q0 Iq + q x Iq: q = A y + B n
// with y, n rational and orthonormal, A = K.
struct RationalMotion {
  Three<Number> I, before, after;
  Number amount, kappa;

  explicit RationalMotion(FineDraw& draw) {
    auto const turn = draw.element<Number>(SO<3>{}, Number(1)).value;
    Number const s = draw.number<Number>(), w = draw.number<Number>(), whole = 1 + s * s, K = 2 * s / whole;
    amount = (1 - s * s) / whole;
    Number const q0 = amount * (1 - w * w) / (1 + w * w), B = amount * 2 * w / (1 + w * w);
    Three<Number> y, q;
    for (int i = 0; i < 3; ++i) y[i] = turn(i, 0), q[i] = K * y[i] + B * turn(i, 1), I[i] = y[i] / q[i];
    Three<Number> const side = cross_product(q, y);
    for (int i = 0; i < 3; ++i)
      before[i] = (q0 * y[i] + side[i]) / amount, after[i] = (q0 * y[i] - side[i]) / amount;
    kappa = K / amount;
  }
  Three<Number> j() const { return {amount / I[0], amount / I[1], amount / I[2]}; }
  static Number mean(Three<Number> const& j, Three<Number> const& u) {
    return j[0] * u[0] * u[0] + j[1] * u[1] * u[1] + j[2] * u[2] * u[2];
  }
};

// One step of the optimised implementation beside the general solver; what is allowed is a residual of 16
// epsilon times the angle in each, over the slope with which the equation crosses zero: at the largest step
// that is none.
struct Beside {
  double momentum = 0, attitude = 0, room = 0;
};
Beside beside_the_general_solver(Inertia<3> const& inertia, Vector3d const& pi, double h) {
  FreeBody const body(inertia, {SO<3>{}, pi});
  auto const parameters = body.moser_veselov_parameters(h, 2);
  FrameState<double> state = body.start();
  HalfTurn<double>(parameters).step(state);
  auto const fast = body.state(state);
  auto const f = MoserVeselov<3>(inertia, h).relative_motion({SO<3>{}, pi}).value;
  Vector3d const after = MoserVeselov<3>::transport(f, {SO<3>{}, pi}).components;
  // The relative motion looks back.
  Eigen::Matrix3d turned;
  for (int i = 0; i < 3; ++i)
    turned.col(i) = Vector3d(SU2::Ad<double>(fast.attitude.value, Vector3d::Unit(i)));
  double const L = pi.norm();
  Three<double> j;
  double r = 0, angle = 0;
  for (int i = 0; i < 3; ++i) {
    j[i] = h * L / (2 * inertia.moments[i]);
    r += j[i] * pi[i] * pi[i] / (L * L);
    angle = std::max(angle, std::abs(h * pi[i] / inertia.moments[i]));
  }
  double const slope =
      std::abs(TwistEquation<double>(j, r).slope(parameters.sin_twist / parameters.cos_twist));
  return {(fast.body_momentum.components - after).norm() / L, (turned - f.value.transpose()).norm(),
          32 * eps * (1 + angle / std::min(1.0, slope))};
}
}  // namespace

BOOST_AUTO_TEST_SUITE(half_turn)

BOOST_AUTO_TEST_CASE(the_twist_of_a_relative_motion_solves_its_equation_exactly) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(testing::seed);
  for (int repeat = 0; repeat < 40; ++repeat) {
    RationalMotion const motion(draw);
    Three<Number> const &u = motion.before, j = motion.j();
    BOOST_TEST((dot(u, u) == 1));
    BOOST_TEST((RationalMotion::mean(j, u) == RationalMotion::mean(j, motion.after)));
    TwistEquation<Number> const equation(j, RationalMotion::mean(j, u));
    BOOST_TEST((equation.residual(motion.kappa) == 0));
    // Of another body, or with the twist the other way, it is not solved.
    BOOST_TEST((equation.residual(-motion.kappa) != 0));
    Three<Number> const other = {j[1], j[0], j[2]};
    BOOST_TEST((TwistEquation<Number>(other, RationalMotion::mean(other, u)).residual(motion.kappa) != 0));
    // The slope is that of the residual: a polynomial of degree four, by five points.
    Number const d = ratio<Number>(1, 7), k = motion.kappa;
    Number const slope = (8 * (equation.residual(k + d) - equation.residual(k - d)) -
                          (equation.residual(k + 2 * d) - equation.residual(k - 2 * d))) /
                         (12 * d);
    BOOST_TEST((slope == equation.slope(k)));
  }
}

BOOST_AUTO_TEST_CASE(the_half_turn_takes_the_momentum_before_to_that_after_exactly) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(testing::seed + 1);
  for (int repeat = 0; repeat < 40; ++repeat) {
    RationalMotion const motion(draw);
    Three<Number> const j = motion.j();
    Number const k = motion.kappa, sum = 1 + k * k;
    Three<Number> const delta = {sum * j[0] - k, sum * j[1] - k, sum * j[2] - k};
    // cos T = |p|/|y| is rational here.
    StepParameters<Number> parameters{delta,
                                      {delta[2] - delta[1], delta[0] - delta[2], delta[1] - delta[0]},
                                      motion.amount,
                                      k * motion.amount,
                                      stretch_of(delta)};
    Three<Number> u = motion.before;
    HalfTurn<Number>(parameters).step(u);
    BOOST_TEST((u == motion.after));
    // The axis is the null vector of diag(delta) + [u]x, and the moments are recovered from the parameters.
    Three<Number> const v = HalfTurn<Number>(parameters).axis(motion.before),
                        side = cross_product(motion.before, v);
    for (int i = 0; i < 3; ++i) BOOST_TEST((delta[i] * v[i] + side[i] == 0));
    BOOST_TEST((inertia_of(parameters) == j));
    // With the gaps the wrong way round it is another map.
    for (auto& g : parameters.gap) g = -g;
    u = motion.before;
    HalfTurn<Number>(parameters).step(u);
    BOOST_TEST((u != motion.after));
  }
}

BOOST_AUTO_TEST_CASE(the_four_roots_are_the_ways_to_choose_the_spectrum) {
  // det(x^2 - x hM - Lambda^2) is a cubic in x^2; f^T Lambda has one of each pair of its roots, with the
  // determinant of Lambda, and Tr(f Lambda) = Tr Lambda
  // - 2 K.
  Vector3d const lambda(0.3, 0.7, 1.6), p(0.011, -0.023, 0.017);  // p = hM/2
  double x[3];
  for (int n = 0; n < 3; ++n) {
    double s = lambda[n] * lambda[n];
    for (int i = 0; i < 20; ++i) {
      double value = 1, slope = 0;
      for (int k = 0; k < 3; ++k)
        slope = slope * (s - lambda[k] * lambda[k]) + value, value *= s - lambda[k] * lambda[k];
      for (int k = 0; k < 3; ++k) {
        double const m = 4 * p[k] * p[k], d = s - lambda[k] * lambda[k];
        value += s * m * d, slope += m * (d + s);
      }
      s -= value / slope;
    }
    x[n] = std::sqrt(s);
  }
  double const size = p.norm();
  Three<double> const j = {size / (lambda[1] + lambda[2]), size / (lambda[2] + lambda[0]),
                           size / (lambda[0] + lambda[1])};
  double const r = (j[0] * p[0] * p[0] + j[1] * p[1] * p[1] + j[2] * p[2] * p[2]) / (size * size);
  TwistEquation<double> const equation(j, r);
  std::vector<double> roots;
  for (auto const& signs : {std::array{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}) {
    double const K = (lambda.sum() - signs[0] * x[0] - signs[1] * x[1] - signs[2] * x[2]) / 2,
                 kappa = K / size;
    // A rounding of Lambda is one of kappa by eps Tr Lambda/|p|.
    BOOST_TEST(std::abs(equation.residual(kappa)) <=
               16 * eps * lambda.sum() / size * std::abs(equation.slope(kappa)));
    roots.push_back(kappa);
  }
  // Choices with the wrong determinant are no roots.
  double const wrong = (lambda.sum() + x[0] - x[1] - x[2]) / 2 / size;
  BOOST_TEST(std::abs(equation.residual(wrong)) > 1e-3);
  BOOST_TEST(std::abs(smallest_root<double>(equation, r).kappa - roots[0]) <= 16 * eps * lambda.sum() / size);
  BOOST_TEST(roots[0] == *std::min_element(roots.begin(), roots.end()));
}

BOOST_AUTO_TEST_CASE(ten_thousand_bodies_step_as_with_the_general_solver) {
  std::mt19937 random(testing::seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double worst = 0, least = 1;
  for (int repeat = 0; repeat < 10000; ++repeat) {
    auto const [inertia, spin] = testing::random_body<3>(random);
    Vector3d const pi = body_momentum(inertia, spin).components;
    // Every tenth body at 0.999 of the largest step, some of them backward; the rest within three quarters of
    // a bound that is below it: |hM| < 2 min Lambda.
    double h = 0.75 * uniform(random) * 2 * inertia.lambda.minCoeff() / pi.norm();
    if (repeat % 10 == 0) h = (h < 0 ? -0.999 : 0.999) * largest_step(inertia, {SO<3>{}, pi});
    auto const [momentum, attitude, room] = beside_the_general_solver(inertia, pi, h);
    worst = std::max({worst, momentum / room, attitude / room}), least = std::min(least, room);
  }
  BOOST_TEST_MESSAGE("fast and general Moser-Veselov, 10000 bodies: at most "
                     << worst << " of the room of 32 eps (1 + angle/slope)");
  BOOST_TEST(worst <= 1);
}

BOOST_AUTO_TEST_CASE(bodies_that_break_codes_step_as_with_the_general_solver) {
  // The general solver reads Lambda, the fast one the moments: of a body that is a million times as long as
  // wide they say the same only where both are exact.
  double const thin = 0x1p-20, near = 0x1p-40;
  for (Vector3d const& moments :
       {Vector3d(1, 1, 1), Vector3d(1, 1, 1.5), Vector3d(1, 1.5, 1.5), Vector3d(1, 1, 2),
        Vector3d(0.6, 0.8, 1.4), Vector3d(thin, 1, 1 + thin), Vector3d(thin, 1, 1 + thin / 2),
        Vector3d(1, 1 + near, 1.5), Vector3d(1, 1 + near, 1 + 2 * near)})
    for (int order = 0; order < 6; ++order)
      for (double const part : {-0.999, -0.3, 1e-9, 0.1, 0.9, 0.999}) {
        Vector3d I, pi;
        int const o[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
        for (int i = 0; i < 3; ++i)
          I[i] = moments[o[order][i]], pi[i] = Vector3d(0.3, -0.2, 0.4)[o[order][i]] * I[i];
        auto const inertia = inertia_from_moments<double>(I);
        auto const [momentum, attitude, room] =
            beside_the_general_solver(inertia, pi, part * largest_step(inertia, {SO<3>{}, pi}));
        BOOST_TEST(momentum <= room);
        BOOST_TEST(attitude <= room);
      }
}

BOOST_AUTO_TEST_CASE(steps_beyond_the_largest_are_refused_and_the_largest_named) {
  std::mt19937 random(testing::seed + 2);
  for (int repeat = 0; repeat < 200; ++repeat) {
    auto const [inertia, spin] = testing::random_body<3>(random);
    auto const pi = body_momentum(inertia, spin);
    FreeBody const body(inertia, pi);
    double const largest = largest_step(inertia, pi);
    BOOST_CHECK_NO_THROW(body.moser_veselov_parameters(0.999999 * largest, 2));
    for (double const part : {1.000001, -1.000001, 1.01, -2.0, 30.0, 1e6}) {
      try {
        body.moser_veselov_parameters(part * largest, 2);
        BOOST_ERROR("accepted a step beyond the longest: " << part);
      } catch (StepTooLong const& error) {
        BOOST_TEST(std::abs(error.largest_step / largest - 1) <= 1e-12);
        BOOST_TEST(std::abs(error.measured / std::abs(part * largest) - 1) <= 1e-12);
      }
    }
  }
  // About a principal axis: h M_i = I_i.
  for (int axis = 0; axis < 3; ++axis)
    for (double const side : {1.0, -1.0}) {
      FreeBody const body(
          inertia_from_moments(0.6, 0.8, 1),
          body_momentum(inertia_from_moments(0.6, 0.8, 1), side * basis_velocity<double>(SO<3>{}, axis)));
      BOOST_CHECK_NO_THROW(body.moser_veselov_parameters(0.999, 2));
      CHECK_REFUSED(body.moser_veselov_parameters(1.001, 2), StepTooLong);
    }
}

BOOST_AUTO_TEST_CASE(the_twist_is_the_same_all_along_the_orbit_and_steps_back_undo_steps) {
  std::mt19937 random(testing::seed + 3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    auto const [inertia, spin] = testing::random_body<3>(random);
    auto const pi = body_momentum(inertia, spin);
    double const h = 0.7 * largest_step(inertia, pi);
    FreeBody const body(inertia, pi);
    auto const first = body.moser_veselov_parameters(h, 2);
    HalfTurn<double> const turn(first);
    FrameState<double> state = body.start();
    for (int k = 0; k < 200; ++k) {
      turn.step(state);
      // Built afresh from where the body is: energy and amount have seen a rounding a step.
      auto const now = FreeBody(inertia, body.state(state).body_momentum).moser_veselov_parameters(h, 2);
      BOOST_TEST(std::abs(now.sin_twist - first.sin_twist) <= 32 * (k + 1) * eps);
    }
    HalfTurn<double> const back(body.moser_veselov_parameters(-h, 2));
    for (int k = 0; k < 200; ++k) back.step(state);
    auto const end = body.state(state), start = body.state(body.start());
    BOOST_TEST((end.body_momentum - start.body_momentum).components.norm() <=
               400 * 32 * eps * body.magnitude());
    BOOST_TEST((end.attitude.value - start.attitude.value).norm() <= 400 * 32 * eps);
  }
}

BOOST_AUTO_TEST_CASE(the_compensated_turn_is_the_same_step) {
  std::mt19937 random(testing::seed + 4);
  for (int repeat = 0; repeat < 100; ++repeat) {
    auto const [inertia, spin] = testing::random_body<3>(random);
    FreeBody const body(inertia, body_momentum(inertia, spin));
    for (double const h : {1e-12, 1e-3, 0.1, 1.0, 3.0, 30.0, -2.0}) {
      auto const parameters = body.step_parameters(h);
      FrameState<double> plain = body.start();
      CompensatedState<double> summed{plain, {{}, {}}}, alone = summed;
      HalfTurn<double>(parameters).step(plain);
      CompensatedHalfTurn<double>(parameters).step(summed);
      CompensatedHalfTurn<double>(parameters).step_momentum(alone);
      Three<double> u = body.start().direction;
      HalfTurn<double>(parameters).step(u);
      for (int i = 0; i < 3; ++i) {
        BOOST_TEST(std::abs(plain.direction[i] - summed.state.direction[i]) <= 16 * eps);
        BOOST_TEST(alone.state.direction[i] == summed.state.direction[i]);
        BOOST_TEST(std::abs(u[i] - plain.direction[i]) <= 4 * eps);
      }
      for (int i = 0; i < 4; ++i)
        BOOST_TEST(std::abs(plain.attitude[i] - summed.state.attitude[i]) <= 16 * eps);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
