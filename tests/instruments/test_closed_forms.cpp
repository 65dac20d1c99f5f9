// The instruments against maps whose defects are known in closed form, and over the rationals.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/momentum_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/variational/momentum_map.hpp"
#include "small_maps.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;
using Vector3d = actio::Vector<double, 3>;

namespace {

LiePoissonMinus const body_momenta;
DiagonalBody<SO<3>> const body{Vector3d(1, 2, 4)};
auto const pi = momentum(SO<3>{}, Vector3d(0.75, -1.25, 0.5));

// A point of T*R^2.
using Plane = Translations<2>;
Costate<Plane, double> const q_and_p{{{}, Vector<double, 2>(0.3, -0.2)}, {{}, Vector<double, 2>(1.5, 0.75)}};

// p goes to p + K q.
auto kick(Matrix<double, 2, 2> const& k) {
  return [k](auto const& x) {
    auto y = x;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) y.momentum.components[i] += x.configuration.value[j] * k(i, j);
    return y;
  };
}
auto const larger = [](auto const& mu) {  // by an eighth
  using M = std::decay_t<decltype(mu)>;
  return M{mu.group, mu.components * (typename M::Scalar(9) / typename M::Scalar(8))};
};
auto const runge_kutta_step = [](auto const& mu) {
  return runge_kutta(body, typename std::decay_t<decltype(mu)>::Scalar(0.25), mu);
};
auto const midpoint_family = [](auto const& h, auto const& mu) { return implicit_midpoint(body, h, mu); };
auto const turned_round = [](auto const& mu) { return -mu; };

}  // namespace

BOOST_AUTO_TEST_CASE(a_linear_canonical_map_has_no_defect) {
  Matrix<double, 2, 2> symmetric;
  symmetric << 2, -1, -1, 3;
  auto const map = kick(symmetric);
  BOOST_TEST(symplectic_defect(CotangentBundle{}, map, q_and_p) == 0);
  BOOST_TEST(poisson_defect(CotangentBundle{}, map, q_and_p) == 0);
}

BOOST_AUTO_TEST_CASE(a_force_with_a_curl_has_the_defect_of_its_curl) {
  Matrix<double, 2, 2> k;
  k << 2, -1, 0.5, 3;
  // The sizes: 1 for configurations, |p| for momenta. Omega has four entries |p|, the defect two entries
  // K_12 - K_21.
  double const p = q_and_p.momentum.components.norm(), curl = 1.5;
  double const expected = std::sqrt(2 * curl * curl) / (2 * p + std::sqrt(4 * p * p + 2 * curl * curl));
  BOOST_TEST(std::abs(symplectic_defect(CotangentBundle{}, kick(k), q_and_p) - expected) < 8 * eps);
  BOOST_TEST(std::abs(poisson_defect(CotangentBundle{}, kick(k), q_and_p) - expected) < 8 * eps);
}

BOOST_AUTO_TEST_CASE(a_scaling_by_an_eighth_has_the_defect_it_must_have) {
  double const e = 0.125;
  // Canonical: (1 + e) against 1. On the dual of an algebra: (1 + e)^2 against 1 + e.
  auto const scaled = [](auto const& x) {
    return std::decay_t<decltype(x)>{x.configuration, larger(x.momentum)};
  };
  BOOST_TEST(std::abs(symplectic_defect(CotangentBundle{}, scaled, q_and_p) - e / (2 + e)) < 4 * eps);
  BOOST_TEST(std::abs(poisson_defect(body_momenta, larger, pi) - e / (2 + e)) < 4 * eps);
  BOOST_TEST(std::abs(orbit_defect(larger, pi) - e) < 4 * eps);
  auto const square = [](auto const& mu) { return mu.components.squaredNorm(); };
  BOOST_TEST(std::abs(casimir_defect(body_momenta, larger, pi, square) - (e + e * e / 2)) < 8 * eps);
  // Turned round, nothing of the bracket is left; the orbit is.
  BOOST_TEST(poisson_defect(body_momenta, turned_round, pi) == 1);
  BOOST_TEST(orbit_defect(turned_round, pi) < 32 * eps);
}

