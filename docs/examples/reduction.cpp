// Examples of the modules reduction, groupoid, instruments and any_group.
#include "actio/any_group/chart_integrator.hpp"
#include "actio/any_group/invariants.hpp"
#include "actio/any_group/legendre_velocity.hpp"
#include "actio/any_group/momentum_across.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "actio/formula/tape_derivatives.hpp"
#include "actio/groupoid/generating_function.hpp"
#include "actio/groupoid/group_as_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/pair_groupoid.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_momentum.hpp"
#include "actio/reduction/euler_lagrange_steps.hpp"
#include "actio/reduction/euler_poincare_steps.hpp"
#include "actio/reduction/galerkin.hpp"
#include "actio/reduction/momentum_step.hpp"
#include "actio/reduction/natural_chart.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_reduction)
using namespace actio;

namespace {
// A rigid body: l(Omega) = (2 Omega_1^2 + 3 Omega_2^2 + 4 Omega_3^2)/2, a function of the body velocity.
auto const body = [](auto const& Omega) {
  auto const& w = Omega.coordinates;
  return (w[0] * w[0] * 2.0 + w[1] * w[1] * 3.0 + w[2] * w[2] * 4.0) / 2.0;
};
auto turn(double x, double y, double z) { return exp(velocity(SO<3>{}, Vector<double, 3>(x, y, z))); }
}  // namespace

// ---- reduction

BOOST_AUTO_TEST_CASE(a_discrete_lagrangian) {
  // [natural_chart_lagrangian_left]
  double const h = 0.1;
  auto const l = natural_chart_lagrangian_left(body, h);  // of f = g1^-1 g0: h times body(-log(f)/h)
  auto const f = turn(-0.1, -0.2, 0);                     // points backwards: the velocity is (1, 2, 0)
  assert(std::abs(l(f) - h * (2 * 1 + 3 * 4) / 2.0) < 1e-14);
  // [natural_chart_lagrangian_left]
  // [momentum_before_left]
  auto const Pi = momentum_before_left(l, f);  // near I Omega = (2, 6, 0), with a part of second order
  assert((Pi.components - Vector<double, 3>(2, 6, 0)).norm() < 0.2);
  // [momentum_before_left]
  // [relative_motion_from_momentum_left]
  auto const found = relative_motion_from_momentum_left(l, Pi, identity<double>(SO<3>{})).value;
  assert((log(found).coordinates - log(f).coordinates).norm() < 1e-14);
  // [relative_motion_from_momentum_left]
}

BOOST_AUTO_TEST_CASE(reduced_steps) {
  // [step_euler_poincare_left]
  auto const l = natural_chart_lagrangian_left(body, 0.1);
  auto const f10 = turn(-0.1, -0.2, 0.05);
  auto const [f21, report] = step_euler_poincare_left(l, f10);  // solves (3.11)
  auto const next = momentum_before_left(l, f21);
  auto const transported = lie_poisson_update_left(f10, momentum_before_left(l, f10));  // (3.18)
  assert((next.components - transported.components).norm() < 1e-13);
  // [step_euler_poincare_left]
}

BOOST_AUTO_TEST_CASE(many_reduced_steps) {
  // [euler_poincare_steps]
  auto const l = natural_chart_lagrangian_left(body, 0.1);
  EulerPoincareStepsLeft motion(l, turn(-0.1, -0.2, 0.05));
  auto g = identity<double>(SO<3>{});
  auto const before = Ad_star(inverse(g), momentum_before_left(l, motion.relative_motion()));
  for (int step = 0; step < 1000; ++step) {
    g = reconstruct_left(g, motion.relative_motion());  // (3.15)
    motion.advance();
  }
  auto const after = Ad_star(inverse(g), momentum_before_left(l, motion.relative_motion()));
  assert((after.components - before.components).norm() < 1e-11);  // the momentum in space
  // [euler_poincare_steps]
}

