// The Moser-Veselov scheme of the generalized rigid body on SO(n), any n (thesis, section 5.2).
//
// The discrete Lagrangian is an action with physical momentum, L(g0, g1) = Tr((1 - f) Lambda)/h with the
// relative motion f = g1^T g0, which is near 1 - h xi; up to the constant Tr(Lambda)/h it is -Tr(g0 Lambda
// g1^T)/h. Its body momentum before the step and after it:
//
//     h M0 = f^T Lambda - Lambda f,        h M1 = Lambda f^T - f Lambda = f (h M0) f^T.
//
// The scheme is these two lines. With X = f^T Lambda the first one reads X - X^T = h M0, X^T X = Lambda^2;
// the relative motion wanted is the one that grows out of the identity with the step, and it is told from the
// others by the spectrum of X: any two eigenvalues have a sum with positive real part (for Lambda >= 0: the
// spectrum is in the right half plane). Up to a certain step there is exactly one such f, beyond it none.
#pragma once

#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/rigid_body/largest_step.hpp"
#include "actio/rigid_body/moser_veselov_equation.hpp"

namespace actio {

/// The Moser-Veselov scheme for one body and one step.
///
/// \snippet bodies.cpp moser_veselov
template <int n, Real S = double>
class MoserVeselov {
 public:
  using Rotation = Element<SO<n>, S>;  ///< of the attitude (body to space), and of the relative motion
  using BodyMomentum = Momentum<SO<n>, S>;
  using Matrix = Storage<SO<n>, S>;

  /// @param inertia  of the body
  /// @param step     h, time; negative steps go back in time
  /// @throws NotFinite, OutsideDomain  where the step is no number, or zero
  MoserVeselov(Inertia<n, S> inertia, S step)
      : inertia_(std::move(inertia)),
        step_(step),
        unit_(working_unit(inertia_)),
        equation_(inertia_.group, inertia_.lambda / unit_, inertia_.moments / unit_) {
    if (!is_finite(step)) throw NotFinite("Moser-Veselov: step");
    if (step == S(0)) throw OutsideDomain("Moser-Veselov", "the step must differ from zero", 0, 0);
  }

  Inertia<n, S> const& inertia() const { return inertia_; }
  S step() const { return step_; }

  /// The reduced discrete Lagrangian \f$\ell(f) = \tfrac1h\mathrm{Tr}((1-f)\Lambda)\f$, energy x time: for
  /// the generic implementation.
  auto lagrangian() const {
    return [lambda = inertia_.lambda, h = step_](auto const& f) {
      using T = typename std::decay_t<decltype(f)>::Scalar;
      T sum(0);
      for (Index i = 0; i < lambda.size(); ++i) sum += (T(1) - f.value(i, i)) * lambda[i];
      return T(sum / h);
    };
  }

  /// Body momentum with which a step with relative motion f begins: \f$M_0 = (f^T\Lambda - \Lambda f)/h\f$.
  BodyMomentum momentum_before(Rotation const& f) const {
    Matrix const p = inertia_.lambda.asDiagonal() * f.value;
    return {f.group, f.group.vee((p.transpose() - p).eval()) / step_};
  }
  /// Body momentum with which it ends: \f$M_1 = (\Lambda f^T - f\Lambda)/h\f$.
  BodyMomentum momentum_after(Rotation const& f) const {
    Matrix const p = f.value * inertia_.lambda.asDiagonal();
    return {f.group, f.group.vee((p.transpose() - p).eval()) / step_};
  }

  /// The relative motion of the step that begins with body momentum `pi`: solves
  /// \f$f^T\Lambda - \Lambda f = hM\f$ on the branch of the identity.
  ///
  /// Newton's method from the guess \f$1-h\xi\f$; where that fails, along a growing step.
  /// Accuracy: residual in each plane within 4 epsilon times \f$|\Lambda_i|+|\Lambda_j|\f$ times the largest
  /// angle of the step; 16 times that where rounding prevents it.
  /// @throws NotFinite     where the momentum is no number
  /// @throws StepTooLong   where there is no solution, with the largest step that would do
  Solved<Rotation> relative_motion(BodyMomentum const& pi) const {
    return relative_motion(pi, equation_.first_guess(scaled(pi)));
  }

  /// The same from a guess that is near, such as the relative motion of the step before.
  /// @throws OutsideDomain  where the guess is no rotation
  Solved<Rotation> relative_motion(BodyMomentum const& pi, Rotation const& near) const {
    auto const goal = scaled(pi);
    // Newton moves by rotations: what begins as a reflection stays one.
    require_finite(near.value, "Moser-Veselov: relative motion");
    if (double const det = equation_.determinant(near); !(det > 0))
      throw OutsideDomain("Moser-Veselov",
                          "the relative motion to start from must be a rotation; its determinant", det, 1);
    Solved<Rotation> found{near, {}};
    if (equation_.newton(goal, found) && equation_.on_branch_of_identity(found.value)) return found;
    return continued(pi, goal);
  }

