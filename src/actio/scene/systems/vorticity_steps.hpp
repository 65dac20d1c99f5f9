// A flow on the sphere in steps: of order 2, or symmetric compositions of them.
#pragma once

#include <memory>

#include "actio/scene/systems/vorticity_motion.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"

namespace actio::scene {

/// A flow, the frame that it is stepped in, and the frame that it is told in.
struct SphereFlow {
  QuantizedSphere sphere;     ///< of the matrices
  SphereLaplacian laplacian;  ///< from which stream functions come
  double rotation;            ///< of the sphere, 1/time
  SkewHermitian<> start;      ///< the absolute vorticity
  TurningFrame frame;         ///< in which it changes least
  Products products;          ///< of the matrices of a step

  /// @param relative  the vorticity relative to the sphere
  /// @param remarks   what a user might want to know of it
  SphereFlow(double rotation_of_sphere, SkewHermitian<> const& relative, std::vector<std::string>& remarks);

  /// \f$|P - Q|_2/\hbar\f$, the fastest turning of a vector by the equations of motion, 1/time: estimated by
  /// power iteration.
  double fastest_turning() const;
};

/// How a flow is stepped.
struct SphereScheme {
  Conserved conserved;            ///< beside the spectrum
  bool to_rounding;               ///< whether the equation of a step is solved in double precision throughout
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
