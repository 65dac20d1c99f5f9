// Long runs of averaged flow, in mixed precision: what each form conserves, at three lengths of averaging.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/averaged_steps.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;

BOOST_AUTO_TEST_SUITE(averaged_long_run)

BOOST_AUTO_TEST_CASE(each_form_conserves_what_it_conserves_without_averaging) {
  int const n = 64, steps = 2000;
  QuantizedSphere const sphere(n);
  SkewHermitian<> const start = testing::random_state(n, 1, 9, 11);
  for (double const alpha : {0.03, 0.1, 0.3}) {
    AveragedStream const stream(n, alpha, AveragedMetric::deformation);
    auto const calm = calmest_frame(sphere, stream, start);
    SkewHermitian<> const turns = (calm.rate * sphere.hbar()) * calm.generator(sphere);
    double const h =
        0.1 * 2 * sphere.hbar() / FastVorticityStep<>::spectral_radius(stream.solve(start) + turns);
    testing::Invariants const before(stream, start);
    for (auto const form : {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
      FastVorticityStep<AveragedStream> step(stream, form, h, calm);
      SkewHermitian<> w = start;
      double energy = 0, momentum = 0;
      for (int k = 1; k <= steps; ++k) {
        step.advance(w);
        if (k % 500 != 0) continue;
        auto const change = testing::Invariants(stream, w) - before;
        energy = std::max(energy, change.energy), momentum = std::max(momentum, change.momentum);
      }
      double const spectrum = (testing::Invariants(stream, w) - before).spectrum;
      BOOST_TEST_MESSAGE("alpha = " << alpha << ", form " << static_cast<int>(form) << ": energy " << energy
                                    << ", momentum " << momentum << ", spectrum " << spectrum);
      BOOST_TEST(norm(w - start) > 0.1 * norm(start));
      BOOST_TEST(spectrum <= 1e-12);
      if (form != Conserved::lie_poisson) BOOST_TEST(energy <= 1e-12);
      if (form != Conserved::energy_casimir) BOOST_TEST(momentum <= 1e-12);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
