// A wave of Rossby and Haurwitz on a rotating sphere, against its exact motion.
//
// What is shown. A single harmonic of degree l drifts to the west on a rotating sphere at the rate 2
// Omega/(l(l+1)), and keeps its shape. The matrices have this motion exactly, with the rate of the fluid.
// Three variants of a step follow it: the Lie-Poisson one to second order, the other two to rounding in a
// single step, if the frame turns with the wave. Read first. Section 10A.5.
//
//   zeta   vorticity in the rotating frame       W   absolute vorticity, zeta + 2 Omega cos(theta)
//   l, m   degree and order of the wave          h   length of a step
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Core>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/vorticity/vorticity_step.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "sphere_disc.hpp"

using namespace actio;
using namespace actio::sphere;

constexpr int size = 24, degree = 5, order = 4;
constexpr double rotation = 1, duration = 1;

// 1. The wave, and the rotation of the sphere: the state is the absolute vorticity.
SphereHarmonics wave() {
  SphereHarmonics f(size);
  f(degree, order) = std::complex<double>(0.6, 0.3);
  return f;
}
SkewHermitian<> absolute(SphereHarmonics const& zeta) {
  return matrix_of(zeta) + planetary_vorticity(QuantizedSphere(size), rotation);
}
// 2. The exact motion. Seen from the stars the wave turns with the sphere, less its drift.
double drift_of(int l) { return -2 * rotation / (l * (l + 1.0)); }
SkewHermitian<> exact(double t) {
  Turning const about_pole(QuantizedSphere(size), Eigen::Vector3d::UnitZ());
  return about_pole((rotation + drift_of(degree)) * t, absolute(wave()));
}

// 3. The state after some time, in `steps` steps of one variant; its error, and the drift that is seen.
struct Followed {
  double error, drift;
};
SkewHermitian<> run(Conserved form, double time, int steps, bool turning) {
  QuantizedSphere const sphere(size);
  SphereLaplacian const laplacian(size);
  auto w = absolute(wave());
  auto const frame = turning ? calmest_frame(sphere, laplacian, w) : TurningFrame{};
  VorticityStep step(laplacian, form, time / steps, frame);
  for (int k = 0; k < steps; ++k) step.advance(w);
  return Turning(sphere, frame.axis)(frame.rate * time, w);
}
Followed follow(Conserved form, int steps, bool turning) {
  auto const w = run(form, duration, steps, turning);
  // The phase of a harmonic that turns by an angle is less by m times it. Seen from the sphere:
  auto const seen = harmonics_of(w)(degree, order) * std::polar(1.0, order * rotation * duration);
  return {norm(w - exact(duration)) / norm(w), std::arg(wave()(degree, order) / seen) / (order * duration)};
}

// The error alone; not a number where the iteration of a step does not contract.
double error_of(Conserved form, int steps, bool turning) {
  try {
    return follow(form, steps, turning).error;
  } catch (NotContracting const&) {
    return std::nan("");
  }
}

// 4. The errors of three variants, the first one in a frame at rest too, for steps of six lengths.
struct Errors {
  std::vector<double> lengths, of[4];
};
Errors errors_of_forms(book::Program& program) {
  struct Form {
    Conserved form;
    bool turning;
  };
  Form const forms[] = {{Conserved::lie_poisson, false},
                        {Conserved::lie_poisson, true},
                        {Conserved::energy_casimir, true},
                        {Conserved::all_invariants, true}};
  std::vector<book::Program::Row> rows;
  Errors errors;
  for (int const steps : {1, 2, 4, 8, 16, 32}) {
    errors.lengths.push_back(duration / steps);
    book::Program::Row row{book::number(steps)};
    for (int k = 0; k < 4; ++k) {
      // A frame at rest has the whole rotation in its displacement: its longest step is shorter.
      errors.of[k].push_back(error_of(forms[k].form, steps, forms[k].turning));
      row.push_back(std::isnan(errors.of[k].back()) ? "" : book::number(errors.of[k].back(), 2));
    }
    rows.push_back(row);
  }
  program.table("errors",
                {"steps", "Lie-Poisson, frame at rest", "Lie-Poisson, turning frame", "energy-Casimir",
                 "all invariants"},
                rows, "Relative error after the sphere has turned by one radian, in a number of steps.");
  return errors;
}

// 5. The wave, at the beginning and after a day of steps.
std::string wave_on_discs() {
  SphereGrid const grid = SphereGrid::uniform(90, 180);
  std::string discs;
  double const largest = values_on(grid, wave()).cwiseAbs().maxCoeff(), day = 2 * M_PI / rotation;
  for (int k : {0, 1}) {
    auto w = absolute(wave());
    // In a day the sphere turns once: it is where it was, and so is what rotates with it.
    if (k == 1) w = run(Conserved::all_invariants, day, 8, true);
    auto const f = harmonics_of(w - planetary_vorticity(QuantizedSphere(size), rotation));
    discs += book::sphere_disc({120 + 240.0 * k, 120}, 108, grid, values_on(grid, f), largest, {20, 35});
    discs += book::svg::label({120 + 240.0 * k, 250}, "day " + std::to_string(k), "middle");
  }
  discs += book::colour_bar({140, 284}, 200, largest, "vorticity, less that of the sphere");
  return book::svg::picture(480, 314, discs);
}

int main(int argc, char** argv) {
  book::Program program(
      argc, argv, "a wave of Rossby and Haurwitz: its drift on a rotating sphere, to rounding in one step");
  auto const [lengths, errors] = errors_of_forms(program);
  // The longest two steps are beyond the range in which the square of h says all.
  double const slope =
      book::exponent({lengths.begin() + 2, lengths.end()}, {errors[1].begin() + 2, errors[1].end()});
  double const one_step = std::max(errors[2][0], errors[3][0]);
  auto const seen = follow(Conserved::all_invariants, 1, true);
  program.figure("order", slope, "order of the Lie-Poisson variant");
  program.figure("one_step", one_step, "relative error of the other two variants after a single step");
  program.figure("drift", seen.drift, book::number(seen.drift, 12),
                 "drift of the wave in one step, radians per unit of time");
  program.figure("exact_drift", drift_of(degree), book::number(drift_of(degree), 12),
                 "the drift of the fluid");
  program.picture("wave", wave_on_discs(),
                  "The vorticity of the wave, seen by an observer on the rotating sphere, at "
                  "the start and after eight steps of the variant of all invariants: it drifts "
                  "to the west and keeps its shape.");

  // 6. What must be so. Rounding of a solved step: a hundred epsilon for each of some ten evaluations.
  double const eps = std::numeric_limits<double>::epsilon();
  program.claim(std::abs(slope - 2) < 0.1, "the Lie-Poisson variant has order 2");
  program.claim(book::measured(one_step) < 1000 * eps, "one step of the other variants is exact to rounding");
  program.claim(book::measured(std::abs(seen.drift - drift_of(degree))) < 1000 * eps,
                "the wave drifts as in the fluid");
  program.headline("the wave exact to " + book::number(one_step, 2) + " in one step", one_step);
  return program.finish();
}
