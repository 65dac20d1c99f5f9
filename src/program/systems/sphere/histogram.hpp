// The histogram of the values that a vorticity has: how much of the sphere has which.
#pragma once

#include <Eigen/Core>

namespace actio::scene {

/// Bins of equal width over an interval.
struct HistogramBins {
  static constexpr int count = 32;  ///< of the bins
  double lowest;                    ///< where the first of them begins
  double highest;                   ///< where the last of them ends

  /// From the least to the greatest of values in ascending order.
  explicit HistogramBins(Eigen::VectorXd const& values)
      : lowest(values[0]), highest(values[values.size() - 1]) {}

  double width() const { return (highest - lowest) / count; }  ///< of one of them
  /// The share of the values in each: a value on the border of two counts to the lower one, and so does one
  /// that rounding has moved over it. What is beyond an end counts to the last bin there.
  Eigen::VectorXd shares(Eigen::VectorXd const& values) const;
};

}  // namespace actio::scene
