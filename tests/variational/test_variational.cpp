// Variational mechanics as a reader uses it: known equations of motion, quadrature, orbits.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "actio/variational/action.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "actio/variational/momentum_map.hpp"
#include "refused.hpp"
#include "spinning_body.hpp"
#include "witness/number.hpp"
#include "witness/taylor_reference.hpp"

using namespace actio;
using testing::eps, testing::spinning_body;

namespace {

/// Euler's equations of that body, written out.
template <class S>
Matrix<S, 3, 1> euler(Matrix<S, 3, 1> const& w) {
  return {(w[1] * w[2] * S(2 - 4)) / S(1), (w[2] * w[0] * S(4 - 1)) / S(2), (w[0] * w[1] * S(1 - 2)) / S(4)};
}

Vector<double, 3> const spin(0.3, -1.1, 0.7);

}  // namespace

BOOST_AUTO_TEST_CASE(euler_poincare_on_the_left_is_euler_and_on_the_right_its_opposite) {
  auto const w = velocity(SO<3>{}, spin);
  auto const left = euler_poincare_acceleration_left(spinning_body, w),
             right = euler_poincare_acceleration_right(spinning_body, w);
  // A dozen operations on numbers of order 1.
  BOOST_TEST((left.coordinates - euler(spin)).norm() < 20 * eps);
  BOOST_TEST((right.coordinates + euler(spin)).norm() < 20 * eps);
}

BOOST_AUTO_TEST_CASE(the_full_equations_move_the_body_as_the_reduced_ones) {
  // Attitude and spatial velocity by the Euler-Lagrange equations on TG; body velocity by Euler's. Both by
  // power series.
  using Full = Matrix<double, 12, 1>;
  Full start;
  start << Matrix<double, 3, 3>::Identity().reshaped(), spin;
  auto const full = taylor_reference<double>(
      [](auto const& y) {
        using T = typename std::decay_t<decltype(y)>::Scalar;
        Matrix<T, 3, 3> g;
        for (int i = 0; i < 9; ++i) g(i % 3, i / 3) = y[i];
        State<SO<3>, T> const v{{{}, g}, {{}, Matrix<T, 3, 1>(y[9], y[10], y[11])}};
        Matrix<T, 3, 3> const rate = SO<3>::hat(v.velocity.coordinates) * g;
        Matrix<T, 3, 1> const acceleration =
            lagrange_acceleration(left_invariant(spinning_body), v).coordinates;
        Matrix<T, 12, 1> result;
        for (int i = 0; i < 9; ++i) result[i] = rate(i % 3, i / 3);
        for (int i = 0; i < 3; ++i) result[9 + i] = acceleration[i];
        return result;
      },
      start, 2.0);
  Vector<double, 3> const reduced =
      taylor_reference<double>([](auto const& w) { return euler(w); }, spin, 2.0);
  Matrix<double, 3, 3> const g = as_matrix<3, 3>(full.data());
  // Two seconds at one turn a second: errors grow a little over tenfold.
  BOOST_TEST((g.transpose() * full.tail<3>() - reduced).norm() < 200 * eps);
  BOOST_TEST((g.transpose() * g - Matrix<double, 3, 3>::Identity()).norm() < 200 * eps);
}

BOOST_AUTO_TEST_CASE(the_pendulum_falls_as_it_should) {
  auto const pendulum = [](auto const& v) {
    return v.velocity.coordinates[0] * v.velocity.coordinates[0] / 2 + v.configuration.value(0, 0) * 9;
  };
  Matrix<double, 1, 1> const angle(0.4), rate(-1.5);
  State<SO<2>, double> const v{exp(velocity(SO<2>{}, angle)), velocity(SO<2>{}, rate)};
  BOOST_TEST(std::abs(lagrange_acceleration(pendulum, v).coordinates[0] + 9 * std::sin(0.4)) < 20 * eps);
}

BOOST_AUTO_TEST_CASE(the_tangent_of_a_one_parameter_group_is_its_generator) {
  auto const xi = velocity(SE<3>{}, Vector<double, 6>(0.1, 0.26, 0.42, 0.58, 0.74, 0.9));
  auto const curve = [&](auto const& t) { return exp(t * over<std::decay_t<decltype(t)>>(xi)); };
  BOOST_TEST((tangent(curve, 0.7).velocity.coordinates - xi.coordinates).norm() < 50 * eps);
  BOOST_TEST(second_tangent(curve, 0.7).velocity.coordinates.norm() < 50 * eps);
  // Its action under a kinetic energy is that energy times the time.
  auto const kinetic = [](auto const& v) { return v.velocity.coordinates.dot(v.velocity.coordinates) / 2; };
  BOOST_TEST(std::abs(action(kinetic, curve, 1.0, 3.0, Quadrature<double>(4)) -
                      xi.coordinates.squaredNorm()) < 50 * eps);
}

BOOST_AUTO_TEST_CASE(a_quadrature_is_exact_to_its_degree_and_no_further) {
  WithArithmetic const exactly(Arithmetic::rationals());
  for (int degree : {0, 1, 5, 12}) {
    Quadrature<Number> const rule(degree);
    auto const error = [&](int power) {
      auto const f = [&](Number const& x) {
        Number y = 1;
        for (int k = 0; k < power; ++k) y *= x;
        return y;
      };
      // From 0 to 2: the integral is 2^(power + 1)/(power + 1).
      return rule(f, Number(0), Number(2)) * (power + 1) - Number(1 << (power + 1));
    };
    for (int power = 0; power <= degree; ++power) BOOST_TEST((error(power) == 0));
    BOOST_TEST((error(degree + 2) != 0));
  }
}

BOOST_AUTO_TEST_CASE(a_vector_that_leaves_the_coadjoint_orbit_is_refused) {
  // Orbits of so(3)* are spheres: radial vectors leave them.
  auto const mu = momentum(SO<3>{}, Vector<double, 3>(1, 2, 2)),
             radial = momentum(SO<3>{}, Vector<double, 3>(0.5, 1, 1));
  BOOST_CHECK_EXCEPTION(orbit_generator(mu, radial), OutsideDomain,
                        [](OutsideDomain const& error) { return error.measured > 0.1; });
  auto const along = momentum(SO<3>{}, Vector<double, 3>(2, -1, 0));
  BOOST_TEST((ad_star(orbit_generator(mu, along), mu).components - along.components).norm() < 20 * eps);
  // At the origin the orbit is a point.
  CHECK_REFUSED(orbit_generator(momentum(SO<3>{}, Vector<double, 3>(0, 0, 0)), along), OutsideDomain);
  // Units do not matter: a body of 1e-47 kg m^2 has its orbits too.
  auto const tiny = 1e-47 * mu;
  BOOST_TEST(
      (ad_star(orbit_generator(tiny, 1e-47 * along), tiny).components - 1e-47 * along.components).norm() <
      20 * eps * 1e-47);
}

BOOST_AUTO_TEST_CASE(a_kinetic_energy_of_any_unit_is_regular) {
  auto const tiny = [](auto const& v) { return spinning_body(body_velocity(v)) * 1e-47; };
  State<SO<3>, double> const v{identity<double>(SO<3>{}), velocity(SO<3>{}, spin)};
  BOOST_TEST((lagrange_acceleration(tiny, v).coordinates - (euler(spin))).norm() < 20 * eps);
}
