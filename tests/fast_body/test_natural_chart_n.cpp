// The natural-chart scheme on SO(n), n at run time: held to its own equations, and to what it must refuse.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "bytes.hpp"
#include "chart_cases.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using actio::testing::Case, actio::testing::difference, actio::testing::n_, actio::testing::random_case;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

MatrixXd hat(Momentum<SO<n_>, double> const& pi) { return pi.group.hat(pi.components); }

}  // namespace

BOOST_AUTO_TEST_SUITE(natural_chart_of_any_size)

BOOST_AUTO_TEST_CASE(solves_the_equations_themselves) {
  std::mt19937 random(testing::seed + 1);
  for (int n : {2, 3, 4, 7, 8, 11, 16, 33})
    for (double h : {0.05, -0.05, 0.5}) {
      BOOST_TEST_CONTEXT("n = " << n << ", h = " << h) {
        auto const [inertia, pi] = random_case(random, n);
        FastNaturalChart scheme(inertia, h);
        auto body = scheme.release(pi);
        for (int k = 0; k < 20; ++k) {
          MatrixXd const m0 = hat(body.momentum()), g0 = body.attitude().value;
          scheme.step_with_attitude(body);
          MatrixXd const f = scheme.last_relative_motion(body).value, m1 = hat(body.momentum()),
                         g1 = body.attitude().value;
          // Entries of f and g near 1: a rounding each, and one of a sum of n products.
          BOOST_TEST(difference(f * f.transpose(), MatrixXd::Identity(n, n)) <= 4 * n * eps);
          BOOST_TEST(difference(f * m0 * f.transpose(), m1) <= 4 * n * eps * m0.norm());
          BOOST_TEST(difference(g1 * f, g0) <= 4 * n * eps);
          // The mean of the momentum over the step, by Simpson's rule on 64 pieces: J log(f^T). What the rule
          // leaves out is (h/64)^4/180 of it and less.
          MatrixXd const z = -matrix_logarithm(f);
          MatrixXd piece = matrix_exponential(MatrixXd(-z / 64)), turned = m0, sum = m0;
          for (int s = 1; s <= 64; ++s) {
            turned = MatrixXd(piece * turned * piece.transpose());
            sum += (s == 64 ? 1 : s % 2 ? 4 : 2) * turned;
          }
          MatrixXd const momentum =
              (MatrixXd(inertia.lambda.asDiagonal()) * z + z * MatrixXd(inertia.lambda.asDiagonal())) / h;
          double const left_out = std::pow(2 * h / 64, 4) / 180;
          BOOST_TEST(difference(sum / 192, momentum) <= (left_out + 1e3 * eps / std::abs(h)) * m0.norm());
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(keeps_the_spectrum_of_the_momentum) {
  std::mt19937 random(testing::seed + 2);
  for (int n : {3, 4, 5, 8}) {
    auto const [inertia, pi] = random_case(random, n);
    double const h = 0.1;
    long const steps = 2000;
    FastNaturalChart scheme(inertia, h);
    auto body = scheme.release(pi);
    VectorXd const before = skew_spectrum(hat(pi));
    double turned = 0, energy = 0;
    for (long k = 0; k < steps; ++k) {
      scheme.step_with_attitude(body);
      turned = std::max(turned, (body.momentum() - pi).components.norm() / pi.components.norm());
      energy = std::max(energy,
                        std::abs(kinetic_energy(inertia, body.momentum()) / kinetic_energy(inertia, pi) - 1));
    }
    // Were all roundings of f - 1, h eps each, to pull the same way.
    double const bound = n * eps * (h * steps + n);
    BOOST_TEST(difference(skew_spectrum(hat(body.momentum())), before) <= bound * before.norm());
    MatrixXd const g = body.attitude().value;
    BOOST_TEST(difference(g.transpose() * g, MatrixXd::Identity(n, n)) <= bound);
    BOOST_TEST(difference(g * hat(body.momentum()) * g.transpose(), hat(pi)) <= bound * hat(pi).norm());
    BOOST_TEST(turned > 0.1);  // it did move
    // A scheme of order 2: the energy is off by the square of the angle of a step at most, and does not
    // leave.
    BOOST_TEST(energy <= h * h);
    BOOST_TEST(energy > 1e-6 * h * h);
  }
}

BOOST_AUTO_TEST_CASE(goes_back_where_it_came_from) {
  std::mt19937 random(testing::seed + 3);
  for (int n : {3, 6, 13}) {
    auto const [inertia, pi] = random_case(random, n);
    FastNaturalChart there(inertia, 0.1), back(inertia, -0.1);
    auto body = there.release(pi);
    for (int k = 0; k < 100; ++k) there.step_with_attitude(body);
    BOOST_TEST((body.momentum() - pi).components.norm() > 0.1 * pi.components.norm());
    for (int k = 0; k < 100; ++k) back.step_with_attitude(body);
    // An error grows with the distance of nearby motions, which over ten radians is some tens.
    double const bound = 200 * n * eps * 30;
    BOOST_TEST((body.momentum() - pi).components.norm() <= bound * pi.components.norm());
    BOOST_TEST(difference(body.attitude().value, MatrixXd::Identity(n, n)) <= bound);
  }
}

BOOST_AUTO_TEST_CASE(plain_copy_is_the_fast_copy) {
  if (best_machine() == Machine::plain) return;
  std::mt19937 random(testing::seed + 4);
  for (int n : {3, 6, 8, 10}) {
    auto const [inertia, pi] = random_case(random, n);
    FastNaturalChart fast(inertia, 0.1, Machine::avx2), plain(inertia, 0.1, Machine::plain);
    auto a = fast.release(pi), b = plain.release(pi);
    for (int k = 0; k < 40; ++k) {
      fast.step_with_attitude(a), plain.step_with_attitude(b);
      // They differ by whether a product is rounded before it is added: a few roundings a step.
      BOOST_TEST((a.momentum() - b.momentum()).components.norm() <= (k + 4) * n * eps * pi.components.norm());
      BOOST_TEST(difference(a.attitude().value, b.attitude().value) <= (k + 4) * n * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(knows_no_units) {
  std::mt19937 random(testing::seed + 5);
  auto const [inertia, pi] = random_case(random, 5);
  FastNaturalChart scheme(inertia, 0.125);
  auto body = scheme.release(pi);
  for (int k = 0; k < 50; ++k) scheme.step_with_attitude(body);
  for (int mass : {-156, 156})
    for (int time : {-30, 30}) {
      FastNaturalChart scaled(
          inertia_from_lambda<n_, double>(VectorXd(inertia.lambda * std::ldexp(1.0, mass))),
          std::ldexp(0.125, time));
      auto same = scaled.release(momentum(pi.group, VectorXd(pi.components * std::ldexp(1.0, mass - time))));
      for (int k = 0; k < 50; ++k) scaled.step_with_attitude(same);
      BOOST_TEST((same.momentum().components * std::ldexp(1.0, time - mass) == body.momentum().components));
      BOOST_TEST((same.attitude().value == body.attitude().value));
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_is_broken_off_and_taken_up_has_the_bits_of_an_unbroken_one) {
  std::mt19937 random(testing::seed + 6);
  for (int n : {3, 4, 8, 33})
    for (bool with_attitude : {false, true}) {
      auto const [inertia, pi] = random_case(random, n);
      double const h = n == 3 ? 2.5 : 0.05;
      FastNaturalChart scheme(inertia, h), again(inertia, h);
      auto const take = [&](FastNaturalChart& with, ChartedBody& body, int count) {
        for (int k = 0; k < count; ++k) with_attitude ? with.step_with_attitude(body) : with.step(body);
      };
      auto unbroken = scheme.release(pi), first = unbroken;
      take(scheme, unbroken, 100);
      take(scheme, first, 37);
      testing::Bytes bytes;
      first.remember(bytes);
      auto second = again.release(momentum(inertia.group, VectorXd(-0.5 * pi.components)));
      take(again, second, n == 8 ? 5 : 0);
      second.remember(bytes.rewind());
      BOOST_TEST(bytes.at_end());
      take(again, second, 63);
      BOOST_TEST((second.momentum().components == unbroken.momentum().components));
      BOOST_TEST((second.attitude().value == unbroken.attitude().value));
      BOOST_TEST(second.steps() == 100);
    }
}

BOOST_AUTO_TEST_CASE(steps_up_to_the_largest_and_no_further) {
  std::mt19937 random(testing::seed + 7);
  for (int n : {2, 3, 4, 8, 20}) {
    BOOST_TEST_CONTEXT("n = " << n) {
      auto const [inertia, pi] = random_case(random, n);
      double largest = 0;
      for (double too_long : {7.0, 1e5}) {
        FastNaturalChart scheme(inertia, too_long);
        auto body = scheme.release(pi);
        BOOST_CHECK_EXCEPTION(scheme.step_with_attitude(body), StepTooLong, [&](StepTooLong const& e) {
          largest = e.largest_step;
          return e.measured == too_long;
        });
        // The body is as it was.
        BOOST_TEST((body.momentum().components == pi.components));
        BOOST_TEST(body.steps() == 0);
        // The angle of the fastest plane is then about half a turn, where the chart ends.
        BOOST_TEST(largest > 2);
        BOOST_TEST(largest < 5);
        FastNaturalChart would_do(inertia, largest),
            a_little_more(inertia, largest * (n <= 16 ? 1.001 : 1.06));
        BOOST_CHECK_NO_THROW(would_do.step_with_attitude(body));
        auto refused = a_little_more.release(pi);
        CHECK_REFUSED(a_little_more.step(refused), StepTooLong);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(about_a_principal_plane_half_a_turn_is_the_limit) {
  auto const inertia = inertia_from_lambda<n_, double>(VectorXd::LinSpaced(4, 1, 2));
  VectorXd spin = VectorXd::Zero(6);
  spin[2] = 0.7;
  auto const pi = body_momentum(inertia, velocity(inertia.group, spin));
  FastNaturalChart too_long(inertia, 5);
  auto body = too_long.release(pi);
  BOOST_CHECK_EXCEPTION(too_long.step(body), StepTooLong, [&](StepTooLong const& e) {
    return std::abs(e.largest_step * 0.7 / std::numbers::pi - 1) < 1e-5;
  });
}

BOOST_AUTO_TEST_CASE(rests_where_nothing_turns_and_where_all_moments_are_equal) {
  auto const ball = inertia_from_lambda<n_, double>(VectorXd::Constant(5, 1.5));
  FastNaturalChart scheme(ball, 0.1);
  auto still = scheme.release(momentum(ball.group, VectorXd::Zero(10)));
  for (int k = 0; k < 20; ++k) scheme.step_with_attitude(still);
  BOOST_TEST(still.momentum().components.norm() == 0);
  BOOST_TEST((still.attitude().value == MatrixXd::Identity(5, 5)));

  std::mt19937 random(testing::seed + 8);
  auto const pi = random_case(random, 5).pi;
  auto body = scheme.release(pi);
  for (int k = 0; k < 100; ++k) scheme.step_with_attitude(body);
  BOOST_TEST((body.momentum() - pi).components.norm() <= 100 * 5 * eps * pi.components.norm());
  // It turns with constant velocity.
  MatrixXd const exact = matrix_exponential(MatrixXd(hat(pi) * (10 / 3.0)));
  BOOST_TEST(difference(body.attitude().value, exact) <= 100 * 5 * eps);
}

BOOST_AUTO_TEST_CASE(refuses_what_it_cannot_use) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  std::mt19937 random(testing::seed + 9);
  auto const [inertia, pi] = random_case(random, 5);
  CHECK_REFUSED(FastNaturalChart(inertia, 0.0), OutsideDomain);
  CHECK_REFUSED(FastNaturalChart(inertia, nan), NotFinite);
  FastNaturalChart scheme(inertia, 0.1);
  auto broken = pi;
  broken.components[3] = nan;
  CHECK_REFUSED(scheme.release(broken), NotFinite);
  CHECK_REFUSED(scheme.release(momentum(pi.group, VectorXd::Zero(9))), OutsideDomain);
  auto g = identity<double>(inertia.group);
  g.value(0, 0) = -1;
  CHECK_REFUSED(scheme.release(g, pi), OutsideDomain);
  auto const small = random_case(random, 4);
  auto body = FastNaturalChart(small.inertia, 0.1).release(small.pi);
  CHECK_REFUSED(scheme.step(body), OutsideDomain);
  auto fast = scheme.release(momentum(pi.group, VectorXd(pi.components * 1e200)));
  CHECK_REFUSED(scheme.step(fast), Error);
}

BOOST_AUTO_TEST_SUITE_END()
