// Forces on a system given at run time: order, against GSL's Runge-Kutta method and against the damped
// geodesics in closed form, the ledger of the momentum, what a force at one end alone does, inputs that jump,
// and what a run remembers.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "actio/any_group/level_integrator.hpp"
#include "actio/any_group/momentum_across.hpp"
#include "actio/reduction/composition.hpp"
#include "own_system.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using List = std::vector<double>;
using System = std::shared_ptr<ReducedSystem const>;
using Square = Eigen::MatrixXd;

Square one(System const& system) { return Square::Identity(system->length(), system->length()); }
double largest(List const& x) {
  double out = 0;
  for (double const c : x) out = std::max(out, std::abs(c));
  return out;
}
List minus(List a, List const& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}
/// The slope of the last two errors, of steps in the ratio 2.
double slope(List const& errors) { return std::log2(errors[errors.size() - 2] / errors.back()); }

/// `n` coordinates of which none is simple.
List uneven(int n, double size) {
  List out;
  for (int i = 0; i < n; ++i) out.push_back(size * std::sin(1 + 2.3 * i));
  return out;
}
/// A kinetic energy in the velocities of an algebra, no two of whose axes are alike.
std::string kinetic(MatrixAlgebra const& algebra) {
  std::string out;
  for (std::size_t i = 0; i < algebra.components.size(); ++i) {
    auto const& v = algebra.components[i];
    out += (i ? " + " : "") + std::to_string(1 + 0.4 * static_cast<double>(i)) + "*" + v + "^2/2";
  }
  return out + " + " + algebra.components[0] + "*" + algebra.components[1] + "/8";
}
System free_system(char const* group, Side side) {
  return own_system(group, side, kinetic(named_algebra(group)).c_str());
}

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

/// Momentum and vectors by GSL's Prince-Dormand method of order 8, for p = M v.
List by_gsl(System const& system, ReducedPoint const& start, double time) {
  struct Rates {
    System system;
    Square inverse_mass;
  } rates{system, {}};
  int const d = system->dimension(), m = system->carried();
  rates.inverse_mass =
      LegendreVelocity(*system).hessian(List(static_cast<std::size_t>(d)), start.vectors).inverse();
  auto const rate = [](double t, double const* y, double* out, void* with) {
    auto const& [system, inverse_mass] = *static_cast<Rates const*>(with);
    int const d = system->dimension(), m = system->carried();
    Eigen::VectorXd const p = Eigen::Map<Eigen::VectorXd const>(y, d), v = inverse_mass * p;
    std::vector<double> work, inputs(v.data(), v.data() + d), slopes(static_cast<std::size_t>(1 + d + m)),
        force(static_cast<std::size_t>(d));
    inputs.insert(inputs.end(), y + d, y + d + m);
    system->slopes(inputs.data(), slopes.data(), work);
    inputs.insert(inputs.end(), y, y + d);
    inputs.push_back(t);
    for (auto const& held : system->force->held) inputs.push_back(held(t));
    system->force->components(inputs.data(), force.data(), work);
    double const sign = system->sign();
    Eigen::VectorXd const turned = system->algebra.ad(Vector<double>(v)).transpose() * p;
    for (int i = 0; i < d; ++i) out[i] = sign * turned[i] + force[static_cast<std::size_t>(i)];
    Eigen::MatrixXd const hat = system->algebra.hat(Vector<double>(v));
    for (int k = 0; k < m; ++k) out[d + k] = 0;
    for (int first = 0; first < m; first += system->length()) {
      Eigen::VectorXd const a = Eigen::Map<Eigen::VectorXd const>(y + d + first, system->length());
      Eigen::VectorXd const moved = -sign * hat * a;
      for (int i = 0; i < system->length(); ++i) out[d + first + i] = moved[i];
      for (int c = 0; c < d; ++c) {
        Eigen::VectorXd const turned_by = system->algebra.basis[static_cast<std::size_t>(c)] * a;
        double torque = 0;
        for (int i = 0; i < system->length(); ++i)
          torque += slopes[static_cast<std::size_t>(1 + d + first + i)] * turned_by[i];
        out[c] -= sign * torque;
      }
    }
    return int(GSL_SUCCESS);
  };
  List y = start.momentum;
  y.insert(y.end(), start.vectors.begin(), start.vectors.end());
  gsl_odeiv2_system equations{rate, nullptr, static_cast<std::size_t>(d + m), &rates};
  auto* const driver = gsl_odeiv2_driver_alloc_y_new(&equations, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 1e-14);
  double t = start.time;
  BOOST_TEST_REQUIRE(gsl_odeiv2_driver_apply(driver, &t, t + time, y.data()) == int(GSL_SUCCESS));
  gsl_odeiv2_driver_free(driver);
  return y;
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
