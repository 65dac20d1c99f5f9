// Bodies that roll: a sleigh, Chaplygin's ball and a rattleback, by the discrete principle of Lagrange and
// d'Alembert.
//
// What is shown. A sleigh on a blade is given by three formulas, and its steps have orders 2 and 4 against
// the motion in closed form. The momentum of a ball about its point of contact is conserved to rounding,
// since reactions act at the nodes. A rattleback that is spun the wrong way stops, rattles, and spins the
// other way; spun the right way it slows down for long. Read first. Sections 10E.1 and 10E.2.
//
//   w, v   angular velocity, velocity of the origin of the body, seen from the body   u  the vertical
//   h      step     K  momentum about the contact
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Core>

#include <numbers>

#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "actio/nonholonomic/constrained_integrator.hpp"
#include "actio/nonholonomic/rolling_steps.hpp"
#include "actio/reduction/composition.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"

using namespace actio;
using namespace actio::systems;
using List = std::vector<double>;
using Vertical = Triad<double>;

// 1. A system with constraints, from texts: the group by its name, Lagrangian and constraints as formulas in
// the velocity and in the vectors that the motion carries.
struct Constrained {
  std::shared_ptr<ReducedSystem const> system;
  std::shared_ptr<VelocityConstraints const> constraints;

  Constrained(char const* group, char const* lagrangian, std::vector<char const*> const& each,
              bool carries_vertical) {
    MatrixAlgebra algebra = named_algebra(group);
    auto names = algebra.components;
    for (int i = 1; carries_vertical && i <= algebra.size; ++i) names.push_back("u" + std::to_string(i));
    Tape const l = parse_formula(lagrangian, names);
    system = std::make_shared<ReducedSystem const>(algebra, systems::Side::left, carries_vertical ? 1 : 0, l);
    names.push_back("t");
    std::vector<Tape> tapes;
    for (char const* const one : each) tapes.push_back(parse_formula(one, names));
    constraints = std::make_shared<VelocityConstraints const>(*system, tapes);
  }
  RattleIntegrator run(double h, int order, List const& v, List const& a = {}) const {
    return {system, constraints, h, symmetric_composition<double>(order),
            constrained_state(*system, *constraints, v, a)};
  }
};

// 2. The sleigh: mass 1 and moment of inertia 3/4 about the centre of mass, half a unit in front of the
// blade. With energy 1/2 its motion is w = sech(t/2 - 2), v1 = tanh(t/2 - 2).
double sleigh_error(int order, int steps, double time) {
  static Constrained const sleigh("SE(2)", "(v1^2 + (v2 + w/2)^2 + 3*w^2/4)/2", {"v2"}, false);
  auto run = sleigh.run(time / steps, order, {1 / std::cosh(2.0), -std::tanh(2.0), 0});
  for (int k = 0; k < steps; ++k) run.step();
  auto const v = run.state().velocity;
  return std::hypot(v[0] - 1 / std::cosh(time / 2 - 2), v[1] - std::tanh(time / 2 - 2));
}

// 3. Chaplygin's ball, of radius and mass 1: the point at -u from its centre is at rest. K = M + u x P.
double change_of_momentum(int steps) {
  Constrained const ball("SE(3)", "(w1^2 + 2*w2^2 + 2.5*w3^2 + v1^2 + v2^2 + v3^2)/2",
                         {"v1 - w2*u3 + w3*u2", "v2 - w3*u1 + w1*u3", "v3 - w1*u2 + w2*u1"}, true);
  Vertical const up{0.36, 0.48, 0.8}, w{0.9, -0.4, 1.2}, v = cross(w, up);
  auto run = ball.run(0.05, 2, {w.x, w.y, w.z, v.x, v.y, v.z}, {up.x, up.y, up.z, 0});
  auto const squared = [&] {
    auto const &p = run.point().momentum, &u = run.point().vectors;
    Vertical const K =
        Vertical{p[0], p[1], p[2]} + cross(Vertical{u[0], u[1], u[2]}, Vertical{p[3], p[4], p[5]});
    return dot(K, K);
  };
  double const before = squared();
  double change = 0;
  for (int k = 0; k < steps; ++k) run.step(), change = std::max(change, std::abs(squared() / before - 1));
  return change;
}

