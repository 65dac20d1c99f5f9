// The Lagrangian density of a continuous medium (6.3), its Jacobian (6.1) and deformation tensors (6.2).
//
// The body B has the metric G and the mass density rho(x), its space M the metric g. The stored energy per
// unit mass is a callable W(x, G, g, F): a point of the body, the values of the two metrics there and at its
// image in space, and the deformation gradient. Energies of fluids and solids are in materials.hpp.
#pragma once

#include "actio/forms/metric.hpp"
#include "actio/jets/density.hpp"

namespace actio {

/// A deformation that turns the body inside out, or flat.
struct NotOrientationPreserving : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// A density of mass that is not positive.
struct NotAMassDensity : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// A medium with an n-dimensional body in an N-dimensional space: metrics of those dimensions, a mass
/// density, and a stored energy that takes their values.
template <class Medium, class S, int n, int N>
concept MediumOver = requires(Medium const& medium, Matrix<S, n, 1> const& x, Matrix<S, N, 1> const& y,
                              Matrix<S, N, n> const& F) {
  { as_matrix<S>(medium.G(x)) } -> std::same_as<Matrix<S, n, n>>;
  { as_matrix<S>(medium.g(y)) } -> std::same_as<Matrix<S, N, N>>;
  { medium.rho(x) } -> std::convertible_to<S>;
  { medium.W(x, medium.G(x), medium.g(y), F) } -> std::convertible_to<S>;
};

/// The Jacobian \f$J = \det F\,\sqrt{\det g/\det G}\f$ of a deformation, n = N (6.1).
///
/// \implements{eq_6_1}
/// @param G  value of the body's metric, @param g value of the space's metric, both matrices or `Kronecker`
/// @param F  deformation gradient
template <class BodyMetric, class SpaceMetric, class S, int n>
S jacobian(BodyMetric const& G, SpaceMetric const& g, Matrix<S, n, n> const& F) {
  // [eq_6_1]
  return determinant(F) * volume<S>(g) / volume<S>(G);
  // [eq_6_1]
}
/// The same between Euclidean spaces.
template <int n, class S>
S jacobian(Kronecker<n>, Kronecker<n>, Matrix<S, n, n> const& F) { return determinant(F); }

/// Refuses a deformation that turns the body inside out, or flat.
/// @param which  who asks, for the message
/// @throws NotOrientationPreserving  with J, where it is not positive
template <class S, int n>
void require_orientation(S const& J, Matrix<S, n, 1> const& x, char const* which) {
  if (ordered_arithmetic<S>() && !(base_value(J) > Base<S>(0)))
    throw NotOrientationPreserving(std::string(which) + " at x = " + show(x),
                                   "the Jacobian of a motion is positive", to_double(J), 0);
}

/// The Green deformation tensor \f$C_{ij} = g_{ab}F^a{}_iF^b{}_j\f$ (6.2), the metric of space pulled back to
/// the body.
///
/// \implements{eq_6_2}
template <class SpaceMetric, class S, int N, int n>
Matrix<S, n, n> green_tensor(SpaceMetric const& g, Matrix<S, N, n> const& F) {
  // [eq_6_2]
  return pulled_back(g, F);
  // [eq_6_2]
}

/// The inverse Finger tensor \f$c_{ab} = G_{ij}(F^{-1})^i{}_a(F^{-1})^j{}_b\f$ (6.2), the metric of the body
/// pushed forward to space.
///
/// \implements{eq_6_2}
/// @throws Singular  where F has no inverse
template <class BodyMetric, class S, int n>
Matrix<S, n, n> inverse_finger_tensor(BodyMetric const& G, Matrix<S, n, n> const& F) {
  // [claim_6_1_finger_tensor]
  return pulled_back(G, Matrix<S, n, n>(inverse_matrix(F, "inverse_finger_tensor")));
  // [claim_6_1_finger_tensor]
}

/// A density that is the same everywhere.
template <class S>
struct Homogeneous {
  S value = S(1);  ///< mass per volume of the body; positive
  template <class V>
  Base<typename V::Scalar> operator()(V const&) const { return Base<typename V::Scalar>(value); }
};

/// The density \f$L = \sqrt{\det G}\,\rho\,\bigl(\tfrac12 g_{ab}v^a{}_0v^b{}_0 - W(x, G, g, v)\bigr)\f$ of a
/// continuous medium (6.3).
///
/// \snippet fields.cpp continuum
///
/// \implements{eq_6_3}
/// @tparam BodyMetric   G, a callable on points of the body
/// @tparam SpaceMetric  g, a callable on points of space
/// @tparam Mass         rho, a callable on points of the body
/// @tparam Energy       W, a callable (x, G, g, F) over any scalar: stored energy per unit mass
template <class BodyMetric, class SpaceMetric, class Mass, class Energy>
struct Continuum {
  BodyMetric G;   ///< metric of the body
  SpaceMetric g;  ///< metric of the space
  Mass rho;       ///< mass per volume of the body
  Energy W;       ///< stored energy per unit mass

  template <class S, int n, int N>
    requires MediumOver<Continuum, S, n, N>
  S operator()(Jet<S, n, N> const& j) const {
    Matrix<S, n, 1> const x = j.particle();
    auto const G = this->G(x);
    auto const g = this->g(j.y);
    Matrix<S, N, 1> const v = j.velocity();
    auto const sqrt_det_G = volume<S>(G);
    // [eq_6_3]
    return sqrt_det_G * rho(x) * (inner(g, v, v) / Base<S>(2) - W(x, G, g, j.gradient()));
    // [eq_6_3]
  }

  /// Refuses what is no metric or no mass at this jet, and what the energy refuses: the body turned inside
  /// out.
  /// @throws NotAMetric, NotAMassDensity, NotOrientationPreserving; NotASquare over the rationals, where the
  ///         volume of the body is irrational
  template <class S, int n, int N>
  void examine(Jet<S, n, N> const& j) const {
    Matrix<S, n, 1> const x = j.particle();
    auto const G = this->G(x);
    auto const g = this->g(j.y);
    require_metric(G, x, "metric of the body");
    require_metric(g, j.y, "metric of the space");
    require_volume(G, x, "metric of the body");
    S const mass = rho(x);
    if (ordered_arithmetic<S>() && !(base_value(mass) > Base<S>(0)))
      throw NotAMassDensity("mass density at x = " + show(x), "mass is positive", to_double(mass), 0);
    if constexpr (requires { W.examine(x, G, g, j.gradient()); }) W.examine(x, G, g, j.gradient());
  }
};
template <class BodyMetric, class SpaceMetric, class Mass, class Energy>
Continuum(BodyMetric, SpaceMetric, Mass, Energy) -> Continuum<BodyMetric, SpaceMetric, Mass, Energy>;

/// The covariant time derivative of the velocity,
/// \f$(D_g\dot\phi/Dt)^b = \ddot\phi^b + \gamma^b_{ac}\dot\phi^a\dot\phi^c\f$: the material acceleration.
///
/// \implements{claim_6_2_material_acceleration}
template <class SpaceMetric, class S, int n, int N>
Matrix<S, N, 1> material_acceleration(SpaceMetric const& g, SecondJet<S, n, N> const& j) {
  // [claim_6_2_material_acceleration]
  return j.acceleration() + connection(g, j.y, j.velocity(), j.velocity());
  // [claim_6_2_material_acceleration]
}

}  // namespace actio
