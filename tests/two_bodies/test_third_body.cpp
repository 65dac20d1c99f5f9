// A third body and tides: against forces written out in the test, and what they leave as it is.
#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "didymos.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using testing::apart, testing::Didymos, testing::element, testing::quaternion;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
Vector3d vector(Three<double> const& x) { return {x[0], x[1], x[2]}; }
Three<double> three(Vector3d const& x) { return {x[0], x[1], x[2]}; }

/// A body of twice the mass that passes at eight distances.
ThirdBody passing(Didymos const& d) {
  double const mass = 2 * (d.primary.mass() + d.moon.mass());
  return third_body(mass,
                    {.half_axis = -8 * Didymos::distance,
                     .eccentricity = 2,
                     .inclination = 0.5,
                     .node = 1,
                     .pericentre = 0.3,
                     .time = 3 * d.radian},
                    mass / 2, Didymos::G);
}
TwoBodies with(Didymos const& d, double step, PairMethod method, std::optional<ThirdBody> third,
               std::optional<std::array<Tide, 2>> tides = {}) {
  return TwoBodies(d.primary, d.moon, d.start,
                   {.order = 2,
                    .step = step,
                    .method = std::move(method),
                    .G = Didymos::G,
                    .third = third,
                    .tides = tides});
}
}  // namespace

BOOST_AUTO_TEST_SUITE(third_body_and_tides)

BOOST_AUTO_TEST_CASE(the_force_of_a_third_body_is_that_of_its_potential) {
  Didymos const d(2);
  auto const third = passing(d);
  ThirdBodyForce const force(third, d.primary, d.moon, Didymos::G);
  Vector3d const X(900, 500, -300);
  double const time = 2.3 * d.radian, m1 = d.primary.mass(), m2 = d.moon.mass(), M = m1 + m2;
  auto const moved =
      kepler_drift<double>(third.start.position, third.start.velocity, third.mu, time - third.epoch);
  Vector3d const R = vector(third.start.position) + vector(moved.position);
  auto const q = [](Eigen::Quaterniond const& a) { return Four<double>{a.w(), a.x(), a.y(), a.z()}; };
  Kick<double> kick{};
  force.add_to(kick, three(X), q(d.q1), q(d.q2), time);
  // Accelerations as gradients by central differences of extrapolated steps would do; here as sums over
  // matrices.
  auto const on = [&](Vector3d const& D, double m, ExtendedBody const& body, Eigen::Quaterniond const& a,
                      Vector3d& torque) {
    Eigen::Matrix3d const Rm = a.toRotationMatrix(),
                          I = Rm * vector(body.inertia).asDiagonal() * Rm.transpose();
    double const r = D.norm(), G = Didymos::G * third.mass;
    Vector3d const b = D / r;
    torque = Rm.transpose() * (3 * G / std::pow(r, 3) * b.cross(I * b));
    return Vector3d(
        G * (m * b / (r * r) + 1.5 / std::pow(r, 4) * ((I.trace() - 5 * b.dot(I * b)) * b + 2 * I * b)));
  };
  Vector3d t1, t2;
  Vector3d const F1 = on(R + m2 / M * X, m1, d.primary, d.q1, t1),
                 F2 = on(R - m1 / M * X, m2, d.moon, d.q2, t2);
  double const m = m1 * m2 / M;
  Vector3d const expected = m * (F2 / m2 - F1 / m1);
  BOOST_TEST((vector(kick.force) - expected).norm() <= 50 * eps * m * F2.norm() / m2);
  BOOST_TEST((vector(kick.torque_1) - t1).norm() <= 50 * eps * t1.norm());
  BOOST_TEST((vector(kick.torque_2) - t2).norm() <= 50 * eps * t2.norm());
  BOOST_TEST(expected.norm() > 1e-4 * m * F2.norm() / m2);
  // The sun at a billion distances: the tidal force to its own digits, 3 (b.X) b - X over d^3.
  ThirdBody const sun = third_body(2e30, {.half_axis = 1.5e11, .eccentricity = 0.1}, M, Didymos::G);
  Kick<double> pull{};
  ThirdBodyForce(sun, d.primary, d.moon, Didymos::G).add_to(pull, three(X), q(d.q1), q(d.q2), 0);
  Vector3d const b = vector(sun.start.position).normalized();
  Vector3d const tidal =
      m * Didymos::G * sun.mass / std::pow(vector(sun.start.position).norm(), 3) * (3 * b.dot(X) * b - X);
  BOOST_TEST((vector(pull.force) - tidal).norm() <=
             1e-6 * tidal.norm());  // of the next term, 1e-8, and of the shapes
}

BOOST_AUTO_TEST_CASE(methods_agree_on_the_motion_with_a_passing_body) {
  Didymos const d(2);
  auto const third = passing(d);
  double const time = 6 * d.radian;
  auto at = [&](PairMethod const& method, int steps, std::optional<ThirdBody> const& with_third) {
    auto pair = with(d, time / steps, method, with_third);
    pair.step(steps);
    return pair.state();
  };
  auto const truth = at(kepler_splitting(), 200, third);
  auto const off = [&](TwoBodyState const& s) {
    return (Didymos::place(s) - Didymos::place(truth)).norm() +
           apart(s.second.attitude, truth.second.attitude);
  };
  std::vector<double> steps, errors;
  for (int count = 200; count <= 1600; count *= 2)
    steps.push_back(time / count), errors.push_back(off(at(pair_splitting(), count, third)));
  auto const fit = testing::fit_order(steps, errors);
  BOOST_TEST_MESSAGE("with a third body: straight orbits of order "
                     << fit.slope << ", Kepler splitting off by " << off(at(kepler_splitting(), 24, third))
                     << " at 4 and " << off(at(kepler_splitting(), 48, third)) << " at 8 steps a radian");
  BOOST_TEST(std::abs(fit.slope - 2) < 0.1);
  BOOST_TEST(off(at(kepler_splitting(), 24, third)) < 1e-6);
  BOOST_TEST(off(at(kepler_splitting(), 48, third)) < 1e-8);
  BOOST_TEST(off(at(kepler_splitting(), 200, {})) > 1e-4);  // it does something
}

