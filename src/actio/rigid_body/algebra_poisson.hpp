// The Poisson structure that the inertia of a body puts on its algebra of velocities (thesis, section 5.3).
//
// The Legendre map xi -> J xi carries the minus bracket of left-invariant systems from the dual to the
// algebra. What is a sphere of momenta there is an ellipsoid of velocities here, and the Euler-Poincare
// equations run along the curves in which the energy ellipsoids cut it.
//
// J is given by the moments of the planes, its diagonal in coordinates (`moments` of an Inertia): any field,
// the rationals included.
#pragma once

#include "actio/linear_algebra/linear.hpp"
#include "actio/variational/lie_poisson.hpp"

namespace actio {
namespace detail {

/// Refuses moments that make no metric.
template <Group G, Scalar S>
void require_moments(Coordinates<G, S> const& moments, Velocity<G, S> const& xi) {
  if (moments.size() != xi.coordinates.size())
    throw OutsideDomain("Poisson structure of the algebra",
                        "a moment of inertia for each coordinate is needed; moments",
                        static_cast<double>(moments.size()), static_cast<double>(xi.coordinates.size()));
  require_finite(moments, "Poisson structure of the algebra: moments");
  require_finite(xi.coordinates, "Poisson structure of the algebra: velocity");
  for (Index a = 0; a < moments.size() && ordered_arithmetic<S>(); ++a)
    if (!(moments[a] > S(0)))
      throw UnphysicalInertia("Poisson structure of the algebra", "J must be positive definite; a moment",
                              to_double(base_value(moments[a])), 0);
}

}  // namespace detail

/// \f$J\xi\f$. \implements{claim_5_3_algebra_legendre}
template <Group G, Scalar S>
Momentum<G, S> algebra_legendre(Coordinates<G, S> const& moments, Velocity<G, S> const& xi) {
  detail::require_moments(moments, xi);
  // [claim_5_3_algebra_legendre]
  return {xi.group, moments.cwiseProduct(xi.coordinates)};
  // [claim_5_3_algebra_legendre]
}

/// The matrix T of the bracket on the algebra at xi: \f$\{F, H\}(\xi) = -\langle J\xi, [J^{-1}F',
/// J^{-1}H']\rangle = F'^{\,T}\,T\,H'\f$.
/// @throws UnphysicalInertia  where a moment is not positive
template <Group G, Scalar S>
auto algebra_poisson_tensor(Coordinates<G, S> const& moments, Velocity<G, S> const& xi) {
  auto tensor = lie_poisson_tensor_plus(algebra_legendre(moments, xi));
  for (Index a = 0; a < tensor.rows(); ++a)
    for (Index b = 0; b < tensor.cols(); ++b) tensor(a, b) /= -(moments[a] * moments[b]);
  return tensor;
}

/// \f$C(\xi) = |J\xi|^2\f$, in the Ad-invariant metric: a Casimir. Its level sets are the ellipsoids of
/// \f$J^2\f$.
///
/// \implements{claim_5_3_algebra_casimir, claim_5_3_algebra_casimir_coordinates}
template <Group G, Scalar S>
S algebra_casimir(Coordinates<G, S> const& moments, Velocity<G, S> const& xi) {
  auto const mu = algebra_legendre(moments, xi);
  // [claim_5_3_algebra_casimir]
  return mu.components.squaredNorm();
  // [claim_5_3_algebra_casimir]
}

/// \f$\dot\xi = J^{-1}\,\mathrm{ad}^*_\xi\,J\xi\f$: the Euler-Poincare equations of the body, the flow of the
/// energy in this bracket.
template <Group G, Scalar S>
Velocity<G, S> body_acceleration(Coordinates<G, S> const& moments, Velocity<G, S> const& xi) {
  return {xi.group, ad_star(xi, algebra_legendre(moments, xi)).components.cwiseQuotient(moments)};
}

/// The same for n = 3 from the two families of ellipsoids alone: \f$\dot\xi = (J^2\xi\times J\xi)/\det J\f$,
/// a quarter of the cross product of the differentials of \f$|J\xi|^2\f$ and \f$\langle J\xi,\xi\rangle\f$,
/// over det J.
///
/// \implements{claim_5_3_dynamic_orbits}
/// @throws OutsideDomain  where there are not three coordinates
template <Group G, Scalar S>
Velocity<G, S> along_both_ellipsoids(Coordinates<G, S> const& moments, Velocity<G, S> const& xi) {
  if (xi.coordinates.size() != 3)
    throw OutsideDomain("along_both_ellipsoids", "three coordinates are needed; there are",
                        static_cast<double>(xi.coordinates.size()), 3);
  Coordinates<G, S> const once = algebra_legendre(moments, xi).components, twice = moments.cwiseProduct(once);
  // [claim_5_3_dynamic_orbits]
  return {xi.group, cross(twice, once) / (moments[0] * moments[1] * moments[2])};
  // [claim_5_3_dynamic_orbits]
}

}  // namespace actio
