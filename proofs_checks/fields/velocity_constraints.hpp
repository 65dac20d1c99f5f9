// Constraints that are linear or affine in the velocities of finitely many coordinates, with random
// polynomials for coefficients: time is the only coordinate of the base, n = 0.
#pragma once

#include "fields/constrained_models.hpp"

namespace actio::checks {

/// k constraints \f$\omega_i(q)\cdot\dot q + \beta_i(q) = 0\f$ on m coordinates.
template <class S, int m, int k>
struct VelocityConstraint {
  static constexpr int components = k;
  std::array<std::array<Cubic<S, m>, m>, k> omega;
  std::array<Cubic<S, m>, k> beta;

  /// The one-forms at a point, in rows.
  template <class V>
  auto rows(V const& q) const {
    Matrix<ScalarOf<V>, k, m> w;
    for (int i = 0; i < k; ++i)
      for (int a = 0; a < m; ++a) w(i, a) = omega[i][a](q);
    return w;
  }
  template <class V>
  auto drift(V const& q) const {
    Matrix<ScalarOf<V>, k, 1> b;
    for (int i = 0; i < k; ++i) b[i] = beta[i](q);
    return b;
  }
  template <class T>
  Matrix<T, k, 1> operator()(Jet<T, 0, m> const& j) const {
    Matrix<T, k, 1> const value = rows(j.y) * j.v + drift(j.y);
    return value;
  }
  /// \f$d(\omega_i\cdot\dot q + \beta_i)\f$ contracted with the velocity, in rows:
  /// \f$(\partial_a\omega_{ib} - \partial_b\omega_{ia})\,\dot q^b + \partial_a\beta_i\f$.
  Matrix<S, k, m> turned(Matrix<S, m, 1> const& q, Matrix<S, m, 1> const& velocity) const {
    Matrix<S, k, m> w;
    for (int i = 0; i < k; ++i)
      for (int a = 0; a < m; ++a) {
        w(i, a) = slope_of(beta[i], q, a);
        for (int b = 0; b < m; ++b)
          w(i, a) += (slope_of(omega[i][b], q, a) - slope_of(omega[i][a], q, b)) * velocity[b];
      }
    return w;
  }
};
template <class S, int m, int k>
VelocityConstraint<S, m, k> draw_velocity_constraint(Draw& draw, bool affine) {
  VelocityConstraint<S, m, k> Phi;
  for (int i = 0; i < k; ++i) {
    for (int a = 0; a < m; ++a) Phi.omega[i][a] = draw_cubic<S, m>(draw, ratio<S>(1, 2));
    // Near the last coordinates, so that the forms are independent by far.
    Phi.omega[i][m - k + i].constant += S(2);
    Phi.beta[i] = draw_cubic<S, m>(draw, S(affine ? 1 : 0));
  }
  return Phi;
}

/// A second jet of a motion.
template <class S, int m>
SecondJet<S, 0, m> jet_of_motion(S const& t, Matrix<S, m, 1> const& q, Matrix<S, m, 1> const& velocity,
                                 Matrix<S, m, 1> const& acceleration) {
  SecondJet<S, 0, m> j;
  j.x = Event<S, 0>(t), j.y = q, j.v = velocity, j.w[0] = acceleration;
  return j;
}
/// A first jet of a multiplier.
template <class S, int k>
Jet<S, 0, k> jet_of_multiplier(S const& t, Matrix<S, k, 1> const& lambda, Matrix<S, k, 1> const& rate) {
  return {Event<S, 0>(t), lambda, rate};
}

/// The accelerations that keep a constraint and solve \f$E = \lambda\cdot(d\omega(\dot q)) -
/// \nu\cdot\omega\f$, with the unknown numbers \f$\nu\f$ behind them. For \f$\lambda = 0\f$ this is the
/// principle of Lagrange and d'Alembert, with the reaction \f$-\nu\f$; elsewhere \f$\nu = \dot\lambda\f$
/// makes it the vakonomic one.
template <class S, int m, int k, class L>
Matrix<S, m + k, 1> acceleration_under(L const& density, VelocityConstraint<S, m, k> const& Phi, S const& t,
                                       Matrix<S, m, 1> const& q, Matrix<S, m, 1> const& velocity,
                                       Matrix<S, k, 1> const& lambda) {
  using V = Matrix<S, m, 1>;
  V const none = V::Zero();
  auto const E = [&](V const& a) { return V(euler_lagrange(density, jet_of_motion(t, q, velocity, a))); };
  auto const kept = [&](V const& a) {
    Matrix<S, k, 1> const rate = total_derivative(
        0, [&](auto const& j) { return Phi(j); }, jet_of_motion(t, q, velocity, a));
    return rate;
  };
  Matrix<S, m + k, m + k> system = Matrix<S, m + k, m + k>::Zero();
  Matrix<S, m + k, 1> right;
  right.template head<m>() = Phi.turned(q, velocity).transpose() * lambda - E(none);
  right.template tail<k>() = -kept(none);
  for (int a = 0; a < m; ++a) {
    V const unit = V::Unit(a);
    system.col(a).template head<m>() = E(unit) - E(none);
    system.col(a).template tail<k>() = kept(unit) - kept(none);
  }
  system.template block<m, k>(0, m) = Phi.rows(q).transpose();
  return solve_linear(system, right, "acceleration_under");
}
/// A velocity that satisfies the constraint: the last k components follow from the others.
template <class S, int m, int k>
Matrix<S, m, 1> allowed_velocity(VelocityConstraint<S, m, k> const& Phi, Matrix<S, m, 1> const& q,
                                 Matrix<S, m, 1> velocity) {
  velocity.template tail<k>().setZero();
  Matrix<S, k, m> const w = Phi.rows(q);
  Matrix<S, k, 1> const left = -(w * velocity + Phi.drift(q));
  Matrix<S, k, k> const last = w.template rightCols<k>();
  velocity.template tail<k>() = solve_linear(last, left, "allowed_velocity");
  return velocity;
}

/// A Lagrangian of finitely many coordinates that is neither quadratic nor even: a cubic in time, place and
/// velocity, and a product of velocities besides. Regular near velocities of size one.
template <class S, int m>
struct AnyMechanics {
  Cubic<S, 2 * m + 1> l;
  template <class T>
  T operator()(Jet<T, 0, m> const& j) const {
    T square(0);
    for (int a = 0; a < m; ++a) square += j.v(a, 0) * j.v(a, 0);
    return square * T(2) + l(coordinates(j));
  }
};
template <class S, int m>
AnyMechanics<S, m> draw_mechanics(Draw& draw) { return {draw_cubic<S, 2 * m + 1>(draw, ratio<S>(1, 4))}; }

/// The curve \f$p + p's + bs^2\f$ in R^m.
template <class S, int m>
auto parabola(Matrix<S, m, 1> const& p, Matrix<S, m, 1> const& rate, Matrix<S, m, 1> const& bend) {
  return [=]<class T>(Matrix<T, 1, 1> const& s) {
    return Matrix<T, m, 1>(p.template cast<T>() +
                           (rate.template cast<T>() + bend.template cast<T>() * s[0]) * s[0]);
  };
}

/// Hamilton's principle on the curves that satisfy a constraint on velocities is (7.2), off shell: along a
/// variation that keeps the constraint the integrand changes by what (7.2) leaves, up to the rate of boundary
/// terms. The last k components of the variation follow from the others, which are free; the multiplier makes
/// the last k equations hold.
template <class S, int m, int k>
void restrict_to_allowed_curves(Claim<S>& claim, Draw& draw, bool affine, std::string const& name) {
  using V = Matrix<S, m, 1>;
  auto const L = draw_mechanics<S, m>(draw);
  auto const Phi = draw_velocity_constraint<S, m, k>(draw, affine);
  V const q = draw.vector<S, V>(m) / S(2), v = allowed_velocity(Phi, q, draw.vector<S, V>(m)),
          a = draw.vector<S, V>(m), w = draw.vector<S, V>(m), straight = V::Zero();
  V w_rate = draw.vector<S, V>(m);
  auto const curve = parabola<S, m>(q, v, a);
  Event<S, 0> const now(S(0));
  auto const change_of_constraint = [&](V const& rate) {
    return Matrix<S, k, 1>(rates_of_constraint(Phi, curve, parabola<S, m>(w, rate, straight), now));
  };
  Matrix<S, k, k> const last = Phi.rows(q).template rightCols<k>();
  w_rate.template tail<k>() -=
      solve_linear(last, change_of_constraint(w_rate), "a variation that is allowed");
  auto const variation = parabola<S, m>(w, w_rate, straight);
  auto const lambda = parabola<S, k>(draw.vector<S, Matrix<S, k, 1>>(k), draw.vector<S, Matrix<S, k, 1>>(k),
                                     Matrix<S, k, 1>::Zero());
  auto const paired = [&]<class T>(Matrix<T, 1, 1> const& s) {
    Matrix<T, k, 1> const work = Phi.rows(curve(s)) * variation(s);
    return Matrix<T, 1, 1>(work.dot(lambda(s)));
  };
  V const left = -constrained_field_equations(L, Phi, second_jet(curve, now), first_jet(lambda, now));
  S const changed =
      rate_of_density(L, curve, variation, now) - divergence_of(boundary_part(L, curve, variation), now);
  // Two solutions of small systems, and derivatives of cubics of cubics.
  double const condition = 100;
  claim.zero("the variation keeps the constraint", name, change_of_constraint(w_rate), S(1), condition);
  claim.equal("change of the action on allowed curves, and (7.2)", name,
              S(changed + divergence_of(paired, now)), left.dot(w), condition);
  // Virtual work pairs the free equations with w, and asks for w in the kernel of the constraint.
  claim.differs("virtual work in place of the restriction", name, changed, left.dot(w));
}

}  // namespace actio::checks
