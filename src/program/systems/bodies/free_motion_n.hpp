// Motions of a free body in n dimensions: in steps of a scheme or of a composition of it, and none at all.
#pragma once

#include <Eigen/Core>

#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"
#include "program/systems/bodies/turning_body_n.hpp"

namespace actio::scene {

/// A body in n dimensions at the start.
struct StartOfBodyN {
  Inertia<Eigen::Dynamic> inertia;  ///< of the body
  Eigen::MatrixXd attitude;         ///< body to space
  Eigen::MatrixXd velocity;         ///< in the frame of the body
  Eigen::MatrixXd momentum;         ///< in the frame of the body
};

/// What is stepped, and how.
struct StepsOfBodyN {
  bool chart;     ///< the natural chart, otherwise Moser and Veselov
  int order;      ///< 2, 4 or 6
  bool attitude;  ///< whether it is reconstructed
};

/// The substeps of a composition of this order, as fractions of a step.
std::vector<double> fractions_of(int order);

/// In steps of this length, with the attitude or without.
/// @throws Error  where the step is too long: the first one is tried
std::unique_ptr<TurningBodyN> stepped_motion_n(StepsOfBodyN const& choice, StartOfBodyN const& start,
                                               double step,
                                               bodies::Sweeps sweeps = bodies::Sweeps::beyond_rounding);

/// What does not move: the momentum, without an attitude, of a body all whose moments are equal; and the
/// start of a motion that can take no step.
std::unique_ptr<TurningBodyN> constant_motion_n(Eigen::MatrixXd momentum, Eigen::MatrixXd attitude = {});

}  // namespace actio::scene
