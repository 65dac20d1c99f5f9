// The ideal incompressible fluid seen from space: Eulerian velocity, the equation of Euler and the equation
// of the pressure (section 8.3 of the thesis).
//
// A velocity field is a callable from points (t, y^1, ..., y^n) of time and space to vectors, over any
// scalar; a pressure is one to numbers. All derivatives are covariant, those of the metric g of space; points
// are given as (t, y).
#pragma once

#include "actio/forms/metric.hpp"
#include "actio/jets/jet.hpp"

namespace actio {

namespace detail {
/// The point of space of an event (t, y).
template <class S, int rows>
Matrix<S, rows - 1, 1> place_of(Matrix<S, rows, 1> const& at) { return at.template tail<rows - 1>(); }
}  // namespace detail

/// A velocity field at a point, and its derivatives there.
template <class S, int n>
struct VelocityGradient {
  Matrix<S, n, 1> value;  ///< \f$u\f$
  Matrix<S, n, 1> rate;   ///< \f$\partial_tu\f$
  Matrix<S, n, n> slope;  ///< the covariant derivatives \f$u^a{}_{;b}\f$, a row for each a
};
/// The value of a velocity field at a point (t, y), its rate, and its covariant derivatives.
template <class SpaceMetric, class Field, class S, int rows>
VelocityGradient<S, rows - 1> velocity_gradient(SpaceMetric const& g, Field const& u,
                                                Matrix<S, rows, 1> const& at) {
  constexpr int n = rows - 1;
  auto const j = first_jet(u, at);
  VelocityGradient<S, n> out{j.y, j.velocity(), j.gradient()};
  if constexpr (!is_constant_metric<SpaceMetric>) {
    auto const gamma = christoffel(g, detail::place_of(at));
    for (int a = 0; a < n; ++a) out.slope.row(a) += (gamma[a] * j.y).transpose();
  }
  return out;
}

/// The acceleration \f$\partial_tu + \nabla_uu\f$ of the fluid at a point.
///
/// \implements{claim_8_3_euler_equations}
template <class SpaceMetric, class Field, class S, int rows>
Matrix<S, rows - 1, 1> eulerian_acceleration(SpaceMetric const& g, Field const& u,
                                             Matrix<S, rows, 1> const& at) {
  auto const d = velocity_gradient(g, u, at);
  // [claim_8_3_euler_equations]
  return d.rate + d.slope * d.value;
  // [claim_8_3_euler_equations]
}

/// \f$\nabla_uu\f$, what of the acceleration a steady flow has.
template <class SpaceMetric, class Field, class S, int rows>
Matrix<S, rows - 1, 1> self_advection(SpaceMetric const& g, Field const& u, Matrix<S, rows, 1> const& at) {
  auto const d = velocity_gradient(g, u, at);
  return d.slope * d.value;
}

/// The gradient \f$g^{ab}\partial_bp\f$ of a function at a point (t, y).
template <class SpaceMetric, class Pressure, class S, int rows>
Matrix<S, rows - 1, 1> gradient(SpaceMetric const& g, Pressure const& p, Matrix<S, rows, 1> const& at) {
  auto const dp = derivative(p, at).gradient();
  return raised(g(detail::place_of(at)), Matrix<S, rows - 1, 1>(dp.template tail<rows - 1>()));
}

/// \f$\Delta p = \mathrm{div}\,\mathrm{grad}\,p\f$.
template <class SpaceMetric, class Pressure, class S, int rows>
S laplacian(SpaceMetric const& g, Pressure const& p, Matrix<S, rows, 1> const& at) {
  return divergence(
      g, [&](auto const& y) { return gradient(g, p, y); }, at);
}

/// The right side \f$-\mathrm{div}(\nabla_uu)\f$ of the equation of the pressure (8.14).
///
/// \implements{eq_8_14}
template <class SpaceMetric, class Field, class S, int rows>
S pressure_source(SpaceMetric const& g, Field const& u, Matrix<S, rows, 1> const& at) {
  // [eq_8_14]
  return -divergence(
      g, [&](auto const& y) { return self_advection(g, u, y); }, at);
  // [eq_8_14]
}

/// The slope \f$\partial_cp\,g^{cb}\,\partial_bf\f$ of the pressure through a wall f = 0 that the fluid does
/// not cross: \f$-df(\partial_tu + \nabla_uu)\f$.
///
/// It is the boundary condition that goes with (8.14), and with which it has one solution but for a function
/// of time.
/// @param f  a callable on points of space, zero on the wall
template <class SpaceMetric, class Field, class Wall, class S, int rows>
S pressure_slope_at_wall(SpaceMetric const& g, Field const& u, Wall const& f, Matrix<S, rows, 1> const& at) {
  return -derivative(f, detail::place_of(at)).gradient().dot(eulerian_acceleration(g, u, at));
}

/// The Ricci tensor \f$R_{bd} = \partial_a\gamma^a_{bd} - \partial_d\gamma^a_{ba}
/// + \gamma^a_{ae}\gamma^e_{bd} - \gamma^a_{de}\gamma^e_{ba}\f$ of a metric at a point.
///
/// With it the source of (8.14) is \f$-u^a{}_{;b}u^b{}_{;a} - R_{ab}u^au^b\f$ wherever
/// \f$\mathrm{div}\,u = 0\f$ around.
template <class SpaceMetric, class S, int n>
Matrix<S, n, n> ricci_tensor(SpaceMetric const& g, Matrix<S, n, 1> const& y) {
  Matrix<S, n, n> ricci = Matrix<S, n, n>::Zero();
  if constexpr (!is_constant_metric<SpaceMetric>) {
    // In one column: gamma^a_bd at a n^2 + b + n d.
    auto const symbols = [&g]<class T>(Matrix<T, n, 1> const& z) {
      Matrix<T, n * n * n, 1> column;
      auto const gamma = christoffel(g, z);
      for (int a = 0; a < n; ++a) column.template segment<n * n>(a * n * n) = gamma[a].reshaped(n * n, 1);
      return column;
    };
    auto const d = derivative(symbols, y);
    auto const gamma = [&d](int a, int b, int c) -> S const& { return d.value[a * n * n + b + n * c]; };
    auto const d_gamma = [&d](int e, int a, int b, int c) -> S const& {
      return d.matrix(a * n * n + b + n * c, e);
    };
    for (int b = 0; b < n; ++b)
      for (int d = 0; d < n; ++d)
        for (int a = 0; a < n; ++a) {
          ricci(b, d) += d_gamma(a, a, b, d) - d_gamma(d, a, b, a);
          for (int e = 0; e < n; ++e)
            ricci(b, d) += gamma(a, a, e) * gamma(e, b, d) - gamma(a, d, e) * gamma(e, b, a);
        }
  }
  return ricci;
}

}  // namespace actio
