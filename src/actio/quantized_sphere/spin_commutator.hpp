// Commutators with the spin matrices, which are tridiagonal: O(N^2) operations.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_sphere/quantized_sphere.hpp"

namespace actio::sphere {

/// \f$[iS_j, W]\f$: how W changes when the sphere is turned about the axis j.
/// @param axis  j - 1: 0, 1 or 2
SkewHermitian<> spin_commutator(QuantizedSphere const& sphere, int axis, SkewHermitian<> const& w);

/// \f$\langle iS_j, W\rangle = \mathrm{Tr}(S_j(-iW))\f$: the part of W along the axis j. What is
/// above the diagonal is not looked at.
double spin_component(QuantizedSphere const& sphere, int axis, SkewHermitian<> const& w);

/// \f$W + ie\cdot S\f$ in the place of W: a function \f$e\cdot x/\hbar\f$ is added. O(N) operations.
void add_spin(QuantizedSphere const& sphere, Eigen::Vector3d const& e, SkewHermitian<>& w);

}  // namespace actio::sphere
