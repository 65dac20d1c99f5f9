// Half turns for very many steps: the small change of a step is added by compensated summation (Kahan).
//
// A step writes the new momentum as a rounded whole, which costs one rounding of the whole a step. Here the
// change itself is worked out, to all its digits, and summed with the rounding error of the sum so far: with
// v = u + eps, eps_i = delta_j delta_k u_i + (delta_k - delta_j) u_j u_k,
//
//     u' - u = 2 (u x eps) x v / (v.v), q' - q = q (e - 1), e = (cos T (u.v), sin T v - cos T (u x
//     eps)) / |v|, e_0 - 1 = -(e_1^2 + e_2^2 + e_3^2)/(1 + e_0).
//
// Written with u x eps, the rotation takes the new momentum to the old one whatever the rounding of the
// delta: the momentum in space does not depend on it.
#pragma once

#include "actio/fast_body/space/half_turn.hpp"

namespace actio::bodies {

/// A body's state as an unevaluated sum.
template <class T>
struct CompensatedState {
  FrameState<T> state;                 ///< the leading part
  FrameState<T> compensation{{}, {}};  ///< what is to be added to it

  /// Adds a small change; `compensation` accumulates the rounding errors of the sum.
  template <std::size_t N>
  [[gnu::always_inline]] static void add(std::array<T, N>& sum, std::array<T, N>& compensation,
                                         std::array<T, N> const& change) {
    auto const y = plus(change, compensation), next = plus(sum, y);
    compensation = minus(y, minus(next, sum));
    sum = next;
  }
};

/// A map that takes very many steps with the same parameters.
template <class T>
class CompensatedHalfTurn {
 public:
  CompensatedHalfTurn() = default;
  /// @param parameters  of the orbit on which the steps will be
  explicit CompensatedHalfTurn(StepParameters<T> const& parameters)
      : cos_twist_(parameters.cos_twist), sin_twist_(parameters.sin_twist) {
    for (int i = 0; i < 3; ++i) {
      excess_[i] = parameters.delta[(i + 1) % 3] * parameters.delta[(i + 2) % 3];
      shear_[i] = parameters.gap[i];
    }
  }

  /// The momentum alone.
  [[gnu::always_inline]] void step_momentum(CompensatedState<T>& body) const {
    Three<T> const& u = body.state.direction;
    Three<T> const small = excess(u), v = {u[0] + small[0], u[1] + small[1], u[2] + small[2]};
    turn(body, cross(u, small), v, 1 / dot(v, v));
  }

  /// Momentum and attitude.
  [[gnu::always_inline]] void step(CompensatedState<T>& body) const {
    using std::sqrt;
    Three<T> const& u = body.state.direction;
    Three<T> const small = excess(u), v = {u[0] + small[0], u[1] + small[1], u[2] + small[2]},
                   across = cross(u, small);
    T const inverse = 1 / dot(v, v), root = sqrt(inverse), s = sin_twist_ * root, c = cos_twist_ * root;
    // [compensated_attitude]
    Three<T> const e = {s * v[0] - c * across[0], s * v[1] - c * across[1], s * v[2] - c * across[2]};
    T const e0 = c * dot(u, v), less = e0 > 0 ? -dot(e, e) / (1 + e0) : e0 - 1;
    // [compensated_attitude]
    Four<T> const change = compose(body.state.attitude, {less, e[0], e[1], e[2]});
    turn(body, across, v, inverse);
    CompensatedState<T>::add(body.state.attitude, body.compensation.attitude, change);
  }

 private:
  [[gnu::always_inline]] Three<T> excess(Three<T> const& u) const {
    return {excess_[0] * u[0] + shear_[0] * (u[1] * u[2]), excess_[1] * u[1] + shear_[1] * (u[2] * u[0]),
            excess_[2] * u[2] + shear_[2] * (u[0] * u[1])};
  }
  [[gnu::always_inline]] static Three<T> cross(Three<T> const& a, Three<T> const& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  [[gnu::always_inline]] static void turn(CompensatedState<T>& body, Three<T> const& across,
                                          Three<T> const& v, T const& inverse) {
    // [compensated_turn]
    Three<T> const change = cross(across, v);
    T const twice = 2 * inverse;
    CompensatedState<T>::add(body.state.direction, body.compensation.direction,
                             Three<T>{twice * change[0], twice * change[1], twice * change[2]});
    // [compensated_turn]
  }

  Three<T> excess_, shear_;
  T cos_twist_, sin_twist_;
};

}  // namespace actio::bodies
