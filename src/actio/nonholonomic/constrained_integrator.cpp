#include <Eigen/Core>

#include "actio/nonholonomic/constrained_integrator.hpp"

#include "actio/any_group/momentum_across.hpp"

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

RowsTurn::RowsTurn(std::size_t number, double radians)
    : OutsideDomain("velocity constraint " + std::to_string(number),
                    "its row must turn by at most a radian in a step, for a motion to be followed; radians",
                    radians, most) {}

template <template <class> class Step>
ConstrainedIntegrator<Step>::ConstrainedIntegrator(std::shared_ptr<ReducedSystem const> system,
                                                   std::shared_ptr<VelocityConstraints const> constraints,
                                                   double h, std::vector<double> const& fractions,
                                                   ConstrainedState const& start, double t)
    : system_(std::move(system)),
      constraints_(std::move(constraints)),
      h_(h),
      start_(t),
      now_{start.point},
      nodes_(*constraints_) {
  for (double const fraction : fractions) {
    substeps_.emplace_back(*system_, *constraints_, fraction * h);
    substeps_.back().begin_at(start.velocity);
  }
  if (auto const& friction = system_->dissipation; friction && friction->kind == Dissipation::Kind::orbit)
    throw OutsideDomain("velocity constraints",
                        "reactions lead away from the orbit, so that there must be no friction on it; rate",
                        friction->rate, 0);
  nodes_.set_values(start.velocity, start.point.vectors, t), nodes_.set_rows(start.point.vectors, t);
  now_.rows = nodes_.rows, now_.middle = nodes_.values;
  Eigen::VectorXd const units =
      units_of(LegendreVelocity(*system_).hessian(start.velocity, now_.point.vectors));
  units_.assign(units.data(), units.data() + units.size());
  for (int i = constraints_->dimension; i < constraints_->rows.inputs; ++i)
    rows_turn_ = rows_turn_ || constraints_->rows.depends_on(i);
}

template <template <class> class Step>
void ConstrainedIntegrator<Step>::follow_ledger(ForceLedger before) {
  with_ledger_ = true;
  now_.ledger = std::move(before);
  now_.ledger.impulse.resize(at_nodes_ && now_.configuration.size() ? now_.point.momentum.size() : 0);
}

template <template <class> class Step>
void ConstrainedIntegrator<Step>::step() {
  before_ = now_;
  double within = 0;
  try {
    for (auto& substep : substeps_) {
      take(substep, time() + within);
      within += substep.length();
      turn_rows(now_.point.vectors, time() + within);
    }
  } catch (...) {
    now_ = before_;
    throw;
  }
  ++steps_;
}

template <template <class> class Step>
void ConstrainedIntegrator<Step>::take(Solver& substep, double t) {
  auto const damp = [&] {
    auto const& friction = system_->dissipation;
    if (!friction) return;
    for (double& p : now_.point.momentum) p *= std::exp(-friction->rate * substep.length() / 2);
  };
  damp();
  ReducedPoint const start = with_ledger_ ? now_.point : ReducedPoint{};
  try {
    substep(now_.point, t);
  } catch (NotConverged const&) {
    look_ahead(substep.length(), t);
    throw;
  }
  damp();
  now_.middle = substep.last().constraint.values;
  auto const move = [&] {
    if (now_.configuration.size())
      move_configuration(*system_, substep.length(), substep.unknowns(), now_.configuration);
  };
  if (!with_ledger_) return move();
  auto const v = substep.velocity(), multipliers = substep.multipliers();
  if constexpr (at_nodes_) {
    add_reactions(now_.ledger, start, t, multipliers);
    auto const& force = substep.last().momenta.force;
    double const half = substep.length() / 2;
    for (std::size_t i = 0; i < force.before.size(); ++i)
      now_.ledger.work += half * (force.before[i] + force.after[i]) * v[i];
    add_impulse(now_.ledger, half, force.before);
    move();
    add_impulse(now_.ledger, half, force.after);
  } else {
    auto const& rows = substep.last().constraint.rows;
    for (std::size_t k = 0; k < multipliers.size(); ++k)
      for (std::size_t i = 0; i < v.size(); ++i)
        now_.ledger.work += multipliers[k] * rows[k * v.size() + i] * v[i];
    move();
  }
}

