// How large a matrix is as an operator: the methods of Lanczos and of powers against whole Krylov spaces, and
// what is made of their estimates.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/skew_matrices/operator_radius.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_matrix;

namespace {

/// The largest modulus of an eigenvalue of what -iA is on its Krylov space of some dimension, with a basis
/// that is made orthonormal as a whole.
double krylov_radius(SkewHermitian<> const& a, Eigen::VectorXcd v, Eigen::Index dimension) {
  ComplexMatrix<> const h = a.hermitian();
  ComplexMatrix<> basis(v.size(), 0);
  for (Eigen::Index k = 0; k < std::min(dimension, v.size()); ++k) {
    for (int twice = 0; twice < 2; ++twice) {
      for (Eigen::Index j = 0; j < k; ++j) v -= basis.col(j).dot(v) * basis.col(j);
      v.normalize();
    }
    basis.conservativeResize(Eigen::NoChange, k + 1);
    basis.col(k) = v, v = h * v;
  }
  ComplexMatrix<> const part = basis.adjoint() * h * basis;
  return hermitian_values(part).cwiseAbs().maxCoeff();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(operator_radius)

// Sixteen steps lose about as many digits of orthogonality as the Ritz value has gained.
BOOST_AUTO_TEST_CASE(the_method_of_lanczos_finds_the_radius_on_a_krylov_space) {
  for (int n : {1, 2, 5, 40, 90}) {
    SkewHermitian<> const a = random_matrix(n, 3);
    Eigen::VectorXcd start(n);
    for (int k = 0; k < n; ++k) start[k] = {std::cos(1.7 * k * k + k), std::sin(2.3 * k * k + 1)};
    double const found = lanczos_radius(a), all = vorticity_values(a).cwiseAbs().maxCoeff();
    BOOST_TEST(std::abs(found / krylov_radius(a, start, 16) - 1) <= 1e-9);
    BOOST_TEST(found <= (1 + 1e-13 * n) * all);
    if (n <= 16) BOOST_TEST(found >= (1 - 1e-13 * n) * all);
    // The unit is no part of the estimate.
    for (double unit : {0x1p-50, 0x1p50})
      BOOST_TEST(std::abs(lanczos_radius(unit * a) / (unit * found) - 1) <= 1e-13);
  }
  // A space that ends before sixteen steps, and one that has nothing in it.
  SkewHermitian<> signs(30);
  for (int k = 0; k < 30; ++k) signs.imaginary(k, k) = k % 3 == 0 ? -3 : 2;
  BOOST_TEST(std::abs(lanczos_radius(signs) - 3) <= 1e-13);
  BOOST_TEST(lanczos_radius(SkewHermitian<>(7)) == 0);
}

BOOST_AUTO_TEST_CASE(powers_find_the_growth_of_a_vector_in_the_eighth_multiplication) {
  for (int n : {1, 3, 20}) {
    SkewHermitian<> const a = random_matrix(n, 4);
    Eigen::VectorXcd v(n);
    for (int k = 0; k < n; ++k) v[k] = {std::cos(1.7 * k), std::sin(2.3 * k + 1)};
    double growth = 0;
    for (int k = 0; k < 8; ++k) {
      Eigen::VectorXcd const next = a.complex() * v;
      growth = next.norm() / v.norm(), v = next;
    }
    // Eight products of 2n terms.
    BOOST_TEST(std::abs(power_radius(a) / growth - 1) <= 16 * n * std::numeric_limits<double>::epsilon());
    BOOST_TEST(growth <= (1 + 1e-13 * n) * vorticity_values(a).cwiseAbs().maxCoeff());
  }
  BOOST_TEST(power_radius(SkewHermitian<>(7)) == 0);
}

BOOST_AUTO_TEST_CASE(an_estimate_is_followed_by_the_norm_for_sixteen_steps) {
  SkewHermitian<> const a = random_matrix(12, 5);
  double const size = norm(a), estimate = lanczos_radius(a), rounding = 1e-15;
  FollowedRadius none;
  BOOST_TEST(std::abs(none.bound(a) / (1.05 * estimate) - 1) <= rounding);
  BOOST_TEST(std::abs(none.ratio / (estimate / size) - 1) <= rounding);
  for (int age : {0, 1, 15}) {
    FollowedRadius known{0.25, age};
    BOOST_TEST(std::abs(known.bound(a) / (1.05 * 0.25 * size) - 1) <= rounding);
    BOOST_TEST(std::abs(known.bound(3.0 * a) / (1.05 * 0.25 * 3 * size) - 1) <= rounding);
    BOOST_TEST((known.ratio == 0.25 && known.age == age));
  }
  for (int age : {16, 40}) {
    FollowedRadius old{0.25, age};
    BOOST_TEST(std::abs(old.bound(a) / (1.05 * estimate) - 1) <= rounding);
    BOOST_TEST(old.age == 0);
  }
  // Nothing, and next to nothing, have a bound that may be divided by.
  FollowedRadius of_zero, of_little{0.25, 2};
  BOOST_TEST(of_zero.bound(SkewHermitian<>(12)) == 1e-6);
  BOOST_TEST(of_zero.ratio == 1);
  BOOST_TEST(of_little.bound((1e-9 / size) * a) == 1e-6);
}

BOOST_AUTO_TEST_CASE(distances_are_relative_and_count_each_entry_of_the_lower_half_once) {
  for (int n : {1, 2, 9}) {
    SkewHermitian<> const x = random_matrix(n, 6), y = random_matrix(n, 7);
    double apart = 0, size = 0, size_of_x = 0;
    for (int c = 0; c < n; ++c)
      for (int r = c; r < n; ++r) {
        std::complex<double> const of_x(x.real(r, c), x.imaginary(r, c)),
            of_y(y.real(r, c), y.imaginary(r, c));
        apart += std::norm(of_x - of_y), size += std::norm(of_y), size_of_x += std::norm(of_x);
      }
    double const rounding = n * n * std::numeric_limits<double>::epsilon();
    BOOST_TEST(std::abs(relative_distance(x, y) / std::sqrt(apart / size) - 1) <= rounding);
    BOOST_TEST(std::abs(relative_distance(x, SkewHermitian<>(n)) / std::sqrt(size_of_x) - 1) <= rounding);
  }
}

BOOST_AUTO_TEST_SUITE_END()
