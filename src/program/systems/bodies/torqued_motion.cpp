#include <Eigen/Core>

#include "program/systems/bodies/torqued_motion.hpp"

#include <fmt/format.h>

#include <optional>
#include <type_traits>

#include "actio/fast_body/space/torqued_body.hpp"
#include "actio/reduction/composition.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {
namespace {

/// Steps of kicks and drifts.
template <class Torque>
class StepsOfTorque : public TorquedMotion {
 public:
  StepsOfTorque(PrincipalInertia const& inertia, bodies::FreeState const& start, Torque torque, double step,
                bodies::Splitting method)
      : inertia_(inertia), inverse_(inertia.inverse_tensor()), torque_(std::move(torque)), now_(start) {
    body_.emplace(inertia, start.body_momentum, start.attitude, torque_, step, std::move(method));
    now_ = body_->state();
  }
  void advance(long steps) override {
    body_->step(steps);
    show(*body_);
    // The energy bounds how fast gravity makes a body turn; a formula may do anything.
    if constexpr (std::is_same_v<Torque, bodies::PotentialTorque<FormulaPotential>> ||
                  std::is_same_v<Torque, FormulaTorque>)
      check_turn();
  }
  void look_ahead(double time) override {
    show(*body_);
    if (time == 0) return;
    auto ahead = from_here(time);
    ahead.step();
    show(ahead);
  }
  void change_step(double first, double step, long made) override {
    show(*body_);
    if (first > 0) {
      auto on_the_way = from_here(first);
      on_the_way.step();
      show(on_the_way);
    }
    body_.emplace(inertia_, now_.body_momentum, now_.attitude, torque_, step,
                  bodies::Splitting(body_->method()));
    auto counted = [made](auto&, auto&, long& steps) { steps = made; };
    body_->remember(counted);
    show(*body_);
  }
  void remember(CheckpointStream& stream) override {
    body_->remember(stream);
    show(*body_);
  }
  Eigen::Vector3d body_momentum() const override { return now_.body_momentum.components; }
  Eigen::Vector4d attitude() const override { return now_.attitude.value; }
  double time() const override { return time_; }

 private:
  /// The body as it is shown, with a step of this length.
  bodies::TorquedBody<Torque> from_here(double step) const {
    return {inertia_, now_.body_momentum, now_.attitude, torque_, step, body_->method(), time_};
  }
  void show(bodies::TorquedBody<Torque> const& body) { now_ = body.state(), time_ = body.time(); }
  void check_turn() const {
    double const turn = (inverse_ * body_momentum()).norm() * body_->step_length();
    if (turn > turn_of_a_step::most)
      throw Error(
          fmt::format("step: under this torque the body has come to turn by {:.3g} rad in a step of {}, "
                      "and the scheme is meant for at most {} rad; a step of {:.3g} would do here",
                      turn, body_->step_length(), turn_of_a_step::most,
                      body_->step_length() * turn_of_a_step::most / turn));
  }

  PrincipalInertia inertia_;
  Eigen::Matrix3d inverse_;
  Torque torque_;
  std::optional<bodies::TorquedBody<Torque>> body_;
  bodies::FreeState now_;
  double time_ = 0;
};

}  // namespace

std::unique_ptr<TorquedMotion> torqued_motion(PrincipalInertia const& inertia, bodies::FreeState const& start,
                                              AnyTorque const& torque, double step,
                                              std::string const& order) {
  // Kicks by a torque without a potential have none of the brackets that vanish for one.
  auto const method = order == "2" ? bodies::strang_splitting()
                      : std::holds_alternative<FormulaTorque>(torque)
                          ? bodies::composed_splitting("Suzuki", 4, suzuki<double>())
                          : bodies::blanes_moan_splitting();
  return std::visit(
      [&](auto const& t) -> std::unique_ptr<TorquedMotion> {
        return std::make_unique<StepsOfTorque<std::decay_t<decltype(t)>>>(inertia, start, t, step, method);
      },
      torque);
}

void check_turn_of_step(SceneTable const& method, Schedule const& schedule, double step, double fastest,
                        std::string const& what, std::vector<std::string>& remarks) {
  double const turn = step * fastest;
  if (turn > turn_of_a_step::most * (1 + 1e-9))
    fail_for_long_step(
        method, schedule, StepTooLong("variational", step, turn_of_a_step::most / fastest),
        fmt::format("{} by {:.3g} rad in a step of {}, and the scheme is meant for at most {} rad", what,
                    turn, step, turn_of_a_step::most));
  if (turn > turn_of_a_step::much)
    remarks.push_back(
        fmt::format("step: {} by {:.2g} rad in a step of {}; up to {} rad, a step of "
                    "{:.2g}, the scheme is accurate",
                    what, turn, step, turn_of_a_step::much, turn_of_a_step::much / fastest));
}

double swing_frequency(PrincipalInertia const& inertia, Eigen::Matrix3d const& curvature) {
  Eigen::Vector3d const root = Eigen::Vector3d(inertia.inertia.moments).cwiseSqrt().cwiseInverse();
  Eigen::Matrix3d const along = inertia.axes.transpose() * curvature * inertia.axes;
  return std::sqrt((root.asDiagonal() * along * root.asDiagonal()).norm());
}

double swing_of_weight(PrincipalInertia const& inertia, Eigen::Vector3d const& lever) {
  Eigen::Vector3d const unit = lever.normalized();
  return swing_frequency(inertia, lever.norm() * (Eigen::Matrix3d::Identity() - unit * unit.transpose()));
}

double work_of_step(std::string const& order) {
  auto const method = order == "2" ? bodies::strang_splitting() : bodies::blanes_moan_splitting();
  return static_cast<double>(method.drifts.size());
}

Method variational_method(std::string const& torque) {
  return {"variational",
          {"4", "2"},
          "Kicks of " + torque +
              " and the exact flow of the free body: the action of the free motion and the trapezoid of "
              "the potential, order 2 (Strang); with more nodes 4 (Blanes and Moan).",
          ""};
}

}  // namespace actio::scene
