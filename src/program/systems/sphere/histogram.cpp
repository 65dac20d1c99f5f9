#include <Eigen/Core>

#include "program/systems/sphere/histogram.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {

Eigen::VectorXd HistogramBins::shares(Eigen::VectorXd const& values) const {
  // Of the width: far above the rounding of eigenvalues, far below what a bin is to tell.
  constexpr double border = 1e-7;
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(count);
  for (double const value : values) {
    double const place = width() > 0 ? (value - lowest) / width() : 0;
    shares[std::clamp(static_cast<int>(std::ceil(place - border)) - 1, 0, count - 1)] += 1;
  }
  return shares / static_cast<double>(values.size());
}

}  // namespace actio::scene