BOOST_AUTO_TEST_CASE(steps_without_symmetry) {
  // [euler_lagrange_steps]
  // A pendulum on SO(2): a Lagrangian on TG that no translation leaves as it is.
  auto const pendulum = [](auto const& v) {  // v is a State over any scalar
    auto const& rate = v.velocity.coordinates[0];
    return rate * rate / 2.0 + v.configuration.value(0, 0);
  };
  double const h = 0.05;
  auto const L = discretize_right(pendulum, h, at_second);
  auto const g = [](double angle) { return exp(velocity(SO<2>{}, Vector<double, 1>(angle))); };
  EulerLagrangeSteps motion(L, g(0.1), g(0.1));
  double largest = 0;
  for (int k = 0; k < 1000; ++k) largest = std::max(largest, std::abs(log(motion.advance()).coordinates[0]));
  assert(largest < 0.1001);  // it swings, and does not grow
  // [euler_lagrange_steps]
}

BOOST_AUTO_TEST_CASE(steps_of_higher_order) {
  // [natural_chart_step_left]
  auto const start = momentum_state(body, velocity(SO<3>{}, Vector<double, 3>(1, 2, 0.5)));
  auto const step = natural_chart_step_left(body);  // a map of the momentum, of order 2
  auto const later = step(start, 0.1).state;
  auto const back = step(later, -0.1).state;
  assert((back.momentum.components - start.momentum.components).norm() < 1e-13);
  // [natural_chart_step_left]
  // [composed_left]
  // The error of one step of 0.1 falls with the order: 2, 4 and 6.
  auto const exact = take_steps(step, start, std::vector<double>(10000, 1e-5)).momentum;
  auto const error = [&](auto const& method) {
    return (method(start, 0.1).state.momentum.components - exact.components).norm();
  };
  ComposedLeft const fourth(step, suzuki<double>()), sixth(step, kahan_li<double>());
  assert(error(fourth) < error(step) / 100 && error(sixth) < error(fourth));
  // [composed_left]
  // [galerkin_step_left]
  auto const of_order_6 = galerkin_step_left<double>(body, 3);  // paths of degree 3
  assert(error(of_order_6) < 1e-7);
  // [galerkin_step_left]
}

// ---- groupoid

BOOST_AUTO_TEST_CASE(one_equation_on_two_groupoids) {
  // [lagrange_equations]
  auto const l = natural_chart_lagrangian_right(body, 0.1);
  auto const on_pairs = [&](auto const& arrow) { return l(arrow.first * inverse(arrow.second)); };
  PairArrow<SO<3>, double> const a{turn(0, 0, 0), turn(0.1, -0.3, 0.2)}, b{a.second, turn(0.4, -0.2, 0.1)};
  auto const f01 = a.first * inverse(a.second), f12 = b.first * inverse(b.second);
  auto const pairs = lagrange_equations(PairGroupoid<SO<3>>{}, on_pairs, a, b);
  auto const group = lagrange_equations(GroupAsGroupoid<SO<3>>{}, l, f01, f12);
  assert((pairs + group).norm() < 1e-12);  // the same equation; the coordinates have opposite signs
  // [lagrange_equations]
}

// ---- instruments

BOOST_AUTO_TEST_CASE(what_a_map_preserves) {
  // [poisson_defect]
  // Euler's method along the group: the momentum stays on its sphere; the bracket is not preserved.
  auto const euler = []<class S>(S const& h, Momentum<SO<3>, S> const& Pi) {
    auto const& M = Pi.components;
    auto const Omega = velocity(Pi.group, Vector<S, 3>(M[0] / S(2), M[1] / S(3), M[2] / S(4)));
    return Ad_star(exp(h * Omega), Pi);
  };
  auto const step = [&]<class S>(Momentum<SO<3>, S> const& Pi) { return euler(S(0.5), Pi); };
  auto const Pi = momentum(SO<3>{}, Vector<double, 3>(1, 3, 2));
  assert(poisson_defect(LiePoissonMinus{}, step, Pi) > 1e-3);
  // [poisson_defect]
  // [leaf_defect]
  assert(leaf_defect(LiePoissonMinus{}, euler, 0.5, Pi) < 1e-13);
  // [leaf_defect]
  // [self_adjointness_defect]
  assert(self_adjointness_defect(LiePoissonMinus{}, euler, 0.5, Pi) > 1e-3);  // a step by -h does not undo it
  // [self_adjointness_defect]
}

