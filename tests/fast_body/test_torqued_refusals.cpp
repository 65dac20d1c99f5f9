// Torques and bodies under a torque that there are not: which number was out of bounds, and by what. And the
// torque of gravity in an orbit, against its potential.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include <set>

#include "actio/fast_body/space/torqued_batch.hpp"
#include "actio/fast_body/space/uniform_gravity.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Moment = Momentum<SO<3>, double>;
using Attitude = Element<SU2, double>;

Inertia<3> const inertia = inertia_from_moments(0.8, 1.0, 0.6);
Moment const start{SO<3>{}, {0.5, 0.9, 0.4}};
Attitude const attitude{SU2{}, Vector4d(1, 0.2, 0.3, -0.4).normalized()};
Vector3d const towards(1, 2, 0.5), normal(0, 0.3, 1);
auto const no_torque = [](Four<double> const&, double) { return Three<double>{0, 0, 0}; };

/// The measured number and the bound of a refusal.
template <class F>
std::pair<double, double> refused(F const& f) {
  try {
    f();
  } catch (OutsideDomain const& refusal) {
    return {refusal.measured, refusal.bound};
  }
  throw std::logic_error("nothing was refused");
}
Vector3d vector(Three<double> const& x) { return {x[0], x[1], x[2]}; }
}  // namespace

BOOST_AUTO_TEST_SUITE(torqued_refusals)

BOOST_AUTO_TEST_CASE(a_circular_orbit_has_the_strength_of_three_times_its_rate_squared) {
  double const rate = 0.7;
  auto const torque = gravity_gradient_in_orbit(inertia, rate, 5 * towards, 0.01 * normal);
  BOOST_TEST(std::abs(torque.strength - 3 * rate * rate) <= 4 * eps);
  BOOST_TEST(torque.rate == rate);
  Vector3d const n = towards.normalized(), ahead = normal.cross(n).normalized();
  BOOST_TEST((vector(torque.towards) - n).norm() <= 8 * eps);
  BOOST_TEST((vector(torque.ahead) - ahead).norm() <= 8 * eps);
  for (double const t : {0.0, 0.4, -2.0, 9.0})
    BOOST_TEST((vector(torque.direction(t)) - (std::cos(rate * t) * n + std::sin(rate * t) * ahead)).norm() <=
               16 * eps);
  // Where the centre stands still the time makes no difference.
  auto const still = gravity_gradient(inertia, 1.5, 0.2 * towards);
  BOOST_TEST((vector(still.direction(3)) - n).norm() <= 8 * eps);
  BOOST_TEST((still.strength == 1.5 && still.rate == 0));
}

BOOST_AUTO_TEST_CASE(the_torque_in_an_orbit_is_what_the_potential_falls_by_at_each_time) {
  auto const torque = gravity_gradient_in_orbit(inertia, 0.7, towards, normal);
  auto const& q = attitude.value;
  double const small = 1e-5;
  for (double const t : {0.0, 0.9, -3.0}) {
    Three<double> const found = torque({q[0], q[1], q[2], q[3]}, t);
    for (int i = 0; i < 3; ++i) {
      auto const turned = [&](double angle) {
        return attitude * exp(velocity(SU2{}, Vector3d(angle * Vector3d::Unit(i))));
      };
      double const slope =
          (torque.potential(turned(small), t) - torque.potential(turned(-small), t)) / (2 * small);
      // The difference is of second order, and has an error of epsilon over the angle.
      BOOST_TEST(std::abs(found[i] + slope) <= 4 * torque.strength * (small * small + eps / small));
    }
    // V = 3 mu/(2 r^3) n.I n, with n from the matrix of the attitude.
    Vector3d n;
    for (int i = 0; i < 3; ++i)
      n[i] = vector(torque.direction(t)).dot(Vector3d(SU2::Ad<double>(q, Vector3d(Vector3d::Unit(i)))));
    BOOST_TEST(std::abs(torque.potential(attitude, t) -
                        torque.strength / 2 * n.dot(n.cwiseProduct(Vector3d(inertia.moments)))) <= 32 * eps);
  }
}

BOOST_AUTO_TEST_CASE(directions_and_strengths_that_are_none_are_named) {
  using Pair = std::pair<double, double>;
  BOOST_TEST((refused([] { gravity_gradient(inertia, -0.5, towards); }) == Pair{-0.5, 0}));
  BOOST_TEST((refused([] { gravity_gradient(inertia, 1, Vector3d::Zero()); }) == Pair{0, 0}));
  BOOST_CHECK_NO_THROW(gravity_gradient(inertia, 0, towards));
  BOOST_CHECK_NO_THROW(gravity_gradient(inertia, 1, 1e-300 * towards));
  CHECK_REFUSED(gravity_gradient(inertia, std::nan(""), towards), NotFinite);
  CHECK_REFUSED(gravity_gradient(inertia, 1, Vector3d(0, INFINITY, 1)), NotFinite);
  CHECK_REFUSED(gravity_gradient_in_orbit(inertia, std::nan(""), towards, normal), NotFinite);
  CHECK_REFUSED(gravity_gradient_in_orbit(inertia, 1, towards, Vector3d(0, std::nan(""), 1)), NotFinite);
  // The sine of the angle between the normal and the direction.
  for (double const sine : {0x1p-30, 0x1p-27}) {
    Vector3d const beside(sine, 1, 0);
    auto const [measured, bound] =
        refused([&] { gravity_gradient_in_orbit(inertia, 1, Vector3d(0, 3, 0), beside); });
    BOOST_TEST(std::abs(measured / sine - 1) <= 1e-12);
    BOOST_TEST(bound == 1e-8);
  }
  BOOST_CHECK_NO_THROW(gravity_gradient_in_orbit(inertia, 1, Vector3d(0, 3, 0), Vector3d(0x1p-26, 1, 0)));
  BOOST_TEST((refused([] { uniform_gravity(Vector3d(1, 2, 3), Vector3d::Zero()); }) == Pair{0, 0}));
}

