#include <Eigen/Core>

#include "program/systems/lagrangians/galerkin_motion.hpp"

#include "actio/any_group/momentum_across.hpp"
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

/// A step from a time on. Without vectors and forces the equations are shorter.
Step step_of(ReducedScheme const& scheme, double start, double length) {
  systems::TapeLagrangian const l(scheme.system);
  bool const left = scheme.system->side == systems::Side::left;
  int const s = scheme.stages;
  if (scheme.system->force) {
    systems::TapeForce const force(scheme.system, start, length);
    if (left) return forced_galerkin_step_left<double>(l, s, systems::EachVector{}, force);
    return forced_galerkin_step_right<double>(l, s, systems::EachVector{}, force);
  }
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
        length_(step),
        begin_(start.time),
        last_{State{{group(), coordinates(start.momentum)},
                    coordinates(start.vectors),
                    {group(), coordinates(velocity)}},
              scheme_.with_configuration ? configuration : Eigen::MatrixXd(), start.time},
        shown_(last_) {
    if (scheme_.system->force && scheme_.with_configuration)
      last_.ledger.impulse.resize(start.momentum.size());
    step_of(scheme_, begin_, length_)(last_.state, length_);
    show(last_);
  }
  void advance(long count) override {
    try {
      advance_plainly(count);
    } catch (Error const& error) {
      show(last_);
      scheme_.fail(error, length_, point_, velocity_);
    }
  }
  void advance_plainly(long count) override {
    // What a step remembers of the last one is no part of a checkpoint, so that each begins anew and the
    // digits of a resumed run are those of an unbroken one.
    for (long k = 0; k < count; ++k) {
      take(last_, length_);
      last_.time = begin_ + static_cast<double>(++steps_) * length_;
    }
    show(last_);
  }
  void look_ahead(double time) override {
    Now ahead = last_;
    if (time != 0) take(ahead, time);
    show(ahead);
  }
  void change_step(double first, double step, long) override {
    if (first > 0) take(last_, first);
    length_ = step, begin_ = last_.time, steps_ = 0;
    show(last_);
  }
  void remember(CheckpointStream& stream) override {
    auto const numbers = [&stream](auto& matrix) {
      std::span<double> all(matrix.data(), static_cast<std::size_t>(matrix.size()));
      stream(all);
    };
    numbers(last_.state.momentum.components), numbers(last_.state.vector),
        numbers(last_.state.velocity.coordinates), numbers(last_.configuration);
    if (scheme_.system->force) stream(begin_, steps_, last_.time, last_.ledger.work, last_.ledger.impulse);
    show(last_);
  }
  systems::ReducedPoint const& point() const override { return point_; }
  Eigen::MatrixXd const& configuration() const override { return shown_.configuration; }
  std::vector<double> const& velocity() const override { return velocity_; }
  systems::ForceLedger const& ledger() const override { return shown_.ledger; }

 private:
  struct Now {
    State state;
    Eigen::MatrixXd configuration;
    double time;
    systems::ForceLedger ledger = {};
  };
  G group() const { return G(Algebra(scheme_.system, &scheme_.system->algebra)); }
  void take(Now& now, double h) const {
    auto const& friction = scheme_.system->dissipation;
    auto done = step_of(scheme_, now.time, h)(now.state, friction ? friction->free_time(h) : h);
    if (friction) {
      double const decay = std::exp(-friction->rate * h);
      done.state.momentum = decay * done.state.momentum, done.state.velocity = decay * done.state.velocity;
    }
    auto const side = scheme_.system->side;
    now.ledger.work += done.work;
    if (auto& g = now.configuration; g.size()) {
      if (done.impulse) {
        Eigen::MatrixXd const inverse_of_g = inverse_matrix(g, "configuration");
        auto const added = systems::momentum_across(scheme_.system->algebra, side, g, inverse_of_g,
                                                    list_of(done.impulse->components));
        for (std::size_t i = 0; i < added.size(); ++i) now.ledger.impulse[i] += added[i];
      }
      Eigen::MatrixXd const back = inverse(done.relative_motion).value;
      g = side == systems::Side::left ? Eigen::MatrixXd(g * back) : Eigen::MatrixXd(back * g);
    }
    now.state = done.state, now.time += h;
  }
  void show(Now const& now) {
    point_ = {list_of(now.state.momentum.components), list_of(now.state.vector), now.time};
    velocity_ = list_of(now.state.velocity.coordinates);
    shown_ = now;
  }

  ReducedScheme scheme_;
  double length_, begin_;
  long steps_ = 0;
  Now last_, shown_;
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
