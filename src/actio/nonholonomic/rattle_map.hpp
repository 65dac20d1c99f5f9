// A step with constraints as a map of momenta and carried vectors over infinitesimals: what tangent maps, and
// the stability of rolling, are made of.
#pragma once

#include "actio/any_group/chart_map.hpp"
#include "actio/nonholonomic/constrained_integrator.hpp"

namespace actio::systems {

/// The map of one whole step, at plain numbers and at dual numbers over them.
///
/// The momentum need not obey the constraints: points that differ by a combination of the rows are the same
/// motion and have the same image. So for m constraints a tangent map has m eigenvalues that are zero.
class RattleMap {
 public:
  /// Of a system and constraints that outlive it.
  /// @param fractions  of the substeps; {1} for order 2
  /// @param velocity   near which the first substep looks for its own
  RattleMap(ReducedSystem const& system, VelocityConstraints const& constraints,
            std::vector<double> fractions, std::vector<double> velocity)
      : system_(system),
        constraints_(constraints),
        fractions_(std::move(fractions)),
        velocity_(std::move(velocity)) {}

  /// @param h  step, time, at the scalar of the point
  /// @param t  time at the start, likewise
  /// @throws NotConverged, Singular, NotFinite  where a substep has no solution
  template <class D>
  ReducedPointOver<D> operator()(D const& h, ReducedPointOver<D> point, D t = D(0)) const {
    std::vector<double> near = velocity_;
    for (double const fraction : fractions_) {
      D const part = h * D(fraction);
      substep(part, t, point, near);
      t += part;
    }
    return point;
  }

 private:
  template <class D>
  void substep(D const& h, D const& t, ReducedPointOver<D>& point, std::vector<double>& near) const {
    ReducedPoint const start{values(point.momentum), values(point.vectors)};
    RattleSolver solver(system_, constraints_, base_value(h));
    solver.begin_at(near);
    ReducedPoint end = start;
    solver(end, base_value(t));
    auto const d = near.size(), n = solver.unknowns().size();
    std::vector<D> x(solver.unknowns().begin(), solver.unknowns().end()),
        v(x.begin(), x.begin() + system_.dimension());
    RattleStep<D> step(system_, constraints_);
    step.begin(point.vectors, t);
    step(h, t, v, point.vectors);
    std::vector<D> residual(n);
    set_residual(step, point.momentum, x, residual);
    if constexpr (is_dual<D>) {
      Eigen::MatrixXd const inverse = solver.exact_inverse(start, base_value(t));
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t k = 0; k < x[i].part.size(); ++k)
            x[i].part[k] -= inverse(static_cast<Index>(i), static_cast<Index>(j)) * residual[j].part[k];
      std::copy_n(x.begin(), d, v.begin());
      step(h, t, v, point.vectors);
    }
    std::copy_n(solver.unknowns().begin(), d, near.begin());
    point = {step.momenta.after, step.momenta.vectors};
  }
  template <class D>
  static std::vector<double> values(std::vector<D> const& list) {
    std::vector<double> out;
    for (D const& x : list) out.push_back(base_value(x));
    return out;
  }

  ReducedSystem const& system_;
  VelocityConstraints const& constraints_;
  std::vector<double> fractions_, velocity_;
};

}  // namespace actio::systems
