// Media on one rank and on two, beside threads of one process: what a second process gains, and what the
// model says of more.
//
// Runs of actio-mpi on this machine: a block of rubber in the plane, so many steps, and three times as many;
// their difference is the time of the steps, with all that a run does between them. Wall time, contestants in
// turns, the best tenth of the rounds. A rank has one thread, so that the gain of a second rank is seen.
#include <Eigen/Core>

#include "benchmark.hpp"
#include "runs.hpp"
#include "timing.hpp"

/// A way to run a medium.
struct Way {
  std::string name, command;
  bool water;         ///< in a box, or a block of rubber
  int columns, rows;  ///< of cells
  long steps;         ///< of the shorter run; the longer one has three times as many
  std::vector<double> shorter = {}, longer = {};  ///< seconds of both
  double copies = 0;                              ///< seconds in copies of the last one

  /// Seconds of a step: of those that the longer run has more.
  double seconds() const {
    return (benchmark::best_tenth(longer) - benchmark::best_tenth(shorter)) /
           (2.0 * static_cast<double>(steps));
  }
  /// The cells, for people.
  std::string cells() const { return std::to_string(columns) + " x " + std::to_string(rows); }
  /// So many steps of it.
  std::string scene(long count) const {
    std::string const box = "mesh = { shape = \"box\", lower = [0, 0], cells = [" + std::to_string(columns) +
                            ", " + std::to_string(rows) + "], upper = ";
    double const step = water ? 0.25 / rows : 0.25, until = step * static_cast<double>(count);
    auto const upper = [&](std::string const& x, std::string const& y) {
      return "[" + x + ", " + y + "] }\n";
    };
    std::string const text =
        water ? "kind = \"incompressible_fluid\"\n" + box + upper("1", "1") +
                    "boundary = { left = \"sliding\", right = \"sliding\", bottom = \"sliding\", top = "
                    "\"sliding\" }\n[initial]\nproject = true\n"
                    "velocity = [\"sin(pi*X)*cos(pi*Y)\", \"-cos(pi*X)*sin(pi*Y)\"]\n"
              : "kind = \"elastic_body\"\n" + box + upper(std::to_string(columns), std::to_string(rows)) +
                    "material = { name = \"neo_hookean\", mu = 1, kappa = 3 }\n[initial]\n"
                    "velocity = [\"0.01*Y/" +
                    std::to_string(rows) + "\", \"0\"]\n";
    return "[system]\n" + text + "[method]\nstep = " + book::number(step, 17) +
           "\n[run]\nuntil = " + book::number(until, 17) + "\nevery = " + book::number(until, 17) +
           "\n[output]\nquantities = [\"" + (water ? "volume_defect" : "momentum") + "\"]\n";
  }
};

