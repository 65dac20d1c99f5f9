// The discrete multisymplectic form formula and the discrete Noether theorem on random boxes of space-time.
//
// What a box gives is a sum over its boundary, measured by the magnitudes of its terms. Each term carries the
// rounding of a few operations, and the solution satisfies its equations to a few roundings of theirs; since
// these are independent, sums of them stay near one rounding of the terms. For momenta there is more: they
// are differences of places, and a place of size one is told to epsilon alone, so a momentum is told to
// epsilon over the displacement in a step.
#include <boost/test/unit_test.hpp>

#include "media.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {

/// The largest defects that random boxes have, of what is conserved and of the controls.
struct Defects {
  double form = 0, noether = 0;
  double least_form_control = 1, least_noether_control = 1;
  int boxes = 0;
};

double relative(auto const& balance) {
  return balance.terms > 0 ? to_double(magnitude(balance.sum)) / to_double(balance.terms) : 0.0;
}

/// Draws boxes in a solution, with two first variations of it.
template <int n, class L>
Defects defects_of(L const& density, Sides<n> const& sides, GridIndex<n> const& cells, int slabs, int boxes,
                   bool rotations, std::uint64_t seed) {
  using S = double;
  Draw draw(seed);
  // Steps that differ, each a fraction of the time in which sound crosses a cell.
  std::vector<S> times{0};
  for (int k = 0; k < slabs; ++k) times.push_back(times.back() + 0.04 + 0.01 * (k % 3));
  SpaceTimeMesh<S, n> const mesh(times, cells, sides, bent_cube<S, n>());
  auto solution = disturbed_identity(mesh, draw);
  run(density, mesh, solution);
  auto const V = first_variation(density, mesh, solution, drawn_start<S, n>(mesh, draw));
  auto const W = first_variation(density, mesh, solution, drawn_start<S, n>(mesh, draw));
  // A variation that is none of a solution: V with the levels of W in between.
  auto mixed = V;
  for (std::size_t k = 1; k < mixed.levels.size(); k += 2) mixed.levels[k] = W.levels[k];

  Defects d;
  for (int k = 0; k < boxes; ++k) {
    auto const box = drawn_box(mesh, draw);
    d.form = std::max(d.form, relative(multisymplectic_balance(density, mesh, solution, V, W, box)));
    std::vector<double> momenta;
    for (int a = 0; a < n; ++a)
      momenta.push_back(relative(noether_balance(density, shifting<S, n>(a), mesh, solution, box)));
    if (rotations)
      momenta.push_back(relative(noether_balance(density, turning<S, n>(), mesh, solution, box)));
    d.noether = std::max(d.noether, *std::max_element(momenta.begin(), momenta.end()));
    // Controls need a box with nodes inside, and growth moves every box.
    d.least_noether_control = std::min(
        d.least_noether_control, relative(noether_balance(density, growing<S, n>(), mesh, solution, box)));
    if (box.slabs > 1 && std::all_of(box.cells.begin(), box.cells.end(), [](int c) { return c > 1; }))
      d.least_form_control = std::min(
          d.least_form_control, relative(multisymplectic_balance(density, mesh, solution, mixed, W, box)));
    ++d.boxes;
  }
  return d;
}

void report(char const* what, Defects const& d) {
  BOOST_TEST_MESSAGE(what << ": " << d.boxes << " boxes, form " << d.form << " (control "
                          << d.least_form_control << "), Noether " << d.noether << " (control "
                          << d.least_noether_control << ")");
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_form_formula_and_noethers_theorem_hold_on_random_boxes) {
  auto const free = Side::free, fixed = Side::fixed, periodic = Side::periodic, sliding = Side::sliding;
  auto const holds = [](char const* what, Defects const& d) {
    report(what, d);
    BOOST_TEST(d.form <= 1e-15);
    BOOST_TEST(d.noether <= 1e-14);
    BOOST_TEST(d.least_form_control > 1e-4);
    BOOST_TEST(d.least_noether_control > 1e-4);
  };
  holds("gas in a line", defects_of<1>(gas<double, 1>(), all_sides<1>(free), {6}, 8, 60, true, 1));
  holds("gas, free", defects_of<2>(gas<double, 2>(), all_sides<2>(free), {4, 5}, 6, 60, true, 2));
  holds("gas, periodic", defects_of<2>(gas<double, 2>(), all_sides<2>(periodic), {4, 5}, 6, 60, false, 3));
  holds("solid, free", defects_of<2>(solid<double, 2>(), all_sides<2>(free), {4, 5}, 6, 60, true, 4));
  Sides<2> const sides{{{periodic, periodic}, {fixed, free}}};
  holds("solid, mixed sides", defects_of<2>(solid<double, 2>(), sides, {4, 5}, 6, 60, false, 5));
  Sides<2> const along{{{sliding, free}, {sliding, sliding}}};
  holds("gas, sliding sides", defects_of<2>(gas<double, 2>(), along, {4, 5}, 6, 60, true, 7));
  holds("solid in space", defects_of<3>(solid<double, 3>(), all_sides<3>(free), {3, 2, 2}, 3, 12, true, 6));
}

namespace {

// A channel, free at its ends: along it the momentum stays, across it the walls push.
void slides_along_a_channel(auto const& density) {
  Draw draw(8);
  Sides<2> const channel{{{Side::free, Side::free}, {Side::sliding, Side::sliding}}};
  SpaceTimeMesh<double, 2> const mesh(equal_steps(0.0, 0.04, 12), {4, 5}, channel, bent_cube<double, 2>());
  auto section = disturbed_identity(mesh, draw);
  run(density, mesh, section);
  auto const momentum = [&](int axis, int slab) {
    return momentum_of_level(density, shifting<double, 2>(axis), mesh, section, slab);
  };
  auto const [along, terms] = momentum(0, 0);
  BOOST_TEST(std::abs(momentum(0, 11).sum - along) < 1e-13 * terms);
  BOOST_TEST(std::abs(momentum(1, 11).sum - momentum(1, 0).sum) > 1e-3 * terms);
  for (Index node = 0; node < mesh.node_count(); ++node)
    if (mesh.held_across(node) != 0) {
      BOOST_TEST(section(12, node)[1] == section(0, node)[1]);
      BOOST_TEST(section(12, node)[0] != section(0, node)[0]);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sliding_side_holds_what_is_across_it_and_takes_no_momentum_along_it) {
  slides_along_a_channel(gas<double, 2>());
  // Where the kinetic energy couples the directions, what is held would move with the other one.
  slides_along_a_channel(
      [gas = gas<double, 2>()](auto const& jet) { return gas(jet) + jet.v(0, 0) * jet.v(1, 0) * 0.3; });
}
