// The fast road of media in space: held to the general road, to a plain loop in matrices of Eigen, to the
// plane and to itself.
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <random>

#include "../../benchmarks/peers/gathered_medium.hpp"
#include "actio/continuum/materials.hpp"
#include "actio/multisymplectic/fast_medium_2d.hpp"
#include "actio/multisymplectic/fast_medium_3d.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"

using namespace actio;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Place = std::array<double, 3>;
using enum FastSide;

/// A smooth motion, rough enough that no two cells are alike; periodic where the box is, and zero at no side.
struct Start {
  FastBox3d box;
  double phase(Place const& X, int d) const {
    return 2 * M_PI * (X[d] - box.origin[d]) / (box.cells[d] * box.spacing[d]);
  }
  Place place(Place const& X) const {
    double const a = phase(X, 0), b = phase(X, 1), c = phase(X, 2);
    double const size = 0.03 * std::min({box.spacing[0], box.spacing[1], box.spacing[2]});
    Place out{size * (std::sin(a + 2 * b) + std::cos(3 * a - c)),
              size * (std::cos(2 * a - b) - std::sin(2 * c)), size * (std::sin(a - c) + std::cos(b + c))};
    for (int d = 0; d < 3; ++d) {
      auto const shift = box.shift(d);
      double const part = phase(X, d) / (2 * M_PI);
      out[0] += part * shift.x, out[1] += part * shift.y, out[2] += part * shift.z;
    }
    return out;
  }
  Place velocity(Place const& X) const {
    double const a = phase(X, 0), b = phase(X, 1), c = phase(X, 2);
    return {0.02 * std::sin(b - c) + 0.05, 0.02 * std::cos(a - b) - 0.02, 0.02 * std::sin(a + c)};
  }
};
template <class Medium>
FastMedium3d<Medium> let_go(Medium const& medium, FastBox3d const& box, double dt,
                            FastOptions const& options = {}) {
  Start const start{box};
  return {medium,
          box,
          dt,
          2.5,
          [&](Place const& X) { return start.place(X); },
          [&](Place const& X) { return start.velocity(X); },
          options};
}

/// Boxes of all kinds of sides, with rows that fill registers and that do not, and the smallest ones.
std::vector<FastBox3d> boxes() {
  std::vector<FastBox3d> out;
  FastBox3d::Ends const round{periodic, periodic}, loose{FastSide::free, FastSide::free},
      held{fixed, FastSide::free}, slides{sliding, sliding};
  FastBox3d::Ends const pairs[] = {round, loose, held, slides};
  int const sizes[][3] = {{1, 1, 1}, {2, 1, 3},  {3, 2, 1},  {4, 3, 2},
                          {7, 2, 5}, {11, 3, 2}, {13, 4, 3}, {16, 2, 2}};
  int k = 0;
  for (auto const& size : sizes)
    for (auto const& first : pairs) {
      auto const &second = pairs[(k / 4 + k) % 4], &third = pairs[(k / 2) % 4];
      out.push_back(
          {{size[0], size[1], size[2]}, {0.1, 0.13, 0.11}, {first, second, third}, {0.4, -0.3, 0.2}});
      ++k;
    }
  // A block that is sheared and stretched, and periodic as such.
  out.push_back({{5, 4, 3},
                 {0.1, 0.08, 0.12},
                 {round, round, round},
                 {0, 0, 0},
                 {{{0.49, 0.1, 0.02}, {0.05, 0.3, -0.03}, {0.01, 0.06, 0.37}}}});
  return out;
}
double farthest(std::vector<Place> const& x) {
  double most = 0;
  for (auto const& p : x) most = std::max(most, std::hypot(p[0], p[1], p[2]));
  return most;
}
/// The most that rounding makes of the difference of two ways to compute so many steps. A force is a sum of
/// terms of the size of a stress times an area; there are at most 200 roundings among them, and what edges
/// have lost by the subtraction of places: 2 eps |x|/h of F, times the modulus. The linearised scheme is
/// stable, so that errors of velocities add up, and those of places are their sum.
double room(FastBox3d const& box, double dt, int steps, double modulus, double most) {
  double const h = std::min({box.spacing[0], box.spacing[1], box.spacing[2]}), t = dt * steps;
  double const rate = 4 / h * modulus * eps * (200 + 2 * most / h);
  return 2 * t * t * rate + steps * eps * most;
}

