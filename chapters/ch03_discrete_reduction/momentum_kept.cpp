// Momentum conserved: a heavy body on a ball joint, symmetric about the vertical and about nothing else.
//
// What is shown. Gravity singles out the vertical, so of all turns of space only those about it are
// symmetries, and the discrete Euler-Lagrange equations (3.2) are solved for attitudes. Still the momentum
// about the vertical stays what it is, to rounding (discrete Noether, 3.8), at a step so long that the energy
// is off by a per cent; and the energy, which no theorem conserves, does not run away. Runge-Kutta conserves
// neither. Read first. The section "What a symmetry conserves" of chapter 3.
//
//   g        attitude in SO(3), body to space         L       Lagrangian on TG, J
//   xi       spatial velocity g' g^-1, 1/s            action  discrete Lagrangian on pairs of attitudes, J s
//   Omega    body velocity                            J       momentum about the vertical, J s
//   h        step, s                                  E       energy, J
//
// Compiled at -O2: it takes many steps.
#include "actio/groups/rotations.hpp"
#include "actio/reduction/discrete_momentum.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/momentum_map.hpp"
#include "book/plot.hpp"
#include "book/sphere.hpp"

using namespace actio;
using Matrix3d = actio::Matrix<double, 3, 3>;
using Vector3d = actio::Vector<double, 3>;
using Attitude = Element<SO<3>, double>;
using Moving = State<SO<3>, double>;

// Classical Runge-Kutta for attitude and spatial velocity; the attitude is brought back on the group after
// the step.
template <class Lagrangian>
Moving runge_kutta(Lagrangian const& L, Moving const& v, double h) {
  Moving sum = v, stage = v;
  for (int i = 0; i < 4; ++i) {
    Matrix3d const turning = SO<3>::hat(stage.velocity.coordinates) * stage.configuration.value;
    auto const acceleration = lagrange_acceleration(L, stage);
    double const share = h * (i == 0 || i == 3 ? 1 : 2) / 6, next = i == 2 ? h : h / 2;
    sum.configuration.value += share * turning, sum.velocity = sum.velocity + share * acceleration;
    stage.configuration.value = v.configuration.value + next * turning,
    stage.velocity = v.velocity + next * acceleration;
  }
  sum.configuration = restore(sum.configuration);
  return sum;
}

// 1. The body: a flat board of 0.6 kg, 40 cm by 20 cm by 1 cm, hung by one end of its long axis, axis 3.
double const mass = 0.6, length = 0.4, width = 0.2, thickness = 0.01, gravity = 9.81;
Vector3d const I(mass*(length* length / 3 + thickness * thickness / 12),
                 mass*(length* length / 3 + width * width / 12),
                 mass*(width* width + thickness * thickness) / 12);

// 2. Its Lagrangian on TG: the energy of rotation, in the body frame, less the weight times the height of the
// middle of the board.
auto const L = [](auto const& v) {
  auto const Omega = body_velocity(v).coordinates;
  return (Omega[0] * Omega[0] * I[0] + Omega[1] * Omega[1] * I[1] + Omega[2] * Omega[2] * I[2]) / 2.0 -
         v.configuration.value(2, 2) * (mass * gravity * length / 2);
};
double const h = 0.03;
int const steps = 10000;
auto const action = discretize_left(L, h, at_first);
SO<3> const turns;
auto const about_vertical = left_translation(basis_velocity<double>(turns, 2)),
           about_level = left_translation(basis_velocity<double>(turns, 0));

// 3. Hold it out, 100 degrees from straight up, and throw it round.
Moving throw_round() {
  Attitude const g0 = exp(velocity(turns, Vector3d(0, 100 * M_PI / 180, 0)));
  return {g0, velocity(turns, Vector3d(1.0, 0.5, 4.0))};
}

// The energy, counted from the board hanging at rest.
double energy_above_rest(Moving const& v) { return energy(L, v) + mass * gravity * length / 2; }

// What is written down on the way: the errors of the energy in per cent, where the long axis points, and the
// largest errors of the momentum.
struct Record {
  std::vector<double> time, energy_discrete, energy_classical;
  std::vector<Vector3d> trace;
  double discrete_J = 0, classical_J = 0, level_J = 0;
};

// 4. The first step leaves with the momentum of the start.
Attitude first_step(Moving const& start) {
  Attitude const g0 = start.configuration;
  auto const mu0 = legendre(L, start);
  return solve_on_group([&](auto const& g) { return D1(action, like(g, g0), g) + like(g, mu0); },
                        exp(h * start.velocity) * g0)
      .value;
}

