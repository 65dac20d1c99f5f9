#include <Eigen/Core>

#include "program/systems/bodies/free_motion.hpp"

#include <optional>

namespace actio::scene {
namespace {

/// To any time at once.
class ExactMotion : public TurningBody {
 public:
  explicit ExactMotion(bodies::FreeBody body) : body_(std::move(body)), now_(body_.at(0)) {}
  void go_to(double time) override {
    if (attitude_wanted())
      now_ = body_.at(time);
    else
      now_.body_momentum = body_.body_momentum_at(time);
  }
  Eigen::Vector3d body_momentum() const override { return now_.body_momentum.components; }
  Eigen::Vector4d attitude() const override { return now_.attitude.value; }

 private:
  bodies::FreeBody body_;
  bodies::FreeState now_;
};

/// In steps, with the attitude or without.
template <class Steps>
class SteppedMotion : public TurningBody {
 public:
  SteppedMotion(StepsFrom<Steps> from, bodies::FreeState const& start, double step)
      : from_(std::move(from)), start_(start), steps_(from_(start, step)) {}
  void advance(long count) override {
    ahead_.reset();
    move(steps_, count);
  }
  void look_ahead(double time) override {
    ahead_.reset();
    if (time == 0) return;
    // Without an attitude any will do.
    ahead_.emplace(
        from_({steps_.body_momentum(), attitude_wanted() ? steps_.state().attitude : identity<double>(SU2{})},
              time));
    move(*ahead_, 1);
  }
  void change_step(double first, double step, long) override {
    ahead_.reset();
    if (first > 0) steps_ = of_length(first), move(steps_, 1);
    steps_ = of_length(step);
  }
  void remember(CheckpointStream& stream) override { steps_.remember(stream); }
  Eigen::Vector3d body_momentum() const override { return now().body_momentum().components; }
  Eigen::Vector4d attitude() const override { return now().state().attitude.value; }

 private:
  void move(Steps& steps, long count) const {
    if (attitude_wanted())
      steps.advance(count);
    else
      steps.advance_momentum(count);
  }
  Steps const& now() const { return ahead_ ? *ahead_ : steps_; }
  /// Steps of the same orbit, which go on from where the others are.
  Steps of_length(double step) {
    CheckpointStream saved;
    steps_.remember(saved);
    CheckpointStream restored(saved.bytes());
    Steps out = from_(start_, step);
    out.remember(restored);
    if constexpr (requires { out.forget_steps(); }) out.forget_steps();
    return out;
  }

  StepsFrom<Steps> from_;
  bodies::FreeState start_;
  Steps steps_;
  std::optional<Steps> ahead_;
};

}  // namespace

std::unique_ptr<TurningBody> exact_motion(bodies::FreeBody body) {
  return std::make_unique<ExactMotion>(std::move(body));
}
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<bodies::FreeSteps> steps,
                                            bodies::FreeState const& start, double step) {
  return std::make_unique<SteppedMotion<bodies::FreeSteps>>(std::move(steps), start, step);
}
std::unique_ptr<TurningBody> stepped_motion(StepsFrom<bodies::NaturalChartSteps> steps,
                                            bodies::FreeState const& start, double step) {
  return std::make_unique<SteppedMotion<bodies::NaturalChartSteps>>(std::move(steps), start, step);
}

}  // namespace actio::scene
