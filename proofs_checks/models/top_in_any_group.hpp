// A top in any group: a Lagrangian whose flow is no polynomial, and its equations of motion written out by
// hand, with commutators of matrices and nothing of the library.
//
// Solved by power series they are the reference solution for flows, actions and limits. Without its weight W
// the top is right-invariant.
#pragma once

#include <utility>

#include "actio/variational/state.hpp"
#include "models/models.hpp"
#include "witness/taylor_reference.hpp"

namespace actio::checks {

/// The Lagrangian \f$\tfrac12\langle A\xi,\xi\rangle + \langle b,\xi\rangle - \langle W, g\rangle\f$ with its
/// equations of motion.
template <class S>
struct TopInAnyGroup {
  SpannedGroup group;
  Matrix<S> a, inverse_a, w;
  Vector<S> b;

  template <class T>
  T operator()(State<SpannedGroup, T> const& v) const {
    Vector<T> const xi = v.velocity.coordinates;
    Vector<T> const p = a.template cast<T>() * xi / T(2) + b.template cast<T>();
    return p.dot(xi) - contract(w, Matrix<T>(v.configuration.value));
  }
  /// The rates of (entries of g, xi, action): g' = xi g, mu' = -ad*_xi mu - dV, S' = L.
  template <class T>
  Vector<T> operator()(Vector<T> const& y) const {
    int const n = group.matrix_size(), d = group.dimension();
    Matrix<T> g(n, n);
    for (int i = 0; i < n * n; ++i) g(i % n, i / n) = y[i];
    Vector<T> const xi = y.segment(n * n, d), mu = a.template cast<T>() * xi + b.template cast<T>();
    Matrix<T> const x = group.hat(xi), g_rate = x * g;
    Vector<T> mu_rate(d);
    for (int k = 0; k < d; ++k) {
      Matrix<T> const e = group.hat(Vector<T>(Vector<T>::Unit(d, k)));
      mu_rate[k] = -mu.dot(group.vee(Matrix<T>(x * e - e * x))) - contract(w, Matrix<T>(e * g));
    }
    Vector<T> rates_of_y(n * n + d + 1);
    for (int i = 0; i < n * n; ++i) rates_of_y[i] = g_rate(i % n, i / n);
    rates_of_y.segment(n * n, d) = inverse_a.template cast<T>() * mu_rate;
    rates_of_y[n * n + d] = (*this)(State<SpannedGroup, T>{{group, g}, {group, xi}});
    return rates_of_y;
  }
  /// F_t and S_t by power series.
  template <class T>
  std::pair<State<SpannedGroup, T>, T> flow(State<SpannedGroup, T> const& v, S const& t) const {
    int const n = group.matrix_size(), d = group.dimension();
    Vector<T> y = Vector<T>::Zero(n * n + d + 1);
    for (int i = 0; i < n * n; ++i) y[i] = v.configuration.value(i % n, i / n);
    y.segment(n * n, d) = v.velocity.coordinates;
    y = taylor_reference<T>([this](auto const& z) { return (*this)(z); }, y, T(t));
    Matrix<T> g(n, n);
    for (int i = 0; i < n * n; ++i) g(i % n, i / n) = y[i];
    return {{{group, g}, {group, Vector<T>(y.segment(n * n, d))}}, y[n * n + d]};
  }
};
/// The top with \f$g^{-1}\f$ in the place of g. Without weight it is left-invariant.
template <class S>
struct InvertedTop {
  TopInAnyGroup<S> top;
  template <class T>
  static State<SpannedGroup, T> turned(State<SpannedGroup, T> const& v) {
    return {inverse(v.configuration), -body_velocity(v)};
  }
  template <class T>
  T operator()(State<SpannedGroup, T> const& v) const { return top(turned(v)); }
  template <class T>
  std::pair<State<SpannedGroup, T>, T> flow(State<SpannedGroup, T> const& v, S const& t) const {
    auto const [end, action] = top.flow(turned(v), t);
    return {turned(end), action};
  }
};
template <class S>
TopInAnyGroup<S> draw_top(Draw& draw, SpannedGroup const& group) {
  auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
  auto const w = draw_matrix<S>(draw, group.matrix_size(), group.matrix_size());
  return {group, kinetic.a, inverse_matrix(kinetic.a), w, kinetic.b};
}
template <class S>
TopInAnyGroup<S> draw_top_without_weight(Draw& draw, SpannedGroup const& group) {
  auto top = draw_top<S>(draw, group);
  top.w.setZero();
  return top;
}

}  // namespace actio::checks
