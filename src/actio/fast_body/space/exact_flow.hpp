// The exact flow of the free body over a step of any length, as one half turn and one twist.
//
// Short steps take the power series of short_flow.hpp. For long ones the momentum at half the step after
// M2 = 0 comes from Jacobi's functions, m = L (A_c cn, A_2 sn, A_d dn), the axes c and d being 1 and 3 or 3
// and 1, and delta_1 = m2 m3/(m1 L), delta_3 = -m1 m2/(m3 L). The twist is the precession P about the
// momentum, seen from the axis n that the path stays away from, and an angle that depends on the point of the
// orbit:
//
//     (cos T, sin T)  along  (L m3, m1 m2) turned by P for n = 1,      (L m1, -m2 m3) turned by P for n = 3,
//     P = L J_j t - L (J_j - J_2) int_0^t m2^2/(m2^2 + mj^2) ds,       j = 3 or 1, the other one.
//
// Seen from an axis that the path comes near to, the integrand has a peak and the digits go with it; of the
// two axes one is always 45 degrees away.
//
// The quaternion e of half_turn.hpp is 1 at t = 0, and continuous in t: its sign counts the turns. For
// u.v = sum (1 + delta_j delta_k) u_i^2, and the three factors are sums of positive terms, so that v never
// vanishes. Where m_c = 0, and nowhere else, v is infinite: m_c^2 v is analytic there, not zero by the same
// sum, and m_c^2 is positive on both sides. So v/|v| is continuous. The vector (x, y) along which (cos T, sin
// T) is taken is analytic in t too; it never vanishes, for m1, m2 and m3 never do two at a time in the pairs
// that occur; and it begins along (1, 0). That holds with m_c and m2 as they are: both change their signs
// after half a period, under which the delta_i are invariant and (x, y) is not.
#pragma once

#include "actio/fast_body/space/elliptic.hpp"
#include "actio/fast_body/space/elliptic_integral_third_kind.hpp"
#include "actio/fast_body/space/short_flow.hpp"

namespace actio::bodies {
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

/// How many terms of the power series are enough for all digits of S where \f$s_1t^2\f$ is at most
/// \ref short_enough.
template <Real S>
constexpr int series_terms = std::numeric_limits<S>::digits10 < 20   ? 8
                             : std::numeric_limits<S>::digits10 < 60 ? 26
                                                                     : 50;
inline constexpr double short_enough = 0.02;

template <Real S>
StepParameters<S> parameters_from(InverseMoments<S> const& body, Orbit<S> const& orbit, S const& lever,
                                  S const& square, S const& cos_twist, S const& sin_twist) {
  S const rest = lever * (S(1) - square);
  Three<S> const delta{lever * (orbit.a - body.d12 * square), -lever * orbit.beside,
                       -lever * (orbit.b - body.d23 * square)};
  return {
      delta, {-rest * body.d23, rest * body.d13, -rest * body.d12}, cos_twist, sin_twist, stretch_of(delta)};
}

template <Real S, bool with_twist = true>
StepParameters<S> flow_by_series(InverseMoments<S> const& body, Orbit<S> const& orbit, S const& t) {
  using std::cos, std::sin;
  auto const parameters = ShortFlow<S>::template at<series_terms<S>>(body, orbit, t);
  if constexpr (!with_twist)
    return parameters_from<S>(body, orbit, parameters.lever, parameters.square, S(1), S(0));
  return parameters_from<S>(body, orbit, parameters.lever, parameters.square, cos(parameters.twist),
                            sin(parameters.twist));
}

/// The axis that an orbit encloses, and the constants of the motion on it.
template <Real S>
struct PathRound {
  S inside;            ///< \f$J_2-2H\f$
  int c, d;            ///< the path goes round the axis d, and the component along c changes its sign
  S both;              ///< \f$|J_1-J_3|\f$
  S near_c, near_d;    ///< \f$|J_2-J_d|\f$ and \f$|J_2-J_c|\f$
  S along_c, along_d;  ///< how far twice the energy is from \f$J_d\f$ and from \f$J_c\f$
  S frequency, complement, k2;  ///< of Jacobi's functions

