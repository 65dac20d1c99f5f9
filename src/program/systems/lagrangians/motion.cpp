#include <Eigen/Core>

#include "program/systems/lagrangians/motion.hpp"

#include "actio/any_group/level_integrator.hpp"
#include "program/systems/lagrangians/constrained_motion.hpp"
#include "program/systems/lagrangians/galerkin_motion.hpp"

namespace actio::scene {
namespace {

/// In steps of an integrator: of the natural chart and its compositions, or on a level of the momentum.
template <class Integrator>
class SteppedMotion : public ReducedMotion {
 public:
  SteppedMotion(ReducedScheme scheme, double step, systems::ReducedPoint const& start,
                std::vector<double> const& velocity, Eigen::MatrixXd const& configuration)
      : scheme_(std::move(scheme)), step_(step), steps_(steps_from(step, start, velocity, configuration)) {
    // Only the first step shows whether it is too long.
    auto trial = steps_;
    trial.step();
  }
  void advance(long count) override {
    ahead_.reset();
    try {
      advance_plainly(count);
    } catch (Error const& error) {
      scheme_.fail(error, step_, steps_.point(), steps_.velocity());
    }
  }
  void advance_plainly(long count) override {
    for (long k = 0; k < count; ++k) steps_.step();
  }
  void look_ahead(double time) override {
    ahead_.reset();
    if (time == 0) return;
    ahead_.emplace(steps_from(time, steps_.point(), steps_.velocity(), steps_.configuration(), ledger()));
    ahead_->step();
  }
  void change_step(double first, double step, long) override {
    look_ahead(first);
    steps_ = steps_from(step, point(), velocity(), configuration(), ledger()), step_ = step;
    ahead_.reset();
  }
  void remember(CheckpointStream& stream) override { steps_.remember(stream); }
  systems::ReducedPoint const& point() const override { return now().point(); }
  Eigen::MatrixXd const& configuration() const override { return now().configuration(); }
  std::vector<double> const& velocity() const override { return now().velocity(); }
  systems::ForceLedger const& ledger() const override {
    if constexpr (with_forces)
      return now().ledger();
    else
      return ReducedMotion::ledger();
  }

 private:
  static constexpr bool with_forces = std::is_same_v<Integrator, systems::ChartIntegrator>;
  Integrator const& now() const { return ahead_ ? *ahead_ : steps_; }
  Integrator steps_from(double step, systems::ReducedPoint const& start, std::vector<double> const& velocity,
                        Eigen::MatrixXd const& configuration, systems::ForceLedger const& before = {}) const {
    auto made = [&] {
      if constexpr (with_forces)
        return Integrator(scheme_.system, step, scheme_.fractions, start, velocity);
      else
        return Integrator(scheme_.system, step, start, velocity);
    }();
    if (scheme_.with_configuration) made.follow_configuration(configuration);
    if constexpr (with_forces) made.add_before(before);
    return made;
  }

  ReducedScheme scheme_;
  double step_;
  Integrator steps_;
  std::optional<Integrator> ahead_;
};

/// The start, for ever.
class Standing : public ReducedMotion {
 public:
  explicit Standing(ReducedScene const& scene)
      : point_(scene.start), configuration_(scene.configuration), velocity_(scene.velocity) {}
  systems::ReducedPoint const& point() const override { return point_; }
  Eigen::MatrixXd const& configuration() const override { return configuration_; }
  std::vector<double> const& velocity() const override { return velocity_; }

