// What a flow leaves alone and what it stirs; flows with a symmetry, and products by blocks.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/skew_matrices/bracket_blocks.hpp"
#include "actio/vorticity/canonical_splitting.hpp"
#include "actio/vorticity/vorticity_step.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_matrix, testing::random_state, testing::symmetric_state;

BOOST_AUTO_TEST_SUITE(splittings)

BOOST_AUTO_TEST_CASE(the_canonical_splitting_is_the_projection_on_the_stabiliser) {
  for (int n : {2, 3, 24}) {
    SphereLaplacian const laplacian(n);
    SkewHermitian<> const w = random_state(n, 1, n - 1), p = laplacian.solve(w);
    auto const [steady, rest] = canonical_splitting(laplacian, w);
    double const size = norm(w), bound = 1e-14 * n;
    BOOST_TEST(norm(steady + rest - w) <= bound * size);
    BOOST_TEST(norm(commutator(steady, p)) <= bound * size * norm(p));
    BOOST_TEST(std::abs(inner_product(steady, rest)) <= bound * size * size);
    // The energy is all in the first part.
    BOOST_TEST(std::abs(inner_product(p, rest)) <= bound * size * norm(p));
    // The projection of a projection; nothing that commutes with P is nearer to W.
    SkewHermitian<> const again = split_along(p, steady).rest;
    BOOST_TEST(norm(again) <= bound * size);
    if (n > 2) BOOST_TEST(norm(rest) > 0.1 * size);
    // What moves is the rest alone.
    BOOST_TEST(norm(commutator(p, w) - commutator(p, rest)) <= bound * size * norm(p));
  }
}

BOOST_AUTO_TEST_CASE(steady_flows_have_no_rest) {
  int const n = 20;
  SphereLaplacian const laplacian(n);
  // Degree 1 has a P without equal eigenvalues; that of a zonal flow of even degrees has many.
  SphereHarmonics zonal(n);
  zonal(2, 0) = 1, zonal(4, 0) = 0.4;
  SkewHermitian<> const tilted =
      Turning(QuantizedSphere(n), Eigen::Vector3d(0.6, 0.8, 0))(1.0, matrix_of(zonal));
  for (SkewHermitian<> const& w : {random_state(n, 1, 1), random_state(n, 6, 6), matrix_of(zonal), tilted})
    BOOST_TEST(norm(canonical_splitting(laplacian, w).rest) <= 1e-13 * n * norm(w));
}

// Two values of P that are 16 N epsilon of the largest apart are one, and any others two: of diagonal
// matrices the eigenvalues have no error.
BOOST_AUTO_TEST_CASE(values_of_the_stream_that_rounding_cannot_tell_apart_are_one) {
  int const n = 16;
  SkewHermitian<> const w = random_matrix(n);
  double const apart = 256 * std::numeric_limits<double>::epsilon();
  for (double largest : {1.0, -1.0, 0x1p50, -0x1p50, 0x1p-50})
    for (double part : {0.5, 1.0, 2.0}) {
      SkewHermitian<> p(n);
      for (int k = 0; k < n; ++k) p.imaginary(k, k) = (k - 8) / 32.0;
      p.imaginary(3, 3) = p.imaginary(12, 12) + part * apart;
      p.imaginary(9, 9) = 1;
      p *= largest;
      auto const [steady, rest] = split_along(p, w);
      SkewHermitian<> truth(n);
      truth.imaginary.diagonal() = w.imaginary.diagonal();
      if (part <= 1)
        for (auto const& [r, c] : {std::pair(3, 12), {12, 3}})
          truth.real(r, c) = w.real(r, c), truth.imaginary(r, c) = w.imaginary(r, c);
      BOOST_TEST(norm(steady - truth) <= 1e-14 * norm(w));
      BOOST_TEST(norm(rest - (w - truth)) <= 1e-14 * norm(w));
    }
}

BOOST_AUTO_TEST_CASE(symmetries_are_seen) {
  for (int fold : {1, 2, 3, 4, 7}) {
    SkewHermitian<> w = symmetric_state(15, fold);
    BOOST_TEST(symmetry_of(w) == fold);
    BOOST_TEST(norm(symmetric_part(w, fold) - w) == 0);
    w.real(1, 0) += 1e-12, w.real(0, 1) -= 1e-12;
    BOOST_TEST(symmetry_of(w) == 1);
    BOOST_TEST(symmetry_of(w, 1e-11) == fold);
    BOOST_TEST(symmetry_of(symmetric_part(w, fold)) == fold);
  }
  BOOST_TEST(symmetry_of(planetary_vorticity(QuantizedSphere(9), 1)) == 0);
  BOOST_TEST(symmetry_of(SkewHermitian<>(9)) == 0);
}

BOOST_AUTO_TEST_CASE(products_by_blocks_are_products) {
  for (int fold : {1, 2, 3, 5, 11})
    for (int n : {2, 10, 11}) {
      SkewHermitian<> const a = symmetric_part(random_matrix(n, 1), fold),
                            b = symmetric_part(random_matrix(n, 2), fold);
      SymmetricProducts const products(fold);
      SkewHermitian<>::Part out, lower;
      products.multiply(a.real, b.imaginary, out);
      products.multiply_lower(a.real, b.imaginary, lower);
      SkewHermitian<>::Part const truth = a.real * b.imaginary;
      BOOST_TEST((out - truth).cwiseAbs().maxCoeff() <= 1e-15 * n);
      lower -= truth;
      BOOST_TEST(lower.triangularView<Eigen::Lower>().toDenseMatrix().cwiseAbs().maxCoeff() <= 1e-15 * n);
    }
}

BOOST_AUTO_TEST_SUITE_END()
