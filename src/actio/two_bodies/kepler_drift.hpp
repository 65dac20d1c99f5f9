// The motion of two points that attract each other, over any time, as a change of position and velocity.
//
// With the variable s, dt = r ds, and G_n(s) = s^n c_n(beta s^2), Stumpff's functions c_n and
// beta = 2 mu/r_0 - v_0^2, one formula holds for ellipses, parabolas and hyperbolas:
//
//     t = r_0 G_1 + eta G_2 + mu G_3,  r = r_0 + eta G_1 + zeta G_2,  eta = x_0.v_0,  zeta = mu - beta r_0,
//
// and t grows with s, as r is positive: Newton's method between two bounds finds s. What is returned are
// changes, so that the rounding of a short drift is that of a small number (\cite rein_tamayo_2015).
#pragma once

#include <vector>

#include "actio/fast_body/space/half_turn.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/numbers/functions.hpp"
#include "actio/numbers/pack.hpp"

namespace actio::bodies {

/// How position and velocity change.
template <class S>
struct PointMotion {
  Three<S> position;  ///< length
  Three<S> velocity;  ///< length/time
};

namespace detail {

/// \f$G_1, G_2, G_3\f$ of \f$\beta\f$ and s.
template <class S>
struct UniversalFunctions {
  S g1, g2, g3;
  S s{};
};
template <Real S>
[[gnu::always_inline]] inline UniversalFunctions<S> universal_functions(S const& beta, S const& s) {
  S const square = s * s;
  S x = beta * square;
  // A quarter of x, until the series is short; then back by doubling the argument.
  int halves = 0;
  constexpr bool fast = OfDoubles<S>;
  while (!(magnitude(base_value(x)) <= Base<S>(fast ? 0.1 : 0.5)) && halves < 600)
    x = x * Base<S>(0.25), ++halves;
  S c2, c3;
  if constexpr (fast) {
    // The rest of the series is below a fifth of the rounding.
    S const y = x * x, z = y * y;
    c3 = ((1. / 6 - x / 120) + y * (1. / 5040 - x / 362880)) + z * (1. / 39916800 - x / 6227020800);
    c2 = ((1. / 2 - x / 24) + y * (1. / 720 - x / 40320)) + z * (1. / 3628800 - x / 479001600);
  } else {
    c2 = stumpff<2>(x), c3 = stumpff<3>(x);
  }
  if (halves == 0) {
    S const g2 = square * c2, g3 = square * s * c3;
    return {s - beta * g3, g2, g3, s};
  }
  S c1 = Base<S>(1) - x * c3, c0 = Base<S>(1) - x * c2;
  for (; halves > 0; --halves) {
    c3 = (c2 + c0 * c3) * Base<S>(0.25);  // c_3(4x)
    c2 = c1 * c1 * Base<S>(0.5);
    c1 = c0 * c1;
    c0 = c0 * c0 * Base<S>(2) - Base<S>(1);
  }
  return {s * c1, square * c2, square * s * c3, s};
}

/// The time less whole periods \f$2\pi\mu\beta^{-3/2}\f$.
template <Real S>
[[gnu::noinline, gnu::cold]] S without_whole_periods(S const& t, S const& beta, S const& mu) {
  using std::acos, std::floor, std::sqrt;
  S const period = mu * (Base<S>(2) * Base<S>(acos(Base<S>(-1)))) / (beta * S(sqrt(beta)));
  return t - period * Base<S>(floor(Base<S>(base_value(t) / base_value(period) + Base<S>(0.5))));
}

/// \f$t = r_0s+\eta G_2+\zeta G_3\f$ as an equation for s.
template <Real S>
struct TimeEquation {
  S r, eta, beta, zeta, t;

