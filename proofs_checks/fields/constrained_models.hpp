// Constrained fields whose sections and variations are known in closed form, so that Hamilton's principle on
// the constrained sections can be written down without a multiplier and compared with what a multiplier
// gives.
//
// Nothing is integrated: an integrand is compared with another one up to the divergence of fields that vanish
// with the variation on the boundary. All models are polynomials, and every identity holds off shell.
#pragma once

#include "fields/fields.hpp"

#include "actio/constraints/constrained_equations.hpp"

namespace actio::checks {

/// The sum of two fields, the second one times a number or a dual number.
template <class A, class B, class T>
struct SumOfFields {
  A field;
  B added;
  T by;
  template <class V>
  auto operator()(V const& x) const {
    using R = ScalarOf<V>;
    auto const y = field(x);
    auto const w = added(x);
    std::remove_cvref_t<decltype(y)> sum;
    for (int a = 0; a < y.size(); ++a) sum[a] = y[a] + w[a] * R(by);
    return sum;
  }
};
template <class A, class B, class T>
SumOfFields<A, B, T> sum_of(A const& field, B const& added, T const& by) { return {field, added, by}; }
/// A point over dual numbers, and a field moved along another one by their infinitesimal.
template <class S, int rows>
Matrix<Dual<S>, rows, 1> at_dual(Matrix<S, rows, 1> const& x) { return x.template cast<Dual<S>>(); }
template <class S, class A, class B>
auto moved_field(A const& field, B const& added) { return sum_of(field, added, variable(S(0))); }

/// The derivative of a constraint at a point when the section moves along w.
template <class S, int rows, class Phi, class A, class C>
auto rates_of_constraint(Phi const& constraint, A const& phi, C const& w, Matrix<S, rows, 1> const& x) {
  return rate_of(induced_constraint(constraint, moved_field<S>(phi, w))(at_dual(x)));
}
/// The same of its first component.
template <class S, int rows, class Phi, class A, class C>
S rate_of_constraint(Phi const& constraint, A const& phi, C const& w, Matrix<S, rows, 1> const& x) {
  return rates_of_constraint(constraint, phi, w, x)[0];
}
/// The derivative of a density at a point when the section moves along w.
template <class S, int rows, class L, class A, class C>
S rate_of_density(L const& density, A const& phi, C const& w, Matrix<S, rows, 1> const& x) {
  return density(first_jet(moved_field<S>(phi, w), at_dual(x))).part[0];
}
/// The divergence of a field on space-time, without its component `held` where one is named.
template <class S, int rows, class Field>
S divergence_of(Field const& field, Matrix<S, rows, 1> const& x, int held = -1) {
  auto const d = derivative(field, x);
  S sum(0);
  for (int mu = 0; mu < rows; ++mu)
    if (mu != held) sum += d.matrix(mu, mu);
  return sum;
}
/// What the integration by parts of a variation leaves at the boundary: \f$p_a{}^\mu\,\delta\phi^a\f$.
template <class L, class Phi, class W>
auto boundary_part(L const& density, Phi const& phi, W const& w) {
  return [=]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    Matrix<T, rows, 1> const part = partial_v(density, first_jet(phi, x)).transpose() * w(x);
    return part;
  };
}

/// The derivative of a cubic in its variable k.
template <class S, int m, class V>
auto slope_of(Cubic<S, m> const& c, V const& x, int k) {
  using T = ScalarOf<V>;
  T b(0), d(0), e(0);
  for (int i = 0; i < m; ++i) b += x[i] * T(c.b[i]), d += x[i] * T(c.d[i]), e += x[i] * T(c.e[i]);
  return T(T(c.a[k]) + b * T(c.d[k]) + d * T(c.b[k]) + e * e * T(S(c.e[k] * S(3))));
}
/// A cubic as a field with one component.
template <class S, int n>
struct CubicField {
  Cubic<S, n + 1> c;
  template <class V>
  auto operator()(V const& x) const { return Matrix<ScalarOf<V>, 1, 1>(c(x)); }
};

// ---- One field is a function of the other: w = F(x, u, du).

/// The constraint w = F(x, u, du) on fields (u, w), with any cubic F.
template <class S, int n>
struct FieldGraph {
  static constexpr int components = 1, variables = 2 * n + 3;
  Cubic<S, variables> F;

