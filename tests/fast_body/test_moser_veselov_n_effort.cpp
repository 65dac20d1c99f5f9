// What a step on SO(n) by squares costs: few squares at the start, one once enough steps are remembered; and
// the largest step where n is large, at the ends of what it is asked for.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"
#include "actio/fast_body/any_dimension/natural_chart_n.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

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
  double const norm = skew_spectrum(inertia.group.hat(spin.coordinates)).maxCoeff();
  return {inertia, body_momentum(inertia, spin / norm)};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(effort_on_so_n)

BOOST_AUTO_TEST_CASE(steps_that_remember_take_one_square) {
  std::mt19937 random(testing::seed + 20);
  for (int n : {3, 6, 10, 17, 97}) BOOST_TEST_CONTEXT("n = " << n) {
      auto const [inertia, pi] = random_case(random, n);
      FastMoserVeselov const scheme(inertia, 0.02);
      auto body = scheme.release(pi);
      BOOST_TEST((body.remembered() == 0 && body.steps() == 0));
      scheme.step(body);
      // Each square gains a factor of the angle of a step or so.
      BOOST_TEST((body.squares() > 2 && body.squares() <= 11));
      int many = 0;
      for (int k = 1; k < 40; ++k) {
        scheme.step(body);
        if (k >= 20) many += body.squares() > 1;
      }
      BOOST_TEST(many == 0);
      BOOST_TEST((body.remembered() > 2 && body.remembered() <= 16));
      // What was seen of the defect is below the rounding of f after one sweep more.
      BOOST_TEST(body.defect() <= 0.02 * n * 64 * eps);
    }
}

BOOST_AUTO_TEST_CASE(fewer_digits_take_fewer_squares) {
  std::mt19937 random(testing::seed + 21);
  for (int n : {3, 5, 9}) BOOST_TEST_CONTEXT("n = " << n) {
      auto const [inertia, pi] = random_case(random, n);
      auto const first_step = [&](Sweeps sweeps) {
        FastMoserVeselov const scheme(inertia, 0.3, sweeps);
        auto body = scheme.release(pi);
        scheme.step(body);
        auto const f = scheme.last_relative_motion(body).value;
        return std::tuple{body.squares(), body.defect(),
                          (f * f.transpose() - Eigen::MatrixXd::Identity(n, n)).norm()};
      };
      auto const [few, seen_early, left] = first_step(Sweeps::to_half_the_digits);
      auto const [enough, seen, little] = first_step(Sweeps::to_rounding);
      auto const [more, seen_last, least] = first_step(Sweeps::beyond_rounding);
      BOOST_TEST((few < enough && enough < more));
      BOOST_TEST((seen_early > seen && seen >= seen_last));
      // Half of the digits of the square, |ee^T| being at most n (0.3)^2 or so.
      BOOST_TEST((seen_early <= 1e-8 * n * 0.2 && left <= seen_early && left > 100 * eps));
      BOOST_TEST((little <= 4 * std::sqrt(n) * eps && least <= 4 * std::sqrt(n) * eps));
    }
}

BOOST_AUTO_TEST_CASE(bodies_whose_lambda_hardly_differ_and_bodies_whose_lambda_differ_much_are_solved_alike) {
  // The bound on the contraction of a sweep is made of ratios of Lambda; what is left is rounding for all.
  std::mt19937 random(testing::seed + 25);
  for (int n : {3, 5, 9})
    for (double const unlike : {0.0, 1e-9, 0.9999}) BOOST_TEST_CONTEXT("n = " << n << ", " << unlike) {
        Eigen::VectorXd lambda = Eigen::VectorXd::Ones(n);
        for (int i = 0; i < n; ++i) lambda[i] -= unlike * i / (n - 1);
        auto const inertia = inertia_from_lambda<n_, double>(lambda);
        auto const spin = testing::random_body<n_>(random, n).spin;
        auto const pi = body_momentum(inertia, spin / spin.coordinates.norm());
        for (double const h : {0.02, 0.3}) {
          FastMoserVeselov const scheme(inertia, h);
          auto body = scheme.release(pi);
          Eigen::MatrixXd const m0 = inertia.group.hat(pi.components), l = lambda.asDiagonal();
          scheme.step(body);
          Eigen::MatrixXd const f = scheme.last_relative_motion(body).value;
          BOOST_TEST((f * f.transpose() - Eigen::MatrixXd::Identity(n, n)).norm() <= 4 * std::sqrt(n) * eps);
          BOOST_TEST((f.transpose() * l - l * f - h * m0).norm() <= 4 * n * eps * l.norm());
        }
      }
}