template <class Medium, class Stress>
void agrees_with_plain_loop(Medium const& medium, Stress const& stress, double modulus) {
  for (auto const& box : boxes())
    for (Registers const registers : {Registers::plain, best_registers()}) {
      double const dt = 0.01;
      int const steps = 30;
      auto fast = let_go(medium, box, dt, {2, 0, registers});
      auto plain = peers::gathered(stress, box, dt, fast.places(), fast.velocities());
      fast.step(steps);
      for (int k = 0; k < steps; ++k) plain.step();
      auto const x = fast.places(), v = fast.velocities_half_a_step_ago();
      double worst = 0, worst_v = 0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        worst = std::max(worst, (plain.x[k] - Eigen::Vector3d(x[k].data())).norm());
        worst_v = std::max(worst_v, (plain.v[k] - Eigen::Vector3d(v[k].data())).norm());
      }
      double const bound = room(box, dt, steps, modulus, farthest(x));
      BOOST_TEST_INFO(box.cells[0] << " x " << box.cells[1] << " x " << box.cells[2] << " cells, "
                                   << name_of(registers));
      BOOST_TEST((worst <= bound && worst_v <= bound / dt),
                 "the plain loop is off by " << worst << " and " << worst_v << ", rounding by " << bound);
    }
}
bool same(std::vector<Place> const& x, std::vector<Place> const& y) {
  return x.size() == y.size() && !std::memcmp(x.data(), y.data(), x.size() * sizeof(Place));
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_media_in_space)

BOOST_AUTO_TEST_CASE(media_move_as_by_the_plain_loop) {
  agrees_with_plain_loop(FastFluid{PolytropicByRoots<1, 2>{0.7}}, peers::GasOfTwoStress{0.7}, 0.7 * 4);
  agrees_with_plain_loop(FastStVenantKirchhoff{0.9, 0.6}, peers::StVenantKirchhoffStress{0.9, 0.6}, 5);
  agrees_with_plain_loop(neo_hookean(0.9, 0.6), peers::NeoHookeanStress{0.9, 0.6}, 5);
}

BOOST_AUTO_TEST_CASE(threads_calls_and_a_resumed_run_change_no_bit) {
  FastFluid const gas{PolytropicByRoots<1, 2>{0.7}};
  for (auto const& box : boxes()) {
    auto alone = let_go(gas, box, 0.01);
    alone.step(19);
    auto const x = alone.places(), v = alone.velocities_half_a_step_ago();
    for (int const threads : {2, 3, 7}) {
      auto other = let_go(gas, box, 0.01, {threads});
      other.step(3), other.step();
      auto const kept = other.state();
      auto resumed = let_go(gas, box, 0.01);
      resumed.go_on_from(kept), resumed.step(15);
      BOOST_TEST((same(resumed.places(), x) && resumed.steps() == 19));
      other.step(15);
      BOOST_TEST_INFO(box.cells[0] << " x " << box.cells[1] << " x " << box.cells[2] << " cells, " << threads
                                   << " threads");
      BOOST_TEST((same(other.places(), x) && same(other.velocities_half_a_step_ago(), v)));
    }
  }
}

