// Linear systems, determinants, ranks and roots: exactly over the rationals, and with the measured figure
// where there is no solution.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
#include <random>

#include "actio/linear_algebra/determinant.hpp"
#include "actio/linear_algebra/rank.hpp"
#include "actio/numbers/extrapolation.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/numbers/square_root.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

using Q = Number;
std::mt19937_64 source(5);
/// Whole numbers from -4 to 4, or zero two times in three.
Matrix<Q> drawn(int rows, int columns, bool sparse = false) {
  Matrix<Q> m(rows, columns);
  for (Q& x : m) x = sparse && source() % 3 ? Q(0) : Q(static_cast<long>(source() % 9) - 4);
  return m;
}
/// The sum over all permutations.
template <class K, class Entry>
K by_permutations(int n, K sum, K const& one, Entry const& entry) {
  std::vector<int> p(n);
  std::iota(p.begin(), p.end(), 0);
  do {
    K term = one;
    int inversions = 0;
    for (int i = 0; i < n; ++i) {
      term = term * entry(i, p[i]);
      for (int j = 0; j < i; ++j) inversions += p[j] > p[i];
    }
    sum = inversions % 2 ? sum - term : sum - (-term);
  } while (std::next_permutation(p.begin(), p.end()));
  return sum;
}
double const eps = epsilon<double>();

}  // namespace

BOOST_AUTO_TEST_SUITE(small_systems)

BOOST_AUTO_TEST_CASE(a_solution_over_the_rationals_solves_its_system) {
  WithArithmetic const exactly(Arithmetic::rationals());
  int solved = 0;
  for (int n = 1; n <= 5; ++n)
    for (int k = 0; k < 8; ++k) {
      auto const a = drawn(n, n, k % 2 == 1), right = drawn(n, 1 + k % 3);
      auto const det = by_permutations<Q>(n, Q(0), Q(1), [&](int i, int j) { return a(i, j); });
      BOOST_TEST((determinant_by_elimination(a) == det));
      BOOST_TEST((matrix_rank(a) == n) == (det != 0));
      if (det == 0) {
        auto const e = caught<Singular>([&] { solve_linear(a, right, "here"); });
        BOOST_TEST((e.measured == 0 && e.bound == 0));
        BOOST_TEST(std::string(e.what()).find("here: a matrix with an inverse") == 0u);
        continue;
      }
      ++solved;
      BOOST_TEST((a * solve_linear(a, right) == right));
      BOOST_TEST((inverse_matrix(a) * a == Matrix<Q>::Identity(n, n)));
    }
  BOOST_TEST(solved >= 20);
}

BOOST_AUTO_TEST_CASE(a_determinant_of_complex_numbers_is_the_sum_over_permutations) {
  WithArithmetic const exactly(Arithmetic::rationals());
  for (int n = 1; n <= 4; ++n)
    for (int k = 0; k < 6; ++k) {
      auto const re = drawn(n, n, k % 2 == 1), im = drawn(n, n, k % 3 == 1);
      Matrix<Q> a(2 * n, 2 * n);
      a << re, -im, im, re;
      auto const expected = by_permutations(n, Complex<Q>(Q(0)), Complex<Q>(Q(1)),
                                            [&](int i, int j) { return Complex<Q>(re(i, j), im(i, j)); });
      auto const found = complex_determinant(a);
      BOOST_TEST((found.re == expected.re && found.im == expected.im));
    }
  Complex<Q> const z(Q(3), Q(-4)), w(Q(1), Q(2));
  BOOST_TEST((z.square_of_modulus() == 25 && z.conjugate().im == 4 && (-z).re == -3 && (-z).im == 4));
  BOOST_TEST((((z / w) * w).re == 3 && ((z / w) * w).im == -4));
}

