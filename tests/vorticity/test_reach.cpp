// What is far from the diagonals of smooth flows is not multiplied, and nothing changes by that.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/skew_matrices/bracket_blocks.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "flows.hpp"
#include "loops_blas.hpp"

using namespace actio;
using namespace actio::sphere;
using namespace actio::testing;

namespace {

/// Products that leave nothing out.
struct WholeProducts : ProductsBy<WholeProducts> {
  BlasProducts products{by_counting_loops};
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out) const { products.whole(a, b, out); }
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out) const { products.lower(a, b, out); }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_reach_is_that_of_the_farthest_entry_that_counts) {
  int const n = 23;
  for (int far : {0, 1, 7, n - 1}) {
    SkewHermitian<> w = banded(random_matrix(n), far);
    BOOST_TEST(reach_of(w, 0.0) == far);
    // One entry decides, wherever it is, in either part; one as large as what is negligible does not count.
    for (int c : {0, 5, n - far - 1})
      for (auto* part : {&w.real, &w.imaginary}) {
        w = SkewHermitian<>(n);
        (*part)(std::min(c + far, n - 1), std::min(c + far, n - 1) - far) = -0.5;
        BOOST_TEST(reach_of(w, 0.49) == far);
        BOOST_TEST(reach_of(w, 0.5) == 0);
      }
  }
}

BOOST_AUTO_TEST_CASE(products_within_the_reach_are_the_whole_ones) {
  for (int n : {60, 131, 150})
    for (auto const& [left, right] :
         {std::pair{3, 11}, std::pair{11, 3}, std::pair{0, 40}, std::pair{n, 5}}) {
      SkewHermitian<> const a = banded(random_matrix(n, 1), left), b = banded(random_matrix(n, 2), right);
      for (int threads : {1, 3})
        for (int fold : {1, 3}) {
          Products products = std::make_shared<BlasProducts>(by_loops, threads);
          SkewHermitian<> x = a, y = b;
          if (fold > 1)
            products = std::make_shared<SymmetricProducts>(fold, products), x = symmetric_part(a, fold),
            y = symmetric_part(b, fold);
          Eigen::MatrixXd whole(n, n), within(n, n);
          products->multiply(x.real, y.imaginary, whole);
          within.setConstant(1e300);
          products->multiply(x.real, y.imaginary, within, {left, right});
          // Sums of the same terms in the same order, and of zeros.
          BOOST_TEST((whole.array() == within.array()).all());
          within.setConstant(1e300);
          products->multiply_lower(x.real, y.imaginary, within, {left, right});
          bool same = true;
          for (int c = 0; c < n; ++c) same = same && whole.col(c).tail(n - c) == within.col(c).tail(n - c);
          BOOST_TEST(same);
        }
    }
}

BOOST_AUTO_TEST_CASE(both_products_of_a_step_reach_as_far_as_their_factors_together) {
  int const n = 150;
  for (auto const& [left, right] : {std::pair{9, 14}, std::pair{14, 9}}) {
    SkewHermitian<> const a = banded(random_matrix(n, 1), left), w = banded(random_matrix(n, 2), right);
    Products const products = std::make_shared<BlasProducts>(by_loops);
    SkewProducts<double> of_all(products), within(products);
    SkewHermitian<> c, e, c2, e2;
    of_all.multiply(a, w, c), of_all.multiply_again(a, e);
    within.multiply(a, w, c2, {left, right}), within.multiply_again(a, e2);
    BOOST_TEST(norm(c - c2) == 0);
    BOOST_TEST(norm(e - e2) == 0);
    BOOST_TEST(reach_of(e, 0.0) == 2 * left + right);
  }
}

BOOST_AUTO_TEST_CASE(a_product_of_a_few_diagonals_is_cheap) {
  int const n = 512, left = 20, right = 30;
  Eigen::MatrixXd const a = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd out(n, n);
  multiplications = 0;
  BlasProducts(by_counting_loops).multiply(a, a, out, {left, right});
  // Of each panel what is within reach of it on both sides.
  double const width = BlasProducts::panel(n), inner = width + 2 * right, outer = inner + 2 * left;
  BOOST_TEST(multiplications <= n * inner * outer);
  BOOST_TEST(multiplications >= 0.8 * n * inner * outer);
}

BOOST_AUTO_TEST_CASE(a_step_of_a_smooth_flow_leaves_out_nothing_but_rounding) {
  int const n = 160, steps = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, 5);
  TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
  double const h =
      0.1 * 2 * QuantizedSphere(n).hbar() / FastVorticityStep<>::spectral_radius(laplacian.solve(start));
  for (auto const conserved : {Conserved::lie_poisson, Conserved::all_invariants}) {
    SkewHermitian<> w = start, whole = start;
    FastVorticityStep<> within(laplacian, conserved, h, calm,
                               std::make_shared<BlasProducts>(by_counting_loops)),
        all(laplacian, conserved, h, calm, std::make_shared<WholeProducts>());
    double made = 0, of_all = 0;
    for (int k = 0; k < steps; ++k) {
      multiplications = 0;
      within.advance(w), made = multiplications;
      all.advance(whole), of_all = multiplications - made;
    }
    BOOST_TEST_MESSAGE("share of a step's products that is made: " << made / of_all);
    BOOST_TEST(made < 0.6 * of_all);
    // Two roundings of each entry in each step, and the roundings of A, that is a tenth as large.
    BOOST_TEST(norm(w - whole) <= 4 * steps * std::numeric_limits<double>::epsilon() * norm(start));
    BOOST_TEST(norm(w - whole) > 0);
    BOOST_TEST((sphere_momentum(w) - sphere_momentum(start)).norm() <= 1e-14 * sphere_momentum(start).norm());
    BOOST_TEST(std::abs(vorticity_casimirs(w, 2)[0] / vorticity_casimirs(start, 2)[0] - 1) <= 1e-14);
  }
}
