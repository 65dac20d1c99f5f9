// The volume of a cell from its corners, and its derivative: what an incompressible medium keeps (chapter 10C
// of the book; (8.1) integrated over a cell).
//
// A kind of cell says how many corners it has, where they are, and what its volume is:
//
//     double slope[4][2];
//     double const A = PlaneCell::volume(corners, slope);   // slope[b] is dA/dy_b
//
// Corners are numbered as those of a mesh of a body: bit k says "upper along k". Translations of all corners
// and rotations leave a volume as it is, so that the sum of slopes and that of y x slope vanish.
#pragma once

#include <array>
#include <cmath>

namespace actio::media {

namespace detail {
/// u x v.
inline std::array<double, 3> cross(double const* u, double const* v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
/// u . v.
inline double dot(double const* u, double const* v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
}  // namespace detail

/// The determinant of the edges at a corner of a box-like cell, along increasing coordinates of the cell.
template <int d>
double corner_determinant(double const (*y)[d], int b) {
  double edge[d][d];
  for (int k = 0; k < d; ++k)
    for (int a = 0; a < d; ++a) edge[k][a] = y[b | 1 << k][a] - y[b & ~(1 << k)][a];
  if constexpr (d == 2)
    return edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0];
  else
    return detail::dot(edge[0], detail::cross(edge[1], edge[2]).data());
}

/// A quadrilateral in the plane: half the cross product of its diagonals, which is the mean of the Jacobians
/// at its corners.
struct PlaneCell {
  static constexpr int body = 2;      ///< dimension of the body
  static constexpr int space = 2;     ///< components of a place
  static constexpr bool flat = true;  ///< volumes are functions of differences of places
  static constexpr int corners = 4;   ///< of a cell

  /// The Jacobian at a corner: four times its share of the area.
  static double corner(double const (*y)[2], int b) { return corner_determinant<2>(y, b); }
  /// The area, length squared.
  static double volume(double const (*y)[2]) {
    return 0.5 * ((y[3][0] - y[0][0]) * (y[2][1] - y[1][1]) - (y[3][1] - y[0][1]) * (y[2][0] - y[1][0]));
  }
  /// The area, with its derivative by the place of each corner, length.
  static double volume(double const (*y)[2], double (*slope)[2]) {
    double const p = 0.5 * (y[3][0] - y[0][0]), q = 0.5 * (y[3][1] - y[0][1]);
    double const r = 0.5 * (y[2][0] - y[1][0]), s = 0.5 * (y[2][1] - y[1][1]);
    slope[0][0] = -s, slope[0][1] = r, slope[3][0] = s, slope[3][1] = -r;
    slope[1][0] = q, slope[1][1] = -p, slope[2][0] = -q, slope[2][1] = p;
    return 2 * (p * s - q * r);
  }
};

/// A hexahedron in space with bilinear faces: the integral of the Jacobian of the trilinear map.
///
/// The mean of the Jacobians at the corners would be another number, and sums of it over cells between fixed
/// walls would depend on the places of the nodes inside. With the half means \f$a_i\f$ of the edges along i
/// and the bends \f$h_i\f$ of the faces (corner_correction.hpp) the volume is
/// \f$8\det a+\tfrac83\sum_ia_i\cdot h_k\times h_j\f$, i, j, k in cyclic order.
struct SpaceCell {
  static constexpr int body = 3;      ///< dimension of the body
  static constexpr int space = 3;     ///< components of a place
  static constexpr bool flat = true;  ///< volumes are functions of differences of places
  static constexpr int corners = 8;   ///< of a cell

  /// The Jacobian at a corner.
  static double corner(double const (*y)[3], int b) { return corner_determinant<3>(y, b); }
  /// The volume, length cubed.
  static double volume(double const (*y)[3]) {
    Means const m(y);
    return m.volume();
  }
  /// The volume, with its derivative by the place of each corner, length squared.
  static double volume(double const (*y)[3], double (*slope)[3]) {
    Means const m(y);
    double by_a[3][3], by_h[3][3];
    for (int i = 0; i < 3; ++i) {
      int const j = (i + 1) % 3, k = (i + 2) % 3;
      auto const area = detail::cross(m.a[j], m.a[k]), bent = detail::cross(m.h[k], m.h[j]);
      auto const one = detail::cross(m.h[k], m.a[j]), other = detail::cross(m.a[k], m.h[j]);
      for (int c = 0; c < 3; ++c) by_a[i][c] = area[c] + bent[c] / 3, by_h[i][c] = (one[c] + other[c]) / 3;
    }
    for (int b = 0; b < 8; ++b) {
      int const x = sign(b, 0), y_ = sign(b, 1), z = sign(b, 2);
      for (int c = 0; c < 3; ++c)
        slope[b][c] = x * by_a[0][c] + y_ * by_a[1][c] + z * by_a[2][c] + y_ * z * by_h[0][c] +
                      z * x * by_h[1][c] + x * y_ * by_h[2][c];
    }
    return m.volume();
  }

