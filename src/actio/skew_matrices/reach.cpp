#include <Eigen/Core>

#include "actio/skew_matrices/reach.hpp"

namespace actio::sphere {

Eigen::Index reach_in_single(SkewHermitian<float> const& m) {
  if (m.size() < smallest_with_reach) return Reach::everything;
  // A sixtieth of the rounding of its eigenvalues, by their root mean square.
  float const root = norm(m) / std::sqrt(static_cast<float>(m.size()));
  return useful_reach(m.real, m.imaginary, 1e-9F * root);
}

}  // namespace actio::sphere
