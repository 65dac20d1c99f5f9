// Matrices as functions: the symbol of Berezin is a mean, and stays within the spectrum.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/sphere_fields/sphere_transform.hpp"
#include "actio/sphere_fields/symbols.hpp"
#include "actio/vorticity/vorticity_step.hpp"

using namespace actio;
using namespace actio::sphere;

namespace {

/// The coherent state at a place: the eigenvector of x.S of the greatest eigenvalue.
Eigen::VectorXcd coherent_state(int n, double colatitude, double longitude) {
  Eigen::VectorXcd state(n);
  double choose = 1;  // n - 1 over k
  for (int k = 0; k < n; ++k) {
    double const size = std::sqrt(choose) * std::pow(std::cos(colatitude / 2), n - 1 - k) *
                        std::pow(std::sin(colatitude / 2), k);
    state[k] = std::polar(size, k * longitude);
    choose *= (n - 1.0 - k) / (k + 1);
  }
  return state;
}
/// A vorticity: i times a Hermitian matrix.
SkewHermitian<> of_hermitian(ComplexMatrix<> const& a) {
  return SkewHermitian<>(ComplexMatrix<>(std::complex<double>(0, 1) * a));
}
SkewHermitian<> random_vorticity(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  ComplexMatrix<> a(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) a(i, j) = {normal(random), normal(random)};
  return of_hermitian(ComplexMatrix<>((a + a.adjoint()) / 2));
}
Eigen::VectorXd spectrum(SkewHermitian<> const& w) { return hermitian_values(w.hermitian()); }
/// By how much a field leaves the interval of the eigenvalues, in parts of its length.
double outside(GridField const& field, SkewHermitian<> const& w) {
  Eigen::VectorXd const values = spectrum(w);
  double const least = values.minCoeff(), most = values.maxCoeff();
  return std::max({0.0, least - field.minCoeff(), field.maxCoeff() - most}) / (most - least);
}

}  // namespace

// This holds matrices, their harmonics, the phases of both and the grid to one another.
BOOST_AUTO_TEST_CASE(the_symbol_of_berezin_is_the_mean_in_a_coherent_state) {
  for (int const n : {2, 3, 8, 21}) {
    SkewHermitian<> const w = random_vorticity(n, 3);
    SphereGrid const grid = SphereGrid::uniform(7, 9);
    GridField const field = values_on(grid, symbol_of(w, Symbol::berezin));
    for (int j = 0; j < 7; ++j)
      for (int k = 0; k < 9; ++k) {
        Eigen::VectorXcd const state = coherent_state(n, grid.colatitude[j], grid.longitude(k));
        double const mean = state.dot(w.hermitian() * state).real();
        BOOST_TEST(std::abs(field(j, k) - mean) <= 1e-13 * n);
      }
  }
}

BOOST_AUTO_TEST_CASE(the_field_of_berezin_never_leaves_the_spectrum_and_that_of_weyl_does) {
  int const n = 24;
  SphereGrid const grid = SphereGrid::gauss(n, 2 * n);
  SphereLaplacian const laplacian(n);
  // A vortex as small as it can be, with the spectrum {0, 1}; a random state; and each after steps of the
  // flow, which keep the spectrum and make the field finer.
  Eigen::VectorXcd const state = coherent_state(n, 0.8, 2.1);
  for (SkewHermitian<> w : {of_hermitian(state * state.adjoint()), random_vorticity(n, 5)}) {
    VorticityStep<> step(laplacian, Conserved::energy_casimir, 0.02);
    for (int output = 0; output < 4; ++output) {
      // Rounding of sums of n^2 terms.
      BOOST_TEST(outside(values_on(grid, symbol_of(w, Symbol::berezin)), w) <= 1e-13);
      BOOST_TEST(outside(values_on(grid, symbol_of(w, Symbol::weyl)), w) > 0.01);
      for (int k = 0; k < 5; ++k) step.advance(w);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_factors_of_berezin) {
  // l = 1: sqrt((N - 1)/(N + 1)), by which the coherent mean of S_3 hbar is less than 1.
  for (int const n : {2, 5, 1024}) {
    Eigen::ArrayXd const b = symbol_factors(n, Symbol::berezin);
    BOOST_TEST(b[0] == 1);
    BOOST_TEST(std::abs(b[1] - 0.5 * (n - 1) * QuantizedSphere(n).hbar()) <= 4e-16);
    for (int l = 1; l < n; ++l) BOOST_TEST(b[l] < b[l - 1]);
    BOOST_TEST((symbol_factors(n, Symbol::weyl) == 1).all());
  }
}
