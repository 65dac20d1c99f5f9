#include <Eigen/Core>

#include "program/systems/lagrangians/galerkin_motion.hpp"

#include "actio/any_group/span_of_matrices.hpp"
#include "actio/any_group/tape_lagrangian.hpp"
#include "actio/reduction/galerkin.hpp"

namespace actio::scene {
namespace {

using G = systems::SpanOfMatrices;
using Algebra = std::shared_ptr<systems::MatrixAlgebra const>;

Coordinates<G, double> coordinates(std::vector<double> const& list) {
  return Eigen::Map<Eigen::VectorXd const>(list.data(), static_cast<Eigen::Index>(list.size()));
}
std::vector<double> list_of(Coordinates<G, double> const& x) { return {x.data(), x.data() + x.size()}; }

/// One step, whatever the side: (state, h) -> MomentumStep.
using Step = std::function<MomentumStep<G, double>(MomentumState<G, double> const&, double)>;

Step step_of(ReducedScheme const& scheme) {
  systems::TapeLagrangian const l(scheme.system);
  if (scheme.system->side == systems::Side::left) return galerkin_step_left<double>(l, scheme.stages);
  return galerkin_step_right<double>(l, scheme.stages);
}

class GalerkinMotion : public ReducedMotion {
 public:
  GalerkinMotion(ReducedScheme scheme, double step, systems::ReducedPoint const& start,
                 std::vector<double> const& velocity, Eigen::MatrixXd const& configuration)
      : scheme_(std::move(scheme)),
        group_(scheme_.system->algebra),
        length_(step),
        last_{{group_, coordinates(start.momentum)}, {group_, coordinates(velocity)}},
        configuration_(scheme_.with_configuration ? configuration : Eigen::MatrixXd()) {
    step_of(scheme_)(last_, length_);
    show(last_, configuration_);
  }
  void advance(long count) override {
    try {
      advance_plainly(count);
    } catch (Error const& error) {
      scheme_.fail(error, length_, {list_of(last_.momentum.components), {}},
                   list_of(last_.velocity.coordinates));
    }
  }
  void advance_plainly(long count) override {
    // What a step remembers of the last one is no part of a checkpoint, so that each begins anew and the
    // digits of a resumed run are those of an unbroken one.
    for (long k = 0; k < count; ++k) take(last_, configuration_, length_);
    show(last_, configuration_);
  }
  void look_ahead(double time) override {
    auto ahead = last_;
    auto g = configuration_;
    if (time != 0) take(ahead, g, time);
    show(ahead, g);
  }
  void change_step(double first, double step, long) override {
    if (first > 0) take(last_, configuration_, first);
    length_ = step;
    show(last_, configuration_);
  }
  void remember(CheckpointStream& stream) override {
    auto const numbers = [&stream](auto& matrix) {
      std::span<double> all(matrix.data(), static_cast<std::size_t>(matrix.size()));
      stream(all);
    };
    numbers(last_.momentum.components), numbers(last_.velocity.coordinates), numbers(configuration_);
    show(last_, configuration_);
  }
  systems::ReducedPoint const& point() const override { return point_; }
  Eigen::MatrixXd const& configuration() const override { return shown_; }
  std::vector<double> const& velocity() const override { return velocity_; }

 private:
  void take(MomentumState<G, double>& state, Eigen::MatrixXd& g, double h) const {
    auto const done = step_of(scheme_)(state, h);
    if (g.size()) {
      Eigen::MatrixXd const back = inverse(done.relative_motion).value;
      g = scheme_.system->side == systems::Side::left ? Eigen::MatrixXd(g * back) : Eigen::MatrixXd(back * g);
    }
    state = done.state;
  }
  void show(MomentumState<G, double> const& state, Eigen::MatrixXd const& g) {
    point_.momentum = list_of(state.momentum.components);
    velocity_ = list_of(state.velocity.coordinates);
    shown_ = g;
  }

  ReducedScheme scheme_;
  G group_;
  double length_;
  MomentumState<G, double> last_;
  Eigen::MatrixXd configuration_, shown_;
  systems::ReducedPoint point_;
  std::vector<double> velocity_;
};

}  // namespace

std::unique_ptr<ReducedMotion> galerkin_motion(ReducedScheme const& scheme, double step,
                                               systems::ReducedPoint const& start,
                                               std::vector<double> const& velocity,
                                               Eigen::MatrixXd const& configuration) {
  return std::make_unique<GalerkinMotion>(scheme, step, start, velocity, configuration);
}

}  // namespace actio::scene
