// The constraint of a cell and the action of an extended section: against formulas written by hand, exactly.
#include <boost/test/unit_test.hpp>

#include "actio/constraints/inextensible.hpp"
#include "actio/constraints_on_meshes/cell_volumes.hpp"
#include "actio/constraints_on_meshes/extended_balances.hpp"
#include "actio/continuum/materials.hpp"
#include "actio/incompressible/incompressible_density.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;

namespace {

using Q = Number;
using Point = Matrix<Q, 2, 1>;

SpaceTimeMesh<Q, 2> bent_square() {
  return {{Q(0), ratio<Q>(1, 20), ratio<Q>(1, 8)}, {2, 2}, all_sides<2>(Side::free), [](Point const& u) {
            Q const bump = u[0] * (1 - u[0]) * u[1] * (1 - u[1]);
            return Point(u[0] + bump, u[1] - bump / 3);
          }};
}
auto water() {
  return incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<Q>{ratio<Q>(3, 2)},
                                  OfGreenTensor{StVenantKirchhoff<Q>{ratio<Q>(1, 2), ratio<Q>(2, 3)}}});
}
DiscreteExtendedSection<Q, 2, 2, 1> drawn_on(SpaceTimeMesh<Q, 2> const& mesh, Draw& draw) {
  auto y =
      without_reactions<1>(mesh, restricted(
                                     mesh, [](Matrix<Q, 3, 1> const& x) { return Point(x[1], x[2]); }, 3));
  for (auto& level : y.phi.levels)
    for (auto& at : level) at += draw.vector<Q, Point>(2) / Q(16);
  for (auto& level : y.lambda)
    for (auto& lambda : level) lambda = draw.vector<Q, Matrix<Q, 1, 1>>(1);
  return y;
}
Q area(Matrix<Q, 2, 4> const& y) {
  Q sum(0);
  constexpr std::array<int, 4> around{0, 1, 3, 2};
  for (int i = 0; i < 4; ++i) {
    int const a = around[i], b = around[(i + 1) % 4];
    sum += y(0, a) * y(1, b) - y(0, b) * y(1, a);
  }
  return sum / 2;
}

}  // namespace

BOOST_AUTO_TEST_CASE(in_the_plane_the_constraint_of_a_cell_is_its_area_by_the_shoelace_formula) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(3);
  auto const mesh = bent_square();
  auto const y = drawn_on(mesh, draw);
  mesh.for_cells([&](GridIndex<2> const& cell) {
    auto const here = configuration<2>(cell_of(mesh, y, 1, cell));
    for (int level = 0; level < 2; ++level) {
      Q const expected = area(here.y.middleCols<4>(4 * level)) - area(here.geometry->places);
      BOOST_TEST((constraint_of_cell(water().constraint, here, level)[0] == expected));
    }
  });
}

BOOST_AUTO_TEST_CASE(the_action_is_that_of_the_medium_and_the_multipliers_times_the_constraints) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(5);
  auto const mesh = bent_square();
  auto const y = drawn_on(mesh, draw);
  Q expected = discrete_action(water().density, mesh, y.phi);
  for (int level = 0; level < 3; ++level)
    mesh.for_cells([&](GridIndex<2> const& cell) {
      Q const before = level > 0 ? mesh.time(level) - mesh.time(level - 1) : Q(0),
              after = level < 2 ? mesh.time(level + 1) - mesh.time(level) : Q(0);
      auto const here = cell_of(mesh, y.phi, level > 0 ? level - 1 : 0, cell);
      Q const C = area(here.y.middleCols<4>(level > 0 ? 4 : 0)) - area(here.geometry->places);
      expected += (before + after) / 2 * y.lambda[level][mesh.number(cell)][0] * C;
    });
  BOOST_TEST((discrete_action(water(), mesh, y) == expected));
}

BOOST_AUTO_TEST_CASE(the_cartan_form_of_a_multiplier_is_its_part_of_the_constraint) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(7);
  auto const mesh = bent_square();
  auto const y = drawn_on(mesh, draw);
  auto const cell = cell_of(mesh, y, 0, {});
  for (int level = 0; level < 2; ++level) {
    Q sum(0);
    for (int b = 0; b < 4; ++b) sum += discrete_cartan_form(water(), cell, node_of_corner<2>(b, level))[2];
    auto const C = constraint_of_cell(water().constraint, configuration<2>(cell), level);
    BOOST_TEST((sum == C[0] * cell.duration() / 2));
  }
  // Those of the values are the same by either road.
  for (int l = 0; l < cell.nodes; ++l)
    BOOST_TEST((cartan_form_of_values(water(), cell, l) ==
                Point(discrete_cartan_form(water(), cell, l).template head<2>())));
}

BOOST_AUTO_TEST_CASE(volumes_of_cells_in_space_add_up_and_are_the_corners_of_parallelepipeds) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(11);
  // The body is a cube, cut into eight cells at a point inside, whose faces and edges it bends.
  using Corners = Matrix<Q, 3, 8>;
  std::array<Matrix<Q, 3, 1>, 27> nodes;
  for (int i = 0; i < 27; ++i)
    nodes[i] = Matrix<Q, 3, 1>(Q(i % 3), Q(i / 3 % 3), Q(i / 9)) +
               (i == 13 ? Matrix<Q, 3, 1>(draw.vector<Q, Matrix<Q, 3, 1>>(3) / Q(2))
                        : Matrix<Q, 3, 1>(Matrix<Q, 3, 1>::Zero()));
  Q sum(0);
  for (int cell = 0; cell < 8; ++cell) {
    Corners y;
    for (int b = 0; b < 8; ++b) {
      int node = 0, stride = 1;
      for (int i = 0; i < 3; ++i, stride *= 3) node += ((cell >> i & 1) + (b >> i & 1)) * stride;
      y.col(b) = nodes[node];
    }
    sum += volume_of_cell(y);
  }
  BOOST_TEST((sum == 8));
  Corners skew;
  Matrix<Q, 3, 3> edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = draw.vector<Q, Matrix<Q, 3, 1>>(3);
  for (int b = 0; b < 8; ++b) skew.col(b) = edges * Matrix<Q, 3, 1>(Q(b & 1), Q(b >> 1 & 1), Q(b >> 2 & 1));
  BOOST_TEST((volume_of_cell(skew) == determinant(edges)));
}

BOOST_AUTO_TEST_CASE(extended_sections_that_are_none_of_a_mesh_are_refused) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(9);
  auto const mesh = bent_square();
  auto const y = drawn_on(mesh, draw);
  auto short_of_a_level = y, short_of_a_cell = y;
  short_of_a_level.lambda.pop_back();
  short_of_a_cell.lambda[1].pop_back();
  CHECK_REFUSED(discrete_action(water(), mesh, short_of_a_level), NotAMesh);
  CHECK_REFUSED(discrete_euler_lagrange(water(), mesh, short_of_a_cell, 1, 0), NotAMesh);
  CHECK_REFUSED(discrete_euler_lagrange(water(), mesh, y, 2, 0), NotAMesh);
}