namespace {
/// The general road: one level by the fast road, the others by the discrete Euler-Lagrange field equations of
/// the density, by duals.
template <class Medium, class Energy>
void roads_agree(Medium const& medium, Energy const& energy, FastBox3d::Ends const (&fast_sides)[3],
                 Side const (&general)[3]) {
  int const steps = 6;
  double const dt = 0.01, density = 2.5;
  FastBox3d const box{{4, 3, 2}, {0.1, 0.13, 0.11}, {fast_sides[0], fast_sides[1], fast_sides[2]}};
  FastMedium3d<Medium> fast = let_go(medium, box, dt);
  // Whoever is held is at rest.
  auto const bump = [&](Place const& X) {
    double product = 1;
    for (int d = 0; d < 3; ++d) product *= std::sin(M_PI * X[d] / (box.cells[d] * box.spacing[d]));
    return product * product;
  };
  fast = FastMedium3d<Medium>(
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
  // The general road solves each level to 64 roundings of places below 1, and both lose some 200 roundings of
  // a kick, dt^2 times a modulus below 4 over h; what a step is off goes on as a velocity.
  double const h = 0.1, a_step = eps * (64 + 200 * dt * dt * 4 / h * (1 + 1 / h));
  BOOST_TEST_MESSAGE("in space the fast road and the general road differ by " << worst);
  BOOST_TEST(worst <= a_step * steps * (steps + 1) / 2);
}
}  // namespace

BOOST_AUTO_TEST_CASE(both_roads_are_the_same_to_rounding) {
  FastBox3d::Ends const loose{FastSide::free, FastSide::free}, held{fixed, fixed}, round{periodic, periodic};
  for (auto const& [fast, general] :
       {std::pair{std::array{loose, held, round}, std::array{Side::free, Side::fixed, Side::periodic}},
        {std::array{round, loose, loose}, std::array{Side::periodic, Side::free, Side::free}}}) {
    FastBox3d::Ends const fast_sides[3] = {fast[0], fast[1], fast[2]};
    Side const sides[3] = {general[0], general[1], general[2]};
    roads_agree(FastFluid{PolytropicByRoots<1, 2>{0.7}}, Barotropic{WholePolytropic<double, 1>{0.7}},
                fast_sides, sides);
    roads_agree(FastStVenantKirchhoff{0.9, 0.6}, OfGreenTensor{StVenantKirchhoff<double>{0.9, 0.6}},
                fast_sides, sides);
    roads_agree(neo_hookean(0.9, 0.6), OfGreenTensor{NeoHookean{0.6, LogarithmicVolume<double>{0.9}}},
                fast_sides, sides);
  }
}

namespace {
/// A motion that does not depend on Z, between two walls that it slides along.
template <class Medium>
void moves_as_in_the_plane(Medium const& medium, double modulus) {
  int const steps = 40;
  double const dt = 0.01;
  FastBox3d const box{{9, 4, 3},
                      {0.1, 0.13, 0.12},
                      {FastBox3d::Ends{FastSide::free, fixed}, FastBox3d::Ends{periodic, periodic},
                       FastBox3d::Ends{sliding, sliding}}};
  FastBox2d const plane{{9, 4}, {0.1, 0.13}, {FastSide::free, fixed}, {periodic, periodic}};
  auto const place = [](double X, double Y) {
    double const b = 2 * M_PI * Y / 0.52;
    return std::array{X + 0.01 * std::sin(7 * X + b), Y + 0.01 * std::cos(5 * X - b)};
  };
  FastMedium3d space(
      medium, box, dt, 1,
      [&](Place const& X) {
    auto const p = place(X[0], X[1]);
    return Place{p[0], p[1], X[2]};
      },
      [](Place const& X) {
    return Place{0.1 * X[0], 0.2, 0};
  });
  FastMedium2d flat(
      medium, plane, dt, 1, [&](std::array<double, 2> const& X) { return place(X[0], X[1]); },
      [](std::array<double, 2> const& X) {
    return std::array{0.1 * X[0], 0.2};
      });
  space.step(steps), flat.step(steps);
  auto const x = space.places();
  auto const y = flat.places();
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    auto const& p = y[k % y.size()];
    double const Z = 0.12 * static_cast<double>(k / y.size());
    worst = std::max(worst, std::hypot(x[k][0] - p[0], x[k][1] - p[1], x[k][2] - Z));
  }
  BOOST_TEST_MESSAGE("space and plane differ by " << worst);
  BOOST_TEST(worst <= room(box, dt, steps, modulus, farthest(x)));
}
}  // namespace

BOOST_AUTO_TEST_CASE(what_does_not_depend_on_z_moves_as_in_the_plane) {
  moves_as_in_the_plane(FastFluid{PolytropicByRoots<1, 2>{0.7}}, 0.7 * 4);
  moves_as_in_the_plane(FastStVenantKirchhoff{0.9, 0.6}, 5);
  moves_as_in_the_plane(neo_hookean(0.9, 0.6), 5);
}

