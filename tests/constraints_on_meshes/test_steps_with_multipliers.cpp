// Steps with multipliers: against a pendulum written by hand, the equations themselves, and what is refused.
#include <boost/test/unit_test.hpp>

#include "actio/constraints/directors.hpp"
#include "actio/constraints/inextensible.hpp"
#include "actio/constraints_on_meshes/extended_balances.hpp"
#include "actio/constraints_on_meshes/step_with_multipliers.hpp"
#include "actio/continuum/materials.hpp"
#include "actio/incompressible/incompressible_density.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::media;

namespace {

using Point = Matrix<double, 2, 1>;

auto water() {
  return incompressible(
      Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{1.5}, NoStoredEnergy{}});
}
/// m |y|/h of a node inside of the square.
constexpr double rounded_water = 1.5 / 9 / 0.02;
SpaceTimeMesh<double, 2> square(Sides<2> const& sides, int steps, GridIndex<2> const& cells = {3, 3}) {
  return {equal_steps(0.0, 0.02, steps), cells, sides,
          StraightBox<double, 2>{Point(-0.5, -0.5), Point(0.5, 0.5)}};
}
template <int n, class Mesh>
auto at_rest(Mesh const& mesh) {
  return without_reactions<1>(
      mesh,
      restricted(
          mesh, [](Matrix<double, n + 1, 1> const& x) { return Matrix<double, n, 1>(x.template tail<n>()); },
          1));
}
template <int n, class Mesh, class Field>
Level<double, n> velocities(Mesh const& mesh, Field const& field) {
  Level<double, n> v;
  for (Index i = 0; i < mesh.node_count(); ++i) v.push_back(field(mesh.place(i)));
  return v;
}
/// The largest residual of the field equations at inner levels, momentum. What rounds it is m |y|/h, of which
/// momenta are differences.
template <class L, class Mesh, class Section>
double worst_of(L const& density, Mesh const& mesh, Section const& y) {
  double worst = 0;
  for (int level = 1; level < y.last(); ++level)
    for (Index i = 0; i < mesh.node_count(); ++i) {
      auto const E = discrete_euler_lagrange(density, mesh, y, level, i).sum;
      unsigned const held = mesh.fixed(i) ? ~0u : mesh.held_across(i);
      for (int a = 0; a < E.size(); ++a)
        if (!(held >> a & 1)) worst = std::max(worst, std::abs(E[a]));
    }
  return worst;
}
template <class Mesh, class Section>
double worst_area(Mesh const& mesh, Section const& y) {
  double worst = 0;
  for (int slab = 0; slab < y.last(); ++slab)
    mesh.for_cells([&](GridIndex<2> const& cell) {
      auto const here = cell_of(mesh, y.phi, slab, cell);
      worst = std::max(worst, std::abs(constraint_of_cell(water().constraint, here, 1)[0]));
    });
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(one_cell_of_a_string_is_a_pendulum_stepped_by_hand) {
  // A cell of the length a with mass rho a/2 at its free end. The multiplier is the tension, per length.
  double const a = 0.8, rho = 2.5, g = 9.81, h = 0.01;
  SpaceTimeMesh<double, 1> const mesh(
      equal_steps(0.0, h, 200), {1}, Sides<1>{{{Side::fixed, Side::free}}},
      StraightBox<double, 1>{Matrix<double, 1, 1>(0.0), Matrix<double, 1, 1>(a)});
  AugmentedDensity const string(HeavyString<double, 2>{rho, Point(0, -g)}, Inextensible{Euclidean<2>{}});
  auto y = without_reactions<1>(mesh, DiscreteSection<double, 1, 2>{{{Point(0, 0), Point(a, 0)}}});
  first_step(string, mesh, y, {Point(0, 0), Point(0, 1.5)});
  while (y.last() + 1 < mesh.levels()) step(string, mesh, y);

  // By hand: the multiplier of a quadratic equation, in units of its force over the mass.
  Point before(a, 0), now;
  double largest = 0;
  for (int k = 0; k < 200; ++k) {
    Point const free = k == 0 ? Point(a, h * 1.5 - h * h * g / 2)
                              : Point(2 * now[0] - before[0], 2 * now[1] - before[1] - h * h * g);
    Point const along = k == 0 ? before : now;
    double const p = free.dot(along), q = along.dot(along), c = free.dot(free) - a * a;
    double const s = (p - std::sqrt(p * p - q * c)) / q;
    Point const next = free - along * s;
    if (k > 0) {
      before = now;
      // s = h^2 lambda/(a m) with the mass m = rho a/2.
      double const tension = s * rho * a * a / (2 * h * h);
      largest = std::max(largest, std::abs(y.lambda[k][0][0] - tension) / (rho * g * a));
    }
    now = next;
    largest = std::max(largest, magnitude(Point(y.phi(k + 1, 1) - now)) / a);
  }
  // Two recursions of 200 steps, whose roundings add up linearly in velocity and so quadratically in place;
  // the tension is a second difference of places, over (h/0.29 s)^2.
  BOOST_TEST(largest < 200 * 200 * epsilon<double>() / (h * h));
  BOOST_TEST(magnitude(Point(now - Point(a, 0))) > 0.1);
}

BOOST_AUTO_TEST_CASE(water_with_free_sides_keeps_areas_and_both_momenta) {
  auto const mesh = square(all_sides<2>(Side::free), 40);
  auto y = at_rest<2>(mesh);
  first_step(water(), mesh, y, velocities<2>(mesh, [](Point const& X) {
               return Point(X[0] - 2 * X[1] + 0.3, 3 * X[0] - X[1]);
             }));
  while (y.last() + 1 < mesh.levels()) BOOST_TEST(step(water(), mesh, y).sweeps <= 6);
  BOOST_TEST(worst_of(water(), mesh, y) < 16 * epsilon<double>() * rounded_water);
  BOOST_TEST(worst_area(mesh, y) < 8 * epsilon<double>());
  RigidMotion<double, 2> motion{Matrix<double, 2, 2>::Zero(), Point(0.3, 0.7)};
  motion.turn(0, 1) = -1, motion.turn(1, 0) = 1;
  auto const sum =
      noether_balance(water(), motion_of_space<2>(motion), mesh, y, CellBox<2>{1, 38, {0, 1}, {2, 2}});
  BOOST_TEST(std::abs(sum.sum) < 1e-13 * sum.terms);
  BOOST_TEST(sum.terms > 1);
}

BOOST_AUTO_TEST_CASE(what_changes_areas_in_a_velocity_is_taken_away_by_the_first_multipliers) {
  // An impulse: in half of the step the multiplier is twice as large. In a turn it is a pressure.
  auto const first_multiplier = [](double h, auto const& field) {
    SpaceTimeMesh<double, 2> const mesh(equal_steps(0.0, h, 1), {3, 3}, all_sides<2>(Side::free),
                                        StraightBox<double, 2>{Point(-0.5, -0.5), Point(0.5, 0.5)});
    auto y = at_rest<2>(mesh);
    first_step(water(), mesh, y, velocities<2>(mesh, field));
    BOOST_TEST(worst_area(mesh, y) < 8 * epsilon<double>());
    return y.lambda[0][4][0];
  };
  auto const swell = [](Point const& X) { return X; };
  auto const turn = [](Point const& X) { return Point(-X[1], X[0]); };
  BOOST_TEST(std::abs(first_multiplier(1e-3, swell) / first_multiplier(2e-3, swell) - 2) < 0.02);
  BOOST_TEST(std::abs(first_multiplier(1e-3, turn) / first_multiplier(2e-3, turn) - 1) < 0.02);
}

BOOST_AUTO_TEST_CASE(directors_stay_unit_vectors) {
  SpaceTimeMesh<double, 1> const mesh(
      equal_steps(0.0, 0.01, 20), {4}, all_sides<1>(Side::free),
      StraightBox<double, 1>{Matrix<double, 1, 1>(0.0), Matrix<double, 1, 1>(1.0)});
  // Stretch, shear and bending of a rod whose director is held in length alone.
  auto const energy = [](auto const&, auto const& m) {
    using T = std::remove_cvref_t<decltype(m(0, 0))>;
    T const stretch = m(0, 0) - 1.0, shear = m(0, 1), bend = m(2, 2);
    return T(stretch * stretch * 2.0 + shear * shear + bend * 0.1);
  };
  AugmentedDensity const rod(DirectedBody<double, decltype(energy)>{1.0, 0.2, energy}, UnitDirector{});
  auto y = without_reactions<1>(mesh, restricted(
                                          mesh,
                                          [](Matrix<double, 2, 1> const& x) {
                                            Matrix<double, 6, 1> r;
                                            r << x[1], 0.0, 0.0, 0.0, std::cos(x[1]), std::sin(x[1]);
                                            return r;
                                          },
                                          1));
  Level<double, 6> v(5, Matrix<double, 6, 1>::Zero());
  v[0][2] = 1;
  first_step(rod, mesh, y, v);
  while (y.last() + 1 < mesh.levels()) step(rod, mesh, y);
  BOOST_TEST(worst_of(rod, mesh, y) < 16 * epsilon<double>() * 0.25 / 0.01);
  // One multiplier a cell: the squares of its two directors have the mean one.
  for (int cell = 0; cell < 4; ++cell) {
    auto const d = [&](int node) { return Matrix<double, 3, 1>(y.phi(20, node).tail<3>()); };
    BOOST_TEST(std::abs((d(cell).dot(d(cell)) + d(cell + 1).dot(d(cell + 1))) / 2 - 1) <
               16 * epsilon<double>());
  }
}

BOOST_AUTO_TEST_CASE(closed_walls_leave_the_multiplier_of_one_cell_free) {
  auto const mesh = square(all_sides<2>(Side::sliding), 20);
  // The stream function cos(pi x) cos(pi y): no velocity across the sides.
  auto const v = velocities<2>(mesh, [](Point const& X) {
    double const p = 3.14159265358979323846;
    return Point(-std::cos(p * X[0]) * std::sin(p * X[1]), std::sin(p * X[0]) * std::cos(p * X[1]));
  });
  auto y = at_rest<2>(mesh), z = y;
  CHECK_REFUSED(first_step(water(), mesh, y, v), Singular);
  BOOST_TEST(y.last() == 0);
  BOOST_TEST((y.lambda[0] == z.lambda[0]));
  first_step(water(), mesh, y, v, AtRest{}, Pinned{4});
  first_step(water(), mesh, z, v, AtRest{}, Pinned{0});
  for (int k = 1; k < 20; ++k) {
    step(water(), mesh, y, AtRest{}, Pinned{4});
    step(water(), mesh, z, AtRest{}, Pinned{0});
  }
  BOOST_TEST(worst_area(mesh, y) < 8 * epsilon<double>());
  BOOST_TEST(worst_of(water(), mesh, y) < 16 * epsilon<double>() * rounded_water);
  // Another pinned cell: the same motion, and pressures that differ by one constant.
  double apart = 0, level = y.lambda[10][0][0] - z.lambda[10][0][0];
  for (Index i = 0; i < mesh.node_count(); ++i)
    apart = std::max(apart, magnitude(Point(y.phi(20, i) - z.phi(20, i))));
  for (int K = 0; K < 9; ++K) BOOST_TEST(std::abs(y.lambda[10][K][0] - z.lambda[10][K][0] - level) < 1e-9);
  BOOST_TEST(std::abs(level) > 1e-3);
  BOOST_TEST(apart < 1e-12);
}

BOOST_AUTO_TEST_CASE(corners_in_space_contradict_closed_walls) {
  // What 27 cells gain in volume their walls do not give, and yet the corners say so.
  SpaceTimeMesh<double, 3> const mesh(
      equal_steps(0.0, 0.1, 2), {3, 3, 3}, all_sides<3>(Side::sliding),
      StraightBox<double, 3>{Matrix<double, 3, 1>::Zero(), Matrix<double, 3, 1>::Constant(3.0)});
  auto const body =
      incompressible(Continuum{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{1.0}, NoStoredEnergy{}});
  auto const v = velocities<3>(mesh, [](Matrix<double, 3, 1> const& X) {
    double const p = 3.14159265358979323846 / 3;
    auto const cell = [&](int i, int j, int k) {
      return std::sin(p * X[i]) * std::cos(p * X[j]) * std::cos(2 * p * X[k]);
    };
    return Matrix<double, 3, 1>(cell(0, 1, 2), cell(1, 2, 0), cell(2, 0, 1));
  });
  auto y = at_rest<3>(mesh);
  CHECK_REFUSED(first_step(body, mesh, y, v, AtRest{}, Pinned{13}), InconsistentConstraints);
  BOOST_TEST(y.last() == 0);
  // The volumes of the cells do not.
  AugmentedDensity const held(body.density, CellVolumes{});
  first_step(held, mesh, y, v, AtRest{}, Pinned{13});
  step(held, mesh, y, AtRest{}, Pinned{13});
  double worst = 0, moved = 0;
  mesh.for_cells([&](GridIndex<3> const& cell) {
    worst = std::max(worst, std::abs(constraint_of_cell(CellVolumes{}, cell_of(mesh, y.phi, 1, cell), 1)[0]));
  });
  for (Index i = 0; i < mesh.node_count(); ++i)
    moved = std::max(moved, magnitude(Matrix<double, 3, 1>(y.phi(2, i) - y.phi(0, i))));
  // Volumes of one, from products of three numbers up to three.
  BOOST_TEST(worst < 64 * epsilon<double>());
  BOOST_TEST(moved > 0.05);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_stepped_with_multipliers_is_refused_and_leaves_the_section_as_it_was) {
  auto const mesh = square(all_sides<2>(Side::free), 3);
  auto y = at_rest<2>(mesh);
  auto const still = velocities<2>(mesh, [](Point const&) { return Point(0, 0); });
  CHECK_REFUSED(step(water(), mesh, y), NotAMesh);
  CHECK_REFUSED(first_step(water(), mesh, y, {}), NotAMesh);
  CHECK_REFUSED(first_step(water(), mesh, y, still, AtRest{}, Pinned{9}), NotAMesh);
  // A constraint on velocities.
  auto const slow = constraint<1>([]<class S>(Jet<S, 2, 2> const& j) {
    return Matrix<S, 1, 1>(j.v(0, 0) * j.v(0, 0) + j.v(1, 1) - 1.0);
  });
  AugmentedDensity const skates(water().density, slow);
  auto const v = velocities<2>(mesh, [](Point const&) { return Point(0.5, 0); });
  CHECK_REFUSED(first_step(skates, mesh, y, v), NotSpatial);
  // A step in which the cells would have to turn over.
  auto const fast = velocities<2>(mesh, [](Point const& X) { return Point(-120 * X[1], 90 * X[0]); });
  CHECK_REFUSED(first_step(water(), mesh, y, fast), Error);
  BOOST_TEST(y.last() == 0);
  BOOST_TEST(y.lambda.size() == 1u);
}
