// The heavy top, stepped: the Lagrangian with chords, solved for the state after a step, and compositions of
// such steps.
#pragma once

#include <vector>

#include "actio/reduction/composition.hpp"
#include "actio/rigid_body/heavy_top_lagrangians.hpp"
#include "actio/rigid_body/moser_veselov.hpp"

namespace actio {

/// The scheme of \ref trace_lagrangian, in closed form but for the relative motion: half of the impulse of
/// gravity, a step of Moser and Veselov's, the other half.
///
/// Exactly conserved, at every step length and order: \f$|\Gamma|\f$ and \f$\langle\Pi,\Gamma\rangle\f$; for
/// a symmetric top with its centre of mass on the axis of symmetry also the component of \f$\Pi\f$ along that
/// axis, by Noether's theorem: the trace does not change when f is conjugated by a rotation that commutes
/// with \f$\Lambda\f$. Energy is not.
///
/// \snippet bodies.cpp heavy_top
template <Real S = double>
class HeavyTopScheme {
 public:
  using Rotation = Element<SO<3>, S>;     ///< of the attitude (body to space), and of the relative motion
  using State = HeavyTopState<S>;         ///< momentum and vertical
  using Vector = actio::Matrix<S, 3, 1>;  ///< of 3-space

  /// @param top    the body
  /// @param step   h, time; negative steps go back in time
  /// @param order  2, or 4, 6, 8 by \ref symmetric_composition of 5, 25, 125 steps
  /// @throws NotFinite, OutsideDomain  where the step is no number, or zero; where there is no such order
  HeavyTopScheme(HeavyTop<S> top, S step, int order = 2) : top_(std::move(top)), step_(step), order_(order) {
    if (!is_finite(step)) throw NotFinite("heavy top: step");
    if (step == S(0)) throw OutsideDomain("heavy top", "the step must differ from zero", 0, 0);
    for (S const& weight : symmetric_composition<S>(order))
      stages_.push_back(
          {MoserVeselov<3, S>(top_.inertia, weight * step), top_.lever() * S(weight * step / S(2))});
  }

  /// The body.
  HeavyTop<S> const& top() const { return top_; }
  S step() const { return step_; }

  /// One step of momentum and vertical.
  /// @throws StepTooLong  where there is no solution, with a step that would do from there; the state stays
  ///                      what it was
  /// @throws NotFinite    where the state is no number
  void advance(State& state) const {
    move(state, [](Rotation const&) {});
  }
  /// The same, and the attitude with it. Attitude and vertical are updated by the same relative motions, and
  /// stay consistent to rounding.
  void advance(State& state, Rotation& attitude) const {
    Rotation g = attitude;
    move(state, [&](Rotation const& f) { g = MoserVeselov<3, S>::reconstruct(g, f); });
    attitude = g;
  }

 private:
  struct Stage {
    MoserVeselov<3, S> drift;
    Vector kick;  // half of the step times p
  };

  template <class Visit>
  void move(State& state, Visit const& visit) const {
    if (!is_finite(state.momentum.components) || !is_finite(state.vector))
      throw NotFinite("heavy top: momentum or vertical");
    State next = state;
    try {
      for (Stage const& stage : stages_) visit(pass(stage, next));
    } catch (StepTooLong const&) {
      throw StepTooLong("heavy top", std::abs(to_double(step_)), step_that_does(state));
    }
    state = next;
  }

  /// One step of second order. Momentum and vertical turn alike, and a short step changes them by a small sum
  /// instead of a rounded whole.
  static Rotation pass(Stage const& stage, State& s) {
    auto const kick = [&] { s.momentum.components += cross(s.vector, stage.kick); };
    // [heavy_top_step]
    kick();
    Rotation const f = stage.drift.relative_motion(s.momentum).value;
    s.momentum = stage.drift.transport_by_increment(f, s.momentum);
    s.vector = stage.drift.transport_by_increment(f, {f.group, s.vector}).components;
    kick();
    // [heavy_top_step]
    return f;
  }

  /// A step shorter than this one that has a solution, within a thousandth of one that has not.
  double step_that_does(State const& state) const {
    auto const does = [&](double part) {
      try {
        State trial = state;
        HeavyTopScheme const shorter(top_, S(step_ * S(part)), order_);
        for (Stage const& stage : shorter.stages_) pass(stage, trial);
        return true;
      } catch (Error const&) {
        return false;
      }
    };
    double low = 1, high = 1;
    while (low > 1e-200 && !does(low /= 2)) high = low;
    while (high - low > 1e-3 * low) {
      double const middle = (low + high) / 2;
      (does(middle) ? low : high) = middle;
    }
    return std::abs(to_double(step_)) * low;
  }

  HeavyTop<S> top_;
  S step_;
  int order_;
  std::vector<Stage> stages_;
};

// Two tops that are known by name.

/// A top and the body velocity it is let go with, standing as its body frame does in space.
template <Real S>
struct KnownTop {
  HeavyTop<S> top;          ///< the body
  Velocity<SO<3>, S> spin;  ///< body velocity, 1/time
};

/// The benchmark of Brüls and Cardona: a disc of 15 kg on an arm of 1 m that turns about the arm at 150
/// rad/s. SI units.
///
/// About its centre of mass the disc is flat exactly, \f$I_2 = I_1 + I_3\f$.
template <Real S>
KnownTop<S> bruls_cardona_top() {
  using Vector = actio::Matrix<S, 3, 1>;
  auto const disc = inertia_from_moments<S>(Vector(ratio<S>(15, 64), ratio<S>(15, 32), ratio<S>(15, 64)));
  return {held_at_a_point<S>(S(15), disc, Vector(S(0), S(1), S(0)), Vector(S(0), S(0), ratio<S>(-981, 100))),
          velocity(SO<3>{}, Vector(S(0), S(150), ratio<S>(-461538, 100000)))};
}
/// Kovalevskaya's top: \f$I_1 = I_2 = 2I_3\f$, centre of mass in the plane of equal moments. In units with
/// \f$I_3 = 1\f$ and weight times arm 1. It has a fourth integral,
/// \f$|(\Omega_1 + i\Omega_2)^2 - (\Gamma_1 + i\Gamma_2)|^2\f$.
template <Real S>
KnownTop<S> kovalevskaya_top() {
  using Vector = actio::Matrix<S, 3, 1>;
  return {heavy_top<S>(S(1), inertia_from_moments<S>(Vector(S(2), S(2), S(1))),
                       Vector(ratio<S>(1, 2), S(0), S(0)), Vector(S(0), S(0), S(-2))),
          velocity(SO<3>{}, Vector(ratio<S>(1, 2), ratio<S>(1, 3), ratio<S>(7, 5)))};
}

}  // namespace actio
