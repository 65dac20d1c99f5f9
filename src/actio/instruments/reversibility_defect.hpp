// Whether a map can be undone: by the step of opposite sign, or by itself after a reversal of velocities.
#pragma once

#include "actio/instruments/tangent_of_map.hpp"

namespace actio {

namespace detail {
/// The root of the sum of squares of what leads from x to y, in sizes of the space at x.
template <class Space, class Point>
auto distance_in_sizes(Space const& space, Point const& x, Point const& y, char const* where) {
  using S = typename Point::Scalar;
  require_image(space, x, y, where);
  AnyVector<S> away = space.difference(x, y);
  auto const sizes = space.sizes(x);
  for (Index i = 0; i < away.size(); ++i) away[i] /= sizes[i];
  return length_of(away);
}
}  // namespace detail

/// How far \f$\Phi_{-h}\circ\Phi_h\f$ is from the identity at x: 0 for a self-adjoint (symmetric) family of
/// maps.
///
/// The length of what leads from x to \f$\Phi_{-h}(\Phi_h(x))\f$, in coordinates divided by the sizes of the
/// space at x: a momentum in units of itself, turns in radians.
///
/// \snippet reduction.cpp self_adjointness_defect
/// @param space   any space of spaces.hpp
/// @param family  (h, point) -> point
/// @param h       step, time; not zero
/// @throws NotFinite, OutsideDomain where the step, the point or an image is no number, the step is zero, or
/// an image has the wrong size Accuracy: a self-adjoint family gets a few epsilon for each of the two steps.
template <class Point, SpaceOf<Point> Space, class Family>
typename Point::Scalar self_adjointness_defect(Space const& space, Family const& family,
                                               typename Point::Scalar const& h, Point const& x) {
  using S = typename Point::Scalar;
  if (!is_finite(h)) throw NotFinite("self-adjointness defect: step");
  if (h == S(0)) throw OutsideDomain("self-adjointness defect", "the step must differ from zero", 0, 0);
  require_point(x, "self-adjointness defect: point");
  Point const image = family(h, x);
  require_image(space, x, image, "self-adjointness defect: image");
  // [self_adjointness_defect]
  Point const back = family(S(-h), image);
  return detail::distance_in_sizes(space, x, back, "self-adjointness defect: image of the way back");
  // [self_adjointness_defect]
}

/// How far \f$\rho\circ\Phi\circ\rho\circ\Phi\f$ is from the identity at x, with an involution \f$\rho\f$
/// that turns velocities round: 0 for a reversible map.
///
/// @param reversal  point -> point; \f$\Pi\mapsto-\Pi\f$ for the momentum of a body
/// The length and the accuracy are those of \ref self_adjointness_defect.
/// @throws NotFinite, OutsideDomain where the point or an image is no number, or has the wrong size; where
///         the reversal is no involution at x
template <class Point, SpaceOf<Point> Space, class Map, class Reversal>
typename Point::Scalar reversibility_defect(Space const& space, Map const& map, Point const& x,
                                            Reversal const& reversal) {
  using S = typename Point::Scalar;
  require_point(x, "reversibility defect: point");
  S const twice = detail::distance_in_sizes(space, x, Point(reversal(Point(reversal(x)))),
                                            "reversibility defect: reversal");
  S const allowed = S(1024) * epsilon<S>();
  if (twice > allowed)
    throw OutsideDomain("reversibility defect", "an involution is needed; twice the reversal leads away by",
                        to_double(twice), to_double(allowed));
  Point const image = map(x);
  require_image(space, x, image, "reversibility defect: image");
  // [reversibility_defect]
  Point const back = reversal(Point(map(Point(reversal(image)))));
  return detail::distance_in_sizes(space, x, back, "reversibility defect: image of the way back");
  // [reversibility_defect]
}

}  // namespace actio
