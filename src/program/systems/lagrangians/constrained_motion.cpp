#include <Eigen/Core>

#include "program/systems/lagrangians/constrained_motion.hpp"

#include "actio/nonholonomic/rattle_integrator.hpp"

namespace actio::scene {
namespace {

class ConstrainedMotion : public ReducedMotion {
 public:
  ConstrainedMotion(ReducedScheme scheme, double step, systems::ReducedPoint const& start,
                    std::vector<double> const& velocity, Eigen::MatrixXd const& configuration)
      : scheme_(std::move(scheme)),
        step_(step),
        steps_(steps_from(step, {start, velocity, 0}, configuration, 0)) {
    // Only the first step shows whether it is too long.
    auto trial = steps_;
    trial.step();
    show(steps_);
  }
  void advance(long count) override {
    try {
      advance_plainly(count);
    } catch (Error const& error) {
      show(steps_);
      scheme_.fail(error, step_, state_.point, state_.velocity);
    }
  }
  void advance_plainly(long count) override {
    for (long k = 0; k < count; ++k) steps_.step();
    show(steps_);
  }
  void look_ahead(double time) override {
    show(steps_);
    if (time == 0) return;
    auto ahead = steps_from(time, state_, shown_, steps_.time());
    ahead.step();
    show(ahead);
  }
  void change_step(double first, double step, long made) override {
    look_ahead(first);
    steps_ = steps_from(step, state_, shown_, static_cast<double>(made) * step), step_ = step;
  }
  void remember(CheckpointStream& stream) override { steps_.remember(stream), show(steps_); }
  systems::ReducedPoint const& point() const override { return state_.point; }
  Eigen::MatrixXd const& configuration() const override { return shown_; }
  std::vector<double> const& velocity() const override { return state_.velocity; }
  double time() const override { return time_; }

 private:
  systems::RattleIntegrator steps_from(double step, systems::ConstrainedState const& start,
                                       Eigen::MatrixXd const& configuration, double time) const {
    systems::RattleIntegrator made(scheme_.system, scheme_.constraints, step, scheme_.fractions, start, time);
    if (scheme_.with_configuration) made.follow_configuration(configuration);
    return made;
  }
  void show(systems::RattleIntegrator const& steps) {
    state_ = steps.state(), shown_ = steps.configuration(), time_ = steps.time();
  }

  ReducedScheme scheme_;
  double step_, time_ = 0;
  systems::RattleIntegrator steps_;
  systems::ConstrainedState state_;
  Eigen::MatrixXd shown_;
};

}  // namespace

std::unique_ptr<ReducedMotion> constrained_motion(ReducedScheme const& scheme, double step,
                                                  systems::ReducedPoint const& start,
                                                  std::vector<double> const& velocity,
                                                  Eigen::MatrixXd const& configuration) {
  return std::make_unique<ConstrainedMotion>(scheme, step, start, velocity, configuration);
}

void define_constraints(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion) {
  auto const ends = numbered(1, scene.constraints->count);
  graph.define("reaction", ends,
               [system = scene.system, constraints = scene.constraints, &motion](auto, double* out) {
                 std::ranges::copy(systems::ConstrainedVelocity(*system, *constraints)
                                       .reaction(motion.velocity(), motion.point().vectors, motion.time()),
                                   out);
               });
  graph.define("constraint", ends, [constraints = scene.constraints, &motion](auto, double* out) {
    systems::ConstraintValues<double> at(*constraints);
    at.set_values(motion.velocity(), motion.point().vectors, motion.time());
    std::ranges::copy(at.values, out);
  });
}

}  // namespace actio::scene
