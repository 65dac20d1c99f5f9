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
    for (long k = 0; k < count; ++k) try {
        steps_.step();
      } catch (Error const& error) {
        double const longest = scheme_.longest_step(step_, steps_.point(), steps_.velocity());
        if (longest > 0) throw StepTooLong("natural chart", step_, longest);
        throw;
      }
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
  return Eigen::Map<Eigen::VectorXd const>(x.data(), static_cast<Eigen::Index>(x.size())).norm();
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

double ReducedScheme::longest_step(double step, ReducedPoint const& start,
                                   std::vector<double> const& velocity) const {
  ReducedScheme trial = *this;
  trial.with_configuration = false;
  auto const works = [&](double h) {
    try {
      trial.motion(h, start, velocity, {});
      return true;
    } catch (Error const&) {
      return false;
    }
  };
  double good = step;
  for (int k = 0; !works(good); ++k) {
    if (k == 40) return 0;
    good /= 2;
  }
  double bad = std::min(step, 2 * good);
  while (bad - good > 1e-3 * good) {
    double const between = (good + bad) / 2;
    (works(between) ? good : bad) = between;
  }
  return good;
}

std::unique_ptr<ReducedMotion> standing(ReducedScene const& scene) { return std::make_unique<Standing>(scene); }

}  // namespace actio::scene
