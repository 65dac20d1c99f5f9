// What can be told of a body that turns in n dimensions.
#pragma once

#include <Eigen/Core>

#include "actio/rigid_body/inertia.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// The motion of a body in n dimensions.
class TurningBodyN : public Motion {
 public:
  /// A skew matrix, in the frame of the body; energy x time.
  virtual Eigen::MatrixXd body_momentum() const = 0;
  /// Body to space.
  virtual Eigen::MatrixXd attitude() const = 0;
  /// The angle is \f$|g_1-g_0|_F/\sqrt2\f$: for a small turn in one plane, that turn.
  StateDistance distance(Motion const& other) const override;
};

/// `attitude`, `momentum`, `energy`, `spectrum`, `casimir`.
std::vector<Quantity> turning_body_n_quantities();
/// How these come from a motion.
void define_turning_body_n(QuantityGraph& graph, TurningBodyN const& motion,
                           Inertia<Eigen::Dynamic> const& inertia);
/// The largest modulus in the spectrum of M with which no Casimir leaves the numbers, with some room.
double largest_modulus_for_casimirs(int n);

}  // namespace actio::scene
