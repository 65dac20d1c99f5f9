// Boxes of the optimised implementation: what sides make of the nodes there, periods, and what is no box.
#include <boost/test/unit_test.hpp>

#include "actio/fast_media/fast_box_3d.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using testing::caught;

namespace {
using enum Side;
}

BOOST_AUTO_TEST_SUITE(fast_boxes)

BOOST_AUTO_TEST_CASE(sides_hold_what_they_say_and_halve_the_measure_of_their_nodes) {
  FastBox2d const flat{{3, 4}, {0.5, 0.25}, {fixed, sliding}, {sliding, Side::free}, {2, -3}};
  BOOST_TEST(flat.count() == 20);
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 3; ++i) {
      double const area = 0.125 * (i == 0 || i == 3 ? 0.5 : 1) * (j == 0 || j == 4 ? 0.5 : 1);
      BOOST_TEST(flat.response({i, j}, 0) == (i == 0 || i == 3 ? 0 : 1 / area));
      BOOST_TEST(flat.response({i, j}, 1) == (i == 0 || j == 0 ? 0 : 1 / area));
      BOOST_TEST((flat.at({i, j}) == std::array{2 + 0.5 * i, -3 + 0.25 * j}));
    }
  FastBox3d solid{{2, 3, 4}, {0.5, 0.25, 0.125}, {}, {1, 2, 3}};
  solid.ends(0) = {sliding, Side::free}, solid.ends(1) = {periodic, periodic},
  solid.ends(2) = {Side::free, fixed};
  BOOST_TEST(solid.count() == 3 * 3 * 5);
  for (int k = 0; k <= 4; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i <= 2; ++i) {
        double const volume = 0.015625 * (i == 0 || i == 2 ? 0.5 : 1) * (k == 0 || k == 4 ? 0.5 : 1);
        for (int c = 0; c < 3; ++c)
          BOOST_TEST(solid.response({i, j, k}, c) == (k == 4 || (i == 0 && c == 0) ? 0 : 1 / volume));
        BOOST_TEST((solid.at({i, j, k}) == std::array{1 + 0.5 * i, 2 + 0.25 * j, 3 + 0.125 * k}));
      }
}

BOOST_AUTO_TEST_CASE(a_period_that_is_not_given_is_the_length_of_the_box) {
  FastBox2d flat{{3, 4}, {0.5, 0.25}};
  auto const of_plane = [&](int d) { return std::array{flat.shift(d).x, flat.shift(d).y}; };
  BOOST_TEST((of_plane(0) == std::array{1.5, 0.0} && of_plane(1) == std::array{0.0, 1.0}));
  flat.period = {{{0, 1.25}, {-0.75, 0}}};
  BOOST_TEST((of_plane(0) == flat.period[0] && of_plane(1) == flat.period[1]));
  FastBox3d solid{{2, 3, 4}, {0.5, 0.25, 0.125}};
  auto const of_space = [&](int d) {
    return std::array{solid.shift(d).x, solid.shift(d).y, solid.shift(d).z};
  };
  BOOST_TEST((of_space(0) == std::array{1.0, 0.0, 0.0} && of_space(1) == std::array{0.0, 0.75, 0.0} &&
              of_space(2) == std::array{0.0, 0.0, 0.5}));
  for (std::size_t i = 0; i < 3; ++i) {
    solid.period = {};
    for (std::size_t d = 0; d < 3; ++d) solid.period[d][(i + d) % 3] = 0.7;
    for (std::size_t d = 0; d < 3; ++d) BOOST_TEST((of_space(static_cast<int>(d)) == solid.period[d]));
  }
}

namespace {
template <class Box>
void refuses(Box const& box, double measured, double bound, char const* direction) {
  auto const error = caught<OutsideDomain>([&] { box.examine(); });
  BOOST_TEST((error.measured == measured && error.bound == bound));
  BOOST_TEST(std::string(error.what()).find(direction) != std::string::npos);
}
}  // namespace

BOOST_AUTO_TEST_CASE(a_refused_box_is_told_what_is_wrong_along_which_direction) {
  FastBox3d const box{{1, 1, 1}, {0.5, 0.25, 0.125}};
  box.examine();
  char const* const names[] = {"direction 1", "direction 2", "direction 3"};
  for (std::size_t d = 0; d < 3; ++d) {
    FastBox3d other = box;
    other.cells[d] = 0;
    refuses(other, 0, 1, names[d]);
    for (double const length : {0.0, -0.5}) {
      other = box, other.spacing[d] = length;
      refuses(other, length, 0, names[d]);
    }
    for (std::size_t end = 0; end < 2; ++end) {
      other = box, other.sides[d][end] = periodic;
      refuses(other, 1, 2, names[d]);
    }
    for (double const none : {static_cast<double>(NAN), HUGE_VAL}) {
      other = box, other.spacing[d] = none;
      CHECK_REFUSED(other.examine(), NotFinite);
      other = box, other.origin[d] = none;
      CHECK_REFUSED(other.examine(), NotFinite);
      for (std::size_t i = 0; i < 3; ++i) {
        other = box, other.period[d][i] = none;
        CHECK_REFUSED(other.examine(), NotFinite);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
