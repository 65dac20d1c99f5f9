// Anderson's acceleration of a fixed point x = F(x): where plain iteration is slow or goes astray.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace actio::bodies {

/// Makes the next argument of a fixed-point iteration from the last few.
///
/// Of all combinations of the last m + 1 residuals F(x) - x with sum of coefficients 1 it takes the smallest
/// (least squares, by orthogonalisation), and the same combination of the arguments, moved by half the
/// residual.
class Anderson {
 public:
  explicit Anderson(int memory) : memory_(static_cast<std::size_t>(memory)) {}

  /// @param x         the argument; becomes the next one
  /// @param residual  F(x) - x
  void mix(std::vector<double>& x, std::vector<double> const& residual);

 private:
  using Vector = std::vector<double>;
  static double dot(Vector const& a, Vector const& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  static double norm(Vector const& a) { return std::sqrt(dot(a, a)); }
  static void subtract(Vector& a, double factor, Vector const& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= factor * b[i];
  }
  static Vector difference(Vector a, Vector const& b) {
    subtract(a, 1, b);
    return a;
  }

  std::size_t memory_;
  Vector last_x_, last_residual_;
  std::vector<Vector> steps_, changes_;
};

}  // namespace actio::bodies
