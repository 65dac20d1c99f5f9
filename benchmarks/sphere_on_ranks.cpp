// The fluid on the sphere on one process and on two ranks; and what a model says of larger matrices on more.
//
// Runs of the built commands: a developed flow, random coefficients with an enstrophy spectrum l^-1 up to the
// grid. Wall time of a step, the least of some rounds; memory of each rank by GNU time. The model counts the
// operations and the bytes of a step in this process and measures their rates on one processor.
#include <Eigen/Core>

#include <random>
#include <sstream>

#include "actio/quantized_sphere/matrix_harmonics.hpp"
#include "actio/skew_matrices/blas_products.hpp"
#include "actio/skew_matrices/dealt_blocks.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "benchmark.hpp"
#include "runs.hpp"
#include "timing.hpp"

extern "C" {
actio::sphere::Gemm<double> dgemm_;
actio::sphere::Gemm<float> sgemm_;
void openblas_set_num_threads(int);
}

using namespace actio::sphere;
using book::number;

/// Steps of one time a run, h |P|/(2 hbar) being about a tenth, in which P has the largest eigenvalue 1/2.
double step_of(int n) { return 1.5 / n; }

/// A scene of so many steps.
std::string scene(int n, long steps) {
  std::ostringstream out;
  out.precision(17);
  double const end = step_of(n) * static_cast<double>(steps);
  out << "[system]\nkind = \"vorticity_sphere\"\nN = " << n << "\n[initial]\nrandom = { lmax = " << n - 1
      << ", slope = -3 }\n[method]\nname = \"lie_poisson\"\nstep = " << step_of(n)
      << "\n[run]\nuntil = " << end << "\nevery = " << end << "\n[output]\nquantities = [\"energy\"]\n";
  return out.str();
}

/// Wall seconds of a step, and the memory of ranks after some.
struct Run {
  double seconds = 0;
  std::vector<double> megabytes;  ///< of each rank
};
/// @param ranks  1: the command without MPI, on so many threads
Run run_of(int n, int ranks, int threads, long steps, int rounds) {
  benchmark::Folder const folder;
  std::string const inner = "sh -c '/usr/bin/time -f %M -o " + folder.path +
                            "/kb.${OMPI_COMM_WORLD_RANK:-0} " + (ranks == 1 ? ACTIO_COMMAND : ACTIO_MPI) +
                            " \"$@\"' actio";
  std::string const command = ranks == 1 ? "ACTIO_THREADS=" + std::to_string(threads) + " taskset -c 0-" +
                                               std::to_string(threads - 1) + " " + inner
                                         : benchmark::on_ranks(ranks, ACTIO_MPIEXEC, inner);
  Run out;
  out.seconds = benchmark::seconds_of_steps(
                    folder, command, [n](long count) { return scene(n, count); }, steps, rounds) /
                (2 * static_cast<double>(steps));
  for (int rank = 0; rank < ranks; ++rank) {
    double kilobytes = 0;
    std::ifstream(folder.path + "/kb." + std::to_string(rank)) >> kilobytes;
    out.megabytes.push_back(kilobytes / 1024);
  }
  return out;
}

/// Products by one thread of a BLAS: how many operations they are, and how long they take.
class CountedProducts : public ProductsBy<CountedProducts> {
 public:
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out, Reach reach) const {
    count<Part>(2, 3, [&] { blas_.whole(a, b, out, reach); });
  }
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out, Reach reach) const {
    count<Part>(9.0 / 8, 2.5, [&] { blas_.lower(a, b, out, reach); });
  }

  struct Precision {
    double operations = 0;  ///< in units of N^3
    double numbers = 0;     ///< that pass rank 0, in units of N^2, if it keeps none of them
    double products = 0;    ///< how many
    double seconds = 0;     ///< that they take
  };
  mutable std::array<Precision, 2> of;  ///< in double and in single precision

 private:
  template <class Part, class Work>
  void count(double operations, double numbers, Work const& work) const {
    auto& to = of[sizeof(typename Part::Scalar) == sizeof(float)];
    to.operations += operations, to.numbers += numbers, ++to.products;
    to.seconds += benchmark::processor_seconds_of(work);
  }
  BlasProducts blas_{BlasFunctions{&dgemm_, &sgemm_}};
};

/// What a step consists of.
struct Model {
  static constexpr double bandwidth = 10e9;            ///< bytes a second between two ranks
  std::array<CountedProducts::Precision, 2> products;  ///< of a step
  std::array<double, 2> rate;                          ///< operations a second
  double rest;                                         ///< seconds beside products, for N^2 = 1
  double copy;                                         ///< seconds that rank 0 takes to sort a byte

  /// Seconds of a step.
  struct Time {
    double products = 0;  ///< operations, shared
    double alone = 0;     ///< on rank 0 beside products
    double dealt = 0;     ///< matrices between rank 0 and the others
    double between = 0;   ///< panels from rank to rank

    double all() const { return products + alone + dealt + between; }  ///< one after the other
  };
  Time operator()(double n, int ranks) const {
    auto const grid = DealtBlocks::of(static_cast<int>(n), ranks);
    double const others = 1 - 1.0 / ranks;
    Time out;
    for (std::size_t k = 0; k < 2; ++k) {
      double const bytes = k == 0 ? sizeof(double) : sizeof(float);
      out.products += products[k].operations * n * n * n / (rate[k] * ranks);
      out.dealt += products[k].numbers * n * n * bytes * (ranks == 1 ? 0 : others / bandwidth + copy);
      out.between += products[k].products * n * n * bytes / bandwidth *
                     ((1 - 1.0 / grid.columns) / grid.rows + (1 - 1.0 / grid.rows) / grid.columns);
    }
    out.alone = rest * n * n;
    return out;
  }
};

