// The heavy top: a rigid body held at a point, under gravity. Discrete mechanics with an advected vector, which is the vertical as the body sees it.
//
// The state is (Pi, Gamma): the body momentum about the fixed point, and the unit vector against gravity in the body frame, Gamma = g^T k. The
// attitude g is not part of it. With the weight times the centre of mass, p = m |gravity| chi, the Lagrangian is l = <I Omega, Omega>/2 - <p, Gamma>,
// and the equations of Euler and Poisson are
//
//     Pi' = Pi x Omega + Gamma x p,        Gamma' = Gamma x Omega.
//
// (Pi, Gamma) is an element of the dual of se(3), the semidirect product of so(3) with 3-space, and moves on a coadjoint orbit of SE(3): |Gamma| and
// <Pi, Gamma>, the momentum about the vertical, are the Casimirs. The frame of the body is that of its principal axes at the fixed point.
#pragma once

#include <vector>

#include "actio/foundations/groups/motions.hpp"
#include "actio/reduction/advected.hpp"
#include "actio/rigid_body/moser_veselov.hpp"

namespace actio {

/// Body momentum, and the vertical (against gravity, a unit vector) as the body sees it.
template <Real S = double>
using HeavyTopState = AdvectedState<SO<3>, S, 3>;

/// A body held at a point under gravity. Made by \ref heavy_top or \ref held_at_a_point, which check it.
template <Real S = double>
struct HeavyTop {
  using Vector = Eigen::Matrix<S, 3, 1>;  ///< of 3-space

  S mass;                 ///< not negative; zero for a free body
  Inertia<3, S> inertia;  ///< about the fixed point, in the body frame; mass x length^2
  Vector centre;          ///< centre of mass from the fixed point, in the body frame; length
  Vector gravity;         ///< acceleration, in the frame of space; length/time^2. Zero for a free body

