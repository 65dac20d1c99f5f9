// Cells that turn inside out in the optimised implementation, in the plane and in space: nodes without forces
// worth the name fly on straight lines, so that it is known beforehand which cell does it, at which step, and
// how far.
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double dt = 0.01;
using enum Side;
template <class Box>
using Points = std::vector<std::array<double, Box::dimension>>;

/// What belongs to the nodes of a box, one after the other.
template <class Box>
struct AtNodes {
  Box box;
  Points<Box> points;
  std::array<double, Box::dimension> operator()(std::array<double, Box::dimension> const& X) const {
    std::size_t at = 0;
    for (std::size_t d = Box::dimension; d-- > 0;) {
      double const i = (X[d] - box.origin[d]) / box.spacing[d];
      at = at * static_cast<std::size_t>(box.nodes(static_cast<int>(d))) +
           static_cast<std::size_t>(std::lround(i));
    }
    return points[at];
  }
};
template <class Box>
Points<Box> at_rest(Box const& box) {
  Points<Box> out;
  media::detail::for_nodes(box, [&](auto const& node, std::size_t) { out.push_back(box.at(node)); });
  return out;
}
/// After so many steps.
template <class Box>
Points<Box> flown(Points<Box> x, Points<Box> const& v, long steps) {
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t d = 0; d < x[k].size(); ++d) x[k][d] += static_cast<double>(steps) * dt * v[k][d];
  return x;
}

/// The number of a corner of a cell among the nodes, and the place of it as the cell has it.
template <class Box>
std::size_t node_of(Box const& box, std::array<int, Box::dimension> const& cell, unsigned corner) {
  std::size_t at = 0;
  for (int d = Box::dimension - 1; d >= 0; --d) {
    int const i = cell[static_cast<std::size_t>(d)] + static_cast<int>(corner >> d & 1), all = box.nodes(d);
    at = at * static_cast<std::size_t>(all) + static_cast<std::size_t>(i % all);
  }
  return at;
}
template <class Box>
auto place_of(Box const& box, std::array<int, Box::dimension> const& cell, unsigned corner,
              Points<Box> const& x) {
  auto place = x[node_of(box, cell, corner)];
  // The periods of these boxes are their lengths.
  for (std::size_t d = 0; d < place.size(); ++d)
    if (cell[d] + static_cast<int>(corner >> d & 1) == box.nodes(static_cast<int>(d)))
      place[d] += box.cells[d] * box.spacing[d];
  return place;
}
/// The least Jacobian of a cell, and which corners have none that is positive.
struct Look {
  double least = HUGE_VAL;
  unsigned inverted = 0;
};
template <class Box>
Look look_at(Box const& box, std::array<int, Box::dimension> const& cell, Points<Box> const& x) {
  Look out;
  for (unsigned corner = 0; corner < 1 << Box::dimension; ++corner) {
    double F[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, J = 0;
    for (unsigned d = 0; d < Box::dimension; ++d) {
      auto const to = place_of(box, cell, corner | 1u << d, x),
                 from = place_of(box, cell, corner & ~(1u << d), x);
      for (unsigned i = 0; i < Box::dimension; ++i) F[d][i] = (to[i] - from[i]) / box.spacing[d];
    }
    for (unsigned i = 0; i < 3; ++i) {
      unsigned const j = (i + 1) % 3, k = (i + 2) % 3;
      J += F[0][i] * (F[1][j] * F[2][k] - F[1][k] * F[2][j]);
    }
    out.least = std::min(out.least, J);
    if (J <= 0) out.inverted |= 1u << corner;
  }
  return out;
}
/// What is known of a flight beforehand.
template <class Box>
struct Flight {
  long step = 0;                               ///< the first after which a cell is inside out
  std::array<int, Box::dimension> cell{};      ///< the cell with the least Jacobian then
  double least = HUGE_VAL, before = HUGE_VAL;  ///< that, and the least of this cell a step before
  unsigned corners = 0;                        ///< that are inside out at some step
  long again = 0;                              ///< the first after which no cell is inside out any more
};
template <class Box>
Flight<Box> foreseen(Box const& box, Points<Box> const& v) {
  Flight<Box> out;
  auto const start = at_rest(box);
  for (long step = 1; step <= 40 && out.again == 0; ++step) {
    auto const x = flown<Box>(start, v, step);
    unsigned now = 0;
    media::detail::for_indices(box.cells, [&](auto const& cell) {
      auto const look = look_at(box, cell, x);
      now |= look.inverted;
      if (out.corners == 0 && look.least < out.least)
        out.least = look.least, out.cell = cell, out.step = step;
    });
    if (out.corners == 0 && now == 0) out.least = HUGE_VAL;
    if (out.corners != 0 && now == 0) out.again = step;
    out.corners |= now;
  }
  if (out.corners) out.before = look_at(box, out.cell, flown<Box>(start, v, out.step - 1)).least;
  return out;
}

/// The cell is found that is known to be inside out first, in a call of so many steps.
template <class Medium, class Box>
void is_found(Medium const& medium, Box const& box, Points<Box> const& v, Flight<Box> const& known,
              long count, FastOptions const& options = {}) {
  FastMedium<Medium, Box> body(medium, box, dt, 2, AtNodes<Box>{box, at_rest(box)}, AtNodes<Box>{box, v},
                               options);
  auto const rounding = [](double x, double y) { return std::abs(x - y) <= 1e-12; };
  try {
    body.step(count);
    BOOST_ERROR("no cell was found inside out");
  } catch (CellInverts const& found) {
    std::array<int, 3> cell{};
    std::copy(known.cell.begin(), known.cell.end(), cell.begin());
    BOOST_TEST((found.step == known.step && found.cell == cell && found.time_step == dt));
    BOOST_TEST((rounding(found.measured, known.least) && found.bound == 0));
    BOOST_TEST(found.largest_step == body.largest_step());
    std::string name;
    for (int const i : known.cell) name += (name.empty() ? "(" : ", ") + std::to_string(i);
    std::string const what = found.what(), is = "whose Jacobian is ";
    BOOST_TEST(what.find("medium: step " + std::to_string(known.step) + " of length 0.01 would turn cell " +
                         name + ") inside out, ") == 0);
    BOOST_TEST(what.find("step before it is " + show(found.largest_step) + ")") != std::string::npos);
    BOOST_TEST(std::abs(std::stod(what.substr(what.find(is) + is.size())) - known.before) <= 1e-8);
  }
  BOOST_TEST(body.steps() == known.step - 1);
  auto const x = body.places(), y = flown<Box>(at_rest(box), v, known.step - 1);
  bool same = true;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t d = 0; d < x[k].size(); ++d) same = same && rounding(x[k][d], y[k][d]);
  BOOST_TEST(same);
}
// So soft that a step changes no velocity by more than rounding.
constexpr FastFluid<PolytropicByRoots<1, 2>> gas{{1e-22}};
constexpr FastStVenantKirchhoff solid{1e-22, 1e-22};

