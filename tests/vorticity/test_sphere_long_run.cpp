// Long runs: what each form of the step conserves, and that nothing of it drifts.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/vorticity_step.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;

namespace {

/// Changes along a run, each at its sampled steps, and straight lines through them.
struct Record {
  std::vector<double> at, energy, momentum, casimirs;
  double spectrum = 0, most_energy = 0, most_momentum = 0, most_casimirs = 0;
};

/// @param steps  each with the largest eigenvalue of A about a tenth, as a run has by default
Record run(int n, SkewHermitian<> const& start, Conserved conserved, int steps) {
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  TurningFrame const calm = calmest_frame(sphere, laplacian, start);
  SkewHermitian<> const turns = (calm.rate * sphere.hbar()) * calm.generator(sphere);
  double const h = 0.1 * 2 * sphere.hbar() / VorticityStep<>::spectral_radius(laplacian.solve(start) + turns);
  VorticityStep<> step(laplacian, conserved, h, calm);
  double const energy = vorticity_energy(laplacian, start), size = norm(start), area = sphere.area_element();
  double const most_momentum = area * size * std::sqrt(n / 3.0);
  Eigen::Vector3d const momentum = sphere_momentum(start);
  Eigen::VectorXd const casimirs = vorticity_casimirs(start, 8), values = vorticity_values(start);
  double const scale = std::sqrt(2 * enstrophy(start) / (4 * M_PI));  // the mean vorticity
  SkewHermitian<> w = start;
  Record record;
  for (int k = 1; k <= steps; ++k) {
    step.advance(w);
    if (k % 10 != 0) continue;
    record.at.push_back(k);
    record.energy.push_back(vorticity_energy(laplacian, w) / energy - 1);
    record.momentum.push_back((sphere_momentum(w) - momentum).dot(momentum.normalized()) / most_momentum);
    record.most_energy = std::max(record.most_energy, std::abs(record.energy.back()));
    record.most_momentum =
        std::max(record.most_momentum, (sphere_momentum(w) - momentum).norm() / most_momentum);
    if (k % 100 != 0) continue;
    Eigen::VectorXd const now = vorticity_casimirs(w, 8);
    // C_k in units of the k-th power of the mean vorticity, but not below what C_k of the values' moduli is.
    for (int j = 2; j <= 8; ++j) {
      double const unit =
          std::max(4 * M_PI * std::pow(scale, j), area * values.cwiseAbs().array().pow(j).sum());
      record.most_casimirs = std::max(record.most_casimirs, std::abs(now[j - 2] - casimirs[j - 2]) / unit);
    }
  }
  record.spectrum = (vorticity_values(w) - values).cwiseAbs().maxCoeff() / values.cwiseAbs().maxCoeff();
  BOOST_TEST(norm(w - start) > 0.1 * size);
  return record;
}

void report(char const* name, int n, int steps, Record const& r) {
  BOOST_TEST_MESSAGE(name << ", N = " << n << ", " << steps << " steps: energy " << r.most_energy
                          << ", momentum " << r.most_momentum << ", C_2 to C_8 " << r.most_casimirs
                          << ", spectrum " << r.spectrum);
}

/// No drift: a line through the samples rises by less than what is allowed over the run, or by less than four
/// of its standard errors, as roundings make it wander (a random walk has correlated samples, and a line
/// through one looks better than it is: four, and not two).
bool drifts(std::vector<double> const& at, std::vector<double> const& change, double allowed) {
  auto const line = testing::line_through(at, change);
  BOOST_TEST_MESSAGE("  a line through the changes rises by " << line.slope << " +- " << line.error
                                                              << " a step");
  return std::abs(line.slope) * at.back() > allowed && std::abs(line.slope) > 4 * line.error;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sphere_long_run)

BOOST_AUTO_TEST_CASE(casimirs_and_spectrum_stay_in_every_form) {
  int const n = 32, steps = 1500;
  SkewHermitian<> const start = testing::random_state(n, 1, 9, 11);
  Record const poisson = run(n, start, Conserved::lie_poisson, steps),
               energy = run(n, start, Conserved::energy_casimir, steps),
               all = run(n, start, Conserved::all_invariants, steps);
  report("lie_poisson", n, steps, poisson), report("energy_casimir", n, steps, energy),
      report("all_invariants", n, steps, all);
  for (Record const* r : {&poisson, &energy, &all}) {
    BOOST_TEST(r->spectrum <= 1e-13);
    BOOST_TEST(r->most_casimirs <= 1e-13);
  }
  // What each form gives up is seen, and is no drift.
  BOOST_TEST(poisson.most_momentum <= 1e-13);
  BOOST_TEST(poisson.most_energy > 1e-8);
  BOOST_TEST(energy.most_energy <= 1e-13);
  BOOST_TEST(energy.most_momentum > 1e-8);
  BOOST_TEST(all.most_energy <= 1e-13);
  BOOST_TEST(all.most_momentum <= 1e-13);
  // The energy of the Lie-Poisson form oscillates: over the run a line rises by less than it swings.
  BOOST_TEST(!drifts(poisson.at, poisson.energy, poisson.most_energy));
  BOOST_TEST(!drifts(all.at, all.energy, 1e-14));
  BOOST_TEST(!drifts(all.at, all.momentum, 1e-14));
}

// All scales down to that of the grid, at the size for which the figures are claimed.
BOOST_AUTO_TEST_CASE(all_invariants_stay_together_where_all_scales_move) {
  int const n = 64, steps = 150;
  Record const r = run(n, testing::random_state(n, 1, n - 1, 12), Conserved::all_invariants, steps);
  report("all_invariants, all scales", n, steps, r);
  BOOST_TEST(r.spectrum <= 1e-13);
  BOOST_TEST(r.most_casimirs <= 1e-13);
  BOOST_TEST(r.most_energy <= 1e-13);
  BOOST_TEST(r.most_momentum <= 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
