// What a free body says of itself: its symmetry, its pace, how near the separatrix is, and the longest steps
// of its schemes.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/fast_body/space/free_steps.hpp"
#include "caught.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using testing::caught;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

FreeBody body_of(Vector3d const& moments, Vector3d const& momentum) {
  return FreeBody(inertia_from_moments<double>(moments), {SO<3>{}, momentum});
}
}  // namespace

BOOST_AUTO_TEST_SUITE(free_body_parameters)

BOOST_AUTO_TEST_CASE(a_sphere_has_three_equal_moments_and_a_symmetric_body_two) {
  Vector3d const M(0.3, -0.7, 0.45);
  BOOST_TEST(body_of({0.7, 0.7, 0.7}, M).is_sphere());
  BOOST_TEST(body_of({0.7, 0.7, 0.7}, M).is_symmetric());
  for (int axis = 0; axis < 3; ++axis)
    for (double const other : {0.5, 1.5}) {
      Vector3d I(1, 1, 1);
      I[axis] = other;
      BOOST_TEST(body_of(I, M).is_symmetric());
      BOOST_TEST(!body_of(I, M).is_sphere());
    }
  BOOST_TEST(!body_of({0.6, 0.8, 1}, M).is_symmetric());
  BOOST_TEST(!body_of({0.6, 0.8, 1}, M).is_sphere());
}

BOOST_AUTO_TEST_CASE(moments_are_equal_within_two_epsilon) {
  Vector3d const M(0.3, -0.7, 0.45);
  for (int axis = 0; axis < 3; ++axis)
    for (double const sign : {1.0, -1.0}) {
      // Two moments near 3/2, apart by so many units in the last place.
      Vector3d I(1.5, 1.5, 1.5), far = I;
      I[(axis + 1) % 3] += sign * 2 * eps, far[(axis + 1) % 3] += sign * 4 * eps, I[axis] = far[axis] = 1;
      BOOST_TEST(body_of(I, M).is_symmetric());
      BOOST_TEST(!body_of(far, M).is_symmetric());
    }
  // The middle moment is the second.
  BOOST_TEST(axis_of_symmetry({2, 2, 3}) == 2);
  BOOST_TEST(axis_of_symmetry({3, 2, 2}) == 0);
  BOOST_TEST(axis_of_symmetry({2, 2, 2}) == 2);
  BOOST_TEST(axis_of_symmetry({1, 2, 3}) == -1);
  BOOST_TEST(axis_of_symmetry({1.5 + 3 * eps, 1.5, 1}) == 2);
  BOOST_TEST(axis_of_symmetry({1, 1.5, 1.5 - 3 * eps}) == 0);
}

BOOST_AUTO_TEST_CASE(the_pace_is_made_of_the_moments_and_the_momentum) {
  Vector3d const I(0.6, 0.8, 1);
  for (double const unit : {1.0, 1e-40, 7e30})
    for (Vector3d const& M : {Vector3d(0.2, 0.3, 1), Vector3d(1, 0.3, 0.2), Vector3d(1e-3, 1, -2e-3)}) {
      // L^2 s1 = (J1 - J2) (2H - J3 L^2) + (J2 - J3) (J1 L^2 - 2H), in the given units.
      Vector3d const J = I.cwiseInverse();
      double const H2 = M.cwiseAbs2().dot(J), L2 = M.squaredNorm(),
                   s1 = (J[0] - J[1]) * (H2 - J[2] * L2) + (J[1] - J[2]) * (J[0] * L2 - H2);
      auto const body = body_of(unit * I, unit * M);
      BOOST_TEST(std::abs(body.pace() / std::sqrt(s1) - 1) <= 32 * eps);
      BOOST_TEST(std::abs(body.magnitude() / unit / std::sqrt(L2) - 1) <= 8 * eps);
      // The frequency of Jacobi's functions, and no more than root two of it.
      double const frequency =
          std::sqrt(std::max((J[0] - J[1]) * (H2 - J[2] * L2), (J[1] - J[2]) * (J[0] * L2 - H2)));
      BOOST_TEST(body.pace() >= frequency * (1 - 32 * eps));
      BOOST_TEST(body.pace() <= std::sqrt(2.0) * frequency * (1 + 32 * eps));
    }
}

