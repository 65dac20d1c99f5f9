#include "actio/formula/elementary.hpp"

namespace actio {

namespace detail {

double function_of_double(Operation operation, double x) {
  switch (operation) {
    case Operation::sqrt:
      return std::sqrt(x);
    case Operation::cbrt:
      return std::cbrt(x);
    case Operation::exp:
      return std::exp(x);
    case Operation::log:
      return std::log(x);
    case Operation::log2:
      return std::log2(x);
    case Operation::log10:
      return std::log10(x);
    case Operation::sin:
      return std::sin(x);
    case Operation::cos:
      return std::cos(x);
    case Operation::tan:
      return std::tan(x);
    case Operation::asin:
      return std::asin(x);
    case Operation::acos:
      return std::acos(x);
    case Operation::atan:
      return std::atan(x);
    case Operation::sinh:
      return std::sinh(x);
    case Operation::cosh:
      return std::cosh(x);
    case Operation::tanh:
      return std::tanh(x);
    case Operation::asinh:
      return std::asinh(x);
    case Operation::acosh:
      return std::acosh(x);
    case Operation::atanh:
      return std::atanh(x);
    case Operation::abs:
      return std::abs(x);
    case Operation::sign:
      return x > 0 ? 1 : x < 0 ? -1 : 0;
    case Operation::floor:
      return std::floor(x);
    case Operation::ceil:
      return std::ceil(x);
    case Operation::round:
      return std::round(x);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace detail

}  // namespace actio
