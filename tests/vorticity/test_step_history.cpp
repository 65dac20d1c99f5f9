// What a step of the plain form keeps, how good its first guess is, how fast it converges, and that it solves
// its equation whichever way it was found.
#include <boost/test/unit_test.hpp>

#include "actio/vorticity/diagonal_runge_kutta.hpp"
#include "caught.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::caught;
using testing::random_state, testing::RossbyHaurwitz;

namespace {

constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};

/// By how much the step that was made from W to `end` misses its two equations, relative to |W|.
double missed(VorticityStep<> const& step, SkewHermitian<> const& w, SkewHermitian<> const& end) {
  auto const n = w.size();
  ComplexMatrix<> const one = ComplexMatrix<>::Identity(n, n), a = step.displacement().complex(),
                        middle = step.middle().complex();
  return std::max(((one - a) * middle * (one + a) - w.complex()).norm(),
                  ((one + a) * middle * (one - a) - end.complex()).norm()) /
         norm(w);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(step_history)

BOOST_AUTO_TEST_CASE(as_many_steps_are_kept_as_are_extrapolated) {
  int const n = 8;
  SphereLaplacian const laplacian(n);
  for (auto const conserved : forms)
    for (int kept : {0, 1, 3, 5}) {
      SkewHermitian<> w = random_state(n, 1, n - 1);
      VorticityStep<> step(laplacian, conserved, 0.01);
      BOOST_TEST(step.extrapolated_steps == 5);
      step.extrapolated_steps = kept;
      for (int k = 1; k <= 7; ++k) {
        SkewHermitian<> const before = w;
        step.advance(w);
        BOOST_TEST(step.past().size() == static_cast<std::size_t>(std::min(k, kept)));
        if (kept == 0) continue;
        auto const& newest = step.past().front();
        double const rounding = 1e-14 * norm(w);
        BOOST_TEST(norm(newest.increment - (step.middle() - before)) <= rounding);
        if (conserved == Conserved::lie_poisson)
          BOOST_TEST(newest.half_change.size() == 0);
        else
          BOOST_TEST(norm(newest.half_change - 0.5 * (w - before)) <= rounding);
      }
      step.forget();
      BOOST_TEST(step.past().empty());
    }
}

// With a polynomial of degree 4 through the steps before, the equation is satisfied to some h^5 at once, and
// with the state alone to some h. In between one evaluation is enough for the one, and not for the other.
BOOST_AUTO_TEST_CASE(a_guess_from_five_steps_needs_no_round) {
  int const n = 10;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, 5, 3);
  TurningFrame const calm = calmest_frame(sphere, laplacian, start);
  for (auto const conserved : forms)
    for (TurningFrame const& frame : {TurningFrame{}, calm}) {
      double const h = 0.02;
      std::vector<double> first, residuals;
      for (int kept : {0, 5}) {
        SkewHermitian<> w = start;
        VorticityStep<> step(laplacian, conserved, h, frame);
        step.extrapolated_steps = kept;
        for (int k = 0; k < 6; ++k) step.advance(w);
        // Any residual will do: the report has that of the first guess.
        step.tolerance = 10;
        VorticityReport const report = step.advance(w);
        BOOST_TEST(report.iterations == 1);
        residuals.push_back(report.residual);
      }
      BOOST_TEST_MESSAGE("residual of the first guess: " << residuals[0] << ", extrapolated "
                                                         << residuals[1]);
      BOOST_TEST(residuals[1] <= 1e-6 * residuals[0]);
    }
}

BOOST_AUTO_TEST_CASE(a_step_of_any_length_solves_its_equation) {
  int const n = 12;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  double const unit = std::numeric_limits<double>::epsilon();
  for (double perturbation : {1.0, 1e-6, 0.0})
    for (auto const conserved : forms) {
      SkewHermitian<> const start = RossbyHaurwitz{}.state(n) + perturbation * random_state(n, 1, n - 1, 9);
      TurningFrame const frame = calmest_frame(sphere, laplacian, start);
      for (double h : {0.1, -0.1, 30.0, -300.0}) {
        // Long ones only where nothing moves, and by the forms that leave the wave as it is.
        if (std::abs(h) > 1 && (perturbation != 0 || conserved == Conserved::lie_poisson)) continue;
        SkewHermitian<> w = start;
        VorticityStep<> step(laplacian, conserved, h, frame);
        VorticityReport const report = step.advance(w);
        double const size = norm(step.displacement());
        BOOST_TEST_MESSAGE("h = " << h << ": |A| = " << size << ", " << report.iterations << " evaluations");
        BOOST_TEST(missed(step, start, w) <= 8 * n * unit * (1 + size) * (1 + size));
        BOOST_TEST(report.residual <= 1e-13);
        if (perturbation != 0) BOOST_TEST(norm(w - start) > 1e-9 * norm(start));
      }
    }
}

