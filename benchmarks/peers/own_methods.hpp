// The methods of this library, as contestants.
#pragma once

#include <Eigen/Geometry>

#include "actio/fast_body/space/free_steps.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "peers/preprocessed_moser_veselov.hpp"

namespace peers {

inline actio::bodies::FreeBody free_body(Task const& task) {
  return {actio::inertia_from_moments(task.I[0], task.I[1], task.I[2]),
          {actio::SO<3>{}, Eigen::Vector3d(task.M[0], task.M[1], task.M[2])}};
}
inline Seven seven(actio::bodies::FreeState const& s) {
  auto const& M = s.body_momentum.components;
  auto const& q = s.attitude.value;
  return {M[0], M[1], M[2], q[0], q[1], q[2], q[3]};
}

/// Half turns with the same parameters, without compensation.
inline std::unique_ptr<Stepper> half_turns(actio::bodies::FreeBody const& body,
                                           actio::bodies::StepParameters<double> const& parameters) {
  using State = actio::bodies::FrameState<double>;
  return stepper(
      body.start(),
      [turn = actio::bodies::HalfTurn<double>(parameters)](State & p)
          __attribute__((always_inline)) { turn.step(p); },
      [body](State const& p) { return seven(body.state(p)); });
}

inline Method exact_half_turns() {
  return {"exact half turns", [](Task const& task, double h) {
            auto const body = free_body(task);
            return half_turns(body, body.step_parameters(h));
          }};
}
/// The momentum alone.
inline Method exact_momentum() {
  return {"exact half turns, momentum alone", [](Task const& task, double h) {
            using State = actio::bodies::FrameState<double>;
            auto const body = free_body(task);
            return stepper(
                body.start(),
                [turn = actio::bodies::HalfTurn<double>(body.step_parameters(h))](State & p)
                    __attribute__((always_inline)) { turn.step(p.direction); },
                [body](State const& p) { return seven(body.state(p)); });
          }};
}
/// As `FreeSteps` goes: compensated, and set back on the orbit now and then.
class CompensatedStepper final : public Stepper {
 public:
  CompensatedStepper(Task const& task, double h) : motion_(free_body(task), h) {}
  void advance(long steps) override { motion_.advance(steps); }
  Seven state() const override { return seven(motion_.state()); }

 private:
  actio::bodies::FreeSteps motion_;
};
inline Method exact_compensated() {
  return {"exact, compensated (FreeSteps)",
          [](Task const& task, double h) { return std::make_unique<CompensatedStepper>(task, h); }};
}

/// Moser-Veselov, solved once for the orbit; of order 4 and more with modified moments.
inline Method moser_veselov_once(int order) {
  return {"Moser-Veselov, order " + std::to_string(order) + ", twist once",
          [order](Task const& task, double h) {
            auto const body = free_body(task);
            return half_turns(body, body.moser_veselov_parameters(h, order));
          }};
}

/// Moser-Veselov with the equation for the twist solved in each step, as a body under torques would want it;
/// with modified moments these are worked out in each step, too.
class TwistEachStep {
 public:
  TwistEachStep(actio::bodies::FreeBody const& body, Task const& task, double h, int order)
      : polynomials_(task, order), modified_(order > 2), half_(h / 2) {
    for (int i = 0; i < 3; ++i) J_[i] = 1 / task.I[i];
    magnitude_ = body.magnitude();
  }
  [[gnu::always_inline]] void operator()(actio::bodies::FrameState<double>& state) const {
    auto const& u = state.direction;
    double s = 1, d = 0;
    double const energy = J_[0] * u[0] * u[0] + J_[1] * u[1] * u[1] + J_[2] * u[2] * u[2];
    if (modified_)
      polynomials_.at(magnitude_ * magnitude_, magnitude_ * magnitude_ * energy, half_ * half_, s, d);
    double const t = half_ * magnitude_;
    actio::bodies::Three<double> const j{t * (s * J_[0] + d), t * (s * J_[1] + d), t * (s * J_[2] + d)};
    bool found = false;
    auto const parameters = actio::bodies::moser_veselov_parameters<double>(j, u, found);
    if (!found) throw std::runtime_error("Moser-Veselov: the step is too long");
    actio::bodies::HalfTurn<double>(parameters).step(state);
  }

 private:
  PreprocessingPolynomials polynomials_;
  bool modified_;
  double half_, magnitude_;
  actio::bodies::Three<double> J_;
};
inline Method moser_veselov_each_step(int order) {
  return {"Moser-Veselov, order " + std::to_string(order) + ", twist each step",
          [order](Task const& task, double h) {
            // The moments of this task are in ascending order, so the axes of the steps are those of the
            // body.
            auto const body = free_body(task);
            return stepper(
                body.start(), TwistEachStep(body, task, h, order),
                [body](actio::bodies::FrameState<double> const& p) { return seven(body.state(p)); });
          }};
}

/// The scheme for rotations of any size, at n = 3: attitude as a matrix.
class GeneralStepper final : public Stepper {
 public:
  GeneralStepper(Task const& task, double h)
      : scheme_(actio::inertia_from_moments(task.I[0], task.I[1], task.I[2]), h),
        body_(actio::release(
            scheme_.inertia(), actio::identity<double>(actio::SO<3>{}),
            actio::body_velocity(scheme_.inertia(),
                                 actio::Momentum<actio::SO<3>, double>{
                                     actio::SO<3>{}, Eigen::Vector3d(task.M[0], task.M[1], task.M[2])}))) {}
  void advance(long steps) override {
    for (; steps > 0; --steps) actio::advance(scheme_, body_);
  }
  Seven state() const override {
    auto const& M = body_.body_momentum.components;
    Eigen::Quaterniond const q(Eigen::Matrix3d(body_.attitude.value));
    return {M[0], M[1], M[2], q.w(), q.x(), q.y(), q.z()};
  }

 private:
  actio::MoserVeselov<3> scheme_;
  actio::BodyInMotion<3, double> body_;
};
inline Method moser_veselov_general() {
  return {"Moser-Veselov for SO(n), n = 3",
          [](Task const& task, double h) { return std::make_unique<GeneralStepper>(task, h); }};
}

}  // namespace peers
