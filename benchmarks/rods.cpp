// What a step of a rod costs: for each section, of a rod that fits into the cache and of one that does not,
// with and without stretch and shear, and by the general road with dual numbers.
//
// A slack rod of rubber hangs by a pin and swings. Processor time, contestants in turns, a tenth of the
// rounds below.
#include <Eigen/Core>

#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/rods/rod.hpp"
#include "actio/rods/rod_lagrangian.hpp"
#include "actio/rods/step_limit.hpp"
#include "benchmark.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::rods;

// So that no compiler leaves out what is computed.
double volatile sink;

Rod rubber(int elements, bool unshearable) {
  auto const section = RodSection::circular(0.02, 1e7, 0.3, 1000);
  auto const shape = RodShape::of_strains(1, elements, {0, 0, 0}, {1, 0, 0, 0});
  RodLoads loads;
  loads.gravity = {0, 0, -9.81};
  loads.start.held = RodEnd::Held::pinned;
  double const longest = longest_rod_step(
      Rod(section, shape, {shape, {}, {}}, loads, {1e-9, unshearable}).constants(), unshearable);
  return {section, shape, {shape, {}, {}}, loads, {longest / 2, unshearable}};
}

/// A step of one section by the general road: the differential of the elements on both sides by dual numbers,
/// and Newton's method on the group.
struct GeneralSection {
  RodSection section = RodSection::circular(0.02, 1e7, 0.3, 1000);
  ElementAtRest<double> rest{100, {1, 0, 0}, {0, 0, 0}};
  KineticAction kinetic{section, 0.01, 1e-5};
  StrainAction strain{section, rest, 1e-5};
  Element<SE<3>, double> f = identity<double>(SE<3>{}), e = f;

  GeneralSection() {
    f.value(0, 3) = -1e-5, e.value(0, 3) = -0.01;
    f = restore(f);
  }
  void step() {
    auto const force = left_differential(strain, e) - right_differential(strain, e);
    auto const mu = -right_differential(kinetic, f) + force;
    f = solve_on_group(momentum_equation_left(kinetic, mu), f).value;
    sink = f.value(0, 3);
  }
};

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "rods: what a step of a section costs");
  Rod free = rubber(1000, false), stiff = rubber(1000, true),
      large = rubber(program.length(100000, 20000), false);
  GeneralSection general;
  free.step(10), stiff.step(10), large.step(2), general.step();
  long const steps = 200, few = 40;
  auto const count = [](Rod const& rod, long made) {
    return static_cast<double>(made) * static_cast<double>(rod.sections());
  };
  auto const times = benchmark::in_turns(
      program.rounds(31), {{"free", [&] { free.step(steps); }, count(free, steps)},
                           {"without stretch and shear", [&] { stiff.step(few); }, count(stiff, few)},
                           {"large", [&] { large.step(4); }, count(large, 4)},
                           {"general road",
                            [&] {
                              for (int k = 0; k < 200; ++k) general.step();
                            },
                            200}});
  auto const ns = [&](std::size_t k) { return 1e9 * benchmark::best_tenth(times[k]); };
  program.figure("free_ns", ns(0), "ns for a section and step, 1000 elements");
  program.figure("stiff_ns", ns(1), "the same without stretch and shear");
  program.figure("large_ns", ns(2), "the same as the first with a hundred times as many elements");
  program.figure("general", benchmark::ratio_of_best(times[3], times[0]),
                 "a section by dual numbers and Newton's method, in steps of the first");
  program.claim_of_time(ns(0) <= 120, "a section and step takes at most 120 ns");
  program.claim_of_time(ns(1) <= 600, "and 600 ns without stretch and shear");
  program.headline("a section of a rod takes " + book::number(ns(0)) + " ns a step", ns(0));
  return program.finish();
}
