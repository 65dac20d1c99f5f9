#include <Eigen/Core>

#include "actio/any_group/chart_integrator.hpp"

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
    : system_(std::move(system)), point_(std::move(start)) {
  for (double const fraction : fractions) {
    substeps_.emplace_back(*system_, fraction * h);
    substeps_.back().begin_at(velocity);
  }
}

void ChartIntegrator::step() {
  point_before_ = point_, configuration_before_ = configuration_;
  try {
    for (auto& substep : substeps_) {
      substep(point_);
      if (configuration_.size())
        move_configuration(*system_, substep.length(), substep.velocity(), configuration_);
    }
  } catch (...) {
    point_ = point_before_, configuration_ = configuration_before_;
    throw;
  }
}

}  // namespace actio::systems
