#include <Eigen/Core>

#include "program/systems/lagrangians/galerkin_motion.hpp"

#include "actio/any_group/tape_lagrangian.hpp"
#include "actio/reduction/advected_galerkin.hpp"

namespace actio::scene {
namespace {

using G = systems::SpanOfMatrices;
using Algebra = std::shared_ptr<systems::MatrixAlgebra const>;
using State = AdvectedMomentumState<G, double, Dynamic>;

Coordinates<G, double> coordinates(std::vector<double> const& list) {
  return Eigen::Map<Eigen::VectorXd const>(list.data(), static_cast<Eigen::Index>(list.size()));
}
std::vector<double> list_of(Coordinates<G, double> const& x) { return {x.data(), x.data() + x.size()}; }

/// One step, whatever the side.
using Step = std::function<AdvectedMomentumStep<G, double, Dynamic>(State const&, double)>;

/// Without vectors the equations are shorter.
Step step_of(ReducedScheme const& scheme) {
  systems::TapeLagrangian const l(scheme.system);
  bool const left = scheme.system->side == systems::Side::left;
  int const s = scheme.stages;
  if (scheme.system->vectors > 0) {
    if (left) return advected_galerkin_step_left<double>(l, s, systems::EachVector{});
    return advected_galerkin_step_right<double>(l, s, systems::EachVector{});
  }
  auto const plain = [](auto const& step) {
    return [step](State const& from, double h) -> AdvectedMomentumStep<G, double, Dynamic> {
      auto const done = step(MomentumState<G, double>{from.momentum, from.velocity}, h);
      return {
          done.relative_motion, {done.state.momentum, from.vector, done.state.velocity}, done.evaluations};
    };
  };
  if (left) return plain(galerkin_step_left<double>(l, s));
  return plain(galerkin_step_right<double>(l, s));
}

class GalerkinMotion : public ReducedMotion {
 public:
  GalerkinMotion(ReducedScheme scheme, double step, systems::ReducedPoint const& start,
                 std::vector<double> const& velocity, Eigen::MatrixXd const& configuration)
      : scheme_(std::move(scheme)),
        group_(scheme_.system->algebra),
        length_(step),
        last_{{group_, coordinates(start.momentum)},
              coordinates(start.vectors),
              {group_, coordinates(velocity)}},
        configuration_(scheme_.with_configuration ? configuration : Eigen::MatrixXd()) {
    step_of(scheme_)(last_, length_);
    show(last_, configuration_);
  }
  void advance(long count) override {
    try {
      advance_plainly(count);
    } catch (Error const& error) {
      scheme_.fail(error, length_, {list_of(last_.momentum.components), list_of(last_.vector)},
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
    numbers(last_.momentum.components), numbers(last_.vector), numbers(last_.velocity.coordinates),
        numbers(configuration_);
    show(last_, configuration_);
  }
  systems::ReducedPoint const& point() const override { return point_; }
  Eigen::MatrixXd const& configuration() const override { return shown_; }
  std::vector<double> const& velocity() const override { return velocity_; }

 private:
  void take(State& state, Eigen::MatrixXd& g, double h) const {
    auto const done = step_of(scheme_)(state, h);
    if (g.size()) {
      Eigen::MatrixXd const back = inverse(done.relative_motion).value;
      g = scheme_.system->side == systems::Side::left ? Eigen::MatrixXd(g * back) : Eigen::MatrixXd(back * g);
    }
    state = done.state;
  }
  void show(State const& state, Eigen::MatrixXd const& g) {
    point_ = {list_of(state.momentum.components), list_of(state.vector)};
    velocity_ = list_of(state.velocity.coordinates);
    shown_ = g;
  }

  ReducedScheme scheme_;
  G group_;
  double length_;
  State last_;
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