BOOST_AUTO_TEST_CASE(the_midpoint_rule_has_the_poisson_defect_of_its_determinant) {
  // It preserves every sphere, so that A B A^T = det A B; and det A = (1 + c + d)/(1 + c - d) with the second
  // and third invariants of the vector field at the middle.
  for (double const h : {0.5, 0.25, 0.125}) {
    auto const map = [h](auto const& mu) {
      return implicit_midpoint(body, typename std::decay_t<decltype(mu)>::Scalar(h), mu);
    };
    Vector3d const m = (pi.components + map(pi).components) / 2, I = body.inertia;
    double const a = 1 / I[2] - 1 / I[1], b = 1 / I[0] - 1 / I[2], c = 1 / I[1] - 1 / I[0];
    double const third = 2 * a * b * c * m.prod(),
                 second = -(a * b * m[2] * m[2] + a * c * m[1] * m[1] + b * c * m[0] * m[0]);
    double const expected = std::abs(third) * h * h * h / 8 / (1 + second * h * h / 4);
    BOOST_TEST(expected > 1e-5);
    BOOST_TEST(std::abs(poisson_defect(body_momenta, map, pi) - expected) < 64 * eps);
    BOOST_TEST(orbit_defect(map, pi) < 64 * eps);
    BOOST_TEST(leaf_defect(body_momenta, midpoint_family, h, pi) < 64 * eps / h);
    BOOST_TEST(self_adjointness_defect(body_momenta, midpoint_family, h, pi) < 64 * eps);
    BOOST_TEST(reversibility_defect(body_momenta, map, pi, turned_round) < 64 * eps);
  }
}

BOOST_AUTO_TEST_CASE(a_way_across_the_spheres_has_the_slope_it_leaves_them_with) {
  // exp(h) times a turn about an axis: along mu the rate is |mu|, along the sphere |axis x mu|.
  Vector3d const axis(0.5, 0.25, 1);
  auto const family = [&](auto const& h, auto const& mu) {
    using M = std::decay_t<decltype(mu)>;
    using std::exp;
    typename M::Scalar const growth = exp(h);
    return M{mu.group, actio::exp(h * over<typename M::Scalar>(velocity(SO<3>{}, axis))).value *
                           mu.components * growth};
  };
  double const radial = pi.components.norm(), along = cross(axis, pi.components).norm();
  BOOST_TEST(std::abs(leaf_defect(body_momenta, family, 0.3, pi) - radial / std::hypot(radial, along)) <
             16 * eps);
}

BOOST_AUTO_TEST_CASE(explicit_euler_is_undone_up_to_the_square_of_the_step) {
  auto const x = momentum(Translations<1>{}, Matrix<double, 1, 1>(3.0));
  auto const euler = [](double h, auto const& y) { return y + h * y; };
  BOOST_TEST(std::abs(self_adjointness_defect(LiePoissonPlus{}, euler, 0.25, x) - 0.0625) < 2 * eps);
  BOOST_TEST(self_adjointness_defect(
                 body_momenta, [](double h, auto const& y) { return y + h * body.rate(y); }, 0.25, pi) >
             1e-3);
}

BOOST_AUTO_TEST_CASE(a_turned_momentum_has_the_defect_of_the_turn) {
  double const angle = 0.4;
  Costate<SO<3>, double> const x{exp(velocity(SO<3>{}, Vector3d(0.1, 0.7, -0.3))), pi};
  auto const map = [&](auto const& y) {
    return std::decay_t<decltype(y)>{
        y.configuration,
        {y.momentum.group, exp(velocity(SO<3>{}, Vector3d(0, 0, angle))).value * y.momentum.components}};
  };
  auto const about = [](int axis) { return left_translation(basis_velocity<double>(SO<3>{}, axis)); };
  Vector3d const m = pi.components;
  double const expected = std::abs(std::cos(angle) * m[0] - std::sin(angle) * m[1] - m[0]) / m.norm();
  BOOST_TEST(std::abs(momentum_defect(CotangentBundle{}, map, x, about(0)) - expected) < 4 * eps);
  BOOST_TEST(momentum_defect(CotangentBundle{}, map, x, about(2)) < 4 * eps);
}

