// Numbers that are known to lie between two bounds, as scalars of a tape: what a formula may come to where
// its inputs are anything within theirs.
//
// Bounds are not rounded outwards: they are meant to be compared by their size. Outside of the domain of a
// function the bounds are those of the part within; where nothing is, they are NaNs.
#pragma once

#include <boost/numeric/interval.hpp>

#include "actio/formula/elementary.hpp"

namespace actio {

namespace detail {
using Interval = boost::numeric::interval<
    double,
    boost::numeric::interval_lib::policies<boost::numeric::interval_lib::save_state_nothing<
                                               boost::numeric::interval_lib::rounded_transc_exact<double>>,
                                           boost::numeric::interval_lib::checking_base<double>>>;
}  // namespace detail

/// All numbers from a lower to an upper bound.
struct ValueRange : detail::Interval {
  using detail::Interval::Interval;
  ValueRange() = default;
  /// Of these bounds.
  ValueRange(detail::Interval const& bounds) : detail::Interval(bounds) {}  // NOLINT: as the sums of two are
  /// The largest modulus; infinite where it is not known.
  double largest() const {
    double const out = std::max(std::abs(lower()), std::abs(upper()));
    return std::isnan(lower()) || std::isnan(upper()) ? HUGE_VAL : out;
  }
};
/// Its bounds are double.
template <>
struct BaseOf<ValueRange> {
  using type = double;
};

/// A product; of a number by itself, a square.
inline ValueRange operator*(ValueRange const& x, ValueRange const& y) {
  if (&x == &y) return boost::numeric::square(static_cast<detail::Interval const&>(x));
  return static_cast<detail::Interval const&>(x) * static_cast<detail::Interval const&>(y);
}

/// A function of one number.
ValueRange elementary(Operation operation, ValueRange const& range);

/// \f$x^c\f$ with a constant c.
ValueRange power(ValueRange const& x, ValueRange const& c);
/// \f$\sqrt{x^2 + y^2}\f$.
inline ValueRange hypotenuse(ValueRange const& x, ValueRange const& y) {
  detail::Interval const &a = x, &b = y;
  return boost::numeric::sqrt(boost::numeric::square(a) + boost::numeric::square(b));
}
/// The angle of the point (x, y): any, where it is not to the right of the origin.
inline ValueRange angle_of(ValueRange const& y, ValueRange const& x) {
  if (!(x.lower() > 0)) return {-half_turn<double>(), half_turn<double>()};
  return elementary(Operation::atan, ValueRange(static_cast<detail::Interval const&>(y) / x));
}

}  // namespace actio
