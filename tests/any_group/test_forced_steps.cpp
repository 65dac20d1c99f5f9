// Forces on a system given at run time: order, against GSL's Runge-Kutta method and against the damped
// geodesics in closed form, the ledger of the momentum, what a force at one end alone does, inputs that jump,
// and what a run remembers.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/level_integrator.hpp"
#include "actio/any_group/momentum_across.hpp"
#include "actio/any_group/tape_lagrangian.hpp"
#include "actio/reduction/advected_galerkin.hpp"
#include "actio/reduction/composition.hpp"
#include "forced_reference.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

/// Momentum and configuration after a time.
struct End {
  List momentum;
  Square configuration;
};
End after(System const& system, List const& fractions, int steps, double time, ReducedPoint const& start,
          List const& v) {
  ChartIntegrator run(system, time / steps, fractions, start, v);
  run.follow_configuration(one(system));
  for (int k = 0; k < steps; ++k) run.step();
  return {run.point().momentum, run.configuration()};
}
double apart(End const& a, End const& b) {
  return std::max(largest(minus(a.momentum, b.momentum)),
                  (a.configuration - b.configuration).cwiseAbs().maxCoeff());
}

/// The damped motion in closed form: momentum times e^-ct, along the free motion to the time (1 - e^-ct)/c.
End damped(System const& free, double rate, double time, List const& v) {
  double const tau = -std::expm1(-rate * time) / rate;
  int const steps = 200;
  LevelIntegrator run(free, tau / steps, point_at(*free, v), v);
  run.follow_configuration(one(free));
  for (int k = 0; k < steps; ++k) run.step();
  End end{run.point().momentum, run.configuration()};
  for (double& p : end.momentum) p *= std::exp(-rate * time);
  return end;
}

/// Errors of the momentum and the vectors in n, 2 n, 4 n steps, against GSL.
List errors_to_gsl(System const& system, List const& fractions, int n, double time, List const& v,
                   List const& a = {}) {
  ReducedPoint const start = point_at(*system, v, a);
  List const truth = by_gsl(system, start, time);
  List out;
  for (int const steps : {n, 2 * n, 4 * n}) {
    ChartIntegrator run(system, time / steps, fractions, start, v);
    for (int k = 0; k < steps; ++k) run.step();
    List end = run.point().momentum;
    end.insert(end.end(), run.point().vectors.begin(), run.point().vectors.end());
    out.push_back(largest(minus(end, truth)));
  }
  return out;
}

/// Drag by the square of the velocity, a spring in time, and a push that depends on the momentum.
std::vector<std::string> uneven_force(MatrixAlgebra const& algebra) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < algebra.components.size(); ++i) {
    auto const& v = algebra.components[i];
    out.push_back(i % 2 ? "0.2*cos(2*t) - 0.3*" + v : "-0.2*" + v + "*abs(" + v + ") + 0.05*p_" + v);
  }
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(forced_steps)

BOOST_AUTO_TEST_CASE(damping_slows_the_free_motion_along_its_path_on_five_groups) {
  double const rate = 0.3, time = 2;
  for (char const* const group : {"SO(3)", "SE(3)", "SL(2)", "SU(3)", "Sp(4)"})
    for (Side const side : {Side::left, Side::right}) {
      System const free = free_system(group, side);
      std::vector<std::string> drag;
      for (auto const& v : free->algebra.components) drag.push_back("-0.3*p_" + v);
      System const system = with_force(free, drag);
      List const v = uneven(free->dimension(), 0.6);
      End const truth = damped(free, rate, time, v);
      for (int const order : {2, 4}) {
        List errors;
        for (int const steps : {20, 40, 80})
          errors.push_back(apart(
              after(system, order == 2 ? List{1} : suzuki<double>(), steps, time, point_at(*system, v), v),
              truth));
        BOOST_TEST_CONTEXT(group << (side == Side::left ? " left" : " right") << ", order " << order << ": "
                                 << errors[0] << " " << errors[1] << " " << errors[2])
        BOOST_TEST(std::abs(slope(errors) - order) < 0.1);
      }
    }
}