BOOST_AUTO_TEST_CASE(charted_steps_that_remember_take_few_sweeps) {
  std::mt19937 random(testing::seed + 22);
  for (int n : {3, 6, 10}) BOOST_TEST_CONTEXT("n = " << n) {
      auto const [inertia, pi] = random_case(random, n);
      FastNaturalChart scheme(inertia, 0.02);
      auto body = scheme.release(pi);
      scheme.step(body);
      int const first = body.sweeps();
      int most = 0;
      for (int k = 1; k < 40; ++k) {
        scheme.step(body);
        if (k >= 20) most = std::max(most, body.sweeps());
      }
      BOOST_TEST_MESSAGE("natural chart, n = " << n << ": " << first << " sweeps at first, later at most "
                                               << most);
      BOOST_TEST(most <= 2);
      BOOST_TEST(most < first);
    }
}

BOOST_AUTO_TEST_CASE(the_largest_step_where_n_is_large_knows_rest_and_what_is_none) {
  std::mt19937 random(testing::seed + 23);
  auto const [inertia, pi] = random_case(random, 6);
  BOOST_TEST(std::isinf(largest_step_n(inertia, 0.0 * pi)));
  auto broken = pi;
  broken.components[4] = std::nan("");
  CHECK_REFUSED(largest_step_n(inertia, broken), NotFinite);
  Eigen::VectorXd lambda = inertia.lambda;
  lambda[2] = -0.25 * lambda.maxCoeff();
  auto const negative = inertia_from_lambda<n_, double>(lambda);
  for (auto const& longest : {std::function<double()>([&] { return largest_step_n(negative, pi); }),
                              std::function<double()>([&] { return largest_step(negative, pi); })})
    BOOST_CHECK_EXCEPTION(longest(), OutsideDomain, [](OutsideDomain const& e) {
      return std::abs(e.measured + 0.25) <= 4 * eps && e.bound == 0;
    });
  // About a principal plane h M_ij = Lambda_i + Lambda_j; and the largest step goes with the inertia, and
  // with one over the momentum.
  for (int a : {0, 7, 14}) {
    auto plane = 0.0 * pi;
    plane.components[a] = 3 * inertia.moments[a];
    BOOST_TEST(std::abs(3 * largest_step_n(inertia, plane) - 1) <= 1e-5);
  }
  double const one = largest_step_n(inertia, pi);
  auto const heavy = inertia_from_lambda<n_, double>(Eigen::VectorXd(1e30 * inertia.lambda));
  BOOST_TEST(std::abs(largest_step_n(heavy, 1e30 * pi) / one - 1) <= 1e-5);
  BOOST_TEST(std::abs(largest_step_n(inertia, 1e-20 * pi) * 1e-20 / one - 1) <= 1e-5);
  // A planar body, one of whose Lambda is zero.
  lambda[2] = 0;
  auto const planar = inertia_from_lambda<n_, double>(lambda);
  BOOST_TEST(std::abs(largest_step_n(planar, pi) / largest_step(planar, pi) - 1) <= 1e-5);
}

BOOST_AUTO_TEST_CASE(the_largest_eigenvalue_of_a_tridiagonal_matrix_is_that_of_the_whole) {
  std::mt19937 random(testing::seed + 24);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n : {1, 2, 3, 7, 12})
    for (double const shift : {0.0, 2.0, 40.0}) {
      std::vector<double> diagonal(static_cast<std::size_t>(n)), beside(static_cast<std::size_t>(n - 1));
      Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n, n);
      for (int k = 0; k < n; ++k)
        whole(k, k) = diagonal[static_cast<std::size_t>(k)] = shift + uniform(random);
      for (int k = 0; k + 1 < n; ++k)
        whole(k, k + 1) = whole(k + 1, k) = beside[static_cast<std::size_t>(k)] = 3 * uniform(random);
      double const expected = symmetric_eigen(whole).values[n - 1];
      if (expected > 0)
        BOOST_TEST(std::abs(bodies::detail::largest_of_tridiagonal(diagonal, beside) - expected) <=
                   16 * n * eps * (1 + shift + 6));
    }
}

BOOST_AUTO_TEST_SUITE_END()