/// Runs it once.
/// @return what its summary.json says
nlohmann::json run(Way const& way, long steps) {
  benchmark::Folder const folder;
  std::ofstream(folder.path + "/scene.toml") << way.scene(steps);
  std::string const line = way.command + " run " + folder.path + "/scene.toml --force --quiet --out " +
                           folder.path + "/run > " + folder.path + "/told 2>&1";
  if (std::system(line.c_str()) != 0) throw std::runtime_error("a run failed: " + line);
  return nlohmann::json::parse(std::ifstream(folder.path + "/run/summary.json"));
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "media on two ranks");
  std::string const mpi = ACTIO_MPI;
  if (mpi.empty()) {
    program.say("MPI was not found when this was built: nothing is measured.");
    return program.finish();
  }
  ::setenv("ACTIO_CHECKPOINT_SECONDS", "1000", 1);  // a busy machine would have more of them
  int const size = program.length(1000, 400), rounds = program.length(5, 2);
  long const steps = program.length(200, 60), few = program.length(20, 10);
  int const boxes = program.length(512, 192);
  auto const threads = [](int count) { return "ACTIO_THREADS=" + std::to_string(count) + " " ACTIO_COMMAND; };
  auto const on = [&](int ranks) {
    return "ACTIO_THREADS=1 " + benchmark::on_ranks(ranks, ACTIO_MPIEXEC, mpi);
  };
  std::vector<Way> ways{{"rubber, one process", threads(1), false, size, size, steps},
                        {"rubber, two threads", threads(2), false, size, size, steps},
                        {"rubber, one rank", on(1), false, size, size, steps},
                        {"rubber, two ranks", on(2), false, size, size, steps},
                        {"rubber, two ranks, twice the cells", on(2), false, size, 2 * size, steps},
                        {"water, one process", threads(1), true, boxes, boxes, few},
                        {"water, one rank", on(1), true, boxes, boxes, few},
                        {"water, two ranks", on(2), true, boxes, boxes, few}};
  for (int round = 0; round < rounds; ++round)
    for (Way& way : ways) {
      way.shorter.push_back(run(way, way.steps)["wall_seconds"].get<double>());
      auto const told = run(way, 3 * way.steps);
      way.longer.push_back(told["wall_seconds"].get<double>());
      way.copies = told.value("seconds_in_copies", 0.0);
    }
  double const alone = ways[0].seconds(), one = ways[2].seconds(), two = ways[3].seconds(),
               twice = ways[4].seconds();
  std::vector<std::vector<std::string>> measured;
  for (Way const& way : ways) {
    double const first = way.water ? ways[5].seconds() : alone;
    measured.push_back({way.name, way.cells(), book::number(1e3 * way.seconds()),
                        book::number(first / way.seconds(), 3),
                        book::number(100 * way.copies / way.longer.back(), 2) + " %"});
  }
  program.table(
      "measured", {"run", "cells", "ms a step", "times as fast as one process", "in copies"}, measured,
      "Media on two cores: rubber by explicit steps, incompressible water whose pressures are found by "
      "multigrid. In copies: the part of its last run that rank 0 spends on copies of rows, in which it "
      "also waits for rank 1.");
  double const ns = 1e9 * alone / (static_cast<double>(size) * size);
  program.figure("ns", ns, "ns for a cell and step without MPI");
  program.figure("threads", alone / ways[1].seconds(), "times as fast with two threads");
  program.figure("one", 100 * (one / alone - 1), "per cent that one rank takes longer than without MPI");
  program.figure("two", one / two, "times as fast on two ranks");
  program.figure("weak", 100 * (twice / one - 1), "per cent longer for twice the cells on two ranks");
  program.figure("water", ways[6].seconds() / ways[7].seconds(), "times as fast on two ranks, water");
  program.figure("water_one", 100 * (ways[6].seconds() / ways[5].seconds() - 1),
                 "per cent that water on one rank takes longer than without MPI");
  // The model: a message takes 2 us and 0.1 ns for a byte (10 GB/s); two neighbours.
  std::vector<std::vector<std::string>> table;
  for (auto const& [n, what] : {std::pair{1000, "1000 x 1000"}, std::pair{100, "100 x 100"}}) {
    double const compute = ns * 1e-9 * n * n, halo = 2 * (2e-6 + 32.0 * n / 10e9);
    table.push_back({what, book::number(1e6 * compute), book::number(1e6 * halo),
                     book::number(100 * halo / (halo + compute), 2) + " %"});
  }
  program.table("model", {"cells a rank", "steps, us", "copies, us", "lost"}, table,
                "A step of a rank among many, by the model: 2 us for a message and 10 GB/s.");
  program.claim_of_time(one <= 1.02 * alone, "one rank takes at most 2 % longer than without MPI");
  program.claim_of_time(one / two >= 1.8, "two ranks are at least 1.8 times as fast as one");
  program.claim_of_time(ways[6].seconds() >= 1.6 * ways[7].seconds(),
                        "two ranks are at least 1.6 times as fast as one with water");
  program.headline("two ranks are " + book::number(one / two, 2) + " times as fast as one", one / two);
  return program.finish();
}
