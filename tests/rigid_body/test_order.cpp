// Order of both schemes against somebody else's solution, and the reference solution against itself.
#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "random_bodies.hpp"
#include "refused.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;

namespace {

// M' = [M, xi] with matrices, and g' = g xi: momentum and attitude in one vector.
template <int n>
actio::Vector<double> flow(Inertia<n> const& inertia, Momentum<SO<n>, double> const& pi, double duration) {
  using Matrix = actio::Matrix<double, n, n>;
  constexpr int d = SO<n>::dim;
  actio::Vector<double> y(d + n * n);
  y.head(d) = pi.components;
  as_matrix<n, n>(y.data() + d).setIdentity();
  auto const rate = [&](double, actio::Vector<double> const& state) {
    Coordinates<SO<n>, double> const m = state.head(d);
    Matrix const M = SO<n>::hat(m), xi = SO<n>::hat(m.cwiseQuotient(inertia.moments)),
                 g = as_matrix<n, n>(state.data() + d);
    actio::Vector<double> change(d + n * n);
    change.head(d) = SO<n>::vee((M * xi - xi * M).eval());
    as_matrix<n, n>(change.data() + d) = g * xi;
    return change;
  };
  return reference_solution(rate, y, 0, duration);
}

// Errors of momentum and attitude after two time units, at halved steps.
template <class Scheme, int n>
void has_order_two(Inertia<n> const& inertia, Velocity<SO<n>, double> const& spin) {
  auto const start = body_momentum(inertia, spin);
  double const duration = 2;
  actio::Vector<double> const truth = flow(inertia, start, duration);
  std::vector<double> steps, in_momentum, in_attitude;
  for (int count = 40; count <= 1280; count *= 2) {
    Scheme const scheme(inertia, duration / count);
    auto pi = start;
    auto g = identity<double>(SO<n>{});
    for (int k = 0; k < count; ++k) {
      auto const f = scheme.relative_motion(pi).value;
      pi = scheme.momentum_after(f);
      g = reconstruct_left(g, f);
    }
    steps.push_back(scheme.step());
    in_momentum.push_back((pi.components - truth.head(SO<n>::dim)).norm());
    in_attitude.push_back((g.value.reshaped() - truth.tail(n * n)).norm());
  }
  for (auto const* errors : {&in_momentum, &in_attitude}) {
    auto const fit = testing::fit_order(steps, *errors);
    BOOST_TEST_MESSAGE("n = " << n << ": order " << fit.slope << ", spread " << fit.spread << ", least error "
                              << errors->back());
    BOOST_TEST(std::abs(fit.slope - 2) < 0.05);
    BOOST_TEST(errors->back() > 1e-9);  // far above rounding and above the reference
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(order)

BOOST_AUTO_TEST_CASE(the_reference_solution_knows_sines_and_a_free_top) {
  auto const oscillator = [](double, actio::Vector<double, 2> const& y) {
    return actio::Vector<double, 2>(y[1], -y[0]);
  };
  actio::Vector<double, 2> const y = reference_solution(oscillator, actio::Vector<double, 2>(0, 1), 0, 10);
  BOOST_TEST(std::abs(y[0] - std::sin(10.0)) < 1e-13);
  BOOST_TEST(std::abs(y[1] - std::cos(10.0)) < 1e-13);
  auto const back = reference_solution(oscillator, y, 10, 0);
  BOOST_TEST(std::abs(back[0]) < 1e-13);
  // Small numbers are as good as large ones.
  actio::Vector<double, 2> const tiny =
      reference_solution(oscillator, actio::Vector<double, 2>(0, 1e-60), 0, 10);
  BOOST_TEST(std::abs(tiny[0] / 1e-60 - std::sin(10.0)) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_reference_solution_refuses_what_is_no_number) {
  auto const blow_up = [](double, actio::Matrix<double, 1, 1> const& y) {
    return actio::Matrix<double, 1, 1>(y * y[0]);
  };
  actio::Matrix<double, 1, 1> one, bad;
  one << 1;
  bad << std::nan("");
  CHECK_REFUSED(reference_solution(blow_up, one, 0, 2), Error);  // the solution 1/(1-t) ends at t = 1
  CHECK_REFUSED(reference_solution(blow_up, bad, 0, 1), NotFinite);
  CHECK_REFUSED(reference_solution(blow_up, one, 0, INFINITY), NotFinite);
}

BOOST_AUTO_TEST_CASE(moser_veselov_is_of_order_two) {
  std::mt19937 random(testing::seed);
  auto const three = testing::random_body<3>(random);
  has_order_two<MoserVeselov<3>>(three.inertia, three.spin);
  auto const four = testing::random_body<4>(random);
  has_order_two<MoserVeselov<4>>(four.inertia, four.spin);
  auto const five = testing::random_body<5>(random);
  has_order_two<MoserVeselov<5>>(five.inertia, five.spin);
}

BOOST_AUTO_TEST_CASE(natural_charts_are_of_order_two) {
  std::mt19937 random(testing::seed);
  auto const three = testing::random_body<3>(random);
  has_order_two<NaturalChartScheme<3>>(three.inertia, three.spin);
  auto const four = testing::random_body<4>(random);
  has_order_two<NaturalChartScheme<4>>(four.inertia, four.spin);
}

BOOST_AUTO_TEST_SUITE_END()