// A second-order iteration for a spectrum on the imaginary axis up to beta: its errors fall by
// beta/(1 + sqrt(1 + beta^2)) a round. Where W is no rotation beta is 2|A|; where it is little else, what
// changes the rest is a third of the turn.
BOOST_AUTO_TEST_CASE(errors_fall_as_fast_as_the_second_order_iteration_can_make_them) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  QuantizedSphere const sphere(n);
  SkewHermitian<> const waves = random_state(n, 2, 6, 3);
  for (double rotation : {0.0, 40.0})
    for (double beta : {0.3, 0.8}) {
      SkewHermitian<> const start = waves + planetary_vorticity(sphere, rotation);
      double const radius =
          vorticity_values(laplacian.solve(start)).cwiseAbs().maxCoeff() / (2 * sphere.hbar());
      // A rotation 2 Omega z turns by Omega.
      double const h = beta / (2 * radius + rotation / 3);
      SkewHermitian<> w = start;
      VorticityStep<> step(laplacian, Conserved::energy_casimir, h);
      int const made = step.advance(w).iterations;
      double const fall = beta / (1 + std::sqrt(1 + beta * beta)), digits = 36.7;
      BOOST_TEST_MESSAGE("beta = " << beta << ", rotation " << rotation << ": " << made << " evaluations, at "
                                   << fall << " a round " << digits / -std::log(fall));
      // A third more for what the estimate of |A| is short of, and the evaluations that see the end.
      BOOST_TEST(made <= 1.3 * digits / -std::log(fall) + 4);
    }
}

// The composition makes the same steps one after another: its report is that of all of them.
BOOST_AUTO_TEST_CASE(a_composition_reports_what_its_steps_report) {
  int const n = 8;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, n - 1, 5);
  for (double h : {0.2, -0.2}) {
    SkewHermitian<> w = start, composed = start;
    int iterations = 0;
    double residual = 0;
    auto const weights = suzuki<double>();
    for (double const b : weights) {
      VorticityReport const one = VorticityStep<>(laplacian, Conserved::energy_casimir, b * h).advance(w);
      iterations += one.iterations, residual = std::max(residual, one.residual);
    }
    ComposedVorticityStep<> step(laplacian, Conserved::energy_casimir, h, weights);
    VorticityReport const all = step.advance(composed);
    BOOST_TEST(step.step() == h);
    BOOST_TEST(all.iterations == iterations);
    BOOST_TEST(all.residual == residual);
    BOOST_TEST(norm(w - composed) <= 1e-14 * norm(w));
  }
}

// The first substep is too long, of either sign, and names a length; the whole may be as long as that is for
// its longest substep.
BOOST_AUTO_TEST_CASE(a_composition_that_is_too_long_names_a_length_for_its_longest_step) {
  int const n = 10;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, 7, 5);
  for (double h : {500.0, -500.0})
    for (auto const& weights : {std::vector{0.4, 0.6}, {-0.75, 1.75}, {1.0}}) {
      double largest = 0;
      SkewHermitian<> w = start;
      auto const one = caught<NotContracting>(
          [&] { VorticityStep<>(laplacian, Conserved::lie_poisson, weights[0] * h).advance(w); });
      BOOST_TEST(one.step == weights[0] * h);
      largest = std::abs(one.largest);
      auto const composed = caught<NotContracting>(
          [&] { ComposedVorticityStep<>(laplacian, Conserved::lie_poisson, h, weights).advance(w); });
      BOOST_TEST(composed.step == h);
      BOOST_TEST(std::abs(composed.largest / std::copysign(largest / weights.back(), h) - 1) <= 1e-15);
    }
}

// At the triple jump the second weight would be zero; beyond there is none.
BOOST_AUTO_TEST_CASE(the_first_weight_of_five_stages_is_bounded_by_the_triple_jump) {
  double const jump = 1 / (2 - std::cbrt(2.0));
  for (double bad : {jump * (1 + 1e-15), 1.5, 3.0}) {
    auto const error = caught<OutsideDomain>([&] { five_stages(bad); });
    BOOST_TEST(error.measured == bad);
    BOOST_TEST(std::abs(error.bound - jump) <= 4e-16);
  }
  // Both conditions hold for any other first weight; at zero the triple jump remains.
  for (double first : {-2.0, 0.0, jump * (1 - 1e-9)}) {
    auto const b = five_stages(first);
    double sum = 0, cubes = 0, most = 0;
    for (double const x : b) sum += x, cubes += x * x * x, most = std::max(most, std::abs(x));
    BOOST_TEST(b[0] == first);
    BOOST_TEST(std::abs(sum - 1) <= 1e-15 * most);
    BOOST_TEST(std::abs(cubes) <= 1e-14 * most * most * most);
  }
  BOOST_TEST(std::abs(five_stages(0)[1] - jump) <= 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
