// A body with its gravity, in the axes in which it is moved: its principal axes, counted so that the middle
// moment of inertia belongs to the second, with the centre of mass as origin.
#pragma once

#include "actio/fast_body/space/short_flow.hpp"
#include "actio/rigid_body/principal_inertia.hpp"
#include "actio/two_bodies/polyhedron.hpp"

namespace actio::bodies {

/// A rigid body that attracts others. Made by \ref extended_body, \ref sphere_body, \ref ellipsoid_body or
/// \ref polyhedron_body, which check it.
struct ExtendedBody {
  Moments<double> moments;  ///< in its principal axes, about the centre of mass
  Three<double> inertia;    ///< along these axes, mass x length^2
  double radius;            ///< no part is farther from the centre of mass, length
  Eigen::Matrix3d axes;     ///< the principal axes as columns, in the frame in which the body was given
  Eigen::Vector3d centre;   ///< of mass, in the frame in which the body was given

  /// Mass.
  double mass() const { return moments.mass(); }
};

/// A body from its moments in any frame: they are shifted to the centre of mass and turned to the principal
/// axes. A frame along principal axes is only counted anew, without rounding.
/// @param moments  of order 2 at least, about the origin of the frame; kg m^degree
/// @param radius   no part of the body is farther from the origin, m
/// @throws NotFinite          where a number is none
/// @throws OutsideDomain      where the order is less than 2, mass or radius is not positive, or no
///                            distribution of mass has such moments: the matrix of the A_{a+b}, with
///                            exponents a and b up to half the order, has a negative eigenvalue
/// @throws UnphysicalInertia  where the moments of inertia are those of no body
ExtendedBody extended_body(Moments<double> const& moments, double radius);

/// A homogeneous ball.
ExtendedBody sphere_body(double mass, double radius, int order);
/// A homogeneous ellipsoid along the axes of its frame.
ExtendedBody ellipsoid_body(double mass, std::array<double, 3> const& half_axes, int order);
/// A homogeneous polyhedron. Its moments are integrated again in the principal axes, where nothing cancels.
ExtendedBody polyhedron_body(Polyhedron<double> const& shape, double density, int order);

/// Whether all moments with an odd exponent vanish, as those of an ellipsoid.
bool has_planes_of_symmetry(ExtendedBody const& body);

}  // namespace actio::bodies
