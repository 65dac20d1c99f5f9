// Energy, angular momentum, Casimir functions: each by a second way.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_harmonics, testing::random_state;

BOOST_AUTO_TEST_SUITE(sphere_invariants)

// Sums over N terms of eigenvalues, which are good to N epsilon.
BOOST_AUTO_TEST_CASE(casimir_functions_are_sums_of_powers_of_eigenvalues) {
  for (int n : {2, 3, 16, 50}) {
    SkewHermitian<> const w = random_state(n, 0, n - 1);
    Eigen::VectorXd const values = vorticity_values(w), casimirs = vorticity_casimirs(w, 9);
    double const largest = values.cwiseAbs().maxCoeff();
    for (int k = 2; k <= 9; ++k) {
      double const truth = 4 * M_PI / n * values.array().pow(k).sum();
      BOOST_TEST(std::abs(casimirs[k - 2] - truth) <= 1e-15 * n * k * 4 * M_PI * std::pow(largest, k));
    }
    BOOST_TEST(std::abs(casimirs[0] / (2 * enstrophy(w)) - 1) <= 1e-15 * n);
    BOOST_TEST(casimirs.size() == 8);
  }
  BOOST_TEST(vorticity_casimirs(random_state(4, 1, 3), 1).size() == 0);
}

BOOST_AUTO_TEST_CASE(energy_and_enstrophy_are_sums_over_the_harmonics) {
  for (int n : {2, 5, 40}) {
    SphereHarmonics const f = random_harmonics(n, 1, n - 1);
    SkewHermitian<> const w = matrix_of(f);
    double energy = 0, square = 0;
    for (int l = 1; l < n; ++l)
      for (int m = -l; m <= l; ++m) {
        double const part = std::norm(f(l, std::abs(m)));
        energy += 0.5 * part / (l * (l + 1.0)), square += 0.5 * part;
      }
    BOOST_TEST(std::abs(vorticity_energy(SphereLaplacian(n), w) / energy - 1) <= 1e-15 * n);
    BOOST_TEST(std::abs(energy_by_degree(f).sum() / energy - 1) <= 1e-15 * n);
    BOOST_TEST(std::abs(enstrophy(w) / square - 1) <= 1e-15 * n);
  }
}

// The coordinates are sqrt(4 pi/3) Y_10 and, with i y, -sqrt(8 pi/3) Y_11: their integrals with the
// vorticity.
BOOST_AUTO_TEST_CASE(angular_momentum_is_the_part_of_degree_one) {
  for (int n : {2, 3, 40}) {
    SphereHarmonics const f = random_harmonics(n, 0, n - 1);
    Eigen::Vector3d const momentum = sphere_momentum(matrix_of(f));
    double const third = std::sqrt(4 * M_PI / 3);
    Eigen::Vector3d const truth(-std::sqrt(2.0) * third * f(1, 1).real(),
                                std::sqrt(2.0) * third * f(1, 1).imag(), third * f(1, 0).real());
    BOOST_TEST((momentum - truth).norm() <= 2e-15 * n * truth.norm());
  }
}

// A rigid rotation with the rate Omega: vorticity 2 Omega z, energy (1/2) Omega^2 of the integral of
// 1 - z^2, 8 pi/3, and 2 Omega times the integral of z^2, 4 pi/3, as its momentum.
BOOST_AUTO_TEST_CASE(a_rigid_rotation_has_the_energy_of_a_spinning_shell) {
  double const rate = 0.3;
  for (int n : {2, 3, 64}) {
    SkewHermitian<> const w = planetary_vorticity(QuantizedSphere(n), rate);
    BOOST_TEST(std::abs(vorticity_energy(SphereLaplacian(n), w) / (4 * M_PI / 3 * rate * rate) - 1) <=
               1e-15 * n);
    BOOST_TEST((sphere_momentum(w) - Eigen::Vector3d(0, 0, 8 * M_PI / 3 * rate)).norm() <=
               1e-15 * n * 8 * M_PI / 3 * rate);
    // The values of the vorticity lie in equal distances: the sphere has equal areas in equal heights.
    Eigen::VectorXd const values = vorticity_values(w);
    for (int k = 0; k < n; ++k)
      BOOST_TEST(std::abs(values[k] - 2 * rate * 2 / std::sqrt(n * n - 1.0) * (k - 0.5 * (n - 1))) <=
                 1e-15 * n);
  }
}

BOOST_AUTO_TEST_SUITE_END()
