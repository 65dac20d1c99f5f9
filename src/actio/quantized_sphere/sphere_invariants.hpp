// What a flow on the sphere conserves: energy, angular momentum, and the integrals of powers of the
// vorticity.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_sphere/matrix_harmonics.hpp"
#include "actio/quantized_sphere/turning_frame.hpp"

namespace actio::sphere {

/// The kinetic energy \f$-\tfrac12\int\psi\zeta = -\tfrac12\tfrac{4\pi}N\langle P, W\rangle\f$ of the unit
/// sphere with unit density.
///
/// \snippet sphere.cpp sphere_invariants
/// @param stream  the map W -> P, for instance a `SphereLaplacian`
template <class Stream>
double vorticity_energy(Stream const& stream, SkewHermitian<> const& w) {
  return -0.5 * QuantizedSphere(static_cast<int>(w.size())).area_element() *
         inner_product(stream.solve(w), w);
}

/// \f$\tfrac12\int\zeta^2 = \tfrac12\tfrac{4\pi}N|W|^2\f$.
inline double enstrophy(SkewHermitian<> const& w) {
  double const size = norm(w);
  return 0.5 * QuantizedSphere(static_cast<int>(w.size())).area_element() * size * size;
}

/// \f$\int x\,\zeta = \tfrac{4\pi}N\hbar\,\mathrm{Tr}(S_j(-iW))\f$, j = 1, 2, 3: the angular momentum of the
/// fluid.
inline Eigen::Vector3d sphere_momentum(SkewHermitian<> const& w) {
  QuantizedSphere const sphere(static_cast<int>(w.size()));
  return sphere.area_element() * sphere.hbar() * spin_components(sphere, w);
}

/// The eigenvalues of -iW, in ascending order: the values of the vorticity, each on 1/N of the sphere.
inline Eigen::VectorXd vorticity_values(SkewHermitian<> const& w) { return hermitian_values(w.hermitian()); }

/// The Casimir functions \f$C_k = \tfrac{4\pi}N\mathrm{Tr}((-iW)^k)\f$, k = 2 .. most: the integrals of the
/// powers of the vorticity. By products of matrices, about most/2 of them.
Eigen::VectorXd vorticity_casimirs(SkewHermitian<> const& w, int most);

/// The energy in each degree, \f$\tfrac12\sum_m|f_{lm}|^2/(l(l+1))\f$ at l; zero at l = 0.
inline Eigen::VectorXd energy_by_degree(SphereHarmonics const& vorticity) {
  Eigen::VectorXd energy = Eigen::VectorXd::Zero(vorticity.degrees());
  for (int l = 1; l < vorticity.degrees(); ++l) energy[l] = 0.5 * vorticity.power(l) / (l * (l + 1.0));
  return energy;
}

/// \f$2\Omega\cos\theta\f$, the vorticity of a rotation about the pole, as a matrix.
inline SkewHermitian<> planetary_vorticity(QuantizedSphere const& sphere, double rotation) {
  SkewHermitian<> w(sphere.n);
  add_spin(sphere, 2 * rotation * sphere.hbar() * Eigen::Vector3d::UnitZ(), w);
  return w;
}

}  // namespace actio::sphere
