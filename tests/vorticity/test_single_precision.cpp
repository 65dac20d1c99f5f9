// What a step finds in single precision, against complex matrices: the transform on several tiles and within
// the reach of its factors, its degree, and the finish.
//
// In a unit of its own, which is as large as a unit may be.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/isospectral_finish.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::banded, testing::random_matrix, testing::random_state;

namespace {

constexpr double single_unit = std::numeric_limits<float>::epsilon();

/// Products that take what is beyond the reach for zero, to the letter.
struct LiteralProducts : ProductsBy<LiteralProducts> {
  template <class Part>
  void whole(Part a, Part b, Part& out, Reach reach) const {
    for (Eigen::Index c = 0; c < a.rows(); ++c)
      for (Eigen::Index r = 0; r < a.rows(); ++r) {
        if (std::abs(r - c) > reach.left) a(r, c) = 0;
        if (std::abs(r - c) > reach.right) b(r, c) = 0;
      }
    out = a * b;
  }
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out, Reach reach) const {
    whole(a, b, out, reach);
    out.template triangularView<Eigen::StrictlyUpper>().setConstant(7);
  }
};

ComplexMatrix<> completed(SkewHermitian<float> const& lower) {
  SkewHermitian<> whole = lower.cast<double>();
  mirror_lower(whole);
  return whole.complex();
}
double radius_of(SkewHermitian<> const& a) { return vorticity_values(a).cwiseAbs().maxCoeff(); }

}  // namespace

BOOST_AUTO_TEST_SUITE(single_precision)

// 1/(1 + x) on [0, b], whose pole is seen under rho = (sqrt(1 + b) + 1)/(sqrt(1 + b) - 1): Chebyshev's
// interpolation of the degree d is off by less than 2 rho^(-d-1).
BOOST_AUTO_TEST_CASE(the_degree_of_the_transform_is_the_least_even_one_that_is_good_enough) {
  for (double radius : {0.003, 0.03, 0.1, 0.25, 0.5, 0.8, 0.99})
    for (double error : {2e-9, 1e-7, 1e-4}) {
      double const root = std::sqrt(1 + radius * radius), rho = (root + 1) / (root - 1);
      int const degree = SingleCayley::degree(radius, error);
      BOOST_TEST(degree % 2 == 0);
      BOOST_TEST(degree >= 2);
      BOOST_TEST(2 * std::pow(rho, -degree - 1) <= error);
      if (degree > 2) BOOST_TEST(2 * std::pow(rho, -degree + 1) > error);
      if (error == 2e-9) BOOST_TEST(degree == SingleCayley::degree(radius));
    }
  // Beyond, it is good for nothing, and bounded.
  BOOST_TEST(SingleCayley::degree(5) == 24);
}

BOOST_AUTO_TEST_CASE(the_transform_is_that_of_complex_matrices_within_the_reach_of_its_factors) {
  // Several tiles and a rest; the first is smaller than what a reach is looked for in.
  for (int n : {40, 100}) {
    SkewHermitian<> const w = random_state(n, 1, 12, 3);
    SkewHermitian<> a = SphereLaplacian(n).solve(random_state(n, 1, 4, 4));
    double const radius = radius_of(a);
    ComplexMatrix<> const one = ComplexMatrix<>::Identity(n, n);
    for (double size : {0.05, 0.5})
      for (double error : {2e-9, 1e-5}) {
        SkewHermitian<> const scaled = (size / radius) * a;
        SingleCayley cayley(std::make_shared<LiteralProducts>());
        cayley.factor(scaled, 1.02 * size, error);
        SkewHermitian<float> f, e;
        cayley.conjugate(w.cast<float>(), f, e, reach_in_single(w.cast<float>()));
        ComplexMatrix<> const inverse = (one - scaled.complex()).inverse(),
                              middle = inverse * w.complex() * inverse.adjoint(),
                              u = inverse * (one + scaled.complex()), end = u * w.complex() * u.adjoint();
        // Some ten products, each of no more than fifty terms that count; and what the polynomial is off by.
        double const bound = 10 * 50 * single_unit * size + 4 * error;
        BOOST_TEST((w.complex() + completed(f) + completed(e) - middle).norm() <= bound * norm(w));
        BOOST_TEST((w.complex() + 2 * completed(f) + 4 * completed(e) - end).norm() <= 2 * bound * norm(w));
      }
  }
}

