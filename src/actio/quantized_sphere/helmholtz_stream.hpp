// The stream function of a quasi-geostrophic layer: (Delta - gamma) P = W.
//
// A layer whose depth may change a little has the potential vorticity q = (Delta - gamma) psi + 2 Omega x_3,
// with gamma the square of the radius of the sphere over that of deformation. Any map W -> P that commutes
// with rotations serves the step, and this one does.
//
// On a rotating sphere the state is W = q, and P is taken of all of it, as where gamma is 0: the part of P
// that comes from 2 Omega x_3 is a rotation, and the flow of q is the free one in a frame that turns about
// the pole at the rate 2 Omega/(2 + gamma). Without gamma that is Omega, and the frame the inertial one.
#pragma once

#include "actio/quantized_sphere/laplacian.hpp"

namespace actio::sphere {

/// \f$(\Delta-\gamma)^{-1}\f$ on the matrices with trace zero, \f$\gamma > 0\f$.
class HelmholtzStream {
 public:
  /// Factors the matrices of the diagonals; N^2 numbers are stored.
  /// @param gamma  the square of radius over radius of deformation
  /// @throws OutsideDomain  where N < 2, or where gamma is not above 0: without it there is `SphereLaplacian`
  HelmholtzStream(int n, double gamma);
  int size() const { return n_; }
  double gamma() const { return gamma_; }  ///< what is subtracted from the Laplacian
  /// By what rate about the pole a flow has to be turned back on a sphere that rotates:
  /// \f$2\Omega/(2+\gamma)\f$.
  double frame_rate(double rotation) const { return 2 * rotation / (2 + gamma_); }

  /// The P with trace zero of \f$(\Delta-\gamma)P = W - \mathrm{Tr}(W)/N\f$: what a constant adds to a stream
  /// function makes no flow. O(N^2) operations.
  void solve(SkewHermitian<> const& w, SkewHermitian<>& p) const;
  /// The same as a value.
  SkewHermitian<> solve(SkewHermitian<> const& w) const {
    SkewHermitian<> p(n_);
    solve(w, p);
    return p;
  }

 private:
  using Part = SkewHermitian<>::Part;

  /// On and below the diagonal, with the diagonals as lanes: forwards through the columns, and back.
  void solve(Part const& w, Part& p, double mean) const;
  int n_;
  double gamma_;
  Part above_, pivot_;
};

}  // namespace actio::sphere
