#include <Eigen/Core>

#include "actio/nonholonomic/rattle_solver.hpp"

namespace actio::systems {

RattleSolver::RattleSolver(ReducedSystem const& system, VelocityConstraints const& constraints, double h)
    : system_(system),
      constraints_(constraints),
      h_(h),
      step_(system, constraints),
      moved_(system, constraints),
      start_(constraints),
      projection_(system, constraints),
      iteration_(static_cast<std::size_t>(constraints.dimension + constraints.count)),
      v_(dimension()) {}

void RattleSolver::begin_at(std::vector<double> const& velocity) {
  iteration_.unknowns.assign(iteration_.unknowns.size(), 0);
  std::copy(velocity.begin(), velocity.end(), iteration_.unknowns.begin());
  iteration_.forget(), history_.clear();
}

void RattleSolver::operator()(ReducedPoint& point, double t) {
  auto const look = [&] { return evaluate(point, t); };
  auto const differentiate_there = [&] { return differentiate(point, t); };
  start_.set_rows(point.vectors, t);
  if (!history_.empty()) history_.predict(iteration_.unknowns);
  if (history_.empty() || !iteration_.chord(look, differentiate_there)) newton(point, t);
  require_in_chart(system_, step_.momenta, h_, v_);
  history_.remember(iteration_.unknowns);
  // What the last residual leaves of the momentum goes with the step as the momentum does.
  auto& left = v_;
  std::copy_n(iteration_.residual.begin(), left.size(), left.begin());
  step_.momenta.transport(left);
  for (std::size_t i = 0; i < left.size(); ++i) point.momentum[i] = step_.momenta.after[i] - left[i];
  point.vectors = step_.momenta.vectors;
}

double RattleSolver::evaluate(ReducedPoint const& start, double t) {
  ++evaluations_;
  auto const& x = iteration_.unknowns;
  auto const d = v_.size(), n = x.size();
  std::copy_n(x.begin(), d, v_.begin());
  if (!step_(h_, t, v_, start.vectors)) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double r, scale = 0;
    if (i < d) {
      r = step_.momenta.before[i] - start.momentum[i];
      for (std::size_t k = 0; k + d < n; ++k) r -= start_.rows[k * d + i] * x[d + k];
      scale = std::abs(start.momentum[i]) + std::abs(step_.momenta.before[i]) + step_.momenta.sizes[i];
    } else {
      r = step_.middle.values[i - d], scale = std::abs(r);
    }
    iteration_.residual[i] = r;
    if (!(r - r == 0)) return HUGE_VAL;
    for (std::size_t j = 0; j < n; ++j) scale += iteration_.moduli[i * n + j] * std::abs(x[j]);
    if (r != 0) largest = std::max(largest, std::abs(r) / scale);
  }
  return largest;
}

bool RattleSolver::differentiate(ReducedPoint const& start, double t) {
  auto const d = v_.size(), n = iteration_.unknowns.size();
  Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(static_cast<Index>(n), static_cast<Index>(n));
  std::vector<Moved<double>> v(iteration_.unknowns.begin(),
                               iteration_.unknowns.begin() + constraints_.dimension),
      a(start.vectors.begin(), start.vectors.end());
  for (std::size_t first = 0; first < d; first += batch) {
    std::size_t const end = std::min(d, first + batch);
    for (std::size_t i = first; i < end; ++i) v[i].part[i - first] = 1;
    ++evaluations_;
    if (!moved_(Moved<double>(h_), Moved<double>(t), v, a)) return false;
    for (std::size_t i = first; i < end; ++i) {
      v[i].part[i - first] = 0;
      for (std::size_t r = 0; r < n; ++r)
        derivative(static_cast<Index>(r), static_cast<Index>(i)) =
            (r < d ? moved_.momenta.before[r] : moved_.middle.values[r - d]).part[i - first];
    }
  }
  for (std::size_t k = 0; k + d < n; ++k)
    for (std::size_t i = 0; i < d; ++i)
      derivative(static_cast<Index>(i), static_cast<Index>(d + k)) = -start_.rows[k * d + i];
  Eigen::VectorXd const units = units_with_multipliers(derivative, constraints_.dimension);
  InverseInUnits const inverse(derivative, units);
  iteration_.set_derivative(derivative, inverse.matrix, units);
  regular_ = inverse.condition;
  return regular_ > 0x1p-50;
}

Eigen::MatrixXd RattleSolver::exact_inverse(ReducedPoint const& start, double t) {
  start_.set_rows(start.vectors, t);
  differentiate(start, t);
  auto const n = static_cast<Index>(iteration_.unknowns.size());
  return Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor> const>(iteration_.inverse.data(), n, n);
}

void RattleSolver::newton(ReducedPoint const& start, double t) {
  iteration_.forget();
  if (!history_.empty()) iteration_.unknowns = history_.last();
  auto& x = iteration_.unknowns;
  std::copy_n(x.begin(), v_.size(), v_.begin());
  std::vector<double> lambda(x.begin() + constraints_.dimension, x.end());
  projection_.solve(start.momentum, start.vectors, t, v_, lambda);
  std::copy(v_.begin(), v_.end(), x.begin());
  std::copy(lambda.begin(), lambda.end(), x.begin() + constraints_.dimension);
  std::vector<double> sizes;
  if (iteration_.newton([&] { return evaluate(start, t); }, [&] { return differentiate(start, t); }, sizes))
    return;
  if (regular_ <= 0x1p-50)
    throw Singular("rattle", "Lagrangian and constraints must be regular for this step; condition", regular_,
                   0x1p-50);
  throw NotConverged("rattle", sizes, StepIteration::tolerance);
}

}  // namespace actio::systems
