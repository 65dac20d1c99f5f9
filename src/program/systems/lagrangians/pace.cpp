#include <Eigen/Core>

#include "program/systems/lagrangians/pace.hpp"

#include "actio/any_group/chart_map.hpp"

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

}  // namespace

double fastest_rate(ReducedScene const& scene, double time) {
  systems::ReducedSystem const& system = *scene.system;
  Eigen::VectorXd const v = as_vector(scene.velocity);
  double const turns = turning(system, v);
  systems::ChartMap const map(system, {1}, scene.velocity);
  double h = turns > 0 ? std::min(time, 0.05 / turns) : time;
  for (int k = 0; k < 200; ++k) try {
      Eigen::MatrixXd const tangent = systems::tangent_of(
          [&](systems::ReducedPointOver<Moved<double>> const& x) { return map(Moved<double>(h), x); },
          scene.start);
      auto const n = tangent.rows();
      double const radius =
          systems::eigenvalues_of(tangent - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff();
      auto const after = map(h, systems::ReducedPointOver<double>{scene.start.momentum, scene.start.vectors});
      std::vector<double> v_after = scene.velocity;
      systems::LegendreVelocity(system).solve(after.momentum, after.vectors, v_after);
      double const grows = turning(system, as_vector(v_after) - v) / h;
      double const fastest = std::max({turns, radius / h, std::sqrt(grows)});
      // Of a step that is short for what it found the rates are those at the start.
      if (fastest * h <= 0.2) return fastest;
      h = std::min(h / 2, 0.1 / fastest);
    } catch (Error const&) {
      h /= 4;
    }
  return turns;
}

}  // namespace actio::scene
