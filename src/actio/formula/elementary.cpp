#include "actio/formula/elementary.hpp"

namespace actio {

namespace detail {

namespace {

// Where they are single instructions of a processor.
double root(double x) { return std::sqrt(x); }
double modulus(double x) { return std::abs(x); }
double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
double below(double x) { return std::floor(x); }
double above(double x) { return std::ceil(x); }

/// In the order of `Operation`, from the first function of one number on.
constexpr double (*functions[])(double) = {
    root,       std::cbrt,  std::exp,  std::log,  std::log2, std::log10, std::sin,  std::cos,
    std::tan,   std::asin,  std::acos, std::atan, std::sinh, std::cosh,  std::tanh, std::asinh,
    std::acosh, std::atanh, modulus,   sign,      below,     above,      std::round};
constexpr auto first = static_cast<std::size_t>(Operation::sqrt);
static_assert(first + std::size(functions) == std::size(operation_names));

}  // namespace

double function_of_double(Operation operation, double x) {
  auto const k = static_cast<std::size_t>(operation);
  return k < first ? std::numeric_limits<double>::quiet_NaN() : functions[k - first](x);
}

}  // namespace detail

}  // namespace actio
