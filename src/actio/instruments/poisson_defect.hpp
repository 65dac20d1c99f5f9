// How far a map is from being Poisson.
#pragma once

#include "actio/instruments/tangent_of_map.hpp"

namespace actio {

/// \f$A\,B(x)\,A^T - B(\Phi(x))\f$ with \f$A = T_x\Phi\f$: zero exactly where
/// \f$\{F\circ\Phi, H\circ\Phi\} = \{F, H\}\circ\Phi\f$ at x for all F and H.
///
/// In coordinates divided by the sizes of the space at x (`TangentAt`); 1/action. Exact over the rationals.
template <class Point, SpaceOf<Point> Space, class Map>
auto poisson_residual(Space const& space, Map const& map, Point const& x) {
  using S = typename Point::Scalar;
  auto const linearized = tangent_of_map(space, map, x);
  auto const pushed_forward =
      detail::congruent<S>(linearized.tangent, detail::over_sizes<S>(space.bivector(x), linearized.sizes));
  return detail::AnyMatrix<S>(pushed_forward -
                              detail::over_sizes<S>(space.bivector(linearized.image), linearized.sizes));
}

/// The Poisson defect of a map at a point: from 0 for a map that preserves the bracket there to 1 where
/// nothing cancels.
///
/// \f[ \frac{|A\,B(x)\,A^T - B(\Phi(x))|}{|A\,B(x)\,A^T| + |B(\Phi(x))|}, \qquad A = T_x\Phi, \f]
/// lengths being the root of the sum of squares in coordinates divided by the sizes of the space, so that
/// units do not matter. It is 0 where both brackets vanish. The reflection \f$\mu\mapsto-\mu\f$, which turns
/// the bracket round, has the defect 1.
///
/// \snippet reduction.cpp poisson_defect
/// @param space  \ref LiePoissonMinus for momenta of a body, \ref LiePoissonPlus for momenta in space,
///               \ref RelativeMotionsLeft or \ref RelativeMotionsRight for relative motions, or another space
///               of spaces.hpp
/// @param map    point -> point, at every scalar
/// @throws NotFinite, OutsideDomain  as \ref tangent_of_map
/// Accuracy: a Poisson map gets a few epsilon times \f$|A|^2|B(x)|/|B(\Phi(x))|\f$, times the condition of
/// the equation that an implicit map solves; a defect above that is meant.
template <class Point, SpaceOf<Point> Space, class Map>
typename Point::Scalar poisson_defect(Space const& space, Map const& map, Point const& x) {
  using S = typename Point::Scalar;
  auto const linearized = tangent_of_map(space, map, x);
  auto const before = detail::over_sizes<S>(space.bivector(x), linearized.sizes),
             after = detail::over_sizes<S>(space.bivector(linearized.image), linearized.sizes);
  // [poisson_defect]
  auto const pushed_forward = detail::congruent<S>(linearized.tangent, before);
  return detail::relative_difference<S>(pushed_forward, after);
  // [poisson_defect]
}

}  // namespace actio
