// A flow on the sphere that moves on, and the frames that it is looked at in.
//
// What is stepped is the absolute vorticity, that of the sphere's own rotation included, in a frame that
// turns uniformly about the angular momentum (turning_frame.hpp); where the sphere turns fast, but for what
// turns as a whole. What is told of it is told in the frame of the rotating sphere: turned by an
// angle that is the rate times the time, multiplied and never accumulated.
#pragma once

#include "actio/skew_matrices/skew_hermitian.hpp"
#include "program/registry/simulation.hpp"

#include <Eigen/Core>

namespace actio::scene {

/// The motion of the vorticity on a rotating sphere.
class VorticityMotion : public Motion {
 public:
  /// The vorticity relative to the rotating sphere, in the frame of the sphere, at the time of the motion.
  /// About N^2 operations where the angular momentum lies along the pole, otherwise four products of
  /// matrices.
  virtual sphere::SkewHermitian<> vorticity_at_output() const = 0;
  /// The same but for a rotation, which is none at the start: for what does not depend on one, as the energy
  /// in each degree. About N^2 operations.
  virtual sphere::SkewHermitian<> vorticity_but_for_rotation() const = 0;
  /// The absolute vorticity but for a rotation: for the eigenvalues and their powers.
  virtual sphere::SkewHermitian<> absolute_vorticity() const = 0;
  /// The angular momentum of the absolute motion, along axes that do not turn with the sphere; those of the
  /// sphere at the start.
  virtual Eigen::Vector3d angular_momentum() const = 0;

  /// How far the vorticities are apart, relative to the sphere: as momenta. That of the sphere's rotation,
  /// which is known, would make the error of the flow look small.
  StateDistance distance(Motion const& other) const override;
};

}  // namespace actio::scene
