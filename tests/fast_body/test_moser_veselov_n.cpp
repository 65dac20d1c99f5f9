// The step on SO(n) by squares: held to the general solver, to the equations themselves, and to what it must
// refuse.
#include <boost/test/unit_test.hpp>

#include <Eigen/LU>
#include "../rigid_body/random_bodies.hpp"

#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int n_ = Eigen::Dynamic;
constexpr double eps = std::numeric_limits<double>::epsilon();

struct Case {
  Inertia<n_> inertia;
  Momentum<SO<n_>, double> pi;
};
/// A random body whose velocity, as a matrix, has the norm 1.
Case random_case(std::mt19937& random, int n) {
  auto const [inertia, spin] = testing::random_body<n_>(random, n);
  MatrixXd const xi = inertia.group.hat(spin.coordinates);
  double const norm = std::sqrt(largest_eigenvalue(xi.transpose() * xi));
  return {inertia, body_momentum(inertia, spin / norm)};
}
Element<SO<n_>, double> random_attitude(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto g = identity<double>(SO<n_>{n});
  for (int k = 0; k < 2 * n; ++k) {
    int const i = static_cast<int>(random() % static_cast<unsigned>(n)),
              j = (i + 1 + static_cast<int>(random() % static_cast<unsigned>(n - 1))) % n;
    double const angle = 3 * uniform(random), c = std::cos(angle), s = std::sin(angle);
    VectorXd const a = g.value.col(i), b = g.value.col(j);
    g.value.col(i) = c * a + s * b, g.value.col(j) = c * b - s * a;
  }
  return restore(restore(g));
}
double difference(MatrixXd const& a, MatrixXd const& b) { return (a - b).norm(); }
double difference(Momentum<SO<n_>, double> const& a, Momentum<SO<n_>, double> const& b) {
  return (a.components - b.components).norm();
}
double orthogonality(MatrixXd const& f) {
  return (f * f.transpose() - MatrixXd::Identity(f.rows(), f.cols())).norm();
}

/// By how much two solvers may differ in f, in the norm of Frobenius. The general one leaves 4 roundings of
/// the largest angle in each of n(n-1) entries, and restores f to the rounding of its entries, which adds
/// products over n: together 8 n roundings; sweeps leave less. `condition` is how much the equation makes of
/// that.
double solver_rounding(int n, double condition = 1) { return 8 * n * eps * condition; }

double farthest = 0;  ///< largest difference seen of two relative motions, over the bound

/// One step from the state of `body` by both solvers.
template <class Scheme>
void agrees_for_a_step(Scheme const& scheme, RotatingBody& body, double condition = 1) {
  MoserVeselov<n_> const general(scheme.inertia(), scheme.step());
  auto const pi = body.momentum();
  auto const g = body.attitude();
  auto const f = general.relative_motion(pi).value;
  scheme.step_with_attitude(body);
  double const bound = solver_rounding(body.size(), condition);
  double const size = pi.components.norm();
  double const apart = difference(scheme.last_relative_motion(body).value, f.value);
  farthest = std::max(farthest, apart / bound);
  BOOST_TEST(apart <= bound);
  // M1 = f M0 f^T moves by twice the change of f; so does, once, the attitude.
  BOOST_TEST(difference(body.momentum(), general.transport(f, pi)) <= 2 * bound * size);
  BOOST_TEST(difference(body.attitude().value, general.reconstruct(g, f).value) <= 2 * bound);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fast_moser_veselov)

BOOST_AUTO_TEST_CASE(is_the_general_step) {
  std::mt19937 random(testing::seed);
  for (int n : {2, 3, 4, 5, 6, 7, 8, 9, 12, 16, 33})
    for (double h : {0.01, -0.01, 0.1, 0.4}) {
      BOOST_TEST_CONTEXT("n = " << n << ", h = " << h) {
        auto const [inertia, pi] = random_case(random, n);
        FastMoserVeselov const scheme(inertia, h);
        auto body = scheme.release(random_attitude(random, n), pi);
        // At rest in memory, while it fills, and when it is full.
        for (int k = 0; k < (n > 16 ? 2 : 25); ++k) agrees_for_a_step(scheme, body);
        BOOST_TEST(body.steps() == (n > 16 ? 2 : 25));
      }
    }
  BOOST_TEST_MESSAGE(
      "step by squares against the general solver, n = 2 to 33: largest difference of f over its bound "
      << farthest);
}