template <template <class> class Step>
void ConstrainedIntegrator<Step>::look_ahead(double h, double t) {
  std::vector<double> v = substeps_.back().velocity(),
                      lambda(static_cast<std::size_t>(constraints_->count), 0);
  ConstrainedVelocity(*system_, *constraints_).solve(now_.point.momentum, now_.point.vectors, t, v, lambda);
  Step<double> step(*system_, *constraints_);
  if (step(h, t, v, now_.point.vectors)) turn_rows(step.vectors_at_end(), t + h);
}

template <template <class> class Step>
void ConstrainedIntegrator<Step>::turn_rows(std::vector<double> const& vectors, double t) {
  if (!rows_turn_) return;
  nodes_.set_rows(vectors, t);
  std::size_t const d = units_.size();
  for (std::size_t k = 0; k * d < now_.rows.size(); ++k) {
    double both = 0, last = 0, now = 0;
    for (std::size_t i = 0; i < d; ++i) {
      double const a = now_.rows[k * d + i] * units_[i], b = nodes_.rows[k * d + i] * units_[i];
      both += a * b, last += a * a, now += b * b;
    }
    double const cosine = both / std::sqrt(last * now);
    if (!(cosine - cosine == 0)) throw NotFinite("a velocity constraint or its row");
    if (cosine < std::cos(RowsTurn::most)) throw RowsTurn(k + 1, std::acos(std::max(-1.0, cosine)));
  }
  now_.rows = nodes_.rows;
}

template <template <class> class Step>
void ConstrainedIntegrator<Step>::add_reactions(ForceLedger& ledger, ReducedPoint const& at, double t,
                                                std::vector<double> const& multipliers) const {
  ConstraintValues<double> there(*constraints_);
  std::size_t const d = now_.point.momentum.size();
  there.set_values(std::vector<double>(d, 0), at.vectors, t), there.set_rows(at.vectors, t);
  std::vector<double> reaction(d, 0);
  for (std::size_t k = 0; k < multipliers.size(); ++k) {
    ledger.work -= multipliers[k] * there.values[k];
    for (std::size_t i = 0; i < d; ++i) reaction[i] += there.rows[k * d + i] * multipliers[k];
  }
  add_impulse(ledger, 1, reaction);
}

template <template <class> class Step>
void ConstrainedIntegrator<Step>::add_impulse(ForceLedger& ledger, double times,
                                              std::vector<double> const& covector) const {
  if (ledger.impulse.empty() || covector.empty()) return;
  Eigen::MatrixXd const back = inverse_matrix(now_.configuration, "configuration");
  auto const moved = momentum_across(system_->algebra, system_->side, now_.configuration, back, covector);
  for (std::size_t i = 0; i < moved.size(); ++i) ledger.impulse[i] += times * moved[i];
}

template <template <class> class Step>
std::pair<ConstrainedState, std::vector<double>> ConstrainedIntegrator<Step>::projected() const {
  ConstrainedVelocity projection(*system_, *constraints_);
  std::vector<double> v = velocity_of_substep(), lambda(static_cast<std::size_t>(constraints_->count), 0);
  auto const &p = now_.point.momentum, &a = now_.point.vectors;
  projection.solve(p, a, time(), v, lambda);
  return {{{projection.momentum(p, a, time(), lambda), a}, v, 0}, lambda};
}

template <template <class> class Step>
ConstrainedState ConstrainedIntegrator<Step>::state() const {
  if constexpr (at_nodes_) return projected().first;
  std::vector<double> v = velocity_of_substep();
  LegendreVelocity(*system_).solve(now_.point.momentum, now_.point.vectors, v);
  return {now_.point, v, 0};
}

template <template <class> class Step>
std::vector<double> ConstrainedIntegrator<Step>::constraint() const {
  if constexpr (!at_nodes_) return now_.middle;
  ConstraintValues<double> at(*constraints_);
  at.set_values(state().velocity, now_.point.vectors, time());
  return at.values;
}

template <template <class> class Step>
std::vector<double> ConstrainedIntegrator<Step>::reaction() const {
  return ConstrainedVelocity(*system_, *constraints_)
      .reaction(projected().first.velocity, now_.point.vectors, time());
}

template <template <class> class Step>
ForceLedger ConstrainedIntegrator<Step>::ledger() const {
  ForceLedger out = now_.ledger;
  if (at_nodes_ && with_ledger_) add_reactions(out, now_.point, time(), projected().second);
  return out;
}

template class ConstrainedIntegrator<RattleStep>;
template class ConstrainedIntegrator<ConservingStep>;

}  // namespace actio::systems
