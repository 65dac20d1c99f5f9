// Claims about whole sets, decided in balls: f > 0 on a box, exactly one zero in a ball of points.
//
// A box is a vector of balls. What a formula makes of it holds every value that the formula has on the box,
// so a lower bound above zero decides the sign everywhere at once. Where the bound is too weak the box is
// halved along its widest side. Made inside the call that `AnyClaim::encloses` is given, where balls are in
// force.
#pragma once

#include <utility>
#include <vector>

#include "actio/matrices/matrix.hpp"
#include "actio/numbers/derivative.hpp"
#include "claim.hpp"

namespace actio::checks {

/// The middle of a ball, without radius.
inline Number middle_of(Number const& ball) { return Number((ball.lower() + ball.upper()) / 2).lower(); }
/// How wide a ball is, rounded to a double.
inline double width_of(Number const& ball) { return to_double(Number(ball.upper() - ball.lower())); }

/// f > 0 everywhere on a box.
///
/// @param f     Vector<Number> -> Number, of balls; Undecided counts as a bound that is too weak
/// @param box   balls, one for each variable (`Number::between`)
/// @param most  boxes after which the answer is that it was not decided
template <class F>
Enclosure positive_on(F const& f, Vector<Number> const& box, int most = 4096) {
  Enclosure found{.shown = true, .margin = HUGE_VAL};
  std::vector<Vector<Number>> open = {box};
  while (!open.empty()) {
    Vector<Number> const x = open.back();
    open.pop_back();
    if (++found.boxes > most) return {.shown = false, .margin = found.margin, .boxes = most};
    try {
      Number const value = f(x);
      if (value.lower() > Number(0)) {
        found.margin = std::min(found.margin, to_double(value.lower()));
        continue;
      }
      // Not positive at any point of this box: no division helps.
      if (!(value.upper() > Number(0)))
        return {.margin = to_double(value.upper()), .boxes = found.boxes, .refuted = true};
    } catch (Undecided const&) {
    }
    Index widest = 0;
    for (Index k = 1; k < x.size(); ++k)
      if (width_of(x[k]) > width_of(x[widest])) widest = k;
    Number const cut = middle_of(x[widest]);
    Vector<Number> low = x, high = x;
    low[widest] = Number::between(x[widest].lower(), cut);
    high[widest] = Number::between(cut, x[widest].upper());
    open.push_back(low), open.push_back(high);
  }
  return found;
}
/// f > 0 on the whole segment from `from` to `to`.
/// @param f  Number -> Number, of balls
template <class F>
Enclosure positive_along(F const& f, Number const& from, Number const& to, int most = 4096) {
  Vector<Number> box(1);
  box[0] = Number::between(from, to);
  return positive_on([&](Vector<Number> const& x) { return Number(f(x[0])); }, box, most);
}

/// Exactly one zero of F in the box \f$X = m \pm r\f$, by the operator of Krawczyk: with Y near the inverse
/// of \f$F'(m)\f$, \f$K = m - Y F(m) + (1 - Y F'(X))(X - m)\f$ lies inside X. The margin is the least
/// distance of K from the boundary of X, over r.
///
/// @param f       a callable over any scalar, Vector<T> -> Vector<T>, as many equations as unknowns
/// @param centre  m: near the zero
/// @param radius  r: of the box, in each variable
template <class F>
Enclosure one_zero_near(F const& f, Vector<Number> const& centre, Number const& radius) {
  Index const n = centre.size();
  Vector<Number> point(n), box(n), offset(n);
  for (Index k = 0; k < n; ++k) {
    point[k] = middle_of(centre[k]);
    box[k] = Number::between(point[k] - radius, point[k] + radius);
    offset[k] = Number::between(-radius, radius);
  }
  auto const there = derivative(f, point), everywhere = derivative(f, box);
  // Any Y serves that is near enough: it is found in double.
  Matrix<double> slope(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) slope(i, j) = to_double(middle_of(there.matrix(i, j)));
  Matrix<Number> const Y = inverse_matrix(slope).unaryExpr([](double y) { return Number(y); });
  Matrix<Number> slack = -(Y * everywhere.matrix);
  for (Index i = 0; i < n; ++i) slack(i, i) += Number(1);
  Vector<Number> const moved = (-(Y * there.value) + slack * offset).eval();  // K - m
  Enclosure found{.shown = true, .margin = HUGE_VAL, .boxes = 1};
  for (Index k = 0; k < n; ++k) {
    double const room = to_double(Number((radius - magnitude(moved[k])) / radius).lower());
    found.shown = found.shown && room > 0, found.margin = std::min(found.margin, room);
  }
  return found;
}

}  // namespace actio::checks
