// Functions of matrices against closed forms, and where they are refused the figure that was measured.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/linear_algebra/eigenvalues.hpp"
#include "actio/linear_algebra/matrix_logarithm.hpp"
#include "actio/linear_algebra/schur_form.hpp"
#include "actio/numbers/gauss_quadrature.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

double const eps = epsilon<double>();
using Square = Matrix<double>;

double apart(Square const& a, Square const& b) { return magnitude(Square(a - b)) / (1 + magnitude(b)); }

}  // namespace

BOOST_AUTO_TEST_SUITE(functions_of_matrices)

BOOST_AUTO_TEST_CASE(exponentials_of_two_rows_have_closed_forms) {
  // Halved up to ten times, of both signs; each doubling magnifies rounding by about 2.
  for (double const a : {-3.0, -0.5, -0.2, 0.0, 0.1, 0.5, 0.75, 2.0, 40.0})
    for (double const b : {0.0, 0.2, -1.5, 300.0}) {
      double const allowed = 64 * eps * (1 + std::abs(a) + std::abs(b)), e = std::exp(a);
      // e^(a + bN) = e^a (1 + bN); iex(a + bN) = iex(a) + iex'(a) bN.
      Square const jordan{{a, b}, {0, a}};
      BOOST_TEST(apart(matrix_exponential(jordan), Square{{e, b * e}, {0, e}}) <= allowed);
      double const iex_a =
          std::abs(a) < 0.3 ? 1 + a / 2 * (1 + a / 3 * (1 + a / 4 * (1 + a / 5))) : std::expm1(a) / a;
      double const slope = std::abs(a) < 0.3 ? 0.5 + a / 3 * (1 + a * 3 / 8) : (e - iex_a) / a;
      double const cut = std::abs(a) < 0.3 ? std::pow(std::abs(a), 3) / 4 : 0;  // where their series are cut
      BOOST_TEST(apart(iex(jordan), Square{{iex_a, b * slope}, {0, iex_a}}) <= allowed + cut);
      BOOST_TEST(apart(chi(jordan) * iex(jordan), Square::Identity(2, 2)) <= allowed * (1 + std::abs(b)));
      // w iex(w) = e^w - 1, with a matrix that has no zero.
      Square const full{{a / 4, b / 40}, {-0.3, a / 8 + 0.1}};
      BOOST_TEST(apart(full * iex(full), matrix_exponential(full) - Square::Identity(2, 2)) <=
                 allowed * magnitude(matrix_exponential(full)));
      // Below the edge of the chart the logarithm leads back.
      if (std::abs(b) <= 1.5 && a <= 2) {
        BOOST_TEST(apart(matrix_logarithm(matrix_exponential(jordan)), jordan) <= 64 * allowed);
        Square const root = matrix_square_root(matrix_exponential(full));
        BOOST_TEST(apart(root * root, matrix_exponential(full)) <= 64 * allowed);
        BOOST_TEST(apart(root, matrix_exponential(full / 2)) <= 64 * allowed);
      }
    }
  // A turn by 3 beside a stretching: eigenvalues 2 e^{+-3i}.
  double const c = 2 * std::cos(3), s = 2 * std::sin(3), l = std::log(2);
  BOOST_TEST(apart(matrix_logarithm(Square{{c, -s}, {s, c}}), Square{{l, -3}, {3, l}}) <= 1e3 * eps);
}

BOOST_AUTO_TEST_CASE(norms_are_those_of_rows_and_say_how_often_to_halve) {
  BOOST_TEST(row_norm(Square{{1, -2}, {0.5, 0.25}, {-1, 0}}) == 3);
  BOOST_TEST(row_norm(Square{{1, 0}, {3, -4}}) == 7);
  BOOST_TEST(std::isnan(row_norm(Square{{1, std::nan("")}, {3, -4}})));
  BOOST_TEST(halvings(Square{{0.5, 0}, {0, 0.5}}, "here") == 0);
  BOOST_TEST(halvings(Square{{0.25, 0.5}, {0, 0.5}}, "here") == 1);
  BOOST_TEST(halvings(Square{{0, 0}, {0, 4}}, "here") == 3);
  BOOST_TEST(halvings(Square{{0, 0}, {0, 4.1}}, "here") == 4);
  CHECK_REFUSED(halvings(Square{{HUGE_VAL}}, "here"), NotFinite);
  CHECK_REFUSED(matrix_logarithm(Square{{1, HUGE_VAL}, {0, 1}}), NotFinite);
}

