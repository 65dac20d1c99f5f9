// A free body over a part of a step, as changes of momentum and attitude: exact, or by Moser and Veselov.
//
// As in short_step.hpp the time runs from 0 to 2 and the momentum is a pure number, p = hM/(2 I) with some
// unit I of inertia.
#pragma once

#include "actio/fast_body/space/exact_flow.hpp"
#include "actio/fast_body/space/explicit_moser_veselov.hpp"
#include "actio/fast_body/space/short_step.hpp"
#include "actio/numbers/errors.hpp"

namespace actio::bodies {

/// What a drift does to a body.
template <class T>
struct RotorMotion {
  Three<T> change;  ///< of the momentum
  Four<T> turn;     ///< \f$e-1\f$ for the rotation e, after which the attitude is \f$qe\f$
};

/// The product of vectors.
template <class T>
[[gnu::always_inline]] inline Three<T> cross_product(Three<T> const& a, Three<T> const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

namespace detail {

/// e - 1 of a unit quaternion, without the cancellation.
template <class T>
[[gnu::always_inline]] inline Four<T> less_one(Four<T> const& e) {
  T const across = e[1] * e[1] + e[2] * e[2] + e[3] * e[3];
  return {e[0] > T{} ? T(-across / (1.0 + e[0])) : T(e[0] - 1.0), e[1], e[2], e[3]};
}
/// From the parameters of a half turn, for a momentum of the size `size` along u: as in
/// compensated_half_turn.hpp, u' - u = 2 (u x v) x v/(v.v), and u x v by the small part of v where there is
/// one.
template <class T>
RotorMotion<T> motion_of(StepParameters<T> const& parameters, Three<T> const& u, T const& size) {
  using std::sqrt;
  auto const& delta = parameters.delta;
  Three<T> v, excess;
  for (int i = 0; i < 3; ++i) {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    T const shear = parameters.gap[i] * (u[j] * u[k]);
    v[i] = parameters.stretch[i] * u[i] + shear, excess[i] = delta[j] * delta[k] * u[i] + shear;
  }
  bool const is_short = base_value(dot(delta, delta)) < Base<T>(0.1);
  Three<T> const across = cross_product(u, is_short ? excess : v), change = cross_product(across, v);
  T const inverse = 1.0 / dot(v, v), root = sqrt(inverse), twice = 2.0 * inverse * size,
          s = parameters.sin_twist * root, c = parameters.cos_twist * root;
  return {{twice * change[0], twice * change[1], twice * change[2]},
          less_one(Four<T>{c * dot(u, v), s * v[0] - c * across[0], s * v[1] - c * across[1],
                           s * v[2] - c * across[2]})};
}
template <class T>
RotorMotion<T> any_rotor(InverseMoments<Base<T>> const& body, Three<T> const& p);

/// Magnitude and direction of a momentum, or zero.
template <class T>
T size_of(Three<T> const& p, Three<T>& u) {
  using std::sqrt;
  T const size = sqrt(dot(p, p));
  if (!is_finite(base_value(size)))
    throw NotFinite("two bodies: momentum of a body, in the course of the motion");
  u = {p[0] / size, p[1] / size, p[2] / size};
  return size;
}
/// The same body for momenta that have rates of change.
template <class T>
InverseMoments<T> constant_body(InverseMoments<Base<T>> const& body) {
  InverseMoments<T> result;
  for (int i = 0; i < 3; ++i) result.J[i] = T(body.J[i]);
  result.d12 = T(body.d12), result.d23 = T(body.d23), result.d13 = T(body.d13);
  return result;
}
/// The exact motion of any length. Over dual numbers, which elliptic functions are not written for, it is
/// composed of equal parts that are short enough for the series; packs go lane after lane.
template <class T>
[[gnu::noinline]] RotorMotion<T> long_rotor(InverseMoments<Base<T>> const& body, Three<T> const& p) {
  if constexpr (is_pack<Base<T>>) {
    using One = std::conditional_t<is_dual<T>, Dual<double>, double>;
    RotorMotion<T> all;
    for (int k = 0; k < Base<T>::lanes; ++k) try {
        set_lane(all, k, any_rotor<One>(in_lane<InverseMoments<double>>(body, k), in_lane<Three<One>>(p, k)));
      } catch (NotFinite const&) {
        One const none = std::numeric_limits<double>::quiet_NaN();
        set_lane(all, k, RotorMotion<One>{{none, none, none}, {none, none, none, none}});
      }
    return all;
  } else {
    if (base_value(dot(p, p)) == Base<T>(0))
      return {{}, {T{}, body.J[0] * p[0], body.J[1] * p[1], body.J[2] * p[2]}};
    Three<T> u;
    T const size = size_of(p, u);
    if constexpr (is_dual<T>) {
      auto const lifted = constant_body<T>(body);
      Orbit<T> const orbit(lifted, u);
      int const parts = 1 + static_cast<int>(to_double(base_value(sqrt(orbit.s1 * size * size + 1e-300))) /
                                             std::sqrt(short_enough));
      FrameState<T> moved{u, {T{} + 1.0, T{}, T{}, T{}}};
      T const t = size / double(parts);
      auto const flow = ShortFlow<T>::template at<8>(lifted, orbit, t);
      HalfTurn<T> const part(
          parameters_from<T>(lifted, orbit, flow.lever, flow.square, cos(flow.twist), sin(flow.twist)));
      for (int k = 0; k < parts; ++k) part.step(moved);
      Three<T> const d = minus(moved.direction, u);
      return {{size * d[0], size * d[1], size * d[2]}, less_one(moved.attitude)};
    } else {
      return motion_of<T>(exact_flow<T>(body, u, size), u, size);
    }
  }
}

}  // namespace detail

/// The exact motion of a free body.
/// @param body   inverse moments times the part of the step, in that unit
/// @param terms  5 or 8, as many terms of the series as the last step needed; in, out
template <class T>
[[gnu::always_inline]] inline RotorMotion<T> exact_rotor(InverseMoments<Base<T>> const& body,
                                                         Three<T> const& p, int& terms) {
  if constexpr (OfDoubles<T>) {
    if (terms == 5) {
      auto const short_one = short_motion<5, T>(StepTable<5, Base<T>>::get(), body, p);
      if (all_within<5>(short_one.reach)) [[likely]]
        return {short_one.change, detail::less_one(short_one.turn)};
    }
    auto const longer = short_motion<8, T>(StepTable<8, Base<T>>::get(), body, p);
    terms = longer.reach.turn <= T(short_reach<5> / 2) && longer.reach.twist <= T(short_twist<5> / 2) ? 5 : 8;
    if (all_within<8>(longer.reach)) return {longer.change, detail::less_one(longer.turn)};
  }
  return detail::long_rotor<T>(body, p);
}
/// The same where nothing is known of the step before.
template <class T>
RotorMotion<T> detail::any_rotor(InverseMoments<Base<T>> const& body, Three<T> const& p) {
  int terms = 8;
  return exact_rotor<T>(body, p, terms);
}

namespace detail {
/// The parameters of a step of Moser and Veselov; over dual numbers by those of the values and one step of
/// Newton's method.
template <class T>
StepParameters<T> parameters_of_scheme(HalfStep<T> const& step, Three<T> const& u, bool& found) {
  if constexpr (is_dual<T>) {
    HalfStep<Base<T>> const values{
        {step.j[0].value, step.j[1].value, step.j[2].value}, step.d12.value, step.d23.value};
    auto const of_values =
        moser_veselov_parameters<Base<T>>(values, {u[0].value, u[1].value, u[2].value}, found);
    T const kappa(of_values.sin_twist / of_values.cos_twist);
    TwistFromMiddle<T> const equation(step, u);
    return equation.parameters(kappa - equation.residual(kappa) / equation.slope(kappa));
  } else {
    return moser_veselov_parameters<T>(step, u, found);
  }
}
}  // namespace detail

/// The same by the scheme of Moser and Veselov.
/// @throws OutsideDomain  where it has no solution
template <class T>
RotorMotion<T> moser_veselov_rotor(InverseMoments<Base<T>> const& constant, Three<T> const& p) {
  auto const body = detail::constant_body<T>(constant);
  if (base_value(dot(p, p)) == Base<T>(0)) return {};
  Three<T> u;
  T const size = detail::size_of(p, u);
  bool found = true;
  auto const parameters = detail::parameters_of_scheme<T>(
      {{size * body.J[0], size * body.J[1], size * body.J[2]}, size * body.d12, size * body.d23}, u, found);
  if (!found)
    throw OutsideDomain(
        "Moser-Veselov rotor",
        "the step is too long for the scheme to have a solution; half the angle that a body turns in it",
        to_double(base_value(T(size * body.J[1]))), 0.5);
  return detail::motion_of<T>(parameters, u, size);
}

}  // namespace actio::bodies
