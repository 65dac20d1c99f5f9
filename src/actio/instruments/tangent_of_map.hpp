// The tangent of a map given as code: by evaluating it on points moved infinitely little.
//
// A map is a callable from a point to a point of the same space, written at every scalar: it is called at
// plain numbers and at dual numbers over them. A constant of it, such as its step, is a plain number or made
// from one. A map that solves an equation on the way is differentiated through its solver, or, cheaper, with
// implicit_map.hpp.
#pragma once

#include "actio/instruments/spaces.hpp"

namespace actio {

/// Where a map leads, and its tangent map in coordinates divided by the sizes of the space at the start.
template <class Point>
struct TangentAt {
  using Scalar = typename Point::Scalar;
  Point image;                        ///< \f$\Phi(x)\f$
  detail::AnyMatrix<Scalar> tangent;  ///< \f$D^{-1}\,T_x\Phi\,D\f$ with D the diagonal matrix of the sizes
  detail::AnyVector<Scalar> sizes;    ///< of the coordinates, in their units
};

/// Refuses what is no point of the space, and a map that leads to another one.
template <class Space, class Point, class Image>
void require_image(Space const& space, Point const& x, Image const& image, char const* where) {
  require_point(image, where);
  if (space.dimension(image) != space.dimension(x))
    throw OutsideDomain(where, "a map into the same space is needed; dimension of its image",
                        space.dimension(image), space.dimension(x));
}

/// The tangent of a map at a point.
///
/// @param map  point -> point, at every scalar
/// @throws NotFinite      where the point, its image or the derivative is no number
/// @throws OutsideDomain  where the point or its image has the wrong size
/// Exact up to rounding: no step size enters. The map is evaluated once for each batch of directions.
template <class Point, SpaceOf<Point> Space, class Map>
TangentAt<Point> tangent_of_map(Space const& space, Map const& map, Point const& x) {
  using S = typename Point::Scalar;
  require_point(x, "tangent of a map: point");
  int const n = space.dimension(x);
  TangentAt<Point> found{x, detail::AnyMatrix<S>(n, n), space.sizes(x)};
  over_batches(n, [&](int first) {
    auto const image = map(space.moved(x, found.sizes, first));
    require_image(space, x, image, "tangent of a map: image or derivative");
    detail::AnyVector<Moved<S>> const change = space.change(image);
    store_parts(found.tangent, change, first);
    if (first == 0) found.image = value_of(image);
  });
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) found.tangent(i, k) /= found.sizes[i];
  return found;
}

namespace detail {

/// \f$A\,B\,A^T\f$.
template <class S>
AnyMatrix<S> congruent(AnyMatrix<S> const& a, AnyMatrix<S> const& b) {
  Index const n = a.rows(), m = b.rows();
  AnyMatrix<S> ab = AnyMatrix<S>::Zero(n, m), result = AnyMatrix<S>::Zero(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j)
      for (Index k = 0; k < m; ++k) ab(i, j) += a(i, k) * b(k, j);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      for (Index k = 0; k < m; ++k) result(i, j) += ab(i, k) * a(j, k);
  return result;
}
/// Each entry times the sizes of its row and its column.
template <class S>
AnyMatrix<S> times_sizes(AnyMatrix<S> m, AnyVector<S> const& sizes) {
  for (Index i = 0; i < m.rows(); ++i)
    for (Index j = 0; j < m.cols(); ++j) m(i, j) *= sizes[i] * sizes[j];
  return m;
}
/// Each entry over the sizes of its row and its column.
template <class S>
AnyMatrix<S> over_sizes(AnyMatrix<S> m, AnyVector<S> const& sizes) {
  for (Index i = 0; i < m.rows(); ++i)
    for (Index j = 0; j < m.cols(); ++j) m(i, j) /= sizes[i] * sizes[j];
  return m;
}
/// \f$|a-b|/(|a|+|b|)\f$, lengths of all entries as one column; 0 where both vanish.
template <class S>
S relative_difference(AnyMatrix<S> const& a, AnyMatrix<S> const& b) {
  auto const length = [](AnyMatrix<S> const& m) { return length_of(AnyVector<S>(m.reshaped())); };
  S const together = length(a) + length(b);
  return together > S(0) ? S(length(a - b) / together) : S(0);
}

}  // namespace detail
}  // namespace actio