/// Counted and measured on one processor.
Model model_of(int n, int steps) {
  openblas_set_num_threads(1);
  std::mt19937 random(1997);
  std::normal_distribution<double> normal;
  SphereHarmonics f(n);
  for (int l = 1; l < n; ++l)
    for (int m = 0; m <= l; ++m) {
      double const size = 1 / std::sqrt(l * (2.0 * l + 1)), real = normal(random), imaginary = normal(random);
      f(l, m) = {size * real, m > 0 ? size * imaginary : 0};
    }
  SkewHermitian<> w = matrix_of(f);
  SphereLaplacian const laplacian(n);
  double const radius = FastVorticityStep<>::spectral_radius(laplacian.solve(w));
  auto const counted = std::make_shared<CountedProducts>();
  FastVorticityStep<> step(laplacian, Conserved::lie_poisson, 0.2 * QuantizedSphere(n).hbar() / radius,
                           calmest_frame(QuantizedSphere(n), laplacian, w), counted);
  // Until there are steps to guess from.
  for (int k = 0; k < 8; ++k) step.advance(w);
  counted->of = {};
  double const seconds = benchmark::processor_seconds_of([&] {
    for (int k = 0; k < steps; ++k) step.advance(w);
  });
  Model out;
  double in_products = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    auto& p = out.products[k] = counted->of[k];
    out.rate[k] = p.operations * n * n * n / p.seconds, in_products += p.seconds;
    p.operations /= steps, p.numbers /= steps, p.products /= steps;
  }
  out.rest = (seconds - in_products) / steps / n / n;
  auto const blocks = DealtBlocks::of(n, 4);
  std::vector<double> sent(blocks.numbers_of(1));
  auto const sort = [&] {
    double* to = sent.data();
    blocks.visit(1, {n, n},
                 [&](int i, int j, int count, std::size_t) { to = std::copy_n(&w.real(i, j), count, to); });
  };
  sort();
  out.copy = benchmark::processor_seconds_of([&] {
               for (int k = 0; k < 20; ++k) sort();
             }) /
             (20.0 * sizeof(double) * static_cast<double>(sent.size()));
  return out;
}

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "the fluid on the sphere on two ranks");
  if (std::string(ACTIO_MPI).empty()) {
    program.say("MPI or ScaLAPACK was not found when this was built: nothing is measured.");
    return program.finish();
  }
  std::vector<int> const sizes = program.is_short() ? std::vector{128} : std::vector{512, 1024};
  Model const model = model_of(program.length(1024, 256), program.length(4, 2));
  std::vector<std::vector<std::string>> table;
  double gain = 0;
  for (int const n : sizes) {
    long const steps = n < 512 ? 10 : n == 512 ? 6 : 2;
    int const rounds = n < 512 ? 1 : n == 512 ? 3 : 2;
    Run const one = run_of(n, 1, 1, steps, rounds), two = run_of(n, 1, 2, steps, rounds),
              ranks = run_of(n, 2, 1, steps, rounds);
    gain = one.seconds / ranks.seconds;
    // A matrix of real numbers, and what MPI itself may take.
    double const matrix = sizeof(double) / 1048576.0 * n * n, mpi = 50;
    program.claim(ranks.megabytes[0] <= one.megabytes[0] + 4 * matrix + mpi &&
                      ranks.megabytes[1] <= 8 * matrix / 2 + mpi,
                  "N = " + std::to_string(n) +
                      ": rank 0 takes at most four matrices more than one process, "
                      "rank 1 half of eight");
    table.push_back({std::to_string(n), number(one.seconds), number(two.seconds), number(ranks.seconds),
                     number(model(n, 2).all()), number(one.megabytes[0]), number(ranks.megabytes[0]),
                     number(ranks.megabytes[1])});
  }
  program.table("steps",
                {"N", "one thread, s", "two threads, s", "two ranks, s", "by the model, s", "one process, MB",
                 "rank 0, MB", "rank 1, MB"},
                table, "A step of a developed flow, and the memory of its run.");
  program.figure("two", gain, "times as fast on two ranks as on one thread, the largest N");

  table.clear();
  double least = HUGE_VAL, shared = 0;
  for (int const n : {2048, 4096, 8192})
    for (int const ranks : {1, 2, 16, 256, 2500}) {
      auto const t = model(n, ranks);
      double const nothing_alone = t.products + t.alone / ranks + t.between;
      if (n == 4096) least = std::min(least, t.all()), shared = ranks == 256 ? nothing_alone : shared;
      table.push_back({std::to_string(n), std::to_string(ranks), number(t.products), number(t.alone),
                       number(t.dealt), number(t.between), number(t.all()), number(nothing_alone)});
    }
  program.table("model",
                {"N", "ranks", "operations", "rank 0 alone", "dealt out", "between ranks", "a step",
                 "if rank 0 did nothing alone"},
                table,
                "Seconds of a step, by the model: operations at the rates that were measured here on one "
                "processor, bytes at 10 GB/s.");
  program.figure("gigaflops", 1e-9 * model.rate[0],
                 "10^9 operations a second, double precision, one processor");
  program.figure("gigaflops_single", 1e-9 * model.rate[1], "the same in single precision");
  program.figure("model_4096", least, "seconds of a step, N = 4096, by the model, the least");
  program.figure("model_4096_shared", shared,
                 "the same on 256 ranks if rank 0 did nothing alone, which is not built");
  program.figure("double_products", model.products[0].products,
                 "products of real matrices in a step, double");
  program.figure("single_products", model.products[1].products, "the same in single precision");
  program.claim_of_time(gain >= 1.2, "two ranks are at least 1.2 times as fast as one thread");
  program.headline("two ranks are " + number(gain, 2) + " times as fast as one thread", gain);
  return program.finish();
}
