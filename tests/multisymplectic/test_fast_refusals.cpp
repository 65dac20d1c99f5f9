// What the optimised implementation of media says of cells that turn inside out, of steps that are too long,
// and of boxes that are none.
#include <boost/test/unit_test.hpp>
#include <cstring>

#include "acoustic.hpp"
#include "actio/fast_media/fast_medium_2d.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using testing::caught;

namespace {
using Place = std::array<double, 2>;
using enum Side;

Place at_rest(Place const& X) { return X; }
Place still(Place const&) { return {0, 0}; }

/// A solid that does not resist collapse, whose left side is thrown against the right.
FastMedium2d<FastStVenantKirchhoff> thrown(FastOptions const& options = {}) {
  FastBox2d const box{{20, 12}, {0.1, 0.1}, {fixed, fixed}, {free, free}};
  return {FastStVenantKirchhoff{0.3, 0.2},
          box,
          0.02,
          1,
          at_rest,
          [](Place const& X) {
            return Place{X[0] < 0.8 ? 1.5 : 0, 0.1 * X[1]};
          },
          options};
}
bool same(std::vector<Place> const& x, std::vector<Place> const& y) {
  return x.size() == y.size() && !std::memcmp(x.data(), y.data(), x.size() * sizeof(Place));
}
double least_jacobian(std::vector<Place> const& x, FastBox2d const& box) {
  double least = HUGE_VAL;
  int const n = box.nodes(0);
  auto const at = [&](int i, int j) { return x[static_cast<std::size_t>(j * n + i)]; };
  for (int j = 0; j < box.cells[1]; ++j)
    for (int i = 0; i < box.cells[0]; ++i)
      for (int k = 0; k < 4; ++k) {
        int const a = k % 2, b = k / 2;
        Place const o = at(i, j + b), p = at(i + 1, j + b), q = at(i + a, j), r = at(i + a, j + 1);
        least = std::min(least, ((p[0] - o[0]) * (r[1] - q[1]) - (p[1] - o[1]) * (r[0] - q[0])) /
                                    (box.spacing[0] * box.spacing[1]));
      }
  return least;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_refusals)

BOOST_AUTO_TEST_CASE(a_cell_about_to_turn_inside_out_is_refused_with_the_state_before) {
  auto medium = thrown();
  CellInverts const found = caught<CellInverts>([&] { medium.step(1000); });
  BOOST_TEST(found.step > 1);
  BOOST_TEST(medium.steps() == found.step - 1);
  BOOST_TEST(found.measured <= 0);
  BOOST_TEST(least_jacobian(medium.places(), medium.box()) > 0);
  // It is the state of a run that stops there, to the last bit, and the next step is refused as well.
  auto other = thrown();
  other.step(found.step - 1);
  BOOST_TEST(same(other.places(), medium.places()));
  BOOST_TEST(same(other.velocities_half_a_step_ago(), medium.velocities_half_a_step_ago()));
  for (auto* one : {&medium, &other}) {
    CellInverts const again = caught<CellInverts>([&] { one->step(); });
    BOOST_TEST(again.step == found.step);
    BOOST_TEST((again.cell == found.cell && again.measured == found.measured));
  }
  BOOST_TEST(std::string(found.what()).find("inside out") != std::string::npos);
  BOOST_TEST(found.time_step == 0.02);
  BOOST_TEST(found.largest_step > 0.02);
}

BOOST_AUTO_TEST_CASE(threads_and_levels_find_the_same_cell) {
  auto medium = thrown();
  CellInverts const found = caught<CellInverts>([&] { medium.step(1000); });
  for (int const threads : {1, 2, 5})
    for (int const levels : {1, 3, 8}) {
      auto other = thrown({threads, levels});
      CellInverts const again = caught<CellInverts>([&] { other.step(1000); });
      BOOST_TEST((again.step == found.step && again.cell == found.cell && again.measured == found.measured));
      BOOST_TEST(same(other.places(), medium.places()));
    }
}

// The end of a call is a place where nobody looks at the Jacobians that follow, unless somebody does.
BOOST_AUTO_TEST_CASE(no_call_ends_with_a_cell_inside_out) {
  auto medium = thrown();
  CellInverts const found = caught<CellInverts>([&] { medium.step(1000); });
  for (long const last : {found.step - 1, found.step}) {
    auto other = thrown();
    bool refused = false;
    try {
      other.step(last);
    } catch (CellInverts const&) {
      refused = true;
    }
    BOOST_TEST(refused == (last == found.step));
    BOOST_TEST(least_jacobian(other.places(), other.box()) > 0);
  }
}

// Linearised at rest, with c = 2: the largest frequency of the discrete dispersion relation is that of
// neighbours which move against each other along the shorter edge, 2c/h, so that h/c is the longest step. The
// largest frequency is found within a per cent.
BOOST_AUTO_TEST_CASE(the_longest_step_is_that_of_the_discrete_dispersion_relation) {
  for (auto const& [h1, h2] : {std::pair{0.1, 0.1}, {0.1, 0.13}, {0.2, 0.05}}) {
    FastBox2d const box{{12, 10}, {h1, h2}, {periodic, periodic}, {periodic, periodic}};
    FastMedium2d medium(FastFluid{testing::Acoustic{2}}, box, 0.001, 1, at_rest, still);
    BOOST_TEST(medium.largest_step() == std::min(h1, h2) / 2, boost::test_tools::tolerance(0.01));
  }
}
template <class Medium>
void is_stable_up_to_the_longest_step(Medium const& law) {
  FastBox2d const box{{12, 9}, {0.1, 0.12}, {sliding, sliding}, {sliding, sliding}};
  auto const place = [](Place const& X) {
    return Place{X[0] + 1e-6 * std::sin(31 * X[0] * X[1]) * X[0] * (X[0] - 1.2), X[1]};
  };
  double const longest = FastMedium2d(law, box, 1e-3, 1, at_rest, still).largest_step();
  FastMedium2d below(law, box, 0.97 * longest, 1, place, still);
  below.step(2000);
  BOOST_TEST(least_jacobian(below.places(), box) > 0.999);
  // The bound at the start is that of a window, from above within three per cent.
  auto const error = caught<OutsideDomain>([&] { FastMedium2d(law, box, 1.05 * longest, 1, place, still); });
  BOOST_TEST(error.measured == 1.05 * longest);
  BOOST_TEST(error.bound >= 0.99 * longest);
  BOOST_TEST(error.bound <= 1.04 * longest);
}
BOOST_AUTO_TEST_CASE(steps_are_stable_below_the_longest_and_refused_beyond) {
  is_stable_up_to_the_longest_step(FastFluid{PolytropicByRoots<1, 2>{0.5}});
  is_stable_up_to_the_longest_step(FastStVenantKirchhoff{0.6, 0.2});
  is_stable_up_to_the_longest_step(neo_hookean(0.6, 0.2));
}

BOOST_AUTO_TEST_CASE(what_is_no_medium_is_refused_at_once) {
  FastFluid const gas{PolytropicByRoots<1, 2>{1}};
  FastBox2d const box{{4, 4}, {0.1, 0.1}};
  auto const with = [&](FastBox2d const& b, double dt, double density, auto const& place) {
    FastMedium2d(gas, b, dt, density, place, still);
  };
  CHECK_REFUSED(with({{0, 4}, {0.1, 0.1}}, 0.01, 1, at_rest), OutsideDomain);
  CHECK_REFUSED(with({{4, 4}, {0.1, -0.1}}, 0.01, 1, at_rest), OutsideDomain);
  CHECK_REFUSED(with({{4, 4}, {0.1, NAN}}, 0.01, 1, at_rest), NotFinite);
  CHECK_REFUSED(with({{4, 4}, {0.1, 0.1}, {periodic, Side::free}}, 0.01, 1, at_rest), OutsideDomain);
  CHECK_REFUSED(with({{4, 4}, {0.1, 0.1}, {fixed, moved}}, 0.01, 1, at_rest), OutsideDomain);
  CHECK_REFUSED(with(box, 0, 1, at_rest), OutsideDomain);
  CHECK_REFUSED(with(box, NAN, 1, at_rest), NotFinite);
  CHECK_REFUSED(with(box, 0.01, -1, at_rest), OutsideDomain);
  CHECK_REFUSED(with(box, 0.01, 1,
                     [](Place const& X) {
                       return Place{X[0], std::sqrt(0.2 - X[1])};
                     }),
                NotFinite);
  CHECK_REFUSED(with(box, 0.01, 1,
                     [](Place const& X) {
                       return Place{X[0], X[1] * (0.35 - X[1])};
                     }),
                CellInverts);
  FastMedium2d medium(gas, box, 0.01, 1, at_rest, still);
  CHECK_REFUSED(medium.step(-1), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