BOOST_AUTO_TEST_CASE(splittings_have_one_kick_more_than_drifts_and_parts_that_add_up) {
  using Pair = std::pair<double, double>;
  auto const [sum, one] = refused([] { composed_splitting("short", 2, {0.5, 0.25}); });
  BOOST_TEST((sum == 0.75 && one == 1));
  CHECK_REFUSED(composed_splitting("none", 2, {0.5, std::nan("")}), NotFinite);
  CHECK_REFUSED(composed_splitting("near", 2, {0.5, 0.5 + 64 * eps}), OutsideDomain);
  BOOST_CHECK_NO_THROW(composed_splitting("nearer", 2, {0.5, 0.5 + 8 * eps}));
  // Fractions that are larger than the step are rounded by more.
  BOOST_CHECK_NO_THROW(composed_splitting("long", 2, {-100, 101 + 1024 * eps}));
  auto const three = composed_splitting("three", 4, {0.5, -0.25, 0.75});
  BOOST_TEST((three.name == "three" && three.order == 4));
  BOOST_TEST((three.kicks == std::vector<double>{0.25, 0.125, 0.25, 0.375}));
  BOOST_TEST((three.drifts == std::vector<double>{0.5, -0.25, 0.75}));
  for (auto const& method : {strang_splitting(), blanes_moan_splitting(), three}) {
    double kicks = 0, drifts = 0;
    for (double const c : method.kicks) kicks += c;
    for (double const c : method.drifts) drifts += c;
    BOOST_TEST(std::abs(kicks - 1) <= 8 * eps);
    BOOST_TEST(std::abs(drifts - 1) <= 8 * eps);
  }
  Splitting const bad{"bad", 1, {1}, {0.5, 0.5}}, empty{"empty", 1, {1}, {}};
  BOOST_TEST((refused([&] { TorquedBody(inertia, start, attitude, no_torque, 0.1, bad); }) == Pair{1, 3}));
  BOOST_TEST((refused([&] { TorquedBody(inertia, start, attitude, no_torque, 0.1, empty); }) == Pair{1, 1}));
  BOOST_TEST((refused([&] { TorquedBatch(0.1, bad); }) == Pair{1, 3}));
  BOOST_TEST((refused([&] { TorquedBatch(0.1, empty); }) == Pair{1, 1}));
}

