// What the corners of a cell miss of its volume, and how they are put right (chapter 10 of the thesis).
//
// Corners that stand for 2^-n of the parallelepiped on their edges integrate the Jacobian of the multilinear
// map by the trapezoidal rule: exactly on a line, in the plane, and where the cell is a parallelepiped. Of
// other hexahedra the rule has the volume T in the place of |K|. With the half means a_i of the edges along i
// and the bends h_i of the faces across i, \f$h_i = \tfrac18\sum_b\eta_j\eta_kX_b\f$ with
// \f$\eta=\pm1\f$,
//
//     T = 8 (det a + D), |K| = 8 (det a + D/3), D = det(a1, h3, h2) + det(h3, a2, h1) + det(h2, h1, a3).
//
// So volumes of corners are multiplied by s = |K|/T, and all deformation gradients of the cell get the same
// part K = sum_b y_b (d log s/dX_b)^T more. An affine map changes no s: K of an affine section is none. And
// since d|K|/dX_b is the integral of the gradient of the hat function of b, the mean of the deformation
// gradients over the corners is then that of the multilinear map over the cell.
#pragma once

#include "actio/forms/forms.hpp"
#include "actio/numbers/errors.hpp"

namespace actio::media {

/// How many corners a cell with n dimensions has.
template <int n>
inline constexpr int corners_of_cell = 1 << n;

/// The correction of the corners of a cell.
template <class S, int n>
struct CornerCorrection {
  bool any = false;                         ///< whether there is one: not of parallelepipeds
  S ratio = S(1);                           ///< s, by which volumes of corners are multiplied
  Matrix<S, n, corners_of_cell<n>> slopes;  ///< \f$\partial\log s/\partial X_b\f$, a column for each corner

  /// The part K that the deformation gradients of all corners have in common.
  /// @param y  component a of the value at corner b: a callable (b, a)
  template <class T, int N, class Values>
  Matrix<T, N, n> common(Values const& y) const {
    Matrix<T, N, n> K = Matrix<T, N, n>::Zero();
    // Slopes sum up to zero: differences are as good as places, and better rounded.
    for (int b = 1; any && b < corners_of_cell<n>; ++b)
      for (int a = 0; a < N; ++a)
        for (int i = 0; i < n; ++i) K(a, i) += (y(b, a) - y(0, a)) * slopes(i, b);
    return K;
  }
  /// Adds to the corners of a cell what the stress on that part does to them.
  void add_forces(Matrix<S, n, n> const& P, S (*f)[n]) const {
    for (int b = 1; any && b < corners_of_cell<n>; ++b)
      for (int a = 0; a < n; ++a) {
        S pull(0);
        for (int i = 0; i < n; ++i) pull += P(a, i) * slopes(i, b);
        f[0][a] += pull, f[b][a] -= pull;
      }
  }
};

namespace detail {
/// +1 or -1: at which end of the cell a corner lies along i.
constexpr int end_of_corner(int b, int i) { return b >> i % 3 & 1 ? 1 : -1; }
template <class S>
Matrix<S, 3, 1> cross_of(Matrix<S, 3, 1> const& u, Matrix<S, 3, 1> const& v) {
  return Matrix<S, 3, 1>(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}
}  // namespace detail

/// The correction of a cell with these corners.
/// @param X  places, a column for each corner
/// Bends that are roundings of the places count as none.
template <class S, int n>
CornerCorrection<S, n> corner_correction(Matrix<S, n, corners_of_cell<n>> const& X) {
  CornerCorrection<S, n> out;
  if constexpr (n == 3) {
    using Vector = Matrix<S, 3, 1>;
    using detail::cross_of, detail::end_of_corner;
    Vector a[3], h[3];
    for (int i = 0; i < 3; ++i) {
      a[i] = h[i] = Vector::Zero();
      for (int b = 0; b < 8; ++b) {
        S const bend(end_of_corner(b, i + 1) * end_of_corner(b, i + 2));
        a[i] += X.col(b) * (S(end_of_corner(b, i)) / S(8)), h[i] += X.col(b) * (bend / S(8));
      }
      // A sum of eight places that a map has rounded a few times.
      out.any = out.any || !(magnitude(h[i]) <= S(8) * epsilon<S>() * magnitude(X));
    }
    if (!out.any) return out;
    S D(0);
    Vector a_slope[3], h_slope[3];
    for (int i = 0, j = 1, k = 2; i < 3; ++i, j = (j + 1) % 3, k = (k + 1) % 3) {
      a_slope[i] = cross_of(h[k], h[j]), h_slope[i] = cross_of(h[k], a[j]) + cross_of(a[k], h[j]);
      D += a[i].dot(a_slope[i]);
    }
    S const det = a[0].dot(cross_of(a[1], a[2])), exact = det + D / S(3), corners = det + D;
    out.ratio = exact / corners;
    S const of_det = S(1) / exact - S(1) / corners, of_D = S(1) / (S(3) * exact) - S(1) / corners;
    for (int b = 0; b < 8; ++b) {
      Vector slope = Vector::Zero();
      for (int i = 0, j = 1, k = 2; i < 3; ++i, j = (j + 1) % 3, k = (k + 1) % 3) {
        Vector const by_a = cross_of(a[j], a[k]) * of_det + a_slope[i] * of_D;
        slope += by_a * S(end_of_corner(b, i));
        slope += h_slope[i] * S(of_D * S(end_of_corner(b, j) * end_of_corner(b, k)));
      }
      out.slopes.col(b) = slope / S(8);
    }
  }
  return out;
}

}  // namespace actio::media