BOOST_AUTO_TEST_CASE(tides_leave_the_momentum_and_take_energy) {
  Didymos const d(2);
  std::array<Tide, 2> const tides{Tide{0.01, 0.3, 400, 2170}, Tide{0.01, 0.3, 80, 2400}};
  double const time = 3 * d.radian;
  auto const at = [&](int steps) {
    auto pair = with(d, time / steps, kepler_splitting(), {}, tides);
    pair.step(steps);
    return pair;
  };
  auto const start = with(d, 60, kepler_splitting(), {}, tides);
  auto const fine = at(1600);
  BOOST_TEST((fine.angular_momentum() - start.angular_momentum()).norm() <=
             1e-14 * start.angular_momentum().norm());
  BOOST_TEST(fine.energy() < start.energy() - 1e-9 * std::abs(start.energy()));
  std::vector<double> steps, errors;
  auto const truth = at(12800).state();
  // From where the error of the splitting itself is below that of the tides.
  for (int count = 200; count <= 1600; count *= 2) {
    auto const s = at(count).state();
    steps.push_back(time / count);
    errors.push_back((Didymos::place(s) - Didymos::place(truth)).norm() +
                     apart(s.second.attitude, truth.second.attitude));
  }
  auto const fit = testing::fit_order(steps, errors);
  BOOST_TEST_MESSAGE("tides: order " << fit.slope << ", errors " << errors.front() << " to "
                                     << errors.back());
  BOOST_TEST(std::abs(fit.slope - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(the_tidal_torque_has_the_size_that_is_said) {
  // One short step: the spin of the primary changes by -(3/2) k2 (3/(4 pi rho))^2 G m1^2 m2^2 sin(2 eps)/(R
  // r^6) t/I3.
  double const G = 1, m1 = 2, m2 = 1, r = 3, w = 5;
  auto const one = ellipsoid_body(m1, {0.5, 0.5, 0.4}, 2), two = sphere_body(m2, 0.3, 2);
  auto const upright = element(Eigen::Quaterniond::Identity());
  auto const start =
      state_of_velocities(one, two, {r, 0, 0}, {0, 1, 0}, upright, {0, 0, w}, upright, {0, 0, 1.0 / r});
  Tide const tide{0.2, 0.1, 0.5, 1.5};
  double const h = 1e-3;
  TwoBodies pair(one, two, start, {.order = 2, .step = h, .G = G, .tides = std::array{tide, Tide{}}});
  double const before = start.first.body_momentum.components.norm();
  pair.step();
  double const size = 1.5 * 0.2 * std::pow(3 / (4 * M_PI * 1.5), 2) * m1 * m1 * m2 * m2 * std::sin(0.2) /
                      0.5 / std::pow(r, 6);
  BOOST_TEST(std::abs((before - pair.state().first.body_momentum.components.norm()) / (size * h) - 1) <=
             1e-6);
  // Between the rates that are small: in proportion.
  double const rate = 1e-8, least = size * std::sqrt(6 / (M_PI * 1.5)) / one.inertia[2];
  BOOST_TEST(rate < 0.1 * least);
  auto const slow = state_of_velocities(one, two, {r, 0, 0}, {0, 1, 0}, upright, {0, 0, 1.0 / r + rate},
                                        upright, {0, 0, 1.0 / r});
  TwoBodies gentle(one, two, slow, {.order = 2, .step = 1e-6, .G = G, .tides = std::array{tide, Tide{}}});
  double const spin = slow.first.body_momentum.components[2];
  gentle.step();
  double const lost = spin - gentle.state().first.body_momentum.components[2];
  BOOST_TEST(std::abs(lost) < size * 1e-6 * 0.1);
}

BOOST_AUTO_TEST_CASE(orbits_and_tides_that_there_are_not_are_refused) {
  Didymos const d(2);
  CHECK_REFUSED(third_body(0, {.half_axis = 1, .eccentricity = 0}, 1, 1), OutsideDomain);
  CHECK_REFUSED(third_body(1, {.half_axis = 1, .eccentricity = -0.1}, 1, 1), OutsideDomain);
  CHECK_REFUSED(third_body(1, {.half_axis = 1, .eccentricity = 1.2}, 1, 1), OutsideDomain);
  CHECK_REFUSED(third_body(1, {.half_axis = std::nan(""), .eccentricity = 0}, 1, 1), NotFinite);
  auto const tides = [&](Tide const& tide) {
    return with(d, 60, pair_splitting(), {}, std::array{tide, Tide{}});
  };
  CHECK_REFUSED(tides({0.1, 0.1, 400, 0}), OutsideDomain);
  CHECK_REFUSED(tides({0.1, 0.1, 0, 2000}), OutsideDomain);
  CHECK_REFUSED(tides({-0.1, 0.1, 400, 2000}), OutsideDomain);
  CHECK_REFUSED(tides({0.1, 0.1, 400, 2000}).tangent_map(1), OutsideDomain);
  CHECK_REFUSED(d.pair(60).lyapunov_exponent(0), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
