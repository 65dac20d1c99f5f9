// Examples of the modules variational, rigid_body, fast_body, two_bodies, rods and bodies.
#include "actio/bodies/body_catalogue.hpp"
#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"
#include "actio/fast_body/any_dimension/natural_chart_n.hpp"
#include "actio/fast_body/space/free_steps.hpp"
#include "actio/fast_body/space/natural_chart_steps.hpp"
#include "actio/fast_body/space/potential_torque.hpp"
#include "actio/fast_body/space/torqued_body.hpp"
#include "actio/fast_body/space/uniform_gravity.hpp"
#include "actio/reduction/composition.hpp"
#include "actio/rigid_body/casimirs.hpp"
#include "actio/rigid_body/heavy_top.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "actio/rods/rod.hpp"
#include "actio/two_bodies/two_bodies.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "actio/variational/legendre.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "actio/variational/momentum_map.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_bodies)
using namespace actio;
using namespace actio::bodies;

// ---- variational

BOOST_AUTO_TEST_CASE(euler_lagrange_of_a_pendulum) {
  // [euler_lagrange]
  // A pendulum of length 1: its configuration is a rotation of the plane.
  auto const pendulum = [](auto const& v) {  // v is a State over any scalar
    auto const& rate = v.velocity.coordinates[0];
    return rate * rate / 2.0 + 9.81 * v.configuration.value(0, 0);
  };
  auto const g = exp(velocity(SO<2>{}, Vector<double, 1>(0.5)));
  State<SO<2>, double> const v{g, velocity(SO<2>{}, Vector<double, 1>(2.0))};
  auto const acceleration = lagrange_acceleration(pendulum, v);
  assert(std::abs(acceleration.coordinates[0] + 9.81 * std::sin(0.5)) < 1e-14);
  assert(std::abs(euler_lagrange(pendulum, v, acceleration).components[0]) < 1e-14);
  // [euler_lagrange]
}

BOOST_AUTO_TEST_CASE(reduced_equations) {
  // [euler_poincare]
  // A rigid body: l(Omega) = (2 Omega_1^2 + 3 Omega_2^2 + 4 Omega_3^2)/2, invariant on the left.
  auto const l = [](auto const& Omega) {
    auto const& w = Omega.coordinates;
    return (w[0] * w[0] * 2.0 + w[1] * w[1] * 3.0 + w[2] * w[2] * 4.0) / 2.0;
  };
  auto const rate = euler_poincare_acceleration_left(l, velocity(SO<3>{}, Vector<double, 3>(1, 2, 3)));
  // Euler: 2 Omega_1' = (3 - 4) Omega_2 Omega_3, and so on round.
  assert((rate.coordinates - Vector<double, 3>(-3.0, 2.0, -0.5)).norm() < 1e-14);
  // [euler_poincare]
  // [lie_poisson]
  auto const h = [](auto const& Pi) {
    auto const& M = Pi.components;
    return (M[0] * M[0] / 2.0 + M[1] * M[1] / 3.0 + M[2] * M[2] / 4.0) / 2.0;
  };
  auto const Pi = momentum(SO<3>{}, Vector<double, 3>(2, 6, 12));
  auto const torque_free = lie_poisson_rate_left(h, Pi);  // Pi x Omega
  assert((torque_free.components - Vector<double, 3>(-6, 6, -2)).norm() < 1e-14);
  // [lie_poisson]
}

// ---- rigid_body

BOOST_AUTO_TEST_CASE(inertia_of_a_body) {
  // [inertia_from_moments]
  Inertia<3> const brick = inertia_from_moments(0.6, 0.8, 1.0);  // mass x length^2
  auto const Omega = velocity(SO<3>{}, Vector<double, 3>(1, 0, 2));
  auto const Pi = body_momentum(brick, Omega);
  assert((Pi.components - Vector<double, 3>(0.6, 0, 2)).norm() < 1e-15);
  assert(std::abs(kinetic_energy(brick, Pi) - 2.3) < 1e-15);
  // No body has moments of which one is larger than the sum of the others.
  BOOST_CHECK_THROW(inertia_from_moments(1.0, 1.0, 2.1), UnphysicalInertia);
  // [inertia_from_moments]
}

BOOST_AUTO_TEST_CASE(inertia_from_a_tensor) {
  // [principal_inertia]
  Eigen::Matrix3d tensor;
  tensor << 2, 1, 0, 1, 2, 0, 0, 0, 3.5;
  PrincipalInertia const body = principal_inertia(tensor);
  assert((body.tensor() - tensor).norm() < 1e-14);
  Eigen::Vector3d moments = body.inertia.moments;
  std::sort(moments.begin(), moments.end());
  assert((moments - Eigen::Vector3d(1, 3, 3.5)).norm() < 1e-14);
  // [principal_inertia]
}

