// What constraints on velocities cost: a step on SE(3) with the three rows of rolling, beside one without;
// and a rattleback, by formulas and with its steps written out.
//
// A lopsided ball of three moments of inertia turns by a hundredth of a radian in a step. Processor time,
// contestants in turns, a tenth of the rounds below; instructions by valgrind where that is there.
#include <Eigen/Core>

#include <numbers>

#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "actio/nonholonomic/constrained_integrator.hpp"
#include "actio/nonholonomic/rolling_steps.hpp"
#include "actio/reduction/composition.hpp"
#include "benchmark.hpp"
#include "callgrind.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::systems;
using List = std::vector<double>;

// So that no compiler leaves out what is computed.
double volatile sink;

/// A body that rolls, from texts.
struct Body {
  std::shared_ptr<ReducedSystem const> system;
  std::shared_ptr<VelocityConstraints const> constraints;
  ConstrainedState start;

  Body(std::string const& lagrangian, std::string const& contact, List const& w, List const& up) {
    auto const algebra = named_algebra("SE(3)");
    auto names = algebra.components;
    for (char const* const u : {"u1", "u2", "u3", "u4"}) names.push_back(u);
    system = std::make_shared<ReducedSystem const>(algebra, systems::Side::left, 1,
                                                   parse_formula(contact + lagrangian, names));
    names.push_back("t");
    std::vector<Tape> rows;
    for (char const* const row : {"v1 + w2*r3 - w3*r2", "v2 + w3*r1 - w1*r3", "v3 + w1*r2 - w2*r1"})
      rows.push_back(parse_formula(contact + row, names));
    constraints = std::make_shared<VelocityConstraints const>(*system, rows);
    // The velocity of the centre of mass is what a blow makes of none.
    List v = w;
    v.resize(6, 0);
    start = constrained_state(*system, *constraints, v, {up[0], up[1], up[2], 0}, 0, HUGE_VAL);
  }
  RattleIntegrator rolling(double h, List const& fractions = {1}) const {
    return {system, constraints, h, fractions, start};
  }
  ChartIntegrator free(double h) const { return {system, h, {1}, start.point, start.velocity}; }
};

Body ball() {
  return {"(w1^2 + 2*w2^2 + 2.5*w3^2 + v1^2 + v2^2 + v3^2)/2 - 0.3*u1",
          "r1 = 0.1 - u1; r2 = -u2; r3 = -u3;",
          {0.9, -0.4, 1.2},
          {0.36, 0.48, 0.8}};
}
template <class Run>
void take(Run& run, long steps) {
  for (long k = 0; k < steps; ++k) run.step();
}

// The rattleback of Kane and Levinson over twelve seconds, spun the wrong way at 5 rad/s.
struct Rattleback {
  double tilt = std::sin(std::numbers::pi / 360);
  Triad<double> up{tilt, tilt, std::sqrt(1 - 2 * tilt * tilt)};
  RollingBody<Ellipsoid> body{{{20, 3, 2}, 1}, {2, 16, 17, 0, 0, -0.2}, 1, 981};

  double spin_after(double time, int order, int steps) const {
    RollingSteps<Ellipsoid> run(body, time / steps, symmetric_composition<double>(order), -5.0 * up, up);
    take(run, steps);
    return dot(run.velocity(), run.normal());
  }
  Body by_formulas() const {
    return {"(2*w1^2 + 16*w2^2 + 17*w3^2 - 0.4*w1*w2 + v1^2 + v2^2 + v3^2)/2 - 981*(S - u3)",
            "S = sqrt((20*u1)^2 + (3*u2)^2 + (2*u3)^2); r1 = -400*u1/S; r2 = -9*u2/S; r3 = 1 - 4*u3/S;",
            {-5 * up.x, -5 * up.y, -5 * up.z},
            {up.x, up.y, up.z}};
  }
};

constexpr double h = 0.01;
constexpr long few = 1000, many = 4 * few;

int count_all() {
  Body const body = ball();
  for (long const steps : {few, many}) {
    std::string const number = std::to_string(steps);
    benchmark::counted(("free " + number).c_str(), [&] {
      auto run = body.free(h);
      take(run, steps);
      sink = run.point().momentum[0];
    });
    benchmark::counted(("rolling " + number).c_str(), [&] {
      auto run = body.rolling(h);
      take(run, steps);
      sink = run.point().momentum[0];
    });
  }
  return 0;
}

int main(int argc, char** argv) {
  if (argc > 1 && !std::strcmp(argv[1], "--count")) return count_all();
  benchmark::Benchmark program(argc, argv, "bodies that roll: what constraints on velocities cost");
  Body const body = ball();
  auto free = body.free(h);
  auto rolling = body.rolling(h);
  take(free, 100), take(rolling, 100);
  long const steps = 2000;
  double const units = static_cast<double>(steps);
  auto const times = benchmark::in_turns(
      program.rounds(31),
      {{"free", [&] { take(free, steps); }, units}, {"rolling", [&] { take(rolling, steps); }, units}});
  double const in_time = benchmark::ratio_of_best(times[1], times[0]);
  program.figure("step_us", 1e6 * benchmark::best_tenth(times[1]),
                 "microseconds for a step of a body that rolls");
  program.figure("ratio", in_time, "a step on SE(3) with the rows of rolling, in steps without");
  program.claim_of_time(in_time <= 2.5, "three rows cost at most one and a half free steps more");
  if (benchmark::pieces_can_be_counted()) {
    auto counts =
        benchmark::counted_pieces("'" + std::filesystem::canonical("/proc/self/exe").string() + "' --count");
    auto const each = [&](std::string const& kind) {
      return (counts[kind + " " + std::to_string(many)] - counts[kind + " " + std::to_string(few)]) /
             static_cast<double>(many - few);
    };
    if (!counts.empty()) {
      double const instructions = each("rolling") / each("free");
      program.figure("instructions", instructions, "the same in instructions");
      program.claim(book::measured(instructions) < 2.5, "and at most as much in instructions");
    }
  }

  Rattleback const stone;
  double const truth = stone.spin_after(12, 8, 4800);
  int const enough = 8500;
  double const error = std::abs(stone.spin_after(12, 4, enough) - truth);
  auto const twelve = benchmark::in_turns(
      program.rounds(31), {{"written out", [&] { sink = stone.spin_after(12, 4, enough); }, 1.0}});
  double const ms = 1e3 * benchmark::best_tenth(twelve[0]);
  Body const texts = stone.by_formulas();
  auto formulas = texts.rolling(12.0 / enough, suzuki<double>());
  int const some = program.length(enough, 500);
  double const by_formulas =
      1e3 * benchmark::processor_seconds_of([&] { take(formulas, some); }) * enough / some;
  program.figure("error", error, "rad/s, error of the spin of a rattleback after 12 s");
  program.figure("rattleback_ms", ms, "ms for these 12 s, written out");
  program.figure("formulas_ms", by_formulas, "ms for the same by formulas");
  program.claim(book::measured(error) < 1e-4, "the spin after 12 s is right to 1e-4 rad/s");
  program.claim_of_time(ms <= 50, "in at most 50 ms");
  program.headline("12 s of a rattleback to 1e-4 rad/s take " + book::number(ms) + " ms", ms);
  return program.finish();
}
