// From pairs of configurations to relative motions: the quotient maps of the diagonal actions, and back.
//
// Both quotients take the earlier configuration over the later one, so a relative motion is near 1 - h xi: it
// leads backwards in time.
#pragma once

#include "actio/groups/group.hpp"

namespace actio {

/// \f$f_{01} = g_0\,g_1^{-1}\f$, the class of a pair modulo right multiplication of both.
///
/// \implements{eq_3_9}
template <Group G, Scalar S>
Element<G, S> relative_motion_right(Element<G, S> const& g0, Element<G, S> const& g1) {
  // [eq_3_9]
  return g0 * inverse(g1);
  // [eq_3_9]
}
/// \f$f_{10} = g_1^{-1}g_0\f$, the class of a pair modulo left multiplication of both.
template <Group G, Scalar S>
Element<G, S> relative_motion_left(Element<G, S> const& g0, Element<G, S> const& g1) {
  return inverse(g1) * g0;
}

/// \f$\delta f\,f^{-1} = \vartheta_0 - \mathrm{Ad}_f\,\vartheta_1\f$: how \f$f = g_0g_1^{-1}\f$ varies with
/// its configurations, \f$\vartheta = \delta g\,g^{-1}\f$.
///
/// \implements{claim_3_2_variation_of_f}
template <Group G, Scalar S>
Velocity<G, S> relative_variation_right(Element<G, S> const& f, Velocity<G, S> const& theta0,
                                        Velocity<G, S> const& theta1) {
  // [claim_3_2_variation_of_f]
  return theta0 - Ad(f, theta1);
  // [claim_3_2_variation_of_f]
}
/// \f$f^{-1}\delta f = \vartheta_0 - \mathrm{Ad}_{f^{-1}}\,\vartheta_1\f$: how \f$f = g_1^{-1}g_0\f$ varies
/// with its configurations, \f$\vartheta = g^{-1}\delta g\f$.
template <Group G, Scalar S>
Velocity<G, S> relative_variation_left(Element<G, S> const& f, Velocity<G, S> const& theta0,
                                       Velocity<G, S> const& theta1) {
  return theta0 - Ad(inverse(f), theta1);
}

/// The discrete Lagrangian on G x G that a function of \f$g_0g_1^{-1}\f$ stands for.
///
/// \implements{claim_3_2_reduced_lagrangian}
template <class F>
auto lift_right(F l) {
  // [claim_3_2_reduced_lagrangian]
  return [l](auto const& g0, auto const& g1) { return l(relative_motion_right(g0, g1)); };
  // [claim_3_2_reduced_lagrangian]
}
/// The discrete Lagrangian on G x G that a function of \f$g_1^{-1}g_0\f$ stands for.
template <class F>
auto lift_left(F l) {
  return [l](auto const& g0, auto const& g1) { return l(relative_motion_left(g0, g1)); };
}

/// Reconstruction (3.14): the configuration after \f$g_k\f$ when the relative motion is
/// \f$f_{k,k+1} = g_kg_{k+1}^{-1}\f$.
///
/// \implements{eq_3_14}
template <Group G, Scalar S>
Element<G, S> reconstruct_right(Element<G, S> const& gk, Element<G, S> const& f) {
  // [eq_3_14]
  return inverse(f) * gk;
  // [eq_3_14]
}
/// Reconstruction (3.15): the configuration after \f$g_k\f$ when the relative motion is
/// \f$f_{k+1,k} = g_{k+1}^{-1}g_k\f$.
///
/// \snippet reduction.cpp euler_poincare_steps
///
/// \implements{eq_3_15}
template <Group G, Scalar S>
Element<G, S> reconstruct_left(Element<G, S> const& gk, Element<G, S> const& f) {
  // [eq_3_15]
  return gk * inverse(f);
  // [eq_3_15]
}

}  // namespace actio
