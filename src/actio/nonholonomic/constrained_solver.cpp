#include <Eigen/Core>

#include "actio/nonholonomic/constrained_solver.hpp"

namespace actio::systems {

template <template <class> class Step>
ConstrainedSolver<Step>::ConstrainedSolver(ReducedSystem const& system,
                                           VelocityConstraints const& constraints, double h)
    : constraints_(constraints),
      h_(h),
      step_(system, constraints),
      moved_(system, constraints),
      projection_(system, constraints),
      iteration_(static_cast<std::size_t>(constraints.dimension + constraints.count)),
      v_(static_cast<std::size_t>(constraints.dimension)) {
  Step<double>::require(system);
}

template <template <class> class Step>
void ConstrainedSolver<Step>::begin_at(std::vector<double> const& velocity) {
  iteration_.unknowns.assign(iteration_.unknowns.size(), 0);
  std::copy(velocity.begin(), velocity.end(), iteration_.unknowns.begin());
  iteration_.forget(), history_.clear();
}

template <template <class> class Step>
void ConstrainedSolver<Step>::operator()(ReducedPoint& point, double t) {
  auto const look = [&] { return evaluate(point, t); };
  auto const differentiate_there = [&] { return differentiate(point, t); };
  step_.begin(point.vectors, t);
  if (!history_.empty()) history_.predict(iteration_.unknowns);
  if (history_.empty() || !iteration_.chord(look, differentiate_there)) newton(point, t);
  step_.finish(h_, iteration_.unknowns, iteration_.residual, point);
  history_.remember(iteration_.unknowns);
}

template <template <class> class Step>
double ConstrainedSolver<Step>::evaluate(ReducedPoint const& start, double t) {
  ++evaluations_;
  auto const& x = iteration_.unknowns;
  auto const d = v_.size(), n = x.size();
  std::copy_n(x.begin(), d, v_.begin());
  if (!step_(h_, t, v_, start.vectors)) return HUGE_VAL;
  set_residual(step_, start.momentum, x, iteration_.residual);
  double largest = 0, speed = 0;
  for (std::size_t i = 0; i < d; ++i) speed = std::max(speed, iteration_.in_units(i));
  for (std::size_t i = 0; i < n; ++i) {
    double const r = iteration_.residual[i];
    if (!(r - r == 0)) return HUGE_VAL;
    double scale =
        i < d ? std::abs(start.momentum[i]) + step_.size(i) : std::abs(r) + speed / iteration_.unit(i);
    for (std::size_t j = 0; i < d && j < n; ++j) scale += iteration_.moduli[i * n + j] * std::abs(x[j]);
    if (r != 0) largest = std::max(largest, std::abs(r) / scale);
  }
  return largest;
}

template <template <class> class Step>
bool ConstrainedSolver<Step>::differentiate(ReducedPoint const& start, double t) {
  using D = Moved<double>;
  auto const d = v_.size(), n = iteration_.unknowns.size();
  Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(static_cast<Index>(n), static_cast<Index>(n));
  std::vector<D> x(iteration_.unknowns.begin(), iteration_.unknowns.end()),
      v(x.begin(), x.begin() + constraints_.dimension), a(start.vectors.begin(), start.vectors.end()),
      momentum(start.momentum.begin(), start.momentum.end()), residual(n);
  moved_.begin(a, D(t));
  for (std::size_t first = 0; first < d; first += batch) {
    std::size_t const end = std::min(d, first + batch);
    for (std::size_t i = first; i < end; ++i) v[i].part[i - first] = 1;
    ++evaluations_;
    if (!moved_(D(h_), D(t), v, a)) return false;
    set_residual(moved_, momentum, x, residual);
    for (std::size_t i = first; i < end; ++i) {
      v[i].part[i - first] = 0;
      for (std::size_t r = 0; r < n; ++r)
        derivative(static_cast<Index>(r), static_cast<Index>(i)) = residual[r].part[i - first];
    }
  }
  for (std::size_t k = 0; k + d < n; ++k)
    for (std::size_t i = 0; i < d; ++i)
      derivative(static_cast<Index>(i), static_cast<Index>(d + k)) =
          -Step<double>::share * moved_.constraint.rows[k * d + i].value;
  Eigen::VectorXd const units = units_with_multipliers(derivative, constraints_.dimension);
  InverseInUnits const inverse(derivative, units);
  iteration_.set_derivative(derivative, inverse.matrix, units);
  regular_ = inverse.condition;
  return regular_ > 0x1p-50;
}

template <template <class> class Step>
Eigen::MatrixXd ConstrainedSolver<Step>::exact_inverse(ReducedPoint const& start, double t) {
  differentiate(start, t);
  auto const n = static_cast<Index>(iteration_.unknowns.size());
  return Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor> const>(iteration_.inverse.data(), n, n);
}

template <template <class> class Step>
void ConstrainedSolver<Step>::newton(ReducedPoint const& start, double t) {
  iteration_.forget();
  auto& x = iteration_.unknowns;
  if (!history_.empty()) x = history_.last();
  std::copy_n(x.begin(), v_.size(), v_.begin());
  std::vector<double> lambda(x.begin() + constraints_.dimension, x.end());
  projection_.solve(start.momentum, start.vectors, t, v_, lambda);
  std::copy(v_.begin(), v_.end(), x.begin());
  std::copy(lambda.begin(), lambda.end(), x.begin() + constraints_.dimension);
  std::vector<double> sizes;
  if (iteration_.newton([&] { return evaluate(start, t); }, [&] { return differentiate(start, t); }, sizes))
    return;
  if (regular_ <= 0x1p-50)
    throw Singular(Step<double>::name, "Lagrangian and constraints must be regular for this step; condition",
                   regular_, 0x1p-50);
  throw NotConverged(Step<double>::name, sizes, StepIteration::tolerance);
}

template class ConstrainedSolver<RattleStep>;
template class ConstrainedSolver<ConservingStep>;

}  // namespace actio::systems
