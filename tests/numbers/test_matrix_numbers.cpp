// Sums, products, norms and largest entries of matrices that are not square, against plain loops over whole
// numbers.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/matrices/matrix.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

/// Entries that look random, of both signs and without a zero.
template <class S = int, int R = Dynamic, int C = Dynamic>
Matrix<S, R, C> mixed(Index rows, Index columns, int seed) {
  Matrix<S, R, C> m(rows, columns, detail::Sized{});
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) {
      int const x = static_cast<int>((i * 7 + j * 11 + seed * 5) % 17) - 8;
      m(i, j) = S(x == 0 ? 9 : x);
    }
  return m;
}
template <class F>
bool every(Index rows, Index columns, F const& holds) {
  bool all = true;
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) all = all && holds(i, j);
  return all;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(matrix_numbers)

BOOST_AUTO_TEST_CASE(operations_number_by_number) {
  auto const a = mixed(3, 5, 1), b = mixed(3, 5, 2);
  auto const fixed = mixed<int, 3, 5>(3, 5, 2);
  // A view whose rows are not those of its matrix.
  auto const whole = mixed(6, 7, 2);
  auto const view = whole.block(2, 1, 3, 5);
  auto const agree = [&](auto const& left, auto const& right) {
    auto const x = [&](Index i, Index j) { return left(i, j); };
    auto const y = [&](Index i, Index j) { return right(i, j); };
    auto const holds = [&](auto const& m, auto const& value) {
      BOOST_TEST((m.rows() == 3 && m.cols() == 5));
      BOOST_TEST(every(3, 5, [&](Index i, Index j) { return m(i, j) == value(i, j); }));
    };
    holds(left + right, [&](Index i, Index j) { return x(i, j) + y(i, j); });
    holds(left - right, [&](Index i, Index j) { return x(i, j) - y(i, j); });
    holds(-left, [&](Index i, Index j) { return -x(i, j); });
    holds(left * 3, [&](Index i, Index j) { return 3 * x(i, j); });
    holds(3 * left, [&](Index i, Index j) { return 3 * x(i, j); });
    holds((left * 12) / 4, [&](Index i, Index j) { return 3 * x(i, j); });
    holds(left.cwiseProduct(right), [&](Index i, Index j) { return x(i, j) * y(i, j); });
    holds(left.cwiseQuotient(right), [&](Index i, Index j) { return x(i, j) / y(i, j); });
    holds(left.cwiseMax(right), [&](Index i, Index j) { return std::max(x(i, j), y(i, j)); });
    holds(left.cwiseAbs(), [&](Index i, Index j) { return std::abs(x(i, j)); });
    holds(left.cwiseAbs2(), [&](Index i, Index j) { return x(i, j) * x(i, j); });
    holds(left.template cast<double>().cwiseInverse(), [&](Index i, Index j) { return 1.0 / x(i, j); });
    holds(left.cwiseAbs().template cast<double>().cwiseSqrt(),
          [&](Index i, Index j) { return std::sqrt(double(std::abs(x(i, j)))); });
    holds(left.unaryExpr([](int n) { return n - 0.5; }), [&](Index i, Index j) { return x(i, j) - 0.5; });
    // Products, also with numbers of another kind.
    auto const product = left * right.transpose();
    auto const other = left.template cast<double>() * right.transpose();
    BOOST_TEST((product.rows() == 3 && product.cols() == 3));
    BOOST_TEST(every(3, 3, [&](Index i, Index j) {
      int sum = 0;
      for (Index k = 0; k < 5; ++k) sum += x(i, k) * y(j, k);
      return product(i, j) == sum && other(i, j) == sum;
    }));
    // Sums and the like.
    int sum = 0, squares = 0, largest = -99, least = 99;
    double prod = 1;
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 5; ++j) {
        sum += x(i, j), squares += x(i, j) * x(i, j), prod *= x(i, j);
        largest = std::max(largest, x(i, j)), least = std::min(least, x(i, j));
      }
    auto const real = left.template cast<double>();
    BOOST_TEST((left.sum() == sum && left.squaredNorm() == squares && real.prod() == prod));
    BOOST_TEST((left.maxCoeff() == largest && left.minCoeff() == least));
    BOOST_TEST(real.norm() == std::sqrt(double(squares)));
    BOOST_TEST(std::abs(real.stableNorm() / std::sqrt(double(squares)) - 1) <= 8 * epsilon<double>());
    BOOST_TEST(magnitude(left) == std::max(largest, -least));
    BOOST_TEST((left == left && !(left == right) && left == Matrix<int>(left)));
    // Places.
    int dot = 0;
    for (Index k = 0; k < 5; ++k) dot += x(1, k) * y(2, k);
    BOOST_TEST((left.row(1).dot(right.row(2)) == dot && left.row(1).dot(right.row(2).transpose()) == dot));
    BOOST_TEST((left.row(1).transpose().dot(right.row(2)) == dot));
    BOOST_TEST(left.row(1).template cast<double>().dot(right.row(2)) == dot);
    auto const v = left.col(3);
    BOOST_TEST((v.x() == x(0, 3) && v.y() == x(1, 3) && v.z() == x(2, 3) && left.row(1).w() == x(1, 3)));
    auto const across = v.cross(right.col(0));
    auto const same = cross(v, right.col(0));
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      BOOST_TEST(across[i] == x(j, 3) * y(k, 0) - x(k, 3) * y(j, 0));
      BOOST_TEST(same[i] == across[i]);
    }
  };
  agree(a, b), agree(b, a), agree(a, fixed), agree(fixed, a), agree(view, a), agree(a, view);
  Eigen::MatrixXi const theirs = b;
  BOOST_TEST(
      ((theirs + a) == b + a && (theirs - a) == b - a && (a - theirs) == a - b && (a + theirs) == a + b));
  BOOST_TEST((Eigen::MatrixXi(theirs.transpose()) * a == b.transpose() * a &&
              a.transpose() * theirs == a.transpose() * b));
}

