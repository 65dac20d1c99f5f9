// Torques and bodies under a torque that there are not: which number was out of bounds, and by what. And the
// torque of gravity in an orbit, against its potential.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/fast_body/space/torqued_body.hpp"
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
std::pair<double, double> refusal(F const& f) {
  try {
    f();
  } catch (OutsideDomain const& why) {
    return {why.measured, why.bound};
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
  BOOST_TEST((refusal([] { gravity_gradient(inertia, -0.5, towards); }) == Pair{-0.5, 0}));
  BOOST_TEST((refusal([] { gravity_gradient(inertia, 1, Vector3d::Zero()); }) == Pair{0, 0}));
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
        refusal([&] { gravity_gradient_in_orbit(inertia, 1, Vector3d(0, 3, 0), beside); });
    BOOST_TEST(std::abs(measured / sine - 1) <= 1e-12);
    BOOST_TEST(bound == 1e-8);
  }
  BOOST_CHECK_NO_THROW(gravity_gradient_in_orbit(inertia, 1, Vector3d(0, 3, 0), Vector3d(0x1p-26, 1, 0)));
  BOOST_TEST((refusal([] { uniform_gravity(Vector3d(1, 2, 3), Vector3d::Zero()); }) == Pair{0, 0}));
}

BOOST_AUTO_TEST_CASE(splittings_have_one_kick_more_than_drifts_and_parts_that_add_up) {
  using Pair = std::pair<double, double>;
  auto const [sum, one] = refusal([] { composed_splitting("short", 2, {0.5, 0.25}); });
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
  BOOST_TEST((refusal([&] { TorquedBody(inertia, start, attitude, no_torque, 0.1, bad); }) == Pair{1, 3}));
  BOOST_TEST((refusal([&] { TorquedBody(inertia, start, attitude, no_torque, 0.1, empty); }) == Pair{1, 1}));
}

BOOST_AUTO_TEST_CASE(steps_and_counts_that_are_none_are_named) {
  using Pair = std::pair<double, double>;
  TorquedBody body(inertia, start, attitude, no_torque, 0.25, strang_splitting(), 3);
  BOOST_TEST((refusal([&] { body.step(-2); }) == Pair{-2, 0}));
  BOOST_TEST(body.time() == 3);
  body.step(0), body.step(4);
  BOOST_TEST((body.time() == 4 && body.step_length() == 0.25 && body.method().name == "Strang"));
  CHECK_REFUSED(TorquedBody(inertia, start, attitude, no_torque, 0.25, strang_splitting(), NAN), NotFinite);
  BOOST_TEST((refusal([] { TorquedBody(inertia, start, attitude, no_torque, 0.0); }) == Pair{0, 0}));
  CHECK_REFUSED(TorquedBody(inertia, {SO<3>{}, 1e200 * start.components}, attitude, no_torque, 1.0),
                NotFinite);
}

BOOST_AUTO_TEST_SUITE_END()
