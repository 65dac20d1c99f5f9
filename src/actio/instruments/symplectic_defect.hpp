// How far a map is from being symplectic.
#pragma once

#include "actio/instruments/tangent_of_map.hpp"

namespace actio {

/// \f$A^T\,\Omega(\Phi(x))\,A - \Omega(x)\f$ with \f$A = T_x\Phi\f$: zero exactly where the map preserves the
/// two-form at x.
///
/// In coordinates divided by the sizes of the space at x (`TangentAt`); an action. Exact over the rationals.
template <class Point, SymplecticSpaceOf<Point> Space, class Map>
auto symplectic_residual(Space const& space, Map const& map, Point const& x) {
  using S = typename Point::Scalar;
  auto const linearized = tangent_of_map(space, map, x);
  detail::AnyMatrix<S> const pulled_back =
      detail::congruent<S>(linearized.tangent.transpose(),
                           detail::times_sizes<S>(space.two_form(linearized.image), linearized.sizes));
  return detail::AnyMatrix<S>(pulled_back - detail::times_sizes<S>(space.two_form(x), linearized.sizes));
}

/// The symplectic defect of a map at a point: from 0 for a map that preserves the two-form there to 1 where
/// nothing cancels.
///
/// \f[ \frac{|A^T\Omega(\Phi(x))A - \Omega(x)|}{|A^T\Omega(\Phi(x))A| + |\Omega(x)|}, \qquad A = T_x\Phi, \f]
/// lengths being the root of the sum of squares in coordinates divided by the sizes of the space, so that
/// units do not matter.
/// @param space  a space with a two-form: `CotangentBundle`, `PairsOfConfigurations`
/// @param map    point -> point, at every scalar
/// @throws NotFinite, OutsideDomain  as \ref tangent_of_map
/// Accuracy: a symplectic map gets a few epsilon times \f$|A|^2\f$, times the condition of the equation that
/// an implicit map solves; a defect above that is meant.
template <class Point, SymplecticSpaceOf<Point> Space, class Map>
typename Point::Scalar symplectic_defect(Space const& space, Map const& map, Point const& x) {
  using S = typename Point::Scalar;
  auto const linearized = tangent_of_map(space, map, x);
  // [symplectic_defect]
  auto const pulled_back =
      detail::congruent<S>(linearized.tangent.transpose(),
                           detail::times_sizes<S>(space.two_form(linearized.image), linearized.sizes));
  return detail::relative_difference<S>(pulled_back,
                                        detail::times_sizes<S>(space.two_form(x), linearized.sizes));
  // [symplectic_defect]
}

}  // namespace actio