BOOST_AUTO_TEST_CASE(steps_and_counts_that_are_none_are_named) {
  using Pair = std::pair<double, double>;
  TorquedBody body(inertia, start, attitude, no_torque, 0.25, strang_splitting(), 3);
  BOOST_TEST((refused([&] { body.step(-2); }) == Pair{-2, 0}));
  BOOST_TEST(body.time() == 3);
  body.step(0), body.step(4);
  BOOST_TEST((body.time() == 4 && body.step_length() == 0.25 && body.method().name == "Strang"));
  CHECK_REFUSED(TorquedBody(inertia, start, attitude, no_torque, 0.25, strang_splitting(), NAN), NotFinite);
  BOOST_TEST((refused([] { TorquedBody(inertia, start, attitude, no_torque, 0.0); }) == Pair{0, 0}));
  CHECK_REFUSED(TorquedBody(inertia, {SO<3>{}, 1e200 * start.components}, attitude, no_torque, 1.0),
                NotFinite);

  auto const torque = gravity_gradient(inertia, 1.5, towards);
  CHECK_REFUSED(TorquedBatch(std::nan("")), NotFinite);
  BOOST_TEST((refused([] { TorquedBatch(0.0); }) == Pair{0, 0}));
  TorquedBatch batch(0.5);
  BOOST_TEST((batch.size() == 0 && batch.step_length() == 0.5));
  for (std::size_t i = 0; i < 5; ++i) BOOST_TEST(batch.add(inertia, start, attitude, torque) == i);
  BOOST_TEST((refused([&] { batch.step(-3); }) == Pair{-3, 0}));
  BOOST_TEST((refused([&] { (void)batch.state(5); }) == Pair{5, 5}));
  BOOST_TEST((refused([&] { (void)batch.state(7); }) == Pair{7, 5}));
  batch.step(3);
  BOOST_TEST(batch.time() == 1.5);
  std::vector<Inertia<3>> const two(2, inertia);
  std::vector<Moment> const momenta(3, start);
  std::vector<Attitude> const attitudes(2, attitude);
  std::vector<GravityGradient> const torques(4, torque);
  BOOST_TEST((refused([&] { TorquedBatch(two, momenta, attitudes, torques, 0.1); }) == Pair{3, 2}));
  BOOST_TEST((refused([&] { TorquedBatch(two, {start, start}, attitudes, torques, 0.1); }) == Pair{4, 2}));
  BOOST_TEST((refused([&] {
                TorquedBatch(two, {start, start}, {attitude}, {torque, torque}, 0.1);
              }) == Pair{1, 2}));

  BodyBatch free(0.5);
  BOOST_TEST((refused([] { BodyBatch(0.0); }) == Pair{0, 0}));
  BOOST_TEST((refused([&] { free.step(-1); }) == Pair{-1, 0}));
  BOOST_TEST((refused([&] { free.step_momentum(-4); }) == Pair{-4, 0}));
  BOOST_TEST(free.add(inertia, start, attitude) == 0u);
  BOOST_TEST((refused([&] { (void)free.momentum(1); }) == Pair{1, 1}));
  BOOST_TEST((refused([&] { (void)free.attitude(6); }) == Pair{6, 1}));
  free.step_momentum(0);
  BOOST_CHECK_NO_THROW((void)free.attitude(0));
  free.step_momentum(2);
  BOOST_TEST((refused([&] { (void)free.attitude(0); }) == Pair{0, 1}));
  BOOST_TEST((free.time() == 1 && free.step_length() == 0.5));
  BOOST_TEST((refused([&] { BodyBatch(two, momenta, attitudes, 0.1); }) == Pair{3, 2}));
  BOOST_TEST((refused([&] { BodyBatch(two, {start, start}, {attitude}, 0.1); }) == Pair{1, 2}));
}

BOOST_AUTO_TEST_CASE(rows_of_steps_end_where_those_of_one_body_do) {
  auto const torque = gravity_gradient_in_orbit(inertia, 0.7, towards, normal);
  for (auto const& method : {strang_splitting(), blanes_moan_splitting()})
    for (long const steps : {1L, 63L, 64L, 65L, 128L, 129L}) {
      TorquedBatch batch(0.05, method);
      for (int i = 0; i < 3; ++i) batch.add(inertia, start, attitude, torque);
      TorquedBody alone(inertia, start, attitude, torque, 0.05, method);
      batch.step(steps), alone.step(steps);
      // Twenty roundings a drift, magnified by the angle turned since.
      double const room = 20 * eps * static_cast<double>(steps) * static_cast<double>(method.drifts.size()) *
                          (1 + 0.1 * static_cast<double>(steps));
      for (std::size_t i = 0; i < 3; ++i) {
        BOOST_TEST((batch.state(i).body_momentum - alone.state().body_momentum).components.norm() <= room);
        BOOST_TEST((batch.state(i).attitude.value - alone.state().attitude.value).norm() <= room);
      }
    }
}

// About the third axis, faster than an angle can be told, under a torque about that axis: the first kick
// brakes, the last one may take the momentum beyond the numbers. Then that body is refused, and its
// neighbours go on.
BOOST_AUTO_TEST_CASE(a_momentum_that_becomes_no_number_takes_no_neighbour_with_it) {
  auto const weak = gravity_gradient(inertia, 1.5, towards),
             strong = gravity_gradient(inertia, 5.6e153, Vector3d(1, 0.02, 0));
  TorquedBatch batch(4), others(4);
  for (int i = 0; i < 20; ++i) {
    Moment const fast{SO<3>{}, {0, 0, -1.335e154 * (1 - 1e-3 * i)}};
    if (i % 5 == 2)
      batch.add(inertia, start, attitude, weak), others.add(inertia, start, attitude, weak);
    else
      batch.add(inertia, fast, identity<double>(SU2{}), strong), others.add(inertia, start, attitude, weak);
  }
  batch.step(), others.step();
  std::set<std::size_t> refused;
  for (auto const& why : batch.refused()) {
    refused.insert(why.index);
    BOOST_TEST(why.index % 5 != 2);
    BOOST_TEST(std::string(why.what()) ==
               "body " + std::to_string(why.index) + ": torqued body: the momentum has become no number");
    CHECK_REFUSED((void)batch.state(why.index), BodyRefused);
  }
  BOOST_TEST((0 < refused.size() && refused.size() < 16));
  BOOST_TEST(refused.size() == batch.refused().size());
  for (std::size_t i = 0; i < 20; ++i) {
    if (refused.count(i)) continue;
    BOOST_TEST(is_finite(batch.state(i).body_momentum.components));
    if (i % 5 != 2) continue;
    BOOST_TEST((batch.state(i).body_momentum.components == others.state(i).body_momentum.components));
    BOOST_TEST((batch.state(i).attitude.value == others.state(i).attitude.value));
  }
  BOOST_TEST(batch.time() == 4);
}

BOOST_AUTO_TEST_SUITE_END()
