// The Moser-Veselov scheme of the generalized rigid body on SO(n), any n (thesis, section 5.2).
//
// The discrete Lagrangian is an action with physical momentum, L(g0, g1) = Tr((1 - f) Lambda)/h with the relative motion f = g1^T g0, which is near
// 1 - h xi; up to the constant Tr(Lambda)/h it is -Tr(g0 Lambda g1^T)/h. Its body momentum before the step and after it:
//
//     h M0 = f^T Lambda - Lambda f,        h M1 = Lambda f^T - f Lambda = f (h M0) f^T.
//
// The scheme is these two lines. With X = f^T Lambda the first one reads X - X^T = h M0, X^T X = Lambda^2; the relative motion wanted is the one that
// grows out of the identity with the step, and it is told from the others by the spectrum of X: any two eigenvalues have a sum with positive real
// part (for Lambda >= 0: the spectrum is in the right half plane). Up to a certain step there is exactly one such f, beyond it none.
#pragma once

#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "actio/rigid_body/inertia.hpp"
#include "actio/rigid_body/largest_step.hpp"

namespace actio {

/// The Moser-Veselov scheme for one body and one step.
template <int n, Real S = double>
class MoserVeselov {
 public:
  using Place = Element<SO<n>, S>;         ///< of the attitude (body to space), and of the relative motion
  using BodyMomentum = Momentum<SO<n>, S>;
  using Matrix = Storage<SO<n>, S>;

  /// @param inertia  of the body
  /// @param step     h, time; negative steps go back in time
  /// @throws NotFinite, OutsideDomain  where the step is no number, or zero
  MoserVeselov(Inertia<n, S> inertia, S step) : inertia_(std::move(inertia)), step_(step) {
    using std::frexp, std::ldexp;
    if (!is_finite(step)) throw NotFinite("Moser-Veselov: step");
    if (step == S(0)) throw OutsideDomain("Moser-Veselov", "the step must differ from zero", 0, 0);
    // Work in units of a power of two near the largest moment: nothing is rounded, and bodies of any size look alike.
    int exponent = 0;
    frexp(magnitude(inertia_.moments), &exponent);
    unit_ = ldexp(S(1), exponent);
    lambda_ = inertia_.lambda / unit_;
    moments_ = inertia_.moments / unit_;
  }

  Inertia<n, S> const& inertia() const { return inertia_; }
  S step() const { return step_; }

  /// The reduced discrete Lagrangian \f$\ell(f) = \tfrac1h\mathrm{Tr}((1-f)\Lambda)\f$, energy x time: for the general road.
  auto lagrangian() const {
    return [lambda = inertia_.lambda, h = step_](auto const& f) {
      using T = typename std::decay_t<decltype(f)>::Scalar;
      T sum(0);
      for (Eigen::Index i = 0; i < lambda.size(); ++i) sum += (T(1) - f.value(i, i)) * lambda[i];
      return T(sum / h);
    };
  }

  /// Body momentum with which a step with relative motion f begins: \f$M_0 = (f^T\Lambda - \Lambda f)/h\f$.
  BodyMomentum momentum_before(Place const& f) const {
    Matrix const p = inertia_.lambda.asDiagonal() * f.value;
    return {f.group, f.group.vee((p.transpose() - p).eval()) / step_};
  }
  /// Body momentum with which it ends: \f$M_1 = (\Lambda f^T - f\Lambda)/h\f$.
  BodyMomentum momentum_after(Place const& f) const {
    Matrix const p = f.value * inertia_.lambda.asDiagonal();
    return {f.group, f.group.vee((p.transpose() - p).eval()) / step_};
  }

  /// The relative motion of the step that begins with body momentum `pi`: solves \f$f^T\Lambda - \Lambda f = hM\f$ on the branch of the identity.
  ///
  /// Newton's method from the guess \f$1-h\xi\f$; where that fails, along a growing step.
  /// Accuracy: residual in each plane within 4 epsilon times \f$|\Lambda_i|+|\Lambda_j|\f$ times the largest angle of the step; 16 times that where rounding prevents it.
  /// @throws NotFinite     where the momentum is no number
  /// @throws StepTooLong   where there is no solution, with the largest step that would do
  Solved<Place> relative_motion(BodyMomentum const& pi) const { return relative_motion(pi, first_guess(scaled(pi))); }