// Rows in units of their own: the pivot is the one that is largest beside its row. Taken by size alone, or
// without exchange, the other row drowns.
BOOST_AUTO_TEST_CASE(pivots_are_chosen_beside_their_rows) {
  Matrix<double> a{{1e-18, 1, 0}, {1, 1, 2}, {3e20, 1e40, -2e40}};
  Matrix<double> const x{{3}, {-2}, {0.5}};
  for (int k = 0; k < 6; ++k) {
    auto const solved = solve_linear(a, Matrix<double>(a * x));
    // Each sum rounds by the size of its terms; the condition of the rows in units of their own is below 8.
    for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(solved(i, 0) - x(i, 0)) <= 64 * eps);
    a.row(k % 2).swap(a.row(k % 2 + 1));
  }
}

BOOST_AUTO_TEST_CASE(a_pivot_that_is_rounding_is_told_with_its_size_and_the_bound) {
  // 1 + 4 epsilon - 1, made of terms of size 1; n = 2 allows 16 epsilon.
  auto const e = caught<Singular>([] {
    solve_linear(Matrix<double>{{1, 1}, {1, 1 + 4 * eps}}, Matrix<double>{{1}, {1}}, "here");
  });
  BOOST_TEST((e.measured == 4 * eps / (1 + 4 * eps) || e.measured == 4 * eps));
  BOOST_TEST(e.bound == 16 * eps);
  BOOST_CHECK_NO_THROW(solve_linear(Matrix<double>{{1, 1}, {1, 1 + 17 * eps}}, Matrix<double>{{1}, {1}}));
  // Of two zeros nothing is made; a large entry elsewhere does not count, nor does a small unit.
  auto const zero = caught<Singular>([] { inverse_matrix(Matrix<double>{{0, 1}, {0, 1e30}}); });
  BOOST_TEST((zero.measured == 0 && zero.bound == 16 * eps));
  BOOST_CHECK_NO_THROW(inverse_matrix(Matrix<double>{{1, 1e30}, {0, 1}}));
  BOOST_CHECK_NO_THROW(inverse_matrix(Matrix<double>{{1e-30, 0}, {0, 1e30}}));
  auto const largest = caught<NotFinite>([] {
    solve_linear(Matrix<double>{{1e-200, 0}, {0, 1}}, Matrix<double>{{1e200, 1}, {1, 1}}, "here");
  });
  BOOST_TEST(largest.what() ==
             std::string("here: the solution is beyond the largest number: a NaN or an infinity "
                         "where a finite number is needed"));
  for (int k = 0; k < 4; ++k) {
    Matrix<double> bad = Matrix<double>::Identity(2, 2), right = Matrix<double>::Ones(2, 2);
    BOOST_CHECK_NO_THROW(solve_linear(bad, right));
    (k < 2 ? bad(k, 1) : right(k - 2, 1)) = std::nan("");
    CHECK_REFUSED(solve_linear(bad, right), NotFinite);
  }
}

BOOST_AUTO_TEST_CASE(a_derivative_goes_through_a_solution_and_a_determinant) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // d(A^-1 b) = -A^-1 dA A^-1 b + A^-1 db; d det A = det A tr(A^-1 dA).
  using D = Dual<Q, 1>;
  auto const a = Matrix<Q>{{0, 2, 1}, {3, 1, -1}, {1, 4, 2}}, da = drawn(3, 3), b = drawn(3, 2),
             db = drawn(3, 2);
  auto A = a.cast<D>(), B = b.cast<D>();
  for (int k = 0; k < 9; ++k) A(k).part[0] = da(k);
  for (int k = 0; k < 6; ++k) B(k).part[0] = db(k);
  auto const x = solve_linear(A, B);
  auto const inverse = inverse_matrix(a);
  auto const rate = inverse * db - inverse * da * inverse * b;
  for (int k = 0; k < 6; ++k) BOOST_TEST((x(k).value == (inverse * b)(k) && x(k).part[0] == rate(k)));
  BOOST_TEST(
      (determinant_by_elimination(A).part[0] == determinant_by_elimination(a) * (inverse * da).trace()));
}

