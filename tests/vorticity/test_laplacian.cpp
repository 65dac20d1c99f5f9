// The Laplacian of the quantised sphere, held to double commutators and to its eigenvalues; its inverse.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_matrix, testing::random_state;

namespace {

/// \f$-\sum_j[S_j,[S_j,W]]\f$ with whole matrices.
SkewHermitian<> double_commutators(QuantizedSphere const& sphere, SkewHermitian<> const& w) {
  SkewHermitian<> sum(w.size());
  for (int axis = 0; axis < 3; ++axis) {
    SkewHermitian<> const s(ComplexMatrix<>(std::complex<double>(0, 1) * sphere.spin(axis)));
    sum += commutator(s, commutator(s, w));
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(laplacian)

BOOST_AUTO_TEST_CASE(it_is_the_sum_of_double_commutators) {
  for (int n : {2, 3, 4, 5, 16, 40}) {
    SphereLaplacian const laplacian(n);
    SkewHermitian<> const w = random_matrix(n);
    SkewHermitian<> const truth = double_commutators(QuantizedSphere(n), w);
    // Each of the sums has terms of N^2/2 |W|.
    double const bound = 1e-15 * n * n * norm(w);
    BOOST_TEST(norm(laplacian.apply(w) - truth) <= bound);
    BOOST_TEST(norm(truth) > 1e6 * bound);
    BOOST_TEST(norm(laplacian.apply(w) + truth) > 1e6 * bound);
  }
}

BOOST_AUTO_TEST_CASE(its_eigenvalues_are_those_of_the_sphere) {
  for (int n : {2, 3, 8, 48}) {
    SphereLaplacian const laplacian(n);
    for (int l = 0; l < n; l = l < 4 ? l + 1 : 2 * l) {
      SkewHermitian<> const w = random_state(n, l, l);
      // Entries of Delta are up to N^2/2, whatever the degree.
      BOOST_TEST(norm(laplacian.apply(w) + l * (l + 1.0) * w) <= 1e-15 * n * n * norm(w));
      BOOST_TEST(norm(laplacian.apply(w) + (l + 1.0) * (l + 1.0) * w) > 0.9 * norm(w));
      if (l > 0) BOOST_TEST(norm(laplacian.solve(w) + (1 / (l * (l + 1.0))) * w) <= 1e-16 * n * n * norm(w));
    }
  }
}

// The numbers of the diagonal m are Delta's matrix between the m + 1 .. N - 1: its eigenvalues by Eigen.
BOOST_AUTO_TEST_CASE(each_diagonal_has_the_degrees_from_its_number_on) {
  int const n = 40;
  SphereLaplacian const laplacian(n);
  for (int m : {0, 1, 7, 38, 39}) {
    int const size = n - m;
    Eigen::MatrixXd a(size, size);
    for (int k = 0; k < size; ++k) {
      SkewHermitian<> w(n);
      w.imaginary(k, k + m) = w.imaginary(k + m, k) = 1;
      SkewHermitian<> const image = laplacian.apply(w);
      for (int r = 0; r < size; ++r) a(r, k) = image.imaginary(r + m, r);
      BOOST_TEST(std::abs(norm(image) - std::sqrt(m == 0 ? 1 : 2) * a.col(k).norm()) <= 1e-12 * n * n);
    }
    Eigen::VectorXd const values = hermitian_values(a);
    for (int l = m; l < n; ++l) BOOST_TEST(std::abs(values[n - 1 - l] + l * (l + 1.0)) <= 1e-14 * n * n);
  }
}

BOOST_AUTO_TEST_CASE(it_is_inverted_on_the_matrices_without_trace) {
  for (int n : {2, 3, 16, 33, 200}) {
    SphereLaplacian const laplacian(n);
    SkewHermitian<> w = random_matrix(n);
    SkewHermitian<> const p = laplacian.solve(w);
    double const trace = w.imaginary.trace() / n;
    BOOST_TEST(std::abs(trace) > 1e-3);
    for (int k = 0; k < n; ++k) w.imaginary(k, k) -= trace;
    // What rounding does to p, N * 1e-16 of it, Delta takes by up to N^2.
    double const bound = 1e-16 * n * n * n * norm(p);
    BOOST_TEST(norm(laplacian.apply(p) - w) <= bound);
    BOOST_TEST(std::abs(p.imaginary.trace()) <= 1e-15 * n * norm(p));
    BOOST_TEST((p.real + p.real.transpose()).norm() == 0);
    SkewHermitian<> const back = laplacian.solve(laplacian.apply(p));
    BOOST_TEST(norm(back - p) <= 1e-15 * n * norm(p));
  }
}

// Where the vorticity is all of degree 1 or 2 the answer is known: no digit may be lost at large N.
BOOST_AUTO_TEST_CASE(large_scales_keep_their_digits_at_large_sizes) {
  for (int n : {64, 256, 1024}) {
    QuantizedSphere const sphere(n);
    SphereLaplacian const laplacian(n);
    SkewHermitian<> const rotation = planetary_vorticity(sphere, 1);
    SkewHermitian<> const p = laplacian.solve(rotation);
    BOOST_TEST_MESSAGE("N = " << n << ": relative error of the stream function of a rotation "
                              << norm(p + 0.5 * rotation) / norm(p));
    BOOST_TEST(norm(p + 0.5 * rotation) <= 1e-15 * n * norm(p));
  }
}

BOOST_AUTO_TEST_CASE(it_commutes_with_rotations) {
  int const n = 24;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const w = random_state(n, 1, n - 1);
  Turning const turning(sphere, Eigen::Vector3d(1, -2, 0.5).normalized());
  SkewHermitian<> const one = turning(1.1, laplacian.solve(w)), other = laplacian.solve(turning(1.1, w));
  BOOST_TEST(norm(one - other) <= 1e-15 * n * norm(one));
  // And not with any unitary matrix: of the spin matrices' own algebra alone.
  SkewHermitian<> p = laplacian.solve(w), turned = w;
  auto const swap = [](SkewHermitian<>& x) {
    for (auto* part : {&x.real, &x.imaginary}) {
      part->row(0).swap(part->row(1));
      part->col(0).swap(part->col(1));
    }
  };
  swap(p), swap(turned);
  BOOST_TEST(norm(laplacian.solve(turned) - p) > 1e-3 * norm(p));
}

BOOST_AUTO_TEST_SUITE_END()
