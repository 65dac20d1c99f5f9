// The echelon form and the kernel against elimination over the rationals, and the pivots and bounds that
// refusals carry.
#include <boost/test/unit_test.hpp>

#include "actio/constraints/multiplier_theorem.hpp"
#include "caught.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

using Q = Number;
template <class S>
using Table = Matrix<S, Dynamic, Dynamic>;
constexpr double eps = std::numeric_limits<double>::epsilon();

/// The rank by Gauss's elimination, column by column.
int rank_of(Table<Q> m) {
  int rank = 0;
  for (Index c = 0; c < m.cols() && rank < m.rows(); ++c) {
    Index pivot = rank;
    while (pivot < m.rows() && m(pivot, c) == Q(0)) ++pivot;
    if (pivot == m.rows()) continue;
    for (Index k = 0; k < m.cols(); ++k) std::swap(m(pivot, k), m(rank, k));
    for (Index i = rank + 1; i < m.rows(); ++i) {
      Q const factor = m(i, c) / m(rank, c);
      for (Index k = 0; k < m.cols(); ++k) m(i, k) -= factor * m(rank, k);
    }
    ++rank;
  }
  return rank;
}
/// A product of two factors with small fractions, of a rank at most that of their common side.
Table<Q> product(FineDraw& draw, int rows, int common, int columns) {
  Table<Q> m = Table<Q>::Zero(rows, columns);
  for (int n = 0; n < common; ++n) {
    Vector<Q> const left = draw.vector<Q, Vector<Q>>(rows), right = draw.vector<Q, Vector<Q>>(columns);
    for (int i = 0; i < rows; ++i)
      for (int c = 0; c < columns; ++c) m(i, c) += left[i] * right[c];
  }
  return m;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(echelon_forms)

BOOST_AUTO_TEST_CASE(rank_and_kernel_are_those_of_plain_elimination) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(29);
  for (auto const& [rows, common, columns] :
       {std::array{2, 2, 5}, {3, 2, 5}, {4, 3, 4}, {5, 2, 3}, {5, 5, 3}, {4, 4, 7}, {1, 1, 1}, {3, 0, 2}}) {
    Table<Q> const m = product(draw, rows, common, columns);
    int const rank = rank_of(m);
    auto const e = echelon(m);
    BOOST_TEST(e.rank == rank);
    BOOST_TEST(e.onto() == (rank == rows));
    BOOST_TEST(e.bound == 0);
    BOOST_TEST_REQUIRE(e.kernel().cols() == columns - rank);
    BOOST_TEST(rank_of(Table<Q>(e.kernel().transpose())) == columns - rank);
    // The rows have the identity in the exchanged columns, and are combinations of those given.
    std::vector<int> sorted = e.column;
    std::sort(sorted.begin(), sorted.end());
    for (int c = 0; c < columns; ++c) BOOST_TEST(sorted[static_cast<std::size_t>(c)] == c);
    for (int i = 0; i < rank; ++i)
      for (int c = 0; c < rank; ++c) BOOST_TEST((e.matrix(i, c) == Q(i == c)));
    for (int i = 0; i < rows; ++i)
      for (int c = 0; c < columns - rank; ++c) {
        Q sum(0);
        for (int k = 0; k < columns; ++k) sum += m(i, k) * e.kernel()(k, c);
        BOOST_TEST((sum == Q(0)));
      }
    // In double, with rows in units far apart.
    Table<double> scaled(rows, columns);
    for (int i = 0; i < rows; ++i)
      for (int c = 0; c < columns; ++c) scaled(i, c) = std::ldexp(to_double(m(i, c)), 60 * i - 90);
    auto const rounded = echelon(scaled);
    BOOST_TEST(rounded.rank == rank);
    BOOST_TEST(rounded.bound == 8 * std::max(rows, columns) * eps);
    for (int i = 0; i < rows; ++i)
      for (int c = 0; c < columns - rank; ++c) {
        double sum = 0;
        for (int k = 0; k < columns; ++k) sum += to_double(m(i, k)) * rounded.kernel()(k, c);
        BOOST_TEST(std::abs(sum) < 1e4 * eps);
      }
  }
}

