#include <boost/test/unit_test.hpp>

#include <cmath>

#include "program/pictures/envelope.hpp"
#include "program/pictures/key_frames.hpp"

using actio::scene::Envelope, actio::scene::KeyFrames;

BOOST_AUTO_TEST_SUITE(overview)

BOOST_AUTO_TEST_CASE(an_envelope_keeps_a_short_curve_whole) {
  Envelope envelope;
  for (std::size_t i = 0; i < Envelope::most_pieces; ++i)
    envelope.add(static_cast<double>(i), std::sin(static_cast<double>(i)));
  BOOST_TEST(envelope.rows_per_piece() == 1);
  auto const points = envelope.points();
  BOOST_TEST_REQUIRE(points.size() == Envelope::most_pieces);
  for (std::size_t i = 0; i < points.size(); ++i) BOOST_TEST(points[i].value == std::sin(points[i].t));
}

BOOST_AUTO_TEST_CASE(an_envelope_loses_no_peak_wherever_it_is) {
  for (long const peak : {0L, 1L, 2047L, 2048L, 4095L, 4096L, 77'777L, 99'998L, 99'999L}) {
    Envelope envelope;
    for (long i = 0; i < 100'000; ++i)
      envelope.add(static_cast<double>(i), i == peak            ? 5
                                           : i == 99'999 - peak ? -7
                                                                : std::cos(0.01 * static_cast<double>(i)));
    BOOST_TEST(envelope.pieces().size() <= Envelope::most_pieces);
    BOOST_TEST(envelope.highest() == 5);
    BOOST_TEST(envelope.lowest() == -7);
    auto const points = envelope.points();
    BOOST_TEST(points.front().t == 0);
    BOOST_TEST(points.back().t == 99'999);
    for (std::size_t i = 1; i < points.size(); ++i)
      if (!(points[i - 1].t < points[i].t)) BOOST_ERROR("points are out of order");
    bool found = false;
    for (auto const& p : points) found |= p.t == static_cast<double>(peak) && p.value == 5;
    BOOST_TEST(found, "the peak at " << peak << " is at another time");
  }
}

BOOST_AUTO_TEST_CASE(pieces_follow_one_another_and_hold_equally_many_rows) {
  Envelope envelope;
  for (long i = 0; i < 30'000; ++i) envelope.add(static_cast<double>(i), 0);
  auto const& pieces = envelope.pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    BOOST_TEST(pieces[i].first.t == static_cast<double>(i) * static_cast<double>(envelope.rows_per_piece()));
    BOOST_TEST(pieces[i + 1].first.t == pieces[i].last.t + 1);
  }
}

BOOST_AUTO_TEST_CASE(an_excerpt_holds_every_row_of_a_stride_as_long_as_neighbours_are_near) {
  for (double const most : {1e9, 7.0, 1.0, 0.5}) {
    KeyFrames key_frames([most](auto const& a, auto const& b) { return b[0] - a[0] <= most; });
    for (int i = 0; i < 50'000; ++i) key_frames.add(std::vector<double>{static_cast<double>(i)});
    auto const& rows = key_frames.rows();
    BOOST_TEST(rows.size() <= KeyFrames::most_rows);
    BOOST_TEST(2 * rows.size() >= KeyFrames::most_rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      BOOST_TEST_REQUIRE(rows[i].size() == 1u);
      if (rows[i][0] != static_cast<double>(i) * static_cast<double>(key_frames.stride()))
        BOOST_ERROR("row " << i << " of the key frames is row " << rows[i][0]);
    }
    // Strides are powers of two: of seven, four is the longest that is near enough.
    BOOST_TEST(key_frames.stride() == (most > 1e3 ? 32 : most > 4 ? 4 : 1));
    BOOST_TEST(key_frames.beginning_only() == (most < 1e3));
  }
}

BOOST_AUTO_TEST_SUITE_END()
