// Averaged flow: its stream function, what its metric measures, its waves, its vortices, and the limit of
// Euler's fluid.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/averaged_steps.hpp"
#include "caught.hpp"
#include "flows.hpp"
#include "refused.hpp"
#include "vortex_pairs.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::caught;
using testing::random_matrix, testing::random_state, testing::random_harmonics;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};
constexpr AveragedMetric metrics[] = {AveragedMetric::deformation, AveragedMetric::rough};

/// By what a degree is divided.
double divisor(AveragedStream const& stream, int l) {
  double const y = l * (l + 1.0), square = stream.alpha() * stream.alpha();
  return y * (1 + square * (stream.metric() == AveragedMetric::deformation ? y - 2 : y));
}
SkewHermitian<> half_a_turn(int n) { return planetary_vorticity(QuantizedSphere(n), 0.35); }

}  // namespace

BOOST_AUTO_TEST_SUITE(averaged_flow)
BOOST_AUTO_TEST_CASE(what_has_no_averaged_flow_is_refused) {
  CHECK_REFUSED(AveragedStream(8, -0.1, AveragedMetric::rough), OutsideDomain);
  CHECK_REFUSED(AveragedStream(8, 0.75, AveragedMetric::deformation), OutsideDomain);
  CHECK_REFUSED(AveragedStream(8, std::nan(""), AveragedMetric::rough), NotFinite);
  CHECK_REFUSED(AveragedStream(1, 0.1, AveragedMetric::rough), OutsideDomain);
  auto const error =
      caught<OutsideDomain>([&] { AveragedStream(8, std::sqrt(0.5), AveragedMetric::deformation); });
  BOOST_TEST((error.measured == std::sqrt(0.5) && error.bound == std::sqrt(0.5)));
  AveragedStream(8, 40, AveragedMetric::rough);
}

// The coefficients of a degree are what they were, divided; whatever alpha is, and up to l = 199.
BOOST_AUTO_TEST_CASE(the_stream_of_averaged_flow_is_divided_by_degrees) {
  int const n = 200;
  double worst = 0;
  for (auto const metric : metrics)
    for (double const square : {1e-4, 1e-2, 0.1, 0.3}) {
      AveragedStream const stream(n, std::sqrt(square), metric);
      for (int const l : {1, 2, 3, 17, 60, 130, 199}) {
        auto const f = random_harmonics(n, l, l);
        SkewHermitian<> const w = matrix_of(f), p = stream.solve(w);
        double const error =
            (divisor(stream, l) * harmonics_of(p).coefficient.row(l) + f.coefficient.row(l)).norm() /
            f.coefficient.row(l).norm();
        worst = std::max(worst, error);
        // To the harmonics and back, and two solves: sums of n terms in each.
        BOOST_TEST(error <= 4 * 4 * n * eps);
        // Other degrees have the rounding of entries up to N^2, of which the degree 1 is divided by 2 alone.
        BOOST_TEST(norm(p + (1 / divisor(stream, l)) * w) <= 1e-16 * n * n * norm(w) / 2);
      }
    }
  BOOST_TEST_MESSAGE("within a degree " << worst);
}

BOOST_AUTO_TEST_CASE(the_stream_of_averaged_flow_solves_its_equation) {
  for (int const n : {2, 3, 30})
    for (auto const metric : metrics)
      for (double const alpha : {0.0, 0.1, 0.7}) {
        SphereLaplacian const laplacian(n);
        SkewHermitian<> w = random_matrix(n);
        SkewHermitian<> const p = AveragedStream(n, alpha, metric).solve(w), curl = laplacian.apply(p);
        double const square = alpha * alpha, shift = metric == AveragedMetric::deformation ? 2 : 0;
        w.imaginary.diagonal().array() -= w.imaginary.trace() / n;
        SkewHermitian<> const q = (1 - shift * square) * curl - square * laplacian.apply(curl);
        double const most = (1 + square * n * n) * n * n;  // of the operator
        BOOST_TEST(norm(q - w) <= eps * n * most * norm(p));
        BOOST_TEST(std::abs(p.imaginary.trace()) <= 4 * eps * n * norm(p));
        if (alpha == 0) BOOST_TEST(norm(p - laplacian.solve(w)) <= n * eps * norm(p));
      }
}