BOOST_AUTO_TEST_CASE(an_eigenvalue_on_the_negative_axis_is_refused_with_what_was_measured) {
  auto const text = [](Error const& e) { return std::string(e.what()); };
  // The iteration makes m of -1 the matrix zero, which has no inverse.
  auto const pivot = caught<OutsideDomain>([] { matrix_logarithm(Square{{-1, 0}, {0, -1}}); });
  BOOST_TEST((pivot.measured == 0 && pivot.bound == 16 * eps));
  BOOST_TEST(text(pivot).find("log: no eigenvalue may lie on the negative real axis (3.19), measured") == 0u);
  // Newton's iteration for a root never comes to rest on the negative axis.
  auto const wander = caught<OutsideDomain>([] { matrix_square_root(Square{{-2}}); });
  BOOST_TEST((wander.measured > 1e-6 && wander.bound == 1e-6));
  BOOST_TEST(text(wander).find("distance left after 60 iterations") != std::string::npos);
  // At an angle d from the axis a root magnifies rounding by 1/d^2, and is refused where that costs half the
  // digits and a thousandth.
  for (double const d : {1e-1, 1e-2, 1e-4, 1e-5, 1e-6}) {
    double const c = -std::cos(d), s = std::sin(d), half = M_PI - d;
    Square const near{{c, -s, 0}, {s, c, 0}, {0, 0, 0.5}};
    Square const logarithm{{0, -half, 0}, {half, 0, 0}, {0, 0, std::log(0.5)}};
    if (d >= 1e-2) {
      BOOST_TEST(apart(matrix_logarithm(near), logarithm) <= 64 * eps / (d * d));
    } else {
      auto const e = caught<OutsideDomain>([&] { matrix_logarithm(near); });
      BOOST_TEST((e.measured > e.bound && e.measured <= 64 * eps / (d * d)));
      BOOST_TEST(e.bound == std::sqrt(eps) * 1e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_nilpotent_matrix_has_a_polynomial_and_others_none) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using Q = Number;
  Matrix<Q> const w{{0, 2, -1}, {0, 0, 3}, {0, 0, 0}};
  auto const geometric = [](int n) { return Q(n + 1); };
  Matrix<Q> const expected = Matrix<Q>{{1, 4, -2 + 18}, {0, 1, 6}, {0, 0, 1}};
  BOOST_TEST((nilpotent_series(w, geometric, "here") == expected));
  BOOST_TEST((one_over_factorial<Q>(0) == 1 && one_over_factorial<Q>(1) == 1 &&
              one_over_factorial<Q>(5) == Q(1) / 120));
  Matrix<Q> const a = Matrix<Q>::Identity(3, 3) + w;
  BOOST_TEST((nilpotent_logarithm(a) == Matrix<Q>(w - w * w / Q(2))));
  // The square of ((0, 1), (0, 2)) is ((0, 2), (0, 4)).
  auto const e = caught<NotInThisField>([&] {
    nilpotent_series(Matrix<Q>{{0, 1}, {0, 2}}, geometric, "here");
  });
  BOOST_TEST((e.measured == 4 && e.bound == 0));
  BOOST_TEST(std::string(e.what()).find("here: over a field without transcendental functions") == 0u);
}

BOOST_AUTO_TEST_CASE(gausss_rules_are_exact_below_twice_their_number_of_nodes) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (int s : {1, 2, 3, 4, 7}) {
    auto const rule = gauss_quadrature<double>(s);
    auto const many = gauss_quadrature<Number>(s);
    BOOST_TEST((int(rule.nodes.size()) == s && int(rule.weights.size()) == s));
    for (int degree = 0; degree <= 2 * s; ++degree) {
      double sum = 0;
      Number exact = 0;
      for (int i = 0; i < s; ++i) {
        sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
        exact += many.weights[i] * pow(many.nodes[i], degree);
        BOOST_TEST((i == 0 ? rule.nodes[i] > 0 : rule.nodes[i] > rule.nodes[i - 1]));
        BOOST_TEST(rule.nodes[i] < 1);
      }
      // The error of x^2s is (s!)^4/((2s + 1) (2s)!^2) exactly.
      double missed = 0;
      if (degree == 2 * s) {
        missed = 1. / (2 * s + 1);
        for (int k = 1; k <= s; ++k) missed *= std::pow(double(k) / (s + k), 2);
      }
      BOOST_TEST(std::abs(1. / (degree + 1) - sum - missed) <= 32 * eps);
      BOOST_TEST(std::abs(to_double(Number(1) / (degree + 1) - exact) - missed) <=
                 (missed > 0 ? 1e-16 : 1e-48));
    }
  }
  for (double const x : {-0.7, 0.2, 1.3}) {
    BOOST_TEST(legendre_polynomial(1, x) == x);
    BOOST_TEST(std::abs(legendre_polynomial(2, x) - (3 * x * x - 1) / 2) <= 4 * eps);
    BOOST_TEST(std::abs(legendre_polynomial(3, x) - (5 * x * x - 3) * x / 2) <= 8 * eps);
    BOOST_TEST(std::abs(legendre_polynomial(4, x) - ((35 * x * x - 30) * x * x + 3) / 8) <= 32 * eps);
  }
  auto const none = caught<OutsideDomain>([] { gauss_quadrature<double>(0); }),
             many = caught<OutsideDomain>([] { gauss_quadrature<double>(1001); });
  BOOST_TEST((none.measured == 0 && none.bound == 1 && many.measured == 1001 && many.bound == 1000));
}

BOOST_AUTO_TEST_CASE(eigenvalues_and_eigenvectors_solve_their_equation) {
  Eigen::MatrixXd a(3, 3);
  a << 2, -1, 0.5, -1, 5, 3, 0.5, 3, -4;
  Eigen::MatrixXd upper = a;
  upper(1, 0) = upper(2, 0) = upper(2, 1) = 77;  // what is not read
  auto const found = symmetric_eigen(upper);
  BOOST_TEST((found.values[0] < found.values[1] && found.values[1] < found.values[2]));
  Square const v = found.vectors;
  BOOST_TEST(apart(v.transpose() * v, Square::Identity(3, 3)) <= 16 * eps);
  BOOST_TEST(apart(Square(a) * v, v * Vector<double>(found.values).asDiagonal()) <= 32 * eps);
  BOOST_TEST(std::abs(largest_eigenvalue(upper) - found.values[2]) <= 32 * eps);
  // Of ((1, -2), (3, 1)): 1 +- i sqrt 6; beside it -5 and 4 over entries that do not count.
  Eigen::MatrixXd b(4, 4);
  b << 1, -2, 9, 8, 3, 1, 7, 6, 0, 0, -5, 5, 0, 0, 0, 4;
  for (double const unit : {1.0, 1e250, 1e-250}) {
    auto const real = real_parts_of_eigenvalues(b * unit);
    double const expected[] = {-5, 1, 1, 4};
    for (int i = 0; i < 4; ++i) BOOST_TEST(std::abs(real[i] / unit - expected[i]) <= 256 * eps);
  }
  for (auto const& e : {caught<OutsideDomain>([] { symmetric_eigen(Eigen::MatrixXd::Zero(2, 3)); }),
                        caught<OutsideDomain>([] { real_parts_of_eigenvalues(Eigen::MatrixXd::Zero(2, 3)); }),
                        caught<OutsideDomain>([] { schur_form(Square::Zero(2, 3)); })})
    BOOST_TEST((e.measured == 2 && e.bound == 3));
  CHECK_REFUSED(schur_form(Square(0, 0)), OutsideDomain);
  CHECK_REFUSED(schur_form(Square{{std::nan("")}}), NotFinite);
  CHECK_REFUSED(symmetric_eigen(Eigen::MatrixXd::Constant(2, 2, HUGE_VAL)), NotFinite);
  CHECK_REFUSED(largest_eigenvalue(Eigen::MatrixXd::Constant(2, 2, HUGE_VAL)), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_schur_form_is_nearly_triangular_and_gives_the_matrix_back) {
  for (int const n : {1, 2, 3, 5, 6}) {
    Square a(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) a(i, j) = std::sin(1 + 3 * i + 5 * j * j) + (i == j + 1 ? 2 : 0);
    auto const [u, t] = schur_form(a);
    BOOST_TEST(apart(u.transpose() * u, Square::Identity(n, n)) <= 64 * eps);
    BOOST_TEST(apart(u * t * u.transpose(), a) <= 64 * n * eps);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < i; ++j) BOOST_TEST((j == i - 1 || t(i, j) == 0));
    for (int i = 0; i + 2 < n; ++i) BOOST_TEST((t(i + 1, i) == 0 || t(i + 2, i + 1) == 0));
  }
}

BOOST_AUTO_TEST_SUITE_END()