// 4. The rattleback of Kane and Levinson, in centimetres and seconds, with its steps written out. Its
// principal axes of inertia are turned a little against those of its shape: the product -0.2.
RollingBody<Ellipsoid> const rattleback{{{20, 3, 2}, 1}, {2, 16, 17, 0, 0, -0.2}, 1, 981};
struct Spins {
  List time, spin;
  double first_zero = 0, energy = 0;
};
Spins spun(double start, double end) {
  double const tilt = std::sin(std::numbers::pi / 360), h = 0.001;
  Vertical const up{tilt, tilt, std::sqrt(1 - 2 * tilt * tilt)};
  RollingSteps<Ellipsoid> run(rattleback, h, suzuki<double>(), start * up, up);
  Spins all;
  double const before = rattleback.energy(start * up, up);
  for (int k = 1; k * h <= end; ++k) {
    run.step();
    double const spin = dot(run.velocity(), run.normal()), last = all.spin.empty() ? start : all.spin.back();
    if (all.first_zero == 0 && spin * start <= 0) all.first_zero = h * (k - spin / (spin - last));
    all.time.push_back(k * h), all.spin.push_back(spin);
    all.energy = std::max(all.energy, std::abs(rattleback.energy(run.velocity(), run.normal()) / before - 1));
  }
  return all;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "bodies that roll: a sleigh, a ball and a rattleback");
  std::vector<std::vector<std::string>> rows;
  double last[2] = {};
  for (int const steps : {40, 80, 160}) {
    rows.push_back({std::to_string(steps)});
    for (int const order : {2, 4}) {
      double const error = sleigh_error(order, steps, 8), before = std::exchange(last[order / 2 - 1], error);
      rows.back().push_back(book::number(error));
      rows.back().push_back(before > 0 ? book::number(std::log2(before / error)) : "–");
      if (steps == 160)
        program.claim(book::measured(std::abs(std::log2(before / error) - order)) < 0.1,
                      "the steps of the sleigh have order " + std::to_string(order));
    }
  }
  program.table("sleigh", {"steps", "error, order 2", "slope", "error, order 4", "slope"}, rows,
                "Velocity of a sleigh after 8 units of time, against the closed form.");

  double const change = change_of_momentum(20000);
  program.figure("ball", change, "relative change of the squared momentum about the contact in 20000 steps");
  program.claim(book::measured(change) < 1e-13,
                "the momentum of the ball about its contact stays to rounding");

  auto const wrong = spun(-5, 8), right = spun(5, 14);
  auto plot = book::Plot("time, s", "spin, rad/s").size(560, 330);
  plot.curve(wrong.time, wrong.spin, "spun the wrong way")
      .curve(right.time, right.spin, "spun the other way");
  program.picture("rattleback", plot.svg(), "The spin of a rattleback about the vertical.");
  program.figure("zero", wrong.first_zero, book::number(wrong.first_zero, 6) + " s",
                 "when the spin is first zero");
  program.figure("slow", right.first_zero, book::number(right.first_zero) + " s", "the same the other way");
  program.figure("energy", std::max(wrong.energy, right.energy), "largest relative change of the energy");
  program.claim(book::measured(std::abs(wrong.first_zero - 2.80443)) < 1e-3,
                "the rattleback stops when other programs say so");
  program.claim(book::measured(right.first_zero / wrong.first_zero) > 4,
                "spun the other way it takes much longer");
  program.headline("a rattleback stops after " + book::number(wrong.first_zero) + " s and spins back",
                   wrong.first_zero);
  return program.finish();
}