BOOST_AUTO_TEST_CASE(the_equation_is_evaluated_with_another_rounding_of_the_same_matrix) {
  for (int n : {5, 40, 100}) {
    SkewHermitian<> const w = banded(random_matrix(n, 1), 30);
    SkewHermitian<> a = banded(random_matrix(n, 2), 3);
    a *= 0.3 / radius_of(a);
    SingleCayley cayley(std::make_shared<LiteralProducts>());
    cayley.factor(a, 0.31);
    ComplexMatrix<> const x = a.complex(), y = w.complex();
    for (double factor : {1.0, 0.6, 0.83}) {
      SkewHermitian<float> f, e;
      cayley.evaluate(a, factor, w.cast<float>(), f, e, n < 96 ? Reach::everything : 30);
      double const bound = 10 * n * single_unit * norm(w);
      BOOST_TEST((completed(f) - (x * y - y * x)).norm() <= bound * 0.3);
      BOOST_TEST((completed(e) - x * y * x).norm() <= bound * 0.09);
    }
  }
}

BOOST_AUTO_TEST_CASE(commutators_in_single_precision_are_commutators) {
  for (auto const& [n, left, right] : {std::tuple(3, 2, 2), {33, 32, 32}, {100, 4, 21}, {100, 21, 4}}) {
    SkewHermitian<> const y = banded(random_matrix(n, 1), left), x = banded(random_matrix(n, 2), right);
    SingleCayley cayley(std::make_shared<LiteralProducts>());
    SkewHermitian<float> c;
    cayley.commutator(y.cast<float>(), x.cast<float>(), c);
    BOOST_TEST((completed(c) - commutator(y, x).complex()).norm() <= 4 * n * single_unit * norm(y) * norm(x));
  }
}

BOOST_AUTO_TEST_CASE(the_residual_of_the_equation_is_the_norm_of_what_is_left) {
  for (int n : {2, 12, 33, 100}) {
    SkewHermitian<> const w = banded(random_matrix(n, 1), 25),
                          middle = w + 0.1 * banded(random_matrix(n, 3), 20);
    SkewHermitian<> const a = 0.02 * banded(random_matrix(n, 2), 5);
    IsospectralFinish<> finish(std::make_shared<LiteralProducts>());
    ComplexMatrix<> const x = a.complex(), m = middle.complex(),
                          r = w.complex() + x * m - m * x + x * m * x - m;
    // It is kept in single precision.
    BOOST_TEST(std::abs(finish.evaluate(w, a, middle) / r.norm() - 1) <= n * single_unit);
    // What is negligible may be left out: there is nothing of it here.
    BOOST_TEST(std::abs(finish.evaluate(w, a, middle, {1e-9, 1e-9}) / r.norm() - 1) <= n * single_unit);
  }
}

// Of A a ten thousand million millionth of its largest eigenvalue, of W that part of the root mean square.
BOOST_AUTO_TEST_CASE(what_is_negligible_goes_with_the_sizes_of_both) {
  Negligible const one = Negligible::beside(1, 1, 1), other = Negligible::beside(0.25, 12, 16);
  BOOST_TEST((one.of_a == 1e-16 && one.of_w == 1e-16));
  BOOST_TEST(std::abs(other.of_a / 0.25e-16 - 1) <= 1e-15);
  BOOST_TEST(std::abs(other.of_w / 3e-16 - 1) <= 1e-15);
}

BOOST_AUTO_TEST_CASE(a_reach_is_looked_for_from_96_on_and_counts_beside_the_eigenvalues) {
  for (int n : {95, 96, 97})
    for (float unit : {1e-6F, 1.0F, 1e6F}) {
      SkewHermitian<float> m = (double(unit) * banded(random_matrix(n, 4), 2)).cast<float>();
      float const root = norm(m) / std::sqrt(static_cast<float>(n));
      bool const looks = n >= 96;
      for (auto* part : {&m.real, &m.imaginary}) {
        (*part)(50, 20) = 0.9e-9F * root;
        BOOST_TEST(reach_in_single(m) == (looks ? 2 : Reach::everything));
        (*part)(50, 20) = -1.1e-9F * root;
        BOOST_TEST(reach_in_single(m) == (looks ? 30 : Reach::everything));
        BOOST_TEST(useful_reach(m.real, m.imaginary, 1.2e-9F * root) == (looks ? 2 : Reach::everything));
        (*part)(50, 20) = 0;
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
