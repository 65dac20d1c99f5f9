// A million steps of heavy tops: what the scheme conserves changes by rounding alone, and like a random walk.
// A benchmark to nine places.
//
// A step rounds momentum and vertical a few times, each time by at most half an epsilon of their size. What
// walks at random is off by a few eps sqrt(steps) then; the bound has a hundredfold of room, and a drift in
// proportion to the steps would be ten times beyond it.
#include <boost/test/unit_test.hpp>

#include <sstream>

#include "euler_poisson.hpp"
#include "random_bodies.hpp"
#include "witness/number.hpp"
#include "witness/taylor_reference.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

namespace {

constexpr long steps = 1000000;
double const bound = 100 * std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(steps));

/// The largest change of one quantity, and how it grows.
struct Walk {
  double start, size, largest = 0;
  std::vector<double> count{}, change{};

  void look(long k, double value, bool record) {
    largest = std::max(largest, std::abs(value - start) / size);
    if (record) count.push_back(static_cast<double>(k)), change.push_back(std::max(largest, 1e-16));
  }
  void judge(std::string const& name) const {
    double const growth = testing::fit_order(count, change).slope;
    BOOST_TEST_MESSAGE(name << " after 1e6 steps: " << largest << ", growth exponent " << growth);
    BOOST_TEST(largest <= bound);
    BOOST_TEST(growth < 0.85);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(heavy_top_long_run)

BOOST_AUTO_TEST_CASE(a_symmetric_top_keeps_both_casimirs_and_the_momentum_about_its_axis) {
  auto const top =
      heavy_top<double>(1, inertia_from_moments(0.6, 0.6, 1.0), Vector3d(0, 0, 0.3), Vector3d(0, 0, -9.81));
  HeavyTopScheme<> const scheme(top, 0.01);
  auto state =
      release(top, exp(velocity(SO<3>{}, Vector3d(0.5, 0, 0))), velocity(SO<3>{}, Vector3d(0.3, 0.4, 6)));
  auto const about_vertical = [&] { return state.momentum.components.dot(state.vector); };
  double const size = state.momentum.components.norm(), energy = top.energy(state);
  Walk vertical{about_vertical(), size}, length{state.vector.norm(), 1},
      axis{state.momentum.components[2], size};
  double lost = 0;
  for (long k = 1, next = 100; k <= steps; ++k) {
    scheme.advance(state);
    if (k % 1000 && k != next) continue;
    vertical.look(k, about_vertical(), k == next), length.look(k, state.vector.norm(), k == next),
        axis.look(k, state.momentum.components[2], k == next);
    lost = std::max(lost, std::abs(top.energy(state) / energy - 1));
    if (k == next) next = next * 3 / 2;
  }
  vertical.judge("symmetric top, momentum about the vertical");
  length.judge("symmetric top, length of the vertical");
  axis.judge("symmetric top, momentum about its axis");
  BOOST_TEST_MESSAGE("energy off by at most " << lost);
  BOOST_TEST(lost > 1e-6);  // conserved by no theorem
}

BOOST_AUTO_TEST_CASE(a_top_without_symmetry_keeps_both_casimirs_and_its_attitude_the_vertical) {
  auto const top = heavy_top<double>(1.5, inertia_from_moments(0.7, 0.9, 1.2), Vector3d(0.1, -0.15, 0.2),
                                     Vector3d(1, 2, -9));
  HeavyTopScheme<> const scheme(top, 0.02);
  auto g = exp(velocity(SO<3>{}, Vector3d(0.5, 0.2, -0.4)));
  auto state = release(top, g, velocity(SO<3>{}, Vector3d(1.5, -1, 2)));
  auto const about_vertical = [&] { return state.momentum.components.dot(state.vector); };
  auto const in_space = [&] { return (g.value * state.momentum.components).dot(top.vertical()); };
  double const size = state.momentum.components.norm();
  Walk vertical{about_vertical(), size}, length{state.vector.norm(), 1}, space{in_space(), size}, seen{0, 1};
  for (long k = 1, next = 100; k <= steps; ++k) {
    scheme.advance(state, g);
    if (k % 1000 && k != next) continue;
    vertical.look(k, about_vertical(), k == next), length.look(k, state.vector.norm(), k == next),
        space.look(k, in_space(), k == next);
    seen.look(k, (g.value * state.vector - top.vertical()).norm(), k == next);
    if (k == next) next = next * 3 / 2;
  }
  vertical.judge("top without symmetry, momentum about the vertical");
  length.judge("top without symmetry, length of the vertical");
  space.judge("top without symmetry, momentum about the vertical by way of the attitude");
  seen.judge("top without symmetry, the vertical by way of the attitude");
}

BOOST_AUTO_TEST_CASE(the_benchmark_of_bruls_and_cardona_comes_out_to_nine_places) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  // 50 digits by power series.
  auto const [exact_top, exact_spin] = bruls_cardona_top<Number>();
  testing::EulerPoisson<Number> const equations{exact_top.inertia.moments, exact_top.lever()};
  auto const start = testing::together(release(exact_top, identity<Number>(SO<3>{}), exact_spin));
  Matrix<Number, 6, 1> const end = taylor_reference<Number>(equations, start, Number(1));
  Vector3d const truth =
      end.head<3>().cwiseQuotient(exact_top.inertia.moments).unaryExpr([](Number const& x) {
        return to_double(x);
      });

  auto const [top, spin] = bruls_cardona_top<double>();
  BOOST_TEST(top.inertia.lambda[1] == 15);
  for (auto const& [order, count] : {std::pair(4, 50000), std::pair(8, 1000)}) {
    HeavyTopScheme<> const scheme(top, 1.0 / count, order);
    auto state = release(top, identity<double>(SO<3>{}), spin);
    for (int k = 0; k < count; ++k) scheme.advance(state);
    Vector3d const omega = body_velocity(top.inertia, state.momentum).coordinates;
    std::ostringstream digits;
    digits.precision(12);
    digits << omega[0] << ", " << omega[1] << ", " << omega[2] << " (50 digits: " << truth[0] << ", "
           << truth[1] << ", " << truth[2] << ")";
    BOOST_TEST_MESSAGE("Brüls-Cardona top, order "
                       << order << ", angular velocity after 1 s: " << digits.str() << ", apart by "
                       << (omega - truth).norm());
    BOOST_TEST((omega - truth).norm() <= 1e-9);
  }
}

BOOST_AUTO_TEST_SUITE_END()