BOOST_AUTO_TEST_CASE(a_pivot_is_relative_to_the_largest_term_it_was_made_from) {
  // In units of their largest entries the rows are (1, 1/3) and (1/2, 1): the last pivot is 1 - 1/6, of terms
  // 1 and 1/6.
  Matrix<double, 2, 2> A;
  A << 3, 1, 1, 2;
  BOOST_TEST(std::abs(echelon(A).pivot - 5.0 / 6) < 4 * eps);
  // (1, 1/4) and (1, 1/2): 1/2 - 1/4, of which the larger term was 1/2.
  A << 4, 1, 4, 2;
  BOOST_TEST(echelon(A).pivot == 0.5);
  // (1, 1/2) and (1, 1/4): 1/4 - 1/2, of which the larger term was subtracted.
  A << 4, 2, 4, 1;
  BOOST_TEST(echelon(A).pivot == 0.5);
  // Half of what counts as rounding, and twice as much.
  double const bound = 16 * eps;
  A << 1, 1, 1, 1 + bound / 2;
  BOOST_TEST(echelon(A).rank == 1);
  BOOST_TEST(std::abs(echelon(A).pivot / (bound / 2) - 1) < 0.25);
  A(1, 1) = 1 + bound * 2;
  BOOST_TEST(echelon(A).rank == 2);
  // More rows than columns: nothing is left to try.
  Matrix<double, 3, 2> tall;
  tall << 1, 0, 0, 1, 1, 1;
  BOOST_TEST(echelon(tall).rank == 2);
  BOOST_TEST(echelon(tall).pivot == 0);
}

BOOST_AUTO_TEST_CASE(a_constraint_that_is_not_onto_is_refused_at_its_point_with_pivot_and_bound) {
  // Two planes that are the same but for eight units in the last place.
  auto const planes = []<class T>(Matrix<T, 3, 1> const& q) {
    return Matrix<T, 2, 1>(T(q[0] + q[1]), T(q[0] + q[1] * (1 + 8 * eps) - 1.0));
  };
  auto const f = constrained<2>([]<class T>(Matrix<T, 3, 1> const& q) { return T(q[2]); }, planes);
  auto const e = caught<NotRegular>([&] { f.require_regular(Vector<double, 3>(0.5, -2, 3)); });
  BOOST_TEST((e.point == std::vector<double>{0.5, -2, 3}));
  BOOST_TEST(e.bound == 8 * 3 * eps);
  BOOST_TEST(std::abs(e.measured / (8 * eps) - 1) < 0.25);
  BOOST_TEST(std::string(e.what()).find("(0.5, -2, 3)") != std::string::npos, e.what());
}

BOOST_AUTO_TEST_CASE(a_multiplier_of_two_constraints_balances_the_function_in_any_inner_product) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // On two planes in four dimensions the function |q|^2/2 - <c, q> is critical nearest to c. The inner
  // product of the fibres is not diagonal.
  using V4 = Matrix<Q, 4, 1>;
  V4 const c(Q(1), Q(2), Q(-1), Q(3)), one(Q(1), Q(0), Q(2), Q(-1)), two(Q(0), Q(3), Q(1), Q(1));
  auto const over = []<class T>(V4 const& v, Matrix<T, 4, 1> const& q) {
    T sum(0);
    for (int i = 0; i < 4; ++i) sum += q[i] * T(v[i]);
    return sum;
  };
  auto const h = [&]<class T>(Matrix<T, 4, 1> const& q) { return T(q.dot(q) / T(Q(2)) - over(c, q)); };
  auto const planes = [&]<class T>(Matrix<T, 4, 1> const& q) {
    return Matrix<T, 2, 1>(over(one, q), over(two, q));
  };
  Matrix<Q, 2, 2> metric;
  metric << 2, 1, 1, 3;
  auto const f = constrained<2>(h, planes, ConstantMetric<Q, 2>{metric});
  // The point nearest to c, by the normal equations.
  Matrix<Q, 2, 2> gram;
  gram << one.dot(one), one.dot(two), one.dot(two), two.dot(two);
  Matrix<Q, 2, 1> const share = solve_linear(gram, Matrix<Q, 2, 1>(one.dot(c), two.dot(c)), "shares");
  V4 const q = c - one * share[0] - two * share[1];
  auto const lambda = f.multiplier(q);
  // dh = q - c = -share: the multiplier is -metric^-1 share.
  BOOST_TEST((metric * lambda == Matrix<Q, 2, 1>(-share)));
  BOOST_TEST(f.restricted_differential(q).isZero());
  BOOST_TEST(f.augmented_differential(q, lambda).isZero());
  // Elsewhere the differential on the kernel is that along its vectors.
  V4 const elsewhere(Q(1), Q(1), Q(1), Q(1));
  auto const kernel = echelon(f.constraint_derivative(elsewhere)).kernel();
  auto const along = f.restricted_differential(elsewhere);
  BOOST_TEST_REQUIRE(along.size() == 2);
  for (int k = 0; k < 2; ++k) {
    Q sum(0);
    for (int i = 0; i < 4; ++i) sum += kernel(i, k) * (elsewhere[i] - c[i]);
    BOOST_TEST((along[k] == sum));
  }
}

BOOST_AUTO_TEST_SUITE_END()