BOOST_AUTO_TEST_CASE(moser_veselov_scheme) {
  // [moser_veselov]
  MoserVeselov<3> const scheme(inertia_from_moments(0.6, 0.8, 1.0), 0.1);
  auto const Pi = momentum(SO<3>{}, Vector<double, 3>(0.3, 0.8, 0.4));
  auto const after = scheme.step_lie_poisson(Pi);
  assert(std::abs(after.components.norm() - Pi.components.norm()) < 1e-15);
  assert(std::abs(kinetic_energy(scheme.inertia(), after) - kinetic_energy(scheme.inertia(), Pi)) < 1e-15);
  assert(scheme.longest_step(Pi) > 0.1);  // beyond it there is no solution: StepTooLong
  // [moser_veselov]
}

BOOST_AUTO_TEST_CASE(a_heavy_top) {
  // [heavy_top]
  // Half a kilogram, 10 cm above its point, tilted by 0.5 and spun at 30 rad/s. SI units.
  Vector<double, 3> const centre(0, 0, 0.1), gravity(0, 0, -9.81);
  auto const top = heavy_top<double>(0.5, inertia_from_moments(0.02, 0.02, 0.005), centre, gravity);
  auto state = release(top, exp(velocity(SO<3>{}, Vector<double, 3>(0.5, 0, 0))),
                       velocity(SO<3>{}, Vector<double, 3>(0, 0, 30)));
  double const about_vertical = state.momentum.components.dot(state.vector);
  HeavyTopScheme<> const scheme(top, 1e-3);
  for (int k = 0; k < 1000; ++k) scheme.advance(state);
  assert(std::abs(state.momentum.components.dot(state.vector) - about_vertical) < 1e-14);
  assert(std::abs(state.vector.norm() - 1) < 1e-14);
  // [heavy_top]
}

// ---- fast_body

BOOST_AUTO_TEST_CASE(exact_motion) {
  // [free_body]
  // The brick about its middle axis, a little aside: it turns over, again and again.
  auto const M = momentum(SO<3>{}, Eigen::Vector3d(0.001, 0.8, 0.001));
  FreeBody const brick(inertia_from_moments(0.6, 0.8, 1.0), M);
  FreeState const later = brick.at(1000);  // one evaluation, whatever the time
  assert((later.spatial_momentum() - M).components.norm() < 1e-12);
  double const energy = kinetic_energy(brick.inertia(), later.body_momentum);
  assert(std::abs(energy - kinetic_energy(brick.inertia(), M)) < 1e-12);
  // [free_body]
  // [free_steps]
  FreeSteps motion(brick, 0.1);
  motion.advance(10000);
  FreeState const stepped = motion.state();  // the same motion, step by step
  assert((stepped.body_momentum.components - later.body_momentum.components).norm() < 1e-10);
  // [free_steps]
  // [moser_veselov_parameters]
  // The scheme of Moser and Veselov without an iteration: of order 2, or 4 with modified moments.
  auto const error = [&](int order) {
    FreeSteps steps(brick, 0.1, brick.moser_veselov_parameters(0.1, order));
    steps.advance(100);
    return (steps.state().body_momentum.components - brick.at(10).body_momentum.components).norm();
  };
  assert(error(2) < 1e-2 && error(4) < error(2) / 100);
  // [moser_veselov_parameters]
}

BOOST_AUTO_TEST_CASE(body_under_a_torque) {
  // [torqued_body]
  // A rod of 1 kg and 1 m that hangs from its end, a pendulum of length 2/3, let go at 0.1 rad. SI units.
  auto const rod = inertia_from_moments(1.0 / 3, 1.0 / 3, 1e-6);  // about the end
  auto const gravity = uniform_gravity(Eigen::Vector3d(0, 0, -0.5 * 9.81), Eigen::Vector3d(0, 0, -1));
  auto const tilted = exp(velocity(SU2{}, Eigen::Vector3d(0.1, 0, 0)));
  TorquedBody body(rod, momentum(SO<3>{}, Eigen::Vector3d(0, 0, 0)), tilted, gravity, 0.001,
                   blanes_moan_splitting());
  double const period = 2 * std::numbers::pi * std::sqrt(2.0 / 3 / 9.81) * (1 + 0.01 / 16);
  body.step(std::lround(period / 0.001));
  FreeState const now = body.state();
  double const energy = kinetic_energy(rod, now.body_momentum) + gravity.potential(now.attitude);
  assert(std::abs(energy - gravity.potential(tilted)) < 1e-9);
  assert(now.body_momentum.components.norm() < 1e-3);  // back, and at rest again
  // [torqued_body]
}

BOOST_AUTO_TEST_CASE(torque_of_the_velocity) {
  // [velocity_torque]
  // Drag slows a body that turns about its third axis: w = w(0) e^(-ct/I_3).
  auto const drag = [](Four<double> const&, double, Three<double> const& w, double) {
    return Three<double>{-0.1 * w[0], -0.1 * w[1], -0.1 * w[2]};
  };
  auto const still = exp(velocity(SU2{}, Eigen::Vector3d(0, 0, 0)));
  TorquedBody body(inertia_from_moments(1, 1.5, 2), momentum(SO<3>{}, Eigen::Vector3d(0, 0, 2)), still, drag,
                   0.1, composed_splitting("Suzuki", 4, suzuki<double>()));
  body.step(100);
  assert(std::abs(body.state().body_momentum.components[2] - 2 * std::exp(-0.1 / 2 * 10)) < 1e-9);
  // [velocity_torque]
}

