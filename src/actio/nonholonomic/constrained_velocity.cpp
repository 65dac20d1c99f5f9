#include <Eigen/Core>

#include "actio/nonholonomic/constrained_velocity.hpp"

#include "actio/any_group/chart_solver.hpp"

namespace actio::systems {
namespace {

using Eigen::Index;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

Eigen::VectorXd units_with_multipliers(Eigen::MatrixXd const& derivative, int dimension) {
  Eigen::VectorXd units(derivative.rows());
  units.head(dimension) = units_of(derivative.topLeftCorner(dimension, dimension));
  for (Index k = dimension; k < units.size(); ++k) {
    double const largest =
        (derivative.row(k).head(dimension).transpose().cwiseAbs().cwiseProduct(units.head(dimension)))
            .maxCoeff();
    units[k] = largest > 0 ? 1 / largest : 1;
  }
  return units;
}

ConstrainedVelocity::ConstrainedVelocity(ReducedSystem const& system, VelocityConstraints const& constraints)
    : system_(system),
      constraints_(constraints),
      legendre_(system),
      at_(constraints),
      matrix_(Eigen::MatrixXd::Zero(constraints.dimension + constraints.count,
                                    constraints.dimension + constraints.count)),
      residual_(matrix_.rows()) {}

void ConstrainedVelocity::set_matrix(std::vector<double> const& v, std::vector<double> const& a) {
  Index const d = constraints_.dimension, m = constraints_.count;
  matrix_.topLeftCorner(d, d) = legendre_.hessian(v, a);
  for (Index k = 0; k < m; ++k)
    for (Index i = 0; i < d; ++i) {
      matrix_(d + k, i) = at_.rows[at(k * d + i)];
      matrix_(i, d + k) = -matrix_(d + k, i);
    }
}

Eigen::MatrixXd ConstrainedVelocity::inverse() const {
  InverseInUnits const inverse(matrix_, units_with_multipliers(matrix_, constraints_.dimension));
  if (!(inverse.condition > 0x1p-50))
    throw Singular("velocity constraints",
                   "the Lagrangian must be regular along constraints that are independent; condition",
                   inverse.condition, 0x1p-50);
  return inverse.matrix;
}

double ConstrainedVelocity::residual(std::vector<double> const& p, std::vector<double> const& a, double t,
                                     std::vector<double> const& v, std::vector<double> const& lambda) {
  std::vector<double> const now = legendre_.momentum(v, a);
  at_.set_values(v, a, t), at_.set_rows(a, t);
  set_matrix(v, a);
  Index const d = constraints_.dimension, m = constraints_.count;
  Eigen::VectorXd const sizes = sizes_at(v);
  double largest = 0;
  for (Index i = 0; i < d + m; ++i) {
    double scale = 0, sum = 0;
    if (i < d) {
      sum = now[at(i)] - p[at(i)], scale = std::abs(now[at(i)]) + std::abs(p[at(i)]);
      for (Index k = 0; k < m; ++k) sum += matrix_(i, d + k) * lambda[at(k)];
      for (Index k = 0; k < m; ++k) scale += std::abs(matrix_(i, d + k) * lambda[at(k)]);
    } else {
      sum = at_.values[at(i - d)], scale = std::abs(sum) + sizes[i - d];
    }
    for (Index j = 0; i < d && j < d; ++j) scale += std::abs(matrix_(i, j) * v[at(j)]);
    residual_[i] = sum;
    if (!(sum - sum == 0)) throw NotFinite("a velocity constraint or its row");
    if (sum != 0) largest = std::max(largest, std::abs(sum) / scale);
  }
  return largest;
}

void ConstrainedVelocity::solve(std::vector<double> const& p, std::vector<double> const& a, double t,
                                std::vector<double>& v, std::vector<double>& lambda) {
  Index const d = constraints_.dimension, m = constraints_.count;
  std::vector<double> sizes;
  double size = residual(p, a, t, v, lambda);
  for (int iteration = 0; iteration < 60; ++iteration) {
    sizes.push_back(size);
    if (size <= tolerance_) return;
    Eigen::VectorXd const update = inverse() * residual_;
    std::vector<double> const from = v, from_lambda = lambda;
    double const before = size;
    for (double fraction = 1; fraction > 1e-9; fraction /= 2) {
      for (Index i = 0; i < d; ++i) v[at(i)] = from[at(i)] - fraction * update[i];
      for (Index k = 0; k < m; ++k) lambda[at(k)] = from_lambda[at(k)] - fraction * update[d + k];
      size = residual(p, a, t, v, lambda);
      if (size <= before) break;
    }
    if (size <= 64 * tolerance_ && size >= before / 2) return;
    if (!(size <= before)) break;
  }
  throw NotConverged("velocity on constraints", sizes, tolerance_);
}

std::vector<double> ConstrainedVelocity::momentum(std::vector<double> p, std::vector<double> const& a,
                                                  double t, std::vector<double> const& lambda) {
  at_.set_rows(a, t);
  for (std::size_t k = 0; k < lambda.size(); ++k)
    for (std::size_t i = 0; i < p.size(); ++i) p[i] += at_.rows[k * p.size() + i] * lambda[k];
  return p;
}

double ConstrainedVelocity::defect(std::vector<double> const& v, std::vector<double> const& a, double t) {
  at_.set_values(v, a, t), at_.set_rows(a, t);
  set_matrix(v, a);
  Eigen::VectorXd const sizes = sizes_at(v);
  double largest = 0;
  for (std::size_t k = 0; k < at_.values.size(); ++k) {
    double const c = std::abs(at_.values[k]), size = sizes[static_cast<Index>(k)];
    if (!std::isfinite(c)) throw NotFinite("a velocity constraint or its row");
    if (c > 0) largest = std::max(largest, size > c ? c / size : 1);
  }
  return largest;
}

Eigen::VectorXd ConstrainedVelocity::sizes_at(std::vector<double> const& v) const {
  Index const d = constraints_.dimension, m = constraints_.count;
  Eigen::VectorXd const units = units_of(matrix_.topLeftCorner(d, d));
  double speed = 0;
  for (Index i = 0; i < d; ++i) speed = std::max(speed, std::abs(v[at(i)]) / units[i]);
  Eigen::VectorXd out(m);
  for (Index k = 0; k < m; ++k)
    out[k] = speed * (matrix_.row(d + k).head(d).transpose().cwiseAbs().cwiseProduct(units)).maxCoeff();
  return out;
}

void ConstrainedVelocity::require_independent(std::vector<double> const& v, std::vector<double> const& a,
                                              double t) {
  at_.set_rows(a, t);
  Index const d = constraints_.dimension, m = constraints_.count;
  set_matrix(v, a);
  Eigen::VectorXd const units = units_of(matrix_.topLeftCorner(d, d));
  Eigen::MatrixXd rows = matrix_.bottomLeftCorner(m, d) * units.asDiagonal();
  require_finite(rows, "a velocity constraint or its row");
  for (Index k = 0; k < m; ++k) {
    double const before = rows.row(k).norm();
    for (int twice = 0; twice < 2; ++twice)
      for (Index j = 0; j < k; ++j) rows.row(k) -= rows.row(k).dot(rows.row(j)) * rows.row(j);
    double const left = rows.row(k).norm();
    if (!(left > 1e-10 * before))
      throw Singular("velocity constraint " + std::to_string(k + 1),
                     "its row must be independent of those before; relative distance from their span",
                     before > 0 ? left / before : 0, 1e-10);
    rows.row(k) /= left;
  }
}

std::vector<double> ConstrainedVelocity::reaction(std::vector<double> const& v, std::vector<double> const& a,
                                                  double t) {
  using D = Moved<double>;
  std::size_t const d = v.size(), length = at(system_.length());
  // Velocity fixed, vectors and time moving.
  std::vector<D> inputs(v.begin(), v.end());
  std::vector<D> moving(a.begin(), a.end());
  for (auto const& e : system_.algebra.entries)
    for (std::size_t first = 0; first < a.size(); first += length)
      moving[first + at(e.row)].part[0] -=
          system_.sign() * v[at(e.direction)] * e.value * a[first + at(e.column)];
  inputs.insert(inputs.end(), moving.begin(), moving.end());
  std::vector<D> slopes(inputs.size() + 1), work;
  system_.slopes(inputs.data(), slopes.data(), work);
  D time(t);
  time.part[0] = 1;
  ConstraintValues<D> constraint(constraints_);
  constraint.set_values({v.begin(), v.end()}, moving, time);

  Eigen::VectorXd right(matrix_.rows());
  for (std::size_t i = 0; i < d; ++i) right[static_cast<Index>(i)] = -slopes[1 + i].part[0];
  for (auto const& c : system_.algebra.constants)
    right[c.b] += system_.sign() * v[at(c.a)] * c.value * slopes[1 + at(c.c)].value;
  for (auto const& e : system_.algebra.entries)
    for (std::size_t first = 0; first < a.size(); first += length)
      right[e.direction] -=
          system_.sign() * slopes[1 + d + first + at(e.row)].value * e.value * a[first + at(e.column)];
  if (auto const& friction = system_.dissipation; friction && friction->kind == Dissipation::Kind::conformal)
    for (std::size_t i = 0; i < d; ++i) right[static_cast<Index>(i)] -= friction->rate * slopes[1 + i].value;
  if (system_.force) {
    ReducedPoint now{{}, a, t};
    for (std::size_t i = 0; i < d; ++i) now.momentum.push_back(slopes[1 + i].value);
    auto const force = force_at(system_, v, now);
    for (std::size_t i = 0; i < d; ++i) right[static_cast<Index>(i)] += force[i];
  }
  for (std::size_t k = 0; k < constraint.values.size(); ++k)
    right[static_cast<Index>(d + k)] = -constraint.values[k].part[0];

  at_.set_rows(a, t);
  set_matrix(v, a);
  Eigen::VectorXd const solved = inverse() * right;
  return {solved.data() + d, solved.data() + solved.size()};
}

}  // namespace actio::systems
