// A flow on the torus in steps.
#pragma once

#include "actio/quantized_torus/torus_stream.hpp"
#include "actio/skew_matrices/products.hpp"
#include "program/registry/simulation.hpp"
#include "program/systems/sphere/scheme.hpp"

namespace actio::scene {

/// A flow at its start.
struct TorusFlow {
  torus::TorusStream stream;      ///< of its Hamiltonian
  sphere::SkewHermitian<> start;  ///< its vorticity
  sphere::Products products;      ///< of the matrices of a step

  /// \f$|P|_2/\hbar\f$, the fastest turning of a vector by the equations of motion, 1/time: estimated by the
  /// method of Lanczos.
  double fastest_turning() const;
};

/// The motion of the vorticity on the torus.
class TorusMotion : public Motion {
 public:
  /// Now.
  virtual sphere::SkewHermitian<> const& vorticity() const = 0;
  /// How far the vorticities are apart: as momenta.
  StateDistance distance(Motion const& other) const override;
};

/// A flow from its start, in steps.
std::unique_ptr<TorusMotion> stepped_torus(std::shared_ptr<TorusFlow const> flow, SphereScheme const& scheme,
                                           double step);

}  // namespace actio::scene