BOOST_AUTO_TEST_CASE(torque_of_a_potential) {
  // [potential_torque]
  // A magnet in a field along e_3 of space: V = -m R_33, given with its slope by the entries of R.
  PotentialTorque const field([](NineEntries const& R, double, NineEntries& slope) {
    slope = {};
    slope[8] = -0.2;
    return -0.2 * R[8];
  });
  auto const q = exp(velocity(SU2{}, Eigen::Vector3d(0.3, 0, 0)));  // turned about e_1
  assert(std::abs(field.potential(q) + 0.2 * std::cos(0.3)) < 1e-15);
  auto const torque = field({q.value[0], q.value[1], q.value[2], q.value[3]}, 0.0);
  assert(std::abs(torque[0] + 0.2 * std::sin(0.3)) < 1e-15);  // back to e_3
  // [potential_torque]
}

BOOST_AUTO_TEST_CASE(bodies_of_n_dimensions) {
  // [moser_veselov_n]
  auto const body = inertia_from_lambda<Dynamic, double>(Eigen::VectorXd::LinSpaced(8, 1.0, 2.0).eval());
  Eigen::VectorXd const M = Eigen::VectorXd::LinSpaced(28, -0.3, 0.4);  // n(n-1)/2
  FastMoserVeselov const scheme(body, 0.05);
  auto moving = scheme.release(momentum(SO<Eigen::Dynamic>{8}, M));
  for (int k = 0; k < 1000; ++k) scheme.step_with_attitude(moving);
  assert(std::abs(moving.momentum().components.norm() - M.norm()) < 1e-12);
  Eigen::MatrixXd const g = moving.attitude().value;
  assert((g * g.transpose() - Eigen::MatrixXd::Identity(8, 8)).norm() < 1e-12);
  // [moser_veselov_n]
}

// ---- two_bodies

BOOST_AUTO_TEST_CASE(a_binary_asteroid) {
  // [two_bodies]
  auto const primary =
      ellipsoid_body(5.26e11, {394, 394, 290}, 4);  // mass in kg, half axes in m, order of moments
  auto const moon = ellipsoid_body(4.9e9, {96, 75, 60}, 4);
  Element<SU2, double> const upright = identity<double>(SU2{});
  auto const start = state_of_velocities(primary, moon, {1189, 0, 0}, {0, 0.172, 0},  // position and velocity
                                         upright, {0, 0, 7.7e-4}, upright, {0, 0, 1.46e-4});
  TwoBodies pair(primary, moon, start, {.order = 4, .step = 1200});
  auto const momentum = pair.angular_momentum();
  double const energy = pair.energy();
  pair.step(7200);  // a hundred days
  assert((pair.angular_momentum() - momentum).norm() < 1e-14 * momentum.norm());
  assert(std::abs(pair.energy() / energy - 1) < 1e-9);
  // [two_bodies]
}

// ---- bodies

BOOST_AUTO_TEST_CASE(from_the_catalogue) {
  std::string const folder = ACTIO_DATA;
  // [read_body]
  Body const apophis = read_body(folder + "/bodies.toml", "apophis");
  auto const start = body_momentum(apophis.principal, apophis.spin);
  FreeBody const asteroid(apophis.principal, start);
  assert(apophis.unit == "ratio" && apophis.time == "h");
  assert(std::abs(asteroid.at(24).body_momentum.components.norm() - start.components.norm()) < 1e-14);
  // [read_body]
}

// ---- rods

BOOST_AUTO_TEST_CASE(rods_in_space) {
  using namespace actio::rods;
  // [rod_section]
  // A wire of steel, 1 mm thick.
  auto const wire = RodSection::circular(0.5e-3, 2e11, 0.3, 7800);
  assert(std::abs(wire.mass - 7800 * std::numbers::pi * 0.25e-6) < 1e-15);
  // [rod_section]
  // [rod_shape]
  // Half a circle of it, 30 cm long: bent about the third axis of its sections.
  double const bend = std::numbers::pi / 0.3;
  auto const shape = RodShape::of_strains(0.3, 40, {0, 0, 0}, {1, 0, 0, 0},
                                          [=](double) { return Three<double>{0, 0, bend}; });
  assert(std::abs(shape.places.back()[1] - 2 / bend) < 1e-3);
  // [rod_shape]
  // [rod]
  // It is straight at rest, and let go: it swings, and momentum stays zero.
  auto const straight = RodShape::of_strains(0.3, 40, {0, 0, 0}, {1, 0, 0, 0});
  Rod rod(wire, straight, {shape, {}, {}}, {}, {1e-6, true});
  double const before = rod.energies(rod.frame()).strain;
  rod.step(1000);
  auto const now = rod.energies(rod.frame());
  assert(std::abs(now.kinetic + now.strain - before) < 1e-3 * before);
  assert(std::abs(rod.momentum().linear[1]) < 1e-15);
  // [rod]
}

BOOST_AUTO_TEST_SUITE_END()
