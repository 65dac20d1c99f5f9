// The step of the fluid on the sphere: what each form conserves, and that it goes back.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/vorticity_step.hpp"
#include "caught.hpp"
#include "flows.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_state;

BOOST_AUTO_TEST_SUITE(vorticity_step)

BOOST_AUTO_TEST_CASE(each_form_conserves_what_it_says_and_is_reversible) {
  int const n = 16, steps = 50;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, 9);
  auto const energy = [&](auto const& w) { return inner_product(laplacian.solve(w), w); };
  auto const spectrum = [](auto const& w) { return hermitian_values(w.hermitian()); };
  Eigen::Vector3d const momentum = spin_components(sphere, start);
  double const size = spectrum(start).cwiseAbs().maxCoeff();
  TurningFrame const calm = calmest_frame(sphere, laplacian, start);
  for (auto const conserved : {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants})
    for (TurningFrame const& frame : {TurningFrame{}, calm}) {
      SkewHermitian<> w = start;
      VorticityStep<> forwards(laplacian, conserved, 0.02, frame),
          backwards(laplacian, conserved, -0.02, frame);
      for (int k = 0; k < steps; ++k) forwards.advance(w);
      double const by_energy = std::abs(energy(w) / energy(start) - 1);
      double const by_momentum = (spin_components(sphere, w) - momentum).norm() / momentum.norm();
      BOOST_TEST((spectrum(w) - spectrum(start)).cwiseAbs().maxCoeff() <= 1e-13 * size);
      BOOST_TEST((conserved == Conserved::lie_poisson ? by_energy > 1e-9 : by_energy <= 1e-13));
      BOOST_TEST((conserved == Conserved::energy_casimir ? by_momentum > 1e-9 : by_momentum <= 1e-13));
      for (int k = 0; k < steps; ++k) backwards.advance(w);
      BOOST_TEST(norm(w - start) <= 1e-12 * norm(start));
    }
}

// A step that is named as one that does must do; the one that was tried does not.
BOOST_AUTO_TEST_CASE(a_step_that_is_too_long_names_one_that_is_not) {
  int const n = 16;
  SphereLaplacian const laplacian(n);
  for (SkewHermitian<> const& start : {random_state(n, 1, 9), random_state(n, 8, n - 1)})
    for (auto const conserved :
         {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
      double const longer = 1e4;
      SkewHermitian<> w = start;
      VorticityStep<> step(laplacian, conserved, longer);
      double const named = testing::caught<NotContracting>([&] { step.advance(w); }).largest;
      BOOST_TEST(norm(w - start) == 0);
      BOOST_TEST(named > 0);
      BOOST_TEST(named < longer);
      VorticityStep<> shorter(laplacian, conserved, named), twice(laplacian, conserved, 2 * named);
      BOOST_CHECK_NO_THROW(shorter.advance(w));
      w = start;
      CHECK_REFUSED(twice.advance(w), NotContracting);
      // Back in time as well.
      VorticityStep<> back(laplacian, conserved, -longer);
      CHECK_REFUSED(back.advance(w), NotContracting);
    }
}

BOOST_AUTO_TEST_CASE(what_is_no_number_is_refused_and_nothing_stays_nothing) {
  int const n = 8;
  SphereLaplacian const laplacian(n);
  double const nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  CHECK_REFUSED(VorticityStep<>(laplacian, Conserved::lie_poisson, 0), OutsideDomain);
  CHECK_REFUSED(VorticityStep<>(laplacian, Conserved::lie_poisson, nan), NotFinite);
  for (auto const conserved :
       {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
    VorticityStep<> step(laplacian, conserved, 0.1);
    for (double bad : {nan, infinity}) {
      SkewHermitian<> w = random_state(n, 1, n - 1);
      w.imaginary(2, 3) = bad;
      CHECK_REFUSED(step.advance(w), NotFinite);
    }
    SkewHermitian<> zero(n);
    BOOST_TEST(step.advance(zero).iterations == 0);
    BOOST_TEST(norm(zero) == 0);
    // Smaller than what has a square, and larger.
    for (double scale : {1e-300, 1e-170, 1e200}) {
      SkewHermitian<> w = scale * random_state(n, 1, n - 1);
      CHECK_REFUSED(step.advance(w), Error);
    }
  }
}

// The unit of time is no part of the motion.
BOOST_AUTO_TEST_CASE(a_power_of_two_changes_no_digit) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, n - 1);
  for (auto const conserved : {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants})
    for (int power : {-400, -17, 400}) {
      double const unit = std::ldexp(1.0, power);
      SkewHermitian<> w = start, scaled = unit * start;
      VorticityStep<> step(laplacian, conserved, 0.1), other(laplacian, conserved, 0.1 / unit);
      for (int k = 0; k < 4; ++k) step.advance(w), other.advance(scaled);
      BOOST_TEST(norm((1 / unit) * scaled - w) <= 1e-14 * norm(w));
    }
}

// The middle comes from two solves, each off by rounding times the condition of 1 - A.
BOOST_AUTO_TEST_CASE(an_elimination_finds_the_middle_for_a_displacement_of_any_size) {
  int const n = 16;
  SkewHermitian<> const w = random_state(n, 1, 9), p = SphereLaplacian(n).solve(random_state(n, 2, 7));
  ComplexMatrix<> const one = ComplexMatrix<>::Identity(n, n), start = w.complex();
  for (double const size : {0.01, 1.0, 100.0}) {
    SkewHermitian<> const a = (size / norm(p)) * p;
    SkewHermitian<> middle(n);
    eliminate_middle(a, w, middle);
    ComplexMatrix<> const A = a.complex(), M = middle.complex();
    double const bound = 8 * n * std::numeric_limits<double>::epsilon() * (1 + size) * (1 + size) * norm(w);
    BOOST_TEST(((one - A) * M * (one + A) - start).norm() <= bound);
    BOOST_TEST(((one + A) * M * (one - A) - start).norm() > 1e-4 * norm(w));  // the end of the step
  }
}

BOOST_AUTO_TEST_SUITE_END()
