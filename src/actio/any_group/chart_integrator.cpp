#include <Eigen/Core>

#include "actio/any_group/chart_integrator.hpp"

#include "actio/any_group/momentum_across.hpp"

namespace actio::systems {

void apply_exponential(MatrixAlgebra const& algebra, double h, std::vector<double> const& v,
                       Eigen::MatrixXd& g) {
  if (size_of_step(algebra, h, v) > 1) {
    // The series would cancel.
    g = (matrix_exponential(hat_of_step(algebra, h, v)) * g).eval();
    return;
  }
  Eigen::MatrixXd term = g, next(g.rows(), g.cols());
  double const size = g.cwiseAbs().maxCoeff();
  for (int k = 1; k < 400; ++k) {
    next.setZero();
    for (auto const& e : algebra.entries)
      next.row(e.row) += (v[static_cast<std::size_t>(e.direction)] * e.value * h / k) * term.row(e.column);
    std::swap(term, next);
    g += term;
    if (!(term.cwiseAbs().maxCoeff() > 0x1p-55 * size)) return;
  }
}

void move_configuration(ReducedSystem const& system, double h, std::vector<double> const& v,
                        Eigen::MatrixXd& g) {
  bool const left = system.side == Side::left;
  if (system.chart == Chart::cayley) {
    Eigen::MatrixXd const c = cayley(hat_of_step(system.algebra, h, v));
    g = left ? Eigen::MatrixXd(g * c) : Eigen::MatrixXd(c * g);
    return;
  }
  if (!left) return apply_exponential(system.algebra, h, v, g);
  Eigen::MatrixXd moved = Eigen::MatrixXd::Identity(g.rows(), g.cols());
  apply_exponential(system.algebra, h, v, moved);
  g = g * moved;
}

ChartIntegrator::ChartIntegrator(std::shared_ptr<ReducedSystem const> system, double h,
                                 std::vector<double> const& fractions, ReducedPoint start,
                                 std::vector<double> const& velocity)
    : system_(std::move(system)), length_(h), begin_(start.time), point_(std::move(start)) {
  auto const& friction = system_->dissipation;
  along_free_motion_ = friction && friction->kind == Dissipation::Kind::conformal &&
                       damps_along_free_motion(*system_) && !system_->force;
  double const free = along_free_motion_ ? friction->free_time(h) : h;
  for (double const fraction : fractions) {
    substeps_.emplace_back(*system_, fraction * free);
    substeps_.back().begin_at(velocity);
  }
}

void ChartIntegrator::step() {
  point_before_ = point_, configuration_before_ = configuration_;
  ForceLedger const ledger_before = ledger_;
  try {
    for (auto& substep : substeps_) {
      dissipate(substep.length() / 2, substep);
      substep(point_);
      dissipate(substep.length() / 2, substep);
      if (!system_->force) {
        if (configuration_.size())
          move_configuration(*system_, substep.length(), substep.velocity(), configuration_);
        continue;
      }
      auto const& last = substep.last().force;
      double const half = substep.length() / 2;
      for (std::size_t i = 0; i < last.before.size(); ++i)
        ledger_.work += half * (last.before[i] + last.after[i]) * substep.velocity()[i];
      if (!configuration_.size()) continue;
      add_impulse(half, last.before);
      move_configuration(*system_, substep.length(), substep.velocity(), configuration_);
      add_impulse(half, last.after);
    }
    if (along_free_motion_)
      for (double& p : point_.momentum) p *= std::exp(-system_->dissipation->rate * length_);
  } catch (...) {
    point_ = point_before_, configuration_ = configuration_before_, ledger_ = ledger_before;
    throw;
  }
  ++steps_;
  if (system_->force) set_time();
}

void ChartIntegrator::dissipate(double h, ChartSolver const& substep) {
  auto const& friction = system_->dissipation;
  if (!friction || along_free_motion_) return;
  if (friction->kind == Dissipation::Kind::conformal) {
    for (double& p : point_.momentum) p *= std::exp(-friction->rate * h);
  } else {
    auto near = substep.velocity();
    turn_by_friction(*system_, h, point_.momentum, near);
  }
}

void ChartIntegrator::add_before(ForceLedger const& before) {
  ledger_.work += before.work;
  for (std::size_t i = 0; i < before.impulse.size() && i < ledger_.impulse.size(); ++i)
    ledger_.impulse[i] += before.impulse[i];
}

void ChartIntegrator::add_impulse(double h, std::vector<double> const& force) {
  Eigen::MatrixXd const back = inverse_matrix(configuration_, "configuration");
  auto const moved = momentum_across(system_->algebra, system_->side, configuration_, back, force);
  for (std::size_t i = 0; i < moved.size(); ++i) ledger_.impulse[i] += h * moved[i];
}

}  // namespace actio::systems
