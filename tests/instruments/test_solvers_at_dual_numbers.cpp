// The solvers of the library differentiated as they are, on bodies of any size and without reduction.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/instruments/discrete_spaces.hpp"
#include "actio/instruments/momentum_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/variational/momentum_map.hpp"
#include "small_maps.hpp"

using namespace actio;
using namespace actio::testing;
using Vector3d = actio::Vector<double, 3>;

namespace {
constexpr double h = 0.25;
}

BOOST_AUTO_TEST_CASE(the_unreduced_step_is_symplectic_and_a_step_straight_on_is_not) {
  DiagonalBody<SO<3>> const body{Vector3d(1, 2, 4)};
  auto const top = [&](auto const& g0, auto const& g1) {  // with a weight
    using S = typename std::decay_t<decltype(g0)>::Scalar;
    return S(chart_lagrangian(body, h)(relative_motion_left(g0, g1)) -
             (g0.value(2, 2) + g1.value(2, 2)) * ratio<S>(1, 8));
  };
  auto const g0 = exp(velocity(SO<3>{}, Vector3d(0.3, -0.8, 0.5)));
  PairArrow<SO<3>, double> const x{g0, g0 * exp(velocity(SO<3>{}, Vector3d(0.2, -0.1, 0.15)))};
  auto const flow = [&](auto const& y) {
    return std::decay_t<decltype(y)>{y.second, step_euler_lagrange(top, y.first, y.second).value};
  };
  auto const straight_on = [](auto const& y) {
    return std::decay_t<decltype(y)>{y.second, y.second * inverse(y.first) * y.second};
  };
  PairsOfConfigurations const space{top};
  BOOST_TEST(symplectic_defect(space, flow, x) < 1000 * eps);
  BOOST_TEST(poisson_defect(space, flow, x) < 1000 * eps);
  BOOST_TEST(symplectic_defect(space, straight_on, x) > 1e-3);
  // Of the turns of space, the weight leaves those about the vertical.
  auto const about = [](int axis) { return left_translation(basis_velocity<double>(SO<3>{}, axis)); };
  BOOST_TEST(momentum_defect(space, flow, x, about(2)) < 1000 * eps);
  BOOST_TEST(momentum_defect(space, flow, x, about(0)) > 1e-3);
}

BOOST_AUTO_TEST_CASE(molecules_and_stations_have_the_same_tangent) {
  for (double const unit : {1.0, 0x1p-156, 0x1p+40}) {
    DiagonalBody<SO<3>> const body{Vector3d(1, 2, 4) * unit};
    auto const pi = momentum(SO<3>{}, Vector3d(Vector3d(0.75, -1.25, 0.5) * unit));
    auto const l = chart_lagrangian(body, h);
    auto const by_solver = [&](auto const& pi) {
      auto const start = exp(-typename std::decay_t<decltype(pi)>::Scalar(h) * body.velocity(pi));
      return lie_poisson_update_left(relative_motion_from_momentum_left(l, pi, start).value, pi);
    };
    BOOST_TEST(poisson_defect(LiePoissonMinus{}, by_solver, pi) < 1000 * eps);
    BOOST_TEST(poisson_defect(LiePoissonPlus{}, by_solver, pi) < 1000 * eps);  // the sign of both brackets
  }
}
