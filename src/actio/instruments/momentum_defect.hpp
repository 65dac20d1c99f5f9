// How far a map is from conserving the momentum of a symmetry.
#pragma once

#include "actio/instruments/tangent_of_map.hpp"

namespace actio {

namespace detail {
/// The sum over the units of the components of |momentum| |velocity|: the size of the terms of a pairing.
template <Group G, Scalar S>
S size_of_pairing(Momentum<G, S> const& mu, Velocity<G, S> const& xi) {
  auto const classes = unit_classes(mu.group);
  S sum(0);
  for (std::size_t k = 0; k < classes.has_length.size(); ++k) {
    AnyVector<S> m = mu.components, v = xi.coordinates;
    for (Index a = 0; a < m.size(); ++a)
      if (classes.of[static_cast<std::size_t>(a)] != static_cast<int>(k)) m[a] = v[a] = S(0);
    sum += length_of(m) * length_of(v);
  }
  return sum;
}
}  // namespace detail

/// The momentum defect of a map at a point: the change of \f$J = \langle\mu, \vartheta(g)\rangle\f$ relative
/// to the largest value that a pairing of such a momentum with such a velocity has.
///
/// \f[ \frac{|J(\Phi(x)) - J(x)|}{\max_{x, \Phi(x)}\sum|\mu||\vartheta|}, \f]
/// the sum over the components that share a unit: turns and shifts.
/// @param space      `CotangentBundle`, or `PairsOfConfigurations`, where \f$\mu = D_2L\f$ and \f$g = g_1\f$
/// @param map        point -> point, at plain numbers
/// @param generator  Element -> Velocity: the generator of the symmetry on G, translated to the identity on
///   the right (variational/momentum_map.hpp)
/// @throws NotFinite, OutsideDomain where the point, its image or the generator is no number, or has the
/// wrong size Accuracy: a map that conserves J gets about an epsilon for each rounding of a step, of the
/// order of ten; 0 where the momentum vanishes at both ends.
template <class Point, SpaceOf<Point> Space, class Map, class Generator>
typename Point::Scalar momentum_defect(Space const& space, Map const& map, Point const& x,
                                       Generator const& generator) {
  using S = typename Point::Scalar;
  require_point(x, "momentum defect: point");
  Point const image = map(x);
  require_image(space, x, image, "momentum defect: image");
  auto const before = space.costate(x), after = space.costate(image);
  auto const theta = generator(before.configuration), theta_after = generator(after.configuration);
  detail::require_coordinates(theta.coordinates, before.configuration.group.dimension(),
                              "momentum defect: generator");
  detail::require_coordinates(theta_after.coordinates, before.configuration.group.dimension(),
                              "momentum defect: generator");
  S const size = detail::size_of_pairing(before.momentum, theta),
          size_after = detail::size_of_pairing(after.momentum, theta_after);
  S const largest = size_after > size ? size_after : size;
  // [momentum_defect]
  S const change = magnitude(S(pair(after.momentum, theta_after) - pair(before.momentum, theta)));
  return largest > S(0) ? S(change / largest) : S(0);
  // [momentum_defect]
}

}  // namespace actio