// psi = a z + b z^2 + c z^3, with u = -sin(theta) psi'(z) to the east: |Def u|^2 = sin(theta)^4 psi''^2/2.
BOOST_AUTO_TEST_CASE(the_energy_is_that_of_the_rate_of_deformation) {
  int const n = 12;
  double const a = 0.7, b = -0.4, c = 0.9, alpha = 0.3;
  double const velocity = 2 * M_PI * (4 * a * a / 3 + (4 * b * b + 6 * a * c) * 4 / 15 + 9 * c * c * 4 / 35);
  double const def = M_PI * (4 * b * b * 16 / 15 + 36 * c * c * 16 / 105);
  // In Legendre polynomials, and its Laplacian.
  double const legendre[] = {a + 0.6 * c, 2 * b / 3, 0.4 * c};
  SphereHarmonics psi(n);
  double curl = 0;
  for (int l = 1; l <= 3; ++l) {
    psi(l, 0) = legendre[l - 1] * std::sqrt(4 * M_PI / (2 * l + 1));
    curl += std::pow(l * (l + 1) * psi(l, 0).real(), 2);
  }
  SphereLaplacian const laplacian(n);
  for (auto const metric : metrics) {
    bool const deforms = metric == AveragedMetric::deformation;
    SkewHermitian<> const omega = laplacian.apply(matrix_of(psi)),
                          q = (1 - (deforms ? 2 : 0) * alpha * alpha) * omega -
                              alpha * alpha * laplacian.apply(omega);
    double const truth = velocity / 2 + alpha * alpha * (deforms ? def : curl / 2);
    BOOST_TEST(std::abs(vorticity_energy(AveragedStream(n, alpha, metric), q) / truth - 1) <= 64 * n * eps);
  }
}

// Every form conserves what it conserves of Euler's fluid, in mixed precision, too.
BOOST_AUTO_TEST_CASE(averaged_flow_conserves_what_each_form_conserves) {
  int const n = 20, steps = 40;
  QuantizedSphere const sphere(n);
  SkewHermitian<> const start = random_state(n, 1, n - 1);
  auto const run = [&]<class Step>(AveragedStream const& stream, Conserved conserved) {
    TurningFrame const calm = calmest_frame(sphere, stream, start);
    SkewHermitian<> w = start;
    Step step(stream, conserved, 0.2, calm);
    for (int k = 0; k < steps; ++k) step.advance(w);
    testing::Changes const changes = testing::Invariants(stream, w) - testing::Invariants(stream, start);
    BOOST_TEST(norm(w - start) > 0.1 * norm(start));
    BOOST_TEST(changes.spectrum <= 1e-15 * (steps + n));
    if (conserved == Conserved::lie_poisson) BOOST_TEST(changes.energy > 1e-12);
    if (conserved != Conserved::lie_poisson) BOOST_TEST(changes.energy <= 1e-15 * (steps + n));
    if (conserved == Conserved::energy_casimir) BOOST_TEST(changes.momentum > 1e-12);
    if (conserved != Conserved::energy_casimir) BOOST_TEST(changes.momentum <= 1e-15 * (steps + n));
  };
  for (auto const metric : metrics)
    for (double const alpha : {0.03, 0.1, 0.3})
      for (auto const conserved : forms) {
        AveragedStream const stream(n, alpha, metric);
        run.operator()<VorticityStep<AveragedStream>>(stream, conserved);
        run.operator()<FastVorticityStep<AveragedStream>>(stream, conserved);
      }
}

// A rotation a z and one degree: P is -a z/d_1 and -W_l/d_l, which turns the wave at the difference times a.
BOOST_AUTO_TEST_CASE(a_wave_of_averaged_flow_is_exact_in_one_step) {
  int const n = 20;
  QuantizedSphere const sphere(n);
  Turning const turning(sphere, Eigen::Vector3d::UnitZ());
  testing::RossbyHaurwitz const wave;
  for (auto const metric : metrics)
    for (double const alpha : {0.03, 0.1, 0.3})
      for (auto const conserved : {Conserved::energy_casimir, Conserved::all_invariants}) {
        AveragedStream const stream(n, alpha, metric);
        double const time = 3,
                     rate = wave.rotation * (1 / divisor(stream, 1) - 1 / divisor(stream, wave.degree));
        TurningFrame const frame = calmest_frame(sphere, stream, wave.state(n));
        BOOST_TEST(std::abs(frame.rate / rate - 1) <= 16 * n * eps);
        SkewHermitian<> w = wave.state(n);
        VorticityStep<AveragedStream>(stream, conserved, time, frame).advance(w);
        SkewHermitian<> const truth = half_a_turn(n) + turning(rate * time, wave.wave(n));
        // The step to 5e-15, as without averaging; then the angle, which has the rounding of the rate.
        BOOST_TEST(norm(w - wave.state(n)) <= 5e-15 * norm(w));
        BOOST_TEST(norm(turning(frame.rate * time, w) - truth) <= 64 * n * eps * norm(w));
        // With Euler's rate it would be elsewhere.
        BOOST_TEST(norm(turning(wave.rate() * time, w) - truth) > 1e6 * 64 * n * eps * norm(w));
      }
}

