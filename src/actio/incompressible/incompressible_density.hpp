// The Lagrangian density of an incompressible medium and its momenta (section 8.2 of the thesis).
#pragma once

#include "actio/incompressible/volume_constraint.hpp"

namespace actio {

/// The density \f$L_\Phi = L + \lambda\,\Phi\f$ of an incompressible medium (8.3), on jets of the extended bundle.
///
/// The multiplier adds to L: so \f$\lambda = \sqrt{\det G}\,P\f$ has the sign of a pressure that is positive in compression.
/// \implements{eq_8_3}
/// @tparam Medium  L, a density on jets over (n, n), such as \ref Continuum
template <class Medium, class BodyMetric, class SpaceMetric>
struct IncompressibleDensity {
  Medium medium;
  VolumeConstraint<BodyMetric, SpaceMetric> constraint;

  template <class S, int n, int M>
  S operator()(Jet<S, n, M> const& j) const {
    auto const below = deformation(j);
    // [eq_8_3]
    return medium(below) + j.y[M - 1] * constraint(below);
    // [eq_8_3]
  }
  /// @throws NotAMetric, VolumeNotPositive; and what the medium refuses
  template <class S, int n, int M>
  void examine(Jet<S, n, M> const& j) const {
    auto const below = deformation(j);
    constraint.examine(below);
    detail::examine(medium, below);
  }
};

/// The incompressible medium with the metrics, the mass and the stored energy of a continuous one.
template <class BodyMetric, class SpaceMetric, class Mass, class Energy>
auto incompressible(Continuum<BodyMetric, SpaceMetric, Mass, Energy> const& medium) {
  return IncompressibleDensity<Continuum<BodyMetric, SpaceMetric, Mass, Energy>, BodyMetric, SpaceMetric>{medium, {medium.G, medium.g}};
}

/// No stored energy: that of an ideal incompressible fluid, whose energy is a function of J alone and J is one (section 8.3).
struct NoStoredEnergy {
  template <class BodyMetric, class SpaceMetric, class S, int N, int n>
  S operator()(Eigen::Matrix<S, n, 1> const&, BodyMetric const&, SpaceMetric const&, Eigen::Matrix<S, N, n> const&) const {
    return S(0);
  }
};

namespace detail {
/// \f$\partial W/\partial v^a{}_j\f$ at a jet, a row for each a.
template <class Medium, class S, int n>
Eigen::Matrix<S, n, n> energy_slope(Medium const& medium, Jet<S, n, n> const& j) {
  using D = Dual<S, n>;
  Eigen::Matrix<D, n, 1> const x = j.particle().template cast<D>(), y = j.y.template cast<D>();
  auto const G = medium.G(x);
  auto const g = medium.g(y);
  Eigen::Matrix<S, n, n> slope;
  for (int k = 0; k < n; ++k) {
    Eigen::Matrix<D, n, n> F = j.gradient().template cast<D>();
    for (int a = 0; a < n; ++a) F(a, k).part[a] = S(1);
    D const W = medium.W(x, G, g, F);
    for (int a = 0; a < n; ++a) slope(a, k) = W.part[a];
  }
  return slope;
}
/// \f$F^{-1}\f$ with the determinant taken in: \f$J(F^{-1})^k{}_a\f$, a row for each k.
template <class Medium, class S, int n>
Eigen::Matrix<S, n, n> volume_slope(Medium const& medium, Jet<S, n, n> const& j) {
  return inverse_matrix(j.gradient(), "deformation gradient") * jacobian(medium.G(j.particle()), medium.g(j.y), j.gradient());
}
}  // namespace detail

/// The momenta of an incompressible medium in closed form (8.4), those of the multiplier, which vanish, included.
///
/// \f$p_a{}^0 = \rho\,g_{ab}v^b{}_0\sqrt{\det G}\f$, \f$p_a{}^j = \bigl(PJ(v^{-1})^j{}_a - \rho\,\partial W/\partial v^a{}_j\bigr)\sqrt{\det G}\f$ and
/// \f$\Pi = \bigl(-\tfrac12\rho\,g_{ab}v^a{}_0v^b{}_0 + \rho\,(\partial W/\partial v^a{}_j)\,v^a{}_j - \rho W - P(J(n-1)+1)\bigr)\sqrt{\det G}\f$.
/// \implements{eq_8_4,claim_8_2_affine_momentum,claim_8_2_multiplier_momentum}
/// @throws Singular  where the deformation gradient has no inverse
template <class Medium, class BodyMetric, class SpaceMetric, class S, int n, int M>
DualJet<S, n, M> incompressible_momenta(IncompressibleDensity<Medium, BodyMetric, SpaceMetric> const& density, Jet<S, n, M> const& extended) {
  detail::examine(density, extended);
  auto const& medium = density.medium;
  auto const j = deformation(extended);
  Eigen::Matrix<S, n, 1> const x = j.particle(), velocity = j.velocity();
  auto const G = medium.G(x);
  auto const g = medium.g(j.y);
  S const rho = medium.rho(x), root = volume<S>(G), P = material_pressure(medium.G, extended), J = density.constraint.volume_ratio(j);
  Eigen::Matrix<S, n, n> const W_v = detail::energy_slope(medium, j), cofactor = detail::volume_slope(medium, j);
  DualJet<S, n, M> z{extended.x, extended.y, S(0), Eigen::Matrix<S, M, n + 1>::Zero()};
  z.p.col(0).template head<n>() = lowered(g, velocity) * S(rho * root);
  S work(0);
  for (int k = 0; k < n; ++k)
    for (int a = 0; a < n; ++a) {
      // [eq_8_4]
      z.p(a, k + 1) = (P * cofactor(k, a) - rho * W_v(a, k)) * root;
      // [eq_8_4]
      work += W_v(a, k) * j.v(a, k + 1);
    }
  S const energy = medium.W(x, G, g, j.gradient());
  // [claim_8_2_affine_momentum]
  z.Pi = (-rho * inner(g, velocity, velocity) / S(2) + rho * work - rho * energy - P * (J * S(n - 1) + S(1))) * root;
  // [claim_8_2_affine_momentum]
  return z;
}

}  // namespace actio
