// The stream function of a layer: what is subtracted from the Laplacian, and its waves.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/quantized_sphere/helmholtz_stream.hpp"
#include "actio/vorticity/vorticity_step.hpp"
#include "caught.hpp"
#include "flows.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::caught;
using testing::random_matrix, testing::random_state;

extern template class actio::sphere::VorticityStep<HelmholtzStream>;

namespace {

constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};

}  // namespace

BOOST_AUTO_TEST_SUITE(layers)
BOOST_AUTO_TEST_CASE(the_stream_of_a_layer_is_divided_by_degrees) {
  CHECK_REFUSED(HelmholtzStream(8, 0), OutsideDomain);
  CHECK_REFUSED(HelmholtzStream(8, -1), OutsideDomain);
  CHECK_REFUSED(HelmholtzStream(8, std::nan("")), NotFinite);
  CHECK_REFUSED(HelmholtzStream(1, 1), OutsideDomain);
  for (int n : {2, 3, 30})
    for (double gamma : {1e-6, 2.0, 500.0}) {
      HelmholtzStream const stream(n, gamma);
      SphereLaplacian const laplacian(n);
      for (int l = 0; l < n; l = 2 * l + 1) {
        SkewHermitian<> const w = random_state(n, l, l);
        double const truth = l == 0 ? 0 : -1 / (l * (l + 1.0) + gamma);
        // Rounding of entries up to N^2, by what is divided by at least.
        BOOST_TEST(norm(stream.solve(w) - truth * w) <= 1e-16 * n * n * norm(w) / (2 + gamma));
      }
      SkewHermitian<> w = random_matrix(n);
      SkewHermitian<> const p = stream.solve(w);
      double const mean = w.imaginary.trace() / n;
      w.imaginary.diagonal().array() -= mean;
      BOOST_TEST(norm(laplacian.apply(p) - gamma * p - w) <= 1e-16 * n * n * n * (1 + gamma) * norm(p));
    }
}

// The step takes it in the place of the Laplacian: all invariants hold, energy with its P.
BOOST_AUTO_TEST_CASE(a_layer_flows_and_its_waves_are_exact) {
  int const n = 20, steps = 40;
  QuantizedSphere const sphere(n);
  HelmholtzStream const stream(n, 8);
  SkewHermitian<> const start = random_state(n, 1, n - 1);
  TurningFrame const calm = calmest_frame(sphere, stream, start);
  for (auto const conserved : forms) {
    SkewHermitian<> w = start;
    VorticityStep<HelmholtzStream> step(stream, conserved, 0.1, calm);
    for (int k = 0; k < steps; ++k) step.advance(w);
    testing::Changes const changes = testing::Invariants(stream, w) - testing::Invariants(stream, start);
    BOOST_TEST(norm(w - start) > 0.1 * norm(start));
    BOOST_TEST(changes.spectrum <= 1e-15 * (steps + n));
    if (conserved != Conserved::lie_poisson) BOOST_TEST(changes.energy <= 1e-15 * (steps + n));
    if (conserved != Conserved::energy_casimir) BOOST_TEST(changes.momentum <= 1e-15 * (steps + n));
  }
  // A rotation a z and one degree: P is -a z/(2 + gamma) and -W_l/(l(l + 1) + gamma), which turns the wave at
  // the difference times a.
  testing::RossbyHaurwitz const wave;
  double const rate = wave.rotation * (1 / (2 + stream.gamma()) - 1 / (30 + stream.gamma())), time = 3;
  TurningFrame const frame = calmest_frame(sphere, stream, wave.state(n));
  BOOST_TEST(std::abs(frame.rate / rate - 1) <= 1e-13);
  SkewHermitian<> w = wave.state(n);
  VorticityStep<HelmholtzStream>(stream, Conserved::all_invariants, time, frame).advance(w);
  Turning const turning(sphere, Eigen::Vector3d::UnitZ());
  SkewHermitian<> const truth =
      planetary_vorticity(sphere, wave.rotation / 2) + turning(rate * time, wave.wave(n));
  BOOST_TEST(norm(turning(frame.rate * time, w) - truth) <= 1e-13 * norm(w));
}

// On a rotating sphere psi comes from q - 2 Omega z; the free flow of q, turned back at the frame's rate,
// solves that.
BOOST_AUTO_TEST_CASE(a_layer_on_a_rotating_sphere_is_a_free_one_in_another_frame) {
  int const n = 14;
  double const rotation = 1.5;
  QuantizedSphere const sphere(n);
  HelmholtzStream const stream(n, 5);
  SkewHermitian<> const planet = planetary_vorticity(sphere, rotation),
                        q = random_state(n, 1, n - 1) + planet;
  SkewHermitian<> const truth = (1 / sphere.hbar()) * commutator(stream.solve(q - planet), q);
  // d/dt of the free flow turned by -rate t: minus the rate times the derivative of a turn, -[i S_3, q].
  auto const in_frame = [&](double rate) {
    return (1 / sphere.hbar()) * commutator(stream.solve(q), q) + rate * spin_commutator(sphere, 2, q);
  };
  BOOST_TEST(norm(in_frame(stream.frame_rate(rotation)) - truth) <= 1e-14 * n * norm(truth));
  BOOST_TEST(norm(in_frame(rotation) - truth) > 0.1 * norm(truth));
}

// Rounding is 1/gamma times as large in the trace, and does not stay there.
BOOST_AUTO_TEST_CASE(the_stream_of_a_layer_has_no_trace) {
  for (int n : {2, 3, 30})
    for (double gamma : {1e-9, 1.0}) {
      SkewHermitian<> const p = HelmholtzStream(n, gamma).solve(random_matrix(n));
      BOOST_TEST(std::abs(p.imaginary.trace()) <= 1e-15 * n * norm(p));
    }
  auto const error = caught<OutsideDomain>([&] { HelmholtzStream(8, -0.5); });
  BOOST_TEST((error.measured == -0.5 && error.bound == 0));
}

BOOST_AUTO_TEST_SUITE_END()
