// A short step of a free body that is not prepared: for a momentum that has just changed, as under a torque.
//
// The half turn of half_turn.hpp with the series of short_flow.hpp, both in the momentum p itself instead of
// its direction. Time runs from 0 to 2 and p is a pure number: p = hM/(2 I) with some unit I of inertia, and
// moments in that unit. The magnitude |p| is needed nowhere, so there is no root. With V = v|p| the axis of
// the half turn,
//
//     tan^2(u, V) = |p x V|^2/(p.V)^2 = sum (D_i V_i)^2/(p.V)^2 =: e2,        |p||V| = (p.V) sqrt(1 + e2),
//
// where e2 is small, so that its root is a short series, and one division remains. A body at rest is no
// exception.
#pragma once

#include "actio/fast_body/space/short_flow.hpp"

namespace actio::bodies {

/// Coefficients of all the series of a \ref short_step: \ref ShortSeries, \f$(-1)^n/(2n)!\f$,
/// \f$(-1)^n/(2n+1)!\f$ and those of \f$(1+x)^{-1/2}\f$.
///
/// The sines are good to 1e-17 for \f$T^2\f$ up to 1/25 with 6 terms, up to 1/4 with 8.
template <int terms, class T = double>
struct StepTable : detail::ShortTable<terms, T> {
  static constexpr int sines = terms > 5 ? 8 : 6;   ///< terms of sine and cosine
  static constexpr int roots = terms > 5 ? 10 : 6;  ///< terms of the inverse root
  std::array<T, sines> cosine;                      ///< of the cosine
  std::array<T, sines> sinc;                        ///< of the sine over its argument
  std::array<T, roots> inverse_root;                ///< of the inverse root