 private:
  static constexpr int sign(int b, int i) { return b >> i & 1 ? 1 : -1; }
  struct Means {
    double a[3][3] = {}, h[3][3] = {};
    explicit Means(double const (*y)[3]) {
      for (int i = 0; i < 3; ++i)
        for (int b = 1; b < 8; ++b) {
          int const bend = sign(b, (i + 1) % 3) * sign(b, (i + 2) % 3);
          // Signs sum up to zero: differences are as good as places, and better rounded.
          for (int c = 0; c < 3; ++c) {
            double const d = y[b][c] - y[0][c];
            a[i][c] += 0.125 * sign(b, i) * d, h[i][c] += 0.125 * bend * d;
          }
        }
    }
    double volume() const {
      double bent = 0;
      for (int i = 0; i < 3; ++i)
        bent += detail::dot(a[i], detail::cross(h[(i + 2) % 3], h[(i + 1) % 3]).data());
      return 8 * (detail::dot(a[0], detail::cross(a[1], a[2]).data()) + bent / 3);
    }
  };
};

/// A quadrilateral of great circles on the unit sphere: two triangles with the area
/// \f$2\arctan\frac{a\cdot b\times c}{1+a\cdot b+b\cdot c+c\cdot a}\f$ each.
struct SphereCell {
  static constexpr int body = 2;       ///< dimension of the body
  static constexpr int space = 3;      ///< components of a place, a unit vector
  static constexpr bool flat = false;  ///< volumes are functions of places
  static constexpr int corners = 4;    ///< of a cell

  /// The Jacobian at a corner, in the plane that touches the sphere there.
  static double corner(double const (*y)[3], int b) {
    double u[3], v[3];
    for (int a = 0; a < 3; ++a) u[a] = y[b | 1][a] - y[b & 2][a], v[a] = y[b | 2][a] - y[b & 1][a];
    return detail::dot(y[b], detail::cross(u, v).data());
  }
  /// The area, seen from the side to which the body looks.
  static double volume(double const (*y)[3]) {
    return triangle(y[0], y[1], y[3], nullptr, nullptr, nullptr) +
           triangle(y[0], y[3], y[2], nullptr, nullptr, nullptr);
  }
  /// The area, with its derivative by the place of each corner along the sphere.
  static double volume(double const (*y)[3], double (*slope)[3]) {
    for (int b = 0; b < 4; ++b) slope[b][0] = slope[b][1] = slope[b][2] = 0;
    double const area = triangle(y[0], y[1], y[3], slope[0], slope[1], slope[3]) +
                        triangle(y[0], y[3], y[2], slope[0], slope[3], slope[2]);
    for (int b = 0; b < 4; ++b) {
      double const up = detail::dot(slope[b], y[b]);
      for (int c = 0; c < 3; ++c) slope[b][c] -= up * y[b][c];
    }
    return area;
  }

 private:
  static double triangle(double const* a, double const* b, double const* c, double* da, double* db,
                         double* dc) {
    // With edges from a the numerator has no places that cancel.
    double u[3], v[3];
    for (int k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k];
    double const N = detail::dot(a, detail::cross(u, v).data());
    double const D = 1 + detail::dot(a, b) + detail::dot(b, c) + detail::dot(c, a);
    if (da) {
      double const scale = 2 / (N * N + D * D);
      auto const bc = detail::cross(b, c), ca = detail::cross(c, a), ab = detail::cross(a, b);
      for (int k = 0; k < 3; ++k) {
        da[k] += scale * (D * bc[k] - N * (b[k] + c[k]));
        db[k] += scale * (D * ca[k] - N * (c[k] + a[k]));
        dc[k] += scale * (D * ab[k] - N * (a[k] + b[k]));
      }
    }
    return 2 * std::atan2(N, D);
  }
};

}  // namespace actio::media
