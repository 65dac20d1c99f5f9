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
std::optional<ExactRatio> exact_ratio(std::int64_t p, std::int64_t q);

/// \f$-x\f$.
inline ExactRatio operator-(ExactRatio const& x) { return {-x.above, x.below}; }

/// \f$1/x\f$; nothing where x = 0.
inline std::optional<ExactRatio> reciprocal(ExactRatio const& x) { return exact_ratio(x.below, x.above); }

/// \f$xy\f$; nothing where it does not fit.
std::optional<ExactRatio> product(ExactRatio const& x, ExactRatio const& y);

/// \f$x + y\f$; nothing where it, or a number on the way, does not fit.
std::optional<ExactRatio> sum(ExactRatio const& x, ExactRatio const& y);

/// \f$\sqrt x\f$ where it is a ratio again, else nothing.
std::optional<ExactRatio> exact_root(ExactRatio const& x);

/// The double nearest to x.
inline double to_double(ExactRatio const& x) {
  return static_cast<double>(static_cast<long double>(x.above) / static_cast<long double>(x.below));
}

}  // namespace actio
