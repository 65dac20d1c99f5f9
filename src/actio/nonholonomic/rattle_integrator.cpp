#include <Eigen/Core>

#include "actio/nonholonomic/rattle_integrator.hpp"

namespace actio::systems {

ConstrainedState constrained_state(ReducedSystem const& system, VelocityConstraints const& constraints,
                                   std::vector<double> const& v, std::vector<double> const& a, double t,
                                   double allowed) {
  for (auto const* list : {&v, &a})
    for (double const x : *list)
      if (!std::isfinite(x)) throw NotFinite(list == &v ? "velocity at the start" : "vectors at the start");
  ConstrainedVelocity projection(system, constraints);
  ConstrainedState state{{LegendreVelocity(system).momentum(v, a), a}, v, 0};
  projection.require_independent(v, a, t);
  state.moved = projection.defect(v, a, t);
  if (!(state.moved <= allowed))
    throw OutsideDomain("velocity constraints",
                        "the velocity at the start must obey them; largest defect, relative", state.moved,
                        allowed);
  std::vector<double> lambda(static_cast<std::size_t>(constraints.count), 0);
  projection.solve(state.point.momentum, a, t, state.velocity, lambda);
  state.point.momentum = projection.momentum(std::move(state.point.momentum), a, t, lambda);
  return state;
}

RattleIntegrator::RattleIntegrator(std::shared_ptr<ReducedSystem const> system,
                                   std::shared_ptr<VelocityConstraints const> constraints, double h,
                                   std::vector<double> const& fractions, ConstrainedState const& start,
                                   double t)
    : system_(std::move(system)),
      constraints_(std::move(constraints)),
      h_(h),
      start_(t),
      point_(start.point) {
  for (double const fraction : fractions) {
    substeps_.emplace_back(*system_, *constraints_, fraction * h);
    substeps_.back().begin_at(start.velocity);
  }
}

void RattleIntegrator::step() {
  point_before_ = point_, configuration_before_ = configuration_;
  double within = 0;
  try {
    for (auto& substep : substeps_) {
      substep(point_, time() + within);
      within += substep.length();
      if (configuration_.size())
        move_configuration(*system_, substep.length(), substep.unknowns(), configuration_);
    }
  } catch (...) {
    point_ = point_before_, configuration_ = configuration_before_;
    throw;
  }
  ++steps_;
}

ConstrainedState RattleIntegrator::state() const {
  ConstrainedVelocity projection(*system_, *constraints_);
  std::vector<double> v = velocity_of_substep(), lambda(static_cast<std::size_t>(constraints_->count), 0);
  projection.solve(point_.momentum, point_.vectors, time(), v, lambda);
  return {{projection.momentum(point_.momentum, point_.vectors, time(), lambda), point_.vectors}, v, 0};
}

std::vector<double> RattleIntegrator::reaction() const {
  return ConstrainedVelocity(*system_, *constraints_).reaction(state().velocity, point_.vectors, time());
}

std::vector<double> RattleIntegrator::velocity_of_substep() const {
  auto const& x = substeps_.back().unknowns();
  return {x.begin(), x.begin() + constraints_->dimension};
}

std::vector<double> RattleIntegrator::impulse() const {
  auto const& x = substeps_.back().unknowns();
  return {x.begin() + constraints_->dimension, x.end()};
}

}  // namespace actio::systems
