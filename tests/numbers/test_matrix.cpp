// The eager matrix against Eigen's, and where the two could differ: numbers of a matrix as factors, parts of
// it on both sides.
#include <boost/test/unit_test.hpp>

#include <sstream>

#include "actio/matrices/matrix.hpp"
#include "witness/draw.hpp"

using namespace actio;

namespace {

Matrix<double> drawn(Draw& draw, int rows, int columns) {
  Matrix<double> m(rows, columns);
  for (double& x : m) x = draw.number<double>();
  return m;
}
/// Entry by entry, to the rounding of sums of a few numbers below 1.
bool same(Matrix<double> const& a, Matrix<double> const& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a - Matrix<double>(b)).isZero(0x1p-48);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(matrix)

BOOST_AUTO_TEST_CASE(operations_agree_with_those_of_eigen) {
  Draw draw(7);
  for (int n : {1, 2, 3, 5}) {
    Matrix<double> const a = drawn(draw, n, n + 1), b = drawn(draw, n + 1, n), c = drawn(draw, n, n + 1),
                         v = drawn(draw, n, 1);
    Matrix<double> const ea = a, eb = b, ec = c, ev = v;
    BOOST_TEST(same(a * b, ea * eb));
    BOOST_TEST(same(a + c, ea + ec));
    BOOST_TEST(same(a - 2.0 * c / 3.0, ea - 2.0 * ec / 3.0));
    BOOST_TEST(same(-a.transpose(), -ea.transpose()));
    BOOST_TEST(same(v.transpose() * a, ev.transpose() * ea));
    BOOST_TEST(same(a.cwiseProduct(c), ea.cwiseProduct(ec)));
    BOOST_TEST(same(a.cwiseQuotient(c), ea.cwiseQuotient(ec)));
    BOOST_TEST(same(a.cwiseAbs(), ea.cwiseAbs()));
    BOOST_TEST(same(a.topRightCorner(n, n), ea.topRightCorner(n, n)));
    BOOST_TEST(same(a.row(n - 1), ea.row(n - 1)));
    BOOST_TEST(same(a.rightCols(1), ea.rightCols(1)));
    BOOST_TEST(same(a.diagonal(), ea.diagonal()));
    BOOST_TEST(same(a.reshaped(), ea.reshaped()));
    BOOST_TEST(std::abs(a.norm() - ea.norm()) <= 0x1p-48);
    BOOST_TEST(std::abs(a.sum() - ea.sum()) <= 0x1p-48);
    BOOST_TEST((a * b).trace() == (a * b).diagonal().sum());
    BOOST_TEST(a.maxCoeff() == ea.maxCoeff());
    BOOST_TEST(a.minCoeff() == ea.minCoeff());
    BOOST_TEST(same(v.asDiagonal() * a, ev.asDiagonal() * ea));
  }
}

BOOST_AUTO_TEST_CASE(matrices_of_eigen_go_in_and_come_out) {
  Vector<double, 3> const e(1, 2, 3);
  Vector<double, 3> const v = 2 * e, w(e);
  Vector<double, 3> const back = v, direct(w);
  BOOST_TEST((back == 2 * e && direct == e));
  BOOST_TEST((v + e == Vector<double, 3>(3, 6, 9)));
  BOOST_TEST((e - v == Vector<double, 3>(-1, -2, -3)));
  BOOST_TEST(v.dot(e) == 28);
  BOOST_TEST((v.cross(e)).isZero());
  BOOST_TEST((Matrix<double, 3, 3>::Identity() * v == v));
  Vector<double> const longer = v;
  BOOST_TEST(longer.size() == 3);
}

BOOST_AUTO_TEST_CASE(a_number_of_the_matrix_may_be_its_factor) {
  Vector<double> v(3);
  v << 2, 4, 6;
  v /= v[0];
  BOOST_TEST((v == Vector<double, 3>(1, 2, 3)));
  v *= v[1];
  BOOST_TEST((v == Vector<double, 3>(2, 4, 6)));
  v.setConstant(v[2]);
  BOOST_TEST((v == Vector<double, 3>(6, 6, 6)));
}

BOOST_AUTO_TEST_CASE(parts_of_one_matrix_may_stand_on_both_sides) {
  Matrix<double, 3, 3> a;
  a << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  Matrix<double, 3, 3> const before = a;
  a = a.transpose();
  BOOST_TEST((a == before.transpose()));
  a = before;
  a.topRows(2) = a.bottomRows(2);
  BOOST_TEST((a.row(0) == before.row(1) && a.row(1) == before.row(2) && a.row(2) == before.row(2)));
  a = before;
  a.col(0).swap(a.col(2));
  BOOST_TEST((a.col(0) == before.col(2) && a.col(2) == before.col(0)));
  a = before;
  a *= a;
  BOOST_TEST((a == before * before));
}

// Also where only the rows, or only the columns, differ in number.
BOOST_AUTO_TEST_CASE(matrices_of_different_sizes_are_not_equal) {
  Matrix<double> const a = Matrix<double>::Zero(2, 3);
  BOOST_TEST((a == Matrix<double>::Zero(2, 3)));
  for (auto const& [rows, columns] : {std::pair(1, 3), {3, 3}, {2, 2}, {2, 4}, {3, 2}})
    BOOST_TEST(!(a == Matrix<double>(Matrix<double>::Zero(rows, columns))));
}

BOOST_AUTO_TEST_CASE(numbers_of_a_row_and_of_a_column_are_counted_alike) {
  Matrix<double, 2, 3> a{{1, 2, 3}, {4, 5, 6}};
  for (int j = 0; j < 3; ++j) BOOST_TEST(a.row(1)[j] == a(1, j));
  for (int i = 0; i < 2; ++i) BOOST_TEST(a.col(2)[i] == a(i, 2));
}

BOOST_AUTO_TEST_CASE(a_part_of_a_temporary_matrix_is_a_copy) {
  auto const made = [] { return Matrix<double, 3, 3>::Identity(); };
  auto const column = made().col(1);
  auto const head = (made() * Vector<double, 3>(4, 5, 6)).head<2>();
  BOOST_TEST((std::is_same_v<decltype(column), Vector<double, 3> const>));
  BOOST_TEST((std::is_same_v<decltype(head), Vector<double, 2> const>));
  BOOST_TEST((head == Vector<double, 2>(4, 5)));
}

BOOST_AUTO_TEST_CASE(matrices_are_filled_by_numbers_and_by_blocks) {
  Matrix<double, 3, 3> a;
  a << Matrix<double, 2, 2>::Identity(), Vector<double, 2>(7, 8), 1, 2, 3;
  Matrix<double, 3, 3> const expected{{1, 0, 7}, {0, 1, 8}, {1, 2, 3}};
  BOOST_TEST((a == expected));
  std::ostringstream text;
  text << Matrix<int, 2, 2>{{1, 2}, {3, 4}};
  BOOST_TEST(text.str() == "1 2\n3 4\n");
}

BOOST_AUTO_TEST_CASE(a_norm_of_numbers_whose_squares_overflow_is_found) {
  Vector<double, 3> const large(3e200, 4e200, 0), small(3e-200, 4e-200, 0), nothing(0, 0, 0);
  BOOST_TEST(std::abs(large.stableNorm() / 5e200 - 1) < 4e-16);
  BOOST_TEST(std::abs(small.stableNorm() / 5e-200 - 1) < 4e-16);
  BOOST_TEST(nothing.stableNorm() == 0);
  BOOST_TEST(Vector<double>(0).stableNorm() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
