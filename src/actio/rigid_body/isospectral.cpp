#include "actio/rigid_body/isospectral.hpp"

namespace actio {

std::vector<IsospectralDegree> isospectral_degrees(int n) {
  std::vector<IsospectralDegree> degrees;
  for (int k = 2; k <= n; k += 2)
    for (int j = 0; j + k <= n; ++j) degrees.push_back({k, j});
  return degrees;
}

}  // namespace actio
