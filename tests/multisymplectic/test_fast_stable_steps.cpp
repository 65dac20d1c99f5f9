// The longest stable step of the optimised implementation: of a window around the cell that resists most it
// is the bound at the start, and in space it is that of a dispersion relation.
#include <boost/test/unit_test.hpp>
#include <random>

#include "acoustic.hpp"
#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;

namespace {
using enum Side;
template <class Box>
using Node = std::array<int, Box::dimension>;
template <class Box>
using Points = std::vector<std::array<double, Box::dimension>>;

/// The number of a node in the order of nodes.
template <class Box>
std::size_t number_of(Box const& box, Node<Box> const& node) {
  std::size_t at = 0;
  for (std::size_t d = Box::dimension; d-- > 0;)
    at = at * static_cast<std::size_t>(box.nodes(static_cast<int>(d))) + static_cast<std::size_t>(node[d]);
  return at;
}
/// A box whose nodes are somewhere.
template <class Box>
struct Shape {
  Box box;
  Points<Box> places;
  std::array<double, Box::dimension> operator()(std::array<double, Box::dimension> const& X) const {
    Node<Box> node;
    for (std::size_t d = 0; d < node.size(); ++d)
      node[d] = static_cast<int>(std::lround((X[d] - box.origin[d]) / box.spacing[d]));
    return places[number_of(box, node)];
  }
};
/// Every node a little away from rest, differently.
template <class Box>
Shape<Box> disturbed(Box const& box) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-0.01, 0.01);
  Shape<Box> out{box, {}};
  media::detail::for_nodes(box, [&](auto const& node, std::size_t) {
    out.places.push_back(box.at(node));
    for (std::size_t d = 0; d < Box::dimension; ++d) out.places.back()[d] += some(random) * box.spacing[d];
  });
  return out;
}
/// The corners of a cell go towards each other, each by a part of the length of the cell.
template <class Box>
void squeeze(Shape<Box>& shape, Node<Box> const& cell, double part) {
  for (unsigned corner = 0; corner < 1 << Box::dimension; ++corner) {
    Node<Box> node = cell;
    for (unsigned d = 0; d < Box::dimension; ++d)
      node[d] = (cell[d] + static_cast<int>(corner >> d & 1)) % shape.box.nodes(static_cast<int>(d));
    auto& place = shape.places[number_of(shape.box, node)];
    for (unsigned d = 0; d < Box::dimension; ++d)
      place[d] += (corner >> d & 1 ? -part : part) * shape.box.spacing[d];
  }
}
template <class Box>
auto body_of(Shape<Box> const& shape, double dt) {
  return FastMedium<FastNeoHookean<LogarithmicLaw>, Box>(
      neo_hookean(0.9, 0.6), shape.box, dt, 2, shape,
      [](std::array<double, Box::dimension> const&) { return std::array<double, Box::dimension>{}; });
}
/// Eight cells along each direction with this one in the middle, or as near to it as the body has as many,
/// cut out: where they are cut the nodes are held.
template <class Box>
Shape<Box> window_around(Shape<Box> const& shape, Node<Box> const& cell) {
  Box const& box = shape.box;
  Shape<Box> out{box, {}};
  Node<Box> first{};
  for (int d = 0; d < Box::dimension; ++d) {
    auto const at = static_cast<std::size_t>(d);
    if (box.cells[at] <= 8) continue;
    // Of a periodic direction the last node is none of its own: so the last row of cells is never inside.
    int const last = box.periodic(d) ? box.cells[at] - 9 : box.cells[at] - 8;
    first[at] = std::min(std::max(cell[at] - 4, 0), last);
    out.box.cells[at] = 8;
    out.box.ends(d) = {first[at] == 0 && !box.periodic(d) ? box.ends(d)[0] : fixed,
                       first[at] == last && !box.periodic(d) ? box.ends(d)[1] : fixed};
  }
  media::detail::for_nodes(out.box, [&](auto node, std::size_t) {
    for (std::size_t d = 0; d < node.size(); ++d) node[d] += first[d];
    out.places.push_back(shape.places[number_of(box, node)]);
  });
  return out;
}

