// What a flow on the torus conserves, and its fields.
#pragma once

#include <Eigen/Core>

#include "actio/quantized_torus/torus_harmonics.hpp"
#include "actio/quantized_torus/torus_stream.hpp"

namespace actio::torus {

/// \f$-\tfrac12\int\psi\omega = -\tfrac12\tfrac{4\pi^2}N\langle P, W\rangle\f$: the kinetic energy, and in a
/// layer the potential one with it.
///
/// \snippet torus.cpp torus_invariants
double flow_energy(TorusStream const& stream, sphere::SkewHermitian<> const& w);
/// \f$\tfrac12\int\omega^2 = \tfrac12\tfrac{4\pi^2}N|W|^2\f$.
double flow_enstrophy(sphere::SkewHermitian<> const& w);

/// The energy in rings of wave vectors: at k, 0 .. N/sqrt(2), that of those whose length rounds to k. Their
/// sum is the energy.
/// @param gamma  of the stream
Eigen::VectorXd energy_by_ring(TorusHarmonics const& vorticity, double gamma = 0);

/// The parts of a function in other directions: each coefficient times `of(m, n)`.
template <class Of>
TorusHarmonics scaled(TorusHarmonics f, Of const& of) {
  for (int m = -f.largest(); m <= f.largest(); ++m)
    for (int n = 0; n <= f.largest(); ++n) {
      auto& c = f.coefficient(n, m < 0 ? m + f.size() : m);
      c *= of(m, n);
    }
  return f;
}

/// The stream function, of a vorticity \f$(\Delta-\gamma)\psi\f$, its mean zero.
TorusHarmonics stream_function(TorusHarmonics const& vorticity, double gamma = 0);

/// The fields of a flow.
struct FlowFields {
  GridValues vorticity;       ///< in a layer the potential one
  GridValues streamfunction;  ///< with the mean zero
  GridValues along_x;         ///< \f$u = -\partial_y\psi\f$
  GridValues along_y;         ///< \f$v = \partial_x\psi\f$
};
/// Those of a vorticity, on M by M points. Derivatives are those of the Fourier series.
FlowFields flow_on_grid(TorusHarmonics const& vorticity, double gamma, int points);

}  // namespace actio::torus