BOOST_AUTO_TEST_CASE(near_the_separatrix_the_complementary_modulus_is_a_hundredth_or_less) {
  for (Vector3d const& I : {Vector3d(0.6, 0.8, 1), Vector3d(0.1, 0.95, 1), Vector3d(1, 0.8, 0.6)})
    for (int side = 0; side < 2; ++side)
      for (double const part : {1e-4, 0.002, 0.004, 0.006, 0.008, 0.012, 0.3}) {
        // M1 = x cos a and M3 = z sin a are on the separatrix at 45 degrees.
        Vector3d const J = I.cwiseInverse();
        double const angle = 0.25 * M_PI + (side ? -1 : 1) * part, x = std::sqrt(std::abs(J[1] - J[2])),
                     z = std::sqrt(std::abs(J[0] - J[1]));
        Vector3d const u = Vector3d(x * std::cos(angle), 0.4, z * std::sin(angle)).normalized();
        double const H2 = u.cwiseAbs2().dot(J), first = (J[0] - J[1]) * (H2 - J[2]),
                     third = (J[1] - J[2]) * (J[0] - H2), larger = std::max(first, third),
                     complement = 1 - std::min(first, third) / larger;
        // s1 is the sum of the two, 2 - k'^2 times the larger, and the bound a hundredth of that.
        if (complement < 0.0197) BOOST_TEST(body_of(I, u).near_separatrix());
        if (complement > 0.0199) BOOST_TEST(!body_of(I, u).near_separatrix());
      }
}

BOOST_AUTO_TEST_CASE(orders_that_no_scheme_has_are_refused_with_the_nearest_bound) {
  auto const body = body_of({0.6, 0.8, 1}, {0.9, 0.3, -0.5});
  for (auto const& [order, bound] : {std::pair{0, 2}, std::pair{-2, 2}, std::pair{1, 2}, std::pair{3, 40},
                                     std::pair{41, 40}, std::pair{42, 40}}) {
    auto const refusal = caught<OutsideDomain>([&] { body.moser_veselov_parameters(0.1, order); });
    BOOST_TEST(refusal.measured == order);
    BOOST_TEST(refusal.bound == bound);
  }
  BOOST_CHECK_NO_THROW(body.moser_veselov_parameters(0.01, 40));
  auto const zero = caught<OutsideDomain>([&] { FreeSteps(body, 0.0); });
  BOOST_TEST((zero.measured == 0 && zero.bound == 0));
  FreeSteps alone(body, 0.1);
  alone.advance_momentum(0);
  BOOST_CHECK_NO_THROW(alone.state());
  alone.advance_momentum(1);
  auto const unknown = caught<OutsideDomain>([&] { alone.state(); });
  BOOST_TEST((unknown.measured == 0 && unknown.bound == 1));
  BOOST_TEST(alone.step() == 0.1);
}

BOOST_AUTO_TEST_CASE(steps_of_any_order_go_up_to_the_longest_and_not_beyond) {
  for (Vector3d const& M : {Vector3d(0.9, 0.3, -0.5), Vector3d(0.1, 0.8, 0.7)})
    for (double const mass : {1.0, 1e-30})
      for (int const order : {4, 6, 10}) {
        auto const body = body_of(mass * Vector3d(0.6, 0.8, 1), mass * M);
        auto const refusal = caught<StepTooLong>([&] { body.moser_veselov_parameters(-1000, order); });
        double const longest = refusal.largest_step;
        BOOST_TEST(refusal.measured == 1000);
        BOOST_TEST(refusal.bound == longest);
        for (double const sign : {1.0, -1.0}) {
          for (double const part : {0.2, 0.4, 0.6, 0.8, 0.999999})
            BOOST_CHECK_NO_THROW(body.moser_veselov_parameters(sign * part * longest, order));
          for (double const part : {1.000001, 1.01, 1.5, 3.0, 20.0}) {
            auto const beyond =
                caught<StepTooLong>([&] { body.moser_veselov_parameters(sign * part * longest, order); });
            BOOST_TEST(std::abs(beyond.largest_step / longest - 1) <= 1e-11);
            BOOST_TEST(std::abs(beyond.measured / (part * longest) - 1) <= 4 * eps);
          }
        }
      }
}

BOOST_AUTO_TEST_SUITE_END()
