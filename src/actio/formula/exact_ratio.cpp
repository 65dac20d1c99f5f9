#include "actio/formula/exact_ratio.hpp"

namespace actio {

std::optional<ExactRatio> exact_ratio(std::int64_t p, std::int64_t q) {
  constexpr auto least = std::numeric_limits<std::int64_t>::min();
  if (q == 0 || p == least || q == least) return std::nullopt;
  std::int64_t const common = std::gcd(p, q) * (q < 0 ? -1 : 1);
  return ExactRatio{p / common, q / common};
}

std::optional<ExactRatio> product(ExactRatio const& x, ExactRatio const& y) {
  // What stands above one and below the other is cancelled first: then it overflows only where it does not
  // fit.
  std::int64_t const g = std::gcd(x.above, y.below), h = std::gcd(y.above, x.below);
  std::int64_t p, q;
  if (__builtin_mul_overflow(x.above / g, y.above / h, &p) ||
      __builtin_mul_overflow(x.below / h, y.below / g, &q))
    return std::nullopt;
  return exact_ratio(p, q);
}

std::optional<ExactRatio> sum(ExactRatio const& x, ExactRatio const& y) {
  std::int64_t const g = std::gcd(x.below, y.below);
  std::int64_t left, right, p, q;
  if (__builtin_mul_overflow(x.above, y.below / g, &left) ||
      __builtin_mul_overflow(y.above, x.below / g, &right) || __builtin_add_overflow(left, right, &p) ||
      __builtin_mul_overflow(x.below, y.below / g, &q))
    return std::nullopt;
  return exact_ratio(p, q);
}

std::optional<ExactRatio> exact_root(ExactRatio const& x) {
  auto const root = [](std::int64_t n) -> std::int64_t {
    auto const r = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(n))));
    return n >= 0 && r <= 3037000499 && r * r == n ? r : -1;
  };
  if (x.above < 0) return std::nullopt;
  std::int64_t const p = root(x.above), q = root(x.below);
  if (p < 0 || q < 0) return std::nullopt;
  return ExactRatio{p, q};
}

}  // namespace actio
