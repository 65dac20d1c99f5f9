// What is conserved: three variants of a step on matrices, and a spherical-harmonic truncation of the same
// flow.
//
// What is shown. The classical truncation conserves energy, angular momentum and enstrophy, and no other
// integral of a power of the vorticity. On matrices every power and the whole spectrum are conserved by each
// of the three variants; the Lie-Poisson one has the angular momentum beside them, the energy-Casimir one the
// energy, the third one both. The step that is found in single precision has the spectrum to rounding and the
// rest to its tolerance: this is measured, too. Read first. Section 10A.4.
//
//   zeta  vorticity, by its harmonics        W   vorticity as a matrix
//   psi   stream function                    C_k integral of the k-th power of the vorticity
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Core>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "actio/vorticity/vorticity_step.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "eighths.hpp"
#include "random_flow.hpp"
#include "step_defects.hpp"
#include "truncated_flow.hpp"

using namespace actio;
using namespace actio::sphere;
using book::measured, book::number;

constexpr int size = 20, steps = 400, most = 6;
constexpr double h = 0.1;
unsigned const seed = 10;

// 1. A flow at random: degrees 1 to 6.
SphereHarmonics flow_at_random() {
  SphereHarmonics f = random_flow(size, 1, 6, seed);
  f.coefficient = f.coefficient / 3.0;
  return f;
}

// 2. What is measured of a state: energy, angular momentum, C_2 .. C_6 scaled by powers of C_2, and the
//    spectrum.
struct Invariants {
  double energy = 0;
  Eigen::Vector3d momentum;
  Eigen::VectorXd casimirs, values;
};
Invariants of_matrix(SphereLaplacian const& laplacian, SkewHermitian<> const& w) {
  return {vorticity_energy(laplacian, w), sphere_momentum(w), vorticity_casimirs(w, most),
          vorticity_values(w)};
}
Invariants of_field(SphereGrid const& fine, SphereHarmonics const& zeta) {
  Invariants found;
  found.energy = energy_by_degree(zeta).sum();
  // x_3 and x_1 + i x_2 by the harmonics of degree 1.
  double const scale = std::sqrt(4 * M_PI / 3);
  found.momentum = scale * Eigen::Vector3d(-std::sqrt(2) * zeta(1, 1).real(),
                                           std::sqrt(2) * zeta(1, 1).imag(), zeta(1, 0).real());
  GridField const values = values_on(fine, zeta);
  GridField power = values;
  found.casimirs.resize(most - 1);
  for (int k = 2; k <= most; ++k) {
    power = power.cwiseProduct(values);
    found.casimirs[k - 2] = fine.integral(power);
  }
  return found;
}
// The change since the beginning: of energy, momentum, C_2 .. C_6, spectrum; all relative.
std::vector<double> change(Invariants const& now, Invariants const& then) {
  std::vector<double> out{std::abs(now.energy / then.energy - 1),
                          (now.momentum - then.momentum).norm() / then.momentum.norm()};
  double const unit = std::sqrt(then.casimirs[0] / (4 * M_PI));
  for (int k = 2; k <= most; ++k)
    out.push_back(std::abs(now.casimirs[k - 2] - then.casimirs[k - 2]) / (4 * M_PI * std::pow(unit, k)));
  if (then.values.size() != 0) out.push_back((now.values - then.values).cwiseAbs().maxCoeff() / unit);
  return out;
}

// 3. A run: the largest changes.
struct Run {
  std::vector<double> largest;
};
template <class Advance, class Measure>
Run run(Advance const& advance, Measure const& measure) {
  Run out;
  Invariants const start = measure();
  for (int k = 1; k <= steps; ++k) {
    advance();
    if (k % 20 != 0) continue;
    auto const now = change(measure(), start);
    out.largest.resize(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) out.largest[i] = std::max(out.largest[i], now[i]);
  }
  return out;
}

