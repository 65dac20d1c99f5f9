// The heavy top by kicks and exact drifts: its order, what it conserves, and a benchmark.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/euler_poisson.hpp"
#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/torqued_body.hpp"
#include "actio/fast_body/space/uniform_gravity.hpp"
#include "actio/rigid_body/heavy_top_body.hpp"
#include "refused.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;
using Vector6d = actio::Vector<double, 6>;
using Moment = Momentum<SO<3>, double>;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

HeavyTop<double> const crooked = heavy_top<double>(1.5, inertia_from_moments(0.7, 1.2, 0.9),
                                                   Vector3d(0.1, -0.15, 0.2), Vector3d(1, 2, -9));
Element<SU2, double> const tilted{SU2{}, Eigen::Vector4d(1, 0.2, 0.3, -0.4).normalized()};
Vector3d const spin(1.5, -1, 2);

struct Top {
  HeavyTop<double> top;
  Vector3d velocity;
  Element<SU2, double> attitude;

  Moment momentum() const { return {SO<3>{}, top.inertia.moments.cwiseProduct(velocity)}; }
  UniformGravity gravity() const { return uniform_gravity(top.lever(), top.gravity); }
  FreeState after(double duration, int steps, Splitting const& method) const {
    TorquedBody body(top.inertia, momentum(), attitude, gravity(), duration / steps, method);
    body.step(steps);
    return body.state();
  }
  /// Momentum, and the vertical in the body frame.
  Vector6d seen(FreeState const& s) const {
    Vector6d y;
    y << s.body_momentum.components, SU2::Ad<double>(SU2::inverse<double>(s.attitude.value), top.vertical());
    return y;
  }
  Vector6d solved(double duration) const {
    testing::EulerPoisson<double> const equations{top.inertia.moments, top.lever()};
    return reference_solution([&](double, Vector6d const& y) { return equations(y); },
                              seen({momentum(), attitude}), 0, duration);
  }
  double energy(FreeState const& s) const {
    return kinetic_energy(top.inertia, s.body_momentum) + gravity().potential(s.attitude);
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(uniform_gravity_on_a_top)

BOOST_AUTO_TEST_CASE(the_torque_is_what_the_potential_falls_by) {
  auto const gravity = Top{crooked, spin, tilted}.gravity();
  auto const& q = tilted.value;
  Three<double> const torque = gravity({q[0], q[1], q[2], q[3]}, 0);
  double const small = 1e-5;
  for (int i = 0; i < 3; ++i) {
    auto const turned = [&](double angle) {
      return tilted * exp(velocity(SU2{}, Vector3d(angle * Vector3d::Unit(i))));
    };
    double const slope = (gravity.potential(turned(small)) - gravity.potential(turned(-small))) / (2 * small);
    // The difference is of second order, and has an error of epsilon over the angle.
    BOOST_TEST(std::abs(torque[i] + slope) <= 4 * (small * small + eps / small) * magnitude(crooked.lever()));
  }
}

BOOST_AUTO_TEST_CASE(orders_two_and_four_are_measured_against_the_equations_of_euler_and_poisson) {
  Top const top{crooked, spin, tilted};
  Vector6d const truth = top.solved(2);
  for (auto const& method : {strang_splitting(), blanes_moan_splitting()}) {
    std::vector<double> steps, errors;
    for (int const count : {40, 56, 80, 112, 160})
      steps.push_back(2.0 / count), errors.push_back((top.seen(top.after(2, count, method)) - truth).norm());
    auto const fit = testing::fit_order(steps, errors);
    BOOST_TEST_MESSAGE("heavy top, " << method.name << ": order " << fit.slope << ", errors "
                                     << errors.front() << " to " << errors.back());
    BOOST_TEST(std::abs(fit.slope - method.order) < 0.15);
  }
}

BOOST_AUTO_TEST_CASE(the_momentum_about_the_vertical_is_kept_and_the_energy_stays_near) {
  Top const top{crooked, spin, tilted};
  FreeState const first{top.momentum(), tilted};
  auto const vertical = [&](FreeState const& s) {
    return s.spatial_momentum().components.dot(crooked.vertical());
  };
  double const h = 0.02;
  for (auto const& method : {strang_splitting(), blanes_moan_splitting()}) {
    TorquedBody body(crooked.inertia, first.body_momentum, tilted, top.gravity(), h, method);
    double early = 0, late = 0, lost = 0;
    for (int k = 0; k < 2000; ++k) {
      body.step(20);
      auto const s = body.state();
      double& worst = k < 1000 ? early : late;
      worst = std::max(worst, std::abs(top.energy(s) - top.energy(first)));
      lost = std::max(lost, std::abs(vertical(s) - vertical(first)));
    }
    BOOST_TEST_MESSAGE("heavy top, " << method.name << ", 4e4 steps: energy off by " << early
                                     << " in the first half, " << late
                                     << " in the second; vertical momentum by " << lost);
    BOOST_TEST(late <= 1.2 * early);
    BOOST_TEST(early > 100 * eps);  // conserved by no theorem
    BOOST_TEST(lost <= 100 * eps * std::sqrt(4e4 * static_cast<double>(method.drifts.size())) *
                           first.body_momentum.components.norm());
  }
}

BOOST_AUTO_TEST_CASE(the_names_of_the_axes_do_not_matter) {
  FreeState const usual = Top{crooked, spin, tilted}.after(3, 100, blanes_moan_splitting());
  for (int shift = 1; shift < 3; ++shift) {
    auto const turned = [&](Vector3d const& x) {
      return Vector3d(x[shift], x[(shift + 1) % 3], x[(shift + 2) % 3]);
    };
    auto const other_top =
        heavy_top<double>(1.5, inertia_from_moments<double>(turned(crooked.inertia.moments)),
                          turned(crooked.centre), turned(crooked.gravity));
    Element<SU2, double> attitude = tilted;
    attitude.value.tail<3>() = turned(tilted.value.tail<3>());
    FreeState const other = Top{other_top, turned(spin), attitude}.after(3, 100, blanes_moan_splitting());
    BOOST_TEST((other.body_momentum.components - turned(usual.body_momentum.components)).norm() <= 1e-12);
    BOOST_TEST((other.attitude.value.tail<3>() - turned(usual.attitude.value.tail<3>())).norm() <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(gravity_that_is_none_is_refused) {
  CHECK_REFUSED(uniform_gravity(Vector3d(1, 2, 3), Vector3d::Zero()), OutsideDomain);
  CHECK_REFUSED(uniform_gravity(Vector3d(1, 2, std::nan("")), Vector3d(0, 0, -9)), NotFinite);
  CHECK_REFUSED(uniform_gravity(Vector3d(1, 2, 3), Vector3d(0, 0, INFINITY)), NotFinite);
}

BOOST_AUTO_TEST_SUITE_END()
