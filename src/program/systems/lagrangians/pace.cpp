#include <Eigen/Core>

#include "program/systems/lagrangians/pace.hpp"

#include "actio/nonholonomic/rattle_map.hpp"

namespace actio::scene {
namespace {

/// \f$\sqrt{|\mathrm{tr}\,\mathrm{ad}_v^2|}/2\f$.
double turning(systems::ReducedSystem const& system, Eigen::VectorXd const& v) {
  auto const ad = system.algebra.ad(Vector<double>(v));
  double trace = 0;
  for (Index i = 0; i < ad.rows(); ++i)
    for (Index j = 0; j < ad.cols(); ++j) trace += ad(i, j) * ad(j, i);
  return std::sqrt(std::abs(trace)) / 2;
}

Eigen::VectorXd as_vector(std::vector<double> const& list) {
  return Eigen::Map<Eigen::VectorXd const>(list.data(), static_cast<Eigen::Index>(list.size()));
}

/// @param map       a step, of points over any scalar
/// @param velocity  (point) -> the velocity there
template <class Map, class Velocity>
double rate_of(ReducedScene const& scene, double time, Map const& map, Velocity const& velocity) {
  systems::ReducedSystem const& system = *scene.system;
  Eigen::VectorXd const v = as_vector(scene.velocity);
  double const turns = turning(system, v);
  double h = turns > 0 ? std::min(time, 0.05 / turns) : time;
  for (int k = 0; k < 200; ++k) try {
      Eigen::MatrixXd const tangent = systems::tangent_of(
          [&](systems::ReducedPointOver<Moved<double>> const& x) { return map(Moved<double>(h), x); },
          scene.start);
      double radius = 0;
      for (auto const& one :
           systems::eigenvalues_of(tangent - Eigen::MatrixXd::Identity(tangent.rows(), tangent.rows())))
        // Combinations of the rows of constraints are sent to zero at once.
        if (!scene.constraints || std::abs(1.0 + one) > 0.5) radius = std::max(radius, std::abs(one));
      auto const after = map(h, systems::ReducedPointOver<double>{scene.start.momentum, scene.start.vectors});
      double const grows = turning(system, as_vector(velocity({after.momentum, after.vectors})) - v) / h;
      double const fastest = std::max({turns, radius / h, std::sqrt(grows)});
      // Of a step that is short for what it found the rates are those at the start.
      if (fastest * h <= 0.2) return fastest;
      h = std::min(h / 2, 0.1 / fastest);
    } catch (Error const&) {
      h /= 4;
    }
  return turns;
}

}  // namespace

double fastest_rate(ReducedScene const& scene, double time) {
  systems::ReducedSystem const& system = *scene.system;
  if (!scene.constraints)
    return rate_of(scene, time, systems::ChartMap(system, {1}, scene.velocity),
                   [&](systems::ReducedPoint const& at) {
                     std::vector<double> v = scene.velocity;
                     systems::LegendreVelocity(system).solve(at.momentum, at.vectors, v);
                     return v;
                   });
  auto const& constraints = *scene.constraints;
  return rate_of(
      scene, time, systems::RattleMap(system, constraints, {1}, scene.velocity),
      [&](systems::ReducedPoint const& at) {
        std::vector<double> v = scene.velocity, lambda(static_cast<std::size_t>(constraints.count), 0);
        systems::ConstrainedVelocity(system, constraints).solve(at.momentum, at.vectors, 0, v, lambda);
        return v;
      });
}

}  // namespace actio::scene
