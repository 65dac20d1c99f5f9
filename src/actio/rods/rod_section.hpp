// The cross-section of a rod: what it weighs, and how it resists.
#pragma once

#include "actio/fast_body/space/half_turn.hpp"

namespace actio::rods {

using bodies::Four;
using bodies::Three;

/// A section in its principal axes: the first along the rod, the others across it.
///
/// \snippet bodies.cpp rod_section
struct RodSection {
  Three<double> stretching;  ///< \f$C_N\f$: against stretch and the two shears, EA, GA2, GA3; force
  Three<double> bending;     ///< \f$C_M\f$: against twist and the two bends, GJ, EI2, EI3; force x length^2
  double mass;               ///< per length, \f$\rho A\f$
  Three<double> inertia;     ///< moments per length, \f$\rho J, \rho I_2, \rho I_3\f$; mass x length

  /// A disc of a solid.
  /// @param radius   length
  /// @param young    E, pressure
  /// @param poisson  \f$\nu\f$, a number in (-1, 1/2]
  /// @param density  mass per volume
  /// @param shear    the part of the area that resists shear; 1: all of it
  static RodSection circular(double radius, double young, double poisson, double density, double shear = 1);

  /// @throws OutsideDomain  where a stiffness, the mass or a moment is not a positive number, or the moments
  ///                        are those of no distribution of mass
  void examine() const;
};

}  // namespace actio::rods