 private:
  systems::ReducedPoint point_;
  Eigen::MatrixXd configuration_;
  std::vector<double> velocity_;
};

double length(std::vector<double> const& x) {
  return Eigen::Map<Eigen::VectorXd const>(x.data(), static_cast<Eigen::Index>(x.size())).stableNorm();
}

double length_between(std::vector<double> a, std::vector<double> const& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return length(a);
}

/// A scheme that preserves the bracket has an energy that hardly changes, or no solution near the motion.
/// @throws OutsideDomain  where a step changes the energy by more than half of the sizes of its parts
void require_like_energy(systems::ReducedSystem const& system, systems::ReducedPoint const& start,
                         systems::ReducedPoint const& end, std::vector<double> velocity) {
  systems::LegendreVelocity legendre(system);
  double size = 0;
  auto const energy = [&](systems::ReducedPoint const& at) {
    legendre.solve(at.momentum, at.vectors, velocity);
    double const e = legendre.energy(velocity, at.vectors);
    double kinetic = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i) kinetic += std::abs(velocity[i] * at.momentum[i]);
    size = std::max({size, std::abs(e), kinetic});
    return e;
  };
  double const before = energy(start), change = std::abs(energy(end) - before);
  if (change > 0.5 * size)
    throw OutsideDomain("step",
                        "the energy must change little in a step; its change over the size of its parts",
                        change / size, 0.5);
}

}  // namespace

systems::ForceLedger const& ReducedMotion::ledger() const {
  static systems::ForceLedger const nothing;
  return nothing;
}

StateDistance ReducedMotion::distance(Motion const& other) const {
  auto const& there = dynamic_cast<ReducedMotion const&>(other);
  StateDistance out;
  out.momentum = length_between(point().momentum, there.point().momentum);
  out.modulus = length(point().momentum);
  out.vectors = length_between(point().vectors, there.point().vectors);
  out.vectors_modulus = length(point().vectors);
  Eigen::MatrixXd const &g = configuration(), &h = there.configuration();
  if (g.size() && g.size() == h.size())
    out.attitude = (h - g).stableNorm() / g.stableNorm() * std::sqrt(static_cast<double>(g.cols()) / 2);
  return out;
}

std::unique_ptr<ReducedMotion> ReducedScheme::motion(double step, systems::ReducedPoint const& start,
                                                     std::vector<double> const& velocity,
                                                     Eigen::MatrixXd const& configuration) const {
  auto const made = [&](Eigen::MatrixXd const& g) -> std::unique_ptr<ReducedMotion> {
    if (constraints) return constrained_motion(*this, step, start, velocity, g);
    if (stages > 0) return galerkin_motion(*this, step, start, velocity, g);
    if (fractions.empty())
      return std::make_unique<SteppedMotion<systems::LevelIntegrator>>(*this, step, start, velocity, g);
    return std::make_unique<SteppedMotion<systems::ChartIntegrator>>(*this, step, start, velocity, g);
  };
  auto const trial = made(configuration);
  trial->advance_plainly(1);
  bool const acted_on = system->force || system->dissipation;
  if (keeps_energy && !acted_on) require_like_energy(*system, start, trial->point(), velocity);
  return made(configuration);
}

double ReducedScheme::longest_step(double step, double divisor, systems::ReducedPoint const& start,
                                   std::vector<double> const& velocity) const {
  ReducedScheme trial = *this;
  trial.with_configuration = false;
  auto const works = [&](double h) {
    try {
      trial.motion(h, start, velocity, {})->advance_plainly(8);
      return true;
    } catch (Error const&) {
      return false;
    }
  };
  auto const fitted = [divisor](double h) { return divisor > 0 ? divisor / std::ceil(divisor / h) : h; };
  double h = fitted(0.8 * step);
  for (int k = 0; k < 60; ++k, h = fitted(std::min(0.8 * h, h * (1 - 1e-9))))
    if (works(h) && works(0.8 * h) && works(0.64 * h)) return h;
  return 0;
}

void ReducedScheme::fail(Error const& error, double step, systems::ReducedPoint const& start,
                         std::vector<double> const& velocity) const {
  if (double const longest = longest_step(step, 0, start, velocity); longest > 0)
    throw StepTooLong(name, step, longest);
  throw Error(error.what());
}

std::unique_ptr<ReducedMotion> standing(ReducedScene const& scene) {
  return std::make_unique<Standing>(scene);
}

}  // namespace actio::scene
