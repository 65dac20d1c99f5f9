#include "actio/stored_energy/small_strains.hpp"

namespace actio::media {

double without_logarithm(double x) {
  if (std::abs(x) > 0.1) return x - std::log1p(x);
  // With z = x/(2+x): log(1+x) = 2 (z + z^3/3 + z^5/5 + ...), and x - 2 z = x z.
  double const z = x / (2 + x), square = z * z;
  double sum = 0;
  for (int k = 21; k >= 3; k -= 2) sum = sum * square + 1.0 / k;
  return z * (x - 2 * square * sum);
}

double exponential_beyond_line(double x) {
  if (std::abs(x) > 0.5) return std::expm1(x) - x;
  double sum = 0;
  for (int k = 16; k >= 3; --k) sum = (sum + 1) * x / k;
  return x * x / 2 * (1 + sum);
}

}  // namespace actio::media
