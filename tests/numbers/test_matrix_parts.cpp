// Parts and shapes of matrices that are not square, entry by entry: of a matrix, of a view of every second
// row of one, and of both where they are constant.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>


#include "actio/matrices/matrix.hpp"
#include "actio/numbers/errors.hpp"

using namespace actio;

namespace {

/// 10 i + j in row i and column j.
template <int R = Dynamic, int C = Dynamic>
Matrix<int, R, C> numbered(Index rows, Index columns) {
  Matrix<int, R, C> m(rows, columns, detail::Sized{});
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) m(i, j) = static_cast<int>(10 * i + j);
  return m;
}
/// r rows and c columns of those, from row i and column j on.
template <class Part>
bool is(Part const& part, Index i0, Index j0, Index r, Index c) {
  bool same = part.rows() == r && part.cols() == c && part.size() == r * c;
  for (Index i = 0; same && i < r; ++i)
    for (Index j = 0; same && j < c; ++j) same = part(i, j) == 10 * (i0 + i) + j0 + j;
  return same;
}
/// All parts of a matrix with 4 rows and 6 columns.
template <class M>
void parts_are_where_they_belong(M&& m) {
  BOOST_TEST(is(m, 0, 0, 4, 6));
  BOOST_TEST((is(m.col(4), 0, 4, 4, 1) && is(m.row(2), 2, 0, 1, 6)));
  BOOST_TEST((is(m.block(1, 2, 3, 4), 1, 2, 3, 4) && is(m.template block<3, 2>(1, 3), 1, 3, 3, 2)));
  BOOST_TEST((is(m.topRows(3), 0, 0, 3, 6) && is(m.template topRows<1>(), 0, 0, 1, 6)));
  BOOST_TEST((is(m.middleRows(1, 2), 1, 0, 2, 6) && is(m.template middleRows<2>(1), 1, 0, 2, 6)));
  BOOST_TEST((is(m.bottomRows(3), 1, 0, 3, 6) && is(m.template bottomRows<1>(), 3, 0, 1, 6)));
  BOOST_TEST((is(m.leftCols(2), 0, 0, 4, 2) && is(m.template leftCols<5>(), 0, 0, 4, 5)));
  BOOST_TEST((is(m.middleCols(3, 2), 0, 3, 4, 2) && is(m.template middleCols<3>(2), 0, 2, 4, 3)));
  BOOST_TEST((is(m.rightCols(2), 0, 4, 4, 2) && is(m.template rightCols<5>(), 0, 1, 4, 5)));
  BOOST_TEST((is(m.topLeftCorner(3, 2), 0, 0, 3, 2) && is(m.template topLeftCorner<1, 5>(), 0, 0, 1, 5)));
  BOOST_TEST((is(m.topRightCorner(3, 2), 0, 4, 3, 2) && is(m.template topRightCorner<1, 5>(), 0, 1, 1, 5)));
  BOOST_TEST(
      (is(m.bottomLeftCorner(3, 2), 1, 0, 3, 2) && is(m.template bottomLeftCorner<1, 5>(), 3, 0, 1, 5)));
  BOOST_TEST(
      (is(m.bottomRightCorner(3, 2), 1, 4, 3, 2) && is(m.template bottomRightCorner<1, 5>(), 3, 1, 1, 5)));
  // Parts of parts: rows lie, columns stand.
  BOOST_TEST((is(m.row(2).segment(1, 4), 2, 1, 1, 4) && is(m.col(4).segment(1, 2), 1, 4, 2, 1)));
  BOOST_TEST((is(m.row(2).template segment<4>(1), 2, 1, 1, 4)));
  BOOST_TEST((is(m.col(4).template segment<2>(1), 1, 4, 2, 1)));
  BOOST_TEST((is(m.row(3).head(2), 3, 0, 1, 2) && is(m.col(5).head(3), 0, 5, 3, 1)));
  BOOST_TEST((is(m.row(3).template head<2>(), 3, 0, 1, 2) && is(m.col(5).template head<3>(), 0, 5, 3, 1)));
  BOOST_TEST((is(m.row(3).tail(2), 3, 4, 1, 2) && is(m.col(5).tail(3), 1, 5, 3, 1)));
  BOOST_TEST((is(m.row(3).template tail<2>(), 3, 4, 1, 2) && is(m.col(5).template tail<3>(), 1, 5, 3, 1)));
  BOOST_TEST(is(m.block(1, 1, 3, 4).bottomRightCorner(2, 3), 2, 2, 2, 3));
  // Shapes.
  auto const diagonal = m.block(0, 1, 4, 3).diagonal();
  BOOST_TEST((diagonal.size() == 3 && diagonal[0] == 1 && diagonal[1] == 12 && diagonal[2] == 23));
  BOOST_TEST(m.topLeftCorner(3, 3).trace() == 33);
  auto const turned = m.transpose();
  auto const column = m.reshaped();
  auto const wide = m.reshaped(3, 8);
  bool same = turned.rows() == 6 && turned.cols() == 4 && column.rows() == 24 && wide.cols() == 8;
  for (Index k = 0; k < 24; ++k) {
    int const number = static_cast<int>(10 * (k % 4) + k / 4);
    same = same && turned(k / 4, k % 4) == number && column[k] == number && wide(k % 3, k / 3) == number;
  }
  BOOST_TEST(same);
  auto const square = m.row(1).asDiagonal();
  BOOST_TEST((square.rows() == 6 && square.cols() == 6 && square.sum() == 75 && square.trace() == 75));
  BOOST_TEST((square(5, 5) == 15 && square(0, 0) == 10));
  // Numbers of a part are counted along it.
  for (Index k = 0; k < 4; ++k)
    BOOST_TEST((m.row(1).segment(1, 4)[k] == 11 + k && m.col(1)[k] == 10 * k + 1));
  BOOST_TEST((m.row(1)(4) == 14 && m.col(1)(3) == 31));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(matrix_parts)

BOOST_AUTO_TEST_CASE(parts_of_matrices_and_of_views_are_where_they_belong) {
  auto any = numbered(4, 6);
  auto fixed = numbered<4, 6>(4, 6);
  parts_are_where_they_belong(any);
  parts_are_where_they_belong(std::as_const(any));
  parts_are_where_they_belong(fixed);
  parts_are_where_they_belong(std::as_const(fixed));
  // Two apart down a column, eleven along a row.
  std::vector<int> memory(66, -1);
  MatrixView<int, Dynamic, Dynamic> every_second(memory.data() + 1, 4, 6, 2, 11);
  every_second = any;
  parts_are_where_they_belong(every_second);
  parts_are_where_they_belong(std::as_const(every_second));
  int written = 0;
  for (int x : memory) written += x >= 0;
  BOOST_TEST(written == 24);
  BOOST_TEST((is(as_matrix<4, 6>(any.data()), 0, 0, 4, 6)));
  BOOST_TEST((is(as_vector(any.data() + 4, 4), 0, 1, 4, 1)));
  // Of a temporary matrix.
  BOOST_TEST((is(numbered(4, 6).middleCols(3, 2), 0, 3, 4, 2) && is(numbered(4, 6).row(2), 2, 0, 1, 6)));
  BOOST_TEST(is(numbered<1, 6>(1, 6).tail<2>(), 0, 4, 1, 2));
  BOOST_TEST(is(Matrix<int, Dynamic, 1>(numbered(4, 6).col(3)).head(2), 0, 3, 2, 1));
  BOOST_TEST(numbered(4, 6).diagonal().size() == 4);
}

BOOST_AUTO_TEST_CASE(what_is_written_to_a_part_stands_in_the_matrix) {
  auto const before = numbered(4, 6);
  auto m = before;
  m.block(1, 2, 2, 3) *= 100;
  m.row(3).tail(2) += Matrix<int, 1, 2>(1000, 2000);
  m.col(0).head(2) -= Vector<int, 2>(5, 6);
  m.diagonal().array() += 7;
  m.rightCols(1).array() -= 50;
  Matrix<int> expected = before;
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < 6; ++j) {
      int& x = expected(i, j);
      if (i >= 1 && i < 3 && j >= 2 && j < 5) x *= 100;
      if (i == 3 && j >= 4) x += j == 4 ? 1000 : 2000;
      if (j == 0 && i < 2) x -= i == 0 ? 5 : 6;
      if (i == j) x += 7;
      if (j == 5) x -= 50;
    }
  BOOST_TEST((m == expected));
  m = before;
  m.row(0).swap(m.row(3)), m.topRows(2).col(1).swap(m.bottomRows(2).col(4));
  BOOST_TEST(
      (m(0, 0) == 30 && m(3, 5) == 5 && m(0, 1) == 24 && m(2, 4) == 31 && m(1, 1) == 4 && m(3, 4) == 11));
  m.topLeftCorner(2, 3).setIdentity();
  BOOST_TEST((m(0, 0) == 1 && m(1, 1) == 1 && m(0, 1) == 0 && m(1, 0) == 0 && m(1, 2) == 0 && m(2, 0) == 20));
  m.middleCols(1, 2).setOnes(), m.bottomRows(1).setZero(), m.col(5).setConstant(9);
  BOOST_TEST((m(2, 1) == 1 && m(2, 2) == 1 && m(2, 0) == 20 && m(3, 1) == 0 && m(3, 5) == 9 && m(2, 5) == 9));
  m.block(0, 0, 2, 2) /= 2;
  BOOST_TEST((m(0, 0) == 0 && m(2, 0) == 20));
}

