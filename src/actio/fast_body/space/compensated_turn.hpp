// Half turns for very many steps: the small change of a step is added with what the sums before have lost.
//
// A step writes the new momentum as a rounded whole, which costs one rounding of the whole a step. Here the change itself is worked out, to all its digits, and summed with a
// carry (Kahan): with v = u + eps, eps_i = delta_j delta_k u_i + (delta_k - delta_j) u_j u_k,
//
//     u' - u = 2 (u x eps) x v / (v.v),      q' - q = q (e - 1),      e = (cos T (u.v), sin T v - cos T (u x eps)) / |v|,      e_0 - 1 = -(e_1^2 + e_2^2 + e_3^2)/(1 + e_0).
//
// Written with u x eps, the rotation takes the new momentum to the old one whatever rounding has done to the delta: momentum in space does not feel it.
#pragma once

#include "actio/fast_body/space/half_turn.hpp"

namespace actio {

/// A body's place as an unevaluated sum.
template <class T>
struct PlaceWithCarry {
  BodyPlace<T> place;           ///< the leading part
  BodyPlace<T> carry{{}, {}};   ///< what is to be added to it

  /// Adds a small change, and keeps what the sums lose.
  template <std::size_t N>
  [[gnu::always_inline]] static void add(std::array<T, N>& sum, std::array<T, N>& carry, std::array<T, N> const& change) {
    auto const y = plus(change, carry), next = plus(sum, y);
    carry = minus(y, minus(next, sum));
    sum = next;
  }
};

/// A flight made ready for very many steps.
template <class T>
class CompensatedTurn {
 public:
  CompensatedTurn() = default;
  /// @param flight  of the orbit on which the steps will be
  explicit CompensatedTurn(Flight<T> const& flight) : cos_twist_(flight.cos_twist), sin_twist_(flight.sin_twist) {
    for (int i = 0; i < 3; ++i) {
      excess_[i] = flight.delta[(i + 1) % 3] * flight.delta[(i + 2) % 3];
      shear_[i] = flight.gap[i];
    }
  }

  /// The momentum alone.
  [[gnu::always_inline]] void step_momentum(PlaceWithCarry<T>& body) const {
    Three<T> const& u = body.place.direction;
    Three<T> const small = excess(u), v = {u[0] + small[0], u[1] + small[1], u[2] + small[2]};
    turn(body, cross(u, small), v, 1 / dot(v, v));
  }

  /// Momentum and attitude.
  [[gnu::always_inline]] void step(PlaceWithCarry<T>& body) const {
    using std::sqrt;
    Three<T> const& u = body.place.direction;
    Three<T> const small = excess(u), v = {u[0] + small[0], u[1] + small[1], u[2] + small[2]}, across = cross(u, small);
    T const inverse = 1 / dot(v, v), root = sqrt(inverse), s = sin_twist_ * root, c = cos_twist_ * root;
    // [compensated_attitude]
    Three<T> const e = {s * v[0] - c * across[0], s * v[1] - c * across[1], s * v[2] - c * across[2]};
    T const e0 = c * dot(u, v), less = e0 > 0 ? -dot(e, e) / (1 + e0) : e0 - 1;
    // [compensated_attitude]
    Four<T> const change = compose(body.place.attitude, {less, e[0], e[1], e[2]});
    turn(body, across, v, inverse);
    PlaceWithCarry<T>::add(body.place.attitude, body.carry.attitude, change);
  }

 private:
  [[gnu::always_inline]] Three<T> excess(Three<T> const& u) const {
    return {excess_[0] * u[0] + shear_[0] * (u[1] * u[2]), excess_[1] * u[1] + shear_[1] * (u[2] * u[0]), excess_[2] * u[2] + shear_[2] * (u[0] * u[1])};
  }
  [[gnu::always_inline]] static Three<T> cross(Three<T> const& a, Three<T> const& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  [[gnu::always_inline]] static void turn(PlaceWithCarry<T>& body, Three<T> const& across, Three<T> const& v, T const& inverse) {
    // [compensated_turn]
    Three<T> const change = cross(across, v);
    T const twice = 2 * inverse;
    PlaceWithCarry<T>::add(body.place.direction, body.carry.direction, Three<T>{twice * change[0], twice * change[1], twice * change[2]});
    // [compensated_turn]
  }

  Three<T> excess_, shear_;
  T cos_twist_, sin_twist_;
};

}  // namespace actio
