// The linear equations for pressures, S P = r on a box of cells that a flow has deformed: our cycles beside
// the multigrid solvers of PETSc, all within conjugate gradients, to the same residual.
#include <petscksp.h>

#include "actio/incompressible_media/multigrid_pressure.hpp"
#include "benchmark.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::media;
using book::number;

namespace {

constexpr double reduction = 1e-10;  // of the residual, in the norm of its squares
constexpr int most_cycles = 500;

/// Cells of a square that a vortex has turned, whose nodes are free on all sides.
struct Equations {
  BodyMesh mesh;
  MeshVolumes<PlaneCell> volumes;
  MeshShare share;
  std::vector<double> masses, slopes, right;

  explicit Equations(int n)
      : mesh(box_mesh({0, 0}, {1, 1}, {n, n})),
        volumes(mesh),
        share(mesh, nullptr),
        masses(mesh.nodes.size()) {
    SharpPlaces places;
    for (auto const& X : mesh.nodes) {
      double const x = X[0] - 0.5, y = X[1] - 0.5, angle = 0.8 * std::exp(-8 * (x * x + y * y));
      places.y.push_back(std::cos(angle) * x - std::sin(angle) * y);
      places.y.push_back(std::sin(angle) * x + std::cos(angle) * y);
    }
    masses = volumes.masses(places, std::vector<double>(volumes.cells(), 1.0));
    volumes.slopes(places, slopes, volumes.all());
    for (std::size_t k = 0; k < volumes.cells(); ++k)
      right.push_back(std::sin(0.37 * static_cast<double>(k * k % 1009)));
  }
  /// The lower half of S.
  Eigen::SparseMatrix<double> matrix() const {
    PressureMatrix<PlaneCell> out(volumes, masses, false);
    out.fill(slopes);
    return out.values;
  }
};

/// What a solver took.
struct Taken {
  double seconds;  ///< with its preparation
  int cycles;
  double residual;  ///< relative
};

double norm(std::vector<double> const& r) {
  double sum = 0;
  for (double const one : r) sum += one * one;
  return std::sqrt(sum);
}

/// What is left of the right side, relative to it.
double residual_of(Equations const& of, Eigen::SparseMatrix<double> const& lower, double const* x) {
  auto const n = static_cast<Eigen::Index>(of.right.size());
  Eigen::Map<Eigen::VectorXd const> const right(of.right.data(), n), found(x, n);
  return (right - lower.selfadjointView<Eigen::Lower>() * found).norm() / right.norm();
}

/// Conjugate gradients with our cycle.
Taken by_cycles(Equations const& of, Eigen::SparseMatrix<double> const& S) {
  Taken out{};
  auto const n = static_cast<long>(of.right.size());
  std::vector<double> x(of.right.size(), 0), r = of.right, p(x), z(x), q(x);
  out.seconds = benchmark::processor_seconds_of([&] {
    MultigridPressure solver(of.mesh, of.volumes, of.masses, of.share);
    solver.build(of.slopes);
    double const first = norm(r);
    for (double last = 0; norm(r) > reduction * first && out.cycles < most_cycles; ++out.cycles) {
      solver.apply(r, z);
      double now = 0, along = 0;
      for (std::size_t k = 0; k < r.size(); ++k) now += r[k] * z[k];
      for (std::size_t k = 0; k < r.size(); ++k) p[k] = z[k] + (out.cycles == 0 ? 0 : now / last) * p[k];
      Eigen::Map<Eigen::VectorXd>(q.data(), n) =
          S.selfadjointView<Eigen::Lower>() * Eigen::Map<Eigen::VectorXd>(p.data(), n);
      for (std::size_t k = 0; k < r.size(); ++k) along += p[k] * q[k];
      for (std::size_t k = 0; k < r.size(); ++k) x[k] += now / along * p[k], r[k] -= now / along * q[k];
      last = now;
    }
  });
  out.residual = residual_of(of, S, x.data());
  return out;
}

/// Conjugate gradients of PETSc.
/// @param kind    of the preconditioner
/// @param option  of it, and its value; none: the defaults
Taken by_petsc(Equations const& of, Eigen::SparseMatrix<double> const& lower, char const* kind,
               std::pair<char const*, char const*> option) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> S = lower.selfadjointView<Eigen::Lower>();
  auto const n = static_cast<PetscInt>(of.right.size());
  PetscOptionsClear(nullptr);
  if (option.first) PetscOptionsSetValue(nullptr, option.first, option.second);
  Mat A = nullptr;
  MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, S.outerIndexPtr(), S.innerIndexPtr(), S.valuePtr(), &A);
  Vec b = nullptr, x = nullptr;
  VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, of.right.data(), &b);
  VecDuplicate(b, &x);
  Taken out{};
  out.seconds = benchmark::processor_seconds_of([&] {
    KSP solver = nullptr;
    PC by = nullptr;
    PetscInt rounds = 0;
    KSPCreate(PETSC_COMM_SELF, &solver), KSPSetOperators(solver, A, A), KSPSetType(solver, KSPCG);
    KSPGetPC(solver, &by), PCSetType(by, kind), PCSetFromOptions(by);
    KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED);
    KSPSetTolerances(solver, reduction, 0, PETSC_DEFAULT, most_cycles);
    KSPSolve(solver, b, x);
    KSPGetIterationNumber(solver, &rounds), KSPDestroy(&solver);
    out.cycles = static_cast<int>(rounds);
  });
  double const* found = nullptr;
  VecGetArrayRead(x, &found);
  out.residual = residual_of(of, lower, found);
  VecRestoreArrayRead(x, &found);
  VecDestroy(&x), VecDestroy(&b), MatDestroy(&A);
  return out;
}