BOOST_AUTO_TEST_CASE(the_rank_is_that_of_the_factors) {
  WithArithmetic const exactly(Arithmetic::rationals());
  for (auto const& [rows, columns] : {std::pair(4, 6), {6, 4}, {5, 5}, {1, 3}, {3, 1}})
    for (int rank = 0; rank <= std::min(rows, columns); ++rank) {
      Matrix<Q> left = Matrix<Q>::Zero(rows, rank), right = Matrix<Q>::Zero(rank, columns);
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < rank; ++j)
          left(i, j) = Q(i == rows - 1 - j ? 1 : i > rows - 1 - j ? i + 2 * j : 0);
      for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rank; ++j)
          right(j, i) = Q(i == (j + 1) % columns ? 1 : i > j + 1 ? i - 3 * j : 0);
      auto const a = left * right;
      BOOST_TEST(matrix_rank(a) <= rank);
      BOOST_TEST(matrix_rank(left) == rank);
      BOOST_TEST(matrix_rank(left.transpose()) == rank);
      BOOST_TEST(matrix_rank(left.unaryExpr([](Q const& x) { return to_double(x); })) == rank);
    }
  // 256 n epsilon of the largest entry is the bound, n the larger of rows and columns.
  for (bool const wide : {false, true}) {
    Matrix<double> a = Matrix<double>::Zero(2, 3);
    a(0, 1) = -4, a(1, 0) = 4 * 256 * 3 * eps;
    BOOST_TEST(matrix_rank(wide ? a : a.transpose()) == 1);
    a(1, 0) *= 1.001;
    BOOST_TEST(matrix_rank(wide ? a : a.transpose()) == 2);
  }
}

BOOST_AUTO_TEST_CASE(a_root_of_a_rational_is_rational_or_refused) {
  using Q = rational;
  BOOST_TEST((square_root(Q(49) / 36) == Q(7) / 6 && square_root(Q(0)) == 0));
  for (Q const& x : {Q(-4) / 9, Q(2) / 9, Q(4) / 7, Q(8)}) {
    auto const e = caught<NotASquare>([&] { square_root(x); });
    BOOST_TEST((e.measured == to_double(x) && e.bound == 0));
  }
  Dual<Q, 2> x(Q(9) / 4);
  x.part = {Q(1), Q(-2)};
  BOOST_TEST((square_root(x).value == Q(3) / 2 && square_root(x).part[0] == Q(1) / 3));
  BOOST_TEST((square_root(x).part[1] == Q(-2) / 3 && square_root(2.25) == 1.5));
}

BOOST_AUTO_TEST_CASE(a_sequence_is_continued_by_the_polynomial_of_falling_differences) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using Pair = Matrix<Q, 2, 1>;
  for (int degree = 0; degree <= 12; ++degree) {
    Extrapolation<Pair> sequence;
    BOOST_TEST(sequence.empty());
    auto const term = [&](int k) {
      Pair p(Q(1), Q(3));
      for (int d = 0; d < degree; ++d) p[0] *= Q(k) / 8, p[1] *= Q(k + 1) / 8;
      return p;
    };
    for (int k = 200; k < 200 + 2 * 12; ++k) {
      sequence.push(term(k));
      BOOST_TEST(!sequence.empty());
      // Twelve terms tell a polynomial of degree eleven, and fewer one of a lower degree.
      BOOST_TEST((sequence.next() == term(k + 1)) == (std::min(k - 199, 12) > degree));
    }
    sequence.clear();
    BOOST_TEST(sequence.empty());
    sequence.push(term(5));
    BOOST_TEST((sequence.next() == term(5)));
  }
  // Differences that do not fall are left out: of 1, -1, 1, -1 and of one jump; of equal sizes, too.
  Extrapolation<Matrix<Q, 1, 1>> jumps;
  for (int k : {1, -1, 1, -1}) jumps.push(Matrix<Q, 1, 1>(Q(k)));
  BOOST_TEST((jumps.next()[0] == -1));
  jumps.clear();
  for (int k : {0, 5}) jumps.push(Matrix<Q, 1, 1>(Q(k)));
  BOOST_TEST((jumps.next()[0] == 5));
  jumps.push(Matrix<Q, 1, 1>(Q(7)));
  // 7, 2 and -3: the second difference is larger than the first.
  BOOST_TEST((jumps.next()[0] == 9));
}

BOOST_AUTO_TEST_SUITE_END()