BOOST_AUTO_TEST_CASE(sizes_and_constants_of_rows_columns_and_matrices) {
  using Row = Matrix<int, 1, Dynamic>;
  using Column = Matrix<int, Dynamic, 1>;
  using Thin = Matrix<int, Dynamic, 3>;
  auto const has = [](auto const& m, Index r, Index c) { return m.rows() == r && m.cols() == c; };
  BOOST_TEST((has(Row(4), 1, 4) && has(Column(4), 4, 1) && has(Thin(4), 4, 3) && has(Matrix<int>(4), 4, 1)));
  BOOST_TEST((has(Matrix<int>(4, 2), 4, 2) && has(Thin(4, 3), 4, 3) && has(Matrix<int>(), 0, 0)));
  BOOST_TEST((Matrix<int, 1, 1>(7)(0, 0) == 7 && Vector<int, 2>(8, 9)[1] == 9 && Row(1, 2, 3)[2] == 3));
  BOOST_TEST((has(Row(1, 2, 3, 4), 1, 4) && has(Column(1, 2, 3, 4), 4, 1) && Column(1, 2, 3, 4)[3] == 4));
  BOOST_TEST((Column(1, 2, 3, 4)[0] == 1 && Column(1, 2, 3, 4)[1] == 2 && Column(1, 2, 3, 4)[2] == 3));
  Matrix<int> const listed{{1, 2, 3}, {4, 5, 6}};
  BOOST_TEST((has(listed, 2, 3) && listed(0, 2) == 3 && listed(1, 0) == 4));
  BOOST_TEST((has(Column{{5, 6, 7}}, 3, 1) && Column{{5, 6, 7}}[2] == 7 && has(Column{{5}, {6}}, 2, 1)));
  BOOST_TEST((has(Column{{5}}, 1, 1) && has(Row{{5, 6}}, 1, 2)));

  BOOST_TEST((has(Row::Constant(3, 5), 1, 3) && has(Column::Constant(3, 5), 3, 1)));
  BOOST_TEST((Row::Constant(3, 5).sum() == 15 && Matrix<int>::Constant(2, 3, 4).sum() == 24));
  BOOST_TEST((has(Matrix<int>::Zero(2, 3), 2, 3) && Column::Zero(4).isZero() && has(Row::Zero(4), 1, 4)));
  BOOST_TEST((Matrix<int>::Ones(2, 3).sum() == 6 && has(Column::Ones(4), 4, 1) && Row::Ones(4).sum() == 4));
  BOOST_TEST((Matrix<int, 2, 3>::Ones().sum() == 6 && Matrix<int, 2, 3>::Constant(2).sum() == 12));
  BOOST_TEST((Matrix<int, 2, 3>::Zero().isZero() && Matrix<int, 2, 3>::Identity().sum() == 2));
  BOOST_TEST((Matrix<int>::Identity(3, 2) == Matrix<int>{{1, 0}, {0, 1}, {0, 0}}));
  BOOST_TEST((Matrix<int, 1, 3>::Unit(1) == Matrix<int, 1, 3>(0, 1, 0)));
  BOOST_TEST((Vector<int, 3>::Unit(1) == Vector<int, 3>(0, 1, 0) && has(Row::Unit(4, 2), 1, 4)));
  BOOST_TEST((Row::Unit(4, 2)[2] == 1 && Row::Unit(4, 2).sum() == 1 && Column::Unit(4, 3)[3] == 1));
  BOOST_TEST((Vector<int, 3>::UnitX() == Vector<int, 3>(1, 0, 0) && Vector<int, 3>::UnitZ()[2] == 1));
  BOOST_TEST((Vector<int, 3>::UnitY()[1] == 1));

  Matrix<int> m = numbered(3, 4);
  m.conservativeResize(2, 5);
  BOOST_TEST((is(m.leftCols(4), 0, 0, 2, 4) && m.col(4).isZero()));
  m.conservativeResize(4, 2);
  BOOST_TEST((is(m.topRows(2), 0, 0, 2, 2) && m.bottomRows(2).isZero() && has(m, 4, 2)));
  Column c(1, 2, 3);
  c.conservativeResize(5);
  BOOST_TEST((has(c, 5, 1) && c[2] == 3 && c[3] == 0 && c[4] == 0));
  c.resize(2), m.resize(3);
  Row r(1, 2, 3);
  r.resize(5);
  Thin thin;
  thin.resize(5);
  BOOST_TEST((has(c, 2, 1) && has(m, 3, 1) && has(r, 1, 5) && has(thin, 5, 3)));
  BOOST_TEST((has(m.setZero(2, 7), 2, 7) && m.isZero()));
  // Where Eigen's matrices come from and go to.
  Eigen::Matrix<int, 2, Eigen::Dynamic> const there = numbered(2, 3);
  BOOST_TEST((is(there, 0, 0, 2, 3) && is(Matrix<int, 2, 3>(there), 0, 0, 2, 3)));
  Eigen::MatrixXi const part = numbered(4, 6).bottomRows(2);
  BOOST_TEST(is(part, 2, 0, 2, 6));
  BOOST_TEST((is(Matrix<int>(there.rightCols(2)), 0, 1, 2, 2)));
}

BOOST_AUTO_TEST_SUITE_END()
