// The optimised implementation of media in space: held to the generic implementation, and what it refuses.
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include "actio/continuum/materials.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"
#include "caught.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::media;
using testing::caught;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Place = std::array<double, 3>;
using enum Side;
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_ways_in_space)

namespace {
/// The generic implementation: one level by the optimised implementation, the others by the discrete
/// Euler-Lagrange field equations of the density, by duals.
template <class Medium, class Energy>
void ways_agree(Medium const& medium, Energy const& energy, FastBox3d::Ends const (&fast_sides)[3],
                Side const (&general)[3]) {
  int const steps = 6;
  double const dt = 0.01, density = 2.5;
  FastBox3d const box{{4, 3, 2}, {0.1, 0.13, 0.11}, {fast_sides[0], fast_sides[1], fast_sides[2]}};
  // Whoever is held is at rest.
  auto const bump = [&](Place const& X) {
    double product = 1;
    for (int d = 0; d < 3; ++d) product *= std::sin(M_PI * X[d] / (box.cells[d] * box.spacing[d]));
    return product * product;
  };
  FastMedium3d fast(
      medium, box, dt, density,
      [&](Place const& X) {
        double const b = 0.02 * bump(X);
        return Place{X[0] + b * (X[1] + X[2]), X[1] - b, X[2] + b * X[0]};
      },
      [&](Place const& X) {
        return Place{0.2 * bump(X), -0.1 * bump(X) * X[0], 0.1 * bump(X) * X[1]};
      });
  std::vector<double> times;
  for (int k = 0; k <= steps + 1; ++k) times.push_back(k * dt);
  Sides<3> sides;
  for (int d = 0; d < 3; ++d) sides[d] = {general[d], general[d]};
  Eigen::Vector3d const lengths(0.4, 3 * 0.13, 0.22);
  SpaceTimeMesh<double, 3> const mesh(times, GridIndex<3>{{4, 3, 2}}, sides,
                                      StraightBox<double, 3>{Eigen::Vector3d::Zero(), lengths});
  DiscreteSection<double, 3, 3> section;
  section.jump << lengths[0], 0, 0, 0, lengths[1], 0, 0, 0, lengths[2];
  auto const add = [&] {
    section.levels.emplace_back();
    for (auto const& p : fast.places()) section.levels.back().push_back({p[0], p[1], p[2]});
  };
  add(), fast.step(), add();
  Continuum const continuum{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{density}, energy};
  for (int k = 0; k < steps; ++k) step(continuum, mesh, section);
  fast.step(steps);
  auto const x = fast.places();
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    worst = std::max(worst, (section.levels.back()[k] - Eigen::Vector3d(x[k].data())).norm());
  // The generic implementation solves each level to 64 roundings of places below 1, and both lose some 200
  // roundings of a kick, dt^2 times a modulus below 4 over h; what a step is off goes on as a velocity.
  double const h = 0.1, a_step = eps * (64 + 200 * dt * dt * 4 / h * (1 + 1 / h));
  BOOST_TEST_MESSAGE("in space the optimised implementation and the generic implementation differ by "
                     << worst);
  BOOST_TEST(worst <= a_step * steps * (steps + 1) / 2);
}
}  // namespace

BOOST_AUTO_TEST_CASE(both_ways_are_the_same_to_rounding) {
  FastBox3d::Ends const loose{Side::free, Side::free}, held{fixed, fixed}, round{periodic, periodic};
  for (auto const& [fast, general] :
       {std::pair{std::array{loose, held, round}, std::array{Side::free, Side::fixed, Side::periodic}},
        {std::array{round, loose, loose}, std::array{Side::periodic, Side::free, Side::free}}}) {
    FastBox3d::Ends const fast_sides[3] = {fast[0], fast[1], fast[2]};
    Side const sides[3] = {general[0], general[1], general[2]};
    ways_agree(FastFluid{PolytropicByRoots<1, 2>{0.7}}, Barotropic{WholePolytropic<double, 1>{0.7}},
               fast_sides, sides);
    ways_agree(FastStVenantKirchhoff{0.9, 0.6}, OfGreenTensor{StVenantKirchhoff<double>{0.9, 0.6}},
               fast_sides, sides);
    ways_agree(neo_hookean(0.9, 0.6), OfGreenTensor{NeoHookean{0.6, LogarithmicVolume<double>{0.9}}},
               fast_sides, sides);
  }
}

BOOST_AUTO_TEST_CASE(a_homogeneous_deformation_stores_its_energy_times_the_volume) {
  Eigen::Matrix3d F;
  F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.3, -0.15, 0.1, 1.2;
  Eigen::Matrix3d const C = F.transpose() * F, E = (C - Eigen::Matrix3d::Identity()) / 2;
  double const J = F.determinant(), density = 2.5, volume = 0.4 * 0.39 * 0.22;
  auto const stored = [&](auto const& medium) {
    FastMedium3d const body(
        medium, FastBox3d{{4, 3, 2}, {0.1, 0.13, 0.11}}, 0.01, density,
        [&](Place const& X) {
          Eigen::Vector3d const x = F * Eigen::Vector3d(X.data());
          return Place{x[0], x[1], x[2]};
        },
        [](Place const&) { return Place{}; });
    // Rounding of places is 10 to 30 times as large in the edges of the cells.
    return body.energy() / (density * volume);
  };
  double const log_J = std::log(J), trace = C.trace() - 3, bound = 200 * eps;
  BOOST_TEST(std::abs(stored(FastFluid{PolytropicByRoots<1, 2>{0.7}}) - 0.7 / J) <= bound);
  BOOST_TEST(std::abs(stored(neo_hookean(0.9, 0.6)) - (0.3 * trace - 0.6 * log_J + 0.45 * log_J * log_J)) <=
             bound);
  BOOST_TEST(std::abs(stored(FastStVenantKirchhoff{0.9, 0.6}) -
                      (0.45 * E.trace() * E.trace() + 0.6 * (E * E).trace())) <= bound);
}

