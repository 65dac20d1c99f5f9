// Torques that depend on the angular velocity: drag in closed form, orders, the way back, and what is
// refused.
#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include "actio/fast_body/space/torqued_body.hpp"
#include "actio/reduction/composition.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// A body that turns about its second axis alone.
template <class Torque>
TorquedBody<Torque> about_second_axis(Torque const& torque, double h, Splitting const& method) {
  return {inertia_from_moments(1, 2, 2.5), {SO<3>{}, {0, 3, 0}}, {SU2{}, {1, 0, 0, 0}}, torque, h, method};
}
/// Linear drag at the rate 1/4.
auto const drag = [](Four<double> const&, double, Three<double> const& w, double) {
  return Three<double>{-0.5 * w[0], -0.5 * w[1], -0.5 * w[2]};
};

}  // namespace

BOOST_AUTO_TEST_SUITE(velocity_torques)

BOOST_AUTO_TEST_CASE(drag_decays_by_the_rational_factor_of_gauss_in_each_kick) {
  // dM/ds = -z M over a unit of s: (1 - z/2 + z^2/12)/(1 + z/2 + z^2/12), twice a step with half of it.
  double const h = 0.5, z = 0.25 * h / 2, factor = (1 - z / 2 + z * z / 12) / (1 + z / 2 + z * z / 12);
  auto body = about_second_axis(drag, h, strang_splitting());
  body.step(10);
  double const truth = 3 * std::pow(factor, 20);
  // Two stages and a sum of a few roundings each in twenty kicks.
  BOOST_TEST(std::abs(body.state().body_momentum.components[1] - truth) < 64 * 20 * eps * truth);
}

BOOST_AUTO_TEST_CASE(steps_back_undo_steps) {
  auto const uneven = [](Four<double> const& q, double t, Three<double> const& w, double) {
    return Three<double>{-0.3 * w[0] * w[1] + 0.2 * q[1], 0.1 * std::cos(t) - 0.2 * w[1] * w[0], 0.4 * w[0]};
  };
  for (auto const& method : {strang_splitting(), composed_splitting("Suzuki", 4, suzuki<double>())}) {
    PrincipalInertia const inertia = inertia_from_moments(0.8, 1.0, 0.6);
    Vector3d const M(0.5, 0.9, 0.4);
    TorquedBody there(inertia, {SO<3>{}, M}, {SU2{}, {1, 0, 0, 0}}, uneven, 0.1, method);
    there.step(20);
    auto const middle = there.state();
    BOOST_TEST((middle.body_momentum.components - M).norm() > 0.1);
    TorquedBody back(inertia, middle.body_momentum, middle.attitude, uneven, -0.1, method, 2);
    back.step(20);
    BOOST_TEST((back.state().body_momentum.components - M).norm() < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(an_input_held_over_a_step_is_that_of_its_middle) {
  // The torque is 1 in steps whose middle is before 1, and 0 in the others: the momentum grows by 1.
  auto const pulse = [](Four<double> const&, double, Three<double> const&, double middle) {
    return Three<double>{0, middle < 1 ? 1.0 : 0.0, 0};
  };
  auto body = about_second_axis(pulse, 0.125, strang_splitting());
  body.step(16);
  BOOST_TEST(std::abs(body.state().body_momentum.components[1] - 4) < 64 * eps);
}

BOOST_AUTO_TEST_CASE(a_kick_that_has_no_solution_is_refused_and_the_body_stays) {
  auto const strong = [](Four<double> const&, double, Three<double> const& w, double) {
    return Three<double>{0, -200 * w[1], 0};
  };
  auto body = about_second_axis(strong, 1, strang_splitting());
  CHECK_REFUSED(body.step(), OutsideDomain);
  BOOST_TEST(body.state().body_momentum.components[1] == 3);
  auto const lost = [](Four<double> const&, double, Three<double> const& w, double) {
    return Three<double>{0, std::sqrt(w[1] - 2), 0};
  };
  auto other = about_second_axis(lost, 1, strang_splitting());
  CHECK_REFUSED(other.step(), NotFinite);
}

BOOST_AUTO_TEST_SUITE_END()
