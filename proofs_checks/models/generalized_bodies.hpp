// Generalized rigid bodies, their relative motions and exact motions of the Moser-Veselov scheme: for the
// checks of section 5.2, 5.3 and chapter 1.
//
// Momenta are those of the scaled Lagrangian Tr(f Lambda), as the thesis has them: h times the physical ones.
// They are written out as matrices here and nowhere taken from the classes that the checks judge.
//
// Rotations are rational by Cayley's transform. A motion is not solved for: (5.7) is linear in Lambda, so the
// relative motions are drawn first and a body is found that moves like this. Its Lambda is symmetric but not
// diagonal: the frame of the body is not that of its principal axes, which no statement here needs.
#pragma once

#include <string>
#include <vector>

#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "claim.hpp"

namespace actio::checks {

using Turns = SO<Dynamic>;
template <class S>
using Turn = Element<Turns, S>;
template <class S>
using BodyMomentum = Momentum<Turns, S>;
template <class S>
using BodyVelocity = Velocity<Turns, S>;

inline std::string name_of(int n) { return "SO(" + std::to_string(n) + ")"; }
/// Calls `visit(n, name)` for n = 3, 4, 5 at several random points: SO(3) alone would hide what SO(4) and
/// SO(5) show about Casimirs and indices.
template <class S, class Visit>
void over_bodies(Claim<S> const&, Visit const& visit) {
  for (int n = 3; n <= 5; ++n) visit(n, name_of(n));
}

/// \f$\Lambda\f$ of a body in its principal frame: diagonal, no two entries alike.
template <class S>
Matrix<S> draw_inertia(Draw& draw, int n) {
  Matrix<S> lambda = Matrix<S>::Zero(n, n);
  for (int i = 0; i < n; ++i) lambda(i, i) = ratio<S>(i + 1, 2) + draw.number<S>() * ratio<S>(1, 8);
  return lambda;
}
/// \f$\Lambda_i+\Lambda_j\f$ by coordinates.
template <class S>
Vector<S> moments_of(Matrix<S> const& lambda) {
  Vector<S> moments(lambda.rows() * (lambda.rows() - 1) / 2);
  over_planes(static_cast<int>(lambda.rows()),
              [&](int a, int i, int j) { moments[a] = lambda(i, i) + lambda(j, j); });
  return moments;
}
/// A velocity that turns in every plane: each coordinate between a quarter of `size` and all of it, with
/// either sign. So no control is near its zero by chance.
template <class S>
BodyVelocity<S> draw_turning(Draw& draw, int n, S const& size = S(1)) {
  Turns const group{n};
  BodyVelocity<S> xi{group, Vector<S>(group.dimension())};
  for (int a = 0; a < group.dimension(); ++a)
    xi.coordinates[a] = (S(5) + S(3) * draw.number<S>()) * (draw.below(2) == 0 ? size : S(-size)) / S(8);
  return xi;
}
/// A rotation by Cayley's transform of such a velocity.
template <class S>
Turn<S> draw_turn(Draw& draw, int n, S const& size = ratio<S>(3, 4)) {
  return retract(draw_turning<S>(draw, n, size));
}

/// \f$f^T\Lambda - \Lambda f\f$, the momentum before the step, and \f$\Lambda f^T - f\Lambda\f$, the momentum
/// after it.
template <class S>
Matrix<S> before(Matrix<S> const& lambda, Turn<S> const& f) {
  return f.value.transpose() * lambda - lambda * f.value;
}
template <class S>
Matrix<S> after(Matrix<S> const& lambda, Turn<S> const& f) {
  return lambda * f.value.transpose() - f.value * lambda;
}
/// \f$a\,m\,a^T\f$.
template <class S>
Matrix<S> turned(Turn<S> const& a, Matrix<S> const& m) { return a.value * m * a.value.transpose(); }
/// A skew matrix as a momentum, and back.
template <class S>
BodyMomentum<S> as_momentum(Matrix<S> const& m) {
  Turns const group{static_cast<int>(m.rows())};
  return {group, group.vee(m)};
}
template <class S>
Matrix<S> as_matrix(BodyMomentum<S> const& mu) { return mu.group.hat(mu.components); }

/// \f$\ell(f) = \mathrm{Tr}(f\Lambda)\f$, scaled as in the thesis: the physical one is -1/h of it, up to a
/// constant.
template <class S>
struct TraceLagrangian {
  Matrix<S> lambda;
  S factor = S(1);

  template <class T>
  T operator()(Element<Turns, T> const& f) const {
    T sum(0);
    for (Index i = 0; i < lambda.rows(); ++i)
      for (Index j = 0; j < lambda.cols(); ++j) sum += f.value(i, j) * T(S(lambda(j, i) * factor));
    return sum;
  }
};
/// Another discrete Lagrangian of the same body, by Cayley's chart in place of the logarithm:
/// \f$\ell(f) = \tfrac12\xi^TA\xi\f$ with \f$f = \mathrm{cay}(\xi)\f$. A control: it preserves the Casimirs
/// of its own bracket and nothing else.
template <class S>
struct ChartLagrangian {
  Matrix<S> a;

