// What a step of the fluid on the sphere costs, in complex products of the same size; and what is left of the
// invariants after ten thousand steps.
//
// The unit is one zgemm of OpenBLAS on one processor, timed in the same rounds. The length of a step is that
// of the published codes, h |P|_2/(2 hbar) = 0.157. The smooth state has random harmonics of degrees below
// ten, the developed one an enstrophy spectrum l^-1 up to the grid. The peer is the fixed point that the
// published codes use, to their usual tolerance.
#include <Eigen/Core>

#include <random>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/skew_matrices/blas_products.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "benchmark.hpp"
#include "peers/fixed_point_midpoint.hpp"
#include "timing.hpp"

extern "C" {
actio::sphere::Gemm<double> dgemm_;
actio::sphere::Gemm<float> sgemm_;
void openblas_set_num_threads(int);
}

using namespace actio;
using namespace actio::sphere;
using Fast = FastVorticityStep<>;

/// A random state: degrees below ten, or an enstrophy spectrum l^-1 to the grid.
SkewHermitian<> random_state(int n, bool developed, unsigned seed = 1997) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  SphereHarmonics f(n);
  for (int l = 1; l < (developed ? n : 10); ++l)
    for (int m = 0; m <= l; ++m) {
      double const size = developed ? 1 / std::sqrt(l * (2.0 * l + 1)) : 1;
      double const real = normal(random), imaginary = normal(random);
      f(l, m) = {size * real, m > 0 ? size * imaginary : 0};
    }
  return matrix_of(f);
}
/// The step with h |P|_2/(2 hbar) as given.
double step_of(SphereLaplacian const& laplacian, SkewHermitian<> const& w, double share) {
  return share * 2 * QuantizedSphere(static_cast<int>(w.size())).hbar() /
         Fast::spectral_radius(laplacian.solve(w));
}
double casimir_change(SkewHermitian<> const& from, SkewHermitian<> const& to) {
  Eigen::VectorXd const before = vorticity_casimirs(from, 8), after = vorticity_casimirs(to, 8);
  double const c2 = std::abs(before[0]), area = 4 * M_PI;
  double worst = 0;
  // In units of (C_2/4 pi)^(k/2) 4 pi: odd powers may nearly vanish.
  for (Eigen::Index k = 0; k < before.size(); ++k)
    worst = std::max(worst, std::abs(after[k] - before[k]) /
                                std::max(std::abs(before[k]),
                                         area * std::pow(c2 / area, 0.5 * static_cast<double>(k + 2))));
  return worst;
}

/// Times of one size and state.
struct Cost {
  double product_ms, peer, unfinished, poisson, energy, all, rounds, diagonals;
  double casimirs, peer_casimirs;
};
Cost cost_of(benchmark::Benchmark const& program, int n, bool developed) {
  Products const products = std::make_shared<BlasProducts>(BlasFunctions{&dgemm_, &sgemm_});
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, developed);
  double const h = step_of(laplacian, start, 0.157);
  TurningFrame const frame = calmest_frame(QuantizedSphere(n), laplacian, start);

  ComplexMatrix<> const a = start.complex();
  ComplexMatrix<> out;
  peers::FixedPointMidpoint peer{laplacian, h};
  ComplexMatrix<> by_peer = a;
  VorticityStep<> unfinished(laplacian, Conserved::lie_poisson, h, frame, products);
  unfinished.tolerance = 1e-8;
  SkewHermitian<> w = start;
  Fast poisson(laplacian, Conserved::lie_poisson, h, frame, products),
      energy(laplacian, Conserved::energy_casimir, h, frame, products),
      all(laplacian, Conserved::all_invariants, h, frame, products);
  std::array<SkewHermitian<>, 3> states{start, start, start};
  double rounds = 0, steps_made = 0;
  auto const advance = [&](Fast& fast, SkewHermitian<>& state) {
    auto const report = fast.advance(state);
    if (&fast == &poisson) rounds += report.iterations, ++steps_made;
  };
  // Until there are five steps to guess from.
  for (int k = 0; k < 6; ++k) {
    if (k < 2) peer.step(by_peer);
    unfinished.advance(w), advance(poisson, states[0]), advance(energy, states[1]), advance(all, states[2]);
  }
  rounds = steps_made = 0;
  double const count = n <= 64 ? 20 : n <= 256 ? 2 : 1;
  auto const times = [count](auto const& one) {
    return [count, one] {
      for (int k = 0; k < count; ++k) one();
    };
  };
  auto const t = benchmark::in_turns(program.rounds(n > 512    ? 3
                                                    : n == 512 ? 7
                                                               : 15),
                                     {{"product", times([&] { peers::complex_product(a, a, out); }), count},
                                      {"peer", times([&] { peer.step(by_peer); }), count},
                                      {"unfinished", times([&] { unfinished.advance(w); }), count},
                                      {"Lie-Poisson", times([&] { advance(poisson, states[0]); }), count},
                                      {"energy-Casimir", times([&] { advance(energy, states[1]); }), count},
                                      {"all", times([&] { advance(all, states[2]); }), count}});
  auto const in_products = [&](std::size_t k) { return benchmark::ratio_of_best(t[k], t[0]); };
  return {1e3 * benchmark::best_tenth(t[0]),
          in_products(1),
          in_products(2),
          in_products(3),
          in_products(4),
          in_products(5),
          rounds / steps_made,
          static_cast<double>(reach_of(states[0], Negligible::beside(1, norm(states[0]), n).of_w) + 1),
          casimir_change(start, states[0]),
          casimir_change(start, SkewHermitian<>(by_peer.real(), by_peer.imag()))};
}

