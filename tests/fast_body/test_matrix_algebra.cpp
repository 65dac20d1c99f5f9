// Matrices in blocks, against matrices of Eigen: whole numbers, of which every sum is exact, in matrices
// without any symmetry, of sizes on both sides of those at which blocks, rows of blocks and pieces of sums
// end.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/fast_body/any_dimension/matrix_algebra.hpp"
#include "actio/fast_body/any_dimension/matrix_conditions.hpp"

using namespace actio;
using namespace actio::bodies;
using namespace actio::bodies::detail;
using Eigen::MatrixXd;

namespace {

MatrixXd whole_numbers(std::mt19937& random, int n) {
  MatrixXd a(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) a(i, j) = static_cast<int>(random() % 17) - 8;
  return a;
}
Zeros in_blocks(MatrixXd const& a) {
  Blocked<0> const shape(static_cast<int>(a.rows()));
  Zeros blocks(full_size(shape));
  for (int j = 0; j < shape.n; ++j)
    for (int i = 0; i < shape.n; ++i) blocks.data()[full_entry(shape, i, j)] = a(i, j);
  return blocks;
}
/// Whether blocks hold this matrix, and zeros beyond it.
bool holds(Zeros const& blocks, MatrixXd const& a) {
  Blocked<0> const shape(static_cast<int>(a.rows()));
  int const edge = 4 * shape.blocks();
  for (int j = 0; j < edge; ++j)
    for (int i = 0; i < edge; ++i)
      if (blocks.data()[full_entry(shape, i, j)] != (i < shape.n && j < shape.n ? a(i, j) : 0.0))
        return false;
  return true;
}
/// The blocks on and below the diagonal of a symmetric matrix.
bool half_holds(Zeros const& half, MatrixXd const& a) {
  Blocked<0> const shape(static_cast<int>(a.rows()));
  int const edge = 4 * shape.blocks();
  for (int j = 0; j < edge; ++j)
    for (int i = j / 4 * 4; i < edge; ++i)
      if (half.data()[half_entry(shape, i, j)] != (i < shape.n && j < shape.n ? a(i, j) : 0.0)) return false;
  return true;
}
MatrixXd product(MatrixXd const& a, MatrixXd const& b) { return a.lazyProduct(b); }

template <int B>
void square_and_product_in_place(std::mt19937& random, int n) {
  MatrixXd const g = whole_numbers(random, n), e = whole_numbers(random, n);
  Blocked<0> const shape(n);
  Zeros const gb = in_blocks(g), eb = in_blocks(e);
  Zeros square(half_size(shape)), both(full_size(shape));
  square_of(Blocked<B>(n), eb.data(), square.data());
  product_of(Blocked<B>(n), gb.data(), eb.data(), both.data());
  BOOST_TEST(half_holds(square, product(e, e.transpose())), "square, n = " << n << ", blocks known " << B);
  BOOST_TEST(holds(both, product(g, e.transpose())), "product, n = " << n << ", blocks known " << B);
}

/// The unit lower triangle l times d times its transpose.
MatrixXd with_pivots(MatrixXd const& l, Eigen::VectorXd const& d) {
  return product(product(l, MatrixXd(d.asDiagonal())), MatrixXd(l.transpose()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(matrix_algebra)

BOOST_AUTO_TEST_CASE(squares_and_products_of_blocks_are_those_of_their_matrices) {
  std::mt19937 random(1971);
  for (int n = 1; n <= 17; ++n) square_and_product_in_place<0>(random, n);
  for (int n : {1, 2, 3, 4}) square_and_product_in_place<1>(random, n);
  for (int n : {5, 6, 7, 8}) square_and_product_in_place<2>(random, n);
  for (int n : {13, 14, 15, 16}) square_and_product_in_place<4>(random, n);
  // More rows than are added up at a time, an even and an odd number of blocks; and sums of several pieces.
  for (int n : {128, 129, 137, 257}) square_and_product_in_place<0>(random, n);
}

BOOST_AUTO_TEST_CASE(what_is_done_with_blocks_is_done_with_their_matrix) {
  std::mt19937 random(1972);
  for (Machine const machine : {Machine::plain, best_machine()})
    for (int n : {1, 2, 3, 4, 5, 7, 8, 9, 13, 16, 18, 130}) {
      BOOST_TEST_CONTEXT("n = " << n) {
        MatrixAlgebra const algebra(n, machine);
        BOOST_TEST(algebra.shape().n == n);
        MatrixXd const a = whole_numbers(random, n), b = whole_numbers(random, n), at = a.transpose();
        Zeros const ab = in_blocks(a), bb = in_blocks(b);
        BOOST_TEST(algebra.size() == full_size(algebra.shape()));
        Zeros out(algebra.size());
        algebra.times_transposed(ab.data(), bb.data(), out.data());
        BOOST_TEST(holds(out, product(a, MatrixXd(b.transpose()))));
        auto const changed = [&](auto const& change) {
          Zeros copy = ab;
          change(copy.data());
          return copy;
        };
        BOOST_TEST(holds(changed([&](double* t) { algebra.subtract_transposed(t); }), a - at));
        BOOST_TEST(holds(changed([&](double* t) { algebra.transpose_in_place(t); }), at));
        BOOST_TEST(holds(changed([&](double* t) { algebra.make_skew(t); }), (a - at) / 2));
        BOOST_TEST(holds(changed([&](double* t) { algebra.scale(-3, t); }), -3 * a));
        BOOST_TEST(holds(changed([&](double* t) { algebra.add(5, bb.data(), t); }), a + 5 * b));
        BOOST_TEST(
            holds(changed([&](double* t) { algebra.multiply_entries(bb.data(), t); }), a.cwiseProduct(b)));
        BOOST_TEST(holds(changed([&](double* t) { algebra.add_identity(t); }), a + MatrixXd::Identity(n, n)));
        BOOST_TEST(algebra.norm(ab.data()) == std::sqrt(a.cwiseAbs2().sum()));
        // A copy is another matrix; what is assigned is the same.
        Zeros copy = ab, other(1);
        copy.data()[0] += 1, other = copy;
        BOOST_TEST(holds(ab, a));
        BOOST_TEST(other.data()[0] == a(0, 0) + 1);
        BOOST_TEST(other.data()[full_entry(algebra.shape(), n - 1, n / 2)] ==
                   a(n - 1, n / 2) + (n == 1 ? 1 : 0));
      }
    }
}

BOOST_AUTO_TEST_CASE(a_matrix_is_positive_definite_where_all_pivots_are_positive) {
  std::mt19937 random(1973);
  for (int n : {1, 2, 3, 5, 8}) {
    MatrixXd l = whole_numbers(random, n).triangularView<Eigen::StrictlyLower>();
    l += MatrixXd::Identity(n, n);
    Eigen::VectorXd d(n);
    for (int i = 0; i < n; ++i) d[i] = 1 + static_cast<int>(random() % 5);
    BOOST_TEST(positive_definite(with_pivots(l, d)));
    // What stands above the diagonal is not read.
    MatrixXd const lower = with_pivots(l, d).triangularView<Eigen::Lower>();
    BOOST_TEST(positive_definite(lower));
    for (int k = 0; k < n; ++k)
      for (double const pivot : {0.0, -1.0}) {
        auto other = d;
        other[k] = pivot;
        BOOST_TEST(!positive_definite(with_pivots(l, other)), "n = " << n << ", pivot " << k);
        if (pivot < 0) BOOST_TEST(sign_of_determinant(with_pivots(l, other)) == -1);
      }
    BOOST_TEST(sign_of_determinant(with_pivots(l, d)) == 1);
    BOOST_TEST(sign_of_determinant(MatrixXd::Zero(n, n)) == 0);
    if (n > 2) {
      MatrixXd exchanged = with_pivots(l, d);
      exchanged.row(0).swap(exchanged.row(n - 1));
      BOOST_TEST(sign_of_determinant(exchanged) == -1);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_rotation_is_named_by_how_far_it_is_from_one) {
  auto const refused = [](MatrixXd const& g, int n) {
    try {
      require_rotation(g, n, "here");
    } catch (OutsideDomain const& e) {
      return std::pair{e.measured, e.bound};
    }
    return std::pair{0.0, 0.0};
  };
  MatrixXd const one = MatrixXd::Identity(3, 3);
  BOOST_CHECK_NO_THROW(require_rotation(one, 3, "here"));
  BOOST_TEST((refused(MatrixXd::Zero(4, 3), 3) == std::pair{4.0, 3.0}));
  BOOST_TEST((refused(MatrixXd::Zero(3, 4), 3) == std::pair{3.0, 3.0}));
  BOOST_TEST((refused(one, 2) == std::pair{3.0, 2.0}));
  // Columns of length 1 that are not at right angles, in each pair; and at right angles, of another length.
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i <= j; ++i)
      for (double const off : {0x1p-20, 0x1p-26}) {
        MatrixXd g = one;
        if (i == j)
          g(i, i) = 1 + off;
        else
          g(i, j) = off;
        double const found = i == j ? 2 * off + off * off : off;
        BOOST_TEST((refused(g, 3) == std::pair{found, 1e-8}), i << ", " << j << ", " << off);
        g = one, g(i, j) += 0x1p-30;
        BOOST_CHECK_NO_THROW(require_rotation(g, 3, "here"));
      }
  MatrixXd mirror = one;
  mirror(1, 1) = -1;
  BOOST_TEST((refused(mirror, 3) == std::pair{-1.0, 1.0}));
}

BOOST_AUTO_TEST_SUITE_END()
