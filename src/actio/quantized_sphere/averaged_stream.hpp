// The stream function of the averaged equations of Euler on the sphere.
//
// They are the geodesics of a kinetic energy that counts gradients of the velocity, too, with a length alpha,
// in radii of the sphere: what is finer than alpha is carried along, and moves nothing. Of the metrics
//
//   deformation   int 1/2 |u|^2 + alpha^2 |Def u|^2,   q = (1 - alpha^2 (Delta + 2)) Delta psi,
//   rough         int 1/2 |u|^2 + alpha^2/2 |curl u|^2,   q = (1 - alpha^2 Delta) Delta psi,
//
// the first has the rate of deformation, the symmetric part of the gradient of u, which for a rotation is
// zero (Holm, Kouranbaeva, Marsden, Ratiu and Shkoller 1999; Shkoller 2000). The vorticity q is carried by u
// = r x grad psi. On a degree l, with y = l(l + 1), this divides q by y(1 + alpha^2 (y - 2)) or y(1 + alpha^2
// y).
//
// The inverse is a difference of those of Delta and of Delta - gamma, which cancel where alpha^2 y is large.
// Here the one is applied to what the other leaves.
#pragma once

#include "actio/quantized_sphere/laplacian.hpp"

namespace actio::sphere {

/// What an averaged flow has in its kinetic energy beside the velocity.
enum class AveragedMetric {
  deformation,  ///< \f$\alpha^2|\mathrm{Def}\,u|^2\f$: a rotation has none
  rough         ///< \f$\tfrac12\alpha^2|\mathrm{curl}\,u|^2\f$
};
/// c in the factor \f$1-\alpha^2(\Delta+c)\f$.
inline double metric_shift(AveragedMetric metric) { return metric == AveragedMetric::deformation ? 2 : 0; }

/// \f$W\mapsto P\f$ with \f$(1-\alpha^2(\Delta+c))\,\Delta P=W\f$, where c is 2 or 0, on the matrices with
/// trace zero.
///
/// \snippet sphere.cpp averaged_stream
class AveragedStream {
 public:
  /// Factors the matrices of the diagonals; 4 N^2 numbers are stored.
  /// @param alpha   the length, in radii of the sphere; 0: Euler's equations
  /// @throws OutsideDomain  where N < 2 or alpha < 0; with the deformation where alpha^2 is 1/2 or more, from
  ///                        where on the factor \f$1-\alpha^2(\Delta+2)\f$ is not positive on constants
  AveragedStream(int n, double alpha, AveragedMetric metric);
  int size() const { return n_; }
  double alpha() const { return alpha_; }            ///< the length, in radii of the sphere
  AveragedMetric metric() const { return metric_; }  ///< that of the kinetic energy

  /// The P with trace zero of \f$(1-\alpha^2(\Delta+c))\,\Delta P = W - \mathrm{Tr}(W)/N\f$. O(N^2)
  /// operations.
  ///
  /// Accuracy: that of `SphereLaplacian`, and then relative to \f$|\Delta^{-1}W|\f$ about
  /// \f$10^{-16}N\f$: a rounding of low degrees is not made smaller by \f$1+\alpha^2l(l+1)\f$ as the rest is.
  void solve(SkewHermitian<> const& w, SkewHermitian<>& p) const;
  /// The same as a value.
  SkewHermitian<> solve(SkewHermitian<> const& w) const {
    SkewHermitian<> p(size());
    solve(w, p);
    return p;
  }

 private:
  using Part = SkewHermitian<>::Part;
  /// A factorisation of the matrix of each diagonal, with that of k and m at (k + m, k): what couples the row
  /// with the next one, and the inverse of D. What couples the last row with none is zero.
  struct Factors {
    Part beside, pivot;
  };

  void solve_diagonal(Part const& w, Part& p) const;
  int n_;
  double alpha_;
  AveragedMetric metric_;
  Factors laplacian_, average_;
};

}  // namespace actio::sphere