// Every other step solves (3.2). Runge-Kutta beside it.
Record follow(Moving const& start) {
  double const J = noether_momentum(L, start, about_vertical), E = energy_above_rest(start);
  auto const energy_error = [&](Moving const& v) { return energy_above_rest(v) / E - 1; };
  Attitude before = start.configuration, now = first_step(start);
  Moving classical = runge_kutta(L, start, h);

  Record r;
  r.trace.push_back(before.value.col(2));
  for (int k = 1; k <= steps; ++k) {
    // The momentum with which the step arrives, and the velocity that goes with it.
    auto const Omega = Ad_star(now, legendre_target(action, before, now)).components.cwiseQuotient(I).eval();
    Moving const arrived{now, Ad(now, velocity(turns, Omega))};
    r.discrete_J =
        std::max(r.discrete_J, std::abs(discrete_momentum(action, before, now, about_vertical) / J - 1));
    r.classical_J = std::max(r.classical_J, std::abs(noether_momentum(L, classical, about_vertical) / J - 1));
    r.level_J = std::max(r.level_J, std::abs(discrete_momentum(action, before, now, about_level) / J));
    r.time.push_back(k * h);
    r.energy_discrete.push_back(100 * energy_error(arrived));
    r.energy_classical.push_back(100 * energy_error(classical));
    if (k < 650) r.trace.push_back(now.value.col(2));

    Attitude const next = step_euler_lagrange(action, before, now).value;
    before = now, now = next;
    classical = runge_kutta(L, classical, h);
  }
  return r;
}

// 5. Show where its long axis points, and the energy.
void draw(book::Program& program, Record const& r) {
  program.picture(
      "path", book::Sphere(30, -50).curve(r.trace, "where the long axis points").svg(),
      "Where the board points in the first 19 seconds, seen from below, straight from step to step. "
      "Turn the whole picture about the vertical, and it is that of another motion: this is the "
      "symmetry, and there is no other.");
  program.picture("energy",
                  book::Plot("time, s", "error of the energy, %")
                      .curve(r.time, r.energy_classical, "Runge-Kutta", {.colour = 2})
                      .curve(r.time, r.energy_discrete, "discrete Euler-Lagrange", {.colour = 1, .width = 1})
                      .svg(),
                  "Energy over 10 000 steps of 0.03 s. The discrete motion has an error that "
                  "comes and goes with the swing and does not add up; that of Runge-Kutta only "
                  "grows: the method drives the board.");
}

// 6. The energy by quarters of the time: what is bounded is as large in each.
std::vector<double> tabulate_quarters(book::Program& program, Record const& r) {
  std::vector<std::vector<std::string>> rows;
  std::vector<double> worst;
  for (int quarter = 0; quarter < 4; ++quarter) {
    auto const largest = [&](std::vector<double> const& errors) {
      auto const part = std::span(errors).subspan(quarter * steps / 4, steps / 4);
      return std::max(std::ranges::max(part), -std::ranges::min(part));
    };
    worst.push_back(largest(r.energy_discrete));
    rows.push_back({book::text(quarter * steps / 4 * h, " to ", (quarter + 1) * steps / 4 * h),
                    book::number(worst.back(), 2), book::number(largest(r.energy_classical), 2)});
  }
  program.table("energy", {"seconds", "discrete", "Runge-Kutta"}, rows,
                "Largest error of the energy in each quarter of the time, in per cent.");
  return worst;
}

// 7. What must be so. The momentum picks up a rounding error a step; at worst they add up.
void check(book::Program& program, Record const& r, std::vector<double> const& worst) {
  program.figure("kept", r.discrete_J, "change of the momentum about the vertical, relative");
  program.figure("lost", r.classical_J, "the same by Runge-Kutta");
  program.figure("level", r.level_J, "change of the momentum about a level axis, over the vertical one");
  program.claim(book::measured(r.discrete_J) < steps * 0x1p-52,
                "the momentum about the vertical is conserved to rounding");
  program.claim(book::measured(r.level_J) > 1, "that about a level axis is not");
  program.claim(book::measured(r.classical_J) > 0.01, "Runge-Kutta does not conserve it");
  program.claim(book::measured(worst[3]) < 1.5 * worst[0] && book::measured(worst[3]) < 3,
                "the error of the energy does not grow, and stays below 3 per cent");
  program.claim(book::measured(r.energy_classical.back()) > 5 * worst[3], "that of Runge-Kutta does");
  program.headline("vertical momentum conserved to " + book::number(r.discrete_J, 2) +
                       "; Runge-Kutta changes it by " + book::number(100 * r.classical_J, 2) + " %",
                   r.discrete_J);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a board hung by one end and thrown round: what its one symmetry conserves, "
                        "and what happens to the energy");
  Record const r = follow(throw_round());
  draw(program, r);
  check(program, r, tabulate_quarters(program, r));
  return program.finish();
}
