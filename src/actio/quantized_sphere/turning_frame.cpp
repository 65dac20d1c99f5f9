#include <Eigen/Core>

#include "actio/quantized_sphere/turning_frame.hpp"

namespace actio::sphere {

Turning::Turning(QuantizedSphere const& sphere, Eigen::Vector3d const& axis) : sphere_(sphere), axis_(axis) {
  azimuth_ = std::atan2(axis[1], axis[0]);
  upright_ = axis[0] == 0 && axis[1] == 0;
  if (upright_) return;
  // After a turn about the third axis e lies in the plane of the first and the third: real, tridiagonal.
  int const n = sphere.n;
  Eigen::VectorXd diagonal(n), beside(n - 1);
  for (int k = 0; k < n; ++k) diagonal[k] = axis[2] * sphere.weight(k);
  for (int k = 0; k + 1 < n; ++k) beside[k] = std::hypot(axis[0], axis[1]) * sphere.ladder(k);
  // Of the weights in ascending order.
  vectors_ = tridiagonal_eigensystem<Eigen::MatrixXd>(diagonal, beside).vectors;
  transposed_ = vectors_.transpose();
}

SkewHermitian<> Turning::operator()(double angle, SkewHermitian<> const& w) const {
  if (angle == 0) return w;
  ComplexMatrix<> a = w.complex();
  if (upright_) return SkewHermitian<>(conjugated(axis_[2] * angle, false, a));
  a = conjugated(-azimuth_, false, a);
  a = between(transposed_, a, vectors_);
  a = conjugated(angle, true, a);
  a = between(vectors_, a, transposed_);
  return SkewHermitian<>(conjugated(azimuth_, false, a));
}

ComplexMatrix<> Turning::conjugated(double angle, bool ascending, ComplexMatrix<> const& a) const {
  int const n = sphere_.n;
  ComplexMatrix<> out(n, n);
  for (int c = 0; c < n; ++c)
    for (int r = 0; r < n; ++r) out(r, c) = std::polar(1.0, angle * (ascending ? c - r : r - c)) * a(r, c);
  return out;
}

ComplexMatrix<> Turning::between(Eigen::MatrixXd const& f, ComplexMatrix<> const& a,
                                 Eigen::MatrixXd const& g) {
  ComplexMatrix<> out(a.rows(), a.cols());
  out.real() = product_of(product_of(f, Eigen::MatrixXd(a.real())), g);
  out.imag() = product_of(product_of(f, Eigen::MatrixXd(a.imag())), g);
  return out;
}

}  // namespace actio::sphere
