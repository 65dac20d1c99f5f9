// Flows whose motion is known: steady ones, waves of Rossby and Haurwitz, and what is near them; the order of
// each form of the step; and the way back.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/vorticity_step.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_state, testing::RossbyHaurwitz, testing::Invariants;

namespace {

constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};
char const* name(Conserved conserved) {
  return conserved == Conserved::lie_poisson      ? "lie_poisson"
         : conserved == Conserved::energy_casimir ? "energy_casimir"
                                                  : "all_invariants";
}

SkewHermitian<> after(SphereLaplacian const& laplacian, Conserved conserved, double time, int steps,
                      TurningFrame const& frame, SkewHermitian<> w) {
  VorticityStep<> step(laplacian, conserved, time / steps, frame);
  for (int k = 0; k < steps; ++k) step.advance(w);
  return frame.rate == 0 ? w : Turning(QuantizedSphere(laplacian.size()), frame.axis)(frame.rate * time, w);
}

/// The order of a form against a known end, from `coarsest` steps on, doubled `count` - 1 times.
testing::Line order_against(SkewHermitian<> const& truth, SphereLaplacian const& laplacian,
                            Conserved conserved, double time, int coarsest, int count,
                            TurningFrame const& frame, SkewHermitian<> const& start) {
  std::vector<double> steps, errors;
  for (int k = 0, all = coarsest; k < count; ++k, all *= 2) {
    steps.push_back(time / all);
    errors.push_back(norm(after(laplacian, conserved, time, all, frame, start) - truth) / norm(truth));
  }
  auto const line = testing::order_of(steps, errors);
  BOOST_TEST_MESSAGE(name(conserved) << (frame.rate == 0 ? "" : " in the calmest frame") << ": order "
                                     << line.slope << " +- " << line.error << ", errors " << errors.front()
                                     << " to " << errors.back());
  // The last error is the scheme's, far above rounding.
  BOOST_TEST(errors.back() > 1e-9);
  return line;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(exact_flows)

BOOST_AUTO_TEST_CASE(zonal_flows_are_steady) {
  int const n = 24, steps = 20;
  SphereLaplacian const laplacian(n);
  SphereHarmonics f = testing::random_harmonics(n, 1, n - 1);
  f.coefficient.rightCols(n - 1).setZero();
  SkewHermitian<> const start = matrix_of(f);
  for (auto const conserved : forms) {
    // A is diagonal too, and commutes: nothing is rounded but products whose difference is zero.
    SkewHermitian<> const end = after(laplacian, conserved, 4, steps, {}, start);
    BOOST_TEST(norm(end - start) <= 1e-15 * steps * norm(start));
  }
  // Turned to another axis the flow is as steady, up to the scheme in the Lie-Poisson form.
  QuantizedSphere const sphere(n);
  SkewHermitian<> const tilted = Turning(sphere, Eigen::Vector3d::UnitX())(0.5, start);
  BOOST_TEST(norm(tilted - start) > 0.1 * norm(start));
  for (auto const conserved : {Conserved::energy_casimir, Conserved::all_invariants})
    BOOST_TEST(norm(after(laplacian, conserved, 1, steps, {}, tilted) - tilted) <=
               1e-14 * steps * norm(start));
}

BOOST_AUTO_TEST_CASE(a_single_degree_is_steady) {
  int const n = 24, steps = 10;
  SphereLaplacian const laplacian(n);
  for (int l : {1, 2, 5, 23}) {
    SkewHermitian<> const start = random_state(n, l, l);
    for (auto const conserved : {Conserved::energy_casimir, Conserved::all_invariants})
      BOOST_TEST(norm(after(laplacian, conserved, 2, steps, {}, start) - start) <=
                 1e-14 * steps * norm(start));
  }
  // P of the middle is not parallel to W: the Lie-Poisson form moves it, less with the square of the step.
  SkewHermitian<> const start = random_state(n, 5, 5);
  auto const line = order_against(start, laplacian, Conserved::lie_poisson, 2, 10, 4, {}, start);
  BOOST_TEST(std::abs(line.slope - 2) <= 0.05);
}

BOOST_AUTO_TEST_CASE(the_wave_solves_the_equations) {
  for (int n : {8, 33}) {
    QuantizedSphere const sphere(n);
    SphereLaplacian const laplacian(n);
    RossbyHaurwitz const wave;
    SkewHermitian<> const w = wave.after(n, 0.7);
    SkewHermitian<> const moves = (1 / sphere.hbar()) * commutator(laplacian.solve(w), w);
    // It turns about the pole with its rate.
    SkewHermitian<> const turns = -wave.rate() * spin_commutator(sphere, 2, w);
    BOOST_TEST(norm(moves - turns) <= 1e-15 * n * n * norm(w));
    BOOST_TEST(norm(turns) > 0.1 * norm(w));
  }
}

BOOST_AUTO_TEST_CASE(without_a_frame_the_wave_is_found_to_order_two) {
  int const n = 16;
  SphereLaplacian const laplacian(n);
  RossbyHaurwitz const wave;
  double const time = 2;
  // The corrections of all invariants are not unique on a wave: that form needs the frame, where there are
  // none.
  for (auto const conserved : {Conserved::lie_poisson, Conserved::energy_casimir}) {
    auto const line =
        order_against(wave.after(n, time), laplacian, conserved, time, 20, 4, {}, wave.state(n));
    BOOST_TEST(std::abs(line.slope - 2) <= 0.05);
  }
}

BOOST_AUTO_TEST_CASE(in_its_frame_the_wave_is_exact_in_one_step_of_any_size) {
  for (int n : {12, 32}) {
    QuantizedSphere const sphere(n);
    SphereLaplacian const laplacian(n);
    for (double planet : {0.0, 3.0}) {
      // On a rotating sphere: the absolute vorticity in the inertial frame is a wave with another rotation.
      RossbyHaurwitz wave;
      wave.rotation += 2 * planet;
      TurningFrame const frame = calmest_frame(sphere, laplacian, wave.state(n));
      for (auto const conserved : {Conserved::energy_casimir, Conserved::all_invariants})
        for (double time : {1e-3, 2.0, -50.0, 1e4}) {
          SkewHermitian<> const end = after(laplacian, conserved, time, 1, frame, wave.state(n));
          // The rate is good to some epsilon, and the angle to as many times itself; orders go up to 5.
          double const angle = std::abs(wave.rate() * time) * wave.degree, size = norm(wave.state(n));
          BOOST_TEST(norm(end - wave.after(n, time)) <= 2e-15 * (n + n * angle) * size);
          // The relative vorticity of the fluid that the planet carries along.
          if (time != 2.0) continue;
          Turning const turning(sphere, Eigen::Vector3d::UnitZ());
          SkewHermitian<> const seen = turning(-planet * time, end) - planetary_vorticity(sphere, planet);
          RossbyHaurwitz const relative;
          double const drift =
              (relative.rotation / 2 + planet) - (relative.rotation + 2 * planet) / 30 - planet;
          SkewHermitian<> const truth =
              planetary_vorticity(sphere, relative.rotation / 2) + turning(drift * time, relative.wave(n));
          BOOST_TEST(norm(seen - truth) <= 2e-15 * (n + n * angle) * size);
        }
    }
  }
}

// The sheet of states that turn with their frame is where the corrections of the invariants are not unique.
BOOST_AUTO_TEST_CASE(near_waves_all_invariants_hold) {
  int const n = 24, steps = 60;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  RossbyHaurwitz const wave;
  for (double planet : {0.0, 2.0})
    for (double perturbation : {0.0, 1e-6, 1e-4, 1e-2, 1e-1}) {
      SkewHermitian<> const rest = random_state(n, 1, n - 1, 9);
      SkewHermitian<> const start = wave.state(n) + planetary_vorticity(sphere, planet) + perturbation * rest;
      TurningFrame const frame = calmest_frame(sphere, laplacian, start);
      SkewHermitian<> w = start;
      VorticityStep<> step(laplacian, Conserved::all_invariants, 0.1, frame);
      int most = 0;
      for (int k = 0; k < steps; ++k) most = std::max(most, step.advance(w).iterations);
      testing::Changes const changes = Invariants(laplacian, w) - Invariants(laplacian, start);
      BOOST_TEST_MESSAGE("wave + " << perturbation << ", planet " << planet << ": energy " << changes.energy
                                   << ", momentum " << changes.momentum << ", spectrum " << changes.spectrum
                                   << ", at most " << most << " iterations");
      // Each step rounds N terms.
      BOOST_TEST(changes.energy <= 4e-16 * (steps + n));
      BOOST_TEST(changes.momentum <= 4e-16 * (steps + n));
      BOOST_TEST(changes.spectrum <= 4e-16 * (steps + n));
    }
}

// A planet that turns by a radian in a step, twenty times as fast as the fluid on it: its vorticity must not
// be taken for a motion.
BOOST_AUTO_TEST_CASE(on_a_fast_planet_all_invariants_hold) {
  int const n = 16, steps = 40;
  SphereLaplacian const laplacian(n);
  double const planet = 20;
  SkewHermitian<> const start =
      random_state(n, 1, n - 1, 9) + planetary_vorticity(QuantizedSphere(n), planet);
  TurningFrame const frame = calmest_frame(QuantizedSphere(n), laplacian, start);
  SkewHermitian<> w = start;
  VorticityStep<> step(laplacian, Conserved::all_invariants, 1 / planet, frame);
  int most = 0;
  for (int k = 0; k < steps; ++k) most = std::max(most, step.advance(w).iterations);
  testing::Changes const changes = Invariants(laplacian, w) - Invariants(laplacian, start);
  BOOST_TEST_MESSAGE("planet " << planet << ", a radian a step: energy " << changes.energy << ", momentum "
                               << changes.momentum << ", spectrum " << changes.spectrum << ", at most "
                               << most << " iterations");
  BOOST_TEST(changes.energy <= 4e-16 * (steps + n));
  BOOST_TEST(changes.momentum <= 4e-16 * (steps + n));
  BOOST_TEST(changes.spectrum <= 4e-16 * (steps + n));
}

// A state of all scales, against a fine run of another form.
BOOST_AUTO_TEST_CASE(each_form_is_of_order_two) {
  int const n = 12;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, n - 1, 2);
  double const time = 1;
  TurningFrame const calm = calmest_frame(sphere, laplacian, start);
  // Richardson's extrapolation of two fine runs: an error of order four.
  SkewHermitian<> const fine = after(laplacian, Conserved::lie_poisson, time, 3200, {}, start),
                        half = after(laplacian, Conserved::lie_poisson, time, 1600, {}, start);
  SkewHermitian<> const truth = fine + (1.0 / 3) * (fine - half);
  BOOST_TEST(norm(truth - start) > 0.1 * norm(start));
  for (auto const conserved : forms)
    for (TurningFrame const& frame : {TurningFrame{}, calm}) {
      auto const line = order_against(truth, laplacian, conserved, time, 50, 4, frame, start);
      BOOST_TEST(std::abs(line.slope - 2) <= 0.05);
    }
}

BOOST_AUTO_TEST_CASE(each_form_goes_back) {
  int const n = 16, steps = 20;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, n - 1, 4);
  for (auto const conserved : forms)
    for (TurningFrame const& frame : {TurningFrame{}, calmest_frame(sphere, laplacian, start)}) {
      SkewHermitian<> w = start;
      VorticityStep<> forwards(laplacian, conserved, 0.04, frame),
          backwards(laplacian, conserved, -0.04, frame);
      for (int k = 0; k < steps; ++k) forwards.advance(w);
      BOOST_TEST(norm(w - start) > 1e-2 * norm(start));
      for (int k = 0; k < steps; ++k) backwards.advance(w);
      // Roundings of both ways, which the flow tears apart by a factor that is not large in so short a time.
      BOOST_TEST(norm(w - start) <= 1e-13 * norm(start));
    }
}

BOOST_AUTO_TEST_SUITE_END()
