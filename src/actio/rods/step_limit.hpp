// The longest step of a rod: that of small waves along a straight one.
#pragma once

#include "actio/rods/rod_arrays.hpp"

namespace actio::rods {

/// Small waves along a straight rod of equal elements, as the scheme has them.
///
/// With \f$\Omega=\tfrac2h\sin\tfrac{\omega h}2\f$, \f$K=\tfrac2D\sin\tfrac{kD}2\f$ and
/// \f$c=\cos\tfrac{kD}2\f$
/// \f[ (\rho A\,\Omega^2-GA\,K^2)\,(\rho I\,\Omega^2-EI\,K^2-GA\,c^2)=(GA\,K\,c)^2, \qquad
///     \rho A\,\Omega^2=EA\,K^2, \qquad \rho J\,\Omega^2=GJ\,K^2 . \f]
struct RodWaves {
  RodSection section;  ///< of the rod
  double length;       ///< D of an element

  /// \f$\Omega^2\f$ of both branches of shear and bending across an axis, the slower first; 1/time^2.
  /// @param axis  of the bending, 2 or 3
  /// @param k     wave number, 1/length
  std::array<double, 2> bending(int axis, double k) const;
  double stretching(double k) const;  ///< \f$\Omega^2\f$ of waves along the rod
  double twisting(double k) const;    ///< \f$\Omega^2\f$ of waves of twist

  /// The fastest of all.
  struct Fastest {
    double omega;      ///< \f$\max\Omega\f$, 1/time
    char const* what;  ///< which wave it is
  };
  /// @param unshearable  without stretch and shear
  Fastest fastest(bool unshearable) const;
};

/// The longest step with which small waves are stable, \f$2/\max\Omega\f$, and what binds it. Free ends weigh
/// half and may take some per cent of it.
double longest_rod_step(RodConstants const& rod, bool unshearable);

/// @throws OutsideDomain  where the step is longer, with the wave that binds it
void require_stable_step(RodConstants const& rod, double step, bool unshearable);

}  // namespace actio::rods
