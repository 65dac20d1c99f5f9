// The Moser-Veselov scheme: its equation, the branch of the identity, the longest step, and input that has no
// answer.
#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/body_in_motion.hpp"
#include "caught.hpp"
#include "random_bodies.hpp"
#include "refused.hpp"

using namespace actio;
using testing::caught;
using Vector3d = actio::Vector<double, 3>;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

// What (5.7) and (5.9) say, written out with matrices.
template <int n>
double defect(Inertia<n> const& inertia, double h, Storage<SO<n>, double> const& f,
              Coordinates<SO<n>, double> const& pi) {
  Storage<SO<n>, double> const lambda = inertia.lambda.asDiagonal();
  return magnitude((f.transpose() * lambda - lambda * f - h * inertia.group.hat(pi)).eval()) /
         magnitude(lambda);
}

template <int n>
void solves_up_to_the_longest_step_and_refuses_beyond(int size = n) {
  std::mt19937 random(testing::seed + size);
  for (int repeat = 0; repeat < 3; ++repeat) {
    auto const [inertia, spin] = testing::random_body<n>(random, size);
    auto const pi = body_momentum(inertia, spin);
    double const longest = largest_step(inertia, pi);
    for (double const part : {1e-8, 0.01, 0.5, 0.9, 0.999, 0.999999}) {
      auto const f = MoserVeselov<n>(inertia, part * longest).relative_motion(pi).value;
      BOOST_TEST(defect<n>(inertia, part * longest, f.value, pi.components) <= 64 * eps);
      BOOST_TEST(magnitude((f.value.transpose() * f.value - identity<double>(inertia.group).value).eval()) <=
                 8 * eps);
      // The branch of the identity: the spectrum of f^T Lambda lies to the right. Close to the end the least
      // real part goes with the root.
      Matrix<double> const x = f.value.transpose() * inertia.lambda.asDiagonal();
      BOOST_TEST(real_parts_of_eigenvalues(x)[0] > 0.1 * std::sqrt(1 - part) * inertia.lambda.minCoeff());
    }
    for (double const part : {1.000001, 1.001, 1.1, 3.0, 100.0}) {
      auto const error =
          caught<StepTooLong>([&] { MoserVeselov<n>(inertia, part * longest).relative_motion(pi); });
      BOOST_TEST(std::abs(error.largest_step / longest - 1) <= 1e-12);
      BOOST_TEST(std::abs(error.measured / (part * longest) - 1) <= 1e-12);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(moser_veselov)

BOOST_AUTO_TEST_CASE(solves_up_to_the_longest_step_and_refuses_beyond_it) {
  solves_up_to_the_longest_step_and_refuses_beyond<3>();
  solves_up_to_the_longest_step_and_refuses_beyond<4>();
  solves_up_to_the_longest_step_and_refuses_beyond<5>();
  solves_up_to_the_longest_step_and_refuses_beyond<8>();
  solves_up_to_the_longest_step_and_refuses_beyond<Dynamic>(6);
}

BOOST_AUTO_TEST_CASE(few_evaluations_find_the_relative_motion) {
  std::mt19937 random(testing::seed);
  for (int repeat = 0; repeat < 5; ++repeat) {
    auto const [inertia, spin] = testing::random_body<4>(random);
    auto const pi = body_momentum(inertia, spin);
    double const longest = largest_step(inertia, pi);
    // A division gains a factor of about the angle of the step; where that is too little Newton doubles the
    // digits.
    for (auto const& [part, most] :
         {std::pair{1e-8, 3}, {1e-3, 7}, {0.1, 14}, {0.5, 14}, {0.9, 8}, {0.999, 12}}) {
      auto const found = MoserVeselov<4>(inertia, part * longest).relative_motion(pi);
      BOOST_TEST_MESSAGE("part " << part << ": " << found.report.evaluations << " evaluations");
      BOOST_TEST(found.report.evaluations <= most);
    }
  }
}

BOOST_AUTO_TEST_CASE(about_a_principal_axis_the_sine_of_the_angle_is_h_times_the_velocity) {
  auto const inertia = inertia_from_moments(0.6, 0.8, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    auto const spin = basis_velocity<double>(SO<3>{}, axis);
    auto const pi = body_momentum(inertia, spin);
    BOOST_TEST(std::abs(largest_step(inertia, pi) - 1) <= 1e-12);  // h M_i = I_i
    for (double const h : {1e-6, 0.1, 0.9, 0.999}) {
      auto const turn = log(MoserVeselov<3>(inertia, h).relative_motion(pi).value).coordinates;
      // f looks back: the angle is negative
      BOOST_TEST(std::abs(turn[axis] + std::asin(h)) <= 8 * eps / std::sqrt(1 - h * h));
    }
  }
}

BOOST_AUTO_TEST_CASE(moves_with_the_flow_and_not_against_it) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<3>(random);
  auto const pi = body_momentum(inertia, spin);
  Vector3d const euler = pi.components.cross(spin.coordinates);
  for (double const h : {1e-3, -1e-3}) {
    MoserVeselov<3> const scheme(inertia, h);
    Vector3d const slope = (scheme.step_lie_poisson(pi) - pi).components / h;
    BOOST_TEST((slope - euler).norm() <= 2e-3 * euler.norm());
    auto body = release(inertia, identity<double>(SO<3>{}), spin);
    advance(scheme, body);
    BOOST_TEST((log(body.attitude).coordinates / h - spin.coordinates).norm() <=
               2e-3 * spin.coordinates.norm());
  }
}

BOOST_AUTO_TEST_CASE(a_step_back_undoes_a_step) {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<4>(random);
  auto const pi = body_momentum(inertia, spin);
  auto const there = MoserVeselov<4>(inertia, 0.2).step_lie_poisson(pi);
  auto const back = MoserVeselov<4>(inertia, -0.2).step_lie_poisson(there);
  BOOST_TEST(magnitude((back - pi).components) <= 64 * eps * magnitude(pi.components));
}

BOOST_AUTO_TEST_CASE(a_planar_body_has_a_lambda_of_zero_and_moves_all_the_same) {
  auto const inertia = inertia_from_moments(0.6158144, 1.1557006, 0.6158144 + 1.1557006);
  auto const pi = body_momentum(inertia, velocity(SO<3>{}, Vector3d(0.7, -0.4, 0.5)));
  double const longest = largest_step(inertia, pi);
  for (double const part : {0.01, 0.5, 0.999}) {
    auto const f = MoserVeselov<3>(inertia, part * longest).relative_motion(pi).value;
    BOOST_TEST(defect<3>(inertia, part * longest, f.value, pi.components) <= 64 * eps);
  }
  CHECK_REFUSED(MoserVeselov<3>(inertia, 1.001 * longest).relative_motion(pi), StepTooLong);
}

BOOST_AUTO_TEST_CASE(bodies_of_every_size_give_the_same_digits) {
  Vector3d const moments(0.6, 0.8, 1.0), spin(0.7, -0.4, 0.5);
  auto const motion = [&](double mass, double pace) {
    auto const inertia = inertia_from_moments<double>(moments * mass);
    auto body = release(inertia, identity<double>(SO<3>{}), velocity(SO<3>{}, (spin * pace).eval()));
    MoserVeselov<3> const scheme(inertia, 0.2 / pace);
    for (int k = 0; k < 50; ++k) advance(scheme, body);
    return body;
  };
  auto const usual = motion(1, 1);
  // Powers of two: not a digit differs.
  auto const small = motion(std::ldexp(1.0, -156), std::ldexp(1.0, -40)),
             large = motion(std::ldexp(1.0, 156), std::ldexp(1.0, 40));
  BOOST_TEST((small.attitude.value - usual.attitude.value).norm() == 0);
  BOOST_TEST((large.attitude.value - usual.attitude.value).norm() == 0);
  for (double const mass : {1e-47, 1e47})
    for (double const pace : {1e-12, 1e12})
      BOOST_TEST(magnitude((motion(mass, pace).attitude.value - usual.attitude.value).eval()) <=
                 50 * 32 * eps);
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_stays) {
  auto const inertia = inertia_from_moments(0.6, 0.8, 1.0);
  auto const rest = momentum(SO<3>{}, Vector3d(Vector3d::Zero()));
  BOOST_TEST(std::isinf(largest_step(inertia, rest)));
  auto const f = MoserVeselov<3>(inertia, 1e6).relative_motion(rest).value;
  BOOST_TEST((f.value - Matrix<double, 3, 3>::Identity()).norm() == 0);
}

BOOST_AUTO_TEST_CASE(a_symmetric_body_and_a_sphere_move) {
  for (Vector3d const& moments : {Vector3d(1, 1, 1), Vector3d(1, 1, 1.5), Vector3d(1, 1, 2),
                                  Vector3d(1e-6, 1, 1), Vector3d(1e-6, 1, 1 + 1e-6)}) {
    auto const inertia = inertia_from_moments<double>(moments);
    auto const pi = body_momentum(inertia, velocity(SO<3>{}, Vector3d(0.3, 0.2, 0.4)));
    auto const solved = MoserVeselov<3>(inertia, 0.1).relative_motion(pi);
    BOOST_TEST(defect<3>(inertia, 0.1, solved.value.value, pi.components) <= 64 * eps);
  }
}

BOOST_AUTO_TEST_CASE(no_number_and_no_step_are_refused) {
  auto const inertia = inertia_from_moments(0.6, 0.8, 1.0);
  CHECK_REFUSED(MoserVeselov<3>(inertia, std::nan("")), NotFinite);
  CHECK_REFUSED(MoserVeselov<3>(inertia, INFINITY), NotFinite);
  CHECK_REFUSED(MoserVeselov<3>(inertia, 0.0), OutsideDomain);
  MoserVeselov<3> const scheme(inertia, 0.1);
  CHECK_REFUSED(scheme.relative_motion(momentum(SO<3>{}, Vector3d(1, std::nan(""), 0))), NotFinite);
  CHECK_REFUSED(scheme.relative_motion(momentum(SO<3>{}, Vector3d(1, INFINITY, 0))), NotFinite);
  CHECK_REFUSED(scheme.relative_motion(momentum(SO<3>{}, Vector3d(1e300, 0, 0))), StepTooLong);
  CHECK_REFUSED(largest_step(inertia, momentum(SO<3>{}, Vector3d(1, std::nan(""), 0))), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_reflection_is_no_relative_motion) {
  MoserVeselov<3> const scheme(inertia_from_moments(1.5, 2, 3), 0.1);
  Element<SO<3>, double> const mirror{{}, Matrix<double, 3, 3>(Vector3d(1, 1, -1).asDiagonal())};
  CHECK_REFUSED(scheme.relative_motion({{}, Vector3d(0.1, 0.2, 0.3)}, mirror), OutsideDomain);
  CHECK_REFUSED(scheme.step_euler_poincare(mirror), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(a_generalized_body_with_a_negative_lambda_moves_in_short_steps) {
  auto const inertia = inertia_from_lambda<4, double>(Vector<double, 4>(-0.3, 1, 1.5, 2));
  std::mt19937 random(testing::seed);
  auto const pi = body_momentum(inertia, testing::random_body<4>(random).spin);
  auto const f = MoserVeselov<4>(inertia, 0.01).relative_motion(pi).value;
  BOOST_TEST(defect<4>(inertia, 0.01, f.value, pi.components) <= 64 * eps);
  CHECK_REFUSED(MoserVeselov<4>(inertia, 100.0).relative_motion(pi), Error);
}

BOOST_AUTO_TEST_SUITE_END()
