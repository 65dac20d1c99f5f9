// The natural-chart scheme on SO(n), n at run time, held to the generic implementation.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "chart_cases.hpp"

using namespace actio;
using namespace actio::bodies;
using actio::testing::difference, actio::testing::random_case;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Steps of one body, each held to the generic implementation from the same momentum.
template <int n>
void agrees_with_the_general_way(std::mt19937& random, double h) {
  auto const [inertia, pi] = random_case(random, n);
  NaturalChartScheme<n> const general(
      inertia_from_lambda<n, double>(Eigen::Matrix<double, n, 1>(inertia.lambda)), h);
  FastNaturalChart scheme(inertia, h);
  auto body = scheme.release(pi);
  for (int k = 0; k < 3; ++k) {
    Momentum<SO<n>, double> const before{{}, body.momentum().components};
    auto const f = general.relative_motion(before).value;
    scheme.step_with_attitude(body);
    // The generic implementation ends where each residual is within 16 roundings of its row, for n > 4 after
    // a logarithm with a few roundings more; n rows.
    double const bound = 16 * n * eps;
    BOOST_TEST(difference(scheme.last_relative_motion(body).value, f.value) <= bound);
    BOOST_TEST((general.momentum_after(f).components - body.momentum().components).norm() <=
               2 * bound * before.components.norm());
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(natural_chart_of_any_size)

BOOST_AUTO_TEST_CASE(is_the_general_way) {
  std::mt19937 random(testing::seed);
  // Up to steps of which some are beyond the reach of sweeps.
  for (double h : {0.01, 0.3, 1.0, 2.5}) {
    BOOST_TEST_CONTEXT("h = " << h) {
      agrees_with_the_general_way<3>(random, h);
      agrees_with_the_general_way<4>(random, h);
      agrees_with_the_general_way<5>(random, h);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