  PathRound(InverseMoments<S> const& body, Three<S> const& u, Orbit<S> const& orbit) {
    using std::sqrt;
    inside = difference_of_products<S>(body.d23 * u[2], u[2], body.d12 * u[0], u[0]);
    bool const third = !(inside * body.d13 < S(0));
    c = third ? 0 : 2, d = 2 - c;
    both = magnitude(body.d13), near_c = magnitude(third ? body.d12 : body.d23),
    near_d = magnitude(third ? body.d23 : body.d12);
    along_d = magnitude(third ? orbit.a : orbit.b), along_c = magnitude(third ? orbit.b : orbit.a);
    S const all = both * magnitude(inside) / (near_d * along_d);
    frequency = sqrt(S(near_d * along_d)), k2 = near_c * along_c / (near_d * along_d);
    // Closer to the separatrix than this the squares of the remainder would fall below the smallest numbers.
    complement = all < std::numeric_limits<S>::min() / epsilon<S>() ? S(0) : all;
    if (complement > S(1)) complement = S(1);
  }
};

/// The precession P, seen from the axis that the path stays away from: the other one than j.
/// @param sn,cn,dn  of the remainder of the phase after that many whole half periods
template <Real S>
S precession(InverseMoments<S> const& body, PathRound<S> const& path, bool from_c, S const& t, S const& phase,
             S const& halves, typename JacobiFunctions<S>::Values const& at) {
  int const j = from_c ? path.d : path.c;
  S const g = from_c ? S(path.along_c / path.along_d) : S(path.near_c / path.near_d),
          weight = from_c ? S(g * path.both / path.near_d) : S(path.both / path.near_d);
  S const size = magnitude(at.sn);
  S const part = path.complement == S(0) && magnitude(phase) > S(1)
                     ? elliptic_integral_third_kind_on_separatrix<S>(magnitude(phase), size, g)
                     : elliptic_integral_third_kind<S>(size, at.cn * at.cn, at.dn * at.dn, path.k2, g);
  S share = at.sn < S(0) ? S(-part) : part;
  if (halves != S(0))
    share += S(2) * halves * elliptic_integral_third_kind<S>(S(1), S(0), path.complement, path.k2, g);
  S const J_beyond = j == 0 ? body.d12 : S(-body.d23);  // J_j - J_2
  return body.J[j] * t - J_beyond * weight * share / path.frequency;
}

template <Real S, bool with_twist = true>
StepParameters<S> flow_by_elliptic_functions(InverseMoments<S> const& body, Three<S> const& u,
                                             Orbit<S> const& orbit, S const& t) {
  using std::cos, std::floor, std::sin, std::sqrt;
  PathRound<S> const path(body, u, orbit);
  S const Ac = sqrt(S(path.along_c / path.both)), Ad = sqrt(S(path.along_d / path.both)),
          A2 = sqrt(S(path.along_c / path.near_d));
  bool const steep = path.complement == S(0);  // on the separatrix: no period

  // Whole half periods, after each of which sn and cn change their signs, and the rest.
  JacobiFunctions<S> const jacobi(path.complement);
  S const quarter = jacobi.quarter_period(), phase = path.frequency * t;
  S const halves = steep ? S(0) : S(floor(S(phase / (S(2) * quarter) + S(1) / S(2))));
  auto const rest = jacobi.at(steep ? phase : difference_of_products<S>(phase, S(1), S(2) * halves, quarter));
  bool const odd = halves != S(2) * S(floor(S(halves / S(2))));
  S cn = odd ? S(-rest.cn) : rest.cn, dn = rest.dn;

  // M2 grows where M1 M3 (J1 - J3) is positive. Of c the size may be zero, at half the period: then a little
  // beside it. On the separatrix both sizes fade away, and only their ratio matters.
  S const tiny = epsilon<S>() * epsilon<S>();
  if (steep && dn < tiny) cn = dn = tiny;
  S mc = Ac * cn, md = Ad * dn, m2 = odd != (body.d13 < S(0)) ? S(-A2 * rest.sn) : S(A2 * rest.sn);
  if (S const least = tiny * md; magnitude(mc) < least) mc = mc < S(0) ? S(-least) : least;
  S const m1 = path.c == 0 ? mc : md, m3 = path.c == 0 ? md : mc;
  S const lever = m2 / (body.d13 * m1 * m3), beside = m1 * m1 + m3 * m3, shear = lever * beside,
          first = m2 * m3 / m1, third = -m1 * m2 / m3;
  // 1 + delta_j delta_k as sums of one sign: next to the middle axis 1 - m2^2 would be a difference.
  S const across = body.d12 / body.d13, along = body.d23 / body.d13;
  Three<S> const stretch{across * (S(1) + third * third) + along * beside, beside,
                         along * (S(1) + first * first) + across * beside};
  StepParameters<S> parameters{{first, lever * path.inside, third},
                               {-shear * body.d23, shear * body.d13, -shear * body.d12},
                               S(1),
                               S(0),
                               stretch};
  if constexpr (with_twist) {
    bool const from_c = Ac <= Ad, from_first = from_c == (path.c == 0);
    S const turned = precession<S>(body, path, from_c, t, phase, halves, rest), cosine = cos(turned),
            sine = sin(turned);
    S const x = from_first ? m3 : m1, y = from_first ? S(m1 * m2) : S(-m2 * m3),
            length = sqrt(S(x * x + y * y));
    parameters.cos_twist = (cosine * x - sine * y) / length,
    parameters.sin_twist = (sine * x + cosine * y) / length;
  }
  return parameters;
}

}  // namespace detail

/// The exact flow of the free body, for every step length.
///
/// @param body  inverse moments of inertia, the middle one in the middle
/// @param u     direction of the body momentum
/// @param t     half the step times the magnitude of the momentum
/// Accuracy: a few roundings of the phase, that is about epsilon times the angle turned.
template <Real S>
StepParameters<S> exact_flow(InverseMoments<S> const& body, Three<S> const& u, S const& t) {
  Orbit<S> const orbit(body, u);
  if (!(orbit.s1 * t * t > S(detail::short_enough))) return detail::flow_by_series<S>(body, orbit, t);
  return detail::flow_by_elliptic_functions<S>(body, u, orbit, t);
}

/// The same without its twist, for the momentum alone: no integral, no sine and no cosine. The \f$\delta_i\f$
/// are those of \ref exact_flow to the bit.
template <Real S>
StepParameters<S> exact_flow_of_momentum(InverseMoments<S> const& body, Three<S> const& u, S const& t) {
  Orbit<S> const orbit(body, u);
  if (!(orbit.s1 * t * t > S(detail::short_enough))) return detail::flow_by_series<S, false>(body, orbit, t);
  return detail::flow_by_elliptic_functions<S, false>(body, u, orbit, t);
}

}  // namespace actio::bodies
