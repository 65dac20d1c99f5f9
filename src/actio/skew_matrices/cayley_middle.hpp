// The middle of a step by an elimination, for a displacement that is too large for a fixed point.
#pragma once

#include <Eigen/LU>

#include "actio/skew_matrices/skew_hermitian.hpp"

namespace actio::sphere {

/// \f$\tilde W = (1-A)^{-1}W_0(1+A)^{-1}\f$, the middle of the step from \f$W_0\f$ by
/// \f$\mathrm{cay}(A)\f$. It is there for every A, since no eigenvalue of 1 - A has a modulus below 1.
/// Accuracy: rounding, times the condition of 1 - A. O(N^3) operations.
/// @param middle  of the size of W_0
template <class Real>
void eliminate_middle(SkewHermitian<Real> const& a, SkewHermitian<Real> const& w,
                      SkewHermitian<Real>& middle) {
  using Part = typename SkewHermitian<Real>::Part;
  Eigen::Index const n = w.size();
  Part system(2 * n, 2 * n), sides(2 * n, n);
  system << -a.real, a.imaginary, -a.imaginary, -a.real;
  system.diagonal().array() += 1;
  Eigen::PartialPivLU<Part> const solver(system);
  sides << w.real, w.imaginary;
  sides = solver.solve(sides);
  // Its adjoint, and once more.
  Part next(2 * n, n);
  next << sides.topRows(n).transpose(), -sides.bottomRows(n).transpose();
  sides = solver.solve(next);
  middle.real = (sides.topRows(n).transpose() - sides.topRows(n)) / 2;
  middle.imaginary = -(sides.bottomRows(n).transpose() + sides.bottomRows(n)) / 2;
}

}  // namespace actio::sphere
