#include <Eigen/Core>

#include "actio/nonholonomic/conserving_integrator.hpp"

namespace actio::systems {
namespace {

/// Refuses what is not v.Mv/2 - V(a).
void require_constant_metric(ReducedSystem const& system) {
  constexpr char const* where = "steps that conserve the energy";
  if (system.chart != Chart::cayley)
    throw OutsideDomain(where, "Cayley's chart is needed; chart, 0 for the exponential one", 0, 1);
  if (system.force || system.dissipation)
    throw OutsideDomain(where, "there must be no force and no friction; how many there are",
                        int(system.force.has_value()) + int(system.dissipation.has_value()), 0);
  int const d = system.dimension();
  Tape momenta = system.slopes;
  momenta.outputs = {momenta.outputs.begin() + 1, momenta.outputs.begin() + 1 + d};
  momenta = joined({momenta});
  int varying = 0, moving = 0;
  for (int i = 1 + d; i < system.curvature.size(); ++i) varying += !system.curvature.is_constant(i);
  if (varying > 0)
    throw OutsideDomain(where, "the kinetic energy must have constant coefficients as it is written; others",
                        varying, 0);
  for (int i = d; i < system.lagrangian.inputs; ++i) varying += momenta.depends_on(i);
  std::vector<double> still(static_cast<std::size_t>(system.lagrangian.inputs), 0),
      p(static_cast<std::size_t>(d)), work;
  momenta(still.data(), p.data(), work);
  for (double const x : p) moving += x != 0;
  if (varying + moving > 0)
    throw OutsideDomain(where, "there must be no momentum at rest; vectors and constants in momenta",
                        varying + moving, 0);
}

}  // namespace

ConservingSolver::ConservingSolver(ReducedSystem const& system, VelocityConstraints const& constraints,
                                   double h)
    : constraints_(constraints),
      h_(h),
      step_(system, constraints),
      moved_(system, constraints),
      projection_(system, constraints),
      iteration_(static_cast<std::size_t>(constraints.dimension + constraints.count)),
      v_(static_cast<std::size_t>(constraints.dimension)),
      multipliers_(static_cast<std::size_t>(constraints.count)) {
  require_constant_metric(system);
}

void ConservingSolver::begin_at(std::vector<double> const& velocity) {
  iteration_.unknowns.assign(iteration_.unknowns.size(), 0);
  std::copy(velocity.begin(), velocity.end(), iteration_.unknowns.begin());
  iteration_.forget(), history_.clear();
}

void ConservingSolver::operator()(ReducedPoint& point, double t) {
  auto const look = [&] { return evaluate(point, t); };
  auto const differentiate_there = [&] { return differentiate(point, t); };
  if (!history_.empty()) history_.predict(iteration_.unknowns);
  if (history_.empty() || !iteration_.chord(look, differentiate_there)) newton(point, t);
  history_.remember(iteration_.unknowns);
  // Of the two ways to the momentum at the end, that on which the last residual does next to no work.
  std::size_t const d = v_.size();
  for (std::size_t i = 0; i < d; ++i) {
    double change = step_.change[i];
    for (std::size_t k = 0; k < step_.constraint.values.size(); ++k)
      change += step_.constraint.rows[k * d + i] * multipliers_[k];
    point.momentum[i] += change;
  }
  point.vectors = step_.vectors;
}

double ConservingSolver::evaluate(ReducedPoint const& start, double t) {
  ++evaluations_;
  auto const& x = iteration_.unknowns;
  auto const d = v_.size(), n = x.size();
  std::copy_n(x.begin(), d, v_.begin());
  std::copy(x.begin() + constraints_.dimension, x.end(), multipliers_.begin());
  step_(h_, t, v_, start.vectors);
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double r, scale = 0;
    if (i < d) {
      r = 2 * (step_.momentum[i] - start.momentum[i]) - step_.change[i];
      for (std::size_t k = 0; k + d < n; ++k) r -= step_.constraint.rows[k * d + i] * x[d + k];
      scale = 2 * std::abs(start.momentum[i]) + (2 + step_.work_terms) * std::abs(step_.momentum[i]);
    } else {
      r = step_.constraint.values[i - d], scale = std::abs(r);
    }
    iteration_.residual[i] = r;
    if (!(r - r == 0)) return HUGE_VAL;
    for (std::size_t j = 0; j < n; ++j) scale += iteration_.moduli[i * n + j] * std::abs(x[j]);
    if (r != 0) largest = std::max(largest, std::abs(r) / scale);
  }
  return largest;
}

bool ConservingSolver::differentiate(ReducedPoint const& start, double t) {
  auto const d = v_.size(), n = iteration_.unknowns.size();
  auto const& x = iteration_.unknowns;
  Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(static_cast<Index>(n), static_cast<Index>(n));
  std::vector<Moved<double>> v(x.begin(), x.begin() + constraints_.dimension),
      a(start.vectors.begin(), start.vectors.end());
  for (std::size_t first = 0; first < d; first += batch) {
    std::size_t const end = std::min(d, first + batch);
    for (std::size_t i = first; i < end; ++i) v[i].part[i - first] = 1;
    ++evaluations_;
    moved_(Moved<double>(h_), Moved<double>(t), v, a);
    for (std::size_t i = first; i < end; ++i) {
      v[i].part[i - first] = 0;
      for (std::size_t r = 0; r < n; ++r) {
        Moved<double> left =
            r < d ? 2 * moved_.momentum[r] - moved_.change[r] : moved_.constraint.values[r - d];
        for (std::size_t k = 0; r < d && k + d < n; ++k) left -= moved_.constraint.rows[k * d + r] * x[d + k];
        derivative(static_cast<Index>(r), static_cast<Index>(i)) = left.part[i - first];
      }
    }
  }
  for (std::size_t k = 0; k + d < n; ++k)
    for (std::size_t i = 0; i < d; ++i)
      derivative(static_cast<Index>(i), static_cast<Index>(d + k)) = -moved_.constraint.rows[k * d + i].value;
  Eigen::VectorXd const units = units_with_multipliers(derivative, constraints_.dimension);
  InverseInUnits const inverse(derivative, units);
  iteration_.set_derivative(derivative, inverse.matrix, units);
  regular_ = inverse.condition;
  return regular_ > 0x1p-50;
}

void ConservingSolver::newton(ReducedPoint const& start, double t) {
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
    throw Singular("steps that conserve the energy",
                   "the constraints must be regular for this step; condition", regular_, 0x1p-50);
  throw NotConverged("steps that conserve the energy", sizes, StepIteration::tolerance);
}

}  // namespace actio::systems
