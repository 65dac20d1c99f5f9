// What the solver of Moser and Veselov's equation asks of a relative motion, each against its definition: its
// determinant, the branch it is on, and how far a first guess is from the solution.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/moser_veselov.hpp"
#include "random_bodies.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <int n>
MoserVeselovEquation<n, double> equation_of(Inertia<n> const& inertia) {
  return {inertia.group, inertia.lambda, inertia.moments};
}
/// By expansion along the first row.
double determinant_by_rows(Eigen::MatrixXd const& a) {
  if (a.rows() == 0) return 1;
  double sum = 0;
  for (Eigen::Index j = 0; j < a.cols(); ++j) {
    Eigen::MatrixXd minor(a.rows() - 1, a.cols() - 1);
    for (Eigen::Index i = 1; i < a.rows(); ++i)
      for (Eigen::Index k = 0, to = 0; k < a.cols(); ++k)
        if (k != j) minor(i - 1, to++) = a(i, k);
    sum += (j % 2 ? -1 : 1) * a(0, j) * determinant_by_rows(minor);
  }
  return sum;
}
template <int n>
void determinants_are_sums_over_rows(std::mt19937& random) {
  for (int trial = 0; trial < 40; ++trial) {
    Element<SO<n>, double> f{{}, {}};
    // Small whole numbers, many of them zero, so that pivots are exchanged.
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) f.value(i, j) = trial % 2 ? random() % 3 - 1.0 : (random() % 19 - 9.0) / 4;
    double const expected = determinant_by_rows(f.value);
    BOOST_TEST(std::abs(MoserVeselovEquation<n, double>::determinant(f) - expected) <=
               256 * eps * std::pow(f.value.norm(), n));
  }
}
template <int n>
void the_branch_is_told_by_the_spectrum(std::mt19937& random, bool negative) {
  int there = 0, not_there = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto body = testing::random_body<n>(random);
    Matrix<double, n, 1> lambda = body.inertia.lambda;
    if (negative) lambda[trial % n] = -0.3;
    auto const inertia = inertia_from_lambda<n, double>(lambda);
    auto const f = exp((trial % 4 + 0.3) * body.spin);
    Matrix<double> const x = f.value.transpose() * inertia.lambda.asDiagonal();
    Vector<double> const real = real_parts_of_eigenvalues(x);
    // The least sum of two; next to zero neither answer is wrong.
    double const least = real[0] + real[1];
    if (std::abs(least) < 1e-3) continue;
    BOOST_TEST(equation_of<n>(inertia).on_branch_of_identity(f) == (least > 0));
    ++(least > 0 ? there : not_there);
  }
  BOOST_TEST((there > 5 && not_there > 5));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(moser_veselov_equation)

BOOST_AUTO_TEST_CASE(a_determinant_is_the_sum_over_rows) {
  std::mt19937 random(testing::seed);
  determinants_are_sums_over_rows<2>(random);
  determinants_are_sums_over_rows<3>(random);
  determinants_are_sums_over_rows<5>(random);
}

BOOST_AUTO_TEST_CASE(the_branch_of_the_identity_is_where_any_two_eigenvalues_have_a_sum_to_the_right) {
  std::mt19937 random(testing::seed + 1);
  the_branch_is_told_by_the_spectrum<3>(random, false);
  the_branch_is_told_by_the_spectrum<4>(random, false);
  the_branch_is_told_by_the_spectrum<3>(random, true);
  the_branch_is_told_by_the_spectrum<4>(random, true);
}

BOOST_AUTO_TEST_CASE(a_first_guess_is_right_to_second_order_and_a_long_one_is_cut_to_half_a_radian) {
  std::mt19937 random(testing::seed + 2);
  auto const [inertia, spin] = testing::random_body<4>(random);
  auto const pi = body_momentum(inertia, spin);
  auto const equation = equation_of<4>(inertia);
  for (double const h : {1e-2, 1e-3}) {
    auto const f = MoserVeselov<4>(inertia, h).relative_motion(pi).value;
    double const angle = h * spin.coordinates.norm();
    BOOST_TEST((equation.first_guess(h * pi.components).value - f.value).norm() <= angle * angle);
  }
  auto const far = equation.first_guess(100 * pi.components);
  double const angle = Vector<double>(log(far).coordinates).norm();
  // 1 + t + t^2/2 is a turn by t to third order.
  BOOST_TEST(std::abs(angle - 0.5) <= 0.125 / 2);
  BOOST_TEST((log(far).coordinates / angle + spin.coordinates / spin.coordinates.norm()).norm() <= 0.1);
}

BOOST_AUTO_TEST_CASE(a_branch_that_ends_is_followed_to_its_end) {
  // About a principal plane of a body with a negative Lambda: h M = (Lambda_i + Lambda_j) sin of the angle.
  auto const inertia = inertia_from_lambda<4, double>(Vector<double, 4>(-0.3, 1, 1.5, 2));
  std::mt19937 random(testing::seed + 3);
  auto const pi = body_momentum(inertia, testing::random_body<4>(random).spin);
  double longest = 0;
  for (double const h : {50.0, -3.0}) try {
      MoserVeselov<4>(inertia, h).relative_motion(pi);
      BOOST_ERROR("accepted a step beyond the end of the branch");
    } catch (StepTooLong const& e) {
      BOOST_TEST(e.measured == std::abs(h));
      if (longest > 0) BOOST_TEST(std::abs(e.largest_step / longest - 1) <= 1e-6);
      longest = e.largest_step;
    }
  BOOST_CHECK_NO_THROW(MoserVeselov<4>(inertia, longest * (1 - 1e-6)).relative_motion(pi));
  CHECK_REFUSED(MoserVeselov<4>(inertia, longest * (1 + 1e-4)).relative_motion(pi), StepTooLong);
}

BOOST_AUTO_TEST_SUITE_END()