/// One cell, of which one corner alone is inside out on the way: each of them once.
template <class Box>
void each_corner_is_found(Box const& box) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> some(-0.5, 0.5);
  unsigned done = 0;
  while (done + 1 < 1u << (1u << Box::dimension)) {
    Points<Box> v(at_rest(box).size());
    for (auto& one : v)
      for (double& c : one) c = some(random);
    auto const known = foreseen(box, v);
    bool const alone = known.again > 0 && (known.corners & (known.corners - 1)) == 0;
    if (!alone || (done & known.corners)) continue;
    done |= known.corners;
    is_found(gas, box, v, known, known.again), is_found(solid, box, v, known, known.again);
  }
}
/// One cell after the other in a row of cells along the first direction: all become shorter along the first
/// two directions, and go on until they are turned over along both, but one of them not at once.
template <class Box>
void each_cell_of_a_row_is_found(Box const& box) {
  auto const start = at_rest(box);
  for (int odd = 0; odd < box.cells[0]; ++odd) {
    Points<Box> v;
    media::detail::for_nodes(box, [&](auto const& node, std::size_t k) {
      v.push_back({});
      v.back()[0] = -5.1 * (start[k][0] + (node[0] > odd ? 0.3 * box.spacing[0] : 0));
      v.back()[1] = -5.1 * start[k][1];
    });
    auto const known = foreseen(box, v);
    BOOST_TEST((known.again > known.step && known.cell[0] == odd));
    is_found(gas, box, v, known, known.again, {1, 1 + odd % 4}), is_found(solid, box, v, known, known.again);
  }
}
/// Some cells of a box, one after the other, whose corners alone move: in calls that end there, or later.
template <class Box>
void some_cells_are_found(Box const& box) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> some(-0.5, 0.5);
  for (int draw = 0; draw < 8; ++draw) {
    std::array<int, Box::dimension> cell;
    for (std::size_t d = 0; d < cell.size(); ++d)
      cell[d] = static_cast<int>(random() % static_cast<unsigned>(box.cells[d]));
    Points<Box> v(at_rest(box).size());
    for (unsigned corner = 0; corner < 1 << Box::dimension; ++corner)
      for (double& c : v[node_of(box, cell, corner)]) c = some(random);
    auto const known = foreseen(box, v);
    FastOptions const options{1 + draw % 3, 1 + draw % 4};
    if (known.corners)
      is_found(gas, box, v, known, known.step, options),
          is_found(solid, box, v, known, known.step + 2, options);
  }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_inversions)

BOOST_AUTO_TEST_CASE(a_corner_that_is_inside_out_on_the_way_is_found) {
  each_corner_is_found(FastBox2d{{1, 1}, {0.1, 0.1}});
  each_corner_is_found(FastBox3d{{1, 1, 1}, {0.1, 0.1, 0.1}});
}
BOOST_AUTO_TEST_CASE(a_cell_that_is_inside_out_on_the_way_is_found_wherever_it_is_in_its_row) {
  each_cell_of_a_row_is_found(FastBox2d{{14, 1}, {0.1, 0.13}});
  each_cell_of_a_row_is_found(FastBox3d{{7, 1, 1}, {0.1, 0.13, 0.11}});
}
BOOST_AUTO_TEST_CASE(the_first_cell_that_turns_inside_out_is_named_with_its_jacobians) {
  some_cells_are_found(FastBox2d{{9, 3}, {0.1, 0.13}, {Side::free, fixed}, {periodic, periodic}});
  some_cells_are_found(FastBox2d{{14, 2}, {0.1, 0.13}, {periodic, periodic}, {sliding, Side::free}});
  FastBox3d box{{6, 2, 2}, {0.1, 0.13, 0.11}};
  box.sides[1] = {periodic, periodic};
  some_cells_are_found(box);
  box.cells = {3, 2, 3}, box.sides[0] = {periodic, periodic}, box.sides[1] = {sliding, fixed};
  box.sides[2] = {periodic, periodic};
  some_cells_are_found(box);
}

BOOST_AUTO_TEST_SUITE_END()
