// Steps of two bodies: against somebody else's integrator, known figures, closed forms; orders; what they
// conserve; what undoes them.
#include <boost/test/unit_test.hpp>

#include <gsl/gsl_sf_ellint.h>

#include "../rigid_body/random_bodies.hpp"
#include "didymos.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using testing::apart, testing::Didymos, testing::element, testing::quaternion;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
PairMethod kepler_strang() { return {strang_splitting(), true, Rotor::exact}; }

/// How far the second body is off, in first distances.
double off(TwoBodyState const& a, TwoBodyState const& b) {
  return (Didymos::place(a) - Didymos::place(b)).norm();
}
}  // namespace

BOOST_AUTO_TEST_SUITE(two_bodies)

BOOST_AUTO_TEST_CASE(didymos_after_a_radian_is_where_two_other_programs_have_it) {
  Didymos const d;
  auto pair = d.pair(d.radian / 200);
  pair.step(200);
  // RK7(8) of F2BPtoolkit at a tolerance of 1e-14, and a prototype of order 8 in 64 bits of mantissa.
  Vector3d const theirs(-0.172030545819763, 1.023810408339284, 0.028078215610871),
      prototype(-0.172030545819458, 1.023810408339441, 0.028078215610872),
      in_space(0.543984793455898, 0.884675673145831, -0.000380714758252);
  auto const seen = Didymos::place_seen(pair.state());
  BOOST_TEST((seen - theirs).norm() <= 1e-11);
  BOOST_TEST((seen - prototype).norm() <= 1e-11);
  BOOST_TEST((Didymos::place(pair.state()) - in_space).norm() <= 1e-11);
  BOOST_TEST((seen - Didymos::place_seen(testing::solved(d, d.radian))).norm() <= 1e-13);
  // A control: the start in other axes, the roll to the other side.
  auto other = d;
  other.start.second.attitude = element(d.q2.conjugate());
  auto rolled = other.pair(d.radian / 200);
  rolled.step(200);
  BOOST_TEST((Didymos::place_seen(rolled.state()) - theirs).norm() > 1e-6);
}

BOOST_AUTO_TEST_CASE(errors_after_sixty_radians_are_those_of_the_table) {
  Didymos const d;
  double const time = 60 * d.radian;
  auto const truth = testing::solved(d, time);
  struct Row {
    PairMethod method;
    int steps;
    double place, moon;
  };
  for (auto const& [method, steps, place, moon] : {Row{pair_splitting(), 6000, 1.7e-3, 1.5e-3},
                                                   {pair_splitting(4), 300, 7.8e-6, 6.7e-6},
                                                   {kepler_strang(), 6000, 9e-6, 8e-6},
                                                   {kepler_splitting(), 180, 1.2e-7, 5e-7},
                                                   {kepler_splitting(), 300, 8.4e-10, 6.5e-8},
                                                   {kepler_splitting(), 600, 6e-12, 4e-9}}) {
    auto pair = d.pair(time / steps, method);
    pair.step(steps);
    double const x = off(pair.state(), truth),
                 q = 2 * apart(pair.state().second.attitude, truth.second.attitude);
    BOOST_TEST_MESSAGE(method.splitting.name << (method.kepler ? ", Kepler" : "") << ", step " << time / steps
                                             << " s: place off by " << x << ", attitude of the moon by "
                                             << q);
    BOOST_TEST((x > place / 2 && x < 2 * place));
    BOOST_TEST((q > moon / 2 && q < 2 * moon));
  }
}

