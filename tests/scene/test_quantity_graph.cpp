// A run evaluates what it was asked for and what that needs, each once a row, and nothing else.
#include <algorithm>
#include <random>

#include <boost/test/unit_test.hpp>

#include "program/registry/quantity.hpp"

using namespace actio::scene;

namespace {

constexpr unsigned seed = 1971;

/// Quantities q0, q1, ... of which each needs some before it; the value of each is its number and the sum of
/// what it needs, so that a missed or a stale one shows.
struct Web {
  std::vector<Quantity> known;
  std::vector<std::vector<std::size_t>> needs;

  Web(std::size_t size, std::mt19937& random) : needs(size) {
    for (std::size_t i = 0; i < size; ++i) {
      std::vector<std::string> names;
      for (std::size_t j = 0; j < i; ++j)
        if (random() % 3 == 0) needs[i].push_back(j), names.push_back("q" + std::to_string(j));
      known.push_back(Quantity{"q" + std::to_string(i), Quantity::Kind::scalar, "", "", ""}.from(names));
    }
  }
  QuantityGraph graph(double const& state) const {
    QuantityGraph out(known);
    for (std::size_t i = 0; i < known.size(); ++i)
      out.define(known[i].name, {""}, [i, &state, n = needs[i].size()](auto values, double* value) {
        *value = static_cast<double>(i) + state;
        for (std::size_t k = 0; k < n; ++k) *value += *values[k];
      });
    return out;
  }
  double value(std::size_t i, double state) const {
    double out = static_cast<double>(i) + state;
    for (auto const j : needs[i]) out += value(j, state);
    return out;
  }
  void reach(std::size_t i, std::vector<bool>& reached) const {
    if (reached[i]) return;
    reached[i] = true;
    for (auto const j : needs[i]) reach(j, reached);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(quantity_graph)

BOOST_AUTO_TEST_CASE(what_is_needed_is_evaluated_once_a_row_and_nothing_else_ever) {
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 300; ++k) {
    Web const web(1 + random() % 12, random);
    double state = 0;
    QuantityGraph graph = web.graph(state);
    std::vector<std::string> asked;
    std::vector<std::size_t> numbers;
    std::vector<bool> reached(web.known.size());
    for (std::size_t i = web.known.size(); i-- > 0;)
      if (random() % 3 == 0) asked.push_back(web.known[i].name), numbers.push_back(i), web.reach(i, reached);
    graph.ask(asked);
    BOOST_REQUIRE_EQUAL(graph.row_size(), asked.size());
    long const rows = 1 + static_cast<long>(random() % 5);
    std::vector<double> row(asked.size());
    for (long r = 0; r < rows; ++r) {
      state = static_cast<double>(r) * 1000;
      graph.evaluate(row);
      for (std::size_t i = 0; i < asked.size(); ++i)
        BOOST_REQUIRE_EQUAL(row[i], web.value(numbers[i], state));
    }
    auto const counts = graph.counts();
    for (std::size_t i = 0; i < counts.size(); ++i) {
      BOOST_REQUIRE_EQUAL(counts[i].evaluations, reached[i] ? rows : 0);
      BOOST_REQUIRE_EQUAL(graph.needed(counts[i].name), reached[i]);
    }
  }
}

BOOST_AUTO_TEST_CASE(columns_are_in_the_order_of_asking) {
  using Kind = Quantity::Kind;
  QuantityGraph graph({{"a", Kind::vector, "", "", ""},
                       Quantity{"b", Kind::list, "", "", ""}.from({"a"}),
                       {"c", Kind::scalar, "", "", ""}});
  graph.conserve([](std::string const& name) { return name != "c"; });
  graph.define("a", column_ends(Kind::vector), [](auto, double* v) { v[0] = 1, v[1] = 2, v[2] = 3; });
  graph.define("b", numbered(2, 4, 2),
               [](auto needs, double* v) { v[0] = 10 * needs[0][0], v[1] = 10 * needs[0][2]; });
  graph.define("c", {""}, [](auto, double* v) { *v = 7; });
  graph.ask({"c", "b", "a"});
  BOOST_TEST(graph.columns() == (std::vector<std::string>{"c", "b_2", "b_4", "a_x", "a_y", "a_z"}),
             boost::test_tools::per_element());
  std::vector<double> row(graph.row_size());
  graph.evaluate(row);
  BOOST_TEST(row == (std::vector<double>{7, 10, 30, 1, 2, 3}), boost::test_tools::per_element());
  // A vector is conserved as a whole, a list one by one.
  auto const conserved = graph.conserved();
  BOOST_REQUIRE(conserved.size() == 3u);
  BOOST_TEST((conserved[0].name == "b_2" && conserved[0].first == 1 && conserved[0].size == 1));
  BOOST_TEST((conserved[1].name == "b_4" && conserved[1].first == 2 && conserved[1].size == 1));
  BOOST_TEST((conserved[2].name == "a" && conserved[2].first == 3 && conserved[2].size == 3));
}

BOOST_AUTO_TEST_CASE(matrices_of_ten_and_more_part_their_indices) {
  using Kind = Quantity::Kind;
  BOOST_TEST(column_ends(Kind::skew, 3) == (std::vector<std::string>{"_12", "_13", "_23"}),
             boost::test_tools::per_element());
  BOOST_TEST(column_ends(Kind::matrix, 2) == (std::vector<std::string>{"_11", "_12", "_21", "_22"}),
             boost::test_tools::per_element());
  BOOST_TEST(column_ends(Kind::skew, 10)[8] == "_1_10");
  for (int n = 1; n < 13; ++n) {
    auto ends = column_ends(Kind::matrix, n);
    std::sort(ends.begin(), ends.end());
    BOOST_TEST((std::adjacent_find(ends.begin(), ends.end()) == ends.end()));
  }
}

BOOST_AUTO_TEST_CASE(a_graph_that_is_moved_still_knows_its_nodes) {
  double state = 1;
  std::mt19937 random(seed);
  Web const web(6, random);
  QuantityGraph first = web.graph(state);
  first.ask({"q5"});
  QuantityGraph moved = std::move(first);
  QuantityGraph last = std::move(moved);
  double value = 0;
  last.evaluate({&value, 1});
  BOOST_TEST(value == web.value(5, state));
}

BOOST_AUTO_TEST_SUITE_END()
