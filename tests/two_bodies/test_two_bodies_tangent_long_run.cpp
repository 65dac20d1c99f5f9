// The tangent map: symplectic, the product of its parts, the difference of neighbouring motions; growth of a
// tangent vector.
#include <boost/test/unit_test.hpp>

#include <Eigen/Dense>

#include "didymos.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using testing::Didymos, testing::element, testing::quaternion;

namespace {
using Map = Eigen::Matrix<double, 18, 18>;
using Tangent = Eigen::Matrix<double, 18, 1>;

/// Units of the motion, in which all parts of a tangent vector are comparable.
Tangent units(Didymos const& d) {
  double const m = d.start.momentum.norm() / Didymos::speed;
  Tangent u = Tangent::Ones();
  u.head<3>() *= Didymos::distance, u.segment<3>(3) *= m * Didymos::distance * d.n;
  u.segment<3>(9) *= d.primary.inertia[2] * d.n, u.segment<3>(15) *= d.moon.inertia[2] * d.n;
  return u;
}
/// dX ^ dP, and of each body nu.xi - mu.eta + M.(xi x eta) for (xi, mu) and (eta, nu), in these units of an
/// action.
Map symplectic_form(TwoBodyState const& s) {
  Map form = Map::Zero();
  auto const pairs = [&](int at) {
    form.block<3, 3>(at, at + 3).setIdentity();
    form.block<3, 3>(at + 3, at) = -Eigen::Matrix3d::Identity();
  };
  auto const twist = [&](int at, Vector3d const& M) {
    // M.(xi x eta) = xi.(eta x M)
    form.block<3, 3>(at, at) << 0, M[2], -M[1], -M[2], 0, M[0], M[1], -M[0], 0;
  };
  pairs(0), pairs(6), pairs(12);
  twist(6, s.first.body_momentum.components), twist(12, s.second.body_momentum.components);
  return form;
}
/// The state moved along a tangent vector.
TwoBodyState moved(TwoBodyState s, Tangent const& v) {
  auto const turned = [](Element<SU2, double> const& q, Vector3d const& w) {
    double const angle = w.norm();
    Eigen::Quaterniond const turn(angle > 0 ? Eigen::AngleAxisd(angle, w / angle)
                                            : Eigen::AngleAxisd::Identity());
    return element(quaternion(q) * turn);
  };
  s.position += v.head<3>(), s.momentum += v.segment<3>(3);
  s.first.attitude = turned(s.first.attitude, v.segment<3>(6)),
  s.first.body_momentum.components += v.segment<3>(9);
  s.second.attitude = turned(s.second.attitude, v.segment<3>(12)),
  s.second.body_momentum.components += v.segment<3>(15);
  return s;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(two_bodies_tangent_long_run)

BOOST_AUTO_TEST_CASE(the_tangent_map_is_symplectic) {
  Didymos const d;
  Map const scale = units(d).asDiagonal();
  for (auto const& [method, step, order] : {std::tuple{pair_splitting(), 300.0, 2},
                                            {kepler_splitting(), 1400.0, 4},
                                            {moser_veselov_pair(), 200.0, 2},
                                            {kepler_splitting(), 1400.0, 3}}) {
    auto pair = d.pair(step, method, order);
    Map const before = scale * symplectic_form(pair.state()) * scale;
    Map const map = pair.tangent_map(20), first = pair.tangent_map(8);
    pair.step(8);
    Map const second = pair.tangent_map(12);
    pair.step(12);
    Map const after = scale * symplectic_form(pair.state()) * scale, T = scale.inverse() * map * scale;
    double const size = T.cwiseAbs().maxCoeff();
    // A thousand roundings of each entry; two maps are multiplied.
    double const off = (T.transpose() * after * T - before).cwiseAbs().maxCoeff() /
                       (size * size * after.cwiseAbs().maxCoeff());
    BOOST_TEST_MESSAGE(method.splitting.name << ": symplectic to " << off << ", determinant off by "
                                             << T.determinant() - 1 << ", entries up to " << size);
    BOOST_TEST(off <= 1e-13);
    BOOST_TEST(
        (map - second * first).cwiseProduct((scale.inverse() * Map::Ones() * scale)).cwiseAbs().maxCoeff() <=
        1e-12 * size * size);
    // A control: the form without the twist by the momenta of the bodies.
    Map flat = after, flat_before = before;
    for (int at : {6, 12}) flat.block<3, 3>(at, at).setZero(), flat_before.block<3, 3>(at, at).setZero();
    BOOST_TEST((T.transpose() * flat * T - flat_before).cwiseAbs().maxCoeff() >
               1e-4 * before.cwiseAbs().maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(the_tangent_map_is_the_limit_of_differences) {
  Didymos const d;
  Tangent const u = units(d);
  auto const after = [&](Tangent const& v) {
    TwoBodies pair(d.primary, d.moon, moved(d.start, v), {.order = 4, .step = 1200, .G = Didymos::G});
    pair.step(10);
    return pair.state();
  };
  Map const map = d.pair(1200, kepler_splitting(), 4).tangent_map(10);
  for (int k = 0; k < 18; ++k) {
    // Central differences: of the error, a square of 1e-5 by the third derivative, and rounding over 1e-5.
    Tangent v = Tangent::Zero();
    v[k] = 1e-5 * u[k];
    auto const plus = after(v), minus = after(-v);
    Tangent difference;
    auto const turn = [](Element<SU2, double> const& a, Element<SU2, double> const& b) {
      Eigen::Quaterniond const e = quaternion(a).conjugate() * quaternion(b);
      return Vector3d((e.w() < 0 ? -2 : 2) * e.vec());
    };
    auto const less = [](auto const& x, auto const& y) { return Vector3d(Vector3d(x) - Vector3d(y)); };
    difference << less(plus.position, minus.position), less(plus.momentum, minus.momentum),
        turn(minus.first.attitude, plus.first.attitude),
        less(plus.first.body_momentum.components, minus.first.body_momentum.components),
        turn(minus.second.attitude, plus.second.attitude),
        less(plus.second.body_momentum.components, minus.second.body_momentum.components);
    Tangent const off = (difference / 2e-5 - map.col(k) * u[k]).cwiseQuotient(u);
    BOOST_TEST(off.cwiseAbs().maxCoeff() <=
               1e-6 * (1 + (map.col(k) * u[k]).cwiseQuotient(u).cwiseAbs().maxCoeff()));
  }
}

BOOST_AUTO_TEST_CASE(regular_motion_has_no_exponential_growth_and_a_tumbling_moon_has) {
  Didymos const d;
  auto const exponent = [&](double spin, long steps) {
    auto start = state_of_velocities(d.primary, d.moon, {Didymos::distance, 0, 0}, {0, Didymos::speed, 0},
                                     element(d.q1), d.omega_1, element(d.q2),
                                     d.q2.conjugate() * Vector3d(0, 0, spin * d.n));
    TwoBodies pair(d.primary, d.moon, start, {.order = 2, .step = d.radian / 6, .G = Didymos::G});
    return pair.lyapunov_exponent(steps) * d.radian;
  };
  // A moon that turns three times in an orbit: log(t)/t at 200 and 800 radians. One that turns a third faster
  // than the orbit is near the separatrix of the locked motion, and tumbles.
  double const early = exponent(3, 1200), late = exponent(3, 4800), wild = exponent(1.3, 4800);
  BOOST_TEST_MESSAGE("growth by radian: regular " << early << ", later " << late << "; tumbling " << wild);
  BOOST_TEST(late < early / 2);
  BOOST_TEST(wild > 3 * late);
}

BOOST_AUTO_TEST_SUITE_END()
