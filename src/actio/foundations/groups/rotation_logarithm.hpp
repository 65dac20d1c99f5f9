// Logarithms of rotations: angles from sine and cosine, rotation vectors through unit quaternions.
//
// The vector part of the quaternion keeps the axis to rounding at every angle, so the logarithm is as good next to pi as it is next to
// zero. At pi itself the rotation vector has no sign: the natural chart (3.19) ends there and the functions refuse.
#pragma once

#include <Eigen/Eigenvalues>

#include <cmath>

#include "actio/foundations/matrix_group.hpp"

namespace actio {

/// How near to the edge of the chart is too near: half a turn, up to the rounding that a product of two rotations brings.
template <class S>
Base<S> edge_of_chart() {
  return Base<S>(8) * epsilon<S>();
}

/// The angle with the given sine and cosine (up to a common positive factor), in (-pi, pi).
/// @param edge  how near to pi is too near
/// @throws OutsideDomain  at pi
template <Real S>
S angle_of_rotation(S const& sine, S const& cosine, Base<S> const& edge = edge_of_chart<S>()) {
  using std::atan2;
  if (!is_finite(base_value(sine)) || !is_finite(base_value(cosine))) throw NotFinite("log");
  Base<S> const s = magnitude(base_value(sine)), c = base_value(cosine);
  if (c < Base<S>(0) && s <= edge * -c)
    throw OutsideDomain("log", "rotation angle reaches pi; the natural chart needs less (3.19)", M_PI, M_PI);
  return atan2(sine, cosine);
}

/// A unit quaternion (scalar first) of a rotation matrix, with scalar part not negative; by its largest component, so that nothing cancels.
template <Real S>
Eigen::Matrix<S, 4, 1> quaternion_of_rotation(Eigen::Matrix<S, 3, 3> const& r) {
  using std::sqrt;
  require_finite(r, "quaternion_of_rotation");
  Eigen::Matrix<S, 4, 1> q;
  S const trace = r(0, 0) + r(1, 1) + r(2, 2);
  int i = 0;
  if (r(1, 1) > r(i, i)) i = 1;
  if (r(2, 2) > r(i, i)) i = 2;
  if (trace > r(i, i)) {
    S const w = sqrt(S(trace + S(1)));
    S const scale = S(1) / (w + w);
    q << w / S(2), (r(2, 1) - r(1, 2)) * scale, (r(0, 2) - r(2, 0)) * scale, (r(1, 0) - r(0, 1)) * scale;
  } else {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    S const w = sqrt(S(S(1) + r(i, i) - r(j, j) - r(k, k)));
    S const scale = S(1) / (w + w);
    q[0] = (r(k, j) - r(j, k)) * scale;
    q[1 + i] = w / S(2);
    q[1 + j] = (r(j, i) + r(i, j)) * scale;
    q[1 + k] = (r(k, i) + r(i, k)) * scale;
  }
  if (q[0] < S(0)) q = -q;
  return q;
}

/// The rotation vector (axis times angle, below pi) of a unit quaternion with scalar part not negative.
/// @throws OutsideDomain  at a rotation by pi
template <Real S>
Eigen::Matrix<S, 3, 1> rotation_vector(Eigen::Matrix<S, 4, 1> const& q) {
  using std::atan2, std::sqrt;
  Eigen::Matrix<S, 3, 1> const v = q.template tail<3>();
  S const square = v.squaredNorm();
  if (base_value(square) < Base<S>(1) / Base<S>(4)) return v * (asinc_derivative<0>(square) * Base<S>(2));
  if (base_value(q[0]) <= edge_of_chart<S>())
    throw OutsideDomain("log", "rotation angle reaches pi; the natural chart needs less (3.19)", M_PI - 2 * to_double(q[0]), M_PI);
  S const sine = sqrt(square);
  return v * (atan2(sine, q[0]) * Base<S>(2) / sine);
}

/// The rotation vector of a rotation matrix of 3-space.
/// @throws OutsideDomain  at a rotation by pi
template <Real S>
Eigen::Matrix<S, 3, 1> rotation_vector(Eigen::Matrix<S, 3, 3> const& r) {
  require_finite(r, "log");
  if (base_value(r(0, 0)) + base_value(r(1, 1)) + base_value(r(2, 2)) > Base<S>(2)) {
    // Below 30 degrees the skew part, the sine times the axis, is enough: no root, no division.
    Eigen::Matrix<S, 3, 1> const v{(r(2, 1) - r(1, 2)) / 2, (r(0, 2) - r(2, 0)) / 2, (r(1, 0) - r(0, 1)) / 2};
    S const square = v.squaredNorm();
    if (base_value(square) < ratio<Base<S>>(1, 4)) return v * asinc_derivative<0>(square);
  }
  return rotation_vector(quaternion_of_rotation(r));
}

/// The logarithm of a rotation of n-space, for plain scalars. (See above for n = 2, 3.)
///
/// Away from the identity the rotation is split into turns of orthogonal planes by its real Schur form, which is block diagonal because rotations
/// are normal; each angle comes from its sine and cosine. Equal angles, planes at rest and angles next to pi need no care of their own.
/// @throws OutsideDomain  where one of the angles is pi
/// Accuracy: the exponential of the result is r to a few tens of epsilon. Two angles within d of pi magnify that by 1/d, as they do in any
/// algorithm: the logarithm is not differentiable where both reach it.
template <Real S, int n>
Eigen::Matrix<S, n, n> rotation_logarithm(Eigen::Matrix<S, n, n> const& r) {
  static_assert(Plain<S>, "over dual numbers the derivative of the logarithm is known: primitive::lifted_log");
  using Matrix = Eigen::Matrix<S, n, n>;
  require_finite(r, "log");
  if (row_norm(Matrix(r - Matrix::Identity(r.rows(), r.cols()))) < 0.25) {
    Matrix const a = matrix_logarithm(r);
    return (a - a.transpose()) / S(2);
  }
  // The Schur vectors of r + 4 are those of r. Its diagonal lies between 3 and 5, which keeps the iteration from splitting hairs: it neglects
  // what is small beside the diagonal, and the cosines of r may be zero.
  Matrix const shifted = r + S(4) * Matrix::Identity(r.rows(), r.cols());
  Eigen::RealSchur<Matrix> const schur(shifted);
  if (schur.info() != Eigen::Success) throw NotConverged("log: Schur form of a rotation", {}, to_double(epsilon<S>()));
  Matrix const& t = schur.matrixT();
  int const size = static_cast<int>(r.rows());
  Base<S> const edge = Base<S>(8) * edge_of_chart<S>();  // the Schur form brings its own rounding, up to about 30 epsilon
  Matrix turns = Matrix::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    if (i + 1 < size && t(i + 1, i) != S(0)) {
      S const angle = angle_of_rotation(S(t(i + 1, i) - t(i, i + 1)), S(t(i, i) + t(i + 1, i + 1) - S(8)), edge);
      turns(i + 1, i) = angle, turns(i, i + 1) = -angle;
      ++i;
    } else if (t(i, i) < S(4)) {
      throw OutsideDomain("log", "rotation angle reaches pi; the natural chart needs less (3.19)", M_PI, M_PI);
    }
  }
  return schur.matrixU() * turns * schur.matrixU().transpose();
}

}  // namespace actio
