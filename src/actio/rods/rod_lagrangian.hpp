// The same rod on the general road: its Lagrangian as functions of relative motions of space.
//
// They are those of covariant_reduction, f = (g_a^{k+1})^{-1} g_a^k in time and e = (g_{a+1}^k)^{-1} g_a^k in
// space. The steps of rod_steps.hpp solve the field equation of that module, written out.
#pragma once

#include "actio/covariant_reduction/group_field.hpp"
#include "actio/groups/motions.hpp"
#include "actio/rods/rod_arrays.hpp"

namespace actio::rods {

/// The kinetic action of a section in a step, by Moser and Veselov and with straight ways:
/// \f$\ell_t(f)=\frac lh\mathrm{Tr}((1-R)\Lambda)+\frac{\rho A\,l}{2h}|x|^2\f$, \f$f=(R,x)\f$; energy x time.
struct KineticAction {
  RodSection section;  ///< of the rod
  double share,        ///< l, the length that the section stands for
      step;            ///< h, time

  /// At any scalar.
  template <class T>
  T operator()(Element<SE<3>, T> const& f) const {
    auto const& I = section.inertia;
    double const half = (I[0] + I[1] + I[2]) / 2;
    T turn(0), shift(0);
    for (int i = 0; i < 3; ++i) {
      turn += (T(1) - f.value(i, i)) * T(half - I[static_cast<std::size_t>(i)]);
      shift += f.value(i, 3) * f.value(i, 3);
    }
    return (turn + shift * T(section.mass / 2)) * T(share / step);
  }
};

/// The action of the strains of an element in a step, \f$\ell_s(e)=-h\,V\f$ with
/// \f$V=\frac D2(\langle C_N\Gamma,\Gamma\rangle+\langle C_M\kappa,\kappa\rangle)\f$, strains less those at
/// rest; energy x time.
struct StrainAction {
  RodSection section;          ///< of the rod
  ElementAtRest<double> rest;  ///< of the element
  double step;                 ///< h, time

  /// At any scalar.
  template <class T>
  T operator()(Element<SE<3>, T> const& e) const {
    // E = R^T, eps = -R^T x.
    RelativePlacement<T> placement;
    T const scale = T(2) / (T(1) + e.value(0, 0) + e.value(1, 1) + e.value(2, 2));
    for (int i = 0; i < 3; ++i) {
      auto const k = static_cast<std::size_t>(i);
      int const next = (i + 1) % 3, last = (i + 2) % 3;
      placement.w[k] = scale * (e.value(next, last) - e.value(last, next));
      placement.eps[k] =
          -(e.value(0, i) * e.value(0, 3) + e.value(1, i) * e.value(1, 3) + e.value(2, i) * e.value(2, 3));
    }
    auto const stretch = placement.stretch();
    T sum(0);
    for (std::size_t k = 0; k < 3; ++k) {
      T const Gamma = stretch[k] * T(rest.inverse_length) - T(rest.Gamma[k]),
              kappa = placement.w[k] * T(rest.inverse_length) - T(rest.kappa[k]);
      sum += Gamma * Gamma * T(section.stretching[k]) + kappa * kappa * T(section.bending[k]);
    }
    return -(sum * T(step / 2 / rest.inverse_length));
  }
};

/// The Lagrangian of a rod, a function of an edge and its relative motion.
struct RodAction {
  RodConstants const& rod;  ///< outlives it
  double step;              ///< h, time

  /// At any scalar.
  template <class T>
  T operator()(GridEdge const& edge, Element<SE<3>, T> const& f) const {
    auto const a = static_cast<std::size_t>(edge.node);
    if (edge.direction == Direction::time) return KineticAction{rod.section, rod.share[a], step}(f);
    return StrainAction{
        rod.section, {rod.inverse_length[a], vector_at(rod.Gamma, a), vector_at(rod.kappa, a)}, step}(f);
  }
};

}  // namespace actio::rods