BOOST_AUTO_TEST_CASE(a_lambda_of_zero_or_less_is_no_obstacle) {
  std::mt19937 random(testing::seed + 1);
  for (int n : {3, 4, 6, 8})
    for (double smallest : {1e-9, 0.0, -0.2}) {
      BOOST_TEST_CONTEXT("n = " << n << ", Lambda_1 = " << smallest) {
        auto body_of = random_case(random, n);
        VectorXd lambda = body_of.inertia.lambda;
        lambda[0] = smallest;
        auto const inertia = inertia_from_lambda<n_, double>(lambda);
        for (double h : {0.05, 0.15, 0.25}) {
          FastMoserVeselov const scheme(inertia, h);
          auto body = scheme.release(random_attitude(random, n), body_of.pi);
          for (int k = 0; k < 25; ++k) agrees_for_a_step(scheme, body);
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(solves_the_equations_themselves) {
  std::mt19937 random(testing::seed + 2);
  for (int n : {3, 5, 8, 11, 16, 20, 40}) {
    BOOST_TEST_CONTEXT("n = " << n) {
      auto const [inertia, pi] = random_case(random, n);
      double const h = 0.1;
      MatrixXd const lambda = inertia.lambda.asDiagonal();
      FastMoserVeselov const scheme(inertia, h);
      auto body = scheme.release(random_attitude(random, n), pi);
      for (int k = 0; k < 60; ++k) {
        MatrixXd const m0 = inertia.group.hat(body.momentum().components), g0 = body.attitude().value;
        scheme.step_with_attitude(body);
        MatrixXd const f = scheme.last_relative_motion(body).value,
                       m1 = inertia.group.hat(body.momentum().components);
        // f has entries near 1 on the diagonal: a rounding each, and one of a sum of n products.
        BOOST_TEST(orthogonality(f) <= 4 * std::sqrt(n) * eps);
        BOOST_TEST(difference(f.transpose() * lambda - lambda * f, h * m0) <= 4 * n * eps * lambda.norm());
        BOOST_TEST(difference(lambda * f.transpose() - f * lambda, h * m1) <= 4 * n * eps * lambda.norm());
        BOOST_TEST(difference(f * m0 * f.transpose(), m1) <= 4 * n * eps * m0.norm());
        BOOST_TEST(difference(body.attitude().value * f, g0) <= 4 * n * eps);
      }
      BOOST_TEST(body.squares() <= 5);
    }
  }
}

BOOST_AUTO_TEST_CASE(momentum_alone_takes_the_same_steps) {
  std::mt19937 random(testing::seed + 3);
  for (int n : {3, 4, 7, 16, 21})
    for (Sweeps sweeps : {Sweeps::to_rounding, Sweeps::beyond_rounding}) {
      auto const [inertia, pi] = random_case(random, n);
      FastMoserVeselov const scheme(inertia, 0.05, sweeps);
      auto alone = scheme.release(pi), whole = alone;
      for (int k = 0; k < 300; ++k) scheme.step(alone), scheme.step_with_attitude(whole);
      BOOST_TEST((alone.momentum().components == whole.momentum().components));
      BOOST_TEST((alone.momentum_remainder().components == whole.momentum_remainder().components));
      BOOST_TEST((alone.attitude().value == MatrixXd::Identity(n, n)));
    }
}

BOOST_AUTO_TEST_CASE(plain_copy_is_the_fast_copy) {
  if (best_machine() == Machine::plain) return;
  std::mt19937 random(testing::seed + 4);
  for (int n : {3, 4, 6, 8, 10, 16, 30}) {
    auto const [inertia, pi] = random_case(random, n);
    FastMoserVeselov const fast(inertia, 0.1, Sweeps::to_rounding, Machine::avx2),
        plain(inertia, 0.1, Sweeps::to_rounding, Machine::plain);
    auto a = fast.release(pi);
    for (int k = 0; k < 40; ++k) {
      auto b = plain.release(a.attitude(), a.momentum());
      double const size = a.momentum().components.norm();
      fast.step_with_attitude(a), plain.step_with_attitude(b);
      // They differ by whether a product is rounded before it is added.
      BOOST_TEST(difference(a.momentum(), b.momentum()) <= n * eps * size);
      BOOST_TEST(difference(a.attitude().value, b.attitude().value) <= n * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(keeps_the_spectrum_of_moser_and_veselov) {
  std::mt19937 random(testing::seed + 5);
  for (int n : {3, 4, 5, 8}) {
    auto const [inertia, pi] = random_case(random, n);
    double const h = 0.1;
    MatrixXd const squared = inertia.lambda.cwiseAbs2().asDiagonal();
    FastMoserVeselov const scheme(inertia, h, Sweeps::beyond_rounding);
    auto body = scheme.release(random_attitude(random, n), pi);
    auto const spatial = body.spatial_momentum();
    // h M - z - s Lambda^2 for some z and s: the integrals are the coefficients of its determinant.
    auto const determinants = [&](VectorXd const& components) {
      std::vector<double> values;
      for (double z : {0.5, 1.5})
        for (double s : {0.3, 1.0})
          values.push_back(
              (h * MatrixXd(inertia.group.hat(components)) - z * MatrixXd::Identity(n, n) - s * squared)
                  .determinant());
      return values;
    };
    auto const before = determinants(body.momentum().components);
    long const steps = 2000;
    double turned = 0;
    for (long k = 0; k < steps; ++k) {
      scheme.step_with_attitude(body);
      turned = std::max(turned, difference(body.momentum(), pi) / pi.components.norm());
    }
    auto const after = determinants(body.momentum().components);
    // Were all roundings of e, h eps each, to pull the same way; and n roundings of the determinant.
    double const bound = n * eps * (h * steps + n);
    for (std::size_t a = 0; a < before.size(); ++a) BOOST_TEST(std::abs(after[a] / before[a] - 1) <= bound);
    BOOST_TEST(difference(body.spatial_momentum(), spatial) <= bound * spatial.components.norm());
    BOOST_TEST(orthogonality(MatrixXd(body.attitude().value)) <= bound);
    BOOST_TEST(turned > 0.1);  // it did move
    // The control: a change of one component of the momentum by 1e-6 shows.
    VectorXd wrong = body.momentum().components;
    wrong[0] *= 1 + 1e-6, wrong[1] *= 1 - 2e-6;
    auto const seen = determinants(wrong);
    BOOST_TEST(std::abs(seen[0] / before[0] - 1) > 100 * bound);
  }
}

BOOST_AUTO_TEST_CASE(goes_back_where_it_came_from) {
  std::mt19937 random(testing::seed + 6);
  for (int n : {3, 8, 13}) {
    auto const [inertia, pi] = random_case(random, n);
    FastMoserVeselov const there(inertia, 0.1), back(inertia, -0.1);
    auto const g = random_attitude(random, n);
    auto body = there.release(g, pi);
    for (int k = 0; k < 100; ++k) there.step_with_attitude(body);
    BOOST_TEST(difference(body.momentum(), pi) > 0.1 * pi.components.norm());
    for (int k = 0; k < 100; ++k) back.step_with_attitude(body);
    // An error grows with the distance of nearby motions, which over ten radians is some tens.
    double const bound = 200 * n * eps * 30;
    BOOST_TEST(difference(body.momentum(), pi) <= bound * pi.components.norm());
    BOOST_TEST(difference(body.attitude().value, g.value) <= bound);
  }
}

BOOST_AUTO_TEST_CASE(knows_no_units) {
  std::mt19937 random(testing::seed + 7);
  for (int n : {3, 5, 9}) {
    auto const [inertia, pi] = random_case(random, n);
    FastMoserVeselov const scheme(inertia, 0.125);
    auto body = scheme.release(pi);
    for (int k = 0; k < 50; ++k) scheme.step_with_attitude(body);
    // Powers of two near 1e-47 and 1e47 in mass x length^2, and of 1e-9 and 1e9 in time: the same bits.
    for (int mass : {-156, 156})
      for (int time : {-30, 30}) {
        auto const other = inertia_from_lambda<n_, double>(VectorXd(inertia.lambda * std::ldexp(1.0, mass)));
        FastMoserVeselov const scaled(other, std::ldexp(0.125, time));
        auto same =
            scaled.release(momentum(pi.group, VectorXd(pi.components * std::ldexp(1.0, mass - time))));
        for (int k = 0; k < 50; ++k) scaled.step_with_attitude(same);
        BOOST_TEST((same.momentum().components * std::ldexp(1.0, time - mass) == body.momentum().components));
        BOOST_TEST((same.attitude().value == body.attitude().value));
      }
  }
}

BOOST_AUTO_TEST_CASE(steps_up_to_the_largest_and_no_further) {
  std::mt19937 random(testing::seed + 8);
  for (int n : {3, 4, 5, 6, 7, 8, 9, 16, 33}) {
    BOOST_TEST_CONTEXT("n = " << n) {
      auto const [inertia, pi] = random_case(random, n);
      double const largest = largest_step(inertia, pi);
      // Next to the limit the equation has the condition of a root of a square. Beyond Newton's reach, where
      // mixing still gets: nine tenths of the way.
      double const below = n <= 24 ? 0.999 : 0.9;
      FastMoserVeselov const long_step(inertia, below * largest), too_long(inertia, 1.001 * largest);
      auto body = long_step.release(pi);
      MatrixXd const m0 = inertia.group.hat(pi.components);
      long_step.step_with_attitude(body);
      MatrixXd const f = long_step.last_relative_motion(body).value;
      BOOST_TEST(orthogonality(f) <= 1e3 * n * eps);
      BOOST_TEST(difference(f * m0 * f.transpose(), inertia.group.hat(body.momentum().components)) <=
                 1e3 * n * eps * m0.norm());
      if (n <= 24) long_step.step_with_attitude(body);

      auto refused = too_long.release(pi);
      BOOST_CHECK_EXCEPTION(too_long.step_with_attitude(refused), StepTooLong, [&](StepTooLong const& e) {
        return std::abs(e.largest_step / largest - 1) < 1e-6;
      });
      CHECK_REFUSED(too_long.step(refused), StepTooLong);
      // The body is as it was.
      BOOST_TEST((refused.momentum().components == pi.components));
      BOOST_TEST(refused.steps() == 0);
      FastMoserVeselov const short_step(inertia, 0.01);
      agrees_for_a_step(short_step, refused);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_largest_step_by_lanczos_is_the_largest_step) {
  std::mt19937 random(testing::seed + 9);
  for (int n : {3, 4, 8, 20, 40}) {
    auto [inertia, pi] = random_case(random, n);
    BOOST_TEST(std::abs(largest_step_n(inertia, pi) / largest_step(inertia, pi) - 1) < 1e-6);
    VectorXd lambda = inertia.lambda;
    lambda[1] = 1e-3;
    auto const slender = inertia_from_lambda<n_, double>(lambda);
    BOOST_TEST(std::abs(largest_step_n(slender, pi) / largest_step(slender, pi) - 1) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(one_body_may_change_its_step) {
  std::mt19937 random(testing::seed + 10);
  auto const [inertia, pi] = random_case(random, 6);
  FastMoserVeselov const one(inertia, 0.1), other(inertia, 0.03);
  auto body = one.release(random_attitude(random, 6), pi);
  for (int k = 0; k < 20; ++k) {
    agrees_for_a_step(k % 3 ? one : other, body);
    auto copy = body;
    one.step_with_attitude(copy);
    BOOST_TEST(copy.steps() == body.steps() + 1);
  }
}

BOOST_AUTO_TEST_CASE(rests_where_nothing_turns) {
  auto const inertia = inertia_from_lambda<n_, double>(VectorXd::LinSpaced(5, 1, 2));
  FastMoserVeselov const scheme(inertia, 0.1);
  auto body = scheme.release(momentum(inertia.group, VectorXd::Zero(10)));
  for (int k = 0; k < 20; ++k) scheme.step_with_attitude(body);
  BOOST_TEST(body.momentum().components.norm() == 0);
  BOOST_TEST((body.attitude().value == MatrixXd::Identity(5, 5)));
}

BOOST_AUTO_TEST_CASE(refuses_what_it_cannot_use) {
  double const nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  std::mt19937 random(testing::seed + 11);
  auto const [inertia, pi] = random_case(random, 5);
  CHECK_REFUSED(FastMoserVeselov(inertia, 0.0), OutsideDomain);
  CHECK_REFUSED(FastMoserVeselov(inertia, nan), NotFinite);
  CHECK_REFUSED(FastMoserVeselov(inertia, infinite), NotFinite);
  CHECK_REFUSED(FastMoserVeselov(inertia, 1e-310), NotFinite);

  FastMoserVeselov const scheme(inertia, 0.1);
  auto broken = pi;
  broken.components[3] = nan;
  CHECK_REFUSED(scheme.release(broken), NotFinite);
  broken.components[3] = infinite;
  CHECK_REFUSED(scheme.release(broken), NotFinite);
  CHECK_REFUSED(scheme.release(momentum(pi.group, VectorXd::Zero(9))), OutsideDomain);

  auto g = random_attitude(random, 5);
  g.value.row(2) *= -1;
  BOOST_CHECK_EXCEPTION(scheme.release(g, pi), OutsideDomain,
                        [](OutsideDomain const& e) { return e.measured == -1; });
  // Its columns are at right angles, and its determinant is 1; they are not of length 1.
  auto stretched = random_attitude(random, 5);
  stretched.value.col(0) *= 2, stretched.value.col(1) /= 2;
  CHECK_REFUSED(scheme.release(stretched, pi), OutsideDomain);
  g.value.row(2) *= -1.001;
  CHECK_REFUSED(scheme.release(g, pi), OutsideDomain);
  g.value(0, 0) = nan;
  CHECK_REFUSED(scheme.release(g, pi), NotFinite);
  CHECK_REFUSED(scheme.release(random_attitude(random, 4), pi), OutsideDomain);

  auto const small = random_case(random, 4);
  auto body = FastMoserVeselov(small.inertia, 0.1).release(small.pi);
  CHECK_REFUSED(scheme.step(body), OutsideDomain);
  // Momenta whose step overflows are too long steps, not NaNs.
  auto fast = scheme.release(momentum(pi.group, VectorXd(pi.components * 1e200)));
  CHECK_REFUSED(scheme.step(fast), Error);
}

BOOST_AUTO_TEST_SUITE_END()