  /// The point of space-time, u and its derivatives in one column.
  template <class T>
  static Matrix<T, variables, 1> arguments(Event<T, n> const& x, T const& u, Event<T, n> const& slopes) {
    Matrix<T, variables, 1> all;
    all << x, Matrix<T, 1, 1>(u), slopes;
    return all;
  }
  template <class T, int N>
  static Matrix<T, variables, 1> arguments(Jet<T, n, N> const& j) {
    return arguments(j.x, j.y[0], Event<T, n>(j.v.row(0).transpose()));
  }
  template <class T>
  Matrix<T, 1, 1> operator()(Jet<T, n, 2> const& j) const {
    return Matrix<T, 1, 1>(j.y[1] - F(arguments(j)));
  }
  /// \f$\partial F/\partial u\f$ and \f$\partial F/\partial u_\mu\f$ at a jet.
  template <class T, int N>
  Matrix<T, n + 2, 1> slopes(Jet<T, n, N> const& j) const {
    auto const at = arguments(j);
    Matrix<T, n + 2, 1> all;
    for (int k = 0; k < n + 2; ++k) all[k] = slope_of(F, at, n + 1 + k);
    return all;
  }
  /// The same constraint without the derivative in one coordinate: with 0, that in time.
  FieldGraph without(int mu) const {
    FieldGraph still = *this;
    for (auto* c : {&still.F.a, &still.F.b, &still.F.d, &still.F.e}) (*c)[n + 2 + mu] = S(0);
    return still;
  }
};
template <class S, int n>
FieldGraph<S, n> draw_field_graph(Draw& draw) { return {draw_cubic<S, 2 * n + 3>(draw, ratio<S>(1, 2))}; }

/// A section that satisfies the constraint: u is any, and w is what it must be.
template <class S, int n, class U>
struct OnGraph {
  FieldGraph<S, n> Phi;
  U u;
  template <class V>
  auto operator()(V const& x) const {
    auto const j = first_jet(u, x);
    return Matrix<ScalarOf<V>, 2, 1>(j.y[0], Phi.F(Phi.arguments(j)));
  }
};
template <class S, int n, class U>
OnGraph<S, n, U> on_graph(FieldGraph<S, n> const& Phi, U const& u) { return {Phi, u}; }

/// Three principles at a point of space-time: what each of them leaves of the derivative of the action, once
/// divergences are taken off that integrate to boundary terms of a variation which vanishes there.
template <class S>
struct Principles {
  S restricted;  ///< Hamilton's principle along the sections that satisfy the constraint
  S multiplier;  ///< (7.2) with the multiplier that is found from one of its equations
  /// work of the free equations on displacements that are possible at a held coordinate: time
  S virtual_work;
};

/// The multiplier that makes the equation of w hold: the constraint is w - F, so it is \f$E_w\f$.
template <class L, class Phi>
auto multiplier_on_graph(L const& density, Phi const& phi) {
  return [=]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    return Matrix<T, 1, 1>(euler_lagrange(density, phi, x)[1]);
  };
}
/// A displacement of (u, w) that is possible while a coordinate is held, when u is displaced by eta: the
/// derivative of eta in this coordinate does not count, the others do. The coordinate is the time but for a
/// reader who exchanges it with another one; with -1 none is held.
template <class S, int n, class Phi, class Eta>
auto virtual_displacement(FieldGraph<S, n> const& graph, Phi const& phi, Eta const& eta, int held = 0) {
  return [=]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    auto const slopes = graph.slopes(first_jet(phi, x));
    auto const moved = first_jet(eta, x);
    T w = slopes[0] * moved.y[0];
    for (int mu = 0; mu <= n; ++mu)
      if (mu != held) w += slopes[mu + 1] * moved.v(0, mu);
    return Matrix<T, 2, 1>(moved.y[0], w);
  };
}
/// The three principles at x for the section over u, varied along eta.
template <class S, int n, class L>
Principles<S> principles_on_graph(L const& density, FieldGraph<S, n> const& graph, CubicField<S, n> const& u,
                                  CubicField<S, n> const& eta, Event<S, n> const& x, int held = 0) {
  auto const phi = on_graph(graph, u);
  auto const lambda = multiplier_on_graph(density, phi);
  auto const moved = on_graph(graph, moved_field<S>(u, eta));
  // How the section moves, and the fields that integrations by parts leave at the boundary.
  auto const change = virtual_displacement(graph, phi, eta, -1);
  auto const from_graph = [&]<class T, int rows>(Matrix<T, rows, 1> const& at) {
    Matrix<T, rows, 1> const part =
        graph.slopes(first_jet(phi, at)).template tail<n + 1>() * T(lambda(at)[0] * eta(at)[0]);
    return part;
  };
  Matrix<S, 2, 1> const E = euler_lagrange(density, phi, x),
                        rest = E - reaction(graph, second_jet(phi, x), first_jet(lambda, x));
  return {S(density(first_jet(moved, at_dual(x))).part[0] -
            divergence_of(boundary_part(density, phi, change), x) - divergence_of(from_graph, x)),
          S(rest[0] * eta(x)[0]),
          S(E.dot(virtual_displacement(graph, phi, eta, held)(x)) - divergence_of(from_graph, x, held))};
}

