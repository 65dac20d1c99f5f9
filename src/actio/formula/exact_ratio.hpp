// Ratios of 64-bit integers: the constants of a formula, exact as long as they fit.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

namespace actio {

/// A ratio \f$p/q\f$ of two integers of 64 bits in lowest terms, with q > 0 and \f$|p| < 2^{63}\f$.
struct ExactRatio {
  std::int64_t above = 0;  ///< p
  std::int64_t below = 1;  ///< q

  friend bool operator==(ExactRatio const&, ExactRatio const&) = default;
  /// Whether it is this whole number.
  bool is(std::int64_t n) const { return above == n && below == 1; }
  /// Whether it is a whole number.
  bool whole() const { return below == 1; }
};

/// \f$p/q\f$ in lowest terms; nothing where q = 0 or where it does not fit.
inline std::optional<ExactRatio> exact_ratio(std::int64_t p, std::int64_t q) {
  constexpr auto least = std::numeric_limits<std::int64_t>::min();
  if (q == 0 || p == least || q == least) return std::nullopt;
  std::int64_t const common = std::gcd(p, q) * (q < 0 ? -1 : 1);
  return ExactRatio{p / common, q / common};
}

/// \f$-x\f$.
inline ExactRatio operator-(ExactRatio const& x) { return {-x.above, x.below}; }

/// \f$1/x\f$; nothing where x = 0.
inline std::optional<ExactRatio> reciprocal(ExactRatio const& x) { return exact_ratio(x.below, x.above); }

/// \f$xy\f$; nothing where it does not fit.
inline std::optional<ExactRatio> product(ExactRatio const& x, ExactRatio const& y) {
  // What stands above one and below the other is cancelled first: then it overflows only where it does not
  // fit.
  std::int64_t const g = std::gcd(x.above, y.below), h = std::gcd(y.above, x.below);
  std::int64_t p, q;
  if (__builtin_mul_overflow(x.above / g, y.above / h, &p) ||
      __builtin_mul_overflow(x.below / h, y.below / g, &q))
    return std::nullopt;
  return exact_ratio(p, q);
}

/// \f$x + y\f$; nothing where it, or a number on the way, does not fit.
inline std::optional<ExactRatio> sum(ExactRatio const& x, ExactRatio const& y) {
  std::int64_t const g = std::gcd(x.below, y.below);
  std::int64_t left, right, p, q;
  if (__builtin_mul_overflow(x.above, y.below / g, &left) ||
      __builtin_mul_overflow(y.above, x.below / g, &right) || __builtin_add_overflow(left, right, &p) ||
      __builtin_mul_overflow(x.below, y.below / g, &q))
    return std::nullopt;
  return exact_ratio(p, q);
}

/// \f$\sqrt x\f$ where it is a ratio again, else nothing.
inline std::optional<ExactRatio> exact_root(ExactRatio const& x) {
  auto const root = [](std::int64_t n) -> std::int64_t {
    auto const r = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(n))));
    return n >= 0 && r <= 3037000499 && r * r == n ? r : -1;
  };
  if (x.above < 0) return std::nullopt;
  std::int64_t const p = root(x.above), q = root(x.below);
  if (p < 0 || q < 0) return std::nullopt;
  return ExactRatio{p, q};
}

/// The double nearest to x.
inline double to_double(ExactRatio const& x) {
  return static_cast<double>(static_cast<long double>(x.above) / static_cast<long double>(x.below));
}

}  // namespace actio
