// Friction inside a satellite: a force that the symmetry does not feel, and what it does in the end.
//
// What is shown. A body with a wheel on an axle turns freely, and the bearing of the wheel has friction. The
// discrete equations (3.11) with this force conserve the momentum in space to rounding and lose energy at
// each step. Set to turn about its axis of least inertia, the satellite ends turning about that of most:
// Explorer 1 did. The energy at the end follows from the momentum alone. Beside it: Runge-Kutta; a force that
// acts at one end of a step only; and the order, measured against a damped motion in closed form. Read first.
// Section 3.2, and the page on forces.
//
//   g      configuration, attitude and angle of the wheel       Pi     body momentum, with that of the wheel
//   v      velocity of the body: w and the rate s of the wheel  F      force: friction in the bearing
//   l      reduced Lagrangian                                   h      step
//
// Compiled at -O2: it takes many steps.
#include "actio/groups/direct_product.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/reduction/discrete_force.hpp"
#include "actio/reduction/momentum_level.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using Satellite = DirectProduct<SO<3>, SO<2>>;
using Velocity4 = Velocity<Satellite, double>;
using Momentum4 = Momentum<Satellite, double>;
using Configuration = Element<Satellite, double>;
Satellite const satellite;

// 1. The satellite: moments of inertia of the whole, and the wheel, whose axle is the first axis.
double const I1 = 1.5, I2 = 1, I3 = 2, wheel = 0.1, friction = 0.05;
auto const l = [](auto const& v) {
  auto const& x = v.coordinates;
  return (x[0] * x[0] * (I1 - wheel) + x[1] * x[1] * I2 + x[2] * x[2] * I3 +
          (x[0] + x[3]) * (x[0] + x[3]) * wheel) /
         2.0;
};
// The force: friction against the rate of the wheel. No component acts on the body as a whole.
auto const bearing = []<class S>(Velocity<Satellite, S> const& v) {
  Vector<S> F = Vector<S>::Zero(4);
  F[3] = v.coordinates[3] * (-friction);
  return momentum(v.group, F);
};

// 2. A motion: steps of (3.11) with the force.
struct Motion {
  std::vector<double> time, energy, nutation;
  double change_of_momentum = 0, energy_at_end = 0;
};
Velocity4 velocity_of(Momentum4 const& pi) {
  auto const& p = pi.components;
  double const turning = (p[0] - p[3]) / (I1 - wheel);
  return velocity(satellite, Vector<double>{{turning, p[1] / I2, p[2] / I3, p[3] / wheel - turning}});
}
Vector<double, 3> in_space(Configuration const& g, Momentum4 const& pi) {
  return Ad_star(inverse(g), pi).components.head(3);
}
Momentum4 at_the_start() { return gradient(l, velocity(satellite, Vector<double>{{0.02, 0.9, 0.05, 0}})); }

// What is written down of a state.
class Record {
 public:
  Record(Momentum4 const& pi) : start_(in_space(identity<double>(satellite), pi)) {}
  void add(double t, Configuration const& g, Momentum4 const& pi) {
    auto const J = in_space(g, pi);
    double const E = l(velocity_of(pi));
    motion.time.push_back(t), motion.energy.push_back(E);
    motion.nutation.push_back(std::acos(std::min(1.0, std::abs(pi.components[2]) / J.norm())) * 180 / M_PI);
    motion.change_of_momentum = std::max(motion.change_of_momentum, (J - start_).norm() / start_.norm());
    motion.energy_at_end = E;
  }
  Motion motion;

 private:
  Vector<double, 3> start_;
};

double const h = 0.1;
int const steps = 16000;
Motion by_discrete_equations() {
  auto const discrete = natural_chart_lagrangian_left(l, h);
  auto const force = force_at_both_ends(bearing, h);
  auto pi = at_the_start();
  auto f = identity<double>(satellite), g = f;
  Record record(pi);
  for (int k = 1; k <= steps; ++k) {
    std::tie(f, pi) = forced_step_left(discrete, force, pi, f);
    g = reconstruct_left(g, f);
    record.add(k * h, g, pi);
  }
  return record.motion;
}

// 3. Runge-Kutta of order 4 on matrices and momenta, brought back to the group after each step.
Motion by_runge_kutta() {
  auto pi = at_the_start();
  auto g = identity<double>(satellite);
  Record record(pi);
  for (int k = 1; k <= steps; ++k) {
    auto stage_g = g, sum_g = g;
    auto stage = pi, sum = pi;
    for (int i = 0; i < 4; ++i) {
      auto const v = velocity_of(stage);
      Matrix<double> const turning = stage_g.value * satellite.hat(v.coordinates);
      auto const rate = ad_star(v, stage) + bearing(v);
      double const share = h * (i == 0 || i == 3 ? 1 : 2) / 6, next = i == 2 ? h : h / 2;
      sum_g.value += share * turning, sum = sum + share * rate;
      stage_g.value = g.value + next * turning, stage = pi + next * rate;
    }
    g = restore(sum_g), pi = sum;
    record.add(k * h, g, pi);
  }
  return record.motion;
}

