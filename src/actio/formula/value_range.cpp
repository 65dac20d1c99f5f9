#include "actio/formula/value_range.hpp"

namespace actio {

ValueRange elementary(Operation operation, ValueRange const& range) {
  namespace interval = boost::numeric;
  detail::Interval const& x = range;
  if (!is_smooth(operation)) detail::refuse_kinks(operation);
  auto const rising = [&] {
    return detail::Interval(detail::function_of_double(operation, x.lower()),
                            detail::function_of_double(operation, x.upper()));
  };
  switch (operation) {
    case Operation::sqrt:
      return interval::sqrt(x);
    case Operation::log:
      return interval::log(x);
    case Operation::log2:
      return interval::log(x) / std::log(2.0);
    case Operation::log10:
      return interval::log(x) / std::log(10.0);
    case Operation::sin:
      return interval::sin(x);
    case Operation::cos:
      return interval::cos(x);
    case Operation::tan:
      return interval::tan(x);
    case Operation::asin:
      return interval::asin(x);
    case Operation::acos:
      return interval::acos(x);
    case Operation::cosh:
      return interval::cosh(x);
    case Operation::acosh:
      return interval::acosh(x);
    case Operation::atanh:
      return interval::atanh(x);
    default:  // exp, cbrt, atan, sinh, tanh, asinh
      return rising();
  }
}

ValueRange power(ValueRange const& x, ValueRange const& c) {
  double const exponent = c.lower();
  detail::Interval const& base = x;
  if (exponent == std::round(exponent) && std::abs(exponent) < 1024)
    return boost::numeric::pow(base, static_cast<int>(exponent));
  return boost::numeric::exp(boost::numeric::log(base) * exponent);
}

}  // namespace actio