namespace {
/// A solid that does not resist collapse, whose left side is thrown against the right.
FastMedium3d<FastStVenantKirchhoff> thrown(FastOptions const& options = {}) {
  FastBox3d const box{{12, 5, 4},
                      {0.1, 0.1, 0.1},
                      {FastBox3d::Ends{fixed, fixed}, FastBox3d::Ends{Side::free, Side::free},
                       FastBox3d::Ends{Side::free, Side::free}}};
  return {FastStVenantKirchhoff{0.3, 0.2},
          box,
          0.02,
          1,
          [](Place const& X) { return X; },
          [](Place const& X) {
            return Place{X[0] < 0.5 ? 1.5 : 0, 0.1 * X[1], 0.05 * X[2] * X[1]};
          },
          options};
}
/// The least Jacobian of the corners of a cell.
double least_jacobian(std::vector<Place> const& x, FastBox3d const& box, std::array<int, 3> const& cell) {
  double least = HUGE_VAL;
  auto const at = [&](int i, int j, int k) {
    return Eigen::Vector3d(x[static_cast<std::size_t>((k * box.nodes(1) + j) * box.nodes(0) + i)].data());
  };
  for (int k = 0; k < 8; ++k) {
    int const i = cell[0] + k % 2, j = cell[1] + k / 2 % 2, l = cell[2] + k / 4;
    Eigen::Matrix3d F;
    F << at(cell[0] + 1, j, l) - at(cell[0], j, l), at(i, cell[1] + 1, l) - at(i, cell[1], l),
        at(i, j, cell[2] + 1) - at(i, j, cell[2]);
    least = std::min(least, F.determinant() / box.measure());
  }
  return least;
}
}  // namespace

BOOST_AUTO_TEST_CASE(a_cell_about_to_turn_inside_out_is_refused_with_the_state_before) {
  auto medium = thrown();
  CellInverts const found = caught<CellInverts>([&] { medium.step(1000); });
  BOOST_TEST(medium.steps() == found.step - 1);
  BOOST_TEST(found.measured <= 0);
  BOOST_TEST(found.largest_step > 0.02);
  BOOST_TEST(std::string(found.what()).find("inside out") != std::string::npos);
  double least = HUGE_VAL;
  media::detail::for_indices(medium.box().cells, [&](auto const& cell) {
    least = std::min(least, least_jacobian(medium.places(), medium.box(), cell));
  });
  BOOST_TEST(least > 0);
  // The step that is refused, made by hand: x + dt v with the velocities after it is inside out there.
  auto x = medium.places();
  auto const v = medium.velocities(), v_before = medium.velocities_half_a_step_ago();
  for (std::size_t k = 0; k < x.size(); ++k)
    for (std::size_t d = 0; d < 3; ++d) x[k][d] += 0.02 * (2 * v[k][d] - v_before[k][d]);
  BOOST_TEST(std::abs(least_jacobian(x, medium.box(), found.cell) - found.measured) <= 1e-12);
  for (int const threads : {2, 4}) {
    auto other = thrown({threads});
    CellInverts const again = caught<CellInverts>([&] { other.step(1000); });
    BOOST_TEST((again.step == found.step && again.cell == found.cell && again.measured == found.measured));
    BOOST_TEST(other.places() == medium.places());
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_medium_in_space_is_refused_at_once) {
  FastStVenantKirchhoff const solid{0.3, 0.2};
  auto const with = [&](FastBox3d const& box, double dt, double flat) {
    FastMedium3d(
        solid, box, dt, 1,
        [&](Place const& X) {
          return Place{X[0], X[1], flat * X[2]};
        },
        [](Place const&) { return Place{}; });
  };
  FastBox3d const box{{4, 4, 4}, {0.1, 0.1, 0.1}};
  FastBox3d half = box;
  half.sides[2] = {periodic, Side::free};
  with(box, 0.01, 1);
  CHECK_REFUSED(with({{4, 0, 4}, {0.1, 0.1, 0.1}}, 0.01, 1), OutsideDomain);
  CHECK_REFUSED(with({{4, 4, 4}, {0.1, 0.1, -0.1}}, 0.01, 1), OutsideDomain);
  CHECK_REFUSED(with({{4, 4, 4}, {0.1, NAN, 0.1}}, 0.01, 1), NotFinite);
  CHECK_REFUSED(with(half, 0.01, 1), OutsideDomain);
  CHECK_REFUSED(with(box, 0, 1), OutsideDomain);
  CHECK_REFUSED(with(box, 0.01, -1), CellInverts);
  CHECK_REFUSED(with(box, 0.01, NAN), NotFinite);
  CHECK_REFUSED(thrown().step(-1), OutsideDomain);
  CHECK_REFUSED(thrown().go_on_from({}), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
