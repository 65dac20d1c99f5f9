// Harmonics as matrices: held to Clebsch-Gordan coefficients, to eigenvectors of the Laplacian, and to the
// coordinates.
#include <Eigen/Core>

#include <gsl/gsl_sf_coupling.h>

#include <boost/test/unit_test.hpp>

#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_harmonics;

namespace {

/// The entry (k, k + m) of \f$T_{lm}\f$ by the theorem of Wigner and Eckart: with s = (N - 1)/2 and
/// a = s - k, \f$\sqrt{(2l+1)N/4\pi}\,(-1)^k\f$ times the 3j symbol of (s, l, s; -a, m, a - m).
double by_clebsch_gordan(int n, int l, int m, int k) {
  int const twice_s = n - 1, twice_a = twice_s - 2 * k;
  double const symbol = gsl_sf_coupling_3j(twice_s, 2 * l, twice_s, -twice_a, 2 * m, twice_a - 2 * m);
  return std::sqrt((2 * l + 1) * n / (4 * M_PI)) * (k % 2 == 0 ? 1 : -1) * symbol;
}

/// The rows of \ref DiagonalBasis for all k of a diagonal: (l - m, k).
Eigen::MatrixXd whole_basis(int n, int m) {
  DiagonalBasis const basis(n, m);
  int const size = basis.size();
  Eigen::MatrixXd all(size, size);
  DiagonalBasis::Block u;
  for (int first = 0; first < size; first += DiagonalBasis::lanes) {
    basis.block(first, u);
    int const count = std::min(DiagonalBasis::lanes, size - first);
    all.middleCols(first, count) = u.leftCols(count);
  }
  return all;
}

/// The same by Eigen, up to signs: the Laplacian's matrix on the diagonal m is symmetric about its middle, so
/// that even and odd vectors are found by themselves, from tridiagonal matrices of half the size.
Eigen::MatrixXd by_half_size_problems(int n, int m) {
  int const size = n - m, half = size / 2;
  auto const diagonal = [&](double k) { return -((n - 1.0) * (2 * k + 1 + m) - 2 * k * (k + m)); };
  auto const beside = [&](double k) { return std::sqrt(k * (n - k) * (k + m) * (n - k - m)); };
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  for (int parity : {0, 1}) {
    // Of an odd size the even vectors have the middle entry for themselves.
    int const count = half + (size % 2 == 1 && parity == 0 ? 1 : 0);
    if (count == 0) continue;
    Eigen::VectorXd d(count), e(std::max(0, count - 1));
    for (int k = 0; k < count; ++k) d[k] = diagonal(k);
    for (int k = 1; k < count; ++k) e[k - 1] = beside(k);
    if (size % 2 == 0)
      d[half - 1] += (parity == 0 ? 1 : -1) * beside(half);
    else if (parity == 0 && count > 1)
      e[half - 1] *= std::sqrt(2.0);
    Eigen::MatrixXd const vectors = tridiagonal_eigensystem<Eigen::MatrixXd>(d, e).vectors;
    for (int j = 0; j < count; ++j) {
      // From the largest eigenvalue down: l - m = parity, parity + 2, ...
      Eigen::VectorXd const v = vectors.col(count - 1 - j);
      int const row = 2 * j + parity;
      for (int k = 0; k < count; ++k) {
        bool const middle = size % 2 == 1 && k == half;
        double const entry = middle ? v[k] : v[k] / std::sqrt(2.0);
        all(row, k) = entry, all(row, size - 1 - k) = parity == 0 ? entry : -entry;
      }
    }
  }
  return all;
}

/// Largest difference of the rows, each up to its sign.
double distance_up_to_signs(Eigen::MatrixXd const& a, Eigen::MatrixXd const& b) {
  double largest = 0;
  for (Eigen::Index r = 0; r < a.rows(); ++r) {
    double const sign = a.row(r).dot(b.row(r)) < 0 ? -1 : 1;
    largest = std::max(largest, (a.row(r) - sign * b.row(r)).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The matrix of one real harmonic: where m > 0 its upper part is \f$T_{lm}\f$, or \f$iT_{lm}\f$.
ComplexMatrix<> of_one(int n, int l, int m, std::complex<double> c) {
  SphereHarmonics f(n);
  f(l, m) = c;
  return matrix_of(f).hermitian();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(matrix_harmonics)

BOOST_AUTO_TEST_CASE(entries_are_clebsch_gordan_coefficients) {
  double largest = 0;
  for (int n = 2; n <= 8; ++n)
    for (int l = 0; l < n; ++l)
      for (int m = 0; m <= l; ++m) {
        ComplexMatrix<> const real = of_one(n, l, m, 1);
        ComplexMatrix<> const imaginary = of_one(n, l, m, {0, m > 0 ? 1.0 : 0.0});
        for (int k = 0; k + m < n; ++k) {
          double const truth = by_clebsch_gordan(n, l, m, k);
          largest = std::max(largest, std::abs(real(k, k + m) - truth));
          if (m > 0)
            largest = std::max(largest, std::abs(imaginary(k, k + m) - std::complex<double>(0, truth)));
        }
        // Nothing beside the diagonal and its mirror image.
        double const elsewhere = real.squaredNorm() - (m > 0 ? 2 : 1) * real.diagonal(m).squaredNorm();
        BOOST_TEST(std::abs(elsewhere) <= 1e-14);
      }
  // A few roundings of numbers of size 1, and GSL's own: sums of factorials below 16!.
  BOOST_TEST_MESSAGE("T_lm against GSL's 3j symbols, N = 2 .. 8: " << largest);
  BOOST_TEST(largest <= 2e-14);
}

// At N = 512 entries near the poles fall below 1e-300, and a recurrence in one direction loses all digits.
BOOST_AUTO_TEST_CASE(columns_are_eigenvectors_of_half_size_problems) {
  for (int n : {2, 3, 4, 9, 16, 65, 128})
    for (int m : {0, 1, n / 3, n / 2, n - 2, n - 1}) {
      if (m < 0 || m >= n) continue;
      // The eigenvectors of Eigen are good to epsilon N^2 over the distance of eigenvalues, which is 4 m + 6.
      double const bound = 4e-16 * n * n / (4 * m + 6) + 4e-16 * n;
      double const found = distance_up_to_signs(whole_basis(n, m), by_half_size_problems(n, m));
      BOOST_TEST(found <= bound, "N = " << n << ", m = " << m << ": " << found << " > " << bound);
    }
  for (int m : {3, 200}) {
    int const n = 512;
    double const found = distance_up_to_signs(whole_basis(n, m), by_half_size_problems(n, m));
    BOOST_TEST_MESSAGE("N = 512, the diagonal " << m << " against the half-size eigenproblem: " << found);
    BOOST_TEST(found <= 4e-16 * n * n / (4 * m + 6) + 4e-16 * n);
  }
}

BOOST_AUTO_TEST_CASE(columns_are_orthonormal_at_large_sizes) {
  for (int n : {512, 1024})
    for (int m : {0, 17, n / 2, n - 3}) {
      Eigen::MatrixXd const u = whole_basis(n, m);
      Eigen::MatrixXd gram = u * u.transpose();
      gram.diagonal().array() -= 1;
      BOOST_TEST_MESSAGE("N = " << n << ", m = " << m << ": columns orthonormal up to "
                                << gram.cwiseAbs().maxCoeff());
      BOOST_TEST(gram.cwiseAbs().maxCoeff() <= 1e-15 * n);
    }
}

// At N = 4096 the recurrences leave the range of numbers from either end; a block alone shows what becomes of
// them there.
BOOST_AUTO_TEST_CASE(a_block_of_a_size_at_which_both_recurrences_overflow_is_orthonormal) {
  int const n = 4096;
  for (int m : {0, n / 64, n / 8}) {
    DiagonalBasis::Block u;
    DiagonalBasis(n, m).block(0, u);
    Eigen::MatrixXd gram = u.transpose() * u;
    gram.diagonal().array() -= 1;
    BOOST_TEST(gram.cwiseAbs().maxCoeff() <= 1e-15 * n);
  }
}

// Sums over N harmonics and N entries of size 1.
BOOST_AUTO_TEST_CASE(coefficients_come_back) {
  for (int n : {2, 3, 31, 32, 64, 65, 100}) {
    SphereHarmonics const f = random_harmonics(n, 0, n - 1);
    SkewHermitian<> const w = matrix_of(f);
    SphereHarmonics const back = harmonics_of(w);
    BOOST_TEST((back.coefficient - f.coefficient).cwiseAbs().maxCoeff() <= 1e-15 * n);
    SkewHermitian<> const any = testing::random_matrix(n);
    BOOST_TEST(norm(matrix_of(harmonics_of(any)) - any) <= 1e-15 * n * norm(any));
    // Parseval: the integral of the square.
    double integral = 0;
    for (int l = 0; l < n; ++l) integral += f.power(l);
    BOOST_TEST(std::abs(2 * enstrophy(w) / integral - 1) <= 1e-15 * n);
  }
}

BOOST_AUTO_TEST_CASE(one_is_the_identity_and_degree_one_are_the_coordinates) {
  for (int n : {2, 3, 20}) {
    QuantizedSphere const sphere(n);
    auto const distance = [](ComplexMatrix<> const& a, ComplexMatrix<> const& b) {
      return (a - b).cwiseAbs().maxCoeff();
    };
    double const third = std::sqrt(4 * M_PI / 3);
    BOOST_TEST(distance(of_one(n, 0, 0, std::sqrt(4 * M_PI)), ComplexMatrix<>::Identity(n, n)) <= 1e-15);
    // z = sqrt(4 pi/3) Y_10, and x + iy = -sqrt(8 pi/3) Y_11.
    BOOST_TEST(distance(of_one(n, 1, 0, third), sphere.hbar() * sphere.spin(2)) <= 2e-15);
    BOOST_TEST(distance(of_one(n, 1, 1, -third / std::sqrt(2.0)), sphere.hbar() * sphere.spin(0)) <= 2e-15);
    BOOST_TEST(distance(of_one(n, 1, 1, {0, third / std::sqrt(2.0)}), sphere.hbar() * sphere.spin(1)) <=
               2e-15);
  }
}

// x^2 - y^2 is sqrt(32 pi/15) Re Y_22: products of coordinates, with the factor of degree 2 that quantising
// has, (1 - 4/N^2)^(1/2) (1 - 1/N^2)^(-1/2).
BOOST_AUTO_TEST_CASE(degree_two_are_products_of_coordinates) {
  for (int n : {3, 4, 32}) {
    QuantizedSphere const sphere(n);
    ComplexMatrix<> const x = sphere.hbar() * sphere.spin(0), y = sphere.hbar() * sphere.spin(1);
    double const factor = std::sqrt((n * n - 4.0) / (n * n - 1.0));
    ComplexMatrix<> const square = x * x - y * y, harmonic = of_one(n, 2, 2, std::sqrt(32 * M_PI / 15) / 2);
    BOOST_TEST((square - factor * harmonic).cwiseAbs().maxCoeff() <= 1e-14);
  }
}

BOOST_AUTO_TEST_SUITE_END()
