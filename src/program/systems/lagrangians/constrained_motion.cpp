#include <Eigen/Core>

#include "program/systems/lagrangians/constrained_motion.hpp"

#include <fmt/format.h>

#include <numbers>

#include "actio/nonholonomic/constrained_integrator.hpp"

namespace actio::scene {
namespace {

/// ": up is 0.12 degrees from axis 3": of the carried vector that is nearest to an axis, where it is within a
/// tenth of a radian of it; there contacts end.
std::string said_of_directions(ReducedScheme const& scheme, systems::ReducedPoint const& point) {
  auto const length = static_cast<std::size_t>(scheme.system->length());
  double least = 0.1;
  std::string said;
  for (std::size_t k = 0; k < scheme.carried.size(); ++k) {
    Eigen::Map<Eigen::VectorXd const> const a(point.vectors.data() + k * length,
                                              static_cast<Eigen::Index>(length));
    Eigen::Index axis = 0;
    double const along = a.cwiseAbs().maxCoeff(&axis),
                 angle = std::atan2(std::sqrt(std::max(0.0, a.squaredNorm() - along * along)), along);
    if (!(angle < least)) continue;
    least = angle;
    said = fmt::format("; {} is {:.3g} degrees from axis {}", scheme.carried[k],
                       angle * 180 / std::numbers::pi, axis + 1);
  }
  return said;
}

/// @tparam Integrator  of steps by the discrete principle, or of those that conserve the energy
template <class Integrator>
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
      fail(error);
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
  systems::ForceLedger const& ledger() const override { return ledger_; }
  std::vector<double> constraint() const override { return constraint_; }
  double time() const override { return time_; }

 private:
  /// A shorter step is no answer to a contact that ends.
  [[noreturn]] void fail(Error const& error) const {
    auto const said = said_of_directions(scheme_, state_.point);
    if (dynamic_cast<systems::RowsTurn const*>(&error)) throw Error(error.what() + said);
    try {
      scheme_.fail(error, step_, state_.point, state_.velocity);
    } catch (Error const& told) {
      throw Error(told.what() + said);
    }
  }
  Integrator steps_from(double step, systems::ConstrainedState const& start,
                        Eigen::MatrixXd const& configuration, double time) const {
    Integrator made(scheme_.system, scheme_.constraints, step, scheme_.fractions, start, time);
    if (scheme_.with_configuration) made.follow_configuration(configuration);
    if (scheme_.with_ledger) made.follow_ledger(ledger_);
    return made;
  }
  void show(Integrator const& steps) {
    state_ = steps.state(), shown_ = steps.configuration(), time_ = steps.time();
    constraint_ = steps.constraint(), ledger_ = steps.ledger();
  }

  ReducedScheme scheme_;
  double step_, time_ = 0;
  systems::ForceLedger ledger_;
  Integrator steps_;
  systems::ConstrainedState state_;
  Eigen::MatrixXd shown_;
  std::vector<double> constraint_;
};

}  // namespace

std::unique_ptr<ReducedMotion> constrained_motion(ReducedScheme const& scheme, double step,
                                                  systems::ReducedPoint const& start,
                                                  std::vector<double> const& velocity,
                                                  Eigen::MatrixXd const& configuration) {
  if (scheme.conserves)
    return std::make_unique<ConstrainedMotion<systems::ConservingIntegrator>>(scheme, step, start, velocity,
                                                                              configuration);
  return std::make_unique<ConstrainedMotion<systems::RattleIntegrator>>(scheme, step, start, velocity,
                                                                        configuration);
}

void define_constraints(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion) {
  auto const ends = numbered(1, scene.constraints->count);
  graph.define("reaction", ends,
               [system = scene.system, constraints = scene.constraints, &motion](auto, double* out) {
                 std::ranges::copy(systems::ConstrainedVelocity(*system, *constraints)
                                       .reaction(motion.velocity(), motion.point().vectors, motion.time()),
                                   out);
               });
  graph.define("constraint", ends,
               [&motion](auto, double* out) { std::ranges::copy(motion.constraint(), out); });
  if (scene.contact.empty()) return;
  std::vector<std::string> const axes{"_x", "_y", "_z"};
  auto const count = scene.contact.size();
  graph.define("contact", {axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(count)},
               [contact = joined(scene.contact), count, &motion](auto, double* out) {
                 auto const n = static_cast<Eigen::Index>(count);
                 Eigen::VectorXd place = Eigen::VectorXd::Ones(n + 1);
                 std::vector<double> work;
                 contact(motion.point().vectors.data(), place.data(), work);
                 Eigen::VectorXd::Map(out, n) = (motion.configuration() * place).head(n);
               });
}

}  // namespace actio::scene