// ---- any_group

BOOST_AUTO_TEST_CASE(groups_given_at_run_time) {
  using namespace actio::systems;
  // [named_algebra]
  MatrixAlgebra const se2 = named_algebra("SE(2)");
  assert(se2.dimension == 3 && se2.components[1] == "v1");
  // [named_algebra]
  // [casimirs]
  std::vector<Casimir> const found = casimirs(se2);
  assert(found.size() == 1 && found[0].text() == "v1^2 + v2^2");
  assert(found[0].evaluate(Eigen::Vector3d(7, 3, 4)) == 25);
  // [casimirs]
}

BOOST_AUTO_TEST_CASE(group_given_by_matrices) {
  using namespace actio::systems;
  // [spanned_algebra]
  // Sol: the matrices with rows (s, 0, x), (0, -s, y), (0, 0, 0).
  Eigen::MatrixXd s = Eigen::MatrixXd::Zero(3, 3), x = s, y = s;
  s(0, 0) = 1, s(1, 1) = -1, x(0, 2) = 1, y(1, 2) = 1;
  MatrixAlgebra const sol = spanned_algebra({s, x, y});
  assert(casimirs(sol)[0].text() == "x2*x3");
  BOOST_CHECK_THROW(spanned_algebra({s, x + y}), OutsideDomain);  // a commutator leaves the span
  // [spanned_algebra]
}

BOOST_AUTO_TEST_CASE(system_given_at_run_time) {
  using namespace actio::systems;
  // [chart_integrator]
  // A flat hull in water, from texts: the group by its name, the Lagrangian as a formula.
  auto const algebra = named_algebra("SE(2)");
  auto const l = parse_formula("(w^2 + v1^2 + 6*v2^2)/2", algebra.components);
  auto const hull = std::make_shared<ReducedSystem const>(algebra, actio::systems::Side::left, 0, l);
  std::vector<double> const velocity{0.7, 1, 0.2};
  ReducedPoint const start{LegendreVelocity(*hull).momentum(velocity, {}), {}};
  ChartIntegrator motion(hull, 0.05, suzuki<double>(), start, velocity);
  for (int k = 0; k < 1000; ++k) motion.step();
  auto const& P = motion.point().momentum;
  assert(std::abs(P[1] * P[1] + P[2] * P[2] - (1 + 1.2 * 1.2)) < 1e-12);  // the Casimir
  // [chart_integrator]
  // [force_across]
  // The same hull is pushed along the first axis of space, whose momentum then grows in proportion to the
  // time.
  auto names = algebra.components;
  for (char const* const more : {"p_w", "p_v1", "p_v2", "t"}) names.push_back(more);
  auto const constant = [&](std::vector<std::string> const& texts) {
    std::vector<Tape> tapes;
    for (auto const& text : texts) tapes.push_back(parse_formula(text, names));
    return joined(tapes);
  };
  auto const pushed = std::make_shared<ReducedSystem>(*hull);
  pushed->force = GeneralizedForce{constant({"0", "0", "0"}), {}, constant({"0", "0.5", "0"})};
  ReducedPoint from = start;
  Eigen::MatrixXd const one = Eigen::MatrixXd::Identity(3, 3);
  from.frame = frame_at(algebra, actio::systems::Side::left, one, one);
  ChartIntegrator push(pushed, 0.05, suzuki<double>(), from, velocity);
  push.follow_configuration(one);
  for (int k = 0; k < 40; ++k) push.step();
  Eigen::MatrixXd const g = push.configuration();
  auto const in_space =
      momentum_across(algebra, actio::systems::Side::left, g, g.inverse(), push.point().momentum);
  assert(std::abs(in_space[1] - (1 + 0.5 * 2)) < 1e-13);
  // [force_across]
}

BOOST_AUTO_TEST_SUITE_END()