  StepTable()
    requires is_pack<T>
  {
    set_all_lanes(*this, StepTable<terms>());
  }
  StepTable()
    requires std::same_as<T, double>
  {
    long double c = 1, b = 1;
    for (int n = 0; n < sines; ++n) {
      cosine[n] = static_cast<double>(c), sinc[n] = static_cast<double>(c / (2 * n + 1));
      c /= -static_cast<long double>((2 * n + 1) * (2 * n + 2));
    }
    for (int n = 0; n < roots; ++n) {
      inverse_root[n] = static_cast<double>(b);
      b *= -static_cast<long double>(2 * n + 1) / (2 * n + 2);
    }
  }
  /// The table, made once. Take the reference before a loop.
  static StepTable const& get() {
    static StepTable const table;
    return table;
  }
};

/// How far a short step reached: both must stay small, or the step is none.
template <class T>
struct Reach {
  T turn;   ///< \f$X + e_2\f$, at most \ref short_reach
  T twist;  ///< \f$T^2\f$, at most \ref short_twist
};
/// The largest \f$X + e_2\f$ for which nothing beyond rounding is left out of a \ref short_step with so many
/// terms: \f$(0.41X)^{terms} = \varepsilon/2\f$.
template <int terms>
inline constexpr double short_reach = terms == 5   ? 1.5e-3
                                      : terms == 8 ? 2.4e-2
                                                   : 0;
/// The largest \f$T^2\f$ for the sines that go with them.
template <int terms>
inline constexpr double short_twist = terms == 5 ? 0.04 : 0.25;

/// Whether the step is exact to rounding. A NaN is not.
template <int terms, class T>
[[gnu::always_inline]] inline bool all_within(Reach<T> const& reach) {
  bool const turn = reach.turn <= T(short_reach<terms>), twist = reach.twist <= T(short_twist<terms>);
  return turn && twist;
}

/// What a free motion over the time 2 does.
template <class T>
struct ShortMotion {
  Four<T> turn;     ///< the rotation from the attitude after it to that before it, in the axes of the body
  Three<T> change;  ///< of the momentum
  Reach<T> reach;   ///< whether that was a short step; if not, the others have no meaning
};

/// A free motion over the time 2: how much momentum and attitude change.
/// @param  table  of the series, with 5 or 8 terms
/// @param  body   inverse moments; those of a step by a part c of the whole are c times as large, c may be
///                negative
/// @param  p      momentum, a pure number
template <int terms, class T>
[[gnu::always_inline]] inline ShortMotion<T> short_motion(StepTable<terms, Base<T>> const& table,
                                                          InverseMoments<Base<T>> const& body,
                                                          Three<T> const& p) {
  double const tiny = 1e-140;  // so that a body at rest has a direction; its inverse has a square
  T const x = p[0] * p[0], y = p[1] * p[1], z = p[2] * p[2], pp = x + y + (z + tiny), inverse = 1.0 / pp;
  T const A = body.d12 * y + body.d13 * z, B = body.d13 * x + body.d23 * y,
          beside = body.d12 * x - body.d23 * z;
  T const X = body.d12 * B + body.d23 * A, AB = A * B, Y = body.d12 * body.d23 * AB, W = AB * inverse;
  auto const s = ShortSeries<T>::template by_table<terms>(table, X, Y, W);

  // D_i, and the axis V.
  T const m2 = AB * s.square, rest = s.lever * (1.0 - W * s.square);
  T const D1 = s.lever * (A - body.d12 * m2), D2 = -(s.lever * beside), D3 = s.lever * (body.d23 * m2 - B);
  T const e1 = D2 * D3 * inverse, e2 = D3 * D1 * inverse, e3 = D1 * D2 * inverse;
  T const V1 = p[0] + (e1 * p[0] - rest * body.d23 * (p[1] * p[2])),
          V2 = p[1] + (e2 * p[1] + rest * body.d13 * (p[2] * p[0])),
          V3 = p[2] + (e3 * p[2] - rest * body.d12 * (p[0] * p[1]));

  // p.V and how far V is from p.
  T const along = 1.0 / ((pp + e1 * x) + (e2 * y + e3 * z)), w1 = V1 * along, w2 = V2 * along,
          w3 = V3 * along;
  T const g1 = D1 * V1, g2 = D2 * V2, g3 = D3 * V3, off = (g1 * g1 + (g2 * g2 + g3 * g3)) * (along * along);
  T const root =
      detail::power_sum<StepTable<terms>::roots>(table.inverse_root.data(), detail::Powers<T>(off));

  T const rate = body.J[1] + beside * inverse * s.mean, square = pp * (rate * rate);
  detail::Powers<T> const powers(square);
  T const cosine = detail::power_sum<StepTable<terms>::sines>(table.cosine.data(), powers),
          sine = pp * rate * detail::power_sum<StepTable<terms>::sines>(table.sinc.data(), powers);
  T const n1 = w1 * root, n2 = w2 * root, n3 = w3 * root, twice = 2.0 * pp * along * (root * root);
  // The change of the momentum, since p x V = -(D_i V_i): the rounding of a step is that of a small number.
  return {{cosine * root, (sine + cosine * D1) * n1, (sine + cosine * D2) * n2, (sine + cosine * D3) * n3},
          {-twice * (g2 * w3 - g3 * w2), -twice * (g3 * w1 - g1 * w3), -twice * (g1 * w2 - g2 * w1)},
          {X + off, square}};
}

/// Momentum and attitude after a free motion over the time 2.
///
/// @param  table  of the series, with 5 or 8 terms
/// @param  body   inverse moments, as in \ref short_motion
/// @param  p      momentum, a pure number; in, out
/// @param  q      unit quaternion, body to space; in, out
/// @return        whether that was a short step; if not, p and q have no meaning
template <int terms>
[[gnu::always_inline]] inline Reach<double> short_step(StepTable<terms> const& table,
                                                       InverseMoments<double> const& body, Three<double>& p,
                                                       Four<double>& q) {
  auto const [turn, change, reach] = short_motion<terms, double>(table, body, p);
  q = compose(q, turn);
  p = plus(p, change);
  return reach;
}

}  // namespace actio::bodies
