// An element of a rod between two cross-sections, in closed form.
//
// The relative motion of an element, in the frame of its first section, is e = (E, eps), the rotation as a
// unit quaternion. Cayley's map of the motions of space as matrices with four rows is inverted by
//
//     w = cay^-1(E) = 2 vec(E)/scalar(E),        Gamma = (eps - w x eps/2)/D,        kappa = w/D
//
// with the length D of the element: what the rod is stretched and sheared by, and what it is twisted and bent
// by. The strain energy is D/2 times that of the section in Gamma - Gamma0 and kappa - kappa0, its stresses
// are N = C_N (Gamma - Gamma0) and M = C_M (kappa - kappa0), and its differential on e is
//
//     force n = N + w x N/2 in the frame of the first section,
//     moment m = T(-w) M',  M' = M - eps x N/2,  in the frame of the second one,
//
// where T(w) p = p + w x p/2 + w (w.p)/4 is the inverse of the derivative of Cayley's map, but for a factor.
// The first section feels the moment T(w) M' + eps x n, since E T(-w) = T(w).
#pragma once

#include "actio/fast_body/space/moser_veselov_turn.hpp"
#include "actio/rods/rod_section.hpp"

namespace actio::rods {

/// The product of vectors.
template <class T>
[[gnu::always_inline]] inline Three<T> cross(Three<T> const& a, Three<T> const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// a + c b.
template <class T>
[[gnu::always_inline]] inline Three<T> plus_times(Three<T> const& a, T const& c, Three<T> const& b) {
  return {a[0] + c * b[0], a[1] + c * b[1], a[2] + c * b[2]};
}
/// Entry by entry.
template <class T>
[[gnu::always_inline]] inline Three<T> times(Three<T> const& a, Three<T> const& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
/// c a.
template <class T>
[[gnu::always_inline]] inline Three<T> times(T const& c, Three<T> const& a) {
  return {c * a[0], c * a[1], c * a[2]};
}
/// a - b.
template <class T>
[[gnu::always_inline]] inline Three<T> difference(Three<T> const& a, Three<T> const& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// The inverse of a unit quaternion.
template <class T>
[[gnu::always_inline]] inline Four<T> inverse_turn(Four<T> const& q) {
  return {q[0], -q[1], -q[2], -q[3]};
}
/// \f$qvq^{-1}\f$: a vector of the frame q, in space.
template <class T>
[[gnu::always_inline]] inline Three<T> turned(Four<T> const& q, Three<T> const& v) {
  return bodies::turned_back(inverse_turn(q), v);
}
/// \f$T(w)p=p+\tfrac12w\times p+\tfrac14w\,(w\cdot p)\f$.
template <class T>
[[gnu::always_inline]] inline Three<T> cayley_differential(Three<T> const& w, Three<T> const& p) {
  return plus_times(plus_times(p, T(0.5), cross(w, p)), T(0.25 * bodies::dot(w, p)), w);
}

/// Where one section is, seen from another.
template <class T>
struct RelativePlacement {
  Three<T> w;    ///< \f$\mathrm{cay}^{-1}(E)\f$: twice the tangent of half the angle, about its axis
  Three<T> eps;  ///< from the first to the second place, in the frame of the first; length

  /// @param q0,q1  attitudes, unit quaternions, which turn by less than half a revolution from one to the
  ///               other
  /// @param dx     from the first to the second place, in space
  [[gnu::always_inline]] static RelativePlacement of(Four<T> const& q0, Four<T> const& q1,
                                                     Three<T> const& dx) {
    Four<T> const e = bodies::compose(inverse_turn(q0), q1);
    T const twice = 2.0 / e[0];
    return {{twice * e[1], twice * e[2], twice * e[3]}, bodies::turned_back(q0, dx)};
  }
  /// \f$\epsilon-\tfrac12w\times\epsilon = D\,\Gamma\f$.
  [[gnu::always_inline]] Three<T> stretch() const { return plus_times(eps, T(-0.5), cross(w, eps)); }
};

/// What strains an element has at rest, and how long it is.
template <class T>
struct ElementAtRest {
  T inverse_length;  ///< 1/D; 1/length
  Three<T> Gamma;    ///< \f$\Gamma_0\f$, a pure number
  Three<T> kappa;    ///< \f$\kappa_0\f$; 1/length
};

/// What an element exerts on the sections at its ends.
template <class T>
struct ElementForce {
  Three<T> n;       ///< force on the first section, in its frame; the second one feels the opposite
  Three<T> first;   ///< moment on the first section, in its frame
  Three<T> second;  ///< moment from which the second one feels the opposite, in the frame of that
};

/// The differential of the strain energy of an element with stresses N and M.
template <class T>
[[gnu::always_inline]] inline ElementForce<T> element_force(RelativePlacement<T> const& e, Three<T> const& N,
                                                            Three<T> const& M) {
  // [element_force]
  Three<T> const n = plus_times(N, T(0.5), cross(e.w, N)), inner = plus_times(M, T(-0.5), cross(e.eps, N));
  Three<T> const back{-e.w[0], -e.w[1], -e.w[2]};
  return {n, bodies::plus(cayley_differential(e.w, inner), cross(e.eps, n)),
          cayley_differential(back, inner)};
  // [element_force]
}

/// Strains less those at rest.
template <class T>
struct ElementStrain {
  Three<T> Gamma;  ///< stretch and shears
  Three<T> kappa;  ///< twist and bends; 1/length
};
/// Those of an element.
template <class T>
[[gnu::always_inline]] inline ElementStrain<T> element_strain(RelativePlacement<T> const& e,
                                                              ElementAtRest<T> const& rest) {
  return {difference(times(rest.inverse_length, e.stretch()), rest.Gamma),
          difference(times(rest.inverse_length, e.w), rest.kappa)};
}

}  // namespace actio::rods
