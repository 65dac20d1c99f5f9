#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/fast_body/any_dimension/matrix_algebra.hpp"
#include "actio/fast_body/any_dimension/skew_spectrum.hpp"
#include "actio/linear_algebra/eigenvalues.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

MatrixXd random_skew(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  MatrixXd a = MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) a(i, j) = uniform(random), a(j, i) = -a(i, j);
  return a;
}
/// The moduli from the symmetric matrix [0, A; -A, 0], which has each of them twice with each sign, by GSL.
VectorXd by_gsl(MatrixXd const& a) {
  Eigen::Index const n = a.rows();
  MatrixXd twice = MatrixXd::Zero(2 * n, 2 * n);
  twice.topRightCorner(n, n) = a, twice.bottomLeftCorner(n, n) = -a;
  return symmetric_eigen(twice).values.tail(n);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(spectrum_of_skew_matrices)

BOOST_AUTO_TEST_CASE(is_that_of_a_symmetric_matrix_of_twice_the_size) {
  std::mt19937 random(1971);
  for (int n : {1, 2, 3, 4, 5, 8, 9, 33, 60})
    for (double size : {1.0, 1e-47, 1e8, 1e-300, 1e300}) {
      BOOST_TEST_CONTEXT("n = " << n << ", size " << size) {
        MatrixXd const a = random_skew(random, n);
        VectorXd const moduli = skew_spectrum(a * size) / size, witness = by_gsl(a);
        BOOST_TEST((moduli - witness).norm() <= 8 * n * eps * a.norm());
        BOOST_TEST(std::is_sorted(moduli.begin(), moduli.end()));
        for (int k = n - 1; k > 0; k -= 2) BOOST_TEST(moduli[k] == moduli[k - 1]);
        if (n % 2) BOOST_TEST(moduli[0] == 0);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_matrix_that_is_nearly_tridiagonal_loses_nothing_to_cancellation) {
  std::mt19937 random(1973);
  for (double const beside : {1e-3, 1e-6, 1e-9})
    for (double const sign : {1.0, -1.0}) BOOST_TEST_CONTEXT(beside << ", " << sign) {
        MatrixXd a = beside * random_skew(random, 9);
        for (int i = 0; i + 1 < 9; ++i) a(i + 1, i) += sign * (1 + i), a(i, i + 1) = -a(i + 1, i);
        BOOST_TEST((skew_spectrum(a) - by_gsl(a)).norm() <= 8 * 9 * eps * a.norm());
      }
}

BOOST_AUTO_TEST_CASE(planes_that_rest_have_modulus_zero) {
  std::mt19937 random(1972);
  // Turned at random, two planes of seven turn: 3 and 2 times, in a space of which the rest is still.
  MatrixXd a = MatrixXd::Zero(14, 14);
  a(0, 1) = 3, a(1, 0) = -3, a(2, 3) = 2, a(3, 2) = -2;
  MatrixXd const x = random_skew(random, 14),
                 g = (MatrixXd::Identity(14, 14) - x).inverse() * (MatrixXd::Identity(14, 14) + x);
  VectorXd const moduli = skew_spectrum(g * a * g.transpose());
  BOOST_TEST((moduli.head(10).array() == 0).all());
  BOOST_TEST(std::abs(moduli[10] - 2) <= 14 * eps * 3);
  BOOST_TEST(std::abs(moduli[13] - 3) <= 14 * eps * 3);
  BOOST_TEST((skew_spectrum(MatrixXd::Zero(6, 6)).array() == 0).all());
}

BOOST_AUTO_TEST_CASE(what_is_no_skew_matrix_of_numbers_is_refused) {
  MatrixXd a = MatrixXd::Zero(3, 3);
  a(1, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_REFUSED(skew_spectrum(a), NotFinite);
  CHECK_REFUSED(skew_spectrum(MatrixXd::Zero(3, 2)), OutsideDomain);
  CHECK_REFUSED(skew_spectrum(MatrixXd()), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(matrix_algebra)

BOOST_AUTO_TEST_CASE(a_norm_counts_the_entries_of_its_matrix_and_nothing_behind_it) {
  for (int n : {2, 4, 5, 9}) {
    bodies::detail::MatrixAlgebra const algebra(n);
    std::vector<double> room(algebra.size() + 8, 0.0);
    room[bodies::detail::full_entry(algebra.shape(), 0, 1)] = 3, room[bodies::detail::full_entry(
                                                                     algebra.shape(), 1, 0)] = -4;
    for (std::size_t k = algebra.size(); k < room.size(); ++k) room[k] = 7;
    BOOST_TEST(algebra.norm(room.data()) == 5.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
