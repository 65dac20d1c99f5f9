// One-parameter subgroups of SO(n): the end and the mean of what they transport, against the exponential
// series in more digits and the equations that determine the mean.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/fast_body/any_dimension/one_parameter_subgroup.hpp"
#include "actio/fast_body/any_dimension/skew_spectrum.hpp"

using namespace actio;
using namespace actio::bodies;
using namespace actio::bodies::detail;
using Eigen::MatrixXd;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

Wide product(Wide const& a, Wide const& b) { return a.lazyProduct(b); }
MatrixXd random_skew(std::mt19937& random, int n, double norm) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  MatrixXd a = MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) a(i, j) = uniform(random), a(j, i) = -a(i, j);
  return a * (norm / a.norm());
}
/// exp(a) - 1: the series at a/1024, and (1 + e)^2 - 1 = 2e + e^2 ten times.
Wide exponential_less_one(Wide const& a) {
  Wide const small = a / 1024;
  Wide term = small, e = small;
  for (int k = 2; k < 20; ++k) term = product(term, small) / k, e += term;
  for (int k = 0; k < 10; ++k) e = 2 * e + product(e, e);
  return e;
}
Zeros in_blocks(MatrixXd const& a) {
  Blocked<0> const shape(static_cast<int>(a.rows()));
  Zeros blocks(full_size(shape));
  for (int j = 0; j < shape.n; ++j)
    for (int i = 0; i < shape.n; ++i) blocks.data()[full_entry(shape, i, j)] = a(i, j);
  return blocks;
}
Wide matrix(Zeros const& blocks, int n) {
  Wide a(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) a(i, j) = blocks.data()[full_entry(Blocked<0>(n), i, j)];
  return a;
}
double length(Wide const& a) { return static_cast<double>(a.norm()); }

}  // namespace

BOOST_AUTO_TEST_SUITE(one_parameter_subgroup)

BOOST_AUTO_TEST_CASE(its_end_is_the_exponential_and_a_rotation_to_the_rounding_of_its_distance_from_one) {
  std::mt19937 random(1971);
  for (int n : {2, 3, 5, 6, 9})
    for (double const norm : {1e-9, 0.1, 0.5, 0.9, 3.0, 12.0}) BOOST_TEST_CONTEXT(n << ", " << norm) {
        MatrixXd const z = random_skew(random, n, norm);
        MatrixAlgebra const algebra(n);
        OneParameterSubgroup subgroup(algebra);
        Zeros e(algebra.size());
        subgroup.relative_motion(in_blocks(z).data(), e.data());
        Wide const found = matrix(e, n);
        // A few roundings of a sum of n products, which doubling magnifies as it does the angle.
        BOOST_TEST(length(found - exponential_less_one(-z.cast<long double>())) <= 4 * n * eps * norm);
        Wide const defect = found + Wide(found.transpose()) + product(found, Wide(found.transpose()));
        BOOST_TEST(length(defect) <= 2 * n * eps * length(found));
      }
}

BOOST_AUTO_TEST_CASE(its_mean_is_the_one_whose_bracket_is_what_the_transport_changes) {
  // Z m - m Z = P - e^-Z P e^Z for the mean m, and m has the components of P along what commutes with Z: its
  // odd powers span that.
  std::mt19937 random(1972);
  for (int n : {2, 3, 5, 6})
    for (double const norm : {1e-9, 0.1, 0.5, 0.9, 3.0, 12.0}) BOOST_TEST_CONTEXT(n << ", " << norm) {
        MatrixXd const z = random_skew(random, n, norm), p = random_skew(random, n, norm == 3 ? 1e-12 : 40);
        MatrixAlgebra const algebra(n);
        OneParameterSubgroup subgroup(algebra);
        Zeros mean(algebra.size());
        subgroup.mean(in_blocks(z).data(), in_blocks(p).data(), mean.data());
        Wide const m = matrix(mean, n), Z = z.cast<long double>(), P = p.cast<long double>();
        BOOST_TEST(length(m + Wide(m.transpose())) == 0);
        Wide const e = exponential_less_one(-Z);
        Wide const eP = product(e, P),
                   change = eP + product(P, Wide(e.transpose())) + product(eP, Wide(e.transpose()));
        double const room = 4 * n * eps * (1 + norm) * p.norm();
        BOOST_TEST(length(product(Z, m) - product(m, Z) + change) <= room * norm);
        Wide power = Z;
        for (int k = 1; k < n; k += 2) {
          BOOST_TEST(std::abs(static_cast<double>((m - P).cwiseProduct(power).sum())) <=
                     room * length(power));
          power = product(product(power, Z), Z);
        }
      }
}

BOOST_AUTO_TEST_CASE(the_bound_on_its_angles_is_within_a_known_factor_of_the_largest) {
  std::mt19937 random(1973);
  for (int n : {2, 3, 4, 5, 8, 13})
    for (double const norm : {1e-9, 1.0, 50.0}) {
      MatrixXd const z = random_skew(random, n, norm);
      MatrixAlgebra const algebra(n);
      OneParameterSubgroup subgroup(algebra);
      double const bound = subgroup.angle_bound(in_blocks(z).data()), largest = skew_spectrum(z).maxCoeff();
      BOOST_TEST(bound >= largest * (1 - 4 * n * eps));
      BOOST_TEST(bound <= largest * std::pow(n / 2, 0.25) * (1 + 4 * n * eps));
    }
}

BOOST_AUTO_TEST_SUITE_END()
