// What Casimirs are found with: monomials, conditions with few terms, whole coefficients, and the defect.
#include <boost/test/unit_test.hpp>

#include "actio/any_group/invariants.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::systems;
using systems::detail::SparseElimination, systems::detail::SparseRow;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using Terms = std::vector<Casimir::Term>;

Casimir of(Terms terms) { return {terms.front().j < 0 ? 1 : 2, std::move(terms), {"x", "y", "z"}}; }
std::vector<double> whole(std::vector<double> const& coefficients) {
  Terms terms;
  for (double const c : coefficients) terms.push_back({0, -1, c});
  std::vector<double> out;
  for (auto const& t : systems::detail::with_whole_coefficients(of(terms)).terms)
    out.push_back(t.coefficient);
  return out;
}
/// Rows with few entries, small and whole, and multiples of rows among them.
std::vector<SparseRow> some_rows(Draw& draw, int count, int columns) {
  std::vector<SparseRow> rows;
  auto const below = [&](int n) { return static_cast<int>((draw.number<double>() + 1) * 500) % n; };
  for (int k = 0; k < count; ++k) {
    SparseRow row;
    for (int e = 0; e < 4; ++e) row[below(columns)] = below(2) ? 1 + below(3) : -1 - below(3);
    if (k % 4 == 3)
      for (auto const& [column, x] : rows[static_cast<std::size_t>(k - 2)]) row[column] += 2 * x;
    std::erase_if(row, [](auto const& entry) { return entry.second == 0; });
    rows.push_back(row);
    if (k % 5 == 4) {
      SparseRow again = rows[static_cast<std::size_t>(k - 3)];
      for (auto& [column, x] : again) x *= -3;
      rows.push_back(again);
    }
  }
  return rows;
}
/// The rank over the rationals.
int rank_of(std::vector<SparseRow> const& rows, int columns) {
  WithArithmetic const exactly(Arithmetic::rationals());
  std::vector<std::vector<Number>> m;
  for (auto const& row : rows) {
    m.emplace_back(static_cast<std::size_t>(columns), Number(0));
    for (auto const& [column, x] : row)
      m.back()[static_cast<std::size_t>(column)] = Number(static_cast<int>(x));
  }
  std::size_t rank = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(columns) && rank < m.size(); ++c) {
    std::size_t pivot = rank;
    while (pivot < m.size() && m[pivot][c] == 0) ++pivot;
    if (pivot == m.size()) continue;
    std::swap(m[pivot], m[rank]);
    for (std::size_t i = rank + 1; i < m.size(); ++i) {
      Number const factor = m[i][c] / m[rank][c];
      for (std::size_t k = c; k < m[i].size(); ++k) m[i][k] -= factor * m[rank][k];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(casimir_parts)

BOOST_AUTO_TEST_CASE(monomials_are_numbered_without_gaps_and_their_factors_come_back) {
  for (int const d : {1, 2, 5, 9}) {
    systems::detail::Monomials const monomials{d};
    int next = 0;
    for (int i = 0; i < d; ++i)
      for (int j = i; j < d; ++j, ++next) {
        BOOST_TEST(monomials.number(i, j) == next);
        BOOST_TEST(monomials.number(j, i) == next);
        BOOST_TEST((monomials.factors(next) == std::pair(i, j)));
      }
    BOOST_TEST(monomials.count(2) == next);
    BOOST_TEST(monomials.count(1) == d);
  }
}

BOOST_AUTO_TEST_CASE(coefficients_in_whole_proportions_become_whole_and_the_first_positive) {
  using List = std::vector<double>;
  BOOST_TEST((whole({-0.5, 1.25}) == List{2, -5}));
  BOOST_TEST((whole({0.1, -0.3}) == List{1, -3}));
  BOOST_TEST((whole({4, 6}) == List{2, 3}));
  // Sixtieths are the finest that are tried, and a million is the largest.
  BOOST_TEST((whole({1, 61.0 / 60}) == List{60, 61}));
  BOOST_TEST((whole({-1, 62.0 / 61}) == List{1, -62.0 / 61}));
  BOOST_TEST((whole({1, 999999}) == List{1, 999999}));
  BOOST_TEST((whole({0.5, 1000001}) == List{0.5, 1000001}));
}

BOOST_AUTO_TEST_CASE(values_and_texts_are_those_of_the_terms) {
  Casimir const linear = of({{0, -1, -1}, {1, -1, 2}, {2, -1, -0.5}}),
                quadratic = of({{0, 0, 3}, {0, 2, -1}, {1, 2, 1}});
  Vector<double, 3> const mu(2, 3, 5);
  BOOST_TEST(linear.evaluate(mu) == -2 + 6 - 2.5);
  BOOST_TEST(quadratic.evaluate(mu) == 3 * 4 - 10 + 15);
  BOOST_TEST(linear.text() == "-x + 2*y - 0.5*z");
  BOOST_TEST(quadratic.text() == "3*x^2 - x*z + y*z");
}

BOOST_AUTO_TEST_CASE(the_defect_is_the_largest_coefficient_of_a_bracket) {
  // On SE(2), {w, p_1} = p_2 and {w, p_2} = -p_1: the bracket of a p_1^2 + b p_2^2 with w is 2 (b - a) p_1
  // p_2.
  auto const defect = [](double a, double b, double unit) {
    auto basis = named_algebra("SE(2)").basis;
    basis[0] *= unit;
    return systems::detail::defect_of_casimir(spanned_algebra(basis), of({{1, 1, a}, {2, 2, b}}));
  };
  BOOST_TEST(defect(1, 1, 1) == 0);
  BOOST_TEST(defect(1, 3, 1) == 4.0 / 3);
  BOOST_TEST(defect(-3, 1, 1) == 8.0 / 3);
  // Relative to the structure constants.
  BOOST_TEST(std::abs(defect(1, 3, 8) - 4.0 / 3) < 8 * eps);
  // w + 5 p_1 has the brackets -p_2 and p_1 with the shifts, and 5 p_2 with w.
  BOOST_TEST(systems::detail::defect_of_casimir(named_algebra("SE(2)"), of({{0, -1, 1}, {1, -1, 5}})) == 1);
  BOOST_TEST(systems::detail::defect_of_casimir(named_algebra("SE(2)"), of({{0, -1, 2}})) == 1);
  // w p_1 has w p_2 with w and -p_1 p_2 and p_1^2 with the shifts.
  BOOST_TEST(systems::detail::defect_of_casimir(named_algebra("SE(2)"), of({{0, 1, 2}})) == 1);
}

BOOST_AUTO_TEST_CASE(rows_of_few_entries_are_reduced_to_echelon_form) {
  Draw draw(21);
  for (int const columns : {6, 11, 23}) {
    auto const given = some_rows(draw, columns, columns);
    SparseElimination span(columns);
    int added = 0;
    for (auto const& row : given) {
      double const distance = span.add(row);
      added += distance > 0;
      BOOST_TEST(distance >= 0);
    }
    int const rank = rank_of(given, columns);
    BOOST_TEST_REQUIRE(static_cast<int>(span.rows().size()) == rank);
    BOOST_TEST(added == rank);
    // Nothing is left of a row that was added, and a row that was not changes nothing.
    for (auto const& row : given) BOOST_TEST(span.add(row) == 0);
    auto const basis = span.null_space();
    BOOST_TEST(static_cast<int>(basis.size()) == columns - rank);
    for (auto const& x : basis)
      for (auto const& row : given) {
        double sum = 0, size = 0;
        for (auto const& [column, y] : row)
          if (auto const at = x.find(column); at != x.end())
            sum += y * at->second, size += std::abs(y * at->second);
        // As many eliminations as rows, each a few roundings of entries that stay moderate.
        BOOST_TEST(std::abs(sum) <= 64 * columns * eps * (1 + size));
      }
  }
}

BOOST_AUTO_TEST_CASE(a_row_is_as_far_from_the_span_as_what_is_left_of_its_largest_entry) {
  SparseElimination span(3);
  BOOST_TEST(span.add({{0, 2}, {1, -2}}) == 1);
  // (4, 0, 1) less 2 (2, -2, 0) is (0, 4, 1); with the last of the largest entries as pivot it is (4, 0, 1).
  BOOST_TEST(span.add({{0, 4}, {2, 1}}, 1.5) == 1);
  BOOST_TEST(span.rows().size() == 1u);
  BOOST_TEST(span.add({{0, 1}, {1, -1}, {2, 0.125}}, 0.25) == 0.125);
  BOOST_TEST(span.rows().size() == 1u);
  BOOST_TEST(span.add({{0, 1}, {1, -1}, {2, 0.125}}, 0.125) == 0.125);
  BOOST_TEST_REQUIRE(span.rows().size() == 2u);
  BOOST_TEST((span.rows()[0] == SparseRow{{0, -1}, {1, 1}}));
  BOOST_TEST((span.rows()[1] == SparseRow{{2, 1}}));
  auto const left = span.null_space();
  BOOST_TEST_REQUIRE(left.size() == 1u);
  BOOST_TEST((left[0] == SparseRow{{0, 1}, {1, 1}}));
}

BOOST_AUTO_TEST_SUITE_END()
