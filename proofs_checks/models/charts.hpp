// Charts of a group, and mechanics written out in coordinates: the second route that chapter 2 is held to.
//
// A chart is a callable from coordinates to an element, at every scalar. Everything here is partial
// derivatives of ordinary functions L(q, v): no translation, no ad.
#pragma once

#include "actio/variational/curves.hpp"
#include "models/models.hpp"

namespace actio::checks {

/// The chart q -> cayley(q) h, which covers a neighbourhood of h.
template <class S>
auto chart_right(Element<SpannedGroup, S> const& h) {
  return [h](auto const& q) {
    using T = typename std::decay_t<decltype(q)>::Scalar;
    Matrix<T> const turn = cayley(h.group.hat(q)), configuration = h.value.template cast<T>();
    return Element<SpannedGroup, T>{h.group, turn * configuration};
  };
}
/// The chart r -> k cayley(r).
template <class S>
auto chart_left(Element<SpannedGroup, S> const& k) {
  return [k](auto const& r) {
    using T = typename std::decay_t<decltype(r)>::Scalar;
    Matrix<T> const turn = cayley(k.group.hat(r)), configuration = k.value.template cast<T>();
    return Element<SpannedGroup, T>{k.group, configuration * turn};
  };
}
/// The coordinates of an element in `chart_left(k)`.
template <class S>
auto coordinates_left(Element<SpannedGroup, S> const& k) {
  return [k](auto const& g) {
    using T = typename std::decay_t<decltype(g)>::Scalar;
    Matrix<T> const back = inverse_matrix(k.value).template cast<T>();
    return Vector<T>(k.group.vee(inverse_cayley(Matrix<T>(back * g.value))));
  };
}

/// (q, v) as dual numbers q + v dt.
template <class T>
Vector<Dual<T>> moving(Vector<T> const& q, Vector<T> const& v) {
  Vector<Dual<T>> x(q.size());
  for (Index i = 0; i < q.size(); ++i) x[i].value = q[i], x[i].part[0] = v[i];
  return x;
}
template <class T>
Vector<T> values(Vector<Dual<T>> const& x) { return x.unaryExpr([](Dual<T> const& y) { return y.value; }); }
template <class T>
Vector<T> rates(Vector<Dual<T>> const& x) { return x.unaryExpr([](Dual<T> const& y) { return y.part[0]; }); }
template <class T>
Matrix<T> matrix_rates(Matrix<Dual<T>> const& x) {
  return x.unaryExpr([](Dual<T> const& y) { return y.part[0]; });
}
template <class T>
Matrix<T> matrix_values(Matrix<Dual<T>> const& x) {
  return x.unaryExpr([](Dual<T> const& y) { return y.value; });
}

/// The point of TG with coordinates (q, v) in a chart, by matrices alone: xi = g' g^-1.
template <class Chart, class T>
State<SpannedGroup, T> state_in(Chart const& chart, Vector<T> const& q, Vector<T> const& v) {
  auto const g = chart(moving(q, v));
  Matrix<T> const configuration = matrix_values(g.value),
                  xi = matrix_rates(g.value) * inverse_matrix(configuration);
  return {{g.group, configuration}, {g.group, g.group.vee(xi)}};
}
/// xi' of the curve with coordinates (q, v, a).
template <class Chart, class T>
Velocity<SpannedGroup, T> acceleration_in(Chart const& chart, Vector<T> const& q, Vector<T> const& v,
                                          Vector<T> const& a) {
  auto const state = state_in(chart, moving(q, v), moving(v, a));
  return {state.configuration.group, rates(state.velocity.coordinates)};
}
/// Columns: how the element moves when a coordinate does, translated to the identity on the right.
template <class Chart, class T>
Matrix<T> frame(Chart const& chart, Vector<T> const& q) {
  int const n = static_cast<int>(q.size());
  Matrix<T> columns(n, n);
  for (int i = 0; i < n; ++i)
    columns.col(i) = state_in(chart, q, Vector<T>(Vector<T>::Unit(n, i))).velocity.coordinates;
  return columns;
}
/// A Lagrangian on TG as a function of coordinates and their rates.
template <class L, class Chart>
auto in_coordinates(L const& lagrangian, Chart const& chart) {
  return [lagrangian, chart](auto const& q, auto const& v) { return lagrangian(state_in(chart, q, v)); };
}

/// dL/dq.
template <class F, class T>
Vector<T> slopes(F const& f, Vector<T> const& q, Vector<T> const& v) {
  Vector<T> d(q.size()), none = Vector<T>::Zero(q.size());
  for (Index i = 0; i < q.size(); ++i)
    d[i] = f(moving(q, Vector<T>(Vector<T>::Unit(q.size(), i))), moving(v, none)).part[0];
  return d;
}
/// dL/dv.
template <class F, class T>
Vector<T> momenta(F const& f, Vector<T> const& q, Vector<T> const& v) {
  Vector<T> d(q.size()), none = Vector<T>::Zero(q.size());
  for (Index i = 0; i < q.size(); ++i)
    d[i] = f(moving(q, none), moving(v, Vector<T>(Vector<T>::Unit(q.size(), i)))).part[0];
  return d;
}
/// The left side of (2.4): dL/dq - d/dt dL/dv along (q, v, a).
template <class F, class T>
Vector<T> euler_lagrange_in_coordinates(F const& f, Vector<T> const& q, Vector<T> const& v,
                                        Vector<T> const& a) {
  return slopes(f, q, v) - rates(momenta(f, moving(q, v), moving(v, a)));
}

/// A point of TG, and a tangent vector there.
template <class S>
State<SpannedGroup, S> draw_state(Draw& draw, SpannedGroup const& group) {
  auto const g = draw.element<S>(group);
  return {g, draw.velocity<S>(group)};
}
template <class S>
StateChange<SpannedGroup, S> draw_change(Draw& draw, SpannedGroup const& group) {
  auto const theta = draw.velocity<S>(group);
  return {theta, draw.velocity<S>(group)};
}

/// A curve in a group through random points, t -> retract(t a + t^2 b) retract(t c) h: no geodesic, no
/// one-parameter group.
template <class S>
auto draw_retracted_curve(Draw& draw, SpannedGroup const& group) {
  auto const a = draw.velocity<S>(group, ratio<S>(1, 2)), b = draw.velocity<S>(group, ratio<S>(1, 2)),
             c = draw.velocity<S>(group, ratio<S>(1, 2));
  auto const h = draw.element<S>(group);
  return [=](auto const& t) {
    using T = std::decay_t<decltype(t)>;
    return retract(t * (over<T>(a) + t * over<T>(b))) * retract(t * over<T>(c)) * over<T>(h);
  };
}
/// The curve's configuration and its body velocity at t.
template <class Curve, class S>
std::pair<Matrix<S>, Matrix<S>> place_and_body_velocity(Curve const& curve, S const& t) {
  Dual<S> time(t);
  time.part[0] = S(1);
  auto const moving_element = curve(time);
  Matrix<S> const g = matrix_values(moving_element.value);
  return {g, g.transpose() * matrix_rates(moving_element.value)};
}
/// A family of curves through `curve`: (epsilon, t) -> retract(epsilon (a + t b + t^2 c)) curve(t)
/// retract(epsilon t d).
template <class S, class Curve>
auto draw_family(Draw& draw, SpannedGroup const& group, Curve const& curve) {
  auto const a = draw.velocity<S>(group), b = draw.velocity<S>(group), c = draw.velocity<S>(group),
             d = draw.velocity<S>(group);
  return [=](auto const& epsilon, auto const& t) {
    using T = std::decay_t<decltype(t)>;
    return retract(epsilon * (over<T>(a) + t * (over<T>(b) + t * over<T>(c)))) * curve(t) *
           retract(epsilon * t * over<T>(d));
  };
}

/// The rate of a path in the algebra.
template <class S, class Path>
Velocity<SpannedGroup, S> rate_along(Path const& path, S const& t) {
  Dual<S> time(t);
  time.part[0] = S(1);
  return rate_of(path(time));
}

}  // namespace actio::checks
