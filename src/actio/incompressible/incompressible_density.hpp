// The Lagrangian density of an incompressible medium and its momenta (section 8.2 of the thesis).
#pragma once

#include "actio/continuum/stresses.hpp"
#include "actio/incompressible/volume_constraint.hpp"

namespace actio {

/// The density \f$L_\Phi = L + \lambda\,\Phi\f$ of an incompressible medium (8.3), on jets of the extended
/// bundle.
///
/// The multiplier adds to L: so \f$\lambda = \sqrt{\det G}\,P\f$ has the sign of a pressure that is positive
/// in compression.
/// An alias of \ref AugmentedDensity: its constructor takes the density L and the \ref VolumeConstraint,
/// `IncompressibleDensity(medium, VolumeConstraint(medium.G, medium.g))`; \ref incompressible makes it of the
/// medium alone. Neither throws: jets are examined where it is evaluated.
/// \implements{eq_8_3}
/// @tparam Medium  L, a density on jets over (n, n), such as \ref Continuum
template <class Medium, class BodyMetric, class SpaceMetric>
using IncompressibleDensity = AugmentedDensity<Medium, VolumeConstraint<BodyMetric, SpaceMetric>>;

/// The incompressible medium with the metrics, the mass and the stored energy of a continuous one.
///
/// \snippet fields.cpp incompressible
template <class BodyMetric, class SpaceMetric, class Mass, class Energy>
auto incompressible(Continuum<BodyMetric, SpaceMetric, Mass, Energy> const& medium) {
  // [eq_8_3]
  return AugmentedDensity(medium, VolumeConstraint(medium.G, medium.g));
  // [eq_8_3]
}

/// No stored energy: that of an ideal incompressible fluid, whose energy is a function of J alone and J is
/// one (section 8.3).
struct NoStoredEnergy {
  template <class BodyMetric, class SpaceMetric, class S, int N, int n>
  S operator()(Matrix<S, n, 1> const&, BodyMetric const&, SpaceMetric const&, Matrix<S, N, n> const&) const {
    return S(0);
  }
};

/// The momenta of an incompressible medium in closed form (8.4), those of the multiplier, which vanish,
/// included.
///
/// \f$p_a{}^0 = \rho\,g_{ab}v^b{}_0\sqrt{\det G}\f$, \f$p_a{}^j = \bigl(PJ(v^{-1})^j{}_a - \rho\,\partial
/// W/\partial v^a{}_j\bigr)\sqrt{\det G}\f$ and
/// \f$\Pi = \bigl(-\tfrac12\rho\,g_{ab}v^a{}_0v^b{}_0 + \rho\,(\partial W/\partial v^a{}_j)\,v^a{}_j - \rho
/// W - P(J(n-1)+1)\bigr)\sqrt{\det G}\f$.
/// \implements{eq_8_4,claim_8_2_affine_momentum,claim_8_2_multiplier_momentum}
/// @throws Singular  where the deformation gradient has no inverse
template <class Medium, class BodyMetric, class SpaceMetric, class S, int n, int M>
DualJet<S, n, M> incompressible_momenta(IncompressibleDensity<Medium, BodyMetric, SpaceMetric> const& density,
                                        Jet<S, n, M> const& extended) {
  examine(density, extended);
  auto const& medium = density.density;
  auto const j = deformation(extended);
  Matrix<S, n, 1> const x = j.particle(), velocity = j.velocity();
  auto const G = medium.G(x);
  auto const g = medium.g(j.y);
  S const rho = medium.rho(x), sqrt_det_G = volume<S>(G), P = multiplier_pressure(medium.G, extended),
          J = density.constraint.volume_ratio(j);
  Matrix<S, n, n> const W_v = partial_F(medium, j), cofactor = area_transformation(G, g, j.gradient());
  DualJet<S, n, M> z{extended.x, extended.y, S(0), Matrix<S, M, n + 1>::Zero()};
  // [eq_8_4]
  z.p.col(0).template head<n>() = lowered(g, velocity) * S(rho * sqrt_det_G);
  for (int k = 0; k < n; ++k)
    z.p.col(k + 1).template head<n>() = (cofactor.col(k) * P - W_v.col(k) * rho) * sqrt_det_G;
  // [eq_8_4]
  S work(0);
  for (int k = 0; k < n; ++k) work += W_v.col(k).dot(j.v.col(k + 1).template head<n>());
  S const energy = medium.W(x, G, g, j.gradient());
  // [claim_8_2_affine_momentum]
  z.Pi =
      (-rho * inner(g, velocity, velocity) / S(2) + rho * work - rho * energy - P * (J * S(n - 1) + S(1))) *
      sqrt_det_G;
  // [claim_8_2_affine_momentum]
  return z;
}

}  // namespace actio
