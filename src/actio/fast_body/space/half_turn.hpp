// One step of a free body in three dimensions, as a half turn, which is a rotation by pi, and a rotation
// about the momentum (a twist).
//
// Let u be the direction of the body momentum and L its magnitude. A step of the scheme of Moser and Veselov,
// of the same scheme with other moments of inertia, and of the exact motion too, takes u to its mirror image
// under a half turn, about the null vector v of diag(delta) + [u]x:
//
//     v_i = (1 + delta_j delta_k) u_i + (delta_k - delta_j) u_j u_k, u' = 2 (u.v)/(v.v) v - u, (i, j, k)
//     cyclic.
//
// The three numbers delta_i belong to the orbit and to the step length, not to the point of the orbit. The
// rotation of the body over the step is the half turn followed by a turn about the momentum, which in space
// stands still: by an angle given by the twist T, again the same for all steps. As a unit quaternion,
//
//     e = ( cos T (u.v),  (sin T + cos T delta_i) v_i ) / |v|,          q' = q e.
//
// So a step needs no iteration: one division for the momentum, one square root more for the attitude. Which
// delta and T make which method is told in explicit_moser_veselov.hpp, modified_inertia.hpp and
// exact_flow.hpp.
#pragma once

#include <array>
#include <cmath>

namespace actio::bodies {

/// Three numbers of any kind: double or of many digits.
template <class T>
using Three = std::array<T, 3>;
/// A quaternion, scalar first.
template <class T>
using Four = std::array<T, 4>;

/// The parameters of a step of one length on one orbit of a free body, in numbers without dimension: those of
/// the exact flow, or of the Moser-Veselov scheme.
template <class T>
struct StepParameters {
  Three<T> delta;  ///< \f$\delta_i = D_i/L\f$, of the axis of the half turn
  /// \f$\delta_k-\delta_j\f$, (i, j, k) cyclic: given apart, for a difference would lose its digits where
  /// moments are nearly equal
  Three<T> gap;
  T cos_twist;  ///< \f$\cos T\f$
  T sin_twist;  ///< \f$\sin T\f$
  /// \f$1+\delta_j\delta_k\f$: given apart, for the sum may be as small as the distance to the middle axis,
  /// for a long step
  Three<T> stretch;
};

/// \f$1+\delta_j\delta_k\f$, where nothing cancels: for short steps.
template <class T>
Three<T> stretch_of(Three<T> const& delta) {
  return {delta[1] * delta[2] + 1, delta[2] * delta[0] + 1, delta[0] * delta[1] + 1};
}

/// The state of a body in the axes of the steps: direction of the body momentum, and attitude (body to
/// space).
template <class T>
struct FrameState {
  Three<T> direction;  ///< unit vector along the momentum in the body frame
  Four<T> attitude;    ///< unit quaternion, scalar first
};

/// The inner product.
template <class T>
[[gnu::always_inline]] inline T dot(Three<T> const& a, Three<T> const& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// The sum, entry by entry.
template <class T>
[[gnu::always_inline]] inline Three<T> plus(Three<T> const& a, Three<T> const& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
/// The sum, entry by entry.
template <class T>
[[gnu::always_inline]] inline Four<T> plus(Four<T> const& a, Four<T> const& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
/// The difference, entry by entry.
template <class T>
[[gnu::always_inline]] inline Three<T> minus(Three<T> const& a, Three<T> const& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// The difference, entry by entry.
template <class T>
[[gnu::always_inline]] inline Four<T> minus(Four<T> const& a, Four<T> const& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}
/// The product of quaternions.
template <class T>
[[gnu::always_inline]] inline Four<T> compose(Four<T> const& p, Four<T> const& q) {
  // Sums of two and two: half as long a wait as one after the other.
  return {(p[0] * q[0] - p[1] * q[1]) - (p[2] * q[2] + p[3] * q[3]),
          (p[0] * q[1] + q[0] * p[1]) + (p[2] * q[3] - p[3] * q[2]),
          (p[0] * q[2] + q[0] * p[2]) + (p[3] * q[1] - p[1] * q[3]),
          (p[0] * q[3] + q[0] * p[3]) + (p[1] * q[2] - p[2] * q[1])};
}

/// A map that takes many steps with the same parameters: what does not change from step to step is computed
/// once.
///
/// Off the orbit that the numbers belong to, rounding is propagated and not magnified, while steps are short.
/// Long ones, where a \f$|\delta_i|\f$ exceeds 1, may magnify it in each step: many of them in a row are
/// taken by `FreeSteps`, which projects back onto the orbit.
template <class T>
class HalfTurn {
 public:
  HalfTurn() = default;
  /// @param parameters  of the orbit on which the steps will be
  explicit HalfTurn(StepParameters<T> const& parameters)
      : along_(parameters.cos_twist), about_(parameters.sin_twist) {
    for (int i = 0; i < 3; ++i) {
      stretch_[i] = parameters.stretch[i];
      shear_[i] = parameters.gap[i];
      across_[i] = parameters.cos_twist * parameters.delta[i] + parameters.sin_twist;
    }
  }

  /// The axis of the half turn that maps the direction u to the next, of any length.
  [[gnu::always_inline]] Three<T> axis(Three<T> const& u) const {
    return {stretch_[0] * u[0] + shear_[0] * (u[1] * u[2]), stretch_[1] * u[1] + shear_[1] * (u[2] * u[0]),
            stretch_[2] * u[2] + shear_[2] * (u[0] * u[1])};
  }

  /// The momentum alone: 9 products for the axis, 6 and a division for the half turn.
  [[gnu::always_inline]] void step(Three<T>& u) const {
    // [half_turn]
    Three<T> const v = axis(u);
    T const twice = 2 * dot(u, v), inverse = 1 / dot(v, v);
    u = {(twice * v[0]) * inverse - u[0], (twice * v[1]) * inverse - u[1], (twice * v[2]) * inverse - u[2]};
    // [half_turn]
  }

  /// Momentum and attitude.
  [[gnu::always_inline]] void step(FrameState<T>& body) const {
    using std::sqrt;
    Three<T>& u = body.direction;
    // [half_turn_attitude]
    Three<T> const v = axis(u);
    T const uv = dot(u, v), inverse = 1 / dot(v, v), root = sqrt(inverse);
    Four<T> const q =
        compose(body.attitude, {along_ * uv, across_[0] * v[0], across_[1] * v[1], across_[2] * v[2]});
    body.attitude = {q[0] * root, q[1] * root, q[2] * root, q[3] * root};
    T const twice = 2 * uv;
    u = {(twice * v[0]) * inverse - u[0], (twice * v[1]) * inverse - u[1], (twice * v[2]) * inverse - u[2]};
    // [half_turn_attitude]
  }

  /// The same for one step of any length: with u x v in place of -delta_i v_i, which cancels where a long
  /// step begins or ends near the middle axis.
  void leap(FrameState<T>& body) const {
    using std::sqrt;
    Three<T>& u = body.direction;
    Three<T> const v = axis(u);
    T const uv = dot(u, v), inverse = 1 / dot(v, v), root = sqrt(inverse);
    Four<T> e{along_ * uv * root, {}, {}, {}};
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      e[1 + i] = (about_ * v[i] - along_ * (u[j] * v[k] - u[k] * v[j])) * root;
    }
    body.attitude = compose(body.attitude, e);
    for (int i = 0; i < 3; ++i) u[i] = 2 * uv * inverse * v[i] - u[i];
  }
  /// The momentum alone, to the same bits.
  void leap(Three<T>& u) const {
    Three<T> const v = axis(u);
    T const uv = dot(u, v), inverse = 1 / dot(v, v);
    for (int i = 0; i < 3; ++i) u[i] = 2 * uv * inverse * v[i] - u[i];
  }

 private:
  Three<T> stretch_, shear_, across_;
  T along_, about_;
};

}  // namespace actio::bodies
