#include <Eigen/Core>

#include "actio/any_group/dissipation.hpp"

#include <cmath>

#include "actio/any_group/legendre_velocity.hpp"

namespace actio::systems {
namespace {

Eigen::VectorXd ad_star(MatrixAlgebra const& algebra, Eigen::VectorXd const& v, Eigen::VectorXd const& p) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(p.size());
  for (auto const& c : algebra.constants) out[c.b] += v[c.a] * p[c.c] * c.value;
  return out;
}

/// \f$\exp(\mathrm{ad}^*_\theta)\,p\f$ by its series.
Eigen::VectorXd turned(MatrixAlgebra const& algebra, Eigen::VectorXd const& theta, Eigen::VectorXd const& p) {
  Eigen::VectorXd sum = p, term = p;
  for (int k = 1; k < 300; ++k) {
    term = ad_star(algebra, theta, term) / k;
    sum += term;
    if (!(term.cwiseAbs().maxCoeff() > 0x1p-55 * sum.cwiseAbs().maxCoeff())) return sum;
  }
  throw OutsideDomain("friction on the orbit", "a step must be short enough for its series; terms", 300, 300);
}

}  // namespace

double Dissipation::free_time(double h) const { return rate == 0 ? h : -std::expm1(-rate * h) / rate; }

bool damps_along_free_motion(ReducedSystem const& system) {
  if (system.vectors > 0) return false;
  auto const d = static_cast<std::size_t>(system.dimension());
  std::size_t const first = 1 + d;  // of the second derivatives
  for (std::size_t k = first; k < static_cast<std::size_t>(system.curvature.size()); ++k)
    if (!system.curvature.is_constant(static_cast<int>(k))) return false;
  std::vector<double> const rest(d, 0.0);
  std::vector<double> values(static_cast<std::size_t>(system.curvature.size())), work;
  system.curvature(rest.data(), values.data(), work);
  for (std::size_t k = 1; k < first; ++k)
    if (values[k] != 0) return false;
  return true;
}

void turn_by_friction(ReducedSystem const& system, double h, std::vector<double>& p,
                      std::vector<double>& near) {
  auto const& friction = *system.dissipation;
  auto const size = static_cast<Eigen::Index>(p.size());
  Eigen::Map<Eigen::VectorXd> momentum(p.data(), size);
  Eigen::VectorXd const start = momentum;
  LegendreVelocity legendre(system);
  Eigen::VectorXd theta = Eigen::VectorXd::Zero(size);
  std::vector<double> middle = p, changes;
  for (int iteration = 0; iteration < 100; ++iteration) {
    legendre.solve(middle, {}, near);
    Eigen::Map<Eigen::VectorXd const> const v(near.data(), size);
    Eigen::Map<Eigen::VectorXd> now(middle.data(), size);
    Eigen::VectorXd const next =
        friction.rate * (friction.sharp * ad_star(system.algebra, v, Eigen::VectorXd(now)));
    double const change = (next - theta).cwiseAbs().maxCoeff(), length = next.cwiseAbs().maxCoeff();
    theta = next;
    now = turned(system.algebra, h / 2 * theta, start);
    changes.push_back(length > 0 ? change / length : 0);
    bool const stays =
        changes.size() > 1 && changes.back() < 1e-12 && changes.back() > changes.rbegin()[1] / 2;
    if (changes.back() <= 0x1p-50 || stays) {
      momentum = turned(system.algebra, h * theta, start);
      return;
    }
  }
  throw NotConverged("friction on the orbit", changes, 0x1p-50);
}

}  // namespace actio::systems
