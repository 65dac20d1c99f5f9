// Motions in SL(3), a group that discrete mechanics was not written for: it needs nothing but the primitives
// of the group.
//
// Dirichlet's ellipsoid of fluid without gravity moves on a geodesic of SL(3) with the metric of the space of
// matrices, which rotations leave as it is, on either side. The metric that is carried around by left
// multiplication has geodesics in closed form.
#include <boost/test/unit_test.hpp>

#include "actio/groups/special_linear.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_momentum.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "witness/draw.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;

namespace {

double const eps = epsilon<double>();
using G = SL<3>;
using Configuration = Element<G, double>;
using Square = actio::Matrix<double, 3, 3>;

template <class T>
T square(actio::Matrix<T, 3, 3> const& a) {
  T sum(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += a(i, j) * a(i, j);
  return sum;
}

/// \f$|A_1 - A_0|^2/2h\f$, the action of an ellipsoid of unit inertia.
auto ellipsoid(double h) {
  return [h](auto const& a0, auto const& a1) { return square((a1.value - a0.value).eval()) / (2 * h); };
}
/// \f$(|f-1|^2 + |f^{-1}-1|^2)/4h\f$ of the relative motion f, second order to \f$\tfrac12|\xi|^2\f$.
auto carried_around(double h) {
  return [h](auto const& f) {
    auto const one = identity<typename std::decay_t<decltype(f)>::Scalar>(f.group);
    return (square((f.value - one.value).eval()) + square((inverse(f).value - one.value).eval())) / (4 * h);
  };
}
auto const half_square = [](auto const& xi) { return square(xi.group.hat(xi.coordinates)) / 2; };

/// A velocity whose matrix is like a skew one, so that the motions below stay bounded, but is none.
Square elliptic() {
  Square m;
  m << 0, -0.5, 0.8, 0.25, 0, -1.2, -0.2, 0.6, 0;
  Square const stretch = actio::Vector<double, 3>(1, 0.5, 2).asDiagonal();
  return stretch * (m - m.transpose()) * inverse_matrix(stretch) / 2;
}
Velocity<G, double> as_velocity(Square const& m) { return velocity(G{}, G{}.vee(m)); }

/// \f$e^{tM^T}e^{t(M-M^T)}\f$: the geodesic from 1 with velocity M of the metric \f$\mathrm{tr}(\xi^T\xi)\f$
/// carried around by left multiplication.
Configuration geodesic(Square const& m, double t) {
  return exp(t * as_velocity(m.transpose())) * exp(t * as_velocity(m - m.transpose()));
}

struct Deviation {
  double miss;       ///< of the last configuration from the geodesic
  double drift;      ///< of the momentum in space, relative to it
  double condition;  ///< by how much Ad of a configuration magnifies rounding
};
/// Steps by l, from 1 with the velocity that the geodesic begins with.
template <class L>
Deviation steps_by(L const& l, double h, int steps) {
  Square const m = elliptic();
  Configuration g = identity<double>(G{});
  // The first step leaves with the momentum of the velocity M: of the matrices tr(M^T xi).
  Momentum<G, double> pi{G{}, Coordinates<G, double>(8)};
  for (int a = 0; a < 8; ++a)
    pi.components[a] =
        (m.transpose() * G{}.hat(Coordinates<G, double>(Coordinates<G, double>::Unit(a)))).trace();
  auto f = relative_motion_from_momentum_left(l, pi, exp(-h * as_velocity(m))).value;
  double drift = 0, condition = 1;
  double const size = magnitude(pi.components);
  for (int k = 0; k < steps; ++k) {
    if (k > 0) f = step_euler_poincare_left(l, f).value;
    drift =
        std::max(drift, magnitude((Ad_star(inverse(g), momentum_before_left(l, f)) - pi).components) / size);
    g = restore(reconstruct_left(g, f));
    condition = std::max(condition, row_norm(g.value) * row_norm(inverse(g).value));
  }
  return {magnitude((g.value - geodesic(m, h * steps).value).eval()), drift, condition};
}

}  // namespace

BOOST_AUTO_TEST_CASE(steps_follow_the_geodesics_of_a_left_invariant_metric_to_second_order) {
  // The closed form is independent of the steps: were it not the limit, the ratio would tend to 1. It is 2^2
  // up to a term h^2 |M|^2, here 0.02 or 0.006 of it.
  double const coarse = steps_by(carried_around(0.02), 0.02, 50).miss,
               fine = steps_by(carried_around(0.01), 0.01, 100).miss;
  BOOST_TEST(std::abs(coarse / fine - 4) < 0.1);
  // The natural chart needs the logarithm of the group as well.
  double const in_chart = steps_by(natural_chart_lagrangian_left(half_square, 0.04), 0.04, 25).miss;
  double const in_finer_chart = steps_by(natural_chart_lagrangian_left(half_square, 0.02), 0.02, 50).miss;
  BOOST_TEST(std::abs(in_chart / in_finer_chart - 4) < 0.1);
  // A Lagrangian that looks ahead only is of first order.
  auto const lopsided = [](double h) {
    return [h](auto const& f) {
      return square((f.value - identity<typename std::decay_t<decltype(f)>::Scalar>(f.group).value).eval()) /
             (2 * h);
    };
  };
  BOOST_TEST(steps_by(lopsided(0.02), 0.02, 50).miss / steps_by(lopsided(0.01), 0.01, 100).miss < 2.5);
}

BOOST_AUTO_TEST_CASE(momentum_in_space_is_kept_over_ten_thousand_steps) {
  double const h = 0.05;
  auto const found = steps_by(carried_around(h), h, 10000);
  // One rounding error of the solver a step, each 16 eps/h, seen from space; they add up like a random walk
  // of ten thousand steps, 100 times one.
  double const bound = 100 * 16 * eps / h * found.condition;
  BOOST_TEST_MESSAGE("drift " << found.drift << ", bound " << bound << ", condition " << found.condition);
  BOOST_TEST(found.drift < bound);
}

namespace {

/// \f$\ddot A = \lambda A^{-T}\f$ with the multiplier that preserves the determinant.
actio::Vector<double> ellipsoid_rate(double, actio::Vector<double> const& state) {
  Square const a = as_matrix<3, 3>(state.data()), rate = as_matrix<3, 3>(state.data() + 9),
               inverse = inverse_matrix(a);
  Square const velocity = inverse * rate,
               force = inverse.transpose() * ((velocity * velocity).trace() / inverse.squaredNorm());
  actio::Vector<double> change(18);
  change << state.tail(9), force.reshaped();
  return change;
}

Square const start_velocity = (Square() << 0.1, -0.4, 0.3, 0.5, 0.2, -0.2, -0.1, 0.4, -0.3).finished();

/// The second configuration: where the action of the first step leaves with the momentum of the velocity.
Configuration second_configuration(double h) {
  auto const L = ellipsoid(h);
  Configuration const start = identity<double>(G{});
  Momentum<G, double> mu{G{}, Coordinates<G, double>(8)};
  for (int a = 0; a < 8; ++a)
    mu.components[a] =
        (start_velocity.transpose() * G{}.hat(Coordinates<G, double>(Coordinates<G, double>::Unit(a))))
            .trace();
  auto const residual = [&](auto const& g) { return D1(L, like(g, start), g) + like(g, mu); };
  return solve_on_group(residual, exp(h * as_velocity(start_velocity))).value;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_ellipsoid_of_Dirichlet_moves_as_its_equations_say) {
  actio::Vector<double> state(18);
  state << Square::Identity().reshaped(), start_velocity.reshaped();
  actio::Vector<double> const exact = reference_solution(ellipsoid_rate, state, 0, 1);
  std::vector<double> miss;
  for (int const steps : {50, 100}) {
    double const h = 1.0 / steps;
    Configuration before = identity<double>(G{}), configuration = second_configuration(h);
    for (int k = 1; k < steps; ++k) {
      auto const next = step_euler_lagrange(ellipsoid(h), before, configuration).value;
      before = configuration, configuration = next;
    }
    miss.push_back((configuration.value - as_matrix<3, 3>(exact.data())).cwiseAbs().maxCoeff());
  }
  BOOST_TEST(std::abs(miss[0] / miss[1] - 4) < 0.1);
}

BOOST_AUTO_TEST_CASE(the_ellipsoid_keeps_angular_momentum_and_circulation_over_ten_thousand_steps) {
  double const h = 1e-3;
  int const steps = 10000;
  auto const L = ellipsoid(h);
  Configuration before = identity<double>(G{}), configuration = second_configuration(h);
  Square turn = Square::Zero();
  turn(0, 1) = -1, turn(1, 0) = 1;
  auto const zeta = as_velocity(turn);
  // Rotations of space act from the left, rotations of the labels from the right.
  auto const in_space = [&](auto const& g) { return like(g, zeta); };
  auto const of_labels = [&](auto const& g) { return Ad(g, like(g, zeta)); };
  // A velocity that is no rotation is no symmetry.
  auto const stretch = [&](auto const& g) {
    return like(g, as_velocity(actio::Vector<double, 3>(1, -1, 0).asDiagonal()));
  };
  auto const all = [&] {
    return actio::Vector<double, 3>(discrete_momentum(L, before, configuration, in_space),
                                    discrete_momentum(L, before, configuration, of_labels),
                                    discrete_momentum(L, before, configuration, stretch));
  };
  actio::Vector<double, 3> const start = all();
  actio::Vector<double, 3> drift = actio::Vector<double, 3>::Zero();
  for (int k = 1; k < steps; ++k) {
    auto const next = step_euler_lagrange(L, before, configuration).value;
    before = configuration, configuration = next;
    drift = drift.cwiseMax((all() - start).cwiseAbs());
  }
  // Rows of the derivative are of the size |A|^2/h; the rest as for the momentum in space above.
  double const bound = 100 * 16 * eps / h * configuration.value.squaredNorm();
  BOOST_TEST_MESSAGE("drift " << drift.transpose() << ", bound " << bound);
  BOOST_TEST(drift[0] < bound);
  BOOST_TEST(drift[1] < bound);
  BOOST_TEST(drift[2] > 0.1);
  BOOST_TEST(std::abs(determinant_by_elimination(configuration.value) - 1) <
             64 * eps * configuration.value.squaredNorm());
}