  /// The same from a guess that is near, such as the relative motion of the step before.
  /// @throws OutsideDomain  where the guess is no rotation
  Solved<Place> relative_motion(BodyMomentum const& pi, Place const& near) const {
    auto const goal = scaled(pi);
    // Newton moves by rotations: what begins as a reflection stays one.
    require_finite(near.value, "Moser-Veselov: relative motion");
    if (double const det = determinant(near); !(det > 0)) throw OutsideDomain("Moser-Veselov", "the relative motion to start from must be a rotation; its determinant", det, 1);
    Solved<Place> found{near, {}};
    if (newton(goal, found) && on_branch_of_identity(found.value)) return found;
    return continued(pi, goal);
  }

  /// DEP: the relative motion after `f10`. Solves \f$f_{21}^T\Lambda - \Lambda f_{21} = \Lambda f_{10}^T - f_{10}\Lambda\f$. \implements{eq_5_7}
  /// @throws StepTooLong  where there is no solution, with the largest step that would do for this momentum
  Solved<Place> step_euler_poincare(Place const& f10) const {
    return relative_motion(momentum_after(f10), f10);
  }

  /// DLP: the body momentum after a step with relative motion f, \f$M_1 = f M_0 f^T\f$. \implements{eq_5_8}
  static BodyMomentum carry(Place const& f, BodyMomentum const& pi) {
    Matrix const m = pi.group.hat(pi.components), e = less_identity(f);
    // f M f^T with f = 1 + e, so that a short step changes M by a small sum instead of a rounded whole.
    Matrix const em = e * m;
    // [eq_5_8]
    return {pi.group, pi.components + pi.group.vee((em + m * e.transpose() + em * e.transpose()).eval())};
    // [eq_5_8]
  }
  /// The attitude after g and a step with relative motion f: \f$g_1 = g_0f^{-1}\f$.
  static Place reconstruct(Place const& g, Place const& f) {
    return restore(Place{g.group, g.value + g.value * less_identity(f).transpose()});
  }
  /// DLP: the body momentum after `pi`, with the relative motion found from it.
  BodyMomentum step_lie_poisson(BodyMomentum const& pi) const { return carry(relative_motion(pi).value, pi); }

  /// DEL: the attitude after g0, g1. Only \f$g_1^Tg_0\f$ matters: \f$g_2 = g_1f_{21}^{-1}\f$. \implements{claim_5_2_reconstruction}
  Place step_euler_lagrange(Place const& g0, Place const& g1) const {
    return reconstruct_left(g1, step_euler_poincare(relative_motion_left(g0, g1)).value);
  }

  /// What is left of the DEP equation (5.7), matrices in coordinates: zero along motions.
  BodyMomentum residual(Place const& f10, Place const& f21) const {
    // [eq_5_7]
    return momentum_before(f21) - momentum_after(f10);
    // [eq_5_7]
  }

  /// The largest step for which a motion with body momentum `pi` exists. Infinite at rest.
  double longest_step(BodyMomentum const& pi) const { return largest_step(inertia_, pi); }

 private:
  /// \f$e = f - 1\f$, with \f$1 + e\f$ orthogonal to the rounding of e. That of f, which next to 1 is larger, would pull at the Casimirs in every
  /// step in the same direction: a drift in proportion to the time.
  static Matrix less_identity(Place const& f) {
    Matrix e = f.value;
    e.diagonal().array() -= S(1);
    Matrix const excess = e + e.transpose() + e.transpose() * e;
    return e - (excess + e * excess) / S(2);
  }

  using Vector = Coordinates<SO<n>, S>;

  /// h M in the working unit.
  Vector scaled(BodyMomentum const& pi) const {
    if (pi.components.size() != moments_.size())
      throw OutsideDomain("Moser-Veselov", "a momentum with a component for each moment of inertia is needed; components", static_cast<double>(pi.components.size()),
                          static_cast<double>(moments_.size()));
    if (!is_finite(pi.components)) throw NotFinite("Moser-Veselov: body momentum");
    Vector const goal = pi.components / unit_ * step_;
    if (!is_finite(goal)) throw NotFinite("Moser-Veselov: step times body momentum over inertia");
    return goal;
  }

  /// \f$f = 1 - h\xi\f$ and so on, with \f$J\xi = M\f$: right to second order in the step.
  Place first_guess(Vector const& goal) const {
    Vector turn = -goal.cwiseQuotient(moments_);
    shorten(turn);
    return moved(actio::identity<S>(inertia_.group), turn);
  }

