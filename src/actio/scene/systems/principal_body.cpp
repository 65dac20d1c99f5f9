#include "actio/scene/systems/principal_body.hpp"

namespace actio::scene {
namespace {

/// To any time at once.
class ExactMotion : public PrincipalBody {
 public:
  ExactMotion(FreeBody body, GivenInertia const& inertia) : PrincipalBody(inertia), body_(std::move(body)), now_(body_.at(0)) {}
  void go_to(double time) override {
    if (attitude_wanted()) now_ = body_.at(time);
    else now_.body_momentum = body_.body_momentum_at(time);
  }

 protected:
  Eigen::Vector3d principal_momentum() const override { return now_.body_momentum.components; }
  Eigen::Vector4d principal_attitude() const override { return now_.attitude.value; }

 private:
  FreeBody body_;
  FreeState now_;
};

/// In steps, with the attitude or without.
template <class Steps>
class SteppedMotion : public PrincipalBody {
 public:
  SteppedMotion(Steps steps, GivenInertia const& inertia) : PrincipalBody(inertia), steps_(std::move(steps)) {}
  void advance(long count) override {
    if (attitude_wanted()) steps_.advance(count);
    else steps_.advance_momentum(count);
  }
  void remember(Memory& memory) override { steps_.remember(memory); }

 protected:
  Eigen::Vector3d principal_momentum() const override { return steps_.body_momentum().components; }
  Eigen::Vector4d principal_attitude() const override { return steps_.state().attitude.value; }

 private:
  Steps steps_;
};

}  // namespace

PrincipalStart::PrincipalStart(GivenInertia const& inertia, Eigen::Vector3d const& given, Eigen::Vector4d const& q)
    : momentum{{}, inertia.turned ? Eigen::Vector3d(inertia.axes.transpose() * given) : given}, attitude{{}, inertia.turned ? compose(q, quaternion(inertia.axes)) : q} {}

PrincipalBody::PrincipalBody(GivenInertia const& inertia) : inertia_(inertia), back_(quaternion(inertia.axes).cwiseProduct(Eigen::Vector4d(1, -1, -1, -1))) {}
Eigen::Vector3d PrincipalBody::body_momentum() const {
  Eigen::Vector3d const M = principal_momentum();
  return inertia_.turned ? Eigen::Vector3d(inertia_.axes * M) : M;
}
Eigen::Vector4d PrincipalBody::attitude() const {
  Eigen::Vector4d const q = principal_attitude();
  return inertia_.turned ? Eigen::Vector4d(compose(q, back_).normalized()) : q;
}

std::unique_ptr<TurningBody> exact_motion(FreeBody body, GivenInertia const& inertia) { return std::make_unique<ExactMotion>(std::move(body), inertia); }
std::unique_ptr<TurningBody> stepped_motion(FreeSteps steps, GivenInertia const& inertia) { return std::make_unique<SteppedMotion<FreeSteps>>(std::move(steps), inertia); }
std::unique_ptr<TurningBody> stepped_motion(NaturalChartSteps steps, GivenInertia const& inertia) {
  return std::make_unique<SteppedMotion<NaturalChartSteps>>(std::move(steps), inertia);
}

}  // namespace actio::scene
