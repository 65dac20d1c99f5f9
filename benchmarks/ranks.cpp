// One medium on one rank and on two: what a second process gains, and what the model says of more.
//
// Runs of actio-mpi on this machine: a block of rubber in the plane, so many steps, and three times as many;
// their difference is the time of the steps. Wall time, the least of some rounds. Threads are left out: a
// rank has one.
#include <Eigen/Core>

#include <sstream>

#include "benchmark.hpp"
#include "runs.hpp"

/// Seconds that twice so many steps of a block take.
/// @param command  that runs a scene
double seconds_of_steps(std::string const& command, int columns, int rows, long steps, int rounds) {
  auto const scene = [&](long count) {
    std::ostringstream out;
    out << "[system]\nkind = \"elastic_body\"\nmesh = { shape = \"box\", lower = [0, 0], upper = [" << columns
        << ", " << rows << "], cells = [" << columns << ", " << rows
        << "] }\nmaterial = { name = \"neo_hookean\", mu = 1, kappa = 3 }\n[initial]\nvelocity = [\"0.01*Y/"
        << rows << "\", \"0\"]\n[method]\nstep = 0.25\n[run]\nuntil = " << 0.25 * static_cast<double>(count)
        << "\nevery = " << 0.25 * static_cast<double>(count) << "\n[output]\nquantities = [\"momentum\"]\n";
    return out.str();
  };
  return benchmark::seconds_of_steps(benchmark::Folder(), command, scene, steps, rounds);
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "one medium on two ranks");
  std::string const mpi = ACTIO_MPI;
  if (mpi.empty()) {
    program.say("MPI was not found when this was built: nothing is measured.");
    return program.finish();
  }
  int const columns = program.length(1000, 400), rows = program.length(1000, 400),
            rounds = program.length(5, 2);
  long const steps = program.length(100, 60);
  // One thread each: what a second rank gains is to be seen, and not what a thread does.
  auto const on = [&](int ranks) { return benchmark::on_ranks(ranks, ACTIO_MPIEXEC, mpi); };
  double const alone = seconds_of_steps("taskset -c 0 " ACTIO_COMMAND, columns, rows, steps, rounds),
               one = seconds_of_steps(on(1), columns, rows, steps, rounds),
               two = seconds_of_steps(on(2), columns, rows, steps, rounds),
               twice = seconds_of_steps(on(2), columns, 2 * rows, steps, rounds);
  double const ns = 1e9 * alone / (2.0 * static_cast<double>(steps) * columns * rows);
  program.figure("ns", ns, "ns for a cell and step without MPI");
  program.figure("one", 100 * (one / alone - 1), "per cent that one rank takes longer than without MPI");
  program.figure("two", one / two, "times as fast on two ranks");
  program.figure("weak", 100 * (twice / one - 1), "per cent longer for twice the cells on two ranks");
  // The model: a message takes 2 us and 0.1 ns for a byte (10 GB/s); two neighbours.
  std::vector<std::vector<std::string>> table;
  for (auto const& [size, what] : {std::pair{1000, "1000 x 1000"}, std::pair{100, "100 x 100"}}) {
    double const compute = ns * 1e-9 * size * size, halo = 2 * (2e-6 + 32.0 * size / 10e9);
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