// 4. The runs of the truncation and of the three variants.
std::vector<Run> all_runs() {
  std::vector<Run> runs;
  {
    TruncatedFlow const truncation(size, h);
    auto zeta = flow_at_random();
    // The sixth power of a polynomial of degree 19 is integrated exactly.
    auto const fine = SphereGrid::gauss(3 * size, 6 * size);
    runs.push_back(run([&] { truncation.advance(zeta); }, [&] { return of_field(fine, zeta); }));
  }
  SphereLaplacian const laplacian(size);
  for (auto const form : {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
    auto w = matrix_of(flow_at_random());
    VorticityStep step(laplacian, form, h, calmest_frame(QuantizedSphere(size), laplacian, w));
    runs.push_back(run([&] { step.advance(w); }, [&] { return of_matrix(laplacian, w); }));
  }
  return runs;
}

// 5. What the page shows of them.
void show(book::Program& program, std::vector<Run> const& runs) {
  std::vector<std::string> const names{"energy", "angular momentum", "C_2, enstrophy", "C_3", "C_4", "C_5",
                                       "C_6",    "spectrum"};
  std::vector<book::Program::Row> rows;
  for (std::size_t i = 0; i < names.size(); ++i) {
    book::Program::Row row{names[i]};
    for (auto const& r : runs) row.push_back(i < r.largest.size() ? number(r.largest[i], 2) : "");
    rows.push_back(row);
  }
  program.table("invariants", {"", "truncation", "Lie-Poisson", "energy-Casimir", "all invariants"}, rows,
                "Largest relative change in " + std::to_string(steps) + " steps of " + number(h) +
                    ", N = " + std::to_string(size) + ".");
}

// 6. The energy of the Lie-Poisson variant over a long time, with the step and with half of it; and the
//    modified energy, which a step changes by a term of the fifth order alone.
double second_order(SphereLaplacian const& laplacian, SkewHermitian<> const& w) {
  double const hbar = QuantizedSphere(size).hbar();
  SkewHermitian<> const p = laplacian.solve(w), rate = (1 / hbar) * commutator(p, w);
  SkewHermitian<> const pwp(ComplexMatrix<>(p.complex() * w.complex() * p.complex()));
  return QuantizedSphere(size).area_element() *
         (2 / (hbar * hbar) * inner_product(p, pwp) - inner_product(laplacian.solve(rate), rate));
}
struct LongRun {
  std::vector<double> times, energy, modified;
};
LongRun long_run(double dt, double time) {
  constexpr int samples = 1600;
  SphereLaplacian const laplacian(size);
  auto w = matrix_of(flow_at_random());
  auto const modified = [&] {
    return vorticity_energy(laplacian, w) - dt * dt / 24 * second_order(laplacian, w);
  };
  double const energy = vorticity_energy(laplacian, w), start = modified();
  VorticityStep step(laplacian, Conserved::lie_poisson, dt);
  long const between = std::lround(time / dt) / samples;
  LongRun out;
  for (int k = 0; k < samples; ++k) {
    for (long i = 0; i < between; ++i) step.advance(w);
    out.times.push_back(dt * static_cast<double>(between * (k + 1)));
    out.energy.push_back(vorticity_energy(laplacian, w) / energy - 1);
    out.modified.push_back((modified() - start) / energy);
  }
  return out;
}
double largest(std::vector<double> const& x) {
  double out = 0;
  for (double const y : x) out = std::max(out, std::abs(y));
  return out;
}
void show_long_run(book::Program& program) {
  constexpr double time = 320;
  LongRun const run = long_run(h, time), half = long_run(h / 2, time);
  Eighths const whole(run.energy), half_step(half.energy);
  show_eighths(program, whole, half_step, h);
  Eighths const modified(run.modified), half_modified(half.modified);
  auto const row = [](std::string const& name, std::vector<double> const& x, Eighths const& of) {
    return book::Program::Row{name, number(largest(x), 2), number(of.oscillation, 2), number(of.trend, 2),
                              number(of.uncertainty, 2)};
  };
  program.table("modified", {"", "largest change", "deviation", "trend per eighth", "its standard error"},
                {row("energy, step " + number(h), run.energy, whole),
                 row("energy, step " + number(h / 2), half.energy, half_step),
                 row("modified energy, step " + number(h), run.modified, modified),
                 row("modified energy, step " + number(h / 2), half.modified, half_modified)},
                "The same two runs: the energy and the modified energy, relative to the energy.");
  auto plot = book::Plot("time", "relative change");
  plot.curve(run.times, run.energy, "energy, step " + number(h))
      .curve(half.times, half.energy, "half of it")
      .curve(run.times, run.modified, "modified energy, step " + number(h));
  program.picture("long", plot.svg(),
                  "The energy of the Lie-Poisson variant wanders with the state; the modified energy stays.");
  program.figure("long_time", time, number(time), "duration of the long runs");
  program.figure("long_steps", std::round(time / h), std::to_string(std::lround(time / h)),
                 "steps of the long run with the longer step");
  program.figure("modified_ratio", largest(run.modified) / largest(half.modified),
                 "largest change of the modified energy over that with half the step");
  program.figure("energy_ratio", largest(run.energy) / largest(half.energy), "the same for the energy");
  program.figure("modified_gain", largest(run.energy) / largest(run.modified),
                 "largest change of the energy over that of the modified energy");
  program.claim(measured(std::abs(largest(run.energy) / largest(half.energy) - 4)) < 1,
                "half the step, a quarter of the change of the energy");
  program.claim(measured(std::abs(largest(run.modified) / largest(half.modified) - 16)) < 8,
                "and about a sixteenth of that of the modified energy");
}

// 7. What one step misses, each begun without a past: to rounding in three variants, and to a tolerance.
struct Misses {
  double spectrum, energy, momentum, back, poisson;
};
Misses misses(step_defects::Step const& step, SphereLaplacian const& laplacian, SkewHermitian<> const& w) {
  constexpr double once = 0.03;  // short enough for the fast step to do without the other one at its start
  SkewHermitian<> const after = step(w, once);
  return {step_defects::spectrum(step, w, once),
          std::abs(vorticity_energy(laplacian, after) / vorticity_energy(laplacian, w) - 1),
          (sphere_momentum(after) - sphere_momentum(w)).norm() / sphere_momentum(w).norm(),
          step_defects::self_adjointness(step, w, once), step_defects::poisson(step, w, once)};
}
struct AllMisses {
  Misses lie_poisson, energy_casimir, all_invariants, fast;
};
AllMisses exactly_and_fast(book::Program& program) {
  constexpr int small = 8;
  SphereLaplacian const laplacian(small);
  SkewHermitian<> const w = matrix_of(random_flow(small, 1, small - 1, seed));
  auto const by = [&]<class Method>(std::type_identity<Method>, Conserved form) {
    return misses(
        [&laplacian, form](SkewHermitian<> from, double step) {
          Method(laplacian, form, step).advance(from);
          return from;
        },
        laplacian, w);
  };
  std::type_identity<VorticityStep<>> const plain;
  AllMisses const found{by(plain, Conserved::lie_poisson), by(plain, Conserved::energy_casimir),
                        by(plain, Conserved::all_invariants),
                        by(std::type_identity<FastVorticityStep<>>{}, Conserved::lie_poisson)};
  auto const row = [](std::string const& name, Misses const& m) {
    return book::Program::Row{name,
                              number(m.spectrum, 2),
                              number(m.momentum, 2),
                              number(m.energy, 2),
                              number(m.back, 2),
                              number(m.poisson, 2)};
  };
  program.table(
      "fast", {"one step", "spectrum", "angular momentum", "energy", "step and step back", "Poisson defect"},
      {row("Lie-Poisson", found.lie_poisson), row("energy-Casimir", found.energy_casimir),
       row("all invariants", found.all_invariants), row("Lie-Poisson, `FastVorticityStep`", found.fast)},
      "What one step misses, relative. The tangent of the Poisson defect is found by differences; "
      "what they miss is seen in the first line.");
  program.figure("fast_size", small, std::to_string(small), "size of the matrices of that table");
  program.figure("defect", found.lie_poisson.poisson, "Poisson defect of the Lie-Poisson variant");
  program.figure("defect_energy", found.energy_casimir.poisson, "of the energy-Casimir variant");
  program.figure("defect_all", found.all_invariants.poisson, "of that of all invariants");
  program.figure("defect_fast", found.fast.poisson, "of the Lie-Poisson variant by FastVorticityStep");
  program.figure("back_fast", found.fast.back, "step and step back, by FastVorticityStep");
  program.figure("momentum_fast", found.fast.momentum, "change of the angular momentum by FastVorticityStep");
  return found;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "the invariants of three variants of a step, beside a truncation of the same flow");
  program.say("a flow at random from seed ", seed);
  auto const runs = all_runs();
  show(program, runs);
  auto const& [truncated, poisson, level, all] =
      std::tie(runs[0].largest, runs[1].largest, runs[2].largest, runs[3].largest);
  double const worst = *std::max_element(all.begin(), all.end());
  program.figure("all", worst, "largest change of any invariant, the variant of all invariants");
  program.figure("poisson_energy", poisson[0], "largest change of the energy, Lie-Poisson variant");
  program.figure("level_momentum", level[1],
                 "largest change of the angular momentum, energy-Casimir variant");
  program.figure("truncated_c4", truncated[4], "largest change of C_4, truncation");

  // 8. What must be so: a rounding for each step, in numbers scaled by powers of the vorticity.
  double const rounding = 1e-12;
  auto const casimirs = [](std::vector<double> const& c) {
    return *std::max_element(c.begin() + 2, c.end());
  };
  program.claim(measured(std::max({truncated[0], truncated[1], truncated[2]})) < rounding,
                "the truncation conserves energy, angular momentum and enstrophy");
  program.claim(measured(truncated[4]) > 1e-2, "and not the fourth power of the vorticity");
  program.claim(measured(std::max({casimirs(poisson), casimirs(level), casimirs(all)})) < rounding,
                "every variant conserves the Casimirs and the spectrum");
  program.claim(measured(std::max(poisson[1], all[1])) < rounding,
                "the Lie-Poisson variant and the third conserve the angular momentum");
  program.claim(measured(std::max(level[0], all[0])) < rounding,
                "the energy-Casimir variant and the third conserve the energy");
  program.claim(measured(poisson[0]) > 1e-8 && measured(level[1]) > 1e-8, "and what each gives up is seen");
  show_long_run(program);
  auto const [plain, level_once, all_once, fast] = exactly_and_fast(program);
  program.claim(
      measured(std::max({plain.spectrum, level_once.spectrum, all_once.spectrum, fast.spectrum})) < 1e-13,
      "every step keeps the spectrum");
  program.claim(measured(std::max({plain.back, level_once.back, all_once.back})) < 1e-13,
                "those that are solved to rounding are self-adjoint");
  program.claim(measured(plain.poisson) < 1e-8,
                "the Lie-Poisson variant is a Poisson map, as far as differences can tell");
  program.claim(measured(std::min(level_once.poisson, all_once.poisson)) > 1e-6, "and the other two are not");
  // The tolerance is 1e-8, and differences over 0.02 of the state divide by that.
  program.claim(measured(fast.back) < 1e-7, "the fast one goes back to its tolerance");
  program.claim(measured(fast.poisson) < 1e-5, "and is a Poisson map to it");
  program.headline("all invariants within " + number(worst, 2), worst);
  return program.finish();
}
