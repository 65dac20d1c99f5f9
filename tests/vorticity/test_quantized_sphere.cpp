// The quantised sphere: spin matrices, commutators with them, and matrices in two parts.
#include <boost/test/unit_test.hpp>

#include "actio/skew_matrices/products.hpp"
#include "flows.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_matrix;

namespace {

std::complex<double> const i(0, 1);

/// Largest entry.
double size_of(ComplexMatrix<> const& a) { return a.cwiseAbs().maxCoeff(); }
double size_of(SkewHermitian<> const& a) { return size_of(a.complex()); }

}  // namespace

BOOST_AUTO_TEST_SUITE(quantized_sphere)

// Entries of products are sums of two terms up to N^2/4, each within a few epsilon.
BOOST_AUTO_TEST_CASE(the_spin_matrices_turn_one_another_and_their_squares_add_up_to_one) {
  for (int n : {2, 3, 4, 17, 64}) {
    QuantizedSphere const sphere(n);
    double const bound = 4e-16 * n * n;
    ComplexMatrix<> squares = ComplexMatrix<>::Zero(n, n);
    for (int j = 0; j < 3; ++j) {
      ComplexMatrix<> const a = sphere.spin(j), b = sphere.spin((j + 1) % 3), c = sphere.spin((j + 2) % 3);
      BOOST_TEST(size_of(ComplexMatrix<>(a * b - b * a - i * c)) <= bound);
      // The other order of the three is another algebra.
      BOOST_TEST(size_of(ComplexMatrix<>(a * b - b * a + i * c)) > 0.9);
      BOOST_TEST(size_of(ComplexMatrix<>(a - a.adjoint())) == 0);
      BOOST_TEST(std::abs(a.trace()) == 0);
      squares += sphere.hbar() * sphere.hbar() * a * a;
    }
    BOOST_TEST(size_of(ComplexMatrix<>(squares - ComplexMatrix<>::Identity(n, n))) <= 2e-15);
    // The area of the sphere, and the integral of the square of a coordinate.
    BOOST_TEST(std::abs(sphere.area_element() * n / (4 * M_PI) - 1) <= 4e-16);
    double const square = sphere.area_element() * std::pow(sphere.hbar(), 2) * sphere.spin(2).squaredNorm();
    BOOST_TEST(std::abs(square / (4 * M_PI / 3) - 1) <= 1e-15 * n);
  }
}

BOOST_AUTO_TEST_CASE(fewer_than_two_points_are_refused) {
  for (int n : {1, 0, -3}) {
    CHECK_REFUSED(QuantizedSphere{n}, OutsideDomain);
    CHECK_REFUSED(SphereLaplacian{n}, OutsideDomain);
  }
}

BOOST_AUTO_TEST_CASE(commutators_with_spin_matrices_are_those_of_whole_matrices) {
  for (int n : {2, 3, 8, 33}) {
    QuantizedSphere const sphere(n);
    SkewHermitian<> const w = random_matrix(n);
    for (int axis = 0; axis < 3; ++axis) {
      SkewHermitian<> const s(ComplexMatrix<>(i * sphere.spin(axis)));
      // Four terms of size N/2 against a whole row of a product that is zeros else.
      BOOST_TEST(size_of(spin_commutator(sphere, axis, w) - commutator(s, w)) <= 4e-15 * n);
      BOOST_TEST(size_of(spin_commutator(sphere, axis, w) + commutator(s, w)) > 0.1);
      double const trace = (sphere.spin(axis) * w.hermitian()).trace().real();
      BOOST_TEST(std::abs(spin_component(sphere, axis, w) - trace) <= 4e-16 * n * n);
      BOOST_TEST(std::abs(inner_product(s, w) - trace) <= 4e-16 * n * n);
    }
  }
}

BOOST_AUTO_TEST_CASE(matrices_in_two_parts_are_complex_matrices) {
  for (int n : {1, 2, 31, 32, 33, 70}) {
    SkewHermitian<> const x = random_matrix(n, 1), y = random_matrix(n, 2);
    ComplexMatrix<> const a = x.complex(), b = y.complex();
    BOOST_TEST(size_of(ComplexMatrix<>(a + a.adjoint())) == 0);
    BOOST_TEST(size_of(ComplexMatrix<>(a - i * x.hermitian())) == 0);
    BOOST_TEST(size_of(ComplexMatrix<>(commutator(x, y).complex() - (a * b - b * a))) <= 4e-15 * n);
    BOOST_TEST(std::abs(inner_product(x, y) + (a * b).trace().real()) <= 1e-15 * n * n);
    BOOST_TEST(std::abs(norm(x) / a.norm() - 1) <= 1e-14);
    // What is above the diagonal follows from what is below, wherever a tile ends.
    SkewHermitian<> half = x;
    for (int c = 0; c < n; ++c)
      for (int r = 0; r < c; ++r) half.real(r, c) = half.imaginary(r, c) = 7;
    mirror_lower(half);
    BOOST_TEST(size_of(half - x) == 0);
  }
}

BOOST_AUTO_TEST_CASE(products_of_two_parts_are_those_of_complex_matrices) {
  for (int n : {1, 2, 5, 33}) {
    SkewHermitian<> const a = random_matrix(n, 1), w = random_matrix(n, 2);
    SkewProducts<double> products;
    SkewHermitian<> c(n), e(n);
    products.multiply(a, w, c);
    products.multiply_again(a, e);
    // Three sums of n terms of size one.
    BOOST_TEST(size_of(c - commutator(a, w)) <= 2e-14 * n);
    ComplexMatrix<> const whole = a.complex() * w.complex() * a.complex();
    BOOST_TEST(size_of(ComplexMatrix<>(e.complex() - whole)) <= 1e-13 * n);
    BOOST_TEST(size_of(ComplexMatrix<>(e.complex() + e.complex().adjoint())) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
