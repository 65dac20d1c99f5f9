// The plain road of media on meshes: held to the fast road, and what it says of itself.
#include <boost/test/unit_test.hpp>

#include "actio/multisymplectic/fast_medium_2d.hpp"
#include "actio/multisymplectic/medium_on_mesh.hpp"

using namespace actio;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Plane2 = std::array<double, 2>;

Plane2 bent(Plane2 const& X) { return {X[0] + 0.03 * X[0] * X[1], X[1] - 0.02 * X[0] * X[0]}; }
Plane2 turning(Plane2 const& X) { return {0.1 * X[1], 0.2 - X[0] * X[1]}; }
BodyStart<2> thrown() {
  BodyStart<2> start;
  start.density = [](Plane2 const&) { return 1.7; };
  start.placement = bent, start.velocity = turning;
  return start;
}

/// Seven by five cells, thirty steps by both roads.
template <class Medium>
void roads_agree(Medium const& medium, std::array<FastSide, 2> across, std::array<FastSide, 2> up) {
  int const n = 7, m = 5, steps = 30;
  double const h1 = 0.1, h2 = 0.13, dt = 0.01;
  FastMedium2d<Medium> fast(medium, {{n, m}, {h1, h2}, across, up}, dt, 1.7, bent, turning);
  using enum BodySide<2>::Kind;
  BodySides<2> sides;
  char const* const names[4] = {"left", "right", "bottom", "top"};
  for (int k = 0; k < 4; ++k) {
    FastSide const side = (k < 2 ? across : up)[k % 2];
    if (side != FastSide::free) sides[names[k]] = {side == FastSide::fixed ? fixed : sliding, {}};
  }
  MediumOnMesh<2> body(box_mesh({0, 0}, {n * h1, m * h2}, {n, m}), stored_energy<2>(medium), thrown(),
                       {.step = dt}, sides);
  fast.step(steps), body.step(steps);
  auto const x = fast.places(), y = body.places();
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    worst = std::max(worst, std::hypot(x[k][0] - y[k][0], x[k][1] - y[k][1]));
  // Each step rounds places below 1 and 100 times a kick, dt^2 times a modulus below 2 over h; what a step is
  // off goes on as a velocity.
  double const a_step = eps * (2 + 100 * dt * dt * 2 / (h1 * h1));
  BOOST_TEST(worst <= a_step * steps * (steps + 1) / 2);
  BOOST_TEST_MESSAGE("the plain road and the fast road differ by " << worst);
  // Where nothing is held both have the angular momentum of the start.
  if (sides.empty())
    BOOST_TEST(body.angular_momentum()[2] == fast.angular_momentum(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(body.largest_step() == fast.largest_step(), boost::test_tools::tolerance(0.01));
  // Energies are those of the same places and velocities.
  BOOST_TEST(body.energies().stored + body.energies().kinetic == fast.energy(),
             boost::test_tools::tolerance(1e-12));
}
}  // namespace

BOOST_AUTO_TEST_SUITE(medium_on_mesh)

BOOST_AUTO_TEST_CASE(on_boxes_of_the_plane_both_roads_are_the_same_to_rounding) {
  using enum FastSide;
  for (auto const& [across, up] : {std::pair{std::array{free, free}, std::array{free, free}},
                                   {{fixed, free}, {sliding, free}},
                                   {{sliding, sliding}, {free, fixed}}}) {
    roads_agree(FastFluid{PolytropicByRoots<1, 2>{0.2}}, across, up);
    roads_agree(FastStVenantKirchhoff{0.9, 0.6}, across, up);
    roads_agree(neo_hookean(0.9, 0.6), across, up);
  }
}

BOOST_AUTO_TEST_CASE(a_step_that_is_set_before_the_first_one_is_that_of_the_beginning) {
  auto const made = [](double step) {
    return MediumOnMesh<2>(box_mesh({0, 0}, {1, 1}, {3, 3}), stored_energy<2>(neo_hookean(0.9, 0.6)),
                           thrown(), {.step = step});
  };
  auto one = made(0.01), other = made(1);
  other.set_time_step(0.01);
  one.step(5), other.step(5);
  BOOST_TEST((one.remember() == other.remember()));
  BOOST_TEST(other.time() == 0.05);
  BOOST_CHECK_THROW(other.set_time_step(0.02), OutsideDomain);
  BOOST_CHECK_THROW(made(1).set_time_step(-1), OutsideDomain);
}

// As people know them: by their places in a box, otherwise by numbers.
BOOST_AUTO_TEST_CASE(cells_have_the_names_of_the_fast_road) {
  auto const box = box_mesh({0, 0, 0}, {1, 1, 1}, {4, 3, 2});
  BOOST_TEST(box.cell_name(0) == "cell (0, 0, 0)");
  BOOST_TEST(box.cell_name(3 + 4 * (2 + 3 * 1)) == "cell (3, 2, 1)");
  BOOST_TEST(box_mesh({0}, {1}, {4}).cell_name(2) == "cell 2");
  BodyStart<2> start;
  start.placement = [](Plane2 const& X) { return Plane2{X[0] == 1 && X[1] == 2 ? 5.0 : X[0], X[1]}; };
  auto const says = [](Error const& error) {
    return std::string(error.what()).find("cell (1, 1) is inside out at the start") != std::string::npos;
  };
  auto const law = neo_hookean(0.9, 0.6);
  BOOST_CHECK_EXCEPTION(
      MediumOnMesh<2>(box_mesh({0, 0}, {3, 3}, {3, 3}), stored_energy<2>(law), start, {.step = 0.01}),
      BodyCellInverts, says);
  BOOST_CHECK_EXCEPTION(
      FastMedium2d(law, FastBox2d{{3, 3}, {1, 1}}, 0.01, 1, start.placement, start.velocity), CellInverts,
      says);
}

BOOST_AUTO_TEST_SUITE_END()
