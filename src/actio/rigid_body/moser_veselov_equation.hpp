// The equation that a step of the Moser-Veselov scheme has to solve: f^T Lambda - Lambda f = P for the
// relative motion f, P = hM given.
//
// There are many solutions, up to a certain size of P; the one wanted grows out of the identity as P grows
// from zero. Newton's method on the group finds it from a guess that is near, and along a growing P where
// none is; the spectrum of f^T Lambda tells whether it is the right one.
#pragma once

#include "actio/groups/solve.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "actio/rigid_body/inertia.hpp"

namespace actio {

/// \f$f^T\Lambda - \Lambda f = P\f$, for one body.
template <int n, Real S>
class MoserVeselovEquation {
 public:
  using Rotation = Element<SO<n>, S>;  ///< of the relative motion
  using Matrix = Storage<SO<n>, S>;
  using Vector = Coordinates<SO<n>, S>;  ///< of P

  MoserVeselovEquation(SO<n> group, actio::Matrix<S, n, 1> lambda, Vector moments)
      : group_(group), lambda_(std::move(lambda)), moments_(std::move(moments)) {}

  /// \f$f = 1 - h\xi\f$ and so on, with \f$J\xi = M\f$: right to second order in the step.
  Rotation first_guess(Vector const& goal) const {
    Vector turn = -goal.cwiseQuotient(moments_);
    shorten(turn);
    return moved(actio::identity<S>(group_), turn);
  }

  /// Newton's method for the relative motion with momentum `goal`, from where `found` is.
  bool newton(Vector const& goal, Solved<Rotation>& found) const {
    auto const& group = group_;
    Report& report = found.report;
    // Residuals in each plane in units of what a turn by 1 makes there: as angles. A rounding error in an
    // entry of f off the diagonal is one of the largest angle; four of them are allowed.
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

      // At the identity the derivative is J: a division. Where that gains too little, solve with the
      // derivative where we are. Many digits take many divisions: solve after sixteen of them.
      steep = steep || (!done && iteration > 0 && (iteration > 16 || size > before / 3));
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

  /// The solution for `goal` along a growing right side, as far as it goes.
  struct Continued {
    Solved<Rotation> found;  ///< where the way ended
    S reached;               ///< the part of the goal that has a solution; 1 where all is well
    Report last;             ///< of the iteration that failed
  };
  Continued continued(Vector const& goal) const {
    Continued way{{actio::identity<S>(group_), {}}, S(0), {}};
    // Go as far as Newton follows; halve the way where it does not.
    S ahead(1);
    while (way.reached < S(1)) {
      S const next = way.reached + ahead < S(1) ? S(way.reached + ahead) : S(1);
      Solved<Rotation> trial = way.found;
      if (newton(Vector(goal * next), trial) && on_branch_of_identity(trial.value)) {
        way.found = trial, way.reached = next, ahead *= S(2);
      } else {
        way.last = trial.report, ahead /= S(2);
        if (to_double(ahead) > 1e-8 * to_double(way.reached)) continue;
        if (to_double(ahead) < 1e-300 || way.reached > S(0)) break;
      }
    }
    return way;
  }

  /// Whether any two eigenvalues of \f$f^T\Lambda\f$ have a sum with positive real part.
  bool on_branch_of_identity(Rotation const& f) const {
    actio::Matrix<double, n, n> const x =
        (f.value.transpose() * lambda_.asDiagonal()).unaryExpr([](S const& v) { return to_double(v); });
    // A positive definite symmetric part settles it, and is cheap.
    if (positive_definite(x + x.transpose())) return true;
    actio::Vector<double> const real = real_parts_of_eigenvalues(x);
    // At the end of the branch two solutions meet like the roots of a square: nearer than the root of a
    // rounding error they are one.
    return real[0] + real[1] > -1e-7 * magnitude(x);
  }

  /// The determinant, by elimination with row exchanges.
  static double determinant(Rotation const& f) {
    actio::Matrix<double, n, n> a = f.value.unaryExpr([](S const& v) { return to_double(v); });
    double product = 1;
    for (Index k = 0; k < a.rows(); ++k) {
      Index pivot = k;
      for (Index i = k + 1; i < a.rows(); ++i)
        if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
      if (pivot != k) a.row(k).swap(a.row(pivot)), product = -product;
      product *= a(k, k);
      if (product == 0) return 0;
      for (Index i = k + 1; i < a.rows(); ++i)
        a.row(i).tail(a.cols() - k) -= a.row(k).tail(a.cols() - k) * (a(i, k) / a(k, k));
    }
    return product;
  }

 private:
  /// Cuts a rotation vector down to length 1/2, so that \ref moved stays near the group and Newton near the
  /// branch. Whether it had to.
  static bool shorten(Vector& turn) {
    using std::sqrt;
    S const square = turn.squaredNorm();
    if (!(square > S(1) / S(4))) return false;
    turn /= S(2) * sqrt(square);
    return true;
  }

  /// \f$f\,(1 + \vartheta + \vartheta^2/2)\f$ brought back on the group.
  static Rotation moved(Rotation const& f, Vector const& turn) {
    auto const theta = f.group.hat(turn);
    Matrix one_and = theta + theta * theta / S(2);
    one_and.diagonal().array() += S(1);
    Rotation next{f.group, f.value * one_and};
    // The excess of the series, of fourth order, is squared each time; the last time takes the rounding of
    // the product away.
    for (double excess = std::pow(to_double(turn.squaredNorm()), 2) / 4; excess > 1e-8; excess *= excess)
      next = restore(next);
    return restore(next);
  }

  /// \f$|\Lambda_i|+|\Lambda_j|\f$ of each plane.
  Vector planes() const {
    Vector sums(moments_.size());
    over_planes(static_cast<int>(lambda_.size()),
                [&](int a, int i, int j) { sums[a] = magnitude(lambda_[i]) + magnitude(lambda_[j]); });
    return sums;
  }

  /// How \f$X - X^T\f$, \f$X = f^T\Lambda = p^T\f$, falls when f moves to \f$f e^\vartheta\f$:
  /// \f$\vartheta\mapsto\vartheta X + X^T\vartheta\f$ in coordinates.
  auto derivative(Matrix const& p) const {
    int const d = group_.dimension(), size = static_cast<int>(p.rows());
    actio::Matrix<S, SO<n>::dim, SO<n>::dim> k(d, d);
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

  /// By the pivots of the elimination.
  static bool positive_definite(actio::Matrix<double, n, n> a) {
    for (Index k = 0; k < a.rows(); ++k) {
      if (!(a(k, k) > 0)) return false;
      for (Index i = k + 1; i < a.rows(); ++i) {
        double const factor = a(i, k) / a(k, k);
        for (Index j = k + 1; j < a.rows(); ++j) a(i, j) -= factor * a(k, j);
      }
    }
    return true;
  }

  SO<n> group_;
  actio::Matrix<S, n, 1> lambda_;
  Vector moments_;
};

}  // namespace actio
