// The optimised implementation of media in space: held to a plain loop in matrices of Eigen, to the plane and
// to itself.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>
#include <cstring>

#include "../../benchmarks/peers/gathered_medium.hpp"
#include "actio/fast_media/fast_medium_2d.hpp"
#include "actio/fast_media/fast_medium_3d.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Place = std::array<double, 3>;
using enum Side;

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
  FastBox3d::Ends const round{periodic, periodic}, loose{Side::free, Side::free}, held{fixed, Side::free},
      slides{sliding, sliding};
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
  // A row of eight registers, whose places in memory are further apart than others'.
  out.push_back({{29, 2, 2}, {0.1, 0.13, 0.11}, {slides, round, held}, {0.4, -0.3, 0.2}});
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
    for (Registers const registers : usable_registers()) {
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
/// A motion that does not depend on Z, between two walls that it slides along.
template <class Medium>
void moves_as_in_the_plane(Medium const& medium, double modulus) {
  int const steps = 40;
  double const dt = 0.01;
  FastBox3d const box{{9, 4, 3},
                      {0.1, 0.13, 0.12},
                      {FastBox3d::Ends{Side::free, fixed}, FastBox3d::Ends{periodic, periodic},
                       FastBox3d::Ends{sliding, sliding}}};
  FastBox2d const plane{{9, 4}, {0.1, 0.13}, {Side::free, fixed}, {periodic, periodic}};
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

BOOST_AUTO_TEST_SUITE_END()
