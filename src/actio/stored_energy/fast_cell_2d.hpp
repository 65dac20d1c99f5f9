// A cell of a medium in the plane: what its four edges store, and the slope of that in each of them.
//
// The scheme has the stored energy at the corners of a cell, where two edges meet: with e over the length of
// the cell in its direction, they are the columns of F. The energy of a cell per mass density is
//
//     E = (h1 h2/4) sum over the corners of W(F),
//
// and what the corners need of the edges, |e|^2, e.e' and e x e', they share. So a cell is far from four
// elements: its edges' slopes dE/de are sums over two corners each, and the force on a node is a sum over the
// edges that meet there.
//
// Corners are numbered 0 (left below), 1 (right below), 2 (left above), 3 (right above).
#pragma once

#include <array>
#include <type_traits>

#include "actio/stored_energy/fast_volume_laws.hpp"

namespace actio::media {

namespace detail {

/// A vector in the plane.
template <class T>
struct Plane {
  T x, y;
  [[gnu::always_inline]] friend Plane operator+(Plane const& a, Plane const& b) {
    return {a.x + b.x, a.y + b.y};
  }
  [[gnu::always_inline]] friend Plane operator-(Plane const& a, Plane const& b) {
    return {a.x - b.x, a.y - b.y};
  }
};
template <class T>
[[gnu::always_inline]] inline T cross(Plane<T> const& a, Plane<T> const& b) { return a.x * b.y - a.y * b.x; }
template <class T>
[[gnu::always_inline]] inline T dot(Plane<T> const& a, Plane<T> const& b) { return a.x * b.x + a.y * b.y; }

/// One vector for each edge of a cell: two that go right, two that go up.
template <class T>
struct Edges {
  Plane<T> below, above, left, right;
};
/// The edges between four corners.
template <class T>
[[gnu::always_inline]] inline Edges<T> edges_between(Plane<T> const& x0, Plane<T> const& x1,
                                                     Plane<T> const& x2, Plane<T> const& x3) {
  return {x1 - x0, x3 - x2, x2 - x0, x3 - x1};
}
/// \copydoc edges_between
template <class T>
Edges<T> edges_between(Plane<T> const (&x)[4]) { return edges_between(x[0], x[1], x[2], x[3]); }
/// s a.
template <class T>
Plane<T> scaled_by(double s, Plane<T> const& a) { return {s * a.x, s * a.y}; }
/// \f$e_1\times e_2\f$ at the corners: \f$h_1h_2J\f$.
template <class T>
[[gnu::always_inline]] inline void areas(Edges<T> const& e, T (&d)[4]) {
  d[0] = cross(e.below, e.left), d[1] = cross(e.below, e.right);
  d[2] = cross(e.above, e.left), d[3] = cross(e.above, e.right);
}

/// The part of the slopes that is \f$\sum_c q_c\,\partial(e_1\times e_2)_c\f$.
template <class T>
[[gnu::always_inline]] inline Edges<T> area_slopes(Edges<T> const& e, T const (&q)[4]) {
  return {{q[0] * e.left.y + q[1] * e.right.y, -(q[0] * e.left.x + q[1] * e.right.x)},
          {q[2] * e.left.y + q[3] * e.right.y, -(q[2] * e.left.x + q[3] * e.right.x)},
          {-(q[0] * e.below.y + q[2] * e.above.y), q[0] * e.below.x + q[2] * e.above.x},
          {-(q[1] * e.below.y + q[3] * e.above.y), q[1] * e.below.x + q[3] * e.above.x}};
}

/// Cells with a law of the area, `volume`: its slopes q at the corners come first, and the slopes in the
/// edges from them.
template <class Cell>
concept WithVolume = requires(Cell const& cell) { cell.volume; };

/// Cells of a fluid of one size.
template <class Scaled>
struct FluidCell {
  Scaled volume;  ///< the law at \f$h_1h_2J\f$, with the slope \f$U'/4\f$
  template <class T>
  [[gnu::always_inline]] Edges<T> slopes(Edges<T> const& e, T const (&d)[4]) const {
    T q[4];
    volume.slopes(d, q);
    return slopes_from(e, q);
  }
  template <class T>
  [[gnu::always_inline]] Edges<T> slopes_from(Edges<T> const& e, T const (&q)[4]) const {
    return area_slopes(e, q);
  }
};
/// Cells of a neo-Hookean solid of one size: a fluid whose edges are springs as well.
template <class Scaled>
struct NeoHookeanCell {
  Scaled volume;
  double across, up;  ///< \f$\tfrac\mu2h_2/h_1\f$ and \f$\tfrac\mu2h_1/h_2\f$
  template <class T>
  [[gnu::always_inline]] Edges<T> slopes(Edges<T> const& e, T const (&d)[4]) const {
    T q[4];
    volume.slopes(d, q);
    return slopes_from(e, q);
  }
  template <class T>
  [[gnu::always_inline]] Edges<T> slopes_from(Edges<T> const& e, T const (&q)[4]) const {
    Edges<T> const f = area_slopes(e, q);
    return {{f.below.x + across * e.below.x, f.below.y + across * e.below.y},
            {f.above.x + across * e.above.x, f.above.y + across * e.above.y},
            {f.left.x + up * e.left.x, f.left.y + up * e.left.y},
            {f.right.x + up * e.right.x, f.right.y + up * e.right.y}};
  }
};
/// Cells of St Venant and Kirchhoff's solid of one size. The slope in the edge e1 below is
/// \f$(A_1|e_1|^2+B_1(|e_2|^2+|e_2'|^2)+C_1)\,e_1+D\,(e_1.e_2)\,e_2+D\,(e_1.e_2')\,e_2'\f$ with the edges at
/// its ends.
struct StVenantKirchhoffCell {
  double a1, b1, c1, a2, b2, c2, d_mixed;
  StVenantKirchhoffCell(double lambda, double mu, double h1, double h2)
      : a1(h2 / (4 * h1) * (lambda + 2 * mu) / (h1 * h1)),
        b1(h2 / (4 * h1) * lambda / (2 * h2 * h2)),
        c1(-h2 / (4 * h1) * 2 * (lambda + mu)),
        a2(h1 / (4 * h2) * (lambda + 2 * mu) / (h2 * h2)),
        b2(h1 / (4 * h2) * lambda / (2 * h1 * h1)),
        c2(-h1 / (4 * h2) * 2 * (lambda + mu)),
        d_mixed(mu / (4 * h1 * h2)) {}
  template <class T>
  [[gnu::always_inline]] static Plane<T> sum(T const& s, Plane<T> const& e, T const& g, Plane<T> const& u,
                                             T const& h, Plane<T> const& v) {
    return {s * e.x + g * u.x + h * v.x, s * e.y + g * u.y + h * v.y};
  }
  template <class T>
  [[gnu::always_inline]] Edges<T> slopes(Edges<T> const& e, T const (&)[4]) const {
    T const below = dot(e.below, e.below), above = dot(e.above, e.above), left = dot(e.left, e.left),
            right = dot(e.right, e.right);
    T const sides = b1 * (left + right) + c1, ends = b2 * (below + above) + c2;
    T const g0 = d_mixed * dot(e.below, e.left), g1 = d_mixed * dot(e.below, e.right),
            g2 = d_mixed * dot(e.above, e.left), g3 = d_mixed * dot(e.above, e.right);
    return {sum(T(a1 * below + sides), e.below, g0, e.left, g1, e.right),
            sum(T(a1 * above + sides), e.above, g2, e.left, g3, e.right),
            sum(T(a2 * left + ends), e.left, g0, e.below, g2, e.above),
            sum(T(a2 * right + ends), e.right, g1, e.below, g3, e.above)};
  }
};
}  // namespace detail

/// A barotropic fluid, \f$W = U(J)\f$ per unit mass, for the optimised implementation: its pressure is
/// \f$-\rho U'(J)\f$, \f$\rho\f$ the mass density of the body. Made in braces:
/// `FastFluid{PolytropicGas{K, gamma}}`.
template <class Volume>
struct FastFluid {
  Volume volume;  ///< U, speed squared: \ref PolytropicGas, \ref PolytropicByRoots, or a law of your own
  /// What steps a cell of these lengths.
  auto on(double h1, double h2) const {
    auto const scaled = detail::scaled(volume, h1 * h2, 0.25);
    return detail::FluidCell<std::remove_const_t<decltype(scaled)>>{scaled};
  }
};
template <class Volume>
FastFluid(Volume) -> FastFluid<Volume>;

/// A neo-Hookean solid, \f$W = \tfrac\mu2(\Tr C-d)+U(J)\f$ per unit mass in d dimensions, for the optimised
/// implementation. \ref neo_hookean and \ref blatz_ko make those that are free of stress at rest; in braces,
/// `FastNeoHookean{mu, QuadraticLaw{mu, kappa}}`, that is so where \f$U'(1) = -\mu\f$.
template <class Volume>
struct FastNeoHookean {
  double mu;      ///< shear modulus over the mass density, speed squared; positive
  /// U, speed squared: \ref LogarithmicLaw, \ref ReciprocalLaw, \ref QuadraticLaw, or your own
  Volume volume;
  /// What steps a cell of these lengths.
  auto on(double h1, double h2) const {
    auto const scaled = detail::scaled(volume, h1 * h2, 0.25);
    return detail::NeoHookeanCell<std::remove_const_t<decltype(scaled)>>{scaled, mu / 2 * h2 / h1,
                                                                         mu / 2 * h1 / h2};
  }
};
template <class Volume>
FastNeoHookean(double, Volume) -> FastNeoHookean<Volume>;

/// A neo-Hookean solid that is free of stress at rest:
/// \f$W = \tfrac\mu2(\Tr C-d) - \mu\log J + \tfrac\lambda2\log^2J\f$ per unit mass, in d dimensions, with
/// \f$C = F^TF\f$ and \f$J = \det F > 0\f$. At small strains it is the linear solid with Lame's moduli
/// \f$\rho\lambda\f$ and \f$\rho\mu\f$: with Young's modulus E and Poisson's ratio \f$\nu\f$ of a material in
/// space, \f$\rho\mu = E/(2+2\nu)\f$ and \f$\rho\lambda = E\nu/((1+\nu)(1-2\nu))\f$.
///
/// \snippet media.cpp neo_hookean
/// @param lambda  Lame's first modulus over the mass density, speed squared; at rest stable for
///                \f$\lambda > -2\mu/d\f$, and zero or more for most materials
/// @param mu      shear modulus over the mass density, speed squared; positive
inline FastNeoHookean<LogarithmicLaw> neo_hookean(double lambda, double mu) { return {mu, {lambda, mu}}; }
/// Blatz and Ko's solid, free of stress at rest: \f$U = \tfrac{\mu}{2m}(J^{-2m}-1)\f$, \f$\lambda = 2m\mu\f$.
/// @tparam m  a whole number, 1 or more: the larger, the less the volume changes
/// @param mu  shear modulus over the mass density, speed squared; positive
template <int m>
FastNeoHookean<PolytropicByRoots<1, 2 * m + 1>> blatz_ko(double mu) { return {mu, {mu}}; }

/// St Venant and Kirchhoff's solid, \f$W = \tfrac\lambda2(\Tr E)^2+\mu\Tr E^2\f$ per unit mass with Green's
/// strain \f$E = \tfrac12(C-1)\f$, for the optimised implementation. Made in braces,
/// `FastStVenantKirchhoff{lambda, mu}`. It does not resist collapse: it is for strains well below 1.
struct FastStVenantKirchhoff {
  double lambda;  ///< Lame's first modulus over the mass density, speed squared; above \f$-2\mu/d\f$
  double mu;      ///< shear modulus over the mass density, speed squared; positive
  /// What steps a cell of these lengths.
  detail::StVenantKirchhoffCell on(double h1, double h2) const { return {lambda, mu, h1, h2}; }
};

namespace detail {
/// What steps cells of these lengths.
template <class Medium>
auto cell_on(Medium const& medium, std::array<double, 2> const& h) { return medium.on(h[0], h[1]); }
/// \f$h_1h_2J\f$ at the corners.
template <class T>
std::array<T, 4> corner_volumes(Edges<T> const& e) {
  T d[4];
  areas(e, d);
  return {d[0], d[1], d[2], d[3]};
}
/// The forces of a cell on its corners per mass density.
template <class Cell, class T>
std::array<Plane<T>, 4> corner_forces(Cell const& cell, Edges<T> const& e) {
  T d[4];
  areas(e, d);
  Edges<T> const s = cell.slopes(e, d);
  return {s.below + s.left, s.right - s.below, s.above - s.left, Plane<T>{} - (s.above + s.right)};
}
}  // namespace detail

}  // namespace actio::media
