// A body that is described in a frame other than that of its principal axes moves as the same body described
// along them.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/fast_body/space/free_steps.hpp"
#include "actio/fast_body/space/natural_chart_steps.hpp"
#include "actio/fast_body/space/torqued_body.hpp"
#include "actio/fast_body/space/uniform_gravity.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

/// One motion in two descriptions: along the principal axes, and in a frame that differs from it by a turn.
struct TwoFrames {
  Inertia<3> inertia;
  PrincipalInertia turned;
  FreeState start, turned_start;

  TwoFrames(Eigen::Vector3d const& moments, Eigen::Matrix3d const& axes, Eigen::Vector3d const& momentum,
            Eigen::Vector4d const& q)
      : inertia(inertia_from_moments<double>(moments)),
        turned(inertia, axes),
        start{{SO<3>{}, momentum}, {SU2{}, q.normalized()}},
        turned_start(seen(start)) {}

  Eigen::Vector4d turn() const { return quaternion_of_rotation<double>(turned.axes); }
  /// A state along the principal axes, in the other frame.
  FreeState seen(FreeState const& s) const {
    Eigen::Vector4d const q = SU2::compose<double>(s.attitude.value, SU2::inverse<double>(turn()));
    return {{SO<3>{}, turned.axes * Eigen::Vector3d(s.body_momentum.components)}, {SU2{}, q}};
  }
  /// How far two states of the other frame are apart: relative for the momentum.
  double apart(FreeState const& a, FreeState const& b) const {
    double const amount = start.body_momentum.components.norm();
    return std::max((a.body_momentum.components - b.body_momentum.components).norm() / amount,
                    (a.attitude.value - b.attitude.value).norm());
  }
};

/// Frames of catalogue bodies, of a nearly symmetric one and of a sphere; the last is a mere exchange of
/// axes.
std::vector<TwoFrames> frames() {
  Eigen::Matrix3d const
      slanted = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(),
      over = Eigen::AngleAxisd(3.0, Eigen::Vector3d(0.2, 0.1, 1).normalized()).toRotationMatrix();
  Eigen::Matrix3d exchanged;
  exchanged << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  Eigen::Vector4d const q(0.8, -0.1, 0.5, 0.3);
  return {{{0.6, 0.8, 1}, slanted, {1.8, 0.4, -0.9}, q},
          {{1, 0.6, 0.8}, over, {0.1, 1.2, 0.3}, q},
          {{1, 1, 1.5}, slanted, {0.3, 0.4, 1}, q},
          {{1, 1, 1}, over, {0.3, 0.4, 1}, q},
          {{0.8, 1, 0.6}, exchanged, {0.2, 1, 0.4}, q}};
}
/// Rounding: a few epsilon for each radian that the body may have turned by, and for the turn itself.
double room(TwoFrames const& f, double time) {
  return 32 * eps * (1 + time * f.start.body_momentum.components.norm() / f.inertia.moments.minCoeff());
}
}  // namespace

BOOST_AUTO_TEST_SUITE(turned_axes)

BOOST_AUTO_TEST_CASE(a_free_body_speaks_in_its_frame) {
  for (auto const& f : frames()) {
    FreeBody const body(f.inertia, f.start.body_momentum, f.start.attitude),
        turned(f.turned, f.turned_start.body_momentum, f.turned_start.attitude);
    for (double const t : {0.0, 0.3, -7.0, 40.0}) {
      BOOST_TEST(f.apart(f.seen(body.at(t)), turned.at(t)) <= room(f, std::abs(t)));
      BOOST_TEST(turned.body_momentum_at(t).components == turned.at(t).body_momentum.components);
    }
    BOOST_TEST(turned.is_symmetric() == body.is_symmetric());
  }
}

BOOST_AUTO_TEST_CASE(steps_speak_in_the_frame_of_the_body) {
  for (auto const& f : frames()) {
    FreeSteps steps(FreeBody(f.inertia, f.start.body_momentum, f.start.attitude), 0.1),
        turned(FreeBody(f.turned, f.turned_start.body_momentum, f.turned_start.attitude), 0.1);
    NaturalChartSteps chart(f.inertia, f.start.body_momentum, f.start.attitude, 0.1),
        turned_chart(f.turned, f.turned_start.body_momentum, f.turned_start.attitude, 0.1);
    for (auto* s : {&steps, &turned}) s->advance(100);
    for (auto* s : {&chart, &turned_chart}) s->advance(100);
    BOOST_TEST(f.apart(f.seen(steps.state()), turned.state()) <= room(f, 10));
    BOOST_TEST(f.apart(f.seen(chart.state()), turned_chart.state()) <= room(f, 10));
  }
}

BOOST_AUTO_TEST_CASE(torques_are_those_of_the_frame_of_the_body) {
  for (auto const& f : frames()) {
    Eigen::Vector3d const lever(0.1, -0.2, 0.3), turned_lever = f.turned.axes * lever, down(0, 0.6, -0.8);
    auto const moved = [&](auto const& inertia, FreeState const& s, auto const& torque) {
      TorquedBody body(inertia, s.body_momentum, s.attitude, torque, 0.01, blanes_moan_splitting());
      body.step(100);
      return body.state();
    };
    UniformGravity const here = uniform_gravity(lever, down), there = uniform_gravity(turned_lever, down);
    FreeState const expected = f.seen(moved(f.inertia, f.start, here));
    BOOST_TEST(f.apart(expected, moved(f.turned, f.turned_start, there)) <= room(f, 1));
    // The same as a function of which the frame knows nothing.
    auto const any = [there](Four<double> const& q, double time) { return there(q, time); };
    BOOST_TEST(f.apart(expected, moved(f.turned, f.turned_start, any)) <= room(f, 1));
    // The gradient of gravity is made of the principal moments.
    auto const gradient = gravity_gradient(f.inertia, 0.5, down);
    BOOST_TEST(f.apart(f.seen(moved(f.inertia, f.start, gradient)),
                       moved(f.turned, f.turned_start, gradient)) <= room(f, 1));
  }
}

BOOST_AUTO_TEST_CASE(axes_that_are_no_rotation_are_refused) {
  Inertia<3> const inertia = inertia_from_moments(0.6, 0.8, 1);
  Momentum<SO<3>, double> const m{SO<3>{}, Eigen::Vector3d(1, 0, 0)};
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity(), stretched = mirror, none = mirror;
  mirror(2, 2) = -1, stretched(0, 0) = 1 + 1e-6, none(0, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_REFUSED(FreeBody({inertia, mirror}, m), OutsideDomain);
  CHECK_REFUSED(FreeBody({inertia, stretched}, m), OutsideDomain);
  CHECK_REFUSED(FreeBody({inertia, none}, m), NotFinite);
}

BOOST_AUTO_TEST_SUITE_END()
