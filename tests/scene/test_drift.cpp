#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "program/run/drift.hpp"
#include "refused.hpp"

using actio::Error;
using actio::scene::Drift, actio::scene::CheckpointStream;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The drift of one vector over rows.
double drift_of(std::vector<std::vector<double>> const& rows) {
  Drift drift({{"q", 0, rows.front().size()}});
  for (auto const& row : rows) drift.see(row);
  BOOST_TEST(drift.worst() == drift.entries().front().relative);
  return drift.worst();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(drift)

BOOST_AUTO_TEST_CASE(it_is_the_largest_distance_from_the_start_over_the_length_there) {
  BOOST_TEST(drift_of({{3, 4, 0}}) == 0);
  BOOST_TEST(drift_of({{3, 4, 0}, {3, 4, 5}, {3, 4, 1}}) == 1);
  BOOST_TEST(drift_of({{-2}, {-1}, {-2.5}}) == 0.5);
}

BOOST_AUTO_TEST_CASE(it_does_not_depend_on_the_unit_however_large_or_small) {
  double const one = drift_of({{3, 4, 1}, {3.25, 4, -1}, {3, 4.5, 1}});
  for (int power : {-1060, -500, -480, 400, 500, 1000}) {
    auto const in = [power](double x) { return std::ldexp(x, power); };
    // Two lengths and a quotient, each with a few roundings; next to 1e-308 numbers have fewer digits.
    double const tolerance = 16 * eps * one + (power < -1022 ? std::ldexp(4, -1074 - power) : 0);
    BOOST_TEST(
        std::abs(drift_of({{in(3), in(4), in(1)}, {in(3.25), in(4), in(-1)}, {in(3), in(4.5), in(1)}}) -
                 one) <= tolerance,
        "2^" << power);
  }
}

BOOST_AUTO_TEST_CASE(from_zero_it_is_measured_by_the_largest_seen) {
  BOOST_TEST(drift_of({{0, 0}, {0, 0}}) == 0);
  BOOST_TEST(drift_of({{0, 0}, {3, 4}, {1, 0}}) == 1);
  BOOST_TEST(drift_of({{0}, {1e-320}}) == 1);
}

BOOST_AUTO_TEST_CASE(terms_that_overflow_are_no_unit) {
  using Unit = actio::scene::QuantityGraph::Unit;
  Drift out({{"q", 0, 1}});
  Unit const unit{std::numeric_limits<double>::infinity(), 0, 0};
  for (double const value : {2.0, 3.0}) out.see({&value, 1}, {&unit, 1});
  BOOST_TEST(out.worst() == 0.5);
}

BOOST_AUTO_TEST_CASE(of_what_is_at_rest_it_is_measured_by_its_own_pace) {
  using Unit = actio::scene::QuantityGraph::Unit;
  auto const drift = [](std::vector<double> const& values, std::vector<double> const& terms) {
    Drift out({{"q", 0, 1}});
    for (std::size_t k = 0; k < values.size(); ++k) {
      Unit const unit{terms[k], 1e-12, 4};
      out.see({&values[k], 1}, {&unit, 1});
    }
    return out.entries().front();
  };
  // Terms of rounding alone: the unit is that of rest.
  BOOST_TEST(drift({0, 1e-17}, {0, 1e-16}).unit == 4);
  BOOST_TEST(drift({0, 1e-17}, {0, 1e-16}).relative == 1e-17 / 4);
  // Once it moves the unit is what it is made of, however slow that is, from whatever start.
  BOOST_TEST(drift({0, 1e-11}, {0, 2e-11}).relative == 0.5);
  BOOST_TEST(drift({0, 1, 0}, {0, 8, 0}).relative == 0.125);
}

BOOST_AUTO_TEST_CASE(quantities_have_each_their_own) {
  Drift drift({{"a", 0, 1}, {"b", 2, 2}});
  drift.see(std::vector<double>{1, 100, 3, 4});
  drift.see(std::vector<double>{1.5, 200, 3, 4});
  BOOST_TEST(drift.entries()[0].relative == 0.5);
  BOOST_TEST(drift.entries()[1].relative == 0);
  BOOST_TEST(drift.worst() == 0.5);
}

BOOST_AUTO_TEST_CASE(it_goes_on_where_it_was) {
  std::vector<std::vector<double>> const rows{{1, 2, 3}, {1.1, 2, 3}, {1, 2, 3.0001}, {1, 1.9, 3}};
  for (std::size_t cut = 0; cut <= rows.size(); ++cut) {
    Drift first({{"q", 0, 3}}), second({{"q", 0, 3}});
    for (std::size_t k = 0; k < cut; ++k) first.see(rows[k]);
    CheckpointStream saved;
    first.remember(saved);
    CheckpointStream restored(saved.bytes());
    second.remember(restored);
    restored.end();
    for (std::size_t k = cut; k < rows.size(); ++k) second.see(rows[k]);
    BOOST_TEST(second.worst() == drift_of(rows));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(checkpoint_stream)

BOOST_AUTO_TEST_CASE(what_is_written_is_read_back_and_nothing_is_left) {
  CheckpointStream stream;
  double x = 0.1;
  std::vector<double> list(1000, 0.3), none;
  stream(x, list, none);
  double y = 0;
  std::vector<double> again, empty;
  CheckpointStream back(stream.bytes());
  back(y, again);
  CHECK_REFUSED(back.end(), Error);
  back(empty);
  back.end();
  BOOST_TEST((x == y && again == list && empty.empty()));
}

BOOST_AUTO_TEST_CASE(it_is_not_trusted) {
  CheckpointStream stream;
  std::vector<double> list(3, 0.3);
  stream(list);
  for (std::size_t size = 0; size < stream.bytes().size(); ++size) {
    std::vector<double> back;
    CheckpointStream cut(stream.bytes().substr(0, size));
    CHECK_REFUSED(cut(back), Error);
  }
  // A list of another size; lists that would be longer than memory, and so long that their bytes have no
  // number.
  std::vector<double> other(4);
  CheckpointStream whole(stream.bytes());
  CHECK_REFUSED(whole(other), Error);
  for (std::size_t claimed : {std::size_t{4}, std::size_t{1} << 40, std::size_t{1} << 61, ~std::size_t{0}}) {
    std::string bytes = stream.bytes();
    std::memcpy(bytes.data(), &claimed, sizeof claimed);
    std::vector<double> back;
    CheckpointStream lying(bytes);
    CHECK_REFUSED(lying(back), Error);
  }
}

BOOST_AUTO_TEST_SUITE_END()
