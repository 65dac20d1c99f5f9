// The projection of matrices on the span of a basis: Gram and Schmidt's orthogonalization, with the answer in
// whole numbers where the basis is simple enough.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio::systems::detail {

/// A list of matrices of one size, each as the row of its entries.
struct SpanProjection {
  using Rows = std::vector<Eigen::VectorXd>;

  Rows dual;               ///< the dual basis inside the span, times the denominator
  double denominator = 1;  ///< a whole number; more than 1 only where that makes the dual basis whole

  /// @throws Singular  where a matrix is a combination of those before it: which one, and the combination
  explicit SpanProjection(Rows const& basis);

 private:
  static constexpr double independent_ = 1e-10;
  Rows orthonormal_;
  Rows combination_;  // of the basis that each orthonormal matrix is

  void add(Eigen::VectorXd const& e, Rows const& basis);

  [[noreturn]] static void refuse(Index k, Eigen::VectorXd const& made_of, double distance);

  void find_dual();

  /// The least whole number that makes the dual basis whole up to rounding, and then without rounding.
  void find_denominator();
};

}  // namespace actio::systems::detail