BOOST_AUTO_TEST_CASE(any_force_has_the_order_of_the_free_steps) {
  for (char const* const group : {"SO(3)", "SE(2)", "SE(3)"})
    for (Side const side : {Side::left, Side::right}) {
      System const free = free_system(group, side), system = with_force(free, uneven_force(free->algebra));
      // The velocities keep their signs, so that the drag is smooth along the motion.
      List v = uneven(free->dimension(), 0.1);
      for (double& x : v) x = 1 + std::abs(x);
      for (int const order : {2, 4}) {
        List const errors = errors_to_gsl(system, order == 2 ? List{1} : suzuki<double>(), 16, 0.5, v);
        BOOST_TEST_CONTEXT(group << (side == Side::left ? " left" : " right") << ", order " << order << ": "
                                 << errors[0] << " " << errors[1] << " " << errors[2])
        BOOST_TEST(std::abs(slope(errors) - order) < 0.1);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_damped_top_has_the_order_of_the_free_one) {
  for (Side const side : {Side::left, Side::right}) {
    System const system =
        with_force(own_system("SO(3)", side, "(w1^2 + 1.5*w2^2 + 0.5*w3^2)/2 - 2*a3 - a1", true),
                   {"-0.1*w1 + 0.2*a2", "-0.1*w2*a3^2", "-0.05*w3"});
    for (int const order : {2, 4}) {
      List const errors = errors_to_gsl(system, order == 2 ? List{1} : suzuki<double>(), 40, 1, {0.5, 0.2, 3},
                                        {0.1, -0.3, -1});
      BOOST_TEST_CONTEXT("order " << order << ": " << errors[0] << " " << errors[1] << " " << errors[2])
      BOOST_TEST(std::abs(slope(errors) - order) < 0.1);
    }
  }
}

BOOST_AUTO_TEST_CASE(galerkin_steps_have_their_order_with_a_force_and_their_impulse_is_exact) {
  using G = SpanOfMatrices;
  for (Side const side : {Side::left, Side::right}) {
    System const system =
        with_force(own_system("SO(3)", side, "(w1^2 + 1.5*w2^2 + 0.5*w3^2)/2 - 2*a3 - a1", true),
                   {"-0.1*w1 + 0.2*a2", "-0.1*w2*a3^2 + 0.3*cos(2*t)", "-0.05*p_w3"});
    List const v{0.5, 0.2, 3}, a{0.1, -0.3, -1};
    List const truth = by_gsl(system, point_at(*system, v, a), 1);
    G const group(system->algebra);
    auto const column = [](List const& x) {
      return Matrix<double, Dynamic, 1>(
          Eigen::Map<Eigen::VectorXd const>(x.data(), static_cast<Eigen::Index>(x.size())));
    };
    for (int const s : {1, 2, 3}) {
      List errors;
      for (int const steps : {5, 10}) {
        AdvectedMomentumState<G, double, Dynamic> state{
            {group, column(point_at(*system, v, a).momentum)}, column(a), {group, column(v)}};
        double const h = 1.0 / steps;
        TapeLagrangian const l{system};
        for (int k = 0; k < steps; ++k) {
          TapeForce const force(system, k * h, h);
          state = side == Side::left
                      ? forced_galerkin_step_left<double>(l, s, EachVector{}, force)(state, h).state
                      : forced_galerkin_step_right<double>(l, s, EachVector{}, force)(state, h).state;
        }
        List end(state.momentum.components.data(), state.momentum.components.data() + 3);
        end.insert(end.end(), state.vector.data(), state.vector.data() + 3);
        errors.push_back(largest(minus(end, truth)));
      }
      BOOST_TEST_CONTEXT("order " << 2 * s << ": " << errors[0] << " " << errors[1])
      BOOST_TEST(std::abs(slope(errors) - 2 * s) < 0.35);
    }
  }
  // Without a vector the whole momentum of the symmetry changes by the impulse.
  for (Side const side : {Side::left, Side::right}) {
    System const free = free_system("SE(3)", side), system = with_force(free, uneven_force(free->algebra));
    List const v = uneven(6, 0.5);
    G const group(system->algebra);
    auto const start = point_at(*system, v);
    auto const column = [&](List const& x) {
      return Eigen::VectorXd(Eigen::Map<Eigen::VectorXd const>(x.data(), 6));
    };
    AdvectedMomentumState<G, double, Dynamic> const state{
        {group, column(start.momentum)}, Matrix<double, Dynamic, 1>(0), {group, column(v)}};
    TapeForce const force(system, 0, 0.3);
    TapeLagrangian const l{system};
    auto const done = side == Side::left
                          ? forced_galerkin_step_left<double>(l, 2, EachVector{}, force)(state, 0.3)
                          : forced_galerkin_step_right<double>(l, 2, EachVector{}, force)(state, 0.3);
    auto const back = side == Side::left ? Ad_star(done.relative_motion, done.state.momentum)
                                         : Ad_star(inverse(done.relative_motion), done.state.momentum);
    double const change = magnitude((back - state.momentum - *done.impulse).components);
    BOOST_TEST(change < 64 * eps * magnitude(state.momentum.components));
    BOOST_TEST(magnitude(done.impulse->components) > 0.01);
  }
}

BOOST_AUTO_TEST_CASE(a_force_at_one_end_of_a_step_alone_is_of_order_one) {
  System const free = free_system("SO(3)", Side::left);
  List const v = uneven(3, 0.6);
  End const truth = damped(free, 0.3, 2, v);
  List errors;
  for (int const steps : {40, 80, 160}) {
    double const h = 2.0 / steps;
    ReducedPoint point = point_at(*free, v);
    ChartSolver step(*free, h);
    step.begin_at(v);
    for (int k = 0; k < steps; ++k) {
      step(point);
      List const p = LegendreVelocity(*free).momentum(step.velocity(), {});
      for (std::size_t i = 0; i < p.size(); ++i) point.momentum[i] -= h * 0.3 * p[i];
    }
    errors.push_back(largest(minus(point.momentum, truth.momentum)));
  }
  BOOST_TEST(std::abs(slope(errors) - 1) < 0.1);
}

BOOST_AUTO_TEST_CASE(the_momentum_in_space_changes_by_the_impulse_of_the_force) {
  // A drag so small that much of the motion is left at the end, for whose time the sum of the changes is far
  // above what a step loses.
  for (Side const side : {Side::left, Side::right}) {
    System const free = free_system("SE(3)", side);
    System const system = with_force(free, {"-0.001*w1 + 0.05*cos(t)", "-0.001*w2*abs(w2)", "0.02*sin(t)",
                                            "-0.001*v1*w3", "0.03*cos(2*t)", "-0.002*v3"});
    List const v{0.7, -0.4, 0.9, 0.2, -0.3, 0.1};
    ChartIntegrator run(system, 0.05, {1}, point_at(*system, v), v);
    run.follow_configuration(one(system));
    auto const across = [&] {
      Square const g = run.configuration();
      return momentum_across(system->algebra, side, g, Square(g.inverse()), run.point().momentum);
    };
    List const before = across();
    int const steps = 1000;
    double size = largest(before), condition = 1, worst = 0;
    for (int k = 0; k < steps; ++k) {
      run.step();
      List const now = across();
      size = std::max(size, largest(now));
      condition = std::max(condition, run.configuration().norm());
      worst = std::max(worst, largest(minus(minus(now, before), run.ledger().impulse)));
    }
    BOOST_TEST_CONTEXT((side == Side::left ? "left" : "right") << ": " << worst << " of " << size) {
      // Ad of a configuration multiplies a few roundings a step by the square of its size.
      BOOST_TEST(worst < 16 * eps * steps * size * condition * condition);
      BOOST_TEST(largest(run.ledger().impulse) > 0.01 * size);
    }
  }
}

BOOST_AUTO_TEST_CASE(work_is_what_the_energy_changes_by_to_the_order_of_the_step) {
  System const free = free_system("SE(2)", Side::left);
  System const system = with_force(free, {"-0.2*w*abs(w)", "0.3*cos(t)", "-0.1*v2"});
  List const v{0.7, 1.0, 0.4};
  List errors;
  for (int const steps : {50, 100, 200}) {
    ReducedPoint const start = point_at(*system, v);
    ChartIntegrator run(system, 2.0 / steps, {1}, start, v);
    for (int k = 0; k < steps; ++k) run.step();
    LegendreVelocity legendre(*system);
    List w = v;
    legendre.solve(run.point().momentum, {}, w);
    errors.push_back(std::abs(legendre.energy(w, {}) - legendre.energy(v, {}) - run.ledger().work));
  }
  BOOST_TEST(std::abs(slope(errors) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(an_input_that_jumps_between_two_steps_costs_no_order) {
  System const free = free_system("SO(3)", Side::left);
  std::pair<std::string, HeldInput> const thrust{"u", HeldInput({{0, 0.5}, {1, -0.25}})};
  System const system = with_force(free, {"u", "-0.2*w2", "u*w3"}, {thrust});
  List const v{0.7, 1.0, 0.4};
  // The truth is two smooth motions, one after the other.
  ReducedPoint middle = point_at(*system, v);
  middle.momentum = by_gsl(system, middle, 1 - 1e-15);
  middle.time = 1;
  List const truth = by_gsl(system, middle, 1);
  for (int const order : {2, 4}) {
    List errors;
    for (int const steps : {20, 40, 80}) {
      ChartIntegrator run(system, 2.0 / steps, order == 2 ? List{1} : suzuki<double>(), point_at(*system, v),
                          v);
      for (int k = 0; k < steps; ++k) run.step();
      errors.push_back(largest(minus(run.point().momentum, truth)));
    }
    BOOST_TEST_CONTEXT("order " << order << ": " << errors[0] << " " << errors[1] << " " << errors[2])
    BOOST_TEST(std::abs(slope(errors) - order) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(the_time_of_a_step_is_a_multiple_of_its_length) {
  System const system = with_force(free_system("SO(3)", Side::left), {"cos(t)", "0", "0"});
  ChartIntegrator run(system, 0.1, suzuki<double>(), point_at(*system, {0.7, 1.0, 0.4}), {0.7, 1.0, 0.4});
  for (int k = 0; k < 1000; ++k) run.step();
  BOOST_TEST(run.point().time == 1000 * 0.1);
}

BOOST_AUTO_TEST_CASE(a_component_that_dies_out_between_two_equal_moments_stops_no_run) {
  // Its rate is a difference of two equal products, whose roundings are larger than the component.
  System const system = with_force(
      own_system("SO(3) x R^1", Side::left, "(0.05*x1^2 + 4.3*x2^2 + 4.8*x3^2 + 0.5*(x2 + x4)^2)/2"),
      {"0", "0", "0", "-20*x4"});
  List const v{20, 4, 1, 0};
  ChartIntegrator run(system, 0.02, suzuki<double>(), point_at(*system, v), v);
  for (int k = 0; k < 20000; ++k) run.step();
  BOOST_TEST(std::abs(run.point().momentum[0]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(rows_of_an_input_are_checked) {
  using Rows = std::vector<std::pair<double, double>>;
  CHECK_REFUSED(HeldInput(Rows{}), OutsideDomain);
  CHECK_REFUSED(HeldInput(Rows{{1, 0}, {1, 2}}), OutsideDomain);
  CHECK_REFUSED(HeldInput(Rows{{1, std::numeric_limits<double>::infinity()}}), NotFinite);
  HeldInput const rows(Rows{{1, 3}, {2, 5}});
  BOOST_TEST(rows(0) == 3);
  BOOST_TEST(rows(1.5) == 3);
  BOOST_TEST(rows(2) == 5);
  BOOST_TEST(rows(9) == 5);
}

BOOST_AUTO_TEST_SUITE_END()
