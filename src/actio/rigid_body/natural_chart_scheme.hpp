// The natural-chart scheme of the generalized rigid body on SO(n) (thesis, section 5.1).
//
// The kinetic energy, through the natural chart with its base point at either end, gives the reduced discrete
// Lagrangian l(f) = h <J zeta, zeta>/2 with zeta = -log(f)/h. Everything else is chapter 3: the three forms
// below call it and add the body's momenta. This is the generic implementation: any scalar with roots, fixed
// n.
#pragma once

#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "actio/rigid_body/inertia.hpp"

namespace actio {

/// The natural-chart scheme for one body and one step.
template <int n, Real S = double>
class NaturalChartScheme {
 public:
  using Rotation = Element<SO<n>, S>;  ///< of the attitude (body to space), and of the relative motion
  using BodyMomentum = Momentum<SO<n>, S>;

  /// @param inertia  of the body
  /// @param step     h, time, positive
  /// @throws NotFinite, OutsideDomain  where the step is no number, or not positive
  NaturalChartScheme(Inertia<n, S> inertia, S step) : inertia_(std::move(inertia)), step_(step) {
    if (!is_finite(step)) throw NotFinite("natural-chart scheme: step");
    if (!(step > S(0)))
      throw OutsideDomain("natural-chart scheme", "the step must be positive", to_double(step), 0);
  }

  Inertia<n, S> const& inertia() const { return inertia_; }
  S step() const { return step_; }

  /// The reduced discrete Lagrangian \f$\ell(f) = \tfrac1{2h}\langle J\log f, \log f\rangle\f$, energy x
  /// time. \implements{eq_5_3}
  auto lagrangian() const {
    // [eq_5_3]
    auto const energy = [inertia = inertia_](auto const& xi) { return kinetic_energy(inertia, xi); };
    return natural_chart_lagrangian_left(energy, step_);
    // [eq_5_3]
  }

  /// Body momentum with which a step with relative motion f begins.
  BodyMomentum momentum_before(Rotation const& f) const { return momentum_before_left(lagrangian(), f); }
  /// Body momentum with which it ends.
  BodyMomentum momentum_after(Rotation const& f) const { return -right_differential(lagrangian(), f); }

  /// The relative motion of the step that begins with body momentum `pi`, near \f$e^{-hJ^{-1}\Pi}\f$.
  /// @throws NotConverged, Singular, OutsideDomain where the step is too long: the chart ends at half a turn
  ///         a step
  Solved<Rotation> relative_motion(BodyMomentum const& pi) const {
    if (!is_finite(pi.components)) throw NotFinite("natural-chart scheme: body momentum");
    Rotation const start = exp(S(-step_) * body_velocity(inertia_, pi));
    return relative_motion_from_momentum_left(lagrangian(), pi, start);
  }

  /// DEP: the relative motion after `f10`.
  Solved<Rotation> step_euler_poincare(Rotation const& f10) const {
    return step_euler_poincare_left(lagrangian(), f10);
  }
  /// DLP: the body momentum after `pi`.
  BodyMomentum step_lie_poisson(BodyMomentum const& pi) const {
    return lie_poisson_update_left(relative_motion(pi).value, pi);
  }
  /// DEL: the attitude after g0, g1, in its reduced form.
  Rotation step_euler_lagrange(Rotation const& g0, Rotation const& g1) const {
    return reconstruct_left(g1, step_euler_poincare(relative_motion_left(g0, g1)).value);
  }
  /// DEL on \f$SO(n)\times SO(n)\f$ itself, with nothing reduced: the state is a pair of attitudes, six
  /// numbers for n = 3, where the reduced form has three.
  Solved<Rotation> step_unreduced(Rotation const& g0, Rotation const& g1) const {
    return actio::step_euler_lagrange(lift_left(lagrangian()), g0, g1);
  }

  /// The body momentum with which a step of constant body velocity zeta begins:
  /// \f$\chi(\mathrm{ad}^*_{h\zeta})\,J\zeta\f$, in closed form.
  ///
  /// Equating it after one step with it before the next gives (5.4).
  BodyMomentum momentum_of(Velocity<SO<n>, S> const& zeta) const {
    // [eq_5_4]
    auto const turn = ad_matrix(step_ * zeta);
    return {zeta.group, chi(turn).transpose() * body_momentum(inertia_, zeta).components};
    // [eq_5_4]
  }

 private:
  Inertia<n, S> inertia_;
  S step_;
};

}  // namespace actio
