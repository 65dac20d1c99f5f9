// A body to spin, for the tests of this folder.
#pragma once

#include <limits>

namespace actio::testing {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// A body with moments of inertia 1, 2 and 4 kg m^2.
inline constexpr auto spinning_body = [](auto const& omega) {
  auto const& w = omega.coordinates;
  return (w[0] * w[0] + w[1] * w[1] * 2 + w[2] * w[2] * 4) / 2;
};

}  // namespace actio::testing
