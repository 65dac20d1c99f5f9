// A step of the natural chart as a map of momenta and carried vectors over infinitesimals: what tangent maps
// and instruments are made of.
#pragma once

#include <Eigen/Core>

#include "actio/any_group/chart_integrator.hpp"

namespace actio::systems {

/// A point over the scalar S.
template <class S>
struct ReducedPointOver {
  std::vector<S> momentum,  ///< of the body (left-invariant) or in space (right-invariant)
      vectors;              ///< one after the other
  S time = S(0);            ///< when, for a force that depends on it
};

/// The map of one whole step, at plain numbers and at dual numbers over them.
///
/// The equation of each substep is solved at the values; its solution is then moved with the infinitesimals
/// of momentum, vectors and step by the implicit function theorem.
class ChartMap {
 public:
  /// Of a system that outlives it.
  /// @param fractions  of the substeps; {1} for order 2
  /// @param velocity   near which the first substep looks for its own
  ChartMap(ReducedSystem const& system, std::vector<double> fractions, std::vector<double> velocity)
      : system_(system), fractions_(std::move(fractions)), velocity_(std::move(velocity)) {}

  /// @param h  step, time, at the scalar of the point
  /// @throws NotConverged, Singular, NotFinite  where a substep has no solution
  template <class D>
  ReducedPointOver<D> operator()(D const& h, ReducedPointOver<D> point) const {
    std::vector<double> near = velocity_;
    for (double const fraction : fractions_) substep(D(h * D(fraction)), point, near, [](auto const&...) {});
    return point;
  }
  /// The same; `visit(h, v)` is told the length and the velocity of each substep, at the scalar of the point.
  template <class D, class Visit>
  ReducedPointOver<D> operator()(D const& h, ReducedPointOver<D> point, Visit const& visit) const {
    std::vector<double> near = velocity_;
    for (double const fraction : fractions_) substep(D(h * D(fraction)), point, near, visit);
    return point;
  }

 private:
  template <class D, class Visit>
  void substep(D const& h, ReducedPointOver<D>& point, std::vector<double>& near, Visit const& visit) const {
    ReducedPoint const start{values(point.momentum), values(point.vectors), base_value(point.time)};
    ChartSolver solver(system_, base_value(h));
    solver.begin_at(near);
    ReducedPoint end = start;
    solver(end);
    near = solver.velocity();
    std::vector<D> v(near.begin(), near.end());
    ChartStep<D> step(system_);
    step.begin_at(point.time);
    step(h, v, point.vectors);
    if constexpr (is_dual<D>) {
      Eigen::MatrixXd const inverse = solver.exact_inverse(start);
      for (std::size_t i = 0; i < v.size(); ++i)
        for (std::size_t j = 0; j < v.size(); ++j)
          for (std::size_t k = 0; k < v[i].part.size(); ++k)
            v[i].part[k] -= inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *
                            (step.before[j].part[k] - point.momentum[j].part[k]);
      step(h, v, point.vectors);
    }
    visit(h, v);
    for (std::size_t i = 0; i < v.size(); ++i) point.momentum[i] += step.after[i] - step.before[i];
    point.vectors = step.vectors;
    point.time += h;
  }
  template <class D>
  static std::vector<double> values(std::vector<D> const& list) {
    std::vector<double> out;
    for (D const& x : list) out.push_back(base_value(x));
    return out;
  }

  ReducedSystem const& system_;
  std::vector<double> fractions_, velocity_;
};

/// The derivative of momentum and vectors after a map in those before it, column by column.
/// @param map  ReducedPointOver -> ReducedPointOver, over infinitesimals
template <class Map>
Eigen::MatrixXd tangent_of(Map const& map, ReducedPoint const& at) {
  std::size_t const d = at.momentum.size(), n = d + at.vectors.size();
  using D = Moved<double>;
  Eigen::MatrixXd tangent(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  auto const component = [d](ReducedPointOver<D>& p, std::size_t i) -> D& {
    return i < d ? p.momentum[i] : p.vectors[i - d];
  };
  for (std::size_t first = 0; first < n; first += batch) {
    ReducedPointOver<D> moved{
        {at.momentum.begin(), at.momentum.end()}, {at.vectors.begin(), at.vectors.end()}, D(at.time)};
    for (std::size_t k = 0; k < batch && first + k < n; ++k) component(moved, first + k).part[k] = 1;
    auto image = map(moved);
    for (std::size_t k = 0; k < batch && first + k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        tangent(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(first + k)) =
            component(image, i).part[k];
  }
  return tangent;
}

}  // namespace actio::systems