// ---- No field is a function of the other: curves in the plane that sweep area at a given rate.

/// A curve of the second degree in the last coordinate s, with coefficients that change with time where there
/// is one (n = 1), and its derivatives along itself.
template <class S, int n>
struct PlaneCurve {
  Matrix<S, 2, 3> start, change;
  template <class V>
  auto coefficients(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, 2, 3> c = start.template cast<T>();
    if constexpr (n > 0) c += change.template cast<T>() * x[0];
    return c;
  }
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    auto const c = coefficients(x);
    return Matrix<T, 2, 1>(c.col(0) + (c.col(1) + c.col(2) * x[n]) * x[n]);
  }
  template <class V>
  auto slope(V const& x) const {
    auto const c = coefficients(x);
    return Matrix<ScalarOf<V>, 2, 1>(c.col(1) + c.col(2) * (x[n] + x[n]));
  }
  template <class V>
  auto bend(V const& x) const {
    auto const c = coefficients(x);
    return Matrix<ScalarOf<V>, 2, 1>(c.col(2) + c.col(2));
  }
};
/// \f$[a, b] = a_1b_2 - a_2b_1\f$.
template <class T>
T area(Matrix<T, 2, 1> const& a, Matrix<T, 2, 1> const& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The constraint \f$[r, r_s] = \rho(x)\f$, where \f$\rho\f$ is that of a given curve. Neither component of r
/// is a function of the other, and the constraint is not linear.
template <class S, int n>
struct ArealRate {
  static constexpr int components = 1;
  PlaneCurve<S, n> r;

  template <class V>
  auto rho(V const& x) const { return area(r(x), r.slope(x)); }
  template <class T>
  Matrix<T, 1, 1> operator()(Jet<T, n, 2> const& j) const {
    return Matrix<T, 1, 1>(area(j.y, Matrix<T, 2, 1>(j.v.col(n))) - rho(j.x));
  }
  /// Every variation that keeps the constraint, by a function b: \f$\rho b\,r_s - (\rho_sb + \tfrac12\rho
  /// b_s)\,r\f$.
  auto variation(Cubic<S, n + 1> const& b) const {
    return [self = *this, b]<class T, int rows>(Matrix<T, rows, 1> const& x) {
      T const rate = self.rho(x), rate_s = area(self.r(x), self.r.bend(x));
      T const along = rate_s * b(x) + rate * slope_of(b, x, n) / T(2);
      return Matrix<T, 2, 1>(self.r.slope(x) * T(rate * b(x)) - self.r(x) * along);
    };
  }
  /// The multiplier of the equations contracted with r: \f$\lambda = E\cdot r/(2\rho)\f$.
  template <class L>
  auto multiplier(L const& density) const {
    return [self = *this, density]<class T, int rows>(Matrix<T, rows, 1> const& x) {
      return Matrix<T, 1, 1>(euler_lagrange(density, self.r, x).dot(self.r(x)) / (self.rho(x) * T(2)));
    };
  }
};
template <class S, int n>
ArealRate<S, n> draw_areal_rate(Draw& draw) {
  auto const matrix = [&] {
    Matrix<S, 2, 3> m;
    for (int i = 0; i < 6; ++i) m(i % 2, i / 2) = draw.number<S>() * ratio<S>(1, 5);
    return m;
  };
  PlaneCurve<S, n> r{matrix(), matrix()};
  r.start(0, 0) += S(1), r.start(1, 1) += S(1);
  return {r};
}
/// The three principles at x for the curve of the constraint, varied along what b makes.
template <class S, int n, class L>
Principles<S> principles_of_areal_rate(L const& density, ArealRate<S, n> const& Phi, Cubic<S, n + 1> const& b,
                                       Event<S, n> const& x) {
  auto const change = Phi.variation(b);
  auto const lambda = Phi.multiplier(density);
  auto const from_constraint = [&]<class T, int rows>(Matrix<T, rows, 1> const& at) {
    Matrix<T, rows, 1> part = Matrix<T, rows, 1>::Zero();
    T const rate = Phi.rho(at);
    part[n] = -lambda(at)[0] * rate * rate * b(at);
    return part;
  };
  Matrix<S, 2, 1> const E = euler_lagrange(density, Phi.r, x),
                        rest = E - reaction(Phi, second_jet(Phi.r, x), first_jet(lambda, x));
  S const at_ends = divergence_of(from_constraint, x);
  return {S(rate_of_density(density, Phi.r, change, x) -
            divergence_of(boundary_part(density, Phi.r, change), x) - at_ends),
          S(rest.dot(Phi.r.slope(x)) * Phi.rho(x) * b(x)), S(E.dot(change(x)) - at_ends)};
}

}  // namespace actio::checks