  /// \f$|g|\f$.
  S pull() const {
    using std::sqrt;
    S const scale = magnitude(gravity);
    return scale > S(0) ? S(scale * sqrt((gravity / scale).squaredNorm())) : S(0);
  }
  /// The unit vector against gravity, in the frame of space; the third axis where there is no gravity.
  Vector vertical() const { return pull() > S(0) ? Vector(-gravity / pull()) : Vector(Vector::Unit(2)); }
  /// \f$p = m|g|\chi\f$: weight times centre of mass; energy.
  Vector lever() const { return centre * S(mass * pull()); }
  /// \f$\langle p, \Gamma\rangle\f$: the potential energy, zero with the centre of mass as high as the fixed point.
  S potential(Vector const& gamma) const { return lever().dot(gamma); }
  /// Kinetic and potential energy. No discrete motion keeps it exactly: its error is bounded, of second order in the step.
  S energy(HeavyTopState<S> const& state) const { return kinetic_energy(inertia, state.momentum) + potential(state.vector); }
  /// The same top over another scalar.
  template <Real T>
  HeavyTop<T> over() const {
    return {T(mass), inertia.template over<T>(), centre.template cast<T>(), gravity.template cast<T>()};
  }
};

/// A heavy top from its inertia about the fixed point.
///
/// @param mass     not negative
/// @param inertia  about the fixed point, in the frame of the principal axes there
/// @param centre   centre of mass from the fixed point, in that frame
/// @param gravity  acceleration, in the frame of space
/// @throws NotFinite          where one of them is no number
/// @throws OutsideDomain      where the mass is negative
/// @throws UnphysicalInertia  where a \f$\Lambda_i\f$ is negative, or where no body of that mass with that centre has so little inertia: the second moments
///                            about the centre, \f$\Lambda - m\chi\chi^T\f$, must not be negative, \f$m\sum_i\chi_i^2/\Lambda_i \le 1\f$. Equality is a
///                            body without extent in one direction
template <Real S>
HeavyTop<S> heavy_top(S const& mass, Inertia<3, S> const& inertia, Eigen::Matrix<S, 3, 1> const& centre, Eigen::Matrix<S, 3, 1> const& gravity) {
  if (!is_finite(mass) || !is_finite(centre) || !is_finite(gravity) || !is_finite(inertia.lambda))
    throw NotFinite("heavy top: mass, inertia, centre of mass or gravity");
  if (mass < S(0)) throw OutsideDomain("heavy top", "the mass must not be negative", to_double(mass), 0);
  HeavyTop<S> const top{mass, inertia, centre, gravity};
  if (!is_finite(top.lever())) throw NotFinite("heavy top: weight times centre of mass");
  S const scale = magnitude(inertia.lambda), rounding = inertia_tolerance<S>() * scale;
  S share(0);
  for (int i = 0; i < 3; ++i) {
    if (inertia.lambda[i] < S(0))
      throw UnphysicalInertia("heavy top", "no Lambda_i of a body in space is negative; Lambda_" + std::to_string(i + 1) + " in units of the largest",
                              to_double(S(inertia.lambda[i] / scale)), 0);
    share += mass * (centre[i] / (inertia.lambda[i] + rounding)) * centre[i];
  }
  if (!(share <= S(1)))
    throw UnphysicalInertia("heavy top", "inertia about the fixed point must be at least that of the whole mass at its centre; m sum chi_i^2/Lambda_i",
                            to_double(share), 1);
  return top;
}

/// A body with known inertia about its centre of mass, held at a point on one of its principal axes there: \f$\Lambda_i\f$ grows by \f$m\chi_i^2\f$.
///
/// @param about_centre  inertia about the centre of mass; a flat body, with a \f$\Lambda_i\f$ of zero, is one
/// @param centre        centre of mass from the fixed point, with one component that is not zero, or none
/// @throws OutsideDomain  where the centre is on no axis: the principal axes at the fixed point are others then (\ref held_anywhere finds them)
template <Real S>
HeavyTop<S> held_at_a_point(S const& mass, Inertia<3, S> const& about_centre, Eigen::Matrix<S, 3, 1> const& centre, Eigen::Matrix<S, 3, 1> const& gravity) {
  if (!is_finite(mass) || !is_finite(centre)) throw NotFinite("heavy top: mass or centre of mass");
  int off = -1;
  for (int i = 0; i < 3; ++i) off += centre[i] != S(0);
  if (off > 0)
    throw OutsideDomain("heavy top", "the fixed point must lie on a principal axis through the centre of mass; components of the way beside it", off, 0);
  if (mass < S(0)) throw OutsideDomain("heavy top", "the mass must not be negative", to_double(mass), 0);
  return heavy_top(mass, inertia_from_lambda<3, S>(about_centre.lambda + mass * centre.cwiseProduct(centre)), centre, gravity);
}

/// A top, and the frame that it is described in.
struct TurnedHeavyTop {
  HeavyTop<double> top;  ///< in the frame of its principal axes at the fixed point
  Eigen::Matrix3d axes;  ///< these axes as columns, in the frame that everything was given in; a rotation
};
/// A body held at any point of it.
///
/// @param tensor  inertia about the centre of mass, 3 by 3, symmetric, in any body frame
/// @param centre  centre of mass from the fixed point, in that frame
/// @throws NotFinite, OutsideDomain, UnphysicalInertia  as \ref heavy_top and \ref principal_inertia
inline TurnedHeavyTop held_anywhere(double mass, Eigen::Matrix3d const& tensor, Eigen::Vector3d const& centre, Eigen::Vector3d const& gravity) {
  if (!is_finite(mass) || !is_finite(centre)) throw NotFinite("heavy top: mass or centre of mass");
  if (mass < 0) throw OutsideDomain("heavy top", "the mass must not be negative", mass, 0);
  principal_inertia(tensor);  // refuses what is no inertia of a body
  auto const [inertia, axes] = principal_inertia(tensor + mass * (centre.squaredNorm() * Eigen::Matrix3d::Identity() - centre * centre.transpose()));
  return {heavy_top<double>(mass, inertia, axes.transpose() * centre, gravity), axes};
}

/// The state of a top that is let go with attitude g and body velocity xi.
template <Real S>
HeavyTopState<S> release(HeavyTop<S> const& top, Element<SO<3>, S> const& g, Velocity<SO<3>, S> const& xi) {
  return {body_momentum(top.inertia, xi), g.value.transpose() * top.vertical()};
}

// Discrete Lagrangians l(f, Gamma), Gamma before the step, for the general road.

/// Chords: \f$\ell(f, \Gamma) = \tfrac1h\mathrm{Tr}((1-f)\Lambda) - \tfrac h2\langle p, \Gamma + f\Gamma\rangle\f$, energy x time. The kinetic part
/// is that of Moser and Veselov.
/// @param h  step, time; not zero
/// @throws OutsideDomain, NotFinite  where it is zero, or no number
template <Real S>
auto trace_lagrangian(HeavyTop<S> const& top, S const& h) {
  if (!is_finite(h)) throw NotFinite("heavy top: step");
  if (h == S(0)) throw OutsideDomain("heavy top", "the step must differ from zero", 0, 0);
  return [lambda = top.inertia.lambda, p = top.lever(), h](auto const& f, auto const& gamma) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    Eigen::Matrix<T, 3, 1> const after = f.value * gamma;
    T sum(0);
    for (int i = 0; i < 3; ++i) sum += (T(1) - f.value(i, i)) * (lambda[i] / h) - (gamma[i] + after[i]) * (p[i] * h / S(2));
    return sum;
  };
}
/// Arcs: \f$\ell(f, \Gamma) = \tfrac1{2h}\langle I\log f, \log f\rangle - h\langle p, f^{1/2}\Gamma\rangle\f$, the Lagrangian in the natural chart,
/// half way between the places.
/// @param h  step, time; positive
/// @throws OutsideDomain, NotFinite  where it is not positive, or no number
template <Real S>
auto natural_chart_lagrangian(HeavyTop<S> const& top, S const& h) {
  if (!is_finite(h)) throw NotFinite("heavy top: step");
  if (!(h > S(0))) throw OutsideDomain("heavy top", "a step in the natural chart must be positive", to_double(h), 0);
  return [inertia = top.inertia, p = top.lever(), h](auto const& f, auto const& gamma) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    auto const turn = log(f);
    Eigen::Matrix<T, 3, 1> const between = exp(turn / T(2)).value * gamma;
    T sum = kinetic_energy(inertia, turn) / T(h);
    for (int i = 0; i < 3; ++i) sum -= between[i] * S(p[i] * h);
    return sum;
  };
}