  /// Cuts a rotation vector down to length 1/2, so that \ref moved stays near the group and Newton near the branch. Whether it had to.
  static bool shorten(Vector& turn) {
    using std::sqrt;
    S const square = turn.squaredNorm();
    if (!(square > S(1) / S(4))) return false;
    turn /= S(2) * sqrt(square);
    return true;
  }

  /// \f$f\,(1 + \vartheta + \vartheta^2/2)\f$ brought back on the group.
  static Place moved(Place const& f, Vector const& turn) {
    auto const theta = f.group.hat(turn);
    Matrix one_and = theta + theta * theta / S(2);
    one_and.diagonal().array() += S(1);
    Place next{f.group, f.value * one_and};
    // The excess of the series, of fourth order, is squared each time; the last time takes the rounding of the product away.
    for (double excess = std::pow(to_double(turn.squaredNorm()), 2) / 4; excess > 1e-8; excess *= excess) next = restore(next);
    return restore(next);
  }

  /// Newton's method for the relative motion with momentum `goal`, from where `found` is.
  bool newton(Vector const& goal, Solved<Place>& found) const {
    auto const& group = inertia_.group;
    Report& report = found.report;
    // Residuals in each plane in units of what a turn by 1 makes there: as angles. A rounding error in an entry of f off the diagonal is one of the largest
    // angle; four of them are allowed.
    Vector const unit = planes();
    report = {0, {}, 4 * to_double(epsilon<S>()) * to_double(magnitude(goal.cwiseQuotient(moments_)))};
    bool steep = false;  // whether the last update, by the derivative at the identity, did well enough
    for (int iteration = 0; iteration < 100; ++iteration) {
      Matrix const p = lambda_.asDiagonal() * found.value.value;
      Vector const residual = group.vee((p.transpose() - p).eval()) - goal;
      double const size = to_double(magnitude(residual.cwiseQuotient(unit).eval()));
      double const before = report.residuals.empty() ? size : report.residuals.back();
      report.residuals.push_back(size);
      ++report.evaluations;
      if (!std::isfinite(size)) return false;
      bool const done = size <= report.tolerance || (size <= 16 * report.tolerance && size > before / 2);

      // At the identity the derivative is J: a division. Where that gains too little, solve with the derivative where we are.
      steep = steep || (!done && iteration > 0 && size > before / 3);
      Vector turn;
      if (steep) {
        try {
          turn = solve_linear(derivative(p), residual, "Moser-Veselov: derivative of the momentum");
        } catch (Singular const&) {
          return false;
        }
      } else {
        turn = residual.cwiseQuotient(moments_);
      }
      steep = shorten(turn) || steep;
      // The last update costs no evaluation: rounding remains, but no bias.
      found.value = moved(found.value, turn);
      if (done) return true;
    }
    return false;
  }

  /// \f$|\Lambda_i|+|\Lambda_j|\f$ of each plane.
  Vector planes() const {
    Vector sums(moments_.size());
    over_planes(static_cast<int>(lambda_.size()), [&](int a, int i, int j) { sums[a] = magnitude(lambda_[i]) + magnitude(lambda_[j]); });
    return sums;
  }

  /// How \f$X - X^T\f$, \f$X = f^T\Lambda = p^T\f$, falls when f moves to \f$f e^\vartheta\f$: \f$\vartheta\mapsto\vartheta X + X^T\vartheta\f$ in coordinates.
  auto derivative(Matrix const& p) const {
    int const d = inertia_.group.dimension(), size = static_cast<int>(p.rows());
    Eigen::Matrix<S, SO<n>::dim, SO<n>::dim> k(d, d);
    over_planes(size, [&](int b, int q, int r) {
      over_planes(size, [&](int a, int i, int j) {
        S entry(0);
        if (i == q) entry += p(j, r);
        if (i == r) entry -= p(j, q);
        if (j == r) entry += p(i, q);
        if (j == q) entry -= p(i, r);
        k(a, b) = entry;
      });
    });
    return k;
  }

  /// Whether any two eigenvalues of \f$f^T\Lambda\f$ have a sum with positive real part.
  bool on_branch_of_identity(Place const& f) const {
    Eigen::Matrix<double, n, n> const x = (f.value.transpose() * lambda_.asDiagonal()).unaryExpr([](S const& v) { return to_double(v); });
    // A positive definite symmetric part settles it, and is cheap.
    if (positive_definite(x + x.transpose())) return true;
    Eigen::VectorXd const real = real_parts_of_eigenvalues(x);
    // At the end of the branch two solutions meet like the roots of a square: nearer than the root of a rounding error they are one.
    return real[0] + real[1] > -1e-7 * magnitude(x);
  }

