// Splitting into kicks and exact drifts: orders, and what is conserved.
#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/torqued_body.hpp"
#include "actio/reduction/composition.hpp"
#include "refused.hpp"
#include "witness/number.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Moment = Momentum<SO<3>, double>;
using Attitude = Element<SU2, double>;
using Seven = actio::Vector<double, 7>;

struct Start {
  Inertia<3> inertia = inertia_from_moments(0.8, 1.0, 0.6);
  Moment momentum{SO<3>{}, {0.5, 0.9, 0.4}};
  Attitude attitude{SU2{}, Vector4d(1, 0.2, 0.3, -0.4).normalized()};

  template <class Torque>
  FreeState after(double duration, int steps, Torque const& torque,
                  Splitting const& method = strang_splitting()) const {
    TorquedBody body(inertia, momentum, attitude, torque, duration / steps, method);
    body.step(steps);
    return body.state();
  }
};
Vector3d const towards(1, 2, 0.5), normal(0, 0.3, 1);

Seven together(FreeState const& s) {
  Seven y;
  y << s.body_momentum.components, s.attitude.value;
  return y;
}
double apart(FreeState const& a, FreeState const& b) {
  FreeState turned = b;
  if (a.attitude.value.dot(b.attitude.value) < 0) turned.attitude.value = -b.attitude.value;
  return (together(a) - together(turned)).norm();
}

// M' = M x w + 3 mu/r^3 n x I n, q' = q w/2, with the direction n to the centre brought to the body by a
// matrix.
FreeState solved(Start const& start, double duration, double strength, double rate) {
  Vector3d const I = start.inertia.moments, n0 = towards.normalized(), ahead = normal.cross(n0).normalized();
  auto const equations = [&](double t, Seven const& y) {
    Vector3d const M = y.head<3>(), w = M.cwiseQuotient(I), q = y.tail<3>();
    Eigen::Matrix3d const R = Eigen::Quaterniond(y[3], y[4], y[5], y[6]).normalized().toRotationMatrix();
    Vector3d const n = R.transpose() * (std::cos(rate * t) * n0 + std::sin(rate * t) * ahead);
    Seven change;
    change << M.cross(w) + strength * n.cross(I.cwiseProduct(n)), -0.5 * q.dot(w),
        0.5 * (y[3] * w + q.cross(w));
    return change;
  };
  Seven const end = reference_solution(equations, together({start.momentum, start.attitude}), 0, duration);
  return {{SO<3>{}, end.head<3>()}, {SU2{}, end.tail<4>()}};
}

std::vector<Splitting> methods() {
  return {strang_splitting(), composed_splitting("Suzuki", 4, suzuki<double>()), blanes_moan_splitting()};
}
}  // namespace

BOOST_AUTO_TEST_SUITE(torqued_body)

BOOST_AUTO_TEST_CASE(the_series_leave_out_nothing_beyond_rounding) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  auto const compare = [](auto const& series, double X, double y, double w) {
    // Y is at most X^2/4 and W at most X, from what they are made of.
    double const Y = y * X * X / 4, W = w * X;
    auto const truth = ShortSeries<Number>::by_recursion<30>(Number(X), Number(Y), Number(W));
    auto const found = series(X, Y, W);
    double const off[] = {to_double(found.lever - truth.lever), to_double(found.square - truth.square),
                          to_double(found.mean - truth.mean)};
    for (double const x : off) BOOST_TEST(std::abs(x) <= 2 * eps);
  };
  for (double const y : {0.0, 0.5, 1.0})
    for (double const w : {0.0, 0.5, 1.0})
      for (double const part : {0.0, 0.3, 1.0}) {
        compare(
            [](double X, double Y, double W) {
              return ShortSeries<double>::by_table<5>(bodies::detail::short_table<5>(), X, Y, W);
            },
            part * short_reach<5>, y, w);
        compare(
            [](double X, double Y, double W) {
              return ShortSeries<double>::by_table<8>(bodies::detail::short_table<8>(), X, Y, W);
            },
            part * short_reach<8>, y, w);
      }
}