/// The shortest time of one of its settings that came to the residual.
Taken best_of_petsc(Equations const& of, Eigen::SparseMatrix<double> const& S, char const* kind,
                    std::vector<std::pair<char const*, char const*>> const& options) {
  Taken best{HUGE_VAL, 0, HUGE_VAL};
  for (auto const& option : options)
    if (Taken const one = by_petsc(of, S, kind, option);
        one.residual <= 2 * reduction && one.seconds < best.seconds)
      best = one;
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Benchmark program(argc, argv, "pressures of deformed cells: our cycles beside PETSc's");
  PetscInitializeNoArguments();
  std::vector<book::Program::Row> table;
  double least = HUGE_VAL, last = 0, worst = 0;
  for (int const n : program.length(std::vector{64, 128, 256}, std::vector{64, 128})) {
    Equations const equations(n);
    auto const S = equations.matrix();
    std::vector<double> ours, aggregates, ruge;
    Taken a{}, b{}, c{};
    for (int round = 0; round < program.length(5, 3); ++round) {
      a = by_cycles(equations, S), ours.push_back(a.seconds);
      b = best_of_petsc(equations, S, PCGAMG,
                        {{nullptr, nullptr}, {"-pc_gamg_threshold", "0.08"}, {"-pc_gamg_threshold", "0.25"}});
      c = best_of_petsc(equations, S, PCHYPRE,
                        {{nullptr, nullptr},
                         {"-pc_hypre_boomeramg_strong_threshold", "0.5"},
                         {"-pc_hypre_boomeramg_strong_threshold", "0.9"}});
      aggregates.push_back(b.seconds), ruge.push_back(c.seconds);
    }
    double const own = benchmark::median(ours), of_b = benchmark::median(aggregates) / own,
                 of_c = benchmark::median(ruge) / own;
    last = std::min(of_b, of_c), least = std::min(least, last);
    worst = std::max({worst, a.residual, b.residual, c.residual});
    table.push_back({number(n) + " x " + number(n), number(1e3 * own, 3), number(a.cycles), number(of_b, 3),
                     number(b.cycles), number(of_c, 3), number(c.cycles)});
  }
  PetscFinalize();
  program.table("cost",
                {"cells", "ours, ms", "cycles", "GAMG, times", "cycles", "BoomerAMG, times", "cycles"}, table,
                "Pressures to a residual of " + number(reduction) +
                    " of the right side by conjugate gradients with one cycle a round, preparation "
                    "included: ours, and as multiples of it GAMG of PETSc and BoomerAMG of hypre, each with "
                    "the best of three thresholds; medians.");
  program.figure("times", last, "times as long the faster of both takes on the largest box");
  program.claim(worst <= 2 * reduction, "all come to the residual");
  program.claim_of_time(least >= 1, "ours are the fastest on each box");
  program.headline("the faster peer takes " + number(last, 2) + " times as long", last);
  return program.finish();
}
