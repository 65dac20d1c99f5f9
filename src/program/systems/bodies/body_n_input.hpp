// What a scene says of a body in n dimensions: its inertia, its attitude, and how it turns at the start.
#pragma once

#include <Eigen/Core>

#include "actio/rigid_body/inertia.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// A body in n dimensions has at most so many: its velocity is then 130816 numbers and its attitude 262144,
/// which with 17 digits fill a scene of 16 MB by half, and a step is a fraction of a second.
inline constexpr int most_dimensions = 512;

/// The records of [system] and [initial].
std::vector<Parameter> body_n_parameters();

/// `lambda`: the diagonal of Lambda.
/// @throws SceneError  where there are fewer than 2 or more than \ref most_dimensions numbers, or a sum of
///                     two is not positive
Inertia<Eigen::Dynamic> read_lambda(SceneTable const& system);

/// `attitude`: an n by n rotation; the identity, written back, where it is left out. Where the largest entry
/// of \f$g^Tg-1\f$ is at most 1e-9 the nearest rotation is taken, and said in `remarks`.
/// @throws SceneError  where it is farther off, or a reflection
Eigen::MatrixXd read_attitude_n(SceneTable initial, int n, std::vector<std::string>& remarks);

/// `angular_velocity`: the upper triangle of \f$g^{-1}\dot g\f$, row by row, as a skew matrix.
/// @throws SceneError  where it has another length than n(n-1)/2
Eigen::MatrixXd read_velocity_n(SceneTable const& initial, int n);

/// The upper triangle of a skew matrix, row by row.
std::vector<double> upper_triangle(Eigen::MatrixXd const& skew);
/// The skew matrix with this upper triangle, row by row.
Eigen::MatrixXd skew_matrix(double const* upper, int n);

}  // namespace actio::scene
