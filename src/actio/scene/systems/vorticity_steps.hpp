// A flow on the sphere in steps: of order 2, or symmetric compositions of them.
#pragma once

#include <memory>
#include <optional>

#include "actio/scene/systems/vorticity_motion.hpp"
#include "actio/vorticity/vorticity_step.hpp"

namespace actio::scene {

/// What multiplies the matrices of a step (vorticity/products.hpp): the one place that says so.
using SphereProducts = EigenProducts;
/// A step of the flow.
using SphereStep = VorticityStep<SphereLaplacian, SphereProducts>;

/// A flow, the frame that it is stepped in, and the frame that it is told in.
struct SphereFlow {
  QuantizedSphere sphere;     ///< of the matrices
  SphereLaplacian laplacian;  ///< from which stream functions come
  double rotation;            ///< of the sphere, 1/time
  SkewHermitian<> start;      ///< the absolute vorticity
  TurningFrame frame;         ///< in which it changes least

  /// @param relative  the vorticity relative to the sphere
  SphereFlow(double rotation_of_sphere, SkewHermitian<> const& relative);

  /// \f$|P - Q|_2/\hbar\f$, the fastest turning of a vector by the equations of motion, 1/time: estimated by
  /// power iteration.
  double fastest_turning() const;
};

/// How a flow is stepped.
struct SphereScheme {
  Conserved conserved;            ///< beside the spectrum
  std::vector<double> fractions;  ///< of a step, those of the substeps

  /// The longest fraction.
  double longest() const;
};

/// A flow from its start, in steps.
std::unique_ptr<VorticityMotion> stepped_vorticity(std::shared_ptr<SphereFlow const> flow,
                                                   SphereScheme const& scheme, double step);

/// The longest step, up to this one, of which the first eight can be made; zero where none was found.
double longest_vorticity_step(std::shared_ptr<SphereFlow const> const& flow, SphereScheme const& scheme,
                              double step);

}  // namespace actio::scene
