// A long run on the torus: energy and spectrum at once, without a drift.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/vorticity/torus_steps.hpp"
#include "torus_flows.hpp"

using namespace actio;
using namespace actio::torus;

BOOST_AUTO_TEST_SUITE(torus_long_run)

BOOST_AUTO_TEST_CASE(energy_and_every_casimir_stay_together) {
  int const n = 15, steps = 10000;
  TorusStream const stream(n);
  sphere::SkewHermitian<> const start = testing::random_torus_state(n, 7, 3);
  double const h = 0.1 * 2 * QuantizedTorus(n).hbar() / TorusStep::spectral_radius(stream.solve(start));
  double const energy = flow_energy(stream, start);
  // Casimirs in units of what those of the moduli of the values are.
  Eigen::VectorXd const values = sphere::hermitian_values(start.hermitian());
  for (auto const form : {sphere::Conserved::energy_casimir, sphere::Conserved::lie_poisson}) {
    sphere::SkewHermitian<> w = start;
    TorusStep step(stream, form, h);
    double most_energy = 0, most_casimirs = 0;
    for (int k = 1; k <= steps; ++k) {
      step.advance(w);
      most_energy = std::max(most_energy, std::abs(flow_energy(stream, w) / energy - 1));
      if (k % 500 != 0) continue;
      Eigen::VectorXd const now = sphere::hermitian_values(w.hermitian());
      for (int j = 2; j <= 8; ++j)
        most_casimirs =
            std::max(most_casimirs, std::abs(now.array().pow(j).sum() - values.array().pow(j).sum()) /
                                        values.cwiseAbs().array().pow(j).sum());
    }
    double const spectrum = (sphere::hermitian_values(w.hermitian()) - values).cwiseAbs().maxCoeff() /
                            values.cwiseAbs().maxCoeff();
    BOOST_TEST_MESSAGE("N = " << n << ", " << steps << " steps: energy " << most_energy << ", C_2 to C_8 "
                              << most_casimirs << ", spectrum " << spectrum);
    BOOST_TEST(sphere::norm(w - start) > 0.5 * sphere::norm(start));
    BOOST_TEST(spectrum <= 1e-14);
    BOOST_TEST(most_casimirs <= 1e-12);
    if (form == sphere::Conserved::energy_casimir)
      BOOST_TEST(most_energy <= 1e-12);
    else
      BOOST_TEST(most_energy > 1e-6);
  }
}

BOOST_AUTO_TEST_SUITE_END()