  /// The last s at which the functions were evaluated, and the step from there back to the solution.
  struct Solution {
    UniversalFunctions<S> at;
    S step;
  };
  /// A step of Halley's method from s.
  [[gnu::always_inline]] Solution halley(S const& s) const {
    auto const g = universal_functions<S>(beta, s);
    S const miss = r * s + eta * g.g2 + zeta * g.g3 - t, radius = r + eta * g.g1 + zeta * g.g2,
            slope = eta * (S(1) - beta * g.g2) + zeta * g.g1;
    return {g, miss * radius / (radius * radius - miss * slope * S(0.5))};
  }
  /// From a series in t; it needs two evaluations or three for steps of a part of a radian.
  [[gnu::always_inline]] Solution solution() const {
    S const inverse = S(1) / r, q = t * inverse, tilt = q * inverse * eta, bend = q * q * inverse * zeta;
    if (!(magnitude(tilt) < S(1) && magnitude(bend) < S(1))) return by_bounds();
    S s = q * (S(1) - tilt * S(0.5) + tilt * tilt * S(0.5) - bend * (S(1) / S(6)));
    // The error of the next step is the cube of this, or less.
    S const enough = near_enough();
    S last = magnitude(s);
    for (int round = 0; round < 8; ++round) {
      Solution const found = halley(s);
      S const size = magnitude(found.step);
      if (size <= enough * magnitude(s)) return found;
      if (!(size < last + enough * magnitude(s))) break;
      s -= found.step, last = size;
    }
    return by_bounds();
  }
  [[gnu::always_inline]] static S near_enough() {
    using std::pow;
    if constexpr (OfDoubles<S>)
      return S(4e-6);
    else
      return S(pow(epsilon<S>(), S(0.4)));
  }
  /// The same with bounds, for long times and orbits that pass near the centre.
  [[gnu::noinline, gnu::cold]] Solution by_bounds() const
    requires is_pack<S>
  {
    Solution all;
    for (int k = 0; k < S::lanes; ++k)
      set_lane(all, k, in_lane<TimeEquation<double>>(*this, k).solution_or_none());
    return all;
  }
  /// The same, without a number where there is none: in a lane beside others.
  Solution solution_or_none() const try { return solution(); } catch (NotConverged const&) {
    S const none = std::numeric_limits<S>::quiet_NaN();
    return {{none, none, none, none}, none};
  }
  [[gnu::noinline, gnu::cold]] Solution by_bounds() const {
    S const sign = t < S(0) ? S(-1) : S(1);
    TimeEquation const ahead{r, sign * eta, beta, zeta, sign * t};
    auto const miss = [&](S const& s) {
      auto const g = universal_functions<S>(beta, s);
      return S(ahead.r * s + ahead.eta * g.g2 + ahead.zeta * g.g3 - ahead.t);
    };
    // Not more than a radian of the orbit at first, where functions of long ones would overflow.
    using std::sqrt;
    S low(0), high = ahead.t / r;
    if (S const turn = high * high * magnitude(beta); turn > S(1)) high = high / S(sqrt(turn));
    for (int round = 0; round < 200 && miss(high) < S(0); ++round) low = high, high += high;
    S s = (low + high) * S(0.5), last = high - low;
    std::vector<double> steps;
    for (int round = 0; round < 400; ++round) {
      Solution const found = ahead.halley(s);
      S const size = magnitude(found.step);
      if (size <= S(64) * epsilon<S>() * magnitude(s)) {
        auto at = found.at;
        at.s *= sign, at.g1 *= sign, at.g3 *= sign;
        return {at, sign * found.step};
      }
      steps.push_back(to_double(size));
      (miss(s) > S(0) ? high : low) = s;
      // Halved where a step leaves the bounds, or is not half of the last one.
      S const next = s - found.step;
      bool const good = next > low && next < high && size + size <= last;
      last = good ? size : S((high - low) * S(0.5));
      s = good ? next : S((low + high) * S(0.5));
    }
    throw NotConverged("Kepler's equation", steps, to_double(S(64) * epsilon<S>() * magnitude(s)));
  }
};

}  // namespace detail

/// Position and velocity after a time t under \f$\ddot x=-\mu x/r^3\f$, less what they are now.
/// @param x,v  position, not zero, and velocity
/// @param mu   length^3/time^2
/// @param t    of any sign and length
/// @throws NotConverged  where position or velocity is no number, or a collision is met
/// Accuracy: a few epsilon of the angle that is passed.
template <Real S>
[[gnu::always_inline]] inline PointMotion<S> kepler_drift(Three<S> const& x, Three<S> const& v, S const& mu,
                                                          S const& t) {
  using std::sqrt;
  S const r0 = sqrt(dot(x, x)), inverse = S(1) / r0, eta = dot(x, v),
          beta = mu * inverse * Base<S>(2) - dot(v, v), zeta = mu - beta * r0;
  using B = Base<S>;
  S rest = t;
  if constexpr (!is_pack<B>)
    if (base_value(beta) > B(0) && base_value(t * t * beta * beta * beta) > base_value(S(mu * mu)) * B(39))
        [[unlikely]]
      rest = detail::without_whole_periods<S>(t, beta, mu);
  detail::TimeEquation<B> const equation{base_value(r0), base_value(eta), base_value(beta), base_value(zeta),
                                         base_value(rest)};
  auto const [s, last] = equation.solution();
  detail::UniversalFunctions<S> g;
  S radius;
  if constexpr (std::is_same_v<S, double> || is_pack<S>) {
    // The last step is so small that its square is all that is needed for G_n at the end of it.
    S const g0 = S(1) - beta * s.g2, half = last * last * S(0.5);
    g = {s.g1 - last * g0 - half * beta * s.g1, s.g2 - last * s.g1 + half * g0,
         s.g3 - last * s.g2 + half * s.g1};
    radius = r0 + eta * g.g1 + zeta * g.g2;
  } else {
    // One step of Newton's method in the scalar itself: its derivatives are those of the solution.
    S root(s.s - last);
    g = detail::universal_functions<S>(beta, root);
    root = root - (r0 * root + eta * g.g2 + zeta * g.g3 - rest) / S(r0 + eta * g.g1 + zeta * g.g2);
    g = detail::universal_functions<S>(beta, root);
    radius = r0 + eta * g.g1 + zeta * g.g2;
  }
  // [kepler_drift]
  S const f = -mu * g.g2 * inverse, h = rest - mu * g.g3, df = -mu * g.g1 * inverse / radius,
          dh = -mu * g.g2 / radius;
  return {{f * x[0] + h * v[0], f * x[1] + h * v[1], f * x[2] + h * v[2]},
          {df * x[0] + dh * v[0], df * x[1] + dh * v[1], df * x[2] + dh * v[2]}};
  // [kepler_drift]
}

}  // namespace actio::bodies