// Each step rounds the velocities and places of 210 nodes: as a walk eps sqrt(steps/210), 2e-15 for twenty
// thousand steps, or less than ten times that where the same rounding comes again and again.
BOOST_AUTO_TEST_CASE(a_body_let_go_conserves_momenta_and_its_energy_does_not_drift) {
  FastBox3d const box{{6, 5, 4}, {0.1, 0.1, 0.1}, FastBox3d{}.sides, {-0.3, -0.2, -0.1}};
  FastMedium3d body(
      FastStVenantKirchhoff{1, 0.5}, box, 0.02, 3,
      [](Place const& X) {
    return Place{X[0] * 1.02 + 0.01 * X[1] * X[1], X[1], X[2] - 0.01 * X[0]};
      },
      [](Place const& X) {
    return Place{0.03 - 0.3 * X[1], 0.02 + 0.3 * X[0] - 0.2 * X[2], 0.2 * X[1]};
  });
  Eigen::Vector3d const p(body.momentum().data()), L(body.angular_momentum().data());
  double const E = body.energy();
  double parts = 0;
  for (auto const& v : body.velocities()) parts += 0.003 * std::hypot(v[0], v[1], v[2]);
  double of_p = 0, of_L = 0, of_E = 0, drift = 0;
  for (int k = 0; k < 100; ++k) {
    body.step(200);
    of_p = std::max(of_p, (Eigen::Vector3d(body.momentum().data()) - p).norm() / parts);
    of_L = std::max(of_L, (Eigen::Vector3d(body.angular_momentum().data()) - L).norm() / L.norm());
    double const e = body.energy() / E - 1;
    of_E = std::max(of_E, std::abs(e));
    drift += (k >= 75 ? e : k < 25 ? -e : 0) / 25;
  }
  BOOST_TEST_MESSAGE("solid in space, 20000 steps: momentum " << of_p << ", angular momentum " << of_L
                                                              << ", energy " << of_E
                                                              << ", change of its mean " << drift);
  BOOST_TEST(of_p <= 2e-14);
  BOOST_TEST(of_L <= 2e-14);
  BOOST_TEST(of_E <= 2e-3);
  BOOST_TEST(std::abs(drift) <= 0.5 * of_E);
}

namespace {
/// A solid that does not resist collapse, whose left side is thrown against the right.
FastMedium3d<FastStVenantKirchhoff> thrown(FastOptions const& options = {}) {
  FastBox3d const box{{12, 5, 4},
                      {0.1, 0.1, 0.1},
                      {FastBox3d::Ends{fixed, fixed}, FastBox3d::Ends{FastSide::free, FastSide::free},
                       FastBox3d::Ends{FastSide::free, FastSide::free}}};
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
template <class Try>
CellInverts inversion_in(Try const& tried) {
  try {
    tried();
  } catch (CellInverts const& error) {
    return error;
  }
  BOOST_FAIL("no cell was found inside out");
  throw 0;
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
  CellInverts const found = inversion_in([&] { medium.step(1000); });
  BOOST_TEST(medium.steps() == found.step - 1);
  BOOST_TEST(found.measured <= 0);
  BOOST_TEST(found.largest_step > 0.02);
  BOOST_TEST(std::string(found.what()).find("inside out") != std::string::npos);
  double least = HUGE_VAL;
  detail::for_indices(medium.box().cells, [&](auto const& cell) {
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
    CellInverts const again = inversion_in([&] { other.step(1000); });
    BOOST_TEST((again.step == found.step && again.cell == found.cell && again.measured == found.measured));
    BOOST_TEST(same(other.places(), medium.places()));
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
  half.sides[2] = {periodic, FastSide::free};
  with(box, 0.01, 1);
  BOOST_CHECK_THROW(with({{4, 0, 4}, {0.1, 0.1, 0.1}}, 0.01, 1), OutsideDomain);
  BOOST_CHECK_THROW(with({{4, 4, 4}, {0.1, 0.1, -0.1}}, 0.01, 1), OutsideDomain);
  BOOST_CHECK_THROW(with({{4, 4, 4}, {0.1, NAN, 0.1}}, 0.01, 1), NotFinite);
  BOOST_CHECK_THROW(with(half, 0.01, 1), OutsideDomain);
  BOOST_CHECK_THROW(with(box, 0, 1), OutsideDomain);
  BOOST_CHECK_THROW(with(box, 0.01, -1), CellInverts);
  BOOST_CHECK_THROW(with(box, 0.01, NAN), NotFinite);
  BOOST_CHECK_THROW(thrown().step(-1), OutsideDomain);
  BOOST_CHECK_THROW(thrown().go_on_from({}), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