/// Weights of a symmetric composition of steps of second order that has the order asked for, by Suzuki's fractals: five steps for each two orders more.
///
/// \f$s, s, 1-4s, s, s\f$ with \f$s = 1/(4-4^{1/(p+1)})\f$ takes order p to p + 2. Steps back in time are shorter than those of the triple jump.
/// @param order  2, 4, 6 or 8
/// @throws OutsideDomain  for another
template <Real S>
std::vector<S> symmetric_composition(int order) {
  if (order < 2 || order > 8 || order % 2) throw OutsideDomain("symmetric composition", "the order must be 2, 4, 6 or 8", order, order < 2 ? 2 : 8);
  using std::pow;
  std::vector<S> weights{S(1)};
  for (int p = 2; p < order; p += 2) {
    S const outer = S(1) / (S(4) - S(pow(S(4), S(S(1) / S(p + 1))))), inner = S(1) - S(4) * outer;
    std::vector<S> composed;
    for (S const& s : {outer, outer, inner, outer, outer})
      for (S const& w : weights) composed.push_back(s * w);
    weights = std::move(composed);
  }
  return weights;
}

/// The scheme of \ref trace_lagrangian, in closed form but for the relative motion: half of the impulse of gravity, a step of Moser and Veselov's,
/// the other half.
///
/// Exactly conserved, at every step length and order: \f$|\Gamma|\f$ and \f$\langle\Pi,\Gamma\rangle\f$; for a symmetric top with its centre of mass
/// on the axis of symmetry also the component of \f$\Pi\f$ along that axis, by Noether's theorem: the trace does not change when f is conjugated by a
/// rotation that commutes with \f$\Lambda\f$. Energy is not.
template <Real S = double>
class HeavyTopScheme {
 public:
  using Place = Element<SO<3>, S>;        ///< of the attitude (body to space), and of the relative motion
  using State = HeavyTopState<S>;         ///< momentum and vertical
  using Vector = Eigen::Matrix<S, 3, 1>;  ///< of 3-space

  /// @param top    the body
  /// @param step   h, time; negative steps go back in time
  /// @param order  2, or 4, 6, 8 by \ref symmetric_composition of 5, 25, 125 steps
  /// @throws NotFinite, OutsideDomain  where the step is no number, or zero; where there is no such order
  HeavyTopScheme(HeavyTop<S> top, S step, int order = 2) : top_(std::move(top)), step_(step), order_(order) {
    if (!is_finite(step)) throw NotFinite("heavy top: step");
    if (step == S(0)) throw OutsideDomain("heavy top", "the step must differ from zero", 0, 0);
    for (S const& weight : symmetric_composition<S>(order))
      stages_.push_back({MoserVeselov<3, S>(top_.inertia, weight * step), top_.lever() * S(weight * step / S(2))});
  }

  /// The body.
  HeavyTop<S> const& top() const { return top_; }
  S step() const { return step_; }