int main(int argc, char** argv) {
  openblas_set_num_threads(1);
  benchmark::Benchmark program(argc, argv,
                               "a step of the fluid on the sphere, in complex products of N by N matrices");
  using book::number;
  std::vector<book::Program::Row> rows;
  double least_gain = HUGE_VAL, gain_developed = HUGE_VAL, extra = 0, step_ms = 0, smooth_large = 0,
         developed_large = 0, unfinished_large = 0, digits = HUGE_VAL;
  for (int n : {64, 256, 512, 1024}) {
    // A product of the largest takes a fifth of a second.
    if (program.is_short() && n > 64) continue;
    for (bool developed : {false, true}) {
      Cost const c = cost_of(program, n, developed);
      rows.push_back({std::to_string(n), developed ? "developed" : "smooth", number(c.diagonals),
                      number(c.product_ms), number(c.peer), number(c.unfinished), number(c.poisson),
                      number(c.rounds), number(c.energy), number(c.all), number(c.peer_casimirs, 2),
                      number(c.casimirs, 2)});
      if (n <= 512) {
        (developed ? gain_developed : least_gain) =
            std::min(developed ? gain_developed : least_gain, c.peer / c.poisson);
        step_ms = c.poisson * c.product_ms;
        extra = std::max(extra, c.all / c.energy - 1);
        if (developed) digits = std::min(digits, std::log10(c.peer_casimirs / c.casimirs));
      }
      (developed ? developed_large : smooth_large) = c.poisson;
      if (!developed) unfinished_large = c.unfinished;
    }
  }
  // A short run has the smallest size alone: the table, what is said of all, and of the largest, the release
  // has.
  if (!program.is_short()) {
    program.table("cost",
                  {"N", "state", "diagonals", "product, ms", "fixed point", "no finish", "Lie-Poisson",
                   "rounds", "energy-Casimir", "all invariants", "fixed point: Casimirs", "ours: Casimirs"},
                  rows);
    program.figure("gain", least_gain,
                   "how many times faster than the fixed point a Lie-Poisson step of a smooth "
                   "state is, least over N = 64 to 512");
    program.figure("gain_developed", gain_developed, "the same of a developed state");
    program.figure(
        "digits", digits,
        "decimal digits that the Casimirs of a developed state have more than by the fixed point, least");
    program.figure("extra", 100 * extra,
                   "what all invariants cost more than energy and Casimirs, per cent, most");
    program.figure("smooth", smooth_large,
                   "a Lie-Poisson step of a smooth state with the exact finish, in products, the largest N");
    program.figure("developed", developed_large, "the same of a developed state");
    program.figure("unfinished", unfinished_large,
                   "a step of a smooth state without the finish, the largest N");
  }

  // The invariants of long runs.
  rows.clear();
  int const n = 64, steps = program.length(10000, 300);
  Products const products = std::make_shared<BlasProducts>(BlasFunctions{&dgemm_, &sgemm_});
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, false);
  double const h = step_of(laplacian, start, 0.039);
  TurningFrame const frame = calmest_frame(QuantizedSphere(n), laplacian, start);
  Eigen::Vector3d const momentum = sphere_momentum(start);
  double const energy = vorticity_energy(laplacian, start);
  double worst_casimir = 0, worst_in_double = 0, worst_other = 0;
  auto const keep = [&](auto step, Conserved conserved, char const* name, char const* precision) {
    SkewHermitian<> w = start;
    double const seconds = benchmark::processor_seconds_of([&] {
      for (int k = 0; k < steps; ++k) step.advance(w);
    });
    double const casimirs = casimir_change(start, w),
                 of_energy = std::abs(vorticity_energy(laplacian, w) / energy - 1),
                 of_momentum = (sphere_momentum(w) - momentum).norm() / momentum.norm();
    rows.push_back({name, precision, number(static_cast<double>(steps)), number(casimirs, 2),
                    number(of_energy, 2), number(of_momentum, 2), number(1e3 * seconds / steps)});
    if (conserved == Conserved::all_invariants) worst_other = std::max({worst_other, of_energy, of_momentum});
    return casimirs;
  };
  for (auto const& [conserved, name] : {std::pair{Conserved::lie_poisson, "Lie-Poisson"},
                                        std::pair{Conserved::energy_casimir, "energy-Casimir"},
                                        std::pair{Conserved::all_invariants, "all invariants"}}) {
    worst_casimir = std::max(worst_casimir,
                             keep(Fast(laplacian, conserved, h, frame, products), conserved, name, "mixed"));
    worst_in_double =
        std::max(worst_in_double,
                 keep(VorticityStep<>(laplacian, conserved, h, frame, products), conserved, name, "double"));
  }
  // The published codes' step, to its usual tolerance.
  peers::FixedPointMidpoint peer{laplacian, h};
  ComplexMatrix<> by_peer = start.complex();
  double const peer_seconds = benchmark::processor_seconds_of([&] {
    for (int k = 0; k < steps; ++k) peer.step(by_peer);
  });
  SkewHermitian<> const of_peer(by_peer.real(), by_peer.imag());
  double const peer_casimirs = casimir_change(start, of_peer);
  rows.push_back({"fixed point", "double", number(static_cast<double>(steps)), number(peer_casimirs, 2),
                  number(std::abs(vorticity_energy(laplacian, of_peer) / energy - 1), 2),
                  number((sphere_momentum(of_peer) - momentum).norm() / momentum.norm(), 2),
                  number(1e3 * peer_seconds / steps)});
  program.table("invariants",
                {"form", "precision", "steps", "C_2 to C_8", "energy", "angular momentum", "ms a step"},
                rows);
  if (!program.is_short()) {
    program.figure("casimirs", worst_casimir,
                   "largest relative change of C_2 to C_8 of the three forms, N = 64, in mixed precision");
    program.figure("digits_long", std::log10(peer_casimirs / worst_casimir),
                   "decimal digits that they have more than by the fixed point");
    program.figure("casimirs_double", worst_in_double, "the same in double precision");
    program.figure("all", worst_other,
                   "largest relative change of energy and angular momentum by the form that conserves all");
  }
  program.claim(worst_casimir <= 1e-13, "the Casimirs stay within 1e-13 in mixed precision, in every form");
  program.claim(worst_other <= 1e-12, "energy and angular momentum together stay within 1e-12");

  // The harmonics beside the step.
  int const size = program.length(512, 64);
  SkewHermitian<> const large = random_state(size, true);
  double const transform = benchmark::processor_seconds_of([&] { (void)harmonics_of(large); });
  if (!program.is_short()) {
    program.figure("transform_ms", 1e3 * transform,
                   "milliseconds from the matrix to the harmonics, the largest N up to 512");
    program.figure("transform", 1e3 * transform / step_ms, "the same in steps of that size");
  }
  program.headline("a Lie-Poisson step of a developed state with exact Casimirs is " +
                       number(gain_developed) + " times faster than the fixed point of published codes",
                   gain_developed);
  return program.finish();
}