  /// The determinant, by elimination with row exchanges.
  static double determinant(Place const& f) {
    Eigen::Matrix<double, n, n> a = f.value.unaryExpr([](S const& v) { return to_double(v); });
    double product = 1;
    for (Eigen::Index k = 0; k < a.rows(); ++k) {
      Eigen::Index pivot = k;
      for (Eigen::Index i = k + 1; i < a.rows(); ++i)
        if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
      if (pivot != k) a.row(k).swap(a.row(pivot)), product = -product;
      product *= a(k, k);
      if (product == 0) return 0;
      for (Eigen::Index i = k + 1; i < a.rows(); ++i) a.row(i).tail(a.cols() - k) -= a.row(k).tail(a.cols() - k) * (a(i, k) / a(k, k));
    }
    return product;
  }

  /// By the pivots of the elimination.
  static bool positive_definite(Eigen::Matrix<double, n, n> a) {
    for (Eigen::Index k = 0; k < a.rows(); ++k) {
      if (!(a(k, k) > 0)) return false;
      for (Eigen::Index i = k + 1; i < a.rows(); ++i) {
        double const factor = a(i, k) / a(k, k);
        for (Eigen::Index j = k + 1; j < a.rows(); ++j) a(i, j) -= factor * a(k, j);
      }
    }
    return true;
  }

  /// The relative motion along a growing step, or the reason why there is none.
  Solved<Place> continued(BodyMomentum const& pi, Vector const& goal) const {
    // Where a Lambda_i is negative there is no closed form for the longest step: go as far as the branch goes.
    bool const closed_form = !(lambda_.minCoeff() < S(0));
    double const h = std::abs(to_double(step_)), longest = closed_form ? longest_step(pi) : std::numeric_limits<double>::infinity();
    if (h > longest) throw StepTooLong("Moser-Veselov", h, longest);
    Solved<Place> found{actio::identity<S>(inertia_.group), {}};
    Report last;
    // Go as far as Newton follows; halve the way where it does not.
    S reached(0), way(1);
    while (reached < S(1)) {
      S const next = reached + way < S(1) ? S(reached + way) : S(1);
      Solved<Place> trial = found;
      if (newton(Vector(goal * next), trial) && on_branch_of_identity(trial.value)) {
        found = trial, reached = next, way *= S(2);
      } else {
        last = trial.report, way /= S(2);
        if (to_double(way) > 1e-8 * to_double(reached)) continue;
        if (!closed_form && reached > S(0)) throw StepTooLong("Moser-Veselov", h, h * to_double(reached));
        if (to_double(way) < 1e-300 || reached > S(0)) throw NotConverged("Moser-Veselov", last.residuals, last.tolerance);
      }
    }
    return found;
  }

  Inertia<n, S> inertia_;
  S step_, unit_;
  Eigen::Matrix<S, n, 1> lambda_;
  Vector moments_;
};

/// A free body on its way: attitude, body momentum, and the relative motion of the last step, which is where the solver looks first.
template <int n, Real S = double>
struct BodyInMotion {
  Element<SO<n>, S> attitude;        ///< body to space
  Momentum<SO<n>, S> body_momentum;  ///< energy x time
  Element<SO<n>, S> last;            ///< the relative motion of the last step

  /// The momentum in space: \f$\mathrm{Ad}^*_{g^{-1}}\,\Pi\f$, as the matrix \f$gMg^T\f$ in coordinates. Constant along the motion.
  Momentum<SO<n>, S> spatial_momentum() const { 
    return {attitude.group, attitude.group.vee((attitude.value * attitude.group.hat(body_momentum.components) * attitude.value.transpose()).eval())};
  }
};

/// One step: relative motion from momentum, momentum carried along, attitude reconstructed.
template <int n, Real S>
void advance(MoserVeselov<n, S> const& scheme, BodyInMotion<n, S>& body) {
  body.last = scheme.relative_motion(body.body_momentum, body.last).value;
  body.body_momentum = scheme.carry(body.last, body.body_momentum);
  body.attitude = scheme.reconstruct(body.attitude, body.last);
}

/// A body that is let go with attitude g and body velocity xi.
template <int n, Real S>
BodyInMotion<n, S> release(Inertia<n, S> const& inertia, Element<SO<n>, S> const& g, Velocity<SO<n>, S> const& xi) {
  return {g, body_momentum(inertia, xi), identity<S>(inertia.group)};
}

}  // namespace actio
