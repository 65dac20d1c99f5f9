// A Lagrangian on a group whose motions are polynomials in time, so that actions, flows and pullbacks over
// finite times are exact over the rationals.
//
// On Aff(1), GL(2) and the Heisenberg group the free entries q of a matrix are coordinates. In bent
//   coordinates u(q) the Lagrangian is L = 1/2 u'^T A u' + kappa (s.u')^3 + c.u + d/dt [(w.u)^2 (r.u)] with
//   s.A^-1 c = 0, whose motions are u = u0 + u0' t + A^-1 c t^2/2. It is not quadratic, not even, and as a
//   function on TG invariant under nothing, unless symmetry is asked for. The flow is written out here from
//   that solution; the library never solves anything.
#pragma once

#include <utility>

#include "actio/variational/action.hpp"
#include "models/charts.hpp"

namespace actio::checks {

template <class S>
struct ExactMotions {
  SpannedGroup group;
  std::vector<std::pair<int, int>> entries;  // the free entries
  Vector<S> bend;                            // u_i = q_i + bend_i q_{i-1} q_0
  Matrix<S> a;
  Vector<S> s, c, w, r, fall;  // fall = A^-1 c
  S kappa;

  // Coordinates.

  template <class T>
  Vector<T> read(Matrix<T> const& m) const {
    Vector<T> q(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) q[i] = m(entries[i].first, entries[i].second);
    return q;
  }
  template <class T>
  Element<SpannedGroup, T> configuration(Vector<T> const& q) const {
    Matrix<T> m = Matrix<T>::Identity(group.matrix_size(), group.matrix_size());
    for (std::size_t i = 0; i < entries.size(); ++i) m(entries[i].first, entries[i].second) = q[i];
    return {group, m};
  }
  template <class T>
  Vector<T> straight(Vector<T> const& q) const {
    Vector<T> u = q;
    for (Index i = 1; i < q.size(); ++i) u[i] += q[i - 1] * q[0] * T(bend[i]);
    return u;
  }
  template <class T>
  Vector<T> bent(Vector<T> const& u) const {
    Vector<T> q = u;
    for (Index i = 1; i < u.size(); ++i) q[i] -= q[i - 1] * q[0] * T(bend[i]);
    return q;
  }
  /// The chart of straight coordinates.
  auto chart() const {
    return [self = *this](auto const& u) { return self.configuration(self.bent(u)); };
  }

  // The Lagrangian: in straight coordinates, in entries, on TG.

  template <class T>
  T in_straight(Vector<T> const& u, Vector<T> const& v) const {
    T const sv = dot(s, v), wu = dot(w, u);
    Vector<T> const p = a.template cast<T>() * v;
    return v.dot(p) / 2 + sv * sv * sv * T(kappa) + dot(c, u) + wu * dot(w, v) * dot(r, u) * 2 +
           wu * wu * dot(r, v);
  }
  template <class T>
  T in_entries(Vector<T> const& q, Vector<T> const& v) const {
    auto const u = straight(moving(q, v));
    return in_straight(values(u), rates(u));
  }
  template <class T>
  T operator()(State<SpannedGroup, T> const& state) const {
    Matrix<T> const g = state.configuration.value, rate = group.hat(state.velocity.coordinates) * g;
    return in_entries(read(g), read(rate));
  }

  // Its motions.

  /// (u, u') of a state.
  template <class T>
  std::pair<Vector<T>, Vector<T>> straight_state(State<SpannedGroup, T> const& state) const {
    Matrix<T> const g = state.configuration.value, rate = group.hat(state.velocity.coordinates) * g;
    auto const u = straight(moving(read(g), read(rate)));
    return {values(u), rates(u)};
  }
  /// F_t.
  template <class T>
  State<SpannedGroup, T> flow(State<SpannedGroup, T> const& state, T const& t) const {
    auto const [u, v] = straight_state(state);
    Vector<T> const f = fall.template cast<T>();
    return state_in(chart(), Vector<T>(u + v * t + f * (t * t / 2)), Vector<T>(v + f * t));
  }
  /// The motion through a state, as a curve.
  auto motion(State<SpannedGroup, S> const& state) const {
    auto const [u, v] = straight_state(state);
    return [self = *this, u = u, v = v](auto const& t) {
      using T = std::decay_t<decltype(t)>;
      Vector<T> const x =
          u.template cast<T>() + v.template cast<T>() * t + self.fall.template cast<T>() * (t * t / 2);
      return self.configuration(self.bent(x));
    };
  }
  /// The generator of u -> u + e d, translated to the identity on the right.
  auto shift(Vector<S> const& d) const {
    return [self = *this, d](auto const& g) {
      using T = typename std::decay_t<decltype(g)>::Scalar;
      return state_in(self.chart(), self.straight(self.read(Matrix<T>(g.value))),
                      Vector<T>(d.template cast<T>()))
          .velocity;
    };
  }

