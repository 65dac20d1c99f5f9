#include "actio/scene/systems/reduced_motion.hpp"

#include "actio/scene/systems/galerkin_motion.hpp"

namespace actio::scene {
namespace {

/// In steps of the natural chart, or of a symmetric composition of it.
class ChartMotion : public ReducedMotion {
 public:
  ChartMotion(ReducedScheme scheme, double step, ReducedPoint const& start, std::vector<double> const& velocity,
              Eigen::MatrixXd const& configuration)
      : scheme_(std::move(scheme)),
        step_(step),
        steps_(scheme_.system, step, scheme_.fractions, start, velocity) {
    if (scheme_.with_configuration) steps_.follow_configuration(configuration);
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
    ahead_.emplace(scheme_.system, time, scheme_.fractions, steps_.point(), steps_.velocity());
    if (scheme_.with_configuration) ahead_->follow_configuration(steps_.configuration());
    ahead_->step();
  }
  void remember(CheckpointStream& stream) override { steps_.remember(stream); }
  ReducedPoint const& point() const override { return now().point(); }
  Eigen::MatrixXd const& configuration() const override { return now().configuration(); }
  std::vector<double> const& velocity() const override { return now().velocity(); }

 private:
  ChartIntegrator const& now() const { return ahead_ ? *ahead_ : steps_; }

  ReducedScheme scheme_;
  double step_;
  ChartIntegrator steps_;
  std::optional<ChartIntegrator> ahead_;
};

/// The start, for ever.
class Standing : public ReducedMotion {
 public:
  explicit Standing(ReducedScene const& scene)
      : point_(scene.start), configuration_(scene.configuration), velocity_(scene.velocity) {}
  ReducedPoint const& point() const override { return point_; }
  Eigen::MatrixXd const& configuration() const override { return configuration_; }
  std::vector<double> const& velocity() const override { return velocity_; }

 private:
  ReducedPoint point_;
  Eigen::MatrixXd configuration_;
  std::vector<double> velocity_;
};

double length(std::vector<double> const& x) {
  return Eigen::Map<Eigen::VectorXd const>(x.data(), static_cast<Eigen::Index>(x.size())).stableNorm();
}

}  // namespace

StateDistance ReducedMotion::distance(Motion const& other) const {
  auto const& there = dynamic_cast<ReducedMotion const&>(other).point();
  std::vector<double> difference = point().momentum;
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= there.momentum[i];
  return {0, length(difference), length(point().momentum)};
}

std::unique_ptr<ReducedMotion> ReducedScheme::motion(double step, ReducedPoint const& start,
                                                     std::vector<double> const& velocity,
                                                     Eigen::MatrixXd const& configuration) const {
  if (stages > 0) return galerkin_motion(*this, step, start, velocity, configuration);
  return std::make_unique<ChartMotion>(*this, step, start, velocity, configuration);
}

double ReducedScheme::longest_step(double step, double divisor, ReducedPoint const& start,
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

void ReducedScheme::fail(Error const& error, double step, ReducedPoint const& start,
                         std::vector<double> const& velocity) const {
  if (double const longest = longest_step(step, 0, start, velocity); longest > 0)
    throw StepTooLong(name, step, longest);
  throw Error(error.what());
}

std::unique_ptr<ReducedMotion> standing(ReducedScene const& scene) { return std::make_unique<Standing>(scene); }

}  // namespace actio::scene
