// Moments of homogeneous polyhedra, exactly: sums over the tetrahedra from the origin to the triangles of the
// surface, with the sign of their orientation.
//
// For a tetrahedron (0, p, q, w) of volume V the integral of (s.x)^n is 6 V n!/(n+3)! h_n(s.p, s.q, s.w),
// with the complete symmetric polynomial h_n, and h_n(a, b, c) = a h_{n-1}(a, b, c) + h_n(b, c) makes the
// series degree by degree. There is no root and no quadrature: over the rationals there is no error.
#pragma once

#include "actio/two_bodies/moments.hpp"

namespace actio::bodies {

/// A closed surface of triangles, counter-clockwise as seen from outside.
template <Scalar S = double>
struct Polyhedron {
  std::vector<Matrix<S, 3, 1>> vertices;  ///< length
  std::vector<std::array<int, 3>> faces;  ///< vertices of each triangle, counted from 0
};

/// Refuses a surface that is none: each edge is to be met by two triangles, once in each direction.
/// @throws OutsideDomain  where an edge is met otherwise, or a triangle names a vertex that is not there
void require_closed(std::vector<std::array<int, 3>> const& faces, int vertices);

/// The moments of a homogeneous polyhedron about the origin.
/// @param density  mass/length^3
/// @throws OutsideDomain  where the surface is not closed, the density not positive, or the volume not, as
///                        that of a surface that is inside out
/// Accuracy: exact over the rationals.
template <Scalar S>
Moments<S> polyhedron_moments(Polyhedron<S> const& body, S const& density, int order) {
  if (!(density > S(0)))
    throw OutsideDomain("moments of a polyhedron", "the density must be positive", to_double(density), 0);
  if (order < 0) throw OutsideDomain("moments of a polyhedron", "the order must not be negative", order, 0);
  require_closed(body.faces, static_cast<int>(body.vertices.size()));
  Polynomial<S> sum(order), one(order), two(order), three(order);  // h_n of one, two and three points
  auto const next = [](Polynomial<S>& h, int n, Matrix<S, 3, 1> const& p, Polynomial<S> const* less) {
    over_exponents(n, n, [&](int i, int j, int l) {
      S value(0);
      if (i > 0) value += h(i - 1, j, l) * p[0];
      if (j > 0) value += h(i, j - 1, l) * p[1];
      if (l > 0) value += h(i, j, l - 1) * p[2];
      h(i, j, l) = less ? S(value + (*less)(i, j, l)) : value;
    });
  };
  for (auto const& [a, b, c] : body.faces) {
    Matrix<S, 3, 1> const &p = body.vertices[a], &q = body.vertices[b], &w = body.vertices[c];
    S const six_volumes = p[0] * (q[1] * w[2] - q[2] * w[1]) + p[1] * (q[2] * w[0] - q[0] * w[2]) +
                          p[2] * (q[0] * w[1] - q[1] * w[0]);
    one(0, 0, 0) = two(0, 0, 0) = three(0, 0, 0) = S(1);
    for (int n = 1; n <= order; ++n) next(one, n, w, nullptr), next(two, n, q, &one), next(three, n, p, &two);
    // The series has (s.x)^n/n!, whose integral is 6 V h_n/(n+3)!.
    for (int n = 0; n <= order; ++n) {
      S const weight = density * six_volumes / S(factorial(n + 3));
      over_exponents(n, n, [&](int i, int j, int l) { sum(i, j, l) += weight * three(i, j, l); });
    }
  }
  if (!(sum(0, 0, 0) > S(0)))
    throw OutsideDomain(
        "moments of a polyhedron",
        "the volume must be positive: triangles are to be counter-clockwise seen from outside; volume",
        to_double(S(sum(0, 0, 0) / density)), 0);
  return Moments<S>(sum);
}

}  // namespace actio::bodies
