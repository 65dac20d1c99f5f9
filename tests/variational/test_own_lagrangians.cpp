// Lagrangians of a reader's own: on groups that are no rotations, and with no regular velocity.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "refused.hpp"
#include "spinning_body.hpp"

using namespace actio;
using testing::eps, testing::spinning_body;

namespace {
Vector<double, 3> const spin(0.3, -1.1, 0.7);
}  // namespace

BOOST_AUTO_TEST_CASE(a_lagrangian_blind_to_a_velocity_is_refused_with_its_pivot) {
  auto const flat = [](auto const& v) {
    auto const& w = v.velocity.coordinates;
    return (w[0] * w[0] + w[1] * w[1]) / 2 + w[2];
  };
  State<SO<3>, double> const v{identity<double>(SO<3>{}), velocity(SO<3>{}, spin)};
  BOOST_CHECK_EXCEPTION(lagrange_acceleration(flat, v), Singular, [](Singular const& error) {
    return error.measured <= error.bound && std::string(error.what()).find("d2L/dxi2") != std::string::npos;
  });
  CHECK_REFUSED(euler_poincare_acceleration_left(
                    [](auto const& w) { return w.coordinates[0] * w.coordinates[0]; }, v.velocity),
                Singular);
}

BOOST_AUTO_TEST_CASE(a_readers_own_lagrangian_on_se3_needs_no_derivatives) {
  // A ball of mass 3 on a spring, in a wind that turns it: kinetic energy less the energy of the spring, plus
  // a term linear in the velocity.
  auto const L = [](auto const& v) {
    auto const body = body_velocity(v).coordinates;
    auto const configuration = v.configuration.value.template topRightCorner<3, 1>();
    auto const turning = body.template head<3>(), sliding = body.template tail<3>();
    return turning.dot(turning) + sliding.dot(sliding) * 3 / 2 - configuration.dot(configuration) * 5 / 2 +
           body[0] * configuration[2];
  };
  Matrix<double, 6, 1> motion;
  motion << 0.1, 0.2, -0.3, 1.0, 0.5, -0.25;
  State<SE<3>, double> const v{exp(velocity(SE<3>{}, motion)), velocity(SE<3>{}, motion)};
  auto const acceleration = lagrange_acceleration(L, v);
  BOOST_TEST(euler_lagrange(L, v, acceleration).components.norm() < 100 * eps);
  // Energy stays: its rate along the vector field.
  BOOST_TEST(std::abs(energy(L, moved(v, lagrange_vector_field(L, v))).part[0]) < 100 * eps);
  // The equation of the spring, in the frame of space: the force on the mass is -5 times the configuration,
  // and what the wind adds.
  Vector<double, 3> const x = v.configuration.value.topRightCorner<3, 1>(), w = motion.head<3>(),
                          u = motion.tail<3>() + w.cross(x);
  Vector<double, 3> const accelerated =
      acceleration.coordinates.tail<3>() + acceleration.coordinates.head<3>().cross(x) + w.cross(u);
  Vector<double, 3> const wind(0, 0, (v.configuration.value.topLeftCorner<3, 3>().transpose() * w)[0]);
  BOOST_TEST((3 * accelerated + 5 * x - wind).norm() < 200 * eps);
}

BOOST_AUTO_TEST_CASE(quaternions_and_matrices_give_the_same_motion) {
  // The weight of a top: height of a point fixed in the body.
  auto const top = [](auto const& v) {
    auto const body = body_velocity(v);
    Matrix<typename std::decay_t<decltype(v)>::Scalar, 3, 1> up;
    up << 0, 0, 1;
    auto const height = Ad(inverse(v.configuration), decltype(body){body.group, up}).coordinates[0];
    return spinning_body(body) - height * 3;
  };
  auto const turn = Vector<double, 3>(0.5, 0.2, -0.9);
  State<SO<3>, double> const matrices{exp(velocity(SO<3>{}, turn)), velocity(SO<3>{}, spin)};
  State<SU2, double> const quaternions{exp(velocity(SU2{}, turn)), velocity(SU2{}, spin)};
  BOOST_TEST(
      (lagrange_acceleration(top, matrices).coordinates - lagrange_acceleration(top, quaternions).coordinates)
          .norm() < 100 * eps);
}