BOOST_AUTO_TEST_CASE(orders_two_and_four_are_measured) {
  Didymos const d;
  double const time = 3 * d.radian;
  auto const truth = testing::solved(d, time);
  for (auto const& [method, first] : {std::pair{pair_splitting(), 64},
                                      {moser_veselov_pair(), 256},
                                      {kepler_strang(), 64},
                                      {pair_splitting(4), 48}}) {
    std::vector<double> steps, errors;
    for (int count = first; count <= 4 * first; count *= 2) {
      auto pair = d.pair(time / count, method);
      pair.step(count);
      steps.push_back(time / count);
      errors.push_back(off(pair.state(), truth) + apart(pair.state().first.attitude, truth.first.attitude) +
                       apart(pair.state().second.attitude, truth.second.attitude));
    }
    auto const fit = testing::fit_order(steps, errors);
    BOOST_TEST_MESSAGE(method.splitting.name << (method.kepler ? ", Kepler" : "") << ": order " << fit.slope
                                             << ", errors " << errors.front() << " to " << errors.back());
    BOOST_TEST(std::abs(fit.slope - method.splitting.order) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_step_back_undoes_a_step_and_the_momentum_stays) {
  for (int const order : {2, 3, 4}) {
    Didymos const d(4);
    for (auto const& method :
         {pair_splitting(), pair_splitting(4), kepler_splitting(), moser_veselov_pair()}) {
      double const h = method.kepler ? 1000 : 60;
      long const steps = 200;
      auto there = d.pair(h, method, order);
      Vector3d const J = there.angular_momentum();
      there.step(steps);
      // Sums are compensated: what is left is the rounding of single changes.
      BOOST_TEST((there.angular_momentum() - J).norm() <= 1e-14 * J.norm());
      TwoBodies back(d.primary, d.moon, there.state(),
                     {.order = order, .step = -h, .method = method, .G = Didymos::G, .start = there.time()});
      back.step(steps);
      double const stages = static_cast<double>(method.splitting.drifts.size());
      // Roundings of the state where it turns grow with the angle that the primary has turned.
      double const room =
          50 * eps * (std::sqrt(double(steps) * stages) + h * double(steps) * d.omega_1.norm());
      BOOST_TEST(off(back.state(), d.start) <= room);
      BOOST_TEST(apart(back.state().first.attitude, d.start.first.attitude) <= room);
      BOOST_TEST(apart(back.state().second.attitude, d.start.second.attitude) <= room);
      BOOST_TEST(std::abs(back.time()) <= 1e-9);
      BOOST_TEST(off(there.state(), d.start) > 0.01);
    }
  }
}

BOOST_AUTO_TEST_CASE(steps_at_once_are_steps_one_by_one) {
  Didymos const d;
  for (auto const& method : {pair_splitting(), kepler_splitting()}) {
    auto together = d.pair(200, method), single = d.pair(200, method);
    together.step(100);
    for (int k = 0; k < 100; ++k) single.step();
    BOOST_TEST(off(together.state(), single.state()) <= 100 * eps);
    BOOST_TEST(apart(together.state().first.attitude, single.state().first.attitude) <= 100 * eps);
    BOOST_TEST(together.time() == single.time());
  }
}

BOOST_AUTO_TEST_CASE(two_balls_move_as_points_and_turn_uniformly) {
  double const G = 1, m1 = 3, m2 = 1, mu = m1 + m2;
  auto const a = sphere_body(m1, 0.3, 4), b = sphere_body(m2, 0.2, 4);
  Vector3d const X(2, 0, 0.3), V(0.1, 1.2, 0.2), w1(0.3, -0.2, 0.9), w2(-0.5, 0.4, 0.1);
  Eigen::Quaterniond const q1(Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized())),
      q2(Eigen::AngleAxisd(-0.7, Vector3d(0, 1, 1).normalized()));
  double const h = 0.05;
  long const steps = 400;
  double const time = h * double(steps);
  for (int const order : {2, 4}) {
    TwoBodies pair(a, b, state_of_velocities(a, b, X, V, element(q1), w1, element(q2), w2),
                   {.order = order, .step = h, .G = G});
    pair.step(steps);
    auto const s = pair.state();
    auto const orbit = kepler_drift<double>({X[0], X[1], X[2]}, {V[0], V[1], V[2]}, mu, time);
    double const room = 20 * eps * time * double(steps);
    BOOST_TEST((s.position - X - Vector3d(orbit.position[0], orbit.position[1], orbit.position[2])).norm() <=
               room);
    BOOST_TEST(apart(s.first.attitude, element(q1 * Eigen::Quaterniond(Eigen::AngleAxisd(
                                                        w1.norm() * time, w1.normalized())))) <= room);
    BOOST_TEST(apart(s.second.attitude, element(q2 * Eigen::Quaterniond(Eigen::AngleAxisd(
                                                         w2.norm() * time, w2.normalized())))) <= room);
  }
}

BOOST_AUTO_TEST_CASE(the_tenth_pericentre_about_an_oblate_body_is_where_an_elliptic_integral_has_it) {
  // In the equator V/m = -mu/r - k/r^3, k = mu (a^2-c^2)/10, and u = 1/r obeys (du/dphi)^2 = alpha
  // u^3 - u^2 + ... with alpha = 2k/h^2 and roots u1 < u2 < u3.
  double const m1 = 5, m2 = 1, mu = m1 + m2, a = 0.5, c = 0.35, k = mu * (a * a - c * c) / 10;
  auto const one = ellipsoid_body(m1, {a, a, c}, 2), two = sphere_body(m2, 0.1, 2);
  double const r0 = 1.2, v0 = 2.4, spin = r0 * v0;  // at the pericentre
  double const alpha = 2 * k / (spin * spin), u0 = 1 / r0;
  // The other roots: of alpha u^2 + (alpha u0 - 1) u + (alpha u0^2 - u0 + 2 mu/h^2).
  double const p = alpha * u0 - 1, q = alpha * u0 * u0 - u0 + 2 * mu / (spin * spin),
               root = std::sqrt(p * p - 4 * alpha * q), far = 2 * q / (-p + root),
               third = (-p + root) / (2 * alpha);
  double const modulus = std::sqrt((u0 - far) / (third - far)),
               angle = 4 * gsl_sf_ellint_Kcomp(modulus, GSL_PREC_DOUBLE) / std::sqrt(alpha * (third - far));
  BOOST_TEST(angle > 2 * M_PI * 1.001);
  auto const start =
      state_of_velocities(one, two, {r0, 0, 0}, {0, v0, 0}, element(Eigen::Quaterniond::Identity()),
                          {0, 0, 3}, element(Eigen::Quaterniond::Identity()), {0, 0, 1});
  double const h = 0.02;
  TwoBodyOptions options{.order = 2, .step = h, .G = 1};
  TwoBodies pair(one, two, start, options);
  double before = 0, turned = 0, last = 0;
  for (int pericentres = 0; pericentres < 10;) {
    pair.step();
    Vector3d const X = pair.state().position;
    double const rate = X.dot(pair.state().momentum), phi = std::atan2(X[1], X[0]);
    turned += std::remainder(phi - last, 2 * M_PI), last = phi;
    if (before < 0 && rate >= 0) ++pericentres;
    before = rate;
  }
  // Back to where the distance is least, by Newton's method in the length of one step.
  TwoBodyState at = pair.state();
  for (int round = 0; round < 5; ++round) {
    Vector3d const X = at.position, V = at.momentum / pair.reduced_mass();
    double const r = X.norm(), bend = V.squaredNorm() - mu / r - 3 * k / (r * r * r);
    options.step = -X.dot(V) / bend;
    if (std::abs(options.step) < 1e-15) break;
    TwoBodies correction(one, two, at, options);
    correction.step();
    at = correction.state();
  }
  double const phi = std::atan2(at.position[1], at.position[0]);
  turned += std::remainder(phi - last, 2 * M_PI);
  BOOST_TEST_MESSAGE("tenth pericentre: " << turned << " rad, off by " << turned - 10 * angle);
  BOOST_TEST(std::abs(turned - 10 * angle) <= 1e-9);
  BOOST_TEST(std::abs(at.position.norm() - r0) <= 1e-9);
}

BOOST_AUTO_TEST_CASE(motions_that_there_are_not_are_refused) {
  Didymos const d;
  auto const with = [&](auto const& change) {
    TwoBodyState start = d.start;
    TwoBodyOptions options{.order = 2, .step = 60, .G = Didymos::G};
    change(start, options);
    return TwoBodies(d.primary, d.moon, start, options);
  };
  CHECK_REFUSED(with([](auto&, auto& o) { o.step = 0; }), OutsideDomain);
  CHECK_REFUSED(with([](auto&, auto& o) { o.step = std::nan(""); }), NotFinite);
  CHECK_REFUSED(with([](auto&, auto& o) { o.G = -1; }), OutsideDomain);
  CHECK_REFUSED(with([](auto&, auto& o) { o.order = 6; }), OutsideDomain);
  CHECK_REFUSED(with([](auto&, auto& o) { o.method.splitting.kicks.pop_back(); }), OutsideDomain);
  CHECK_REFUSED(with([](auto& s, auto&) { s.position[1] = std::nan(""); }), NotFinite);
  CHECK_REFUSED(with([](auto& s, auto&) { s.first.body_momentum.components[0] = INFINITY; }), NotFinite);
  CHECK_REFUSED(with([](auto& s, auto&) { s.second.attitude.value *= 1.5; }), OutsideDomain);
  CHECK_REFUSED(with([](auto& s, auto&) { s.position = Vector3d(484, 0, 0); }), OutsideDomain);
  auto pair = d.pair(60);
  CHECK_REFUSED(pair.step(-1), OutsideDomain);
  // Without its speed the moon falls.
  auto falling = with([](auto& s, auto&) { s.momentum.setZero(); });
  auto const fall = [&] {
    while (falling.time() < d.radian) falling.step();
  };
  CHECK_REFUSED(fall(), OutsideDomain);
  BOOST_TEST(falling.nearness() < 1);  // the state before the step that is refused
  BOOST_TEST(falling.nearness() > 0.8);
  // A step in which the primary turns by more than half a turn is beyond the scheme of Moser and Veselov.
  auto too_long = d.pair(5000, moser_veselov_pair());
  CHECK_REFUSED(too_long.step(), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