BOOST_AUTO_TEST_CASE(orders_two_and_four_are_measured) {
  Start const start;
  for (double const rate : {0.0, 0.7}) {
    auto const torque = rate == 0 ? gravity_gradient(start.inertia, 1.5, towards)
                                  : gravity_gradient_in_orbit(start.inertia, rate, towards, normal);
    double const duration = 8;
    FreeState const truth = solved(start, duration, torque.strength, rate);
    for (auto const& method : methods()) {
      std::vector<double> steps, errors;
      for (int count = 64; count <= 1024; count *= 2) {
        steps.push_back(duration / count);
        errors.push_back(apart(start.after(duration, count, torque, method), truth));
      }
      auto const fit = testing::fit_order(steps, errors);
      BOOST_TEST_MESSAGE(method.name << ", mean motion " << rate << ": order " << fit.slope << ", errors "
                                     << errors.front() << " to " << errors.back());
      // Steps are long enough that rounding does not end it, and where the leading terms nearly cancel the
      // next ones still show.
      BOOST_TEST(std::abs(fit.slope - method.order) < (method.name == "Blanes-Moan" ? 0.1 : 0.05));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_step_back_undoes_a_step) {
  Start const start;
  auto const torque = gravity_gradient_in_orbit(start.inertia, 0.7, towards, normal);
  for (auto const& method : methods()) {
    int const steps = 500;
    TorquedBody there(start.inertia, start.momentum, start.attitude, torque, 0.05, method);
    there.step(steps);
    auto const turn = there.state();
    TorquedBody back(start.inertia, turn.body_momentum, turn.attitude, torque, -0.05, method, there.time());
    back.step(steps);
    // Some twenty roundings a drift, which the motion may magnify by the angle turned.
    double const room = 20 * eps * 2 * steps * static_cast<double>(method.drifts.size());
    BOOST_TEST(apart(back.state(), {start.momentum, start.attitude}) <= room);
    BOOST_TEST(std::abs(back.time()) <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(energy_stays_bounded_over_many_steps_and_the_momentum_along_the_direction_stays) {
  Start const start;
  auto const torque = gravity_gradient(start.inertia, 1.5, towards);
  auto const energy = [&](FreeState const& s) {
    return kinetic_energy(start.inertia, s.body_momentum) + torque.potential(s.attitude);
  };
  auto const along = [&](FreeState const& s) {
    return s.spatial_momentum().components.dot(towards.normalized());
  };
  FreeState const first{start.momentum, start.attitude};
  for (auto const& method : {strang_splitting(), blanes_moan_splitting()}) {
    TorquedBody body(start.inertia, start.momentum, start.attitude, torque, 0.1, method);
    double early = 0, late = 0, lost = 0;
    int const rounds = 10000;
    for (int k = 0; k < rounds; ++k) {
      body.step(10);
      auto const s = body.state();
      double const off = std::abs(energy(s) - energy(first));
      if (k < rounds / 2) early = std::max(early, off);
      if (k >= rounds / 2) late = std::max(late, off);
      lost = std::max(lost, std::abs(along(s) - along(first)));
    }
    BOOST_TEST_MESSAGE(method.name << ", 1e5 steps: energy off by " << early << " in the first half, " << late
                                   << " in the second; momentum along the direction by " << lost);
    BOOST_TEST(late <= 1.2 * early);
    BOOST_TEST(early > 1e-9);  // conserved by no theorem
    // The torque has no component along n. Kicks and drifts conserve it, to a random walk of roundings.
    BOOST_TEST(lost <= 100 * eps * std::sqrt(1e5 * static_cast<double>(method.drifts.size())));
  }
  // A control: one kick too late, the first order and no longer its own inverse. It is symplectic too, but
  // the energy is off by more.
  TorquedBody lopsided(start.inertia, start.momentum, start.attitude, torque, 0.1,
                       Splitting{"lopsided", 1, {1, 0}, {1}});
  TorquedBody strang(start.inertia, start.momentum, start.attitude, torque, 0.1);
  double one = 0, two = 0;
  for (int k = 0; k < 100; ++k) {
    lopsided.step(), strang.step();
    one = std::max(one, std::abs(energy(lopsided.state()) - energy(first))),
    two = std::max(two, std::abs(energy(strang.state()) - energy(first)));
  }
  BOOST_TEST(one > 4 * two);
}

BOOST_AUTO_TEST_CASE(without_a_torque_the_motion_is_the_free_one_whatever_the_step) {
  std::mt19937 random(testing::seed);
  for (int trial = 0; trial < 20; ++trial) {
    auto const [inertia, spin] = testing::random_body<3>(random);
    Moment const momentum = body_momentum(inertia, spin);
    Attitude const attitude{SU2{}, Vector4d(1, 0.1, 0.2, 0.3).normalized()};
    auto const sphere = inertia_from_moments(0.7, 0.7, 0.7);
    // Each of the three ways to compute a drift, and the changes between them.
    for (double const h : {0.01, 0.1, 0.2, 0.4, 1.0, 10.0, -0.3}) {
      int const steps = 20;
      TorquedBody none(
          inertia, momentum, attitude,
          [](Four<double> const&, double) {
            return Three<double>{0, 0, 0};
          },
          h);
      TorquedBody ball(sphere, momentum, attitude, gravity_gradient(sphere, 2, towards), h,
                       blanes_moan_splitting());
      none.step(steps), ball.step(steps);
      double const angle = std::abs(h) * spin.coordinates.norm(),
                   room = 20 * eps * steps * (1 + steps * angle);
      BOOST_TEST(apart(none.state(), FreeBody(inertia, momentum, attitude).at(steps * h)) <=
                 room * (1 + momentum.components.norm()));
      BOOST_TEST(apart(ball.state(), FreeBody(sphere, momentum, attitude).at(steps * h)) <=
                 6 * room * (1 + momentum.components.norm()));
    }
  }
}

// Moments that differ in the last of ten digits: a unit of inertia that is no power of two would round the
// difference away.
BOOST_AUTO_TEST_CASE(a_long_body_keeps_the_difference_of_its_moments) {
  Start long_body;
  long_body.inertia = inertia_from_moments(1e-6, 1.0, 1 + 1e-6);
  long_body.momentum.components = {1e-6, 0.3, 0.9};
  double const duration = 100;
  auto const none = [](Four<double> const&, double) { return Three<double>{0, 0, 0}; };
  FreeState const stepped = long_body.after(duration, 4000, none),
                  free = FreeBody(long_body.inertia, long_body.momentum, long_body.attitude).at(duration);
  // 4000 steps have a few roundings each; the body turns about its long axis as fast as about the others, so
  // that nothing magnifies them but the time.
  BOOST_TEST(apart(stepped, free) <= 4000 * 8 * eps);
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_begins_to_swing) {
  Start start;
  start.momentum.components.setZero();
  auto const torque = gravity_gradient(start.inertia, 1.5, towards);
  BOOST_TEST(apart(start.after(3, 300, torque, blanes_moan_splitting()), solved(start, 3, 1.5, 0)) <= 1e-9);
  // Without a torque it stays, exactly.
  auto const still = start.after(3, 10, gravity_gradient(start.inertia, 0, towards));
  BOOST_TEST(still.body_momentum.components.norm() == 0);
  BOOST_TEST((still.attitude.value - start.attitude.value).norm() <= 2 * eps);
}

BOOST_AUTO_TEST_CASE(the_order_of_the_axes_and_the_way_of_saying_the_torque_do_not_matter) {
  Start const start;
  for (int shift = 0; shift < 3; ++shift) {
    auto const turned = [&](Vector3d const& x) {
      return Vector3d(x[shift], x[(shift + 1) % 3], x[(shift + 2) % 3]);
    };
    Start other;
    other.inertia = inertia_from_moments<double>(turned(start.inertia.moments));
    other.momentum.components = turned(start.momentum.components);
    other.attitude.value.tail<3>() = turned(start.attitude.value.tail<3>());
    auto const torque = gravity_gradient_in_orbit(other.inertia, 0.7, turned(towards), turned(normal));
    auto const end = other.after(5, 100, torque),
               plain = start.after(5, 100, gravity_gradient_in_orbit(start.inertia, 0.7, towards, normal));
    BOOST_TEST((end.body_momentum.components - turned(plain.body_momentum.components)).norm() <= 1e-12);
    BOOST_TEST((end.attitude.value.tail<3>() - turned(plain.attitude.value.tail<3>())).norm() <= 1e-12);
    BOOST_TEST(apart(end, other.after(5, 100, [&](Four<double> const& q, double t) {
                 return torque(q, t);
               })) <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(no_unit_is_too_small_or_too_large) {
  Start const start;
  for (double const unit : {1e-47, 1.0, 1e47})
    for (double const pace : {1e-12, 1.0, 1e6}) {
      Start other = start;
      other.inertia = inertia_from_moments<double>(unit * start.inertia.moments);
      other.momentum.components *= unit * pace;
      auto end = other.after(5 / pace, 50, gravity_gradient(other.inertia, 1.5 * pace * pace, towards));
      end.body_momentum.components /= unit * pace;
      BOOST_TEST(apart(end, start.after(5, 50, gravity_gradient(start.inertia, 1.5, towards))) <= 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_flown_is_named) {
  Start const start;
  auto const still = [](Four<double> const&, double) { return Three<double>{0, 0, 0}; };
  CHECK_REFUSED(TorquedBody(start.inertia, start.momentum, start.attitude, still, 0.0), OutsideDomain);
  CHECK_REFUSED(TorquedBody(start.inertia, start.momentum, start.attitude, still, std::nan("")), NotFinite);
  CHECK_REFUSED(TorquedBody(start.inertia, {SO<3>{}, Vector3d(1, NAN, 0)}, start.attitude, still, 0.1),
                NotFinite);
  CHECK_REFUSED(TorquedBody(start.inertia, start.momentum, {SU2{}, Vector4d(0, 0, 0, 0)}, still, 0.1),
                OutsideDomain);
  Inertia<3> unphysical = start.inertia;
  unphysical.moments[1] = 5;
  CHECK_REFUSED(TorquedBody(unphysical, start.momentum, start.attitude, still, 0.1), UnphysicalInertia);
  CHECK_REFUSED(
      TorquedBody(start.inertia, start.momentum, start.attitude, still, 0.1, Splitting{"none", 1, {1}, {}}),
      OutsideDomain);
  CHECK_REFUSED(composed_splitting("half", 2, {0.5}), OutsideDomain);
  CHECK_REFUSED(gravity_gradient(start.inertia, -1, towards), OutsideDomain);
  CHECK_REFUSED(gravity_gradient(start.inertia, 1, Vector3d::Zero()), OutsideDomain);
  CHECK_REFUSED(gravity_gradient_in_orbit(start.inertia, 1, towards, towards), OutsideDomain);

  // A torque that is no number leaves the body where it was.
  TorquedBody body(
      start.inertia, start.momentum, start.attitude,
      [](Four<double> const&, double t) {
        return Three<double>{0, t > 0.45 ? NAN : 0.1, 0};
      },
      0.1);
  body.step(3);
  auto const before = body.state();
  CHECK_REFUSED(body.step(10), NotFinite);
  BOOST_TEST((together(body.state()) - together(before)).norm() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
