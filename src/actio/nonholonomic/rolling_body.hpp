// A convex body that rolls on a plane under gravity: the steps of rattle_step.hpp on SE(3), written out.
//
// The plane has the normal u, seen from the body, and touches it at r(u) from the centre of mass. Rolling,
// v + w x r = 0, gives the velocity of the centre of mass, and momenta enter by that about the contact alone,
//
//     K = M - r x P,
//
// since reactions have no moment about it. A step maps (K, u) to (K, u); its unknown is the angular velocity
// w with K of P_0 equal to that at the start. Heights are -r.u, and du/dt = u x w.
#pragma once

#include <array>
#include <cmath>

#include "actio/numbers/errors.hpp"

namespace actio {

/// Three numbers, with what a step does with them.
template <class S>
struct Triad {
  S x{};  ///< the first
  S y{};  ///< the second
  S z{};  ///< the third

  friend Triad operator+(Triad const& a, Triad const& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Triad operator-(Triad const& a, Triad const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Triad operator*(S const& c, Triad const& a) { return {c * a.x, c * a.y, c * a.z}; }
  /// \f$a\cdot b\f$.
  friend S dot(Triad const& a, Triad const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  /// \f$a\times b\f$.
  friend Triad cross(Triad const& a, Triad const& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

namespace detail {
/// The solution of three equations.
inline Triad<double> solve_three(std::array<Triad<double>, 3> const& columns, Triad<double> const& right,
                                 char const* where) {
  auto const& [c0, c1, c2] = columns;
  Triad<double> const n = cross(c1, c2);
  if (double const sum = dot(c0, n) + dot(right, right); !(sum - sum == 0))
    throw NotFinite(std::string(where) + ": point of contact");
  double const determinant = dot(c0, n), size = std::sqrt(dot(c0, c0) * dot(c1, c1) * dot(c2, c2));
  if (!(std::abs(determinant) > 0x1p-40 * size))
    throw Singular(where,
                   "an inertia about each axis through the contact is needed; determinant over lengths",
                   size > 0 ? std::abs(determinant) / size : 0, 0x1p-40);
  return {dot(right, n) / determinant, dot(c0, cross(right, c2)) / determinant,
          dot(c0, cross(c1, right)) / determinant};
}

}  // namespace detail

/// An ellipsoid, seen from a centre of mass on its third axis: \f$r_i = -a_i^2u_i/S + s\,\delta_{i3}\f$ with
/// \f$S = |(a_1u_1, a_2u_2, a_3u_3)|\f$. With two equal halves and one of zero it is a disc: then no normal
/// may lie along its axis.
struct Ellipsoid {
  std::array<double, 3> half_axes;  ///< lengths
  double centre_above = 0;          ///< the centre of the ellipsoid along the third axis; a length

  /// The point of contact for a normal, which need not have length 1.
  template <class S>
  Triad<S> operator()(Triad<S> const& u) const {
    using std::sqrt;
    S const a = S(half_axes[0]) * u.x, b = S(half_axes[1]) * u.y, c = S(half_axes[2]) * u.z,
            scale = S(-1) / sqrt(a * a + b * b + c * c);
    return {S(half_axes[0]) * a * scale, S(half_axes[1]) * b * scale,
            S(half_axes[2]) * c * scale + S(centre_above)};
  }
};

/// A rigid body with a smooth convex shape.
template <class Shape>
struct RollingBody {
  Shape shape;                    ///< normal, seen from the body -> contact, from the centre of mass
  std::array<double, 6> inertia;  ///< 11, 22, 33, 23, 13, 12 about the centre of mass; mass times length^2
  double mass = 1,                ///< of the body
      gravity = 0;                ///< length/time^2

  /// \f$I\,w\f$.
  template <class S>
  Triad<S> spin_momentum(Triad<S> const& w) const {
    return {S(inertia[0]) * w.x + S(inertia[5]) * w.y + S(inertia[4]) * w.z,
            S(inertia[5]) * w.x + S(inertia[1]) * w.y + S(inertia[3]) * w.z,
            S(inertia[4]) * w.x + S(inertia[3]) * w.y + S(inertia[2]) * w.z};
  }
  /// The momentum about the contact, \f$Iw - m\,r\times(r\times w)\f$.
  Triad<double> momentum(Triad<double> const& w, Triad<double> const& u) const {
    auto const r = shape(u);
    return spin_momentum(w) - mass * cross(r, cross(r, w));
  }
  /// The angular velocity of a momentum about the contact.
  /// @throws Singular  where the body has no inertia about an axis through the contact
  Triad<double> velocity(Triad<double> const& momentum, Triad<double> const& u) const;
  /// Kinetic energy, and \f$m\,g\f$ times the height of the centre of mass.
  double energy(Triad<double> const& w, Triad<double> const& u) const {
    return dot(w, momentum(w, u)) / 2 - mass * gravity * dot(shape(u), u);
  }
};

template <class Shape>
Triad<double> RollingBody<Shape>::velocity(Triad<double> const& k, Triad<double> const& u) const {
  return detail::solve_three({momentum({1, 0, 0}, u), momentum({0, 1, 0}, u), momentum({0, 0, 1}, u)}, k,
                             "rolling body");
}

}  // namespace actio
