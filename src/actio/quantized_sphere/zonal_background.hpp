// What turns as a whole, apart from the flow on it: the background of a step.
//
// On a sphere that turns fast W = bX + V with X = i hbar S_3, where b is many times as large as V. In the sum
// V is lost in the rounding of bX, and energy and angular momentum of the flow with it. So a step can be made
// of V alone. The displacement is A = A' + A_0 with A_0 = i a S_3, which commutes with X. Without a flow its
// middle would be
//
//   M = (1 - A_0)^{-1} bX (1 + A_0)^{-1} = i diag(mu),   mu_k = b hbar s_k/(1 + a^2 s_k^2),   s_k of S_3,
//
// and what the equation of a step, Wt = W_0 + [A, Wt] + A Wt A, leaves for Vt = Wt - M is
//
//   Vt = V_0 + C + B A' + B A_0 + A_0 M A',   B = A Vt + A' M,   C = [A, Vt] + [A', M],   V_1 = V_0 + 2C.
//
// A' is of the size of V over b, so no term is larger than what V changes by in a step; and A_0, which is not
// small, is kept out of the products of matrices, whose rounding is that of their largest entries. Products
// with the diagonal matrices take O(N^2) operations.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_sphere/quantized_sphere.hpp"
#include "actio/skew_matrices/products.hpp"

namespace actio::sphere {

/// A rotation of the whole sphere about the third axis, of which a step keeps the flow apart.
struct ZonalBackground {
  double vorticity = 0;  ///< b, of the vorticity b x_3; 1/time
  /// of the part b' x_3 that the stream function of the displacement has besides that of V, in the frame of
  /// the step; 1/time
  double stream = 0;

  /// Whether there is one.
  bool is_there() const { return vorticity != 0; }
};

/// The terms of the equation of a step that a background adds.
class ZonalTerms {
 public:
  /// Of none.
  ZonalTerms() = default;
  /// @param eps  h/(2 hbar)
  ZonalTerms(QuantizedSphere const& sphere, ZonalBackground const& background, double eps);

  double turn() const { return turn_; }  ///< a

  /// Adds A_0.
  void add_own(SkewHermitian<>& a) const { a.imaginary.diagonal() += own_; }
  /// Adds M.
  void add_middle(SkewHermitian<>& w) const { w.imaginary.diagonal() += middle_; }
  /// Adds A_0 Vt + A' M to the product A' Vt, and [A', M] + [A_0, Vt] to its commutator: there differences of
  /// entries of M or of A_0 are not found by subtraction.
  void add_to_product(SkewHermitian<> const& a, SkewHermitian<> const& v, SkewProducts<double>& products,
                      SkewHermitian<>& c) const;
  /// Adds B A_0 + A_0 M A' to B A', B being the product.
  void add_outside(SkewHermitian<> const& a, SkewProducts<double>& products, SkewHermitian<>& e) const;

 private:
  double scale_ = 0, turn_ = 0;
  Eigen::VectorXd own_, share_, middle_;  ///< a s_k, 1/(1 + a^2 s_k^2), mu_k
};

}  // namespace actio::sphere
