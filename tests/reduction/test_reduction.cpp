// Discrete mechanics as a reader uses it: the two ways with their solvers on many groups, and refusals in
// place of wrong numbers.
#include <boost/test/unit_test.hpp>

#include "actio/groups/affine_line.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/spanned_group.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "group_from_basis.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

using testing::from_basis;

/// Kinetic energy of a body without any symmetry of its own.
struct KineticEnergy {
  Matrix<double> inertia;

  KineticEnergy(Draw& draw, int n) : inertia(Matrix<double>::Identity(n, n) * (n + 1)) {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j) inertia(i, j) = inertia(j, i) = inertia(i, j) + draw.number<double>();
  }
  auto operator()(auto const& xi) const {
    using T = typename std::decay_t<decltype(xi)>::Scalar;
    return T(xi.coordinates.dot(inertia.template cast<T>() * xi.coordinates) / T(2));
  }
};

auto const spinning_body = [](auto const& omega) {
  auto const& w = omega.coordinates;
  return (w[0] * w[0] + w[1] * w[1] * 2 + w[2] * w[2] * 4) / 2;
};

}  // namespace

BOOST_AUTO_TEST_CASE(both_ways_lead_to_the_same_places_on_seven_groups) {
  std::vector<SpannedGroup> const groups = {
      from_basis("SO(3)", SO<3>{}),          from_basis("SO(4)", SO<4>{}), from_basis("SE(2)", SE<2>{}),
      from_basis("SE(3)", SE<3>{}),          from_basis("Aff(1)", Aff1{}), from_basis("GL(2)", GL<2>{}),
      from_basis("Heisenberg", Heisenberg{})};
  Draw draw(7);
  for (auto const& group : groups) {
    double const h = 0.05;
    int const steps = 20;
    auto const l = natural_chart_lagrangian_right(KineticEnergy(draw, group.dimension()), h);
    auto const L = lift_right(l);
    auto const start = draw.element<double>(group);
    auto before = start, configuration = exp(h * draw.velocity<double>(group)) * start,
         reduced = configuration;
    auto f = relative_motion_right(before, configuration);
    // Right multiplication is the symmetry, so it is the momentum in the body that stays.
    auto const in_body = [&] { return Ad_star(configuration, D2(L, before, configuration)); };
    auto const at_start = in_body();
    for (int k = 0; k < steps; ++k) {
      auto const full = step_euler_lagrange(L, before, configuration);
      auto const half = step_euler_poincare_right(l, f);
      BOOST_TEST_CONTEXT(group.name() << ", step " << k) {
        BOOST_TEST(full.report.evaluations <= 4);
        BOOST_TEST(half.report.evaluations <= 4);
      }
      before = configuration, configuration = full.value;
      f = half.value, reduced = reconstruct_right(reduced, f);
    }
    // A relative motion is found to 16 eps, so its velocity, and the momentum, to 16 eps/h; Ad of a
    // configuration of this size magnifies that a few times.
    double const bound = 4 * 16 * eps / h * steps;
    BOOST_TEST_CONTEXT(group.name()) {
      BOOST_TEST(magnitude((configuration.value - reduced.value).eval()) <=
                 bound * magnitude(configuration.value));
      BOOST_TEST(magnitude((in_body() - at_start).components) <= bound * magnitude(at_start.components));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_body_keeps_its_momentum_in_space_over_ten_thousand_steps) {
  double const h = 0.1;
  auto const l = natural_chart_lagrangian_left(spinning_body, h);
  auto f = exp(velocity(SO<3>{}, Vector<double, 3>(-0.03, 0.11, -0.07)));
  auto g = identity<double>(SO<3>{});
  auto const in_space = [&] { return Ad_star(inverse(g), momentum_before_left(l, f)); };
  auto const start = in_space();
  double drift = 0;
  for (int k = 0; k < 10000; ++k) {
    g = restore(reconstruct_left(g, f));
    f = step_euler_poincare_left(l, f).value;
    drift = std::max(drift, (in_space() - start).components.norm() / start.components.norm());
  }
  // One rounding error of the solver a step, each a few eps/h; they add up like a random walk.
  BOOST_TEST(drift < 100 * 16 * eps / h);
}

BOOST_AUTO_TEST_CASE(a_discrete_lagrangian_that_is_blind_to_a_direction_is_refused_with_its_pivot) {
  auto const flat = [](auto const& f) {
    auto const w = log(f).coordinates;
    return w[0] * w[0] + w[1] * w[1];
  };
  // Along the third axis it has no second derivative at all.
  auto const f = exp(velocity(SO<3>{}, Vector<double, 3>(0, 0, 0.1)));
  BOOST_CHECK_EXCEPTION(step_euler_poincare_right(flat, f), Singular,
                        [](Singular const& e) { return e.measured <= e.bound; });
  CHECK_REFUSED(step_euler_lagrange(lift_right(flat), f, identity<double>(SO<3>{})), Singular);
}

BOOST_AUTO_TEST_CASE(a_step_past_the_chart_throws_and_never_returns) {
  // Three quarters of a turn in a step: beyond the natural chart, whatever the body.
  double const h = 1;
  auto const l = natural_chart_lagrangian_left(spinning_body, h);
  auto const pi = momentum(SO<3>{}, Vector<double, 3>(0.5, 9.4, 1.1));
  CHECK_REFUSED(
      relative_motion_from_momentum_left(l, pi, exp(velocity(SO<3>{}, Vector<double, 3>(-0.5, -3, -0.3)))),
      Error);
}

BOOST_AUTO_TEST_CASE(a_rotation_by_pi_has_no_place_in_the_natural_chart) {
  auto const l = natural_chart_lagrangian_left(spinning_body, 0.1);
  Matrix<double, 3, 3> const half_turn = Vector<double, 3>(1, -1, -1).asDiagonal();
  BOOST_CHECK_EXCEPTION(step_euler_poincare_left(l, Element<SO<3>, double>{SO<3>{}, half_turn}),
                        OutsideDomain, [](OutsideDomain const& e) { return e.measured >= e.bound; });
}

BOOST_AUTO_TEST_CASE(nothing_that_is_no_number_gets_in) {
  double const nan = std::nan(""), infinity = HUGE_VAL;
  auto const l = natural_chart_lagrangian_left(spinning_body, 0.1);
  auto const f = exp(velocity(SO<3>{}, Vector<double, 3>(0.1, 0.2, 0.3)));
  for (double const bad : {nan, infinity, -infinity}) {
    auto broken = f;
    broken.value(1, 2) = bad;
    CHECK_REFUSED(step_euler_poincare_left(l, broken), NotFinite);
    CHECK_REFUSED(step_euler_lagrange(lift_left(l), f, broken), NotFinite);
    CHECK_REFUSED(relative_motion_from_momentum_left(l, momentum(SO<3>{}, Vector<double, 3>(bad, 0, 0)), f),
                  NotFinite);
    auto const broken_energy = [bad](auto const& xi) { return spinning_body(xi) * bad; };
    CHECK_REFUSED(step_euler_poincare_left(natural_chart_lagrangian_left(broken_energy, 0.1), f), NotFinite);
    CHECK_REFUSED(natural_chart_lagrangian_left(spinning_body, bad), Error);
  }
  CHECK_REFUSED(natural_chart_lagrangian_left(spinning_body, 0.0), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(a_fall_is_solved_in_metres_and_in_micrometres) {
  for (double const unit : {1.0, 1e3, 1e6, 1e-6}) {
    double const h = 0.1, g = 9.81 * unit;
    auto const L = [=](auto const& a, auto const& b) {
      auto const v = (b.value[0] - a.value[0]) / h;
      return v * v * (h / 2) - (a.value[0] + b.value[0]) * (g * h / 2);
    };
    auto const start = identity<double>(Translations<1>{});
    BOOST_TEST(std::abs(step_euler_lagrange(L, start, start).value.value[0] / (-g * h * h) - 1) < 16 * eps);
  }
}
