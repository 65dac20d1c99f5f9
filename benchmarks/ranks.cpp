// One medium on one rank and on two, beside threads of one process: what a second process gains, and what the
// model says of more.
//
// Runs of actio-mpi on this machine: a block of rubber in the plane, so many steps, and three times as many;
// their difference is the time of the steps, with all that a run does between them. Wall time, contestants in
// turns, the best tenth of the rounds. A rank has one thread, so that the gain of a second rank is seen.
#include <Eigen/Core>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "benchmark.hpp"
#include "timing.hpp"

namespace fs = std::filesystem;

/// A folder among the temporary files, gone at the end.
struct Folder {
  std::string path = (fs::temp_directory_path() / "actio_ranks_XXXXXX").string();
  Folder() {
    if (!::mkdtemp(path.data())) throw std::runtime_error("no folder among the temporary files");
  }
  ~Folder() { fs::remove_all(path); }
};

/// A way to run the block.
struct Way {
  std::string name, command;
  int rows;
  std::vector<double> shorter = {},
                      longer = {};  ///< seconds of a run of so many steps, and three times as many
  double copies = 0;                ///< seconds in copies of the last one

  /// Seconds of the steps between both.
  double seconds() const { return benchmark::best_tenth(longer) - benchmark::best_tenth(shorter); }
};

/// Runs it once.
/// @return what its summary.json says
nlohmann::json run(Way const& way, int columns, long steps) {
  Folder const folder;
  double const until = 0.25 * static_cast<double>(steps);
  std::ofstream(folder.path + "/scene.toml")
      << "[system]\nkind = \"elastic_body\"\nmesh = { shape = \"box\", lower = [0, 0], upper = [" << columns
      << ", " << way.rows << "], cells = [" << columns << ", " << way.rows
      << "] }\nmaterial = { name = \"neo_hookean\", mu = 1, kappa = 3 }\n[initial]\nvelocity = [\"0.01*Y/"
      << way.rows << "\", \"0\"]\n[method]\nstep = 0.25\n[run]\nuntil = " << until << "\nevery = " << until
      << "\n[output]\nquantities = [\"momentum\"]\n";
  std::string const line = way.command + " run " + folder.path + "/scene.toml --force --quiet --out " +
                           folder.path + "/run > " + folder.path + "/told 2>&1";
  if (std::system(line.c_str()) != 0) throw std::runtime_error("a run failed: " + line);
  return nlohmann::json::parse(std::ifstream(folder.path + "/run/summary.json"));
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "one medium on two ranks");
  std::string const mpi = ACTIO_MPI;
  if (mpi.empty()) {
    program.say("MPI was not found when this was built: nothing is measured.");
    return program.finish();
  }
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1), ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  ::setenv("ACTIO_CHECKPOINT_SECONDS", "1000", 1);  // a busy machine would have more of them
  int const size = program.length(1000, 400), rounds = program.length(7, 2);
  long const steps = program.length(200, 60);
  auto const threads = [](int count) { return "ACTIO_THREADS=" + std::to_string(count) + " " ACTIO_COMMAND; };
  auto const on = [&](int ranks) {
    return "ACTIO_THREADS=1 " ACTIO_MPIEXEC " --oversubscribe --bind-to none -n " + std::to_string(ranks) +
           " " + mpi;
  };
  std::vector<Way> ways{{"one process", threads(1), size},
                        {"two threads", threads(2), size},
                        {"one rank", on(1), size},
                        {"two ranks", on(2), size},
                        {"two ranks, twice the cells", on(2), 2 * size}};
  for (int round = 0; round < rounds; ++round)
    for (Way& way : ways) {
      way.shorter.push_back(run(way, size, steps)["wall_seconds"].get<double>());
      auto const told = run(way, size, 3 * steps);
      way.longer.push_back(told["wall_seconds"].get<double>());
      way.copies = told.value("seconds_in_copies", 0.0);
    }
  double const alone = ways[0].seconds(), one = ways[2].seconds(), two = ways[3].seconds(),
               twice = ways[4].seconds(), each = 1e3 / (2.0 * static_cast<double>(steps));
  std::vector<std::vector<std::string>> measured;
  for (Way const& way : ways)
    measured.push_back({way.name, std::to_string(size) + " x " + std::to_string(way.rows),
                        book::number(each * way.seconds()), book::number(alone / way.seconds(), 3),
                        book::number(100 * way.copies / way.longer.back(), 2) + " %"});
  program.table(
      "measured", {"run", "cells", "ms a step", "times as fast as one process", "in copies"}, measured,
      "One medium on two cores. In copies: the part of its last run that rank 0 spends on copies of "
      "rows, in which it also waits for rank 1.");
  double const ns = 1e6 * each * alone / (static_cast<double>(size) * size);
  program.figure("ns", ns, "ns for a cell and step without MPI");
  program.figure("threads", alone / ways[1].seconds(), "times as fast with two threads");
  program.figure("one", 100 * (one / alone - 1), "per cent that one rank takes longer than without MPI");
  program.figure("two", one / two, "times as fast on two ranks");
  program.figure("weak", 100 * (twice / one - 1), "per cent longer for twice the cells on two ranks");
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
  program.headline("two ranks are " + book::number(one / two, 2) + " times as fast as one", one / two);
  return program.finish();
}