/// A step of this length is refused, and any shorter one is not.
template <class Box>
void bound_is(Shape<Box> const& shape, double longest) {
  auto const error = testing::caught<OutsideDomain>([&] { body_of(shape, 1000); });
  double const bound = error.bound;
  BOOST_TEST(error.measured == 1000);
  BOOST_TEST(bound == longest, boost::test_tools::tolerance(1e-12));
  body_of(shape, bound);
  CHECK_REFUSED(body_of(shape, std::nextafter(bound, 1e3)), OutsideDomain);
}
template <class Box>
void bound_is_that_of_a_window(Box const& box, std::vector<Node<Box>> const& cells) {
  for (auto const& cell : cells) {
    auto shape = disturbed(box);
    squeeze(shape, cell, 0.15);
    bound_is(shape, body_of(window_around(shape, cell), 1e-6).largest_step());
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_stable_steps)

BOOST_AUTO_TEST_CASE(the_bound_at_the_start_is_that_of_a_window_around_the_cell_that_resists_most) {
  FastBox2d box{{13, 10}, {0.1, 0.13}, {Side::free, sliding}, {fixed, Side::free}};
  bound_is_that_of_a_window<FastBox2d>(box, {{0, 0}, {12, 9}, {4, 5}, {8, 6}, {9, 4}, {5, 7}});
  box.left_right = {periodic, periodic};
  bound_is_that_of_a_window<FastBox2d>(box, {{12, 3}, {7, 9}, {9, 0}});
  box.left_right = {sliding, Side::free}, box.below_above = {periodic, periodic}, box.cells = {9, 8};
  bound_is_that_of_a_window<FastBox2d>(box, {{4, 7}, {5, 2}});
  FastBox3d solid{{2, 9, 3}, {0.1, 0.13, 0.11}};
  solid.sides[0] = {periodic, periodic}, solid.sides[2] = {sliding, Side::free};
  bound_is_that_of_a_window<FastBox3d>(solid, {{1, 4, 0}, {0, 5, 2}});
}

BOOST_AUTO_TEST_CASE(of_many_cells_every_third_is_looked_at) {
  // Two times 4096 cells make a stride of three; fewer make none.
  for (auto const& [across, up, third] : {std::tuple{110, 80, true}, {90, 91, false}}) {
    auto shape = disturbed(FastBox2d{{across, up}, {0.1, 0.13}});
    std::array<int, 2> const looked_at{63, 30}, harder{across == 110 ? 22 : 20, 50};
    BOOST_TEST(((30 * across + 63) % 3 == 0 && (50 * across + harder[0]) % 3 != 0));
    squeeze(shape, looked_at, 0.15), squeeze(shape, harder, 0.17);
    bound_is(shape, body_of(window_around(shape, third ? looked_at : harder), 1e-6).largest_step());
  }
}

// In space, with the phases t_i of a wave from cell to cell and s_i = sin(t_i/2), a cubic cell has the matrix
// (4c^2/h^2)(s_i s_j cos(t_i/2)cos(t_j/2) + delta_ij s_i^4). With the same s along all diagonals its largest
// eigenvalue is 3s^2-2s^4, and that is 9/8 for s^2 = 3/4, which is a third of a turn from cell to cell.
BOOST_AUTO_TEST_CASE(in_space_waves_along_the_diagonals_bound_the_step) {
  FastBox3d const box{{3, 6, 3},
                      {0.1, 0.1, 0.1},
                      {FastBox3d::Ends{periodic, periodic}, FastBox3d::Ends{periodic, periodic},
                       FastBox3d::Ends{periodic, periodic}}};
  std::vector<media::detail::Space<double>> x;
  media::detail::for_nodes(
      box, [&](auto const& node, std::size_t) { x.push_back(media::detail::as_vector(box.at(node))); });
  double const found = media::detail::largest_frequency(
      box, media::detail::cell_on(FastFluid{testing::Acoustic{2}}, box.spacing), x);
  double const exact = 2 * 2 / 0.1 * std::sqrt(9.0 / 8);
  BOOST_TEST(found <= exact * (1 + 1e-12));
  BOOST_TEST(found >= exact * 0.995);
}

BOOST_AUTO_TEST_SUITE_END()