  /// DEP: the relative motion after `f10`. Solves \f$f_{21}^T\Lambda - \Lambda f_{21} = \Lambda
  /// f_{10}^T - f_{10}\Lambda\f$. \implements{eq_5_7}
  /// @throws StepTooLong  where there is no solution, with the largest step that would do for this momentum
  Solved<Rotation> step_euler_poincare(Rotation const& f10) const {
    return relative_motion(momentum_after(f10), f10);
  }

  /// DLP: the body momentum after a step with relative motion f, \f$M_1 = f M_0 f^T\f$. \implements{eq_5_8}
  static BodyMomentum transport(Rotation const& f, BodyMomentum const& pi) {
    Matrix const M0 = pi.group.hat(pi.components);
    // [eq_5_8]
    Matrix const M1 = f.value * M0 * f.value.transpose();
    // [eq_5_8]
    return {pi.group, pi.group.vee(M1)};
  }
  /// The same as \f$M_0 + eM_0 + M_0e^T + eM_0e^T\f$ with e = f - 1, which the steps use: a short step adds a
  /// small change, so that the rounding of a step is that of the change and not of the whole.
  static BodyMomentum transport_by_increment(Rotation const& f, BodyMomentum const& pi) {
    Matrix const m = pi.group.hat(pi.components), e = less_identity(f), em = e * m;
    return {pi.group, pi.components + pi.group.vee((em + m * e.transpose() + em * e.transpose()).eval())};
  }
  /// The attitude after g and a step with relative motion f: \f$g_1 = g_0f^{-1}\f$.
  static Rotation reconstruct(Rotation const& g, Rotation const& f) {
    return restore(Rotation{g.group, g.value + g.value * less_identity(f).transpose()});
  }
  /// DLP: the body momentum after `pi`, with the relative motion found from it.
  BodyMomentum step_lie_poisson(BodyMomentum const& pi) const {
    return transport_by_increment(relative_motion(pi).value, pi);
  }

  /// DEL: the attitude after g0, g1. Only \f$g_1^Tg_0\f$ matters: \f$g_2 = g_1f_{21}^{-1}\f$.
  /// \implements{claim_5_2_reconstruction}
  Rotation step_euler_lagrange(Rotation const& g0, Rotation const& g1) const {
    return reconstruct_left(g1, step_euler_poincare(relative_motion_left(g0, g1)).value);
  }

  /// The residual of the DEP equation (5.7), matrices in coordinates: zero along motions.
  BodyMomentum residual(Rotation const& f10, Rotation const& f21) const {
    // [eq_5_7]
    return momentum_before(f21) - momentum_after(f10);
    // [eq_5_7]
  }

  /// The largest step for which a motion with body momentum `pi` exists. Infinite at rest.
  double longest_step(BodyMomentum const& pi) const { return largest_step(inertia_, pi); }

 private:
  /// \f$e = f - 1\f$, with \f$1 + e\f$ orthogonal to the rounding of e. That of f, which next to 1 is larger,
  /// would pull at the Casimirs in every step in the same direction: a drift in proportion to the time.
  static Matrix less_identity(Rotation const& f) {
    Matrix e = f.value;
    e.diagonal().array() -= S(1);
    Matrix const excess = e + e.transpose() + e.transpose() * e;
    return e - (excess + e * excess) / S(2);
  }

  using Vector = Coordinates<SO<n>, S>;

  /// h M in the working unit.
  Vector scaled(BodyMomentum const& pi) const {
    if (pi.components.size() != inertia_.moments.size())
      throw OutsideDomain(
          "Moser-Veselov", "a momentum with a component for each moment of inertia is needed; components",
          static_cast<double>(pi.components.size()), static_cast<double>(inertia_.moments.size()));
    if (!is_finite(pi.components)) throw NotFinite("Moser-Veselov: body momentum");
    Vector const goal = pi.components / unit_ * step_;
    if (!is_finite(goal)) throw NotFinite("Moser-Veselov: step times body momentum over inertia");
    return goal;
  }

  /// The relative motion along a growing step, or the reason why there is none.
  Solved<Rotation> continued(BodyMomentum const& pi, Vector const& goal) const {
    // Where a Lambda_i is negative there is no closed form for the longest step: go as far as the branch
    // goes.
    bool const closed_form = !(inertia_.lambda.minCoeff() < S(0));
    double const h = std::abs(to_double(step_)),
                 longest = closed_form ? longest_step(pi) : std::numeric_limits<double>::infinity();
    if (h > longest) throw StepTooLong("Moser-Veselov", h, longest);
    auto const way = equation_.continued(goal);
    if (way.reached == S(1)) return way.found;
    if (!closed_form && way.reached > S(0)) throw StepTooLong("Moser-Veselov", h, h * to_double(way.reached));
    throw NotConverged("Moser-Veselov", way.last.residuals, way.last.tolerance);
  }

  /// A power of two near the largest moment: dividing by it rounds nothing, and bodies of any size look
  /// alike.
  static S working_unit(Inertia<n, S> const& inertia) {
    using std::frexp, std::ldexp;
    int exponent = 0;
    frexp(magnitude(inertia.moments), &exponent);
    return ldexp(S(1), exponent);
  }

  Inertia<n, S> inertia_;
  S step_, unit_;
  MoserVeselovEquation<n, S> equation_;
};

}  // namespace actio
