// A body in a potential of one's own: its torque, its order where the potential depends on time, and what it
// shares with the torques that have a name.
#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/potential_torque.hpp"
#include "actio/fast_body/space/torqued_body.hpp"
#include "actio/fast_body/space/uniform_gravity.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Attitude = Element<SU2, double>;
using Seven = actio::Vector<double, 7>;

Inertia<3> const inertia = inertia_from_moments(0.8, 1.0, 0.6);
Momentum<SO<3>, double> const start_momentum{SO<3>{}, {0.5, 0.9, 0.4}};
Attitude const attitude{SU2{}, Eigen::Vector4d(1, 0.2, 0.3, -0.4).normalized()};

Matrix3d matrix(NineEntries const& entries) {
  return Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor> const>(entries.data());
}
Four<double> four(Eigen::Vector4d const& q) { return {q[0], q[1], q[2], q[3]}; }

/// V = r33^4 cos(2t) / 2 - 0.7 r12 sin(3t) + r21 r32, energy.
double value(Matrix3d const& R, double t) {
  return std::pow(R(2, 2), 4) * std::cos(2 * t) / 2 - 0.7 * R(0, 1) * std::sin(3 * t) + R(1, 0) * R(2, 1);
}
PotentialTorque const messy([](NineEntries const& r, double t, NineEntries& slope) {
  Matrix3d const R = matrix(r);
  slope = {};
  slope[8] = 2 * R(2, 2) * R(2, 2) * R(2, 2) * std::cos(2 * t);
  slope[1] = -0.7 * std::sin(3 * t);
  slope[3] = R(2, 1), slope[7] = R(1, 0);
  return value(R, t);
});

/// Euler's equations with the torque written out by components.
FreeState solved(double duration) {
  auto const equations = [](double t, Seven const& y) {
    Vector3d const M = y.head<3>(), w = M.cwiseQuotient(Vector3d(inertia.moments)), q = y.tail<3>();
    Matrix3d const R = Eigen::Quaterniond(y[3], y[4], y[5], y[6]).normalized().toRotationMatrix();
    double const n3 = R(2, 2), quartic = 2 * n3 * n3 * n3 * std::cos(2 * t), wave = -0.7 * std::sin(3 * t);
    // A row (a, b, c) of R that a turn changes by (b z - c y, c x - a z, a y - b x): minus the factors of x,
    // y, z.
    Vector3d torque(quartic * R(2, 1), -quartic * R(2, 0), 0);
    torque += wave * Vector3d(-R(0, 2), 0, R(0, 0));
    torque += R(2, 1) * Vector3d(0, R(1, 2), -R(1, 1)) + R(1, 0) * Vector3d(-R(2, 2), 0, R(2, 0));
    Seven change;
    change << M.cross(w) + torque, -0.5 * q.dot(w), 0.5 * (y[3] * w + q.cross(w));
    return change;
  };
  Seven start;
  start << start_momentum.components, attitude.value;
  Seven const end = reference_solution(equations, start, 0, duration);
  return {{SO<3>{}, end.head<3>()}, {SU2{}, end.tail<4>()}};
}
double apart(FreeState const& a, FreeState const& b) {
  Eigen::Vector4d const p = a.attitude.value, q = b.attitude.value;
  return (a.body_momentum.components - b.body_momentum.components).norm() +
         std::min((p - q).norm(), (p + q).norm());
}
template <class Torque>
FreeState after(double duration, int steps, Torque const& torque,
                Splitting const& method = strang_splitting()) {
  TorquedBody body(inertia, start_momentum, attitude, torque, duration / steps, method);
  body.step(steps);
  return body.state();
}
}  // namespace

BOOST_AUTO_TEST_SUITE(potential_torque)

BOOST_AUTO_TEST_CASE(the_entries_are_those_of_the_rotation) {
  Eigen::Vector4d const q = attitude.value;
  Matrix3d const expected = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  BOOST_TEST((matrix(rotation_entries(four(q))) - expected).norm() <= 8 * eps);
}