// The sphere turns, and psi comes from q - 2 Omega z: the free flow of q, turned back at 2 Omega/d_1.
BOOST_AUTO_TEST_CASE(averaged_flow_on_a_rotating_sphere_is_a_free_one_in_another_frame) {
  int const n = 14;
  double const rotation = 1.5;
  QuantizedSphere const sphere(n);
  SkewHermitian<> const planet = planetary_vorticity(sphere, rotation),
                        q = random_state(n, 1, n - 1) + planet;
  for (auto const metric : metrics) {
    AveragedStream const stream(n, 0.3, metric);
    SkewHermitian<> const truth = (1 / sphere.hbar()) * commutator(stream.solve(q - planet), q);
    double const rate = metric == AveragedMetric::deformation ? rotation : rotation / (1 + 2 * 0.09);
    SkewHermitian<> const free = (1 / sphere.hbar()) * commutator(stream.solve(q), q);
    BOOST_TEST(norm(free + rate * spin_commutator(sphere, 2, q) - truth) <= 1e-14 * n * norm(truth));
    if (metric == AveragedMetric::rough)
      BOOST_TEST(norm(free + rotation * spin_commutator(sphere, 2, q) - truth) > 0.1 * norm(truth));
  }
}

// At a fixed N. To first order P changes by alpha^2 W, which commutes with W, and with the deformation by 2
// alpha^2 times itself as well, so that time runs faster by that: like alpha^2, and with the rough metric
// like alpha^4.
BOOST_AUTO_TEST_CASE(averaged_flow_tends_to_euler_s) {
  int const n = 24, steps = 20;
  SkewHermitian<> const start = random_state(n, 1, 6);
  auto const run = [&](auto const& stream) {
    SkewHermitian<> w = start;
    VorticityStep step(stream, Conserved::all_invariants, 0.05,
                       calmest_frame(QuantizedSphere(n), SphereLaplacian(n), start));
    for (int k = 0; k < steps; ++k) step.advance(w);
    return w;
  };
  SkewHermitian<> const euler = run(SphereLaplacian(n));
  for (auto const metric : metrics) {
    std::vector<double> lengths{0.04, 0.02, 0.01, 0.005}, apart;
    for (double const alpha : lengths)
      apart.push_back(norm(run(AveragedStream(n, alpha, metric)) - euler) / norm(euler));
    BOOST_TEST_MESSAGE("apart " << apart.front() << " to " << apart.back());
    BOOST_TEST(apart.back() > 1e-9);
    // The next power is alpha^2 l(l + 1) times as large: a tenth, for the longest length.
    double const order = metric == AveragedMetric::rough ? 4 : 2;
    BOOST_TEST(std::abs(testing::order_of(lengths, apart).slope - order) <= 0.1);
  }
}

// Points have the rate of a conical function. Matrices have vortices of the size N^{-1/2}, whose rate is off
// by the square of that; extrapolated, by the fourth power of their size in units of alpha.
BOOST_AUTO_TEST_CASE(two_vortices_of_averaged_flow_turn_as_points_do) {
  testing::VortexPair const pair;
  int const n = 64;
  for (auto const metric : metrics)
    for (double const alpha : {0.2, 0.3}) {
      double const truth = pair.rate_of_points(alpha, metric),
                   coarse = pair.rate(AveragedStream(n, alpha, metric)) / truth - 1,
                   fine = pair.rate(AveragedStream(2 * n, alpha, metric)) / truth - 1;
      BOOST_TEST_MESSAGE("alpha " << alpha << ": " << truth << ", off by " << coarse << ", " << fine
                                  << ", extrapolated " << 2 * fine - coarse);
      double const bound = 1 / (alpha * alpha * n * n);
      BOOST_TEST(std::abs(2 * fine - coarse) <= bound);
      // Euler's rate is another one, and that of the other metric is.
      BOOST_TEST(std::abs(pair.rate_of_points(0, metric) / truth - 1) > 3 * bound);
      auto const other =
          metric == AveragedMetric::rough ? AveragedMetric::deformation : AveragedMetric::rough;
      BOOST_TEST(std::abs(pair.rate_of_points(alpha, other) / truth - 1) > 3 * bound);
    }
  // Far apart on the scale of alpha, the rough metric has Euler's rate but for e^{-d/alpha}.
  BOOST_TEST(std::abs(pair.rate_of_points(0.03, AveragedMetric::rough) /
                          pair.rate_of_points(0, AveragedMetric::rough) -
                      1) < 1e-10);
}

BOOST_AUTO_TEST_SUITE_END()
