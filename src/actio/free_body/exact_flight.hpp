// The exact motion of a free body over a step of any length, as one half turn and one twist.
//
// Short steps take the power series of short_flight.hpp. For long ones the momentum at half the step after M2 = 0 comes from Jacobi's functions,
// m = L (A_c cn, A_2 sn, A_d dn), the axes c and d being 1 and 3 or 3 and 1, and delta_1 = m2 m3/(m1 L), delta_3 = -m1 m2/(m3 L). The twist is the precession P about the momentum, seen
// from the axis n that the path stays away from, and an angle that belongs to the place:
//
//     (cos T, sin T)  along  (L m3, m1 m2) turned by P for n = 1,      (L m1, -m2 m3) turned by P for n = 3,
//     P = L J_j t - L (J_j - J_2) int_0^t m2^2/(m2^2 + mj^2) ds,       j = 3 or 1, the other one.
//
// Seen from an axis that the path comes near to, the integrand has a peak and the digits go with it; of the two axes one is always 45 degrees away.
#pragma once

#include "actio/free_body/elliptic.hpp"
#include "actio/free_body/short_flight.hpp"
#include "actio/free_body/third_kind.hpp"

namespace actio {
namespace detail {

/// \f$xy - zw\f$ without the cancellation, where the scalar has a fused multiplication.
template <Real S>
S difference_of_products(S const& x, S const& y, S const& z, S const& w) {
  if constexpr (std::is_same_v<S, double>) {
    double const zw = z * w, error = std::fma(-z, w, zw), difference = std::fma(x, y, -zw);
    return difference + error;
  } else {
    return x * y - z * w;
  }
}

/// How many terms of the power series are enough for all digits of S where \f$s_1t^2\f$ is at most \ref short_enough.
template <Real S>
constexpr int series_terms = std::numeric_limits<S>::digits10 < 20 ? 8 : std::numeric_limits<S>::digits10 < 60 ? 26 : 50;
inline constexpr double short_enough = 0.02;

template <Real S>
Flight<S> flight_from(InverseMoments<S> const& body, Orbit<S> const& orbit, S const& lever, S const& square, S const& cos_twist, S const& sin_twist) {
  S const rest = lever * (S(1) - square);
  Three<S> const delta{lever * (orbit.a - body.d12 * square), -lever * orbit.beside, -lever * (orbit.b - body.d23 * square)};
  return {delta, {-rest * body.d23, rest * body.d13, -rest * body.d12}, cos_twist, sin_twist, stretch_of(delta)};
}

template <Real S>
Flight<S> flight_by_series(InverseMoments<S> const& body, Orbit<S> const& orbit, S const& t) {
  using std::cos, std::sin;
  auto const flight = ShortFlight<S>::template at<series_terms<S>>(body, orbit, t);
  return flight_from<S>(body, orbit, flight.lever, flight.square, cos(flight.twist), sin(flight.twist));
}

template <Real S>
Flight<S> flight_by_elliptic_functions(InverseMoments<S> const& body, Three<S> const& u, Orbit<S> const& orbit, S const& t) {
  using std::cos, std::floor, std::sin, std::sqrt;
  // The path goes round the axis d, and the component along c changes its sign.
  S const inside = difference_of_products<S>(body.d23 * u[2], u[2], body.d12 * u[0], u[0]);  // J2 - 2H
  bool const round_third = !(inside * body.d13 < S(0));
  int const c = round_third ? 0 : 2, d = 2 - c;
  S const both = magnitude(body.d13), near_c = magnitude(round_third ? body.d12 : body.d23), near_d = magnitude(round_third ? body.d23 : body.d12);
  S const along_d = magnitude(round_third ? orbit.a : orbit.b), along_c = magnitude(round_third ? orbit.b : orbit.a);
  S const frequency = sqrt(S(near_d * along_d)), all = both * magnitude(inside) / (near_d * along_d), k2 = near_c * along_c / (near_d * along_d);
  // Closer to the separatrix than this the squares of what is left would fall below the smallest numbers.
  S const complement = all < std::numeric_limits<S>::min() / epsilon<S>() ? S(0) : all;
  S const Ac = sqrt(S(along_c / both)), Ad = sqrt(S(along_d / both)), A2 = sqrt(S(along_c / near_d));

  // Whole half periods, after which sn and cn change their signs, and the rest.
  JacobiFunctions<S> const jacobi(complement < S(1) ? complement : S(1));
  S const quarter = jacobi.quarter_period(), phase = frequency * t;
  S const halves = complement == S(0) ? S(0) : S(floor(S(phase / (S(2) * quarter) + S(1) / S(2))));
  S const u_rest = complement == S(0) ? phase : difference_of_products<S>(phase, S(1), S(2) * halves, quarter);
  auto [sn, cn, dn] = jacobi.at(u_rest);

  // The precession seen from the axis that the path stays away from.
  bool const from_c = Ac <= Ad;
  int const j = from_c ? d : c;
  S const g = from_c ? S(along_c / along_d) : S(near_c / near_d), weight = from_c ? S(g * both / near_d) : S(both / near_d);
  S const part = complement == S(0) && magnitude(phase) > S(1) ? integral_of_third_kind_on_the_separatrix<S>(magnitude(phase), magnitude(sn), g)
                                                               : integral_of_third_kind<S>(magnitude(sn), cn * cn, dn * dn, k2, g);
  S share = sn < S(0) ? S(-part) : part;
  if (halves != S(0)) share += S(2) * halves * integral_of_third_kind<S>(S(1), S(0), complement, k2, g);
  S const J_beyond = j == 0 ? body.d12 : S(-body.d23);  // J_j - J_2
  S const precession = body.J[j] * t - J_beyond * weight * share / frequency;

  // M2 grows where M1 M3 (J1 - J3) is positive. Of c the size may be zero, at half the period: then a little beside it. On the
  // separatrix both sizes fade away, and only their ratio matters.
  S const tiny = epsilon<S>() * epsilon<S>();
  if (complement == S(0) && dn < tiny) cn = dn = tiny;
  S mc = Ac * cn, md = Ad * dn, m2 = body.d13 < S(0) ? S(-A2 * sn) : S(A2 * sn);
  if (S const least = tiny * md; magnitude(mc) < least) mc = mc < S(0) ? S(-least) : least;
  S const m1 = c == 0 ? mc : md, m3 = c == 0 ? md : mc;
  bool const from_first = from_c == (c == 0);
  S const x = from_first ? m3 : m1, y = from_first ? S(m1 * m2) : S(-m2 * m3), length = sqrt(S(x * x + y * y));
  S const cosine = cos(precession), sine = sin(precession);
  S const lever = m2 / (body.d13 * m1 * m3), beside = m1 * m1 + m3 * m3, rest = lever * beside, first = m2 * m3 / m1, third = -m1 * m2 / m3;
  // 1 + delta_j delta_k as sums of one sign: next to the middle axis 1 - m2^2 would be a difference.
  S const across = body.d12 / body.d13, along = body.d23 / body.d13;
  Three<S> const stretch{across * (S(1) + third * third) + along * beside, beside, along * (S(1) + first * first) + across * beside};
  return {{first, lever * inside, third}, {-rest * body.d23, rest * body.d13, -rest * body.d12},
          (cosine * x - sine * y) / length, (sine * x + cosine * y) / length, stretch};
}

}  // namespace detail

/// The free flight of a body: exact, for every step length.
///
/// @param body  inverse moments of inertia, the middle one in the middle
/// @param u     direction of the body momentum
/// @param t     half the step times the amount of the momentum
/// Accuracy: a few roundings of the phase, that is about epsilon times the angle turned.
template <Real S>
Flight<S> exact_flight(InverseMoments<S> const& body, Three<S> const& u, S const& t) {
  Orbit<S> const orbit(body, u);
  if (!(orbit.s1 * t * t > S(detail::short_enough))) return detail::flight_by_series<S>(body, orbit, t);
  return detail::flight_by_elliptic_functions<S>(body, u, orbit, t);
}

}  // namespace actio