BOOST_AUTO_TEST_CASE(nothing_is_wrong_with_a_body_at_rest) {
  auto const rest = momentum(SO<3>{}, Vector3d(0, 0, 0));
  BOOST_TEST(poisson_defect(body_momenta, runge_kutta_step, rest) == 0);
  BOOST_TEST(orbit_defect(runge_kutta_step, rest) == 0);
  BOOST_TEST(leaf_defect(
                 body_momenta, [](auto const& h, auto const& mu) { return runge_kutta(body, h, mu); }, 0.25,
                 rest) == 0);
  // Nor with one that turns about a principal axis, whose momentum stands still but for rounding.
  auto const steady = momentum(SO<3>{}, Vector3d(0, 1.1, 0));
  auto const turns = [](auto const& h, auto const& mu) { return splitting(body, h, mu); };
  BOOST_TEST(leaf_defect(body_momenta, turns, 0.3, steady) == 0);
  BOOST_TEST(leaf_defect(body_momenta, midpoint_family, 0.3, steady) == 0);
}

BOOST_AUTO_TEST_CASE(a_frame_turned_in_the_body_sees_the_same_defects) {
  auto const turn = exp(velocity(SO<3>{}, Vector3d(1.0, -0.4, 0.6)));
  auto const turned = [&](auto const& mu) { return Ad_star(inverse(like(mu, turn)), mu); };
  auto const back = [&](auto const& mu) { return Ad_star(like(mu, turn), mu); };
  auto const seen = [&](auto const& mu) { return turned(runge_kutta_step(back(mu))); };
  double const defect = poisson_defect(body_momenta, runge_kutta_step, pi),
               orbit = orbit_defect(runge_kutta_step, pi);
  BOOST_TEST(defect > 1e-8);
  BOOST_TEST(std::abs(poisson_defect(body_momenta, seen, turned(pi)) - defect) < 32 * eps);
  BOOST_TEST(std::abs(orbit_defect(seen, turned(pi)) - orbit) < 32 * eps);
}

BOOST_AUTO_TEST_CASE(a_coadjoint_action_is_exact_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(11);
  SE<3> const space;
  auto const g = draw.element<Number>(space);
  auto const mu = draw.momentum<Number>(space);
  auto const action = [&](auto const& at) { return Ad_star(like(at, g), at); };
  BOOST_TEST((magnitude(poisson_residual(LiePoissonPlus{}, action, mu)) == 0));
  // Lifted to the cotangent bundle; and with an element that depends on the momentum, which preserves orbits
  // and not the bracket.
  Costate<SE<3>, Number> const x{draw.element<Number>(space), mu};
  auto const lifted = [&](auto const& p) {
    return std::decay_t<decltype(p)>{like(p.configuration, g) * p.configuration,
                                     Ad_star(inverse(like(p.momentum, g)), p.momentum)};
  };
  BOOST_TEST((magnitude(symplectic_residual(CotangentBundle{}, lifted, x)) == 0));
  BOOST_TEST((magnitude(poisson_residual(CotangentBundle{}, lifted, x)) == 0));
  auto const bent = [&](auto const& at) {
    return Ad_star(retract(decltype(basis_velocity<typename std::decay_t<decltype(at)>::Scalar>(space, 0)){
                       space, at.components}),
                   at);
  };
  BOOST_TEST((magnitude(poisson_residual(LiePoissonPlus{}, bent, mu)) > 0));
}
