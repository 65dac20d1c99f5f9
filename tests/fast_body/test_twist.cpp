// The twist of a step of Moser and Veselov: its equation in the differences of the moments beside the
// equation of the fourth degree, and what is solved, against many digits.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/fast_body/space/explicit_moser_veselov.hpp"
#include "actio/fast_body/space/short_flow.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Numbers j of a body whose middle moment is the second, either way round, and a direction; the same real
/// numbers in double and in S.
template <class S>
struct Step {
  HalfStep<S> half;
  Three<S> u;
  S r;

  /// @param e  1/I of the three axes, ascending or descending
  Step(Three<double> const& e, double length, Three<double> const& direction) {
    using std::sqrt;
    for (int i = 0; i < 3; ++i) half.j[i] = S(e[i]) * S(length), u[i] = S(direction[i]);
    half.d12 = half.j[0] - half.j[1], half.d23 = half.j[1] - half.j[2];
    S const size = sqrt(dot(u, u));
    for (S& x : u) x /= size;
    r = half.j[0] * u[0] * u[0] + half.j[1] * u[1] * u[1] + half.j[2] * u[2] * u[2];
  }
};
Three<double> random_direction(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return {uniform(random), uniform(random), uniform(random)};
}
double off(Number const& a, Number const& b) { return to_double(magnitude(a - b)); }

}  // namespace

BOOST_AUTO_TEST_SUITE(twist)

BOOST_AUTO_TEST_CASE(both_forms_of_the_equation_are_one_function_with_one_slope) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  std::mt19937 random(1971);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 40; ++trial) {
    Three<double> e{1.3, 0.9, 0.4};
    if (trial % 2) std::swap(e[0], e[2]);
    Step<Number> const step(e, uniform(random), random_direction(random));
    TwistEquation<Number> const quartic(step.half.j, step.r);
    TwistFromMiddle<Number> const middle(step.half, step.u);
    Number const kappa = 2 * uniform(random), d = ratio<Number>(1, 1000000000);
    BOOST_TEST(off(middle.residual(kappa), quartic.residual(kappa)) <= 1e-47);
    BOOST_TEST(off(middle.slope(kappa), quartic.slope(kappa)) <= 1e-47);
    // By differences, to the fourth order in 1e-9.
    Number const slope = (8 * (middle.residual(kappa + d) - middle.residual(kappa - d)) -
                          (middle.residual(kappa + 2 * d) - middle.residual(kappa - 2 * d))) /
                         (12 * d);
    BOOST_TEST(off(middle.slope(kappa), slope) <= 1e-33);
  }
}

BOOST_AUTO_TEST_CASE(the_root_is_the_smallest_and_a_few_evaluations_find_it) {
  std::mt19937 random(1972);
  std::uniform_real_distribution<double> uniform(0, 1);
  int found = 0, refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Three<double> e{1.3, 0.9, 0.4};
    if (trial % 2) std::swap(e[0], e[2]);
    Step<double> const step(e, 0.6 * uniform(random), random_direction(random));
    TwistEquation<double> const equation(step.half.j, step.r);
    // The least root by looking for the first change of sign from 0, where the residual is r, positive.
    double left = 0, right = 0;
    while (right < 4 && equation.residual(right) > 0) left = right, right += 1e-3;
    for (int k = 0; k < 60; ++k) {
      double const middle = (left + right) / 2;
      (equation.residual(middle) > 0 ? left : right) = middle;
    }
    auto const quartic = smallest_root<double>(equation, step.r),
               middle = smallest_root<double>(TwistFromMiddle<double>(step.half, step.u), step.r);
    BOOST_TEST(quartic.found == middle.found);
    // Next to the longest step the root is nearly a double one.
    if (equation.slope(left) > -0.05) continue;
    ++(quartic.found ? found : refused);
    if (!quartic.found) continue;
    for (auto const& twist : {quartic, middle}) {
      BOOST_TEST(std::abs(twist.kappa - left) <= 16 * eps / std::abs(equation.slope(left)));
      // The digits double with each; next to a double root fewer do.
      BOOST_TEST(twist.iterations <= 12);
      BOOST_TEST(twist.iterations >= 2);
    }
  }
  BOOST_TEST(found > 150);
}

BOOST_AUTO_TEST_CASE(the_parameters_have_all_their_digits_for_long_bodies_and_for_nearly_round_ones) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  std::mt19937 random(1973);
  for (Three<double> const& e : {Three<double>{1.5, 1, 0.25},
                                 {0.25, 1, 1.5},
                                 {0x1p20, 1.25, 1},
                                 {1, 1.25, 0x1p20},
                                 {1 + 0x1p-30, 1, 1 - 0x1p-31},
                                 {1 + 0x1p-40, 1, 0.5}})
    for (double const part : {1e-6, 0.1, 0.3, -0.3})
      for (int trial = 0; trial < 5; ++trial) {
        double const length = part / std::max(e[0], e[2]);
        auto direction = random_direction(random);
        Step<Number> const exact(e, length, direction);
        // The same real numbers: differences and components are rounded once.
        HalfStep<double> half;
        Three<double> u;
        for (int i = 0; i < 3; ++i) half.j[i] = to_double(exact.half.j[i]), u[i] = to_double(exact.u[i]);
        half.d12 = to_double(exact.half.d12), half.d23 = to_double(exact.half.d23);
        bool found = false, found_exactly = false;
        auto const p = moser_veselov_parameters<double>(half, u, found);
        auto const q = moser_veselov_parameters<Number>(exact.half, exact.u, found_exactly);
        BOOST_TEST((found && found_exactly));
        Number const kappa = q.sin_twist / q.cos_twist, whole = 1 + kappa * kappa;
        BOOST_TEST(off(q.cos_twist * q.cos_twist * whole, 1) <= 1e-46);
        // delta_i = (1 + kappa^2) j_i - kappa solves the equation of the fourth degree.
        TwistEquation<Number> const equation(exact.half.j, part < 0 ? -exact.r : exact.r);
        if (part > 0) BOOST_TEST(off(equation.residual(kappa), 0) <= 1e-44);
        Number const least = magnitude(exact.half.d12) < magnitude(exact.half.d23)
                                 ? magnitude(exact.half.d12)
                                 : magnitude(exact.half.d23);
        for (int i = 0; i < 3; ++i) {
          BOOST_TEST(off(q.delta[i], whole * exact.half.j[i] - kappa) <= 1e-45);
          int const j = (i + 1) % 3, k = (i + 2) % 3;
          BOOST_TEST(off(q.gap[i], q.delta[k] - q.delta[j]) <= 1e-45);
          BOOST_TEST(off(q.stretch[i], 1 + q.delta[j] * q.delta[k]) <= 1e-45);
          // Differences of the moments bound all three; roundings of what they are multiplied with.
          Number const scale = magnitude(q.delta[i]) + least;
          BOOST_TEST(off(Number(p.delta[i]), q.delta[i]) <= 64 * eps * to_double(scale));
          BOOST_TEST(off(Number(p.gap[i]), q.gap[i]) <= 32 * eps * to_double(magnitude(q.gap[i])));
          BOOST_TEST(off(Number(p.stretch[i]), q.stretch[i]) <= 32 * eps);
        }
        BOOST_TEST(off(Number(p.cos_twist), q.cos_twist) <= 16 * eps);
        BOOST_TEST(off(Number(p.sin_twist), q.sin_twist) <= 16 * eps * to_double(magnitude(q.sin_twist)));
      }
}

BOOST_AUTO_TEST_SUITE_END()