  /// One step of momentum and vertical.
  /// @throws StepTooLong  where there is no solution, with a step that would do from there; the state stays what it was
  /// @throws NotFinite    where the state is no number
  void advance(State& state) const {
    move(state, [](Place const&) {});
  }
  /// The same, and the attitude with it. Attitude and vertical are carried along by the same relative motions, and stay consistent to rounding.
  void advance(State& state, Place& attitude) const {
    Place g = attitude;
    move(state, [&](Place const& f) { g = MoserVeselov<3, S>::reconstruct(g, f); });
    attitude = g;
  }

 private:
  struct Stage {
    MoserVeselov<3, S> drift;
    Vector kick;  // half of the step times p
  };

  template <class Visit>
  void move(State& state, Visit const& visit) const {
    if (!is_finite(state.momentum.components) || !is_finite(state.vector)) throw NotFinite("heavy top: momentum or vertical");
    State next = state;
    try {
      for (Stage const& stage : stages_) visit(pass(stage, next));
    } catch (StepTooLong const&) {
      throw StepTooLong("heavy top", std::abs(to_double(step_)), step_that_does(state));
    }
    state = next;
  }

  /// One step of second order. Momentum and vertical turn alike, and a short step changes them by a small sum instead of a rounded whole.
  static Place pass(Stage const& stage, State& s) {
    auto const kick = [&] { s.momentum.components += cross(s.vector, stage.kick); };
    // [heavy_top_step]
    kick();
    Place const f = stage.drift.relative_motion(s.momentum).value;
    s.momentum = stage.drift.carry(f, s.momentum);
    s.vector = stage.drift.carry(f, {f.group, s.vector}).components;
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

/// The element of SE(3) by whose coadjoint action a step of second order moves momentum and vertical:
/// \f$(\Pi_1, \Gamma_1) = \mathrm{Ad}^*_{k^{-1}}(\Pi_0, \Gamma_0)\f$.
///
/// Here \f$k = s\,f\,s\f$ with the shift s by \f$-\tfrac h2p\f$: the impulse of gravity is a shift of the semidirect product, and the Casimirs cannot change.
/// @param f  the relative motion of the step
template <Real S>
Element<SE<3>, S> step_as_motion(HeavyTop<S> const& top, S const& h, Element<SO<3>, S> const& f) {
  Element<SE<3>, S> shift = identity<S>(SE<3>{}), turn = shift;
  shift.value.template topRightCorner<3, 1>() = top.lever() * S(-h / S(2));
  turn.value.template topLeftCorner<3, 3>() = f.value;
  return shift * turn * shift;
}

// Two tops that are known by name.

/// A top and the body velocity it is let go with, standing as its body frame does in space.
template <Real S>
struct KnownTop {
  HeavyTop<S> top;          ///< the body
  Velocity<SO<3>, S> spin;  ///< body velocity, 1/time
};

/// The benchmark of Brüls and Cardona: a disc of 15 kg on an arm of 1 m that turns about the arm at 150 rad/s. SI units.
///
/// About its centre of mass the disc is flat exactly, \f$I_2 = I_1 + I_3\f$.
template <Real S>
KnownTop<S> bruls_cardona_top() {
  using Vector = Eigen::Matrix<S, 3, 1>;
  auto const disc = inertia_from_moments<S>(Vector(ratio<S>(15, 64), ratio<S>(15, 32), ratio<S>(15, 64)));
  return {held_at_a_point<S>(S(15), disc, Vector(S(0), S(1), S(0)), Vector(S(0), S(0), ratio<S>(-981, 100))),
          velocity(SO<3>{}, Vector(S(0), S(150), ratio<S>(-461538, 100000)))};
}
/// Kovalevskaya's top: \f$I_1 = I_2 = 2I_3\f$, centre of mass in the plane of equal moments. In units with \f$I_3 = 1\f$ and weight times arm 1. It
/// has a fourth integral, \f$|(\Omega_1 + i\Omega_2)^2 - (\Gamma_1 + i\Gamma_2)|^2\f$.
template <Real S>
KnownTop<S> kovalevskaya_top() {
  using Vector = Eigen::Matrix<S, 3, 1>;
  return {heavy_top<S>(S(1), inertia_from_moments<S>(Vector(S(2), S(2), S(1))), Vector(ratio<S>(1, 2), S(0), S(0)), Vector(S(0), S(0), S(-2))),
          velocity(SO<3>{}, Vector(ratio<S>(1, 2), ratio<S>(1, 3), ratio<S>(7, 5)))};
}

}  // namespace actio