// 4. The order. A force that is minus a constant times the momentum slows the free motion along its own path,
//    which gives the body momentum in closed form. Order 4 is composed of substeps.
double const rate = 0.3, until = 2;
auto const drag = []<class S>(Velocity<Satellite, S> const& v) { return S(-rate) * gradient(l, v); };
Momentum4 damped(double time) {
  double const tau = -std::expm1(-rate * time) / rate;
  auto const step = momentum_level_step_left<double>(l);
  auto state = momentum_state(l, velocity_of(at_the_start()));
  for (int k = 0; k < 100; ++k) state = step(state, tau / 100).state;
  return std::exp(-rate * time) * state.momentum;
}
double error(int count, std::vector<double> const& fractions, bool both_ends = true) {
  auto pi = at_the_start();
  auto f = identity<double>(satellite);
  for (int k = 0; k < count; ++k)
    for (double const fraction : fractions) {
      double const step = fraction * until / count;
      auto const half = force_at_both_ends(drag, step);
      auto const none = [](auto const& x) { return 0.0 * momentum(x.group, log(x).coordinates); };
      auto const whole = [&](auto const& x) { return half.at_end(x) + half.at_end(x); };
      auto const discrete = natural_chart_lagrangian_left(l, step);
      auto const near = identity<double>(satellite);
      if (both_ends)
        std::tie(f, pi) = forced_step_left(discrete, half, pi, near);
      else
        std::tie(f, pi) = forced_step_left(discrete, DiscreteForce{none, whole}, pi, near);
    }
  return (pi - damped(until)).components.norm();
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a satellite with friction in the bearing of a wheel, to its end");
  Motion const discrete = by_discrete_equations(), classical = by_runge_kutta();
  double const L = at_the_start().components.head(3).norm(), expected = L * L / (2 * I3);

  program.figure("momentum", discrete.change_of_momentum, "change of the momentum in space, relative");
  program.figure("runge_kutta", classical.change_of_momentum, "the same by Runge-Kutta of order 4");
  program.figure("energy_at_end", discrete.energy_at_end, "energy at the end");
  program.figure("expected", expected, "energy of the turn about the axis of most inertia");
  program.figure("off", std::abs(discrete.energy_at_end / expected - 1), "its difference, relative");
  program.picture(
      "nutation",
      book::Plot("time", "angle from the axis of most inertia, degrees")
          .curve(discrete.time, discrete.nutation, "discrete equations with a force", {.colour = 1})
          .svg(),
      "The angle between the momentum and the third axis of the satellite. Friction takes energy as long as "
      "the wheel turns in its bearing, and none when the satellite turns about the axis of most inertia.");

  std::vector<std::vector<std::string>> rows;
  std::vector<double> slopes;
  auto const row = [&](std::string const& name, std::vector<double> const& fractions, bool both_ends) {
    std::vector<double> errors;
    for (int const count : {20, 40, 80}) errors.push_back(error(count, fractions, both_ends));
    slopes.push_back(std::log2(errors[1] / errors[2]));
    rows.push_back({name, book::number(errors[0], 2), book::number(errors[1], 2), book::number(errors[2], 2),
                    book::number(slopes.back(), 3)});
  };
  row("the natural chart, half of the force at each end", {1}, true);
  row("composed of five substeps", suzuki<double>(), true);
  row("all of the force at the end", {1}, false);
  program.table("orders", {"step", "20 steps", "40", "80", "order"}, rows,
                "Error of the body momentum of a satellite that is damped, after two units of time.");

  using book::measured;
  program.claim(measured(discrete.change_of_momentum) < steps * 16 * 0x1p-52,
                "the momentum in space is conserved to rounding");
  program.claim(measured(std::abs(discrete.energy_at_end / expected - 1)) < 1e-10,
                "the satellite ends turning about the axis of most inertia");
  program.claim(measured(classical.change_of_momentum) > 1e-8, "Runge-Kutta changes the momentum");
  program.claim(measured(std::abs(slopes[0] - 2)) < 0.1, "half of the force at each end has order 2");
  program.claim(measured(std::abs(slopes[1] - 4)) < 0.15, "the composition has order 4");
  program.claim(measured(std::abs(slopes[2] - 1)) < 0.1, "all of it at the end has order 1");
  program.headline("momentum kept to " + book::number(discrete.change_of_momentum, 2) +
                       " under friction; Runge-Kutta changes it by " +
                       book::number(classical.change_of_momentum, 2),
                   discrete.change_of_momentum);
  return program.finish();
}
