// What a step of an incompressible fluid on a box costs: nanoseconds for an unknown, of which a cell has
// three, two coordinates and a pressure; by multigrid and by Cholesky factors, in the same rounds.
#include "actio/incompressible_media/incompressible_medium.hpp"
#include "benchmark.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::media;
using book::number;

namespace {

/// A block of fluid that is sheared and stretched.
IncompressibleMedium<2> block(int n, PressureBy by) {
  IncompressibleStart<2> start;
  start.velocity = [](auto const& X) {
    return std::array{0.5 * X[0] - 0.6 * X[1] + 0.3 * std::sin(3 * X[1]), 0.8 * X[0] - 0.5 * X[1]};
  };
  start.project = true;
  VolumeSolving solving;
  solving.by = by;
  return {box_mesh({-1, -1}, {1, 1}, {n, n}), {}, start, 0.2 / n, {}, {}, solving};
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv,
                               "an incompressible fluid on a box: nanoseconds for an unknown and step");
  std::vector<book::Program::Row> rows;
  double largest = 0, ratio = HUGE_VAL, rounds = 0;
  auto const sizes = program.length(std::vector{32, 64, 128, 256}, std::vector{32, 64, 256});
  for (int const n : sizes) {
    auto cycles = block(n, PressureBy::multigrid);
    auto const unknowns = 3.0 * n * n;
    int const steps = n < 100 ? 10 : 5;
    long made = 0, taken = 0;
    cycles.step(steps);
    std::vector<benchmark::Contestant> contestants{{"multigrid",
                                                    [&] {
                                                      for (int k = 0; k < steps; ++k)
                                                        cycles.step(), taken += cycles.rounds(), ++made;
                                                    },
                                                    steps * unknowns}};
    // Factors of the largest box take minutes.
    std::unique_ptr<IncompressibleMedium<2>> factors;
    if (n < 200) {
      factors.reset(new IncompressibleMedium<2>(block(n, PressureBy::factors)));
      factors->step(steps);
      contestants.push_back({"factors", [&] { factors->step(steps); }, steps * unknowns});
    }
    // So many that a matrix is built as often as in a run.
    auto const times = benchmark::in_turns(program.length(8, 4), contestants);
    double const ns = 1e9 * benchmark::median(times[0]);
    rounds = static_cast<double>(taken) / static_cast<double>(made), largest = ns;
    if (factors) ratio = std::min(ratio, benchmark::median(times[1]) / benchmark::median(times[0]));
    rows.push_back({number(unknowns), number(ns, 3), number(rounds, 2),
                    factors ? number(1e9 * benchmark::median(times[1]), 3) : ""});
  }
  program.table(
      "cost", {"unknowns", "multigrid, ns", "rounds", "factors, ns"}, rows,
      "A step of a block of fluid that is sheared and stretched: nanoseconds for an unknown, two "
      "coordinates and a pressure a cell, rounds of a step, and the same by Cholesky factors; medians.");
  program.figure("largest", largest, "ns for an unknown and step at 2e5 unknowns");
  program.figure("rounds", rounds, "rounds of a step there");
  program.claim_of_time(largest <= 120, "at most 120 ns for an unknown and step");
  program.headline(number(largest, 2) + " ns for an unknown and step", largest);
  return program.finish();
}