BOOST_AUTO_TEST_CASE(the_torque_is_what_the_potential_falls_by) {
  Eigen::Vector4d const q = attitude.value;
  double const t = 0.4, small = 1e-5;
  Three<double> const torque = messy(four(q), t);
  for (int i = 0; i < 3; ++i) {
    auto const turned = [&](double by) {
      Eigen::Quaterniond const turn(Eigen::AngleAxisd(by, Vector3d::Unit(i)));
      return value((Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * turn).toRotationMatrix(), t);
    };
    BOOST_TEST(std::abs(torque[i] + (turned(small) - turned(-small)) / (2 * small)) <= 1e-9);
  }
  BOOST_TEST(messy.potential(attitude, t) == value(matrix(rotation_entries(four(q))), t));
}

BOOST_AUTO_TEST_CASE(orders_two_and_four_are_measured_where_the_potential_depends_on_time) {
  double const duration = 6;
  FreeState const truth = solved(duration);
  for (auto const& method : {strang_splitting(), blanes_moan_splitting()}) {
    std::vector<double> steps, errors;
    for (int count = 64; count <= 1024; count *= 2) {
      steps.push_back(duration / count);
      errors.push_back(apart(after(duration, count, messy, method), truth));
    }
    auto const fit = testing::fit_order(steps, errors);
    BOOST_TEST_MESSAGE(method.name << ", potential in time: order " << fit.slope << ", errors "
                                   << errors.front() << " to " << errors.back());
    BOOST_TEST(std::abs(fit.slope - method.order) < 0.15);
  }
  // A control: the potential one step late.
  auto const late = [](Four<double> const& q, double t) { return messy(q, t - 6.0 / 1024); };
  BOOST_TEST(apart(after(duration, 1024, late), truth) > 10 * apart(after(duration, 1024, messy), truth));
}

BOOST_AUTO_TEST_CASE(a_step_back_undoes_a_step_and_steps_may_be_taken_in_parts) {
  for (auto const& method : {strang_splitting(), blanes_moan_splitting()}) {
    int const steps = 300;
    TorquedBody there(inertia, start_momentum, attitude, messy, 0.05, method), parts = there;
    there.step(steps);
    auto const turn = there.state();
    TorquedBody back(inertia, turn.body_momentum, turn.attitude, messy, -0.05, method, there.time());
    back.step(steps);
    double const room = 20 * eps * 2 * steps * static_cast<double>(method.drifts.size());
    BOOST_TEST(apart(back.state(), {start_momentum, attitude}) <= room);
    // A kick that is split in two is rounded twice, and the time goes on where it was.
    for (int k = 0; k < steps / 10; ++k) parts.step(10);
    BOOST_TEST(apart(parts.state(), turn) <= room);
  }
}

BOOST_AUTO_TEST_CASE(the_torques_that_have_a_name_are_those_of_their_potentials) {
  Vector3d const lever(0.3, -0.2, 0.9), towards = Vector3d(1, 2, 0.5).normalized();
  PotentialTorque const weight([=](NineEntries const& r, double, NineEntries& slope) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) slope[static_cast<std::size_t>(3 * i + j)] = -towards[i] * lever[j];
    return -towards.dot(matrix(r) * lever);
  });
  PotentialTorque const gradient([=](NineEntries const& r, double, NineEntries& slope) {
    Vector3d const n = matrix(r).transpose() * towards, In = n.cwiseProduct(Vector3d(inertia.moments));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) slope[static_cast<std::size_t>(3 * i + j)] = 1.5 * towards[i] * In[j];
    return 0.75 * n.dot(In);
  });
  auto const named_weight = uniform_gravity(lever, towards);
  auto const named_gradient = gravity_gradient(inertia, 1.5, towards);
  int const steps = 100;
  for (auto const& method : {strang_splitting(), blanes_moan_splitting()}) {
    double const room = 20 * eps * steps * static_cast<double>(method.drifts.size());
    BOOST_TEST(apart(after(5, steps, weight, method), after(5, steps, named_weight, method)) <= room);
    BOOST_TEST(apart(after(5, steps, gradient, method), after(5, steps, named_gradient, method)) <= room);
  }
  BOOST_TEST(std::abs(weight.potential(attitude) - named_weight.potential(attitude)) <= 8 * eps);
  BOOST_TEST(std::abs(gradient.potential(attitude) - named_gradient.potential(attitude)) <= 8 * eps);
}

BOOST_AUTO_TEST_SUITE_END()
