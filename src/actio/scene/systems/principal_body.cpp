#include "actio/scene/systems/principal_body.hpp"

#include <optional>

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
  SteppedMotion(StepsFrom<Steps> from, PrincipalStart const& start, double step, GivenInertia const& inertia)
      : PrincipalBody(inertia), from_(std::move(from)), steps_(from_(start.momentum, start.attitude, step)) {}
  void advance(long count) override {
    ahead_.reset();
    move(steps_, count);
  }
  void look_ahead(double time) override {
    ahead_.reset();
    if (time == 0) return;
    // Without an attitude any will do.
    ahead_.emplace(from_(steps_.body_momentum(), attitude_wanted() ? steps_.state().attitude : identity<double>(SU2{}), time));
    move(*ahead_, 1);
  }
  void remember(Memory& memory) override { steps_.remember(memory); }

 protected:
  Eigen::Vector3d principal_momentum() const override { return now().body_momentum().components; }
  Eigen::Vector4d principal_attitude() const override { return now().state().attitude.value; }

 private:
  void move(Steps& steps, long count) const {
    if (attitude_wanted()) steps.advance(count);
    else steps.advance_momentum(count);
  }
  Steps const& now() const { return ahead_ ? *ahead_ : steps_; }

  StepsFrom<Steps> from_;
  Steps steps_;
  std::optional<Steps> ahead_;
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
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<FreeSteps> steps, PrincipalStart const& start, double step, GivenInertia const& inertia) {
  return std::make_unique<SteppedMotion<FreeSteps>>(std::move(steps), start, step, inertia);
}
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<NaturalChartSteps> steps, PrincipalStart const& start, double step, GivenInertia const& inertia) {
  return std::make_unique<SteppedMotion<NaturalChartSteps>>(std::move(steps), start, step, inertia);
}

}  // namespace actio::scene