  template <class T>
  T operator()(Element<Turns, T> const& f) const {
    Vector<T> const xi = f.group.vee(inverse_cayley(f.value));
    T sum(0);
    for (Index i = 0; i < xi.size(); ++i)
      for (Index j = 0; j < xi.size(); ++j) sum += xi[i] * xi[j] * T(S(a(i, j) / S(2)));
    return sum;
  }
};

/// Three relative motions and four attitudes of one motion of the scheme.
template <class S>
struct ExactMotion {
  Matrix<S> lambda;        ///< symmetric, largest entry 1
  std::vector<Turn<S>> f;  ///< f_{10}, f_{21}, f_{32}
  std::vector<Turn<S>> g;  ///< g_0, ..., g_3

  int last() const { return static_cast<int>(f.size()); }
  /// \f$\omega_k = f_{k,k-1}\f$, k = 1, 2, 3.
  Turn<S> const& omega(int k) const { return f[k - 1]; }
  /// \f$M_k\f$, the body momentum at \f$g_{k-1}\f$.
  Matrix<S> body(int k) const { return before(lambda, omega(k)); }
};

/// A motion that is its own mirror image in time: with the reflection P in the last axis and
/// \f$P\Lambda P = \Lambda\f$ the sequence \f$f,\; PR,\; Pf^TP\f$ satisfies (5.7) twice if it does once, for
/// any rotation f and any reflection R. That is a linear system for \f$\Lambda\f$, which has one solution up
/// to a factor.
template <class S>
ExactMotion<S> draw_motion(Draw& draw, int n) {
  Matrix<S> p = Matrix<S>::Identity(n, n);
  p(n - 1, n - 1) = S(-1);
  Vector<S> v = draw.vector<S>(n) * ratio<S>(1, 4);
  v[n - 1] += S(1);
  Matrix<S> const reflection = Matrix<S>::Identity(n, n) - v * v.transpose() * S(S(2) / v.dot(v));
  Turns const group{n};
  ExactMotion<S> motion{{}, {draw_turn<S>(draw, n), {group, p * reflection}, {}}, {draw_turn<S>(draw, n)}};
  motion.f[2] = {group, p * motion.f[0].value.transpose() * p};

  // The last entry of the diagonal is 1; solve for the block above it.
  auto const left = [&](Matrix<S> const& lambda) {
    return as_momentum(Matrix<S>(before(lambda, motion.f[1]) - after(lambda, motion.f[0]))).components;
  };
  Matrix<S> lambda = Matrix<S>::Zero(n, n), columns(group.dimension(), group.dimension());
  lambda(n - 1, n - 1) = S(1);
  Vector<S> const right = left(lambda);
  auto const over_block = [&](auto const& visit) {
    for (int i = 0, a = 0; i < n - 1; ++i)
      for (int j = i; j < n - 1; ++j, ++a) visit(a, i, j);
  };
  over_block([&](int a, int i, int j) {
    Matrix<S> one = Matrix<S>::Zero(n, n);
    one(i, j) = one(j, i) = S(1);
    columns.col(a) = left(one);
  });
  Vector<S> const entries = solve_linear(columns, right, "draw_motion");
  over_block([&](int a, int i, int j) { lambda(i, j) = lambda(j, i) = -entries[a]; });
  motion.lambda = lambda / magnitude(lambda);
  for (auto const& f : motion.f) motion.g.push_back({group, motion.g.back().value * f.value.transpose()});
  return motion;
}
/// By how much rounding in the terms of a designed motion is magnified: its body solves up to ten equations,
/// by elimination with row exchanges, whose residual is some ten roundings of the largest entry.
inline constexpr double designed = 10;
/// Two things that a designed motion makes equal, one less the other: to be measured against Lambda, whose
/// largest entry is 1. Its momenta are differences of terms of that size.
template <class X>
auto gap(X const& a, X const& b) {
  if constexpr (requires { (a - b).eval(); })
    return (a - b).eval();
  else
    return a - b;
}

/// The rank of a matrix, by elimination: exact, so over the rationals only.
template <class S>
int exact_rank(Matrix<S> a) {
  int rank = 0;
  for (Index column = 0; column < a.cols() && rank < a.rows(); ++column) {
    Index pivot = rank;
    while (pivot < a.rows() && a(pivot, column) == 0) ++pivot;
    if (pivot == a.rows()) continue;
    a.row(pivot).swap(a.row(rank));
    for (Index i = rank + 1; i < a.rows(); ++i) {
      S const factor = a(i, column) / a(rank, column);
      for (Index j = column; j < a.cols(); ++j) a(i, j) -= factor * a(rank, j);
    }
    ++rank;
  }
  return rank;
}
/// The differentials of several functions of a momentum, one in each row.
template <class S, class F>
Matrix<S> differentials(F const& functions, BodyMomentum<S> const& mu) {
  int const d = mu.group.dimension();
  Matrix<S> rows;
  over_batches(d, [&](int first) {
    auto moved = over<Moved<S>>(mu);
    for (int a = 0; a < batch && first + a < d; ++a) moved.components[first + a].part[a] = S(1);
    auto const values = functions(moved);
    if (first == 0) rows.resize(values.size(), d);
    store_parts(rows, values, first);
  });
  return rows;
}
/// The differentials of several functions on the group, translated on the right, one in each row.
template <class S, class F>
Matrix<S> right_differentials(F const& functions, Turn<S> const& f) {
  int const d = f.group.dimension();
  Matrix<S> rows;
  over_batches(d, [&](int first) {
    auto const values = functions(moved_left(f, first));
    if (first == 0) rows.resize(values.size(), d);
    store_parts(rows, values, first);
  });
  return rows;
}

}  // namespace actio::checks
