// A step of the scheme of Moser and Veselov for a momentum that has just changed, without a root that may
// fail: for bodies that a force kicks before every step, one or several side by side.
//
// As in short_step.hpp the momentum is a pure number, p = hM/(2 I) with some unit I of inertia, and J_i are
// inverse moments in that unit. The equation of explicit_moser_veselov.hpp for K = kappa |p|, with P = |p|^2
// and S = P + K^2, is
//
//     e3 S^2 - e2 K S + e1 K^2 - K + r = 0,        r = sum J_i p_i^2,
//
// and the magnitude of p is needed nowhere, so that a body at rest is no exception. With D_i = S J_i - K the
// axis V = p + ((D_j D_k) p_i + (D_k - D_j) p_j p_k)/P gives the relative rotation
//
//     e = (p.y/S, J_1 y_1, J_2 y_2, J_3 y_3),        y = sqrt(S) V/|V|.
#pragma once

#include "actio/fast_body/space/half_turn.hpp"
#include "actio/fast_body/space/short_flow.hpp"
#include "actio/numbers/pack.hpp"

namespace actio::bodies {

/// How a body turns in one step.
template <class T>
struct MoserVeselovTurn {
  /// the rotation e from the attitude after the step to that before it, scalar first: \f$q' = qe\f$,
  /// \f$M' = e^{-1}Me\f$
  Four<T> turn;
  bool found;  ///< whether there is a solution, of packs in all lanes; if not, `turn` has no meaning
};

/// \f$e^{-1}ve\f$: a vector that is fixed in space, seen after the rotation e.
template <class T>
[[gnu::always_inline]] inline Three<T> turned_back(Four<T> const& e, Three<T> const& v) {
  Three<T> const t{2.0 * (v[1] * e[3] - v[2] * e[2]), 2.0 * (v[2] * e[1] - v[0] * e[3]),
                   2.0 * (v[0] * e[2] - v[1] * e[1])};
  return {v[0] + (e[0] * t[0] + (t[1] * e[3] - t[2] * e[2])),
          v[1] + (e[0] * t[1] + (t[2] * e[1] - t[0] * e[3])),
          v[2] + (e[0] * t[2] + (t[0] * e[2] - t[1] * e[1]))};
}

/// The step, by Newton's method for K from r, on the side where the equation falls.
///
/// @param body  inverse moments, for packs in each lane
/// @param p     momentum \f$hM/2\f$ in the unit of inertia, a pure number
/// Accuracy: rounding; the rotation takes the momentum along, whatever the rounding of K.
template <class T>
[[gnu::always_inline]] inline MoserVeselovTurn<T> moser_veselov_turn(InverseMoments<T> const& body,
                                                                     Three<T> const& p) {
  using std::sqrt;
  constexpr double tiny = 1e-200;  // so that a body at rest has a direction
  auto const& J = body.J;
  T const e1 = J[0] + J[1] + J[2], e2 = J[0] * J[1] + J[1] * J[2] + J[2] * J[0], e3 = J[0] * J[1] * J[2];
  T const P = dot(p, p) + tiny, r = J[0] * (p[0] * p[0]) + J[1] * (p[1] * p[1]) + J[2] * (p[2] * p[2]);
  T K = r, S = P + K * K;
  bool found = false;
  for (int round = 0; round < 40 && !found; ++round) {
    // [moser_veselov_turn]
    T const residual = e3 * (S * S) - e2 * (K * S) + e1 * (K * K) - K + r;
    T const slope = 4.0 * e3 * (K * S) - e2 * (S + 2.0 * (K * K)) + 2.0 * e1 * K - 1.0;
    // [moser_veselov_turn]
    if (!(slope < T(0.0))) break;
    T const move = residual / slope;
    K = K - move, S = P + K * K;
    found = magnitude(move) <= 1e-15 * K + tiny;
  }
  Three<T> const D{S * J[0] - K, S * J[1] - K, S * J[2] - K};
  T const inverse = 1.0 / P, x = (S * inverse) * (p[1] * p[2]), y = (S * inverse) * (p[2] * p[0]),
          z = (S * inverse) * (p[0] * p[1]);
  Three<T> const V{p[0] + (D[1] * D[2] * inverse * p[0] - body.d23 * x),
                   p[1] + (D[2] * D[0] * inverse * p[1] + body.d13 * y),
                   p[2] + (D[0] * D[1] * inverse * p[2] - body.d12 * z)};
  T const size = sqrt(S / (dot(V, V) + tiny)), along = (dot(p, V) + tiny) * size / S;
  return {{along, J[0] * (size * V[0]), J[1] * (size * V[1]), J[2] * (size * V[2])}, found};
}

}  // namespace actio::bodies