  template <class V>
  static auto dot(Vector<S> const& x, V const& y) {
    using T = typename V::Scalar;
    T sum(0);
    for (Index i = 0; i < x.size(); ++i) sum += y[i] * T(x[i]);
    return sum;
  }
};

/// Bounds the degree in t of what is integrated: 12, reached by the total derivative, where u has degree 4
/// and its variations degree 5 (2 and 9 along motions).
inline constexpr int polynomial_degree = 14;

template <class S>
ExactMotions<S> draw_exact_motions(Draw& draw, SpannedGroup const& group) {
  int const n = group.dimension();
  std::vector<std::pair<int, int>> entries;
  if (group.name() == "Aff(1)") entries = {{0, 0}, {0, 1}};
  if (group.name() == "Heisenberg") entries = {{0, 1}, {1, 2}, {0, 2}};
  if (group.name() == "GL(2)") entries = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  auto const kinetic = draw_algebra_polynomial<S>(draw, n);
  S const quarter = ratio<S>(1, 4);
  ExactMotions<S> m{group,
                    entries,
                    draw_vector<S>(draw, n) * quarter,
                    kinetic.a,
                    draw_vector<S>(draw, n),
                    draw_vector<S>(draw, n),
                    draw_vector<S>(draw, n),
                    draw_vector<S>(draw, n),
                    {},
                    draw.number<S>()};
  m.fall = solve_linear(m.a, m.c);
  m.s -= m.fall * S(ExactMotions<S>::dot(m.s, m.fall) / ExactMotions<S>::dot(m.fall, m.fall));
  return m;
}
/// A state near the identity, slow enough to stay in the group for times below 1.
template <class S>
State<SpannedGroup, S> draw_near_state(Draw& draw, SpannedGroup const& group) {
  auto const g = draw.element<S>(group, ratio<S>(1, 4));
  return {g, draw.velocity<S>(group, ratio<S>(1, 4))};
}

/// Groups whose entries are coordinates.
inline std::vector<SpannedGroup> const& entry_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("Aff(1)", Aff1{}), spanned("GL(2)", GL<2>{}),
                                                   spanned("Heisenberg", Heisenberg{})};
  return groups;
}

/// A curve with polynomial entries, no motion of anything: entries q0 + t q1 + t^2 q2.
template <class S>
auto draw_polynomial_curve(Draw& draw, ExactMotions<S> const& m) {
  int const n = m.group.dimension();
  Vector<S> const q0 = m.read(draw.element<S>(m.group, ratio<S>(1, 4)).value);
  Vector<S> const q1 = draw_vector<S>(draw, n) * ratio<S>(1, 4),
                  q2 = draw_vector<S>(draw, n) * ratio<S>(1, 4);
  return [=](auto const& t) {
    using T = std::decay_t<decltype(t)>;
    return m.configuration(
        Vector<T>(q0.template cast<T>() + (q1.template cast<T>() + q2.template cast<T>() * t) * t));
  };
}
/// Directions of the entries, a polynomial in t, with zeros at a and b where `fixed`.
template <class S>
auto draw_direction(Draw& draw, int n, S const& a, S const& b, bool fixed) {
  Vector<S> const d0 = draw_vector<S>(draw, n), d1 = draw_vector<S>(draw, n);
  return [=](auto const& t) {
    using T = std::decay_t<decltype(t)>;
    T const ends = fixed ? T((t - T(a)) * (t - T(b)) * 4) : T(1);
    return Vector<T>((d0.template cast<T>() + d1.template cast<T>() * t) * ends);
  };
}
/// The family (epsilon, t) -> entries of the curve + epsilon times a direction.
template <class S, class Curve, class Direction>
auto shifted(ExactMotions<S> const& m, Curve const& curve, Direction const& direction) {
  return [=](auto const& epsilon, auto const& t) {
    using T = std::decay_t<decltype(t)>;
    return m.configuration(Vector<T>(m.read(Matrix<T>(curve(t).value)) + direction(t) * epsilon));
  };
}

/// A function of time with values in R^n, and its rates.
template <class S, class F>
Vector<S> rate_of(F const& f, S const& t) {
  Dual<S> time(t);
  time.part[0] = S(1);
  return rates(Vector<Dual<S>>(f(time)));
}

}  // namespace actio::checks
