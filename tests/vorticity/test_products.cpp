// Products of real matrices: that the backend can be exchanged, and that threads change nothing.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/skew_matrices/blas_products.hpp"
#include "actio/skew_matrices/products.hpp"
#include "loops_blas.hpp"

using namespace actio;
using namespace actio::sphere;
using actio::testing::by_loops;

namespace {

SkewHermitian<> random_matrix(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  ComplexMatrix<> a(n, n);
  for (auto& x : a.reshaped()) {
    double const real = normal(random);
    x = {real, normal(random)};
  }
  return SkewHermitian<>(a);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_second_backend_gives_the_products_of_complex_matrices) {
  // Around the width of a panel, and where the last one is narrower.
  for (int n : {3, 31, 33, 70, 131}) {
    SkewHermitian<> const a = random_matrix(n, 1), w = random_matrix(n, 2);
    SkewProducts<double> other(std::make_shared<BlasProducts>(by_loops));
    SkewProducts<double> by_eigen;
    SkewHermitian<> c, e, c2, e2;
    other.multiply(a, w, c), other.multiply_again(a, e);
    by_eigen.multiply(a, w, c2), by_eigen.multiply_again(a, e2);
    // Sums of n products, three of them added: 10 n roundings of |A||W|, |A|^2|W|.
    double const rounding = 10 * n * std::numeric_limits<double>::epsilon();
    BOOST_TEST(norm(c - c2) <= rounding * norm(a) * norm(w));
    BOOST_TEST(norm(e - e2) <= rounding * norm(a) * norm(a) * norm(w));
    ComplexMatrix<> const b = a.complex() * w.complex();
    BOOST_TEST((c.complex() - (b - b.adjoint())).norm() <= rounding * norm(a) * norm(w));
    BOOST_TEST((e.complex() - b * a.complex()).norm() <= rounding * norm(a) * norm(a) * norm(w));
  }
}

BOOST_AUTO_TEST_CASE(products_are_equal_bit_for_bit_for_any_number_of_threads) {
  for (int n : {64, 128, 150}) {
    SkewHermitian<> const a = random_matrix(n, 3), w = random_matrix(n, 4);
    Eigen::MatrixXd one(n, n), many(n, n);
    BlasProducts const alone(by_loops);
    for (int threads : {2, 3, 7}) {
      BlasProducts const shared(by_loops, threads);
      // Often, so that a lost wake-up or a panel done twice shows.
      for (int k = 0; k < 5; ++k) {
        many.setConstant(1e300);
        alone.multiply(a.real, w.imaginary, one), shared.multiply(a.real, w.imaginary, many);
        BOOST_TEST((one.array() == many.array()).all());
        many.setConstant(1e300);
        alone.multiply_lower(a.real, w.imaginary, one), shared.multiply_lower(a.real, w.imaginary, many);
        bool same = true;
        for (int c = 0; c < n; ++c) same = same && one.col(c).tail(n - c) == many.col(c).tail(n - c);
        BOOST_TEST(same);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(half_of_a_product_costs_nine_sixteenths_of_it) {
  static double flops = 0;
  BlasFunctions const counting{[](char const*, char const*, int const* m, int const* n, int const* k,
                                  double const*, double const*, int const*, double const*, int const*,
                                  double const*, double*, int const*) { flops += 2.0 * *m * *n * *k; },
                               nullptr};
  for (int n : {256, 512, 1024}) {
    Eigen::MatrixXd a(n, n), b(n, n), c(n, n);
    flops = 0;
    BlasProducts(counting).multiply_lower(a, b, c);
    BOOST_TEST(flops == 2.0 * n * n * n * 9 / 16);
  }
}