BOOST_AUTO_TEST_CASE(vectors_are_scaled_to_length_one) {
  Vector<double, 3> v(3, -4, 12);
  BOOST_TEST((v.normalized() - v / 13).isZero(epsilon<double>()));
  BOOST_TEST((Vector<double, 3>(v * 1e200).stableNormalized() - v / 13).isZero(2 * epsilon<double>()));
  BOOST_TEST((Vector<double, 3>(v * 1e-200).stableNormalized() - v / 13).isZero(2 * epsilon<double>()));
  BOOST_TEST((Vector<double, 3>::Zero().stableNormalized() == Vector<double, 3>::Zero()));
  auto w = v;
  w.normalize();
  BOOST_TEST((w == v.normalized()));

  BOOST_TEST((Vector<double, 3>(1, -HUGE_VAL, 2).stableNorm() == HUGE_VAL));
}

BOOST_AUTO_TEST_CASE(each_entry_counts_for_zero_for_size_and_for_finiteness) {
  for (Index i = 0; i < 2; ++i)
    for (Index j = 0; j < 3; ++j) {
      Matrix<double> m = Matrix<double>::Constant(2, 3, 0.5);
      BOOST_TEST((m.isZero(0.5) && !m.isZero(0.25) && is_finite(m)));
      BOOST_CHECK_NO_THROW(require_finite(m, "here"));
      m(i, j) = -2;
      BOOST_TEST((!m.isZero(1) && m.isZero(2) && magnitude(m) == 2));
      m(i, j) = 2;
      BOOST_TEST((!m.isZero(1) && m.isZero(2) && magnitude(m) == 2));
      for (double const bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        m(i, j) = bad;
        BOOST_TEST((!m.isZero(1) && !is_finite(m)));
        BOOST_TEST((std::isnan(bad) ? std::isnan(magnitude(m)) : magnitude(m) == HUGE_VAL));
        BOOST_CHECK_EXCEPTION(require_finite(m, "here"), NotFinite, [](NotFinite const& e) {
          return std::string(e.what()) == "here: a NaN or an infinity where a finite number is needed";
        });
        Matrix<dec50> many = m.cast<dec50>();
        CHECK_REFUSED(require_finite(many, "here"), NotFinite);
        BOOST_TEST(!is_finite(many));
      }
    }
  BOOST_TEST((magnitude(rational(-3)) == 3 && magnitude(rational(3)) == 3 && is_finite(rational(3))));
  BOOST_TEST((ratio<rational>(-6, 4) == rational(-3) / 2));
}

BOOST_AUTO_TEST_CASE(a_matrix_is_filled_row_by_row_from_blocks_of_any_size) {
  Matrix<int, 5, 4> m;
  Matrix<int> const wide{{1, 2, 3}, {4, 5, 6}}, thin{{7}, {8}}, low{{9, 10}}, nothing(2, 0);
  m << wide, thin, low, 11, 12, Matrix<int>{{13, 14}, {15, 16}}, nothing, Matrix<int>{{17, 18}, {19, 20}};
  BOOST_TEST(
      (m == Matrix<int>{{1, 2, 3, 7}, {4, 5, 6, 8}, {9, 10, 11, 12}, {13, 14, 17, 18}, {15, 16, 19, 20}}));
  Vector<int> v(6);
  v << 1, Vector<int, 3>(2, 3, 4), Vector<int>(0), 5, 6;
  for (int k = 0; k < 6; ++k) BOOST_TEST(v[k] == k + 1);
  Vector<int, 2> w;
  BOOST_TEST(&(w << 1, 2).finished() == &w);
  BOOST_TEST(w[1] == 2);
}

BOOST_AUTO_TEST_CASE(what_goes_wrong_says_what_was_measured_and_the_bound) {
  OutsideDomain const outside("here", "less is needed", 0.1234567891, 2);
  BOOST_TEST(outside.what() == std::string("here: less is needed, measured 0.123456789, bound 2"));
  BOOST_TEST((outside.measured == 0.1234567891 && outside.bound == 2));
  StepTooLong const step("here", 0.5, 0.25);
  BOOST_TEST((step.measured == 0.5 && step.bound == 0.25 && step.largest_step == 0.25));
  BOOST_TEST(std::string(step.what()).find("would do is 0.25, measured 0.5, bound 0.25") !=
             std::string::npos);
  NotConverged const history("here", {4, 2, 3}, 1e-3), none("here", {}, 1);
  BOOST_TEST((history.residuals.size() == 3 && history.residuals[2] == 3 && history.tolerance == 1e-3));
  BOOST_TEST(
      std::string(history.what()).find("no convergence in 3 iterations, residual 3, tolerance 0.001") !=
      std::string::npos);
  BOOST_TEST(std::string(none.what()).find("in 0 iterations, residual none, tolerance 1") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
